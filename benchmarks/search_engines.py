"""The engines of a layout search beside plain CMA-ES and plain random search, on the first level.

    python benchmarks/search_engines.py [--quick] [--out FOLDER]

All place the magnets and sensors of the paper's cube (31 lengths and angles), scored as a search scores
them on the first level, limits as penalties, in two tasks (`TASKS`): the 99th percentile of the
position bound at 5 N, and `examples/search_cube.toml` itself, 2, 5 and 12 N with its limits over the
start. The tool takes random layouts (`search.engine` "random"), each improved by `polish_steps`
generations, here 600, as nothing but lengths and angles varies. The peers: CMA-ES of the package
`cmaes` with its default population and with four times that, started anew where it has converged, and
random layouts. Each gets as many scorings as the tool, then as much processor time; the best layout
within all limits counts. One thread; per seed, all in one process after each other. Writes
`search_engines.json`.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import torch
from harness import conclude, machine, option_parser

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, search_space
from design.spec_io import load_spec
from estimator.layouts.polish import Judged, LowestFidelity, judge
from instobj.search import lowest_fidelity
from instobj.search.engines import ask, sampling, tell
from instobj.search.lowest_fidelity import score_trials, start_scores, structure_fidelity
from instobj.search.outcome.history import plain_cma_es
from instobj.stages.run import Run

EXAMPLE = Path(__file__).parents[1] / "examples" / "search_cube.toml"
OUTWARD = 'search.vary.sensor_chip=["outward"]'
LONG = "search.polish_steps=600"
TASKS = {
    "5 N": [
        'search.objectives=["percentile_99_position_bound_mm"]',
        "search.forces_n=[5.0]",
        "search.limits.places_worse=1.0",
        "search.limits.times_start={}",
        OUTWARD,
        LONG,
    ],
    "2, 5 and 12 N, limits over the start": [OUTWARD, LONG],
}
QUICK = [
    "mesh.surface_edge_mm=3.5",
    "mesh.edge_mm=8.0",
    "mesh.rim_edge_ratio=1.0",
    "mesh.magnet_sides=8",
    "contact_grid.count=[4, 4]",
    "contact_grid.pitch_mm=6.0",
    "press.depths_mm=[1.0, 2.0, 4.0]",
]
_PARALLEL = 96
"""Random layouts that are scored together."""


class Meter:
    """Scores of points of the unit cube, counted, with the best within all limits by scorings and time."""

    def __init__(self, lowest: LowestFidelity, space: SearchSpace) -> None:
        self.lowest, self.objectives = lowest, space.spec.search.objectives
        self.free = np.array([not v.choices for v in space.variables])
        middle = params_at(space, np.full(len(space.variables), 0.5))
        self.poles = torch.tensor(polarities(lowest.space.structured, middle))
        self.started, self.scorings, self.best = time.process_time(), 0, np.inf
        self.history: list[tuple[int, float, float]] = []

    @property
    def seconds(self) -> float:
        return time.process_time() - self.started

    def __call__(self, units: np.ndarray) -> np.ndarray:
        """Penalised objectives of points (layout, free variable)."""
        with torch.no_grad():
            point = torch.as_tensor(units, dtype=torch.float32)
            poles = self.poles.expand(len(units), -1)
            judged = judge(self.lowest, point, poles, self.objectives)
        self.note(len(units), judged)
        return judged.penalized[:, 0].double().numpy()

    def note(self, scorings: int, judged: Judged) -> None:
        self.scorings += scorings
        within = judged.objectives[judged.broken_mm == 0, 0]
        if len(within) and float(within.min()) < self.best:
            self.best = float(within.min())
            self.history.append((self.scorings, self.seconds, self.best))

    def after(self, scorings: float = np.inf, seconds: float = np.inf) -> float | None:
        """The best after so many scorings, or so much processor time; None where nothing kept every limit."""
        within = [best for n, s, best in self.history if n <= scorings and s <= seconds]
        return within[-1] if within else None


def tool(space: SearchSpace, lowest: LowestFidelity, seed: int, budget: int) -> dict[str, Any]:
    """The tool's own loop, without its store and its second process."""
    search, meter = space.spec.search, Meter(lowest, space)
    asked = sampling("random", space.variables, 1, seed, search.batch)
    counted = lowest_fidelity.judge

    def counting(*arguments: Any) -> Judged:
        judged = counted(*arguments)
        meter.scorings += len(arguments[1])
        return judged

    lowest_fidelity.judge = counting
    best, trials = np.inf, 0
    try:
        while meter.scorings < budget:
            batch = ask(asked, search.batch)
            results = score_trials(space, lowest, [dict(one.params) for one in batch])
            for trial, result in zip(batch, results, strict=True):
                tell(asked, trial, result.params, result.values, {})
                if result.feasible:
                    best = min(best, result.values[0])
            trials += len(batch)
    finally:
        lowest_fidelity.judge = counted
    best = best if np.isfinite(best) else None
    return {"best": best, "scorings": meter.scorings, "seconds": meter.seconds, "trials": trials}


