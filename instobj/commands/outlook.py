"""Outlook of placed tables: a mesh that fits into memory, parts that would help, the next step."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from design.layout.places.measures import LONGEST_PATH_MM
from design.placement.objects import (
    COARSE,
    Request,
    ShellVariant,
    Tables,
    first_fit,
    spec_of,
)
from design.spec.object import ObjectSpec
from instobj.report.weak_areas import far_share
from instobj.stages.resources import needed_gib, search_seconds

MOST_GIB = 12.0
"""Memory of the response, at most: what a machine of 16 GiB has free."""
_SMALL_MM = 60.0
"""Bodies no longer than this fit with the usual edges: a cube of that size needs 8 GiB."""
_EDGE_STEP, _LONGEST = 1.1, 3.0
"""Steps in which edges grow, and by how much at most: beyond, the shell is one element thick."""
_TRIES_S = 8.0
"""Time after which no further number of parts is tried."""
_MORE = ((1, 0), (0, 4), (1, 4), (2, 0), (2, 4), (4, 4))
"""Sensors and magnets more on each face that are tried, the cheapest first."""
_FEW, _LESS = 0.05, 0.75
"""Share of far locations that is called near, and how much smaller one must be to be named."""


def with_edges_that_fit(request: Request, tables: Tables, most_gib: float = MOST_GIB) -> Tables:
    """The tables; where the mechanics would need more memory, with longer edges of the mesh."""
    if max(tables["body"].get("size_mm", request.size_mm)) <= _SMALL_MM:
        return tables
    mesh, factor = spec_of(tables).mesh, 1.0
    changed = tables
    while needed_gib("response", spec_of(changed)) > most_gib and factor < _LONGEST:
        factor *= _EDGE_STEP
        edges = {
            key: round(factor * getattr(mesh, key), 2) for key in ("edge_mm", "surface_edge_mm")
        }
        changed = tables | {"mesh": edges}
    return changed


def parts_that_help(request: Request, tables: Tables) -> str:
    """Say which number of parts on each face brings locations near, by signal paths; nothing where all
    are."""
    share = far_share(spec_of(tables))
    if share <= _FEW:
        return ""
    best, told, started = _LESS * share, "", time.monotonic()
    magnets = int(np.shape(tables["magnets"]["positions_mm"])[-2])
    for sensors_more, magnets_more in _MORE:
        if time.monotonic() - started > _TRIES_S or best <= _FEW:
            break
        counts = (request.sensors + sensors_more, magnets + magnets_more if magnets_more else None)
        larger = replace(request, sensors=counts[0], magnets=counts[1] or request.magnets)
        placed = first_fit(larger, (ShellVariant(**tables["shell"]),), COARSE)
        if placed is None or placed["body"].get("sensed_faces") != tables["body"].get(
            "sensed_faces"
        ):
            continue
        if (left := far_share(spec_of(placed))) < best:
            best, told = left, _told(sensors_more, counts)
    if told:
        return f"{told} would leave about {100 * best:.0f} % of the locations too far"
    return (
        f"no number of parts tried here brings many more locations within {LONGEST_PATH_MM:g} mm: take "
        "a smaller body, or `instobj optimize`"
    )


def _told(sensors_more: int, counts: tuple[int, int | None]) -> str:
    sensors, magnets = counts
    options = [f"--sensors {sensors}"] * bool(sensors_more)
    options += [f"--magnets {magnets}"] * (magnets is not None)
    several = "s" * (sensors_more > 1)
    words = [f"{sensors_more} more sensor{several} on each face"] * bool(sensors_more)
    words += [f"{magnets} magnets on each face"] * (magnets is not None)
    return f"{' and '.join(words)} ({' '.join(options)})"


def next_step_text(spec: ObjectSpec) -> str:
    """Say how large the mesh's edges are where they are not the usual ones, and what scores take."""
    usual, mesh = type(spec.mesh)(), spec.mesh
    edges = ""
    if mesh.surface_edge_mm > usual.surface_edge_mm:
        edges = (
            f"edges of the mesh are {mesh.surface_edge_mm:g} instead of {usual.surface_edge_mm:g} mm, so "
            f"that the mechanics fit into {MOST_GIB:g} GiB: shallow presses are less exact\n"
        )
    seconds, gib = search_seconds(spec).chain, needed_gib("response", spec)
    took = f"{seconds / 60:.0f} min" if seconds >= 120 else f"{seconds:.0f} s"
    return f"{edges}scores (`instobj score`) take about {took} of one free core and {gib:.2g} GiB"


def tables_of(spec: ObjectSpec) -> Tables:
    """Tables of a specification that say how its parts were placed."""
    content = spec.model_dump(mode="json", exclude_unset=True)
    shell = {key: getattr(spec.shell, key) for key in ShellVariant.__dataclass_fields__}
    return {**{table: content[table] for table in ("body", "magnets", "sensors")}, "shell": shell}
