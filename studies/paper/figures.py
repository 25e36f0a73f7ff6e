"""Figures of the paper's experiments."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float, Num

from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from estimator.metrics.heatmaps import ContactErrors

_COLOURS = ("#1b6ca8", "#6a994e", "#b08900", "#7a5195", "#4f4f4f", "#c78fb4", "#57a0a0")
PAPER_COLOUR = "#c8553d"
_BOUND_COLOUR = "#9ab8cf"


def headline(what: str, quick: bool) -> str:
    """A figure's title: that all but the paper's figures is simulated, and whether it is a look."""
    return f"Simulated: {what}" + (
        " (quick form: reduced resolution, for a preview only)" if quick else ""
    )


_MOST_BARS = 12
"""Of panels that stand side by side."""


def draw_bars(
    rows: list[dict[str, Any]],
    group: str,
    panels: dict[str, dict[str, str]],
    title: str,
    path: Path,
) -> None:
    """Groups of bars with their values, a panel per axis label; its bars are columns by legend."""
    from matplotlib.figure import Figure

    bars = len(rows) * max(map(len, panels.values()))
    across = 1 if len(rows) > 4 or bars > _MOST_BARS else len(panels)
    down = len(panels) // across
    width = max(5.5, 1.2 + 1.6 * len(rows), 0.55 * bars)
    figure = Figure(figsize=(width * across, 4.2 * down), layout="constrained")
    figure.suptitle(textwrap.fill(title, int(11 * width * across)), fontsize=10)
    every = figure.subplots(down, across, squeeze=False).ravel()
    for axes, (label, series) in zip(every, panels.items(), strict=True):
        _group_bars(axes, rows, series)
        names = [textwrap.fill(f"{row[group]}", 20) for row in rows]
        axes.set_xticks(range(len(rows)), names)
        axes.set(ylabel=label, xlabel=group, xlim=(-0.55, len(rows) - 0.45))
        axes.set_ylim(0, 1.08 * axes.get_ylim()[1])
        axes.grid(axis="y", alpha=0.3)
        axes.set_axisbelow(True)
        if len(series) > 1:
            axes.legend(
                loc="upper center", bbox_to_anchor=(0.5, -0.22), ncols=min(len(series), 4), frameon=False,
                fontsize=9,
            )  # fmt: skip
    save_figure(figure, path)


def _group_bars(axes: Any, rows: list[dict[str, Any]], series: dict[str, str]) -> None:
    width = 0.8 / len(series)
    for index, (name, legend) in enumerate(series.items()):
        value = np.array([np.nan if row.get(name) is None else row[name] for row in rows], float)
        place = np.arange(len(rows)) + (index - (len(series) - 1) / 2) * width
        axes.bar(place, value, 0.92 * width, color=_colour(name, index), label=legend)
        for x, y in zip(place, value, strict=True):
            if np.isfinite(y):
                axes.annotate(f"{y:.3g}", (x, y), ha="center", va="bottom", fontsize=8)


def _colour(column: str, index: int) -> str:
    """The paper and bounds keep their colours from figure to figure."""
    fixed = {"paper": PAPER_COLOUR, "best": _BOUND_COLOUR, "possible": _BOUND_COLOUR}
    return fixed.get(column.split()[0].strip(","), _COLOURS[index % len(_COLOURS)])


def draw_histograms(errors: dict[str, ContactErrors], title: str, path: Path) -> None:
    """Share of contacts (or frames) with an error of at least so much, one line each."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 4.0), layout="constrained")
    figure.suptitle(title, fontsize=10)
    left, right = figure.subplots(1, 2)
    for (name, found), colour in zip(errors.items(), _COLOURS, strict=False):
        for axes, values in ((left, found.force_percent), (right, found.distance_px)):
            finite = np.sort(values[np.isfinite(values)])[::-1]
            share = (np.arange(len(finite)) + 1) / len(finite)
            axes.step(finite, share, where="post", color=colour, label=name)
    left.set(xlabel="force error E_f (% of the location's range)", xscale="log", xlim=(0.05, 200))
    left.set_ylabel("share of contacts with error ≥ x")
    right.set(xlabel="localisation error E_loc (pixels)", xlim=(-0.2, None))
    right.set_ylabel("share of frames with error ≥ x")
    for axes in (left, right):
        axes.set(yscale="log", ylim=(1e-4, 1.3))
        axes.grid(alpha=0.3)
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside lower center", ncols=5, frameon=False
    )
    save_figure(figure, path)


