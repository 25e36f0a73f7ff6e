"""What rigid bodies close under a face take back of a half-space's compliance.

A bonded layer of depth h has a half-space's surface compliance times L(kh) at wavenumber k. With
κ = 3 − 4ν, L(α) = (2κ sinh 2α − 4α)/(2κ cosh 2α + κ² + 1 + 4α²) (Dimitriadis et al., Biophys. J. 82
(2002) 2798), and 1 − L(α) is nearly e^(−cα²). So the base takes back what a half-space answers to the
same patches, each of them wider by c h² in its variance per axis. Beside a body's rim this fades.
Its three constants are fitted to forces by NGSolve over and beside magnets of a cube, a ball and a
capsule (`benchmarks/forces_over_magnets.py`), 2 mm of silicone over Ø 6 mm: what is left is within
2 % at 1 and 2 mm depth and 4.5 % at 0.5 mm.
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

WIDENED = 0.2
"""c above: 0.25 fits L of a layer without end, 0.2 forces over magnets by NGSolve."""
_FADES, _REACHES = 1.0, 0.8
"""In depths: width of the fading, and how far outside the rim its middle lies; fitted to the same."""
LEAST_WEIGHT = 0.02
_LEAST_DEPTH_MM, _DEPTH_STEP_MM = 0.3, 0.05
"""Depths are rounded, so that presses over a tilted magnet share what is kept: 0.1 % of force."""


@dataclass(frozen=True)
class RigidBase:
    """A rigid body in the plane coordinates of its face: centre, axes as columns, outline, height; Young's
    modulus (MPa) and Poisson's ratio of the silicone over it."""

    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    outline: Outline
    height_mm: float
    elastic: tuple[float, float]

    def weights(self, points_mm: Float[np.ndarray, "n 3"]) -> tuple[Float[np.ndarray, "n"], float]:
        """How far the body is what lies under points of the face (0 to 1), and its depth (mm)."""
        x, y, z = ((points_mm - self.centre_mm) @ self.axes).T
        beyond = self.outline.beyond_mm(np.column_stack([x, y]))
        depth = np.clip(abs(z) - self.height_mm / 2, _LEAST_DEPTH_MM, None)
        weight = erfc((beyond / depth - _REACHES) / _FADES) / 2
        total = weight.sum()
        mean = float(weight @ depth / total) if total > 0 else _LEAST_DEPTH_MM
        return weight, round(mean / _DEPTH_STEP_MM) * _DEPTH_STEP_MM

    def taken_back(self, patches: Patches, depth_mm: float) -> Float[np.ndarray, "patch patch"]:
        """∫ u_n dA over each patch per unit pressure on each that a base takes back, mm³/MPa."""
        wider = replace(patches, variance_mm2=patches.variance_mm2 + WIDENED * depth_mm**2, own=1.0)
        return normal_compliance(wider, wider, *self.elastic)

    def taken_back_wherever(
        self, patches: Patches, depth_mm: float
    ) -> Float[np.ndarray, "patch patch"]:
        """The same, kept: on a flat face an indenter's cells are the same at every place. Read-only."""
        away = patches.centre_mm - patches.centre_mm[0]
        pattern = np.column_stack([away, patches.area_mm2, patches.variance_mm2]).round(9)
        return _of_pattern(self.elastic, pattern.tobytes(), len(pattern), depth_mm)


@functools.lru_cache(maxsize=32)
def _of_pattern(
    elastic: tuple[float, float], pattern: bytes, count: int, depth_mm: float
) -> Float[np.ndarray, "patch patch"]:
    """What is taken back of patches known by their centroids, area and variance."""
    columns = np.frombuffer(pattern).reshape(count, -1)
    variance = columns[:, -1] + WIDENED * depth_mm**2
    wider = Patches(columns[:, -2], columns[:, :-2], variance, 1.0)
    matrix = normal_compliance(wider, wider, *elastic)
    matrix.flags.writeable = False
    return matrix


def rigid_bases(spec: ObjectSpec, frame: FaceFrame, surface: FaceSurface) -> tuple[RigidBase, ...]:
    """Rigid bodies under one face; none where magnets are points. They slip as the face over them."""
    if spec.mechanics.magnets != "rigid":
        return ()
    layout, bases = shell_body_layout(spec), []
    elastic = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    for i in np.flatnonzero(layout.face == frame.number):
        centre, axes = frame.in_plane(layout.centre_mm[i]), frame.axes.T @ layout.frame[i]
        if surface.slip_mm is not None:
            from_there = np.linalg.norm(surface.xy_mm - surface.slip_mm - centre[:2], axis=1)
            centre[:2] += surface.slip_mm[np.argmin(from_there)]
        body = layout.bodies[i]
        bases.append(RigidBase(centre, axes, body.outline, body.height_mm, elastic))
    return tuple(bases)
