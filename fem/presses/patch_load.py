"""Uniform pressure on disks: displacement of the surface and motions of all magnets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.mechanics import IndenterSpec
from design.spec.object import ObjectSpec
from fem.contact.indenter import moved, patch_cells
from fem.contact.refined import joint_compliance, refined_face, spread_cells
from fem.linear.response import ResponseOperator
from fem.presses.joint import Tip, spread_motion
from fem.presses.table import require_on_face, require_on_patch


@dataclass(frozen=True)
class PatchLoad:
    """Disks under one pressure: force (N) and mean displacement inwards (mm) of each, and motions.

    `motion` (magnet, 6) is in mm and rad, in the object's frame, as in `MagnetMotions`.
    """

    force_n: Float[np.ndarray, "patch"]
    sunk_mm: Float[np.ndarray, "patch"]
    motion: Float[np.ndarray, "magnet 6"]


def load_patches(
    spec: ObjectSpec,
    response: ResponseOperator,
    places: Sequence[Tip],
    radius_mm: float,
    pressure_mpa: float,
) -> PatchLoad:
    """Press uniformly on a disk at every place, all together. Linear: negative pressures pull.

    Raises
    ------
    InputError
        A radius that is not positive, a pressure that is zero or infinite, or a disk on no sensed
        face or over a face's border.
    """
    if not (radius_mm > 0 and np.isfinite([radius_mm, pressure_mpa]).all() and pressure_mpa):
        raise InputError(
            "a patch needs a positive radius in mm and a pressure in MPa; got "
            f"{radius_mm:g} and {pressure_mpa:g}. Example: --patch 4 0.02"
        )
    disk, cells = IndenterSpec(kind="flat", radius_mm=radius_mm), patch_cells(radius_mm)
    spec = spec.changed(indenter=disk)
    numbers = [surface.number for surface in response.surfaces]
    spreads = []
    for place in places:
        if place.face not in numbers:
            raise InputError(f"face {place.face} is not a sensed face. Press one of {numbers}")
        face = refined_face(response, numbers.index(place.face), spec)
        centre = face.frame.to_plane(np.array([place.x_mm, place.y_mm]))
        require_on_face(face, disk, centre[None])
        spread = spread_cells(face, moved(cells.patches, centre), centre)
        require_on_patch(cells, spread, np.inf)
        spreads.append(spread)
    pressure = np.full(len(spreads) * len(cells.height_mm), pressure_mpa)
    sunk = joint_compliance(response, spreads, spec) @ pressure
    area = float(cells.patches.area_mm2.sum())
    return PatchLoad(
        np.full(len(spreads), pressure_mpa * area),
        sunk.reshape(len(spreads), -1).sum(axis=1) / area,
        spread_motion(response, spreads, pressure),
    )
