"""Sparse LDLᵀ on dense fronts: a direct solver of saddle-point matrices on NumPy and SciPy alone.

Multifrontal elimination (Duff & Reid, ACM TOMS 9 (1983) 302) along a nested dissection: each node is
one dense symmetric front, whose unknowns are eliminated by LAPACK's Cholesky factorization and
level-3 BLAS; what is left is added to a front above. Matrices of elasticity are quasi-definite
(Vanderbei, SIAM J. Optim. 5 (1995) 100): positive definite on displacements, negative semidefinite on
pressures. A pressure is eliminated once the displacements next to it are, so signs take the place of
pivoting: Cholesky of the displacements, then of the pressures with their sign turned.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from scipy.linalg import get_blas_funcs, get_lapack_funcs, solve_triangular

from design.errors import SolverError
from fem.linear.dissection import dissect
from fem.linear.sparse import shape_of

(_POTRF,) = get_lapack_funcs(("potrf",), dtype="float64")
_TRSM, _SYRK = get_blas_funcs(("trsm", "syrk"), dtype="float64")
_LEAST_PIVOT = 1e-13
"""Least pivot over an unknown's own stiffness; rounding leaves some 1e-16 where a matrix is singular."""
MOST_RUNS = 150
"""Largest number of runs of neighbouring rows that are added block by block; more of them are added one by
one."""


class SingularSystemError(SolverError):
    """The matrix could not be factored reliably (an unsupported body, or broken mesh)."""


@dataclass(frozen=True)
class _Column:
    """Columns of L of one front's unknowns; `positive` of them come first."""

    pivots: slice
    later: Int[np.ndarray, "later"]
    positive: int
    triangle: Float[np.ndarray, "own own"]
    below: Float[np.ndarray, "later own"]


@dataclass(frozen=True)
class _Remainder:
    """Remainder that the elimination of a front leaves at later unknowns, in the lower triangle."""

    later: Int[np.ndarray, "later"]
    matrix: Float[np.ndarray, "later later"]


@dataclass(frozen=True)
class Elimination:
    """A symmetric quasi-definite matrix with all but the kept unknowns eliminated.

    `schur` is the Schur complement of the kept unknowns in their order; `negative_pivots` counts the
    negative eigenvalues of the eliminated block. `columns` are empty where nothing is to be solved.
    """

    order: Int[np.ndarray, "n"]
    columns: tuple[_Column, ...]
    schur: Float[np.ndarray, "kept kept"]
    negative_pivots: int

    def solve(self, right_sides: Float[np.ndarray, "n m"]) -> Float[np.ndarray, "n m"]:
        """x of A x = b for every column b; nothing may have been kept."""
        x = np.array(right_sides, float)[self.order]
        for column in self.columns:
            x[column.pivots] = _triangular(column.triangle, x[column.pivots])
            x[column.later] -= column.below @ x[column.pivots]
        return self._backward(x)

    def extend_kept(self, kept: Float[np.ndarray, "kept m"]) -> Float[np.ndarray, "n m"]:
        """All unknowns where the kept ones have these values and nothing else loads the others."""
        x = np.zeros((len(self.order), kept.shape[1]))
        x[len(x) - len(kept) :] = kept
        return self._backward(x)

    def _backward(self, x: Float[np.ndarray, "n m"]) -> Float[np.ndarray, "n m"]:
        """Backward substitution in place, then the unknowns in their own order."""
        for column in reversed(self.columns):
            values = x[column.pivots].copy()
            values[column.positive :] *= -1
            values -= column.below.T @ x[column.later]
            x[column.pivots] = _triangular(column.triangle, values, transposed=True)
        solution = np.empty_like(x)
        solution[self.order] = x
        return solution


def eliminate(
    matrix: sp.csr_matrix, kept: Bool[np.ndarray, "n"] | None = None, solves: bool = True
) -> Elimination:
    """Eliminate all unknowns but the `kept` ones; the factor is stored only where it `solves`.

    Raises
    ------
    SingularSystemError
        A is singular to working precision, or its signs are not those of a quasi-definite matrix.
    """
    size = shape_of(matrix)[0]
    kept = np.zeros(size, bool) if kept is None else kept
    negative = (matrix.diagonal() <= 0) & ~kept
    plan = dissect(matrix, negative, kept)
    order = np.concatenate([plan.order, np.flatnonzero(kept)])
    upper = sp.csr_matrix(sp.triu(matrix[order][:, order], format="csr"))
    local, columns = np.empty(size, np.int64), []
    waiting: dict[int, list[_Remainder]] = {}
    for node, parent in enumerate(plan.parent):
        pivots = slice(int(plan.start[node]), int(plan.start[node + 1]))
        column, remainder = _front(
            upper, pivots, int(negative[order[pivots]].sum()), waiting.pop(node, []), local
        )
        if solves:
            columns.append(column)
        if len(remainder.later):
            waiting.setdefault(int(parent), []).append(remainder)
    schur = _schur(upper, len(plan.order), waiting.pop(len(plan.parent), []))
    return Elimination(order, tuple(columns), schur, int(negative.sum()))


def _schur(
    upper: sp.csr_matrix, first: int, remainders: list[_Remainder]
) -> Float[np.ndarray, "kept kept"]:
    """The last front, both triangles."""
    schur = np.asfortranarray(upper[first:, first:].toarray().T)
    for remainder in remainders:
        add_front(schur, remainder.later - first, remainder.matrix)
    lower = np.tril(schur)
    return lower + np.tril(lower, -1).T


