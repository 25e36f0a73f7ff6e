"""Report of a recording: what was found, measured and fixed."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import median

import numpy as np
from jaxtyping import Float

from estimator.recordings.checks.faults import Fault
from estimator.recordings.contacts import Place
from estimator.recordings.presses import LAG_FRAMES, LagReport
from estimator.recordings.table import channel_name


@dataclass(frozen=True)
class RecordingReport:
    """Report of what was read, measured, found and fixed; `dataclasses.asdict` for JSON, `str` for people.

    `largest_force_n` is of one load cell from its rest level; `places` lists the contact case of
    each place id, `noise_counts` the white noise at rest by channel name. `presses_zeroed_after` counts
    the presses without enough rest before them, zeroed from the rest that follows. `motion` says what an
    IMU felt; empty without one.
    """

    path: str
    kind: str
    frames: int
    contact_frames: int
    rest_frames: int
    unused_frames: int
    faces_pressed: tuple[int, ...]
    tips: int
    presses: int
    sessions: int
    places: tuple[Place, ...]
    frame_rate_hz: float
    units: str
    lag: LagReport
    largest_force_n: float
    noise_counts: dict[str, float | None]
    presses_zeroed_after: int
    faults: tuple[Fault, ...]
    motion: str = ""

    def __str__(self) -> str:
        lines = [
            f"{self.path}: {self.frames} frames ({self.kind} format), {_number(self.presses, 'press', 'es')} "
            f"of {_number(len(self.places), 'contact case')} on "
            f"face{'s' * (len(self.faces_pressed) > 1)} {', '.join(map(str, self.faces_pressed))}",
            f"  frames: {self.contact_frames} contact, {self.rest_frames} rest, "
            f"{self.unused_frames} not used (neither clearly pressed nor at rest, or faulty); "
            f"{self.frame_rate_hz:.1f} frames/s; {self.units}",
            f"  forces up to {self.largest_force_n:.3g} N; noise at rest {_noise_text(self.noise_counts)}",
            f"  force lag: {_lag_text(self.lag)}",
            *(f"  {text}" for text in filter(None, [self.motion])),
            *(f"  {fault}" for fault in self.faults),
        ]
        return "\n".join(lines)


def _number(count: int, name: str, plural: str = "s") -> str:
    return f"{count} {name}{plural * (count != 1)}"


def _noise_text(noise_counts: dict[str, float | None]) -> str:
    """Medians over the channels of each axis that have readings at rest, noisy ones included."""
    by_axis = {
        axis: [noise for name, noise in noise_counts.items() if noise is not None and axis in name]
        for axis in "XYZ"
    }
    noise_texts = [f"{median(noises):.3g} ({axis})" for axis, noises in by_axis.items() if noises]
    if not noise_texts:
        return "not known"
    number = sum(map(len, by_axis.values()))
    return f"{', '.join(noise_texts)} counts, medians over {number} channels"


def _lag_text(lag: LagReport) -> str:
    if not lag.per_press:
        return (
            f"not known, so not corrected: no place is pressed through more than {LAG_FRAMES} frames on "
            "end. Press one place several times in a row if the load cell may be late"
        )
    did = "corrected" if lag.corrected else "not corrected: too little gained or agreed"
    return (
        f"{lag.frames} frames ({did}); {100 * lag.share_within_2:.0f} % of presses within ±2; variance "
        f"of signals that the force leaves {100 * lag.residual_uncorrected:.1f} % → "
        f"{100 * lag.residual_corrected:.1f} %"
    )


def noise_by_name(noise_counts: Float[np.ndarray, "face sensor 3"]) -> dict[str, float | None]:
    """White noise of every channel at rest, by the channel's name."""
    return {
        channel_name(*index): None if np.isnan(value) else round(float(value), 2)
        for index, value in np.ndenumerate(noise_counts)
    }
