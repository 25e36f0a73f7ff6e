"""Presses of tips off the middle, on faces that are half-spaces: a page that a person can judge."""

import numpy as np

from fem.presses.compliance_map import compliance_map
from fem.presses.discretisation import coarser, mesh_difference, sample_presses
from fem.presses.joint import Tip, press_path, press_tips, refined_faces
from fem.presses.table import simulate_lattice
from fem.presses.to_force import press_to_force
from fem.presses.viscoelastic import relaxed_force_n
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import coarse_spec
from tests.support.physics_pages import assert_page, chosen

SPEC = coarse_spec(
    contact_grid={"count": (2, 3), "pitch_mm": 4.0},
    press={"depths_mm": (0.6, 1.4)},
    magnets={"positions_mm": [[3.0, -6.0], [-7.0, 2.0]]},
    silicone={"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.47},
)
PRONY = ((0.3, 2.0), (0.1, 20.0))
TIPS = Tip(3, 2.0, -7.0), Tip(3, -4.0, 5.5)
DEPTHS_MM = np.array([[0.5, 0.3], [1.2, 1.0]])


def of_lattice(response):
    forces, motions = simulate_lattice(SPEC, response)
    yield from chosen(forces, "force_n", "contact_area_mm2")
    yield "motions (mm, rad)", motions.motion
    yield "compliance (mm/N)", compliance_map(forces).mm_per_n
    one, other = (sample_presses(SPEC, made) for made in (half_space_response(SPEC, 9), response))
    yield "sampled motions (mm)", one.motion_mm
    yield "share of motions that a mesh changes", mesh_difference(one, other).motion
    mesh = coarser(SPEC).mesh
    yield "edges of a coarser mesh (mm)", [mesh.edge_mm, mesh.surface_edge_mm]


def of_tips(response):
    path = press_path(SPEC, response, list(TIPS), DEPTHS_MM, refined_faces(SPEC, response))
    presses = {
        "first of a path": path[0],
        "last of a path": path[1],
        "at once": press_tips(SPEC, response, list(TIPS), DEPTHS_MM[1]),
        "to 2 N": press_to_force(SPEC, response, ((TIPS[0],), (TIPS[1],)), 2.0),
        "squeezed": press_to_force(SPEC, response, ((TIPS[0],), (Tip(5, -3.0, 4.0),)), 3.0),
    }
    for name, press in presses.items():
        sizes = [*press.depth_mm, *press.force_n, *press.contact_area_mm2]
        yield f"{name}: depths (mm), forces (N), areas (mm²)", sizes
        yield f"{name}: motions (mm, rad)", press.motion
    force_n = np.arange(12.0).reshape(2, 6)
    yield "relaxed (N)", relaxed_force_n(force_n, np.arange(6) / 2, PRONY)


def test_the_page_of_presses():
    response = half_space_response(SPEC, 13, 0.1)
    assert_page("fem/presses", [*of_lattice(response), *of_tips(response)])
