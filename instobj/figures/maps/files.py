"""Maps that a run writes: one per face and score, on one scale over all faces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from design.spec.object import ObjectSpec
from estimator.information.cross_face import RELATIONS, CrossFace
from estimator.information.scores import PlaceScores, weakest_place
from estimator.information.shear import ShearScores
from estimator.information.weak_areas import WeakAreas
from instobj.figures.maps.heatmaps import FaceMaps
from instobj.figures.maps.overview import draw_overview
from instobj.figures.maps.scale import BOUND_COLOURS, GAIN_COLOURS, finite_limits, map_scale
from instobj.store.readers import BOUND_OVERVIEW


@dataclass(frozen=True)
class ScoreMap:
    """One score as a map: field of `PlaceScores`, file stem, title, unit, scale."""

    field: str
    stem: str
    title: str
    unit: str
    log: bool
    colours: str


SCORE_MAPS = (
    ScoreMap("position_bound_mm", "position_bound", "Position bound", "mm", True, BOUND_COLOURS),
    ScoreMap("force_bound_n", "force_bound", "Force bound", "N", True, BOUND_COLOURS),
    ScoreMap("detectable_force_n", "detectable", "Detectable force", "N", True, BOUND_COLOURS),
    ScoreMap("delta_raw", "delta", "Convex-hull sensitivity δ", "", True, GAIN_COLOURS),
    ScoreMap(
        "stiffness_n_per_mm",
        "stiffness",
        "Force per indentation depth",
        "N/mm",
        False,
        GAIN_COLOURS,
    ),
)


def unit_of(score_map: ScoreMap, spec: ObjectSpec) -> str:
    """Unit of a map; δ is a volume in as many dimensions as a face has channels."""
    return score_map.unit or f"counts^{3 * spec.sensors.count_per_face}/N"


def draw_score_maps(
    spec: ObjectSpec, scores: PlaceScores, folder: Path, step: Callable[[str], None]
) -> None:
    """Write `<stem>_face_<n>.png` for every map and face, and the overview of position bounds."""
    pictures = FaceMaps(spec)
    for score_map in SCORE_MAPS:
        step(f"maps of {score_map.title.lower()}")
        values = getattr(scores, score_map.field)
        how = score_map.log, score_map.colours
        scale = map_scale(unit_of(score_map, spec), *finite_limits(values), *how)
        for row, face in zip(values, scores.faces.tolist(), strict=True):
            title = f"{score_map.title}, {spec.score.force_n:g} N"
            pictures.draw(row, face, title, scale, folder / f"{score_map.stem}_face_{face}.png")
    _draw_overview(spec, scores, folder / Path(BOUND_OVERVIEW.name).name)


def _draw_overview(spec: ObjectSpec, scores: PlaceScores, path: Path) -> None:
    values = scores.position_bound_mm
    weakest = weakest_place(scores)
    whose = "each face's own" if spec.score.channels == "own" else "all"
    draw_overview(
        values,
        scores.faces,
        spec,
        f"Position bound of a contact of {spec.score.force_n:g} N",
        "mm",
        *finite_limits(values),
        path,
        colours=BOUND_COLOURS,
        direction_deg=scores.weakest_direction_deg,
        note=(
            f"Cramér–Rao bound √(σx² + σy²) from {whose} sensors, fresh baseline. Weakest: "
            f"{weakest.position_bound_mm:.2f} mm on face {weakest.face} at "
            f"({weakest.x_mm:g}, {weakest.y_mm:g}) mm."
            + (" ∞: blind, along the line." if np.isinf(values).any() else "")
            + (f" {scores.beyond_bound} (framed)." if scores.beyond_bound else "")
            + (f" {scores.unreached}." if scores.unreached else "")
        ),
        marked=scores.misread,
    )


_MEASURE_MAPS = (
    (
        "border_mm",
        "border_distance",
        "Distance to the border of the patch",
        "mm",
        1.0,
        GAIN_COLOURS,
    ),
    ("magnet_mm", "magnet_distance", "Distance to the nearest magnet", "mm", 1.0, BOUND_COLOURS),
    ("path_mm", "signal_path", "Signal path over a magnet to a sensor", "mm", 1.0, BOUND_COLOURS),
    ("curvature_per_mm", "curvature", "Mean curvature", "1/m", 1000.0, GAIN_COLOURS),
)


def draw_measure_maps(
    spec: ObjectSpec,
    scores: PlaceScores,
    areas: WeakAreas,
    folder: Path,
    step: Callable[[str], None],
) -> None:
    """Overviews of the measures that vary over the object, its weakest tenth framed."""
    bound, is_judged = scores.position_bound_mm, scores.judged
    weakest = is_judged & (bound >= np.quantile(bound[is_judged], 0.9, method="lower"))
    for name, stem, title, unit, factor, colours in _MEASURE_MAPS:
        if name not in areas.rank_correlation:
            continue
        step(f"map of the {title.lower()}")
        values = factor * getattr(areas.measures, name)
        draw_overview(
            values,
            scores.faces,
            spec,
            title,
            unit,
            *finite_limits(values),
            folder / f"{stem}_overview.png",
            log=False,
            colours=colours,
            marked=weakest,
            note=(
                "Framed: the tenth of the contact locations with the largest position bounds. "
                f"Rank correlation with the bound: {areas.rank_correlation[name]:+.2f}."
            ),
        )


def draw_shear_maps(spec: ObjectSpec, scores: ShearScores, folder: Path) -> None:
    """Overviews of the position and tangential-force bounds where both are unknown."""
    unknowns_text = f"location, normal and tangential force all unknown, {spec.score.force_n:g} N"
    draw_overview(
        scores.position_bound_mm,
        scores.faces,
        spec,
        "Position bound with tangential force",
        "mm",
        *finite_limits(scores.position_bound_mm),
        folder / "position_bound_sheared_overview.png",
        note=f"Cramér–Rao bound √(σx² + σy²), fresh baseline: {unknowns_text}.",
    )
    draw_overview(
        scores.tangential_force_bound_n,
        scores.faces,
        spec,
        "Bound of the tangential force",
        "N",
        *finite_limits(scores.tangential_force_bound_n),
        folder / "tangential_force_bound_overview.png",
        note=f"Cramér–Rao bound √(σFx² + σFy²), fresh baseline: {unknowns_text}.",
    )


def draw_cross_face_map(spec: ObjectSpec, cross: CrossFace, folder: Path) -> None:
    """Overview of the disturbance by a press at each location of the most affected other face.

    None is drawn of an object with one sensed face.
    """
    if not len(cross.pressed):
        return
    faces = np.unique(cross.pressed)
    largest = np.stack([cross.size_sigma[cross.pressed == face].max(axis=0) for face in faces])
    medians = {relation: cross.summary(relation) for relation in RELATIONS}
    medians_text = ", ".join(
        f"{relation} face {values['median_sigma']:.1f} σ ({values['median_false_force_n']:.2f} N of "
        "false force)"
        for relation, values in medians.items()
        if values
    )
    draw_overview(
        largest,
        faces,
        spec,
        f"Disturbance of the most affected other face by a press of {cross.force_n:g} N",
        "σ of a fresh baseline",
        *finite_limits(largest),
        folder / "cross_face_overview.png",
        note=(
            "Length of the signal change in the other face's own channels. Median over all locations, "
            f"{medians_text}."
        ),
    )
