"""Speed and error of the field models against magpylib, in one run on one thread.

    python benchmarks/field.py [--quick] [--out FOLDER]

The job is the product's own: in every press 25 magnets have moved and turned, and 15 sensors see
the sum of their fields. Both sides do the whole of it, magpylib with one Cylinder per magnet whose
path holds the presses, the product's law in pieces that fit the cache, as signals take it. Times are
processor time, the least of several runs, so that other programs on the machine matter less. Writes
`field.json`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import magpylib
import numpy as np
from harness import best_seconds, conclude, machine, option_parser
from scipy.spatial.transform import Rotation

from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel, field_model, sum_over_magnets
from estimator.field.sources import DiskMagnet
from estimator.field.vectors import Vector, components
from estimator.signals.presses import press_signals
from fem.presses.results import MagnetMotions, PressForces

DISK = DiskMagnet(6.0, 1.0, 1.43)
MAGNETS, SENSORS = 25, 15
PAIRS_PER_PRESS = MAGNETS * SENSORS
TARGETS = {8.0: 30.0, 7.0: 20.0}
"""Nearest distance (mm) to the ratio of rates that is aimed at, with an error of 0.1 %."""
SIGNALS_TARGET_S = 0.5
TYPES = {"float32": np.float32, "float64": np.float64}
PIECE_BYTES = 96 * 1024
"""Size of one temporary: a dozen of them about fill a second-level cache."""


@dataclass(frozen=True)
class Job:
    """Sensors within 0.5 mm of the origin; magnets anywhere from `nearest_mm` from any of them."""

    points_mm: np.ndarray
    centres_mm: np.ndarray
    turns: Rotation

    @property
    def pairs(self) -> int:
        return len(self.centres_mm) * PAIRS_PER_PRESS

    @property
    def axes(self) -> np.ndarray:
        return self.turns.apply([0.0, 0.0, 1.0]).reshape(self.centres_mm.shape)


def make_job(pairs: int, nearest_mm: float) -> Job:
    """About that many pairs, at distances from `nearest_mm` to about three times that."""
    rng = np.random.default_rng(1)
    presses = max(1, round(pairs / PAIRS_PER_PRESS))
    directions = rng.standard_normal((presses, MAGNETS, 3))
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    points = rng.standard_normal((SENSORS, 3))
    points *= 0.5 * rng.uniform(0, 1, (SENSORS, 1)) / np.linalg.norm(points, axis=1, keepdims=True)
    reach = 0.5 + nearest_mm * rng.uniform(1, 3, (presses, MAGNETS, 1))
    return Job(points, reach * directions, Rotation.random(presses * MAGNETS, rng=rng))


def by_magpylib(job: Job) -> Callable[[], np.ndarray]:
    """The job for magpylib, its objects made beforehand."""
    magnets = [
        magpylib.magnet.Cylinder(
            polarization=(0, 0, DISK.polarization_t),
            dimension=(DISK.diameter_mm / 1e3, DISK.height_mm / 1e3),
            position=job.centres_mm[:, magnet] / 1e3,
            orientation=job.turns[slice(magnet, None, MAGNETS)],
        )
        for magnet in range(MAGNETS)
    ]
    points = job.points_mm / 1e3
    return lambda: magpylib.getB(magnets, points, sumup=True)


def by_arrays(job: Job, model: FieldModel, dtype: Any) -> Callable[[], np.ndarray]:
    """The job by the product's law, its arrays made beforehand: presses last, a sensor at a time."""
    points, *placed = (
        components(given.swapaxes(0, -2).astype(dtype))
        for given in (job.points_mm, job.centres_mm, job.axes)
    )
    count = PIECE_BYTES // np.dtype(dtype).itemsize // MAGNETS
    pieces = [slice(first, first + count) for first in range(0, len(job.centres_mm), count)]

    def field(sensor: int, piece: slice) -> Vector:
        centre, axis = (_part(given, np.s_[:, piece]) for given in placed)
        return sum_over_magnets(_part(points, sensor), centre, axis, model)

    return lambda: np.concatenate(
        [[field(sensor, piece) for sensor in range(SENSORS)] for piece in pieces], axis=2
    )


def _part(vector: Vector, rows: Any) -> Vector:
    x, y, z = (component[rows] for component in vector)
    return x, y, z


def magpylib_rate(nearest_mm: float, sizes: tuple[int, ...], repeats: int) -> float:
    """magpylib's pairs per second at the size that suits it best."""
    jobs = [make_job(size, nearest_mm) for size in sizes]
    return max(job.pairs / best_seconds(by_magpylib(job), repeats) for job in jobs)


