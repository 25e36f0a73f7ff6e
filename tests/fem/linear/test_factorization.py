"""The Schur complement equals dense algebra; broken systems are refused."""

import sys

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose

from fem.linear import dissection, factorization, multifrontal
from fem.linear.elements import assemble, free_motion_basis, saddle_point_matrix, taylor_hood
from fem.linear.factorization import (
    Factorization,
    LoadedFactor,
    SingularSystemError,
    compliance_of_loads,
    solve_symmetric,
)
from fem.linear.material import lame_constants
from fem.linear.response import require_inertia
from fem.linear.sparse import shape_of, upper_triangle
from tests.support.mechanics import kept_factors
from tests.support.mechanics.fem_cases import box_mesh


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


def forces(matrix, pressures):
    """Loads on displacements, none on pressures."""
    loads = sparse_loads(shape_of(matrix)[0] - pressures)
    return sp.csr_matrix(sp.vstack([loads, sp.csr_matrix((pressures, shape_of(loads)[1]))]))


@pytest.fixture(params=["pardiso", "multifrontal"])
def solver(request, monkeypatch):
    if request.param == "multifrontal":
        monkeypatch.setattr(factorization, "pardiso_available", lambda: False)
        monkeypatch.setattr(dissection, "LEAF_UNKNOWNS", 60)
        monkeypatch.setattr(dissection, "LARGE_GRAPH", 300)
    elif not factorization.pardiso_available():
        pytest.skip("MKL's PARDISO is not on this machine")
    return request.param


def test_compliance_of_loads_equals_dense_algebra(solver):
    matrix, _ = small_system(bonded=True)
    loads = sparse_loads(shape_of(matrix)[0])
    exact = loads.T @ np.linalg.solve(matrix.toarray(), loads.toarray())
    compliance = compliance_of_loads(matrix, loads).matrix
    scale = abs(exact).max()
    assert_allclose(compliance, exact, rtol=0, atol=1e-11 * scale)
    assert_allclose(compliance, compliance.T, rtol=0, atol=1e-12 * scale)


def test_solutions_equal_dense_algebra(solver):
    matrix, _ = small_system(bonded=True)
    right = np.random.default_rng(8).standard_normal((shape_of(matrix)[0], 3))
    exact = np.linalg.solve(matrix.toarray(), right)
    solution = solve_symmetric(matrix, right)
    assert_allclose(solution, exact, rtol=0, atol=1e-10 * abs(exact).max())


def test_one_factorization_answers_many_right_sides(solver):
    matrix, pressures = small_system(bonded=True)
    right = np.random.default_rng(3).standard_normal((shape_of(matrix)[0], 5))
    exact = np.linalg.solve(matrix.toarray(), right)
    with Factorization(matrix) as factor:
        for columns in (slice(0, 2), slice(2, 5), slice(1, 4)):
            solved = factor.solve(right[:, columns])
            assert_allclose(solved, exact[:, columns], rtol=0, atol=1e-10 * abs(exact).max())
        assert factor.negative_pivots == pressures
    with pytest.raises(ValueError, match="released"):
        factor.solve(right)
    factor.release()  # once more does no harm


def test_matrices_of_one_pattern_are_ordered_once_and_solved_alike(monkeypatch):
    """As the systems of two materials are; another pattern is ordered anew, the oldest forgotten."""
    if not factorization.pardiso_available():
        pytest.skip("MKL's PARDISO is not on this machine")
    asked, call = [], factorization.Pardiso.call

    def noted(self, phase, right_sides, solution):
        asked.extend([int(self.parameters[4])] if phase == factorization.ANALYSE_PHASE else [])
        call(self, phase, right_sides, solution)

    monkeypatch.setattr(factorization.Pardiso, "call", noted)
    monkeypatch.setattr(factorization, "KEPT_ORDERS", {})
    monkeypatch.setattr(factorization, "MOST_ORDERS", 2)
    matrix, pressures = small_system(bonded=True)
    scale = np.r_[np.full(shape_of(matrix)[0] - pressures, 2.0), np.full(pressures, 0.7)]
    other = sp.csr_matrix(sp.diags_array(scale) @ matrix @ sp.diags_array(scale))
    smaller = matrix[3:, 3:]
    for given in (matrix, other, smaller, smaller, matrix, matrix[1:, 1:], smaller):
        right = np.random.default_rng(4).standard_normal((shape_of(given)[0], 2))
        exact = np.linalg.solve(given.toarray(), right)
        found = solve_symmetric(given, right)
        assert_allclose(found, exact, rtol=0, atol=1e-9 * abs(exact).max())
    assert asked == [2, 1, 2, 1, 1, 2, 2]


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


