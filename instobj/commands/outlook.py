"""Outlook of placed tables: a mesh that fits into memory, bounds, parts that would help, the next step."""

from __future__ import annotations

from math import ceil

from design.errors import InputError
from design.placement.objects import (
    Request,
    Tables,
    spec_of,
)
from design.spec.object import ObjectSpec
from estimator.layouts.without_mesh import MEDIAN_FACTOR, FirstScore, first_score
from instobj.report.cells import percent_text
from instobj.stages.resources import needed_gib, require_memory, search_seconds

MOST_GIB = 12.0
"""Memory of the response, at most: what a machine of 16 GiB has free."""
_SMALL_MM = 60.0
"""Bodies no longer than this fit with the usual edges: a cube of that size needs 8 GiB."""
_EDGE_STEP, _LONGEST = 1.1, 3.0
"""Steps in which edges grow, and by how much at most: beyond, the shell is one element thick."""


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


def chosen_text(spec: ObjectSpec, placed: bool) -> str:
    """Say which magnets and which range the object has, and why where they were `placed` for a request."""
    magnets, sensors = spec.magnets, spec.sensors
    sizes = sorted({f"Ø{size.diameter_mm:g} × {size.height_mm:g} mm" for size in magnets.sizes})
    parts = f"magnets {', '.join(sizes)} and sensors of ±{sensors.range_mt:g} mT"
    if not placed:
        return f"{parts}, as on the paper's cube"
    return (
        f"{parts}: of the stock magnets, ranges and places that fit, those that locate presses of "
        f"{spec.score.force_n:g} N best (judged without a mesh, by the presses of a flat layer)"
    )


def expected_text(spec: ObjectSpec, score: FirstScore) -> str:
    """Say which position bounds to expect, and whether light touches are felt; ranges are those of
    docs/measured/bodies.md."""
    felt = f"about {percent_text(score.felt)} feel" if score.felt < 1 else "all feel"
    least, most = map(percent_text, score.within_range)
    shares = least if least == most else f"{least.removesuffix(' %')} to {most}"
    return (
        f"expect position bounds of {score.median_mm:.2g} mm (median, within a factor of "
        f"{MEDIAN_FACTOR:g}), one in twenty above {score.percentile_95_mm:.2g} mm (a third of that to twice "
        f"that); {shares} of the contact locations within limits.position_bound_mm = "
        f"{spec.limits.position_bound_mm:g} mm; {felt} a touch of limits.detectable_force_n = "
        f"{spec.limits.detectable_force_n:g} N"
    )


def outlook_text(spec: ObjectSpec) -> str:
    """Say the same of a specification and what it is not for, or why nothing can be said without a mesh."""
    try:
        expected = expected_text(spec, first_score(spec))
        return f"{expected}. Compare layouts by `instobj score`, not by this"
    except InputError as error:
        return f"position bounds are known after `instobj score` only: {error}"


def memory_text(spec: ObjectSpec) -> str:
    """Say that this machine cannot score the object, and which keys would help; nothing where it can."""
    try:
        require_memory("response", spec)
    except InputError as error:
        return f"this cannot be scored here: {error}"
    return ""


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
    # the estimate is of one free core; programs beside it easily double the time
    least, most = ceil(seconds / 60), ceil(2 * seconds / 60)
    return f"{edges}scores (`instobj score`) take {least} to {most} min and {gib:.2g} GiB"
