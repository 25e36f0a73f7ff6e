"""Page of a layout search, self-contained: what it found, and how far to trust it."""

from __future__ import annotations

import base64
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.layout.places.contact_places import contact_places
from design.layout.places.coverage import covered_share
from design.spec.object import ObjectSpec
from estimator.information.scores import fill_places
from estimator.layouts.fidelity import MARGINS, SCORE_NAMES, bounds_by_press
from instobj.report.pages import write_page
from instobj.search.outcome.figures import LABELS, draw_convergence
from instobj.search.outcome.layouts import ShownLayout, layouts_scene
from instobj.search.outcome.moves import moved_parts
from instobj.search.outcome.rows import promotion_tables, ratio_rows
from instobj.search.verdict import best_known
from instobj.store.readers import CROSS_FACE, MANIFEST, PARTS_PICTURE, SCORES

if TYPE_CHECKING:
    from instobj.search.outcome.history import History
    from instobj.search.verdict import Promotion

Say = Callable[[str], None]
_LEVELS = {
    "1": "lowest fidelity level",
    "2": "second fidelity level",
    "3": "highest fidelity level",
}


_LARGEST = "largest_false_force_n"


@dataclass(frozen=True)
class ChainResults:
    """Folders of the chain's results that the page shows: the parts; scores before and after, where the
    chain has scored both."""

    parts: Path
    scores: tuple[Path, Path] | None


def write_search_page(
    start: ObjectSpec,
    promotion: Promotion,
    history: History,
    layouts: Sequence[ShownLayout],
    results: ChainResults,
    folder: Path,
    step: Say,
) -> Path:
    """Write `search.html` with its figures, and return where it is."""
    step("maps before and after, figures and page")
    figures = folder / "figures"
    return write_page(
        folder / "search.html",
        "search.html.j2",
        name=start.name,
        found=promotion,
        start_kept=best_known(start.search, promotion) is promotion.start,
        covered=covered_share(promotion.best.spec),
        history=history,
        objectives=len(history.names),
        scene=base64.b64encode(layouts_scene(layouts, history)).decode(),
        level=_LEVELS[promotion.level],
        highest=_highest(promotion) + _cross_face(results),
        maps=_maps(promotion, results, figures),
        ratios=ratio_rows(promotion),
        tables=promotion_tables(promotion),
        parts=_parts(results.parts),
        parts_picture=PARTS_PICTURE.path(results.parts),
        **moved_parts(start, promotion.best.spec),
        **_search(history, figures),
        **_forces(promotion, figures),
    )


def _highest(promotion: Promotion) -> list[list[str]]:
    return [
        [
            LABELS[name],
            f"{start_score:.4g}",
            f"{best_score:.4g}",
            _change(name, start_score, best_score),
        ]
        for name in SCORE_NAMES
        for start_score, best_score in [
            [
                getattr(layout.levels[promotion.level], name)
                for layout in (promotion.start, promotion.best)
            ]
        ]
        if not isnan(start_score)  # what this object has none of
    ]


def _cross_face(results: ChainResults) -> list[list[str]]:
    """The largest false force by an adjacent face: the scores above are percentiles."""
    if results.scores is None:
        return []
    start_force, best_force = (
        CROSS_FACE.read(folder)["adjacent"].get(_LARGEST, 0.0) for folder in results.scores
    )
    if not start_force:
        return []
    label = "false force by the next face (N), largest"
    return [
        [
            label,
            f"{start_force:.4g}",
            f"{best_force:.4g}",
            _change(_LARGEST, start_force, best_force),
        ]
    ]


def _forces(promotion: Promotion, folder: Path) -> dict[str, Any]:
    """Bounds force by force, and where a location is worse than it was."""
    from instobj.figures.maps.overview import FaceMap, draw_overview

    spec, faces = promotion.best.spec, promotion.best.spec.body.sensed
    forces = spec.scoring_forces_n
    start_bounds, best_bounds = (
        bounds_by_press(spec, layout.levels[promotion.level])
        for layout in (promotion.start, promotion.best)
    )
    ratio = {key: best_bounds[key] / bound for key, bound in start_bounds.items()}
    rows = []
    for force in forces:
        row, face_keys = [f"{force:g}"], [(force, face) for face in faces]
        old, new, over = (
            np.concatenate([by_press[key] for key in face_keys])
            for by_press in (start_bounds, best_bounds, ratio)
        )
        for percent in (100, 99, 50):
            pair = [float(np.nanpercentile(bounds, percent)) for bounds in (old, new)]
            row += [f"{pair[0]:.3g} → {pair[1]:.3g}", f"{pair[0] / pair[1]:.2f}"]
        rows.append([*row, f"{100 * np.mean(over[~np.isnan(over)] > 1):.1f} %"])
    path = folder / "position_bound_over_start.png"
    largest = fill_places(
        contact_places(spec),
        [np.fmax.reduce([ratio[force, face] for force in forces]) for face in faces],
    )
    every_ratio = np.concatenate(list(ratio.values()))
    worse = np.mean(every_ratio[~np.isnan(every_ratio)] > 1)
    force_list = ", ".join(f"{force:g}" for force in forces)
    title = f"Position bound after the search over before, largest of {force_list} N"
    note = f"Above 1 a location got worse: {100 * worse:.1f} % of locations and forces."
    draw_overview(spec, FaceMap(title, "times", largest, note=note), path)
    header = ["N", "worst, mm", "times better", "99 %, mm", "times better", "median, mm"]
    header += ["times better", "locations worse"]
    return {"force_header": header, "forces": rows, "over_start": path}


def _change(name: str, old_value: float, new_value: float) -> str:
    if name in MARGINS:
        return f"{new_value - old_value:+.3f}"
    return f"× {new_value / old_value:.2f}"


def _maps(promotion: Promotion, results: ChainResults, folder: Path) -> list[tuple[str, Path]]:
    """Pictures of the position bound of every place, both on one scale."""
    from instobj.figures.maps.overview import FaceMap, draw_overview
    from instobj.figures.maps.scale import finite_limits

    if results.scores is None:
        return []
    pair = {"before": promotion.start.spec, "after": promotion.best.spec}
    scores = {when: SCORES.read(score) for when, score in zip(pair, results.scores, strict=True)}
    bounds = {when: score.position_bound_mm for when, score in scores.items()}
    limits = finite_limits(np.concatenate([values.ravel() for values in bounds.values()]))
    pictures = []
    for when, values in bounds.items():
        worst, middle = np.nanmax(values), np.nanmedian(values)
        face_map = FaceMap(
            f"Position bound {when} the search, {pair[when].score.force_n:g} N",
            "mm",
            values,
            limits=limits,
            note=f"Worst location {worst:.2f} mm, median {middle:.2f} mm.",
        )
        path = folder / f"position_bound_{when}.png"
        draw_overview(pair[when], face_map, path)
        pictures.append((when, path))
    return pictures


def _search(history: History, folder: Path) -> dict[str, Any]:
    draw_convergence(history, folder / "convergence.png")
    return {
        "convergence": folder / "convergence.png",
        "trials": len(history.values),
        "kept": int(history.feasible.sum()),
    }


def _parts(folder: Path) -> list[list[str]]:
    return [
        [part.name, f"{part.volume_mm3:.2f}", "yes" if part.stl_watertight else "NO"]
        for part in MANIFEST.read(folder).parts
    ]
