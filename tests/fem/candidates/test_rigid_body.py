"""A rigid magnet's motion as weights at its skin: rigid motions, frames, height, and tied magnets."""

import numpy as np
import pytest
from numpy.linalg import norm
from numpy.testing import assert_allclose

from design.layout.body import face_frame
from design.layout.places.contact_grid import grid_places_in_lattice
from design.layout.places.positions import shell_body_layout
from design.layout.pockets import tilted_frame
from design.spec.object import ContactGridSpec, ScoreSpec
from fem.candidates import rigid_body as module
from fem.candidates.motions import FaceCandidates
from fem.candidates.point_motions import interpolate_at
from fem.candidates.presses import presses_at_forces
from fem.candidates.quadrature import outline_quadrature
from fem.candidates.rigid_body import RigidBody, candidate_rows, tied_magnets
from fem.candidates.tied_magnets import (
    DEGREE,
    flexibilities,
    rigid_motions,
    tie_functionals,
    tied_compliance,
)
from fem.linear.response import displacements, face_pressure_loads
from tests.support.objects.magnet_free_cases import nodal

SHIFT = np.array([0.4, -0.9, 0.2])
TURN = np.array([0.03, -0.07, 0.05])
SHAPES = {"disk": {"diameter_mm": 6.0}, "plate": {"shape": "block", "size_mm": (5.0, 3.0)}}
FACE = 3
"""Its x is −z and its y is +y: a mix-up of axes shows."""
PLACES_MM = ((3.0, -5.0), (-8.0, 6.0), (0.0, 0.0), (12.0, 9.0), (-14.0, -2.0))
DEPTHS_MM = (2.0, 3.1)


def rigid(points):
    return SHIFT + np.cross(TURN, points)


def quadratic(points):
    x, y, z = points.T
    return np.column_stack([x * y - z**2, 0.5 * z * x + y**2, x**2 - 2 * y * z])


@pytest.fixture(scope="module")
def of_a_face(lattices):
    """Candidates of one face alone: as much as a test needs that asks nothing of means over faces."""
    return lattices[FACE - 1 : FACE]


@pytest.fixture(scope="module")
def bodies(cube, factor, lattices, disks):
    plate = with_magnets(cube.spec, **SHAPES["plate"])
    return {
        "disk": disks[0],
        "plate": tied_magnets(plate, cube.system, factor, lattices)[0],
    }


@pytest.fixture(scope="module")
def pressed(cube, factor):
    """Pressures (vertex, place) of presses of face 3, and nodal displacements (3·node, place)."""
    spec = cube.spec.changed(
        contact_grid=ContactGridSpec(count=(3, 3), pitch_mm=10.0),
        score=ScoreSpec(force_n=1.0),
        search=cube.spec.search.changed(forces_n=()),
    )
    press = presses_at_forces(spec, cube.response, FACE - 1, (0.5, 1.0))
    pressures = press.pressure_mpa[grid_places_in_lattice(spec), 1].T
    loads = face_pressure_loads(cube.space, spec)[1][:, cube.response.face_loads(FACE - 1)]
    return pressures, displacements(cube.system, factor, loads @ pressures)


def with_magnets(spec, sensed_faces=None, **magnets):
    body = spec.body.changed(sensed_faces=sensed_faces) if sensed_faces else spec.body
    return spec.changed(magnets=spec.magnets.changed(**magnets), body=body)


def tied_motion(spec, cube, factor, degree):
    """Motion (6, vertex) of the only magnet under pressures on its face, by ties in the mesh."""
    functionals, ties = tie_functionals(spec, cube.space, degree)
    flexibility, crossed = flexibilities(spec, cube.system, factor, functionals)
    none = np.zeros((crossed.shape[1],) * 2)
    return tied_compliance(none, flexibility, crossed, ties)[-6:, :-6]


@pytest.mark.parametrize("shape", SHAPES)
def test_weights_give_a_rigid_motion_back(bodies, shape):
    body = bodies[shape]
    at_skin = np.stack(rigid_motions(body.points_mm))
    found = np.einsum("kmp,mpj->kj", body.weights, at_skin)
    assert_allclose(found, np.eye(6), rtol=0, atol=1e-10)


@pytest.mark.parametrize("shape", SHAPES)
def test_rows_give_a_rigid_motion_back_in_every_frame(cube, bodies, shape):
    centres = np.array([[4.0, -6.0, 17.5], [-9.0, 3.0, 16.5]])
    one, other = tilted_frame(9.0, -14.0), tilted_frame(-20.0, 5.0)
    side = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
    for axes in (one, side, np.stack([one, other]), np.stack([other, side])):
        rows = candidate_rows(cube.space, centres, axes, bodies[shape]).motions
        motion = (rows @ nodal(cube.space, rigid)).reshape(-1, 6)
        assert_allclose(motion[:, :3], rigid(centres), rtol=0, atol=1e-10)
        assert_allclose(motion[:, 3:], [TURN, TURN], rtol=0, atol=1e-10)


