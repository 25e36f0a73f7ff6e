"""Compliance to tractions in three directions, put together from blocks that are made up."""

from types import SimpleNamespace

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose, assert_array_equal
from scipy.linalg import block_diag

from design.errors import InputError
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from fem.contact import traction
from fem.contact.half_space import Patches, traction_compliance

SPEC = ObjectSpec(name="cube")
FRAMES = {frame.number: frame for frame in face_frames(SPEC)}
RNG = np.random.default_rng(4)


def patches(count, seed):
    rng = np.random.default_rng(seed)
    return Patches(rng.uniform(0.5, 2, count), rng.uniform(-4, 4, (count, 2)), np.full(count, 0.1))


@pytest.mark.parametrize("number", [2, 3])
def test_tractions_go_inwards_and_along_the_axes_of_the_face(number):
    moments = sp.csc_matrix(RNG.random((4, 3)))
    frame, dense = FRAMES[number], moments.toarray()
    for direction, along in enumerate((-frame.normal, frame.x, frame.y)):
        found = traction.traction_loads(frame, direction, moments).toarray()
        assert_allclose(found, np.vstack([along[0] * dense, along[1] * dense, along[2] * dense]))


def test_loads_and_motions_of_magnets_are_condensed_together():
    """Twelve motions and two pressures; a magnet's six are the last motions."""
    root = RNG.normal(size=(14, 14))
    matrix, basis = root @ root.T + 14 * np.eye(14), RNG.normal(size=(15, 12))
    tractions = RNG.random((15, 3))
    system = SimpleNamespace(
        matrix=sp.csr_matrix(matrix), motion_basis=sp.csr_matrix(basis), space=None
    )
    mesh = SimpleNamespace(magnets=1)
    condensed = traction.condensed_compliance.__wrapped__(system, mesh, sp.csr_matrix(tractions))
    loads = np.vstack([np.hstack([basis.T @ tractions, np.eye(12)[:, -6:]]), np.zeros((2, 9))])
    assert_allclose(condensed, loads.T @ np.linalg.solve(matrix, loads), atol=1e-12)


def test_patches_of_one_face_move_each_other_on_a_half_space_those_of_others_not():
    first, second, third = patches(2, 0), patches(3, 1), patches(1, 2)
    found = traction.half_space_compliance(SPEC, [3, 5, 3], [first, second, third]).reshape(
        3, 6, 3, 6
    )
    silicone = SPEC.silicone
    modulus = silicone.surface_modulus_mpa, silicone.poisson_ratio
    on_5 = traction_compliance(second, second, *modulus)
    assert_allclose(found[:, 2:5][:, :, :, 2:5], on_5)
    assert_allclose(found[:, :2][:, :, :, 5:], traction_compliance(first, third, *modulus))
    assert not found[:, [0, 1, 5]][:, :, :, 2:5].any()
    assert not found[:, 2:5][:, :, :, [0, 1, 5]].any()


def test_hats_are_refined_to_cells_in_all_three_directions(monkeypatch):
    """Two groups on faces 5 and 3, of 2 and 3 cells on 3 and 2 hats; what finite elements keep is theirs
    less that of the hats on a half-space, spread over the cells, and the cells' own is added."""
    groups = [patches(2, 5), patches(3, 6)]
    hats = {5: patches(4, 7), 3: patches(4, 8)}
    rows, spread = {5: [0, 2, 3], 3: [1, 3]}, {5: RNG.random((3, 2)), 3: RNG.random((2, 3))}
    moments = {number: sp.csc_matrix(RNG.random((2, 4))) for number in hats}
    asked = []

    def spread_cells(face, patch, centre):
        assert_array_equal(centre, [0, 0])
        surface = SimpleNamespace(hats=hats[face], bases=())
        return SimpleNamespace(
            face=surface, rows=np.array(rows[face]), matrix=spread[face], patches=patch
        )

    def condensed(system, mesh, tractions):
        asked.append(tractions.toarray())
        return whole

    def half_space(spec, faces, some):
        assert list(faces) == [5, 3]
        return traction.half_space_compliance.__wrapped__(spec, faces, some)

    whole = RNG.normal(size=(3 * 5 + 12, 3 * 5 + 12))
    half = half_space(SPEC, [5, 3], groups)
    monkeypatch.setattr(traction, "elastic_system", lambda mesh, spec: None)
    monkeypatch.setattr(
        traction,
        "refined_surface",
        lambda system, spec, frame, magnets: (frame.number, moments[frame.number]),
    )
    monkeypatch.setattr(traction, "spread_cells", spread_cells)
    monkeypatch.setattr(traction, "condensed_compliance", condensed)
    response = traction.traction_response.__wrapped__(
        SPEC, SimpleNamespace(magnets=2), [5, 3], groups
    )
    (loads,) = asked
    for direction in range(3):
        columns = loads[:, 5 * direction : 5 * direction + 5]
        for number, part in ((5, columns[:, :3]), (3, columns[:, 3:])):
            frame, dense = FRAMES[number], moments[number].toarray()[:, rows[number]]
            along = (-frame.normal, frame.x, frame.y)[direction]
            assert_allclose(part, np.vstack([one * dense for one in along]))
    of_hats = [
        Patches(
            hats[n].area_mm2[rows[n]], hats[n].centre_mm[rows[n]], hats[n].variance_mm2[rows[n]]
        )
        for n in (5, 3)
    ]
    share = block_diag(*[block_diag(spread[5], spread[3])] * 3)
    wide = whole[:15, :15] - half_space(SPEC, [5, 3], of_hats)
    wanted = share.T @ wide @ share + half
    assert_allclose(response.compliance.reshape(15, 15), (wanted + wanted.T) / 2)
    assert_allclose(response.motion.reshape(12, 15), whole[15:, :15] @ share)


def test_a_curved_face_knows_no_friction():
    body = {"kind": "sphere", "size_mm": [44.0] * 3, "sensed_faces": [1]}
    (frame,) = face_frames(ObjectSpec.model_validate({"name": "ball", "body": body}))
    with pytest.raises(InputError, match="face 1 is curved, and friction"):
        traction.require_flat(frame)
    traction.require_flat(FRAMES[3])
