"""Recordings of a press rig at a hidden object, frame by frame, without machine and serial lines.

The object is drawn within tolerances, with a departure from small strain and a smooth error of the
mechanics of 2 %. Frames carry white noise, the whole session a random walk of drift, forces the load
cell's noise; levels under presses are taken off as `estimator.recordings` does it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.pressed_places import (
    PressedPlaces,
    drift_rate,
    invalidate_hard_presses,
)
from estimator.calibration.twin.unknowns import Unknowns
from estimator.frames.dataset import FrameSet
from estimator.frames.press_protocol import simulated_frames
from estimator.recordings.drift import levels_under_presses
from estimator.signals.interpolation import Traces, counts_at_force, press_traces
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, PressForces
from instobj.bench.rig.plan import PressPlan, PressSettings

TRUE_PRIOR = Prior(0.02, 10.0)
LEVELS_N = np.array([2.0, 4.0, 6.0, 8.0])
_AIR_S = 2.0
"""From the release of a press to the rest before the next one; frames are recorded all the time."""
_CONTACT_N = 0.3
_RAPID_MM_S = 50.0


@dataclass(frozen=True)
class HiddenObject:
    """Signals of one object on the lattice of one face, and which channels (flat) are the face's."""

    spec: ObjectSpec
    face: int
    signals: Signals
    own: Int[np.ndarray, "channel"]

    def traces(self, xy_mm: Float[np.ndarray, "press 2"]) -> Traces:
        found = press_traces(self.signals, np.full(len(xy_mm), self.face), *xy_mm.T)
        return found.select_channels(self.own)

    def counts(
        self, xy_mm: Float[np.ndarray, "place 2"]
    ) -> Float[np.ndarray, "place level channel"]:
        """At `LEVELS_N`."""
        levels = np.tile(LEVELS_N, (len(xy_mm), 1))
        return counts_at_force(self.traces(xy_mm), levels, beyond="clamp").counts


def hidden_object(
    spec: ObjectSpec, presses: tuple[PressForces, MagnetMotions], face: int, seed: int
) -> HiddenObject:
    """The object of that seed."""
    forces, motions = presses
    mine = motions.faces == face
    table = (
        replace(forces, faces=forces.faces[mine], force_n=forces.force_n[mine],
                contact_area_mm2=forces.contact_area_mm2[mine]),
        replace(motions, faces=motions.faces[mine], motion=motions.motion[mine]),
    )  # fmt: skip
    unknowns, rng = Unknowns(spec, (face,)), np.random.default_rng([7, seed])
    signals = None
    while signals is None:
        signals = unknowns.signals(rng.standard_normal(len(unknowns)), *table)
    own = np.flatnonzero(np.repeat(unknowns.design.scene.sensors.face == face, 3))
    exact = HiddenObject(spec, face, signals, own)
    there = signals.pressed[0]
    xy, force = signals.lattice.xy_mm[there], signals.force_n[0, there]
    scale = np.sqrt(np.mean(exact.counts(contact_grid(spec).xy_mm) ** 2, axis=(0, 1)))
    smooth = _smooth_fields(spec, face, xy, len(own), rng) * scale
    share = (force / 10.0)[..., None]
    delta = signals.delta_counts.reshape(*signals.force_n.shape, -1).copy()
    pressed = delta[0, there]
    pressed[..., own] += share * smooth[0][:, None] + share**2 * smooth[1][:, None]
    delta[0, there] = pressed
    held = replace(signals, delta_counts=delta.reshape(signals.delta_counts.shape))
    return replace(exact, signals=held)


def _smooth_fields(
    spec: ObjectSpec,
    face: int,
    xy: Float[np.ndarray, "place 2"],
    channels: int,
    rng: np.random.Generator,
) -> Float[np.ndarray, "2 place channel"]:
    """Draws of the process of `discrepancy`, of its two parts, for channels of scale 1."""
    one = np.ones((len(xy), 1))
    at = PressedPlaces(
        face, np.arange(1), xy, 10 * one, one[..., None], one.astype(int), one[..., None]
    )
    process = Discrepancy(spec, TRUE_PRIOR, at).covariance(xy, 10 * one)[0] / 2
    root = np.linalg.cholesky(process + 1e-9 * np.eye(len(xy)))
    return root @ rng.standard_normal((2, len(xy), channels))


