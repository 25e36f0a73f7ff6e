"""A fruit between two jaws by finite elements: a ball of flesh under a stiffer skin, a quarter of its half.

The cube [0, R]³ is mapped to an octant of the ball: planes of one height become spheres, so that the skin is
whole elements. All three cuts are planes of symmetry: the other jaw presses as this one.
"""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import scipy.sparse as sp
from skfem import MeshTet

from design.body.surface_chart import FaceFrame
from fem.contact.complementarity import contact_pressures
from fem.linear.elements import assemble, element_space, saddle_point_matrix
from fem.linear.factorization import compliance_of_loads
from fem.linear.material import lame_constants
from fem.linear.response import face_surface
from fem.presses.table import profile_moments_mm3, surface_weights_mm2
from tests.support.mechanics.fem_cases import component_basis, graded_axis

DEPTHS_MM = np.linspace(0.1, 2.4, 24)
_NEAR_MM = 8.0


@dataclass(frozen=True)
class PressedFruit:
    """Force (N), mean pressure (MPa) and work (mJ) of one jaw's tip by its depth (mm)."""

    depth_mm: np.ndarray
    force_n: np.ndarray
    pressure_mpa: np.ndarray
    energy_mj: np.ndarray

    def at(self, force_n):
        """Depth, mean pressure and work at a force."""
        columns = (self.depth_mm, self.pressure_mpa, self.energy_mj)
        return tuple(float(np.interp(force_n, self.force_n, column)) for column in columns)


@cache
def pressed_fruit(radius_mm, modulus_mpa, poisson, skin_mm, skin_ratio, tip_mm, cell_mm=0.6):
    """Press a round tip into a fruit whose skin is `skin_ratio` times as stiff as its flesh."""
    plan = graded_axis(cell_mm, 7, 1.45, radius_mm)
    below = skin_mm + graded_axis(cell_mm, 4, 1.45, radius_mm - skin_mm)
    height = radius_mm - np.concatenate([[0.0, skin_mm / 2], below])[::-1]
    cube = MeshTet.init_tensor(plan, plan, height)
    size = np.linalg.norm(cube.p, axis=0)
    scale = np.divide(cube.p.max(axis=0), size, out=np.ones_like(size), where=size > 0)
    mesh = MeshTet(cube.p * scale, cube.t)
    middle = cube.p[:, cube.t].mean(axis=1).max(axis=0)
    stiffness = np.where(middle > radius_mm - skin_mm, skin_ratio, 1.0)
    space = element_space(mesh, "p2")
    basis = component_basis(space.nodes_mm.T > 1e-9)
    operators = assemble(space, lame_constants(modulus_mpa, poisson), stiffness)
    matrix = saddle_point_matrix(operators, basis, np.zeros(0, int))
    x, y, z = np.eye(3)
    frame = FaceFrame(1, z, x, y, np.array([0, 0, radius_mm]), (radius_mm, radius_mm))
    on_top = np.all(cube.p[2][cube.facets] > radius_mm - 1e-9, axis=0)
    surface, moments = face_surface(space, np.flatnonzero(on_top), frame)
    far = np.linalg.norm(surface.xy_mm, axis=1)
    drop = radius_mm - np.sqrt(np.maximum(radius_mm**2 - far**2, 0.0))
    surface = replace(surface, height_mm=-drop)
    near = np.flatnonzero(far < _NEAR_MM)
    empty = sp.csr_matrix((2 * space.node_count, len(near)))
    loads = basis.T @ sp.vstack([empty, -moments[:, near]])
    condensed = compliance_of_loads(matrix, sp.csr_matrix(loads))
    weights = surface_weights_mm2(surface)[near]
    profile = profile_moments_mm3(surface, np.zeros((1, 2)), tip_mm)[0, near]
    pressure = contact_pressures(condensed.matrix, profile, weights, DEPTHS_MM)
    force = 4 * pressure @ weights
    # under Hertz's pressure the mean of r² is 2/5 of a²
    spread = 2.5 * (pressure * weights) @ far[near] ** 2 / (pressure @ weights)
    spread = np.maximum(spread, 1e-9)  # one vertex alone has no extent
    before, steps = np.concatenate([[0.0], force[:-1]]), np.diff(DEPTHS_MM, prepend=0.0)
    work = np.cumsum((before + force) / 2 * steps)
    return PressedFruit(DEPTHS_MM, force, force / (np.pi * spread), work)
