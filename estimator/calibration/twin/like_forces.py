"""Frames of a place in levels of like force.

Frames of a stop have one force and labels that scatter about it. Sorted by label they would fall into
levels whose mean labels differ and whose signals do not: a bias that no number of frames lowers. So
stretches of steady force stay whole, or are cut in time, and these pieces are sorted.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from jaxtyping import Float, Int

STEADY_NOISES = 3.0
"""A stretch is steady while no label is farther from its mean than this many noises of a label."""


def steady_pieces(
    force_n: Float[np.ndarray, "frame"],
    press: Int[np.ndarray, "frame"],
    noise_n: float,
    longest: int,
) -> list[Int[np.ndarray, "_"]]:
    """Frames, in order of time, as stretches of one press and a steady force, none longer than
    `longest`."""
    starts, total, count = [0], float(force_n[0]), 1
    for k in range(1, len(force_n)):
        if press[k] != press[k - 1] or abs(force_n[k] - total / count) > STEADY_NOISES * noise_n:
            starts.append(k)
            total, count = 0.0, 0
        total, count = total + float(force_n[k]), count + 1
    stretches = np.split(np.arange(len(force_n)), starts[1:])
    return [
        piece
        for stretch in stretches
        for piece in np.array_split(stretch, -(-len(stretch) // longest))
    ]


def levels_of_like_force(
    force_n: Float[np.ndarray, "frame"],
    press: Int[np.ndarray, "frame"],
    noise_n: float,
    levels: int,
) -> list[Int[np.ndarray, "_"]]:
    """Frames, in order of time, in `count` levels by growing mean label, with about equal numbers."""
    pieces = steady_pieces(force_n, press, noise_n, max(len(force_n) // levels, 1))
    pieces.sort(key=lambda piece: float(force_n[piece].mean()))
    ends = np.cumsum([len(piece) for piece in pieces])
    wanted = len(force_n) * np.arange(1, levels) / levels
    cuts = np.abs(ends[:, None] - wanted).argmin(axis=0) + 1
    for k in range(levels - 1):  # at least one piece each
        cuts[k] = max(cuts[k], cuts[k - 1] + 1 if k else 1)
        cuts[k] = min(cuts[k], len(pieces) - (levels - 1 - k))
    edges = [0, *cuts.tolist(), len(pieces)]
    return [np.concatenate(pieces[a:b]) for a, b in pairwise(edges)]
