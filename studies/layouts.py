"""Questions of layout that Knopke et al. (RA-L 2024) left open, each as variants of one object.

Every variant goes through the chain: a mesh that resolves its magnets, contact, fields, scores. The
mesh is coarser than the default, as variants are compared among themselves: on the paper's cube
bounds change by a few percent to the default mesh.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from design.layout.places.contact_places import contact_places, grid_count
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from instobj.search.fidelity import chain_score, score_row
from studies.registry import Study, StudyResult
from studies.variant_figure import draw_variants

Changes = dict[str, Any]
Variants = Callable[[ObjectSpec], dict[str, Changes]]

AS_THE_PAPER: Changes = {"score.channels": "own", "limits.use": "bench"}
"""Each face read by its own channels, of an object that stands still: what the paper's tables are of."""
MESH: Changes = AS_THE_PAPER | {
    "mesh.surface_edge_mm": 2.2,
    "mesh.edge_mm": 6.0,
    "press.depths_mm": [0.5, 1.0, 1.5, 2.0, 2.75, 3.5],
    "search.forces_n": [],
}
QUICK_MESH: Changes = AS_THE_PAPER | {
    "mesh.surface_edge_mm": 3.5,
    "mesh.rim_edge_ratio": 1.0,
    "mesh.edge_mm": 8.0,
    "contact_grid.count": [5, 5],
    "contact_grid.pitch_mm": 6.0,
    "press.depths_mm": [1.0, 2.0, 3.0],
    "score.force_n": 4.0,
}
"""Mesh, contact locations and presses of a preview in about a minute."""
QUICK: Changes = QUICK_MESH | {"search.forces_n": []}


def changed(spec: ObjectSpec, changes: Changes, source: str = "a variant") -> ObjectSpec:
    """The specification with dotted keys set, checked like any other; `source` names it in errors.

    Raises
    ------
    InputError
        The changes do not fit the specification.
    """
    content = spec.model_dump(mode="json", exclude_unset=True)
    for name, value in changes.items():
        *tables, key = name.split(".")
        table = content
        for part in tables:
            table = table.setdefault(part, {})
        table[key] = value
    return parse_spec(content, source)


def compare_variants(
    variants: Variants, spec: ObjectSpec, folder: Path, quick: bool
) -> StudyResult:
    """Score the variants, the first being what the others are compared with; write the figure.

    All are pressed at the locations of `spec`, also where a larger body would be filled with more.
    """
    base = _same_places(spec) | (QUICK if quick else MESH)
    rows = []
    for label, changes in variants(spec).items():
        variant = changed(spec, base | changes, f"{spec.name} with {label}")
        rows.append({"variant": label} | score_row(chain_score(variant)))
    draw_variants(
        rows, spec.score.force_n if not quick else QUICK["score.force_n"], folder / "scores.png"
    )
    return StudyResult(rows)


def _same_places(spec: ObjectSpec) -> Changes:
    if not contact_places(spec).all():
        return {}
    return {"contact_grid.count": list(grid_count(spec))}


def sensor_counts(spec: ObjectSpec) -> dict[str, Changes]:
    """Three boards as they are; four fit the same ring, five a ring 1 mm wider."""
    wider = {
        "sensors.radius_mm": 9.585,
        "core.recess_inner_radius_mm": 5.5,
        "core.recess_outer_radius_mm": 12.0,
    }
    return {
        "3 sensors": {"sensors.count_per_face": 3},
        "4 sensors": {"sensors.count_per_face": 4},
        "3 sensors, ring 1 mm wider": {"sensors.count_per_face": 3, **wider},
        "5 sensors, ring 1 mm wider": {"sensors.count_per_face": 5, **wider},
    }


