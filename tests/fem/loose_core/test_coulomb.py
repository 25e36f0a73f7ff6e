"""Coulomb's friction on a core: closed forms of a block, Cattaneo and Mindlin's sphere, planted faults."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import studies.loose_core.coulomb
from fem.contact.half_space import Patches, traction_compliance
from studies.loose_core.coulomb import LooseBody, SiteLaw, onto_cone, site_axes, untouched
from studies.loose_core.response import CoreWalls

FRICTION = 0.4


def one_site(normal=(0.0, 0.0, 1.0)):
    return CoreWalls(np.zeros((1, 3)), np.zeros(1, int), np.array([normal], float), np.ones(1))


def dragged(path_mm, friction=FRICTION, stiffness=(2.0, 2.0, 3.0)):
    """A block on springs, pushed and dragged by a floor along a path of its places."""
    body = LooseBody(np.diag(stiffness), one_site(), SiteLaw(friction, np.ones(1)))
    state, found = untouched(body.walls), []
    for place in path_mm:
        _, state = body.advance(state, np.array([place], float))
        found.append(state)
    return found


def core_force(state):
    """The floor's force in the object's axes."""
    return np.einsum("sij,si->j", site_axes(np.array([[0.0, 0.0, 1.0]])), state.force_n)


def assert_block_slides():
    """Springs 2 N/mm along, 3 N/mm across; the floor rises by 1 mm, then goes 0.3, 1 and 2 mm along x.

    The push is 3 N and the drag at most 1.2 N, which the spring bears at 0.6 mm: beyond it slides.
    """
    rise, stick, slid, further = dragged([(0, 0, 1), (0.3, 0, 1), (1, 0, 1), (2, 0, 1)])
    assert_allclose(core_force(rise), [0, 0, 3], atol=1e-5)
    assert_allclose(core_force(stick), [0.6, 0, 3], atol=1e-5)
    assert not stick.slipping.any()
    assert_allclose(stick.dissipated_mj, 0, atol=1e-5)
    for state, slip in ((slid, 0.4), (further, 1.4)):
        assert state.slipping.all()
        assert_allclose(core_force(state), [1.2, 0, 3], atol=1e-5)
        assert_allclose(state.displacement_mm, [0.6, 0, 1], atol=1e-5)
        assert_allclose(state.dissipated_mj, 1.2 * slip, rtol=1e-4)


def test_a_block_sticks_then_slides():
    assert_block_slides()


def test_friction_turns_round_with_the_motion():
    """After sliding to +x the floor goes back: the drag falls through zero to −1.2 N over 1.2 mm."""
    *_, back, reverse = dragged([(0, 0, 1), (2, 0, 1), (1.4, 0, 1), (0, 0, 1)])
    assert_allclose(core_force(back), [0, 0, 3], atol=1e-5)
    assert_allclose(core_force(reverse), [-1.2, 0, 3], atol=1e-5)
    assert_allclose(reverse.dissipated_mj, 1.2 * (1.4 + 0.8), rtol=1e-4)


def test_a_floor_that_goes_down_leaves_nothing_behind():
    *_, away = dragged([(0, 0, 1), (0.3, 0, 1), (0.3, 0, -0.5)])
    assert_allclose(core_force(away), 0, atol=1e-9)
    assert_allclose(away.opening_mm, 0.5, atol=1e-6)


def softer_cone(trial_n, friction):
    return onto_cone(trial_n, 0.5 * friction)


def pulling_core(trial_n, friction):
    kept = onto_cone(trial_n, friction)
    kept[:, 0] = trial_n[:, 0]
    return kept


def turned_drag(trial_n, friction):
    kept = onto_cone(trial_n, friction)
    kept[:, 1:] = kept[:, 1:] @ np.array([[0, 1], [-1, 0]])
    return kept


FAULTS = {
    "half the friction": (softer_cone, assert_block_slides),
    "a core that pulls": (pulling_core, test_a_floor_that_goes_down_leaves_nothing_behind),
    "drag across the slip": (turned_drag, assert_block_slides),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_planted_faults_are_noticed(fault, monkeypatch):
    planted, check = FAULTS[fault]
    monkeypatch.setattr(studies.loose_core.coulomb, "onto_cone", planted)
    monkeypatch.setattr(studies.loose_core.coulomb, "_MAX_ITERATIONS", 2000)
    with pytest.raises((AssertionError, studies.loose_core.coulomb.SolverError)):
        check()


RADIUS_MM, DEPTH_MM, MODULUS_MPA = 10.0, 0.1, 1.0
CONTACT_MM = np.sqrt(RADIUS_MM * DEPTH_MM)


def half_space(count=15):
    """Patches of a square grid over 1.2 contact radii, on an incompressible half-space: K and sites."""
    edge = 2.4 * CONTACT_MM / count
    axis = (np.arange(count) - (count - 1) / 2) * edge
    xy = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    area = np.full(len(xy), edge**2)
    patches = Patches(area, xy, area / 12)
    compliance = traction_compliance(patches, patches, MODULUS_MPA, 0.5) / edge**4
    order = np.arange(3 * len(xy)).reshape(3, -1).T.ravel()
    inverse = np.linalg.inv(compliance.reshape(3 * len(xy), -1)[np.ix_(order, order)])
    walls = CoreWalls(
        np.column_stack([xy, np.zeros(len(xy))]),
        np.arange(len(xy)),
        np.tile([1.0, 0.0, 0.0], (len(xy), 1)),
        area,
    )
    return (inverse + inverse.T) / 2, walls


def test_a_sphere_dragged_aside_slips_in_cattaneo_and_mindlins_ring():
    """Directions here: x inwards, y and z along the surface. Hertz: P = 4/3 E* √R δ^{3/2}. Cattaneo
    (1938) and Mindlin (1949), no slip within c: Q = μP (1 − c³/a³), and the sphere moved by
    3 (2 − ν) μ P / (16 G a) (1 − (1 − Q/μP)^{2/3})."""
    stiffness, walls = half_space()
    xy = walls.points_mm[:, :2]
    unit = np.full(len(xy), MODULUS_MPA * np.sqrt(walls.weights_mm2[0]) / 5)
    body = LooseBody(stiffness, walls, SiteLaw(FRICTION, unit))
    sunk = np.zeros((len(xy), 3))
    sunk[:, 0] = DEPTH_MM - np.sum(xy**2, axis=1) / (2 * RADIUS_MM)
    _, pressed = body.advance(untouched(walls), sunk)
    push = pressed.force_n[:, 0].sum()
    reduced = MODULUS_MPA / 0.75
    assert_allclose(push, 4 / 3 * reduced * np.sqrt(RADIUS_MM) * DEPTH_MM**1.5, rtol=0.03)
    shear_modulus, share = MODULUS_MPA / 3, 0.6
    most = 3 * 1.5 * FRICTION * push / (16 * shear_modulus * CONTACT_MM)
    moved = most * (1 - (1 - share) ** (2 / 3))
    aside = sunk + np.array([0.0, moved, 0.0])
    _, dragged_aside = body.advance(pressed, aside)
    axes = site_axes(walls.normal)
    drag = np.einsum("sij,si->sj", axes, dragged_aside.force_n)
    assert_allclose(drag[:, 1].sum(), share * FRICTION * push, rtol=0.03)
    assert abs(drag[:, 2].sum()) < 1e-3 * push
    touching = dragged_aside.force_n[:, 0] > 0
    sticks = touching & ~dragged_aside.slipping
    inner = np.sqrt(sticks.sum() / touching.sum())
    assert_allclose(inner, (1 - share) ** (1 / 3), atol=0.04)
    assert dragged_aside.dissipated_mj > 0
    _, gone = body.advance(dragged_aside, sunk + np.array([0.0, 2 * most, 0.0]))
    drag = np.einsum("sij,si->sj", axes, gone.force_n)
    assert_allclose(drag[:, 1].sum(), FRICTION * gone.force_n[:, 0].sum(), rtol=1e-3)
