"""Objects of several shapes, identified from logs that an own model makes, beside labels that say nothing."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from design.errors import RecordingError
from design.spec_io import load_spec
from estimator.adoption.boards import boards_of_faces
from estimator.adoption.identify import Known, identify
from tests.support.recordings.foreign_logs import ForeignObject, make_log
from tests.support.recordings.public_recordings import FOLDER

SMALL = ForeignObject(
    reverse=False, magnets_mm=((0, 0), (10, 10), (-10, 10), (10, -10), (-10, -10)),
    magnet_size_mm=(6, 1), core_mm=13, ring_mm=8.6, spread_mm=7.0,
)  # fmt: skip
"""Magnets in the shell, chips in the core, as in the paper."""
CUBE = FOLDER.parent / "instrumented-cube"
needs_cube = pytest.mark.skipif(not CUBE.exists(), reason=f"no recordings at {CUBE}")


def write(path, columns):
    np.savetxt(path, columns, delimiter=",", fmt="%d")
    return path


def write_floats(folder, columns, force):
    """Write a log with these forces in its third column."""
    path = folder / "log.csv"
    np.savetxt(path, np.column_stack([columns[:, :2], force, columns[:, 3:]]), "%.3f", ",")
    return path


@pytest.mark.parametrize(
    ("thing", "faces", "shape", "pitch"),
    [
        (ForeignObject(faces=6), (1, 2, 3, 4, 5, 6), (4, 4), (9.7, 12)),
        (ForeignObject(chips=4), (2, 5), (3, 5), (16, 9.6)),
        (SMALL, (1, 3), (4, 4), (6, 6)),
    ],
)
def test_chips_under_faces_and_order_of_places_are_found_blind(
    tmp_path, thing, faces, shape, pitch
):
    log = make_log(thing, faces=faces, shape=shape, pitch=pitch, levels=3, rows=5)
    order = np.random.default_rng(4).permutation(log.counts.shape[1])
    found = identify([write(tmp_path / "log.csv", log.columns(order))], Known())
    for face in faces:
        own = range((face - 1) * thing.chips, face * thing.chips)
        assert found.chips_of_face[face] == sorted(int(np.flatnonzero(order == c)[0]) for c in own)
        places = found.orders[0, face]
        assert places.name == f"{shape[0]} rows of {shape[1]}"
        assert places.rank_correlation.min() > 0.85
        assert places.p < 0.02
    assert found.kind == "level"


def test_places_in_a_snake_are_told_from_places_in_rows(tmp_path):
    log = make_log(ForeignObject(), shape=(4, 4), pitch=(10, 12), levels=3, rows=5)
    rows = log.labels[:, 1].astype(int) - 1
    snake = np.where(rows // 4 % 2 == 1, rows // 4 * 4 + 3 - rows % 4, rows)
    labels = log.labels.copy()
    labels[:, 1] = np.where(labels[:, 1] > 0, snake + 1, 0)
    columns = np.column_stack([labels, log.counts.reshape(len(labels), -1)])
    found = identify([write(tmp_path / "log.csv", columns)], Known())
    assert found.orders[0, 1].name == "a snake, 4 rows of 4"


def test_labels_that_say_nothing_find_no_order_of_places(tmp_path):
    log = make_log(ForeignObject(), shape=(4, 4), pitch=(10, 12), levels=3, rows=5)
    new = np.append(0, 1 + np.random.default_rng(5).permutation(16))
    labels = log.labels.copy()
    labels[:, 1] = new[labels[:, 1].astype(int)]
    columns = np.column_stack([labels, log.counts.reshape(len(labels), -1)])
    found = identify([write(tmp_path / "log.csv", columns)], Known())
    assert found.orders == {}
    (order,) = [one for _, one in found.findings if one.question.startswith("order of places")]
    assert order.answer.startswith("cannot be told")


def test_chips_that_feel_nothing_are_given_to_no_face(tmp_path):
    log = make_log(ForeignObject(), shape=(3, 3), levels=3, rows=8)
    still = np.random.default_rng(6).normal(1000, 7, log.counts.shape).round()
    found = identify([write(tmp_path / "log.csv", log.with_counts(still).columns())], Known())
    assert found.chips_of_face == {}


def test_forces_that_come_late_are_brought_to_their_signals(tmp_path):
    thing = ForeignObject()
    force = np.tile(np.concatenate([np.zeros(30), np.linspace(0, 8, 20), np.linspace(8, 0, 20)]), 9)
    place = np.repeat(np.arange(1, 10), 70)
    xy = np.array([(x, y) for x in (-13, 0, 13) for y in (-16, 0, 16)])
    presses = [(2, *xy[p - 1], 0.5 * f) for p, f in zip(place, force, strict=True)]
    counts = np.round(
        thing.counts(presses) + 7 * np.random.default_rng(7).standard_normal((630, 15, 3))
    )
    noise = np.random.default_rng(8).normal(0, 0.05, 630)
    late, timely = np.roll(force, 6) + noise, force + noise
    columns = np.column_stack(
        [np.full(630, 2), place, late.round(3), counts.reshape(630, -1).astype(int)]
    )
    known = Known(columns="face,place,force,chips")
    found, wanted = (identify([write_floats(tmp_path, columns, f)], known) for f in (late, timely))
    (lag,) = [one for _, one in found.findings if one.question == "lag of forces"]
    assert lag.answer.startswith("6 rows")
    assert found.kind == "force"
    assert found.chips_of_face == {2: [3, 4, 5]}
    np.testing.assert_allclose(found.presses[0].change, wanted.presses[0].change, atol=40)


def test_logs_of_unlike_objects_are_not_adopted_together(tmp_path):
    one = make_log(ForeignObject(), shape=(2, 2), levels=2, rows=5)
    other = make_log(ForeignObject(chips=4), shape=(2, 2), levels=2, rows=5)
    paths = [write(tmp_path / f"{k}.csv", log.columns()) for k, log in enumerate((one, other))]
    with pytest.raises(RecordingError, match="one object"):
        identify(paths, Known())


def test_numbers_without_labels_tell_which_chips_answer_and_are_silent(tmp_path):
    log = make_log(ForeignObject(), faces=(1, 4), shape=(3, 3), pitch=(13, 16), levels=3, rows=8)
    counts = log.counts.copy()
    counts[:100, 13] = 0
    bare = write(tmp_path / "bare.csv", counts.reshape(len(counts), -1))
    identified = identify([bare], Known())
    texts = {one.question: one for _, one in identified.findings}
    assert texts["chips that answer"].answer == "chips 1-3, 10-12"
    assert (texts["chips that answer"].p or 1) < 0.02
    assert texts["silent chips"].answer == "chips 14, rows 0-99"
    assert (identified.chips_of_face, identified.orders) == ({}, {})
    with pytest.raises(RecordingError, match="one object"):
        identify([bare, write(tmp_path / "log.csv", log.columns())], Known(label="level"))


@needs_cube
def test_the_second_instrumented_cube_is_identified_blind():
    found = identify([CUBE / "Balanced.csv.gz"], Known())
    texts = [(one.question, one.answer) for _, one in found.findings]
    assert ("silent chips", "chips 13-15, rows 0-4438") in texts
    assert any(
        q == "columns moved" and "chips 1-3 are missing in rows 0-4438" in f for q, f in texts
    )
    assert any(q == "wrong readings" and "chip 13, rows 3509-3554" in f for q, f in texts)
    assert ("label", "level of travel, not a force") in texts
    assert found.chips_of_face == {1: [6, 7, 8]}
    places = found.orders[0, 1]
    assert places.name == "5 rows of 5"
    assert places.rank_correlation.min() > 0.9
    assert places.p < 0.01


@needs_cube
def test_an_earlier_run_without_header_and_a_log_with_names_stripped_give_the_same_chips(tmp_path):
    assert identify([CUBE / "faceForceAuto.csv.gz"], Known()).chips_of_face == {1: [6, 7, 8]}
    text = gzip.decompress((CUBE / "Balanced.csv.gz").read_bytes()).decode()
    bare = tmp_path / "bare.csv"
    bare.write_text(text.split("\n", 1)[1])
    assert identify([bare], Known()).chips_of_face == {1: [6, 7, 8]}


@pytest.mark.skipif(not FOLDER.exists(), reason=f"no recordings at {FOLDER}")
def test_the_paper_s_file_with_names_stripped_tells_its_lag_boards_and_axes(tmp_path):
    """Faces 3 and 5 are held by jaws; the file has the boards of faces 5, 3, 1, 2, 4 in this order."""
    text = (FOLDER / "1probe.csv").read_text().split("\n", 1)[1]
    bare = tmp_path / "bare.csv"
    bare.write_text(text)
    found = identify([bare], Known())
    lag = [one.answer for _, one in found.findings if one.question == "lag of forces"]
    assert lag == ["8 rows behind the chips; corrected"]
    spec = load_spec(Path(__file__).parents[3] / "examples" / "paper_cube.toml")
    boards = boards_of_faces(spec, found.presses[0])
    assert boards.chips_of_face == {3: [3, 4, 5], 5: [0, 1, 2]}
    np.testing.assert_array_equal(boards.turn, np.eye(3))
    assert boards.p < 0.05


def test_a_log_without_rest_is_held_against_its_lowest_levels(tmp_path):
    log = make_log(ForeignObject(), shape=(4, 4), pitch=(10, 12), levels=4, rows=5)
    pressed = log.columns()[log.labels[:, 1] > 0]
    found = identify([write(tmp_path / "log.csv", pressed)], Known())
    assert found.chips_of_face == {1: [0, 1, 2]}
    assert found.orders[0, 1].name == "4 rows of 4"
