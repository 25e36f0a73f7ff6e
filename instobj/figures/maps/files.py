"""Maps that a run writes: one picture of all faces for each score."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from design.spec.object import ObjectSpec
from estimator.information.cross_face import RELATIONS, CrossFace
from estimator.information.scores import PlaceScores, weakest_place
from estimator.information.shear import ShearScores
from estimator.information.weak_areas import WeakAreas
from instobj.figures.maps.overview import FaceMap, draw_overview
from instobj.figures.maps.scale import BOUND_COLOURS, GAIN_COLOURS


@dataclass(frozen=True)
class ScoreMap:
    """One score as a map: field of `PlaceScores`, file stem, title, unit, scale."""

    field: str
    stem: str
    title: str
    unit: str
    log: bool
    colours: str

    @property
    def file_name(self) -> str:
        """Name of its picture."""
        return f"{self.stem}_overview.png"


SCORE_MAPS = (
    ScoreMap("position_bound_mm", "position_bound", "Position bound", "mm", True, BOUND_COLOURS),
    ScoreMap("force_bound_n", "force_bound", "Force bound", "N", True, BOUND_COLOURS),
    ScoreMap("detectable_force_n", "detectable", "Detectable force", "N", True, BOUND_COLOURS),
    ScoreMap("delta_raw", "delta", "Convex-hull sensitivity δ", "", True, GAIN_COLOURS),
    ScoreMap("stiffness_n_per_mm", "stiffness", "Force per depth", "N/mm", False, GAIN_COLOURS),
)


def unit_of(score_map: ScoreMap, spec: ObjectSpec) -> str:
    """Unit of a map; δ is a volume in as many dimensions as a face has channels."""
    return score_map.unit or f"counts^{3 * spec.sensors.count_per_face}/N"


def draw_score_maps(
    spec: ObjectSpec, scores: PlaceScores, folder: Path, step: Callable[[str], None]
) -> None:
    """Write a picture for every score; that of position bounds says more."""
    for score_map in SCORE_MAPS:
        step(f"map of {score_map.title.lower()}")
        whose = f" of a contact of {spec.score.force_n:g} N" * (
            score_map.field != "detectable_force_n"
        )
        face_map = FaceMap(
            f"{score_map.title}{whose}",
            unit_of(score_map, spec),
            getattr(scores, score_map.field),
            score_map.log,
            score_map.colours,
        )
        if score_map.field == "position_bound_mm":
            face_map = _with_position_notes(spec, scores, face_map)
        draw_overview(spec, face_map, folder / score_map.file_name)


def _with_position_notes(spec: ObjectSpec, scores: PlaceScores, face_map: FaceMap) -> FaceMap:
    weakest = weakest_place(scores)
    whose = "each face's own" if spec.score.channels == "own" else "all"
    note = (
        f"Cramér–Rao bound √(σx² + σy²) from {whose} sensors, fresh baseline. Weakest: "
        f"{weakest.position_bound_mm:.2f} mm on face {weakest.face} at "
        f"({weakest.x_mm:g}, {weakest.y_mm:g}) mm."
        + (f" {scores.exceeds_bound} (crossed)." if scores.exceeds_bound else "")
        + (f" {scores.unreached}." if scores.unreached else "")
    )
    directions, marked = scores.weakest_direction_deg, scores.misread
    return replace(face_map, note=note, direction_deg=directions, marked=marked)


@dataclass(frozen=True)
class _MeasureMap:
    """A measure of contact locations as a map; `factor` brings it to its unit."""

    stem: str
    title: str
    unit: str = "mm"
    factor: float = 1.0
    colours: str = BOUND_COLOURS


_MEASURE_MAPS = {
    "border_mm": _MeasureMap(
        "border_distance", "Distance to the border of the patch", colours=GAIN_COLOURS
    ),
    "magnet_mm": _MeasureMap("magnet_distance", "Distance to the nearest magnet"),
    "path_mm": _MeasureMap("signal_path", "Signal path over a magnet to a sensor"),
    "curvature_per_mm": _MeasureMap("curvature", "Mean curvature", "1/m", 1000.0, GAIN_COLOURS),
}


def draw_measure_maps(
    spec: ObjectSpec,
    scores: PlaceScores,
    areas: WeakAreas,
    folder: Path,
    step: Callable[[str], None],
) -> None:
    """Overviews of the measures that vary over the object, its weakest tenth crossed."""
    bound, is_judged = scores.position_bound_mm, scores.judged
    weakest = is_judged & (bound >= np.quantile(bound[is_judged], 0.9, method="lower"))
    for name, measure in _MEASURE_MAPS.items():
        if name not in areas.rank_correlation:
            continue
        step(f"map of the {measure.title.lower()}")
        note = (
            "Crossed: the tenth of the contact locations with the largest position bounds. "
            f"Rank correlation with the bound: {areas.rank_correlation[name]:+.2f}."
        )
        values = measure.factor * getattr(areas.measures, name)
        face_map = FaceMap(
            measure.title, measure.unit, values, False, measure.colours, note=note, marked=weakest
        )
        draw_overview(spec, face_map, folder / f"{measure.stem}_overview.png")


def draw_shear_maps(spec: ObjectSpec, scores: ShearScores, folder: Path) -> None:
    """Overviews of the position and tangential-force bounds where both are unknown."""
    unknowns = f"location, normal and tangential force all unknown, {spec.score.force_n:g} N"
    position = FaceMap(
        "Position bound with tangential force",
        "mm",
        scores.position_bound_mm,
        note=f"Cramér–Rao bound √(σx² + σy²), fresh baseline: {unknowns}.",
    )
    tangential = FaceMap(
        "Bound of the tangential force",
        "N",
        scores.tangential_force_bound_n,
        note=f"Cramér–Rao bound √(σFx² + σFy²), fresh baseline: {unknowns}.",
    )
    draw_overview(spec, position, folder / "position_bound_sheared_overview.png")
    draw_overview(spec, tangential, folder / "tangential_force_bound_overview.png")


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
    title = f"Disturbance of the most affected other face by a press of {cross.force_n:g} N"
    note = (
        "Length of the signal change in the other face's own channels. Median over all locations, "
        f"{medians_text}."
    )
    face_map = FaceMap(title, "σ of a fresh baseline", largest, note=note)
    draw_overview(spec, face_map, folder / "cross_face_overview.png")
