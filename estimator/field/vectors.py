"""Vectors as triples of equally broadcastable arrays (x, y, z).

This keeps large batches in contiguous, cache-sized chunks.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from jaxtyping import Float

Vector = tuple[Any, Any, Any]
"""Components x, y, z: arrays or numbers of one shape."""

_SMALL_SQUARED = 0.25**2
"""Below this the series is exact to rounding: what it leaves out is 1e-17."""
_SINE_SERIES = tuple((-1) ** k / math.factorial(2 * k + 1) for k in range(6))
"""Coefficients of sin h/h in powers of h²."""


def dot(a: Vector, b: Vector) -> Any:
    """a·b."""
    return plus_product(plus_product(a[0] * b[0], a[1], b[1]), a[2], b[2])


def cross(a: Vector, b: Vector) -> Vector:
    """a × b."""
    (ax, ay, az), (bx, by, bz) = a, b
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


def plus_product(a: Any, b: Any, c: Any, factor: float = 1.0) -> Any:
    """a + factor b c, without another array for the sum."""
    product = b * c if factor == 1.0 else (factor * b) * c
    product += a
    return product


def components(vectors: Float[np.ndarray, "*any 3"]) -> Vector:
    """x, y and z of an array whose last dimension holds them, each contiguous."""
    x, y, z = (np.ascontiguousarray(vectors[..., axis]) for axis in range(3))
    return x, y, z


def rotated(vector: Vector, turn: Vector) -> Vector:
    """Rodrigues: v cos θ + w × v sin θ/θ + w (w·v) (1 − cos θ)/θ², component by component.

    `turn` is the rotation vector (rad); exact for finite angles. SciPy's `Rotation` takes one list
    of vectors; here every component stays its own array.
    """
    (x, y, z), (wx, wy, wz) = vector, turn
    squared = 0.25 * (wx * wx + wy * wy + wz * wz)
    share, cosine_of_half = _sine_and_cosine_of_half(squared)
    cosine, sine = 1 - 2 * squared * share * share, share * cosine_of_half
    along_turn = 0.5 * share * share * (wx * x + wy * y + wz * z)
    return (
        cosine * x + sine * (wy * z - wz * y) + along_turn * wx,
        cosine * y + sine * (wz * x - wx * z) + along_turn * wy,
        cosine * z + sine * (wx * y - wy * x) + along_turn * wz,
    )


def _sine_and_cosine_of_half(squared: Any) -> tuple[Any, Any]:
    """sin h/h and cos h of h²; of small angles by the series, in a third of the time."""
    if isinstance(squared, np.ndarray) and np.max(squared, initial=0.0) < _SMALL_SQUARED:
        share = _SINE_SERIES[-1] * squared
        for term in _SINE_SERIES[-2:0:-1]:
            share += term
            share *= squared
        share += _SINE_SERIES[0]
        return share, np.sqrt(1 - squared * share * share)
    half = squared**0.5
    half = half + 1e-20 * (half == 0)
    return np.sin(half) / half, np.cos(half)


def rotate(
    vectors: Float[np.ndarray, "*any 3"], rotation_vector: Float[np.ndarray, "*any 3"]
) -> Float[np.ndarray, "*any 3"]:
    """`rotated` for arrays whose last dimension holds the components."""
    vector, turn = np.broadcast_arrays(vectors, rotation_vector)
    return np.stack(rotated(components(vector), components(turn)), axis=-1)
