"""Arrays of many problems: NumPy's, or tensors of torch on a device, and the few calls that differ.

Forward model, posterior and dictionary are written once, in what both libraries share; what they are
given decides where they work. A program that gives NumPy's arrays never imports torch.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

Array = Any
"""A NumPy array or a tensor, as in `Float[Array, "problem channel"]`."""


def library(array: Array) -> Any:
    """Return the module of an array: `numpy` or `torch`."""
    return np if isinstance(array, np.ndarray) else sys.modules["torch"]


def like(reference: Array, values: Any) -> Array:
    """Return values as an array of the reference's kind, on its device."""
    if isinstance(reference, np.ndarray):
        return np.asarray(values)
    if isinstance(values, np.ndarray) and not values.flags.writeable:
        values = values.copy()  # torch warns of memory that it could write to
    return library(reference).as_tensor(values, device=reference.device)


def zeros(reference: Array, shape: tuple[int, ...]) -> Array:
    """Return zeros of the reference's kind and type, on its device."""
    if isinstance(reference, np.ndarray):
        return np.zeros(shape, reference.dtype)
    return reference.new_zeros(shape)


def to_host(array: Array) -> np.ndarray:
    """Return the array as NumPy's."""
    return array if isinstance(array, np.ndarray) else array.cpu().numpy()


def diagonals(matrices: Array) -> Array:
    """View of each matrix's diagonal."""
    if isinstance(matrices, np.ndarray):
        view = matrices.diagonal(axis1=1, axis2=2)
        # NumPy protects this view; callers add to it
        view.flags.writeable = True
        return view
    return matrices.diagonal(dim1=1, dim2=2)


def apply_in_chunks(function: Callable[..., Array], rows: int, *arrays: Array) -> Array:
    """Return a function of arrays' rows, applied to `rows` rows at a time on a processor.

    Intermediate results then fit its cache. Other devices take all rows at once.
    """
    count = len(arrays[0])
    if count <= rows or not (isinstance(arrays[0], np.ndarray) or arrays[0].device.type == "cpu"):
        return function(*arrays)
    starts = range(0, count, rows)
    return concatenated([function(*(a[k : k + rows] for a in arrays)) for k in starts])


def true_rows(mask: Array) -> Array:
    """Indices of what is true along the one dimension."""
    return library(mask).where(mask)[0]


def float32(array: Array) -> Array:
    """Return the array in single precision."""
    return array.astype(np.float32) if isinstance(array, np.ndarray) else array.float()


def float64(array: Array) -> Array:
    """Return the array in double precision."""
    return array.astype(np.float64) if isinstance(array, np.ndarray) else array.double()


def rows_of(array: Array, rows: Array) -> Array:
    """Return rows; their indices are NumPy's or on the array's device."""
    return array[rows if isinstance(array, np.ndarray) else like(array, rows)]


def chosen(array: Array, index: Array) -> Array:
    """Return entries of the second dimension."""
    return array.take(index, axis=1) if isinstance(array, np.ndarray) else array[:, index]


def concatenated(parts: Sequence[Array]) -> Array:
    """Return the parts joined along the first dimension."""
    return library(parts[0]).concatenate(parts)
