"""Skin of silicone under a contact: depth, area, pressure and work, by the presses that were solved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from estimator.grasps.damage import Sphere, indentation_mm, patch_radius_mm
from estimator.grasps.track import Placed
from estimator.inversion.model.table import PressTable

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(6)
"""Gauss' rule on −1 to 1: exact within 0.1 % for depths that grow as the force to the power 2/3."""


@dataclass(frozen=True)
class Skin:
    """Silicone of an object under round tips.

    A table comes from finite elements: layer on its core, magnets and edges, small strain, no friction,
    one tip of the specification's indenter. Areas are whole cells of a face, so that pressures are
    right within about 10 % from 1 mm of depth on.

    Without a table it is Hertz' half-space. Against tables of two cubes, with shells of 6 and 8 mm, at five
    and eight places, 1 to 3 mm deep, its depth at a force is 0.8 to 2.4 times theirs, its pressure 0.5 to 1.0
    times and its work 0.8 to 2.5 times: most over magnets, where the layer is thin, least near edges.

    Attributes
    ----------
    faces : of the object, by number
    hertz : pair of silicone and tip
    table : of depth and contact area (`skin_table`); None for Hertz
    """

    faces: Mapping[int, FaceFrame]
    hertz: Sphere
    table: PressTable | None = None

    def depth_mm(self, contacts: Placed) -> Float[np.ndarray, "contact"]:
        """Depth of each tip."""
        return self._depth_and_area(contacts, contacts.force_n[:, 2:])[..., 0][:, 0]

    def patch_radius_mm(self, contacts: Placed) -> Float[np.ndarray, "contact"]:
        """Radius of a disc of each contact's area."""
        area = self._depth_and_area(contacts, contacts.force_n[:, 2:])[..., 1][:, 0]
        return np.sqrt(area / np.pi)

    def pressure_mpa(self, contacts: Placed) -> Float[np.ndarray, "contact"]:
        """Mean pressure of each contact on the silicone."""
        force, area = contacts.force_n[:, 2], np.pi * self.patch_radius_mm(contacts) ** 2
        return np.divide(force, area, out=np.zeros(len(force)), where=area > 0)

    def energy_mj(self, contacts: Placed) -> Float[np.ndarray, "contact"]:
        """Work of loading, ∫F dδ = F δ − ∫δ dF, N mm = mJ."""
        force = contacts.force_n[:, 2:]
        on_the_way = self._depth_and_area(contacts, force * (1 + _NODES) / 2)[..., 0]
        return force[:, 0] * (self.depth_mm(contacts) - on_the_way @ _WEIGHTS / 2)

    def _depth_and_area(
        self, contacts: Placed, force_n: Float[np.ndarray, "contact k"]
    ) -> Float[np.ndarray, "contact k 2"]:
        """Depth (mm) and contact area (mm²) at forces of each contact."""
        table = self.table
        if table is None:
            area = np.pi * patch_radius_mm(force_n, self.hertz) ** 2
            return np.stack([indentation_mm(force_n, self.hertz), area], axis=-1)
        rows = [np.flatnonzero(table.faces == face)[0] for face in contacts.face.tolist()]
        xy = [
            chart.from_plane(chart.plane_coordinates(point)[:2])
            for chart, point in zip(
                (self.faces[face] for face in contacts.face.tolist()),
                contacts.point_mm,
                strict=True,
            )
        ]
        count = force_n.shape[1]
        places = np.repeat(np.reshape(xy, (-1, 2)), count, axis=0)
        contact = np.column_stack([places, force_n.ravel()])
        grown = table.expected(np.repeat(rows, count).astype(int), contact)[:, :2]
        return np.asarray(grown, float).clip(0.0).reshape(*force_n.shape, 2) ** (2 / 3)