def test_rows_weigh_displacements_in_the_body_s_own_frame(cube):
    """Any weights, under a field that elements represent exactly: c and ω as vectors of the object."""
    random = np.random.default_rng(5)
    body = RigidBody(
        random.uniform(-1, 1, (7, 3)), random.normal(size=(6, 3, 7)), np.zeros((5, 3, 7))
    )
    centres = np.array([[4.0, -6.0, 17.5], [-9.0, 3.0, 16.5], [0.0, 0.0, 17.0]])
    each = np.stack(
        [tilted_frame(9.0, -14.0), tilted_frame(-20.0, 5.0), face_frame(cube.spec, 3).axes]
    )
    rows = candidate_rows(cube.space, centres, each, body).motions
    read_motion = rows @ nodal(cube.space, quadratic)
    for centre, axes, motion in zip(centres, each, read_motion.reshape(-1, 6), strict=True):
        own = quadratic(centre + body.points_mm @ axes.T) @ axes
        c, w = np.einsum("kmp,pm->k", body.weights, own).reshape(2, 3)
        assert_allclose(motion, np.concatenate([axes @ c, axes @ w]), rtol=0, atol=1e-9)


def test_a_disk_turns_with_its_plane_more_than_by_half_the_curl(cube, bodies):
    """Jeffery, Proc. R. Soc. A 102 (1922) 161: under u_x = γ z a spheroid of ratio 1/6 turns by 0.03 γ.

    Weights of elements of 3 mm make that 0.26 γ; half the curl is 0.5 γ, and is right about the axis.
    """
    centre, n = np.array([[2.0, 5.0, 17.0]]), np.array([0.0, 0.0, 1.0])
    rows = candidate_rows(cube.space, centre, np.eye(3), bodies["disk"]).motions

    def turn(slopes):
        return (rows @ nodal(cube.space, lambda p: p @ slopes.T))[0, 3:]

    unit = np.eye(3)
    assert_allclose(turn(np.outer(unit[0], n)), [0, 0.26, 0], rtol=0, atol=0.03)
    assert_allclose(turn(np.outer(n, unit[0])), [0, -0.74, 0], rtol=0, atol=0.03)
    assert_allclose(turn(np.outer(unit[0], unit[1])), [0, 0, -0.5], rtol=0, atol=0.05)
    share = bodies["disk"].jeffery_parameter
    assert_allclose(share, 0.48, rtol=0, atol=0.05)
    strain = np.array([[0.1, -0.2, 0.5], [-0.2, 0.3, -0.7], [0.5, -0.7, -0.4]])
    assert_allclose(turn(strain), -share * np.cross(n, strain @ n), rtol=0, atol=0.05)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_magnet_at_the_only_candidate_moves_as_its_row_says(
    cube, factor, pressed, shape, monkeypatch
):
    """Alone in the silicone and with the ties' own quadrature: what is left is rounding.

    The coarser quadrature of candidates is off by 3.6 % at most.
    """
    pressures, fields = pressed
    (x, y), depth = (4.0, -7.0), 2.7
    one = with_magnets(
        cube.spec, (FACE,), **SHAPES[shape], positions_mm=((x, y),), depth_mm=(depth,)
    )
    exact = tied_motion(one, cube, factor, module.DEGREE) @ pressures
    lattice = FaceCandidates(FACE, np.array([x]), np.array([y]), np.array([depth]))
    layout = shell_body_layout(one)

    def by_row():
        body = tied_magnets(one, cube.system, factor, [lattice])[0]
        rows = candidate_rows(cube.space, layout.centre_mm, layout.frame, body).motions
        return (rows @ fields)[0]

    coarse = by_row()
    monkeypatch.setattr(module, "CIRCLES", 8)
    monkeypatch.setattr(module, "AROUND", 24)
    fine = by_row()
    for part in (slice(0, 3), slice(3, 6)):
        assert_allclose(fine[part], exact[part], rtol=0, atol=1e-10 * abs(exact[part]).max())
        assert norm(coarse[part] - exact[part]) < 0.05 * norm(exact[part])


