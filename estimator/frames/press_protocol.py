"""Simulated calibration presses: the frames that a recording of the protocol would hold.

All places are pressed by one common travel, so their peak forces differ, as on the machine of
Knopke et al. (RA-L 2024). Each press has its own place jitter, peak force, zeroing error and
drift; each frame its own noise, rounding and clipping.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, face_rows
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.information.scores import fill_places
from estimator.signals.hall import read_out
from estimator.signals.interpolation import (
    Traces,
    counts_at_force,
    depth_at_force,
    force_at_depth,
    press_traces,
)
from estimator.signals.presses import Progress, Signals
from fem.presses.viscoelastic import relaxed_force_n

REST_PLACE_ID = -1
PLACE_ID_STRIDE = 1000
"""`place_id` of a contact frame = place + 1000 · face."""
DRIFT_TIME_S = 900.0
"""The rms drift of a channel, `sensors.drift_counts`, is that after 15 minutes."""
PEAK_FORCE_SPREAD = 0.1
"""Share by which peak forces vary from press to press at one place, either way: an estimate."""
LEAST_FORCE_NOISES = 2.5
"""Contact frames labelled below this many `force_noise_n` are invalid: neither contact nor rest."""


@dataclass(frozen=True)
class NominalPeaks:
    """Peak force of each place, at one common travel, before each press varies it.

    Attributes
    ----------
    common_travel_mm : travel at which the median place reaches the middle of `peak_force_n`
    force_n : (face, place) force there, clipped into `peak_force_n` and to what is reachable
    depth_mm : (face, place) travel that the peak takes
    clamped : (face, place) whether the deepest simulated press stays below the wanted peak

    NaN, and not clamped, at places that a face has not.
    """

    common_travel_mm: float
    force_n: Float[np.ndarray, "face place"]
    depth_mm: Float[np.ndarray, "face place"]
    clamped: Bool[np.ndarray, "face place"]


@dataclass(frozen=True)
class PressPlan:
    """Presses in the order in which they are made: repetition, face, place.

    `x_mm`, `y_mm` are where the tip lands; the label is the place's nominal position. `clamped`
    marks presses whose wanted peak exceeds what the deepest simulated press reaches there.
    """

    repetition: Int[np.ndarray, "press"]
    face: Int[np.ndarray, "press"]
    place: Int[np.ndarray, "press"]
    x_mm: Float[np.ndarray, "press"]
    y_mm: Float[np.ndarray, "press"]
    peak_force_n: Float[np.ndarray, "press"]
    clamped: Bool[np.ndarray, "press"]

    def summary(self) -> dict[str, int | float]:
        """Numbers for a report: presses, how many were clamped, and the range of peaks (N)."""
        return {
            "presses": len(self.face),
            "clamped_presses": int(self.clamped.sum()),
            "lowest_peak_n": float(self.peak_force_n.min()),
            "highest_peak_n": float(self.peak_force_n.max()),
        }


def nominal_peaks(spec: ObjectSpec, signals: Signals) -> NominalPeaks:
    """The protocol's peak forces over the contact grid."""
    places = contact_places(spec)[face_rows(spec, signals.faces)]
    face_index, place = np.nonzero(places)
    x, y = contact_grid(spec).xy_mm[place].T
    traces = press_traces(signals, signals.faces[face_index], x, y)
    low, high = spec.protocol.peak_force_n
    travel = _common_travel_mm(traces, (low + high) / 2)
    wanted = np.clip(force_at_depth(traces, travel), low, high)
    force = np.minimum(wanted, traces.force_n[:, -1])
    values = force, depth_at_force(traces, force[:, None])[:, 0], wanted > force
    return NominalPeaks(travel, *(fill_places(places, [value]) for value in values))


def _common_travel_mm(traces: Traces, median_force_n: float) -> float:
    from scipy.optimize import brentq

    def excess(depth_mm: float) -> float:
        return float(np.median(force_at_depth(traces, depth_mm))) - median_force_n

    deepest = float(traces.depth_mm[-1])
    if excess(deepest) <= 0:
        return deepest
    root: Any = brentq(excess, 0.0, deepest, xtol=1e-6)
    return float(root)


