"""Recipe of a simulated recording: which cases, how far, how often, how long."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.frames.contact_cases import ContactCase, random_case
from estimator.frames.contact_traces import (
    ContactTraces,
    JointMechanics,
    contact_traces,
    travel_at_force,
)
from estimator.frames.press_protocol import DRIFT_TIME_S, nominal_peaks
from estimator.frames.tangential import slope_traces
from estimator.information.shear import ShearSignals
from estimator.signals.interpolation import Traces
from estimator.signals.presses import Progress, Signals

_PHASES = (0.2, 0.35, 0.45, 0.65, 0.75, 0.9)
"""Phases of handling as shares of a grasp's frames: it is closed on, held, shaken, still, released, free."""
_SHAKE = 0.05
"""Phase by which a shake lets go and comes back: 2.5 % of the travel, 4 % of the force."""
_SHAKES = 3
"""Times that a held object is shaken."""
_LEAST_TRAVEL = 0.86
"""Least travel of a grasp over the largest: 80 % of the force, which goes with the power of 3/2."""
_PERIOD_SPREAD = 0.05
"""Periods differ by so much between cases, so that frames do not meet the same phases again."""


@dataclass(frozen=True)
class Pull:
    """Tangential force of each case as a share of its normal force, and counts per newton of it."""

    share: Float[np.ndarray, "case 2"]
    slopes: tuple[Traces, Traces]

    def select(self, part: slice) -> Pull:
        """That of some cases."""
        x, y = (
            replace(t, force_n=t.force_n[part], counts=t.counts[part], corrected=t.corrected[part])
            for t in self.slopes
        )
        return Pull(self.share[part], (x, y))


@dataclass(frozen=True)
class Recipe:
    """Cases to be recorded together and how each is driven; cases without contact come last.

    `pull` is None without tangential forces. `turns` (every, frame) is the phase of travel, rows
    beyond the cases are without contact; `moving` (frame,) marks frames after rest.
    """

    cases: Sequence[ContactCase]
    traces: ContactTraces
    pull: Pull | None
    peak_mm: Float[np.ndarray, "case"]
    turns: Float[np.ndarray, "every frame"]
    moving: Bool[np.ndarray, "frame"]


def periodic_recipe(
    spec: ObjectSpec,
    signals: Signals,
    cases: Sequence[ContactCase],
    mechanics: JointMechanics | None,
    rng: np.random.Generator,
    progress: Progress | None,
) -> Recipe:
    """Every case over and over: the paper's at one travel for all, grasps to one force."""
    frames, quiet = spec.collection.frames_per_case, spec.collection.non_contact_cases
    traces = contact_traces(spec, signals, cases, mechanics, progress)
    total = len(cases) + quiet
    period = spec.protocol.frames_per_press[1] * (
        1 + _PERIOD_SPREAD * rng.uniform(-1, 1, (total, 1))
    )
    turns = rng.uniform(0, 1, (total, 1)) + np.arange(frames) / period
    peak = peak_travel_mm(spec, signals, cases, traces)
    return Recipe(cases, traces, None, peak, turns, np.ones(frames, bool))


def handling_recipe(
    spec: ObjectSpec,
    signals: Signals,
    cases: Sequence[ContactCase],
    mechanics: JointMechanics | None,
    rng: np.random.Generator,
    progress: Progress | None,
) -> Recipe:
    """Every case once: free, closed on, held with a shake, released, free again."""
    frames, total = spec.collection.frames_per_case, len(cases) + spec.collection.non_contact_cases
    traces = contact_traces(spec, signals, cases, mechanics, progress)
    share = (np.arange(frames) + 0.5) / frames
    close, hold, shake, still, release, free = _PHASES
    # half a turn closes, the other half opens; a turn of 0 again is free
    turns = np.interp(share, [close, hold, release, free], [0.0, 0.5, 0.5, 1.0])
    swing = np.clip((share - shake) / (still - shake), 0.0, 1.0)
    turns += _SHAKE * np.sin(2 * np.pi * _SHAKES * swing)
    turns = np.where(share < free, turns, 0.0)
    peak = peak_travel_mm(spec, signals, cases, traces)
    peak = peak * rng.uniform(_LEAST_TRAVEL, 1.0, len(cases))
    touched = (share > close) & (share < free)
    return Recipe(cases, traces, None, peak, np.tile(turns, (total, 1)), touched)


def peak_travel_mm(
    spec: ObjectSpec, signals: Signals, cases: Sequence[ContactCase], traces: ContactTraces
) -> Float[np.ndarray, "case"]:
    """Height of the periodic travel: the paper's common one, or that of the grasps' force."""
    deepest = traces.travel_mm[:, -1]
    if cases[0].squeezed:
        return deepest
    if spec.collection.kind != "paper":  # a pad presses from one side, with the grasps' force
        force = np.full((len(cases), 1), spec.collection.grasp_force_n)
        return travel_at_force(traces, force)[:, 0]
    return np.minimum(nominal_peaks(spec, signals).common_travel_mm, deepest)


def drift_rms_counts(spec: ObjectSpec) -> float:
    """Drift of a case since its zeroing, rms over its frames."""
    seconds = spec.collection.frames_per_case / spec.sensors.frame_rate_hz
    return spec.sensors.drift_counts * float(np.sqrt(seconds / 2 / DRIFT_TIME_S))


def scattered_recipe(
    spec: ObjectSpec,
    signals: Signals,
    mechanics: JointMechanics | None,
    rng: np.random.Generator,
    progress: Progress | None,
    shear: ShearSignals | None,
) -> Recipe:
    """One press at each of many places, after some frames at rest."""
    collection, protocol = spec.collection, spec.protocol
    cases = [
        random_case(spec, rng, number, collection.contacts) for number in range(collection.presses)
    ]
    traces = contact_traces(spec, signals, cases, mechanics, progress)
    wanted = collection.contacts * rng.uniform(*protocol.peak_force_n, (len(cases), 1))
    peak = travel_at_force(traces, wanted)[:, 0]
    rest, frames = protocol.frames_per_press
    turns = (rng.uniform(0, 1, (len(cases), 1)) + np.arange(frames)) / frames
    turns = np.concatenate([np.zeros((len(cases), rest)), turns], axis=1)
    pull = pull_of(spec, signals, cases, shear, rng) if collection.tangential_share else None
    return Recipe(cases, traces, pull, peak, turns, np.arange(rest + frames) >= rest)


def pull_of(
    spec: ObjectSpec,
    signals: Signals,
    cases: Sequence[ContactCase],
    shear: ShearSignals | None,
    rng: np.random.Generator,
) -> Pull:
    """Every case in its own direction, by its own share up to the largest asked for."""
    if shear is None:
        raise InputError(
            "collection.tangential_share needs the signals of tangential forces. Run `instobj "
            "run SPEC --to frames`, which simulates them, or set it to 0"
        )
    angle, size = rng.uniform(0, [2 * np.pi, spec.collection.tangential_share], (len(cases), 2)).T
    share = size[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    face = np.array([case.face[0] for case in cases])
    xy = np.array([case.xy_mm[0] for case in cases])
    return Pull(share, slope_traces(spec, signals, shear, face, xy))