def rate(model: FieldModel, dtype: Any, job: Job, repeats: int) -> float:
    """Pairs per second of the product's law."""
    return job.pairs / best_seconds(by_arrays(job, model, dtype), repeats)


def largest_error(model: FieldModel, dtype: Any, job: Job) -> float:
    """Largest |ΔB|/|B| against magpylib, magnet by magnet at the first sensor."""
    offset = (job.points_mm[0] - job.centres_mm.reshape(-1, 3)).astype(dtype)
    axes = job.axes.reshape(-1, 3).astype(dtype)
    approximate = np.transpose(model(components(offset), components(axes))).astype(float)
    local = job.turns.inv().apply(job.points_mm[0] - job.centres_mm.reshape(-1, 3))
    disk = magpylib.magnet.Cylinder(
        polarization=(0, 0, DISK.polarization_t),
        dimension=(DISK.diameter_mm / 1e3, DISK.height_mm / 1e3),
    )
    exact = job.turns.apply(disk.getB(local / 1e3))
    error = np.linalg.norm(approximate - exact, axis=1) / np.linalg.norm(exact, axis=1)
    return float(error.max())


def compare(quick: bool) -> list[dict[str, Any]]:
    """Rates and errors of dipole and series at both distances and in both types."""
    sizes = (20_000,) if quick else (20_000, 200_000, 1_000_000)
    repeats = 3 if quick else 7
    rows = []
    for nearest, target in TARGETS.items():
        peer = magpylib_rate(nearest, sizes, repeats)
        job = make_job(sizes[-1], nearest)
        series = field_model(DISK, nearest)
        for model in (series, FieldModel(DISK, "multipole", 1)):
            for name, dtype in TYPES.items():
                speed = rate(model, dtype, job, repeats)
                row = {
                    "nearest_mm": nearest,
                    "model": "dipole" if model.order == 1 else model.name,
                    "order": model.order,
                    "type": name,
                    "largest_error": largest_error(model, dtype, job),
                    "pairs_per_s": speed,
                    "magpylib_pairs_per_s": peer,
                    "ratio": speed / peer,
                    "target_ratio": target if model is series and name == "float32" else None,
                }
                rows.append(row)
    return rows


def signals_seconds(quick: bool) -> dict[str, Any]:
    """Signals of 5 faces, all contact locations, 20 depths and 45 channels from motions (float64)."""
    steps = 2 if quick else 20
    depths = np.linspace(0.2, 4.0, steps)
    spec = ObjectSpec(name="cube", press={"depths_mm": tuple(depths.tolist())})  # type: ignore[arg-type]
    grid, faces = contact_grid(spec), np.arange(1, 6)
    shape = (5, len(grid.xy_mm), steps)
    size = np.repeat([0.3, 0.03], 3)
    motion = size * np.random.default_rng(4).uniform(
        -1, 1, (*shape, len(magnet_layout(spec).face), 6)
    )
    forces = PressForces(faces, grid, depths, np.ones(shape), np.ones(shape))
    motions = MagnetMotions(faces, grid, depths, motion)
    seconds = best_seconds(lambda: press_signals(spec, forces, motions), 3)
    return {"presses": int(np.prod(shape)), "channels": 45, "seconds": seconds}


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    lines = ["r >= mm  model      l<=  type     error     Mpairs/s  x magpylib  target"]
    for row in result["models"]:
        target = f">= {row['target_ratio']:g}" if row["target_ratio"] else ""
        lines.append(
            f"{row['nearest_mm']:7g}  {row['model']:9}  {row['order']:3}  {row['type']:7}"
            f"  {row['largest_error']:.2e}  {row['pairs_per_s'] / 1e6:8.1f}"
            f"  {row['ratio']:10.1f}  {target}"
        )
    signals = result["signals"]
    lines.append(
        f"{signals['presses']} presses x {signals['channels']} channels: {signals['seconds']:.3f} s"
        f" (target {SIGNALS_TARGET_S:g} s for 10000)"
    )
    return "\n".join(lines)


def main(arguments: list[str] | None = None) -> None:
    """Measure, write, print."""
    options = option_parser("Field models against magpylib, one thread").parse_args(arguments)
    result = {
        "machine": machine(1, ("numpy", "magpylib")),
        "quick": options.quick,
        "models": compare(options.quick),
        "signals": signals_seconds(options.quick),
    }
    conclude("field", options, result, report)


if __name__ == "__main__":
    main(sys.argv[1:])
