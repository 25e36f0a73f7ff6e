"""Bounds of two contacts at once: two tips on one face, or one on each of two opposite faces."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.information.contact_sets import spread_pairs, spread_places
from estimator.information.identifiability import jacobians_of, set_information
from estimator.signals.presses import Signals

PERCENT = 95.0
"""Of the bounds over all pairs of spread contact locations: what a layout is scored by."""


def two_contact_bounds_mm(
    spec: ObjectSpec, signals: Signals
) -> dict[str, Float[np.ndarray, "pair"]]:
    """Position bound of the worse of two contacts, freshly zeroed, over spread contact locations.

    "own" and "all": two tips on one face, over all faces, from its own channels and from those of all
    faces. "grasp": one tip on each of two opposite faces, from the channels of all faces. Infinite
    where the signals cannot tell; empty where tips do not fit or no two faces are opposite.
    """
    faces = {face.face: face for face in jacobians_of(spec, signals, spread_places(spec))}
    pairs = spread_pairs(spec)
    every = {number: face.whitened for number, face in faces.items()}
    own = {number: every[number][:, face.own] for number, face in faces.items()}
    grasps = [_across(every[a], every[b]) for a, b in opposite_faces(spec)]
    return {
        "own": _worse_mm([_together(one, pairs) for one in own.values()]),
        "all": _worse_mm([_together(one, pairs) for one in every.values()]),
        "grasp": _worse_mm(grasps),
    }


def opposite_faces(spec: ObjectSpec) -> tuple[tuple[int, int], ...]:
    """Pairs of sensed faces whose normals oppose each other."""
    frames = face_frames(spec)
    return tuple(
        (a.number, b.number)
        for row, a in enumerate(frames)
        for b in frames[row + 1 :]
        if a.normal @ b.normal < -0.5
    )


def _together(
    one: Float[np.ndarray, "place channel 3"], pairs: Int[np.ndarray, "pair 2"]
) -> Float[np.ndarray, "pair channel 6"]:
    return np.concatenate([one[pairs[:, 0]], one[pairs[:, 1]]], axis=2)


def _across(
    one: Float[np.ndarray, "place channel 3"], other: Float[np.ndarray, "place channel 3"]
) -> Float[np.ndarray, "pair channel 6"]:
    """Every location of one face with every location of the other."""
    a, b = np.divmod(np.arange(len(one) * len(other)), len(other))
    return np.concatenate([one[a], other[b]], axis=2)


def _worse_mm(sets: list[Float[np.ndarray, "pair channel 6"]]) -> Float[np.ndarray, "n"]:
    found = [set_information(one).position_bound_mm.max(axis=1) for one in sets if len(one)]
    return np.concatenate(found) if found else np.zeros(0)
