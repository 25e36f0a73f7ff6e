"""Chips under each face: they answer when it is pressed; the null exchanges chips and faces."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from estimator.adoption.findings import CERTAIN, EXCHANGES, Finding, numbers_text, share_as_high
from estimator.adoption.presses import ForeignPresses

_LEAST_GAP = 1.8
"""Ratio of answers between the weakest chip of a face and the strongest of the others, at least."""


def chips_under_faces(presses: ForeignPresses) -> tuple[dict[int, list[int]], list[Finding]]:
    """Return face → its chips, and a finding for each face pressed.

    The chips of a face stand above the widest gap among the answers, sorted; a chip goes to the face
    that it answers most. The null exchanges the chips within every press (one face), or the faces
    among the presses as well (several).
    """
    pressed = [int(f) for f in np.unique(presses.face) if f > 0]
    rng = np.random.default_rng((0, 31))
    strength = answers(presses, presses.face, pressed)
    groups, gaps = _split(strength)
    null = []
    for _ in range(EXCHANGES):
        mixed, size = _mixed(presses, rng)
        null.append(_split(answers(mixed, mixed.face, pressed, size))[1])
    chips_of_face, findings = {}, []
    for k, face in enumerate(pressed):
        p = share_as_high([gap[k] for gap in null], gaps[k])
        is_certain = gaps[k] >= _LEAST_GAP and p <= CERTAIN
        if is_certain:
            chips_of_face[face] = groups[k]
        chips = numbers_text([c + 1 for c in groups[k]])
        findings.append(
            Finding(
                f"chips under face {face}",
                f"chips {chips}" if is_certain else "cannot be told: all chips answer alike",
                f"weakest of them {gaps[k]:.1f} times the strongest other",
                f"{np.median([gap[k] for gap in null]):.1f} times",
                p,
            )
        )
    return chips_of_face, findings


def answers(
    presses: ForeignPresses,
    face: Int[np.ndarray, "press contact"],
    faces: list[int],
    size: Float[np.ndarray, "press chip"] | None = None,
) -> Float[np.ndarray, "face chip"]:
    """Root mean square of each chip's change over the presses of each face, above its scatter at rest."""
    size = presses.size if size is None else size
    noise = np.zeros(size.shape[1])
    if len(presses.rest_scatter):
        noise = np.mean(np.nan_to_num(np.sum(presses.rest_scatter**2, axis=2)), axis=0)
    strength = np.zeros((len(faces), size.shape[1]))
    for k, number in enumerate(faces):
        rows = size[(face == number).any(axis=1)]
        live = np.isfinite(rows)
        power = np.where(live, rows, 0.0) ** 2
        mean = power.sum(axis=0) / np.maximum(live.sum(axis=0), 1)
        strength[k] = np.sqrt(np.maximum(mean - noise, noise) + 1.0)
    return strength


def _split(strength: Float[np.ndarray, "face chip"]) -> tuple[list[list[int]], list[float]]:
    """Return each face's chips and the ratio of the weakest of them to the strongest other.

    Where several faces were pressed each chip is one of the face that it answers most.
    """
    face_of_chip = np.argmax(strength, axis=0)
    groups, gaps = [], []
    for k, row in enumerate(strength):
        order = np.argsort(-row)
        most = max(1, len(row) // 2) if len(strength) == 1 else len(row) - 1
        candidates = [c for c in order if face_of_chip[c] == k][:most] or [int(order[0])]
        ratios = []
        for count in range(1, len(candidates) + 1):
            outside = np.setdiff1d(order, candidates[:count])
            ratios.append(row[candidates[count - 1]] / max(row[outside].max(initial=1.0), 1.0))
        best = int(np.argmax(ratios)) + 1
        groups.append(sorted(int(c) for c in candidates[:best]))
        gaps.append(float(ratios[best - 1]))
    return groups, gaps


def _mixed(
    presses: ForeignPresses, rng: np.random.Generator
) -> tuple[ForeignPresses, Float[np.ndarray, "press chip"]]:
    """Exchange the chips that answered within every press, and the faces among the presses."""
    order = rng.random(presses.size.shape).argsort(axis=1)
    size = np.take_along_axis(presses.size, order, axis=1)
    return presses.select(rng.permutation(len(presses))), size
