"""Self-test from the resting signals: which fault of assembly or wiring explains them best.

Resting counts y of an object within tolerance are Gaussian about those of its specification,
y ~ N(μ, C), C = A Aᵀ + noise, with A the change of y by one standard deviation of each tolerance
(first order). A fault moves the mean (a magnet the wrong way round), permutes channels (wiring) or
makes channels say nothing (dead or stuck: any value within full scale is as likely). Each fault
costs the log of its prior probability; the hypothesis of the largest posterior wins.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import numpy as np
from jaxtyping import Float, Int
from scipy.stats import chi2

from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel, field_model
from estimator.field.sources import magnet_source
from estimator.signals.field_setup import at_rest, min_distance_mm, scene
from estimator.signals.hall import full_scale_counts
from estimator.tolerances.assembly import (
    CONTRIBUTIONS,
    Assembly,
    assembled,
    contribution_sizes,
    counts_of,
    draw,
    undisturbed,
)

FaultKind = Literal[
    "flipped magnet", "swapped sensors", "swapped channels", "dead sensor", "dead channel"
]
PRIOR_PROBABILITY = 1e-3
"""Of each single fault: an estimate. Ten times as much is worth 2.3 in the log of the odds."""
POOR_FIT = 1e-3
"""Below this probability of a worse fit by chance even the best hypothesis is not believed."""
_LEADERS = 20
_NEARER_MM = 1.0
"""By which tolerances may bring a magnet nearer to a sensor."""
_STEP = 0.05


@dataclass(frozen=True)
class Fault:
    """One fault: where, and what it does to resting counts (flat channels, sensor · 3 + axis).

    `shift` is added to the mean; `order` says from which channel each reading comes; `silent`
    channels say nothing.
    """

    kind: FaultKind
    where: str
    shift: Float[np.ndarray, "channel"] | None = None
    order: Int[np.ndarray, "channel"] | None = None
    silent: tuple[int, ...] = ()

    def __str__(self) -> str:
        return f"{self.kind}: {self.where}"


@dataclass(frozen=True)
class Hypothesis:
    """Some faults (none: as specified) with their log posterior against "as specified".

    `fit` is the probability that an object with these faults and within tolerance lies as far off.
    """

    faults: tuple[Fault, ...]
    log_odds: float
    fit: float

    @property
    def name(self) -> str:
        return " and ".join(map(str, self.faults)) or "as specified"


@dataclass(frozen=True)
class SelfTest:
    """The likeliest hypothesis first; `believed` where it fits at all.

    `false_alarm_rate` is the share of `healthy_objects` simulated within tolerance in which some
    fault would have been preferred.
    """

    hypotheses: tuple[Hypothesis, ...]
    false_alarm_rate: float
    healthy_objects: int

    @property
    def best(self) -> Hypothesis:
        return self.hypotheses[0]

    @property
    def believed(self) -> bool:
        return self.best.fit >= POOR_FIT


@dataclass(frozen=True)
class RestModel:
    """Resting counts of objects within tolerance, and the faults that are looked for."""

    mean: Float[np.ndarray, "channel"]
    covariance: Float[np.ndarray, "channel channel"]
    faults: tuple[Fault, ...]
    full_scale_counts: float


def rest_model(spec: ObjectSpec, noise_counts: float = 0.0) -> RestModel:
    """Mean and covariance from the specification and its tolerances.

    `noise_counts` is the standard deviation of a mean resting level beside that of the tolerances
    (readings averaged, drift); `sensors.zeroing_counts` is always included.
    """
    design, model = _design(spec)
    mean = _rest(spec, design, model)
    columns = [
        (_rest(spec, up, model) - _rest(spec, down, model)) / (2 * _STEP)
        for up, down in _steps(spec, design)
    ]
    spread = np.stack(columns, axis=1)
    noise = np.hypot(noise_counts, spec.sensors.zeroing_counts) ** 2
    covariance = spread @ spread.T + noise * np.eye(len(mean))
    faults = tuple(_faults(spec, design, model))
    return RestModel(mean, covariance, faults, full_scale_counts(spec.sensors))


def _design(spec: ObjectSpec) -> tuple[Assembly, FieldModel]:
    """The specification's object at rest, and a field model good for tolerances about it."""
    design = undisturbed(scene(spec, core_slipped=True))
    nearest = min_distance_mm(design.scene, at_rest(design.scene))
    return design, field_model(magnet_source(spec.magnets), nearest - _NEARER_MM)


