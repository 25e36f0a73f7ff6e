"""Which frames a recorded press is the mean of, and what its forces, contacts and nulls are, by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.spec.object import ObjectSpec
from estimator.calibration import recorded_presses, validation
from estimator.calibration.recorded_presses import PredictedMotions, RecordedPresses
from tests.support.recordings.frame_sets import frame_set

SPEC = ObjectSpec(name="cube")


def frames_of(force, face=(3, 5)):
    """One press of two jaws with the forces (frame, jaw), 15 channels that count the frames."""
    force = np.asarray(force, float)
    count = len(force)
    signal = np.tile(np.arange(count, dtype=float)[:, None, None, None], (1, 5, 1, 3))
    xy = np.tile([[3.0, -1.0], [3.0, 1.0]], (count, 1, 1))
    on_face = np.where(force > 0, np.array(face), 0)
    return frame_set(signal, on_face, xy, force, press_id=np.zeros(count, int))


def test_a_press_is_the_mean_over_frames_in_which_every_contact_holds_half_of_its_largest_force():
    force = [[0, 0], [4, 8], [5, 8], [8, 7], [10, 4], [9, 3.9], [6, 6], [7, 7]]
    ((signal, newton, contacts, count),) = recorded_presses.presses_in_frames(frames_of(force))
    held = [2, 3, 4, 6, 7]
    assert count == 5
    assert_allclose(signal, np.full(15, np.mean(held)))
    assert_allclose(newton, [0, 0, np.mean([5, 8, 10, 6, 7]), 0, np.mean([8, 7, 4, 6, 7]), 0])
    assert contacts == ((3, 3.0, -1.0), (5, 3.0, 1.0))
    assert (
        recorded_presses.presses_in_frames(frames_of(force[:-1])) == []
    )  # four such frames are too few


def recorded(channels=15):
    force = np.zeros((2, 6))
    force[0, 2] = force[1, [2, 4]] = 6.0
    cases = (((3, 0.0, 0.0),), ((3, 0.0, 0.0), (5, 0.0, 0.0)))
    count = np.array([4, 9])
    zeros = np.zeros(2, int)
    return RecordedPresses(
        np.ones((2, channels)), force, np.array([0, 1]), zeros, count, cases, np.ones(3)
    )


def test_cases_channels_and_faces_are_told_by_number():
    presses = recorded()
    assert presses.face_of_case(5).tolist() == [False, True]
    assert recorded_presses.pressed_faces(presses) == [3, 5]
    two = ObjectSpec.model_validate({"name": "two", "body": {"sensed_faces": [2, 4]}})
    count = 3 * two.sensors.count_per_face
    assert recorded_presses.own_channels(two, 4).tolist() == list(range(count, 2 * count))
    whole = replace(presses, signal_counts=np.arange(2 * 5.0 * count).reshape(2, -1))
    only = whole.signal_counts.copy().reshape(2, 5, count)
    only[:, [0, 2, 4]] = np.nan
    sparse = replace(whole, signal_counts=only.reshape(2, -1))
    assert recorded_presses.keep_sensed_faces(two, whole) is whole
    kept = recorded_presses.keep_sensed_faces(two, sparse).signal_counts
    assert_array_equal(kept, only[:, [1, 3]].reshape(2, -1))


def test_motions_between_tabulated_moduli_are_straight_in_their_logarithm():
    ratios = recorded_presses.MODULUS_RATIOS
    motion = np.log(ratios)[None, None, :, None, None] * np.ones((2, 3, 1, 1, 6))
    motions = PredictedMotions(
        motion * [[[[[1.0]]], [[[2.0]]], [[[3.0]]]]], np.zeros((2, 3, 13), bool)
    )
    for ratio in (0.2, 0.33, 1.0, 2.9, 3.0):
        found = motions.motion_of_cases(np.array([0, 2]), ratio)[:, 0, 0]
        assert_allclose(found, np.log(ratio) * np.array([1.0, 3.0]), atol=1e-12)


def test_figures_are_ranked_among_all_exchanges_of_cases():
    values = np.array([[3.0, 1.0], [2.0, 4.0], [5.0, 0.0]])
    case = np.array([0, 1, 0])
    order = np.array([[0, 1], [1, 0]])
    found = validation.mean_figure(values, case, order)
    assert (found.value, found.null, found.p, found.exchanges) == (4.0, (4.0 + 1.0) / 2, 0.5, 2)
    spread = validation.spread_figure(values, case, order)
    assert spread.value == pytest.approx(np.exp(np.std([3.0, 4.0, 5.0])))
    assert spread.null == pytest.approx(
        (np.exp(np.std([3.0, 4.0, 5.0])) + np.exp(np.std([1.0, 2.0, 0.0]))) / 2
    )
    assert spread.p == 1.0
    assert found.judgement == "cannot be told (2 exchanges of places allow no p below 0.5)"
    assert validation.cannot_be_told(20) == ""
    assert validation.Figure(1.0, 0.0, 0.05, 20).judgement == "supported"
    assert validation.Figure(1.0, 0.0, 0.051, 20).judgement == "not supported"


@pytest.mark.parametrize(
    ("size_ratio", "modulus_mpa", "sized", "inside"),
    [
        (0.8, 0.2, "supported", "inside"), (0.79, 0.3, "not supported", "inside"),
        (1.25, 0.4, "supported", "inside"), (1.26, 0.41, "not supported", "outside"),
        (1.0, 0.19, "supported", "outside"),
    ],
)  # fmt: skip
def test_a_verdict_tells_sizes_within_a_quarter_and_moduli_within_the_silicone_s_range(
    size_ratio, modulus_mpa, sized, inside
):
    silicone = SPEC.silicone.changed(youngs_modulus_mpa=0.3, youngs_modulus_range_mpa=(0.2, 0.4))
    figure = validation.Figure(1.4, 1.5, 0.01, 100)
    found = validation.Agreement(
        "face 3", 9, 4, validation.Figure(0.91, 0.32, 0.06, 100),
        validation.Figure(0.83, 0.51, 0.04, 100), size_ratio, figure, modulus_mpa,
        replace(figure, p=0.07), 1.0,
    )  # fmt: skip
    assert validation.verdict(SPEC.changed(silicone=silicone), found) == (
        "face 3: pattern not supported (cosine 0.91, null 0.32, p 0.06); signs right in 83 % "
        f"(null 51 %, p 0.04); absolute size {sized} (recorded {size_ratio:.2f} of predicted, scatter "
        f"×/÷ 1.40, null 1.50); effective modulus {modulus_mpa:.2f} MPa ×/÷ 1.40, {inside} 0.2 to 0.4 "
        "MPa, its scatter no smaller than that of places exchanged (p 0.07)"
    )
    alone = silicone.changed(youngs_modulus_mpa=modulus_mpa, youngs_modulus_range_mpa=None)
    said = validation.verdict(SPEC.changed(silicone=alone), found)
    assert f"inside {modulus_mpa:g} to {modulus_mpa:g} MPa" in said


def test_rows_of_channels_are_correlations_signs_and_slopes_over_the_presses_own_cases():
    """Presses of the first, second and first case; the last channel is missing in one press."""
    measured = np.array([[1.0, 2.0, 3.0], [-2.0, 1.0, 1.0], [3.0, -0.5, np.nan]])
    counts = np.full((3, 2, 3), 99.0)
    own = np.array([[2.0, -1.0, 1.0], [-1.0, 0.0, 1.0], [1.0, -2.0, 1.0]])
    counts[[0, 1, 2], [0, 1, 0]] = own
    presses = replace(
        recorded(), signal_counts=measured, case=np.array([0, 1, 0]), face_force_n=np.ones((3, 6)),
        recording=np.zeros(3, int), frames=np.full(3, 9),
    )  # fmt: skip
    predictions = validation.Predictions(counts, counts[None])
    rows = validation.channel_rows(presses, predictions, ["F1-X1", "F1-Y1", "F1-Z1"])
    assert [row["channel"] for row in rows] == ["F1-X1", "F1-Y1", "F1-Z1"]
    for k, signs in ((0, 1.0), (1, 1 / 3)):
        a, b = measured[:, k] - measured[:, k].mean(), own[:, k] - own[:, k].mean()
        assert rows[k]["correlation"] == pytest.approx(a @ b / np.sqrt(a @ a * (b @ b)))
        assert rows[k]["signs"] == pytest.approx(signs)
    assert [rows[k]["gain"] for k in (0, 1)] == pytest.approx([7 / 6, -1 / 5])
    assert [rows[2][name] for name in ("correlation", "signs", "gain")] == [None] * 3


def test_cosines_signs_sizes_and_moduli_of_single_presses():
    measured = np.array([[3.0, 4.0, 1.0]])
    predicted = np.array([[[3.0, -4.0, 0.0], [6.0, 8.0, 2.0]]])
    clear = np.array([[True, True, False]])
    cosine, signs, size = validation.score_presses(measured, predicted, clear)
    assert_allclose(cosine, [[-7 / (5 * np.sqrt(26)), 1.0]])
    assert_allclose(signs, [[0.5, 1.0]])
    assert_allclose(size, [[np.log(np.sqrt(26) / 5), np.log(0.5)]])
    ratios = recorded_presses.MODULUS_RATIOS
    sizes = (10 / ratios)[:, None, None] * np.array([1.0, 9.0])
    modulus, bounded = validation.effective_ratios(np.array([8.0]), sizes)
    assert_allclose(modulus, [[10 / 8, 3.0]])
    assert bounded.tolist() == [[True, False]]


def test_a_change_is_clear_beyond_three_sigma_of_noise_and_zero():
    presses = recorded(3 * SPEC.sensors.count_per_face * 5)
    zero = SPEC.sensors.zeroing_counts
    sigma = np.hypot([1 / 2, 1 / 3], zero)
    presses.signal_counts[:, 0] = 3 * sigma * [1.0001, 0.9999]
    channels = np.arange(3)
    clear = validation.clear_changes(SPEC, presses, np.arange(2), channels)
    assert clear[:, 0].tolist() == [True, False]


def test_exchanges_keep_to_cases_that_the_same_presses_predict():
    predicted = np.ones((4, 3, 2))
    predicted[:2, 2, 1] = predicted[2:, :2, 1] = np.nan  # one channel of a press is enough
    order = validation.case_permutations(predicted, np.array([0, 1, 2, 2]), 0)
    assert order.tolist() == [[0, 1, 2], [1, 0, 2]]
    sampled = validation.sampled_exchanges(np.array([0, 0, 1, 1, 1]), 3)
    assert sampled.shape == (5001, 5)
    assert sampled[0].tolist() == [0, 1, 2, 3, 4]
    assert_array_equal(np.sort(sampled[:, :2], axis=1), np.tile([0, 1], (5001, 1)))
    assert np.mean(sampled[:, 0] == 1) == pytest.approx(0.5, abs=0.03)
