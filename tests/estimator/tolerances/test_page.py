"""Budgets, drawn objects and resting levels of a cube off its symmetries: a page that can be judged."""

import numpy as np

from estimator.tolerances.assembly import contribution_sizes, designed
from estimator.tolerances.budget import robustness
from estimator.tolerances.selftest import rank, rest_model
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.odd_presses import SPEC, presses
from tests.support.mechanics.synthetic_presses import synthetic_presses
from tests.support.physics_pages import assert_page, chosen

FEW = SPEC.changed(
    contact_grid=SPEC.contact_grid.changed(count=(2, 2), pitch_mm=4.0),
    magnets=SPEC.magnets.changed(
        positions_mm=((3.0, -6.0), (-7.0, 2.0)), north=("inward", "outward"), tilt_deg=()
    ),
    press=SPEC.press.changed(depths_mm=(1.0, 2.0, 4.0)),
)


def of_budget():
    forces, motions = synthetic_presses(FEW)
    for one in robustness(FEW, forces, motions, draws=1).contributions:
        yield (
            f"{one.name}: counts at rest, signal, bounds of place and force, mm, N",
            [
                one.baseline_counts,
                one.signal,
                one.position_bound,
                one.force_bound,
                one.false_place_mm,
                one.false_force_n,
            ],
        )


def of_drawn_object():
    assembly = drawn_assembly(SPEC, 3)
    sizes = contribution_sizes(designed(SPEC))
    yield "numbers drawn", ", ".join(f"{name} {size}" for name, size in sizes.items())
    yield "magnets (mm)", assembly.scene.magnets.centre_mm
    yield "their axes", assembly.scene.magnets.axis
    yield "sensors (mm)", assembly.scene.sensors.position_mm
    signals = twin_signals(SPEC, assembly, *presses())
    yield from chosen(signals, "baseline_counts", "delta_counts", "force_n")


def of_rest():
    model = rest_model(SPEC, 12.0)
    counts = model.mean + 40 * np.sin(np.arange(len(model.mean)))
    shifts = np.array([one.shift for one in model.faults if one.shift is not None])
    yield "levels at rest (counts)", model.mean
    yield "their covariance (counts²)", model.covariance
    yield "shifts by faults (counts)", shifts
    ranked = rank(model, counts, [(), *((one,) for one in model.faults[::97])])
    for one in ranked[:5]:
        yield f"{one.name}: log odds, fit", [one.log_odds, one.fit]


def test_the_page_of_tolerances():
    assert_page("estimator/tolerances", [*of_budget(), *of_drawn_object(), *of_rest()])
