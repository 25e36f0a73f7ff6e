"""Cost of a slipped core as a stage: the slipped object against the object as calibrated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from instobj.store.readers import SIGNALS, SLIP, SLIP_PICTURE
from instobj.store.stage import StageContext, write_json

if TYPE_CHECKING:
    from estimator.information.slip_cost import SlipCost


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
    """Results that the stage needs of the object as calibrated, and slipped.

    None where the core has not slipped. The object as calibrated has the same rim.
    """
    slip = spec.mechanics.slip
    if not slip.slipped:
        return {}
    calibrated = with_slip(spec, {"rim": slip.rim})
    return {
        "calibrated signals": ("signals", calibrated),
        "slipped signals": ("signals", spec),
    }


def make_slip(context: StageContext, folder: Path) -> None:
    """`slip.json` and `slip.png`; nothing where the core has not slipped."""
    from estimator.information.slip_cost import slip_cost
    from instobj.figures.slip import draw_slip
    from instobj.report.core_section import slip_title

    spec = context.spec
    if not spec.mechanics.slip.slipped:
        return
    inputs, slip = context.inputs, spec.mechanics.slip.model_dump(mode="json")
    calibrated, slipped = (
        SIGNALS.read(inputs[f"{name} signals"]) for name in ("calibrated", "slipped")
    )
    cost = slip_cost(spec, calibrated, slipped)
    content = {"slip": slip, "figures": summary(cost), "sensors": sensor_rows(spec, cost)}
    write_json(content, SLIP.path(folder))
    draw_slip(spec, cost, SLIP_PICTURE.path(folder), slip_title(slip))


def summary(cost: SlipCost) -> dict[str, float]:
    """Medians and worst values over sensors, or over the contact locations of all faces."""
    counts, places = np.linalg.norm(cost.baseline_counts, axis=1), cost.places
    return {
        "baseline_median_counts": float(np.median(counts)),
        "baseline_largest_counts": float(counts.max()),
        "baseline_median_sigma": float(np.median(cost.baseline_sigma)),
        "baseline_largest_sigma": float(cost.baseline_sigma.max()),
        "cosine_median": float(np.median(cost.cosine[places])),
        "cosine_worst": float(cost.cosine[places].min()),
        "size_ratio_smallest": float(cost.size_ratio[places].min()),
        "size_ratio_largest": float(cost.size_ratio[places].max()),
        "force_smallest_n": float(cost.force_n[places].min()),
    } | {
        f"{name}_{how}": float(function(getattr(cost, name)[places]))
        for name in (
            "false_place_mm",
            "false_force_n",
            "rezeroed_place_mm",
            "rezeroed_force_n",
        )
        for how, function in (("median", np.median), ("worst", np.max))
    }


def sensor_rows(spec: ObjectSpec, cost: SlipCost) -> list[dict[str, Any]]:
    """Change of every sensor's resting counts (X, Y, Z) and its size in σ."""
    from design.layout.places.positions import sensor_layout

    rows = []
    faces = sensor_layout(spec).face.tolist()
    for index, face in enumerate(faces):
        x, y, z = (round(float(value)) for value in cost.baseline_counts[index])
        rows.append(
            {
                "face": face,
                "sensor": faces[: index + 1].count(face),
                "ΔX": x,
                "ΔY": y,
                "ΔZ": z,
                "σ": float(cost.baseline_sigma[index]),
            }
        )
    return rows
