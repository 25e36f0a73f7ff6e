"""Where objects of other shapes, thicknesses and magnet spacings are weak: a rule for their design.

Every object is placed as `instobj new` places it, on one sensed face, with the silicone and the score
of the given specification; the mesh is that of a comparison. What is kept of a location is its
measures (`design.layout.places.measures`) and its position bound.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from design.placement.objects import Request, Trim, first_fit
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from estimator.information.scores import score_places
from estimator.information.weak_areas import weak_areas
from instobj.experiments.registry import Study, StudyResult
from instobj.figures.weak_areas import draw_reach
from instobj.stages.run import Run
from instobj.store.readers import SIGNALS

_POCKET_MM = (6.0, 3.0)
_SENSORS = 3
_MESH = {"surface_edge_mm": 2.5, "edge_mm": 7.0}
_DEPTHS_MM = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
NEAR_MM = 3.0
"""Locations so near a magnet, along the surface, are what an object's others are compared with."""
REACH_BINS_MM = (0.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0, 18.0)
_LEAST_IN_BIN = 5


@dataclass(frozen=True)
class Case:
    """A body and one sensed face of it; magnets lie at `spacing` times their usual distances."""

    kind: str
    size_mm: tuple[float, float, float]
    face: int
    thickness_mm: float
    magnets: int
    spacing: float = 1.0


def _even(edge_mm: float) -> tuple[float, float, float]:
    return edge_mm, edge_mm, edge_mm


def _cases() -> tuple[Case, ...]:
    cube, large, small = _even(48.0), _even(64.0), _even(40.0)
    rod, thick_rod = (50.0, 50.0, 70.0), (66.0, 66.0, 80.0)
    ball, large_ball = _even(56.0), _even(72.0)
    return (
        *(
            Case("box", cube, 1, 8.0, count, spacing)
            for count, spacing in ((5, 1.0), (1, 1.0), (9, 1.0), (5, 0.7))
        ),
        *(Case("box", cube, 1, thick, 5) for thick in (6.0, 10.0)),
        Case("box", small, 1, 6.0, 5),
        *(
            Case("box", large, 1, 8.0, count, spacing)
            for count, spacing in ((5, 1.0), (9, 1.0), (5, 0.7), (9, 0.7))
        ),
        *(Case("box", large, 1, thick, 9) for thick in (6.0, 10.0)),
        *(
            Case("cylinder", rod, 3, 8.0, count, spacing)
            for count, spacing in ((5, 1.0), (9, 1.0), (5, 0.7))
        ),
        *(Case("cylinder", rod, 3, thick, 5) for thick in (6.0, 10.0)),
        *(Case("cylinder", thick_rod, 3, 8.0, count) for count in (5, 9)),
        *(
            Case("sphere", ball, 1, 8.0, count, spacing)
            for count, spacing in ((5, 1.0), (1, 1.0), (5, 0.7))
        ),
        *(Case("sphere", ball, 1, thick, 5) for thick in (6.0, 10.0)),
        *(Case("sphere", large_ball, 1, 8.0, count) for count in (5, 9)),
        Case("capsule", (52.0, 52.0, 90.0), 3, 8.0, 5),
        *(Case("ellipsoid", (68.0, 60.0, 54.0), 1, 8.0, count) for count in (5, 9)),
        Case("dome", (60.0, 60.0, 36.0), 1, 8.0, 5),
        *(Case("pad", (60.0, 50.0, 14.0), 1, 8.0, count) for count in (5, 9)),
    )


CASES = _cases()
_QUICK = (Case("box", _even(48.0), 1, 8.0, 5), Case("cylinder", (50.0, 50.0, 70.0), 3, 8.0, 5))


