"""What mechanics hands on: force and magnet motions of every press of the lattice.

Axis order: face (1…5), place (ix · ny + iy of the press lattice), step (depth), magnet, 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.files import atomic_path
from design.layout.positions import PlaceGrid

SCHEMA_VERSION = 1


@dataclass(frozen=True)
class PressForces:
    """Normal force (N, compressive positive) and contact area (mm²) at each depth (mm)."""

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
    is the part of it that is there without a press, on a core that slipped; None for none.
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    motion: Float[np.ndarray, "face place step magnet 6"]
    rest: Float[np.ndarray, "magnet 6"] | None = None


def save_presses(forces: PressForces, motions: MagnetMotions, path: Path | str) -> None:
    """Write both as one NetCDF file with units."""
    import xarray as xr

    per_press = ("face", "place", "step")
    data = xr.Dataset(
        {
            "force_n": (per_press, forces.force_n, {"units": "N"}),
            "contact_area_mm2": (per_press, forces.contact_area_mm2, {"units": "mm2"}),
            "motion": (
                (*per_press, "magnet", "component"),
                motions.motion,
                {"units": "mm mm mm rad rad rad"},
            ),
            "lattice_x_mm": (("ix",), forces.lattice.x_mm, {"units": "mm"}),
            "lattice_y_mm": (("iy",), forces.lattice.y_mm, {"units": "mm"}),
        },
        coords={"face": forces.faces, "depth_mm": (("step",), forces.depth_mm, {"units": "mm"})},
        attrs={"schema_version": SCHEMA_VERSION},
    )
    if motions.rest is not None:
        data["rest"] = (("magnet", "component"), motions.rest, {"units": "mm mm mm rad rad rad"})
    with atomic_path(path) as temporary:
        data.to_netcdf(temporary, engine="h5netcdf")


def load_presses(path: Path | str) -> tuple[PressForces, MagnetMotions]:
    """Read what `save_presses` wrote."""
    import xarray as xr

    with xr.open_dataset(path, engine="h5netcdf") as data:
        if data.attrs.get("schema_version") != SCHEMA_VERSION:
            raise InputError(f"{path} holds no presses of schema {SCHEMA_VERSION}. Simulate anew")
        lattice = PlaceGrid(data["lattice_x_mm"].values, data["lattice_y_mm"].values)
        shared = (data["face"].values, lattice, data["depth_mm"].values)
        forces = PressForces(*shared, data["force_n"].values, data["contact_area_mm2"].values)
        rest = data["rest"].values if "rest" in data else None
        return forces, MagnetMotions(*shared, data["motion"].values, rest)
