"""`instobj bench bringup` without hardware: files, a board on a port, broken-off lines, bad inputs."""

import json
import os
from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError
from design.layout.places.positions import live_channels, magnet_layout, sensor_layout
from design.spec_io import load_spec
from estimator.calibration.resting import channel_names
from estimator.recordings.boards.link import serial_chunks
from instobj.bench.bringup.asking.asked import asked_of
from instobj.bench.bringup.dialogue import ask_questions, open_questions
from instobj.bench.bringup.journal import open_journal, read_journal
from instobj.bench.bringup.simulated import simulated_object
from instobj.bench.bringup.sources import Board
from tests.support.cli import assert_one_clear_error, run
from tests.support.new_objects import SMALL, SMALL_TEXT, played_board

PLANTED = ("swap=F1-S1,F1-S2", "turn=F5-S1", "flip=F3-M2", "dead=F4-Y1", "gain=F2-S2=1.25")
FOUND = {
    ("swapped chips", "F1-S1 and F1-S2"),
    ("turned chip", "F5-S1"),
    ("flipped magnet", "F3-M2"),
    ("dead axis", "F4-Y1"),
    ("gain", "F2-S2"),
}
SCENE = simulated_object(SMALL, 1)
ASKED = asked_of(SMALL)


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bringup")
    (folder / "small.toml").write_text(SMALL_TEXT)
    planted = [word for fault in PLANTED for word in ("--simulated", fault)]
    result = run("bench", "bringup", "small.toml", *planted, "--json", cwd=folder)
    return folder, result


def test_every_planted_fault_is_named_in_result_and_page(done):
    folder, result = done
    assert result.returncode == 1, result.stderr
    rows = json.loads(result.stdout)["tables"]["what to put right"]
    assert {(row["found"], row["where"]) for row in rows} == FOUND
    page = (folder / "runs/small/bringup_simulated/bringup.html").read_text()
    for kind, where in FOUND:
        assert f"<td>{kind}</td><td>{where}</td>" in page
    assert page.count("#b3261e") == len({"F1-S1", "F1-S2", "F5-S1", "F3-M2", "F4-S1", "F2-S2"}) + 1


def test_the_file_as_built_puts_chips_and_magnets_where_they_are(done):
    folder, _ = done
    found = folder / "runs/small/bringup_simulated/small.as_built.toml"
    spec = load_spec(folder / "small.toml", [f'as_built="{found}"'])
    designed, built = sensor_layout(SMALL), sensor_layout(spec)
    expected = designed.axes.copy()
    expected[[0, 1]] = expected[[1, 0]]
    expected[8] = expected[8][[1, 2, 0]]
    turn = np.einsum("sab,scb->sac", built.axes, expected)
    angle_deg = np.rad2deg(np.arccos(np.clip((np.trace(turn, axis1=1, axis2=2) - 1) / 2, -1, 1)))
    assert angle_deg.max() < 10
    assert np.allclose(built.position_mm[[0, 1]], designed.position_mm[[1, 0]], atol=1e-3)
    assert np.argwhere(~live_channels(spec)).tolist() == [[6, 1]]
    flips = np.sum(magnet_layout(spec).axis * magnet_layout(SMALL).axis, axis=1)
    assert np.flatnonzero(flips < 0).tolist() == [5]


def test_a_replay_of_some_recordings_judges_those(done, tmp_path):
    folder, _ = done
    whole = (folder / "runs/small/bringup_simulated/bringup.csv").read_text().splitlines(True)
    (tmp_path / "some.csv").write_text(
        "".join(whole[:2] + [w for w in whole if w.startswith("still,")])
    )
    (tmp_path / "small.toml").write_text(SMALL_TEXT)
    result = run("bench", "bringup", "small.toml", "--replay", "some.csv", "--json", cwd=tmp_path)
    document = json.loads(result.stdout)
    assert document["recorded"] == 1
    assert document["left"] == [asked.name for asked in ASKED[1:]]
    assert not (tmp_path / "small.as_built.toml").exists()


class Typed:
    """Lines that a user types: one for every question, when the board shows what was asked."""

    ended = False

    def __init__(self, board, lines):
        self.board, self.lines, self.asked = board, list(lines), iter(ASKED)

    def poll(self):
        if not self.lines:
            return []
        line = self.lines.pop(0)
        if line in ("", "s"):
            asked = next(self.asked)
            self.board.show(SCENE.recording(replace(asked, frames=20)))
        return [line]


def with_board(journal, lines, channels=None):
    """Go through the questions with these answers."""
    with played_board(channels or channel_names(SMALL)) as board:
        board.show(SCENE.recording(replace(ASKED[0], frames=20)))
        source = Board(SMALL, serial_chunks(board.port), board.port, typed=Typed(board, lines))
        ask_questions(SMALL, source, journal, set())


