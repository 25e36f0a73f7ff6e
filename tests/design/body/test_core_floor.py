"""The floor of a core that is known by its triangles."""

import pytest
import trimesh

from design.body.kinds import offset
from design.body.kinds.ellipsoid import Ellipsoid


def test_of_several_floors_below_the_middle_the_lowest_is_the_core_s(monkeypatch):
    boxes = [trimesh.creation.box((4.0, 4.0, 2.0)).apply_translation((0, 0, z)) for z in (-3, -7)]
    monkeypatch.setattr(offset, "sampled_core", lambda kind: trimesh.util.concatenate(boxes))
    assert Ellipsoid.core_floor_mm.fget(None) == pytest.approx(-8.0)


def test_a_bore_reaches_the_core_above_feet_beside_it(monkeypatch):
    """A turned box of 70 × 104 × 91 mm leaves its −z axis 18 mm below the middle and reaches 37 mm down:
    the bore ended below the core, and 89 mm³ of silicone stood in its rod's way (random design 56)."""
    seat = trimesh.creation.box(bounds=[[-20, -20, -12], [20, 20, 20]])
    foot = trimesh.creation.box(bounds=[[10, -20, -40], [20, 20, -10]])
    core = seat.union(foot)
    monkeypatch.setattr(offset, "sampled_core", lambda _: core)
    body = Ellipsoid((60.0, 60.0, 96.0), 8.0, 0.1, opened=(6,), bore_mm=8.0)
    assert body.core_floor_mm == pytest.approx(-12.0)
    hollow = body.with_bore(core)
    assert hollow.volume - core.volume == pytest.approx(3.1416 * 16 * (49 - 12), rel=0.02)
