"""A whole object calibrated on presses of several tips together, and what it reads of others."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.calibration.twin import unknowns
from estimator.calibration.twin.grasp_twin import (
    GraspMechanics,
    calibrate_on_cases,
    left_share,
    sensor_errors,
)
from estimator.calibration.twin.inverted_twin import inverted_grasps
from estimator.calibration.twin.pressed_cases import pressed_cases
from estimator.frames.windows import all_counts
from estimator.metrics.contacts import contact_rows, matched_contacts
from tests.support.mechanics.inverted import SPEC, presses
from tests.support.physics_pages import assert_page, chosen
from tests.support.recordings.made_grasps import both, built_object, grasps


@pytest.fixture(scope="module")
def built():
    return built_object()


@pytest.fixture(scope="module")
def trained(built):
    """Recordings of one tip and of two tips per jaw."""
    return both(grasps(built, 1, cases=5), grasps(built, 2, cases=4))


@pytest.fixture(scope="module")
def seen(trained):
    return pressed_cases(SPEC, trained, presses()[0])


@pytest.fixture(scope="module")
def twin(seen):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(unknowns, "ITERATIONS", 1)
        return calibrate_on_cases(SPEC, *presses()[:2], seen)


@pytest.fixture(scope="module")
def estimator(twin, seen):
    return inverted_grasps(SPEC, presses()[:2], twin, seen)


def held_out(built):
    """Frames of three tips per jaw at 10 N per face and more."""
    frames = grasps(built, 3, cases=4)
    return frames.select(np.flatnonzero(np.nansum(frames.force_n[..., 2], axis=1) > 20)[::6])


def test_cases_are_means_over_frames_of_like_force(trained, seen):
    assert len(seen) == 9
    assert np.all(np.diff(seen.force_n.sum(axis=2), axis=1) > 0)
    rows = np.flatnonzero(trained.place_id == 0)
    order = np.argsort(np.nansum(trained.force_n[rows, :, 2], axis=1), kind="stable")
    hardest = rows[order][-len(rows) // 4 + 1 :]
    counts = trained.signal_counts[hardest].reshape(len(hardest), -1).mean(axis=0)
    assert_allclose(seen.counts[0, -1], counts[seen.channels], rtol=0.05, atol=20)


def test_cases_left_out_are_predicted_better_than_by_the_design(twin):
    assert twin.helps
    assert not twin.strained
    assert np.median(twin.left_share) < 0.5 * np.median(twin.design_share)


def test_three_tips_that_it_never_saw_are_read(built, estimator):
    frames = held_out(built)
    found, _ = estimator.read(all_counts(frames))
    row = contact_rows(matched_contacts(frames, found))[0]
    assert row["tips a face"] == 3
    assert row["number right %"] >= 60
    assert row["distance mm"] < 3
    assert row["total force N"] < 3
    assert row["not explained %"] <= 10


def test_a_mean_s_variance_is_of_its_frames_and_of_the_zeros_of_its_presses(trained, seen):
    rows = np.flatnonzero(trained.place_id == 0)
    rows = rows[np.argsort(np.nansum(trained.force_n[rows, :, 2], axis=1), kind="stable")]
    for level, part in enumerate(np.array_split(rows, seen.counts.shape[1])):
        zeros = len(set(trained.press_id[part].tolist()))
        white = np.tile(np.square(SPEC.sensors.noise_counts), 15)[seen.channels]
        expected = white / len(part) + SPEC.sensors.zeroing_counts**2 / zeros
        assert_allclose(seen.noise_counts2[0, level], expected)
    assert zeros > 1


def test_noise_is_the_recording_s_where_one_is_known(trained, seen):
    """Simulated presses have the specification's, and so has an axis that was never at rest."""
    noise = np.array([3.0, np.nan, 70.0])
    told = replace(trained, noise_counts=noise, source="recorded")
    found = pressed_cases(SPEC, told, presses()[0])
    expected = np.array([3.0, SPEC.sensors.noise_counts[1], 70.0])
    assert_allclose(found.noise_counts, expected)
    assert_allclose(seen.noise_counts, SPEC.sensors.noise_counts)
    frames = np.array([len(part) for part in np.array_split(rows_of(trained, 0), 4)])
    more = np.tile(expected**2 - np.square(SPEC.sensors.noise_counts), 15)[found.channels]
    assert_allclose(
        found.noise_counts2[0] - seen.noise_counts2[0], more / frames[:, None], atol=1e-9
    )


