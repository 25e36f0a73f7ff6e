"""Factors of the last matrices, kept: several files solve with those of the coarse cube.

A factor is known by every number of its matrix: one with a fault is factored anew.
"""

import hashlib
import weakref

import numpy as np

from fem.linear import factorization

LEAST_UNKNOWNS, MOST_UNKNOWNS = 1_000, 200_000
"""Of a matrix whose factor is kept, and of all together."""

plain_solver_of = factorization.solver_of
_kept = {}


class KeptSolver:
    """Solves as the solver does, which is released when nobody holds it any more."""

    def __init__(self, solver, unknowns):
        self.solve, self.negative_pivots = solver.solve, getattr(solver, "negative_pivots", -1)
        self.unknowns = unknowns
        if hasattr(solver, "release"):
            weakref.finalize(self, solver.release)


def kept_solver(matrix, single=False):
    """In place of what `fem.linear.factorization` makes of a matrix for every `Factorization`."""
    if matrix.shape[0] < LEAST_UNKNOWNS:
        return plain_solver_of(matrix, single)
    key = _digest(matrix), single
    found = _kept.pop(key, None) or KeptSolver(plain_solver_of(matrix, single), matrix.shape[0])
    _kept[key] = found  # the latest last
    while sum(one.unknowns for one in _kept.values()) > MOST_UNKNOWNS:
        del _kept[next(iter(_kept))]
    return found


def solve_with_kept_factor(matrix, right_sides):
    """`solve_symmetric` where `kept_solver` is not in place."""
    solver = kept_solver(matrix)  # of a large matrix nobody else holds it
    return solver.solve(right_sides)


def _digest(matrix):
    digest = hashlib.blake2b()
    for array in (matrix.data, matrix.indices, matrix.indptr):
        digest.update(np.ascontiguousarray(array))
    return digest.digest()
