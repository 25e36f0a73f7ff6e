"""Sparse direct solver, the one seam to it: symmetric indefinite solve and Schur complement.

PARDISO (MKL, x86) factors the saddle-point matrix. Bordered by all loads, it returns the dense
compliance Lᵀ A⁻¹ L as a Schur complement within the same factorization. On the paper's cube that
costs 2 s more than the factorization alone, where solving each load would cost 25 s. Where no MKL
is found, on ARM and Apple's computers, `fem.linear.multifrontal` does the same. It takes 2.4 to 3.6
times the processor time, with results that agree to 1e-12. SciPy's SuperLU takes what is not
quasi-definite.
"""

from __future__ import annotations

import ctypes
import functools
import hashlib
import importlib.metadata
import importlib.util
import os
import platform
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg
from jaxtyping import Bool, Float, Int32
from scipy.linalg import get_lapack_funcs

from design.processes import load_library
from fem.linear.multifrontal import SingularSystemError, eliminate
from fem.linear.sparse import block_matrix, columns_of, rows_of, shape_of, upper_triangle

_SYMMETRIC_INDEFINITE = -2
"""Type of matrix in PARDISO's numbering."""
_LARGEST_RESIDUAL = 1e-6
"""Relative residual above which a solution is refused."""
ANALYSE_PHASE, _FACTOR, _SOLVE, _BACKWARD, _RELEASE = 11, 22, 33, 333, -1
"""Phases of PARDISO, in its numbering."""
(_POTRF,) = get_lapack_funcs(("potrf",), dtype="float64")
_SCHUR_ALONE, _SCHUR_AND_FACTOR = 1, 2
"""PARDISO's iparm(36): the Schur complement alone, or with a factor that solves."""
_SINGLE_PIVOTS = 0
"""PARDISO's iparm(21): pivots of one unknown."""
_GIVEN_ORDER, _TELL_ORDER = 1, 2
"""PARDISO's iparm(5): take an order of elimination, or return its own."""
MOST_ORDERS = 8
"""Orders of elimination that are kept, at most."""
KEPT_ORDERS: dict[str, Int32[np.ndarray, "n"]] = {}
"""In which unknowns are eliminated, by the pattern of the matrix, of the last patterns. Newton's steps
and materials share one: METIS takes 45 % of a factorization of 65 000 unknowns, more of smaller ones."""


@dataclass(frozen=True)
class Compliance:
    """`matrix` = Lᵀ A⁻¹ L for the loads L, and the number of negative pivots of A."""

    matrix: Float[np.ndarray, "load load"]
    negative_pivots: int


def compliance_of_loads(matrix: sp.csr_matrix, loads: sp.csr_matrix) -> Compliance:
    """Condense a symmetric matrix A (n, n) onto sparse loads L (n, m).

    Raises
    ------
    SingularSystemError
        A is singular to working precision.
    """
    if not pardiso_available():
        eliminated = eliminate(*_bordered(matrix, loads), solves=False)
        return Compliance(-eliminated.schur, eliminated.negative_pivots)
    solver = Pardiso(_bordered_triangle(matrix, loads))
    try:
        schur = solver.condense(shape_of(loads)[1], _SCHUR_ALONE)
    finally:
        solver.release()
    return Compliance(-schur, solver.negative_pivots)


def _bordered(
    matrix: sp.csr_matrix, loads: sp.csr_matrix
) -> tuple[sp.csr_matrix, Bool[np.ndarray, "every"]]:
    """[[A, L], [Lᵀ, 0]], and which of its unknowns are the loads'."""
    size, count = shape_of(loads)
    empty = sp.csr_matrix((count, count))
    bordered = block_matrix([[matrix, loads], [loads.T.tocsr(), empty]])
    return bordered, np.arange(size + count) >= size


