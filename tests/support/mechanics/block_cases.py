"""Responses of blocks bonded below and of half-spaces, for presses with closed-form answers."""

from functools import cache

import numpy as np
import scipy.sparse as sp
from skfem import MeshTet

from design.body.surface_chart import FaceFrame
from design.spec.object import IndenterSpec
from fem.contact.complementarity import contact_pressures
from fem.contact.indenter import tip_cells
from fem.contact.refined import cells_compliance
from fem.linear.elements import assemble, saddle_point_matrix, taylor_hood
from fem.linear.factorization import compliance_of_loads
from fem.linear.material import lame_constants
from fem.linear.response import ResponseOperator, face_surface
from tests.support.mechanics.fem_cases import (
    YOUNGS_MODULUS_MPA,
    component_basis,
    graded_axis,
    paper_cube,
)


def spec_of(poisson_ratio, **indenter):
    """A specification of this silicone and indenter, whether it fits the paper's cube or not."""
    spec = paper_cube((1.2, 4.0), poisson_ratio)
    return spec.model_copy(update={"indenter": IndenterSpec(**indenter)})


def plane_strain_modulus_mpa(poisson_ratio):
    return YOUNGS_MODULUS_MPA / (1 - poisson_ratio**2)


def half_space_presses(spec, depths_mm):
    """Pressures (step, cell) of the indenter on a half-space, and its cells."""
    tip = tip_cells(spec.indenter)
    area = tip.patches.area_mm2
    compliance = cells_compliance(tip.patches, spec)
    pressures = contact_pressures(compliance, tip.height_mm * area, area, np.asarray(depths_mm))
    return pressures, tip


def half_space_forces_n(spec, depths_mm):
    pressures, tip = half_space_presses(spec, depths_mm)
    return pressures @ tip.patches.area_mm2


def block_response(poisson_ratio, half_width_mm, height_mm, cell_mm=2.0, cells=3, layers=None):
    """Response of the top of a block bonded below; its cells grow outwards and downwards."""
    half = graded_axis(cell_mm, cells, 1.8, half_width_mm)
    plan = np.concatenate([-half[:0:-1], half])
    down = graded_axis(cell_mm, 1, 1.7, height_mm)
    if layers:
        down = np.linspace(0, height_mm, layers + 1)
    mesh = MeshTet.init_tensor(plan, plan, -down[::-1])
    space = taylor_hood(mesh)
    free = np.tile(space.nodes_mm[:, 2] > -height_mm + 1e-9, (3, 1))
    basis = component_basis(free)
    material = lame_constants(YOUNGS_MODULUS_MPA, poisson_ratio)
    matrix = saddle_point_matrix(assemble(space, material), basis, space.pressure_nodes)
    x, y, z = np.eye(3)
    frame = FaceFrame(1, z, x, y, np.zeros(3), (half_width_mm, half_width_mm))
    facets = mesh.facets_satisfying(lambda x: abs(x[2]) < 1e-9, boundaries_only=True)
    surface, moments = face_surface(space, facets, frame)
    empty = sp.csr_matrix((2 * space.node_count, moments.shape[1]))
    loads = basis.T @ sp.vstack([empty, -moments])
    padding = sp.csr_matrix((len(space.pressure_nodes), moments.shape[1]))
    condensed = compliance_of_loads(matrix, sp.csr_matrix(sp.vstack([loads, padding])))
    return ResponseOperator((surface,), condensed.matrix, matrix.shape[0], -1)


known_block_response = cache(block_response)
"""For tests that plant no fault in it: files share the larger blocks."""
