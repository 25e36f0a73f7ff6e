"""Health of the chips: which answer, how fast, with how many errors, with how much scatter at rest."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.asking.asked import Recording
from instobj.bench.bringup.diagnosis.findings import Finding, channel_name

NOISY = 2.0
"""Times the noise of the specification; real chips differ by a quarter (docs/units.md)."""
SLOW, LOST = 0.9, 0.01
"""Share of the wanted rate below which frames are slow, and share of lost frames that is reported."""
_BUS_ERRORS = 0.01
"""Share of frames with errors of the bus above which it is reported."""
_SEQUENCES = 65536
"""Number of frames after which a frame's 16-bit number begins again."""


@dataclass(frozen=True)
class Health:
    """Health of one recording: rate, lost frames, errors; noise (counts) of every channel, NaN if silent."""

    rate_hz: float
    lost_share: float
    damaged_lines: int
    bus_errors: int | None
    noise_counts: Float[np.ndarray, "chip 3"]


def health_of(recording: Recording) -> Health:
    """Return the health; noise comes from successive readings, which drift does not change."""
    sent = 1 + int(np.sum(np.diff(recording.sequence) % _SEQUENCES))
    lasted_s = float(np.sum(np.maximum(np.diff(recording.board_ms), 0))) / 1000
    steps = np.diff(recording.counts, axis=0)
    has_reading = np.isfinite(steps)
    squares = np.where(has_reading, steps, 0) ** 2
    pairs = has_reading.sum(axis=0)
    noise = np.sqrt(squares.sum(axis=0) / (2 * np.maximum(pairs, 1)))
    return Health(
        (sent - 1) / lasted_s if lasted_s else float("nan"),
        1 - len(recording.sequence) / sent,
        recording.damaged_lines,
        recording.bus_errors,
        np.where(pairs > 0.5 * len(steps), noise, np.nan),
    )


def health_findings(spec: ObjectSpec, recording: Recording) -> Iterator[Finding]:
    """Yield what is out of order with chips and line, from the still recording."""
    health, names = health_of(recording), sensor_names(sensor_layout(spec).face)
    yield from line_findings(spec, health, len(recording.counts))
    for chip, name in enumerate(names):
        noise = health.noise_counts[chip]
        if np.isnan(noise).all():
            yield Finding("silent chip", name, "no reading of any axis")
            continue
        for axis in range(3):
            channel, nominal = channel_name(name, axis), spec.sensors.noise_counts[axis]
            if np.isnan(noise[axis]):
                yield Finding("dead axis", channel, "no reading")
            elif noise[axis] == 0:
                stuck = recording.counts[0, chip, axis]
                yield Finding("dead axis", channel, f"stuck at {stuck:.0f} counts")
            elif noise[axis] > NOISY * nominal:
                measured = f"{noise[axis]:.0f} counts rms at rest, {nominal:g} by the specification"
                yield Finding("noisy channel", channel, measured)


def line_findings(spec: ObjectSpec, health: Health, frames: int) -> Iterator[Finding]:
    wanted_hz = spec.sensors.frame_rate_hz
    if health.rate_hz < SLOW * wanted_hz:
        yield Finding(
            "slow frames", "board", f"{health.rate_hz:.1f} per second, {wanted_hz:g} asked for"
        )
    if health.lost_share > LOST or health.damaged_lines > LOST * frames:
        measured = f"{health.lost_share:.1%} of frames lost, {health.damaged_lines} damaged lines"
        yield Finding("lost frames", "board", measured)
    if (health.bus_errors or 0) > _BUS_ERRORS * frames:
        yield Finding(
            "bus errors", "board", f"{health.bus_errors} failed transfers in {frames} frames"
        )
