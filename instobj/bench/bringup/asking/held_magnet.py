"""Counts of a magnet that a hand holds over the core, for poses known only roughly.

A pose is a vector of eight: where the centre is off the stated place (x, y, height in the face's
frame, mm), how far the magnet's axis is turned about the face's x and y (rad), and a uniform field
(counts, in the object's frame) by which the surroundings changed since the still reading.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.body import core_frames
from design.layout.places.positions import SensorLayout, sensor_layout
from design.layout.pockets import sensor_places
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel, field_model
from estimator.field.sources import magnet_sources
from estimator.field.vectors import components, rotate

OVER_MM = 10.0
"""Height above the core's surface at which a magnet is to be held."""
HAND_MM, HAND_RAD, TURNED_COUNTS_UT = 6.0, 0.5, 50.0
"""Errors of hands (standard deviations), and what turning the core in Earth's field changes."""
_LOWEST_MM = 0.5
"""Air between a held magnet and the core, at least: it cannot be inside."""
_UNKNOWNS = 8
"""Unknowns of a hold: shift (3, mm), tilt (2, rad), uniform field (3, counts)."""


@dataclass(frozen=True)
class HeldMagnet:
    """The core's chips as designed, stated places of the magnet with the faces' axes, its field.

    `polarity` is 1 where the magnet's north points into the core, as asked for, −1 where out of it.
    """

    sensors: SensorLayout
    stated_mm: Float[np.ndarray, "hold 3"]
    face_axes: Float[np.ndarray, "hold 3 3"]
    magnet: FieldModel
    counts_per_mt: float
    polarity: Float[np.ndarray, "hold"]

    def counts(
        self,
        pose: Float[np.ndarray, "hold 8"],
        seat_mm: Float[np.ndarray, "sensor 3"] | float = 0.0,
    ) -> Float[np.ndarray, "hold sensor 3"]:
        """Changes of counts along the chips' designed axes, chips moved by `seat_mm`."""
        centre, axis = self.centre_mm(pose), self.axis(pose)
        offset = (self.sensors.position_mm + seat_mm) - centre[:, None]
        field = self.magnet(components(offset), components(axis[:, None]))
        in_object = 1e3 * self.counts_per_mt * np.stack(field, axis=-1) + pose[:, None, 5:]
        # h hold, s site, c coordinate of the object, a designed chip axis
        return np.einsum("sac,hsc->hsa", self.sensors.axes, in_object)

    def distance_mm(self, pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold sensor"]:
        """From the magnet's centre to every chip."""
        return np.linalg.norm(self.sensors.position_mm - self.centre_mm(pose)[:, None], axis=-1)

    def centre_mm(self, pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold 3"]:
        """Return the centre of the magnet in the object's frame; never inside the core."""
        shift = pose[:, :3].copy()
        thick = self.magnet.magnet.height_mm / 2
        shift[:, 2] = np.maximum(shift[:, 2], _LOWEST_MM + thick - OVER_MM)
        # h hold, j axis of its face (columns), i object coordinate
        return self.stated_mm + np.einsum("hij,hj->hi", self.face_axes, shift)

    def axis(self, pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold 3"]:
        """Return the direction of the magnet's north pole."""
        turn = np.einsum("hij,hj->hi", self.face_axes[:, :, :2], pose[:, 3:5])
        return rotate(-self.polarity[:, None] * self.face_axes[:, :, 2], turn)

    @property
    def pose_sd(self) -> Float[np.ndarray, "8"]:
        """Return the standard deviations of a pose's prior."""
        uniform = 1e-3 * TURNED_COUNTS_UT * self.counts_per_mt
        return np.r_[[HAND_MM] * 3, [HAND_RAD] * 2, [uniform] * 3]

    def off_prior(self, pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold 8"]:
        """Pose over the standard deviations of its prior."""
        return pose / self.pose_sd


@cached_geometry
def hold_places(
    spec: ObjectSpec,
) -> tuple[Float[np.ndarray, "hold 3"], Float[np.ndarray, "hold 3 3"]]:
    """Return where the magnet's centre is to be, in the object's frame (mm), over every chip in the order of
    the sensors; and axes there as columns, the third pointing out of the core."""
    stated_mm, axes = [], []
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for x, y, _ in places:
            stated_mm.append(frame.to_object(np.array([x, y, OVER_MM])))
            axes.append(frame.axes_at(np.array([x, y])))
    return np.stack(stated_mm), np.stack(axes)


def held_magnet(spec: ObjectSpec, holds: list[int]) -> HeldMagnet:
    """The model for one of the object's own magnets over the chips of those numbers."""
    stated_mm, axes = hold_places(spec)
    source = magnet_sources(spec.magnets)[0]
    model = field_model(source, 1.7 * source.circumscribed_radius_mm)
    return HeldMagnet(
        sensor_layout(spec),
        stated_mm[holds],
        axes[holds],
        model,
        spec.sensors.counts_per_mt,
        np.ones(len(holds)),
    )


def stated_pose(holds: int) -> Float[np.ndarray, "hold 8"]:
    """Poses exactly as asked for."""
    return np.zeros((holds, _UNKNOWNS))