def magnet_counts(spec: ObjectSpec) -> dict[str, Changes]:
    """The paper's five, its corners alone, and three by three."""
    corners = [[10, 10], [-10, 10], [-10, -10], [10, -10]]
    edges = [[10, 0], [-10, 0], [0, 10], [0, -10]]
    return {
        "5 magnets": {"magnets.positions_mm": [[0, 0], *corners]},
        "4 magnets, corners": {"magnets.positions_mm": corners},
        "4 magnets, mid-edges": {"magnets.positions_mm": edges},
        "9 magnets": {"magnets.positions_mm": [[0, 0], *corners, *edges]},
    }


def poles(spec: ObjectSpec) -> dict[str, Changes]:
    """Return which of the five poles point inward."""
    out, inward = "outward", "inward"
    return {
        "all outward": {"magnets.north": []},
        "centre inward": {"magnets.north": [inward, out, out, out, out]},
        "corners alternating": {"magnets.north": [out, out, inward, out, inward]},
        "two neighbours inward": {"magnets.north": [out, out, out, inward, inward]},
    }


def arrangements(spec: ObjectSpec) -> dict[str, Changes]:
    """Magnets in the shell and sensors in the core, and the reverse."""
    places = [[8, 8], [-8, 8], [-8, -8], [8, -8]]
    return {
        "magnets in the shell": {},
        "4 magnets in the shell": {
            "magnets.positions_mm": [[10, 10], [-10, 10], [-10, -10], [10, -10]]
        },
        "4 magnets in the core, sensors in the shell": {
            "arrangement": "sensors-in-shell",
            "magnets.positions_mm": places,
        },
    }


def thicknesses(spec: ObjectSpec) -> dict[str, Changes]:
    """The same core in a thicker shell: magnets as deep as before, or as far from the sensors."""
    core, pocket = spec.core_size_mm, spec.shell.pocket_depth_mm
    found: dict[str, Changes] = {f"{spec.shell.thickness_mm:g} mm": {}}
    for more in (2.0, 4.0):
        thickness = spec.shell.thickness_mm + more
        shell = {
            "shell.thickness_mm": thickness,
            "body.size_mm": [edge + 2 * thickness for edge in core],
        }
        found[f"{thickness:g} mm, pockets {pocket:g} mm"] = shell
        deeper = {**shell, "shell.pocket_depth_mm": pocket + more}
        found[f"{thickness:g} mm, pockets {pocket + more:g} mm"] = deeper
    return found


def moduli(spec: ObjectSpec) -> dict[str, Changes]:
    """The same object in softer and harder silicone; what is pressed further stays linear here."""
    modulus = spec.silicone.youngs_modulus_mpa
    depths = [0.5, 1.0, 1.5, 2.0, 2.75, 3.5, 4.5]
    return {
        f"{share * modulus:.3g} MPa": {
            "silicone.youngs_modulus_mpa": share * modulus,
            "silicone.youngs_modulus_range_mpa": None,
            "press.depths_mm": depths,
        }
        for share in (1.0, 1.5, 0.8, 0.65)
    }


def slits(spec: ObjectSpec) -> dict[str, Changes]:
    """Relief slits along the edges between faces, 1 mm wide."""
    return {
        "no slits": {"shell.slits.depth_mm": 0.0},
        "slits 3 mm deep": {"shell.slits.depth_mm": 3.0},
        "slits 5 mm deep": {"shell.slits.depth_mm": 5.0},
    }


def _study(name: str, text: str, variants: Variants) -> Study:
    return Study(name, text, partial(compare_variants, variants))


STUDIES = (
    _study("sensor-count", "Three against four and five sensors per face.", sensor_counts),
    _study("magnet-count", "Five against four and nine magnets per face.", magnet_counts),
    _study("poles", "Poles of the magnets all outward or alternating.", poles),
    _study("arrangement", "Magnets in the core and sensors in the shell.", arrangements),
    _study("shell-thickness", "A thicker shell round the same core.", thicknesses),
    _study("silicone-modulus", "A softer or harder silicone.", moduli),
    _study("relief-slits", "Slits along the edges, against pressure on the neighbours.", slits),
)
