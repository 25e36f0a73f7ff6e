"""Cross-face disturbance: effect of a press on one face on the channels of another.

A face's own estimator takes every signal for a press on its own face. A press elsewhere moves
magnets near this face's sensors all the same; the paper names it the limit of grasps (its E_f
rises to 24 to 39 % when the opposite face is pressed too).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.body import face_frames
from design.layout.places.contact_grid import grid_places_in_lattice
from design.layout.places.contact_places import contact_places
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.information.fisher import disturbance_counts
from estimator.information.scores import fill_places
from estimator.information.sensitivity import own_channels
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.live import read_change
from estimator.signals.presses import Signals

Relation = Literal["adjacent", "opposite"]
LEAST_FALSE_FORCE_N = 0.01
"""Less is no gain of a layout: no sensor shows it."""
RELATIONS: tuple[Relation, ...] = ("adjacent", "opposite")


@dataclass(frozen=True)
class CrossFace:
    """Disturbance of a face's own channels by presses of `force_n` on other faces.

    `pressed`, `read` (pair,) are face numbers and `relation` how they lie to each other. Per pair
    and place of the pressed face: `size_sigma`, length of the signal change in units of a fresh
    zero; `false_force_n`, force of the own-face press (or rest) whose signal is nearest; NaN at
    places that the pressed face has not.
    """

    force_n: float
    pressed: Int[np.ndarray, "pair"]
    read: Int[np.ndarray, "pair"]
    relation: tuple[Relation, ...]
    size_sigma: Float[np.ndarray, "pair place"]
    false_force_n: Float[np.ndarray, "pair place"]
    places: Bool[np.ndarray, "pair place"]

    def summary(self, relation: Relation) -> dict[str, float]:
        """Median, 95th percentile and largest disturbance (σ) and false force (N), over all pairs
        and places.

        Empty where no two sensed faces lie so to each other.
        """
        rows = np.array([r == relation for r in self.relation], bool)
        if not rows.any():
            return {}
        judged = rows[:, None] & self.places
        size, force = self.size_sigma[judged], self.false_force_n[judged]
        return {
            "median_sigma": float(np.median(size)),
            "percentile_95_sigma": float(np.percentile(size, 95)),
            "largest_sigma": float(size.max()),
            "median_false_force_n": float(np.median(force)),
            "percentile_95_false_force_n": float(np.percentile(force, 95)),
            "largest_false_force_n": float(force.max()),
        }


def cross_face_disturbance(spec: ObjectSpec, signals: Signals, force_n: float = 10.0) -> CrossFace:
    """Every sensed face read while every other is pressed at each contact location.

    Places that do not reach `force_n` within the deepest press are pressed to that depth.
    """
    frames = face_frames(spec)
    pairs = [(a, b) for a in range(len(frames)) for b in range(len(frames)) if a != b]
    relation: list[Relation] = [
        "opposite" if frames[a].normal @ frames[b].normal < -0.5 else "adjacent" for a, b in pairs
    ]
    places, live = contact_places(spec), live_channels(spec).ravel()
    pressed = [
        _pressed_counts(spec, signals, face.number, pressed_rows, force_n)
        for face, pressed_rows in zip(frames, places, strict=True)
    ]
    sizes, forces = [], []
    for pressed_face, read_face in pairs:
        face_channels = own_channels(signals, spec.sensors, frames[read_face].number)
        face_channels = face_channels[live[face_channels]]
        sigma = disturbance_counts(spec.sensors, "fresh", live.size)[face_channels]
        change = pressed[pressed_face][:, face_channels] / sigma
        sizes.append(np.linalg.norm(change, axis=1))
        forces.append(
            nearest_press(change, *_own_presses(spec, signals, read_face, face_channels, sigma))[0]
        )
    pressed_rows = places[[a for a, _ in pairs]] if pairs else places[:0]
    return CrossFace(
        force_n,
        np.array([frames[a].number for a, _ in pairs], dtype=int),
        np.array([frames[b].number for _, b in pairs], dtype=int),
        tuple(relation),
        fill_places(pressed_rows, sizes) if pairs else np.zeros(pressed_rows.shape),
        fill_places(pressed_rows, forces) if pairs else np.zeros(pressed_rows.shape),
        pressed_rows,
    )


def _pressed_counts(
    spec: ObjectSpec,
    signals: Signals,
    face: int,
    is_place: Bool[np.ndarray, "every"],
    force_n: float,
) -> Float[np.ndarray, "place channel"]:
    xy = signals.lattice.xy_mm[grid_places_in_lattice(spec)[is_place]]
    traces = press_traces(signals, np.full(len(xy), face), xy[:, 0], xy[:, 1])
    change = counts_at_force(traces, np.full((len(xy), 1), force_n), beyond="clamp").counts[:, 0]
    rest = signals.baseline_counts.ravel()
    return read_change(rest, change, full_scale_counts(spec.sensors))


def _own_presses(
    spec: ObjectSpec,
    signals: Signals,
    face_index: int,
    face_channels: Int[np.ndarray, "channel"],
    sigma: Float[np.ndarray, "channel"],
) -> tuple[Float[np.ndarray, "place knot channel"], Float[np.ndarray, "place knot"]]:
    """Whitened signals of the face's own presses from rest on, and their forces."""
    places = grid_places_in_lattice(spec)[contact_places(spec)[face_index]]
    counts = signals.delta_counts[face_index, places].reshape(
        len(places), len(signals.depth_mm), -1
    )
    rest = np.zeros((len(places), 1))
    rest_counts = signals.baseline_counts.ravel()[face_channels]
    counts = read_change(rest_counts, counts[..., face_channels], full_scale_counts(spec.sensors))
    curve = np.concatenate([np.zeros((len(places), 1, len(face_channels))), counts / sigma], axis=1)
    return curve, np.concatenate([rest, signals.force_n[face_index, places]], axis=1)


def nearest_press(
    change: Float[np.ndarray, "n channel"],
    curve: Float[np.ndarray, "place knot channel"],
    force_n: Float[np.ndarray, "place knot"],
) -> tuple[Float[np.ndarray, "n"], Float[np.ndarray, "n"]]:
    """Force at the point of all the curves (straight between knots) nearest to each change, and the squared
    distance from it."""
    start, piece = curve[:, :-1], np.diff(curve, axis=1)
    length2 = np.maximum((piece**2).sum(axis=-1), 1e-12)
    force, squared = np.empty(len(change)), np.empty(len(change))
    for row, point in enumerate(change):
        # share of each straight piece at which it is nearest: (d − a)·(b − a) / |b − a|²
        share = np.clip(((point - start) * piece).sum(axis=-1) / length2, 0, 1)
        distance = ((point - start - share[..., None] * piece) ** 2).sum(axis=-1)
        place, knot = np.unravel_index(int(np.argmin(distance)), distance.shape)
        low, high = force_n[place, knot], force_n[place, knot + 1]
        force[row] = low + share[place, knot] * (high - low)
        squared[row] = distance[place, knot]
    return force, squared
