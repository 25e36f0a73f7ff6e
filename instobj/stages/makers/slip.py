"""Cost of a slipped core as a stage: both models of the slip against the object as calibrated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from instobj.store.readers import PRESSES, SIGNALS, SLIP, SLIP_PICTURE
from instobj.store.stage import StageContext, write_json

if TYPE_CHECKING:
    from estimator.information.slip_cost import SlipCost
    from estimator.signals.presses import Signals


def with_slip(spec: ObjectSpec, slip: dict[str, Any]) -> ObjectSpec:
    """The specification with these keys of `mechanics.slip` alone.

    Raises
    ------
    InputError
        A slip that is out of range.
    """
    content = spec.model_dump(mode="json")
    content["mechanics"]["slip"] = slip
    return parse_spec(content, "this slip")


def objects_compared(spec: ObjectSpec) -> dict[str, tuple[str, ObjectSpec]]:
    """Results that the stage needs of other objects: as calibrated, and slipped by finite elements.

    None where the core has not slipped. The object as calibrated has the same rim.
    """
    slip = spec.mechanics.slip
    if not slip.slipped:
        return {}
    calibrated = with_slip(spec, {"rim": slip.rim})
    exact = with_slip(spec, slip.model_dump(mode="json") | {"model": "fem"})
    return {
        "calibrated presses": ("presses", calibrated),
        "calibrated signals": ("signals", calibrated),
        "fem signals": ("signals", exact),
    }


def make_slip(context: StageContext, folder: Path) -> None:
    """`slip.json` and `slip.png`; nothing where the core has not slipped."""
    from instobj.figures.slip import draw_slip
    from instobj.report.core_section import slip_title

    spec = context.spec
    if not spec.mechanics.slip.slipped:
        return
    costs = slip_costs(context)
    slip = spec.mechanics.slip.model_dump(mode="json", exclude={"model"})
    numbers = {model: summary(cost) for model, cost in costs.items()}
    content = {"slip": slip, "models": numbers, "sensors": sensor_rows(spec, costs)}
    write_json(content, SLIP.path(folder))
    draw_slip(spec, costs, SLIP_PICTURE.path(folder), slip_title(slip))


def slip_costs(context: StageContext) -> dict[str, SlipCost]:
    """Costs by both models against the object before its core slipped."""
    from estimator.information.slip_cost import slip_cost
    from estimator.signals.presses import press_signals

    spec, inputs = context.spec, context.inputs
    before = SIGNALS.read(inputs["calibrated signals"])
    exact = SIGNALS.read(inputs["fem signals"])
    context.step("signals with the sensors moved alone")
    slip = spec.mechanics.slip.model_dump(mode="json") | {"model": "sensors-only"}
    presses = PRESSES.read(inputs["calibrated presses"])
    approximate = press_signals(with_slip(spec, slip), *presses, context.step)
    signals: dict[str, Signals] = {"fem": exact, "sensors-only": approximate}
    return {model: slip_cost(spec, before, after) for model, after in signals.items()}


def summary(cost: SlipCost) -> dict[str, float]:
    """Medians and worst values over sensors, or over the contact locations of all faces."""
    counts, there = np.linalg.norm(cost.baseline_counts, axis=1), cost.places
    return {
        "baseline_median_counts": float(np.median(counts)),
        "baseline_largest_counts": float(counts.max()),
        "baseline_median_sigma": float(np.median(cost.baseline_sigma)),
        "baseline_largest_sigma": float(cost.baseline_sigma.max()),
        "cosine_median": float(np.median(cost.cosine[there])),
        "cosine_worst": float(cost.cosine[there].min()),
        "size_ratio_smallest": float(cost.size_ratio[there].min()),
        "size_ratio_largest": float(cost.size_ratio[there].max()),
        "force_smallest_n": float(cost.force_n[there].min()),
    } | {
        f"{name}_{how}": float(function(getattr(cost, name)[there]))
        for name in (
            "false_place_mm",
            "false_force_n",
            "rezeroed_place_mm",
            "rezeroed_force_n",
        )
        for how, function in (("median", np.median), ("worst", np.max))
    }


def sensor_rows(spec: ObjectSpec, costs: dict[str, SlipCost]) -> list[dict[str, Any]]:
    """Change of every sensor's resting counts (X, Y, Z) and its size in σ, by both models."""
    from design.layout.places.positions import sensor_layout

    exact, approximate = costs["fem"], costs["sensors-only"]
    rows = []
    faces = sensor_layout(spec).face.tolist()
    for index, face in enumerate(faces):
        x, y, z = (round(float(value)) for value in exact.baseline_counts[index])
        rows.append(
            {
                "face": face,
                "sensor": faces[: index + 1].count(face),
                "ΔX": x,
                "ΔY": y,
                "ΔZ": z,
                "σ": float(exact.baseline_sigma[index]),
                "sensors-only σ": float(approximate.baseline_sigma[index]),
            }
        )
    return rows
