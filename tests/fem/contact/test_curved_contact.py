"""Contact on curved patches: Hertz's sphere on sphere and on cylinder, symmetry, force balance."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import brentq
from scipy.spatial import Delaunay
from scipy.special import ellipe, ellipk

from design.body.kinds.capsule import CapsuleSide
from design.body.surface_chart import Cap, FaceFrame, Relief
from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.contact.indenter import moved, tip_cells
from fem.contact.refined import (
    RefinedFace,
    barycentric,
    cells_compliance,
    facet_shares,
    hat_narrowing,
    hat_patches,
    place_compliance,
    spread_cells,
)
from fem.linear.response import FaceSurface, build_response, face_pressure_loads
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import press_face, require_on_patch, resting_gap_mm
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA, all_silicone

TIP_MM = 5.0
DEPTHS = np.array([0.1, 0.2, 0.3])
SPEC = ObjectSpec.model_validate(
    {"name": "hertz", "silicone": {"youngs_modulus_mpa": YOUNGS_MODULUS_MPA}}
)


def _half_space_face(relief: Relief) -> RefinedFace:
    """A patch whose compliance is a half-space's alone: nothing is left to finite elements."""
    axis = np.linspace(-12, 12, 17)
    xy = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    around = Delaunay(xy)
    x, y, z = np.eye(3)
    frame = FaceFrame(1, z, x, y, np.zeros(3), (12.0, 12.0), relief)
    surface = FaceSurface(1, xy, around.simplices, relief_mm=relief.evaluate(xy)[0])
    none = np.zeros((len(xy), len(xy)))
    narrowing = hat_narrowing(surface)
    elastic = (1.0, 0.5)
    return RefinedFace(frame, surface, 0, hat_patches(surface), none, narrowing, around, elastic)


def _forces(face: RefinedFace, place: tuple[float, float]) -> np.ndarray:
    tip, at = tip_cells(SPEC.indenter), np.array(place)
    spread = spread_cells(face, moved(tip.patches, at), at)
    compliance = place_compliance(spread, cells_compliance(tip.patches, SPEC))
    area = tip.patches.area_mm2
    gap = resting_gap_mm(tip, spread) * area
    return contact_pressures(compliance, gap, area, DEPTHS) @ area


def _hertz(radius_x: float, radius_y: float) -> np.ndarray:
    """Sphere of R 5 mm on a surface of two radii (Johnson, Contact Mechanics, 1985, 4.26 to 4.28)."""
    relative = sorted(1 / (1 / TIP_MM + 1 / radius) for radius in (radius_x, radius_y))
    low, high = relative
    stiff = YOUNGS_MODULUS_MPA / (1 - SPEC.silicone.poisson_ratio**2)
    mean = np.sqrt(low * high)
    shape = 1.0
    if high / low > 1 + 1e-9:

        def ratio(axes: float) -> float:
            square = 1 - axes**2
            k, e = ellipk(square), ellipe(square)
            return (e / axes**2 - k) / (k - e) - high / low

        axes = brentq(ratio, 0.05, 1 - 1e-6)
        square = 1 - axes**2
        k, e = ellipk(square), ellipe(square)
        product = np.sqrt((e / axes**2 - k) * (k - e))
        first = (4 / (np.pi * square) * axes**1.5 * product) ** (1 / 3)
        shape = 2 / np.pi * np.sqrt(axes) / first * k
    return 4 / 3 * stiff * np.sqrt(mean) * (DEPTHS / shape) ** 1.5


@pytest.mark.parametrize(
    ("relief", "radii", "place"),
    [
        (Cap((20.0, 20.0, 20.0)), (20.0, 20.0), (0.0, 0.0)),
        (Cap((20.0, 20.0, 20.0)), (20.0, 20.0), (6.0, 5.0)),
        (Cap((np.inf, 14.0, 14.0)), (np.inf, 14.0), (3.0, -2.0)),
        (Cap((np.inf, 14.0, 14.0)), (np.inf, 14.0), (6.0, 5.0)),
        (Cap(), (np.inf, np.inf), (3.0, -2.0)),
        (CapsuleSide(14.0, 12.0), (np.inf, 14.0), (6.0, 5.0)),
        (CapsuleSide(20.0, 0.0), (20.0, 20.0), (3.0, -2.0)),
    ],
)
def test_hertz_on_curved_patches_wherever_the_tip_lands(relief, radii, place):
    assert_allclose(_forces(_half_space_face(relief), place), _hertz(*radii), rtol=0.03)


@pytest.mark.parametrize("place", [(1.3, -2.0), (10.5, 11.8)])
def test_cells_press_on_the_hats_around_them_narrowed(place):
    """Also where some lie beyond the border, on the nearest vertex alone."""
    face, tip, at = _half_space_face(Cap()), tip_cells(SPEC.indenter), np.array(place)
    patches = moved(tip.patches, at)
    spread = spread_cells(face, patches, at)
    shared = np.zeros((len(face.hats.area_mm2), len(patches.area_mm2)))
    for cell, (xy, area) in enumerate(zip(patches.centre_mm, patches.area_mm2, strict=True)):
        vertices, share = barycentric(face.triangulation, xy[None, :2])
        for vertex, part in zip(vertices[0], share[0], strict=True):
            shared[vertex, cell] += part * area / face.hats.area_mm2[vertex]
    found = np.zeros_like(shared)
    found[spread.rows] = spread.matrix
    assert_allclose(found, face.narrowing.toarray() @ shared, rtol=0, atol=1e-14)


