"""Tables of presses that a batch of layouts can be scored on, and those that it cannot."""

from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import grid_places_in_lattice, press_lattice
from design.spec.object import BodySpec, ContactGridSpec, ObjectSpec
from estimator.layouts.batch_scores import position_bounds
from estimator.layouts.presses import basis, compression, mixed_rows
from estimator.layouts.scorer import layout_scorer
from fem.candidates.motions import FaceCandidates
from tests.support.mechanics.candidate_cases import (
    FACE,
    made_up_motions,
    made_up_spec,
    random_layouts,
)

CUBE = ObjectSpec(name="cube")


def lattice(face, reach=18.0, count=4):
    axis = np.linspace(-reach, reach, count)
    return FaceCandidates(face, axis, axis, np.array([2.0, 4.0]))


def check(*lattices, face=1, forces=2, spec=CUBE):
    motions = SimpleNamespace(
        faces=np.array([one.face for one in lattices]),
        force_n=np.ones((len(lattices), 16, forces)),
        places=press_lattice(spec),
        candidates=lattices,
    )
    basis.check_lattices.__wrapped__(CUBE, motions, face)


def test_faces_that_are_alike_share_a_layout_and_one_face_is_enough():
    check(lattice(1))
    check(lattice(1), lattice(3), lattice(5), face=5)
    with pytest.raises(InputError, match=r"face 2 was not pressed. Choose one of \[1, 3\]"):
        check(lattice(1), lattice(3), face=2)


@pytest.mark.parametrize("other", [lattice(3, reach=18.1), lattice(3, count=5)])
def test_faces_that_differ_are_refused_wherever_they_come(other):
    for lattices in ((lattice(1), other), (lattice(1), lattice(2), other), (other, lattice(5))):
        with pytest.raises(InputError, match="one layout cannot be repeated"):
            check(*lattices, face=int(lattices[0].face))
    with pytest.raises(InputError, match="candidates of face 3 are not those of face 1"):
        check(lattice(1), other)


def test_derivatives_need_two_forces():
    with pytest.raises(InputError, match="need two forces; got one"):
        check(lattice(1), forces=1)


@pytest.mark.parametrize("grid", [{"count": (9, 10)}, {"pitch_mm": 2.5}])
def test_presses_must_be_those_of_the_contact_grid(grid):
    other = CUBE.changed(contact_grid=CUBE.contact_grid.changed(**grid))
    with pytest.raises(InputError, match=r"not on the lattice of this .* \(29, 29\)"):
        check(lattice(1), spec=other)


def test_weights_between_nodes_are_those_of_keys():
    """Cubes come back exactly only to second order: parabolas do, and the weights sum to one."""
    t = torch.linspace(0, 1, 7, dtype=torch.float64)[:, None].expand(-1, 3)
    weights = mixed_rows.cubic_kernel(t)
    nodes = torch.tensor([-1.0, 0.0, 1.0, 2.0], dtype=torch.float64)
    assert_allclose(weights.sum(dim=-1), 1)
    assert_allclose(weights @ nodes, t, atol=1e-12)
    assert_allclose(weights @ nodes**2, t**2, atol=1e-12)
    assert_allclose(weights[3], [[-1 / 16, 9 / 16, 9 / 16, -1 / 16]] * 3)


def test_nodes_beyond_the_lattice_go_on_as_parabolas():
    x, y, z = np.meshgrid(np.arange(4.0), np.arange(3.0), np.arange(5.0), indexing="ij")

    def parabola(x, y, z):
        return np.stack([(1 + x + 2 * x**2) * (y**2 - y) * (3 - z**2), x * y * z], axis=-1)

    padded = compression.with_ghosts(parabola(x, y, z).reshape(-1, 2), (4, 3, 5))
    x, y, z = np.meshgrid(*(np.arange(-1.0, n + 1) for n in (4, 3, 5)), indexing="ij")
    assert_allclose(padded, parabola(x, y, z).reshape(-1, 2), atol=1e-9)


def test_compressed_rows_are_the_best_of_their_rank_with_rotations_weighed_by_four_millimetres():
    rng = np.random.default_rng(0)
    of_modes, sizes = rng.normal(size=(7, 3, 4)), np.array([1.0, 2.0, 5.0])
    modes = [rng.normal(size=(5, 6, 7)) for _ in range(2)]
    tables = [np.einsum("cvr,rqp->cvqp", one, of_modes) for one in modes]
    scale = np.repeat(sizes, 4)
    for rank in (7, 3):
        rows, vectors = compression.compressed(modes, of_modes, sizes, rank)
        weight = np.repeat([1.0, 4.0], 3)[:, None]
        every = np.concatenate([(t.reshape(5, 6, 12) * weight / scale) for t in tables]).reshape(
            -1, 12
        )
        _, _, right = np.linalg.svd(every, full_matrices=False)
        best = every @ right[:rank].T @ right[:rank]
        found = np.concatenate([one.reshape(5, 6, rank) @ vectors for one in rows])
        assert_allclose((found * weight / scale).reshape(-1, 12), best, atol=1e-9)
    assert_allclose(vectors / scale @ (vectors / scale).T, np.eye(3), atol=1e-9)


