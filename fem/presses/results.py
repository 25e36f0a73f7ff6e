"""Result of mechanics: force and magnet motions of every press of the lattice.

Axis order: face (1…5), place (ix · ny + iy of the press lattice), step (depth), magnet, 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import StoreError
from design.layout.places.contact_grid import PlaceGrid
from design.netcdf import FileKind, read_netcdf, write_netcdf

_PER_PRESS = "face place step"
_MOTION = "mm mm mm rad rad rad"
PRESSES_KIND = FileKind(
    "presses",
    {
        "force_n": (_PER_PRESS, "N"),
        "contact_area_mm2": (_PER_PRESS, "mm2"),
        "motion": (f"{_PER_PRESS} magnet component", _MOTION),
        "lattice_x_mm": ("ix", "mm"),
        "lattice_y_mm": ("iy", "mm"),
        "rest": ("magnet component", _MOTION),
    },
    coordinates={"face": ("face", ""), "depth_mm": ("step", "mm")},
    optional=("motion", "rest"),
)


@dataclass(frozen=True)
class PressForces:
    """Normal force (N, compressive positive) and contact area (mm²) at each depth (mm).

    NaN at places that a face has not.
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "face place step"]
    contact_area_mm2: Float[np.ndarray, "face place step"]


@dataclass(frozen=True)
class MagnetMotions:
    """Rigid motion of every magnet (all faces) in every press of `PressForces`.

    In the reverse arrangement the sensor boards stand in the magnets' place.

    `motion` (face, place, step, magnet, 6): displacement of the magnet's centre (mm), then its
    rotation vector (rad), in the object's frame, from where the layout puts it. `rest` (magnet, 6)
    is the part of it that is there without a press, on a core that slipped; None for none. `motion`
    is NaN at places that a face has not.
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    motion: Float[np.ndarray, "face place step magnet 6"]
    rest: Float[np.ndarray, "magnet 6"] | None = None

    @property
    def pressed(self) -> Bool[np.ndarray, "face place"]:
        """Return which places of the lattice each face has."""
        return np.asarray(~np.isnan(self.motion).all(axis=(2, 3, 4)))

    @property
    def all_motions(self) -> Float[np.ndarray, "press magnet 6"]:
        """The motions in all presses that were made."""
        pressed = self.pressed
        motion = self.motion if pressed.all() else self.motion[pressed]
        return motion.reshape(-1, *motion.shape[-2:])


@dataclass(frozen=True)
class ShearMotions:
    """Motion of every magnet per newton of tangential force at every contact location and depth.

    `motion_per_n` (face, place, step, tangent, magnet, 6): mm and rad per N along the face's x and
    y, in the object's frame; zero where the press found no contact, NaN at places that a face has
    not.
    """

    faces: Int[np.ndarray, "face"]
    grid: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    motion_per_n: Float[np.ndarray, "face place step 2 magnet 6"]


def save_presses(forces: PressForces, motions: MagnetMotions | None, path: Path | str) -> None:
    """Write both as one NetCDF file with units; without magnets, the forces alone."""
    values = {
        "force_n": forces.force_n,
        "contact_area_mm2": forces.contact_area_mm2,
        "motion": None if motions is None else motions.motion,
        "lattice_x_mm": forces.lattice.x_mm,
        "lattice_y_mm": forces.lattice.y_mm,
        "rest": None if motions is None else motions.rest,
        "face": forces.faces,
        "depth_mm": forces.depth_mm,
    }
    write_netcdf(PRESSES_KIND, path, values)


def load_presses(path: Path | str) -> tuple[PressForces, MagnetMotions]:
    """Read what `save_presses` wrote.

    Raises
    ------
    InputError
        No such file.
    StoreError
        Damaged, without motions, or of another schema.
    """
    forces, motions = _read(path)
    if motions is None:
        raise StoreError(
            f"{path} holds presses without magnets. Simulate the presses of the object"
        )
    return forces, motions


def load_forces(path: Path | str) -> PressForces:
    """Read the forces of what `save_presses` wrote. Raises as `load_presses`, motions or not."""
    return _read(path)[0]


def _read(path: Path | str) -> tuple[PressForces, MagnetMotions | None]:
    values, _ = read_netcdf(PRESSES_KIND, path)
    lattice = PlaceGrid(values["lattice_x_mm"], values["lattice_y_mm"])
    shared = (values["face"], lattice, values["depth_mm"])
    forces = PressForces(*shared, values["force_n"], values["contact_area_mm2"])
    if "motion" not in values:
        return forces, None
    return forces, MagnetMotions(*shared, values["motion"], values.get("rest"))