def mid_plane_fit(space, centre_mm, axes, outline, fields):
    """Rigid motion that fits a mid-plane best in the least-squares sense: what a magnet does not do."""
    local, weights = outline_quadrature(outline, 2, 8)
    arm = local @ axes[:, :2].T
    values = interpolate_at(space, centre_mm + arm)
    root = np.sqrt(np.tile(weights, 3))[:, None]
    wanted = np.concatenate([values @ part for part in np.split(fields, 3)])
    return np.linalg.lstsq(np.concatenate(rigid_motions(arm)) * root, wanted * root, rcond=None)[0]


@pytest.mark.parametrize("shape", SHAPES)
def test_magnets_anywhere_move_much_more_as_candidates_do_than_as_their_mid_planes(
    cube, factor, bodies, pressed, shape
):
    """One magnet alone, at five places in two depths; weights of candidates are means over the object.

    Off by 8 % (disk) and 10 % (plate) along the normal, 13 and 16 % along the face, 23 and 30 % in the
    tilt; fits of mid-planes by 42 and 35, 26 and 23, 64 and 88 %. Elements of 3 mm make weights differ
    from place to place more than finer ones do; the spin is off by all of its size.
    """
    pressures, fields = pressed
    exact, found, fit = [], [], []
    for place in PLACES_MM:
        for depth in DEPTHS_MM:
            one = with_magnets(
                cube.spec, (FACE,), **SHAPES[shape], positions_mm=(place,), depth_mm=(depth,)
            )
            layout = shell_body_layout(one)
            (centre,), (axes,) = layout.centre_mm, layout.frame
            rows = candidate_rows(cube.space, centre[None], axes, bodies[shape]).motions
            exact.append(in_own_frame(axes, tied_motion(one, cube, factor, DEGREE) @ pressures))
            found.append(in_own_frame(axes, (rows @ fields)[0]))
            fit.append(
                in_own_frame(
                    axes, mid_plane_fit(cube.space, centre, axes, layout.bodies[0].outline, fields)
                )
            )
    exact, found, fit = (np.concatenate(parts, axis=1) for parts in (exact, found, fit))

    def miss(motion, part):
        return norm(motion[part] - exact[part]) / norm(exact[part])

    normal, along, tilt = [2], [0, 1], [3, 4]
    assert miss(found, normal) < 0.11 < 0.34 < miss(fit, normal)
    assert miss(found, tilt) < 0.32 < 0.62 < miss(fit, tilt)
    assert miss(found, along) < 0.17 < 0.22 < miss(fit, along)


def in_own_frame(axes, motion):
    return np.einsum("ji,qjp->qip", axes, motion.reshape(2, 3, -1)).reshape(6, -1)


@pytest.mark.parametrize("shape", SHAPES)
def test_means_that_the_mesh_does_not_tell_apart_get_no_weight(cube, factor, of_a_face, shape):
    """A magnet smaller than the elements it lies in."""
    size = {"diameter_mm": 1.0} if shape == "disk" else {"shape": "block", "size_mm": (1.5, 1.0)}
    small = with_magnets(cube.spec, **size, height_mm=0.5)
    body = tied_magnets(small, cube.system, factor, of_a_face)[0]
    at_skin = np.stack(rigid_motions(body.points_mm))
    found = np.einsum("kmp,mpj->kj", body.weights, at_skin)
    assert_allclose(found, np.eye(6), rtol=0, atol=1e-10)
    assert abs(body.weights[:3]).max() < 1.0


def test_a_magnet_higher_than_its_cover_allows_counts_as_lower(cube, factor, of_a_face):
    """Silicone of 1.5 mm lies over the uppermost candidates: 2.4 mm at most."""
    cover = of_a_face[0].depth_mm[0]
    spec = cube.spec.changed(shell=cube.spec.shell.changed(pocket_depth_mm=4.5))
    lower, limit, higher, highest = (
        tied_magnets(with_magnets(spec, height_mm=height), cube.system, factor, of_a_face)[0]
        for height in (2.0, 1.6 * cover, 2.9, 4.0)
    )
    for one in (higher, highest):
        assert_allclose(one.points_mm, limit.points_mm, rtol=0, atol=1e-12)
        assert_allclose(one.weights, limit.weights, rtol=0, atol=1e-12)
    assert lower.points_mm[:, 2].max() < limit.points_mm[:, 2].max() - 0.1
    assert limit.points_mm[:, 2].max() < 0.8 * cover
    deeper = [FaceCandidates(one.face, one.x_mm, one.y_mm, one.depth_mm[1:]) for one in of_a_face]
    allowed = tied_magnets(with_magnets(spec, height_mm=2.9), cube.system, factor, deeper)[0]
    assert allowed.points_mm[:, 2].max() > limit.points_mm[:, 2].max() + 0.1
