"""Contacts of many frames by inversion on a graphics card beside one and two cores, in one run.

    python benchmarks/card_inversion.py [--quick] [--contacts contacts.nc] [--out FOLDER]

Made frames of two pressed faces with one, two or three tips each, 1 to 17 N a face, noise and gains off by
3 %, read from scratch: a part of them on one core and by two processes, all on the card; contacts of that
part by both are compared. The estimator is that of `examples/paper_cube.toml` from the store, or of a file
that `instobj train --set training.model=inversion` wrote, which needs neither store nor mesher. Wall clock,
the first run on the card apart. Needs CUDA. Writes `card_inversion.json`.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from harness import Result, machine, run
from scipy.optimize import linear_sum_assignment

from estimator.field.device import SWITCH
from estimator.inversion.inversion import Inversion
from estimator.inversion.readings import ContactSets
from estimator.inversion.storage import load_inversion

EXAMPLE = Path(__file__).parents[1] / "examples" / "paper_cube.toml"
_LEFT_OVER = 0.04
_GAIN = 0.03
_APART_MM = 10.0
_FAR_MM = 99.0

_estimator: Inversion | None = None


def measure(quick: bool, contacts: Path | None, card: str = "cuda") -> Result:
    """Frames a second on the processor and on the card, and how far their contacts agree."""
    global _estimator
    _estimator = estimator = load_inversion(contacts) if contacts else _of_example()
    frames, few = (240, 120) if quick else (6000, 480)
    counts = made_frames(estimator, frames, np.random.default_rng(1))
    os.environ[SWITCH] = "cpu"
    estimator.read(counts[:3])
    one, read = _timed(lambda: estimator.read(counts[:few])[0])
    two = _on_two_cores(counts[:few])
    os.environ[SWITCH] = card
    first, _ = _timed(lambda: estimator.read(counts))
    on_card, found = min(
        (_timed(lambda: estimator.read(counts)[0]) for _ in range(1 if quick else 3)),
        key=lambda timed: timed[0],
    )
    rates = {"one_core": few / one, "two_cores": few / two, "card": frames / on_card}
    return {
        "machine": machine(1, ["torch", "numpy", "scipy"]),
        "card": _name(card),
        "frames": frames,
        "frames_on_the_processor": few,
        "frames_per_second": rates,
        "ratio_to_one_core": rates["card"] / rates["one_core"],
        "ratio_to_two_cores": rates["card"] / rates["two_cores"],
        "first_run_s": first,
        "run_s": on_card,
        "memory_gb": _memory_gb(card),
        **agreement(read, found.select(np.arange(few))),
    }


def _of_example() -> Inversion:
    from design.spec_io import load_spec
    from estimator.inversion.inversion import inversion
    from estimator.signals.presses import press_signals
    from instobj.stages.run import Run
    from instobj.store.readers import PRESSES

    spec = load_spec(EXAMPLE)
    presses = Run(spec).read(PRESSES)
    return inversion(spec, *presses, press_signals(spec, *presses), _LEFT_OVER, 0.0)


def made_frames(estimator: Inversion, frames: int, rng: np.random.Generator) -> np.ndarray:
    """Changes of counts of two pressed faces."""
    model = estimator.model
    (low, high), faces = model.bounds, len(model.signals.faces)
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    for row in range(frames):
        tips = row % 3 + 1
        for jaw, on in enumerate(rng.choice(faces, min(2, faces), replace=False)):
            slots = slice(jaw * tips, (jaw + 1) * tips)
            face[row, slots] = on
            contact[row, slots, :2] = _places(low[:2], high[:2], tips, rng)
            contact[row, slots, 2] = rng.uniform(1, 17) * rng.dirichlet(np.full(tips, 20.0))
    counts = model.singles(face, contact)[:, :, 0].sum(axis=1) + model.interaction(face, contact)
    gain = 1 + _GAIN * rng.standard_normal((frames, counts.shape[1] // 3)).repeat(3, axis=1)
    noise = np.minimum(estimator.disturbances.noise_counts, 1e3)
    return counts * gain + noise * rng.standard_normal(counts.shape)


def _places(low: np.ndarray, high: np.ndarray, tips: int, rng: np.random.Generator) -> np.ndarray:
    while True:
        xy = rng.uniform(low, high, (tips, 2))
        apart = np.linalg.norm(xy[:, None] - xy, axis=2) + _FAR_MM * np.eye(tips)
        if apart.min() > _APART_MM:
            return xy


def _timed(call: Callable[[], Any]) -> tuple[float, Any]:
    began = time.perf_counter()
    found = call()
    return time.perf_counter() - began, found


def _on_two_cores(counts: np.ndarray) -> float:
    """Seconds of two processes that read half of the frames each, once they are there."""
    with ProcessPoolExecutor(2, get_context("fork")) as pool:
        list(pool.map(_read_part, [counts[:30], counts[:30]]))
        began = time.perf_counter()
        list(pool.map(_read_part, [counts[::2], counts[1::2]]))
        return time.perf_counter() - began


def _read_part(counts: np.ndarray) -> int:
    assert _estimator is not None
    return len(_estimator.read(counts)[0])


def agreement(one: ContactSets, other: ContactSets) -> Result:
    """Return how many frames have another number or other faces, and how far places, forces and odds differ
    in the rest."""
    differ, away_mm, away_n = 0, [0.0], [0.0]
    for row, number in enumerate(one.number):
        if number != other.number[row]:
            differ += 1
            continue
        (xy, force, face), (xy_other, force_other, face_other) = (
            (part.xy_mm[row, :number], part.force_n[row, :number], part.face[row, :number])
            for part in (one, other)
        )
        cost = np.linalg.norm(xy[:, None] - xy_other, axis=2)
        cost += _FAR_MM * (face[:, None] != face_other)
        mine, theirs = linear_sum_assignment(cost)
        if number and cost[mine, theirs].max() >= _FAR_MM:
            differ += 1
            continue
        away_mm.append(cost[mine, theirs].max(initial=0.0))
        away_n.append(np.abs(force[mine] - force_other[theirs]).max(initial=0.0))
    return {
        "frames_with_other_contacts": differ,
        "places_differ_mm_99": float(np.quantile(away_mm, 0.99)),
        "places_differ_mm": float(max(away_mm)),
        "forces_differ_n": float(max(away_n)),
        "odds_differ_99": float(np.quantile(np.abs(one.odds - other.odds), 0.99)),
        "odds_differ": float(np.abs(one.odds - other.odds).max()),
    }


def _name(card: str) -> str:
    import torch

    return torch.cuda.get_device_name() if card.startswith("cuda") else card


def _memory_gb(card: str) -> float:
    import torch

    return torch.cuda.max_memory_allocated() / 1e9 if card.startswith("cuda") else 0.0


def report(found: Result) -> str:
    """In words."""
    rates = found["frames_per_second"]
    return (
        f"{found['card']} beside {found['machine']['processor']}: contacts of {found['frames']} frames "
        f"{rates['card']:.0f}/s, one core {rates['one_core']:.0f}/s, two {rates['two_cores']:.0f}/s; "
        f"{found['ratio_to_one_core']:.1f} times one core, {found['ratio_to_two_cores']:.1f} times two; "
        f"first run {found['first_run_s']:.1f} s, then {found['run_s']:.1f} s; {found['memory_gb']:.1f} GB\n"
        f"of {found['frames_on_the_processor']} frames {found['frames_with_other_contacts']} have other "
        f"contacts, places differ by {found['places_differ_mm']:.1e} mm (99 %: "
        f"{found['places_differ_mm_99']:.1e}), forces by {found['forces_differ_n']:.1e} N, odds by "
        f"{found['odds_differ']:.1e} (99 %: {found['odds_differ_99']:.1e}) at most"
    )


if __name__ == "__main__":
    run(measure, report, contacts=(Path, None, "contacts.nc of an estimator"))
