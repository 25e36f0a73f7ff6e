"""Readings of a board, zeroed and read as contacts of the whole object, frame by frame (no torch)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from estimator.deploy.runtime import channel_readings
from estimator.deploy.zeroing import (
    REMEMBERED_S,
    ZERO_FRAMES,
    StillReading,
    StreamZero,
    ZeroMode,
)
from estimator.frames.dataset import NO_FACE
from estimator.frames.press_protocol import DRIFT_TIME_S
from estimator.inversion.condition import Condition
from estimator.inversion.holds import HeldDrift
from estimator.inversion.inversion import Inversion
from estimator.inversion.magnets import BesideMagnet
from estimator.inversion.model.forward import NONE
from estimator.inversion.readings import ContactSets
from estimator.inversion.slip import Slip
from estimator.inversion.tracking import Tracker
from estimator.recordings.presses import PAUSE_S
from estimator.signals.hall import full_scale_counts
from estimator.signals.live import is_live

_MOST_DRIFT_S = 180.0
"""Drift of so long, 27 counts by default, makes deviations 1.5 times those of a fresh zero. Where no steady
hold shows drift, contacts would drown in more."""
_AT_THE_END = 0.5
"""Counts: a clipped reading is the largest of whole ones."""


@dataclass
class LiveContacts:
    """Contacts in raw counts, tracked; zeroed as `estimator.deploy.runtime.LiveReader` does.

    Attributes
    ----------
    zero, zero_frames : as there
    leaves_out : it reads frames of which some readings are not believed
    """

    inversion: Inversion
    zero: ZeroMode = "rest"
    zero_frames: int = ZERO_FRAMES
    leaves_out: bool = True

    def __post_init__(self) -> None:
        self._drifting = drifted(self.inversion)
        self._tracker = Tracker(self.inversion)
        self.rezero()

    def warm_up(self) -> None:
        """Read a press: what the first one builds and imports takes a second, which comes too late live.

        Files need no jaws before one of their frames asks for them.
        """
        press = np.array([[[0.0, 0.0, 0.5 * self.inversion.model.bounds[1][2]]]])
        change = self.inversion.model.singles(np.zeros((1, 1), int), press)[0, 0, 0]
        _ = Tracker(self.inversion).feed(change).position_radius_mm
        # what several contacts need takes a fifth of a second to build
        _ = self.inversion.model.pair_counts
        # what jaws are sought from takes a third of a second a face
        for table in self.inversion.jaw_tables:
            self.inversion.jaws.parts(table.face)

    def rezero(self, level: Float[np.ndarray, "channel"] | None = None) -> None:
        """Take the zero again from the frames that follow, with nothing pressed, or the level given.

        A slip of the core stays known, as the calibration is not that of the slipped core; it was none where
        another level proves that the zero was wrong.
        """
        slip = self.slip if level is None else None
        self._tracker = Tracker(self.inversion)
        self._tracker.slip = None if slip is None else slip.zeroed()
        self.level = StreamZero(
            self.zero, self.zero_frames, self.read_still, self.read_drift, level
        )
        self._zero: np.ndarray | None = None
        shown = self.inversion.disturbances
        # 1/12: rounding to whole counts
        noise = np.diag(shown.noise_counts**2 + 1 / 12) + shown.columns @ shown.columns.T
        self._held = HeldDrift(noise, drift_counts(self.inversion, 1.0) ** 2)
        self._age_s = 0.0
        self._unzeroed = np.zeros(self.inversion.model.channels, bool)
        self._out = self._silent = self._unzeroed

    def feed(
        self,
        raw_counts: Float[np.ndarray, "face sensor 3"],
        time_s: float = math.nan,
        left_out: Bool[np.ndarray, "face sensor 3"] | None = None,
    ) -> ContactSets | None:
        """Read one frame, faces in order from 1; None while there is no zero. A channel at the end of its
        range, now or in the zero, says nothing.

        Parameters
        ----------
        left_out : readings that are not believed (`checks.stream.SoundReadings`): contacts are read
            without them. Channels that stood so while the zero was taken wait for the next one.

        Raises
        ------
        InputError
            Too few sensors, or a channel that the estimator uses misses its reading.
        """
        now, starts = self._told(raw_counts, left_out), self.level.starts
        self._zero = self.level.update(now, time_s)
        if self._zero is None:
            return None
        if (slip := self.slip) is not None and self.level.starts > starts:
            self._tracker.slip = slip.zeroed()
        change, most = now - self._zero, full_scale_counts(self.inversion.model.spec.sensors)
        live = is_live(self._zero, change, most - _AT_THE_END) & ~self._out
        self._silent = ~live
        drift = drift_counts(self.inversion, self.level.age_s)
        unshown = min(
            drift,
            drift_counts(self.inversion, _MOST_DRIFT_S),
            math.sqrt(self._held.unknown_counts2),
        )
        change = np.where(live, change, np.nan)
        contacts = self._tracker.feed(change, drift, unshown)
        self._follow_hold(contacts, change)
        slip = self.slip
        if slip is not None and slip.counts.any() and self.level.move(slip.counts):
            self._tracker.slip = slip.carried()
            self._age_s = self._held.unknown_counts2 = 0.0  # the zero moved to rest
        return contacts

    def _follow_hold(self, contacts: ContactSets, change: Float[np.ndarray, "channel"]) -> None:
        """Move the zero by what channels drift while the contacts just read are held.

        Jaws end a hold and begin none: their signals change by other patterns than those of tips.
        """
        held, tips = self._held, (contacts.face[0] != NO_FACE) & ~contacts.jaws[0]
        elapsed_s, self._age_s = self.level.age_s - self._age_s, self.level.age_s
        goes_on = self._age_s > 0 and 0 <= elapsed_s <= PAUSE_S
        held.drift_for(elapsed_s if goes_on else math.inf)
        if self._age_s == 0:  # at rest
            held.unknown_counts2 = 0.0
        if not tips.any():
            held.forget()
        elif not contacts.explained[0] or contacts.chip_out[0] != NONE:
            return
        elif held.is_of(contacts.face[0][tips]):
            self.level.drift(held.follow(change), elapsed_s)
        elif not held.steady and (still := self.level.still_change(held.same_s)) is not None:
            faces = np.searchsorted(self.inversion.model.signals.faces, contacts.face[:, tips])
            places = np.concatenate([contacts.xy_mm, contacts.force_n[..., None]], axis=2)[:, tips]
            slopes = self.inversion.model.singles(faces, places)[0, :, 1:].reshape(-1, len(change))
            mean, frames = still
            mean[np.isnan(change)] = np.nan
            held.begin(contacts.face[0][tips], mean, frames, slopes)

    def condition(self) -> Condition:
        """Return the object's condition by its last frames."""
        live = np.zeros(self.inversion.model.channels, bool)
        live[self.inversion.live_rows] = True
        return self._tracker.condition(live & self._silent)

    @property
    def slip(self) -> Slip | None:
        """Return the slip of the core, as far as it is known; None where it has not slipped."""
        return self._tracker.slip

    def miss(self) -> None:
        """Pass over a frame that lacks a reading: contacts stay where they were."""

    def pass_by(
        self,
        raw_counts: Float[np.ndarray, "face sensor 3"],
        time_s: float,
        left_out: Bool[np.ndarray, "face sensor 3"] | None = None,
    ) -> None:
        """Take a frame that is not read, of which the zero learns; errors as `feed`."""
        self.level.pass_by(self._told(raw_counts, left_out), time_s)

    def _told(
        self,
        raw_counts: Float[np.ndarray, "face sensor 3"],
        left_out: Bool[np.ndarray, "face sensor 3"] | None,
    ) -> Float[np.ndarray, "channel"]:
        """Counts of all channels; those left out show the zero, so that it does not follow them."""
        self._require_its_sensors(raw_counts)
        now, out = np.zeros(self.inversion.model.channels), self._unzeroed.copy()
        now[self.inversion.live_rows] = channel_readings(raw_counts, self.inversion.channels)
        if left_out is not None:
            face, sensor, axis = np.array(self.inversion.channels).T
            stands = left_out[face - 1, sensor, axis]
            out[self.inversion.live_rows[stands]] = True
            if self._zero is None:
                self._unzeroed = out
        self._out = out
        return now if self._zero is None else np.where(out, self._zero, now)

    def _require_its_sensors(self, raw: Float[np.ndarray, "face sensor 3"]) -> None:
        faces = self.inversion.model.signals.faces
        sensors = self.inversion.model.channels // (3 * len(faces))
        if raw.shape[0] < faces.max() or raw.shape[1] < sensors:
            raise InputError(
                f"the estimator reads {sensors} sensors on faces {faces.tolist()}; got readings of "
                f"{raw.shape[1]} sensors on {raw.shape[0]} faces. Use the estimator of the object "
                "that is read"
            )

    def read_still(self, change: Float[np.ndarray, "channel"], frames: int = 1) -> StillReading:
        """Return what the mean of n frames is read as, from scratch."""
        return self._read_mean(self.inversion, change, frames)

    def read_drift(self, followed: Float[np.ndarray, "channel"], frames: int = 1) -> StillReading:
        """Return the same of all that the zero followed lately, with the drift that chips may have."""
        return self._read_mean(self._drifting, followed, frames)

    def _read_mean(self, inversion: Inversion, change: np.ndarray, frames: int) -> StillReading:
        out = self._out | ~self._tracker.believed
        frame = inversion.disturbances.observed(
            np.where(out, np.nan, change)[None], np.array([frames])
        )
        search = inversion.search
        contacts, _, believed = inversion.read_once(search, frame, inversion.error_share())
        pressed = contacts.number[0] > 0
        share = contacts.odds[0] if pressed else 1 - contacts.odds[0]
        explained = bool(contacts.explained[0]) and not self._tracker.beside_magnet
        if (
            explained and pressed
        ):  # what a slipped core shows looks like a press, and turned round too
            beside = BesideMagnet(frame, inversion.lookalike_columns)
            explained = not beside.explains_with_fewer(search, believed)[0]
        return StillReading(float(share), float(np.nansum(contacts.force_n[0])), explained)


def drift_counts(inversion: Inversion, age_s: float) -> float:
    """Return the drift (counts) of a channel since rest was last seen: a random walk."""
    return inversion.model.spec.sensors.drift_counts * math.sqrt(age_s / DRIFT_TIME_S)


def drifted(inversion: Inversion) -> Inversion:
    """Return the same estimator for all that the zero may follow before it forgets it."""
    drift = drift_counts(inversion, REMEMBERED_S)
    offset = np.hypot(inversion.disturbances.offset_counts, drift)
    disturbances = replace(inversion.disturbances, offset_counts=offset)
    return replace(inversion, disturbances=disturbances)
