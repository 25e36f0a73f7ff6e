"""Weak areas of objects of other shapes, thicknesses and magnet spacings: a rule for their design.

Bodies, cores and sensors are placed as `instobj new` places them, magnets as wide as a case says, on
one sensed face, with the silicone and the score of the given specification; the mesh is that of a
comparison. What is kept of a location is its measures (`design.layout.places.measures`) and its
position bound.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import cycle, pairwise
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.layout.places.measures import LONGEST_PATH_MM
from design.placement.objects import Request, ShellVariant, first_fit, spec_of
from design.placement.patterns import magnet_patterns
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from estimator.information.scores import score_places
from estimator.information.weak_areas import weak_areas
from instobj.figures.saving import save_figure
from instobj.figures.style import PALETTE
from instobj.stages.run import Run
from instobj.store.readers import SIGNALS
from studies.registry import Study, StudyResult

_POCKET_MM = (6.0, 3.0)
_SENSORS = 3
_INK = "#1a1a1a"
_MESH = {"surface_edge_mm": 2.5, "edge_mm": 7.0}
_CURVED_MESH = _MESH | {"envelope_mm": 0.15}
_QUICK_MESH = {"surface_edge_mm": 4.0, "edge_mm": 9.0, "envelope_mm": 0.2}
_DEPTHS_MM = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
PATH_BINS_MM = (6.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 24.0, 28.0, 34.0)


@dataclass(frozen=True)
class Case:
    """A body and one sensed face of it; `spread` is the outermost magnets' share of the half extents."""

    kind: str
    size_mm: tuple[float, float, float]
    face: int
    thickness_mm: float
    magnets: int
    spread: float


def _even(edge_mm: float) -> tuple[float, float, float]:
    return edge_mm, edge_mm, edge_mm


_CUBE, _LARGE, _SMALL, _BALL = _even(48.0), _even(64.0), _even(40.0), _even(56.0)
_ROD, _PAD = (50.0, 50.0, 70.0), (60.0, 50.0, 14.0)
_NARROW, _WIDE = 0.462, 0.66

CASES = (
    Case("box", _CUBE, 1, 8.0, 5, _WIDE),
    Case("box", _CUBE, 1, 8.0, 5, _NARROW),
    Case("box", _CUBE, 1, 8.0, 1, _WIDE),
    Case("box", _CUBE, 1, 8.0, 9, _WIDE),
    Case("box", _CUBE, 1, 6.0, 5, _WIDE),
    Case("box", _CUBE, 1, 10.0, 5, _WIDE),
    Case("box", _SMALL, 1, 6.0, 5, 0.58),
    Case("box", _LARGE, 1, 8.0, 5, _WIDE),
    Case("box", _LARGE, 1, 8.0, 5, _NARROW),
    Case("box", _LARGE, 1, 8.0, 9, _WIDE),
    Case("box", _LARGE, 1, 8.0, 9, _NARROW),
    Case("box", _LARGE, 1, 6.0, 9, _WIDE),
    Case("box", _LARGE, 1, 10.0, 9, _WIDE),
    Case("cylinder", _ROD, 3, 8.0, 5, 0.62),
    Case("cylinder", _ROD, 3, 8.0, 5, 0.434),
    Case("cylinder", _ROD, 3, 8.0, 9, _WIDE),
    Case("cylinder", _ROD, 3, 6.0, 5, 0.62),
    Case("cylinder", _ROD, 3, 10.0, 5, 0.62),
    Case("sphere", _BALL, 1, 8.0, 5, 0.54),
    Case("sphere", _BALL, 1, 8.0, 5, 0.378),
    Case("sphere", _BALL, 1, 8.0, 1, 0.54),
    Case("sphere", _BALL, 1, 6.0, 5, 0.54),
    Case("capsule", (52.0, 52.0, 90.0), 3, 8.0, 5, 0.54),
    Case("ellipsoid", (68.0, 60.0, 54.0), 1, 8.0, 5, 0.54),
    Case("dome", (60.0, 60.0, 36.0), 1, 8.0, 5, 0.58),
    Case("pad", _PAD, 1, 8.0, 5, _WIDE),
    Case("pad", _PAD, 1, 8.0, 9, _WIDE),
)
_QUICK = (CASES[1], CASES[13])


def placed_case(spec: ObjectSpec, case: Case, quick: bool = False) -> ObjectSpec:
    """The object of a case, in the specification's silicone.

    Raises
    ------
    InputError
        Its parts find no room.
    """
    request = Request(case.kind, case.size_mm, _SENSORS, 1)
    tables = first_fit(request, (ShellVariant(case.thickness_mm, *_POCKET_MM),))
    if tables is None:
        raise AssertionError(f"sensors find no room: {case}")
    half = np.min([frame.half_extents_mm for frame in face_frames(spec_of(tables))], axis=0)
    places = case.spread * half * magnet_patterns(case.magnets)[0]
    tables["magnets"]["positions_mm"] = (places.round(2) + 0.0).tolist()
    tables["body"]["sensed_faces"] = [case.face]
    flat = all(frame.flat for frame in face_frames(spec_of(tables)))
    tables["mesh"] = _QUICK_MESH if quick else _MESH if flat else _CURVED_MESH
    tables["press"] = {"depths_mm": [1.0, 2.0] if quick else _DEPTHS_MM}
    if quick:
        tables["contact_grid"] = {"count": [6, 6], "pitch_mm": 4.0}
    given = spec.model_dump(mode="json", exclude_unset=True)
    kept = {name: given[name] for name in ("silicone", "score") if name in given}
    return parse_spec({"name": f"{spec.name}-{case.kind}", **kept, **tables}, f"{case}")


