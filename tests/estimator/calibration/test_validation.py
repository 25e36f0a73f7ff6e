"""Recorded presses made by a known object: agreement and its nulls."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.positions import slipped
from design.spec.mechanics import SlipSpec
from estimator.calibration.recorded_presses import (
    MODULUS_RATIOS,
    RecordedPresses,
    keep_sensed_faces,
    own_channels,
    predicted_motions,
    pressed_faces,
    recorded_presses,
    require_presses_of,
    sensors_not_recorded,
    with_all_sensors,
)
from estimator.calibration.validation import (
    agreement,
    case_permutations,
    channel_rows,
    predict,
    rank_correlation,
    tried_ratios,
    verdict,
)
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.recordings.reading import read_recording
from estimator.signals.press_states import rest_motion
from estimator.tolerances.assembly import designed
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses
from tests.support.physics_pages import assert_page, chosen
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper
from tests.support.recordings.public_recordings import FOLDER, NAMES

SPEC = coarse_spec(silicone={"youngs_modulus_mpa": 0.4, "youngs_modulus_range_mpa": (0.2, 0.6)})
CASES = (
    ((3, -3.0, 2.0), (5, -3.0, -2.0)),
    ((3, 0.5, 4.0), (5, 0.5, -4.0)),
    ((3, 2.5, -3.5), (5, 2.5, 3.5)),
    ((3, 4.0, 1.0), (5, 4.0, -1.0)),
    ((3, -4.0, -4.0), (5, -4.0, 4.0)),
)
SLIP = SlipSpec(shift_mm=(0.5, -0.4, 0.3), rotation_deg=(1.5, 2.0, -2.5))
MODEL = FieldModel(magnet_source(SPEC.magnets), "multipole", 11)


def presses_of(signal=None, copies=4):
    case = np.repeat(np.arange(len(CASES)), copies)
    rng = np.random.default_rng(4)
    force = np.zeros((len(case), 5))
    force[:, [2, 4]] = rng.uniform(5, 8, (len(case), 2))
    signal = np.zeros((len(case), 45)) if signal is None else signal
    frames, recording = np.full(len(case), 50), case % 2
    return RecordedPresses(signal, force, case, recording, frames, CASES, np.array([22, 22, 11.0]))


def true_object(modulus_ratio=0.7):
    """The designed object with its core moved, of a softer silicone."""
    design = designed(SPEC)
    moved = replace(design.scene, sensors=slipped(design.scene.sensors, SLIP))
    return replace(design, scene=moved, modulus_ratio=modulus_ratio)


@pytest.fixture(scope="module")
def problem():
    """Recordings of the true object, with noise: 3 counts and 5 % of each channel."""
    forces, motions = synthetic_presses(SPEC)
    silent = presses_of()
    moving, rest = predicted_motions(forces, motions, silent), rest_motion(motions)
    signal = predict(SPEC, true_object(), moving, rest, MODEL).counts[np.arange(20), silent.case]
    rng = np.random.default_rng(7)
    signal *= 1 + 0.05 * rng.standard_normal(signal.shape)
    presses = presses_of(signal + 3 * rng.standard_normal(signal.shape))
    return SimpleNamespace(presses=presses, moving=moving, rest=rest)


def found(problem, assembly, face=3, presses=None):
    predictions = predict(SPEC, assembly, problem.moving, problem.rest, MODEL)
    return agreement(SPEC, presses or problem.presses, predictions, face, seed=1)


def test_the_true_object_agrees_beyond_its_null(problem):
    result = found(problem, true_object())
    assert result.cosine.value > 0.99 > 0.9 > result.cosine.null
    assert result.cosine.p == pytest.approx(1 / 120)
    assert result.signs.value > 0.98
    assert_allclose([result.size_ratio, result.modulus_mpa / 0.4], 1, atol=0.03)
    assert result.size_spread.value < 1.06 < result.size_spread.null
    assert "pattern supported" in verdict(SPEC, result)


def test_two_places_tell_nothing_of_pattern_size_and_scatter(problem):
    """However well predictions agree: p cannot fall below 0.5."""
    presses = problem.presses
    two = presses.case < 2
    few = replace(presses, case=np.where(two, presses.case, presses.case % 2))
    said = verdict(SPEC, found(problem, true_object(), presses=few))
    untold = "cannot be told (2 exchanges of places allow no p below 0.5)"
    assert f"pattern {untold}" in said
    assert f"than that of places exchanged {untold}" in said
    assert "no smaller" not in said


def test_places_of_different_faces_are_exchanged_in_their_groups():
    """Six places on each of two faces: one exchange of all twelve in 924 keeps the faces."""
    count, half = 12, 6
    predicted = np.ones((count, count, 1))
    predicted[:half, half:] = predicted[half:, :half] = np.nan
    order = case_permutations(predicted, np.arange(count), 1)
    assert len(order) > 1000
    assert (np.sort(order[:, :half]) == np.arange(half)).all()
    assert (order[0] == np.arange(count)).all()
    assert len(np.unique(order, axis=0)) > 1000


def _mirrored(signals):
    return signals * np.tile([-1.0, 1.0, 1.0], 15)


def _wrong_places(signals):
    return np.roll(signals, 4, axis=0)


@pytest.mark.parametrize("fault", [_mirrored, _wrong_places])
def test_wrong_recordings_are_not_supported(problem, fault):
    wrong = replace(problem.presses, signal_counts=fault(problem.presses.signal_counts))
    result = found(problem, true_object(), presses=wrong)
    assert not (result.cosine.significant and result.cosine.value > 0.9)


def test_the_effective_modulus_is_that_of_the_object(problem):
    """The true pose with the design's silicone: sizes alone tell the modulus, 0.7 × 0.4 MPa."""
    pose = true_object(modulus_ratio=1.0)
    for face in (3, 5, None):
        result = found(problem, pose, face)
        assert_allclose(result.modulus_mpa, 0.28, rtol=0.03)
        assert result.modulus_bounded == 1


