"""Compliance map: indentation depth per newton at every contact location of every face.

The secant compliance at a depth d is d / F(d), in mm/N: contact grows with depth, so a press twice
as deep needs more than twice the force.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from design.tables import write_table
from fem.linear.response import ResponseOperator
from fem.presses.results import PressForces
from fem.presses.table import Progress, simulate_lattice

DEPTH_MM = 1.0
"""Compliances are taken at the simulated depth nearest to this one."""


@dataclass(frozen=True)
class ComplianceMap:
    """Secant compliance (face, place) in mm/N at `depth_mm`, over the lattice of presses.

    Infinite where the press found no contact, NaN at places that a face has not.
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: float
    mm_per_n: Float[np.ndarray, "face place"]


def compliance_map(forces: PressForces) -> ComplianceMap:
    """From simulated presses, at the depth nearest to 1 mm."""
    step = int(np.argmin(abs(forces.depth_mm - DEPTH_MM)))
    depth, force = float(forces.depth_mm[step]), forces.force_n[:, :, step]
    with np.errstate(divide="ignore"):
        return ComplianceMap(forces.faces, forces.lattice, depth, depth / force)


def presses_without_magnets(
    spec: ObjectSpec, response: ResponseOperator, progress: Progress | None = None
) -> PressForces:
    """The presses that a compliance map needs, answered by the response of a magnet-free mesh.

    Raises
    ------
    InputError
        As `simulate_lattice`.
    """
    depth = min(spec.press.depths_mm, key=lambda depth: abs(depth - DEPTH_MM))
    return simulate_lattice(spec, response, progress, depths_mm=(depth,))[0]


def save_compliance_csv(
    with_magnets: ComplianceMap, without_magnets: ComplianceMap, path: Path | str
) -> None:
    """One row per place that a face has: face, x and y in its frame (mm), and both compliances in mm/N."""
    rows = [
        (int(face), f"{x:g}", f"{y:g}", f"{tied:.6g}", f"{free:.6g}")
        for face, tied_row, free_row in zip(
            with_magnets.faces, with_magnets.mm_per_n, without_magnets.mm_per_n, strict=True
        )
        for (x, y), tied, free in zip(with_magnets.lattice.xy_mm, tied_row, free_row, strict=True)
        if not np.isnan(tied)
    ]
    depth = f"{with_magnets.depth_mm:g}_mm_deep"
    header = ("face", "x_mm", "y_mm", f"mm_per_n_{depth}", f"mm_per_n_without_magnets_{depth}")
    write_table(path, header, rows)
