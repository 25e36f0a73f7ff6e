"""Error of a calibrated twin over the number of presses, by order and by how each press is done.

Hidden objects are pressed by the rig's own plans (`benchmarks.rig_sessions`), returns to the reference
place counted, and calibrated in full. `python -m benchmarks.press_orders SPEC [PRESSES.nc]` writes a table
and a picture to benchmarks/results; finished cases are kept there under the specification's hash, and
skipped when it runs again.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from benchmarks.rig_sessions import LEVELS_N, HiddenObject, hidden_object, recorded
from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from estimator.calibration.twin.digital_twin import CalibratedTwin, PlaceMechanics, calibrate
from estimator.calibration.twin.least_known import doubt_beforehand, press_order
from estimator.calibration.twin.pressed_places import PressedPlaces, pressed_places
from fem.presses.results import MagnetMotions, PressForces, load_presses
from instobj.rig.plan import (
    PressPlan,
    PressSettings,
    middle_place,
    places_among,
    press_plan,
    settings_of_few,
    stops_of,
)

FACE, EVERY = 3, 10
HIDDEN, NOISES = 3, 2
COUNTS = (20, 30, 40)
WHOLE = "all 100 places, one stroke"
RESULTS = Path(__file__).parent / "results"
Table = tuple[PressForces, MagnetMotions]


@dataclass(frozen=True)
class Way:
    """A row of the table: an order of places, settings of every press, and numbers of presses."""

    name: str
    order: Int[np.ndarray, "press"]
    settings: PressSettings
    counts: tuple[int, ...]

    def plan(self, spec: ObjectSpec, presses: int) -> PressPlan:
        places = places_among(presses, EVERY)
        return press_plan(spec, FACE, self.settings, 0, 1, EVERY, places, self.order)


def ways(spec: ObjectSpec, adaptive: Int[np.ndarray, "press"], seed: int) -> list[Way]:
    """Adaptive, and what it is compared with: all 100 places take 111 presses with the returns."""
    usual, strokes = PressSettings(stops_of(spec)), PressSettings(**settings_of_few(spec))
    shuffled = np.random.default_rng(seed).permutation(len(contact_grid(spec).xy_mm))
    return [
        Way("adaptive, 9 strokes", adaptive, strokes, COUNTS),
        Way(WHOLE, shuffled, usual, (111,)),
        Way("random, 9 strokes", shuffled, strokes, COUNTS),
        Way("even grid, 9 strokes", _even(10, 5), strokes, (29,)),
        Way("even grid, 9 strokes", _even(10, 6), strokes, (41,)),
        Way("adaptive, one stroke", adaptive, usual, COUNTS),
        Way("random, one stroke", shuffled, usual, COUNTS[-1:]),
        Way("all 100 places, 9 strokes", shuffled, strokes, (111,)),
    ]


def adaptive_order(spec: ObjectSpec, table: Table) -> Int[np.ndarray, "press"]:
    """As `rig --adaptive` presses."""
    doubt = doubt_beforehand(spec, *table, FACE, PressSettings(stops_of(spec)).full_n)
    middle = middle_place(contact_grid(spec).xy_mm)
    return press_order(doubt, places_among(max(COUNTS), EVERY), [middle])[0]


def _even(side: int, along: int) -> Int[np.ndarray, "press"]:
    """An even grid among all places."""
    lines = np.round(np.linspace(0, side - 1, along)).astype(int)
    return (lines[:, None] * side + lines).ravel()


def left_share(
    hidden: HiddenObject, table: Table, twin: CalibratedTwin, xy: Float[np.ndarray, "place 2"]
) -> float:
    """Rms error at 2 to 8 N at places, as a share of the rms signal."""
    truth, levels = hidden.counts(xy), np.tile(LEVELS_N, (len(xy), 1))
    ones = np.ones((len(xy), len(LEVELS_N), len(LEVELS_N)))
    channels = np.arange(truth.shape[2])
    at = PressedPlaces(FACE, channels, xy, levels, 0 * truth, np.ones_like(levels, int), ones)
    found = PlaceMechanics(twin.unknowns, *table, at).expected(twin.numbers).reshape(truth.shape)
    found = found + twin.discrepancy.mean(twin.left, xy, levels)
    return float(np.sqrt(np.mean((found - truth) ** 2) / np.mean(truth**2)))


def study(spec: ObjectSpec, table: Table, kept: Path) -> dict[str, dict[str, float]]:
    """Shares left by way and number of presses, then by object and noise."""
    grid = contact_grid(spec)
    inner = grid.xy_mm[grid.xy_mm.max(axis=1) < grid.x_mm[-1]] + spec.contact_grid.pitch_mm / 2
    xy = np.concatenate([grid.xy_mm, inner[::3]])
    document = json.loads(kept.read_text()) if kept.exists() else {}
    if document.get("specification") != spec_hash(spec):
        document = {"specification": spec_hash(spec), "shares": {}}
    found, adaptive = document["shares"], adaptive_order(spec, table)
    for noise in range(NOISES):
        for object_seed in range(HIDDEN):
            hidden, case = hidden_object(spec, table, FACE, object_seed), f"{object_seed}.{noise}"
            for way in ways(spec, adaptive, 10 * object_seed + noise):
                for count in way.counts:
                    row = found.setdefault(f"{way.name} | {count}", {})
                    if case in row:
                        continue
                    frames = recorded(
                        hidden, way.plan(spec, count), table[0], 100 * object_seed + noise
                    )
                    twin = calibrate(spec, *table, pressed_places(spec, frames, FACE))
                    row[case] = left_share(hidden, table, twin, xy)
                    kept.write_text(json.dumps(document, indent=1) + "\n")
                    print(
                        case,
                        way.name,
                        count,
                        f"{100 * row[case]:.2f} %",
                        file=sys.stderr,
                        flush=True,
                    )
    return found


def draw(found: dict[str, dict[str, float]], minutes: dict[str, float], path: Path) -> None:
    """Means over objects and sessions, with all of them as points, over presses and over minutes."""
    import matplotlib.pyplot as plt

    figure, panels = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained", sharey=True)
    names = dict.fromkeys(key.split(" | ")[0] for key in found)
    for number, name in enumerate(names):
        keys = sorted(
            (key for key in found if key.split(" | ")[0] == name), key=minutes.__getitem__
        )
        shares = [100 * np.array(list(found[key].values())) for key in keys]
        presses, taken = [int(key.split(" | ")[1]) for key in keys], [minutes[key] for key in keys]
        for axes, at, aside in zip(panels, (presses, taken), (0.6, 0.18), strict=True):
            means = [values.mean() for values in shares]
            (line,) = axes.plot(at, means, marker="o", ms=5, label=name)
            for here, values in zip(at, shares, strict=True):
                beside = np.full(len(values), here + aside * (number - len(names) / 2))
                axes.plot(beside, values, ".", ms=4, color=line.get_color(), alpha=0.6)
            if name == WHOLE:
                axes.axhline(means[0], color=line.get_color(), ls=":")
    panels[0].set(xlabel="presses, returns included", ylabel="error of signals at all places (%)")
    panels[1].set(xlabel="minutes")
    panels[0].set_ylim(bottom=0)
    panels[0].legend(loc="upper right")
    figure.savefig(path, dpi=150)


def main() -> None:
    """Presses come from the store, or from a file given behind the specification."""
    spec = load_spec(Path(sys.argv[1]))
    if len(sys.argv) > 2:
        table = load_presses(Path(sys.argv[2]))
    else:
        from instobj.stages.run import Run
        from instobj.store.readers import PRESSES

        table = Run(spec).read(PRESSES)
    RESULTS.mkdir(exist_ok=True)
    found = study(spec, table, RESULTS / "press_orders.json")
    minutes = {
        f"{way.name} | {count}": way.plan(spec, count).seconds / 60
        for way in ways(spec, np.arange(max(COUNTS)), 0)
        for count in way.counts
    }
    draw(found, minutes, RESULTS / "press_orders.png")
    for key, row in found.items():
        values = 100 * np.array(list(row.values()))
        scatter = f"{values.mean():.2f} ({values.min():.2f} to {values.max():.2f})"
        print(f"{key}: {scatter}, {minutes[key]:.0f} minutes")


if __name__ == "__main__":
    main()