def test_dead_channels_do_not_matter(problem):
    signal = problem.presses.signal_counts.copy()
    signal[:, [18, 22]] = np.nan
    one_dead = replace(problem.presses, signal_counts=signal)
    result = found(problem, true_object(), presses=one_dead)
    assert result.cosine.value > 0.98
    predictions = predict(SPEC, designed(SPEC), problem.moving, problem.rest, MODEL)
    rows = channel_rows(one_dead, predictions, [str(k) for k in range(45)])
    assert rows[18]["correlation"] is None
    assert rows[19]["correlation"] is not None


def test_one_press_has_no_correlation():
    """NaN, which is no JSON, after three warnings of NumPy."""
    assert rank_correlation(np.array([2.0]), np.array([3.0])) is None
    assert rank_correlation(np.array([1.0, 2.0]), np.array([5.0, 3.0])) == pytest.approx(-1)


def motions_of(case, force_n):
    """Motions at the design's modulus of one case pressed with the given forces on faces 3 and 5."""
    forces, motions = synthetic_presses(SPEC)
    force = np.zeros((20, 5))
    force[:, [2, 4]] = force_n
    presses = replace(presses_of(), face_force_n=force, cases=(case, *CASES[1:]))
    return predicted_motions(forces, motions, presses).motion_of_cases(np.zeros(20, int), 1.0)[0]


def test_motions_superpose_over_tips_and_faces():
    """Each of two tips takes half of its face's force; the faces add."""
    tips = ((3, 1.0, 2.0), (3, -3.0, 2.5))
    both = motions_of((*tips, (5, 1.0, -2.0)), [6.0, 5.0])
    parts = [motions_of((tip,), [3.0, 0.0]) for tip in tips]
    parts.append(motions_of(((5, 1.0, -2.0),), [0.0, 5.0]))
    assert_allclose(both, sum(parts), atol=1e-9)
    assert abs(both - motions_of((tips[0], (5, 1.0, -2.0)), [6.0, 5.0])).max() > 1e-3


