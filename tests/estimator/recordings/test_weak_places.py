"""Presses of a weak place, where another face answers more strongly, beside presses with wrong labels."""

import numpy as np
import pytest

from design.layout.places.contact_grid import PlaceGrid
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording
from estimator.recordings.travel_labels import TravelForces
from estimator.signals.presses import Signals
from tests.support.recordings.judged_cases import raw_table

WEAK, FIRM, SIDE, EDGE = (1, 6.0, 6.0), (1, 0.0, 0.0), (3, 0.0, 0.0), (3, 6.0, -6.0)
FORCE_N, REST, HOLD, PRESS = 8.0, 20, 30, 70
LINE_MM = np.array([-6.0, -3.0, 0.0, 3.0, 6.0])


def gains():
    """Counts per newton of every node of the lattice, (face, node, face, sensor, 3).

    A press shows on its face alone, by 60, on face 1 by 20. In the corner of face 1 its face answers by 3,
    and face 3 by 12 in another pattern than its own presses show.
    """
    rng = np.random.default_rng(3)
    own_answers = np.zeros((5, 25, 5, 3, 3))
    own_answers[np.arange(5), :, np.arange(5)] = 60 * rng.choice([-1, 1], (5, 25, 3, 3))
    own_answers[0] /= 3
    own_answers[0, -1] = 0
    own_answers[0, -1, 0], own_answers[0, -1, 2] = (
        3 * rng.choice([-1, 1], (2, 3, 3)) * [[[1]], [[4]]]
    )
    return own_answers


GAINS = gains()
STRONG = GAINS.copy()
"""The same, but that presses of face 1 show by 60, too, outside of its corner."""
STRONG[0, :-1] *= 3


def gain_of(place, by_place):
    face, x, y = place
    ix, iy = (int(np.flatnonzero(value == LINE_MM)[0]) for value in (x, y))
    return by_place[face - 1, ix * 5 + iy]


def model(faces=5, by_place=GAINS):
    """Mechanics of the object whose presses have these gains, of its first faces."""
    depth = np.array([0.5, 1.0, 2.0])
    force = np.broadcast_to(10 * depth, (faces, 25, 3)).copy()
    sensed = by_place[:faces, :, :faces].reshape(faces, 25, 3 * faces, 3)
    delta = sensed[:, :, None] * force[..., None, None]
    lattice, baseline = PlaceGrid(LINE_MM, LINE_MM), np.zeros((3 * faces, 3))
    signals = Signals(np.arange(1, faces + 1), lattice, depth, force, delta, baseline)
    return TravelForces(
        lambda: pytest.fail("no force is asked for"), np.full(2, np.nan), lambda: signals
    )


def recorded(folder, presses, mechanics=None, by_place=GAINS, silent_press=None):
    """Recording of presses (true place, labelled place), in this order."""
    rng = np.random.default_rng(1)
    force = np.concatenate([np.zeros(REST), np.full(HOLD, FORCE_N), np.zeros(REST)])
    counts = np.concatenate(
        [force[:, None, None, None] * gain_of(true, by_place) for true, _ in presses]
    )
    if silent_press is not None:
        counts[silent_press * PRESS : (silent_press + 1) * PRESS] = 0
    counts = np.round(rng.normal(500 + counts, 10.0))
    labels = np.repeat([label for _, label in presses], PRESS, axis=0)
    touched = np.tile(force > 0, len(presses))
    face, tips = (
        np.where(touched, labels[:, 0], 0),
        np.where(touched[:, None], labels[:, 1:], np.nan),
    )
    table = raw_table(
        len(counts), counts=counts, face=face[:, None].astype(int), tip_xy_mm=tips[:, None, None],
        force_n=(np.tile(force, len(presses)) + rng.normal(0, 0.01, len(counts)))[:, None],
        grid_x_mm=LINE_MM, grid_y_mm=LINE_MM,
    )  # fmt: skip
    write_generic_netcdf(table, folder / "made.nc")
    return read_recording(folder / "made.nc", mechanics=mechanics)


