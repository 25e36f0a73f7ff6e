"""Distance to the side walls of rigid bodies, along which meshes are fine."""

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.mesh.edge_lengths import wall_distance_mm


def test_walls_end_at_the_rims():
    spec = ObjectSpec.model_validate({"name": "one", "magnets": {"positions_mm": [[0.0, 0.0]]}})
    layout = shell_body_layout(spec)
    radius, top = layout.bodies[0].outline.half_mm[0], layout.bodies[0].height_mm / 2
    local = [
        *([radius + 2.0, 0.0, 0.3 * top], [0.0, radius, top + 1.5], [radius + 3.0, 0.0, top + 4.0]),
        *([0.0, -radius, -top - 0.5], [0.0, 0.0, 0.0]),
    ]
    points = layout.centre_mm[0] + np.array(local) @ layout.frame[0].T
    assert_allclose(wall_distance_mm(layout, points), [2.0, 1.5, 5.0, 0.5, radius])