def _bordered_triangle(matrix: sp.csr_matrix, loads: sp.csr_matrix) -> sp.csr_matrix:
    """The upper triangle of [[A, L], [Lᵀ, 0]] with its whole diagonal stored."""
    size, count = shape_of(loads)
    last = np.arange(count)
    zeros = sp.csr_matrix((np.zeros(count), (last, size + last)), shape=(count, size + count))
    return rows_of([columns_of([upper_triangle(matrix), loads]), zeros])


def solve_symmetric(
    matrix: sp.csr_matrix, right_sides: Float[np.ndarray, "n m"]
) -> Float[np.ndarray, "n m"]:
    """Solve A x = b for a symmetric, possibly indefinite A and several right sides.

    Raises
    ------
    SingularSystemError
        A is singular to working precision.
    """
    with Factorization(matrix) as factor:
        return factor.solve(right_sides)


_Held = TypeVar("_Held", bound="_HeldFactor")


class _HeldFactor:
    """A factor in memory until it is released; a context that releases it at its end."""

    _solver: Any

    def release(self) -> None:
        """Give the memory of the factor back; nothing can be solved afterwards."""
        if isinstance(self._solver, Pardiso):
            self._solver.release()
        self._solver = None

    def __enter__(self: _Held) -> _Held:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()

    def _unreleased(self) -> Any:
        """Return the solver.

        Raises
        ------
        ValueError
            It was released.
        """
        if self._solver is None:
            raise ValueError("the factorization was released. Solve inside its context")
        return self._solver


class Factorization(_HeldFactor):
    """A symmetric, possibly indefinite matrix A, factored once and solved as often as needed.

    Use it as a context: the factor (1 GB for the default mesh) is given back at its end.
    `negative_pivots` is the number of negative eigenvalues of A (−1: unknown). In single precision, which
    PARDISO alone has, solutions are right to 1e-5 (the paper's cube), for half the memory and time.

    Raises
    ------
    SingularSystemError
        A is singular to working precision.
    """

    def __init__(self, matrix: sp.csr_matrix, single: bool = False) -> None:
        self._solver = solver_of(matrix, single)
        self.negative_pivots: int = getattr(self._solver, "negative_pivots", -1)
        self.unknowns = shape_of(matrix)[0]

    def solve(self, right_sides: Float[np.ndarray, "n m"]) -> Float[np.ndarray, "n m"]:
        """x of A x = b for every column b."""
        return self._unreleased().solve(right_sides)


class LoadedFactor(_HeldFactor):
    """Factor of `compliance_of_loads`, kept: it answers any mixture of the loads at once.

    Costs no more time than the compliance alone, but its memory (1.5 GB for the default mesh) until it is
    released; use it as a context. `compliance` equals `compliance_of_loads`. Loads act on
    displacements, so that the compliance is positive definite.

    Raises
    ------
    SingularSystemError
        A is singular to working precision; or the compliance is not positive definite, as where loads
        depend on each other, which `compliance_of_loads` allows.
    """

    def __init__(self, matrix: sp.csr_matrix, loads: sp.csr_matrix) -> None:
        self._loads = shape_of(loads)[1]
        if not pardiso_available():
            self._solver = eliminate(*_bordered(matrix, loads))
            self.compliance = Compliance(-self._solver.schur, self._solver.negative_pivots)
            return
        self._solver = Pardiso(_bordered_triangle(matrix, loads))
        try:
            schur = -self._solver.condense(self._loads, _SCHUR_AND_FACTOR)
            # PARDISO counts the complement's eigenvalues too: all of them are negative then
            if _POTRF(schur)[1]:
                raise SingularSystemError("the compliance of the loads is not positive definite")
            negative = self._solver.negative_pivots - self._loads
        except BaseException:
            self._solver.release()
            raise
        self.compliance = Compliance(schur, negative)

    def solve(self, weights: Float[np.ndarray, "load m"]) -> Float[np.ndarray, "n m"]:
        """x of A x = L w for every column w: backward substitution from the loads alone."""
        extended = self._unreleased().extend_kept(-np.asarray(weights, float))
        return extended[: len(extended) - self._loads]


