"""Signals of an object off its symmetries, their slopes and what surrounds it, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

from dataclasses import replace

import numpy as np

from design.spec.object import ObjectSpec
from estimator.signals.continuation import continued
from estimator.signals.hall import chip_errors, full_scale_counts
from estimator.signals.interpolation import (
    counts_at_force,
    depth_at_force,
    force_at_depth,
    press_traces,
    signal_gradient,
    unresolved_presses,
)
from estimator.signals.monotone import monotone_cubic
from estimator.signals.press_states import motions_as_signals, press_states
from estimator.signals.presses import press_signals, saturation_margin
from estimator.signals.surroundings import surroundings
from tests.support.mechanics.odd_presses import SPEC, presses, signals
from tests.support.recorded_facts import assert_on_record, told, told_whole

FACE = np.array([1, 2, 3, 4, 5, 5])
X_MM, Y_MM = np.array([[4.4, -4.3, 0.2, 3.1, -2.0, 0.0], [-5.5, 5.8, 0.1, 2.9, -1.0, 5.9]])
REVERSE = {
    "arrangement": "sensors-in-shell",
    "magnets": {
        "positions_mm": [[5.5, -2.0], [-3.0, 6.0]], "shape": "block", "size_mm": [4.0, 3.0],
        "depth_below_core_face_mm": 0.5,
    },
    "sensors": {"positions_mm": [[4.5, 3.5], [-6.0, 1.0]], "mount_rotation_deg": [5.0, -3.0, 20.0]},
    "core": {"wall_mm": 5.0},
}  # fmt: skip


def changed(**tables):
    return ObjectSpec.model_validate({**SPEC.model_dump(exclude_unset=True), **tables})


def on_record(section, lines):
    assert_on_record("signals", section, lines, "estimator")


def test_signals_are_as_on_record():
    on_record("signals", told_whole("signals", signals()))


def test_signals_of_a_reverse_object_are_as_on_record():
    """Boards move in the shell, and blocks stand in the core."""
    forces, motions = presses()
    grid = forces.lattice
    lattice = replace(grid, x_mm=grid.x_mm[:1], y_mm=grid.y_mm)
    some = slice(0, len(grid.y_mm))
    few = replace(
        forces,
        lattice=lattice,
        force_n=forces.force_n[:, some],
        contact_area_mm2=forces.contact_area_mm2[:, some],
    )
    boards = replace(motions, lattice=lattice, motion=motions.motion[:, some, :, :10])
    found = press_signals(changed(**REVERSE), few, boards)
    lines = [told("rest", found.baseline_counts), told("changes", found.delta_counts)]
    on_record("signals of a reverse object", lines)


def test_readings_at_a_force_and_their_slopes_are_as_on_record():
    traces = press_traces(signals(), FACE, X_MM, Y_MM)
    forces = np.linspace(0.0, 7.0, 4) + np.arange(6)[:, None] / 5
    lines = [
        *told_whole("at a force", counts_at_force(traces, forces, beyond="clamp")),
        told("depth", depth_at_force(traces, forces)),
        told("force", force_at_depth(traces, 1.7)),
        *told_whole("slopes", signal_gradient(signals(), FACE, X_MM, Y_MM, np.linspace(0.3, 9, 6))),
        told("unresolved", unresolved_presses(signals())),
    ]
    on_record("slopes", lines)


def test_states_of_a_press_are_as_on_record():
    forces, motions = presses()
    states = press_states(
        forces, motions, FACE, np.column_stack([X_MM, Y_MM]), np.linspace(1, 8, 6)
    )
    lines = [
        told("of the design", states.of_design),
        told("of a softer one", states.motion(0.8)),
        told("slopes", states.slope_per_mm(states.motion(1.3))),
        told("simulated", [states.simulated(ratio) for ratio in (0.3, 1.0, 2.0)]),
        *told_whole("signals of motions", motions_as_signals(forces, motions)),
    ]
    on_record("states", lines)


def test_chips_and_surroundings_are_as_on_record():
    sensors = SPEC.sensors.changed(gain_tolerance=0.05, cross_axis_tolerance=0.02)
    around = changed(environment={"earth_field_ut": 48.0})
    lines = [
        *told_whole("errors", chip_errors(sensors, 15, 7)),
        told("full scale", full_scale_counts(sensors)),
        told("margin", saturation_margin(signals(), SPEC)),
        *told_whole("around", surroundings(around)),
    ]
    on_record("chips and surroundings", lines)


def test_curves_are_as_on_record():
    """Monotone ones, of rising and of turning values; and values beyond the places of a face."""
    rng = np.random.default_rng(5)
    nodes = np.sort(rng.uniform(0, 9, (3, 6)), axis=1)
    values = rng.normal(size=(3, 6, 4)).cumsum(axis=1)
    at = nodes[:, :1] + np.linspace(0, 1, 9) * np.ptp(nodes, axis=1)[:, None]
    pressed = np.ones((5, 6), bool)
    pressed[0, :2] = pressed[4, 5] = False
    whole = continued(rng.normal(size=(30, 2)).cumsum(axis=0), pressed.ravel(), (5, 6))
    lines = [told("curves", monotone_cubic(nodes, values, at))]
    on_record("curves", [*lines, told("continued", whole[~pressed.ravel()])])