def rows_of(frames, case):
    return np.flatnonzero(frames.place_id == case)


def test_an_object_that_is_not_the_drawing_is_told(built, trained, twin):
    chips = np.random.default_rng(1).permutation(15)

    def otherwise(frames):
        counts = frames.signal_counts.reshape(-1, 15, 3)[:, chips, ::-1]
        return replace(frames, signal_counts=counts.reshape(-1, 5, 3, 3))

    other = otherwise(trained)
    seen = pressed_cases(SPEC, other, presses()[0])
    design = replace(twin, numbers=0 * twin.numbers, residual=seen.counts - predicted(seen, twin))
    assert left_share(seen, design.residual.reshape(-1, len(seen.channels))).min() > 0.7
    frames = otherwise(held_out(built))
    found, _ = inverted_grasps(SPEC, presses()[:2], design, seen).read(all_counts(frames))
    assert not found.explained.any()
    assert np.nanmedian(found.position_radius_mm) > 4


def predicted(seen, twin):
    """Of the design."""
    mechanics = GraspMechanics(twin.unknowns, *presses()[:2], seen)
    return mechanics.expected(np.zeros(len(twin.unknowns))).reshape(seen.counts.shape)


def test_a_channel_that_was_dead_in_training_is_not_read_others_with_its_noise(seen, twin):
    kept = np.arange(1, len(seen.channels))
    part = {
        name: getattr(seen, name)[..., kept] for name in ("counts", "noise_counts2", "chip_counts")
    }
    noise = np.array([3.0, 50.0, 70.0])
    without = replace(seen, channels=seen.channels[kept], noise_counts=noise, **part)
    found = inverted_grasps(
        SPEC, presses()[:2], replace(twin, residual=twin.residual[..., kept]), without
    )
    assert (1, 0, 0) not in found.channels
    assert len(found.channels) == 44
    assert_allclose(found.disturbances.noise_counts[1:], np.tile(noise, 15)[1:])


def test_errors_of_sensors_are_what_is_left_over(seen):
    rng = np.random.default_rng(2)
    wrong = 0.3 * seen.chip_counts * rng.standard_normal(seen.counts.shape)
    noise = np.sqrt(seen.noise_counts2) * rng.standard_normal(seen.counts.shape)
    assert_allclose(sensor_errors(seen, wrong + noise, 15), 0.3, rtol=0.35)


def test_two_cases_are_too_few(built):
    with pytest.raises(InputError, match="got 2 such cases"):
        pressed_cases(SPEC, grasps(built, 2, cases=2), presses()[0])


def test_the_share_left_is_of_signals_without_their_noise():
    """5 noise² of 30 left, of 130: √(25 / 125); signals lost in noise are measured by the noise."""
    counts = np.array([[[3.0, 11.0]], [[1.0, 1.0]], [[7.0, 9.0]]])
    noise = np.array([[[1.0, 4.0]], [[2.0, 6.0]], [[3.0, 2.0]]])
    residual = np.array([[1.0, np.sqrt(29)], [4.0, np.sqrt(24)], [1.0, 0.5]])
    seen = SimpleNamespace(counts=counts, noise_counts2=noise)
    found = left_share.__wrapped__(seen, residual)
    assert_allclose(found, [np.sqrt(25 / 125), np.sqrt(32 / 8), 0.0])


def test_the_twin_is_as_on_the_page(twin, seen, estimator):
    lines = [
        *chosen(seen, "force_n", "counts", "noise_counts2"),
        *chosen(twin, "numbers", "modulus_error", "left_share", "residual"),
        *chosen(estimator.disturbances, "model_error"),
    ]
    assert_page("estimator/calibration", lines, "twin of grasps, ")


@pytest.mark.parametrize("force", [[1.0, 1.0], [0.0, 2.0], [2.0, 1.5]], ids=str)
def test_presses_whose_forces_do_not_grow_are_of_no_object(force):
    places = SimpleNamespace(assembled=lambda *_: (np.array([force]), np.zeros((1, 2, 1, 6))))
    seen = SimpleNamespace(counts=np.zeros((2, 3, 4)), channels=np.arange(4))
    guess = SimpleNamespace(spec=None, assembly=lambda _: None, correction=lambda _: None)
    one = SimpleNamespace(
        unknowns=guess, pressed=seen, rest=np.zeros((1, 6)), parts=[([0], [0], places)]
    )
    found = GraspMechanics.expected.__wrapped__(one, np.zeros(2))
    assert found.shape == (6, 4)
    assert np.isnan(found).all()
