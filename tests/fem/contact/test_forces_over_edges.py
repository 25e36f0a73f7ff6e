"""Forces and magnets' motions at borders, corners and over edges, against an independent code.

`benchmarks/forces_over_edges.py`: NGSolve 6.2.2608, Taylor–Hood P2/P1, edges of 0.55 mm under the tip, 0.6 mm
over the edge and 0.7 mm over the corner. It has no magnets on the third face of the corner.
"""

from pathlib import Path

import numpy as np
import pytest

from design.layout.places.positions import magnet_layout
from design.spec_io import load_spec
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.joint import Tip
from fem.presses.over_edge import edge_mesh, edge_place, edge_presser
from fem.presses.table import press_face

CUBE = load_spec(Path(__file__).parents[3] / "examples" / "paper_cube.toml")
DEPTHS_MM = np.array([1.0, 2.0])
SIDE, TOP = (18.5, 10, 10), (10, 10, 18.5)
"""Middles of the magnets that move most."""
BORDERS = {
    (16.5, 0): ((1.620, 4.482), SIDE, (0.03714, 0.11912, -0.15378)),
    (18, 0): ((1.366, 3.689), SIDE, (0.03109, 0.11736, -0.14936)),
    (19.5, 0): ((1.045, 2.816), SIDE, (0.02341, 0.10304, -0.12872)),
    (21, 0): ((0.647, 1.900), SIDE, (0.01545, 0.07716, -0.09428)),
    (19.5, 19.5): ((0.604, 1.523), SIDE, (0.02484, -0.02563, -0.13618)),
    (21, 21): ((0.269, 0.773), SIDE, (0.01217, -0.01566, -0.07098)),
}
"""Places of face 1: forces at both depths (N), a magnet's motion at 2 mm (mm)."""
OVER = {
    "edge, 30°": ((21 + 5 * np.pi / 6, 0), (0.666, 2.172), SIDE, (0.0095, 0.06554, -0.06459)),
    "edge, 45°": ((21 + 5 * np.pi / 4, 0), (0.702, 2.257), TOP, (-0.03506, 0.04762, 0.00443)),
    "corner": (
        (21 + 5 * np.arccos(3**-0.5) / 2**0.5,) * 2,
        (0.206, 0.835),
        TOP,
        (-0.02378, -0.02304, 0.00393),
    ),
}


def motion_error(motion, middle, wanted):
    """Of one magnet's displacement, over the largest of all."""
    centre = magnet_layout(CUBE).centre_mm
    magnet = int(np.argmin(np.linalg.norm(centre - middle, axis=1)))
    largest = np.linalg.norm(motion[:, :3], axis=1).max()
    return np.linalg.norm(motion[magnet, :3] - wanted) / largest


@pytest.mark.slow
def test_forces_and_motions_at_borders_are_within_three_percent():
    response = build_response(tetrahedralize(CUBE), CUBE)
    found = press_face(CUBE, response, 0, np.array(list(BORDERS), float), DEPTHS_MM)
    forces = np.array([wanted[0] for wanted in BORDERS.values()])
    assert (abs(found.force_n / forces - 1) < 0.03).all(), found.force_n / forces - 1
    rows = response.compliance[response.magnet_loads, response.face_loads(0)]
    for pressure, (_, middle, wanted) in zip(found.vertex_mpa[:, 1], BORDERS.values(), strict=True):
        assert motion_error((rows @ pressure).reshape(-1, 6), middle, wanted) < 0.03


@pytest.mark.slow
@pytest.mark.parametrize("case", OVER)
def test_forces_and_motions_over_edges_are_within_four_and_two_percent(case):
    """At 1 and 2 mm: a contact 1.5 mm wide depends on where the mesh's vertices lie."""
    xy, forces, middle, wanted = OVER[case]
    place = edge_place(CUBE, Tip(1, *map(float, xy)))
    press = edge_presser(CUBE, edge_mesh(CUBE, place), place)
    found = [press(DEPTHS_MM[k : k + 1]) for k in range(2)]
    force = np.array([one.force_n[0] for one in found])
    assert (abs(force / forces - 1) < [0.04, 0.02]).all(), force / forces - 1
    assert motion_error(found[1].motion, middle, wanted) < 0.03