def run(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """One row per object; `paths` in the document: bounds of all locations by signal path."""
    rows, found = [], []
    for case in _QUICK if quick else CASES:
        variant = placed_case(spec, case, quick)
        scores = score_places(variant, Run(variant).read(SIGNALS))
        areas, there = weak_areas(variant, scores), scores.judged
        bound = scores.position_bound_mm[there]
        path = areas.measures.path_mm[there]
        found.append((case.kind, path, bound))
        rank = areas.rank_correlation
        rows.append(
            {
                "body": f"{case.kind} {' × '.join(f'{edge:g}' for edge in case.size_mm)}",
                "shell_mm": case.thickness_mm,
                "magnets": case.magnets,
                "spread": case.spread,
                "places": int(there.sum()),
                "median_mm": float(np.median(bound)),
                "worst_mm": float(bound.max()),
                "median_path_mm": float(np.median(path)),
                "edge_ratio": areas.edge_ratio,
                "rank_border": rank.get("border_mm"),
                "rank_magnet": rank.get("magnet_mm"),
                "rank_path": rank.get("path_mm"),
                "rank_curvature": rank.get("curvature_per_mm"),
            }
        )
    every = np.concatenate([path for _, path, _ in found])
    bounds = np.concatenate([bound for *_, bound in found])
    paths = path_rows(every, bounds, spec.limits.position_bound_mm)
    draw_paths(found, paths, spec.limits.position_bound_mm, folder / "paths.png")
    return StudyResult(rows, data={"paths": paths} | growth(every, bounds))


def path_rows(
    path_mm: Float[np.ndarray, "n"], bound_mm: Float[np.ndarray, "n"], limit_mm: float
) -> list[dict[str, Any]]:
    """Bounds of the locations whose signal path lies in a bin, and the share that keeps a limit."""
    rows = []
    for low, high in pairwise(PATH_BINS_MM):
        some = bound_mm[(path_mm >= low) & (path_mm < high)]
        if not len(some):
            continue
        ends = np.quantile(some, [0.1, 0.9], method="nearest")
        rows.append(
            {
                "from_mm": low,
                "to_mm": high,
                "locations": len(some),
                "low_mm": float(ends[0]),
                "median_mm": float(np.median(some)),
                "high_mm": float(ends[1]),
                "within_limit": float(np.mean(some <= limit_mm)),
            }
        )
    return rows


def growth(path_mm: Float[np.ndarray, "n"], bound_mm: Float[np.ndarray, "n"]) -> dict[str, float]:
    """By which path the bound doubles, its scatter about that (a factor), and R² of its logarithm."""
    seen = np.isfinite(bound_mm)
    logarithm = np.log(bound_mm[seen])
    slope, start = np.polyfit(path_mm[seen], logarithm, 1)
    left = logarithm - start - slope * path_mm[seen]
    return {
        "doubles_every_mm": float(np.log(2) / slope),
        "bound_at_15_mm": float(np.exp(start + 15 * slope)),
        "scatter_factor": float(np.exp(left.std())),
        "r_squared": float(1 - left.var() / logarithm.var()),
    }


STUDIES = (
    Study("weak-areas", "Bodies, thicknesses, magnet spacings: which places are weak.", run),
)


def draw_paths(
    objects: Sequence[tuple[str, Float[np.ndarray, "_"], Float[np.ndarray, "_"]]],
    rows: Sequence[dict[str, Any]],
    limit_mm: float,
    path: Path | str,
) -> None:
    """Position bounds of many objects' locations against their signal paths (PNG).

    `objects` are kind, paths and bounds (mm) of their locations, `rows` bins of all of them.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.4, 4.8), layout="constrained")
    axes = figure.subplots()
    kinds = list(dict.fromkeys(kind for kind, *_ in objects))
    for kind, colour in zip(kinds, cycle(PALETTE), strict=False):
        some = [(away, bound) for name, away, bound in objects if name == kind]
        away, bound = (np.concatenate(part) for part in zip(*some, strict=True))
        axes.plot(away, bound, ".", ms=3, alpha=0.5, color=colour, label=kind)
    middle = [(row["from_mm"] + row["to_mm"]) / 2 for row in rows]
    low, high = ([row[end] for row in rows] for end in ("low_mm", "high_mm"))
    axes.fill_between(middle, low, high, color=_INK, alpha=0.15, label="10 to 90 % of locations")
    axes.plot(middle, [row["median_mm"] for row in rows], "-o", color=_INK, ms=4, label="median")
    axes.axhline(limit_mm, color="0.25", ls="--", lw=1, label=f"limit {limit_mm:g} mm")
    axes.axvline(LONGEST_PATH_MM, color="0.25", ls=":", lw=1, label=f"path {LONGEST_PATH_MM:g} mm")
    axes.set(yscale="log", xlabel="signal path over a magnet to a sensor, mm")
    axes.set_ylabel("position bound, mm")
    axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
    axes.grid(alpha=0.3)
    figure.legend(loc="outside right upper", frameon=False, fontsize=9)
    save_figure(figure, path)