def test_columns_are_scaled_by_the_rms_of_their_quantity(spec, motions, presses):
    """Derivatives by x, y and F and the motion itself then count alike in what is left out."""
    frame = next(one for one in face_frames(spec) if one.number == FACE)
    of_modes = basis.press_derivatives(
        motions, FACE, spec.score.force_n, grid_places_in_lattice(spec)
    )
    modes = basis.modes_of(motions, FACE, FACE - 1, frame.axes)
    own = np.einsum("cvr,rqp->cvqp", modes, of_modes)
    assert own.shape[2] == 4
    scale = np.repeat(np.sqrt(np.mean(own**2, axis=(0, 1, 3))), own.shape[3])
    for table in (presses.own_table, presses.other_table):
        unit = table.basis.double().numpy() / scale
        assert_allclose(unit @ unit.T, np.eye(len(unit)), atol=1e-4)


@pytest.mark.parametrize("missing", [(), (0, 1, 5)])
def test_derivatives_of_motions_that_are_parabolas_times_the_force_are_exact(missing):
    """On a whole lattice and where a corner of it is missing; of the second face under presses of it."""
    x_mm, y_mm = np.array([-4.0, -1.0, 2.0, 5.0, 8.0]), np.array([-3.0, 0.0, 3.0, 6.0, 9.0])
    x, y = (grid.ravel() for grid in np.meshgrid(x_mm, y_mm, indexing="ij"))
    one, none = np.ones(25), np.zeros(25)
    rng = np.random.default_rng(5)
    modes = rng.normal(size=(5, 2, 3, 6))
    parabola = rng.normal(size=(2, 6, 3))  # pressed face, term, mode
    force_n = rng.uniform([1.0, 2.0], [1.5, 3.0], (2, 25, 2))
    terms = np.stack([one, x, y, x * y, x**2, y**2], axis=1)
    force_n[1, list(missing)] = np.nan
    motions = SimpleNamespace(
        faces=np.array([2, 5]),
        candidates=[
            FaceCandidates(face, np.arange(count), np.zeros(1), np.ones(1))
            for face, count in ((2, 3.0), (5, 2.0))
        ],
        places=SimpleNamespace(x_mm=x_mm, y_mm=y_mm, shape=(5, 5), xy_mm=np.stack([x, y], 1)),
        force_n=force_n,
        steps_around=lambda newton: np.array([0, 1]),
        by_candidate=modes.astype(np.float32),
        presses=np.einsum("pt,ftr,fps->fpsr", terms, parabola, force_n),
    )
    located = np.array([6, 8, 12, 16, 18])
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    of_modes = basis.press_derivatives.__wrapped__(motions, 5, 1.8, located)
    turned = basis.modes_of.__wrapped__(motions, 5, 1, axes)
    found = np.einsum("cvr,rqp->cvqp", turned, of_modes)

    def wanted(terms):
        per_n = np.einsum("pt,tr,crq->cpq", terms, parabola[1], modes[3:, 1])
        return (per_n.reshape(2, 25, 2, 3) @ axes).reshape(2, 25, 6).swapaxes(1, 2)[..., located]

    by_x = np.stack([none, one, none, y, 2 * x, none], axis=1)
    by_y = np.stack([none, none, one, x, none, 2 * y], axis=1)
    assert found.shape == (2, 6, 4, len(located))
    for number, of in enumerate((1.8 * by_x, 1.8 * by_y, terms, 1.8 * terms)):
        assert_allclose(found[:, :, number], wanted(of), atol=2e-5)


def test_ends_of_the_candidates_and_places_just_beyond_them(presses):
    least, most = mixed_rows.candidate_ends_mm(presses)
    assert_allclose(least, presses.first_mm)
    wanted = presses.first_mm + presses.step_mm * (torch.tensor(presses.nodes) - 1)
    assert_allclose(most, wanted)
    inside = torch.stack([least, most])
    last = torch.tensor(presses.nodes) - 1.0
    index, weight = mixed_rows.rows_around(presses, torch.stack([0 * last, last]), inside)
    ny, nz = (n + 2 for n in presses.nodes[1:])
    for row, node in ((0, torch.ones(3)), (1, last + 1)):
        at = int(node @ torch.tensor([float(ny * nz), float(nz), 1.0]))
        assert int(index[row, weight[row].argmax()]) == at
        assert_allclose(weight[row].max(), 1, atol=1e-6)
    for beyond in (-2e-4, 2e-4):
        for axis in range(3):
            place = torch.stack([0 * last if beyond < 0 else last])
            place[0, axis] += beyond
            with pytest.raises(InputError):
                mixed_rows.rows_around(presses, place, inside[:1])
            place[0, axis] -= 0.75 * beyond
            mixed_rows.rows_around(presses, place, inside[:1])


def test_bounds_of_places_far_apart_are_those_of_all_vectors():
    """63 of 147 independent vectors, 1.3 for each place, had bounds 0.92 to 1.18 times as large."""
    grid, body = ContactGridSpec(count=(7, 7), pitch_mm=8.0), BodySpec(size_mm=(60.0, 60.0, 60.0))
    spec = made_up_spec(ObjectSpec(name="cube", contact_grid=grid, body=body))
    motions, layouts = made_up_motions(spec, pitch_mm=4.0), random_layouts(3, seed=1)
    few, every = (
        position_bounds(
            [layout_scorer(spec, basis.press_basis(spec, motions, FACE, own_rank=rank))], [layouts]
        )[0].numpy()
        for rank in (None, 4 * 49)
    )
    near = every < 10  # mm; farther off presses move next to nothing
    assert near.sum() > 40
    assert_allclose(few[near], every[near], rtol=0.03)