def test_a_kept_factor_answers_mixtures_of_the_loads(solver):
    matrix, pressures = small_system(bonded=True)
    loads = forces(matrix, pressures)
    weights = np.random.default_rng(2).standard_normal((shape_of(loads)[1], 3))
    exact = np.linalg.solve(matrix.toarray(), loads @ weights)
    wanted = compliance_of_loads(matrix, loads)
    with LoadedFactor(matrix, loads) as factor:
        scale = abs(wanted.matrix).max()
        assert_allclose(factor.compliance.matrix, wanted.matrix, rtol=0, atol=1e-12 * scale)
        assert factor.compliance.negative_pivots == wanted.negative_pivots == pressures
        for columns in (slice(0, 2), slice(2, 3)):
            solved = factor.solve(weights[:, columns])
            assert_allclose(solved, exact[:, columns], rtol=0, atol=1e-10 * abs(exact).max())
    with pytest.raises(ValueError, match="released"):
        factor.solve(weights)


def test_a_kept_factor_refuses_an_unsupported_body(solver):
    matrix, pressures = small_system(bonded=False)
    with pytest.raises(SingularSystemError):
        LoadedFactor(matrix, forces(matrix, pressures))


def test_a_kept_factor_of_loads_that_depend_on_each_other_is_refused_or_right(solver):
    """PARDISO would count their zero eigenvalues as it likes; the other solver has no need to."""
    matrix, pressures = small_system(bonded=True)
    loads = forces(matrix, pressures)
    twice = sp.csr_matrix(sp.hstack([loads, loads[:, :2]]))
    if solver == "pardiso":
        with pytest.raises(SingularSystemError):
            LoadedFactor(matrix, twice)
        return
    with LoadedFactor(matrix, twice) as factor:
        assert factor.compliance.negative_pivots == pressures
        weights = np.ones((shape_of(twice)[1], 1))
        exact = np.linalg.solve(matrix.toarray(), twice @ weights)
        assert_allclose(factor.solve(weights), exact, rtol=0, atol=1e-10 * abs(exact).max())


def test_negative_pivots_are_the_pressures(solver):
    matrix, pressures = small_system(bonded=True)
    negative = compliance_of_loads(matrix, sparse_loads(shape_of(matrix)[0])).negative_pivots
    assert negative == pressures == np.sum(np.linalg.eigvalsh(matrix.toarray()) < 0)


def test_an_unsupported_body_is_refused(solver):
    matrix, _ = small_system(bonded=False)
    loads = sparse_loads(shape_of(matrix)[0])
    with pytest.raises(SingularSystemError):
        compliance_of_loads(matrix, loads)
    with pytest.raises(SingularSystemError):
        solve_symmetric(matrix, loads.toarray())


def test_a_wrong_inertia_is_refused():
    require_inertia(80, 80)
    with pytest.raises(SingularSystemError, match="79 negative pivots instead of 80"):
        require_inertia(79, 80)


def test_every_unknown_is_eliminated_once_behind_its_subtree(monkeypatch):
    """Neighbours are in one line of the tree: no entry would be lost between two of its branches."""
    monkeypatch.setattr(dissection, "LEAF_UNKNOWNS", 60)
    matrix, _ = small_system(bonded=True)
    size = shape_of(matrix)[0]
    late, kept = matrix.diagonal() <= 0, np.arange(size) % 50 == 7
    plan = dissection.dissect(matrix, late & ~kept, kept)
    assert sorted(plan.order) == np.flatnonzero(~kept).tolist()
    assert len(plan.parent) > 8
    node = np.full(size, -1)
    node[plan.order] = np.repeat(np.arange(len(plan.parent)), np.diff(plan.start))
    rows, columns = matrix.nonzero()
    for one, other in {*zip(node[rows], node[columns], strict=True)}:
        low, high = sorted((int(one), int(other)))
        while 0 <= low < high:
            low = int(plan.parent[low])
        assert low in (-1, high)


def test_separators_are_as_narrow_as_a_bar(monkeypatch):
    """Of a long bar of 6 × 5 × 5 nodes a layer: a layer, though the unknowns are in random order."""
    monkeypatch.setattr(dissection, "LEAF_UNKNOWNS", 100)
    matrix = bar(40, 30, np.random.default_rng(4))
    none = np.zeros(shape_of(matrix)[0], bool)
    plan = dissection.dissect(matrix, none, none)
    assert np.diff(plan.start)[-1] == 30


def test_a_matrix_of_thousands_of_pieces_is_halved_piece_by_piece():
    size = 20_000
    matrix = sp.csr_matrix(sp.diags([np.arange(1.0, size + 1)], [0]))
    none = np.zeros(size, bool)
    plan = dissection.dissect(matrix, none, none)
    assert np.diff(plan.start).max() <= dissection.LEAF_UNKNOWNS
    assert len(plan.parent) < 4 * size / dissection.LEAF_UNKNOWNS
    solved = multifrontal.eliminate(matrix).solve(np.ones((size, 1)))[:, 0]
    assert_allclose(solved, 1 / np.arange(1.0, size + 1))


