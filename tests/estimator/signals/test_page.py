"""Signals of a cube off its symmetries, their slopes and surroundings: a page that a person can judge."""

from dataclasses import replace

import numpy as np

from design.spec.object import ObjectSpec
from estimator.signals.continuation import continued
from estimator.signals.hall import chip_errors
from estimator.signals.interpolation import (
    counts_at_force,
    depth_at_force,
    force_at_depth,
    press_traces,
    signal_gradient,
)
from estimator.signals.monotone import monotone_cubic
from estimator.signals.press_states import motions_as_signals, press_states
from estimator.signals.presses import press_signals, saturation_margin
from estimator.signals.surroundings import surroundings
from tests.support.mechanics.odd_presses import SPEC, presses, signals
from tests.support.physics_pages import assert_page

FACE = np.array([1, 2, 3, 4, 5, 5])
X_MM, Y_MM = np.array([[4.4, -4.3, 0.2, 3.1, -2.0, 0.0], [-5.5, 5.8, 0.1, 2.9, -1.0, 5.9]])
REVERSE = {
    "arrangement": "sensors-in-shell",
    "magnets": {
        "positions_mm": [[5.5, -2.0], [-3.0, 6.0]], "shape": "block", "size_mm": [4.0, 3.0],
        "depth_below_core_face_mm": 0.5,
    },
    "sensors": {
        "positions_mm": [[4.5, 3.5], [-6.0, 1.0]],
        "rotations_deg": [[5.0, -3.0, 20.0], [-4.0, 6.0, 160.0]],
    },
    "core": {"wall_mm": 5.0},
}  # fmt: skip


def changed(**tables):
    return ObjectSpec.model_validate({**SPEC.model_dump(exclude_unset=True), **tables})


def of_signals():
    yield "at rest (counts)", signals().baseline_counts
    yield "pressed (counts)", signals().delta_counts
    yield "forces (N)", signals().force_n
    yield "margin to saturation", saturation_margin(signals(), SPEC)
    forces, motions = presses()
    some = replace(forces.lattice, x_mm=forces.lattice.x_mm[:1])
    few = slice(0, len(some.y_mm))
    pressed = {name: getattr(forces, name)[:, few] for name in ("force_n", "contact_area_mm2")}
    boards = replace(motions, lattice=some, motion=motions.motion[:, few, :, :10])
    reverse = press_signals(changed(**REVERSE), replace(forces, lattice=some, **pressed), boards)
    yield "reverse object at rest (counts)", reverse.baseline_counts
    yield "reverse object pressed (counts)", reverse.delta_counts


def of_readings():
    traces = press_traces(signals(), FACE, X_MM, Y_MM)
    wanted_n = np.linspace(0.0, 7.0, 4) + np.arange(6)[:, None] / 5
    yield "at forces (counts)", counts_at_force(traces, wanted_n, beyond="clamp").counts
    yield "depths of forces (mm)", depth_at_force(traces, wanted_n)
    yield "forces of 1.7 mm (N)", force_at_depth(traces, 1.7)
    slopes = signal_gradient(signals(), FACE, X_MM, Y_MM, np.linspace(0.3, 9, 6))
    yield "slopes along x (counts/mm)", slopes.d_x
    yield "slopes along y (counts/mm)", slopes.d_y
    yield "slopes with force (counts/N)", slopes.d_force


def of_states():
    forces, motions = presses()
    places = np.column_stack([X_MM, Y_MM])
    states = press_states(forces, motions, FACE, places, np.linspace(1, 8, 6))
    yield "motions of the design (mm, rad)", states.design_motion
    yield "motions of a softer object (mm, rad)", states.motion(0.8)
    yield "slopes of a stiffer object (1/mm)", states.slope_per_mm(states.motion(1.3))
    yield (
        "simulated at ratios of 0.3, 1, 2",
        [states.simulated(ratio).sum() for ratio in (0.3, 1.0, 2.0)],
    )
    yield "motions as signals", motions_as_signals(forces, motions).delta_counts


def of_chips_and_surroundings():
    errors = chip_errors(SPEC.sensors.changed(chip_spread=(0.05, 0.02)), 15, 7)
    yield "matrices of drawn chips", errors.matrix
    around = changed(environment={"earth_ut": [0.0, 0.0, -48.0]})
    felt = surroundings(around, (0.0, 10.0))
    yield (
        "object turned in earth's field (counts)",
        [
            felt.turning_largest_counts,
            felt.turning_rms_counts,
        ],
    )
    yield "jaws of steel (counts)", felt.jaw_counts
    yield "jaws elsewhere (counts)", felt.jaw_elsewhere_counts
    yield "pulls of jaws on a magnet (N)", felt.jaw_pull_n


def of_curves():
    """Monotone ones, of rising and of turning values; and values beyond the places of a face."""
    rng = np.random.default_rng(5)
    nodes = np.sort(rng.uniform(0, 9, (3, 6)), axis=1)
    values = rng.normal(size=(3, 6, 4)).cumsum(axis=1)
    at = nodes[:, :1] + np.linspace(0, 1, 9) * np.ptp(nodes, axis=1)[:, None]
    pressed = np.ones((5, 6), bool)
    pressed[0, :2] = pressed[4, 5] = False
    whole = continued(rng.normal(size=(30, 2)).cumsum(axis=0), pressed.ravel(), (5, 6))
    yield "curves through nodes", monotone_cubic(nodes, values, at)
    yield "continued beyond a face", whole[~pressed.ravel()]


def test_the_page_of_signals():
    parts = (of_signals, of_readings, of_states, of_chips_and_surroundings, of_curves)
    assert_page("estimator/signals", [line for part in parts for line in part()])
