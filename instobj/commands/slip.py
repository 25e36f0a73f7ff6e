"""Cost of a slip of the core: the object as calibrated against the slipped one, by both models."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.files import atomic_path
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec, spec_hash
from instobj.stages.chain import Chain
from instobj.store.publish import file_rows, require_writable, run_folder, stage_row
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from estimator.information.slip_cost import SlipCost
    from estimator.signals.presses import Signals

MODELS = ("fem", "sensors-only")


def slip_specification(
    path: Path,
    shift_mm: tuple[float, float, float],
    rotation_deg: tuple[float, float, float],
    rim: str,
    out: Path,
    overrides: list[str],
) -> dict[str, Any]:
    """Compare both models of a slip with the object as calibrated.

    Results go to `runs/<name>/slip_<shift>_<rotation>_<rim>/`.

    Raises
    ------
    InputError
        A bad specification, or no slip, or one out of range.
    """
    spec = load_spec(path, overrides)
    if not any(shift_mm) and not any(rotation_deg):
        raise InputError("no slip given. Give --shift X Y Z or --rotation X Y Z")
    slip = {"shift_mm": shift_mm, "rotation_deg": rotation_deg, "rim": rim}
    _with_slip(spec, slip)
    require_writable(out)
    chain, costs = slip_costs(spec, slip)
    target = run_folder(out, spec.name) / _folder(slip)
    numbers = {model: summary(cost) for model, cost in costs.items()}
    sensors = sensor_rows(spec, costs)
    target.mkdir(parents=True, exist_ok=True)
    write_json({"slip": slip, "models": numbers, "sensors": sensors}, target / "slip.json")
    draw_slip(spec, costs, target / "slip.png", slip_title(slip))
    return {
        "command": "slip",
        "objects": [
            {
                "name": spec.name,
                "spec_hash": spec_hash(spec),
                "stages": [stage_row(result) for result in chain.results.values()],
                "summary": {
                    slip_title(slip): comparison_rows(numbers),
                    "change of the resting signal": sensors,
                },
                "files": file_rows([target / "slip.json", target / "slip.png"]),
            }
        ],
    }


def slip_costs(spec: ObjectSpec, slip: dict[str, Any]) -> tuple[Chain, dict[str, SlipCost]]:
    """Costs by both models, and the chain of the slipped object.

    Both are measured against the object before its core slipped, rim alike. `slip` has the keys of
    `mechanics.slip`; its model does not matter.
    """
    from estimator.information.slip_cost import slip_cost
    from estimator.signals.presses import load_signals, press_signals
    from fem.presses.results import load_presses

    calibrated = Chain(_with_slip(spec, {"rim": slip["rim"]}))
    before = load_signals(calibrated.require("signals").folder / "lattice_signals.nc")
    slipped = Chain(_with_slip(spec, slip | {"model": "fem"}), calibrated.progress)
    signals: dict[str, Signals] = {
        "fem": load_signals(slipped.require("signals").folder / "lattice_signals.nc")
    }
    with calibrated.progress.stage("signals with the sensors moved alone"):
        approximate = _with_slip(spec, slip | {"model": "sensors-only"})
        presses = load_presses(calibrated.require("presses").folder / "presses.nc")
        signals["sensors-only"] = press_signals(approximate, *presses, calibrated.progress.step)
    return slipped, {model: slip_cost(spec, before, after) for model, after in signals.items()}


def summary(cost: SlipCost) -> dict[str, float]:
    """Medians and worst values over sensors, or over the contact places of all faces."""
    counts = np.linalg.norm(cost.baseline_counts, axis=1)
    return {
        "baseline_median_counts": float(np.median(counts)),
        "baseline_largest_counts": float(counts.max()),
        "baseline_median_sigma": float(np.median(cost.baseline_sigma)),
        "baseline_largest_sigma": float(cost.baseline_sigma.max()),
        "cosine_median": float(np.median(cost.cosine)),
        "cosine_worst": float(cost.cosine.min()),
        "size_ratio_smallest": float(cost.size_ratio.min()),
        "size_ratio_largest": float(cost.size_ratio.max()),
        "force_smallest_n": float(cost.force_n.min()),
    } | {
        f"{name}_{how}": float(function(getattr(cost, name)))
        for name in (
            "false_place_mm",
            "false_force_n",
            "rezeroed_place_mm",
            "rezeroed_force_n",
        )
        for how, function in (("median", np.median), ("worst", np.max))
    }


_ROWS = {
    "resting signal, median sensor, counts": "baseline_median_counts",
    "resting signal, worst sensor, counts": "baseline_largest_counts",
    "resting signal, median sensor, σ": "baseline_median_sigma",
    "resting signal, worst sensor, σ": "baseline_largest_sigma",
    "pattern of a press: cosine, median": "cosine_median",
    "pattern of a press: cosine, worst place": "cosine_worst",
    "size of a press's signal, smallest ratio": "size_ratio_smallest",
    "size of a press's signal, largest ratio": "size_ratio_largest",
    "false place, mm, median, old zero": "false_place_mm_median",
    "false place, mm, worst, old zero": "false_place_mm_worst",
    "false force, N, median, old zero": "false_force_n_median",
    "false force, N, worst, old zero": "false_force_n_worst",
    "false place, mm, median, re-zeroed": "rezeroed_place_mm_median",
    "false place, mm, worst, re-zeroed": "rezeroed_place_mm_worst",
    "false force, N, median, re-zeroed": "rezeroed_force_n_median",
    "false force, N, worst, re-zeroed": "rezeroed_force_n_worst",
}


FIGURES = tuple(_ROWS.values())
"""Names of the figures that tables show, of those in `summary`."""


def comparison_rows(numbers: dict[str, dict[str, float]]) -> list[dict[str, Any]]:
    """One row a figure, one column a model, and the error of moving the sensors alone."""
    rows = []
    for title, key in _ROWS.items():
        fem, approximate = (numbers[model][key] for model in MODELS)
        rows.append(
            {
                "what": title,
                "fem": fem,
                "sensors-only": approximate,
                "its error": approximate - fem,
            }
        )
    return rows


def sensor_rows(spec: ObjectSpec, costs: dict[str, SlipCost]) -> list[dict[str, Any]]:
    """Change of every sensor's resting counts (X, Y, Z) and its size in σ, by both models."""
    from design.layout.positions import sensor_layout

    exact, approximate = (costs[model] for model in MODELS)
    rows = []
    for index, face in enumerate(sensor_layout(spec).face.tolist()):
        x, y, z = (round(float(value)) for value in exact.baseline_counts[index])
        rows.append(
            {
                "face": face,
                "sensor": index + 1,
                "ΔX": x,
                "ΔY": y,
                "ΔZ": z,
                "σ": float(exact.baseline_sigma[index]),
                "sensors-only σ": float(approximate.baseline_sigma[index]),
            }
        )
    return rows


