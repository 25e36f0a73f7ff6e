"""Field at every chip in presses of known travel, for an object that stands somewhere under a machine.

The machine's place and travel become the object's by a pose of four numbers: where the object's
centre is, how it is turned, and the height of the first contact. The machine's axes need not be
right-handed (many have x or z mirrored), so that a pose has one of eight symmetries of the square.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from jaxtyping import Bool, Float
from scipy.ndimage import map_coordinates, spline_filter

from design.errors import InputError
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.calibration.most_probable import Values
from estimator.field.models import MagnetsModel, magnets_model
from estimator.signals.field_setup import Scene, min_distance_mm, scene, sensed_field, zero_motion
from fem.presses.results import MagnetMotions

SYMMETRIES = tuple(
    np.array([[x, 0.0], [0.0, y]])[list(order)]
    for order in ((0, 1), (1, 0))
    for x, y in product((1.0, -1.0), repeat=2)
)
"""Axes of the machine in the object's, as rows: right-handed and mirrored ones."""
_MARGIN_MM = 0.2
_PLAY_MM = 3.0
"""Distance by which magnets may lie nearer to the chips than in the design."""


@dataclass(frozen=True)
class Pose:
    """Pose of the object under the machine; `symmetry` is one of `SYMMETRIES`."""

    shift_mm: Float[np.ndarray, "2"]
    turn_rad: float
    contact_mm: float
    symmetry: int

    def locate_tips(
        self, tip_mm: Float[np.ndarray, "press 3"]
    ) -> tuple[Float[np.ndarray, "press 2"], Float[np.ndarray, "press"]]:
        """Place in the face's frame and travel beyond the first contact, mm."""
        cosine, sine = np.cos(self.turn_rad), np.sin(self.turn_rad)
        turned = (tip_mm[:, :2] - self.shift_mm) @ np.array([[cosine, -sine], [sine, cosine]])
        return turned @ SYMMETRIES[self.symmetry], self.contact_mm - tip_mm[:, 2]

    def moved(self, values: Values) -> Pose:
        """Return the pose moved by `shift_mm`, `turn_rad` and `contact_mm`."""
        return replace(
            self,
            shift_mm=self.shift_mm + values["shift_mm"],
            turn_rad=self.turn_rad + float(values["turn_rad"]),
            contact_mm=self.contact_mm + float(values["contact_mm"]),
        )


@dataclass(frozen=True)
class Twin:
    """Registered or calibrated object: pose, and how far each magnet is off the design.

    `strength` multiplies the polarization of all magnets.
    """

    pose: Pose
    magnet_mm: Float[np.ndarray, "magnet 3"]
    tilt_rad: Float[np.ndarray, "magnet 2"]
    strength: float = 1.0

    def moved(self, values: Values) -> Twin:
        """With its pose moved, and its magnets where `magnet_mm`, `tilt_rad`, `ln_strength` are given."""
        twin = replace(self, pose=self.pose.moved(values))
        if "magnet_mm" not in values:
            return twin
        return replace(
            twin,
            magnet_mm=self.magnet_mm + values["magnet_mm"],
            tilt_rad=self.tilt_rad + values["tilt_rad"],
            strength=self.strength * float(np.exp(values["ln_strength"])),
        )


