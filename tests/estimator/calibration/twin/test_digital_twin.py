"""A twin calibrated on few places against the object itself at the other ones."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import block_diag

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from estimator.calibration.twin import unknowns
from estimator.calibration.twin.added_presses import calibrated_frames
from estimator.calibration.twin.digital_twin import calibrate, left_share, places_left_out
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.pressed_places import (
    PressedPlaces,
    invalidate_hard_presses,
    pressed_places,
)
from estimator.frames.collection import with_slots
from estimator.frames.press_protocol import simulate_presses
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from fem.large_strain.correction import StrainCorrection, corrected_table
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses
from tests.support.physics_pages import assert_page, chosen

pytestmark = pytest.mark.usefixtures("statistics_in_full")
FACE = 3
SPEC = coarse_spec(
    seed=5,
    contact_grid={"count": (7, 7), "pitch_mm": 3.5},
    protocol={
        "presses_per_place": 6,
        "frames_per_press": (3, 12),
        "peak_force_n": (6.0, 9.0),
        "lateral_jitter_mm": 0.0,
    },
)
SOFTENED = StrainCorrection(SPEC.shell.thickness_mm, (0.2, 0.6), (-0.7, 0.8), (-0.6,))


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def truth(presses):
    """Signals of an object off the design in every respect, large deformation included."""
    assembly = drawn_assembly(SPEC, 77)
    return twin_signals(SPEC, assembly, *corrected_table(SPEC, *presses, SOFTENED))


@pytest.fixture(scope="module")
def frames(truth):
    frames = simulate_presses(SPEC, truth, "object")
    return frames.select(np.any(frames.contact_face == FACE, axis=1))


@pytest.fixture(scope="module")
def seen(frames):
    """Every second place in x and y."""
    index = np.round((frames.contact_xy_mm[:, 0] - frames.grid_x_mm[0]) / 3.5).astype(int)
    return pressed_places(SPEC, frames.select((index % 2 == 0).all(axis=1)), FACE)


@pytest.fixture(scope="module")
def twin(presses, seen):
    return calibrate(SPEC, *presses, seen)


@pytest.fixture(scope="module")
def quiet(presses, truth):
    """Calibrated on presses with little noise, so that numbers and process are known apart."""
    sensors = {"noise_counts": (2.0, 2.0, 2.0), "zeroing_counts": 2.0}
    spec = SPEC.model_copy(update={"sensors": SPEC.sensors.model_copy(update=sensors)})
    frames = simulate_presses(spec, truth, "quiet")
    return calibrate(
        spec, *presses, pressed_places(spec, frames, FACE).select_places(np.arange(0, 49, 5))
    )


def left_over(signals, truth, seen):
    """Share of the signals (rms) at 5 N at places that were not pressed."""
    xy = contact_grid(SPEC).xy_mm
    new = xy[~(abs(xy[:, None] - seen.xy_mm) < 1e-6).all(axis=2).any(axis=1)]
    own = slice((FACE - 1) * 9, FACE * 9)
    there, found = (
        counts_at_force(
            press_traces(one, np.full(len(new), FACE), *new.T), np.full((len(new), 1), 5.0)
        ).counts[:, 0, own]
        for one in (truth, signals)
    )
    assert len(new) == 33
    return np.sqrt(np.sum((found - there) ** 2) / np.sum(there**2))


def test_places_never_pressed_are_predicted(presses, truth, seen, twin):
    design = twin_signals(SPEC, unknowns.Unknowns(SPEC, FACE).design, *presses)
    planned, calibrated = (left_over(one, truth, seen) for one in (design, twin.signals()))
    assert planned > 0.08
    assert calibrated < 0.25 * planned
    assert calibrated < 0.05


@pytest.mark.slow
def test_exchanged_places_do_not_help(presses, truth, seen):
    wrong = calibrate(SPEC, *presses, replace(seen, xy_mm=np.roll(seen.xy_mm, 5, axis=0)))
    assert left_over(wrong.signals(), truth, seen) > 0.2


@pytest.mark.slow
def test_without_large_deformation_it_does_worse(monkeypatch, presses, truth, seen, twin):
    with_it = left_over(twin.signals(), truth, seen)
    monkeypatch.setattr(unknowns, "STIFFENING", (1e-9,) * 5)
    small = calibrate(SPEC, *presses, seen)
    assert left_over(small.signals(), truth, seen) > 1.5 * with_it


def test_a_prediction_of_no_object_leaves_everything(seen):
    """NaN counted as nothing left: such a twin was said to help."""
    predicted = np.zeros_like(seen.counts)
    predicted[1] = np.nan
    share = left_share(SPEC, seen, predicted)
    assert share[1] == 1.0
    assert np.isfinite(share).all()


def test_places_left_out_tell_the_error_beforehand(presses, seen):
    few = seen.select_places(np.arange(0, len(seen), 2))
    calibrated, planned = places_left_out(SPEC, *presses, few)
    assert calibrated.shape == planned.shape == (len(few),)
    assert np.median(calibrated) < 0.5 * np.median(planned)
    assert 0 <= np.median(calibrated) < 0.2


def at_five_newtons(signals, xy):
    """Own channels at places of the lattice."""
    face, force = np.full(len(xy), FACE), np.full((len(xy), 1), 5.0)
    own = slice((FACE - 1) * 9, FACE * 9)
    return counts_at_force(press_traces(signals, face, *xy.T), force).counts[:, 0, own]


def drawn_at_five_newtons(twin, xy, count):
    rngs = [np.random.default_rng(seed) for seed in range(count)]
    return np.stack([at_five_newtons(twin.signals(rng), xy) for rng in rngs])


def test_draws_scatter_by_the_error_that_there_is(truth, twin):
    """Around the truth as around their mean, over all places."""
    xy = contact_grid(SPEC).xy_mm
    draws = drawn_at_five_newtons(twin, xy, 12)
    error = (at_five_newtons(truth, xy) - at_five_newtons(twin.signals(), xy)) / draws.std(axis=0)
    assert 0.3 < np.sqrt(np.mean(error**2)) < 2.0


def joint_doubt(twin):
    """Posterior standard deviation (row, channel) of the means' expected values, by one dense matrix
    over all channels, for linear numbers with the process."""
    process, (rows, channels, _) = twin.discrepancy, twin.jacobian.shape
    seen, flat = process.pressed, twin.jacobian.transpose(1, 0, 2).reshape(rows * channels, -1)
    kernel = process.kernel_of(seen.xy_mm, seen.force_n)
    scales = (process.prior.size * process.scale) ** 2
    signal = flat @ flat.T + block_diag(*[scale * kernel for scale in scales])
    zeros = block_diag(*seen.zero_counts2)
    noise = block_diag(*[zeros + np.diag(white) for white in process.white_of.T])
    variance = signal.diagonal() - np.einsum(
        "ij,ji->i", signal, np.linalg.solve(signal + noise, signal)
    )
    return np.sqrt(variance).reshape(channels, rows).T


def test_numbers_and_process_are_drawn_together(quiet):
    """At pressed places, where both are known together much better than either alone."""
    wanted = joint_doubt(quiet)
    seen, own = quiet.discrepancy.pressed, slice((FACE - 1) * 9, FACE * 9)
    face = np.full(len(seen), FACE)
    draws = [
        counts_at_force(
            press_traces(quiet.signals(np.random.default_rng(seed)), face, *seen.xy_mm.T),
            seen.force_n,
            "clamp",
        ).counts[..., own]
        for seed in range(7)
    ]
    spread = np.std(draws, axis=0, ddof=1).reshape(-1, 9)
    strong = (seen.force_n > 3.0).ravel()
    ratio = np.median(spread[strong] / wanted[strong])
    assert 0.85 < ratio < 1.15


def test_an_object_whose_forces_fall_is_told(twin):
    """Large deformation at its limits softens so much that no press grows."""
    numbers = twin.numbers.copy()
    numbers[-5:] = [-5, 5, 0, 0, 0]
    impossible = replace(twin, numbers=numbers, factor=0 * twin.factor)
    for rng in (None, np.random.default_rng(1)):
        with pytest.raises(InputError, match="forces would fall with depth"):
            impossible.signals(rng)


def test_simulated_presses_cover_all_places_and_are_reproducible(twin):
    simulated, again = (calibrated_frames(twin, 2) for _ in range(2))
    np.testing.assert_array_equal(simulated.signal_counts, again.signal_counts)
    assert np.unique(simulated.session_id).tolist() == [0, 1]
    touched = simulated.contact_face[:, 0] == FACE
    assert len(np.unique(simulated.place_id[touched])) == 49
    assert np.unique(simulated.contact_face).tolist() == [0, FACE]


def test_means_by_place_and_force(frames):
    """One tip on the face alone counts; levels hold like forces and add up to all frames."""
    found = pressed_places(SPEC, frames, FACE)
    assert len(found) == 49
    assert (np.diff(found.force_n, axis=1) > 0).all()
    place = np.flatnonzero((found.xy_mm == [3.5, -7.0]).all(axis=1))[0]
    mine = (frames.contact_xy_mm[:, 0] == [3.5, -7.0]).all(axis=1) & frames.valid
    assert found.frames[place].sum() == mine.sum()
    weights = found.frames[place] / mine.sum()
    signal = frames.signal_counts[mine, FACE - 1].reshape(mine.sum(), 9).mean(axis=0)
    assert_allclose(weights @ found.counts[place], signal, rtol=1e-9)
    assert_allclose(weights @ found.force_n[place], frames.force_n[mine, 0, 2].mean(), rtol=1e-9)


def test_what_cannot_calibrate_is_left_out_or_told(frames):
    blind = frames.select(np.arange(len(frames)))
    blind.signal_counts[:, FACE - 1, 0, 1] = np.nan
    assert pressed_places(SPEC, blind, FACE).channels.tolist() == [0, 2, 3, 4, 5, 6, 7, 8]
    two = with_slots(frames, 2)
    two.contact_face[:, 1] = FACE
    with pytest.raises(InputError, match="got 0 such places"):
        pressed_places(SPEC, two, FACE)
    with pytest.raises(InputError, match="Press more places"):
        pressed_places(SPEC, frames.select(frames.place_id == 3003), FACE)


def test_forces_beyond_the_simulated_presses_are_left_out_or_refused(presses, frames, seen):
    """On a table of half the depths, which the labelled presses exceed."""
    forces, motions = presses
    half = slice(0, 3)
    depth = {"depth_mm": forces.depth_mm[half]}
    pressed = {name: getattr(forces, name)[..., half] for name in ("force_n", "contact_area_mm2")}
    shallow = replace(forces, **depth, **pressed)
    with pytest.raises(InputError, match="beyond the deepest simulated press"):
        calibrate(SPEC, shallow, replace(motions, **depth, motion=motions.motion[:, :, half]), seen)
    reached = invalidate_hard_presses(frames, shallow, FACE)
    assert 0.2 < reached.valid.mean() / frames.valid.mean() < 0.9
    i, j = 4, 9  # the lattice has half the grid's pitch
    place = frames.contact_xy_mm[:, 0] == [shallow.lattice.x_mm[i + 1], shallow.lattice.y_mm[j]]
    mine = place.all(axis=1) & frames.valid
    deepest = shallow.force_n[FACE - 1].reshape(15, 15, 3)[i + 1, j, -1]
    wanted = frames.force_n[mine, 0, 2] <= 0.8 * deepest
    assert 0 < wanted.sum() < mine.sum()
    np.testing.assert_array_equal(reached.valid[mine], wanted)


PRIOR = Prior(0.1, 5.0)
NOISY = coarse_spec(sensors={"noise_counts": (2.0, 2.0, 2.0)}, protocol={"force_noise_n": 0.1})


def few_places():
    rng = np.random.default_rng(3)
    return PressedPlaces(
        1,
        np.array([0, 4]),
        np.array([[0.0, 0.0], [4.0, 1.0], [-3.0, 5.0]]),
        np.array([[1.0, 5.0], [2.0, 8.0], [1.5, 9.0]]),
        100 * rng.standard_normal((3, 2, 2)),
        np.array([[20, 30], [10, 40], [25, 25]]),
        36.0 * np.ones((3, 2, 2)),
    )


def covariance_by_hand(seen, channel, xy_mm, force_n):
    """Between points one by one, as the docstring's sum defines it."""

    def matern(a, b):
        s = np.sqrt(5) * np.linalg.norm(a - b) / PRIOR.length_mm
        return (1 + s + s**2 / 3) * np.exp(-s)

    size = (PRIOR.size * np.sqrt(np.mean(seen.counts[..., channel] ** 2))) ** 2
    u = force_n / 10.0
    return np.array(
        [
            [
                size * matern(xy_mm[i], xy_mm[j]) * (u[i] * u[j] + u[i] ** 2 * u[j] ** 2)
                for j in range(len(u))
            ]
            for i in range(len(u))
        ]
    )


