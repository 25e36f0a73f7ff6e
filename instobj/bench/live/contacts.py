"""Contacts for the page: what an estimator reads in a frame, placed on the body."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float

from design.layout.body import face_frame, face_frames
from design.spec.object import ObjectSpec
from estimator.deploy.live_contacts import LiveContacts
from estimator.deploy.zeroing import ZeroMode
from estimator.grasps.track import ContactTrack, track_of_sets
from estimator.inversion.condition import FINE, Condition
from instobj.bench.live.protocol import CONTACT_WIDTH, LABEL_WIDTH

LeftOut = Bool[np.ndarray, "face sensor 3"]
"""Readings that are not believed."""


@dataclass(frozen=True)
class Found:
    """Contacts in a frame, in `protocol.CONTACT`'s columns, whether they explain it, the name of a chip that
    they were read without, the object's condition by its last frames, and the same contacts as a track of one
    frame, of which grasps are judged."""

    contacts: Float[np.ndarray, "contact 15"]
    explained: bool
    chip_out: str = ""
    condition: Condition = FINE
    track: ContactTrack | None = None


class InvertedContacts:
    """Contacts of the whole object, by inversion of its forward model.

    Attributes
    ----------
    channels : the ones that it reads
    presses : depth and contact area of solved presses; None where its file has none
    """

    def __init__(self, spec: ObjectSpec, reader: LiveContacts) -> None:
        self._spec, self._reader = spec, reader
        self.channels = reader.inversion.channels
        self.presses = reader.inversion.model.skin

    def feed(
        self, raw_counts: Float[np.ndarray, "face sensor 3"], time_s: float, left_out: LeftOut
    ) -> Found | None:
        """Return what it reads in the next frame of raw counts; None while there is no zero."""
        reading = self._reader.feed(raw_counts, time_s, left_out)
        if reading is None:
            return None
        radius, halfwidth = reading.position_radius_mm[0], reading.force_halfwidth_n[0]
        rows = [
            placed_contact(
                self._spec,
                (int(reading.face[0, slot]), *reading.xy_mm[0, slot].tolist()),
                (radius[slot], reading.force_n[0, slot], halfwidth[slot]),
                np.nan_to_num(reading.tangential_n[0, slot]),
            )
            for slot in np.flatnonzero(reading.face[0]).tolist()
        ]
        chip = self._reader.inversion.chip_name(int(reading.chip_out[0]))
        shown = np.reshape(rows, (-1, CONTACT_WIDTH))
        force_error = self._reader.inversion.disturbances.force_error
        track = track_of_sets(np.array([time_s]), reading, force_error)
        return Found(shown, bool(reading.explained[0]), chip, self._reader.condition(), track)

    def pass_by(
        self, raw_counts: Float[np.ndarray, "face sensor 3"], time_s: float, left_out: LeftOut
    ) -> None:
        """Take a frame that is left out: the zero follows it."""
        self._reader.pass_by(raw_counts, time_s, left_out)

    def rezero(self) -> None:
        """Take the zero again from the frames that follow."""
        self._reader.rezero()


def open_estimator(
    spec: ObjectSpec, model: Path | None, zero: ZeroMode, zero_frames: int
) -> InvertedContacts | None:
    """Return the reader of `contacts.nc`; None without a file.

    Raises
    ------
    InputError
        A bad file, or none of an inversion.
    """
    from estimator.inversion.storage import load_inversion

    if model is None:
        return None
    reader = LiveContacts(load_inversion(model), zero, zero_frames)
    reader.warm_up()
    return InvertedContacts(spec, reader)


def placed_contact(
    spec: ObjectSpec,
    place: tuple[int, float, float],
    force: tuple[float, float, float],
    pull_n: Float[np.ndarray, "2"],
) -> list[float]:
    """A row of `protocol.CONTACT`; `place` is face, x, y (mm), `force` radius (mm), force and
    halfwidth (N), `pull_n` the tangential force along the face's x and y."""
    point, axes = _place_on_body(spec, place)
    pushed = axes @ np.append(pull_n, -force[1])
    return [*place, *force, *point, *axes[:, 2], *pushed]


def placed_label(spec: ObjectSpec, face: int, x: float, y: float, force_n: float) -> list[float]:
    """A row of `protocol.LABEL`."""
    point, axes = _place_on_body(spec, (face, x, y))
    return [face, x, y, force_n, *point, *axes[:, 2]]


def placed_labels(spec: ObjectSpec, labels: list[list[float]]) -> Float[np.ndarray, "label 10"]:
    """Rows of face, x, y, force on the body; faces that the object does not sense are left out."""
    sensed = {frame.number for frame in face_frames(spec)}
    rows = [
        placed_label(spec, int(label[0]), *label[1:]) for label in labels if int(label[0]) in sensed
    ]
    return np.reshape(rows, (-1, LABEL_WIDTH))


def _place_on_body(
    spec: ObjectSpec, place: tuple[int, float, float]
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
    frame = face_frame(spec, place[0])
    xy = frame.to_plane(np.array(place[1:], float))
    return frame.to_object(np.append(xy, 0.0)), frame.axes_at(xy)
