"""Report of an object: the verdict first, then tables, figures, files and provenance, in one page."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np

from design.layout.body import face_frames
from design.layout.places.contact_places import contact_places, grid_count
from design.layout.places.coverage import covered_shares
from design.spec.object import ObjectSpec
from design.spec_io import spec_hash
from instobj.figures.maps.files import SCORE_MAPS
from instobj.report.cells import shown
from instobj.report.core_section import core_section
from instobj.report.deformation_section import deformation_section
from instobj.report.pages import write_page
from instobj.report.remedies import edges_text, remedies_section, tip_text, worst_edge_text
from instobj.report.summary import cross_face_rows, part_rows
from instobj.report.surroundings import GRASP_HEADER, grasp_rows, surroundings_section
from instobj.report.uncertainty import (
    HEADER,
    bound_rows,
    coarse_mesh_text,
    error_note,
    error_rows,
    error_text,
    force_spread_text,
    forces_text,
    modulus_text,
    travel_text,
)
from instobj.report.verdict import judge, located_text, objects_text, score_rows
from instobj.report.weak_areas import weak_areas_section
from instobj.store import readers
from instobj.store.readers import published_files
from instobj.store.record import read_record

Inputs = dict[str, Path]

_ESTIMATOR_COLUMNS = (
    *("tips a face", "force", "frames", "number right %", "distance mm", "95th percentile mm"),
    *("bound mm", "total force N", "place in 90 % region %", "force in 90 % interval %"),
)
"""Figures of the contacts read, for each number of tips and range of force."""
_PAPER_PARTS = ("arrangement", "body", "shell", "core", "magnets", "sensors", "silicone")


@dataclass(frozen=True)
class Link:
    """A file next to the page."""

    name: str
    href: str


def write_report(spec: ObjectSpec, inputs: Inputs, path: Path) -> None:
    """Write the page from the folders of the stages it stands on."""
    scores = readers.SCORES.read(inputs["scores"])
    curves = readers.PRESS_CURVES.read(inputs["press_curves"])
    budget = readers.ROBUSTNESS.read(inputs["robustness"])
    verdict = judge(spec, scores, curves["saturation_margin"], budget.saturation)
    protocol = readers.PROTOCOL.read(inputs["frames"])
    alternatives = readers.ALTERNATIVES.read(inputs["alternatives"])
    edges = readers.WEAK_AREAS.read(inputs["weak_areas"])
    surroundings = readers.SURROUNDINGS.read(inputs["surroundings"])
    write_page(
        path,
        "report.html.j2",
        spec=spec,
        papers_cube=is_papers_cube(spec),
        still=readers.STILL.path(inputs["scene"]),
        scene=readers.SCENE.path(inputs["scene"]),
        verdict=verdict,
        located=located_text(spec, scores),
        tip=tip_text(spec),
        coarse_mesh=coarse_mesh_text(spec, readers.DISCRETISATION.read(inputs["discretisation"])),
        locations=locations_line(spec),
        unreached=scores.unreached,
        covered_by_face="" if scores.unreached else _covered_by_face(spec),
        checks=[
            [check.what, check.value, check.limit, "pass" if check.passed else "FAIL", check.where]
            for check in verdict.checks
        ],
        **remedies_section(spec, alternatives, verdict.go),
        edge_text=edges_text(spec, edges, alternatives["alternatives"])
        + worst_edge_text(spec, scores, edges),
        surroundings=surroundings_section(surroundings),
        grasp_header=GRASP_HEADER,
        grasp_rows=grasp_rows(surroundings),
        press_curves=readers.PRESS_CURVES_PICTURE.path(inputs["press_curves"]),
        mechanics=_mechanics(spec, curves, inputs, protocol),
        compliance=readers.TIED_COMPLIANCE_MAP.path(inputs["press_curves"]),
        deformation=deformation_section(spec, inputs, protocol),
        core=core_section(spec, inputs["presses"], inputs["slip"]),
        **_estimator(inputs),
        parts=part_rows(inputs["build"]),
        parts_picture=readers.PARTS_PICTURE.path(inputs["build"]),
        parts_folder=f"../../cad_out/{quote(spec.name)}/",
        files=files_beside(inputs),
        **_maps(inputs),
        score_rows=score_rows(scores),
        delta=shown(float(np.median(scores.delta_raw[scores.judged]))),
        **weak_areas_section(inputs["weak_areas"]),
        cross_face=cross_face_rows(inputs["scores"]),
        cross_face_force_n=readers.CROSS_FACE.read(inputs["scores"])["force_n"],
        nuisances=_nuisances(inputs),
        **_robustness(inputs),
        **_discretisation(spec, inputs),
        **_provenance(spec, inputs),
    )


def locations_line(spec: ObjectSpec) -> str:
    """Counts along x and y, or how many each face has where faces differ; in words."""
    places = contact_places(spec)
    least, most = places.sum(axis=1).min(), places.sum(axis=1).max()
    count = f"{least}" if least == most else f"{least} to {most}"
    if places.all():
        count = "{} × {}".format(*grid_count(spec))
    return f"{count} contact locations{' per face' * (len(places) > 1)}"


def _covered_by_face(spec: ObjectSpec) -> str:
    """Shares of single faces, where they differ; those of curved bodies may overlap."""
    shares = [f"{100 * share:.0f}\N{NO-BREAK SPACE}%" for share in covered_shares(spec)]
    if len(set(shares)) == 1:
        return ""
    named = (f"face {face}: {share}" for face, share in zip(spec.body.sensed, shares, strict=True))
    flat = all(frame.flat for frame in face_frames(spec))
    return f" ({', '.join(named)}{'' if flat else '; patches overlap, and what several cover counts once'})"


def is_papers_cube(spec: ObjectSpec) -> bool:
    """Return whether the object is the paper's cube, of which more is known."""
    default = ObjectSpec(name="default")
    return all(getattr(spec, part) == getattr(default, part) for part in _PAPER_PARTS)


