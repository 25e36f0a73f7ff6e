"""Bound below every order of presses, and the parts of the error that is left.

The hidden objects of `press_orders`, linear about their true numbers, with the true prior and the true
errors of every mean: noise of chips, of labelled forces, zeros and drift as the rig's own sessions leave
them. `python -m benchmarks.rig.press_bound SPEC [PRESSES.nc]` prints predicted errors of orders and of all
places, the bound below every choice of 40 presses (`benchmarks.rig.least_possible`), shares of
the error, and errors over bench minutes, all as means over the objects, into results/press_bound.json.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from jaxtyping import Float

from benchmarks.harness import Result, described
from benchmarks.rig.least_possible import PressChoices, least_possible
from benchmarks.rig.press_orders import (
    EVERY,
    FACE,
    HIDDEN,
    RESULTS,
    judged_places,
    orders_of,
    settings,
    table_of,
)
from benchmarks.rig.sessions import LEVELS_N, TRUE_PRIOR, HiddenObject, hidden_object, recorded
from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.calibration.twin.digital_twin import PlaceMechanics
from estimator.calibration.twin.discrepancy import Discrepancy
from estimator.calibration.twin.pressed_places import PressedPlaces, pressed_places
from estimator.calibration.twin.unknowns import Unknowns, jacobian_of
from fem.presses.results import MagnetMotions, PressForces
from instobj.bench.rig.plan import (
    PressSettings,
    middle_place,
    places_among,
    press_plan,
)

PRESSES, ALL = 40, 111
STROKES = (3, 5, 9, 14, 18, 27)
_SLOPE_STEP = 0.01
_LEAST_MODE = 2e-3
Table = tuple[PressForces, MagnetMotions]


@dataclass(frozen=True)
class Linear:
    """An object about its true numbers: unknowns are these and, per channel, two smooth fields.

    Attributes
    ----------
    field : root of a field's covariance at the judged places, of which the pressed ones are the first
    judged : Jacobian of the judged signals, as shares of their rms
    """

    hidden: HiddenObject
    table: Table
    field: Float[np.ndarray, "place mode"]
    judged: Float[np.ndarray, "signal unknown"]

    def rows(
        self, jacobian: Float[np.ndarray, "level channel number"], force_n: np.ndarray, place: int
    ) -> Float[np.ndarray, "level channel unknown"]:
        """Jacobian of the signals of one place with respect to all unknowns."""
        share, modes = force_n / 10.0, self.field.shape[1]
        levels, channels, numbers = jacobian.shape
        found = np.zeros((levels, channels, numbers + 2 * channels * modes))
        found[..., :numbers] = jacobian
        for channel, scale in enumerate(self.hidden.scale_counts):
            for part in range(2):
                start = numbers + (2 * channel + part) * modes
                one = TRUE_PRIOR.size * scale * self.field[place]
                found[:, channel, start : start + modes] = np.outer(share ** (part + 1), one)
        return found


def linear(hidden: HiddenObject, table: Table, xy: Float[np.ndarray, "place 2"]) -> Linear:
    levels = np.tile(LEVELS_N, (len(xy), 1))
    one = np.ones((len(xy), 1))
    at = PressedPlaces(
        FACE, np.arange(1), xy, 10 * one, one[..., None], one.astype(int), one[..., None]
    )
    covariance = Discrepancy(hidden.spec, TRUE_PRIOR, at).covariance(xy, 10 * one)[0]
    values, vectors = np.linalg.eigh(covariance / (2 * TRUE_PRIOR.size**2))
    kept = values > _LEAST_MODE * values[-1]
    start = Linear(hidden, table, vectors[:, kept] * np.sqrt(values[kept]), np.empty((0, 0)))
    jacobian, _ = _jacobian(hidden, table, xy, levels)
    rows = np.concatenate([start.rows(jacobian[k], LEVELS_N, k) for k in range(len(xy))])
    rows = rows.reshape(-1, rows.shape[2]) / np.sqrt(np.mean(hidden.counts(xy) ** 2))
    fewer = np.linalg.qr(rows, mode="r")  # of the same sums of squares
    return replace(start, judged=fewer * np.sqrt(len(fewer) / len(rows)))


def _jacobian(
    hidden: HiddenObject, table: Table, xy: np.ndarray, force_n: Float[np.ndarray, "place level"]
) -> tuple[
    Float[np.ndarray, "place level channel number"], Float[np.ndarray, "place level channel"]
]:
    """With respect to the numbers; and slopes of the signals over the force."""
    channels = len(hidden.own)
    shape = *force_n.shape, channels
    at = PressedPlaces(
        FACE, np.arange(channels), xy, force_n, np.zeros(shape), np.ones(force_n.shape, int),
        np.ones((*force_n.shape, force_n.shape[1])),
    )  # fmt: skip
    mechanics = PlaceMechanics(Unknowns(hidden.spec, (FACE,)), *table, at)
    here = mechanics.expected(hidden.numbers)
    less = replace(at, force_n=force_n * (1 - _SLOPE_STEP))
    below = PlaceMechanics(mechanics.unknowns, *table, less).expected(hidden.numbers)
    slope = (here - below).reshape(shape) / (_SLOPE_STEP * force_n)[..., None]
    return jacobian_of(mechanics, hidden.numbers, here).reshape(*shape, -1), slope


@dataclass(frozen=True)
class Told:
    """One press at every place: what it tells, and the covariances of its errors by source, once they are
    divided by the root of their sum."""

    choices: PressChoices
    sources: dict[str, Float[np.ndarray, "press channel level level"]]
    seconds: float


def told(one: Linear, done: PressSettings) -> Told:
    """From a session at all places without returns, done by the rig's plan."""
    spec, hidden = one.hidden.spec, one.hidden
    xy = contact_grid(spec).xy_mm
    order = np.random.default_rng(0).permutation(len(xy))
    plan = press_plan(spec, FACE, done, 0, 1, 0, None, order)
    seen = pressed_places(spec, recorded(hidden, plan, one.table[0], 0), FACE)
    seen = seen.select_places(
        np.linalg.norm(seen.xy_mm[None] - xy[:, None], axis=-1).argmin(axis=1)
    )
    jacobian, slope = _jacobian(hidden, one.table, seen.xy_mm, seen.force_n)
    chip = np.tile(np.array(spec.sensors.noise_counts) ** 2, spec.sensors.count_per_face)
    found, sources = [], {"chips": [], "labels": [], "zeros and drift": []}
    for place in range(len(xy)):
        rows = one.rows(jacobian[place], seen.force_n[place], place).swapaxes(0, 1)
        zero = seen.zero_counts2[place]
        labels = (spec.protocol.force_noise_n * slope[place].T) ** 2 / seen.frames[place]
        chips = chip[:, None] / seen.frames[place]
        roots = [
            np.linalg.cholesky(np.diag(a + b) + zero) for a, b in zip(chips, labels, strict=True)
        ]
        whiten = [np.linalg.inv(root) for root in roots]
        found.append(np.concatenate([w @ r for w, r in zip(whiten, rows, strict=True)]))
        for name, parts in (
            ("chips", [np.diag(part) for part in chips]),
            ("labels", [np.diag(part) for part in labels]),
            ("zeros and drift", [zero] * len(chips)),
        ):
            sources[name].append([w @ part @ w.T for w, part in zip(whiten, parts, strict=True)])
    choices = PressChoices(np.array(found), one.judged)
    blocks = {name: np.array(parts) for name, parts in sources.items()}
    return Told(choices, blocks, done.seconds)


