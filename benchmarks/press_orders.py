"""Error of a calibrated twin over the number of presses, by the order in which places are pressed.

Hidden objects are drawn within tolerances, with a departure from small strain and a smooth error of
the mechanics of 2 %; `python -m benchmarks.press_orders SPEC` writes a table and a picture to
benchmarks/results. Calibration is one Gauss–Newton step from the hidden object, the limit to which
`calibrate` converges.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.calibration.twin.digital_twin import PlaceMechanics
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.least_known import doubt_beforehand, press_order
from estimator.calibration.twin.pressed_places import PressedPlaces, zero_covariance
from estimator.calibration.twin.unknowns import Unknowns, jacobian_of, normal_equations
from fem.presses.results import MagnetMotions, PressForces, load_presses

FACE, FORCE_N, LEVELS = 3, 8.0, np.array([2.0, 4.0, 6.0, 8.0])
TRUE_PRIOR = Prior(0.02, 10.0)
COUNTS = (4, 9, 16, 20, 25, 30, 36, 40, 49, 64, 81, 100)
HIDDEN, NOISES, RANDOM = 3, 4, 4
RESULTS = Path(__file__).parent / "results"


def places_at(spec: ObjectSpec, xy_mm: Float[np.ndarray, "place 2"]) -> PressedPlaces:
    """Presses of 32 frames each, with neither signals nor noise."""
    shape = len(xy_mm), len(LEVELS)
    channels = np.arange(3 * spec.sensors.count_per_face)
    zero = zero_covariance(spec, 32) * np.ones((shape[0], shape[1], shape[1]))
    counts = np.zeros((*shape, len(channels)))
    return PressedPlaces(
        FACE, channels, xy_mm, np.tile(LEVELS, (shape[0], 1)), counts, np.full(shape, 8), zero
    )


def hidden_signals(
    spec: ObjectSpec,
    presses: tuple[PressForces, MagnetMotions],
    seen: PressedPlaces,
    rng: np.random.Generator,
) -> tuple[PressedPlaces, Float[np.ndarray, "row channel number"], Float[np.ndarray, "number"]]:
    """Signals of an object drawn at random, how they change with its numbers, and these."""
    unknowns = Unknowns(spec, (FACE,))
    mechanics = PlaceMechanics(unknowns, *presses, seen)
    while True:
        numbers = rng.standard_normal(len(unknowns))
        here = mechanics.expected(numbers)
        if np.isfinite(here).all():
            break
    jacobian = jacobian_of(mechanics, numbers, here)
    seen = replace(seen, counts=here.reshape(seen.counts.shape))
    process = Discrepancy(spec, TRUE_PRIOR, seen.at(np.arange(2))).covariance(
        seen.xy_mm, seen.force_n
    )
    scale = np.sqrt(np.mean(seen.counts**2, axis=(0, 1)))
    first = np.sqrt(np.mean(seen.counts[:2] ** 2, axis=(0, 1)))
    draws = [
        np.linalg.cholesky(own + 1e-9 * np.trace(own) * np.eye(len(own)))
        @ rng.standard_normal(len(own))
        for own in process
    ]
    error = (np.stack(draws, axis=1) * scale / first).reshape(seen.counts.shape)
    return replace(seen, counts=seen.counts + error), jacobian, numbers


def measured(
    spec: ObjectSpec, seen: PressedPlaces, rng: np.random.Generator
) -> Float[np.ndarray, "place level channel"]:
    """What presses show: white noise, and one error of the zero per press."""
    white = np.sqrt(seen.white_counts2(spec)) * rng.standard_normal(seen.counts.shape)
    zero = np.sqrt(seen.zero_counts2[:, :1, :1]) * rng.standard_normal(
        (len(seen), 1, len(seen.channels))
    )
    return seen.counts + white + zero


def left_share(
    spec: ObjectSpec,
    truth: PressedPlaces,
    jacobian: Float[np.ndarray, "row channel number"],
    numbers: Float[np.ndarray, "number"],
    mechanics_counts: Float[np.ndarray, "place level channel"],
    shown: Float[np.ndarray, "place level channel"],
    pressed: Int[np.ndarray, "press"],
) -> float:
    """Rms error over all places, as a share of the rms signal, of a twin that saw some presses."""
    levels, channels = shown.shape[1:]
    by_place = jacobian.reshape(len(truth), levels, channels, -1)
    seen = replace(truth.at(pressed), counts=shown[pressed])
    process = Discrepancy(spec, TRUE_PRIOR, seen)
    own = by_place[pressed].reshape(-1, channels, len(numbers))
    right = (shown - mechanics_counts)[pressed].reshape(-1, channels) + own @ numbers
    precision, pull = normal_equations(process, own, right)
    found = np.linalg.solve(precision, pull)
    left = right - own @ found
    predicted = mechanics_counts + by_place @ (found - numbers)
    predicted = predicted + process.mean(left, truth.xy_mm, truth.force_n)
    return float(np.sqrt(np.mean((predicted - truth.counts) ** 2) / np.mean(truth.counts**2)))


def spread_order(xy_mm: Float[np.ndarray, "place 2"]) -> Int[np.ndarray, "place"]:
    """Farthest-point order: the first nearest to the middle, each next farthest from all before."""
    order = [int(np.linalg.norm(xy_mm, axis=1).argmin())]
    while len(order) < len(xy_mm):
        away = np.linalg.norm(xy_mm[:, None] - xy_mm[order], axis=2).min(axis=1)
        order.append(int(away.argmax()))
    return np.array(order)


def grid_subset(side: int, number: int) -> Int[np.ndarray, "press"] | None:
    """Evenly spaced places of a square grid where `number` is a square."""
    root = round(number**0.5)
    if root**2 != number:
        return None
    along = np.round(np.linspace(0, side - 1, root)).astype(int)
    return (along[:, None] * side + along).ravel()


def study(spec: ObjectSpec, presses: tuple[PressForces, MagnetMotions]) -> dict[str, list]:
    """Shares left (hidden object and noise, number of presses) by order."""
    grid = contact_grid(spec)
    middles = (grid.xy_mm + spec.contact_grid.pitch_mm / 2)[grid.xy_mm.max(axis=1) < grid.x_mm[-1]]
    places = places_at(spec, np.concatenate([grid.xy_mm, middles[::3]]))
    adaptive, _ = press_order(doubt_beforehand(spec, *presses, FACE, FORCE_N), len(grid))
    spread = spread_order(grid.xy_mm)
    found: dict[str, list] = {"adaptive": [], "farthest point": [], "random": [], "grid": []}
    for hidden in range(HIDDEN):
        rng = np.random.default_rng([7, hidden])
        truth, jacobian, numbers = hidden_signals(spec, presses, places, rng)
        base = PlaceMechanics(Unknowns(spec, (FACE,)), *presses, places).expected(numbers)
        base = base.reshape(truth.counts.shape)
        for noise in range(NOISES):
            shown = measured(spec, truth, rng)

            def share(pressed):
                return left_share(spec, truth, jacobian, numbers, base, shown, pressed)  # noqa: B023

            found["adaptive"].append([share(adaptive[:n]) for n in COUNTS])
            found["farthest point"].append([share(spread[:n]) for n in COUNTS])
            for draw in range(RANDOM if noise == 0 else 1):
                order = np.random.default_rng([hidden, noise, draw]).permutation(len(grid))
                found["random"].append([share(order[:n]) for n in COUNTS])
            subsets = [grid_subset(len(grid.x_mm), n) for n in COUNTS]
            found["grid"].append([np.nan if s is None else share(s) for s in subsets])
        print(f"hidden object {hidden + 1} of {HIDDEN}", _text(found), file=sys.stderr, flush=True)
    return found


def draw(found: dict[str, list], path: Path) -> None:
    """Medians with the middle 80 %."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for name, rows in found.items():
        shares = 100 * np.array(rows, float)
        known = np.isfinite(shares).all(axis=0)
        low, middle, high = np.percentile(shares[:, known], [10, 50, 90], axis=0)
        number = np.array(COUNTS)[known]
        (line,) = axes.plot(number, middle, marker="o", ms=3, label=name)
        axes.fill_between(number, low, high, color=line.get_color(), alpha=0.15, lw=0)
    whole = 100 * np.median(np.array(found["grid"], float)[:, -1])
    axes.axhline(whole, color="0.4", ls=":", label="all 100 places")
    axes.set(xlabel="presses", ylabel="error of the signals at all places (%)", yscale="log")
    axes.yaxis.set_minor_formatter(lambda value, _: f"{value:g}" if value in (2, 3, 4, 6) else "")
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.legend()
    figure.savefig(path, dpi=150)


def main() -> None:
    """Presses come from the store, or from a file given behind the specification."""
    spec = load_spec(Path(sys.argv[1]))
    if len(sys.argv) > 2:
        presses = load_presses(Path(sys.argv[2]))
    else:
        from instobj.stages.run import Run
        from instobj.store.readers import PRESSES

        presses = Run(spec).read(PRESSES)
    found = study(spec, presses)
    RESULTS.mkdir(exist_ok=True)
    document = {"presses": COUNTS, "shares": found}
    (RESULTS / "press_orders.json").write_text(json.dumps(document) + "\n")
    draw(found, RESULTS / "press_orders.png")
    print(_text(found))


def _text(found: dict[str, list]) -> str:
    lines = []
    for name, rows in found.items():
        shares = 100 * np.median(np.array(rows, float), axis=0)
        values = " ".join(f"{n}:{value:.2f}" for n, value in zip(COUNTS, shares, strict=True))
        lines.append(f"{name} {values}")
    return "\n".join(["", *lines])


if __name__ == "__main__":
    main()
