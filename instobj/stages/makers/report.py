"""Makers of the report and of what it alone shows. Heavy imports stay inside."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.store.readers import (
    PRESS_CURVES,
    PRESS_CURVES_PICTURE,
    PRESSES,
    REPORT,
    RESPONSE,
    SIGNALS,
    SURROUNDINGS,
)
from instobj.store.stage import StageContext, write_json

if TYPE_CHECKING:
    from estimator.signals.presses import Signals


@dataclass(frozen=True)
class TravelSpread:
    """Indentation depth (mm) at which the median place reaches a force, at the modulus and its ends.

    None: not within the deepest simulated press.
    """

    force_n: float
    nominal_mm: float | None
    stiffest_mm: float | None
    softest_mm: float | None


def make_surroundings(context: StageContext, folder: Path) -> None:
    """Changes of resting signals that are no press, and the presses that they are taken for; bounds of
    flat jaws."""
    from estimator.information.false_force import jaw_effects, resting_shift
    from estimator.information.jaws import jaw_bounds
    from fem.presses.jaws import coverable_faces, jaw_faces
    from instobj.stages.makers.surroundings import surroundings_row

    spec, response = context.spec, context.read(RESPONSE)
    context.step("Earth's field, jaws of steel, aluminium and plastic, temperature")
    row = surroundings_row(spec)
    row["jaws"] = [asdict(jaw) for jaw in jaw_effects(spec, response, context.read(SIGNALS))]
    shift = resting_shift(spec, response)
    row["resting"] = None if shift is None else asdict(shift)
    flat = coverable_faces(spec)
    pressed = jaw_bounds(spec, jaw_faces(spec, response, flat)) if flat else ()
    row["jaw_bounds"] = [asdict(bounds) for bounds in pressed]
    write_json(row, SURROUNDINGS.path(folder))


def make_press_curves(context: StageContext, folder: Path) -> None:
    """Curves of force and signal, free range of the sensors, depth at the middle peak force, compliance."""
    from estimator.signals.presses import saturation_margin
    from fem.presses.compliance_map import compliance_map
    from instobj.figures.curves import draw_press_curves
    from instobj.figures.maps.compliance import draw_compliance

    signals = context.read(SIGNALS)
    spread = travel_spread(context.spec, signals)
    content: dict[str, Any] = {
        "saturation_margin": saturation_margin(signals, context.spec),
        "deepest_press_mm": float(signals.depth_mm[-1]),
        "travel": None if spread is None else asdict(spread),
    }
    write_json(content, PRESS_CURVES.path(folder))
    draw_press_curves(context.spec, signals, PRESS_CURVES_PICTURE.path(folder))
    forces, _ = context.read(PRESSES)
    draw_compliance(context.spec, compliance_map(forces), folder)


def make_report(context: StageContext, folder: Path) -> None:
    """The report page."""
    from instobj.report.page import write_report

    context.step("writing the report")
    write_report(context.spec, context.inputs, REPORT.path(folder))


def travel_spread(spec: ObjectSpec, signals: Signals) -> TravelSpread | None:
    """Return how far the tip travels to the protocol's middle peak force; None where no spread is known.

    At a given depth small-strain forces are proportional to the modulus. Linear interpolation
    between the simulated depths of the median place's force.
    """
    from design.layout.places.contact_grid import grid_places_in_lattice
    from design.layout.places.contact_places import contact_places

    if spec.silicone.relative_spread is None:
        return None
    softest, stiffest = spec.silicone.relative_spread
    target = sum(spec.protocol.peak_force_n) / 2
    places = grid_places_in_lattice(spec)
    pressed = signals.force_n[:, places][contact_places(spec)]
    force = np.append(0, np.median(pressed, axis=0))
    depth = np.append(0, signals.depth_mm)

    def travel(scale: float) -> float | None:
        return (
            float(np.interp(target / scale, force, depth)) if target <= scale * force[-1] else None
        )

    return TravelSpread(target, travel(1.0), travel(stiffest), travel(softest))