@dataclass(frozen=True)
class TravelModel:
    """Motions of the magnets over places and travels of one face, as cubic splines, and their field.

    `coefficients` (component, ix, iy, step) start at no travel.
    """

    scene: Scene
    field: MagnetsModel
    x_mm: Float[np.ndarray, "nx"]
    y_mm: Float[np.ndarray, "ny"]
    travel_mm: Float[np.ndarray, "step"]
    coefficients: Float[np.ndarray, "component nx ny step"]

    def design_twin(self, pose: Pose) -> Twin:
        """The object of the drawing."""
        count = len(self.scene.magnets.face)
        return Twin(pose, np.zeros((count, 3)), np.zeros((count, 2)))

    def covers(self, xy_mm: Float[np.ndarray, "place 2"]) -> Bool[np.ndarray, "place"]:
        """Return which places lie within the table by a margin for slopes."""
        low, high = (np.array([end(self.x_mm), end(self.y_mm)]) for end in (np.min, np.max))
        return np.all((xy_mm > low + _MARGIN_MM) & (xy_mm < high - _MARGIN_MM), axis=1)

    def motion(
        self, xy_mm: Float[np.ndarray, "press 2"], travel_mm: Float[np.ndarray, "press"]
    ) -> Float[np.ndarray, "press magnet 6"]:
        """Motions of the magnets; places and travels beyond the table count as its border."""
        nodes = (self.x_mm, self.y_mm, self.travel_mm)
        given = (*xy_mm.T, travel_mm)
        index = [
            np.interp(v, node, np.arange(len(node))) for v, node in zip(given, nodes, strict=True)
        ]
        components = [
            map_coordinates(c, index, order=3, prefilter=False) for c in self.coefficients
        ]
        return np.stack(components, axis=-1).reshape(len(travel_mm), -1, 6)

    def change(
        self, twin: Twin, motion: Float[np.ndarray, "press magnet 6"]
    ) -> Float[np.ndarray, "press sensor 3"]:
        """Change of the flux density (mT) along the chips' axes with the magnets moved."""
        placed = _placed(self.scene, twin)
        still = sensed_field(placed, zero_motion(placed), self.field)
        return self._along_chips(sensed_field(placed, motion, self.field) - still)

    def resting(self, twin: Twin) -> Float[np.ndarray, "sensor 3"]:
        """Flux density (mT) along the chips' axes without a press."""
        placed = _placed(self.scene, twin)
        return self._along_chips(sensed_field(placed, zero_motion(placed), self.field))[0]

    def pressed(
        self, twin: Twin, tip_mm: Float[np.ndarray, "press 3"]
    ) -> Float[np.ndarray, "press sensor 3"]:
        """Change (mT) in presses at the machine's places and heights."""
        return self.change(twin, self.motion(*twin.pose.locate_tips(tip_mm)))

    def _along_chips(self, field_t: np.ndarray) -> np.ndarray:
        # T → mT along each chip's axes: s sensor, j coordinate, i chip axis, n press
        return 1e3 * np.einsum("sij,nsj->nsi", self.scene.sensors.axes, field_t)


def require_comparable(spec: ObjectSpec) -> None:
    """Presses of known travel can be compared with simulated ones of this object.

    Raises
    ------
    InputError
        Several sensed faces, or a curved one.
    """
    frames = face_frames(spec)
    if len(frames) != 1:
        raise InputError(
            f"presses of known travel are compared on one sensed face; got {len(frames)}. Set "
            "body.sensed_faces"
        )
    if not frames[0].flat:
        raise InputError(
            "presses of known travel go straight down onto a flat face; face "
            f"{frames[0].number} of this {spec.body.kind} is curved, and simulated presses follow its "
            "normal. Give a recording with force labels instead"
        )


def travel_model(spec: ObjectSpec, motions: MagnetMotions) -> TravelModel:
    """The model of the presses of an object's one face.

    Raises
    ------
    InputError
        Of `require_comparable`.
    """
    require_comparable(spec)
    place, lattice = scene(spec), motions.lattice
    flat = motions.motion[0].reshape(*lattice.shape, len(motions.depth_mm), -1)
    whole = np.concatenate([np.zeros_like(flat[:, :, :1]), flat], axis=2)
    splines = [spline_filter(part, order=3) for part in np.moveaxis(whole, -1, 0)]
    nearest = min_distance_mm(place, motions.motion.reshape(-1, place.bodies, 6))
    model = magnets_model(spec.magnets, nearest - _PLAY_MM)
    travel = np.append(0.0, motions.depth_mm)
    return TravelModel(place, model, lattice.x_mm, lattice.y_mm, travel, np.stack(splines))


def _placed(designed: Scene, twin: Twin) -> Scene:
    magnets = designed.magnets
    tilt = np.column_stack([twin.tilt_rad, np.zeros(len(twin.tilt_rad))])
    axis = magnets.axis + np.cross(tilt, magnets.axis)
    axis = axis / np.linalg.norm(axis, axis=1, keepdims=True)
    moved_magnets = replace(
        magnets,
        centre_mm=magnets.centre_mm + twin.magnet_mm,
        axis=axis,
        strength=magnets.strength * twin.strength,
    )
    return replace(designed, magnets=moved_magnets)