def _maps(inputs: Inputs) -> dict[str, Any]:
    """Titles and pictures of the scores; the position bound stands on the first screen, δ by itself."""
    folder = inputs["scores"] / "maps"
    paths = {score.field: folder / score.file_name for score in SCORE_MAPS}
    overview, delta = paths.pop("position_bound_mm"), paths.pop("delta_raw")
    titles = {score.field: score.title for score in SCORE_MAPS}
    maps = [(titles[field], path) for field, path in paths.items()]
    return {"overview": overview, "maps": maps, "delta_map": delta}


def _nuisances(inputs: Inputs) -> list[list[str]]:
    """Rows of what changes after the zero: its size, and times that it makes the median bounds."""
    return [
        [
            cost["name"],
            f"{cost['deviation']:.3g} {cost['unit']}" if cost["unit"] else "",
            *(f"{cost[bound]:.2f} times" for bound in ("position", "force")),
        ]
        for cost in readers.NUISANCE_COSTS.read(inputs["scores"])["costs"]
    ]


def _robustness(inputs: Inputs) -> dict[str, Any]:
    from estimator.tolerances.result import SEAT_ERROR

    budget = readers.ROBUSTNESS.read(inputs["robustness"])
    return {
        "robustness_picture": readers.ROBUSTNESS_PICTURE.path(inputs["robustness"]),
        "bounds": bound_rows(budget),
        "draws": budget.draws,
        "saturation": f"{objects_text(budget.saturation).capitalize()}.",
        "budget_forces": forces_text(budget),
        "seat_error": SEAT_ERROR,
    }


def _mechanics(
    spec: ObjectSpec, curves: dict[str, Any], inputs: Inputs, protocol: dict[str, Any]
) -> list[list[str]]:
    mesh = readers.MESH_QUALITY.read(inputs["mesh"])
    response = readers.RESPONSE_SIZE.read(inputs["response"])
    error = readers.DISCRETISATION.read(inputs["discretisation"])
    return [
        ["tetrahedra / vertices", f"{mesh['tets']} / {mesh['vertices']}"],
        ["smallest dihedral angle", f"{mesh['min_dihedral_deg']:.1f}°"],
        ["sealed volume (error)", f"{mesh['volume_mm3']:.1f} mm³ ({mesh['volume_error']:.1e})"],
        ["discretisation error (rms, estimate)", error_text(error)],
        ["unknowns, condensed to", f"{response['unknowns']}, {response['condensed_unknowns']}"],
        ["model", f"{spec.mechanics.element}, magnets rigid, small strain, "
         f"correction: {spec.mechanics.correction}"],
        ["Young's modulus", modulus_text(spec)],
        ["force at a given depth, over that uncertainty range", force_spread_text(spec)],
        ["depth at the middle peak force, over that range", travel_text(curves)],
        ["Poisson's ratio", f"{spec.silicone.poisson_ratio:g}"],
        ["depth at the protocol's peak forces", f"{protocol['shallowest_peak_mm']:.2f} to "
         f"{protocol['deepest_peak_mm']:.2f} mm"],
        ["locations whose peak is clamped to the deepest press", str(protocol["clamped_places"])],
    ]  # fmt: skip


def _discretisation(spec: ObjectSpec, inputs: Inputs) -> dict[str, Any]:
    error = readers.DISCRETISATION.read(inputs["discretisation"])
    return {
        "discretisation_header": HEADER,
        "discretisation": error_rows(error),
        "discretisation_note": error_note(error),
    }


def _estimator(inputs: Inputs) -> dict[str, Any]:
    """Contacts read on simulated presses: rows, picture (None where none was read) and what was judged."""
    content = readers.CONTACT_METRICS.read(inputs["contact_metrics"])
    rows = [[shown(row[name]) for name in _ESTIMATOR_COLUMNS] for row in content["contacts"]]
    picture = readers.CONTACT_PICTURE.path(inputs["contact_metrics"]) if rows else None
    return {
        "estimator_header": _ESTIMATOR_COLUMNS,
        "estimator_rows": rows,
        "estimator_picture": picture,
        "estimator_judged": content["judged"],
    }


def files_beside(inputs: Inputs) -> list[tuple[str, list[Link]]]:
    """Files that lie next to the page once all are published, by stage."""
    files = []
    for stage, folder in inputs.items():
        names = [path.relative_to(folder).as_posix() for path in published_files(stage, folder)]
        if names:
            files.append((stage, [Link(name, quote(name)) for name in names]))
    return files


def _provenance(spec: ObjectSpec, inputs: Inputs) -> dict[str, Any]:
    records = {name: read_record(folder) for name, folder in inputs.items()}
    rows = [
        [name, record["key"][:16], ", ".join(record["inputs"]["spec"])]
        for name, record in records.items()
    ]
    versions = next(iter(records.values()))["inputs"]["libraries"]
    return {
        "stages": rows,
        "hash": spec_hash(spec),
        "made_with": ", ".join(f"{name} {version}" for name, version in versions.items()),
        "specification": json.dumps(spec.model_dump(mode="json"), indent=1),
    }
