"""Alternatives to try next: the stored mechanics scored again with one thing changed at a time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import check
from estimator.information.scores import PlaceScores, score_places
from estimator.signals.presses import Signals, press_signals
from fem.presses.results import load_presses
from instobj.store.readers import ALTERNATIVES, PRESSES, SIGNALS
from instobj.store.stage import StageContext, write_json


@dataclass(frozen=True)
class Alternative:
    """Weakest and median position bound (mm) and worst detectable force (N) after one change."""

    change: str
    weakest_bound_mm: float
    median_bound_mm: float
    worst_detectable_n: float


def make_alternatives(context: StageContext, folder: Path) -> None:
    """Scores after every change, as a table."""
    signals = SIGNALS.read(context.inputs["signals"])
    presses = PRESSES.path(context.inputs["presses"])
    rows = alternatives(context.spec, signals, presses, context.step)
    write_json({"alternatives": [asdict(row) for row in rows]}, ALTERNATIVES.path(folder))


def alternatives(
    spec: ObjectSpec, signals: Signals, presses: Path, step: Callable[[str], None]
) -> list[Alternative]:
    """Score changes that leave the stored mechanics valid, best first; as specified comes first.

    A softer silicone scales every force by its modulus; more sensors and stronger magnets move no
    silicone. Changes that the specification's own checks refuse are left out.
    """
    rows = [_row("as specified", score_places(spec, signals))]
    step("all channels")
    rows.append(_row("estimator reads all channels, not its own face's", _all(spec, signals)))
    for change, update in _CHANGES.items():
        step(change)
        try:
            other = check(update(spec))
            scores = score_places(other, _signals(spec, other, signals, presses))
        except ValueError:
            continue
        rows.append(_row(change, scores))
    return rows[:1] + sorted(rows[1:], key=lambda row: row.weakest_bound_mm)


def _all(spec: ObjectSpec, signals: Signals) -> PlaceScores:
    score = spec.score.changed(channels="all")
    return score_places(spec.changed(score=score), signals)


def _quieter(spec: ObjectSpec) -> ObjectSpec:
    x, y, z = (noise / 2 for noise in spec.sensors.noise_counts)
    return _with_sensors(spec, noise_counts=(x, y, z))


def _one_more_sensor(spec: ObjectSpec) -> ObjectSpec:
    if spec.sensors.positions_mm is not None:
        raise InputError("sensors.positions_mm says where each sensor is. Add one by hand")
    return _with_sensors(spec, count_per_face=spec.sensors.count_per_face + 1)


def _stronger(spec: ObjectSpec) -> ObjectSpec:
    stronger = {
        "grade": None,
        "remanence_t": 1.2 * spec.magnets.remanence_t,
        "current_a": 1.2 * spec.magnets.current_a,
    }
    magnets = spec.magnets.changed(**stronger)
    return spec.changed(magnets=magnets)


def _softer(spec: ObjectSpec) -> ObjectSpec:
    modulus = 0.7 * spec.silicone.youngs_modulus_mpa
    softer = {"youngs_modulus_mpa": modulus, "youngs_modulus_range_mpa": None}
    silicone = spec.silicone.changed(**softer)
    return spec.changed(silicone=silicone)


def _with_sensors(spec: ObjectSpec, **update: object) -> ObjectSpec:
    return spec.changed(sensors=spec.sensors.changed(**update))


_CHANGES: dict[str, Callable[[ObjectSpec], ObjectSpec]] = {
    "four times the averaging (half the white noise)": _quieter,
    "one more sensor on every face": _one_more_sensor,
    "20 % more remanence (coils: current)": _stronger,
    "silicone 30 % softer (deeper presses)": _softer,
}


def _signals(spec: ObjectSpec, other: ObjectSpec, signals: Signals, presses: Path) -> Signals:
    """Signals of `other`, whose mechanics differ from `spec`'s by the modulus at most."""
    ratio = other.silicone.youngs_modulus_mpa / spec.silicone.youngs_modulus_mpa
    if (
        other.magnets == spec.magnets
        and other.sensors.count_per_face == spec.sensors.count_per_face
    ):
        changed = signals
    else:
        changed = press_signals(other, *load_presses(presses))
    return _with_forces(changed, changed.force_n * ratio)


def _with_forces(signals: Signals, force_n: np.ndarray) -> Signals:
    return replace(signals, force_n=force_n)


def _row(change: str, scores: PlaceScores) -> Alternative:
    bound, there = scores.position_bound_fresh_mm, scores.places
    return Alternative(
        change,
        float(bound[there].max()),
        float(np.median(bound[there])),
        float(scores.detectable_force_fresh_n[there].max()),
    )
