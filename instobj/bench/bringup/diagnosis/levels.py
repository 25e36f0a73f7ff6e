"""Resting levels of the closed object against its model, with what is known of chips and magnets."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import POOR_FIT, FaultKind, Hypothesis, rank, rest_model
from instobj.bench.bringup.diagnosis.findings import ChipFound, Finding


def turn_to_design(
    chips: Sequence[ChipFound], counts: Float[np.ndarray, "chip 3"]
) -> Float[np.ndarray, "site 3"]:
    """Readings as chips would give them that sit as drawn; NaN where a needed axis is silent."""
    sorted_counts = np.full(counts.shape, np.nan)
    for chip, reading in zip(chips, counts, strict=True):
        missing = np.isnan(reading)
        turned = chip.turn.T @ np.where(missing, 0.0, reading)
        lost = (abs(chip.turn.T) > 0.5) @ missing
        sorted_counts[chip.site] = np.where(lost, np.nan, turned)
    return sorted_counts


def judge_levels(
    spec: ObjectSpec,
    flipped: Collection[int],
    counts: Float[np.ndarray, "site 3"],
    judged_kinds: Collection[FaultKind],
) -> Hypothesis:
    """The likeliest none or one fault behind the resting levels; `flipped` magnets are known.

    Kinds of faults that other recordings have already judged (`seen`) are not looked for again.
    """
    model = rest_model(with_flips(spec, flipped), spec.sensors.drift_counts)
    looked_for = [(), *((fault,) for fault in model.faults if fault.kind not in judged_kinds)]
    return rank(model, counts.ravel(), looked_for)[0]


def level_findings(best: Hypothesis) -> list[Finding]:
    """The fault that explains the levels, or that none does."""
    measured = f"ln of the odds {best.log_odds:.1f}, as far off with probability {best.fit:.2g}"
    if best.fit < POOR_FIT:
        return [Finding("resting levels", "object", f"beyond all tolerances ({measured})")]
    return [Finding("resting levels", str(fault), measured) for fault in best.faults]


def with_flips(spec: ObjectSpec, flipped: Collection[int]) -> ObjectSpec:
    count = spec.magnets.count
    flips = [
        {"face": spec.body.sensed[k // count], "magnet": k % count + 1, "flipped": True}
        for k in sorted(flipped)
    ]
    return spec.changed(as_built={"magnets": flips})
