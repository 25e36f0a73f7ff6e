"""The floor of a core that is known by its triangles."""

import pytest
import trimesh

from design.body.kinds import offset
from design.body.kinds.ellipsoid import Ellipsoid


def test_of_several_floors_below_the_middle_the_lowest_is_the_core_s(monkeypatch):
    boxes = [trimesh.creation.box((4.0, 4.0, 2.0)).apply_translation((0, 0, z)) for z in (-3, -7)]
    monkeypatch.setattr(offset, "sampled_core", lambda kind: trimesh.util.concatenate(boxes))
    assert Ellipsoid.core_floor_mm.fget(None) == pytest.approx(-8.0)