def parts_left(one: Told, times: Float[np.ndarray, "press"], numbers: int) -> dict[str, float]:
    """Shares of the mean variance that is left, by source; they add up to 1."""
    choices = one.choices
    rows = choices.told
    done = (np.sqrt(times)[:, None, None] * rows).reshape(-1, rows.shape[2])
    spread = np.linalg.solve(np.eye(done.shape[1]) + done.T @ done, choices.judged.T)
    whole = np.sum(choices.judged.T * spread)
    found = {
        "numbers, not told": np.sum(spread[:numbers] ** 2) / whole,
        "smooth error, not told": np.sum(spread[numbers:] ** 2) / whole,
    }
    for name, blocks in one.sources.items():
        gained = 0.0
        for press in np.flatnonzero(times):
            seen = (rows[press] @ spread).reshape(*blocks.shape[1:3], -1)
            gained += times[press] * np.sum(seen * (blocks[press] @ seen))
        found[name] = gained / whole
    return {name: float(value) for name, value in found.items()}


def times_of(spec: ObjectSpec, order: np.ndarray, presses: int) -> Float[np.ndarray, "press"]:
    """Of an order with the rig's returns to the middle."""
    places = contact_grid(spec).xy_mm
    along = places_among(presses, EVERY)
    chosen = [*order[:along], *[middle_place(places)] * (presses - along)]
    return np.bincount(chosen, minlength=len(places)).astype(float)


