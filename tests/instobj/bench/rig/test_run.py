"""Presses by a simulated Grbl machine on a simulated object: recorded, watched, gone on with."""

import csv
import json
import signal
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError, RecordingError
from estimator.recordings.formats.files import read_table
from estimator.recordings.reading import read_recording
from instobj.bench.rig.command import RigOptions, rig
from instobj.bench.rig.mounting import Mounting
from instobj.bench.rig.run import Ports
from tests.support.rig_bench import MIDDLE_MM, TOP_MM, bench, hertz, simple_counts

LIMIT_N = 10.0 * 4 / 3
SETTINGS = {"depths_mm": (1.0, 2.0), "dwell_s": 0.4, "rest_s": 0.5, "speed_mm_s": 4.0}
SETTINGS |= {"full_n": 10.0, "clearance_mm": 3.0}

LOST_S = 3.0
"""On a busy machine the bench itself falls silent for a second."""


def options(made, tmp_path, presses=2, numbers=False, **choice):
    spec = tmp_path / "cube.toml"
    spec.write_text('name = "cube"\n[contact_grid]\ncount = [2, 2]\npitch_mm = 12.0\n')
    ports = Ports(made.port, made.board_port)
    if numbers:
        ports = Ports(made.port, made.board_port, made.load_port, load_scale=9.80665e-3)
    ports = replace(ports, lost_s=choice.pop("lost_s", LOST_S))
    given = {
        "faces": (3,),
        "mounting": Mounting((*MIDDLE_MM, TOP_MM), 0.0),
        "settings": tuple((SETTINGS | choice.pop("settings", {})).items()),
        "presses": presses,
        "reference_every": 0,
    }
    return RigOptions(spec, "grbl", tmp_path / "run", ports, **(given | choice))


def yes(_):
    return True


def rows_of(tmp_path):
    with (tmp_path / "run.csv").open() as file:
        return [
            {k: float(v) if v else None for k, v in row.items()} for row in csv.DictReader(file)
        ]


def events(tmp_path, name):
    lines = (tmp_path / "run.face_3.rig.jsonl").read_text().splitlines()
    return [one for one in map(json.loads, lines) if one["event"] == name]


def require_right_labels(rows, counts_off=25):
    """Every frame's signals are those of its labelled place and force."""
    pressed = [row for row in rows if row["cell1_force_n"] > 1]
    assert len(pressed) > 10
    for row in pressed:
        xy = row["cell1_x1_mm"], row["cell1_y1_mm"]
        counts = np.array([row[f"F3-{axis}1"] for axis in "XYZ"]) - 100
        assert np.abs(counts - simple_counts(row["cell1_force_n"], xy)).max() < counts_off
        assert row["cell1_face"] == 3
        assert row["rest"] == 0


def require_tip_up(made):
    assert made.machine.position[2] > TOP_MM + 2.5


