"""One self-contained report.html: the verdict first, then tables, figures and provenance."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from design.files import atomic_path
from design.spec.object import ObjectSpec
from design.spec_io import spec_hash
from instobj.report import elements
from instobj.report.discretisation import HEADER, error_note, error_rows, error_text
from instobj.report.verdict import Verdict, judge
from instobj.store.content import RECORD

PAPER_TABLE_1 = {
    1: (0.999, 15.3e-4, 1.82, 0.278, 1.0),
    2: (0.999, 67.8e-4, 2.09, 0.380, 1.0),
    3: (0.997, 127e-4, 3.23, 0.479, 1.0),
    4: (0.999, 60.4e-4, 1.99, 0.370, 1.0),
    5: (0.999, 25.5e-4, 2.09, 0.410, 1.0),
}
"""Knopke et al., Table I: A_sim, E_loc (pixels), E_f (%), E_f (N), A_non; random frame split."""


_MODULUS_NOTE = (
    "The modulus is uncertain. For the paper's cube (Platsil Gel-10) recordings fit 0.23 to 0.28 MPa "
    "in the linear model, Gent's relation gives 0.414 MPa at Shore A10, and its recorded peak forces "
    "of 10 to 20 N ask for more travel or a stiffer silicone than either."
)


def write_report(
    spec: ObjectSpec, inputs: dict[str, Path], path: Path, step: Callable[[str], None]
) -> None:
    """Write the page from the folders of the stages it stands on."""
    from estimator.information.scores import load_scores_csv
    from estimator.signals.presses import load_signals, saturation_margin
    from instobj.report.compliance_section import compliance_section
    from instobj.report.core_section import core_section
    from instobj.report.deformation_section import deformation_section
    from instobj.report.surroundings import surroundings_section

    scores = load_scores_csv(inputs["scores"] / "scores.csv")
    signals = load_signals(inputs["signals"] / "lattice_signals.nc")
    verdict = judge(spec, scores, saturation_margin(signals, spec))
    sections = [
        _verdict_section(spec, verdict),
        _alternatives_section(spec, signals, inputs, step),
        _maps_section(spec, inputs),
        _areas_section(scores),
        _cross_face_section(spec, signals),
        _robustness_section(spec, inputs),
        surroundings_section(spec),
        _mechanics_section(spec, signals, inputs, path.parent),
        compliance_section(spec, inputs["presses"], path.parent),
        deformation_section(spec, inputs, _read_json(inputs["frames"] / "protocol.json")),
        core_section(spec, inputs["presses"], path.parent),
        _estimator_section(spec, inputs),
        _parts_section(inputs),
        _provenance_section(spec, inputs),
    ]
    title = f"{spec.name}: {'go' if verdict.go else 'no-go'}"
    with atomic_path(path) as temporary:
        temporary.write_text(elements.page(title, sections), encoding="utf-8")


def _verdict_section(spec: ObjectSpec, verdict: Verdict) -> str:
    word, style = ("GO", "go") if verdict.go else ("NO-GO", "no-go")
    rows = [
        [check.what, check.value, check.limit, "pass" if check.passed else "FAIL", check.where]
        for check in verdict.checks
    ]
    return (
        f"<h1>{elements.text(spec.name)} <span class='{style}'>{word}</span></h1>"
        f"<p><b>What limits it</b>: {elements.text(verdict.limited_by)}.</p>"
        + elements.table(["check", "value", "limit", "", "where"], rows)
    )


def _alternatives_section(
    spec: ObjectSpec, signals: Any, inputs: dict[str, Path], step: Callable[[str], None]
) -> str:
    from instobj.report.alternatives import alternatives

    rows = [
        [
            row.change,
            f"{row.weakest_bound_mm:.2f}",
            f"{row.median_bound_mm:.2f}",
            f"{row.worst_detectable_n:.2f}",
        ]
        for row in alternatives(spec, signals, inputs["presses"] / "presses.nc", step)
    ]
    header = ["change", "weakest position bound, mm", "median, mm", "worst detectable force, N"]
    return (
        "<h2>What to try next</h2><p>The same presses scored again with one thing changed at a "
        f"time, at {spec.score.force_n:g} N; the best comes first.</p>"
        + elements.table(header, rows)
    )


def _maps_section(spec: ObjectSpec, inputs: dict[str, Path]) -> str:
    from instobj.figures.maps import OVERVIEW, SCORE_MAPS, unit_of

    folder = inputs["scores"] / "maps"
    parts = [
        f"<h2>Where it is weak</h2>{elements.image(folder / OVERVIEW, 'Position bound, all faces')}"
    ]
    for score_map in SCORE_MAPS:
        images = "".join(
            elements.image(path, f"{score_map.title} {path.stem}")
            for path in sorted(folder.glob(f"{score_map.stem}_face_*.png"))
        )
        parts.append(
            f"<details><summary>{elements.text(score_map.title)} of every face "
            f"({elements.text(unit_of(score_map, spec))})</summary>"
            f"<div class='grid'>{images}</div></details>"
        )
    whose = "the face's own" if spec.score.channels == "own" else "all"
    return "".join(parts) + (
        f"<p class='note'>Bounds are Cramér–Rao bounds at {spec.score.force_n:g} N from {whose} channels, "
        f"freshly zeroed (white noise and {spec.sensors.zeroing_counts:g} counts). δ is the convex-hull "
        f"volume over the force range ({spec.score.hull} form, N = {spec.score.hull_frames} frames), in "
        "raw counts of the face's own channels with the sensors' white noise.</p>"
    )


def _areas_section(scores: Any) -> str:
    from estimator.information.scores import summarize_areas

    columns = {
        "position_bound_fresh_mm": "position bound, mm",
        "position_bound_drifted_mm": "after 15 min of drift, mm",
        "force_bound_fresh_n": "force bound, N",
        "detectable_force_fresh_n": "detectable force, N",
        "delta_raw": "δ raw, counts^d/N",
        "stiffness_n_per_mm": "N/mm",
    }
    rows = [
        [
            area.area.replace("_", "-"),
            str(area.places),
            *(f"{area.medians[name]:.3g}" for name in columns),
            f"{area.ratio_to_centre['position_bound_fresh_mm']:.2f}",
            f"{area.ratio_to_centre['delta_raw']:.2f}",
        ]
        for area in summarize_areas(scores)
    ]
    header = ["area", "places a face", *columns.values(), "bound / centre's", "δ / centre's"]
    return (
        "<h2>Edges against the centre</h2>"
        + elements.table(header, rows)
        + elements.note("Medians, all faces.")
    )


def _cross_face_section(spec: ObjectSpec, signals: Any) -> str:
    from estimator.information.cross_face import RELATIONS, cross_face_disturbance

    if len(signals.faces) == 1:
        return ""
    cross = cross_face_disturbance(spec, signals)
    rows = []
    for relation in RELATIONS:
        values = cross.summary(relation)
        if values:
            rows.append([relation, *(f"{value:.2f}" for value in values.values())])
    header = ["pressed face", "median, σ", "largest, σ", "median false force, N", "largest, N"]
    note = (
        f"A press of {cross.force_n:g} N on another face, read by this face's own channels: its size "
        "in sigmas of a fresh zero, and the force of the own press whose signal is nearest to it. An "
        "estimator that reads all channels can tell them apart, one that reads its own face cannot."
    )
    return "<h2>Presses on other faces</h2>" + elements.table(header, rows) + elements.note(note)


def _robustness_section(spec: ObjectSpec, inputs: dict[str, Path]) -> str:
    from estimator.tolerances.budget import SEAT_ERROR
    from estimator.tolerances.result import load_robustness
    from instobj.report.robustness import bound_rows

    budget = load_robustness(inputs["robustness"] / "robustness.json")
    rows = bound_rows(budget)
    table = [[str(row["bound"]), *(_figure(row[key]) for key in list(row)[1:])] for row in rows]
    note = (
        f"Each tolerance alone to first order, all at once by {budget.draws} objects drawn within "
        "`tolerances`. False readings are those of an estimator calibrated on the design and zeroed "
        f"on the object. {SEAT_ERROR}"
    )
    return (
        "<h2>Robustness</h2>"
        + elements.image(inputs["robustness"] / "robustness.png", "Ranked bars of the tolerances")
        + elements.table(
            ["bound, freshly zeroed", "design", "5 % of objects below", "95 % below"], table
        )
        + elements.note(note)
    )


def _mechanics_section(
    spec: ObjectSpec, signals: Any, inputs: dict[str, Path], scratch: Path
) -> str:
    from instobj.commands.material import force_spread_text, modulus_text
    from instobj.figures.curves import draw_press_curves

    figure = scratch / "press_curves.png"
    draw_press_curves(spec, signals, figure)
    mesh = _read_json(inputs["mesh"] / "mesh_quality.json")
    response = _read_json(inputs["response"] / "response.json")
    protocol = _read_json(inputs["frames"] / "protocol.json")
    error = _read_json(inputs["discretisation"] / "discretisation.json")
    rows = [
        ["tetrahedra / vertices", f"{mesh['tets']} / {mesh['vertices']}"],
        ["smallest dihedral angle", f"{mesh['min_dihedral_deg']:.1f}°"],
        ["sealed volume (error)", f"{mesh['volume_mm3']:.1f} mm³ ({mesh['volume_error']:.1e})"],
        ["discretisation error (rms, estimate)", error_text(error)],
        ["unknowns, condensed to", f"{response['unknowns']}, {response['condensed_unknowns']}"],
        ["model", f"{spec.mechanics.element}, magnets {spec.mechanics.magnets}, small strain, "
         f"correction: {spec.mechanics.correction}"],
        ["Young's modulus", modulus_text(spec)],
        ["force at a given travel, for that spread", force_spread_text(spec)],
        ["travel to the middle peak force, for that spread", _travel_text(spec, signals)],
        ["Poisson's ratio", f"{spec.silicone.poisson_ratio:g}"],
        ["depth at the protocol's peak forces", f"{protocol['shallowest_peak_mm']:.2f} to "
         f"{protocol['deepest_peak_mm']:.2f} mm"],
        ["places whose peak is clamped to the deepest press", str(protocol["clamped_places"])],
    ]  # fmt: skip
    return (
        "<h2>Mechanics</h2>"
        + elements.image(figure, "Force against travel, signal against force")
        + elements.table(["", ""], rows)
        + elements.note(_MODULUS_NOTE)
        + elements.table(HEADER, error_rows(error))
        + elements.note(_locking_note(spec) + error_note(error))
    )


def _travel_text(spec: ObjectSpec, signals: Any) -> str:
    from instobj.commands.material import travel_spread

    spread = travel_spread(spec, signals)
    if spread is None:
        return "not known"
    deepest = f"more than {signals.depth_mm[-1]:g} mm"
    at, least, most = (
        deepest if travel is None else f"{travel:.2f} mm"
        for travel in (spread.nominal_mm, spread.stiffest_mm, spread.softest_mm)
    )
    return f"{at} ({least} to {most}) to {spread.force_n:g} N at the median place"


def _locking_note(spec: ObjectSpec) -> str:
    from fem.linear.response import LOCKING_WARNING

    return f"{LOCKING_WARNING}. " if spec.mechanics.element == "p1" else ""


def _estimator_section(spec: ObjectSpec, inputs: dict[str, Path]) -> str:
    faces = _read_json(inputs["metrics"] / "metrics.json")["faces"]
    keys = ("similarity", "location_error_px", "force_error_percent", "force_error_n")
    rows = []
    for face in faces:
        paper = PAPER_TABLE_1.get(face["face"], (None,) * 5)
        ours = [*(face[key] for key in keys), face["non_contact_accuracy"]]
        cells = [
            f"{_figure(mine)} <span class='paper'>{_figure(theirs)}</span>"
            for mine, theirs in zip(ours, paper, strict=True)
        ]
        counts = f"{face['contact_frames']} + {face['rest_frames']}"
        rows.append([str(face["face"]), *cells, counts])
    header = ["face", "A_sim", "E_loc, px", "E_f, %", "E_f, N", "A_non", "contact + rest frames"]
    return (
        "<h2>Contact estimator, simulated presses</h2>"
        + elements.table(header, rows, escape=False)
        + elements.note(
            "Held-out presses, none of whose frames were trained on; each press has its own place "
            f"(±{spec.protocol.lateral_jitter_mm:g} mm), peak force, drift and noise. Grey: Table I of "
            "Knopke et al. (RA-L 2024), real hardware, frames of one press in both training and test, "
            "so the two are not the same task."
        )
    )


def _parts_section(inputs: dict[str, Path]) -> str:
    from design.build.manifest import BuildManifest

    rows = [
        [
            part.name,
            f"{part.volume_mm3:.2f}",
            " × ".join(f"{edge:.3f}".rstrip("0").rstrip(".") for edge in part.size_mm),
            f"{100 * (part.stl_volume_mm3 / part.volume_mm3 - 1):+.4f} %",
            "yes" if part.stl_watertight else "NO",
        ]
        for part in BuildManifest.read(inputs["build"]).parts
    ]
    header = ["part", "volume, mm³", "box, mm", "STL volume error", "watertight"]
    image = elements.image(inputs["build"] / "parts.png", "Core, shell, mould box and plug")
    return "<h2>Parts</h2>" + image + elements.table(header, rows)


def _provenance_section(spec: ObjectSpec, inputs: dict[str, Path]) -> str:
    records = {name: _read_json(folder / RECORD) for name, folder in inputs.items()}
    rows = [
        [
            name,
            record["key"][:16],
            f"{record['seconds']:.1f} s",
            ", ".join(record["inputs"]["spec"]),
        ]
        for name, record in records.items()
    ]
    content = json.dumps(spec.model_dump(mode="json"), indent=1)
    versions = next(iter(records.values()))["inputs"]["libraries"]
    made_with = ", ".join(f"{name} {version}" for name, version in versions.items())
    return (
        "<h2>Provenance</h2>"
        + elements.table(["stage", "content key", "took", "depends on"], rows)
        + elements.note(f"Specification {spec_hash(spec)}; {made_with}.")
        + f"<details><summary>Specification</summary><pre>{elements.text(content)}</pre></details>"
    )


def _read_json(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text(encoding="utf-8"))


def _figure(value: float | None) -> str:
    if value is None or not np.isfinite(value):
        return "–"
    return f"{value:.3g}"