def study(spec: ObjectSpec, table: Table) -> dict[str, list[float]]:
    """Predicted errors (% of the signals), a value per object."""
    xy, found = judged_places(spec), {}
    usual, few, orders = settings(spec, 1), settings(spec, 9), orders_of(spec, table)
    adaptive = times_of(spec, orders[9], PRESSES)
    grid = np.arange(len(contact_grid(spec).xy_mm))

    def note(name: str, value: float) -> None:
        found.setdefault(name, []).append(round(value, 4))
        print(f"{name}: {value:.3f}", file=sys.stderr, flush=True)

    for seed in range(HIDDEN):
        one = linear(hidden_object(spec, table, FACE, seed), table, xy)
        deeper = []
        for strokes in STROKES:
            mine = told(one, replace(few, strokes=strokes))
            for count, times in ((PRESSES, adaptive), (ALL, times_of(spec, grid, ALL))):
                at = f"{strokes} strokes, {count} presses, {count * mine.seconds / 60:.0f} minutes"
                note(at, 100 * mine.choices.left(times))
            if strokes == few.strokes:
                _compared(one, mine, adaptive, note)
                deeper.append(mine.choices.told)
        mine = told(one, usual)
        note("usual presses, 40 adaptive", 100 * mine.choices.left(adaptive))
        note("usual presses, 111", 100 * mine.choices.left(times_of(spec, grid, ALL)))
        for depth_mm in (2.0, 4.0):
            mine = told(one, replace(few, depths_mm=(depth_mm,)))
            deeper.append(mine.choices.told)
        rows = min(each.shape[1] for each in deeper)
        assert all(each.shape[1] == rows for each in deeper)
        many = PressChoices(np.concatenate(deeper), one.judged)
        note("bound, 40 presses, depth of each free", 100 * least_possible(many, PRESSES)[0])
    return found


def _compared(one: Linear, mine: Told, adaptive: np.ndarray, note) -> None:
    """Of one kind of press: orders, all places, and the bound."""
    spec, choices = one.hidden.spec, mine.choices
    places, numbers = len(choices.told), len(one.hidden.numbers)
    shuffled = np.random.default_rng(0).permutation(places)
    every = np.ones(places)
    note("40 adaptive", 100 * choices.left(adaptive))
    note("40 random", 100 * choices.left(times_of(spec, shuffled, PRESSES)))
    note("40 greedy, true errors known", 100 * choices.left(choices.greedy(PRESSES)))
    for count in (PRESSES, 60, 80, 100):
        note(f"bound, {count} presses", 100 * least_possible(choices, count)[0])
    note("all 100 places, no returns", 100 * choices.left(every))
    for name, times in (("40 adaptive", adaptive), ("all 100 places", every)):
        for source, share in parts_left(mine, times, numbers).items():
            note(f"share of variance, {name}: {source}", share)


def main() -> None:
    spec = load_spec(Path(sys.argv[1]))
    record = record_of(study(spec, table_of(spec)))
    (RESULTS / "press_bound.json").write_text(json.dumps(record, indent=1) + "\n")
    print("\n".join(" | ".join(row) for row in record["tables"][0]["rows"]))


def record_of(figures: dict[str, list[float]]) -> Result:
    """Return the results file of figures: case → one value an object, % or shares."""
    rows = [
        [name, *(f"{value:.3f}" for value in (np.mean(values), min(values), max(values)))]
        for name, values in figures.items()
    ]
    table = {"columns": ["% of the signals, or share", "mean", "least", "most"], "rows": rows}
    said = described("Bound below every order", "python -m benchmarks.rig.press_bound SPEC")
    return said | {"tables": [table], "figures": figures}


if __name__ == "__main__":
    main()
