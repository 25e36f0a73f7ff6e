"""Figures of a layout search: how it converged, its front, what moved, how fidelity levels agree."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.layout.pockets import Body, magnet_bodies, sensor_places
from design.search.faces import layout_groups
from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from instobj.search.outcome.history import History
    from instobj.search.verdict import Promotion

_INK, _PAPER, _GREY = "#1a1a1a", "#fdfdfb", "#9a968d"
_BEST, _START = "#1f77d0", "#77736b"
_PEERS = "#c46a1b", "#7a4fb5"
_SENSOR = "#0a8f5a"
_MOST_SIDE_BY_SIDE = 3
"""Panels of a row, at most."""
LABELS = {
    "worst_position_bound_mm": "worst location, position bound (mm)",
    "percentile_99_position_bound_mm": "99th percentile of locations, position bound (mm)",
    "median_position_bound_mm": "median location, position bound (mm)",
    "position_over_limit": "position bound over its limit, mean of what is beyond",
    "worst_force_bound_n": "worst location, force bound (N)",
    "median_false_force_n": "false force by the next face (N), median",
    "percentile_95_false_force_n": "false force by the next face (N), 95th percentile",
    "sensitivity_ratio": "δ, 5th over 50th percentile",
}


def draw_convergence(history: History, path: Path) -> None:
    """Best feasible first objective against layouts scored, compared with plain engines (PNG)."""
    from instobj.search.outcome.history import best_so_far

    figure, axes = _figure((8.2, 4.6))
    name, values = history.names[0], history.values[:, 0]
    scorings = history.scorings
    axes.plot(scorings[history.feasible], values[history.feasible], ".", color=_GREY, ms=4,
              label="trials within all limits")  # fmt: skip
    axes.step(scorings, best_so_far(name, values, history.feasible), where="post", color=_BEST, lw=2.2,
              label="search, best so far")  # fmt: skip
    for peer, colour in zip(history.peers, _PEERS, strict=False):
        best = best_so_far(name, peer.values, np.ones(len(peer.values), bool))
        label = "best so far" if len(best) else "none within all limits"
        scorings, to_the_end = np.append(peer.scorings, peer.scored), np.append(best, best[-1:])
        axes.step(scorings[: len(to_the_end)], to_the_end, where="post", color=colour, lw=1.8,
                  label=f"{peer.name}, {label}")  # fmt: skip
    axes.axhline(history.start[0], color=_START, ls="--", lw=1.4, label="start")
    axes.set(xscale="log", yscale="log", xlabel="layouts scored at the lowest fidelity level")
    axes.set(ylabel=LABELS[name], title="Convergence at the lowest fidelity level")
    _plain(axes.yaxis)
    figure.legend(loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    save_figure(figure, path)


def draw_front(history: History, path: Path) -> None:
    """Two objectives of all feasible trials, with the front: trials that none is better than in both
    (PNG)."""
    from design.spec.search import OBJECTIVES_TO_MAXIMIZE

    figure, axes = _figure((6.8, 5.2))
    pair, feasible = history.names[:2], history.values[history.feasible, :2]
    sign = np.array([-1.0 if name in OBJECTIVES_TO_MAXIMIZE else 1.0 for name in pair])
    ahead = pareto_front(sign * feasible)
    axes.plot(*feasible[~ahead].T, ".", color=_GREY, ms=5, label="trials within all limits")
    front = feasible[ahead][np.argsort(feasible[ahead, 0])]
    axes.step(*front.T, "o-", where="post", color=_BEST, lw=1.6, ms=6, label="Pareto front")
    axes.plot(*history.start[:2], "X", color=_START, ms=11, label="start")
    axes.set(xlabel=LABELS[pair[0]], ylabel=LABELS[pair[1]], xscale="log", yscale="log")
    axes.set_title("Pareto front, low-fidelity model")
    _plain(axes.xaxis)
    _plain(axes.yaxis)
    figure.legend(loc="outside lower center", ncols=4, frameon=False, fontsize=9)
    save_figure(figure, path)


def draw_levels(promotion: Promotion, name: str, path: Path) -> None:
    """One score of every layout at a level against the next (PNG)."""
    figure, rows = _figure((9.6, 4.6), 2)
    for axes, (lower, upper) in zip(rows, (("1", "2"), ("2", "3")), strict=True):
        layouts = [
            layout for layout in (promotion.start, *promotion.leaders) if upper in layout.levels
        ]
        pairs = np.array(
            [[getattr(layout.levels[r], name) for r in (lower, upper)] for layout in layouts]
        )
        colours = [_START] + [_BEST] * (len(pairs) - 1)
        axes.scatter(*pairs.T, c=colours, s=46, zorder=3)
        for layout, (x, y) in zip(layouts, pairs, strict=True):
            axes.annotate(
                layout.label, (x, y), xytext=(6, 5), textcoords="offset points", fontsize=8
            )
        ends = [0.0, 1.12 * pairs.max()]
        axes.plot(ends, ends, color=_GREY, lw=1, ls=":", label="equal")
        correlation = promotion.correlations[lower][name]
        stated = (
            f"rank correlation {correlation:.2f}" if np.isfinite(correlation) else "too few to rank"
        )
        axes.set(
            xlim=ends,
            ylim=ends,
            xlabel=f"fidelity level {lower}",
            ylabel=f"fidelity level {upper}",
            title=stated,
        )
        axes.set_aspect("equal")
        axes.legend(frameon=False, fontsize=8, loc="upper left")
    figure.suptitle(f"How well one fidelity level predicts the next: {LABELS[name]}", fontsize=11)
    save_figure(figure, path)


def draw_moves(start: ObjectSpec, changed: ObjectSpec, path: Path) -> Figure:
    """Every layout seen from outside on its first face, before (grey) and after; arrows join the
    nearest (PNG)."""
    groups = layout_groups(changed)
    columns = min(len(groups), _MOST_SIDE_BY_SIDE)
    rows = -(-len(groups) // columns)
    side = 7.6 if len(groups) == 1 else 5.0
    figure, panels = _figure((columns * side, rows * side + 0.6), columns, rows)
    panels = np.atleast_1d(panels).ravel()
    for axes, faces in zip(panels, groups, strict=False):
        _draw_moves_of(axes, start, changed, faces)
    for axes in panels[len(groups) :]:
        axes.set_axis_off()
    figure.suptitle("Layout before and after")
    figure.legend(handles=_move_legend(), loc="outside lower center", ncols=4 if columns > 1 else 2,
                  frameon=False)  # fmt: skip
    save_figure(figure, path)
    return figure


def _draw_moves_of(
    axes: Any, start: ObjectSpec, changed: ObjectSpec, faces: tuple[int, ...]
) -> None:
    from matplotlib.patches import Ellipse, Rectangle
    from matplotlib.patheffects import withStroke

    row = changed.body.sensed.index(faces[0])
    frame = face_frames(changed)[row]
    start_magnets, changed_magnets = magnet_bodies(start)[row], magnet_bodies(changed)[row]
    sensors = [np.array(sensor_places(spec)[row])[:, :2] for spec in (start, changed)]
    edges = frame.half_extents_mm
    if frame.round:
        axes.add_patch(Ellipse((0, 0), 2 * edges[0], 2 * edges[1], fc="#efece4"))
    else:
        axes.add_patch(Rectangle((-edges[0], -edges[1]), 2 * edges[0], 2 * edges[1], fc="#efece4"))
    for body in start_magnets:
        _draw_magnet(axes, body, _GREY, "--")
    several = len(changed.magnets.numbers_by_kind) > 1
    kinds = [f", {kind}" if several else "" for kind in changed.magnets.kinds]
    for body, pole, kind in zip(changed_magnets, changed.magnets.polarities, kinds, strict=True):
        _draw_magnet(axes, body, _BEST, "-")
        mark = f"{'N out' if pole > 0 else 'N in'}, {-body.centre_mm[2]:.1f} mm{kind}"
        below = body.centre_mm[:2] - [0, body.outline.radius_mm + 0.9]
        label = axes.annotate(mark, below, ha="center", va="center", fontsize=8.5, color=_INK)
        label.set_path_effects([withStroke(linewidth=3, foreground="#efece4")])
    places = [
        np.array([body.centre_mm[:2] for body in bodies])
        for bodies in (start_magnets, changed_magnets)
    ]
    _draw_arrows(axes, places[0], places[1], _BEST)
    for points, colour, style in ((sensors[0], _GREY, "--"), (sensors[1], _SENSOR, "-")):
        for x, y in points:
            square = Rectangle(
                (x - 1.2, y - 1.2), 2.4, 2.4, fill=False, ec=colour, ls=style, lw=1.8
            )
            axes.add_patch(square)
    _draw_arrows(axes, sensors[0], sensors[1], _SENSOR)
    axes.set(xlim=(-edges[0] - 1, edges[0] + 1), ylim=(-edges[1] - 1, edges[1] + 1), aspect="equal")
    number = frame.number
    axes.set(xlabel=f"x of face {number} (mm)", ylabel=f"y of face {number} (mm)")
    if len(faces) > 1:
        several = ", ".join(map(str, faces))
        axes.set_title(f"faces {several} (before: face {number})", fontsize=10)


def _move_legend() -> list[Any]:
    from matplotlib.lines import Line2D

    hollow: dict[str, Any] = {"ls": "", "mfc": "none", "ms": 11}
    return [
        Line2D(
            [], [], marker="o", mec=_BEST, mew=2, label="magnet, north pole and depth", **hollow
        ),
        Line2D([], [], marker="s", mec=_SENSOR, mew=2, label="Hall sensor", **hollow),
        Line2D([], [], marker="o", mec=_GREY, mew=2, label="before", **hollow),
        Line2D([], [], color=_BEST, lw=3, label="where a tilted magnet's axis leans"),
    ]


def paired(
    old_places: Float[np.ndarray, "n 2"], new_places: Float[np.ndarray, "m 2"]
) -> list[tuple[int, int]]:
    """Return which of the old places became which of the new, by the least total distance."""
    from scipy.optimize import linear_sum_assignment

    away = np.linalg.norm(old_places[:, None] - new_places, axis=-1)
    rows, columns = linear_sum_assignment(away)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))


def _draw_magnet(axes: Any, body: Body, colour: str, style: str) -> None:
    from matplotlib.patches import Circle

    x, y = body.centre_mm[:2]
    axes.add_patch(Circle((x, y), body.outline.radius_mm, fill=False, ec=colour, ls=style, lw=2))
    lean = 8 * body.frame[:2, 2]
    if np.hypot(*lean) > 0.2:
        axes.plot([x, x + lean[0]], [y, y + lean[1]], color=colour, lw=3, solid_capstyle="round")


def _draw_arrows(axes: Any, old_places: np.ndarray, new_places: np.ndarray, colour: str) -> None:
    for i, j in paired(old_places, new_places):
        if np.hypot(*(new_places[j] - old_places[i])) > 0.5:
            arrow = {"arrowstyle": "-|>", "color": colour, "lw": 1.3, "alpha": 0.7}
            axes.annotate("", new_places[j], old_places[i], arrowprops=arrow)


def pareto_front(values: Float[np.ndarray, "n 2"]) -> np.ndarray:
    """Those that no other is better than or equal to in both (and better in one)."""
    no_worse = np.all(values[None] <= values[:, None], axis=2)
    better = np.any(values[None] < values[:, None], axis=2)
    return ~np.any(no_worse & better, axis=1)


def _figure(size: tuple[float, float], columns: int = 1, rows: int = 1) -> tuple[Any, Any]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, facecolor=_PAPER, layout="constrained")
    axes = figure.subplots(rows, columns)
    for panel in np.atleast_1d(axes).ravel():
        panel.spines[["top", "right"]].set_visible(False)
        panel.set_facecolor(_PAPER)
    return figure, axes


def _plain(axis: Any) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator

    axis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(FuncFormatter(lambda *_: ""))
