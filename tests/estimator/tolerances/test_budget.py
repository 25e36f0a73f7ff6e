"""The robustness budget against closed forms, the scores and Monte Carlo."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.information.scores import score_places
from estimator.signals.field_setup import zero_motion
from estimator.signals.press_states import press_states
from estimator.signals.presses import press_signals
from estimator.tolerances import budget as tolerances
from estimator.tolerances.assembly import assembled, contribution_sizes, counts_of, designed
from estimator.tolerances.budget import robustness
from estimator.tolerances.result import load_robustness, save_robustness
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

NONE = dict.fromkeys(ObjectSpec(name="x").tolerances.model_dump(), 0.0)
ONE_EACH = {
    "sensor_rotation_deg": 3.0,
    "sensor_gain_relative": 0.04,
    "temperature_k": 8.0,
    "earth_field_ut": 45.0,
    "core_shift_mm": 0.2,
    "modulus_relative": 0.1,
}


def spec_with(as_built=None, score=None, **sizes) -> ObjectSpec:
    return coarse_spec(
        contact_grid={"count": (2, 3), "pitch_mm": 4.0},
        tolerances=NONE | sizes,
        as_built=as_built or {},
        score=score or {},
    )


def budget(spec, draws=2):
    return robustness(spec, *synthetic_presses(spec), draws=draws)


def rows(result):
    return {row.name: row for row in result.contributions}


@pytest.fixture(scope="module")
def few():
    return rows(budget(spec_with(**ONE_EACH)))


def test_contributions_with_closed_forms(few):
    """A turn by a rotation vector of σ each way changes a vector v by √2 σ |v|; gains by σ |v|."""
    turned = few["sensor_rotation"]
    assert_allclose([turned.signal, turned.signal_worst], np.sqrt(2) * np.deg2rad(3.0), rtol=1e-3)
    assert_allclose([few["sensor_gain"].signal, few["sensor_gain"].signal_worst], 0.04, rtol=1e-6)
    assert_allclose(few["temperature"].signal, 8 * 0.0011, rtol=1e-6)
    earth = few["earth_field"]
    one_orientation = 820 * 0.045 / np.sqrt(3)
    assert_allclose(earth.baseline_counts, one_orientation, rtol=1e-6)
    assert earth.false_place_mm > 0
    assert_allclose(few["modulus"].baseline_counts, 0, atol=1e-9)


def test_without_tolerances_nothing_spreads():
    result = budget(spec_with())
    for row in (*result.contributions, result.together, result.monte_carlo):
        assert_allclose(list(vars(row).values())[1:], 0, atol=1e-9)


def test_the_design_is_that_of_the_scores():
    spec = spec_with()
    presses = synthetic_presses(spec)
    scores = score_places(spec, press_signals(spec, *presses))
    result = robustness(spec, *presses, draws=2)
    assert scores.reaches_score_force.all()
    bound = scores.position_bound_mm
    assert_allclose(result.position_median_mm.design, np.median(bound), rtol=0.01)
    assert_allclose(result.position_worst_mm.design, bound.max(), rtol=0.01)
    assert_allclose(result.force_worst_n.design, scores.force_bound_n.max(), rtol=0.01)


SMALL = {
    "sensor_rotation_deg": 0.2,
    "core_shift_mm": 0.03,
    "core_yaw_deg": 0.1,
    "modulus_relative": 0.01,
    "temperature_k": 0.5,
    "earth_field_ut": 5.0,
}


def _agreement(result):
    names = ["baseline_counts", "signal", "false_place_mm", "false_force_n", "force_bound"]
    return np.array([getattr(result.monte_carlo, n) / getattr(result.together, n) for n in names])


def test_monte_carlo_agrees_with_first_order_for_small_tolerances():
    """80 objects: a standard deviation of one cause is known within 8 %."""
    assert_allclose(_agreement(budget(spec_with(**SMALL), draws=80)), 1, atol=0.2)


def test_a_core_that_shifts_and_yaws_is_a_shell_that_moves_the_other_way():
    spec = spec_with(core_shift_mm=0.5, core_yaw_deg=2.0)
    design, model = designed(spec), FieldModel(magnet_source(spec.magnets), "exact")

    def rest(scene):
        return counts_of(spec, scene, zero_motion(scene), model)[0]

    shift, turn = np.array([0.3, -0.8, 0.5]), 0.7
    moved = assembled(spec, design, {"core_shift": shift, "core_yaw": np.array([turn])}).scene
    magnets = design.scene.magnets
    angle = -np.deg2rad(2.0 * turn)
    c, s = np.cos(angle), np.sin(angle)
    back = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    shell = replace(
        magnets,
        centre_mm=(magnets.centre_mm - 0.5 * shift) @ back.T,
        axis=magnets.axis @ back.T,
        side=magnets.side @ back.T,
    )
    assert_allclose(rest(moved), rest(replace(design.scene, magnets=shell)), atol=1e-6)
    assert abs(rest(moved) - rest(design.scene)).max() > 50


def test_seats_lie_in_the_faces_own_directions():
    spec = spec_with(magnet_seat_mm=0.2)
    design, (magnet, face) = designed(spec), (11, 3)
    lateral, depth = np.zeros(50), np.zeros(25)
    lateral[2 * magnet : 2 * magnet + 2], depth[magnet] = [1.5, -1.0], 2.0
    moved = assembled(spec, design, {"magnet_seat": lateral, "magnet_depth": depth})
    change = moved.scene.magnets.centre_mm - design.scene.magnets.centre_mm
    frame = face_frames(spec)[face - 1]
    assert_allclose(change[magnet] @ frame.axes, [0.3, -0.2, 0.4], atol=1e-12)
    assert_allclose(np.delete(change, magnet, 0), 0)
    assert_allclose(moved.aside_mm[magnet], [0.3, -0.2])


def test_a_magnet_aside_moves_as_in_a_press_aside_the_other_way():
    spec = spec_with(magnet_seat_mm=0.1)
    forces, motions = synthetic_presses(spec)
    xy, face = np.array([[1.0, -2.0], [3.0, 2.5]]), np.array([2, 2])
    force = np.array([5.0, 6.0])
    states = press_states(forces, motions, face, xy, force)
    lateral = np.tile([0.6, -0.4], 25)
    aside = assembled(spec, designed(spec), {"magnet_seat": lateral})
    moved = tolerances.moved_aside(aside, states, states.design_motion, 2)
    there = press_states(
        forces, motions, face, xy - 0.1 * np.array([0.6, -0.4]), force
    ).design_motion
    own = slice(5, 10)
    size = abs(there[0, :, own] - states.design_motion[0, :, own]).max()
    assert_allclose(moved[0, :, own], there[0, :, own], atol=0.05 * size)
    assert_allclose(
        np.delete(moved, np.arange(5, 10), 2), np.delete(states.design_motion, np.arange(5, 10), 2)
    )


def test_dead_channels_and_all_channels_are_read_as_the_scores_do():
    dead = {"sensors": [{"face": 2, "sensor": 1, "dead": ["X", "Y", "Z"]}]}
    spec = spec_with(as_built=dead, score={"channels": "all"})
    presses = synthetic_presses(spec)
    scores = score_places(spec, press_signals(spec, *presses))
    result = robustness(spec, *presses, draws=2)
    assert_allclose(result.position_worst_mm.design, scores.position_bound_mm.max(), rtol=0.01)


def test_sizes_are_those_of_the_draws():
    spec = spec_with()
    sizes = contribution_sizes(designed(spec))
    assert sum(sizes.values()) == 50 + 25 + 50 + 25 + 4 * 45 + 3 + 1 + 1 + 1 + 6


def test_budget_survives_its_file(tmp_path):
    result = budget(spec_with(core_yaw_deg=1.0))
    save_robustness(result, tmp_path / "robustness.json")
    assert load_robustness(tmp_path / "robustness.json") == result
