"""What is meshed is what is cast: keys and slits in the surface, keys held by the core."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.volumes import sealed_volume_mm3
from design.spec_io import parse_spec
from fem.linear.core_interface import touches_core
from fem.linear.response import build_response
from fem.mesh.quality import mesh_quality, require_quality
from fem.mesh.surfaces import sealed_body_surface
from fem.mesh.tetrahedra import tetrahedralize

KEYS = {
    "core": {"keys": {"positions_mm": [[11.0, 11.3], [-11.5, 11.0]], "size_mm": [2.0, 3.0, 1.5]}}
}
SLITS = {"shell": {"slits": {"depth_mm": 3.0, "width_mm": 0.8}}}


def parsed(content):
    return parse_spec({"name": "t", **content}, "test")


@pytest.mark.parametrize("content", [KEYS, SLITS, KEYS | SLITS], ids=["keys", "slits", "both"])
def test_the_meshed_surface_holds_the_sealed_volume(content):
    surface = sealed_body_surface(parsed(content))
    assert surface.is_watertight
    assert surface.body_count == 1
    assert_allclose(surface.volume, sealed_volume_mm3(parsed(content)), rtol=1e-6)
    assert abs(surface.volume - sealed_volume_mm3(parsed({}))) > 50, "a shell without them differs"


def test_the_core_holds_the_silicone_at_its_keys():
    top, side, free = (11.0, 11.3, 14.5), (12.0, 11.3, 14.0), (11.0, 8.0, 14.5)
    points = np.array([top, side, free])
    assert touches_core(points, parsed(KEYS)).tolist() == [True, True, False]
    assert touches_core(points, parsed({})).tolist() == [False, False, False]


@pytest.mark.slow
def test_slits_keep_a_press_off_the_neighbouring_face():
    """Mean |motion| of face 3 under pressures on face 1, over that of face 1 itself.

    Measured on this mesh: 0.27 without slits, 0.20 with slits 5 mm deep.
    """
    shares = []
    for depth in (0.0, 5.0):
        content = {
            "mesh": {
                "edge_mm": 6.0,
                "surface_edge_mm": 3.0,
                "rim_edge_ratio": 1.0,
            }
        }
        spec = parsed(content | {"shell": {"slits": {"depth_mm": depth}}})
        mesh = tetrahedralize(spec)
        require_quality(mesh_quality(mesh, spec))
        response = build_response(mesh, spec)
        own, other = response.face_loads(0), response.face_loads(2)
        motion = abs(response.compliance[own])
        shares.append(motion[:, other].mean() / motion[:, own].mean())
    assert shares[1] < 0.85 * shares[0]
