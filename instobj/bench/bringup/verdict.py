"""Verdict of a bring-up: everything that its recordings tell, as far as they go."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import FaultKind, Hypothesis
from instobj.bench.bringup.asking.asked import (
    STILL,
    STILL_AGAIN,
    Question,
    Recording,
    Recordings,
    asked_of,
    magnet_names,
)
from instobj.bench.bringup.diagnosis.channels import find_chips, held_readings
from instobj.bench.bringup.diagnosis.chip_findings import chip_findings, earth_findings
from instobj.bench.bringup.diagnosis.chip_fit import chips_found
from instobj.bench.bringup.diagnosis.earth import EarthFound, from_earth
from instobj.bench.bringup.diagnosis.findings import ChipFound, Finding
from instobj.bench.bringup.diagnosis.health import health_findings
from instobj.bench.bringup.diagnosis.levels import judge_levels, level_findings, turn_to_design
from instobj.bench.bringup.diagnosis.poles import (
    MagnetFound,
    PocketFields,
    find_magnet,
    magnet_findings,
    pocket_fields,
)

_JUDGED_WITH_CHIPS: tuple[FaultKind, ...] = (
    "swapped sensors",
    "swapped channels",
    "dead sensor",
    "dead channel",
)
LEAST_HOLDS = 3
"""Fewer say too little about which channel is which."""
_BEYOND_LINEAR = 0.3
"""Share of the scatter of a zero that is left where drift was followed."""


@dataclass(frozen=True)
class Verdict:
    """Findings of all recordings; None where the recordings for it are missing."""

    findings: tuple[Finding, ...]
    chips: tuple[ChipFound, ...] | None
    earth: EarthFound | None
    magnets: tuple[MagnetFound, ...]
    levels: Hypothesis | None


def judge(spec: ObjectSpec, recordings: Recordings) -> Verdict:
    """Judge all recordings that are there; chips count as drawn where no magnet was held."""
    findings = list(health_findings(spec, recordings[STILL])) if STILL in recordings else []
    chips = identified_chips(spec, recordings)
    assumed_chips = chips or drawn_chips(spec)
    earth = _earth(spec, recordings, assumed_chips)
    if chips is not None:
        already = {finding.where for finding in findings}
        findings += [f for f in chip_findings(spec, chips, earth) if f.where not in already]
    if earth is not None:
        findings += earth_findings(spec, earth)
    magnets = tuple(magnets_found(spec, recordings, assumed_chips))
    findings += [wrong for magnet in magnets for wrong in magnet_findings(spec, magnet)]
    levels = _levels(spec, recordings, assumed_chips, chips is not None, magnets)
    findings += [] if levels is None else level_findings(levels)
    return Verdict(tuple(findings), chips, earth, magnets, levels)


def drawn_chips(spec: ObjectSpec) -> tuple[ChipFound, ...]:
    """Chips as the specification says."""
    return tuple(ChipFound(site, np.eye(3)) for site in range(len(sensor_layout(spec).face)))


def identified_chips(spec: ObjectSpec, recordings: Recordings) -> tuple[ChipFound, ...] | None:
    """Every chip's place, turn and gains; None without the still recording and three holds."""
    held = [
        question
        for question in asked_of(spec)
        if question.step == "held" and question.name in recordings
    ]
    if STILL not in recordings or len(held) < LEAST_HOLDS:
        return None
    given = [recordings[question.name] for question in held]
    still, drift_counts, share = levels_without_magnet(spec, recordings, given)
    mask = np.where(silent_findings(recordings), np.nan, 1.0)
    counts = mask * np.stack([recording.unsaturated(spec) for recording in given]) - still
    readings = held_readings(spec, counts, share, drift_counts)
    arrangement = find_chips(spec, readings, [question.part for question in held])
    return tuple(chips_found(readings, arrangement))


