"""Contacts that a recording's labels and load cells describe."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE

Place = tuple[tuple[int, float, float], ...]
"""A contact case: face, x and y (mm) of every tip, sorted."""
_NOWHERE = 1e6
"""Coordinate of tips that are not there: equal to each other, unlike any place."""


def place_keys(
    face: Int[np.ndarray, "frame cell"], tip_xy_mm: Float[np.ndarray, "frame cell tip 2"]
) -> Float[np.ndarray, "frame key"]:
    """Rows that are equal where the labels are: faces, then places to 1 µm (none: far away)."""
    xy = np.round(np.nan_to_num(tip_xy_mm, nan=_NOWHERE), 3)
    stated = np.where(np.isfinite(tip_xy_mm).any(axis=(2, 3)), face, NO_FACE)
    return np.column_stack([stated, xy.reshape(len(face), -1)])


def carried_labels(
    face: Int[np.ndarray, "frame cell"],
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"],
    session: Int[np.ndarray, "frame"],
) -> tuple[Int[np.ndarray, "frame cell"], Float[np.ndarray, "frame cell tip 2"]]:
    """Labels carried to the frames that state none: from those after, else before, of the session.

    A place stated only while it is pressed so covers the rest before that press, too.
    """
    frames = np.arange(len(face))
    face, tip_xy_mm = face.copy(), tip_xy_mm.copy()
    for cell in range(face.shape[1]):
        stated = np.flatnonzero(np.isfinite(tip_xy_mm[:, cell]).any(axis=(1, 2)))
        if not len(stated):
            continue
        after = np.searchsorted(stated, frames)
        following = stated[np.minimum(after, len(stated) - 1)]
        preceding = stated[np.maximum(after - 1, 0)]
        source = np.where(session[following] == session, following, preceding)
        has_label = session[source] == session
        face[has_label, cell] = face[source[has_label], cell]
        tip_xy_mm[has_label, cell] = tip_xy_mm[source[has_label], cell]
    return face, tip_xy_mm


def block_numbers(keys: Float[np.ndarray, "frame label"]) -> Int[np.ndarray, "frame"]:
    """Number of the block of contiguous frames with equal keys that each frame lies in."""
    return np.concatenate([[0], np.cumsum(np.any(keys[1:] != keys[:-1], axis=1))])


def contact_cases(
    face: Int[np.ndarray, "frame cell"],
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"],
    touching: Bool[np.ndarray, "frame cell"],
) -> tuple[Int[np.ndarray, "frame"], Int[np.ndarray, "frame"], tuple[Place, ...]]:
    """Block of each frame (contiguous frames of one contact case), place id (-1 without
    contact), and the contact case of each place id."""
    keys = place_keys(face, tip_xy_mm)
    block = block_numbers(keys)
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    cases = [contact_place(face[row], tip_xy_mm[row]) for row in first]
    places = tuple(sorted({case for case in cases if case}))
    number = np.array([places.index(case) if case else -1 for case in cases])
    return block, np.where(touching.any(axis=1), number[index.ravel()], -1), places


def contact_place(
    face: Int[np.ndarray, "cell"], tip_xy_mm: Float[np.ndarray, "cell tip 2"]
) -> Place:
    """Contact case that a row's labels state, to 1 µm; empty where they state no place."""
    return tuple(
        sorted(
            (int(f), round(float(x), 3), round(float(y), 3))
            for f, tips in zip(face, tip_xy_mm, strict=True)
            for x, y in tips
            if np.isfinite(x)
        )
    )


def place_text(place: Place) -> str:
    """For people: face 3 (1.5, 4.5) + face 5 (1.5, -4.5)."""
    return " + ".join(f"face {face} ({x:g}, {y:g})" for face, x, y in place) or "no place"


def contact_slots(
    face: Int[np.ndarray, "frame cell"],
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"],
    force_n: Float[np.ndarray, "frame cell"],
    shear_n: Float[np.ndarray, "frame cell 2"],
    touching: Bool[np.ndarray, "frame cell"],
) -> tuple[
    Int[np.ndarray, "frame contact"],
    Float[np.ndarray, "frame contact 2"],
    Float[np.ndarray, "frame contact 3"],
]:
    """One slot per tip and cell, each tip with its share of the cell's normal and tangential force."""
    frames, cells, tips = tip_xy_mm.shape[:3]
    held = touching[:, :, None] & np.isfinite(tip_xy_mm[..., 0])
    cell_n = np.concatenate([shear_n, force_n[..., None]], axis=2)
    share_n = cell_n / np.maximum(held.sum(axis=2), 1)[..., None]
    xy_mm = np.where(held[..., None], tip_xy_mm, np.nan)
    force_xyz_n = np.where(held[..., None], share_n[:, :, None], np.nan)
    held_face = np.where(held, face[:, :, None], NO_FACE)
    slots = cells * tips
    return (
        held_face.reshape(frames, slots),
        xy_mm.reshape(frames, slots, 2),
        force_xyz_n.reshape(frames, slots, 3),
    )
