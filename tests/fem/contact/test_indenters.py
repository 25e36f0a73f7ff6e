"""Indenters of every kind: profiles, cells, closed forms on the half-space, blocks and layers."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose
from scipy.spatial import ConvexHull

from design.errors import InputError
from design.layout.tips import footprint_mm, path_mm, tip_heights_mm, tip_shape, tips_overlap
from design.spec.object import ContactGridSpec, IndenterSpec, ObjectSpec
from design.spec_io import check, load_spec
from fem.contact.half_space import Patches, normal_compliance, traction_compliance
from fem.contact.indenter import tip_cells
from fem.presses.table import press_face, simulate_lattice
from tests.support.mechanics.block_cases import (
    block_response,
    half_space_forces_n,
    half_space_presses,
    known_block_response,
    plane_strain_modulus_mpa,
    spec_of,
)
from tests.support.mechanics.fem_cases import dimitriadis_force_n, hertz_force_n

NU = 0.4999
PLACES = np.array([[0.0, 0.0], [0.7, -0.4], [1.1, 0.9]])


def heights(places, **indenter):
    return tip_heights_mm(tip_shape(IndenterSpec(**indenter)), np.asarray(places, float))


def test_profiles_by_hand():
    sphere = heights([[0, 0], [3, 0], [0, -4], [3, 4.1]])
    assert_allclose(sphere, [0, 1, 2, np.inf], rtol=0, atol=1e-12)
    flat = heights([[2, 1], [3.5, 0], [4.1, 0]], kind="flat", radius_mm=4, fillet_mm=1)
    assert_allclose(flat, [0, 1 - np.sqrt(0.75), np.inf], rtol=0, atol=5e-3)
    lying = heights([[3, 0], [0, 3], [0, -3], [5.1, 0]], kind="cylinder", radius_mm=5)
    assert_allclose(lying, [0, 1, 1, np.inf], rtol=0, atol=1e-3)
    along_y = heights([[3, 0], [0, 3]], kind="cylinder", radius_mm=5, turn_deg=(90, 0.0, 0.0))
    assert_allclose(along_y, [1, 0], rtol=0, atol=1e-3)


def test_cells_of_a_ball_are_halved_up_to_0_4_mm_above_its_lowest_point():
    """At √(2 · 5 · 0.4 − 0.4²) = 1.96 mm from its middle; they cover the disk once."""
    cells = tip_cells(IndenterSpec(radius_mm=5.0))
    away = np.linalg.norm(cells.patches.centre_mm, axis=1)
    largest = cells.patches.area_mm2.max()
    small = cells.patches.area_mm2 < 0.3 * largest
    edge = np.sqrt(largest)
    assert small[away < 1.96 - edge].all()
    assert not small[(away > 1.96 + edge) & (away < 4)].any()
    assert_allclose(cells.patches.area_mm2.sum(), np.pi * 25, rtol=0.02)
    assert_allclose(cells.height_mm[away.argmin()], 0, atol=0.05)


def test_a_tilted_cuboid_touches_first_with_the_edge_turned_down():
    """Tilt about y by +10° takes +x down: the surface rises towards −x from its edge; the place is under
    its middle."""
    tilted = {"kind": "cuboid", "size_mm": (6.0, 4.0), "turn_deg": (0.0, 0.0, 10.0)}
    assert_allclose(
        heights(np.add([[0, 1], [-2, 0], [-5, -1]], (3 * np.cos(np.deg2rad(10)), 0)), **tilted),
        np.array([0, 2, 5]) * np.tan(np.deg2rad(10)),
        rtol=0,
        atol=1e-9,
    )
    low, high = footprint_mm(IndenterSpec(**tilted))
    assert_allclose([low[1], high[1]], [-2, 2], rtol=0, atol=1e-9)
    assert low[0] < -2.9


def test_cells_cover_the_outline_and_know_their_heights():
    for indenter in (
        IndenterSpec(),
        IndenterSpec(kind="cuboid", size_mm=(7.0, 4.0), turn_deg=(25, 3.0, 0.0)),
        IndenterSpec(radius_mm=3, tip_count=3),
    ):
        tip = tip_cells(indenter)
        outlines = ConvexHull(tip_shape(indenter).corners_mm).volume
        assert_allclose(tip.patches.area_mm2.sum(), indenter.tip_count * outlines, rtol=0.01)
        low, high = footprint_mm(indenter)
        assert (tip.patches.centre_mm > low).all()
        assert (tip.patches.centre_mm < high).all()
        assert tip.height_mm.min() < 0.05
        assert np.bincount(tip.tip).min() > 100
    sphere = tip_cells(IndenterSpec())
    dish = np.pi * 5**3 / 3  # ∫ profile over the disk
    assert_allclose(sphere.height_mm @ sphere.patches.area_mm2, dish, rtol=0.01)


def square(x, y, edge=1.0):
    return Patches(np.array([edge**2]), np.array([[x, y]], float), np.array([edge**2 / 12]))


@pytest.mark.parametrize(("offset", "exact"), [((2, 0), 0.51073), ((3, 0), 0.33646)])
def test_squares_at_a_distance(offset, exact):
    """∬ 1/|x − y| over two unit squares, by quadrature of its autocorrelation."""
    assert_allclose(
        normal_compliance(square(0, 0), square(*offset), 1 / np.pi, 0.0), exact, rtol=3e-3
    )


def test_tractions_at_a_distance_are_those_of_point_forces():
    """Johnson (1985), 3.2 and 3.6, with r = (3, 4)·20 and ν = 0.3."""
    nu, modulus = 0.3, 0.3
    moved = traction_compliance(square(60, 80), square(0, 0), modulus, nu)[:, 0, :, 0]
    factor = (1 + nu) / (np.pi * modulus)
    n = np.array([0.6, 0.8])
    expected = np.empty((3, 3))
    expected[0, 0] = (1 - nu) * factor / 100
    expected[1:, 1:] = factor / 100 * ((1 - nu) * np.eye(2) + nu * np.outer(n, n))
    expected[1:, 0] = -factor * (1 - 2 * nu) / 2 * n / 100
    expected[0, 1:] = -expected[1:, 0]
    assert_allclose(moved, expected, rtol=2e-4)


def test_hertz_on_the_half_space():
    """Down to a contact of 0.35 mm, one cell in radius; single cells in contact show as ±1.3 %."""
    depths = np.array([0.02, 0.05, 0.1, 0.25])
    force = half_space_forces_n(spec_of(NU), depths) / hertz_force_n(depths, 5.0, NU)
    assert_allclose(force, 1, rtol=0.015)
    assert_allclose(force.mean(), 1, rtol=0.006)


def test_the_line_contact_of_a_long_cylinder():
    """Middle of a cylinder of 16 mm: p₀ = √(P′E*/πR) and half width √(4P′R/πE*) for its own P′."""
    spec = spec_of(NU, kind="cylinder", radius_mm=4.0, size_mm=(16.0, 9.0), turn_deg=(90, 0.0, 0.0))
    pressures, tip = half_space_presses(spec, [0.3])
    x, y = tip.patches.centre_mm.T
    middle = abs(y) < 2
    width = np.ptp(y[middle]) + 2 * abs(y[middle]).min()
    line = pressures[0, middle] @ tip.patches.area_mm2[middle] / width
    modulus = plane_strain_modulus_mpa(NU)
    peak = np.sqrt(line * modulus / (np.pi * 4))
    assert_allclose(pressures[0, middle & (abs(x) < 0.3)].mean(), peak, rtol=0.03)
    half_width = np.sqrt(4 * line * 4 / (np.pi * modulus))
    assert abs(abs(x[middle & (pressures[0] > 0)]).max() - half_width) < 0.3


SQUARE_BAR = tuple((x, y, z) for x in (-3.0, 3.0) for y in (-3.0, 3.0) for z in (0.0, 9.0))


@pytest.mark.parametrize(
    ("kind", "capacitance_mm", "error"),
    [
        ({"kind": "flat", "radius_mm": 3.0}, 2 / np.pi * 3, 0.004),
        ({"kind": "cuboid", "size_mm": (6.0, 6.0), "turn_deg": (30, 0.0, 0.0)}, 0.36679 * 6, 0.02),
        ({"kind": "stl", "vertices_mm": SQUARE_BAR}, 0.36679 * 6, 0.02),
    ],
    ids=["disk", "square", "bar"],
)
def test_flat_punches_are_charged_plates(kind, capacitance_mm, error):
    """F = π E* C δ with C the plate's capacitance over 4πε₀: its pressure is the plate's charge.

    Square: Read, J. Comput. Phys. 133 (1997) 1. Cells miss some of what its corners bear.
    """
    force = half_space_forces_n(spec_of(NU, **kind), [0.2, 0.4])
    stiffness = np.pi * plane_strain_modulus_mpa(NU) * capacitance_mm
    assert_allclose(force, [0.2 * stiffness, 0.4 * stiffness], rtol=error)


def test_a_sharp_punch_converges_with_its_cells(monkeypatch):
    spec, exact = (
        spec_of(NU, kind="flat", radius_mm=3.0),
        2 * 3 * plane_strain_modulus_mpa(NU) * 0.2,
    )
    errors = []
    for cells in (40, 150, 600):
        monkeypatch.setattr("fem.contact.indenter.CELLS", cells)
        errors.append(half_space_forces_n(spec, [0.2])[0] / exact - 1)
    assert abs(errors[0]) > abs(errors[1]) > abs(errors[2])
    assert abs(errors[1]) < 0.006


def test_a_cone_from_its_corners():
    """Sneddon: F = 2 E* δ²/(π tan β) of a cone whose side rises by β."""
    angle = np.deg2rad(np.arange(0, 360, 6))
    ring = np.column_stack([6 * np.cos(angle), 6 * np.sin(angle), np.full(60, 3.0)])
    corners = tuple(map(tuple, np.vstack([[0, 0, 0], ring]).tolist()))
    force = half_space_forces_n(spec_of(NU, kind="stl", vertices_mm=corners), [1.0, 2.0])
    expected = 2 * plane_strain_modulus_mpa(NU) * np.array([1.0, 4.0]) / (np.pi * 0.5)
    assert_allclose(force, expected, rtol=0.03)


@pytest.fixture(scope="module")
def blocks():
    return [known_block_response(NU, size, size) for size in (20.0, 40.0)]


@pytest.mark.parametrize("shape", ["sphere", "punch"])
def test_blocks_differ_from_the_half_space_by_their_size_alone(blocks, shape):
    """Surface edges of 2 mm: the error halves with every doubling, and 2 e₂ − e₁ is within 1 %.

    Sphere of R 5 mm at δ/R = 0.02, a contact of 0.7 mm; flat punch of R 2 mm.
    """
    if shape == "sphere":
        spec, exact = spec_of(NU), hertz_force_n(0.1, 5.0, NU)
    else:
        spec = spec_of(NU, kind="flat", radius_mm=2.0)
        exact = 2 * 2 * plane_strain_modulus_mpa(NU) * 0.1
    errors = [
        press_face(spec, block, 0, PLACES, np.array([0.1])).force_n.mean() / exact - 1
        for block in blocks
    ]
    assert errors[0] > errors[1] > 0
    assert abs(2 * errors[1] - errors[0]) < 0.015


@pytest.fixture(scope="module")
def layer():
    return block_response(0.5, 40.0, 8.0, layers=5)


def test_the_layer_s_force_hardly_depends_on_the_mesh(layer):
    """Bonded layer of 8 mm, ν = 0.5, 80 mm wide, surface edges of 2 mm; contact radii from 1.1 mm."""
    depths = np.array([0.25, 0.5, 1.0, 2.0])
    force = press_face(spec_of(0.5), layer, 0, PLACES, depths).force_n
    assert_allclose(force.mean(axis=0)[2:], [1.69, 5.5], rtol=0.02)
    assert_allclose(force.mean(axis=0)[:3], dimitriadis_force_n(depths[:3], 5.0, 8.0), rtol=0.03)
    assert (force.std(axis=0) / force.mean(axis=0) < 0.02).all()


def test_oblique_presses_without_friction_mirror_each_other():
    """A path to +x is on a block what one to −x is at the mirrored place of the mirrored block."""
    block = block_response(NU, 20.0, 8.0, layers=4)
    (top,) = block.surfaces
    mirrored = replace(block, surfaces=(replace(top, xy_mm=top.xy_mm * [-1, 1]),))
    depths, here = np.array([0.5, 1.5]), np.array([[13.3, 1.1]])
    right, left = (spec_of(NU, direction_deg=(angle, 0.0)) for angle in (25.0, -25.0))
    force = press_face(right, block, 0, here, depths).force_n
    image = press_face(left, mirrored, 0, here * [-1, 1], depths).force_n
    assert_allclose(force, image, rtol=0.004)  # squares of the grid are cut along either diagonal
    moved_on = here + path_mm(right.indenter, depths)[-1:]
    straight = press_face(spec_of(NU), block, 0, moved_on, depths).force_n
    assert_allclose(force[0, 1], straight[0, 1], rtol=1e-10)
    backwards = press_face(left, block, 0, here, depths).force_n
    assert abs(force[0, 1] / backwards[0, 1] - 1) > 0.01


def test_outlines_that_overlap():
    disk = IndenterSpec()
    assert tips_overlap(disk, np.array([7.0, 7.0]))
    assert not tips_overlap(disk, np.array([7.1, 7.1]))
    jaw = IndenterSpec(kind="cuboid", size_mm=(8.0, 2.0), turn_deg=(90, 0.0, 0.0))
    assert not tips_overlap(jaw, np.array([2.1, 0.0]))
    assert tips_overlap(jaw, np.array([0.0, 2.1]))
    probe = IndenterSpec(radius_mm=2.0, tip_count=2)
    assert tips_overlap(probe, np.array([15.0, 3.0]))
    assert not tips_overlap(probe, np.array([7.5, 0.0]))


def test_a_table_with_sticking_friction_is_refused(rigid_response):
    with pytest.raises(InputError, match="instobj press"):
        simulate_lattice(spec_of(NU, friction="sticking"), rigid_response)


@pytest.mark.parametrize(
    ("indenter", "words"),
    [
        ({"kind": "cuboid", "size_mm": (50.0, 9.0)}, "larger than the face"),
        ({"tip_count": 3}, "fewer places"),
        ({"radius_mm": 3.0}, "indenter's height, 3 mm"),
        ({"turn_deg": (0.0, 5.0, 0.0)}, "does nothing to a hemisphere"),
        ({"kind": "flat", "fillet_mm": 5.0}, "below half their width"),
        ({"kind": "stl"}, "vertices_mm"),
    ],
)
def test_indenters_that_do_not_fit_are_refused(indenter, words):
    grid = ContactGridSpec(count=(10, 10))
    with pytest.raises(ValueError, match=words):
        check(ObjectSpec(name="cube", indenter=IndenterSpec(**indenter), contact_grid=grid))


def write_spec(folder, body):
    body.export(folder / "tip.stl")
    spec = folder / "object.toml"
    spec.write_text('name = "x"\n[indenter]\nkind = "stl"\nvertices_mm = "tip.stl"\n')
    return spec


def test_an_stl_is_read_beside_its_specification(tmp_path):
    cone = trimesh.creation.cone(4, 8)
    cone.apply_transform(trimesh.transformations.rotation_matrix(np.pi, [1, 0, 0]))
    spec = load_spec(write_spec(tmp_path, cone))
    profile = tip_heights_mm(tip_shape(spec.indenter), np.array([[0, 0], [0, 2], [0, 4.1]]))
    assert_allclose(profile, [0, 4, np.inf], rtol=1e-2)


def test_bad_stls_are_refused(tmp_path):
    box = trimesh.creation.box((2, 2, 2))
    apart = box.copy()
    apart.apply_translation((5, 0, 0))
    opened = box.copy()
    opened.update_faces(np.arange(len(box.faces)) > 1)
    for body, words in ((trimesh.util.concatenate([box, apart]), "not convex"), (opened, "closed")):
        with pytest.raises(InputError, match=words):
            load_spec(write_spec(tmp_path, body))
    (tmp_path / "tip.stl").unlink()
    with pytest.raises(InputError, match=r"no indenter\.vertices_mm at"):
        load_spec(tmp_path / "object.toml")
