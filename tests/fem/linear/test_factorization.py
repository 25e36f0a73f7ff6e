"""The Schur complement equals dense algebra; broken systems are refused."""

import sys

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose

from fem.linear import factorization
from fem.linear.elements import assemble, free_motion_basis, saddle_point_matrix, taylor_hood
from fem.linear.factorization import (
    Factorization,
    SingularSystemError,
    compliance_of_loads,
    solve_symmetric,
)
from fem.linear.material import lame_constants
from fem.linear.response import _require_inertia
from fem.linear.sparse import shape_of, upper_triangle
from tests.support.fem_cases import box_mesh

pardiso_only = pytest.mark.skipif(
    not factorization.pardiso_available(), reason="MKL's PARDISO is not on this machine"
)


def small_system(bonded):
    """Saddle-point matrix of a jiggled block, and its number of pressures."""
    space = taylor_hood(box_mesh((3, 3, 2), (1.0, 1.3, 0.6), jiggle=0.15))
    operators = assemble(space, lame_constants(0.3, 0.4999))
    free = space.nodes_mm[:, 2] > 1e-9 if bonded else np.ones(space.node_count, bool)
    matrix = saddle_point_matrix(operators, free_motion_basis(free), space.pressure_nodes)
    return matrix, len(space.pressure_nodes)


def sparse_loads(size):
    loads = sp.random(size, 17, density=0.02, rng=np.random.default_rng(5))
    return sp.csr_matrix(loads)


@pytest.fixture(params=["pardiso", "superlu"])
def solver(request, monkeypatch):
    if request.param == "superlu":
        monkeypatch.setattr(factorization, "pardiso_available", lambda: False)
        monkeypatch.setattr(factorization, "_CHUNK", 5)
    elif not factorization.pardiso_available():
        pytest.skip("MKL's PARDISO is not on this machine")
    return request.param


@pytest.mark.filterwarnings("ignore:MKL:UserWarning")
def test_compliance_of_loads_equals_dense_algebra(solver):
    matrix, _ = small_system(bonded=True)
    loads = sparse_loads(shape_of(matrix)[0])
    exact = loads.T @ np.linalg.solve(matrix.toarray(), loads.toarray())
    compliance = compliance_of_loads(matrix, loads).matrix
    scale = abs(exact).max()
    assert_allclose(compliance, exact, rtol=0, atol=1e-11 * scale)
    assert_allclose(compliance, compliance.T, rtol=0, atol=1e-12 * scale)


@pytest.mark.filterwarnings("ignore:MKL:UserWarning")
def test_solutions_equal_dense_algebra(solver):
    matrix, _ = small_system(bonded=True)
    right = np.random.default_rng(8).standard_normal((shape_of(matrix)[0], 3))
    exact = np.linalg.solve(matrix.toarray(), right)
    solution = solve_symmetric(matrix, right)
    assert_allclose(solution, exact, rtol=0, atol=1e-10 * abs(exact).max())


@pytest.mark.filterwarnings("ignore:MKL:UserWarning")
def test_one_factorization_answers_many_right_sides(solver):
    matrix, pressures = small_system(bonded=True)
    right = np.random.default_rng(3).standard_normal((shape_of(matrix)[0], 5))
    exact = np.linalg.solve(matrix.toarray(), right)
    with Factorization(matrix) as factor:
        for columns in (slice(0, 2), slice(2, 5), slice(1, 4)):
            solved = factor.solve(right[:, columns])
            assert_allclose(solved, exact[:, columns], rtol=0, atol=1e-10 * abs(exact).max())
        assert factor.negative_pivots == (pressures if solver == "pardiso" else -1)
    with pytest.raises(ValueError, match="released"):
        factor.solve(right)
    factor.release()  # once more does no harm


@pytest.mark.filterwarnings("ignore:MKL:UserWarning")
def test_adjoint_and_direct_solves_agree_to_rounding(solver):
    """lᵀ (A⁻¹ f) = (A⁻¹ l)ᵀ f, and the Schur complement gives the same."""
    matrix, _ = small_system(bonded=True)
    loads = sparse_loads(shape_of(matrix)[0])
    with Factorization(matrix) as factor:
        solved = factor.solve(loads.toarray())
    forward = loads.T @ solved
    scale = abs(forward).max()
    assert_allclose(forward, forward.T, rtol=0, atol=1e-12 * scale)
    condensed = compliance_of_loads(matrix, loads).matrix
    assert_allclose(condensed, forward, rtol=0, atol=1e-12 * scale)


@pardiso_only
def test_negative_pivots_are_the_pressures():
    matrix, pressures = small_system(bonded=True)
    negative = compliance_of_loads(matrix, sparse_loads(shape_of(matrix)[0])).negative_pivots
    assert negative == pressures == np.sum(np.linalg.eigvalsh(matrix.toarray()) < 0)


@pytest.mark.filterwarnings("ignore:MKL:UserWarning")
def test_an_unsupported_body_is_refused(solver):
    matrix, _ = small_system(bonded=False)
    loads = sparse_loads(shape_of(matrix)[0])
    with pytest.raises(SingularSystemError):
        compliance_of_loads(matrix, loads)
    with pytest.raises(SingularSystemError):
        solve_symmetric(matrix, loads.toarray())


def test_a_wrong_inertia_is_refused():
    _require_inertia(80, 80)
    _require_inertia(-1, 80)  # SuperLU does not count them
    with pytest.raises(SingularSystemError, match="79 negative pivots instead of 80"):
        _require_inertia(79, 80)


@pytest.mark.parametrize("call", [compliance_of_loads, solve_symmetric])
def test_the_slow_solver_says_that_it_is_used(monkeypatch, call):
    monkeypatch.setattr(factorization, "pardiso_available", lambda: False)
    matrix, _ = small_system(bonded=True)
    loads = sparse_loads(shape_of(matrix)[0])
    with pytest.warns(UserWarning, match="SuperLU"):
        call(matrix, loads if call is compliance_of_loads else loads.toarray())


def test_a_machine_without_pypardiso_has_no_pardiso(monkeypatch):
    monkeypatch.setitem(sys.modules, "pypardiso", None)
    assert not factorization.pardiso_available()


def test_the_upper_triangle_stores_every_diagonal_entry_in_sorted_rows():
    dense = np.array([[0.0, 2, 0, -3], [2, 5, 0, 0], [0, 0, 0, 0], [-3, 0, 0, 7]])
    rows, columns = np.nonzero(dense)
    order = np.random.default_rng(3).permutation(len(rows))
    entries = (dense[rows, columns][order] / 2, (rows[order], columns[order]))
    halves = sp.coo_matrix((np.tile(entries[0], 2), np.tile(entries[1], 2)), shape=(4, 4))
    upper = upper_triangle(sp.csr_matrix(halves))
    assert_allclose(upper.toarray(), np.triu(dense), rtol=0, atol=0)
    assert upper.indices.tolist() == [0, 1, 3, 1, 2, 3]
    assert upper.indptr.tolist() == [0, 3, 4, 5, 6]
