"""Contacts found against true ones: distances, numbers and forces."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, PALETTE, RED, draw_equality, draw_shares_within

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.readings import ContactSets
    from estimator.metrics.contacts import MatchedContacts


def draw_contacts(
    frames: FrameSet, contact_sets: ContactSets, matched: MatchedContacts, path: Path
) -> None:
    """Share of contacts within a distance; numbers found against true; total force (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.5, 4.0), layout="constrained")
    distance, number, force = figure.subplots(1, 3)
    _draw_distances(distance, matched)
    _draw_numbers(number, matched)
    _draw_forces(force, contact_sets, matched)
    figure.suptitle(
        f"Contacts read by inversion in {len(frames)} {frames.source} frames", fontsize=11
    )
    save_figure(figure, path)


def _draw_distances(axes: Any, matched: MatchedContacts) -> None:
    tips = matched.tips[matched.frame]
    for number in np.unique(tips).tolist():
        away = matched.distance_mm[tips == number]
        label = f"{number} per face: median {np.median(away):.2f} mm"
        draw_shares_within(axes, away, color=PALETTE[(number - 1) % len(PALETTE)], label=label)
    axes.set(xscale="log", xlabel="distance to the true contact (mm)")
    axes.set_ylabel("contacts with distance ≤ x (%)")
    if len(tips):
        axes.legend(frameon=False, fontsize=8, loc="upper left")


def _draw_numbers(axes: Any, matched: MatchedContacts) -> None:
    most = int(max(matched.true_number.max(), matched.found_number.max())) + 1
    counted = np.zeros((most, most))
    np.add.at(counted, (matched.true_number, matched.found_number), 1)
    share = 100 * counted / np.maximum(counted.sum(axis=1, keepdims=True), 1)
    axes.imshow(share.T, origin="lower", cmap="Blues", vmin=0, vmax=100)
    for true, mine in np.argwhere(counted > 0):
        colour = "white" if share[true, mine] > 60 else "black"
        number = f"{share[true, mine]:.0f}"
        axes.text(true, mine, number, ha="center", va="center", color=colour, fontsize=9)
    ticks = range(most)
    axes.set(xticks=ticks, yticks=ticks, xlabel="true number of contacts", ylabel="number found")
    axes.set_title("% of the frames of each true number", fontsize=9)


def _draw_forces(axes: Any, contact_sets: ContactSets, matched: MatchedContacts) -> None:
    total = np.nansum(contact_sets.force_n, axis=1)
    true = total - matched.total_error_n
    end = 1.05 * float(max(true.max(), total.max(), 1.0))
    draw_equality(axes, 0, end)
    is_right = matched.right
    axes.plot(true[is_right], total[is_right], ".", color=BLUE, ms=4, label="number right")
    axes.plot(true[~is_right], total[~is_right], ".", color=RED, ms=4, label="number wrong")
    axes.set(xlabel="true total force (N)", ylabel="total force found (N)")
    axes.legend(frameon=False, fontsize=8, loc="upper left")
