"""Parts of bodies that are known by their triangles, where their shape is no room's."""

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.build.export import write_part
from design.build.parts import Part
from design.errors import InputError
from design.fabrication.check import check_solid
from design.layout.core_hold import core_outlet
from design.solids import sampled
from design.solids.sampled import sampled_core_part
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec
from tests.support.scans import YCB


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


BRICK = YCB / "YcbFoamBrick.obj"


@pytest.mark.skipif(not BRICK.is_file(), reason=f"the scan {BRICK} is not on this machine")
def test_wire_holes_of_opposite_faces_meet_past_the_centre():
    """Holes that ended at the centre met in a circle: `check` passed, `build` refused the open surface."""
    near, far = (
        [[7.59, 0.0], [-3.8, 12.83], [-3.8, -12.83]],
        [[7.92, 0.0], [-3.96, 13.39], [-3.96, -13.39]],
    )
    body = {"kind": "imported", "scale": 1000.0, "sensed_faces": [3, 5]} | body_of_file(
        BRICK, 1000.0
    )
    sensors = {"count_per_face": 3, "radius_mm": 7.59, "positions_mm": [near, far]}
    core = {"recess_inner_radius_mm": 4.34, "recess_outer_radius_mm": 10.84}
    core |= {"wire_hole_side_diameter_mm": 3.0}
    content = {"name": "brick", "body": body, "sensors": sensors, "core": core}
    spec = ObjectSpec.model_validate(content | {"magnets": {"positions_mm": [[0.0, 0.0]]}})
    findings, _ = check_solid("core", sampled_core_part(spec), spec)
    assert {finding.check: finding.status for finding in findings}["closed surface"] == "pass"


def test_a_surface_that_closes_in_double_precision_alone_is_refused_by_check_and_build(tmp_path):
    """Two edges 1e-7 mm apart are one in the single precision of an STL, with four triangles."""
    corners = (
        [[0, 0, 0], [10, 10, 10]],
        [[10 + 1e-7, 10, 0], [20, 20, 10]],
        [[0, 0, 10], [20, 20, 12]],
    )
    boxes = [trimesh.creation.box(bounds=np.array(one, float)) for one in corners]
    touching = trimesh.boolean.union(boxes, engine="manifold")
    assert touching.is_watertight
    assert touching.body_count == 1
    spec = body_spec("ellipsoid")
    findings, mesh = check_solid("mould_half_a", touching, spec)
    closed = next(finding for finding in findings if finding.check == "closed surface")
    assert (closed.status, mesh) == ("fail", None)
    assert "mould.parting_azimuth_deg" in closed.what
    with pytest.raises(InputError, match="is not closed"):
        write_part(Part("mould_half_a", lambda: touching), touching, tmp_path, spec)
