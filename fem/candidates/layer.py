"""Motion of an incompressible layer that is bonded to a rigid base and pressed by a ball, without a mesh.

A flat shell on its core far from borders. Per wavenumber k the displacement down, W(z) J₀(kr), has
(d²/dz² − k²)² W = 0, and that along the surface, U(z) J₁(kr), follows from the kept volume, U = −W′/k.
Without shear on the surface W″ + k² W = 0 there, the pressure p̂ is G (W‴/k² − 3 W′), and at the base
W = W′ = 0 (Dimitriadis et al., Biophys. J. 82 (2002) 2798). Pressures are taken as Hertz's, with the radius
at which the surface bends by as much as the ball between the middle and the border of the contact.
What is left out: borders, curvature, the magnets' own stiffness, a Poisson's ratio below ½, slip. The force
of a ball of 5 mm radius on 8 or 16 mm is too large by 2 % at 0.5 mm, 4 % at 1 mm and 10 % at 2 mm, on
4 mm by 23 % at 2 mm.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from jaxtyping import Float
from scipy.interpolate import CubicSpline
from scipy.special import j0, j1

DISK_TURNS = 0.64
"""Share of strain that turns a flat disk (`RigidBody.jeffery_parameter` of 6 × 1 mm in a shell of 8 mm)."""
_WAVES, _SHORTEST = 1201, 40.0
"""Wavenumbers, and the largest one times the radius of the contact: what is cut off is 1 % of a depth."""
_REACH = 5.0
"""Thicknesses of the layer beyond which nothing moves: there displacements are below 1e-3 of the largest."""
_RADII = 160
"""Distances at which displacements are tabled."""
_LEAST_CONTACT, _LARGEST_CONTACT, _CONTACTS = 0.02, 0.98, 40
"""Contact radii over the ball's, between which a force is looked for."""
_FORCE_STEP = 0.05
"""Share of a force by which it is changed for derivatives."""
_STEP_MM = 0.05
"""Length by which places are moved for derivatives: short against the silicone over a magnet, 1 mm."""


@dataclass(frozen=True)
class Layer:
    """A layer `thickness_mm` thick of Young's modulus `young_mpa`, pressed by a ball of `radius_mm`."""

    thickness_mm: float
    young_mpa: float
    radius_mm: float

    def modes(
        self, wave_per_mm: Float[np.ndarray, "wave"], depth_mm: Float[np.ndarray, "depth"]
    ) -> tuple[Float[np.ndarray, "wave depth"], Float[np.ndarray, "wave depth"]]:
        """Displacement down and along the surface (mm) for each wave of pressure of 1 MPa."""
        k, h = wave_per_mm[:, None], self.thickness_mm
        down, up = np.exp(-k * depth_mm), np.exp(-k * (h - depth_mm))
        far = np.exp(-wave_per_mm * h)
        ones, zero, kh = np.ones_like(far), np.zeros_like(far), wave_per_mm * h
        # W = (a + b kz) e^(−kz) + (c + d k(h − z)) e^(−k(h − z)): rows are the four conditions, over k:
        # no shear and the pressure at z = 0, then W = 0 and W′ = 0 at z = h.
        rows = np.array(
            [
                [2 * ones, -2 * ones, 2 * far, (2 * kh - 2) * far],
                [2 * ones, zero, -2 * far, -2 * kh * far],
                [far, kh * far, ones, zero],
                [-far, (1 - kh) * far, ones, -ones],
            ]
        ).transpose(2, 0, 1)
        shear = self.young_mpa / 3  # G = E / (2 (1 + ν)) with ν = ½
        loads = np.stack([zero, 1 / (shear * wave_per_mm), zero, zero], axis=1)
        a, b, c, d = np.linalg.solve(rows, loads[..., None])[:, :, 0].T[..., None]
        kz, kup = k * depth_mm, k * (h - depth_mm)
        deep = (a + b * kz) * down + (c + d * kup) * up
        slope = (b - a - b * kz) * down + (c + d * kup - d) * up  # W′ / k
        return deep, -slope

    def contact(self, force_n: float) -> tuple[float, float]:
        """Radius of the contact and depth of the press (mm) at a force.

        A force beyond the largest contact goes on with that radius, straight.
        """
        radii, forces, depths = _contacts(self)
        radius = float(np.interp(force_n, forces, radii))
        most = max(1.0, force_n / forces[-1])
        return radius, most * float(np.interp(force_n, forces, depths))

    def force_at(self, depth_mm: float) -> float:
        """Force of a press that deep (N)."""
        _, forces, depths = _contacts(self)
        return float(np.interp(depth_mm, depths, forces)) * max(1.0, depth_mm / depths[-1])

    def motions(
        self,
        away_mm: Float[np.ndarray, "*pair 2"],
        depth_mm: Float[np.ndarray, "depth"],
        force_n: float,
        turns: float = DISK_TURNS,
    ) -> Float[np.ndarray, "*pair depth 4 6"]:
        """Motions of small disks under presses: along ∂/∂x, ∂/∂y, ∂/∂F of the press, and as they are.

        `away_mm`: from the press to the disk along the surface. Motions are displacements (mm) and
        rotations (rad) in a frame whose z is outward, per mm and per N where they are derivatives.
        """
        step = _STEP_MM * np.eye(2)
        more, less = ((1 + sign * _FORCE_STEP) * force_n for sign in (1, -1))
        depths = tuple(depth_mm.tolist())
        plain = _fields(self, depths, force_n, turns)
        # The press moves one way as the disk moves the other.
        moved = [
            (_vectors(plain, away_mm - shift_mm) - _vectors(plain, away_mm + shift_mm))
            / (2 * _STEP_MM)
            for shift_mm in step
        ]
        by_force = [
            _vectors(_fields(self, depths, force, turns), away_mm) for force in (more, less)
        ]
        per_n = (by_force[0] - by_force[1]) / (more - less)
        return np.stack([*moved, per_n, _vectors(plain, away_mm)], axis=-2)


