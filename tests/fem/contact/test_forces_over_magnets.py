"""Forces of the default mesh over and beside magnets, against an independent code.

The box takes seconds on its mesh on record, other bodies minutes.
"""

from pathlib import Path

import numpy as np
import pytest

from design.spec_io import check, load_spec
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import press_face
from tests.support.objects.magnet_box import BOX

EXAMPLES = Path(__file__).parents[3] / "examples"
DEPTHS_MM = np.array([1.0, 2.0])
ON_BOX_N = {
    (0, 0): (5.011, 12.596),
    (2.5, 0): (3.620, 10.795),
    (6, 0): (2.392, 7.949),
    (14, 0): (4.375, 12.020),
    (16.5, 0): (3.321, 10.146),
    (-14, 0): (3.516, 10.776),
    (-16.5, 0): (2.923, 9.315),
    (27, 0): (1.341, 3.626),
    (28.5, 0): (1.021, 2.762),
    (30, 0): (0.631, 1.873),
}
"""The last three at the border, up to half the tip over the edge: P2/P1 with 0.45 mm, shell 36 mm deep."""
FORCES_N = {
    ("paper_cube", 0): {(0, 0): (3.876, 11.250), (3, 0): (2.920, 9.235), (5, 0): (2.481, 8.121)},
    ("ball", 0): {(0, 0): (3.310, 9.617), (3, 0): (2.608, 8.085), (4.5, 0): (2.466, 7.740)},
    ("capsule", 1): {(0, 0): (3.523, 10.225), (3, 0): (2.700, 8.530), (5, 0): (2.442, 7.960)},
    ("pear", 1): {(0, 0): (3.329, 9.717), (3, 0): (2.592, 8.126), (4.5, 0): (2.584, 7.907)},
    ("better_cube", 0): {
        (8.71, 8.81): (4.477, 11.175),
        (5.71, 8.81): (3.078, 9.108),
        (3.7, 8.81): (2.469, 7.964),
    },
}
"""By place: over a magnet, on its rim, between magnets.

`benchmarks/forces_over_magnets.py`: NGSolve 6.2.2608. Cube, ball and capsule: Taylor–Hood P3/P2 with 0.45 mm
under the tip (the ball's middle 0.35 mm), at the rims and beside the ball's magnet P2/P1 with 0.35 mm, less
0.2 %. Box, over 1 and 1.5 mm of silicone: P3/P2 with 0.5 mm, less 0.1 %. All else: P2/P1 with 0.45 mm, less
0.2 %, by which P2 is too stiff elsewhere. The box, the pear and better_cube set no constant of the closed
form."""

UNDER_4_MM_N = {(0, 0): (2.825, 9.190), (3, 0): (2.541, 8.370), (5, 0): (2.385, 7.773)}
"""The cube with 4 mm of silicone over its magnets, by P2/P1 with 0.45 mm, less 0.2 %."""
ALIKE_BOTH_WAYS = ("paper_cube", "ball", "capsule")
"""There a place and the one at −x, with other triangles, have one force; their mean is compared."""


def errors(spec, face, wanted_n):
    """Relative errors (place, depth) of the default mesh."""
    response = build_response(tetrahedralize(spec), spec)
    places = np.array(list(wanted_n), float)
    force = press_face(spec, response, face, places, DEPTHS_MM).force_n
    if spec.name in ALIKE_BOTH_WAYS:
        mirrored = press_face(spec, response, face, places * [-1, 1], DEPTHS_MM).force_n
        force = (force + mirrored) / 2
    return force / np.array(list(wanted_n.values())) - 1


def test_forces_over_magnets_at_three_depths_are_within_two_percent():
    """On the edge the force at 1 mm scatters by 1 % between meshes, so 4 % are allowed there."""
    found = errors(BOX, 0, ON_BOX_N)
    at_border = np.array(list(ON_BOX_N))[:, :1] >= 27
    assert (abs(found) < np.where(at_border, [0.04, 0.02], 0.02)).all(), found


@pytest.mark.slow
@pytest.mark.parametrize("case", FORCES_N, ids=lambda case: case[0])
def test_forces_over_and_beside_magnets_are_within_two_percent(case):
    name, face = case
    found = errors(load_spec(EXAMPLES / f"{name}.toml"), face, FORCES_N[case])
    assert (abs(found) < 0.02).all(), found


@pytest.mark.slow
def test_forces_over_magnets_under_4_mm_of_silicone_are_within_two_percent():
    """Twice as deep as any magnet that set a constant of the closed form."""
    cube = load_spec(EXAMPLES / "paper_cube.toml").changed(magnets={"depth_mm": 4.5})
    found = errors(check(cube), 0, UNDER_4_MM_N)
    assert (abs(found) < 0.02).all(), found
