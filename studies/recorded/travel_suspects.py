"""Assumptions that residuals point to: each freed by itself, ranked by what that explains elsewhere.

Each assumption is a few numbers with Gaussian priors, fitted with the pose to the registered
presses and judged on all others. Numbers that stand for nothing gain nothing there, or lose. A group
that gains need not be the cause: what looks alike in the field (height and strength of a magnet, travel
and Poisson's ratio) cannot be separated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.errors import SpecError
from design.spec.object import ObjectSpec
from estimator.calibration.known_travel.fit import (
    Changes,
    Fitted,
    Freed,
    fit_beside_pose,
    freed_magnets,
    left_over,
)
from estimator.calibration.known_travel.model import TravelModel, Twin
from estimator.calibration.most_probable import Unknown, Values
from estimator.recordings.formats.travel import TravelRecording
from instobj.figures.saving import save_figure
from instobj.stages.run import Run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POISSON_STEP, LARGEST_POISSON = 0.15, 0.45
"""Change of Poisson's ratio that shows whether it matters, and the largest ratio tried."""
_LEAN_RAD, _LN_TRAVEL, _CHIP_SHARE = 0.05, 0.2, 0.1
"""Prior standard deviations: machine against face, travel's scale, every entry of a chip's matrix."""
_DRAWS = 500
"""Bootstrap draws of an interval."""
_ROUNDS = 15
"""Evaluations of a fit, at most."""


@dataclass(frozen=True)
class FreedAssumption:
    """One assumption freed.

    Attributes
    ----------
    numbers : count of those fitted with the pose
    explained : share of the change of the judged presses (about the resting level of the pose alone)
    gained : over the pose alone, which was fitted to the same presses
    low, high : 90 % of what is gained with the judged places drawn again
    found : what was found, in words
    """

    name: str
    numbers: int
    explained: float
    gained: float
    low: float
    high: float
    finding: str


def ranked_suspects(
    model: TravelModel,
    fitted: Fitted,
    registered: TravelRecording,
    judged: TravelRecording,
    others: Mapping[str, tuple[TravelModel, Callable[[float], str]]],
    seed: int = 0,
) -> list[FreedAssumption]:
    """Every assumption, that which explains most first; `fitted` is the registration to the same
    presses.

    `others` are models of the same object with one assumption of the mechanics changed, by its name:
    one number mixes their motions (1) with those of `model` (0), and the function says what it means.
    """
    freed = _freed(model, fitted) | {
        name: (_mixed(model, rival), lambda values, words=words: words(float(values["share"])))
        for name, (rival, words) in others.items()
    }
    alone = squares_left(left_over(model, fitted, judged))
    size = squares_left(judged.field_mt - fitted.resting_mt)
    rng = np.random.default_rng((seed, 15))
    suspects = []
    for name, (assumption, words) in freed.items():
        fit, values = fit_beside_pose(fitted.twin, assumption, registered, _ROUNDS)
        changes = assumption.change(fit.twin, values, judged.tip_mm)
        residual_squares = squares_left(judged.field_mt - fit.resting_mt - changes)
        gained, low, high = gain_of_suspect(alone, residual_squares, size, judged.place_id, rng)
        explained = float(1 - residual_squares.sum() / size.sum())
        numbers = sum(unknown.size for unknown in assumption.unknowns.values())
        suspects.append(FreedAssumption(name, numbers, explained, gained, low, high, words(values)))
    return sorted(suspects, key=lambda suspect: -suspect.gained)


def _freed(model: TravelModel, fitted: Fitted) -> dict[str, tuple[Freed, Callable[[Values], str]]]:
    """Assumptions by their names, each with what its values say in words."""
    sensors, middle = len(model.scene.sensors.face), fitted.twin.pose.shift_mm

    def leaning(twin: Twin, values: Values, tip: np.ndarray) -> Changes:
        lower = tip.copy()
        lower[:, 2] += (tip[:, :2] - middle) @ values["lean_rad"]
        return model.pressed(twin, lower)

    def deeper(twin: Twin, values: Values, tip: np.ndarray) -> Changes:
        xy, travel = twin.pose.locate_tips(tip)
        return model.change(twin, model.motion(xy, travel * np.exp(values["ln_travel"])))

    def read(twin: Twin, values: Values, tip: np.ndarray) -> Changes:
        # s sensor, j axis as designed, i axis as freed, n press
        return np.einsum("sij,nsj->nsi", np.eye(3) + values["gains"], model.pressed(twin, tip))

    return {
        "machine leans": (
            Freed({"lean_rad": Unknown(_LEAN_RAD, (2,))}, leaning),
            lambda v: f"{np.rad2deg(np.linalg.norm(v['lean_rad'])):.1f}°",
        ),
        "scale of travel": (
            Freed({"ln_travel": Unknown(_LN_TRAVEL)}, deeper),
            lambda v: f"× {np.exp(v['ln_travel']):.2f}",
        ),
        "chips": (
            Freed({"gains": Unknown(_CHIP_SHARE, (sensors, 3, 3))}, read),
            lambda v: f"gains off by {np.sqrt(np.mean(v['gains'] ** 2)):.2f}",
        ),
        "magnets": (
            freed_magnets(model),
            lambda v: (
                f"up to {np.linalg.norm(v['magnet_mm'], axis=1).max():.1f} mm, "
                f"× {np.exp(v['ln_strength']):.2f}"
            ),
        ),
    }