def test_a_bring_up_at_a_port_goes_on_where_the_user_stopped(tmp_path, capsys):
    path = tmp_path / "bringup.csv"
    with_board(open_journal(path, SMALL), ["", "what", "s", "q"])
    assert "'what' is no answer" in capsys.readouterr().err
    journal = open_journal(path, SMALL)
    assert list(journal.recordings) == ["still"]
    assert journal.skipped == {"held F1-S1"}
    assert journal.recordings["still"].counts.shape == (ASKED[0].frames, 10, 3)
    assert open_questions(ASKED, journal)[0].name == "held F1-S2"


def test_a_board_that_leaves_is_told_and_what_was_recorded_stays(tmp_path):
    journal = open_journal(tmp_path / "bringup.csv", SMALL)
    with played_board(channel_names(SMALL)) as board:
        board.show(SCENE.recording(replace(ASKED[0], frames=20)))
        typed = Typed(board, [""])
        source = Board(SMALL, serial_chunks(board.port), board.port, typed=typed)
        typed.poll = lambda: board.leave() or [] if not typed.lines else [typed.lines.pop()]
        with pytest.raises(InputError, match="broke off"):
            ask_questions(SMALL, source, journal, set())
    assert list(open_journal(journal.path, SMALL).recordings) == ["still"]


def test_boards_of_other_objects_and_counts_beyond_16_bits_are_refused(tmp_path):
    journal = open_journal(tmp_path / "bringup.csv", SMALL)
    with pytest.raises(InputError, match="F1-X3, which small has not"):
        with_board(journal, [""], channels=[*channel_names(SMALL)[:-1], "F1-X3"])
    far = SCENE.recording(replace(ASKED[0], frames=20))
    far.counts[:, 3, 1] = 70000
    with played_board(channel_names(SMALL)) as board:
        board.show(far)
        source = Board(SMALL, serial_chunks(board.port), board.port)
        with pytest.raises(InputError, match="70000 counts for F2-Y2"):
            source.record(ASKED[0])
    assert not journal.recordings


def test_a_journal_keeps_what_came_and_cuts_an_unfinished_end(tmp_path):
    journal = open_journal(tmp_path / "bringup.csv", SMALL)
    first, second = (SCENE.recording(asked) for asked in ASKED[:2])
    first.counts[3, 2] = np.nan
    journal.append(first)
    journal.append(second)
    whole = journal.path.stat().st_size
    os.truncate(journal.path, whole - 40)
    again = open_journal(journal.path, SMALL)
    assert list(again.recordings) == [first.name]
    assert again.cut_bytes > 0
    np.testing.assert_array_equal(again.recordings[first.name].counts, first.counts)
    again.append(second)
    assert journal.path.stat().st_size == whole


def test_journals_of_other_objects_and_damaged_ones_are_refused(tmp_path):
    journal = open_journal(tmp_path / "bringup.csv", SMALL)
    journal.append(SCENE.recording(ASKED[0]))
    other = SMALL.changed(sensors=SMALL.sensors.changed(radius_mm=8.0))
    with pytest.raises(InputError, match="of another object"):
        open_journal(journal.path, other)
    lines = journal.path.read_text().splitlines(keepends=True)
    damaged = tmp_path / "damaged.csv"
    damaged.write_text("".join([*lines[:5], "still,9,9\n", *lines[6:]]))
    with pytest.raises(InputError, match="line 6"):
        read_journal(damaged, SMALL)
    damaged.write_text("".join([*lines, "nothing,1,20,3\n"]))
    with pytest.raises(InputError, match="begins no recording"):
        read_journal(damaged, SMALL)
    damaged.write_text("a,b\n1,2\n")
    with pytest.raises(InputError, match="no file of a bring-up"):
        read_journal(damaged, SMALL)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], ["--port", "--replay", "--simulated"]),
        (["--simulated", "bent=F1-S1"], ["bent=F1-S1", "swap="]),
        (["--simulated", "turn=F9-S1"], ["F9-S1", "F1-S1"]),
        (["--simulated", "none", "--repeat", "poles"], ["poles", "held"]),
        (["--replay", "none.csv"], ["no bring-up at none.csv"]),
        (["--port", "/dev/nothing"], ["/dev/nothing", "0 recordings are kept"]),
        (["--simulated", "none", "--set", 'sensors.axes=["Z"]'], ["three axes", "selftest"]),
    ],
)
def test_bad_inputs_give_one_clear_error(tmp_path, arguments, words):
    (tmp_path / "small.toml").write_text(SMALL_TEXT)
    assert_one_clear_error(run("bench", "bringup", "small.toml", *arguments, cwd=tmp_path), *words)
