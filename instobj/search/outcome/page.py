"""Page of a layout search, self-contained: what it found, and how far to trust it."""

from __future__ import annotations

import base64
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.files import atomic_path
from design.layout.places.contact_places import contact_places
from design.layout.places.coverage import covered_share
from design.spec.object import ObjectSpec
from estimator.information.fisher import SUFFIXES
from estimator.information.scores import on_places
from estimator.layouts.fidelity import MARGINS, SCORE_NAMES, bounds_by_press
from instobj.report.pages import render, shown
from instobj.search.fidelity import METRIC_LABELS
from instobj.search.outcome.figures import (
    LABELS,
    draw_convergence,
    draw_front,
    draw_levels,
)
from instobj.search.outcome.layouts import ShownLayout, layouts_scene
from instobj.search.outcome.moves import moved_parts
from instobj.store.readers import CROSS_FACE, MANIFEST, PARTS_PICTURE, SCORES

if TYPE_CHECKING:
    from instobj.search.outcome.history import History
    from instobj.search.verdict import Promoted, Promotion

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
    found: Promotion,
    history: History,
    layouts: Sequence[ShownLayout],
    results: ChainResults,
    folder: Path,
    step: Say,
) -> Path:
    """Write `search.html` with its figures, and return where it is."""
    step("maps before and after, figures and page")
    figures = folder / "figures"
    page = render(
        "search.html.j2",
        name=start.name,
        found=found,
        covered=covered_share(found.best.spec),
        history=history,
        objectives=len(history.names),
        scene=base64.b64encode(layouts_scene(layouts, history)).decode(),
        level=_LEVELS[found.level],
        highest=_highest(found) + _cross_face(results),
        maps=_maps(found, results, figures),
        ratios=[
            [_label(name), f"{ratio.design:.2f}", f"{ratio.low:.2f} to {ratio.high:.2f}"]
            for name, ratio in found.ratios.items()
        ],
        parts=_parts(results.parts),
        parts_picture=PARTS_PICTURE.path(results.parts),
        **moved_parts(start, found.best.spec, figures),
        **_estimators(found),
        **_levels(found, history.names, figures),
        **_search(history, figures),
        **_forces(found, figures),
    )
    path = folder / "search.html"
    with atomic_path(path) as temporary:
        temporary.write_text(page, encoding="utf-8")
    return path


def _highest(found: Promotion) -> list[list[str]]:
    return [
        [_label(name), f"{before:.4g}", f"{after:.4g}", _change(name, before, after)]
        for name in SCORE_NAMES
        for before, after in [
            [getattr(one.levels[found.level], name) for one in (found.start, found.best)]
        ]
        if not isnan(before)  # what this object has none of
    ]


def _cross_face(results: ChainResults) -> list[list[str]]:
    """The largest false force by an adjacent face: the scores above are percentiles."""
    if results.scores is None:
        return []
    before, after = (
        CROSS_FACE.read(folder)["adjacent"].get(_LARGEST, 0.0) for folder in results.scores
    )
    if not before:
        return []
    label = "false force by the next face (N), largest"
    return [[label, f"{before:.4g}", f"{after:.4g}", _change(_LARGEST, before, after)]]


def _forces(found: Promotion, folder: Path) -> dict[str, Any]:
    """Bounds force by force, and where a location is worse than it was."""
    from instobj.figures.maps.overview import draw_overview
    from instobj.figures.maps.scale import finite_limits

    spec, faces = found.best.spec, found.best.spec.body.sensed
    forces = spec.scoring_forces_n
    before, after = (
        bounds_by_press(spec, one.levels[found.level]) for one in (found.start, found.best)
    )
    ratio = {key: after[key] / bound for key, bound in before.items()}
    rows = []
    for force in forces:
        row, own = [f"{force:g}"], [(force, face) for face in faces]
        old, new, over = (
            np.concatenate([by_press[key] for key in own]) for by_press in (before, after, ratio)
        )
        for percent in (100, 99, 50):
            pair = [float(np.nanpercentile(bounds, percent)) for bounds in (old, new)]
            row += [f"{pair[0]:.3g} → {pair[1]:.3g}", f"{pair[0] / pair[1]:.2f}"]
        rows.append([*row, f"{100 * np.mean(over[~np.isnan(over)] > 1):.1f} %"])
    path = folder / "position_bound_over_start.png"
    largest = on_places(
        contact_places(spec),
        [np.fmax.reduce([ratio[force, face] for force in forces]) for face in faces],
    )
    every_ratio = np.concatenate(list(ratio.values()))
    worse = np.mean(every_ratio[~np.isnan(every_ratio)] > 1)
    every = ", ".join(f"{force:g}" for force in forces)
    draw_overview(
        largest,
        np.array(faces),
        spec,
        f"Position bound after the search over before, largest of {every} N",
        "times",
        *finite_limits(largest.ravel()),
        path,
        note=f"Above 1 a location got worse: {100 * worse:.1f} % of locations and forces.",
    )
    header = ["N", "worst, mm", "times better", "99 %, mm", "times better", "median, mm"]
    header += ["times better", "locations worse"]
    return {"force_header": header, "forces": rows, "over_start": path}