def _front(
    upper: sp.csr_matrix,
    pivots: slice,
    negatives: int,
    children: list[_Remainder],
    local: Int[np.ndarray, "n"],
) -> tuple[_Column, _Remainder]:
    """Assemble one front, eliminate its own unknowns; `local` is scratch."""
    pointer = upper.indptr[pivots.start : pivots.stop + 1]
    entries = slice(int(pointer[0]), int(pointer[-1]))
    near, values = upper.indices[entries], upper.data[entries]
    rows = np.unique(np.concatenate([near, *(child.later for child in children)]))
    later = rows[rows >= pivots.stop]
    count, more = pivots.stop - pivots.start, len(later)
    local[pivots], local[later] = np.arange(count), np.arange(more)
    inner = np.zeros((count, count), order="F")
    below = np.zeros((more, count), order="F")
    rest = np.zeros((more, more), order="F")
    row, inside = np.repeat(np.arange(count), np.diff(pointer)), near < pivots.stop
    inner[local[near[inside]], row[inside]] = values[inside]
    below[local[near[~inside]], row[~inside]] = values[~inside]
    stiffness = abs(np.diag(inner))
    for child in children:
        split = int(np.searchsorted(child.later, pivots.stop))
        to_pivots, to_later = local[child.later[:split]], local[child.later[split:]]
        inner[np.ix_(to_pivots, to_pivots)] += child.matrix[:split, :split]
        below[np.ix_(to_later, to_pivots)] += child.matrix[split:, :split]
        add_front(rest, to_later, child.matrix[split:, split:])
    return _eliminated(pivots, later, count - negatives, (inner, below, rest), stiffness)


def add_front(
    front: Float[np.ndarray, "row row"],
    rows: Int[np.ndarray, "part"],
    part: Float[np.ndarray, "part part"],
) -> None:
    """Add a lower triangle at rows in rising order: by blocks of neighbours, `np.ix_` is slow."""
    if not len(rows):
        return
    starts = np.flatnonzero(np.diff(rows, prepend=-2) != 1)
    if len(starts) > MOST_RUNS:
        front[np.ix_(rows, rows)] += part
        return
    runs = [
        (slice(a, b), slice(int(rows[a]), int(rows[a]) + b - a))
        for a, b in zip(starts.tolist(), [*starts[1:].tolist(), len(rows)], strict=True)
    ]
    for number, (column, to_column) in enumerate(runs):
        for row_part, to_row in runs[number:]:
            front[to_row, to_column] += part[row_part, column]


def _eliminated(
    pivots: slice,
    later: Int[np.ndarray, "later"],
    positive: int,
    blocks: tuple[np.ndarray, np.ndarray, np.ndarray],
    stiffness: Float[np.ndarray, "own"],
) -> tuple[_Column, _Remainder]:
    """Displacements, then pressures: columns of L, and the blocks' Schur complement."""
    inner, below, rest = blocks
    triangle = np.zeros_like(inner)
    plus, minus = slice(0, positive), slice(positive, len(inner))
    triangle[plus, plus] = root = _cholesky(inner[plus, plus], stiffness[plus])
    side = _divided(root, below[:, plus])
    rest = _updated(rest, side, -1.0)
    if positive < len(inner):
        triangle[minus, plus] = coupling = _divided(root, inner[minus, plus])
        pressure_schur = coupling @ coupling.T - inner[minus, minus]
        triangle[minus, minus] = turned = _cholesky(pressure_schur, np.diag(pressure_schur))
        pressure_side = _divided(turned, below[:, minus] - side @ coupling.T)
        rest = _updated(rest, pressure_side, 1.0)
        side = np.hstack([side, -pressure_side])
    return _Column(pivots, later, positive, triangle, side), _Remainder(later, rest)


def _cholesky(
    block: Float[np.ndarray, "row row"], stiffness: Float[np.ndarray, "row"]
) -> Float[np.ndarray, "row row"]:
    """L of a lower triangle."""
    if not len(block):
        return np.zeros((0, 0))
    root, failed = _POTRF(block, lower=1, clean=1)
    if failed or (np.diag(root) ** 2 < _LEAST_PIVOT * stiffness).any():
        raise SingularSystemError(
            "the matrix is singular, or not positive on displacements and negative on pressures"
        )
    return root


def _divided(
    root: Float[np.ndarray, "own own"], below: Float[np.ndarray, "later own"]
) -> Float[np.ndarray, "later own"]:
    """B L⁻ᵀ."""
    if not below.size:
        return below
    return _TRSM(1.0, root, np.asfortranarray(below), side=1, lower=1, trans_a=1)


def _updated(
    rest: Float[np.ndarray, "later later"], side: Float[np.ndarray, "later own"], sign: float
) -> Float[np.ndarray, "later later"]:
    """`rest` ± B Bᵀ in the lower triangle."""
    if not side.size:
        return rest
    return _SYRK(sign, np.asfortranarray(side), beta=1.0, c=rest, lower=1, overwrite_c=1)


def _triangular(
    triangle: Float[np.ndarray, "own own"],
    right_sides: Float[np.ndarray, "own m"],
    transposed: bool = False,
) -> Float[np.ndarray, "own m"]:
    return solve_triangular(
        triangle, right_sides, lower=True, trans=1 if transposed else 0, check_finite=False
    )
