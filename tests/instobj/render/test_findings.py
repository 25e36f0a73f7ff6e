"""From where parts with findings are looked at."""

import numpy as np
import pytest
import trimesh

from instobj.render.findings import viewing_direction


def plate(turn_deg, edges=(70.0, 16.0, 110.0)):
    turn = trimesh.transformations.rotation_matrix(np.deg2rad(turn_deg), [0, 0, 1])
    return trimesh.creation.box(edges, transform=turn)


@pytest.mark.parametrize("turn_deg", [0.0, 20.0, 45.0, 110.0])
@pytest.mark.parametrize("side", [1, -1])
def test_a_long_flat_part_is_looked_at_across_from_the_side_of_the_place(turn_deg, side):
    """Halves of a capsule's mould, which part between two edges of their block, were drawn edge-on."""
    angle = np.deg2rad(turn_deg)
    normal = side * np.array([-np.sin(angle), np.cos(angle), 0.0])
    along = np.array([np.cos(angle), np.sin(angle), 0.0])
    mesh, place = plate(turn_deg), 8.0 * normal + 20.0 * along
    towards = viewing_direction(mesh, place)
    assert np.linalg.norm(towards) == pytest.approx(1)
    assert towards @ normal > 0.75
    if turn_deg == 45.0:
        by_the_box = np.sign(place + 1e-9) * [0.8, 0.9, 0.55]
        assert abs(by_the_box / np.linalg.norm(by_the_box) @ normal) < 0.75, "as it was"


def test_a_block_is_looked_at_over_the_object_s_axes():
    towards = viewing_direction(plate(0.0, (50.0, 50.0, 50.0)), np.array([25.0, 10.0, -10.0]))
    expected = np.array([0.8 * 1.7, 0.9, -0.55])
    assert towards == pytest.approx(expected / np.linalg.norm(expected))