def solver_of(matrix: sp.csr_matrix, single: bool = False) -> Any:
    """A factored matrix that solves; in single precision where PARDISO is there."""
    if not pardiso_available():
        try:
            return eliminate(matrix)
        except SingularSystemError:
            return _superlu(matrix)
    solver = Pardiso(upper_triangle(matrix), single)
    try:
        solver.factor()
    except BaseException:
        solver.release()
        raise
    return solver


def pardiso_available() -> bool:
    """Return whether MKL's PARDISO can be called on this machine; `INSTOBJ_MKL=0` says no."""
    return os.environ.get("INSTOBJ_MKL") != "0" and mkl_library() is not None


def quicker_by() -> str:
    """Return how to get PARDISO where it could be had and is not there, else nothing."""
    had = pardiso_available() or os.environ.get("INSTOBJ_MKL") == "0"
    if had or platform.machine() not in ("x86_64", "AMD64"):
        return ""
    return " (a third of the time with MKL: pip install 'instobj[fast]')"


def mkl_library() -> Any | None:
    if importlib.util.find_spec("pypardiso") is None:
        return None
    try:
        return _mkl_library()
    except (ImportError, OSError):
        return None


@functools.cache
def _mkl_library() -> Any:
    """Find MKL by the list of files of MKL's own package.

    Importing pypardiso costs 3 s: it looks through the whole environment.
    """
    for file in _files_of("mkl"):
        if "mkl_rt" in file.name:
            return load_library(str(file.locate()))
    from pypardiso import PyPardisoSolver

    return PyPardisoSolver().libmkl


def _files_of(distribution: str) -> list[Any]:
    """Paths as `importlib.metadata` has them; of another class once its backport is imported."""
    try:
        return importlib.metadata.files(distribution) or []
    except importlib.metadata.PackageNotFoundError:
        return []


