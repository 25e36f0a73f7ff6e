"""The surfaces given to the mesher have the volumes, places and orientation of the object."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.spatial import KDTree

from design.layout.places.positions import magnet_layout, shell_body_layout
from design.layout.surface import sealed_body_surface, support_rings
from design.spec.object import BodySpec, MagnetSpec, ObjectSpec, ShellSpec
from fem.mesh.edge_lengths import edge_length_field
from fem.mesh.surfaces import all_surfaces, body_surfaces, points_in_body

PAPER = ObjectSpec(name="paper")
SKEWED = ObjectSpec(
    name="skewed",
    body=BodySpec(size_mm=(50.0, 46.0, 40.0)),
    shell=ShellSpec(thickness_mm=7.0, pocket_diameter_mm=5.0, pocket_depth_mm=2.5),
    magnets=MagnetSpec(diameter_mm=5.0, positions_mm=((2.0, -1.0), (-9.0, 4.0), (7.0, -9.5))),
)
BOTH = pytest.mark.parametrize("spec", [PAPER, SKEWED], ids=lambda spec: spec.name)


def test_the_paper_s_sealed_body_has_its_closed_form_volume():
    assert_allclose(sealed_body_surface(PAPER).volume, 51104.0, rtol=1e-12)


def test_a_body_of_unequal_edges_has_its_closed_form_volume():
    assert_allclose(sealed_body_surface(SKEWED).volume, 50 * 46 * 40 - 36 * 32 * 33, rtol=1e-12)


@BOTH
def test_every_magnet_prism_has_the_volume_height_and_place_of_its_disk(spec):
    layout = magnet_layout(spec)
    surfaces = body_surfaces(spec)
    assert len(surfaces) == len(layout.centre_mm) > 0
    disk = np.pi * spec.magnets.diameter_mm**2 / 4 * spec.magnets.height_mm
    for surface, centre, axis in zip(surfaces, layout.centre_mm, layout.axis, strict=True):
        assert surface.is_watertight
        assert_allclose(surface.volume, disk, rtol=1e-12)
        assert_allclose(surface.center_mass, centre, rtol=0, atol=1e-9)
        height = (surface.vertices - centre) @ axis
        assert_allclose([height.min(), height.max()], [-0.5, 0.5], rtol=0, atol=1e-9)


OTHER_BODIES = [
    ObjectSpec.model_validate(content)
    for content in (
        {
            "name": "boards",
            "arrangement": "sensors-in-shell",
            "magnets": {"positions_mm": [[8, 8], [-8, 8], [-8, -8], [8, -8]]},
        },
        {
            "name": "tilted-blocks",
            "magnets": {
                "shape": "block",
                "size_mm": [6.0, 3.0],
                "positions_mm": [[2, -1], [-9, 5]],
                "tilt_deg": [[0, 0], [12, -8]],
                "depth_mm": 3.2,
            },
        },
    )
]


@pytest.mark.parametrize("spec", OTHER_BODIES, ids=lambda spec: spec.name)
def test_boards_and_blocks_are_boxes_in_their_own_directions(spec):
    layout, surfaces = shell_body_layout(spec), body_surfaces(spec)
    assert len(surfaces) == len(layout.face)
    half = np.array([*layout.bodies[0].outline.half_mm, layout.bodies[0].height_mm / 2])
    rng = np.random.default_rng(8)
    for index, (surface, frame) in enumerate(zip(surfaces, layout.frame, strict=True)):
        assert_allclose(surface.volume, 8 * half.prod(), rtol=1e-12)
        local = (surface.vertices - layout.centre_mm[index]) @ frame
        assert_allclose(abs(local[:8]), np.tile(half, (8, 1)), rtol=0, atol=1e-9)
        points = layout.centre_mm[index] + rng.uniform(-1.6, 1.6, (400, 3)) * half @ frame.T
        inside = (abs((points - layout.centre_mm[index]) @ frame) < half).all(axis=1)
        np.testing.assert_array_equal(points_in_body(points, layout, index, spec), inside)


@BOTH
def test_all_surfaces_are_closed_and_point_outwards(spec):
    parts = all_surfaces(spec).split(only_watertight=True)
    assert len(parts) == 2 + 5 * len(spec.magnets.positions_mm)
    assert all(part.volume > 0 for part in parts)
    for part in body_surfaces(spec):
        outward = part.triangles_center - part.center_mass
        assert (np.einsum("ij,ij->i", outward, part.face_normals) > 0).all()


@BOTH
def test_the_support_ring_has_an_edge_where_the_core_ends(spec):
    (ring,) = support_rings(spec)
    core = np.array(spec.core_size_mm)
    assert_allclose(ring.bounds[1, 2], -core[2] / 2, rtol=0, atol=1e-12)
    corners = {tuple(np.round(vertex, 9)) for vertex in ring.vertices}
    wanted = {
        (sx * core[0] / 2, sy * core[1] / 2, -core[2] / 2) for sx in (1, -1) for sy in (1, -1)
    }
    assert wanted <= corners


@BOTH
def test_the_ring_lies_wholly_in_the_silicone(spec):
    body, (ring,) = sealed_body_surface(spec), support_rings(spec)
    assert_allclose(body.intersection(ring).volume, ring.volume, rtol=1e-9)


@BOTH
def test_the_share_of_points_in_a_magnet_is_its_volume(spec):
    """Monte Carlo in a box of twice the disk's diameter, off its centre."""
    layout, magnets = magnet_layout(spec), spec.magnets
    index = len(layout.face) - 2
    rng = np.random.default_rng(3)
    edge = 2 * magnets.diameter_mm
    points = layout.centre_mm[index] + rng.uniform(-0.5, 0.5, (200_000, 3)) * edge
    inside = points_in_body(points, shell_body_layout(spec), index, spec)
    disk = np.pi * magnets.diameter_mm**2 / 4 * magnets.height_mm
    assert_allclose(inside.mean() * edge**3, disk, rtol=0.05)
    prism = body_surfaces(spec)[index]
    assert (inside == prism.contains(points))[:2000].all()