def _change(name: str, before: float, after: float) -> str:
    if name in MARGINS:
        return f"{after - before:+.3f}"
    return f"× {after / before:.2f}"


def _label(name: str) -> str:
    return LABELS.get(name, "share of the sensors' range left free")


def _maps(found: Promotion, results: ChainResults, folder: Path) -> list[tuple[str, Path]]:
    """Pictures of the position bound of every place, both on one scale."""
    from instobj.figures.maps.overview import draw_overview
    from instobj.figures.maps.scale import finite_limits

    if results.scores is None:
        return []
    pair = {"before": found.start.spec, "after": found.best.spec}
    scores = {when: SCORES.read(one) for when, one in zip(pair, results.scores, strict=True)}
    baseline = found.start.spec.search.baseline
    bounds = {
        when: getattr(one, f"position_bound{SUFFIXES[baseline]}_mm") for when, one in scores.items()
    }
    every = np.concatenate([values.ravel() for values in bounds.values()])
    pictures = []
    for when, one in scores.items():
        values, path = bounds[when], folder / f"position_bound_{when}.png"
        worst, middle = np.nanmax(values), np.nanmedian(values)
        draw_overview(
            values,
            one.faces,
            pair[when],
            f"Position bound {when} the search, {pair[when].score.force_n:g} N",
            "mm",
            *finite_limits(every),
            path,
            note=f"Worst location {worst:.2f} mm, median {middle:.2f} mm, {baseline} baseline.",
        )
        pictures.append((when, path))
    return pictures


def _estimators(found: Promotion) -> dict[str, Any]:
    columns = tuple(found.estimators)
    rows = [
        [label, *(shown(found.estimators[column].get(name)) for column in columns)]
        for name, label in METRIC_LABELS.items()
        if columns
    ]
    return {"estimator_header": ["mean of faces", *columns], "estimators": rows}


def _levels(found: Promotion, objectives: tuple[str, ...], folder: Path) -> dict[str, Any]:
    named = [name for name in objectives if name in found.correlations["1"]]
    everyone = (found.start, *found.leaders)
    counts = {level: sum(level in one.levels for one in everyone) for level in _LEVELS}
    scores = []
    for name in named or ["worst_position_bound_mm"]:  # those of parts are the same at all
        draw_levels(found, name, folder / f"rungs_{name}.png")
        rows = [[one.label, *(_on(one, level, name) for level in _LEVELS)] for one in everyone]
        header = [LABELS[name], *_LEVELS.values()]
        scores.append({"picture": folder / f"rungs_{name}.png", "header": header, "rows": rows})
    return {
        "levels": scores,
        "rank_header": [
            "rank correlation (Spearman)",
            f"lowest to second, {counts['2']} layouts",
            f"second to highest, {counts['3']} layouts",
        ],
        "ranks": [
            [_label(score), *(_rank(found.correlations[level][score]) for level in ("1", "2"))]
            for score in found.correlations["1"]
        ],
    }


def _on(one: Promoted, level: str, name: str) -> str:
    return shown(getattr(one.levels[level], name) if level in one.levels else None)


def _rank(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else "–"


def _search(history: History, folder: Path) -> dict[str, Any]:
    draw_convergence(history, folder / "convergence.png")
    front = folder / "front.png" if len(history.names) > 1 else None
    if front is not None:
        draw_front(history, front)
    return {
        "convergence": folder / "convergence.png",
        "front": front,
        "trials": len(history.values),
        "kept": int(history.feasible.sum()),
    }


def _parts(folder: Path) -> list[list[str]]:
    return [
        [part.name, f"{part.volume_mm3:.2f}", "yes" if part.stl_watertight else "NO"]
        for part in MANIFEST.read(folder).parts
    ]