class Pardiso:
    """One symmetric indefinite matrix in PARDISO, by its upper triangle; indices are one-based there."""

    def __init__(self, upper: sp.csr_matrix, single: bool = False) -> None:
        size = shape_of(upper)[0]
        self.type = np.dtype(np.float32 if single else np.float64)
        self.values = upper.data.astype(self.type, copy=False)
        self.row_start = (upper.indptr + 1).astype(np.int32)
        self.columns = (upper.indices + 1).astype(np.int32)
        self.handle = np.zeros(64, np.int64)
        self.marked = np.zeros(size, np.int32)
        self.parameters = np.zeros(64, np.int32)
        # own settings; METIS ordering; perturb pivots below 1e-8; Bunch–Kaufman; the two-level algorithm,
        # which takes 7 % less time on one core too; single precision; report the inertia
        for index, value in ((0, 1), (1, 2), (9, 8), (20, 1), (23, 1), (27, int(single))):
            self.parameters[index] = value
        self._function = mkl_library().pardiso  # type: ignore[union-attr]

    def call(self, phase: int, right_sides: np.ndarray, solution: np.ndarray) -> None:
        error = ctypes.c_int32(0)
        self._function(
            _pointer(self.handle, ctypes.c_int64),
            *(ctypes.byref(ctypes.c_int32(v)) for v in (1, 1, _SYMMETRIC_INDEFINITE, phase)),
            ctypes.byref(ctypes.c_int32(len(self.row_start) - 1)),
            _pointer(self.values, ctypes.c_void_p),
            _pointer(self.row_start, ctypes.c_int32),
            _pointer(self.columns, ctypes.c_int32),
            _pointer(self.marked, ctypes.c_int32),
            ctypes.byref(ctypes.c_int32(1 if right_sides.ndim == 1 else right_sides.shape[1])),
            _pointer(self.parameters, ctypes.c_int32),
            ctypes.byref(ctypes.c_int32(0)),
            _pointer(right_sides, ctypes.c_void_p),
            _pointer(solution, ctypes.c_void_p),
            ctypes.byref(error),
        )
        if error.value == -2:
            raise MemoryError("PARDISO ran out of memory. Use a coarser mesh.edge_mm")
        if error.value or (phase == _FACTOR and self.parameters[13]):
            raise SingularSystemError(
                f"PARDISO phase {phase} failed: error {error.value}, "
                f"{self.parameters[13]} perturbed pivots"
            )

    def factor(self) -> None:
        """Analyse and factor; a pattern that was met before keeps its order."""
        unused = np.zeros(len(self.marked), self.type)
        pattern = hashlib.blake2b(self.row_start.tobytes())
        pattern.update(self.columns.tobytes())
        order = KEPT_ORDERS.pop(pattern.hexdigest(), None)
        self.parameters[4] = _TELL_ORDER if order is None else _GIVEN_ORDER
        if order is not None:
            self.marked[:] = order
        self.call(ANALYSE_PHASE, unused, unused)
        KEPT_ORDERS[pattern.hexdigest()] = self.marked.copy() if order is None else order
        if len(KEPT_ORDERS) > MOST_ORDERS:
            KEPT_ORDERS.pop(next(iter(KEPT_ORDERS)))
        self.call(_FACTOR, unused, unused)

    def condense(self, count: int, how: int) -> Float[np.ndarray, "last last"]:
        """Schur complement of the last unknowns; the others are quasi-definite, which needs no blocks of
        two as pivots (the compliance is the same to 1e-14, a tenth of the time less)."""
        self.parameters[20], self.parameters[35] = _SINGLE_PIVOTS, how
        self.marked[len(self.marked) - count :] = 1
        schur, unused = np.zeros((count, count)), np.zeros(len(self.marked))
        self.call(ANALYSE_PHASE, unused, schur)
        self.call(_FACTOR, unused, schur)
        return schur

    def extend_kept(self, kept: Float[np.ndarray, "kept m"]) -> Float[np.ndarray, "n m"]:
        """All unknowns where the marked ones, the last, have these values and nothing else loads the
        others."""
        given = np.zeros((len(self.marked), kept.shape[1]), order="F")
        given[len(given) - len(kept) :] = kept
        solution = np.zeros_like(given, order="F")
        self.call(_BACKWARD, given, solution)
        return solution

    def solve(self, right_sides: Float[np.ndarray, "n m"]) -> Float[np.ndarray, "n m"]:
        rhs = np.asfortranarray(right_sides, self.type)
        solution = np.zeros_like(rhs, order="F")
        self.call(_SOLVE, rhs, solution)
        return solution

    def release(self) -> None:
        unused = np.zeros(len(self.marked), self.type)
        self.call(_RELEASE, unused, unused)

    @property
    def negative_pivots(self) -> int:
        return int(self.parameters[22])


def _pointer(array: np.ndarray, kind: Any) -> Any:
    return array.ctypes.data_as(ctypes.POINTER(kind))


def _superlu(matrix: sp.csr_matrix) -> Any:
    """For tangents under large compression, which are indefinite on displacements too."""
    try:
        factor = scipy.sparse.linalg.splu(sp.csc_matrix(matrix))
    except RuntimeError as error:
        raise SingularSystemError(str(error)) from error
    # SuperLU rarely notices a singular matrix: rounding leaves a pivot of 1e-16, and no error
    probe = np.random.default_rng(1).standard_normal(shape_of(matrix)[0])
    residual = np.linalg.norm(matrix @ factor.solve(probe) - probe) / np.linalg.norm(probe)
    if not residual < _LARGEST_RESIDUAL:
        raise SingularSystemError(
            f"SuperLU solves to a relative residual of {residual:.1g} only: the matrix is singular"
        )
    return factor