def levels_without_magnet(
    spec: ObjectSpec, recordings: Recordings, given: list[Recording]
) -> tuple[Float[np.ndarray, "hold chip 3"], float, Float[np.ndarray, "hold"]]:
    """Levels without a magnet at the times of the holds, and their error by drift (counts).

    Last the variance of each hold's change over that of one frame's noise. Between the still
    recordings before and after the holds levels are taken as linear in time.
    """
    first, last = recordings[STILL], recordings.get(STILL_AGAIN)
    begin, *times, end = (
        float(np.mean(recording.board_ms)) for recording in (first, *given, last or first)
    )
    noise_shares = 1 / np.array([len(recording.counts) for recording in given])
    if last is None or not begin < min(times) or not max(times) < end:
        levels = np.repeat(first.mean[None], len(given), axis=0)
        return levels, spec.sensors.zeroing_counts, noise_shares + 1 / len(first.counts)
    late = (np.array(times) - begin) / (end - begin)
    levels = first.mean + late[:, None, None] * (last.mean - first.mean)
    noise = noise_shares + (1 - late) ** 2 / len(first.counts) + late**2 / len(last.counts)
    return levels, _BEYOND_LINEAR * spec.sensors.zeroing_counts, noise


def silent_findings(recordings: Recordings) -> Bool[np.ndarray, "chip 3"]:
    """Channels that never answer or stick at one value."""
    counts = recordings[STILL].counts
    return np.isnan(recordings[STILL].mean) | (np.ptp(counts, axis=0) == 0)


def _earth(
    spec: ObjectSpec, recordings: Recordings, chips: tuple[ChipFound, ...]
) -> EarthFound | None:
    poses = [question for question in asked_of(spec) if question.step == "earth"]
    if any(question.name not in recordings for question in poses):
        return None
    dead = np.array([chip.dead for chip in chips])
    given = [recordings[question.name] for question in poses]
    means = np.where(dead, np.nan, np.stack([recording.mean for recording in given]))
    times_s = np.array([float(np.mean(recording.board_ms)) / 1000 for recording in given])
    return from_earth(spec, chips, means, times_s, poses[0].frames)


def magnets_found(
    spec: ObjectSpec, recordings: Recordings, chips: tuple[ChipFound, ...]
) -> Iterator[MagnetFound]:
    """Pole and pocket of every magnet whose step was recorded."""
    fields = pocket_fields(spec, chips)
    for question in asked_of(spec):
        if question.step == "magnet" and (
            magnet := magnet_found(spec, recordings, chips, fields, question)
        ):
            yield magnet


def magnet_found(
    spec: ObjectSpec,
    recordings: Recordings,
    chips: tuple[ChipFound, ...],
    fields: PocketFields,
    question: Question,
) -> MagnetFound | None:
    """One magnet from its step against the recording before it; None without both."""
    earlier_name = f"magnet {magnet_names(spec)[question.part - 1]}" if question.part else "closed"
    if earlier_name not in recordings or question.name not in recordings:
        return None
    dead = np.array([chip.dead for chip in chips])
    change = recordings[question.name].unsaturated(spec) - recordings[earlier_name].unsaturated(
        spec
    )
    return find_magnet(fields, question.part, np.where(dead, np.nan, change))


def _levels(
    spec: ObjectSpec,
    recordings: Recordings,
    chips: tuple[ChipFound, ...],
    chips_seen: bool,
    magnets: tuple[MagnetFound, ...],
) -> Hypothesis | None:
    if "rest" not in recordings:
        return None
    judged_kinds: list[FaultKind] = []
    if chips_seen:
        judged_kinds.extend(_JUDGED_WITH_CHIPS)
    if len(magnets) == len(magnet_layout(spec).face):
        judged_kinds.append("flipped magnet")
    flipped = [magnet.expected_pocket for magnet in magnets if magnet.strength < 0]
    counts = _resting_counts(spec, recordings, chips)
    return judge_levels(spec, flipped, counts, judged_kinds)


def _resting_counts(
    spec: ObjectSpec, recordings: Recordings, chips: tuple[ChipFound, ...]
) -> Float[np.ndarray, "site 3"]:
    dead = np.array([chip.dead for chip in chips])
    counts = np.where(dead, np.nan, recordings["rest"].unsaturated(spec))
    return turn_to_design(chips, counts)
