"""Compliance of places: a secant at the depth nearest to 1 mm, with magnets and without."""

import csv

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import StoreError
from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ContactGridSpec, PressSpec
from fem.presses.compliance_map import (
    compliance_map,
    presses_without_magnets,
    save_compliance_csv,
)
from fem.presses.results import PressForces, load_forces, load_presses, save_presses
from tests.support.objects.magnet_free_cases import magnet_free_cube

LATTICE = PlaceGrid(np.array([-2.0, 1.0, 4.0]), np.array([0.0, 5.0]))


@pytest.fixture
def forces():
    force = np.random.default_rng(4).uniform(1, 9, (2, 6, 3))
    return PressForces(np.array([1, 3]), LATTICE, np.array([0.4, 1.2, 2.0]), force, force)


def test_it_is_depth_over_force_at_the_depth_nearest_to_1_mm(forces):
    made = compliance_map(forces)
    assert made.depth_mm == 1.2
    assert_allclose(made.mm_per_n, 1.2 / forces.force_n[:, :, 1], rtol=1e-14)


def test_a_place_without_contact_is_infinitely_soft(forces):
    forces.force_n[1, 4, 1] = 0
    assert compliance_map(forces).mm_per_n[1, 4] == np.inf


def test_the_table_has_one_row_a_place_with_both_compliances(forces, tmp_path):
    tied = compliance_map(forces)
    free = compliance_map(
        PressForces(forces.faces, LATTICE, forces.depth_mm, forces.force_n / 2, forces.force_n)
    )
    save_compliance_csv(tied, free, tmp_path / "compliance.csv")
    with (tmp_path / "compliance.csv").open(newline="") as file:
        header, *rows = csv.reader(file)
    assert header[3:] == ["mm_per_n_1.2_mm_deep", "mm_per_n_without_magnets_1.2_mm_deep"]
    assert len(rows) == 12
    face, x, y, with_magnets, without = (float(cell) for cell in rows[6 + 3])
    assert (face, x, y) == (3, 1, 5)
    assert_allclose(with_magnets, 1.2 / forces.force_n[1, 3, 1], rtol=1e-5)
    assert_allclose(without, 2 * with_magnets, rtol=1e-5)


def test_forces_come_back_from_their_file(forces, tmp_path):
    save_presses(forces, None, tmp_path / "forces.nc")
    loaded = load_forces(tmp_path / "forces.nc")
    with pytest.raises(StoreError, match="presses without magnets"):
        load_presses(tmp_path / "forces.nc")
    for name in ("faces", "depth_mm", "force_n", "contact_area_mm2"):
        np.testing.assert_array_equal(getattr(loaded, name), getattr(forces, name))
    np.testing.assert_array_equal(loaded.lattice.xy_mm, LATTICE.xy_mm)


def test_presses_without_magnets_go_to_that_depth_only():
    """The walls' middle, where nothing but the bonded layer matters, is alike on all faces."""
    cube = magnet_free_cube()
    grid = ContactGridSpec(count=(2, 2), pitch_mm=8.0)
    press = PressSpec(depths_mm=(0.5, 1.1, 2.0))
    spec = cube.spec.model_copy(update={"contact_grid": grid, "press": press})
    forces = presses_without_magnets(spec, cube.response)
    assert_allclose(forces.depth_mm, [1.1])
    assert forces.force_n.shape == (5, 25, 1)
    centre = compliance_map(forces).mm_per_n[:, 12]
    assert_allclose(centre, centre.mean(), rtol=0.05)
    assert_allclose(centre.mean(), 1.1 / 1.95, rtol=0.1)  # 1.69 N at 1 mm of the layer, E 0.3 MPa
