"""Tension between shell and frictionless core under presses: where the core would let go."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from fem.linear.response import ResponseOperator
from fem.presses.joint import Tip, press_path, press_tips
from fem.presses.table import press_places, surface_weights_mm2


@dataclass(frozen=True)
class CoreTension:
    """The largest tension per newton of press force (MPa/N), and the core's vertex it acts at.

    It is the mean over the wall's triangles around the vertex, weighted by its P1 hat: the pressure
    itself grows without bound at the core's edges as the mesh is refined. Positive where the shell
    would lift off, which the linear table leaves out. `press` (face number, x, y) is the press at
    which it is largest, and `force_drop` the share of that press's force that the table has too
    much, from the same press on a core that only pushes; None where not computed.
    """

    pressure_mpa_per_n: float
    point_mm: Float[np.ndarray, "3"]
    press: tuple[int, float, float] | None = None
    force_drop: float | None = None

    def to_dict(self) -> dict[str, float]:
        """Return the values that JSON and tables show."""
        x, y, z = (float(value) for value in self.point_mm)
        shown = {
            "largest_tension_kpa_per_n": 1e3 * self.pressure_mpa_per_n,
            "x_mm": x,
            "y_mm": y,
            "z_mm": z,
        }
        if self.press is not None and self.force_drop is not None:
            face, *place = self.press
            shown |= dict(zip(("press_x_mm", "press_y_mm"), place, strict=True))
            shown |= {"press_face": face, "force_drop_where_it_lifts_off": self.force_drop}
        return shown


def largest_core_tension(
    response: ResponseOperator, face_index: int, pressures_mpa: Float[np.ndarray, "press vertex"]
) -> tuple[CoreTension, int]:
    """Over presses of one face, given by the pressures at its vertices; and the press that has it.

    Presses without force are skipped.

    Raises
    ------
    ValueError
        The shell is bonded to its core, or no press has any force.
    """
    core = response.core
    if core is None:
        raise ValueError("tension at the core is known of a frictionless interface only")
    force = pressures_mpa @ surface_weights_mm2(response.surfaces[face_index])
    pressed = np.flatnonzero(force > 0)
    if len(pressed) == 0:
        raise ValueError("none of the presses touches the face")
    per_load = core.force_per_load[:, response.face_loads(face_index)]
    tension = -(per_load @ pressures_mpa[pressed].T) / core.weights_mm2[:, None] / force[pressed]
    vertex, press = np.unravel_index(int(np.argmax(tension)), tension.shape)
    return CoreTension(float(tension.max()), core.points_mm[vertex]), int(pressed[press])


def core_tension(spec: ObjectSpec, response: ResponseOperator) -> CoreTension:
    """The largest over all contact locations of all faces, each pressed to the deepest depth.

    The press that has it is repeated on a core that only pushes.

    Raises
    ------
    ValueError
        The shell is bonded to its core.
    """
    deepest = np.array(spec.press.depths_mm[-1:])
    tensions = []
    for index, (surface, has_place) in enumerate(
        zip(response.surfaces, contact_places(spec), strict=True)
    ):
        xy = contact_grid(spec).xy_mm[has_place]
        pressures = press_places(spec, response, index, xy, deepest)[:, 0]
        tension, press = largest_core_tension(response, index, pressures)
        x, y = xy[press].tolist()
        tensions.append(replace(tension, press=(surface.number, x, y)))
    worst = max(tensions, key=lambda tension: tension.pressure_mpa_per_n)
    return replace(worst, force_drop=_force_drop(spec, response, worst, deepest))


def _force_drop(
    spec: ObjectSpec, response: ResponseOperator, worst: CoreTension, depth_mm: np.ndarray
) -> float:
    assert worst.press is not None
    tips = [Tip(*worst.press)]
    (held,) = press_path(spec, response, tips, depth_mm[None])
    return 1 - float(press_tips(spec, response, tips, depth_mm).force_n[0] / held.force_n[0])
