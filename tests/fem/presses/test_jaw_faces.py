"""Flat jaws over whole faces: a table over tilt is every press; bounds are those of tilted presses."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import IndenterSpec
from estimator.information.fisher import disturbance_counts
from estimator.information.jaws import jaw_bounds, signals_of_motions
from estimator.signals.nuisances import nuisance_columns
from fem.presses.jaws import jaw_faces
from fem.presses.joint import Tip, press_tips

HALF = 21.0


@pytest.fixture(scope="module")
def jaw(rigid_spec, rigid_response):
    (found,) = jaw_faces(rigid_spec, rigid_response, [3])
    return found


def tilted_press(spec, response, middle_mm, tilt_deg, size_mm=(63.0, 63.0), place_mm=(0.0, 0.0)):
    """The same jaw as an indenter: depth at the middle, tilts about x and y."""
    jaw = IndenterSpec(kind="cuboid", size_mm=tuple(size_mm), turn_deg=(0.0, *tilt_deg))
    # the depth of an indenter counts from what touches first: its lowest corner over the face
    half = np.minimum(np.array(size_mm) / 2, HALF)
    lower = half[::-1] @ np.tan(np.deg2rad(np.abs(tilt_deg)))
    depth = np.array([middle_mm + lower])
    return press_tips(spec.changed(indenter=jaw), response, [Tip(3, *place_mm)], depth)


@pytest.mark.parametrize("tilt_deg", [(0.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -3.0)])
def test_a_pose_is_the_press_of_the_tilted_jaw(jaw, rigid_spec, rigid_response, tilt_deg):
    """Positive tilt about y takes +x down, about x takes −y down."""
    about_x, about_y = np.tan(np.deg2rad(tilt_deg))
    depth = 0.6
    force, centre, motion = jaw.press(HALF * np.array([about_y, -about_x]) / depth)
    pressed = tilted_press(rigid_spec, rigid_response, depth, tilt_deg)
    assert_allclose(depth * force, pressed.force_n[0], rtol=0.01)
    assert_allclose(centre, pressed.centre_mm[0], rtol=0, atol=0.15)
    largest = abs(pressed.motion[:, :3]).max()
    assert_allclose(depth * motion[:, :3], pressed.motion[:, :3], rtol=0, atol=0.01 * largest)


@pytest.mark.parametrize(
    ("lean", "edges"),
    [((0.1, -0.2), (-21.0, 21.0, -21.0, 21.0)), ((1.3, 0.4), (-8.3, 13.1, -20.2, 5.7))],
)
def test_slopes_of_motions_are_those_of_presses_near_by(jaw, lean, edges):
    """Motions per newton by two leans and four edges, as differences inwards of them; the second leaves cells
    that it covers."""

    def of_newton(shape):
        force, _, motion = jaw.press(shape[:2], shape[2:].reshape(2, 2))
        return motion / force

    shape = np.array([*lean, *edges])
    per_newton, slopes = jaw.motion_with_slopes(shape[:2], shape[2:].reshape(2, 2))
    assert_allclose(per_newton, of_newton(shape), rtol=1e-12)
    for slope, way in zip(slopes, 1e-5 * np.diag([1, 1, 1, -1, 1, -1]), strict=True):
        expected = (of_newton(shape + way) - per_newton) / way.sum()
        assert_allclose(slope, expected, rtol=0, atol=1e-4 * abs(expected).max())


@pytest.mark.parametrize(("covered", "tolerance"), [(1.0, 0.06), (0.5, 0.13)])
def test_bounds_are_those_of_the_information_of_tilted_presses(
    jaw, rigid_spec, rigid_response, covered, tolerance
):
    """Fisher's information by dense matrices, from presses of an indenter that is tilted by degrees, and
    where it ends on the face also moved and of other sizes."""
    bounds = {jaw.covered: jaw for jaw in jaw_bounds(rigid_spec, [jaw])}[covered]
    half = covered * HALF
    edge = 2 * half if covered < 1 else 63.0
    start = np.array([bounds.depth_mm, 0.0, 0.0, 0.0, 0.0, edge, edge])

    def pressed(pose):
        return tilted_press(rigid_spec, rigid_response, pose[0], pose[1:3], pose[5:], pose[3:5])

    assert_allclose(pressed(start).force_n[0], rigid_spec.score.force_n, rtol=0.02)
    middle, turn = 0.2 * bounds.depth_mm, np.rad2deg(0.2 * bounds.depth_mm / half)
    # steps of depth, tilts, place and size
    steps = np.array([middle, turn, turn, 0.5, 0.5, 1.0, 1.0])[: 7 if covered < 1 else 3]
    slopes, readings = [], []
    for unknown, step in enumerate(steps):
        ends = [pressed(start + side * step * np.eye(7)[unknown]) for side in (1, -1)]
        counts = signals_of_motions(rigid_spec, np.stack([end.motion for end in ends]))
        up, down = counts.delta_counts[0, 0].reshape(2, -1)
        slopes.append((up - down) / (2 * step))
        level = [np.append(end.force_n, end.centre_mm) for end in ends]
        readings.append((level[0] - level[1]) / (2 * step))
    columns = nuisance_columns(rigid_spec)
    for state, suffix in (("fresh", ""), ("drifted", "_drifted")):
        sigma = disturbance_counts(rigid_spec.sensors, state, len(columns))
        noise = np.diag(sigma**2) + columns @ columns.T
        covariance = np.linalg.inv(np.array(slopes) @ np.linalg.solve(noise, np.array(slopes).T))
        read = np.array(readings).T @ covariance @ np.array(readings)
        variances = (read[0, 0], read[1, 1] + read[2, 2], covariance[[1, 2], [1, 2]].sum())
        size = covariance.diagonal()[5:].sum() if covered < 1 else np.nan
        names = ("force_bound{}_n", "centre_bound{}_mm", "tilt_bound{}_deg", "size_bound{}_mm")
        stated = [getattr(bounds, name.format(suffix)) for name in names]
        # the tilted jaw has other cells: that alone is 3 %, and where its edges end among them more
        assert_allclose(stated, np.sqrt([*variances, size]), rtol=tolerance)


def test_bounds_of_two_opposed_jaws_are_no_smaller_than_of_each_alone(rigid_spec, rigid_response):
    """More unknowns never bring information; faces without an opposed one have no pair."""
    alone = {3: {}, 5: {}, 1: {}}
    pairs = []
    for bounds in jaw_bounds(rigid_spec, jaw_faces(rigid_spec, rigid_response, [1, 3, 5])):
        if bounds.covered < 1:
            continue
        if bounds.against is None:
            alone[bounds.face] = bounds
        else:
            pairs.append(bounds)
    assert [(pair.face, pair.against) for pair in pairs] == [(3, 5), (5, 3)]
    for pair in pairs:
        for name in ("force_bound_n", "centre_bound_mm", "tilt_bound_deg"):
            more, least = getattr(pair, name), getattr(alone[pair.face], name)
            assert least * (1 - 1e-9) <= more < np.inf, name


def test_motions_of_two_opposed_jaws_of_known_force_add_up(jaw, rigid_spec, rigid_response):
    """Together they are stiffer by a tenth; at the forces that they bear, motions add up within 5 %."""
    other = jaw_faces(rigid_spec, rigid_response, [5])[0]
    flat = rigid_spec.changed(indenter=IndenterSpec(kind="cuboid", size_mm=(63.0, 63.0)))
    tips = [Tip(3, 0.0, 0.0), Tip(5, 0.0, 0.0)]
    together = press_tips(flat, rigid_response, tips, np.full(2, 0.6))
    pressed = [face.press(np.zeros(2)) for face in (jaw, other)]
    summed = sum(
        motion / force * bears
        for (force, _, motion), bears in zip(pressed, together.force_n, strict=True)
    )
    largest = abs(together.motion[:, :3]).max()
    assert_allclose(summed[:, :3], together.motion[:, :3], rtol=0, atol=0.05 * largest)
