"""Sparse blocks with definite types: SciPy's own functions return any of a dozen classes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

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


def shape_of(matrix: sp.spmatrix) -> tuple[int, int]:
    """Rows and columns."""
    rows, columns = matrix.shape  # pyright: ignore[reportAttributeAccessIssue]
    return int(rows), int(columns)
