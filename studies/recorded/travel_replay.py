"""Recorded presses of known travel, replayed through the simulated object beside the finite elements.

Each recorded press becomes a contact: its place by the fit, and the force that a press of its travel
has there. The simulated object turns these into counts; the finite elements give the same presses' field
from motions of the magnets, at the same places and travels.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from jaxtyping import Float
from scipy.interpolate import RegularGridInterpolator

from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from estimator.adoption.fit import ObjectFit, Pressed
from estimator.calibration.known_travel.agreement import TravelFigures, figures
from estimator.calibration.known_travel.fit import Fitted
from estimator.calibration.known_travel.model import TravelModel
from estimator.inversion.inversion import inversion
from estimator.inversion.storage import save_inversion
from estimator.recordings.formats.travel import TravelRecording
from estimator.signals.field_setup import scene
from estimator.signals.presses import press_signals
from fem.presses.results import MagnetMotions, PressForces
from instobj.sim import HallObject

EXCHANGES = 99
"""Draws of the null: places exchanged between presses, each keeping its travel."""

Changes = Float[np.ndarray, "press sensor 3"]


@dataclass(frozen=True)
class Replay:
    """Figures of recorded presses by both, of the two beside each other, and the null's cosines."""

    simulated: TravelFigures
    finite_elements: TravelFigures
    between: TravelFigures
    null_median: float
    null_best: float


class SimulatedPresses:
    """Presses of known travel of an object's one face, felt by the simulated object."""

    def __init__(self, spec: ObjectSpec, forces: PressForces, motions: MagnetMotions) -> None:
        model = inversion(spec, forces, motions, press_signals(spec, forces, motions), 0.0, 0.0)
        with TemporaryDirectory() as folder:
            save_inversion(model, Path(folder) / "contacts.nc")
            self.object = HallObject(Path(folder) / "contacts.nc", seed=None)
        self._frame = face_frame(spec, int(forces.faces[0]))
        lattice = forces.lattice
        by_place = forces.force_n[0].reshape(*lattice.shape, -1)
        from_zero = np.concatenate([np.zeros_like(by_place[..., :1]), by_place], axis=-1)
        self._axes = lattice.x_mm, lattice.y_mm, np.append(0.0, forces.depth_mm)
        self._force_n = RegularGridInterpolator(self._axes, from_zero, method="cubic")
        # counts → mT along each chip's axes: inverse of the chips' matrices (s sensor)
        self._per_count = np.linalg.inv(scene(spec).chips.matrix) / spec.sensors.counts_per_mt

    def change_mt(
        self, xy_mm: Float[np.ndarray, "press 2"], travel_mm: Float[np.ndarray, "press"]
    ) -> Changes:
        """Return the changes at places of the face and travels beyond contact, mT."""
        given = np.column_stack([xy_mm, travel_mm])
        low, high = np.array([(axis[0], axis[-1]) for axis in self._axes]).T
        inside = np.clip(given, low, high)
        points = self._frame.to_object(np.pad(inside[:, :2], ((0, 0), (0, 1))))
        # every press is an object of its own with one contact
        force = np.maximum(self._force_n(inside), 0.0)
        counts = self.object.read(points[:, None], force[:, None]) - self.object.rest_counts
        return np.einsum("sij,nsj->nsi", self._per_count, counts)


def replay_recording(
    model: TravelModel,
    simulated: SimulatedPresses,
    fitted: Fitted,
    judged: TravelRecording,
    seed: int,
) -> Replay:
    """Replay a recording at the pose of a fit that left the design as it is."""
    xy, travel = fitted.twin.pose.locate_tips(judged.tip_mm)
    finite_elements = model.change(fitted.twin, model.motion(xy, travel))
    recorded = judged.field_mt - fitted.resting_mt
    return replay(simulated, xy, travel, finite_elements, recorded, seed)


def replay_log(simulated: SimulatedPresses, fit: ObjectFit, judged: Pressed, seed: int) -> Replay:
    """Replay an adopted log at a fit's places, with the fit's strength of the magnets.

    The finite elements have the fit's shift of the magnets too, which the simulated design has not.
    """
    xy, travel = fit.shell_presses(judged)
    return replay(simulated, xy, travel, fit.predicted(judged)[0], fit.recorded(judged), seed)


def replay(
    simulated: SimulatedPresses,
    xy_mm: Float[np.ndarray, "press 2"],
    travel_mm: Float[np.ndarray, "press"],
    finite_elements: Changes,
    recorded: Changes,
    seed: int,
) -> Replay:
    """Return figures of both predictions, and of the null of exchanged places."""
    change = simulated.change_mt(xy_mm, travel_mm)
    rng = np.random.default_rng((seed, 14))
    null = [
        figures(simulated.change_mt(rng.permutation(xy_mm), travel_mm), recorded).cosine
        for _ in range(EXCHANGES)
    ]
    return Replay(
        figures(change, recorded),
        figures(finite_elements, recorded),
        figures(change, finite_elements),
        float(np.median(null)),
        float(np.max(null)),
    )


def replay_row(name: str, found: Replay) -> dict[str, object]:
    """Return one line of the table."""
    return {
        "object": name,
        "presses": found.simulated.presses,
        "cosine, simulated object": round(found.simulated.cosine, 3),
        "finite elements": round(found.finite_elements.cosine, 3),
        "null, median; best": f"{found.null_median:.2f}; {found.null_best:.2f}",
        "explained, simulated object": round(found.simulated.explained, 3),
        "explained, finite elements": round(found.finite_elements.explained, 3),
        "cosine between both": round(found.between.cosine, 4),
    }
