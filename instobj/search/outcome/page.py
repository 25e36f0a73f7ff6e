"""The page of a layout search, self-contained: what it found, and how far to trust it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from design.files import atomic_path
from design.layout.pockets import magnet_bodies
from design.spec.object import ObjectSpec
from instobj.report.elements import image, note, page, table, text
from instobj.search.fidelity import METRIC_LABELS
from instobj.search.outcome.figures import (
    LABELS,
    draw_convergence,
    draw_front,
    draw_moves,
    draw_rungs,
    paired,
)
from instobj.stages.chain import Chain

if TYPE_CHECKING:
    from instobj.search.outcome.history import History
    from instobj.search.promotion import Climb, Climber

Say = Callable[[str], None]
_RUNGS = {"1": "first rung", "2": "second rung", "3": "last rung"}


def write_search_page(
    start: ObjectSpec, found: Climb, history: History, folder: Path, step: Say
) -> Path:
    """Write `search.html` with its figures, and return where it is."""
    step("maps before and after, figures and page")
    sections = [
        _verdict(found),
        _maps(found, folder / "figures"),
        _moves(start, found.best.spec, folder / "figures"),
        _robustness(found),
        _estimators(found),
        _ladder(found, history.names, folder / "figures"),
        _search(history, folder / "figures"),
        _parts(found.best.spec),
    ]
    path = folder / "search.html"
    with atomic_path(path) as temporary:
        temporary.write_text(page(f"Layout search of {start.name}", sections), encoding="utf-8")
    return path


def _verdict(found: Climb) -> str:
    word, style = ("BETTER", "go") if found.better else ("NOT BETTER", "no-go")
    stated = (
        "By the last rung, and for 95 % of pairs of objects built within tolerance."
        if found.better
        else f"Not confirmed by the last rung: {'; '.join(found.objections)}. The best finalist is shown "
        "all the same."
    )
    rows = [
        [_label(name), f"{before:.4g}", f"{after:.4g}", _change(name, before, after)]
        for (name, before), after in zip(
            asdict(found.start.rungs["3"]).items(),
            asdict(found.best.rungs["3"]).values(),
            strict=True,
        )
    ]
    return (
        f"<h1>Layout search <span class='{style}'>{word}</span></h1>"
        f"<p>{text(found.best.label)} against the start. {text(stated)}</p>"
        + table(["last rung: the whole chain", "start", "found", "change"], rows)
    )


def _change(name: str, before: float, after: float) -> str:
    if name == "saturation_margin":
        return f"{after - before:+.3f}"
    return f"× {after / before:.2f}"


def _label(name: str) -> str:
    return LABELS.get(name, "share of the sensors' range left free")


def _maps(found: Climb, folder: Path) -> str:
    """Position bound of every place, both on one scale."""
    from estimator.information.scores import load_scores_csv
    from instobj.figures.heatmaps import draw_overview, finite_limits

    pair = {"before": found.start.spec, "after": found.best.spec}
    scores = {
        when: load_scores_csv(Chain(spec).require("scores").folder / "scores.csv")
        for when, spec in pair.items()
    }
    every = np.concatenate([one.position_bound_fresh_mm.ravel() for one in scores.values()])
    pictures = []
    for when, one in scores.items():
        values, path = one.position_bound_fresh_mm, folder / f"position_bound_{when}.png"
        worst, middle = np.nanmax(values), np.nanmedian(values)
        draw_overview(
            values,
            one.faces,
            pair[when],
            f"Position bound {when} the search, {pair[when].score.force_n:g} N",
            "mm",
            *finite_limits(every),
            path,
            note=f"Worst place {worst:.2f} mm, median {middle:.2f} mm, freshly zeroed.",
        )
        pictures.append(image(path, f"Position bound {when}"))
    return f"<h2>Before and after</h2><div class='grid'>{''.join(pictures)}</div>" + note(
        "One colour scale for both, from the chain's own scores of all faces."
    )


def _moves(start: ObjectSpec, found: ObjectSpec, folder: Path) -> str:
    draw_moves(start, found, folder / "moves.png")
    before, after = magnet_bodies(start)[0], magnet_bodies(found)[0]
    old, new = (np.array([b.centre_mm for b in bodies]) for bodies in (before, after))
    tilts = found.magnets.tilt_deg or ((0.0, 0.0),) * len(new)
    rows = [
        [
            f"magnet {j + 1}",
            _point(old[i]),
            _point(new[j]),
            f"{np.linalg.norm(new[j] - old[i]):.1f}",
            f"{tilts[j][0]:g}, {tilts[j][1]:g}",
            "outward" if found.magnets.polarities[j] > 0 else "inward",
        ]
        for i, j in paired(old[:, :2], new[:, :2])
    ]
    seen = [np.array([p[:2] for p in one.sensors.places[0]]) for one in (start, found)]
    rows += [
        [
            f"sensor {j + 1}, face 1",
            _point(seen[0][i]),
            _point(seen[1][j]),
            f"{np.linalg.norm(seen[1][j] - seen[0][i]):.1f}",
            "",
            "",
        ]
        for i, j in paired(*seen)
    ]
    header = ["part", "from: x, y, depth, mm", "to", "moved, mm", "tilt about x, y, °", "north"]
    others = [
        f"{label} {old_value} → {new_value}"
        for label, old_value, new_value in _other_changes(start, found)
        if old_value != new_value
    ]
    return (
        "<h2>What moved</h2>"
        + image(folder / "moves.png", "Face before and after")
        + table(header, rows)
        + note("Also changed: " + "; ".join(others) if others else "Nothing else changed.")
    )


def _other_changes(start: ObjectSpec, found: ObjectSpec) -> list[tuple[str, str, str]]:
    def stated(spec: ObjectSpec) -> list[str]:
        size = " × ".join(f"{edge:g}" for edge in spec.body.size_mm)
        magnets, sensors = spec.magnets, spec.sensors
        return [
            str(len(magnets.positions_mm)),
            f"Ø{magnets.diameter_mm:g} × {magnets.height_mm:g} mm",
            str(sensors.count_per_face),
            f"{sensors.chip}, turned {sensors.mount_rotation_deg[2]:g}°",
            f"±{sensors.range_mt:g} mT",
            f"{spec.shell.thickness_mm:g} mm",
            spec.silicone.name,
            f"{size} mm",
        ]

    labels = ("magnets per face", "magnet", "sensors per face", "chips", "range", "shell", "silicone",
              "body")  # fmt: skip
    return list(zip(labels, stated(start), stated(found), strict=True))


def _point(values: np.ndarray) -> str:
    return ", ".join(f"{abs(v) if k == 2 else v:.2f}" for k, v in enumerate(values))


def _robustness(found: Climb) -> str:
    rows = [
        [_label(name), f"{ratio.design:.2f}", f"{ratio.low:.2f} to {ratio.high:.2f}"]
        for name, ratio in found.ratios.items()
    ]
    return (
        "<h2>Within tolerance</h2>"
        + table(["start's bound over the found one's", "designs", "95 % of pairs of twins"], rows)
        + note(
            "Twins are objects drawn within [tolerances]; each of the start is compared with each of the "
            "found layout. Above 1 the found layout is better."
        )
    )


def _estimators(found: Climb) -> str:
    columns = (found.start.label, *(one.label for one in found.finalists))
    rows = [
        [label, *(_given(found.estimators[column].get(name)) for column in columns)]
        for name, label in METRIC_LABELS.items()
    ]
    return (
        "<h2>Estimators</h2>"
        + table(["mean of faces", *columns], rows)
        + note(
            "Trained for each layout on simulated presses of the same protocol, judged on whole presses "
            "held out; simulated throughout."
        )
    )


def _given(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}"


def _ladder(found: Climb, objectives: tuple[str, ...], folder: Path) -> str:
    named = [name for name in objectives if name in found.correlations["1"]]
    shown = named or ["worst_position_bound_mm"]  # cost is the same on every rung
    everyone = (found.start, *found.leaders)
    counts = {rung: sum(rung in one.rungs for one in everyone) for rung in _RUNGS}
    pictures = []
    for name in shown:
        draw_rungs(found, name, folder / f"rungs_{name}.png")
        rows = [[one.label, *(_on(one, rung, name) for rung in _RUNGS)] for one in everyone]
        pictures.append(image(folder / f"rungs_{name}.png", "Scores on one rung against the next"))
        pictures.append(table([LABELS[name], *_RUNGS.values()], rows))
    ranks = [
        [_label(score), *(_rank(found.correlations[rung][score]) for rung in ("1", "2"))]
        for score in found.correlations["1"]
    ]
    header = [
        "rank correlation (Spearman)",
        f"first to second, {counts['2']} layouts",
        f"second to last, {counts['3']} layouts",
    ]
    return (
        "<h2>From rung to rung</h2>"
        + "".join(pictures)
        + table(header, ranks)
        + note(
            "1 is the same order, 0 none, −1 the reverse; with as few layouts as these one swap of "
            "two neighbours is worth 0.2 (four layouts) to 0.06 (six). The start is among them. "
            "First: magnets without stiffness, signals linear in their motions. Second: rigid magnets, "
            "contact and fields in full. Last: a mesh that resolves the magnets. Correlations are among "
            "layouts that the rung below had already chosen, where they differ least."
        )
    )


def _on(one: Climber, rung: str, name: str) -> str:
    return f"{getattr(one.rungs[rung], name):.3g}" if rung in one.rungs else "–"


def _rank(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else "–"


def _search(history: History, folder: Path) -> str:
    draw_convergence(history, folder / "convergence.png")
    pictures = image(folder / "convergence.png", "Best so far against layouts scored")
    if len(history.names) > 1:
        draw_front(history, folder / "front.png")
        pictures += image(folder / "front.png", "Pareto front")
    trials, kept = len(history.values), int(history.feasible.sum())
    return (
        "<h2>The search</h2>"
        + pictures
        + note(
            f"{trials} trials, {kept} of them within all limits, {history.scorings_per_trial} layouts "
            f"scored for each; random search was given as many, 8192 at most, and found "
            f"{len(history.random)} within all limits."
        )
    )


def _parts(spec: ObjectSpec) -> str:
    from design.build.manifest import BuildManifest

    folder = Chain(spec).require("build").folder
    rows = [
        [part.name, f"{part.volume_mm3:.2f}", "yes" if part.stl_watertight else "NO"]
        for part in BuildManifest.read(folder).parts
    ]
    return (
        "<h2>Parts of the found layout</h2>"
        + image(folder / "parts.png", "Core, shell and mould")
        + table(["part", "volume, mm³", "STL watertight"], rows)
    )
