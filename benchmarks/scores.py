"""Time of signals, sensitivity and bounds of a whole object against SciPy's exact convex hull.

    python benchmarks/scores.py [--quick] [--out FOLDER]

The object has 5 faces × 100 places × 20 depths and 45 channels. Forces and motions are made up and
smooth; what they are does not change the work. Times are processor time on one thread, the least of
several runs. Writes `scores.json`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from harness import best_seconds, machine, run
from scipy.spatial import ConvexHull

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid, grid_places_in_lattice, press_lattice
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from estimator.information.scores import score_places
from estimator.information.sensitivity import (
    channel_noise,
    covariance_sensitivity,
    own_channels,
    periodic_press,
)
from estimator.signals.interpolation import press_traces
from estimator.signals.presses import Signals, press_signals
from fem.presses.results import MagnetMotions, PressForces

SIGNALS_TARGET_S, SCORES_TARGET_S, HULL_TARGET = 0.5, 1.0, 1000.0
PLACES = 500


def made_up_presses(spec: ObjectSpec) -> tuple[PressForces, MagnetMotions]:
    """Magnets within some millimetres of a press go down, aside and tilt in proportion to depth."""
    lattice, depth = press_lattice(spec), np.asarray(spec.press.depths_mm)
    magnets, frames = magnet_layout(spec), face_frames(spec)
    motion = np.zeros((len(frames), len(lattice), len(depth), len(magnets.face), 6))
    for index, frame in enumerate(frames):
        local = frame.from_object(magnets.centre_mm)
        away = local[:, :2] - lattice.xy_mm[:, None]
        near = np.exp(-np.sum(away**2, -1) / 60) * np.exp((local[:, 2] + 2.5) / 9)
        shift = np.concatenate([0.05 * away, np.full((*near.shape, 1), -0.35)], -1) @ frame.axes.T
        tilt = np.concatenate([-0.01 * away[..., 1:], 0.01 * away[..., :1], 0 * away[..., :1]], -1)
        unit = near[..., None] * np.concatenate([shift, tilt @ frame.axes.T], -1)
        motion[index] = depth[:, None, None] * unit[:, None]
    force = np.broadcast_to(1.7 * depth**1.5, motion.shape[:3]).copy()
    faces = np.array([frame.number for frame in frames])
    return PressForces(faces, lattice, depth, force, force), MagnetMotions(
        faces, lattice, depth, motion
    )


def on_the_contact_grid(
    presses: tuple[PressForces, MagnetMotions], spec: ObjectSpec
) -> tuple[PressForces, MagnetMotions]:
    """Presses at the 100 contact locations of every face alone."""
    (forces, motions), places = presses, grid_places_in_lattice(spec)
    shared = (forces.faces, contact_grid(spec), forces.depth_mm)
    force = forces.force_n[:, places]
    return PressForces(*shared, force, force), MagnetMotions(*shared, motions.motion[:, places])


def hull_seconds(spec: ObjectSpec, signals: Signals, quick: bool) -> dict[str, Any]:
    """One place's δ: exact hull, and the covariance equivalent of a face's places."""
    frames, places = (40, 1) if quick else (100, 3)
    grid = signals.lattice.xy_mm[:: len(signals.lattice) // 99][:100]
    traces = press_traces(signals, np.full(len(grid), 3), grid[:, 0], grid[:, 1])
    traces = traces.select_channels(own_channels(signals, spec.sensors, 3))
    noise = channel_noise(spec.sensors, 9)
    force = np.full(len(grid), spec.score.force_n)
    rng = np.random.default_rng(1)

    def noisy(count: int) -> np.ndarray:
        press = periodic_press(traces, force, count)[:: len(grid) // places][:places]
        return (press + noise * rng.standard_normal(press.shape)) / noise

    few = noisy(frames)
    exact = best_seconds(lambda: [ConvexHull(f).volume for f in few], 1) / places

    def equivalent() -> None:
        covariance_sensitivity(periodic_press(traces, force, 64), force, noise, frames)

    return {
        "frames": frames,
        "exact_s_per_place": exact,
        "covariance_s_per_place": best_seconds(equivalent, 3) / len(grid),
    }


def measure(quick: bool) -> dict[str, Any]:
    """All times, and the ratio of 500 exact hulls to the scores of the whole object."""
    depths = np.linspace(0.2, 4.0, 4 if quick else 20)
    spec = ObjectSpec(name="cube", press={"depths_mm": tuple(depths.tolist())})  # type: ignore[arg-type]
    presses = made_up_presses(spec)
    signals = press_signals(spec, *presses)
    hull = hull_seconds(spec, signals, quick)
    scores = best_seconds(lambda: score_places(spec, signals), 1 if quick else 5)
    grid = on_the_contact_grid(presses, spec)
    return {
        "depths": len(depths),
        "signals_s": best_seconds(lambda: press_signals(spec, *grid), 1 if quick else 5),
        "signals_target_s": SIGNALS_TARGET_S,
        "scores_s": scores,
        "scores_target_s": SCORES_TARGET_S,
        "hull": hull,
        "exact_hulls_over_scores": PLACES * hull["exact_s_per_place"] / scores,
        "exact_hull_over_equivalent": hull["exact_s_per_place"] / hull["covariance_s_per_place"],
        "hull_target": HULL_TARGET,
    }


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    times, hull = result["times"], result["times"]["hull"]
    return "\n".join(
        [
            f"signals, 500 places x {times['depths']} depths x 45 channels: {times['signals_s']:.3f} s"
            f" (target {SIGNALS_TARGET_S:g} s)",
            f"sensitivity, bounds and detectable force of 500 places: {times['scores_s']:.3f} s"
            f" (target {SCORES_TARGET_S:g} s)",
            f"exact hull of {hull['frames']} frames in 9 channels: {hull['exact_s_per_place']:.2f} s a"
            f" place; covariance equivalent {1e3 * hull['covariance_s_per_place']:.3f} ms",
            f"500 exact hulls over all scores: {times['exact_hulls_over_scores']:.0f}"
            f" (target {HULL_TARGET:g} at 100 frames)",
        ]
    )


def whole(quick: bool) -> dict[str, Any]:
    """Times, and what they were measured on."""
    return {"machine": machine(1, ("numpy", "scipy")), "quick": quick, "times": measure(quick)}


if __name__ == "__main__":
    run(whole, report)
