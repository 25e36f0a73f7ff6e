"""Contacts that a recording's labels and load cells describe."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.dataset import NO_FACE
from estimator.heatmap import NO_CONTACT_LABELS, label_grid_mm, label_to_pixel, pixel_to_mm

Place = tuple[tuple[int, int], ...]
"""A contact case: (face, position label) of every tip, sorted."""


def contact_cases(
    face: Int[np.ndarray, "frame cell"],
    position: Int[np.ndarray, "frame cell tip"],
    touching: Bool[np.ndarray, "frame cell"],
) -> tuple[Int[np.ndarray, "frame"], Int[np.ndarray, "frame"], tuple[Place, ...]]:
    """Session of each frame (contiguous block of one contact case), place id (-1 without
    contact), and the contact case of each place id."""
    keys = np.column_stack([face, position.reshape(len(position), -1)])
    session = np.concatenate([[0], np.cumsum(np.any(keys[1:] != keys[:-1], axis=1))])
    unique, index = np.unique(keys, axis=0, return_inverse=True)
    cells = face.shape[1]
    cases = [_place(row[:cells], row[cells:].reshape(cells, -1)) for row in unique]
    places = tuple(sorted({case for case in cases if case}))
    number = np.array([places.index(case) if case else -1 for case in cases])
    return session, np.where(touching.any(axis=1), number[index.ravel()], -1), places


def _place(face: Int[np.ndarray, "cell"], position: Int[np.ndarray, "cell tip"]) -> Place:
    return tuple(
        sorted(
            (int(f), int(p))
            for f, labels in zip(face, position, strict=True)
            for p in labels
            if p not in NO_CONTACT_LABELS
        )
    )


def contact_slots(
    face: Int[np.ndarray, "frame cell"],
    position: Int[np.ndarray, "frame cell tip"],
    force_n: Float[np.ndarray, "frame cell"],
    touching: Bool[np.ndarray, "frame cell"],
) -> tuple[
    Int[np.ndarray, "frame contact"],
    Float[np.ndarray, "frame contact 2"],
    Float[np.ndarray, "frame contact 3"],
]:
    """One slot a tip and cell, each tip with its share of the cell's normal force."""
    frames, cells, tips = position.shape
    held = touching[:, :, None] & ~np.isin(position, NO_CONTACT_LABELS)
    share_n = force_n / np.maximum(held.sum(axis=2), 1)
    pixel = label_to_pixel(np.where(held, position, 1))
    xy_mm = np.where(held[..., None], pixel_to_mm(pixel, *label_grid_mm()), np.nan)
    force_xyz_n = np.zeros((frames, cells, tips, 3))
    force_xyz_n[..., 2] = share_n[:, :, None]
    force_xyz_n[~held] = np.nan
    held_face = np.where(held, face[:, :, None], NO_FACE)
    slots = cells * tips
    return (
        held_face.reshape(frames, slots),
        xy_mm.reshape(frames, slots, 2),
        force_xyz_n.reshape(frames, slots, 3),
    )