@lru_cache(maxsize=32)
def _contacts(layer: Layer) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Radii of contacts, their forces (N) and depths (mm)."""
    radii = layer.radius_mm * np.linspace(_LEAST_CONTACT, _LARGEST_CONTACT, _CONTACTS)
    middles, borders = [], []
    for radius in radii.tolist():
        k = _waves(radius)
        deep = layer.modes(k, np.zeros(1))[0] * (hertz_waves(k, radius) * k)[:, None]
        middle, border = _integrate(j0(np.outer([0.0, radius], k)), deep, k)[:, 0]
        middles.append(middle)
        borders.append(border)
    # The ball stands a² / 2R higher at the contact's border than in its middle.
    forces = radii**2 / (2 * layer.radius_mm) / (np.array(middles) - borders)
    return radii, forces, forces * middles


@lru_cache(maxsize=32)
def _fields(
    layer: Layer, depths_mm: tuple[float, ...], force_n: float, turns: float
) -> CubicSpline:
    """Displacement down and outward along the surface, and rotation about what lies across, over distance."""
    depth_mm, (contact, _) = np.array(depths_mm), layer.contact(force_n)
    k = _waves(contact)
    weight = (force_n * hertz_waves(k, contact) * k)[:, None]
    deep, outwards = (part * weight for part in layer.modes(k, depth_mm))
    near = np.linspace(0, 1, _RADII)
    distance = _REACH * layer.thickness_mm * near**1.5  # closer together near the press
    kr = np.outer(distance, k)
    of_j0, of_j1 = j0(kr), j1(kr)
    # ∂U/∂z of each wave: a central difference of the closed form.
    shift = 1e-3 * layer.thickness_mm
    bend = layer.modes(k, depth_mm + shift)[1] - layer.modes(k, depth_mm - shift)[1]
    down, outward = _integrate(of_j0, deep, k), _integrate(of_j1, outwards, k)
    slope = -_integrate(of_j1, k[:, None] * deep, k)  # ∂(down)/∂r
    lean = _integrate(of_j1, bend * weight / (2 * shift), k)  # ∂(outward)/∂(depth)
    # ½ curl u − λ n × E n about the direction across, with z outward (Jeffery 1922).
    turn = ((1 + turns) * slope - (1 - turns) * lean) / 2
    table = np.stack([down, outward, turn], axis=-1)
    table *= np.cos(np.pi / 2 * np.clip(5 * near - 4, 0, 1))[:, None, None] ** 2  # ends at 0
    return CubicSpline(distance, table, axis=0)


def hertz_waves(
    wave_per_mm: Float[np.ndarray, "wave"], contact_mm: float
) -> Float[np.ndarray, "wave"]:
    """Return the Hankel transform ∫ p J₀(kr) r dr of Hertz's pressure of 1 N within a radius."""
    x = wave_per_mm * contact_mm
    return 3 * (np.sin(x) - x * np.cos(x)) / (2 * np.pi * x**3)


def _waves(contact_mm: float) -> Float[np.ndarray, "wave"]:
    return np.linspace(1e-3, _SHORTEST, _WAVES) / contact_mm


def _integrate(bessel: np.ndarray, waves: np.ndarray, k: np.ndarray) -> np.ndarray:
    """∫ dk by the trapezoidal rule: (distance, wave) times (wave, depth)."""
    weights = np.full(len(k), k[1] - k[0])
    weights[[0, -1]] /= 2
    return (bessel * weights) @ waves


def _vectors(fields: CubicSpline, away_mm: np.ndarray) -> Float[np.ndarray, "*pair depth 6"]:
    """Turn what is tabulated by distance into vectors; nothing moves beyond the table."""
    distance = np.linalg.norm(away_mm, axis=-1)
    least = np.maximum(distance, 1e-9)[..., None]
    cosine, sine = (away_mm / least).T
    cosine, sine = cosine.T[..., None], sine.T[..., None]
    table = fields(np.minimum(distance, fields.x[-1]))
    down, outward, turn = (table[..., k] for k in range(3))
    return np.stack(
        [
            outward * cosine,
            outward * sine,
            -down,
            -turn * sine,
            turn * cosine,
            np.zeros_like(down),
        ],
        axis=-1,
    )
