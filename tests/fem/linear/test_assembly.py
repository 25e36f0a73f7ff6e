"""Assembly by reference tensors, against scikit-fem's forms on the same mesh."""

from itertools import product

import numpy as np
import pytest
from numpy.testing import assert_allclose
from skfem import Basis, BilinearForm, ElementTetP0

from fem.linear.assembly import node_pattern
from fem.linear.elements import TaylorHood, assemble, element_space
from fem.linear.material import LameConstants, lame_constants
from fem.linear.sparse import block_matrix, columns_of
from tests.support.mechanics.fem_cases import box_mesh

MATERIAL = lame_constants(0.3, 0.47)


def slopes(a, b):
    return BilinearForm(lambda u, v, _: u.grad[a] * v.grad[b])


def minus_slope(a):
    return BilinearForm(lambda u, q, _: -u.grad[a] * q)


@pytest.fixture(scope="module", params=["taylor-hood", "p2-p0", "p2"])
def space(request):
    """Two thirds of a jiggled box, so that some nodes belong to no element."""
    mesh = box_mesh((4, 3, 5), (1.0, 1.4, 0.7), jiggle=0.2)
    return element_space(mesh, request.param, np.flatnonzero(np.arange(mesh.nelements) % 3))


def deviatoric_by_forms(space):
    """∫ 2μ ε:ε = μ ∫ (∇u:∇v + ∇uᵀ:∇v), block by block."""
    mu, basis = MATERIAL.shear_modulus_mpa, space.displacement
    form = {ab: mu * slopes(*ab).assemble(basis) for ab in product(range(3), repeat=2)}
    laplacian = form[0, 0] + form[1, 1] + form[2, 2]
    return block_matrix([[form[i, j] + (i == j) * laplacian for j in range(3)] for i in range(3)])


def test_operators_equal_those_of_scikit_fem(space):
    operators = assemble(space, MATERIAL)
    basis, kappa = space.displacement, MATERIAL.inverse_lambda_per_mpa
    exact = deviatoric_by_forms(space)
    if isinstance(space, TaylorHood):
        pressure = space.pressure
        mass = BilinearForm(lambda p, q, _: p * q).assemble(pressure)
        divergence = columns_of([minus_slope(a).assemble(basis, pressure) for a in range(3)])
        assert_allclose(operators.compressibility.toarray(), kappa * mass.toarray(), atol=1e-15)
        assert_allclose(operators.divergence.toarray(), divergence.toarray(), atol=1e-15)
    elif not space.mean_divergence:
        whole = block_matrix([[slopes(j, i).assemble(basis) for j in range(3)] for i in range(3)])
        exact = exact + whole / kappa
    else:
        assert operators.compressibility.shape == (0, 0)
        constant = Basis(space.mesh, ElementTetP0(), elements=basis.tind, intorder=2)
        rows = columns_of([minus_slope(a).assemble(basis, constant) for a in range(3)])
        rows = rows[np.unique(constant.element_dofs)].toarray()
        volumes = constant.dx.sum(axis=1)
        exact = exact + rows.T @ (rows / (kappa * volumes[:, None]))
    exact = np.asarray(exact.toarray() if hasattr(exact, "toarray") else exact)
    assert_allclose(operators.stiffness.toarray(), exact, atol=1e-13 * abs(exact).max())


def test_pairs_of_nodes_beyond_32_bits():
    """70 000² overflows the 32-bit indices of an element's nodes."""
    nodes = np.array([[69_999, 46_500, 3], [3, 68_000, 69_999]], np.int32)
    pattern = node_pattern(nodes, 70_000)
    rows = np.repeat(np.arange(70_000), np.diff(pattern.row_start))
    pairs = set(zip(rows.tolist(), pattern.columns.tolist(), strict=True))
    assert pairs == {pair for tet in nodes.tolist() for pair in product(tet, tet)}
    named = list(zip(rows[pattern.slot], pattern.columns[pattern.slot], strict=True))
    for tet, (row, column) in zip(nodes, named, strict=True):
        assert_allclose(row.reshape(3, 3), np.repeat(tet[:, None], 3, axis=1), rtol=0, atol=0)
        assert_allclose(column.reshape(3, 3), np.tile(tet, (3, 1)), rtol=0, atol=0)


def test_an_element_without_pressure_refuses_an_incompressible_material():
    with pytest.raises(ValueError, match=r"at most 0\.4999"):
        assemble(element_space(box_mesh((1, 1, 1)), "p2-p0"), LameConstants(0.1, 0.0))
