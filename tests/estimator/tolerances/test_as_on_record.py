"""Budgets, drawn objects and resting levels of an object off its symmetries, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

from dataclasses import fields

import numpy as np

from estimator.tolerances.assembly import contribution_sizes, designed
from estimator.tolerances.budget import robustness
from estimator.tolerances.selftest import rank, rest_model
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.odd_presses import SPEC, presses
from tests.support.mechanics.synthetic_presses import synthetic_presses
from tests.support.recorded_facts import assert_on_record, told, told_whole

FEW = SPEC.changed(
    contact_grid=SPEC.contact_grid.changed(count=(2, 2), pitch_mm=4.0),
    magnets=SPEC.magnets.changed(
        positions_mm=((3.0, -6.0), (-7.0, 2.0)), north=("inward", "outward"), tilt_deg=()
    ),
    press=SPEC.press.changed(depths_mm=(1.0, 2.0, 4.0)),
)


def on_record(section, lines):
    assert_on_record("tolerances", section, lines, "estimator")


def test_a_budget_is_as_on_record():
    on_record("budget", told_whole("budget", robustness(FEW, *synthetic_presses(FEW), draws=1)))


def test_drawn_objects_are_as_on_record():
    assembly = drawn_assembly(SPEC, 3)
    numbers = {
        field.name: getattr(assembly, field.name)
        for field in fields(assembly)
        if isinstance(getattr(assembly, field.name), np.ndarray | float)
    }
    found = twin_signals(SPEC, assembly, *presses())
    lines = [
        f"numbers of each: {contribution_sizes(designed(SPEC))}",
        *told_whole("object", numbers),
        told("magnets", assembly.scene.magnets.centre_mm),
        told("their axes", assembly.scene.magnets.axis),
        told("sensors", assembly.scene.sensors.position_mm),
        *told_whole("signals", found),
    ]
    on_record("drawn object", lines)


def test_resting_levels_and_their_faults_are_as_on_record():
    model = rest_model(SPEC, 12.0)
    counts = model.mean + 40 * np.sin(np.arange(len(model.mean)))
    shifts = np.array([one.shift for one in model.faults if one.shift is not None])
    found = rank(model, counts, [(), *((one,) for one in model.faults[::97])])
    lines = [
        told("mean", model.mean),
        told("covariance", model.covariance),
        told("shifts", shifts),
        told("full scale", model.full_scale_counts),
        *(f"{one.name}: {told('log odds, fit', [one.log_odds, one.fit])}" for one in found[:8]),
    ]
    on_record("rest", lines)
