"""Twins: an undisturbed one is the design; drawn ones differ as their tolerances say."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.frames.contact_cases import paper_cases
from estimator.frames.contact_traces import JointMechanics, contact_traces
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import assembled, designed
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    seed=5,
    collection={"poses": (((0.5, -2.0, 0.0),), ())},
    silicone={"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.4999},
)


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def nominal(presses):
    return press_signals(SPEC, *presses)


def test_an_undisturbed_twin_is_the_design(presses, nominal):
    twin = twin_signals(SPEC, designed(SPEC), *presses)
    assert_allclose(twin.baseline_counts, nominal.baseline_counts, rtol=1e-3, atol=1)
    largest = abs(nominal.delta_counts).max()
    assert_allclose(twin.delta_counts, nominal.delta_counts, atol=2e-3 * largest)
    np.testing.assert_array_equal(twin.force_n, nominal.force_n)


def test_the_seed_draws_the_twin(presses):
    first, again, other = (
        twin_signals(SPEC, drawn_assembly(SPEC, seed), *presses) for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(first.delta_counts, again.delta_counts)
    assert np.std(first.baseline_counts - other.baseline_counts) > 50
    assert np.ptp(first.force_n / other.force_n) < 1e-12


@pytest.mark.parametrize("sign", [1, -1])
def test_a_magnet_aside_moves_as_if_the_press_lay_aside(presses, sign):
    """Against a table pressed as far aside the other way, for the magnet's own motion."""
    design = designed(SPEC)
    seat = np.zeros(50)
    seat[:2] = [3.0, -2.0]  # standard deviations of the first magnet, face 1
    aside = assembled(SPEC, design, {"magnet_seat": seat})
    assert_allclose(aside.aside_mm[0], [0.3, -0.2])
    twin = twin_signals(SPEC, aside, *presses)
    from dataclasses import replace

    from design.layout.places.contact_grid import PlaceGrid

    forces, motions = presses
    lattice = forces.lattice
    moved = PlaceGrid(lattice.x_mm - sign * 0.3, lattice.y_mm + sign * 0.2)
    _, shifted = synthetic_presses(SPEC, moved)
    motion = motions.motion.copy()
    motion[0, :, :, 0] = shifted.motion[0, :, :, 0]
    still = replace(aside, aside_mm=0 * aside.aside_mm)
    expected = twin_signals(SPEC, still, forces, replace(motions, motion=motion))
    # the synthetic motion depends on where the magnet is designed to be, not on where it sits
    error = abs(twin.delta_counts - expected.delta_counts)[0].max()
    change = abs(expected.delta_counts - twin_signals(SPEC, still, *presses).delta_counts)[0].max()
    assert (error < 0.15 * change) == (sign == 1)


def test_a_softer_twin_bears_less_at_the_same_travel(presses, nominal):
    soft = assembled(SPEC, designed(SPEC), {"modulus": np.array([-2.0])})
    ratio = np.exp(-0.2)
    assert soft.modulus_ratio == pytest.approx(ratio)
    signals = twin_signals(SPEC, soft, *presses)
    assert_allclose(signals.force_n, ratio * nominal.force_n, rtol=1e-12)
    case = paper_cases(SPEC, 1)[-1]
    response = half_space_response(SPEC)
    hard, joint = (
        contact_traces(SPEC, signals, [case], JointMechanics(response, None, assembly))
        for assembly in (None, soft)
    )
    assert_allclose(joint.force_n, ratio * hard.force_n, rtol=1e-12)
    assert_allclose(joint.counts, hard.counts, atol=2)