@BOTH
def test_the_edge_length_field_is_positively_oriented_and_fills_its_box(spec):
    field = edge_length_field(spec)
    corner = field.points_mm[field.tets]
    volume = np.linalg.det(corner[:, 1:] - corner[:, :1]) / 6
    assert (volume > 0).all()
    assert_allclose(volume.sum(), np.prod(np.array(spec.body.size_mm) + 2), rtol=1e-12)


@BOTH
def test_edges_are_fine_at_the_pressed_faces_and_coarse_at_the_open_one(spec):
    field = edge_length_field(spec, magnets=False)
    half = np.array(spec.body.size_mm) / 2
    sides = (abs(field.points_mm[:, :2]) >= half[:2]).any(axis=1) | (
        field.points_mm[:, 2] >= half[2]
    )
    assert_allclose(field.length_mm[sides], spec.mesh.surface_edge_mm, rtol=1e-12)
    open_face = (abs(field.points_mm[:, :2]) < half[:2] - 8).all(axis=1)
    open_face &= field.points_mm[:, 2] < -half[2] + 2
    assert open_face.any()
    assert_allclose(field.length_mm[open_face], spec.mesh.edge_mm, rtol=1e-12)


@pytest.mark.parametrize("spec", [SKEWED, *OTHER_BODIES], ids=lambda spec: spec.name)
def test_edges_are_finest_at_the_rims_of_rigid_bodies(spec):
    """Against the nearest of many points on the rims; the background grid is 1 mm wide."""
    field, plain = edge_length_field(spec), edge_length_field(spec, magnets=False)
    layout = shell_body_layout(spec)
    corner = layout.bodies[0].outline.corners_mm(spec.mesh.magnet_sides)
    share = np.linspace(0, 1, 20)[:, None, None]
    outline = (corner + share * (np.roll(corner, -1, axis=0) - corner)).reshape(-1, 2)
    heights = np.linspace(-0.5, 0.5, 5) * layout.bodies[0].height_mm
    wall = np.concatenate([np.column_stack([outline, np.full(len(outline), h)]) for h in heights])
    rims = np.concatenate(
        [c + wall @ f.T for c, f in zip(layout.centre_mm, layout.frame, strict=True)]
    )
    distance = KDTree(rims).query(field.points_mm)[0]
    near, far = distance < 0.5, distance > 6
    assert near.sum() > 50
    assert (field.length_mm[near] < 0.7 * spec.mesh.surface_edge_mm).all()
    assert_array_equal(field.length_mm[far], plain.length_mm[far])
    assert (field.length_mm <= plain.length_mm).all()