def test_a_case_on_other_faces_is_no_prediction():
    assert np.isnan(motions_of(((3, 1.0, 2.0),), [6.0, 5.0])).all()


def test_a_softer_silicone_moves_as_under_more_force():
    forces, motions = synthetic_presses(SPEC)
    presses = presses_of()
    moving = predicted_motions(forces, motions, presses)
    ratio = float(MODULUS_RATIOS[5])
    harder = replace(presses, face_force_n=presses.face_force_n / ratio)
    same = predicted_motions(forces, motions, harder)
    assert_allclose(
        moving.motion_of_cases(presses.case, ratio),
        same.motion_of_cases(presses.case, 1.0),
        rtol=0.01,
        atol=1e-4,
    )


def test_presses_of_a_made_recording(tmp_path):
    path = write_gripper(tmp_path / "made.csv", gripper_arrays())
    presses = recorded_presses([read_recording(path)])
    assert (len(presses), len(presses.cases)) == (6, 2)
    assert [contact[0] for contact in presses.cases[0]] == [3, 5]
    assert presses.face_force_n[:, [2, 4]].min() > 0.5 * 17
    assert not presses.face_force_n[:, [0, 1, 3]].any()
    with pytest.raises(InputError, match="twice"):
        recorded_presses([read_recording(path), read_recording(path)])


@pytest.mark.skipif(
    not all((FOLDER / name).is_file() for name in NAMES),
    reason=f"public recordings not found in {FOLDER}; set INSTOBJ_DATA to their folder",
)
def test_presses_of_the_public_recordings():
    presses = recorded_presses([read_recording(FOLDER / name) for name in NAMES])
    assert (len(presses), len(presses.cases)) == (42, 8)
    assert [len(case) for case in presses.cases].count(4) == 3
    dead = np.isnan(presses.signal_counts)
    both = np.argwhere(dead.all(axis=0)).ravel().tolist()
    assert both == []
    second = presses.recording == 1
    assert dead[second][:, [9, 10, 11]].all()  # F2-1, which loses bits in the second
    assert dead[second][:, [33, 34, 35]].all()  # F4-3, dead in the second
    assert not dead[:, [*range(18, 27), *range(36, 45)]].any()
    force = presses.face_force_n[:, [2, 4]]
    assert (force > 7).all()
    assert (force < 20).all()


def test_faces_have_the_channels_of_their_place_among_the_sensed_ones():
    """An object without faces 2, 4 and 5: face 6 is its third."""
    spec = SPEC.changed(body=SPEC.body.changed(sensed_faces=(1, 3, 6), open_faces=()))
    assert own_channels(spec, 6).tolist() == list(range(18, 27))
    presses = replace(
        presses_of(), cases=(((6, 0.0, 0.0),),) * len(CASES), signal_counts=np.zeros((20, 27))
    )
    assert pressed_faces(presses) == [6]
    require_presses_of(spec, presses)
    other = spec.changed(body=spec.body.changed(sensed_faces=(1, 2, 6)))
    with pytest.raises(InputError, match=r"press face 3; .* senses \[1, 2, 6\]"):
        require_presses_of(other, replace(presses, cases=CASES))
    with pytest.raises(InputError, match=r"hold 45 channels; .* has 27"):
        require_presses_of(spec, presses_of())