def _steps(spec: ObjectSpec, design: Assembly) -> Iterator[tuple[Assembly, Assembly]]:
    for name, size in contribution_sizes(design).items():
        if name == "modulus" or not getattr(spec.tolerances, CONTRIBUTIONS[name][0]):
            continue
        for step in _STEP * np.eye(size):
            yield assembled(spec, design, {name: step}), assembled(spec, design, {name: -step})


def _rest(spec: ObjectSpec, assembly: Assembly, model: FieldModel) -> Float[np.ndarray, "channel"]:
    place = assembly.scene
    return counts_of(spec, place, at_rest(place), model)[0].ravel()


def _faults(spec: ObjectSpec, design: Assembly, model: FieldModel) -> Iterator[Fault]:
    place, mean = design.scene, _rest(spec, design, model)
    number = _numbers_within_face(place.magnets.face)
    for magnet, flipped in enumerate(_flipped(design)):
        where = f"magnet {number[magnet]} of face {place.magnets.face[magnet]}"
        yield Fault("flipped magnet", where, shift=_rest(spec, flipped, model) - mean)
    names = sensor_names(place.sensors.face)
    channels = np.arange(len(mean))
    for a, b in combinations(range(len(names)), 2):
        order = channels.reshape(-1, 3).copy()
        order[[a, b]] = order[[b, a]]
        yield Fault("swapped sensors", f"{names[a]} and {names[b]}", order=order.ravel())
    for a, b in combinations(channels.tolist(), 2):
        order = channels.copy()
        order[[a, b]] = order[[b, a]]
        where = f"{_channel(names, a)} and {_channel(names, b)}"
        yield Fault("swapped channels", where, order=order)
    for sensor, name in enumerate(names):
        yield Fault("dead sensor", name, silent=tuple(range(3 * sensor, 3 * sensor + 3)))
    for channel in channels.tolist():
        yield Fault("dead channel", _channel(names, channel), silent=(channel,))


def _flipped(design: Assembly) -> Iterator[Assembly]:
    magnets = design.scene.magnets
    for magnet in range(len(magnets.face)):
        axis = magnets.axis.copy()
        axis[magnet] = -axis[magnet]
        turned = replace(design.scene, magnets=replace(magnets, axis=axis))
        yield replace(design, scene=turned)


def self_test(
    spec: ObjectSpec,
    model: RestModel,
    counts: Float[np.ndarray, "channel"],
    healthy_objects: int = 100,
    shown: int = 5,
) -> SelfTest:
    """The likeliest none, one or two faults behind resting counts; NaN where a channel is dead.

    All single faults are tried, and of pairs those with one of the 20 likeliest single ones.
    """
    single = rank(model, counts, [(), *((fault,) for fault in model.faults)])
    leaders = [hypothesis.faults[0] for hypothesis in single if hypothesis.faults][:_LEADERS]
    pairs = [(a, b) for a in leaders for b in model.faults if a is not b]
    found = sorted(single + rank(model, counts, pairs), key=lambda h: -h.log_odds)
    return SelfTest(
        tuple(_distinct(found)[:shown]),
        false_alarm_rate(spec, model, healthy_objects),
        healthy_objects,
    )


def false_alarm_rate(spec: ObjectSpec, model: RestModel, objects: int) -> float:
    """Share of objects drawn within tolerance for which some single fault is preferred."""
    rng = np.random.default_rng((spec.seed, 7))
    design, field = _design(spec)
    hypotheses = [(), *((fault,) for fault in model.faults)]
    alarms = 0
    for _ in range(objects):
        counts = _rest(spec, draw(spec, design, rng), field)
        counts += spec.sensors.zeroing_counts * rng.standard_normal(len(counts))
        alarms += bool(rank(model, counts, hypotheses)[0].faults)
    return alarms / objects


