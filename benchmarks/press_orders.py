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
        Way("adaptive", adaptive, strokes, COUNTS),
        Way("all 100 places", shuffled, usual, (111,)),
        Way("random, strokes", shuffled, strokes, COUNTS),
        Way("even grid, strokes", _even(10, 5), strokes, (29,)),
        Way("adaptive, one stroke", adaptive, usual, COUNTS),
        Way("random, one stroke", shuffled, usual, COUNTS[-1:]),
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


def draw(found: dict[str, dict[str, float]], path: Path) -> None:
    """Means over objects and noises, with all of them as points."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    names = dict.fromkeys(key.split(" | ")[0] for key in found)
    for name in names:
        rows = {
            int(key.split(" | ")[1]): row
            for key, row in found.items()
            if key.split(" | ")[0] == name
        }
        number = sorted(rows)
        means = [100 * np.mean(list(rows[count].values())) for count in number]
        (line,) = axes.plot(number, means, marker="o", label=name)
        for count in number:
            points = 100 * np.array(list(rows[count].values()))
            axes.plot(
                np.full(len(points), count), points, ".", ms=3, color=line.get_color(), alpha=0.5
            )
        if name == "all 100 places":
            axes.axhline(float(means[0]), color=line.get_color(), ls=":")
    axes.set(xlabel="presses, returns included", ylabel="error of the signals at all places (%)")
    axes.set_ylim(bottom=0)
    axes.legend()
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
    draw(found, RESULTS / "press_orders.png")
    minutes = {
        f"{way.name} | {count}": way.plan(spec, count).seconds / 60
        for way in ways(spec, np.arange(max(COUNTS)), 0)
        for count in way.counts
    }
    for key, row in found.items():
        values = 100 * np.array(list(row.values()))
        scatter = f"{values.mean():.2f} ({values.min():.2f} to {values.max():.2f})"
        print(f"{key}: {scatter}, {minutes[key]:.0f} minutes")


if __name__ == "__main__":
    main()
