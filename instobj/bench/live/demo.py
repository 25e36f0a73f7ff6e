"""A simulated object in a hand, and its board: lines at 200 Hz without hardware.

The object is drawn within the specification's tolerances, so the design's estimator does not know it
exactly; a hand touches, grasps and slides over it, again and again. Counts are those of the forward
model of the drawn object (single presses by its own table, the exact field of summed motions), with
the chips' white noise and nothing else: no drift, no hysteresis, no field of the surroundings.
"""

from __future__ import annotations

import time
from collections.abc import Generator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.spec.object import ObjectSpec
from estimator.inversion.model.forward import NONE, ContactModel, contact_model
from estimator.recordings.boards.lines import Load, encode_frame, encode_header, encode_load
from fem.presses.results import MagnetMotions, PressForces

RATE_HZ = 200
CELLS = 3
"""Contacts at most; each has its true force and place as the lines of a load cell."""
_KNOTS_HZ = 40
_CYCLE_S = 24.0
_LOADS_EVERY = 5
_SLICE_S = 0.01
_OBJECT_SEED = 7
_BEHIND_S = 0.5
"""A board that is this late leaves frames out: they are lost, as on a real line."""


@dataclass(frozen=True)
class SimulatedHand:
    """One cycle of touches, sampled at 40 Hz: faces' indices (`NONE`: no contact), x, y (mm) and
    force (N) of each contact, and the expected raw counts."""

    faces: Int[np.ndarray, "face"]
    face: Int[np.ndarray, "knot contact"]
    contact: Float[np.ndarray, "knot contact 3"]
    counts: Float[np.ndarray, "knot channel"]
    noise_counts: Float[np.ndarray, "channel"]


def simulated_hand(spec: ObjectSpec, forces: PressForces, motions: MagnetMotions) -> SimulatedHand:
    """A drawn object and what a hand does to it; places and forces stay within the table."""
    from estimator.tolerances.virtual_object import drawn_assembly, twin_signals

    signals = twin_signals(spec, drawn_assembly(spec, spec.seed + _OBJECT_SEED), forces, motions)
    model = contact_model(spec, forces, motions, signals)
    face, contact = touches(model)
    expected = model.singles(face, contact)[:, :, 0].sum(axis=1) + model.interaction(face, contact)
    noise = np.tile(np.asarray(spec.sensors.noise_counts, float), model.channels // 3)
    return SimulatedHand(
        model.signals.faces, face, contact, expected + signals.baseline_counts.ravel(), noise
    )


def touches(
    model: ContactModel,
) -> tuple[Int[np.ndarray, "knot contact"], Float[np.ndarray, "knot contact 3"]]:
    """Faces' indices and contacts of one cycle.

    Rest for 3 s; a finger presses face 1 and circles on it; two fingers grasp across the object and
    slide; then three hold it, one of them tapping.
    """
    s = np.arange(int(_CYCLE_S * _KNOTS_HZ)) / _KNOTS_HZ
    (low, high), faces = model.bounds, len(model.signals.faces)
    reach, most = 0.62 * float(min(*high[:2], *-low[:2])), 0.6 * float(high[2])
    first, second, third = 0, min(2, faces - 1), faces - 1
    angle = 2 * np.pi * s / 5
    nothing = np.zeros_like(s)
    plan = (
        (first, _held(s, 3.0, 9.0), reach * np.cos(angle), reach * np.sin(angle), most),
        (
            second,
            _held(s, 10.5, 22.5),
            reach * np.sin(angle / 2),
            0.4 * reach + nothing,
            0.8 * most,
        ),
        (third, _held(s, 10.5, 16.0), -reach * np.sin(angle / 2), nothing, 0.8 * most),
        (third, _held(s, 17.0, 22.5), 0.5 * reach + nothing, -reach * np.cos(angle / 3), most),
        (first, _taps(s, 17.5, 22.0), -0.5 * reach + nothing, 0.5 * reach + nothing, 0.7 * most),
    )
    face = np.full((len(s), len(plan)), NONE)
    contact = np.zeros((len(s), len(plan), 3))
    for slot, (number, share, x, y, peak_n) in enumerate(plan):
        pressed = share > 0.02
        face[pressed, slot] = number
        contact[pressed, slot] = np.stack([x, y, peak_n * share], axis=1)[pressed]
    return face, contact


def _held(s: np.ndarray, begins: float, ends: float) -> np.ndarray:
    """Share of the peak force: up within a second, a little unsteady, down within a second."""
    rise = np.clip(np.minimum(s - begins, ends - s), 0.0, 1.0)
    return np.sin(np.pi / 2 * rise) ** 2 * (0.85 + 0.15 * np.sin(2 * np.pi * s / 1.7))


def _taps(s: np.ndarray, begins: float, ends: float) -> np.ndarray:
    """Five presses, one after the other."""
    inside = (s > begins) & (s < ends)
    return np.where(inside, np.maximum(0.0, np.sin(10 * np.pi * (s - begins) / (ends - begins))), 0)


def hand_chunks(hand: SimulatedHand, names: list[str], seed: int) -> Generator[bytes]:
    """Lines of the simulated board, without end, in real time."""
    rng, started, k = np.random.default_rng(seed), time.monotonic(), 0
    yield encode_header(names)
    while True:
        due = int((time.monotonic() - started) * RATE_HZ)
        k = max(k, due - int(_BEHIND_S * RATE_HZ))
        yield b"".join(hand_lines(hand, number, rng) for number in range(k, due + 1))
        k = due + 1
        time.sleep(_SLICE_S)


def hand_lines(hand: SimulatedHand, number: int, rng: np.random.Generator) -> bytes:
    """A frame between two knots, with noise; every fifth is preceded by the true contacts."""
    position = number / RATE_HZ * _KNOTS_HZ % len(hand.counts)
    knot, share = int(position), position % 1
    after = (knot + 1) % len(hand.counts)
    expected = (1 - share) * hand.counts[knot] + share * hand.counts[after]
    counts = np.round(expected + hand.noise_counts * rng.standard_normal(len(expected)))
    ms = round(1000 * number / RATE_HZ)
    loads = b"" if number % _LOADS_EVERY else b"".join(_loads(hand, knot, ms))
    return loads + encode_frame(number, ms, counts.tolist())


def _loads(hand: SimulatedHand, knot: int, ms: int) -> list[bytes]:
    slots = np.flatnonzero(hand.face[knot] != NONE)[:CELLS].tolist()
    lines = []
    for cell in range(CELLS):
        if cell >= len(slots):
            lines.append(encode_load(Load(ms, cell + 1, 0.0, 0, ())))
            continue
        x, y, force_n = hand.contact[knot, slots[cell]].tolist()
        face = int(hand.faces[hand.face[knot, slots[cell]]])
        lines.append(encode_load(Load(ms, cell + 1, force_n, face, ((x, y),))))
    return lines