def test_channels_of_faces_that_an_object_does_not_sense_are_left_out():
    """Recordings have room for five faces; one that speaks beyond the sensed ones is kept, and refused."""
    spec = coarse_spec(body={"sensed_faces": (2, 3)})
    case, one = np.zeros(2, int), np.ones(2, int)
    signal = np.full((2, 45), np.nan)
    signal[:, 9:27] = np.arange(18)
    force = np.zeros((2, 6))
    cases = (((3, 0.0, 0.0),),)
    presses = RecordedPresses(signal, force, case, one, one + 9, cases, np.ones(3))
    kept = keep_sensed_faces(spec, presses)
    np.testing.assert_array_equal(kept.signal_counts, signal[:, 9:27])
    require_presses_of(spec, kept)
    foreign = replace(presses, signal_counts=np.zeros((2, 45)))
    with pytest.raises(InputError, match="45 channels"):
        require_presses_of(spec, keep_sensed_faces(spec, foreign))


@pytest.fixture(scope="module")
def one_press(tmp_path_factory):
    path = tmp_path_factory.mktemp("made") / "one.csv"
    return read_recording(write_gripper(path, gripper_arrays(presses=1)))


def made_of(recording, read, pressed=(3,), kind="generic"):
    """The recording with readings of some (face, sensor), and other words in its report."""
    where = np.where(read, 7.0, np.nan)[..., None] * np.ones(3)
    frames = len(recording.frames), *where.shape
    return replace(
        recording,
        frames=replace(recording.frames, signal_counts=np.broadcast_to(where, frames).copy()),
        rest_counts=np.broadcast_to(where, (1, *where.shape)).copy(),
        report=replace(recording.report, kind=kind, faces_pressed=pressed),
    )


def test_sensors_without_columns_are_named_and_leave_room_in_the_channels(one_press):
    """Three sensors a face; the recordings have two, and none of the second of face 2."""
    spec = coarse_spec(body={"sensed_faces": (2, 3)})
    read = np.zeros((5, 2), bool)
    read[[1, 2, 2], [0, 0, 1]] = True
    given = [made_of(one_press, read), made_of(one_press, read, kind="gripper")]
    found, gripper = with_all_sensors(spec, given)
    np.testing.assert_array_equal(
        found.frames.signal_counts[:, :, :2], given[0].frames.signal_counts
    )
    assert found.rest_counts.shape == (1, 5, 3, 3)
    assert np.isnan(found.frames.signal_counts[:, :, 2]).all()
    assert gripper.rest_counts.shape == (1, 5, 2, 3)
    assert sensors_not_recorded(spec, [found]) == [(2, 2), (2, 3), (3, 3)]
    whole = made_of(one_press, np.ones((5, 3), bool))
    assert sensors_not_recorded(spec, [found, whole]) == []


def test_a_pressed_face_of_which_no_sensor_was_recorded_is_refused(one_press):
    spec = coarse_spec(body={"sensed_faces": (2, 3)})
    read = np.ones((5, 3), bool)
    read[2] = False
    absent = sensors_not_recorded(spec, [made_of(one_press, read, (2,))])
    assert absent == [(3, 1), (3, 2), (3, 3)]
    with pytest.raises(InputError, match="face 3 is pressed, and none of its sensors was recorded"):
        sensors_not_recorded(spec, [made_of(one_press, read, (2, 3))])


def test_figures_of_merit_are_as_on_the_page(problem):
    result = found(problem, designed(SPEC), None)
    lines = [
        (f"{name}: value, null, p", [one.value, one.null, one.p])
        for name in ("cosine", "signs", "size_spread", "modulus_spread")
        for one in [getattr(result, name)]
    ]
    lines += chosen(result, "size_ratio", "modulus_mpa")
    assert_page("estimator/calibration", [*lines, ("said", verdict(SPEC, result))], "agreement, ")


@pytest.mark.parametrize("modulus", [0.5, 1.0, 1.7])
def test_moduli_that_are_tried_stay_within_those_of_the_mechanics(modulus):
    least, most = min(MODULUS_RATIOS), max(MODULUS_RATIOS)
    wanted = [min(max(modulus * ratio, least), most) for ratio in MODULUS_RATIOS]
    assert_allclose(tried_ratios(modulus), wanted)
