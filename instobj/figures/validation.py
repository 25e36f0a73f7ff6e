"""Predicted against recorded changes of signal, and each case's cosine with its null."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, draw_equality

if TYPE_CHECKING:
    from estimator.calibration.recorded_presses import RecordedPresses
    from estimator.calibration.validation import Predictions

_MOST_NAMED = 10
"""Colours of a figure; more contact locations have one in common, and no list of them."""


def draw_validation(
    spec: ObjectSpec,
    presses: RecordedPresses,
    predictions: Predictions,
    document: dict[str, Any],
    path: Path,
) -> None:
    """One scatter plot per pressed face (own channels), and the figures of merit with their nulls (PNG)."""
    from matplotlib.figure import Figure

    from estimator.calibration.recorded_presses import pressed_faces

    faces = pressed_faces(presses)
    figure = Figure(figsize=(4.4 * (len(faces) + 1), 5.6), layout="constrained")
    *panels, last = figure.subplots(1, len(faces) + 1)
    for face, axes in zip(faces, panels, strict=True):
        draw_scatter(axes, spec, presses, predictions, face)
    _draw_nulls(last, document)
    figure.suptitle(
        f"{spec.name}: predicted against {len(presses)} recorded presses of "
        f"{len(presses.cases)} sets of places"
    )
    save_figure(figure, path)


def draw_scatter(
    axes: Any,
    spec: ObjectSpec,
    presses: RecordedPresses,
    predictions: Predictions,
    face: int,
) -> None:
    """One point per channel and case: means over its presses. Cases are distinguished as far as colours
    go."""
    from estimator.calibration.recorded_presses import own_channels

    face_channels = own_channels(spec, face)
    largest, cases = 0.0, np.flatnonzero(presses.face_of_case(face))
    named = len(cases) <= _MOST_NAMED
    for case in cases:
        rows = np.flatnonzero(presses.case == case)
        recorded = presses.signal_counts[rows][:, face_channels].mean(axis=0)
        predicted = predictions.counts[rows, case][:, face_channels].mean(axis=0)
        places = "; ".join(f"({x:g}, {y:g})" for f, x, y in presses.cases[case] if f == face)
        look = {"label": places} if named else {"color": BLUE}
        axes.plot(predicted, recorded, "o", markersize=4, alpha=0.8 if named else 0.4, **look)
        largest = max(largest, np.nanmax(abs(recorded)), np.nanmax(abs(predicted)))
    limit = 1.08 * largest
    draw_equality(axes, -limit, limit)
    axes.axhline(0, color="#cccccc", linewidth=0.8, zorder=0)
    axes.axvline(0, color="#cccccc", linewidth=0.8, zorder=0)
    axes.set(
        xlabel="predicted change (counts)",
        ylabel="recorded change (counts)",
        title=f"Face {face}, own channels",
    )
    axes.legend(
        fontsize=6.5,
        frameon=False,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.16),
        ncols=2,
        title="contact locations x, y (mm)" if named else f"{len(cases)} contact locations",
        title_fontsize=7,
    )


def _draw_nulls(axes: Any, document: dict[str, Any]) -> None:
    """Cosines and signs as bars, the median of the null as a tick, p next to them."""
    rows = [
        (f"{agreement['what']}: {title}", agreement[key])
        for agreement in document["agreement"]
        for title, key in (("cosine", "cosine"), ("signs", "signs"))
    ]
    for index, (_, row) in enumerate(rows):
        supported = row["p"] <= 0.05
        axes.barh(index, row["value"], color=BLUE if supported else "#b5b5b5")
        axes.plot([row["null"]] * 2, [index - 0.4, index + 0.4], color="black", linewidth=2)
        axes.text(1.03, index, f"{row['value']:.2f}, p {row['p']:.2g}", va="center", fontsize=7.5)
    axes.set_yticks(range(len(rows)), [name for name, _ in rows], fontsize=7.5)
    axes.invert_yaxis()
    axes.set(xlim=(0, 1), title="Blue: better than chance\nblack: permuted locations (null)")
    axes.spines[["top", "right"]].set_visible(False)
