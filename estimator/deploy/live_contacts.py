"""Readings of a board, zeroed and read as contacts of the whole object, frame by frame (no torch)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.deploy.runtime import channel_readings
from estimator.deploy.zeroing import ZERO_FRAMES, StreamZero, ZeroMode
from estimator.inversion.inversion import Inversion
from estimator.inversion.readings import ContactSets
from estimator.inversion.tracking import Tracker


@dataclass
class LiveContacts:
    """Contacts in raw counts, tracked; zeroed as `estimator.deploy.runtime.LiveReader` does.

    Attributes
    ----------
    zero, zero_frames : as there
    """

    inversion: Inversion
    zero: ZeroMode = "rest"
    zero_frames: int = ZERO_FRAMES

    def __post_init__(self) -> None:
        self.rezero()

    def rezero(self) -> None:
        """Take the zero anew from the frames that follow, with nothing pressed."""
        self._tracker, self._still = Tracker(self.inversion), Tracker(_of_one(self.inversion))
        self._level = StreamZero(self.zero, self.zero_frames, self._read_still)

    def feed(
        self, raw_counts: Float[np.ndarray, "face sensor 3"], time_s: float = math.nan
    ) -> ContactSets | None:
        """Read one frame, faces in order from 1; None while there is no zero.

        Raises
        ------
        InputError
            Too few sensors, or a channel that the estimator uses misses its reading.
        """
        self._require_its_sensors(raw_counts)
        now = np.zeros(self.inversion.model.channels)
        now[self.inversion.told] = channel_readings(raw_counts, self.inversion.channels)
        zero = self._level.after(now, time_s)
        return None if zero is None else self._tracker.feed(now - zero)

    def _require_its_sensors(self, raw: Float[np.ndarray, "face sensor 3"]) -> None:
        faces = self.inversion.model.signals.faces
        sensors = self.inversion.model.channels // (3 * len(faces))
        if raw.shape[0] < faces.max() or raw.shape[1] < sensors:
            raise InputError(
                f"the estimator reads {sensors} sensors on faces {faces.tolist()}; got readings of "
                f"{raw.shape[1]} sensors on {raw.shape[0]} faces. Use the estimator of the object "
                "that is read"
            )

    def _read_still(self, change: Float[np.ndarray, "channel"]) -> tuple[float, float]:
        found = self._still.feed(change)
        pressed = found.number[0] > 0
        share = found.odds[0] if pressed else 1 - found.odds[0]
        return float(share), float(np.nansum(found.force_n[0]))


def _of_one(inversion: Inversion) -> Inversion:
    """That knows at most one contact: quick, and enough to tell a press from rest."""
    return replace(inversion, priors=replace(inversion.priors, number=(0.5, 0.5)))