_SMALLEST_SHOWN = 0.03
_COLOURS = {"fem": "#1b6ca8", "sensors-only": "#c8553d"}


def draw_slip(spec: ObjectSpec, costs: dict[str, SlipCost], path: Path, title: str) -> None:
    """Resting signal of every sensor, and how many places are read how wrongly (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 7), layout="constrained")
    grid = figure.add_gridspec(2, 2)
    _draw_sensors(figure.add_subplot(grid[0, :]), spec, costs)
    _draw_shares(figure.add_subplot(grid[1, 0]), costs, "place_mm", "false place (mm)")
    _draw_shares(figure.add_subplot(grid[1, 1]), costs, "force_n", "false force (N)")
    figure.suptitle(f"{spec.name}: {title}", fontsize=13)
    with atomic_path(path) as temporary:
        figure.savefig(temporary, dpi=130)


def _draw_sensors(axes: Any, spec: ObjectSpec, costs: dict[str, SlipCost]) -> None:
    from design.layout.positions import sensor_layout

    face = sensor_layout(spec).face
    place = np.arange(len(face)) + 0.6 * face
    for offset, model in ((-0.2, "fem"), (0.2, "sensors-only")):
        sigma = costs[model].baseline_sigma
        axes.bar(place + offset, sigma, 0.4, color=_COLOURS[model], label=model)
    axes.set_xticks(
        place, [f"{f}·{index % spec.sensors.count_per_face + 1}" for index, f in enumerate(face)]
    )
    axes.set(xlabel="face · sensor", ylabel="change at rest (σ of white noise)")
    axes.legend(frameon=False, ncols=2)
    axes.spines[["top", "right"]].set_visible(False)


def _draw_shares(axes: Any, costs: dict[str, SlipCost], what: str, label: str) -> None:
    """Share of contact locations with an error of at most a limit, with the old and a new zero."""
    for model, cost in costs.items():
        for prefix, style, zero in (("rezeroed", "-", "re-zeroed"), ("false", ":", "old zero")):
            wrong = np.sort(getattr(cost, f"{prefix}_{what}").ravel())
            share = 100 * (np.arange(len(wrong)) + 1) / len(wrong)
            axes.plot(wrong, share, style, color=_COLOURS[model], label=f"{model}, {zero}")
    axes.set_xscale("log")
    axes.set(xlabel=label, ylabel="contact locations with error ≤ x (%)", ylim=(0, 102))
    axes.set_xlim(left=_SMALLEST_SHOWN)
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, fontsize=8, loc="upper left")


def _with_slip(spec: ObjectSpec, slip: dict[str, Any]) -> ObjectSpec:
    content = spec.model_dump(mode="json")
    content["mechanics"]["slip"] = slip
    return parse_spec(content, "this slip")


def slip_title(slip: dict[str, Any]) -> str:
    """The slip in words."""
    parts = []
    if any(slip["shift_mm"]):
        parts.append("shift " + _vector(slip["shift_mm"]) + " mm")
    if any(slip["rotation_deg"]):
        parts.append("rotation " + _vector(slip["rotation_deg"]) + "°")
    return f"core slipped: {', '.join(parts)}, rim {slip['rim']}"


def _folder(slip: dict[str, Any]) -> str:
    values = (*slip["shift_mm"], *slip["rotation_deg"])
    return "slip_" + "_".join(f"{value:g}" for value in values) + f"_{slip['rim']}"


def _vector(values: tuple[float, float, float]) -> str:
    return "(" + ", ".join(f"{value:g}" for value in values) + ")"
