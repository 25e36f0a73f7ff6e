"""Candidate places under curved surfaces: their lattices, corners of round patches, and the solved field."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frame
from design.layout.places.contact_places import pressed_nodes
from design.layout.places.positions import shell_body_layout
from fem.candidates.cubic_convolution import extension
from fem.candidates.motions import candidate_lattices, known_places
from fem.candidates.presses import presses_at_forces
from fem.candidates.presses import simulate_candidates as simulate
from fem.candidates.quadrature import skin_quadrature
from fem.candidates.rigid_body import candidate_rows, tied_magnets
from fem.linear.factorization import Factorization
from fem.linear.response import (
    build_response,
    displacements,
    elastic_system,
    face_pressure_loads,
)
from fem.mesh.tetrahedra import magnet_free_mesh
from tests.support.mechanics.candidate_cases import motion_of, motions_at
from tests.support.objects.body_cases import body_spec

COARSE = {"edge_mm": 9.0, "surface_edge_mm": 4.0, "rim_edge_ratio": 1.0, "envelope_mm": 0.2}
FACE = 1


@pytest.fixture(scope="module")
def spec():
    """An upper end that is round, and a contact grid whose corners it has not."""
    return body_spec(
        "capsule",
        body={"size_mm": [36.0, 36.0, 44.0], "sensed_faces": [1, 3]},
        mesh=COARSE,
        contact_grid={"count": "fill", "pitch_mm": 4.0},
        score={"force_n": 1.0},
    )


@pytest.fixture(scope="module")
def solved(spec):
    mesh = magnet_free_mesh(spec)
    return mesh, elastic_system(mesh, spec), build_response(mesh, spec)


@pytest.fixture(scope="module")
def table(spec, solved, tmp_path_factory):
    folder = tmp_path_factory.mktemp("candidates")
    mesh, _, response = solved
    return simulate(spec, mesh, response, candidate_lattices(spec), folder, force_shares=(0.5, 1.0))


@pytest.fixture(scope="module")
def factor(solved):
    with Factorization(solved[1].matrix) as factor:
        yield factor


def test_candidates_lie_evenly_along_the_surface(spec):
    for lattice in candidate_lattices(spec):
        frame = face_frame(spec, lattice.face)
        for axis, nodes in ((0, lattice.x_mm), (1, lattice.y_mm)):
            places = np.zeros((len(nodes), 2))
            places[:, axis] = nodes
            plane = frame.to_plane(places)
            reach = frame.half_extents_mm[axis] - spec.shell.pocket_diameter_mm / 2
            assert_allclose(plane[[0, -1], axis], [-reach, reach], rtol=0, atol=1e-6)
            points = frame.to_object(np.column_stack([plane, 0 * nodes]))
            steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
            assert np.ptp(steps) < 0.02 * steps.mean()
            assert steps.max() <= 2.0


def test_only_corners_of_round_patches_are_unknown(spec):
    for lattice in candidate_lattices(spec):
        known = known_places(spec, lattice)
        assert not known[[0, 0, -1, -1], [0, -1, 0, -1]].any()
        assert known.mean() > 0.5
        assert np.diff(known.astype(int), axis=0).sum(axis=0).tolist() == [0] * known.shape[1]
    flat = body_spec("two_open")
    assert all(known_places(flat, lattice).all() for lattice in candidate_lattices(flat))


def test_values_go_on_beyond_what_is_known_as_parabolas_do():
    x, y = np.meshgrid(np.arange(8.0), np.arange(9.0), indexing="ij")
    known = np.hypot(x - 3.5, y - 4.0) < 4.2
    values = 1 + x - 2 * y + 0.3 * x * x - 0.2 * y * y + 0.1 * x * y
    found = (extension(known) @ values[known]).reshape(x.shape)
    assert not known.all()
    assert_allclose(found, values, rtol=0, atol=1e-9)


def test_candidates_move_as_the_solved_field_does(spec, solved, factor, table):
    """With rows of their own frames, normal to the surface over each; NaN where a face has no place."""
    _, system, response = solved
    row = table.faces.tolist().index(FACE)
    press = presses_at_forces(spec, response, row, (0.5, 1.0))
    loads = face_pressure_loads(system.space, spec)[1][:, response.face_loads(row)]
    fields = displacements(system, factor, loads @ press.pressure_mpa[:, 1].T)
    body = tied_magnets(spec, system, factor, table.candidates)[0]
    there = pressed_nodes(spec)[row]
    assert not there.all()
    assert (np.isfinite(table.force_n[row]).all(axis=1) == there).all()
    first = 0
    for lattice in table.candidates:
        frame, known = face_frame(spec, lattice.face), known_places(spec, lattice)
        here = np.repeat(known.ravel(), len(lattice.depth_mm))
        plane = frame.to_plane(lattice.xyd_mm[here, :2])
        points = frame.to_object(np.column_stack([plane, -lattice.xyd_mm[here, 2]]))
        direct = candidate_rows(system.space, points, frame.axes_at(plane), body).motions @ fields
        direct = np.moveaxis(direct.reshape(len(points), 6, -1), 2, 0)
        found = motion_of(table)[row, :, 1, first : first + len(lattice)]
        assert_allclose(found[there][:, here], direct, rtol=0, atol=2e-3 * abs(direct).max())
        assert not found[~there].any()
        middle = np.linalg.norm(plane, axis=1) < 6.0
        turned = candidate_rows(system.space, points[middle], frame.axes, body).motions @ fields
        turned = np.moveaxis(turned, 2, 0)
        away = abs(turned - direct[:, middle]).max()
        assert away > 0.01 * abs(direct[:, middle]).max(), "all in one plane"
        first += len(lattice)


def test_tall_magnets_stay_inside_the_silicone_at_every_place(spec, solved, factor):
    """4 mm high, under at most 1.5 mm of silicone: their skin counts as lower, and nothing leaves."""
    tall = spec.changed(
        magnets=spec.magnets.changed(height_mm=4.0), shell=spec.shell.changed(pocket_depth_mm=5.0)
    )
    system, lattices = solved[1], candidate_lattices(tall)
    body = tied_magnets(tall, system, factor, lattices)[0]
    outline = shell_body_layout(tall).bodies[0].outline
    whole = replace(body, points_mm=skin_quadrature(outline, 4.0, 2, 8)[0])
    assert whole.points_mm.shape == body.points_mm.shape
    for lattice in lattices:
        frame, known = face_frame(tall, lattice.face), known_places(tall, lattice)
        xyd = lattice.xyd_mm[np.repeat(known.ravel(), len(lattice.depth_mm))]
        plane = frame.to_plane(xyd[:, :2])
        centres, axes = frame.to_object(np.column_stack([plane, -xyd[:, 2]])), frame.axes_at(plane)
        skin = centres[:, None] + body.points_mm @ np.swapaxes(axes, 1, 2)
        over = -frame.from_object(skin)[..., 2]
        assert over.min() > 0.2
        assert len(candidate_rows(system.space, centres, axes, body).weights) == len(centres)
        with pytest.raises(InputError, match="outside the silicone"):
            candidate_rows(system.space, centres, axes, whole)


def test_interpolation_is_as_good_as_on_flat_faces(spec, solved, factor, table):
    """Pockets anywhere under the pressed patch, on lattices of 2 mm and a coarse mesh."""
    _, system, response = solved
    row = table.faces.tolist().index(FACE)
    press = presses_at_forces(spec, response, row, (0.5, 1.0))
    loads = face_pressure_loads(system.space, spec)[1][:, response.face_loads(row)]
    fields = displacements(system, factor, loads @ press.pressure_mpa[:, 1].T)
    body = tied_magnets(spec, system, factor, table.candidates)[0]
    frame, lattice = face_frame(spec, FACE), table.candidates[row]
    ends = lattice.xyd_mm.min(axis=0), lattice.xyd_mm.max(axis=0)
    xyd = np.random.default_rng(1).uniform(*ends, (60, 3))
    beside = abs(frame.to_plane(xyd[:, :2])) + spec.shell.pocket_diameter_mm / 2
    xyd = xyd[frame.covers(beside)]
    assert len(xyd) > 20
    plane = frame.to_plane(xyd[:, :2])
    points = frame.to_object(np.column_stack([plane, -xyd[:, 2]]))
    direct = candidate_rows(system.space, points, frame.axes_at(plane), body).motions @ fields
    direct = np.moveaxis(direct.reshape(len(points), 6, -1), 2, 0)
    stored_motion = motions_at(table, FACE, xyd[:, :2], xyd[:, 2])[row, pressed_nodes(spec)[row], 1]
    for part, most in ((slice(0, 3), 0.03), (slice(3, 6), 0.08)):
        miss = np.mean((stored_motion - direct)[..., part] ** 2) / np.mean(direct[..., part] ** 2)
        assert np.sqrt(miss) < most


def test_a_face_too_curved_for_the_magnets_is_refused():
    spec = body_spec("sphere", body={"size_mm": [30.0] * 3}, shell={"thickness_mm": 7.0})
    wide = spec.magnets.changed(diameter_mm=14.0)
    narrow = spec.changed(magnets=wide, shell=spec.shell.changed(pocket_diameter_mm=14.5))
    with pytest.raises(InputError, match=r"stands .* mm out of it"):
        candidate_lattices(narrow)