def plain_cma(meter: Meter, seed: int, enough: Callable[[], bool], times: int = 1) -> None:
    """CMA-ES with so many times its default population."""
    plain_cma_es(meter, int(meter.free.sum()), seed, enough, times)


def plain_random(meter: Meter, seed: int, enough: Callable[[], bool]) -> None:
    rng = np.random.default_rng(seed)
    while not enough():
        meter(rng.random((_PARALLEL, int(meter.free.sum()))))


PEERS = {
    "plain CMA-ES": plain_cma,
    "plain CMA-ES ×4": partial(plain_cma, times=4),
    "random": plain_random,
}


def compared(space: SearchSpace, lowest: LowestFidelity, seed: int, budget: int) -> dict[str, Any]:
    """All engines with one seed."""
    found: dict[str, Any] = {}
    found["tool"] = own = tool(space, lowest, seed, budget)
    for name, peer in PEERS.items():
        meter = Meter(lowest, space)
        peer(
            meter,
            seed,
            lambda m=meter: m.scorings >= own["scorings"] and m.seconds >= own["seconds"],
        )
        found[name] = {
            "same scorings": meter.after(scorings=own["scorings"]),
            "same time": meter.after(seconds=own["seconds"]),
            "scorings": meter.scorings,
            "seconds": meter.seconds,
        }
    return found


def measure(quick: bool) -> dict[str, Any]:
    """All figures of one run, task by task."""
    return {name: _of_task(settings, quick) for name, settings in TASKS.items()}


def _of_task(settings: list[str], quick: bool) -> dict[str, Any]:
    few = [*QUICK, "search.polish_steps=4"] if quick else []
    space = search_space(load_spec(EXAMPLE, settings + few))
    (objective,) = space.spec.search.objectives
    Run(space.spec).require("candidates")
    start = start_scores(space.spec)
    middle = params_at(space, np.full(len(space.variables), 0.5))
    lowest = structure_fidelity(space, middle, start)
    budget = 50 if quick else 30_000
    seeds = [compared(space, lowest, seed, budget) for seed in range(1 if quick else 5)]
    return {"objective": objective, "start": start.scores[objective], "seeds": seeds}


def rows(task: dict[str, Any]) -> dict[str, list[float]]:
    """Best values over the seeds, engine by engine."""
    found: dict[str, list[float]] = {}
    for seed in task["seeds"]:
        for name, one in seed.items():
            for key in ("best", "same scorings", "same time"):
                if key in one:
                    label = name if key == "best" else f"{name}, {key}"
                    found.setdefault(label, []).append(np.inf if one[key] is None else one[key])
    return found


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    lines = ["median (least to most) over seeds"]
    for name, task in result["figures"].items():
        lines.append(f"{name}: {task['objective']}, start {task['start']:.2f}")
        for label, values in rows(task).items():
            spread = f"({min(values):.3f} to {max(values):.3f})"
            lines.append(f"  {label:34} {np.median(values):.3f} {spread}")
    return "\n".join(lines)


def main(arguments: list[str] | None = None) -> None:
    """Measure, write, print."""
    options = option_parser("Engines of a layout search").parse_args(arguments)
    torch.set_num_threads(1)
    here = machine(1, ("torch", "numpy", "cmaes", "optuna"))
    result = {"machine": here, "quick": options.quick, "figures": measure(options.quick)}
    conclude("search_engines", options, result, report)


if __name__ == "__main__":
    main(sys.argv[1:])