def recorded(hidden: HiddenObject, plan: PressPlan, forces: PressForces, seed: int) -> FrameSet:
    """Return what the plan's session shows, zeroed; frames beyond the twin's reach are invalid."""
    spec, rng = hidden.spec, np.random.default_rng([11, seed])
    places = np.array(plan.places_mm)
    time_s, number, force, counts = _session(hidden, plan, rng)
    walk = np.sqrt(drift_rate(spec) * np.diff(time_s, prepend=0.0))[:, None]
    noise = np.tile(spec.sensors.noise_counts, spec.sensors.count_per_face)
    counts = counts + np.cumsum(walk * rng.standard_normal(counts.shape), axis=0)
    counts = np.round(counts + noise * rng.standard_normal(counts.shape))
    label = force + spec.protocol.force_noise_n * rng.standard_normal(len(force))
    resting = force <= 0
    shaped = np.zeros((len(counts), 5, spec.sensors.count_per_face, 3))
    shaped[:, hidden.face - 1] = counts.reshape(len(counts), -1, 3)
    spread = np.zeros(shaped.shape[1:])
    spread[hidden.face - 1] = noise.reshape(-1, 3)
    shaped[:, np.arange(5) != hidden.face - 1] = np.nan
    levels = levels_under_presses(
        shaped, time_s, np.zeros(len(time_s), int), ~resting, resting, spread
    )
    load = np.cumsum(np.diff(resting.astype(int), prepend=1) < 0)
    signals = (shaped - levels.counts)[:, hidden.face - 1]
    used = ~resting & (label > _CONTACT_N)
    readings = np.zeros((int(used.sum()), hidden.signals.baseline_counts.size))
    readings[:, hidden.own] = signals[used].reshape(len(readings), -1)
    force_n = np.zeros((len(readings), 1, 3))
    force_n[:, 0, 2] = label[used]
    place = np.unique(places, axis=0, return_inverse=True)[1].ravel()
    frames = simulated_frames(
        spec, "hidden", readings[None], contact_face=np.full((len(readings), 1), hidden.face),
        contact_xy_mm=places[number[used]][:, None], force_n=force_n,
        valid=np.ones(len(readings), bool), press_id=load[used], place_id=place[number[used]],
        session_id=np.zeros(len(readings), int),
    )  # fmt: skip
    frames = replace(frames, source="recorded", time_s=time_s[used], zero_error=levels.error[used])
    return invalidate_hard_presses(frames, forces, hidden.face)


def _session(
    hidden: HiddenObject, plan: PressPlan, rng: np.random.Generator
) -> tuple[
    Float[np.ndarray, "frame"],
    Int[np.ndarray, "frame"],
    Float[np.ndarray, "frame"],
    Float[np.ndarray, "frame channel"],
]:
    """Times (s), numbers of presses, forces (N) and counts, without noise and drift."""
    one, rate = plan.settings, hidden.spec.sensors.frame_rate_hz
    traces, start_s = hidden.traces(np.array(plan.places_mm)), 0.0
    parts: list[tuple[np.ndarray, ...]] = []
    for k in range(len(plan) + 1):
        air_s = _AIR_S + one.rest_s + one.approach_mm / one.speed_mm_s
        rest = start_s + np.arange(0, air_s, 1 / rate)
        quiet = np.zeros((len(rest), len(hidden.own)))
        parts.append((rest, np.full(len(rest), k), np.zeros(len(rest)), quiet))
        start_s += air_s
        if k < len(plan):
            after_s, force = _press(traces, k, one, rate, rng)
            held = counts_at_force(_of_press(traces, k), force[None], beyond="clamp").counts[0]
            held[force <= 0] = 0.0
            parts.append((start_s + after_s, np.full(len(force), k), force, held))
            start_s += after_s[-1]
    time_s, number, force, counts = (
        np.concatenate(columns) for columns in zip(*parts, strict=True)
    )
    return time_s, number, force, counts


def _of_press(traces: Traces, k: int) -> Traces:
    part = slice(k, k + 1)
    return replace(traces, force_n=traces.force_n[part], counts=traces.counts[part],
                   corrected=traces.corrected[part])  # fmt: skip


def _press(
    traces: Traces, k: int, settings: PressSettings, rate_hz: float, rng: np.random.Generator
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Times (s) from the first touch on, and forces, of a press's frames."""
    law = traces.force_n[k : k + 1, :, None]

    def force_at(depth_mm: Float[np.ndarray, "_"]) -> Float[np.ndarray, "_"]:
        held = np.maximum(depth_mm, 0.0) ** 1.5
        return monotone_cubic(traces.depth_mm[None] ** 1.5, law, held[None])[0, :, 0]

    deep = np.linspace(0, settings.depths_mm[-1], 500)
    full = np.flatnonzero(force_at(deep) >= settings.full_n)
    time_s, depth = _way(settings, float(deep[full[0]]) if len(full) else np.inf)
    at = np.arange(rng.uniform(0, 1 / rate_hz), time_s[-1], 1 / rate_hz)
    force = force_at(np.interp(at, time_s, depth))
    return at, np.where(np.interp(at, time_s, depth) > 0, force, 0.0)


def _way(one: PressSettings, full_mm: float) -> tuple[list[float], list[float]]:
    """Times (s) and depths (mm) of a press of which a stroke ends where the full force is met."""
    time_s, depth = [0.0], [0.0]

    def go(to_mm: float, speed_mm_s: float, stay_s: float = 0.0) -> None:
        time_s.append(time_s[-1] + abs(to_mm - depth[-1]) / speed_mm_s)
        time_s.append(time_s[-1] + stay_s)
        depth.extend([to_mm, to_mm])

    speed, met = one.speed_mm_s, False
    for stroke in range(one.strokes):
        for stop in one.settings_after_full(full_mm, 1).depths_mm if met else one.depths_mm:
            met = met or stop >= full_mm
            go(min(stop, full_mm), speed, 0.0 if stop >= full_mm else one.dwell_s)
            if stop >= full_mm:
                break
        if one.strokes == 1 and not met:
            go(0.0, speed)
        elif stroke < one.strokes - 1:
            go(-one.lift_mm, _RAPID_MM_S, one.pause_s)
        speed = one.stroke_speed_mm_s
    return time_s, depth
