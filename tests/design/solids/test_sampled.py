"""Parts of bodies that are known by their triangles, where their shape is no room's."""

import pytest

from design.errors import InputError
from design.layout.core_hold import core_outlet
from design.solids import sampled
from tests.support.objects.body_cases import body_spec


def test_a_core_of_walls_has_its_outlet_and_no_hollow_though_its_box_had_room(monkeypatch):
    """A mug from a file: `build` asked for a core 4.5 mm within its walls, and refused it."""

    def no_room(body):
        raise InputError("no room for a core")

    spec = body_spec("ellipsoid", body={"open_faces": [6], "bore_mm": 9.0})
    monkeypatch.setattr(sampled, "sampled_core", no_room)
    length, diameter = spec.body.size_mm[2] / 2, 2 * core_outlet(spec).radius_mm
    extents = sampled.hollow_mesh(spec).extents
    assert extents[2] == pytest.approx(length)
    assert diameter * 0.7 < min(extents[:2]) <= max(extents[:2]) <= diameter
