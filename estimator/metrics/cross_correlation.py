"""Best displacement of predicted heatmaps against true ones, by zero-normalised cross-correlation.

With maps T (true) and P (predicted), each less its own mean, the correlation at displacement d is
C(d) = Σ_u P(u + d) T(u) / (‖P‖ ‖T‖), zero outside (Knopke et al., RA-L 2024).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

_TIE = 1e-9
"""Correlations this close are equal: the shortest displacement among them is taken."""
CHUNK_FRAMES = 4096
"""Frames correlated at once: it bounds the memory."""


@dataclass(frozen=True)
class Alignment:
    """Best displacement of each predicted map against the true one.

    A map without any contrast (constant) has no correlation: its similarity is 0 and its
    displacement NaN.
    """

    similarity: Float[np.ndarray, "frame"]
    displacement_px: Float[np.ndarray, "frame 2"]


def align(
    predicted_n: Float[np.ndarray, "frame nx ny"], true_n: Float[np.ndarray, "frame nx ny"]
) -> Alignment:
    """A_sim and the displacement of the best match, frame by frame (zero-padded, by FFT)."""
    chunks = [
        _align_chunk(
            predicted_n[start : start + CHUNK_FRAMES], true_n[start : start + CHUNK_FRAMES]
        )
        for start in range(0, max(1, len(true_n)), CHUNK_FRAMES)
    ]
    return Alignment(
        np.concatenate([chunk.similarity for chunk in chunks]),
        np.concatenate([chunk.displacement_px for chunk in chunks]),
    )


def _align_chunk(
    predicted_n: Float[np.ndarray, "frame nx ny"], true_n: Float[np.ndarray, "frame nx ny"]
) -> Alignment:
    from scipy import fft

    p, t = _normalised(predicted_n), _normalised(true_n)
    nx, ny = t.shape[1:]
    size = (fft.next_fast_len(2 * nx - 1, real=True), fft.next_fast_len(2 * ny - 1, real=True))
    spectrum = np.asarray(fft.rfft2(p, size)) * np.asarray(fft.rfft2(t, size)).conj()
    correlation = np.asarray(fft.irfft2(spectrum, size))
    shifts = np.stack(
        np.meshgrid(np.arange(1 - nx, nx), np.arange(1 - ny, ny), indexing="ij"), -1
    ).reshape(-1, 2)
    shifts = shifts[np.argsort(np.hypot(*shifts.T), kind="stable")]
    by_distance = correlation[:, shifts[:, 0], shifts[:, 1]]
    best = by_distance.max(axis=1)
    chosen = np.argmax(by_distance >= best[:, None] - _TIE, axis=1)
    defined = np.any(p != 0, axis=(1, 2)) & np.any(t != 0, axis=(1, 2))
    return Alignment(
        np.where(defined, np.clip(best, -1.0, 1.0), 0.0),
        np.where(defined[:, None], shifts[chosen], np.nan).astype(float),
    )


def _normalised(maps: Float[np.ndarray, "frame nx ny"]) -> Float[np.ndarray, "frame nx ny"]:
    """Zero mean and unit norm; exactly zero where a map is constant up to rounding."""
    maps = np.asarray(maps, float)
    centred = maps - maps.mean(axis=(1, 2), keepdims=True)
    norm = np.sqrt(np.sum(centred**2, axis=(1, 2), keepdims=True))
    scale = np.abs(maps).max(axis=(1, 2), keepdims=True)
    constant = norm <= 1e-12 * scale
    return np.where(constant, 0.0, centred / np.where(constant, 1.0, norm))
