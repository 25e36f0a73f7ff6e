"""Recordings that a bring-up asks for, one question each, and what comes back."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from estimator.signals.hall import full_scale_counts
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.asking.held_magnet import OVER_MM

Step = Literal["still", "held", "earth", "closed", "magnet", "rest"]
STEPS: dict[Step, str] = {
    "still": "chips, rates and noise",
    "held": "which channel is which",
    "earth": "Earth's field",
    "closed": "core closed",
    "magnet": "poles of the magnets",
    "rest": "resting levels",
}
STILL_S, HELD_S, STEP_S, POSE_S = 10.0, 4.0, 2.0, 20.0
"""Times of recordings: at rest, a held magnet, a magnet put in, a pose."""
STILL, STILL_AGAIN = "still", "still again"
POSES = (("+z", "+x"), ("-z", "+x"), ("+x", "+y"), ("-x", "+y"), ("+y", "+z"), ("-y", "+z"))
"""Axis of the object that points up, and the one that points away from the user."""
_FEWEST_FRAMES = 10
"""Frames of a recording that is asked for, at least."""


@dataclass(frozen=True)
class Question:
    """One recording: its name, the question, its frames; `part` counts hold places, poses or magnets."""

    name: str
    step: Step
    question: str
    frames: int
    part: int = 0


@dataclass(frozen=True)
class Recording:
    """Frames that answer one question, channels in the specification's order, NaN where silent.

    Attributes
    ----------
    counts : raw readings
    sequence, board_ms : the frames' own numbers and the board's clock
    damaged_lines, bus_errors : during this recording; None where the board does not tell
    """

    name: str
    counts: Float[np.ndarray, "frame sensor 3"]
    sequence: Int[np.ndarray, "frame"]
    board_ms: Int[np.ndarray, "frame"]
    damaged_lines: int = 0
    bus_errors: int | None = None

    @cached_property
    def mean(self) -> Float[np.ndarray, "sensor 3"]:
        """Mean counts; NaN where a channel misses a frame in ten or more."""
        has_reading = np.isfinite(self.counts)
        mean = np.where(has_reading, self.counts, 0).sum(axis=0) / np.maximum(
            has_reading.sum(axis=0), 1
        )
        return np.where(has_reading.mean(axis=0) > 0.9, mean, np.nan)

    def unsaturated(self, spec: ObjectSpec) -> Float[np.ndarray, "sensor 3"]:
        """Mean counts, NaN where any frame is at full scale."""
        with np.errstate(invalid="ignore"):
            full = (abs(self.counts) >= full_scale_counts(spec.sensors)).any(axis=0)
        return np.where(full, np.nan, self.mean)


Recordings = Mapping[str, Recording]


def require_bringup(spec: ObjectSpec) -> None:
    """Refuse objects that a bring-up does not serve.

    Raises
    ------
    InputError
        Sensors in the shell, or chips that measure fewer than three axes.
    """
    if spec.arrangement != "sensors-in-core":
        raise InputError(
            "bringup holds a magnet over chips in the core and watches magnets being put into the "
            f"shell; {spec.name} has arrangement = "
            f"{spec.arrangement!r}. Use `instobj bench selftest` for it"
        )
    if set(spec.sensors.axes) != set("XYZ"):
        raise InputError(
            f"bringup needs chips of three axes; sensors.axes = {list(spec.sensors.axes)}. Use "
            "`instobj bench selftest` for this object"
        )


def asked_of(spec: ObjectSpec) -> tuple[Question, ...]:
    """All recordings in their order: the bare core first, then the closed object.

    Earth's field comes before the magnets: without them the levels are the chips' own offsets.
    """
    require_bringup(spec)
    return (*_bare_core(spec), *_closed_object(spec))


def _frames(spec: ObjectSpec, seconds: float) -> int:
    return max(_FEWEST_FRAMES, round(seconds * spec.sensors.frame_rate_hz))


def _bare_core(spec: ObjectSpec) -> Iterator[Question]:
    frames = _frames(spec, HELD_S)
    yield Question(
        STILL,
        "still",
        "Stand the open core still, all magnets half a metre away. Touch nothing",
        _frames(spec, STILL_S),
    )
    for part, name in enumerate(sensor_names(sensor_layout(spec).face)):
        face, number = name[1:].split("-S")
        yield Question(
            f"held {name}",
            "held",
            f"Hold one {_kinds(spec)[0]}magnet about {OVER_MM:g} mm above face {face}, sensor {number}, "
            "its north pole towards the core, as still as you can",
            frames,
            part,
        )
    yield Question(
        STILL_AGAIN,
        "still",
        "Take the magnet half a metre away and touch nothing, as at first",
        _frames(spec, STILL_S),
        1,
    )
    for part, (up, front) in enumerate((*POSES, POSES[0])):
        again = " again, as at first" if part == len(POSES) else ""
        yield Question(
            f"earth {part + 1}",
            "earth",
            f"Take all magnets away. Lay the core with its {up} up and its {front} pointing away "
            f"from you{again}; always at one place, away from steel",
            _frames(spec, POSE_S),
            part,
        )


def _closed_object(spec: ObjectSpec) -> Iterator[Question]:
    frames = _frames(spec, STEP_S)
    yield Question(
        "closed", "closed", "Push the core into the shell; no magnet is in its pocket yet", frames
    )
    kinds = _kinds(spec)
    for part, name in enumerate(magnet_names(spec)):
        face, number = name[1:].split("-M")
        magnet = f"{kinds[int(number) - 1]}magnet"
        question = f"Put the {magnet} into pocket {number} of face {face}; then let go"
        yield Question(f"magnet {name}", "magnet", question, frames, part)
    yield Question(
        "rest",
        "rest",
        "Stand the object as it will be used, nothing touching it",
        _frames(spec, STILL_S),
    )


def _kinds(spec: ObjectSpec) -> list[str]:
    """Kind of every magnet of a face, where there are several kinds."""
    several = len(spec.magnets.numbers_by_kind) > 1
    return [f"{kind} " if several else "" for kind in spec.magnets.kinds]


def magnet_names(spec: ObjectSpec) -> list[str]:
    """F3-M2 is the second magnet of face 3."""
    return [name.replace("-S", "-M") for name in sensor_names(np.asarray(magnet_layout(spec).face))]
