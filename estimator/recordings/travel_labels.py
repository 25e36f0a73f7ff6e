"""Recordings by their object's specification: forces at a machine's travel, answers to a press.

At a given travel the force is proportional to the silicone's modulus, so the ends of the modulus'
interval bound every force (linear elasticity; docs/recordings.md).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError, RecordingError
from estimator.frames.dataset import NO_FACE
from estimator.recordings.table import RawTable
from estimator.signals.interpolation import (
    among_pressed,
    counts_at_force,
    force_at_depth,
    press_traces,
)
from estimator.signals.presses import Signals
from fem.presses.results import PressForces

_MACHINE_MM = 0.02
"""Travel that is the deepest press still: a machine is sent two digits and reports the step it stands on."""


@dataclass(frozen=True)
class TravelForces:
    """Mechanics of a recorded object, made or read where a travel is asked for.

    `spread` holds the ends of the modulus' interval over the modulus; NaN where they are not known.
    `signals` are of the same presses, asked for where a label of a face is doubted; None where no model
    may judge it.
    """

    presses: Callable[[], PressForces]
    spread: Float[np.ndarray, "2"]
    signals: Callable[[], Signals] | None = None

    def press_forces(
        self,
        face: Int[np.ndarray, "frame"],
        xy_mm: Float[np.ndarray, "frame 2"],
        travel_mm: Float[np.ndarray, "frame"],
    ) -> Float[np.ndarray, "frame"]:
        """Return the force (N) of each press, at the specification's modulus.

        Raises
        ------
        RecordingError
            A travel beyond the deepest simulated press.
        InputError
            A place that the object's presses do not reach.
        """
        forces = self.presses()
        deepest = float(forces.depth_mm[-1])
        if travel_mm.max(initial=0.0) > deepest + _MACHINE_MM:
            raise RecordingError(
                f"travels reach {travel_mm.max():.3g} mm; the specification's presses go {deepest:g} mm "
                "deep. Add that depth to press.depths_mm, or give travel from the height of first touch"
            )
        bare = np.zeros((*forces.force_n.shape, 0, 3))
        signals = Signals(
            forces.faces, forces.lattice, forces.depth_mm, forces.force_n, bare, np.zeros((0, 3))
        )
        traces = press_traces(signals, face, *xy_mm.T)
        return force_at_depth(traces, np.minimum(travel_mm, deepest))

    def signal_changes(
        self,
        face: Int[np.ndarray, "press"],
        xy_mm: Float[np.ndarray, "press 2"],
        force_n: Float[np.ndarray, "press"],
    ) -> Float[np.ndarray, "press face sensor 3"] | None:
        """Return the change (counts) of faces 1 to the last sensed one in each press, beyond the deepest
        simulated one as in it.

        NaN on faces without sensors; None without a model, or where its presses do not reach a place.
        """
        if self.signals is None:
            return None
        signals = self.signals()
        try:
            traces = press_traces(signals, face, *xy_mm.T)
        except InputError:
            return None
        change = counts_at_force(traces, force_n[:, None], beyond="clamp").counts[:, 0]
        sensors = len(signals.baseline_counts) // len(signals.faces)
        by_face = np.full((len(face), signals.faces.max(), sensors, 3), np.nan)
        by_face[:, signals.faces - 1] = change.reshape(len(face), -1, sensors, 3)
        return by_face

    def places_mm(self, face: int) -> Float[np.ndarray, "place 2"]:
        """Return the places of a face whose presses `signal_changes` knows; none without a model."""
        if self.signals is None or face not in self.signals().faces:
            return np.empty((0, 2))
        signals = self.signals()
        pressed, xy_mm = signals.pressed[signals.faces == face][0], signals.lattice.xy_mm
        return xy_mm[among_pressed(signals.lattice, pressed, *xy_mm.T)]


def force_text(factors: Float[np.ndarray, "2"]) -> str:
    """Return how far forces of travel are known, in words."""
    if np.isnan(factors).any():
        return "by travel: N at the specification's modulus, of unknown interval"
    low, high = factors
    return f"by travel: N at the specification's modulus, truly {low:.2f} to {high:.2f} times"


def with_forces(table: RawTable, mechanics: TravelForces | None) -> RawTable:
    """Return a table labelled by travel with the forces that mechanics give; 0 above the first touch.

    Raises
    ------
    RecordingError
        No mechanics, several tips, a pressed face without its travel, or as `press_forces`.
    """
    if mechanics is None:
        raise RecordingError(
            "its label is a machine's travel and no force. Give --spec FILE: the object's mechanics tell "
            "the force at a travel"
        )
    if table.travel_mm is None or table.tip_xy_mm.shape[1:3] != (1, 1):
        raise RecordingError(
            "travel labels presses of one tip. Give cell1_face, cell1_x1_mm, cell1_y1_mm"
        )
    face, travel = table.face[:, 0], table.travel_mm
    unknown = np.flatnonzero((face != NO_FACE) & np.isnan(travel))
    if len(unknown):
        raise RecordingError(
            f"data row {unknown[0] + 1}: face {face[unknown[0]]} is pressed and its travel is missing. Give "
            "travel_mm there (0: not touched yet), or leave face and place empty"
        )
    pressed = np.flatnonzero((face != NO_FACE) & (np.nan_to_num(travel) > 0))
    force = np.zeros(len(face))
    force[pressed] = mechanics.press_forces(
        face[pressed], table.tip_xy_mm[pressed, 0, 0], travel[pressed]
    )
    return replace(table, force_n=force[:, None])