def draw_maps(
    maps: dict[str, Float[np.ndarray, "nx ny"]],
    title: str,
    path: Path,
    logarithmic: tuple[str, ...] = (),
    alike: bool = False,
    more_is_better: tuple[str, ...] = (),
) -> None:
    """Maps over a face's pixels, x to the right and y up, dark where it is good.

    `logarithmic` names those by decades; `alike` gives all one scale of colours.
    """
    from matplotlib.colors import LogNorm
    from matplotlib.figure import Figure

    figure = Figure(figsize=(3.5 * len(maps), 3.6), layout="constrained")
    figure.suptitle(title + "; darker is better", fontsize=10)
    every = np.concatenate([values.ravel() for values in maps.values()])
    limits = {"vmin": float(np.nanmin(every)), "vmax": float(np.nanmax(every))} if alike else {}
    for axes, (name, values) in zip(
        figure.subplots(1, len(maps), squeeze=False)[0], maps.items(), strict=True
    ):
        norm = LogNorm() if name in logarithmic and np.nanmin(values) > 0 else None
        colours = "viridis_r" if name in more_is_better else "viridis"
        image = axes.imshow(values.T, origin="lower", cmap=colours, norm=norm, **limits)
        axes.set_title(name, fontsize=10)
        axes.set(xlabel="X (pixel)", ylabel="Y (pixel)")
        bar = figure.colorbar(image, ax=axes, shrink=0.8)
        if norm is not None:
            _few_ticks(bar.ax.yaxis)
    save_figure(figure, path)


def draw_lines(
    x: Num[np.ndarray, "point"],
    panels: dict[str, Float[np.ndarray, "point"]],
    label: str,
    title: str,
    path: Path,
    published: dict[str, float],
    mark: tuple[float, str],
) -> None:
    """Panels (axis label: values) over one logarithmic axis, a published value each as a level;
    `mark` is a vertical line."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(3.4 * len(panels), 3.7), layout="constrained")
    figure.suptitle(title, fontsize=10)
    for axes, (name, values) in zip(
        figure.subplots(1, len(panels), squeeze=False)[0], panels.items(), strict=True
    ):
        axes.plot(x, values, "o-", ms=4, color=_COLOURS[0], label="simulated")
        if name in published:
            level = "paper, all its frames (real object)"
            axes.axhline(published[name], color=PAPER_COLOUR, ls=":", label=level)
        axes.axvline(mark[0], color=PAPER_COLOUR, ls="--", lw=1, label=mark[1])
        axes.set(ylabel=name, xlabel=label, xscale="log", ylim=(0, 1.08 * axes.get_ylim()[1]))
        axes.grid(alpha=0.3)
    figure.legend(
        *figure.axes[0].get_legend_handles_labels(),
        loc="outside lower center",
        ncols=4,
        frameon=False,
    )
    save_figure(figure, path)


def draw_scatter(
    panels: list[tuple[str, str, np.ndarray, np.ndarray, float]], title: str, path: Path
) -> None:
    """Panels (x label, y label, x, y, rank correlation) on logarithmic axes, one point per location."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(4.2 * len(panels), 3.7), layout="constrained")
    figure.suptitle(title, fontsize=10)
    for axes, (x_label, y_label, x, y, rank) in zip(
        figure.subplots(1, len(panels), squeeze=False)[0], panels, strict=True
    ):
        kept = (x > 0) & (y > 0)
        axes.loglog(x[kept], y[kept], "o", ms=4, color=_COLOURS[0], alpha=0.7)
        axes.set(xlabel=x_label, ylabel=y_label, title=f"rank correlation {rank:.2f}")
        axes.grid(alpha=0.3)
        for axis in (axes.xaxis, axes.yaxis):
            _few_ticks(axis)
    save_figure(figure, path)


def _few_ticks(axis: Any) -> None:
    """1, 2 and 5 of every decade, as plain numbers."""
    from matplotlib.ticker import LogLocator, NullLocator

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter("{x:.3g}")
