"""Error of a calibrated twin over the number of presses, by order and by how each press is done.

Hidden objects are pressed by the rig's own plans (`benchmarks.rig.sessions`), returns to the reference
place counted, and calibrated in full. `python -m benchmarks.rig.press_orders SPEC [PRESSES.nc]` writes
a table and a picture to benchmarks/results (the paper's cube: the picture of docs/measured/rig.md);
finished cases are kept under the specification's hash, and skipped when it runs again.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from benchmarks.harness import described
from benchmarks.rig.sessions import LEVELS_N, HiddenObject, hidden_object, recorded
from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from estimator.calibration.twin.digital_twin import CalibratedTwin, PlaceMechanics, calibrate
from estimator.calibration.twin.pressed_places import PressedPlaces, pressed_places
from estimator.calibration.twin.traced_presses import traced_presses
from estimator.signals.interpolation import counts_at_force
from fem.presses.results import MagnetMotions, PressForces, load_presses
from instobj.bench.rig.adaptive import adaptive_order
from instobj.bench.rig.plan import (
    PressPlan,
    PressSettings,
    places_among,
    press_plan,
    settings_of_few,
    stops_of,
)

FACE, EVERY = 3, 10
HIDDEN, NOISES = 3, 2
COUNTS = (20, 30, 40)
WHOLE = "all 100 places, one stroke"
RESULTS = Path(__file__).parents[1] / "results"
ROOT = Path(__file__).parents[2]
CUBE, FIGURE = ROOT / "examples" / "paper_cube.toml", ROOT / "docs" / "rig_orders.png"
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


def ways(spec: ObjectSpec, orders: dict[int, Int[np.ndarray, "press"]], seed: int) -> list[Way]:
    """Adaptive (`orders` by number of strokes), and what it is compared with: all 100 places take 111
    presses with the returns."""
    shuffled = np.random.default_rng(seed).permutation(len(contact_grid(spec).xy_mm))
    usual, few, three, many = (settings(spec, strokes) for strokes in (1, 9, 3, 27))
    return [
        Way("adaptive, 9 strokes", orders[9], few, COUNTS),
        Way(WHOLE, shuffled, usual, (111,)),
        Way("all 100 places, 9 strokes", shuffled, few, (111,)),
        Way("even grid, 9 strokes", _even(10, 6), few, (41,)),
        Way("even grid, 9 strokes", _even(10, 5), few, (29,)),
        Way("adaptive, 27 strokes", orders[27], many, COUNTS[-1:]),
        Way("random, 9 strokes", shuffled, few, COUNTS[::-1]),
        Way("adaptive, one stroke", orders[1], usual, COUNTS[::-1]),
        Way("random, one stroke", shuffled, usual, COUNTS[-1:]),
        Way("all 100 places, 3 strokes", shuffled, three, (111,)),
    ]


def settings(spec: ObjectSpec, strokes: int) -> PressSettings:
    """Usual presses of one stroke, or those of few places with so many."""
    if strokes == 1:
        return PressSettings(stops_of(spec))
    return replace(PressSettings(**settings_of_few(spec)), strokes=strokes)


def orders_of(spec: ObjectSpec, table: Table) -> dict[int, Int[np.ndarray, "press"]]:
    """As `rig --adaptive` presses."""
    most = max(COUNTS)
    return {
        strokes: adaptive_order(spec, *table, FACE, settings(spec, strokes), most, EVERY)
        for strokes in (1, 9, 27)
    }


def _even(side: int, along: int) -> Int[np.ndarray, "press"]:
    """An even grid among all places."""
    lines = np.round(np.linspace(0, side - 1, along)).astype(int)
    return (lines[:, None] * side + lines).ravel()


def judged_places(spec: ObjectSpec) -> Float[np.ndarray, "place 2"]:
    """All contact locations, and a third of the middles between them."""
    grid = contact_grid(spec)
    inner = grid.xy_mm[grid.xy_mm.max(axis=1) < grid.x_mm[-1]] + spec.contact_grid.pitch_mm / 2
    return np.concatenate([grid.xy_mm, inner[::3]])


def left_share(
    hidden: HiddenObject, table: Table, twin: CalibratedTwin, xy: Float[np.ndarray, "place 2"]
) -> float:
    """Rms error at 2 to 8 N at places, as a share of the rms signal; at less where a place's deepest
    press, of the object or of the design, does not reach that."""
    traces = hidden.traces(xy)
    designed = traced_presses(hidden.spec, *table, FACE, xy).force_n[0][:, -1]
    reach_n = np.minimum(traces.force_n[:, -1], designed)
    levels = np.minimum(np.tile(LEVELS_N, (len(xy), 1)), reach_n[:, None])
    truth = counts_at_force(traces, levels).counts
    ones = np.ones((len(xy), len(LEVELS_N), len(LEVELS_N)))
    channels = np.arange(truth.shape[2])
    at = PressedPlaces(FACE, channels, xy, levels, 0 * truth, np.ones_like(levels, int), ones)
    predicted = (
        PlaceMechanics(twin.unknowns, *table, at).expected(twin.numbers).reshape(truth.shape)
    )
    predicted = predicted + twin.discrepancy.mean(twin.residual, xy, levels)
    return float(np.sqrt(np.mean((predicted - truth) ** 2) / np.mean(truth**2)))


def study(spec: ObjectSpec, table: Table, kept: Path) -> dict[str, dict[str, float]]:
    """Shares left by way and number of presses, then by object and noise."""
    xy = judged_places(spec)
    document = json.loads(kept.read_text()) if kept.exists() else {}
    few = json.loads(json.dumps(settings_of_few(spec)))
    if (document.get("specification"), document.get("few")) != (spec_hash(spec), few):
        document = {"specification": spec_hash(spec), "few": few, "shares": {}}
    found, orders = document["shares"], orders_of(spec, table)
    for row in range(len(ways(spec, orders, 0))):
        for seed, noise in product(range(HIDDEN), range(NOISES)):
            way, hidden = ways(spec, orders, 10 * seed + noise)[row], None
            for count in way.counts:
                shares, case = found.setdefault(f"{way.name} | {count}", {}), f"{seed}.{noise}"
                if case in shares:
                    continue
                hidden = hidden or hidden_object(spec, table, FACE, seed)
                frames = recorded(hidden, way.plan(spec, count), table[0], 100 * seed + noise)
                twin = calibrate(spec, *table, pressed_places(spec, frames, FACE))
                shares[case] = left_share(hidden, table, twin, xy)
                kept.write_text(json.dumps(document, indent=1) + "\n")
                said = f"{case} {way.name} {count} {100 * shares[case]:.2f} %"
                print(said, file=sys.stderr, flush=True)
    return found


def draw(
    found: dict[str, dict[str, float]],
    minutes: dict[str, float],
    bound: dict[str, list[float]],
    path: Path,
) -> None:
    """Means over objects and sessions, with all of them as points, over presses and over minutes; and
    the bound below every choice of presses (results/press_bound.json, of which no script is kept)."""
    import matplotlib.pyplot as plt

    figure, panels = plt.subplots(1, 2, figsize=(10, 5.4), layout="constrained", sharey=True)
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
    counts = (40, 60, 80, 100)
    least = [np.mean(bound[f"bound, {n} presses"]) for n in counts]
    label = "least possible, any such presses of 9 strokes (computed)"
    panels[0].plot(counts, least, "k--", lw=1, label=label)
    figure.suptitle(_title(found, minutes, bound), fontsize=10)
    panels[0].set(xlabel="presses, returns included", ylabel="error of signals at all places (%)")
    panels[1].set(xlabel="minutes")
    panels[0].set_ylim(bottom=0)
    handles = panels[0].get_legend_handles_labels()
    figure.legend(*handles, loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    figure.savefig(path, dpi=150)


def _title(
    found: dict[str, dict[str, float]], minutes: dict[str, float], bound: dict[str, list[float]]
) -> str:
    def told(key: str) -> str:
        return f"{100 * np.mean(list(found[key].values())):.2f} % ({minutes[key]:.0f} min)"

    most = max(COUNTS)
    line = (
        f"{most} adaptive presses of 9 strokes leave {told(f'adaptive, 9 strokes | {most}')}, all 100 "
        f"places by one stroke {told(f'{WHOLE} | 111')},\n"
        f"by the same 9 strokes {told('all 100 places, 9 strokes | 111')}"
    )
    least = np.mean(bound[f"bound, {most} presses"])
    return f"{line}; any {most} such presses at least {least:.2f} % (computed)"


def table_of(spec: ObjectSpec) -> Table:
    """Presses of the store, or of a file given behind the specification."""
    if len(sys.argv) > 2:
        return load_presses(Path(sys.argv[2]))
    from instobj.stages.run import Run
    from instobj.store.readers import PRESSES

    return Run(spec).read(PRESSES)


def main() -> None:
    spec = load_spec(Path(sys.argv[1]))
    table = table_of(spec)
    RESULTS.mkdir(exist_ok=True)
    found = study(spec, table, RESULTS / "press_orders.json")
    minutes = {
        f"{way.name} | {count}": way.plan(spec, count).seconds / 60
        for way in ways(spec, dict.fromkeys((1, 9, 27), np.arange(max(COUNTS))), 0)
        for count in way.counts
    }
    bound = json.loads((RESULTS / "press_bound.json").read_text())["figures"]
    of_cube = spec_hash(spec) == spec_hash(load_spec(CUBE))
    draw(found, minutes, bound, FIGURE if of_cube else RESULTS / "press_orders.png")
    write_table(RESULTS / "press_orders.json", found, minutes)


def write_table(path: Path, found: dict[str, dict[str, float]], minutes: dict[str, float]) -> None:
    """Add what the results file says of itself and its table: errors in %, minutes at the bench."""
    rows = []
    for key, row in found.items():
        values = 100 * np.array(list(row.values()))
        scatter = f"{values.mean():.2f} ({values.min():.2f} to {values.max():.2f})"
        rows.append([*key.split(" | "), scatter, f"{minutes[key]:.0f}"])
    columns = ["order and strokes", "presses", "error, % of the signals", "minutes"]
    record = described("Order and strokes", "python -m benchmarks.rig.press_orders SPEC") | {
        "tables": [{"columns": columns, "rows": rows}],
        **json.loads(path.read_text()),
    }
    path.write_text(json.dumps(record, indent=1) + "\n")
    print("\n".join(" | ".join(row) for row in rows))


if __name__ == "__main__":
    main()