def bar(layers, across, rng):
    """Laplacian of layers that are coupled to the next, plus the identity; unknowns exchanged."""
    near = sp.diags([1.0, 2.5, 1.0], [-1, 0, 1], shape=(layers, layers))
    matrix = sp.kron(near, sp.csr_matrix(np.ones((across, across)))) + 400 * sp.identity(
        layers * across
    )
    order = rng.permutation(layers * across)
    return sp.csr_matrix(sp.csr_matrix(matrix)[order][:, order])


def test_a_matrix_of_other_signs_is_solved_but_not_condensed(monkeypatch):
    monkeypatch.setattr(factorization, "pardiso_available", lambda: False)
    matrix = sp.csr_matrix(np.array([[1.0, 2.0], [2.0, 1.0]]))
    assert_allclose(solve_symmetric(matrix, np.array([[3.0], [3.0]])), 1)
    with pytest.raises(SingularSystemError, match="positive on displacements"):
        compliance_of_loads(matrix, sp.csr_matrix(np.ones((2, 1))))


def test_a_machine_without_pypardiso_has_no_pardiso(monkeypatch):
    monkeypatch.delenv("INSTOBJ_MKL", raising=False)
    monkeypatch.setitem(sys.modules, "pypardiso", None)
    assert not factorization.pardiso_available()
    monkeypatch.setattr("platform.machine", lambda: "x86_64")
    assert "pip install 'instobj[fast]'" in factorization.quicker_by()
    monkeypatch.setattr("platform.machine", lambda: "arm64")
    assert not factorization.quicker_by(), "there is no MKL for it"


def test_a_switch_leaves_mkl_alone(monkeypatch):
    monkeypatch.setattr(factorization, "mkl_library", lambda: object())
    monkeypatch.delenv("INSTOBJ_MKL", raising=False)
    assert factorization.pardiso_available()
    monkeypatch.setenv("INSTOBJ_MKL", "0")
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


@pytest.mark.parametrize("most_runs", [150, 1], ids=["by blocks", "one by one"])
@pytest.mark.parametrize("at", [[0], [3, 4, 7], [1, 2, 3, 6, 8, 9], []], ids=str)
def test_a_front_is_added_at_its_rows(monkeypatch, at, most_runs):
    """Its lower triangle, wherever the first run of neighbours begins."""
    monkeypatch.setattr(multifrontal, "MOST_RUNS", most_runs)
    rng = np.random.default_rng(2)
    front, part = rng.normal(size=(10, 10)), rng.normal(size=(len(at), len(at)))
    wanted = front.copy()
    for row, to_row in enumerate(at):
        for column, to_column in enumerate(at[: row + 1]):
            wanted[to_row, to_column] += part[row, column]
    multifrontal.add_front(front, np.array(at, int), part)
    assert_allclose(np.tril(front), np.tril(wanted))


@pytest.mark.parametrize("layer", [3, 20, 36])
def test_a_pressure_that_couples_far_unknowns_waits_for_all_of_them(monkeypatch, layer):
    """Beside the first layer of a long bar and another one, in branches of the tree far apart."""
    monkeypatch.setattr(dissection, "LEAF_UNKNOWNS", 20)
    bonds = np.zeros(160)
    bonds[[0, 2, 4 * layer, 4 * layer + 1]] = [3.0, -2.0, 5.0, 4.0]
    near = sp.diags([1.0, 2.5, 1.0], [-1, 0, 1], shape=(40, 40))
    stiff = sp.kron(near, sp.csr_matrix(np.ones((4, 4)))) + 40 * sp.identity(160)
    matrix = sp.csr_matrix(sp.bmat([[stiff, bonds[:, None]], [bonds[None], [[-0.5]]]]))
    right = np.random.default_rng(1).normal(size=(161, 2))
    solved = multifrontal.eliminate(matrix).solve(right)
    assert_allclose(solved, np.linalg.solve(matrix.toarray(), right), rtol=1e-8, atol=1e-10)


def test_single_precision_solves_to_its_own_rounding():
    """Where there is no PARDISO, in double precision."""
    random = np.random.default_rng(58)
    matrix = sp.csr_matrix(np.diag([4.0, 3.0, 5.0, -6.0]) + 0.5)
    right = random.normal(size=(4, 3))
    with Factorization(matrix, single=True) as factor:
        assert_allclose(matrix @ factor.solve(right), right, atol=1e-5)


def test_a_kept_factor_is_there_while_it_solves_though_too_large_to_be_kept(monkeypatch):
    """Of `tests.support`: the last holder lets PARDISO's memory go."""

    class Solver:
        released = False

        def solve(self, right_sides):
            assert not self.released
            return right_sides / 2

        def release(self):
            self.released = True

    made = Solver()
    monkeypatch.setattr(kept_factors, "plain_solver_of", lambda matrix, single: made)
    monkeypatch.setattr(kept_factors, "LEAST_UNKNOWNS", 1)
    monkeypatch.setattr(kept_factors, "MOST_UNKNOWNS", 2)
    found = kept_factors.solve_with_kept_factor(2 * sp.eye_array(3, format="csr"), np.ones((3, 1)))
    assert_allclose(found, 0.5)
    assert made.released