def plan_presses(spec: ObjectSpec, signals: Signals) -> PressPlan:
    """Return where and how hard each press of `simulate_presses` goes; fixed by `spec.seed`."""
    rng = np.random.default_rng((spec.seed, 1))
    protocol, peaks, grid = spec.protocol, nominal_peaks(spec, signals), contact_grid(spec)
    shape = (protocol.presses_per_place, *peaks.force_n.shape)
    places = contact_places(spec)[face_rows(spec, signals.faces)]
    repetition, face_index, place = np.nonzero(np.broadcast_to(places, shape))
    face = signals.faces[face_index]
    jitter = rng.uniform(-1, 1, (len(face), 2)) * protocol.lateral_jitter_mm
    x, y = (grid.xy_mm[place] + jitter).T
    spread = 1 + PEAK_FORCE_SPREAD * rng.uniform(-1, 1, len(face))
    wanted = peaks.force_n[face_index, place] * spread
    reach = press_traces(signals, face, x, y).force_n[:, -1]
    clamped = (wanted > reach) | peaks.clamped[face_index, place]
    return PressPlan(repetition, face, place, x, y, np.minimum(wanted, reach), clamped)


def simulate_presses(
    spec: ObjectSpec, signals: Signals, spec_hash: str, progress: Progress | None = None
) -> FrameSet:
    """Frames of the whole protocol: for each press rest frames, then one rise and fall of force.

    The force is a raised cosine, sampled at a random phase within the frame interval. With
    `silicone.prony` that is the force by the instantaneous modulus at each travel: signals
    follow the travel, the labelled force relaxes and is lower, more so while unloading. The zeroing
    error of a press and its drift since are common to its rest and contact frames. Labels: the
    place's nominal position; the force with the load cell's noise. Repetitions are sessions.
    Peaks beyond the deepest simulated press are clamped to it (`plan_presses` counts them).
    """
    plan = plan_presses(spec, signals)
    rng = np.random.default_rng((spec.seed, 2))
    rest, moving = spec.protocol.frames_per_press
    force, prony = _press_forces(spec, plan, rng), spec.silicone.prony
    readings = np.empty((len(plan.face), rest + moving, signals.baseline_counts.size))
    block = max(1, len(plan.face) // spec.protocol.presses_per_place // 5)
    for start in range(0, len(plan.face), block):
        part = slice(start, start + block)
        traces = press_traces(signals, plan.face[part], plan.x_mm[part], plan.y_mm[part])
        readings[part, :rest] = 0.0
        readings[part, rest:] = counts_at_force(traces, force[part, rest:]).counts
        readings[part] = disturbed(spec, signals, readings[part], rng)
        if progress is not None:
            progress(f"{min(start + block, len(plan.face))} of {len(plan.face)} presses")
    force = relaxed_force_n(force, np.arange(rest + moving) / spec.sensors.frame_rate_hz, prony)
    return _labelled(spec, plan, force, readings, rng, spec_hash)


def _press_forces(
    spec: ObjectSpec, plan: PressPlan, rng: np.random.Generator
) -> Float[np.ndarray, "press frame"]:
    """Force (N) of each frame without relaxation, 0 in the rest frames that come first."""
    resting, moving = spec.protocol.frames_per_press
    phase = 2 * np.pi * (np.arange(moving) + rng.uniform(0, 1, (len(plan.face), 1))) / moving
    force = plan.peak_force_n[:, None] * (1 - np.cos(phase)) / 2
    rest = np.zeros((len(plan.face), resting))
    return np.concatenate([rest, force], axis=1)


def disturbed(
    spec: ObjectSpec,
    signals: Signals,
    delta: Float[np.ndarray, "press frame channel"],
    rng: np.random.Generator,
) -> Float[np.ndarray, "press frame channel"]:
    """Readings less the baseline: zeroing error, random-walk drift, noise, rounding, clipping."""
    sensors = spec.sensors
    presses, _, channels = delta.shape
    step = sensors.drift_counts / np.sqrt(DRIFT_TIME_S * sensors.frame_rate_hz)
    offset = rng.standard_normal((presses, 1, channels)) * sensors.zeroing_counts
    drift = np.cumsum(rng.standard_normal(delta.shape) * step, axis=1)
    baseline = signals.baseline_counts.ravel()
    expected = (baseline + delta + offset + drift).reshape(-1, channels // 3, 3)
    return read_out(expected, sensors, rng).reshape(delta.shape) - baseline


def with_nuisances(
    frames: FrameSet, columns: Float[np.ndarray, "face sensor 3 k"], seed: int
) -> FrameSet:
    """Return frames with nuisances since the zero (`estimator.signals.nuisances`) drawn for every press;
    what a network sees as further faces, its changes over time, feels none."""
    rng = np.random.default_rng(seed)
    press, index = np.unique(frames.press_id, return_inverse=True)
    unknowns = rng.standard_normal((len(press), columns.shape[3]))[index]
    counts = frames.signal_counts.copy()
    # n frame, k nuisance; f face, s sensor, a axis
    counts[:, : len(columns)] += np.einsum("nk,fsak->nfsa", unknowns, columns)
    return replace(frames, signal_counts=counts)


def _labelled(
    spec: ObjectSpec,
    plan: PressPlan,
    force: Float[np.ndarray, "press frame"],
    readings: Float[np.ndarray, "press frame channel"],
    rng: np.random.Generator,
    spec_hash: str,
) -> FrameSet:
    presses, frames = force.shape
    grid, noise = contact_grid(spec), spec.protocol.force_noise_n
    contact = np.arange(frames) >= spec.protocol.frames_per_press[0]
    contact = np.broadcast_to(contact, force.shape)
    label = force + rng.standard_normal(force.shape) * noise
    place_id = (plan.place + PLACE_ID_STRIDE * plan.face)[:, None]
    xy = np.where(contact[..., None], grid.xy_mm[plan.place][:, None], np.nan)
    zero = np.where(contact, 0.0, np.nan)
    forces = np.stack([zero, zero, np.where(contact, label, np.nan)], axis=-1)
    count = presses * frames
    return simulated_frames(
        spec,
        spec_hash,
        readings,
        contact_face=np.where(contact, plan.face[:, None], NO_FACE).reshape(count, 1),
        contact_xy_mm=xy.reshape(count, 1, 2),
        force_n=forces.reshape(count, 1, 3),
        valid=(~contact | (label > LEAST_FORCE_NOISES * noise)).ravel(),
        press_id=np.repeat(np.arange(presses), frames),
        place_id=np.where(contact, place_id, REST_PLACE_ID).ravel(),
        session_id=np.repeat(plan.repetition, frames),
    )


def simulated_frames(
    spec: ObjectSpec,
    spec_hash: str,
    readings: Float[np.ndarray, "every frame channel"],
    **labels: Any,
) -> FrameSet:
    """Readings (counts against rest) of every stretch of frames in a row, with their labels.

    Dead channels read NaN; `labels` are the arrays of `FrameSet` that have one row per frame.
    """
    shape = (len(spec.body.sensed), spec.sensors.count_per_face, 3)
    signal = readings.reshape(-1, *shape)
    grid = contact_grid(spec)
    return FrameSet(
        signal_counts=np.where(live_channels(spec).reshape(shape), signal, np.nan),
        time_s=np.arange(len(signal)) / spec.sensors.frame_rate_hz,
        faces=np.array(spec.body.sensed),
        grid_x_mm=grid.x_mm,
        grid_y_mm=grid.y_mm,
        noise_counts=np.asarray(spec.sensors.noise_counts, float),
        source="simulated",
        spec_hash=spec_hash,
        seed=spec.seed,
        **labels,
    )
