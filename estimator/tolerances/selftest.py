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
from jaxtyping import Bool, Float, Int
from scipy.special import chdtrc

from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, magnets_model
from estimator.signals.field_setup import min_distance_mm, scene, zero_motion
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
"""Probability of each single fault: an estimate. Ten times as much is worth 2.3 in the log of the odds."""
POOR_FIT = 1e-3
"""Below this probability of a worse fit by chance even the best hypothesis is not believed."""
_LEADERS = 20
_SHOWN = 5
"""Most likely hypotheses of an answer, at most."""
_NEARER_MM = 1.0
"""Distance by which tolerances may bring a magnet nearer to a sensor."""
_STEP = 0.05
"""Step of the difference quotients, in standard deviations of a tolerance."""


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
    """Mean and covariance from the specification and its tolerances, to second order in each.

    `noise_counts` is the standard deviation of a mean resting level besides the tolerances'
    (readings averaged, drift); `sensors.zeroing_counts` is always included.
    """
    design, model = design_at_rest(spec)
    mean = resting_counts(spec, design, model)
    moved = np.array(
        [
            [resting_counts(spec, assembly, model) for assembly in pair]
            for pair in _steps(spec, design)
        ]
    ).reshape(-1, 2, len(mean))
    spread = (moved[:, 0] - moved[:, 1]) / (2 * _STEP)
    bend = (moved.sum(axis=1) - 2 * mean) / (2 * _STEP**2)  # counts x + b x², x normal
    noise = np.hypot(noise_counts, spec.sensors.zeroing_counts) ** 2
    covariance = spread.T @ spread + 2 * bend.T @ bend + noise * np.eye(len(mean))
    faults = tuple(_faults(spec, design, model))
    mean = mean + bend.sum(axis=0)
    return RestModel(mean, covariance, faults, full_scale_counts(spec.sensors))


def design_at_rest(spec: ObjectSpec) -> tuple[Assembly, MagnetsModel]:
    """The specification's object at rest, and a field model good for tolerances about it."""
    design = undisturbed(scene(spec, core_slipped=True))
    nearest = min_distance_mm(design.scene, zero_motion(design.scene))
    return design, magnets_model(spec.magnets, nearest - _NEARER_MM)


def _steps(spec: ObjectSpec, design: Assembly) -> Iterator[tuple[Assembly, Assembly]]:
    for name, size in contribution_sizes(design).items():
        if name == "modulus" or not getattr(spec.tolerances, CONTRIBUTIONS[name][0]):
            continue
        for step in _STEP * np.eye(size):
            yield assembled(spec, design, {name: step}), assembled(spec, design, {name: -step})


def resting_counts(
    spec: ObjectSpec, assembly: Assembly, model: MagnetsModel
) -> Float[np.ndarray, "channel"]:
    place = assembly.scene
    return counts_of(spec, place, zero_motion(place), model)[0].ravel()


def _faults(spec: ObjectSpec, design: Assembly, model: MagnetsModel) -> Iterator[Fault]:
    place, mean = design.scene, resting_counts(spec, design, model)
    number = _numbers_within_face(place.magnets.face)
    for magnet, flipped in enumerate(_flipped(design)):
        where = f"magnet {number[magnet]} of face {place.magnets.face[magnet]}"
        yield Fault("flipped magnet", where, shift=resting_counts(spec, flipped, model) - mean)
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
) -> SelfTest:
    """The likeliest none, one or two faults behind resting counts; NaN where a channel is dead.

    All single faults are tried, and of pairs those with one of the 20 likeliest single ones.
    """
    single = rank(model, counts, [(), *((fault,) for fault in model.faults)])
    leaders = [hypothesis.faults[0] for hypothesis in single if hypothesis.faults][:_LEADERS]
    pairs = [(a, b) for a in leaders for b in model.faults if a is not b]
    ranked = sorted(single + rank(model, counts, pairs), key=lambda h: -h.log_odds)
    return SelfTest(
        tuple(distinct_faults(ranked)[:_SHOWN]),
        false_alarm_rate(spec, model, healthy_objects),
        healthy_objects,
    )


def false_alarm_rate(spec: ObjectSpec, model: RestModel, objects: int) -> float:
    """Share of objects drawn within tolerance for which some single fault is preferred."""
    rng = np.random.default_rng((spec.seed, 7))
    design, field = design_at_rest(spec)
    hypotheses = Claims.from_hypotheses(
        [(), *((fault,) for fault in model.faults)], len(model.mean)
    )
    alarms = 0
    for _ in range(objects):
        counts = resting_counts(spec, draw(spec, design, rng), field)
        counts += spec.sensors.zeroing_counts * rng.standard_normal(len(counts))
        alarms += bool(rank(model, counts, hypotheses)[0].faults)
    return alarms / objects


