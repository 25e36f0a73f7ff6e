"""Magnets and the pockets that take them, in a face's own frame: any place, depth and tilt.

A pocket is a cylinder along its magnet's axis, from under the magnet out through the face; both
turn about the magnet's centre. Heights are above the face, so that everything here is below 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

if TYPE_CHECKING:
    from design.spec_hardware import MagnetSpec, ShellSpec


@dataclass(frozen=True)
class Pocket:
    """One magnet at rest and its pocket: centre (mm) and unit axis outward, in the face's frame.

    The pocket's floor touches the magnet's lower side, `floor_mm` from the centre along the axis.
    """

    centre_mm: Float[np.ndarray, "3"]
    axis: Float[np.ndarray, "3"]
    radius_mm: float
    floor_mm: float

    @property
    def mouth_mm(self) -> float:
        """Distance along the axis from the centre to the face's plane."""
        return float(-self.centre_mm[2] / self.axis[2])

    @property
    def volume_mm3(self) -> float:
        """Of the silicone left out: the face cuts the cylinder obliquely, but at its mean length."""
        return float(np.pi * self.radius_mm**2 * (self.floor_mm + self.mouth_mm))

    @property
    def axis_ends_mm(self) -> Float[np.ndarray, "2 3"]:
        """On the axis: the floor's centre, and the height that the mouth's highest point has."""
        slope = float(np.hypot(*self.axis[:2]) / self.axis[2])
        ends = np.array([-self.floor_mm, self.mouth_mm + slope * self.radius_mm])
        return self.centre_mm + ends[:, None] * self.axis

    @property
    def lowest_mm(self) -> float:
        """Height of the pocket's lowest point, negative."""
        floor = self.axis_ends_mm[0, 2]
        return float(floor - self.radius_mm * np.hypot(*self.axis[:2]))

    @property
    def reach_mm(self) -> Float[np.ndarray, "2"]:
        """Largest |x| and |y| within the pocket and its mouth."""
        lean = self.axis[:2]
        floor = abs(self.axis_ends_mm[0, :2]) + self.radius_mm * np.sqrt(1 - lean**2)
        middle = self.centre_mm[:2] + self.mouth_mm * lean
        # the mouth is an ellipse, 1/cos of the tilt longer along the lean
        mouth = abs(middle) + self.radius_mm * np.sqrt(1 + (lean / self.axis[2]) ** 2)
        return np.maximum(floor, mouth)


def pockets(shell: ShellSpec, magnets: MagnetSpec) -> tuple[Pocket, ...]:
    """The pockets of one face, in the order of `magnets.positions_mm`."""
    floor = magnets.height_mm / 2
    depths = magnets.depths_mm or (shell.pocket_depth_mm - floor,) * len(magnets.positions_mm)
    tilts = magnets.tilt_deg or ((0.0, 0.0),) * len(magnets.positions_mm)
    return tuple(
        Pocket(np.array([x, y, -depth]), tilted_axis(*tilt), shell.pocket_diameter_mm / 2, floor)
        for (x, y), depth, tilt in zip(magnets.positions_mm, depths, tilts, strict=True)
    )


def tilted_axis(about_x_deg: float, about_y_deg: float) -> Float[np.ndarray, "3"]:
    """The outward normal turned by the rotation vector (about x, about y, 0)."""
    turn = np.deg2rad([about_x_deg, about_y_deg])
    angle = float(np.hypot(*turn))
    side = np.sinc(angle / np.pi) * turn
    return np.array([side[1], -side[0], np.cos(angle)])


def distance_of_axes_mm(a: Pocket, b: Pocket) -> float:
    """Smallest distance between the axes of two pockets, each from its floor to above its mouth.

    Pockets that are further apart than their radii together cannot touch; for pockets without
    tilt the reverse holds too.
    """
    (p, p_end), (q, q_end) = a.axis_ends_mm, b.axis_ends_mm
    along, other, between = p_end - p, q_end - q, p - q
    aa, bb, ab = along @ along, other @ other, along @ other
    pa, pb = along @ between, other @ between
    determinant = aa * bb - ab**2
    s = 0.0 if determinant < 1e-12 * aa * bb else np.clip((ab * pb - bb * pa) / determinant, 0, 1)
    t = np.clip((ab * s + pb) / bb, 0, 1)
    s = np.clip((ab * t - pa) / aa, 0, 1)
    return float(np.linalg.norm(between + s * along - t * other))