def used(recording):
    """Return of which presses loaded frames are used."""
    frames = recording.frames
    loaded = frames.valid & (frames.place_id >= 0)
    return [bool(loaded[k : k + PRESS].any()) for k in range(0, len(loaded), PRESS)]


def texts(recording, kind):
    return [str(fault) for fault in recording.report.faults if fault.kind == kind]


TRUE = [(place, place) for _ in range(4) for place in (WEAK, FIRM, SIDE, EDGE)]


def test_repeated_presses_of_a_weak_place_are_used_with_a_warning(tmp_path):
    recording = recorded(tmp_path, TRUE)
    assert all(used(recording))
    (text,) = texts(recording, "weak place")
    assert text.startswith("weak place: face 1 (6, 6) mm, 4 presses from row 0: face 3 answers ")
    assert " times as strongly as the labelled face 1" in text
    assert "--spec" in text


def test_a_weak_place_that_is_pressed_once_is_believed_by_the_model_alone(tmp_path):
    once = TRUE[:4] + TRUE[5:8]
    alone = recorded(tmp_path, once)
    assert used(alone) == [False] + 6 * [True]
    (text,) = texts(alone, "doubtful face label")
    assert "as strongly as the labelled face 1; frames not used (--spec" in text
    recording = recorded(tmp_path, once, model())
    assert all(used(recording))
    (text,) = texts(recording, "weak place")
    assert ", in the model 4 times; label believed" in text


def test_the_model_of_an_object_with_fewer_faces_judges_those(tmp_path):
    assert all(used(recorded(tmp_path, TRUE[:4], model(faces=4))))


def test_a_face_that_hardly_answers_at_a_weak_place_is_no_silent_one_by_the_model(tmp_path):
    """3 counts a newton where 60 are usual: less than a tenth. One that is unplugged stays silent."""
    presses = [(place, place) for place in (WEAK, FIRM, FIRM, FIRM, SIDE)]
    alone = recorded(tmp_path, presses, by_place=STRONG)
    assert len(texts(alone, "force without signal")) == 1
    mechanics = model(by_place=STRONG)
    assert all(used(recorded(tmp_path, presses, mechanics, by_place=STRONG)))
    unplugged = recorded(tmp_path, presses, mechanics, by_place=STRONG, silent_press=2)
    assert used(unplugged) == [True, True, False, True, True]
    (text,) = texts(unplugged, "force without signal")
    assert text.startswith(f"force without signal: rows {2 * PRESS}–")


@pytest.mark.parametrize("mechanics", [None, model()], ids=["alone", "by the model"])
@pytest.mark.parametrize("label", [WEAK, FIRM], ids=["weak", "firm"])
def test_single_presses_with_the_label_of_another_face_are_doubted(tmp_path, label, mechanics):
    planted = list(TRUE)
    planted[6] = (SIDE, label)
    recording = recorded(tmp_path, planted, mechanics)
    assert used(recording) == [press != 6 for press in range(len(planted))]
    (text,) = texts(recording, "doubtful face label")
    assert f"–{7 * PRESS - REST - 1}: face 3 answers " in text
    assert len(texts(recording, "weak place")) == 1
    if mechanics:
        assert "a press at face 3 (0, 0) mm answers more alike" in text


@pytest.mark.parametrize("mechanics", [None, model()], ids=["alone", "by the model"])
def test_a_place_with_the_label_of_another_face_throughout_is_doubted(tmp_path, mechanics):
    """All four repetitions agree, and answer as strongly as presses of that face do."""
    planted = [(true, FIRM if true == EDGE else label) for true, label in TRUE if label != FIRM]
    recording = recorded(tmp_path, planted, mechanics)
    assert used(recording) == [true != EDGE for true, _ in planted]
    assert len(texts(recording, "doubtful face label")) == 4


def test_a_weak_pattern_that_presses_of_the_other_face_show_too_is_doubted(tmp_path):
    """Labelled face 3 at one place and face 1 at another, and both respond alike: one of them is wrong."""
    planted = [*TRUE, *((WEAK, SIDE) for _ in range(3))]
    assert not any(used(recorded(tmp_path, planted))[0:16:4])