def rank(
    model: RestModel,
    counts: Float[np.ndarray, "channel"],
    hypotheses: Iterable[tuple[Fault, ...]],
) -> list[Hypothesis]:
    """Hypotheses by their log posterior over that of "as specified", largest first."""
    every = [(), *hypotheses]
    residual = np.stack([_residual(model, counts, faults) for faults in every])
    silent = [_silent(row, faults) for row, faults in zip(residual, every, strict=True)]
    distance, log_volume = _quadratic_forms(model, np.nan_to_num(residual), silent)
    freedom = len(counts) - np.array([len(channels) for channels in silent])
    claimed = np.array([len({c for f in faults for c in f.silent}) for faults in every])
    value = -0.5 * (distance + log_volume + freedom * np.log(2 * np.pi))
    value -= claimed * np.log(2 * model.full_scale_counts)
    value += np.array([len(faults) for faults in every]) * np.log(PRIOR_PROBABILITY)
    fit = chi2.sf(distance, freedom)
    order = 1 + np.argsort(value[0] - value[1:], kind="stable")
    return [Hypothesis(every[k], float(value[k] - value[0]), float(fit[k])) for k in order]


def _residual(
    model: RestModel, counts: Float[np.ndarray, "channel"], faults: tuple[Fault, ...]
) -> Float[np.ndarray, "channel"]:
    for fault in faults:
        if fault.order is not None:
            counts = counts[fault.order]
    return counts - model.mean - sum(f.shift for f in faults if f.shift is not None)


def _silent(residual: Float[np.ndarray, "channel"], faults: tuple[Fault, ...]) -> list[int]:
    """Channels without a reading, and those that the faults call silent."""
    missing = set(np.flatnonzero(np.isnan(residual)).tolist())
    return sorted(missing.union(*(fault.silent for fault in faults)))


def _quadratic_forms(
    model: RestModel,
    residual: Float[np.ndarray, "hypothesis channel"],
    silent: list[list[int]],
) -> tuple[Float[np.ndarray, "hypothesis"], Float[np.ndarray, "hypothesis"]]:
    """rᵀC⁻¹r and ln det C (that of all channels taken as 0), silent channels marginalised.

    With K = C⁻¹, rᵀKr falls by (Kr)ᵤᵀ Kᵤᵤ⁻¹ (Kr)ᵤ, and ln det C grows by that of Kᵤᵤ.
    """
    precision = np.linalg.inv(model.covariance)
    weighted = residual @ precision
    distance = np.einsum("hc,hc->h", residual, weighted)
    log_volume = np.zeros(len(residual))
    for row, channels in enumerate(silent):
        if channels:
            block, part = precision[np.ix_(channels, channels)], weighted[row, channels]
            distance[row] -= part @ np.linalg.solve(block, part)
            log_volume[row] = np.linalg.slogdet(block)[1]
    return distance, log_volume


def sensor_names(face: Int[np.ndarray, "sensor"]) -> list[str]:
    """As people call them: F3-S2 is the second sensor of face 3."""
    numbers = _numbers_within_face(face)
    return [f"F{f}-S{n}" for f, n in zip(face.tolist(), numbers, strict=True)]


def _channel(names: list[str], channel: int) -> str:
    face, sensor = names[channel // 3].split("-S")
    return f"{face}-{'XYZ'[channel % 3]}{sensor}"


def _numbers_within_face(face: Int[np.ndarray, "part"]) -> list[int]:
    return [int(np.sum(face[:index] == own)) + 1 for index, own in enumerate(face)]


def _distinct(hypotheses: list[Hypothesis]) -> list[Hypothesis]:
    """Without pairs that occur in either order."""
    seen: set[frozenset[str]] = set()
    kept = []
    for hypothesis in hypotheses:
        names = frozenset(map(str, hypothesis.faults))
        if names not in seen:
            seen.add(names)
            kept.append(hypothesis)
    return kept
