"""Figures of the paper's experiments."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.files import atomic_path

if TYPE_CHECKING:
    from estimator.metrics import ContactErrors

_COLOURS = ("#1b6ca8", "#9ab8cf", "#c8553d", "#b08900", "#6a994e")


def draw_bars(
    rows: list[dict[str, Any]], group: str, series: dict[str, str], label: str, path: Path
) -> None:
    """Groups of bars, one a column in `series` (column: legend), with their values."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(max(5.5, 1.5 + 1.6 * len(rows)), 3.8), layout="constrained")
    axes = figure.subplots()
    width = 0.8 / len(series)
    for index, (name, legend) in enumerate(series.items()):
        value = np.array([np.nan if row.get(name) is None else row[name] for row in rows], float)
        place = np.arange(len(rows)) + (index - (len(series) - 1) / 2) * width
        axes.bar(place, value, 0.92 * width, color=_COLOURS[index], label=legend)
        for x, y in zip(place, value, strict=True):
            if np.isfinite(y):
                axes.annotate(f"{y:.3g}", (x, y), ha="center", va="bottom", fontsize=8)
    axes.set_xticks(range(len(rows)), [f"{row[group]}" for row in rows])
    axes.set(ylabel=label, xlabel=group)
    axes.set_ylim(0, 1.08 * axes.get_ylim()[1])
    axes.grid(axis="y", alpha=0.3)
    figure.legend(loc="outside upper center", ncols=len(series), frameon=False, fontsize=9)
    save(figure, path)


def draw_histograms(errors: dict[str, ContactErrors], path: Path) -> None:
    """Share of contacts (or frames) with an error of at least so much, one line each."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    left, right = figure.subplots(1, 2)
    for (name, found), colour in zip(errors.items(), _COLOURS, strict=False):
        for axes, values in ((left, found.force_percent), (right, found.distance_px)):
            finite = np.sort(values[np.isfinite(values)])[::-1]
            axes.step(finite, (np.arange(len(finite)) + 1) / len(finite), color=colour, label=name)
    left.set(xlabel="force error E_f (% of the place's range)", xscale="log", xlim=(0.05, 200))
    right.set(xlabel="location error E_loc (pixels)", xlim=(-0.2, None))
    for axes in (left, right):
        axes.set(yscale="log", ylabel="share with at least this error", ylim=(1e-4, 1.3))
        axes.grid(alpha=0.3)
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside upper center", ncols=5, frameon=False
    )
    save(figure, path)


def draw_maps(
    maps: dict[str, Float[np.ndarray, "nx ny"]],
    path: Path,
    logarithmic: tuple[str, ...] = (),
    alike: bool = False,
) -> None:
    """Maps over a face's pixels, x to the right and y up; `logarithmic` names those by decades.

    `alike` gives all one scale of colours.
    """
    from matplotlib.colors import LogNorm
    from matplotlib.figure import Figure

    figure = Figure(figsize=(3.5 * len(maps), 3.4), layout="constrained")
    every = np.concatenate([values.ravel() for values in maps.values()])
    limits = {"vmin": float(np.nanmin(every)), "vmax": float(np.nanmax(every))} if alike else {}
    for axes, (title, values) in zip(
        figure.subplots(1, len(maps), squeeze=False)[0], maps.items(), strict=True
    ):
        norm = LogNorm() if title in logarithmic and np.nanmin(values) > 0 else None
        image = axes.imshow(values.T, origin="lower", cmap="viridis", norm=norm, **limits)
        axes.set(title=title, xlabel="X (pixel)", ylabel="Y (pixel)")
        bar = figure.colorbar(image, ax=axes, shrink=0.8)
        if norm is not None:
            _few_ticks(bar.ax.yaxis)
    save(figure, path)


def draw_lines(
    x: Float[np.ndarray, "point"],
    panels: dict[str, dict[str, Float[np.ndarray, "point"]]],
    label: str,
    path: Path,
    mark: tuple[float, str] | None = None,
) -> None:
    """Panels (title: lines by name) over one logarithmic axis; `mark` is a vertical line."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(3.4 * len(panels), 3.3), layout="constrained")
    for axes, (title, lines) in zip(
        figure.subplots(1, len(panels), squeeze=False)[0], panels.items(), strict=True
    ):
        for (name, values), colour in zip(lines.items(), _COLOURS, strict=False):
            axes.plot(x, values, "o-", ms=4, color=colour, label=name)
        if mark is not None:
            axes.axvline(mark[0], color="0.5", ls="--", label=mark[1])
        axes.set(title=title, xlabel=label, xscale="log")
        axes.grid(alpha=0.3)
    figure.legend(
        *figure.axes[0].get_legend_handles_labels(),
        loc="outside upper center",
        ncols=4,
        frameon=False,
    )
    save(figure, path)


def draw_scatter(panels: list[tuple[str, str, np.ndarray, np.ndarray, float]], path: Path) -> None:
    """Panels (x label, y label, x, y, rank correlation) on logarithmic axes."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(4.2 * len(panels), 3.5), layout="constrained")
    for axes, (x_label, y_label, x, y, rank) in zip(
        figure.subplots(1, len(panels), squeeze=False)[0], panels, strict=True
    ):
        kept = (x > 0) & (y > 0)
        axes.loglog(x[kept], y[kept], "o", ms=4, color=_COLOURS[0], alpha=0.7)
        axes.set(xlabel=x_label, ylabel=y_label, title=f"rank correlation {rank:.2f}")
        axes.grid(alpha=0.3)
        for axis in (axes.xaxis, axes.yaxis):
            _few_ticks(axis)
    save(figure, path)


def _few_ticks(axis: Any) -> None:
    """1, 2 and 5 of every decade, as plain numbers."""
    from matplotlib.ticker import LogLocator, NullLocator

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter("{x:.3g}")


def save(figure: Any, path: Path) -> None:
    """Write a PNG, complete or absent."""
    with atomic_path(path) as temporary:
        figure.savefig(temporary, dpi=130, format="png")
