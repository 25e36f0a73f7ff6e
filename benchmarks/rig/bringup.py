"""Faults named, false alarms and errors of a bring-up, over many simulated objects.

`python -m benchmarks.rig.bringup SPEC FIRST LAST [FAULT…]` prints one JSON line per object: what was
named, errors of gains and offsets and whether their intervals hold the truth. The fault `five` stands for
five at once, at places that differ from object to object.
"""

# pyright: reportOptionalMemberAccess=false, reportOptionalIterable=false, reportReturnType=false
from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.asking.asked import asked_of, magnet_names
from instobj.bench.bringup.diagnosis.findings import channel_name
from instobj.bench.bringup.simulated import SimulatedObject, parse_fault, simulated_object
from instobj.bench.bringup.verdict import Verdict, judge

CROSS_AXIS = "sensors.chip_spread=[0.0,0.01]"


def errors(made: SimulatedObject, verdict: Verdict, times_s: float) -> dict[str, float]:
    """Errors of what was measured against what the simulated object is."""
    gain = np.linalg.norm(made.matrix, axis=2) / made.spec.sensors.counts_per_mt
    gain = np.where(made.dead | made.stuck | made.silent, np.nan, gain)
    held = np.stack([chip.gain for chip in verdict.chips])
    held_interval = np.stack([chip.gain_interval for chip in verdict.chips])
    off = held - gain / np.nanmedian(gain)
    chip_off = np.array([chip.mean_gain for chip in verdict.chips]) - np.nanmean(gain, axis=1)
    earth = verdict.earth
    earth_off = earth.gain / np.nanmean(earth.gain) - gain / np.nanmean(gain)
    offset_off = earth.offset - made.offset - 1e3 * times_s * made.slope_per_ms
    field = float(np.linalg.norm(made.earth_ut))
    return {
        "held_gain_rms": _rms(off),
        "held_gain_stated": _rms(held_interval) / 1.96,
        "held_gain_covered": _share(abs(off) < held_interval, off),
        "held_chip_gain_rms": _rms(chip_off),
        "earth_gain_rms": _rms(earth_off),
        "earth_gain_stated": _rms(earth.gain_interval) / 1.96,
        "earth_gain_covered": _share(abs(earth_off) < earth.gain_interval, earth_off),
        "offset_rms": _rms(offset_off),
        "offset_stated": _rms(earth.offset_interval) / 1.96,
        "offset_covered": _share(abs(offset_off) < earth.offset_interval, offset_off),
        "field_ut": field,
        "field_error_ut": earth.field_ut - field,
        "field_interval_ut": earth.field_interval_ut,
        "misfit": earth.misfit,
        "largest_angle_deg": max(chip.angle_deg for chip in verdict.chips),
        "least_moment": min(abs(magnet.strength) for magnet in verdict.magnets),
        "largest_moment": max(abs(magnet.strength) for magnet in verdict.magnets),
        "levels_fit": verdict.levels.fit,
    }


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(values**2)))


def _share(inside: np.ndarray, values: np.ndarray) -> float:
    return float(np.mean(inside[np.isfinite(values)]))


def five_faults(spec: ObjectSpec, seed: int) -> list[str]:
    """Two chips swapped, one turned, one with a gain of 1.1, a dead axis of another; a flipped magnet."""
    rng = np.random.default_rng((seed, 5))
    chips = rng.permutation(sensor_names(sensor_layout(spec).face)).tolist()
    dead = channel_name(chips[3], int(rng.integers(3)))
    swap, flip = ",".join(sorted(chips[:2])), rng.choice(magnet_names(spec))
    return [
        f"swap={swap}",
        f"turn={chips[2]}",
        f"dead={dead}",
        f"gain={chips[4]}=1.1",
        f"flip={flip}",
    ]


def study(spec: ObjectSpec, seed: int, faults: list[str]) -> dict[str, object]:
    """One object."""
    faults = five_faults(spec, seed) if faults == ["five"] else faults
    made = simulated_object(spec, seed, tuple(map(parse_fault, faults)))
    recordings = {question.name: made.recording(question) for question in asked_of(spec)}
    verdict = judge(spec, recordings)
    poses = [r.board_ms.mean() for name, r in recordings.items() if name.startswith("earth")]
    named = [f"{finding.kind}: {finding.where}" for finding in verdict.findings]
    about = {"seed": seed, "faults": faults, "named": named}
    return about | errors(made, verdict, float(np.mean(poses)) / 1000)


if __name__ == "__main__":
    spec = load_spec(Path(sys.argv[1]), [CROSS_AXIS])
    for seed in range(int(sys.argv[2]), int(sys.argv[3])):
        print(json.dumps(study(spec, seed, sys.argv[4:])), flush=True)