@pytest.fixture(scope="module")
def conditioned():
    """Posterior mean and covariance of one channel at two new points, by dense matrices."""
    seen, channel = few_places(), 1
    new_xy, new_force = np.array([[1.0, 2.0], [6.0, -2.0]]), np.array([7.0, 3.0])
    xy = np.concatenate([new_xy, np.repeat(seen.xy_mm, 2, axis=0)])
    force = np.concatenate([new_force, seen.force_n.ravel()])
    whole = covariance_by_hand(seen, channel, xy, force)
    slope = seen.counts[..., channel] / np.maximum(seen.force_n, 0.3)
    white = (2.0**2 + (0.1 * slope) ** 2) / seen.frames + 1.0
    noise = np.diag(white.ravel()) + 36.0 * np.kron(np.eye(3), np.ones((2, 2)))
    gain = np.linalg.solve(whole[2:, 2:] + noise, whole[2:, :2]).T
    residual = seen.counts[..., channel].ravel()
    return seen, new_xy, new_force[:, None], gain @ residual, whole[:2, :2] - gain @ whole[2:, :2]


def test_the_process_is_conditioned_as_dense_matrices_do_it(conditioned):
    seen, xy, force, mean, _ = conditioned
    found = Discrepancy(NOISY, PRIOR, seen).mean(seen.counts.reshape(6, 2), xy, force)
    assert_allclose(found[:, 0, 1], mean, rtol=1e-9)


def test_draws_of_the_doubt_have_the_posterior_covariance(conditioned):
    seen, xy, force, _, covariance = conditioned
    process, rng = Discrepancy(NOISY, PRIOR, seen), np.random.default_rng(0)
    draws = np.stack([process.doubt(xy, force, rng)[:, 0, 1] for _ in range(4000)])
    assert_allclose(draws.mean(axis=0), 0, atol=0.06 * np.sqrt(covariance.diagonal().max()))
    assert_allclose(np.cov(draws.T), covariance, atol=0.08 * covariance.max())


def test_no_force_no_discrepancy():
    seen = few_places()
    found = Discrepancy(NOISY, PRIOR, seen).mean(
        seen.counts.reshape(6, 2), np.array([[1.0, 2.0]]), np.zeros((1, 3))
    )
    assert_allclose(found, 0, atol=0)


def test_the_twin_is_as_on_the_page(twin, seen):
    lines = [
        *chosen(seen, "force_n", "counts", "zero_counts2"),
        *chosen(twin, "numbers", "modulus_error", "residual", "jacobian"),
        ("covariance", twin.factor @ twin.factor.T),
        ("changes (counts)", twin.signals().delta_counts),
    ]
    assert_page("estimator/calibration", lines, "twin, ")
