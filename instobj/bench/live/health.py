"""Health of every channel, from its last readings: silent, saturated, dead, noisy or drifting."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from design.spec.object import ObjectSpec
from estimator.inversion.condition import CONDITIONS, Condition, object_condition

_WITHOUT_AXIS = str.maketrans("", "", "XYZ")
STATES = ("good", "absent", "silent", "saturated", "dead", "noisy", "drifting")
GOOD, ABSENT, SILENT, SATURATED, DEAD, NOISY, DRIFTING = range(len(STATES))
WINDOW = 400
"""Frames that are looked at."""
_LEAST, _BLOCK, _LATEST = 50, 50, 10
NOISY_FROM = 3.0
"""Times the specified noise."""
_SEEN_NOISE = 0.5
"""Noise (counts) from which a constant reading is no accident."""
_FULL_SCALE = 0.995


@dataclass(frozen=True)
class HealthLimits:
    """Limits of a channel: its noise, full scale and drift since the zero, in counts."""

    noise_counts: Float[np.ndarray, "channel"]
    full_scale_counts: float
    drift_counts: float


def health_limits(spec: ObjectSpec) -> HealthLimits:
    """Those of the specification's chips; a drift counts beyond three errors of the zero and
    `sensors.drift_counts` together."""
    from design.layout.places.positions import sensor_layout

    chips, number = spec.sensors, len(sensor_layout(spec).face)
    return HealthLimits(
        np.tile(np.asarray(chips.noise_counts, float), number),
        chips.range_mt * chips.counts_per_mt,
        float(np.hypot(3 * chips.zeroing_counts, chips.drift_counts)),
    )


def channel_health(
    raw: Float[np.ndarray, "frame channel"],
    live: Bool[np.ndarray, "channel"],
    drift: Float[np.ndarray, "channel"] | None,
    limits: HealthLimits,
) -> list[int]:
    """Return the worst of each channel's `STATES`; states that need 50 frames stay good before.

    Parameters
    ----------
    raw : the last `WINDOW` frames, raw counts, NaN without a reading
    live : channels that the board named
    drift : change of the resting level since the zero; None where nobody knows rest
    """
    state = np.full(raw.shape[1], GOOD)
    if drift is not None:
        state[np.abs(np.nan_to_num(drift)) > limits.drift_counts] = DRIFTING
    state[_noise(raw) > NOISY_FROM * np.hypot(limits.noise_counts, 12**-0.5)] = NOISY
    if len(raw) >= _LEAST:
        recent = raw[-_LEAST:]
        same = np.all(recent == recent[0], axis=0)
        state[same & (limits.noise_counts >= _SEEN_NOISE)] = DEAD
    state[np.any(np.abs(raw[-_LATEST:]) >= _FULL_SCALE * limits.full_scale_counts, axis=0)] = (
        SATURATED
    )
    state[np.isnan(raw[-_LATEST:]).all(axis=0)] = SILENT
    state[~live] = ABSENT
    return state.tolist()


def channel_condition(state: int) -> str:
    """Return what a channel's state asks for, of `CONDITIONS`: chips without sound readings are replaced,
    where their wires are whole. A channel that the board does not name asks for nothing."""
    return {GOOD: "fine", ABSENT: "fine", DRIFTING: "zero again"}.get(state, "recast")


def whole_condition(read: Condition, states: list[int], names: list[str]) -> Condition:
    """Return the condition of the whole object: by what is read or by its channels' states, whichever asks
    for more work."""
    condition_of = {
        name: channel_condition(state) for name, state in zip(names, states, strict=True)
    }
    poor = [name for name, condition in condition_of.items() if condition == "recast"]
    drifting = [name for name, condition in condition_of.items() if condition == "zero again"]
    chips = list(dict.fromkeys(name.translate(_WITHOUT_AXIS) for name in poor))
    by_channels = object_condition(0.0, chips_out=chips, drifting=drifting)
    return max(read, by_channels, key=lambda condition: CONDITIONS.index(condition.name))


def _noise(raw: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "channel"]:
    """White noise of the quietest block of frames: second differences feel no slope, and presses do
    not last through all blocks."""
    blocks = len(raw) // _BLOCK
    if not blocks:
        return np.zeros(raw.shape[1])
    cut = np.nan_to_num(raw[-blocks * _BLOCK :]).reshape(blocks, _BLOCK, -1)
    bend = np.diff(cut, n=2, axis=1)
    return np.sqrt(np.mean(bend**2, axis=1) / 6).min(axis=0)
