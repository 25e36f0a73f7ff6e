"""Sparse blocks with definite types: SciPy's own functions return any of a dozen classes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import scipy.sparse as sp


def rows_of(blocks: Sequence[Any]) -> sp.csr_matrix:
    """Blocks stacked on top of each other."""
    return sp.csr_matrix(sp.vstack(blocks))


def columns_of(blocks: Sequence[Any]) -> sp.csr_matrix:
    """Blocks side by side."""
    return sp.csr_matrix(sp.hstack(blocks))


def block_matrix(blocks: Sequence[Sequence[Any]]) -> sp.csr_matrix:
    """A matrix of blocks; None stands for zeros."""
    return sp.csr_matrix(sp.bmat(blocks))


def upper_triangle(matrix: sp.csr_matrix) -> sp.csr_matrix:
    """Entries on and above the diagonal, columns sorted, every diagonal entry stored (zeros too)."""
    matrix.sum_duplicates()
    size = shape_of(matrix)[0]
    rows = np.repeat(np.arange(size, dtype=matrix.indices.dtype), np.diff(matrix.indptr))
    # PARDISO wants every diagonal entry, zeros too. Columns are sorted, so a missing one belongs at
    # the start of its row of the triangle: it is inserted there, and nothing is sorted again.
    keep = (matrix.indices == rows) | ((matrix.indices > rows) & (matrix.data != 0))
    rows, columns = rows[keep], matrix.indices[keep]
    missing = np.ones(size, bool)
    missing[rows[columns == rows]] = False
    start = np.append(0, np.cumsum(np.bincount(rows, minlength=size)))
    bare = np.flatnonzero(missing)
    data = np.insert(matrix.data[keep], start[bare], 0.0)
    columns = np.insert(columns, start[bare], bare)
    start[1:] += np.cumsum(missing)  # each insertion moves the ends of its and all later rows
    return sp.csr_matrix((data, columns, start), shape=(size, size), copy=False)


def shape_of(matrix: sp.spmatrix) -> tuple[int, int]:
    """Rows and columns."""
    rows, columns = matrix.shape  # pyright: ignore[reportAttributeAccessIssue]
    return int(rows), int(columns)
