"""What mechanics hands on: forces and magnet motions of every press of the lattice.

Axis order: face (1…5), place (ix · ny + iy of the press lattice), step (depth), magnet, 6.
The six motions are displacement (mm) of the magnet's centre and its rotation vector (rad),
both in the object's frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.files import atomic_path
from design.layouts import PlaceGrid

SCHEMA_VERSION = 1


@dataclass(frozen=True)
class PressTable:
    """Presses of one indenter at every lattice place and depth; other faces untouched.

    `force_n` (face, place, step); `motion` (face, place, step, magnet, 6) in mm and rad;
    `contact_area_mm2` (face, place, step).
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "face place step"]
    contact_area_mm2: Float[np.ndarray, "face place step"]
    motion: Float[np.ndarray, "face place step magnet 6"]


def save_press_table(table: PressTable, path: Path | str) -> None:
    """Write the table as NetCDF with units."""
    import xarray as xr

    data = xr.Dataset(
        {
            "force_n": (("face", "place", "step"), table.force_n, {"units": "N"}),
            "contact_area_mm2": (
                ("face", "place", "step"),
                table.contact_area_mm2,
                {"units": "mm2"},
            ),
            "motion": (
                ("face", "place", "step", "magnet", "component"),
                table.motion,
                {"units": "mm, mm, mm, rad, rad, rad"},
            ),
            "lattice_x_mm": (("ix",), table.lattice.x_mm, {"units": "mm"}),
            "lattice_y_mm": (("iy",), table.lattice.y_mm, {"units": "mm"}),
        },
        coords={"face": table.faces, "depth_mm": (("step",), table.depth_mm, {"units": "mm"})},
        attrs={"schema_version": SCHEMA_VERSION},
    )
    with atomic_path(path) as temporary:
        data.to_netcdf(temporary, engine="h5netcdf")


def load_press_table(path: Path | str) -> PressTable:
    """Read a table written by `save_press_table`."""
    import xarray as xr

    with xr.open_dataset(path, engine="h5netcdf") as data:
        return PressTable(
            faces=data["face"].values,
            lattice=PlaceGrid(data["lattice_x_mm"].values, data["lattice_y_mm"].values),
            depth_mm=data["depth_mm"].values,
            force_n=data["force_n"].values,
            contact_area_mm2=data["contact_area_mm2"].values,
            motion=data["motion"].values,
        )
