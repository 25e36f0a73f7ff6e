"""A recording whose presses are numbered: what checks of presses see, and what its frames are made of."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.recordings.checks.faults import Fault, press_changes
from estimator.recordings.checks.repeats import Repeats
from estimator.recordings.presses import CONTACT_FORCE_N, LagReport
from estimator.recordings.table import RawTable
from estimator.recordings.travel_labels import TravelForces

Rows = tuple[Bool[np.ndarray, "frame"], list[Fault]]
"""Frames that a check names, with one sentence for each cause and span."""


@dataclass(frozen=True)
class Judged:
    """A table after its labels were brought into line with its signals.

    Attributes
    ----------
    table : labels carried and faces corrected
    force_n : (frame, cell) from rest, at the instant that the cell reported it
    aligned_n, shear_n : the same, and tangential forces, at the instant of the signals
    press, stretch, block : numbers of the press, of the uninterrupted stretch, of the place
    responses : (press, face) change of each face's signals under force, counts
    no_contact : (frame,) labels say that nothing touches
    rest : (frame,) load cells say so, at the instant of the signals
    mechanics : those of the object's specification, where it is known
    """

    table: RawTable
    time_s: Float[np.ndarray, "frame"]
    rate_hz: float
    force_n: Float[np.ndarray, "frame cell"]
    aligned_n: Float[np.ndarray, "frame cell"]
    shear_n: Float[np.ndarray, "frame cell 2"]
    press: Int[np.ndarray, "frame"]
    stretch: Int[np.ndarray, "frame"]
    block: Int[np.ndarray, "frame"]
    responses: Float[np.ndarray, "press face"]
    no_contact: Bool[np.ndarray, "frame"]
    rest: Bool[np.ndarray, "frame"]
    repeats: Repeats
    lag: LagReport
    noise_counts: Float[np.ndarray, "face sensor 3"]
    mechanics: TravelForces | None = None

    @property
    def face(self) -> Int[np.ndarray, "frame cell"]:
        """Return the face that each load cell presses."""
        return self.table.face

    @property
    def held(self) -> Bool[np.ndarray, "frame cell"]:
        """Return where a load cell shows a contact, at the instant that it reports it."""
        return self.force_n >= CONTACT_FORCE_N

    @property
    def touching(self) -> Bool[np.ndarray, "frame cell"]:
        """Return where a load cell shows a contact, at the instant of the signals."""
        return self.aligned_n >= CONTACT_FORCE_N

    @cached_property
    def changes(self) -> Float[np.ndarray, "press face sensor 3"]:
        """Return the change of every channel under force, counts."""
        return press_changes(self.table.counts, self.force_n, self.press)

    def none(self) -> Bool[np.ndarray, "frame"]:
        """Return a mask of no frame."""
        return np.zeros(len(self.press), bool)
