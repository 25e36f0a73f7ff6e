"""The engines of a layout search beside plain CMA-ES and plain random search, on the first level.

    python benchmarks/search_engines.py [--quick] [--out FOLDER]

All place magnets and sensors, scored as a search scores them on the first level, limits as penalties,
in three tasks (`TASKS`): of the paper's cube (31 lengths and angles) the 99th percentile of the position
bound at 5 N, and over 2, 5 and 12 N its growth over the start's, with limits on other scores; of a
box of 60 × 44 × 40 mm on a coarse mesh (63 lengths and angles, three sizes of faces) the 99th percentile
over 2, 5 and 12 N. The tool improves a random layout by one run of every length of `GENERATIONS`. The
peers: CMA-ES of the package `cmaes` with its default population and with four times that, started anew
where it has converged, and random layouts. Each gets as many scorings as the tool, then as much processor
time; the best layout within all limits counts. One thread; all of a task in one process after each
other, tasks side by side. Writes `search_engines.json`.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import torch
from cmaes import CMA
from harness import machine, run

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, search_space
from design.spec.search import SearchSpec
from design.spec_io import load_spec
from estimator.layouts.polish import Judged, LowestFidelity, judge
from instobj.search.loop import drawn_start
from instobj.search.lowest_fidelity import score_trials, start_scores, structure_fidelity
from instobj.stages.run import Run

EXAMPLE = Path(__file__).parents[1] / "examples" / "search_cube.toml"
OUTWARD = 'search.vary.sensor_chip=["outward"]'
OVER_START = [
    'search.objectives=["position_over_limit"]',
    "search.limits.times_start.percentile_99_position_bound_mm=0.45",
]
FREE = [
    'search.objectives=["percentile_99_position_bound_mm"]',
    "search.limits.times_start={position_over_limit=1e4}",
    OUTWARD,
]
COARSE = [
    "mesh.surface_edge_mm=3.5",
    "mesh.edge_mm=8.0",
    "mesh.rim_edge_ratio=1.0",
    "contact_grid.count=[4, 4]",
    "contact_grid.pitch_mm=6.0",
    "press.depths_mm=[1.0, 2.0, 4.0]",
]
TASKS = {
    "2, 5 and 12 N, limits over the start": [OUTWARD, *OVER_START],
    "5 N": [*FREE, "search.forces_n=[5.0]"],
    "box, 2, 5 and 12 N": [*FREE, *COARSE, "body.size_mm=[60.0, 44.0, 40.0]"],
}
GENERATIONS = (30, 100, 300, 600)
SEEDS = range(100, 105)
"""None of those by which engines were chosen."""
_SPREAD = 0.3
"""Standard deviation of a first generation of plain CMA-ES, of the unit cube."""
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


def tool(space: SearchSpace, lowest: LowestFidelity, seed: int) -> dict[str, Any]:
    """One trial as the tool scores it, of a random layout."""
    seeded = replace(space, spec=space.spec.changed(seed=seed))
    start = drawn_start(seeded, 0)
    started = time.process_time()
    (result,) = score_trials(space, lowest, [start])
    best = result.scores[space.spec.search.objectives[0]]  # peers' best have no penalties either
    return {
        "best": best if result.feasible else None,
        "scorings": result.scorings,
        "seconds": time.process_time() - started,
    }


def plain_cma_es(
    worth: Callable[[np.ndarray], np.ndarray],
    free: int,
    seed: int,
    enough: Callable[[], bool],
    times: int = 1,
) -> None:
    """Minimise `worth` (above 0) in the unit cube of `free` numbers by CMA-ES with a multiple of its default
    population, again where it has converged, until there is enough."""
    rng = np.random.default_rng(seed)
    borders = np.repeat([[0.0, 1.0]], free, axis=0)
    population = times * (4 + int(3 * np.log(free)))
    while not enough():
        of_run = int(rng.integers(2**31))
        run = CMA(
            rng.random(free), _SPREAD, bounds=borders, seed=of_run, population_size=population
        )
        while not (run.should_stop() or enough()):
            units = np.array([run.ask() for _ in range(population)])
            run.tell(list(zip(units, np.log(worth(units)).tolist(), strict=True)))


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


def compared(
    space: SearchSpace, lowest: LowestFidelity, seed: int, lengths: Sequence[int]
) -> dict[str, Any]:
    """All engines with one seed, run length by run length."""
    runs = {
        length: tool(
            replace(space, spec=space.spec.changed(search=_of_length(space, length))), lowest, seed
        )
        for length in lengths
    }
    found: dict[str, Any] = {str(length): {"tool": run} for length, run in runs.items()}
    most = {key: max(run[key] for run in runs.values()) for key in ("scorings", "seconds")}
    for name, peer in PEERS.items():
        meter = Meter(lowest, space)
        peer(
            meter,
            seed,
            lambda m=meter: m.scorings >= most["scorings"] and m.seconds >= most["seconds"],
        )
        for length, own in runs.items():
            found[str(length)][name] = {
                "same scorings": meter.after(scorings=own["scorings"]),
                "same time": meter.after(seconds=own["seconds"]),
                "scorings": meter.scorings,
                "seconds": meter.seconds,
            }
    return found


def _of_length(space: SearchSpace, generations: int) -> SearchSpec:
    return space.spec.search.changed(polish_steps=generations)


def measure(quick: bool) -> dict[str, Any]:
    """All figures of one run, task by task."""
    with ProcessPoolExecutor(1 if quick else os.cpu_count(), get_context("spawn")) as pool:
        figures = pool.map(_of_task, TASKS.values(), repeat(quick))
        return dict(zip(TASKS, figures, strict=True))


def _of_task(settings: list[str], quick: bool) -> dict[str, Any]:
    torch.set_num_threads(1)
    space = search_space(load_spec(EXAMPLE, settings + (COARSE if quick else [])))
    (objective,) = space.spec.search.objectives
    Run(space.spec).require("candidates")
    start = start_scores(space.spec)
    middle = params_at(space, np.full(len(space.variables), 0.5))
    lowest = structure_fidelity(space, middle, start)
    lengths, seeds = ((1, 4), SEEDS[:1]) if quick else (GENERATIONS, SEEDS)
    found = []
    for seed in seeds:
        found.append(compared(space, lowest, seed, lengths))
        best = {
            length: {
                name: one.get("best", one.get("same scorings")) for name, one in engines.items()
            }
            for length, engines in found[-1].items()
        }
        print(f"{objective}, seed {seed}: {json.dumps(best)}", file=sys.stderr, flush=True)
    return {"objective": objective, "start": start.scores[objective], "seeds": found}


def rows(task: dict[str, Any], length: str) -> dict[str, list[float]]:
    """Best values over the seeds for one run length, engine by engine."""
    found: dict[str, list[float]] = {}
    for seed in task["seeds"]:
        for name, one in seed[length].items():
            for key in ("best", "same scorings", "same time"):
                if key in one:
                    label = name if key == "best" else f"{name}, {key}"
                    found.setdefault(label, []).append(np.inf if one[key] is None else one[key])
    return found


def report(result: dict[str, Any]) -> str:
    """Medians over the seeds, one line for each task and length; inf: none within all limits."""
    lines = []
    for name, task in result["figures"].items():
        lines.append(f"{name}: {task['objective']}, start {task['start']:.2f}")
        for length in task["seeds"][0]:
            medians = ((label, np.median(found)) for label, found in rows(task, length).items())
            best = "; ".join(f"{label} {value:.3f}" for label, value in medians)
            lines.append(f"  {length} generations: {best}")
    return "\n".join(lines)


def whole(quick: bool) -> dict[str, Any]:
    """Figures, and what they were measured on."""
    here = machine(1, ("torch", "numpy", "cmaes"))
    return {"machine": here, "quick": quick, "figures": measure(quick)}


if __name__ == "__main__":
    run(whole, report)