@pytest.mark.parametrize("numbers", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_presses_are_done_as_planned_and_recorded(tmp_path, numbers):
    with bench() as made:
        made.machine.late_ok_s = 0.15
        made.numbers_on_load_line = numbers
        found = rig(options(made, tmp_path, numbers=numbers, lost_s=60.0), yes)
        assert not made.machine.overflowed
        require_tip_up(made)
    rows = rows_of(tmp_path)
    require_right_labels(rows, 100 if numbers else 25)  # a line of its own has no common clock
    assert found["presses"] == 2
    assert found["frames"] == len(rows)
    peaks = [max(row["travel_mm"] for row in part) for part in by_place(rows)]
    assert np.allclose(peaks, 2.0, atol=0.03)
    there = [abs(row["travel_mm"] - 1.0) < 0.005 for row in rows]
    still = [row for k, row in enumerate(rows) if k > 0 and all(there[k - 1 : k + 2])]
    assert len(still) >= 2
    for row in still:
        wanted = hertz(1.0, (row["cell1_x1_mm"], row["cell1_y1_mm"]))
        assert abs(row["cell1_force_n"] - wanted) < (1.0 if numbers else 0.2)


def test_the_command_presses_without_a_load_cell_and_its_recording_is_read(tmp_path):
    with bench() as made:
        made.load_silent = True
        given = options(made, tmp_path, presses=1, settings={"speed_mm_s": 2.0})
        ports = replace(given.ports, by_travel=True)
        done = rig(replace(given, ports=ports), yes)
        require_tip_up(made)
    assert done["presses"] == 1
    assert done["reference_n"] == []
    assert done["texts"][-1].endswith("run.nc --spec FILE")
    table = read_table(tmp_path / "run.nc")
    assert table.labelled_by_travel
    assert np.nanmax(table.travel_mm) == pytest.approx(2.0, abs=0.02)
    assert events(tmp_path, "finished")[0].keys() == {"event", "press", "row"}


@pytest.mark.slow
def test_a_run_without_a_load_cell_goes_on_after_a_fault_and_only_without_one(tmp_path):
    def by_travel(made, **choice):
        given = options(made, tmp_path, presses=3, **choice)
        return replace(given, ports=replace(given.ports, by_travel=True))

    with bench() as made:
        made.load_silent = True
        made.plan = once(lambda made: setattr(made, "board_silent", True), second_press)
        with pytest.raises(InputError, match=r"board has said nothing.*tip is up"):
            rig(by_travel(made), yes)
        rows_before = rows_of(tmp_path)
        require_tip_up(made)
        made.board_silent = made.load_silent = False
        with pytest.raises(RecordingError, match="other columns"):
            rig(options(made, tmp_path, presses=3, resume=True), yes)
        require_tip_up(made)
        made.load_silent = True
        done = rig(by_travel(made, resume=True), yes)
        require_tip_up(made)
    assert rows_of(tmp_path)[: len(rows_before)] == rows_before
    assert done["presses"] == 3
    assert max(row["travel_mm"] or 0.0 for row in rows_of(tmp_path)) == pytest.approx(2.0, abs=0.02)


def test_a_board_that_reads_its_load_cell_labels_frames_at_their_time(tmp_path):
    """Ten lines `L` with their own clocks before each frame, as the firmware sends them."""
    with bench() as made:
        made.load_in_bursts = True
        rig(options(made, tmp_path, presses=1, settings={"speed_mm_s": 2.0}), yes)
    rows = rows_of(tmp_path)
    require_right_labels(rows, 12)
    moving = [row for row in rows if 0.3 < row["travel_mm"] < 1.9]
    assert len(moving) >= 5


def loads_in(depths):
    """How often the tip went down to where it touches."""
    touches = np.array([0.0, *depths]) > 0
    return int(np.sum(touches[1:] & ~touches[:-1]))


def test_strokes_of_a_press_are_loads_of_one_place(tmp_path):
    with bench() as made:
        given = {"strokes": 4, "pause_s": 0.6, "depths_mm": (2.0,)}
        rig(options(made, tmp_path, presses=1, settings=given), yes)
        assert not made.machine.overflowed
        require_tip_up(made)
    rows = rows_of(tmp_path)
    require_right_labels(rows)
    assert loads_in([row["travel_mm"] for row in rows]) == 4
    recording = read_recording(tmp_path / "run.nc")
    assert recording.report.presses == 4
    assert recording.report.faults == ()
    frames = recording.frames
    assert len(np.unique(frames.place_id[frames.force_n[:, 0, 2] > 1])) == 1


def test_strokes_after_a_full_force_go_less_deep(tmp_path):
    harder = lambda depth, xy: 2.0 * hertz(depth, xy)  # noqa: E731
    with bench(law=harder) as made:
        given = {"strokes": 3, "pause_s": 0.6, "depths_mm": (2.5,), "speed_mm_s": 1.0}
        found = rig(options(made, tmp_path, presses=1, settings=given), yes)
        require_tip_up(made)
    assert found["presses"] == 1
    rows = rows_of(tmp_path)
    assert loads_in([row["travel_mm"] for row in rows]) == 3
    peaks = list(map(max, split_loads(rows)))
    assert peaks[0] >= 0.9 * SETTINGS["full_n"]  # the frame in which it is met may be cut off
    assert max(peaks[1:]) < SETTINGS["full_n"] < LIMIT_N


@pytest.mark.slow
def test_a_cable_out_between_strokes_leaves_the_tip_clear_and_the_press_is_done_again(tmp_path):
    given = {"strokes": 6, "pause_s": 0.6, "depths_mm": (2.0,)}
    with bench() as made:
        silence = lambda made: setattr(made, "machine_silent", True)  # noqa: E731
        made.plan = once(silence, second_press)  # deep for the second time: the second stroke
        with pytest.raises(InputError, match=r"machine has said nothing.*could NOT be raised"):
            rig(options(made, tmp_path, presses=1, settings=given), yes)
        assert made.machine.position[2] == pytest.approx(TOP_MM + 0.5, abs=0.15)
        assert 2 <= loads_in(made.depths) - 5 * 2 < 6  # without touching off at five places
        before = rows_of(tmp_path)
        made.machine_silent = False
        rig(options(made, tmp_path, presses=1, settings=given, resume=True), yes)
        require_tip_up(made)
    rows = rows_of(tmp_path)
    assert rows[: len(before)] == before
    assert loads_in([row["travel_mm"] for row in rows[len(before) :]]) == 6
    assert [one["press"] for one in events(tmp_path, "finished")] == [0]
    require_right_labels(rows)


def split_loads(rows):
    """Forces of each stretch below the surface."""
    down = np.array([row["travel_mm"] > 0 for row in rows])
    forces = np.array([row["cell1_force_n"] for row in rows])
    parts = np.split(np.arange(len(rows)), np.flatnonzero(np.diff(down)) + 1)
    return [forces[part] for part in parts if down[part[0]]]


def by_place(rows):
    names = sorted({(row["cell1_x1_mm"], row["cell1_y1_mm"]) for row in rows})
    return [[row for row in rows if (row["cell1_x1_mm"], row["cell1_y1_mm"]) == n] for n in names]


def test_a_load_beyond_the_limit_stops_the_feed_within_one_frame(tmp_path):
    harder = lambda depth, xy: hertz(depth, xy) * (1 + 9 * (depth > 1.5))  # noqa: E731
    with bench(law=harder) as made:
        given = options(made, tmp_path, settings={"full_n": 10.0, "speed_mm_s": 1.0})
        with pytest.raises(
            InputError, match=r"more than the limit of 13.3.*The tip is up; --resume"
        ):
            rig(given, yes)
        require_tip_up(made)
        beyond = next(k for k, force in enumerate(made.forces) if force > LIMIT_N)
        assert made.depths[beyond + 1] - made.depths[beyond] < 0.05  # of 0.1 mm per frame
        assert made.depths[beyond + 2] <= made.depths[beyond + 1] + 1e-9
    assert [one["press"] for one in events(tmp_path, "begun")] == [0]


def once(act, when):
    done = []

    def plan(made):
        if not done and when(made):
            done.append(act(made) or True)

    return plan


def second_press(made):
    """Deep in the second press."""
    deep = np.array([0.0, *made.depths]) > 1.4
    return np.sum(deep[1:] & ~deep[:-1]) == 2 and deep[-1]


def test_after_a_fault_the_run_goes_on_without_pressing_twice(tmp_path):
    """After an alarm; whichever fault it is, a run goes on from its journal."""
    with bench() as made:
        made.plan = once(lambda made: made.machine.alarm(1), second_press)
        with pytest.raises(InputError, match=r"ALARM:1 \(a limit switch.*could NOT be raised"):
            rig(options(made, tmp_path, presses=3), yes)
        before = rows_of(tmp_path)
        found = rig(options(made, tmp_path, presses=3, resume=True), yes)
        require_tip_up(made)
    rows = rows_of(tmp_path)
    assert rows[: len(before)] == before
    assert found["presses"] == 3
    finished = [one["press"] for one in events(tmp_path, "finished")]
    assert finished == [0, 1, 2]
    require_right_labels(rows)


def killed(made, given, when):
    """A run by the command line that is killed at a moment; then six seconds of the machine's time."""
    arguments = [
        "bench",
        "rig",
        str(given.spec),
        "--port",
        made.port,
        "--board-port",
        made.board_port,
    ]
    arguments += ["--out", str(given.out), "--face", "3", "--middle", "-150,-100,-8", "--yes"]
    for part in ("depths_mm=1,2", "speed_mm_s=4", "presses=3", "reference_every=0"):
        arguments += ["--plan", part]
    code = "from instobj.cli.app import main; main()"
    process = subprocess.Popen([sys.executable, "-c", code, *arguments])
    made.plan = once(lambda made: process.kill(), when)
    assert process.wait(timeout=300) == -signal.SIGKILL
    until = made.frames + 60
    while made.frames < until:
        time.sleep(0.01)


@pytest.mark.slow
def test_a_killed_run_leaves_the_tip_up_and_goes_on(tmp_path):
    with bench() as made:
        given = options(made, tmp_path, presses=3)
        killed(made, given, second_press)
        require_tip_up(made)
        before = rows_of(tmp_path)
        assert [one["press"] for one in events(tmp_path, "finished")] == [0]
        found = rig(options(made, tmp_path, presses=3, resume=True), yes)
    rows = rows_of(tmp_path)
    assert rows[: len(before)] == before
    assert found["presses"] == 3
    assert [one["press"] for one in events(tmp_path, "finished")] == [0, 1, 2]
    require_right_labels(rows)
    assert read_recording(tmp_path / "run.nc").report.faults == ()


@pytest.mark.slow
def test_a_run_killed_on_its_way_to_the_object_stops_within_a_millimetre(tmp_path):
    with bench() as made:
        made.machine.settings[132] = 30
        killed(
            made,
            options(made, tmp_path),
            lambda made: len(made.depths) > 1 and made.depths[-1] > -1,
        )
        assert made.machine.state == "Idle"
        assert max(made.depths) < 0.3


def test_nothing_moves_before_the_plan_is_confirmed(tmp_path):
    with bench() as made:
        with pytest.raises(InputError, match="nothing was moved"):
            rig(options(made, tmp_path), lambda _: False)
        assert made.machine.state == "Alarm"  # locked, as after power-on
        assert made.machine.lines == []
    assert list(tmp_path.glob("run*")) == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            {"mounting": Mounting((-4.0, -100.0, TOP_MM), 0.0)},
            r"reaches X = 2\.0 mm; .* -300 to 0\.",
        ),
        ({"faces": (3, 4)}, "give one --face"),
        ({"resume": True}, "to go on from"),
    ],
)
def test_plans_that_cannot_be_done_are_refused_before_anything_moves(tmp_path, change, words):
    with bench() as made:
        with pytest.raises(InputError, match=words):
            rig(options(made, tmp_path, **change), yes)
        assert made.machine.lines == []


def test_a_machine_without_homing_is_refused(tmp_path):
    with bench(_22=0) as made, pytest.raises(InputError, match=r"set \$22=1 on the machine"):
        rig(options(made, tmp_path), yes)


def test_a_mounting_turns_places_with_the_face():
    turned = Mounting((-100.0, -50.0, -8.0), 90.0).machine_mm(np.array([[2.0, 0.0], [0.0, 3.0]]))
    assert np.allclose(turned, [[-100.0, -48.0], [-103.0, -50.0]])
