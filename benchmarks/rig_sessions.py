"""Recordings of a press rig at a hidden object, frame by frame, without machine and serial lines.

The object is drawn within tolerances, with a departure from small strain and a smooth error of the
mechanics of 2 %. Frames carry white noise, the whole session a random walk of drift, forces the load
cell's noise; every press is zeroed as `estimator.recordings` does it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.pressed_places import PressedPlaces, drift_rate, within_reach
from estimator.calibration.twin.unknowns import Unknowns
from estimator.frames.dataset import FrameSet
from estimator.frames.press_protocol import simulated_frames
from estimator.recordings.zeros import rest_levels
from estimator.signals.interpolation import Traces, counts_at_force, press_traces
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, PressForces
from instobj.rig.plan import PressPlan, PressSettings

TRUE_PRIOR = Prior(0.02, 10.0)
LEVELS_N = np.array([2.0, 4.0, 6.0, 8.0])
_AIR_S = 2.0
"""From the release of a press to the rest before the next one."""
_CONTACT_N = 0.3


@dataclass(frozen=True)
class HiddenObject:
    """Signals of one object on the lattice of one face, and which channels (flat) are the face's."""

    spec: ObjectSpec
    face: int
    signals: Signals
    own: Int[np.ndarray, "channel"]

    def traces(self, xy_mm: Float[np.ndarray, "press 2"]) -> Traces:
        found = press_traces(self.signals, np.full(len(xy_mm), self.face), *xy_mm.T)
        return found.of_channels(self.own)

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
    return replace(
        exact, signals=replace(signals, delta_counts=delta.reshape(signals.delta_counts.shape))
    )


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
    """What the plan's session shows, zeroed; frames beyond the twin's reach are invalid."""
    spec, rng, rate = (
        hidden.spec,
        np.random.default_rng([11, seed]),
        hidden.spec.sensors.frame_rate_hz,
    )
    places = np.array(plan.places_mm)
    traces, start_s = hidden.traces(places), 0.0
    parts: list[tuple[np.ndarray, ...]] = []
    for k in range(len(plan) + 1):
        rest = start_s + np.arange(0, plan.settings.rest_s, 1 / rate)
        quiet = np.zeros((len(rest), len(hidden.own)))
        parts.append((rest, np.full(len(rest), k), np.zeros(len(rest)), quiet))
        start_s = rest[-1] + plan.settings.approach_mm / plan.settings.speed_mm_s + 0.5
        if k < len(plan):
            after_s, force = _stroke(traces, k, plan.settings, rate, rng)
            held = counts_at_force(_of_press(traces, k), force[None], beyond="clamp").counts[0]
            parts.append((start_s + after_s, np.full(len(force), k), force, held))
            start_s += after_s[-1] + _AIR_S
    time_s, press, force, counts = (np.concatenate(columns) for columns in zip(*parts, strict=True))
    walk = np.sqrt(drift_rate(spec) * np.diff(time_s, prepend=0.0))[:, None]
    noise = np.tile(spec.sensors.noise_counts, spec.sensors.count_per_face)
    counts = counts + np.cumsum(walk * rng.standard_normal(counts.shape), axis=0)
    counts = np.round(counts + noise * rng.standard_normal(counts.shape))
    label = force + spec.protocol.force_noise_n * rng.standard_normal(len(force))
    resting = np.concatenate([np.full(len(part[0]), j % 2 == 0) for j, part in enumerate(parts)])
    shaped = counts.reshape(len(counts), 1, -1, 3)
    zeros = rest_levels(shaped, time_s, press, ~resting, resting)
    spread = noise.reshape(1, -1, 3)
    zero, span_s = zeros.bridged(press, time_s, np.zeros(len(press), int), spread)
    frames = _frames(hidden, shaped - zero, time_s, span_s, press, label, resting, places)
    return within_reach(frames, forces, hidden.face)


def _frames(
    hidden: HiddenObject,
    shaped: Float[np.ndarray, "frame 1 sensor 3"],
    time_s: Float[np.ndarray, "frame"],
    span_s: Float[np.ndarray, "frame 2"],
    press: Int[np.ndarray, "frame"],
    label: Float[np.ndarray, "frame"],
    resting: Bool[np.ndarray, "frame"],
    places: Float[np.ndarray, "press 2"],
) -> FrameSet:
    spec, contact = hidden.spec, ~resting & (label > _CONTACT_N)
    press, count = press[contact], int(contact.sum())
    readings = np.zeros((count, hidden.signals.baseline_counts.size))
    readings[:, hidden.own] = shaped[contact].reshape(count, -1)
    force = np.zeros((count, 1, 3))
    force[:, 0, 2] = label[contact]
    place = np.unique(places, axis=0, return_inverse=True)[1].ravel()
    frames = simulated_frames(
        spec, "hidden", readings, contact_face=np.full((count, 1), hidden.face),
        contact_xy_mm=places[press][:, None], force_n=force, valid=np.ones(count, bool),
        press_id=press, place_id=place[press], session_id=np.zeros(count, int),
    )  # fmt: skip
    return replace(frames, source="recorded", time_s=time_s[contact], zero_span_s=span_s[contact])


def _of_press(traces: Traces, k: int) -> Traces:
    part = slice(k, k + 1)
    return replace(traces, force_n=traces.force_n[part], counts=traces.counts[part],
                   corrected=traces.corrected[part])  # fmt: skip


def _stroke(
    traces: Traces, k: int, settings: PressSettings, rate_hz: float, rng: np.random.Generator
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Times (s) from the first touch on, and forces, of a press's frames."""
    time_s, depth = [0.0], [0.0]
    for stop in settings.depths_mm:
        down_s = time_s[-1] + (stop - depth[-1]) / settings.speed_mm_s
        time_s += [down_s, down_s + settings.dwell_s]
        depth += [stop, stop]
    at = np.arange(
        rng.uniform(0, 1 / rate_hz), time_s[-1] + depth[-1] / settings.speed_mm_s, 1 / rate_hz
    )
    held = np.interp(at, [*time_s, time_s[-1] + depth[-1] / settings.speed_mm_s], [*depth, 0.0])
    law = traces.force_n[k : k + 1, :, None]
    force = monotone_cubic(traces.depth_mm[None] ** 1.5, law, held[None] ** 1.5)[0, :, 0]
    full = np.flatnonzero(force >= settings.full_n)
    last = full[0] + 1 if len(full) else len(force)
    return at[:last], force[:last]