def placed_case(spec: ObjectSpec, case: Case, quick: bool = False) -> ObjectSpec | None:
    """The object of a case, in the specification's silicone; None where its parts find no room."""
    request = Request(case.kind, case.size_mm, _SENSORS, case.magnets)
    tables = first_fit(request, (Trim(case.thickness_mm, *_POCKET_MM),))
    if tables is None:
        return None
    places = tables["magnets"]["positions_mm"]
    tables["magnets"]["positions_mm"] = (case.spacing * np.array(places)).round(2).tolist()
    tables["body"]["sensed_faces"] = [case.face]
    tables["mesh"] = {"surface_edge_mm": 4.0, "edge_mm": 9.0} if quick else _MESH
    tables["press"] = {"depths_mm": [1.0, 2.0] if quick else _DEPTHS_MM}
    if quick:
        tables["contact_grid"] = {"count": [6, 6], "pitch_mm": 4.0}
    given = spec.model_dump(mode="json", exclude_unset=True)
    kept = {name: given[name] for name in ("silicone", "score") if name in given}
    return parse_spec({"name": f"{spec.name}-{case.kind}", **kept, **tables}, f"{case}")


def run(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """One row an object; `reach` in the document: bounds over those near a magnet, by distance."""
    rows, relative = [], []
    for case in _QUICK if quick else CASES:
        variant = placed_case(spec, case, quick)
        if variant is None:
            continue
        scores = score_places(variant, Run(variant).read(SIGNALS))
        areas, there = weak_areas(variant, scores), scores.places
        bound = scores.position_bound_fresh_mm[there]
        magnet = areas.measures.magnet_mm[there]
        near = float(np.median(bound[magnet <= max(NEAR_MM, float(np.quantile(magnet, 0.1)))]))
        relative.append((case, magnet, bound / near))
        rows.append(
            {
                "body": f"{case.kind} {' × '.join(f'{edge:g}' for edge in case.size_mm)}",
                "shell_mm": case.thickness_mm,
                "magnets": case.magnets,
                "spacing": case.spacing,
                "places": int(there.sum()),
                "near_magnet_mm": near,
                "median_mm": float(np.median(bound)),
                "worst_mm": float(bound.max()),
                "edge_ratio": areas.edge_ratio,
                "rank_border": areas.rank_correlation.get("border_mm"),
                "rank_magnet": areas.rank_correlation.get("magnet_mm"),
                "rank_curvature": areas.rank_correlation.get("curvature_per_mm"),
                "farthest_mm": float(magnet.max()),
            }
        )
    reach = reach_rows([(magnet, ratio) for _, magnet, ratio in relative])
    draw_reach(
        [(case.kind, case.thickness_mm, magnet, ratio) for case, magnet, ratio in relative],
        reach,
        folder / "reach.png",
    )
    return StudyResult(rows, data={"reach": reach})


def reach_rows(
    objects: list[tuple[Float[np.ndarray, "_"], Float[np.ndarray, "_"]]],
) -> list[dict[str, Any]]:
    """Bounds over the object's own near a magnet, by distance to the nearest: medians of objects.

    An object counts in a bin that holds five of its locations or more.
    """
    rows = []
    for low, high in pairwise(REACH_BINS_MM):
        found = [ratio[_within(magnet, low, high)] for magnet, ratio in objects]
        medians = [float(np.median(some)) for some in found if len(some) >= _LEAST_IN_BIN]
        if not medians:
            continue
        rows.append(
            {
                "from_mm": low,
                "to_mm": high,
                "objects": len(medians),
                "locations": sum(len(some) for some in found),
                "median": float(np.median(medians)),
                "low": float(np.quantile(medians, 0.1)),
                "high": float(np.quantile(medians, 0.9)),
            }
        )
    return rows


def _within(magnet_mm: Float[np.ndarray, "n"], low: float, high: float) -> Bool[np.ndarray, "n"]:
    return (magnet_mm >= low) & (magnet_mm < high)


STUDIES = (
    Study("weak-areas", "Bodies, thicknesses, magnet spacings: which places are weak.", run),
)
