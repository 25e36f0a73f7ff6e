"""Layouts and contacts on a graphics card beside one core of the processor, in one run.

    python benchmarks/graphics_card.py [--quick] [--out FOLDER]

Layouts: random ones of `examples/search_cube.toml`, judged as a search judges them (two faces, three
forces, limits): a generation of one layout at a time on the processor, as the search does, and in
batches on the card; then whole runs of CMA-ES, side by side on the card. How far the results of both
agree stands beside each ratio. Contacts of many frames: `card_inversion.py`, which runs by itself too.
Wall clock, one thread; the ratio of layouts to two cores is half of that to one. Needs CUDA. Writes
`graphics_card.json`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import card_inversion
import numpy as np
import torch
from harness import Result, machine, run

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, search_space
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.layouts.polish import LowestFidelity, judge, polish, population, runs_together
from instobj.search.lowest_fidelity import start_scores, structure_fidelity
from instobj.stages.run import Run

EXAMPLE = Path(__file__).parents[1] / "examples" / "search_cube.toml"
OVER_START = [
    'search.vary.sensor_chip=["outward"]',
    'search.objectives=["position_over_limit"]',
    "search.limits.times_start.percentile_99_position_bound_mm=0.45",
]
DEVICES = ("cpu", "cuda")
TARGET = 20.0
"""Times two cores, for layouts."""
_GENERATIONS = 30


def timed(call: Callable[[], Any], repeats: int) -> float:
    """Least wall clock of calls, after one to warm up, until the card is done."""
    taken = []
    for _ in range(repeats + 1):
        start = time.perf_counter()
        call()
        torch.cuda.synchronize()
        taken.append(time.perf_counter() - start)
    return min(taken[1:])


def measure(quick: bool) -> Result:
    """Ratios and agreements."""
    if not torch.cuda.is_available():
        raise SystemExit(
            f"error: torch {torch.__version__} sees no CUDA device here; use one that has"
        )
    torch.set_num_threads(1)
    inversion = card_inversion.measure(quick, None)
    space, lowest = lowest_of(load_spec(EXAMPLE, OVER_START))
    return {
        "machine": machine(1, ["torch", "numpy"]),
        "card": torch.cuda.get_device_name(),
        "layouts": layouts(space, lowest, quick),
        "inversion": inversion,
    }


def lowest_of(spec: ObjectSpec) -> tuple[SearchSpace, dict[str, LowestFidelity]]:
    """Scorers on both devices, from one store."""
    space = search_space(spec)
    Run(spec).require("candidates")
    middle = params_at(space, np.full(len(space.variables), 0.5))
    found = {}
    for device in DEVICES:
        with torch.device(device):
            found[device] = structure_fidelity(space, middle, start_scores(spec))
    return space, found


def layouts(space: SearchSpace, lowest: dict[str, LowestFidelity], quick: bool) -> Result:
    """Rates of judging, and of runs of CMA-ES, with what both devices make of the same layouts."""
    free = sum(not v.choices for v in space.variables)
    generation, batch = population(free), 256 if quick else 8192
    units = np.random.default_rng(0).random((batch, free))
    poles = polarities(
        lowest["cpu"].space.structured, params_at(space, np.full(len(space.variables), 0.5))
    )

    def judged(device: str, count: int) -> Any:
        with torch.device(device), torch.no_grad():
            at = torch.as_tensor(units[:count], dtype=torch.float32)
            signs = torch.tensor(poles).expand(count, -1)
            return judge(lowest[device], at, signs, space.spec.search.objectives)

    few = min(batch, 4 * generation)
    found = {device: judged(device, few) for device in DEVICES}
    rates = {
        "cpu": generation / timed(lambda: judged("cpu", generation), 3 if quick else 10),
        "cuda": batch / timed(lambda: judged("cuda", batch), 3 if quick else 20),
    }
    runs = {device: _runs(space, lowest[device], units, poles, device) for device in DEVICES}
    return {
        "variables": free,
        "batch": batch,
        "layouts_per_second": rates,
        "ratio_to_two_cores": rates["cuda"] / (2 * rates["cpu"]),
        "objectives_differ": _largest_share(*(found[d].objectives for d in DEVICES)),
        "penalized_differ": _largest_share(*(found[d].penalized for d in DEVICES)),
        "runs": runs,
        "memory_gb": torch.cuda.max_memory_allocated() / 1e9,
    }


def _runs(
    space: SearchSpace, lowest: LowestFidelity, units: np.ndarray, poles: Any, device: str
) -> Result:
    """Generations of runs of CMA-ES: one run on the processor, as many as go side by side on the card."""
    count = min(runs_together(torch.device(device), population(units.shape[1])), len(units))
    with torch.device(device):
        begin = torch.as_tensor(units[:count], dtype=torch.float32)
        signs, weights = torch.tensor(poles).expand(count, -1), torch.ones(count, 1)

        def judge_at(point: Any, rows: Any) -> Any:
            return judge(lowest, point, signs[rows], space.spec.search.objectives)

        seconds = timed(lambda: polish(judge_at, begin, _GENERATIONS, weights), 1)
    return {"runs": count, "seconds_per_generation_of_a_run": seconds / _GENERATIONS / count}


def _largest_share(one: torch.Tensor, other: torch.Tensor) -> float:
    return float((other.cpu() / one.cpu() - 1).abs().max())


def report(found: Result) -> str:
    """In words."""
    one = found["layouts"]
    lines = [
        f"{found['card']} beside {found['machine']['processor']}",
        f"layouts: {one['layouts_per_second']['cuda']:.0f}/s in batches of {one['batch']}, processor "
        f"{one['layouts_per_second']['cpu']:.0f}/s; {one['ratio_to_two_cores']:.1f} times two cores "
        f"(aim {TARGET:.0f}); objectives differ by {one['objectives_differ']:.1e} at most",
        "runs of CMA-ES, a generation of one run: "
        + ", ".join(
            f"{1e3 * run['seconds_per_generation_of_a_run']:.2f} ms of {run['runs']} on {device}"
            for device, run in one["runs"].items()
        ),
        card_inversion.report(found["inversion"]),
    ]
    return "\n".join(lines)


if __name__ == "__main__":
    run(measure, report)
