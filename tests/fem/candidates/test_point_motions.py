"""Displacements at points: exact for quadratic fields, and where points are looked up."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.pockets import Outline
from fem.candidates.point_motions import containing_tets, interpolate_at
from fem.candidates.quadrature import outline_quadrature, skin_quadrature
from fem.linear.elements import element_space
from tests.support.mechanics.fem_cases import box_mesh
from tests.support.objects.magnet_free_cases import magnet_free_cube, nodal, points_in_the_shell

DISK = Outline((3.0, 3.0), True)
PLATE = Outline((2.5, 1.5), False)


@pytest.fixture(scope="module")
def cube():
    return magnet_free_cube()


def quadratic(points):
    x, y, z = points.T
    return np.column_stack([x * y - z**2, 0.5 * z * x + y**2, x**2 - 2 * y * z])


def test_quadratic_fields_are_exact(cube):
    points = points_in_the_shell(cube.spec, 100)
    moved = interpolate_at(cube.space, points) @ nodal(cube.space, quadratic).reshape(3, -1).T
    assert_allclose(moved, quadratic(points), rtol=0, atol=1e-9)


def test_every_point_is_found_in_the_element_that_holds_it():
    mesh = box_mesh((4, 3, 3), (2.0, 1.5, 1.0), jiggle=0.2)
    corners = np.moveaxis(mesh.p[:, mesh.t], 0, -1)
    share = np.random.default_rng(0).dirichlet(np.ones(4), mesh.t.shape[1])
    points = np.einsum("te,etd->td", share, corners)
    assert (containing_tets(mesh, points) == np.arange(len(points))).all()


def test_points_on_vertices_and_borders_are_inside():
    mesh = box_mesh((3, 3, 3))
    found = containing_tets(mesh, mesh.p.T.copy())
    assert all(vertex in mesh.t[:, tet] for vertex, tet in enumerate(found))


def test_a_point_outside_is_refused_by_its_place(cube):
    with pytest.raises(InputError, match=r"the point \(0, 0, 5\) mm lies outside the silicone"):
        interpolate_at(cube.space, np.array([[0.0, 0.0, 20.0], [0.0, 0.0, 5.0]]))


def test_a_space_with_magnets_cut_out_is_refused():
    space = element_space(box_mesh((2, 2, 2)), "taylor-hood", np.arange(10))
    with pytest.raises(ValueError, match="whole mesh"):
        interpolate_at(space, np.array([[0.5, 0.5, 0.5]]))


@pytest.mark.parametrize("outline", [DISK, PLATE], ids=["disk", "plate"])
def test_means_over_an_outline_are_exact_for_cubics(outline):
    points, weights = outline_quadrature(outline, 2, 8)
    x, y = points.T
    a, b = outline.half_mm
    squares = (a**2 / 4, b**2 / 4) if outline.round else (a**2 / 3, b**2 / 3)
    assert_allclose(weights.sum(), 1, rtol=1e-14)
    assert_allclose([weights @ x**2, weights @ y**2], squares, rtol=1e-13)
    for odd in (x, y, x * y, x**3, x * y**2):
        assert_allclose(weights @ odd, 0, rtol=0, atol=1e-13)


@pytest.mark.parametrize("outline", [DISK, PLATE], ids=["disk", "plate"])
def test_means_over_a_skin_have_their_closed_form(outline):
    height = 1.2
    points, weights = skin_quadrature(outline, height)
    a, b = outline.half_mm
    rim = 2 * np.pi * a if outline.round else 4 * (a + b)
    area = 2 * outline.area_mm2 + rim * height
    z2 = (2 * outline.area_mm2 * height**2 / 4 + rim * height**3 / 12) / area
    if outline.round:
        x2 = (2 * np.pi * a**4 / 4 + np.pi * a**3 * height) / area
    else:
        flat = 2 * outline.area_mm2 * a**2 / 3
        x2 = (flat + height * (2 * 2 * b * a**2 + 2 * 2 * a**3 / 3)) / area
    assert_allclose(weights.sum(), 1, rtol=1e-14)
    assert_allclose(points.T @ weights, 0, rtol=0, atol=1e-13)
    assert_allclose(
        [weights @ points[:, 2] ** 2, weights @ points[:, 0] ** 2], [z2, x2], rtol=1e-12
    )