def rank(
    model: RestModel,
    counts: Float[np.ndarray, "channel"],
    hypotheses: Iterable[tuple[Fault, ...]] | Claims,
) -> list[Hypothesis]:
    """Hypotheses by their log posterior over that of "as specified", largest first."""
    given = (
        hypotheses
        if isinstance(hypotheses, Claims)
        else Claims.from_hypotheses(hypotheses, len(counts))
    )
    residual = counts[given.order] - model.mean - given.shift
    silent = given.silent | np.isnan(residual)
    distance, log_volume = quadratic_forms(model, np.where(silent, 0.0, residual), silent)
    freedom = len(counts) - silent.sum(axis=1)
    value = -0.5 * (distance + log_volume + freedom * np.log(2 * np.pi))
    value -= given.silent.sum(axis=1) * np.log(2 * model.full_scale_counts)
    value += given.number * np.log(PRIOR_PROBABILITY)
    fit = chdtrc(freedom, distance)
    order = 1 + np.argsort(value[0] - value[1:], kind="stable")
    return [Hypothesis(given.faults[k], float(value[k] - value[0]), float(fit[k])) for k in order]


@dataclass(frozen=True)
class Claims:
    """Claims of hypotheses, as arrays; the first one is "as specified".

    Attributes
    ----------
    faults : the faults of each hypothesis
    order : from which channel each reading comes
    shift : of the mean, counts
    silent : whether a channel is said to say nothing
    number : of faults
    """

    faults: list[tuple[Fault, ...]]
    order: Int[np.ndarray, "hypothesis channel"]
    shift: Float[np.ndarray, "hypothesis channel"]
    silent: Bool[np.ndarray, "hypothesis channel"]
    number: Int[np.ndarray, "hypothesis"]

    @staticmethod
    def from_hypotheses(hypotheses: Iterable[tuple[Fault, ...]], channels: int) -> Claims:
        all_hypotheses = [(), *hypotheses]
        order = np.tile(np.arange(channels), (len(all_hypotheses), 1))
        shift, silent = np.zeros(order.shape), np.zeros(order.shape, dtype=bool)
        for row, faults in enumerate(all_hypotheses):
            for fault in faults:
                if fault.order is not None:
                    order[row] = order[row, fault.order]
                if fault.shift is not None:
                    shift[row] += fault.shift
                silent[row, list(fault.silent)] = True
        return Claims(
            all_hypotheses,
            order,
            shift,
            silent,
            np.array([len(faults) for faults in all_hypotheses]),
        )


def quadratic_forms(
    model: RestModel,
    residual: Float[np.ndarray, "hypothesis channel"],
    silent: Bool[np.ndarray, "hypothesis channel"],
) -> tuple[Float[np.ndarray, "hypothesis"], Float[np.ndarray, "hypothesis"]]:
    """rᵀC⁻¹r and ln det C (that of all channels taken as 0), silent channels marginalised.

    With K = C⁻¹, rᵀKr falls by (Kr)ᵤᵀ Kᵤᵤ⁻¹ (Kr)ᵤ, and ln det C grows by that of Kᵤᵤ.
    """
    precision = np.linalg.inv(model.covariance)
    weighted = residual @ precision
    # h hypothesis, c channel: rᵀ (K r)
    distance = np.einsum("hc,hc->h", residual, weighted)
    log_volume = np.zeros(len(residual))
    for row in np.flatnonzero(silent.any(axis=1)):
        channels = np.flatnonzero(silent[row])
        block, part = precision[np.ix_(channels, channels)], weighted[row, channels]
        distance[row] -= part @ np.linalg.solve(block, part)
        log_volume[row] = np.linalg.slogdet(block)[1]
    return distance, log_volume


def sensor_names(face: Int[np.ndarray, "sensor"]) -> list[str]:
    """Names as people call them: F3-S2 is the second sensor of face 3."""
    numbers = _numbers_within_face(face)
    return [f"F{f}-S{n}" for f, n in zip(face.tolist(), numbers, strict=True)]


def _channel(names: list[str], channel: int) -> str:
    face, sensor = names[channel // 3].split("-S")
    return f"{face}-{'XYZ'[channel % 3]}{sensor}"


def _numbers_within_face(face: Int[np.ndarray, "part"]) -> list[int]:
    return [int(np.sum(face[:index] == part_face)) + 1 for index, part_face in enumerate(face)]


def distinct_faults(hypotheses: list[Hypothesis]) -> list[Hypothesis]:
    """Without pairs that occur in either order."""
    known_names: set[frozenset[str]] = set()
    kept = []
    for hypothesis in hypotheses:
        names = frozenset(map(str, hypothesis.faults))
        if names not in known_names:
            known_names.add(names)
            kept.append(hypothesis)
    return kept
