"""Time of contacts by inversion, tracked and from scratch, beside SciPy's least squares.

    python benchmarks/inversion.py [--quick] [--out FOLDER]

Made grasps of the paper's cube by two jaws with one, two or three tips each, which rise to 17 N, hold and
fall; noise as the estimator expects it, and the model that made them. Tracked: each frame from the last one's
contacts. From scratch: single frames alone, and 70 together. The peer refits the last frame's contacts by
`scipy.optimize.least_squares` (numerical derivatives), with their number given. Medians of processor time
over frames above 4 N. The mechanics come from the store, or are made first. Writes `inversion.json`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from harness import Result, machine, run
from scipy.optimize import least_squares

from design.layout.places.contact_grid import contact_grid
from design.spec_io import load_spec
from estimator.inversion.inversion import Inversion, inversion
from estimator.inversion.tracking import Tracker
from estimator.signals.presses import press_signals
from instobj.stages.run import Run
from instobj.store.readers import PRESSES

EXAMPLES = Path(__file__).parents[1] / "examples"
TIPS = {
    1: [(0.0, 0.0)],
    2: [(-0.45, 0.0), (0.45, 0.0)],
    3: [(-0.45, -0.45), (0.45, -0.45), (0.0, 0.45)],
}
"""Places of a jaw's tips over half of the contact grid's width."""
_SHIFT = 0.35
_FORCE_N = np.concatenate([np.zeros(4), np.linspace(1, 17, 10), np.full(8, 17.0), [15, 11, 7, 3]])
_FACES = (3, 5)
"""Of the jaws; the small form presses face 1 alone."""
_LEFT_OVER = 0.04
_TOGETHER = 70
_FROM_N = 4.0


def measure(quick: bool) -> Result:
    """Milliseconds of processor time by tips per jaw, and how often their number is right."""
    example = "gallery/small_cube.toml" if quick else "paper_cube.toml"
    spec = load_spec(EXAMPLES / example)
    presses = Run(spec).read(PRESSES)
    estimator = inversion(spec, *presses, press_signals(spec, *presses), _LEFT_OVER, 0.0)
    rng = np.random.default_rng(1)
    grasps = 1 if quick else 8
    rows = [_row(estimator, tips, grasps, rng) for tips in TIPS]
    return {"machine": machine(1, ["numpy", "scipy"]), "quick": quick, "rows": rows}


def _row(estimator: Inversion, tips: int, grasps: int, rng: np.random.Generator) -> Result:
    tracked, alone, peer, right, counts = [], [], [], [], np.empty((0, 0))
    strong = np.flatnonzero(_FORCE_N > _FROM_N)
    spec = estimator.model.spec
    half_mm = float(contact_grid(spec).x_mm.max())
    jaws = [spec.body.sensed.index(face) for face in _FACES if face in spec.body.sensed] or [0]
    for _ in range(grasps):
        face, contact = _grasp(tips, jaws, half_mm, rng)
        counts = _noisy(estimator, face, contact, rng)
        tracker = Tracker(estimator)
        for row, frame in enumerate(counts):
            took, found = _timed(tracker.feed, frame)
            if row in strong:
                tracked.append(took)
                right.append(int(found.number[0]) == len(jaws) * tips)
        for row in strong[::4]:
            alone.append(_timed(estimator.read, counts[row][None])[0])
            start = face[row], contact[row - 1], half_mm
            peer.append(_timed(_refitted, estimator, counts[row], *start)[0])
    many = np.resize(counts[strong], (_TOGETHER, counts.shape[1]))
    together = _timed(estimator.read, many)[0] / _TOGETHER
    return {
        "tips": tips,
        "tracked_ms": round(float(np.median(tracked)), 2),
        "tracked_ms_95": round(float(np.quantile(tracked, 0.95)), 2),
        "alone_ms": round(float(np.median(alone)), 1),
        "together_ms": round(together, 1),
        "least_squares_ms": round(float(np.median(peer)), 1),
        "number_right": round(float(np.mean(right)), 3),
    }


def _grasp(
    tips: int, jaws: list[int], half_mm: float, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    face = np.full((len(_FORCE_N), 6), -1)
    contact = np.zeros((len(_FORCE_N), 6, 3))
    pressed = _FORCE_N > 0
    for jaw, where in enumerate(jaws):
        shift = rng.uniform(-_SHIFT, _SHIFT, 2)
        for tip, place in enumerate(TIPS[tips]):
            slot = 3 * jaw + tip
            face[pressed, slot] = where
            contact[pressed, slot, :2] = half_mm * (np.array(place) + shift)
            contact[pressed, slot, 2] = _FORCE_N[pressed] / tips
    return face, contact


def _expected(estimator: Inversion, face: np.ndarray, contact: np.ndarray) -> np.ndarray:
    model = estimator.model
    return model.singles(face, contact)[:, :, 0].sum(axis=1) + model.interaction(face, contact)


def _sigma(estimator: Inversion) -> np.ndarray:
    told = estimator.disturbances
    return np.hypot(told.noise_counts, told.offset_counts)


def _noisy(
    estimator: Inversion, face: np.ndarray, contact: np.ndarray, rng: np.random.Generator
) -> np.ndarray:
    expected = _expected(estimator, face, contact)
    return expected + _sigma(estimator) * rng.standard_normal(expected.shape)


def _refitted(
    estimator: Inversion, counts: np.ndarray, face: np.ndarray, contact: np.ndarray, half_mm: float
) -> np.ndarray:
    there, sigma = face >= 0, _sigma(estimator)
    start = contact[there]
    most = np.broadcast_to([half_mm, half_mm, 2 * _FORCE_N.max()], start.shape)
    least = most * [-1.0, -1.0, 0.0]

    def misfit(numbers: np.ndarray) -> np.ndarray:
        now = np.zeros_like(contact)
        now[there] = numbers.reshape(-1, 3)
        return (_expected(estimator, face[None], now[None])[0] - counts) / sigma

    bounds = least.ravel(), most.ravel()
    return least_squares(
        misfit, start.ravel(), bounds=bounds, x_scale=np.tile([1, 1, 5], len(start))
    ).x


def _timed(call: Callable[..., Any], *given: Any) -> tuple[float, Any]:
    began = time.process_time()
    found = call(*given)
    return 1e3 * (time.process_time() - began), found


def report(result: Result) -> str:
    """One line for each number of tips."""
    return "\n".join(
        f"{row['tips']} per jaw: tracked {row['tracked_ms']:.2f} ms (95 %: {row['tracked_ms_95']:.1f}), "
        f"from scratch {row['alone_ms']:.0f} alone, {row['together_ms']:.1f} of {_TOGETHER}; SciPy's least "
        f"squares {row['least_squares_ms']:.0f} ms; number right {row['number_right']:.0%}"
        for row in result["rows"]
    )


if __name__ == "__main__":
    run(measure, report)
