"""Presses on a capsule: on its side as on a cylinder, on its end as on a sphere."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import FacePresses, press_face
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA, all_silicone

DIAMETER_MM = 26.0
PLACES = np.array([[0, 0], [5, 3], [-5, 3], [-5, -3], [5, -3], [0, 6], [0, -6], [6, 0]], float)
"""All alike on a sphere, on an end and on a side; at one of them two meshes differ by up to 6 %."""
SAME = 0.03
"""Of the means over the places: five times two meshes differed by up to 1.6 %."""

pytestmark = pytest.mark.slow


def pressed(kind: str, length_mm: float, face: int) -> FacePresses:
    """The one sensed face of a closed body, pressed at `PLACES`."""
    size = [DIAMETER_MM, DIAMETER_MM, length_mm]
    content = {
        "name": kind,
        "body": {"kind": kind, "size_mm": size, "open_faces": [], "sensed_faces": [face]},
        "shell": {"thickness_mm": 5.0},
        "silicone": {"youngs_modulus_mpa": YOUNGS_MODULUS_MPA},
        "magnets": {"positions_mm": [[0.0, 0.0]]},
        "sensors": {"positions_mm": [[0.0, 0.0]]},
        "core": {"recess_inner_radius_mm": 1.0, "recess_outer_radius_mm": 3.0},
        "indenter": {"radius_mm": 4.0},
        "contact_grid": {"count": [2, 2], "pitch_mm": 2.0},
        "press": {"depths_mm": [0.5, 1.0]},
        "mesh": {
            "edge_mm": 7.0,
            "surface_edge_mm": 2.2,
            "envelope_mm": 0.08,
            "rim_edge_ratio": 1.0,
        },
    }
    spec = ObjectSpec.model_validate(content)
    response = build_response(all_silicone(tetrahedralize(spec)), spec)
    return press_face(spec, response, 0, PLACES, np.array(spec.press.depths_mm))


@pytest.fixture(scope="module")
def forces():
    """Mean forces (N) over the places at two depths, of each body and the face that is pressed."""
    bodies = (
        ("capsule", 52.0, 3),
        ("cylinder", 52.0, 3),
        ("capsule", 52.0, 1),
        ("sphere", 26.0, 1),
    )
    return {
        (kind, face): pressed(kind, length, face).force_n.mean(axis=0)
        for kind, length, face in bodies
    }


def test_a_capsule_s_side_resists_as_a_cylinder_s(forces):
    assert_allclose(forces["capsule", 3], forces["cylinder", 3], rtol=SAME)


def test_a_capsule_s_end_resists_as_a_sphere_s(forces):
    assert_allclose(forces["capsule", 1], forces["sphere", 1], rtol=SAME)
