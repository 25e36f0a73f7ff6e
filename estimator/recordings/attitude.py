"""Attitude and impacts by an IMU: where the weight pulls, in the object's frame, and jolts beyond gravity.

The weight's direction d stands still in the room, so that in an object that turns with the rate ω it obeys
ḋ = −ω × d. The accelerometer, which feels the specific force −g d at rest, draws it back slowly (a
complementary filter: Mahony, Hamel and Pflimlin, IEEE Trans. Autom. Control 53, 1203, 2008). Turns about
the weight itself are not seen.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float

from estimator.recordings.formats.files import read_motion_columns

GRAVITY_M_S2 = 9.80665
"""Standard acceleration of free fall (CGPM 1901)."""
_SETTLE_S = 1.0
"""Time in which the accelerometer draws the direction back by 1 − 1/e."""
_CALM_M_S2, _CALM_S = 0.5, 0.1
"""Specific force off gravity up to which the accelerometer is believed, and for how long it must have been
so: a shaken object passes through gravity's size by chance."""
_LONGEST_STEP_S = 1.0
"""Between two frames; after a longer pause the direction begins again."""


@dataclass
class Attitude:
    """Direction of the weight, frame by frame; None before the first calm reading."""

    down: Float[np.ndarray, "3"] | None = None
    _last_s: float = 0.0
    _shaken_s: float = -np.inf

    def update(self, time_s: float, motion: Float[np.ndarray, "6"]) -> None:
        """Take acceleration (m/s²) and angular rate (rad/s) of a frame; NaN where the IMU was silent."""
        step_s, self._last_s = time_s - self._last_s, time_s
        if not np.isfinite(motion).all():
            return
        force, rate = motion[:3], motion[3:]
        size = float(np.linalg.norm(force))
        if abs(size - GRAVITY_M_S2) > _CALM_M_S2:
            self._shaken_s = time_s
        is_calm = time_s - self._shaken_s > _CALM_S
        if self.down is None or not 0 <= step_s <= _LONGEST_STEP_S:
            self.down = -force / size if is_calm else None
            return
        down, angle = self.down, float(np.linalg.norm(rate)) * step_s
        if angle > 0:
            axis = rate / np.linalg.norm(rate)
            # Rodrigues' rotation by −ω Δt, exact for a rate that is constant over the step
            down = (
                down * np.cos(angle)
                - np.cross(axis, down) * np.sin(angle)
                + axis * (axis @ down) * (1 - np.cos(angle))
            )
        if is_calm:
            gain = 1 - np.exp(-step_s / _SETTLE_S)
            down = down - gain * (down + force / size)
        self.down = down / np.linalg.norm(down)

    @property
    def text(self) -> str:
        """Axis that is down and how far it leans, in words."""
        if self.down is None:
            return "attitude not known yet"
        axis = int(np.argmax(np.abs(self.down)))
        lean_deg = np.degrees(np.arccos(min(1.0, abs(float(self.down[axis])))))
        return f"{'−+'[int(self.down[axis] > 0)]}{'xyz'[axis]} down, {lean_deg:.0f}° off"


@dataclass(frozen=True)
class RecordedMotion:
    """Motion of the object in a recording.

    Attributes
    ----------
    time_s : (frame,)
    down : (frame, 3) unit vector of the weight in the object's frame; NaN where it is not known
    pull : (frame, 3) weight that the object feels over its weight at rest: −f/g of the specific force f.
        Contacts bear this, at rest and accelerated: Σ F + m g = m a is Σ F = m f. NaN where it was silent
    """

    time_s: Float[np.ndarray, "frame"]
    down: Float[np.ndarray, "frame 3"]
    pull: Float[np.ndarray, "frame 3"]

    @property
    def jolt_m_s2(self) -> Float[np.ndarray, "frame"]:
        """Return the specific force off gravity: 0 at rest, 9.8 in free fall, more in an impact.

        One reading a frame: what is shorter may be missed.
        """
        return GRAVITY_M_S2 * np.abs(np.linalg.norm(self.pull, axis=1) - 1)

    def jolt_between(self, start_s: float, end_s: float) -> float:
        """Return the hardest jolt (m/s²) of a stretch; NaN where the IMU was silent."""
        jolt = self.jolt_m_s2[(self.time_s >= start_s) & (self.time_s <= end_s)]
        return float(np.nanmax(jolt)) if np.isfinite(jolt).any() else float("nan")

    def pull_between(self, start_s: float, end_s: float) -> Float[np.ndarray, "3"]:
        """Return the mean pull of a stretch; where the IMU was silent throughout the direction of the weight
        that it last gave, NaN where there is none. The IMU stands for the object's centre of mass: what turns
        add between the two is left out."""
        inside = (self.time_s >= start_s) & (self.time_s <= end_s)
        pull, down = self.pull[inside], self.down[inside]
        heard = np.isfinite(pull).all(axis=1)
        if heard.any():
            return pull[heard].mean(axis=0)
        total = down[np.isfinite(down[:, 0])].sum(axis=0)
        length = float(np.linalg.norm(total))
        return total / length if length > 0 else np.full(3, np.nan)

    @property
    def text(self) -> str:
        """Sentence on the hardest jolt and the largest lean."""
        if not np.isfinite(self.jolt_m_s2).any():
            return "IMU: silent throughout"
        hardest = int(np.nanargmax(self.jolt_m_s2))
        finite = self.down[np.isfinite(self.down[:, 0])]
        lean = "; attitude not known"
        if len(finite):
            turn_deg = np.degrees(np.arccos(np.clip(finite @ finite[0], -1.0, 1.0)).max())
            lean = f"; leans by up to {turn_deg:.0f}° from its first attitude"
        return (
            f"IMU: hardest jolt {self.jolt_m_s2[hardest]:.1f} m/s² beyond gravity at "
            f"{self.time_s[hardest] - self.time_s[0]:.1f} s{lean}"
        )


def recorded_motion(
    time_s: Float[np.ndarray, "frame"], motion: Float[np.ndarray, "frame 6"]
) -> RecordedMotion:
    """Follow the weight through a recording."""
    attitude, down = Attitude(), np.full((len(motion), 3), np.nan)
    for frame, values in enumerate(motion):
        attitude.update(float(time_s[frame]), values)
        if attitude.down is not None:
            down[frame] = attitude.down
    return RecordedMotion(time_s, down, -motion[:, :3] / GRAVITY_M_S2)


def read_motion(path: Path | str) -> RecordedMotion | None:
    """Read the IMU's columns of a recording, labelled or not; None where it has none.

    Raises
    ------
    RecordingError
        As `read_signals`.
    """
    columns = read_motion_columns(path)
    return None if columns is None else recorded_motion(*columns)
