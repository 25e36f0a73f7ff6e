"""Share of a half-space's compliance that rigid bodies close under a face take back.

A bonded layer of depth h has a half-space's surface compliance times L(kh) at wavenumber k. With
κ = 3 − 4ν, L(α) = (2κ sinh 2α − 4α)/(2κ cosh 2α + κ² + 1 + 4α²) (Dimitriadis et al., Biophys. J. 82
(2002) 2798). The base takes back the share 1 − L, which is nearly e^(−vk²): what a half-space answers
to the same patches, each of them wider by v in its variance per axis. v makes the share exact at the
shortest wave that triangles hold, two edges: there finite elements hand over to the closed form. Longer
waves are theirs, so that on finer meshes what is taken back of cells and of their hats becomes the same.

The magnet is no layer without end: outside its rim the share fades. Only that is set by forces, of NGSolve
on a cube, a ball and a capsule; a box with other magnets at three depths and a pear came after
(`benchmarks/forces_over_magnets.py`). What is left at 1 and 2 mm depth stands in docs/measured/presses.md.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.special import erfc

from design.body.surface_chart import FaceFrame
from design.layout.places.positions import shell_body_layout
from design.layout.pockets import Outline
from design.spec.object import ObjectSpec
from fem.contact.half_space import Patches, normal_compliance
from fem.linear.response import FaceSurface

_FADES, _REACHES = 1.0, 0.8
"""In depths: width of the fading, and how far outside the rim its middle lies. By forces of NGSolve over
and next to magnets of Ø 6 mm, 2 mm deep; 0.6 and 0.4 instead change forces by 1 % at 1 mm at most. They
were tried on magnets 1 to 2.5 mm deep that are twice as wide as deep, or wider."""
_HAT_VARIANCE = 1 / 8
"""Variance of the hat function of an equilateral triangulation, per axis, over its edge squared."""
LEAST_WEIGHT = 0.02
"""Cells that count less are left out, which takes time only: next to magnets forces change by 0.006 %."""
_LEAST_DEPTH_MM, _DEPTH_STEP_MM, _EDGE_STEP_MM = 0.3, 0.05, 0.1
"""Depths and edges are rounded, so that presses over a tilted magnet, and magnets, share what is kept: 0.1 %
of force."""


@dataclass(frozen=True)
class RigidBase:
    """A rigid body in the plane coordinates of its face: centre, axes as columns, outline, height; Young's
    modulus (MPa) and Poisson's ratio of the silicone over it, and edges of the triangles there."""

    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    outline: Outline
    height_mm: float
    elastic: tuple[float, float]
    edge_mm: float

    def weights(self, points_mm: Float[np.ndarray, "n 3"]) -> tuple[Float[np.ndarray, "n"], float]:
        """Return how far the body is what lies under points of the face (0 to 1), and its depth (mm)."""
        x, y, z = ((points_mm - self.centre_mm) @ self.axes).T
        beyond = self.outline.signed_distance_mm(np.column_stack([x, y]))
        depth = np.clip(abs(z) - self.height_mm / 2, _LEAST_DEPTH_MM, None)
        weight = erfc((beyond / depth - _REACHES) / _FADES) / 2
        total = weight.sum()
        mean = float(weight @ depth / total) if total > 0 else _LEAST_DEPTH_MM
        return weight, round(mean / _DEPTH_STEP_MM) * _DEPTH_STEP_MM

    def taken_back(self, patches: Patches, depth_mm: float) -> Float[np.ndarray, "patch patch"]:
        """∫ u_n dA over each patch per unit pressure on each that a base takes back, mm³/MPa."""
        variance = patches.variance_mm2 + widening_mm2(depth_mm, self.edge_mm, self.elastic[1])
        wider = replace(patches, variance_mm2=variance, own_factor=1.0)
        return normal_compliance(wider, wider, *self.elastic)

    def taken_back_wherever(
        self, patches: Patches, depth_mm: float
    ) -> Float[np.ndarray, "patch patch"]:
        """The same, kept: in its plane an indenter's cells are the same at every place. Read-only."""
        away = patches.centre_mm - patches.centre_mm[0]
        pattern = np.column_stack([away, patches.area_mm2, patches.variance_mm2]).round(9)
        return _pattern_share(self.elastic, pattern.tobytes(), len(pattern), depth_mm, self.edge_mm)


def widening_mm2(depth_mm: float, edge_mm: float, poisson_ratio: float) -> float:
    """Variance v per axis for which e^(−vk²) is 1 − L(kh) at k = π/edge."""
    wavenumber = np.pi / edge_mm
    (log_share,) = log_taken_share(np.array([wavenumber * depth_mm]), poisson_ratio)
    return float(-log_share / wavenumber**2)


def log_taken_share(
    alpha: Float[np.ndarray, "*n"], poisson_ratio: float
) -> Float[np.ndarray, "*n"]:
    """Return log(1 − L(α)): of a wave's displacement on a half-space, what a rigid base takes back."""
    kappa, damped = 3 - 4 * poisson_ratio, np.exp(-2 * alpha)
    # 1 − L times e^(2α), without a difference of nearly equal numbers or an underflow
    kept = 2 * kappa * damped + kappa**2 + (1 + 2 * alpha) ** 2
    whole = kappa * (1 + damped**2) + (kappa**2 + 1 + 4 * alpha**2) * damped
    return np.log(kept / whole) - 2 * alpha


@functools.lru_cache(maxsize=128)
def _pattern_share(
    elastic: tuple[float, float], pattern: bytes, count: int, depth_mm: float, edge_mm: float
) -> Float[np.ndarray, "patch patch"]:
    """Return what is taken back of patches known by their centroids, area and variance."""
    columns = np.frombuffer(pattern).reshape(count, -1)
    variance = columns[:, -1] + widening_mm2(depth_mm, edge_mm, elastic[1])
    wider = Patches(columns[:, -2], columns[:, :-2], variance, 1.0)
    matrix = normal_compliance(wider, wider, *elastic)
    matrix.flags.writeable = False
    return matrix


def rigid_bases(
    spec: ObjectSpec, frame: FaceFrame, surface: FaceSurface, hats: Patches
) -> tuple[RigidBase, ...]:
    """Rigid bodies under one face. They slip as the face over them."""
    layout, bases = shell_body_layout(spec), []
    elastic = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    for i in np.flatnonzero(layout.face == frame.number):
        centre, axes = frame.plane_coordinates(layout.centre_mm[i]), frame.axes.T @ layout.frame[i]
        if surface.slip_mm is not None:
            from_there = np.linalg.norm(surface.xy_mm - surface.slip_mm - centre[:2], axis=1)
            centre[:2] += surface.slip_mm[np.argmin(from_there)]
        body = layout.bodies[i]
        base = RigidBase(centre, axes, body.outline, body.height_mm, elastic, 0.0)
        bases.append(replace(base, edge_mm=_edge_over_mm(base, hats)))
    return tuple(bases)


def _edge_over_mm(base: RigidBase, hats: Patches) -> float:
    """Median edge of the triangles over a body, finer at its rim; rounded as depths are."""
    weight, _ = base.weights(hats.centre_mm)
    over = weight >= min(0.5, weight.max())
    edge = float(np.sqrt(np.median(hats.variance_mm2[over]) / _HAT_VARIANCE))
    return max(round(edge / _EDGE_STEP_MM), 1) * _EDGE_STEP_MM
