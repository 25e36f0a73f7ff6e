"""Result of a press with large deformation, and its files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float

from design.netcdf import FileKind, write_netcdf
from fem.large_strain.hyperelastic import Hyperelastic
from fem.presses.shape import DeformedShape

_MOTION = ("step magnet component", "mm mm mm rad rad rad")
_PRESS = FileKind(
    "large-deformation presses",
    {
        "force_n": ("step", "N"),
        "linear_force_n": ("step", "N"),
        "contact_area_mm2": ("step", "mm2"),
        "linear_contact_area_mm2": ("step", "mm2"),
        "motion": _MOTION,
        "linear_motion": _MOTION,
    },
    coordinates={"depth_mm": ("step", "mm")},
)


@dataclass(frozen=True)
class LargeStrainPress:
    """One press at increasing depths: large deformation, and small strain on the same mesh.

    Areas are of the undeformed face. `motion` is the displacement of each magnet's centre (mm) and
    its rotation vector (rad) in the object's frame. `status` is "converged", or "diverged" where
    a deeper press was asked for; then the last depth is the last converged one. `shape` and
    `linear_shape` are those of the last depth.
    """

    face: int
    x_mm: float
    y_mm: float
    material: Hyperelastic
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "step"]
    linear_force_n: Float[np.ndarray, "step"]
    contact_area_mm2: Float[np.ndarray, "step"]
    linear_contact_area_mm2: Float[np.ndarray, "step"]
    motion: Float[np.ndarray, "step magnet 6"]
    linear_motion: Float[np.ndarray, "step magnet 6"]
    status: str
    shape: DeformedShape
    linear_shape: DeformedShape

    @property
    def converged_depth_mm(self) -> float:
        """The deepest equilibrium found."""
        return float(self.depth_mm[-1])


@dataclass(frozen=True)
class LinearityLimits:
    """Depths (mm) at which linear and nonlinear force differ by 5 % and 20 %; None: not reached."""

    five_percent_mm: float | None
    twenty_percent_mm: float | None


def linearity_limits(press: LargeStrainPress) -> LinearityLimits:
    """Depths at which the linear force is first 5 % and 20 % off the nonlinear one.

    Shares are of the nonlinear force; depths are interpolated, from agreement at depth 0.
    """
    touched = (press.force_n > 0) & (press.linear_force_n > 0)
    depth = np.append(0, press.depth_mm[touched])
    off = np.append(0, abs(1 - press.linear_force_n[touched] / press.force_n[touched]))
    return LinearityLimits(first_crossing(depth, off, 0.05), first_crossing(depth, off, 0.20))


def save_large_strain_press(press: LargeStrainPress, path: Path | str) -> None:
    """Write forces, areas and motions of both models as NetCDF with units (not the shape)."""
    material = press.material
    attributes = {
        "face": press.face,
        "xy_mm": [press.x_mm, press.y_mm],
        "status": press.status,
        "material": material.name,
        "invariant_coefficients_mpa": list(material.invariant_coefficients_mpa),
        "ogden_moduli_mpa": [mu for mu, _ in material.ogden_terms],
        "ogden_exponents": [alpha for _, alpha in material.ogden_terms],
    }
    write_netcdf(_PRESS, path, {name: getattr(press, name) for name in _PRESS.arrays}, attributes)


def first_crossing(depth: np.ndarray, off: np.ndarray, share: float) -> float | None:
    above = np.flatnonzero(off >= share)
    if not len(above):
        return None
    last = above[0]
    part = (share - off[last - 1]) / (off[last] - off[last - 1])
    return float(depth[last - 1] + part * (depth[last] - depth[last - 1]))
