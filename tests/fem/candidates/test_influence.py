"""Influence of rigid magnets on each other: against both tied at once, symmetries, and frames."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frame
from design.layout.places.positions import shell_body_layout
from fem.candidates.influence import influence, strains_turned
from fem.candidates.rigid_body import STRAINS, candidate_rows
from fem.candidates.tied_magnets import DEGREE, tie_functionals
from fem.linear.response import displacements, face_pressure_loads
from tests.support.objects.magnet_free_cases import nodal

FACE = 3
APART_MM = 7.5


@pytest.fixture(scope="module")
def found(cube, lattices, disks):
    body, tied = disks
    return body, tied, influence(cube.spec, cube.space, body, tied, lattices)


@pytest.fixture(scope="module")
def both(cube, factor):
    """Of two magnets under face 3, as ties see them: flexibility (by magnet, by magnet), rigid motions, and
    the ties' means of fields."""
    magnets = cube.spec.magnets.changed(positions_mm=((-APART_MM / 2, 0), (APART_MM / 2, 0)))
    spec = cube.spec.changed(magnets=magnets)
    own = np.flatnonzero(shell_body_layout(spec).face == FACE)
    functionals, rigid = tie_functionals(spec, cube.space, DEGREE)
    each = functionals.shape[0] // len(shell_body_layout(spec).face)
    rows = slice(own[0] * each, (own[0] + 2) * each)
    ties, motions = functionals[rows], rigid[rows, 6 * own[0] : 6 * own[0] + 12]
    flexibility = ties @ displacements(cube.system, factor, ties.T.toarray())
    return spec, own, ties, motions, (flexibility + flexibility.T) / 2


def held(flexibility, rigid, means):
    """Motions of rigid magnets in a field that the silicone has without them."""
    stiff = np.linalg.inv(flexibility)
    return np.linalg.solve(rigid.T @ stiff @ rigid, rigid.T @ stiff @ means)


def test_strains_are_told_back_and_rigid_motions_are_none(cube, found):
    body = found[0]
    frame = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    centres = np.array([[4.0, -6.0, 17.5], [-9.0, 3.0, 16.5]])
    rows = candidate_rows(cube.space, centres, frame, body)
    for number, strain in enumerate(STRAINS):
        turned = frame @ strain @ frame.T
        strains = (rows @ nodal(cube.space, lambda x, turned=turned: x @ turned))[:, 6:]
        assert_allclose(strains, np.tile(np.eye(5)[number], (2, 1)), rtol=0, atol=1e-9)
    still = rows @ nodal(cube.space, lambda x: np.cross([0.1, 0.2, -0.4], x) + 1.3)
    assert_allclose(still[:, 6:], 0, atol=1e-9)


def test_a_magnet_does_not_give_way_to_the_strain_round_it(cube, found):
    """What it adds takes the strain away where it is: with the mean of ties from all faces nearly."""
    body, tied, _ = found
    one = tied[3 * (FACE - 1) + 1]
    assert one.face == FACE
    for number in range(len(STRAINS)):
        rows = candidate_rows(cube.space, one.centre_mm[None], one.axes, body)
        strains = (rows @ one.field[:, number])[0, 6:]
        assert_allclose(strains, -np.eye(5)[number], rtol=0, atol=0.35)


def told_by(cube, table, body, spec, places, field):
    """Motion of the first of two places as the other one resists the strain of a field."""
    layout = shell_body_layout(spec)
    axes, (here, there) = layout.frame[places[0]], layout.centre_mm[places]
    strain = (candidate_rows(cube.space, there[None], axes, body) @ field)[0, 6:]
    x, y, _ = (here - there) @ axes
    angle, distance = np.arctan2(y, x), (np.hypot(x, y) - table.first_mm) / table.step_mm
    depth = -face_frame(spec, FACE).from_object(here[None])[0, 2]
    at = np.interp(depth, table.depth_mm, np.arange(len(table.depth_mm)))
    low, near = int(at), int(distance)
    mixed = table.values[low, low] * (1 - at % 1) + table.values[low + 1, low + 1] * (at % 1)
    matrix = mixed[near] * (1 - distance % 1) + mixed[near + 1] * (distance % 1)
    motion = (matrix @ strains_turned(angle).T @ strain).reshape(2, 3, -1)
    turn = np.eye(3)
    turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return np.einsum("ij,tjp->tip", axes @ turn, motion)


def test_what_two_magnets_do_to_each_other_is_that_of_both_tied_at_once(cube, found, both, factor):
    """Under loads all over the face above them; as a share of what the other one changes. On this mesh ties
    differ from place to place, and the table is a mean over places."""
    body, _, table = found
    spec, own, ties, rigid, flexibility = both
    loads = face_pressure_loads(cube.space, cube.spec)[1][:, cube.response.face_loads(FACE - 1)]
    field = displacements(cube.system, factor, loads[:, ::9].toarray())
    means, half = ties @ field, len(rigid) // 2
    together = held(flexibility, rigid, means).reshape(2, 2, 3, -1)
    for i in (0, 1):
        block = slice(i * half, (i + 1) * half)
        alone = held(flexibility[block, block], rigid[block, 6 * i : 6 * i + 6], means[block])
        wanted = together[i] - alone.reshape(2, 3, -1)
        told = told_by(cube, table, body, spec, own[[i, 1 - i]], field)
        for part, least in ((0, 0.85), (1, 0.65)):
            alike = np.vdot(told[part], wanted[part]) / np.linalg.norm(told[part])
            assert alike > least * np.linalg.norm(wanted[part])
            assert 0.6 < np.linalg.norm(told[part]) / np.linalg.norm(wanted[part]) < 1.5


def test_a_mirror_through_both_magnets_leaves_half_of_the_figures_none(found):
    """Along it strains zz, xz and xx − yy make motions x, z and a turn about y alone."""
    values = found[2].values
    assert abs(values).max() > 0.1
    for motion in range(6):
        mirrored = motion in (0, 2, 4)
        for strain in range(5):
            if (strain in (0, 1, 3)) != mirrored:
                assert not values[..., motion, strain].any()
    assert not values[:, :, -1].any(), "nothing beyond the last"


def test_strains_of_a_turned_frame():
    for angle in (0.3, 2.0, -1.1):
        cosine, sine = np.cos(angle), np.sin(angle)
        turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        shares = strains_turned(angle)
        for number, strain in enumerate(STRAINS):
            told = np.einsum("s,sij->ij", shares[:, number], STRAINS)
            assert_allclose(told, turn @ strain @ turn.T, atol=1e-12)