def _mixed(model: TravelModel, rival: TravelModel) -> Freed:
    """Motions of both models mixed: a `share` of 0 is the first, of 1 the other."""

    def change(twin: Twin, values: Values, tip: np.ndarray) -> Changes:
        given, share = twin.pose.locate_tips(tip), values["share"]
        motion = (1 - share) * model.motion(*given) + share * rival.motion(*given)
        return model.change(twin, motion)

    return Freed({"share": Unknown(1.0)}, change)


def squares_left(field_mt: Changes) -> Float[np.ndarray, "press"]:
    return np.sum(field_mt**2, axis=(1, 2))


def gain_of_suspect(
    alone: Float[np.ndarray, "press"],
    residual_squares: Float[np.ndarray, "press"],
    size: Float[np.ndarray, "press"],
    place: np.ndarray,
    rng: np.random.Generator,
) -> tuple[float, float, float]:
    """Share gained, and 90 % of the shares with places drawn again."""
    _, number = np.unique(place, return_inverse=True)
    less, all_of = (
        np.bincount(number, weights=given) for given in (alone - residual_squares, size)
    )
    drawn = rng.integers(len(less), size=(_DRAWS, len(less)))
    shares = less[drawn].sum(axis=1) / all_of[drawn].sum(axis=1)
    low, high = np.percentile(shares, (5, 95))
    return float(less.sum() / all_of.sum()), float(low), float(high)


def other_mechanics(run: Run) -> dict[str, tuple[Run, Callable[[float], str]]]:
    """Runs of the object with one assumption of its mechanics changed, where that can be."""
    spec = run.spec
    ratio = spec.silicone.poisson_ratio
    other = min(ratio + POISSON_STEP, LARGEST_POISSON)
    if other - ratio < POISSON_STEP / 2:
        other = ratio - POISSON_STEP
    glued = spec.mechanics.interface == "bonded"
    interface = "frictionless" if glued else "bonded"
    changes = {
        "Poisson's ratio": (
            {"silicone": spec.silicone.changed(poisson_ratio=other)},
            lambda share: f"{ratio + share * (other - ratio):.2f}",
        ),
        "interface": (
            {"mechanics": spec.mechanics.changed(interface=interface)},
            lambda share: f"{100 * share:.0f} % {interface}",
        ),
    }
    rivals: dict[str, tuple[Run, Callable[[float], str]]] = {}
    for name, (fields, words) in changes.items():
        try:
            rivals[name] = Run(spec.changed(**fields), run.progress), words
        except SpecError as error:
            run.progress.say(f"{name} is not questioned: {error}")
    return rivals


def suspect_rows(suspects: list[FreedAssumption]) -> list[dict[str, Any]]:
    """One row an assumption, that which explains most first; shares to three digits."""
    return [
        {k: round(v, 3) if isinstance(v, float) else v for k, v in asdict(suspect).items()}
        for suspect in suspects
    ]


def draw_residuals(
    spec: ObjectSpec,
    model: TravelModel,
    fitted: Fitted,
    judged: TravelRecording,
    suspects: list[FreedAssumption],
    path: Path,
) -> Figure:
    """Return where the residuals of the judged presses lie, chip by chip, and what they point to (PNG)."""
    from matplotlib.figure import Figure

    xy = fitted.twin.pose.locate_tips(judged.tip_mm)[0]
    recorded = judged.field_mt - fitted.resting_mt
    residual = recorded - model.pressed(fitted.twin, judged.tip_mm)
    place = judged.place_id
    count = np.bincount(place)
    has_press = np.flatnonzero(count)
    mean_place = np.stack(
        [np.bincount(place, weights=c)[has_press] / count[has_press] for c in xy.T]
    )

    def rms_per_place(values: np.ndarray) -> np.ndarray:
        return np.sqrt(np.bincount(place, weights=values)[has_press] / count[has_press])

    sensors = residual.shape[1]
    figure = Figure(figsize=(2.4 * sensors + 1.2, 5.6), layout="constrained")
    grid = figure.add_gridspec(2, sensors, height_ratios=(1.1, 1))
    panels = [figure.add_subplot(grid[0, k]) for k in range(sensors)]
    maps = [rms_per_place(np.sum(residual[:, k] ** 2, axis=1)) for k in range(sensors)]
    largest = float(np.quantile(np.concatenate(maps), 0.99))
    for number, (panel, values) in enumerate(zip(panels, maps, strict=True), start=1):
        shown = panel.scatter(
            *mean_place, c=values, s=8, marker="s", cmap="viridis", vmin=0, vmax=largest
        )
        share = np.sum(residual[:, number - 1] ** 2) / np.sum(recorded[:, number - 1] ** 2)
        panel.set(aspect="equal", xlabel="x, mm")
        panel.set_title(f"chip {number}: {100 * share:.0f} % unexplained", fontsize=8)
    panels[0].set_ylabel("y, mm")
    figure.colorbar(shown, ax=panels, label="left over, mT (rms)")
    axes = figure.add_subplot(grid[1, :])
    names = [f"{suspect.name} ({suspect.numbers}): {suspect.finding}" for suspect in suspects][::-1]
    gains = np.array(
        [
            [suspect.gained, suspect.gained - suspect.low, suspect.high - suspect.gained]
            for suspect in suspects
        ]
    )
    axes.barh(names, 100 * gains[::-1, 0], xerr=100 * gains[::-1, 1:].T, color="#31688e", capsize=3)
    axes.axvline(0, color="black", lw=0.8)
    axes.set_xlabel(
        "% of the change explained more, on judged places, with this assumption freed (90 % of places "
        "drawn anew)"
    )
    axes.tick_params(labelsize=8)
    figure.suptitle(
        f"{spec.name}: what is left of {len(judged)} presses, and what it points to", fontsize=11
    )
    save_figure(figure, path)
    return figure