def test_points_of_a_steep_cap_are_shared_among_the_corners_of_its_own_triangles():
    """Within the sagitta of a triangle's edge, however steep; an edge's beyond the border."""
    face = _half_space_face(Cap((20.0, 20.0, 20.0)))
    xy = np.random.default_rng(6).uniform(-12, 12, (200, 2))
    points = np.column_stack([xy, face.frame.relief.evaluate(xy)[0]])
    vertices, share = facet_shares(face, points)
    triangles = {tuple(sorted(corners)) for corners in face.surface.triangles.tolist()}
    assert {tuple(sorted(corners)) for corners in vertices.tolist()} <= triangles
    assert share.min() >= 0
    assert_allclose(share.sum(axis=1), 1)
    corners = face.surface.points_mm[vertices]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    away = np.linalg.norm(np.einsum("nk,nkc->nc", share, corners) - points, axis=1)
    assert (away < longest**2 / 20.0 / 4).all()
    beyond = np.array([[12.6, 0.0, float(face.frame.relief.evaluate(np.array([12.6, 0.0]))[0])]])
    vertices, share = facet_shares(face, beyond)
    assert_allclose(share[0] @ face.surface.points_mm[vertices[0]], [12.0, 0.0, -4.0], atol=0.6)


def test_a_press_that_leaves_the_patch_is_told():
    from design.errors import InputError

    face, tip, at = (
        _half_space_face(Cap((20.0,) * 3)),
        tip_cells(SPEC.indenter),
        np.array([18.5, 0]),
    )
    spread = spread_cells(face, moved(tip.patches, at), at)
    with pytest.raises(InputError, match="leaves the patch of face 1"):
        require_on_patch(tip, spread, 3.0)


@pytest.fixture(scope="module")
def handle():
    """A closed cylinder, pressed on one of its sides."""
    spec = ObjectSpec.model_validate(
        {
            "name": "handle",
            "body": {
                "kind": "cylinder",
                "size_mm": [26, 26, 30],
                "open_faces": [],
                "sensed_faces": [3],
            },
            "shell": {"thickness_mm": 5.0},
            "silicone": {"youngs_modulus_mpa": YOUNGS_MODULUS_MPA},
            "magnets": {"positions_mm": [[0.0, 0.0]]},
            "sensors": {"positions_mm": [[0.0, 0.0]]},
            "core": {"recess_inner_radius_mm": 1.0, "recess_outer_radius_mm": 3.0},
            "indenter": {"radius_mm": 4.0},
            "contact_grid": {"count": [2, 2], "pitch_mm": 2.0},
            "press": {"depths_mm": [0.5, 1.0]},
            "mesh": {
                "edge_mm": 6.0,
                "surface_edge_mm": 2.0,
                "envelope_mm": 0.08,
                "rim_edge_ratio": 1.0,
            },
        }
    )
    mesh = all_silicone(tetrahedralize(spec))
    return spec, mesh, build_response(mesh, spec)


PLACES = np.array([[0.0, 0.0], [0.0, 5.5], [0.0, -5.5]])


def test_a_cylinder_resists_alike_all_round(handle):
    spec, _, response = handle
    force = press_face(spec, response, 0, PLACES, np.array(spec.press.depths_mm)).force_n
    assert_allclose(force / force.mean(axis=0), 1, rtol=0.05)


def test_pressures_on_the_patch_add_up_to_the_force_along_the_tip_s_axis(handle):
    from fem.linear.response import elastic_system

    spec, mesh, response = handle
    frame = face_frame(spec, 3)
    presses = press_face(spec, response, 0, PLACES, np.array(spec.press.depths_mm))
    _, loads = face_pressure_loads(elastic_system(mesh, spec).space, spec)
    for place, vertex, force in zip(PLACES, presses.vertex_mpa, presses.force_n, strict=True):
        total = (loads @ vertex.T).reshape(3, -1, 2).sum(axis=1)
        normal = frame.axes_at(frame.to_plane(place))[:, 2]
        assert_allclose(-normal @ total, force, rtol=0.02)
        across = total + np.outer(normal, force)
        assert (np.linalg.norm(across, axis=0) < 0.06 * force).all()
        lean = np.rad2deg(np.arctan2(-frame.y @ total, -frame.normal @ total))
        assert_allclose(lean, np.rad2deg(place[1] / 13), atol=0.3)  # 25.0° by y in the plane
    tilted = frame.axes_at(frame.to_plane(PLACES[1]))[:, 2]
    assert tilted @ frame.normal < 0.95  # so that the frame's own normal would fail
