"""Objects of six sensed faces and of many chips a face, from a board's lines to predicted contacts."""

import json

import numpy as np
import pytest

from design.catalogue.bus_parts import PICO
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import choose_plan
from estimator.calibration.resting import channel_names
from estimator.frames.dataset import load_frames
from estimator.recordings.boards.lines import Frame, Header
from estimator.recordings.formats.files import read_table
from instobj.bench.firmware.project import project_files
from instobj.bench.live.source import data_set_table
from instobj.bench.live.watch import Watch
from tests.support.avr.board import built, field_mt, messages, needs_simulator, of, world
from tests.support.cli import run
from tests.support.recordings.generic_csv import write_generic_csv
from tests.support.recordings.synthetic_frames import synthetic_frames

TINY = [
    f"--set=training.{setting}"
    for setting in ("epochs=30", "hidden_units=[16, 16]", "ensemble=1", "trees=0", "process=false")
]
GRID_OF_NINE = [[x, y] for x in (-8, 0, 8) for y in (-8, 0, 8)]
OPEN_BELOW, CLOSED = [6], []


def done(*arguments, cwd):
    process = run(*arguments, cwd=cwd)
    assert process.returncode == 0, process.stderr
    return json.loads(process.stdout)


def cube(sensors, open_faces):
    """The paper's cube with boards small enough for that many chips on each face that is not open."""
    places = {"count_per_face": 3} if sensors == 3 else {"positions_mm": GRID_OF_NINE[:sensors]}
    boards = {"package_mm": [4.0, 4.0, 1.6], **places}
    return ObjectSpec.model_validate(
        {"name": "many", "body": {"open_faces": open_faces}, "sensors": boards}
    )


def recorded(tmp_path, name, **made):
    """A board's recording of presses: its lines are replayed, and `collect` writes them down."""
    frames = synthetic_frames(rest=8, **made)
    write_generic_csv(data_set_table(frames), tmp_path / f"{name}_lines.csv")
    arguments = ["--replay", f"{name}_lines.csv@0", "--zero", 8]
    done("bench", "collect", name, *arguments, "--json", cwd=tmp_path)
    return tmp_path / f"{name}.csv"


def test_from_a_boards_lines_to_contacts_on_the_face_that_is_pressed(tmp_path):
    """Six faces of nine chips: more of both than the paper's cube has."""
    faces = (1, 6)
    layout = {"faces": faces, "sides": 6, "sensors": 9, "places": (0, 7, 18)}
    recorded(tmp_path, "first", presses=6, **layout)
    (report,) = done("recordings", "first.csv", "--json", cwd=tmp_path)["reports"]
    assert (report["faces_pressed"], report["faults"]) == (list(faces), [])
    frames = load_frames(tmp_path / "runs/first/frames.nc")
    assert frames.faces.tolist() == list(range(1, 7))
    done("train", "runs/first/frames.nc", *TINY, "--json", cwd=tmp_path)
    done("train", "--export", "runs/first", "--json", cwd=tmp_path)
    again = recorded(tmp_path, "again", presses=2, seed=1, **layout)
    table = read_table(again)
    pressed = np.where(table.force_n[:, 0] > 5.0, table.face[:, 0], 0)
    held = np.isin(pressed, faces)
    sure = np.column_stack([probabilities(tmp_path, face, len(pressed)) for face in faces])[held]
    named = np.array(faces)[sure.argmax(axis=1)]
    assert (named == pressed[held]).mean() > 0.9
    assert (sure.max(axis=1) > 0.5).mean() > 0.9


def test_six_faces_of_24_chips_come_through_line_and_file_to_the_count(tmp_path):
    """432 channels in a line of text of at most 4096 characters."""
    made = {"faces": (3, 6), "sides": 6, "sensors": 24, "places": (5,), "presses": 1}
    table = read_table(recorded(tmp_path, "many", **made))
    sent = synthetic_frames(rest=8, **made)
    np.testing.assert_allclose(table.counts, sent.signal_counts, atol=1e-6)
    assert sorted(set(table.face[table.face > 0])) == [3, 6]


def probabilities(tmp_path, face, frames):
    """Probability of a contact on a face in every frame of the second recording; 0 before a zero."""
    model = f"runs/first/face_{face}.onnx"
    done("predict", model, "again.csv", "--zero", "first:8", "--json", cwd=tmp_path)
    path = tmp_path / f"runs/again/prediction_face_{face}.csv"
    rows = np.genfromtxt(path, delimiter=",", names=True)
    sure = np.zeros(frames)
    sure[rows["frame"].astype(int)] = rows["contact"]
    return sure


def test_the_live_page_takes_every_chip_of_six_faces():
    spec = cube(9, CLOSED)
    names = channel_names(spec)
    assert (len(names), names[0], names[-1]) == (6 * 9 * 3, "F1-X1", "F6-Z9")
    watch = Watch(spec, None, 0)
    watch.take_header(names)
    watch.take_row(1.0, 1.0, (np.arange(len(names)) * 1.0).tolist())
    ((row,), _) = watch.rows_after(0, 1)
    np.testing.assert_array_equal(row.raw, np.arange(len(names)))
    assert row.left_out.shape == (6, 9, 3)


@needs_simulator
def test_the_mega_reads_six_faces(tmp_path):
    spec = cube(3, CLOSED)
    plan, elf = built(spec, tmp_path)
    found, statistics = messages(elf, world(plan, end_ms=400))
    channels = of(Header, found)[0].channels
    assert (len(channels), channels[-1]) == (54, "F6-Z3")
    wanted = np.round([np.array(field_mt(k)) * 32768 / 40 for k in range(18)]).ravel()
    frames = of(Frame, found)
    assert frames
    for frame in frames:
        np.testing.assert_array_equal(frame.counts, wanted)
    assert statistics.damaged_lines == 0


def test_a_board_that_can_is_named_where_one_cannot_supply_the_chips():
    spec = cube(9, CLOSED)
    plan, _ = choose_plan(spec, PICO)
    assert len(plan.chips) == 54
    assert "F6-Z9" in project_files(spec, plan)["plan.py"]


def test_lists_for_five_faces_are_refused_for_six():
    """Face 6 would have none of its own; equal lists are one list for all."""
    lists = [[[x, 0.0]] for x in (-4.0, -2.0, 0.0, 2.0, 4.0)]
    closed = {"name": "six", "body": {"open_faces": []}}
    with pytest.raises(ValueError, match="holds 5 lists"):
        ObjectSpec.model_validate({**closed, "sensors": {"positions_mm": lists}})
    shared = ObjectSpec.model_validate({**closed, "sensors": {"positions_mm": [[2.0, 0.0]]}})
    assert shared.body.sensed == (1, 2, 3, 4, 5, 6)
