"""Cheap solids and triangles of objects off their symmetries: volumes, middles and boxes, on record."""

import numpy as np
import pytest

from design.body.triangles import Block
from design.layout.body import face_frames
from design.layout.core_hold import locators
from design.layout.mould.frame import mould_frame
from design.layout.places.positions import board_places
from design.layout.pockets import shell_pockets
from design.solids import sampled
from design.solids.body import (
    cast_outer_solid,
    cavity_solid,
    core_hollow,
    core_solid,
    outer_solid,
    past_opening,
)
from design.solids.core import _cavity, _outlets, _sensor_recess, _wire_passage
from design.solids.curved_template import curved_template_faces, make_curved_template
from design.solids.jig import make_jig
from design.solids.magnet_template import make_magnet_template
from design.solids.primitives import (
    block_solid,
    pocket_prism,
    pocket_solid,
    radial_box_on_face,
    rod_about_z,
)
from design.solids.probes import make_probe
from design.spec.mechanics import IndenterSpec
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, of_solids

BODIES = ("box", "box open at a side", "pad", "cylinder", "sleeve", "capsule", "sphere", "dome")
TIPS = {
    "flat": {"kind": "flat", "radius_mm": 3.0, "fillet_mm": 0.8, "tilt_deg": [4.0, -6.0]},
    "cuboid": {"kind": "cuboid", "size_mm": [6.0, 4.0], "yaw_deg": 25.0, "tip_count": 3},
    "cylinder": {"kind": "cylinder", "radius_mm": 2.0, "length_mm": 7.0, "tilt_deg": [0.0, 5.0]},
    "stl": {"kind": "stl", "vertices_mm": [[0, 0, 0], [6, 0, 8], [-6, 5, 8], [-6, -5, 8]]},
}


@pytest.mark.parametrize("name", BODIES)
def test_bodies_and_cores_are_as_on_record(name):
    spec = worked(name)
    frame, places = board_places(spec)[0]
    room = outer_solid(spec)
    lines = [
        of_solids("outer", [room]),
        of_solids("cavity", [s for s in [cavity_solid(spec, 0.6)] if s is not None]),
        of_solids("core", [core_solid(spec)]),
        of_solids("hollow", core_hollow(spec)),
        of_solids("cast", [cast_outer_solid(spec)]),
        of_solids("cavity of the core", _cavity(spec)),
        of_solids("outlets", _outlets(spec)),
        of_solids("recess", [_sensor_recess(spec, frame, *places[1])]),
        of_solids("passages", [one for f in face_frames(spec) for one in _wire_passage(spec, f)]),
        of_solids("jig", [make_jig(spec)]),
    ]
    if mould_frame(spec).opening == "open":
        lines.append(of_solids("past", [past_opening(spec, room, mould_frame(spec), 0.3)]))
    assert_on_record("solids", name, lines)


@pytest.mark.parametrize("name", TIPS)
def test_probes_are_as_on_record(name):
    spec = worked("box").changed(indenter=IndenterSpec.model_validate(TIPS[name]))
    own = spec.indenter.tip_count
    probes = [make_probe(spec, tips) for tips in ((own,) if name == "flat" else (own, 2))]
    assert_on_record("probes", name, [of_solids("probe", [probe]) for probe in probes])


@pytest.mark.parametrize("name", ["box", "reverse box", "cylinder", "dome", "closed capsule"])
def test_templates_are_as_on_record(name):
    spec = worked(name)
    flat = spec.body.kind == "box"
    face = spec.body.sensed[-1]
    make = make_magnet_template if flat else make_curved_template
    lines = [of_solids("template", [make(spec, face)])]
    if not flat:
        lines.append(f"faces: {curved_template_faces(spec)}")
    assert_on_record("templates", name, lines)


def test_primitives_by_hand():
    spec = worked("box")
    frame = face_frames(spec)[2]
    plain, tilted = shell_pockets(spec)[2][0], shell_pockets(spec)[2][1]
    turned = radial_box_on_face(frame, 30.0, 2.0, (3.0, 7.0), (-1.5, 0.5))
    assert turned.Volume() == pytest.approx(4.0 * 2.0 * 2.0)
    middle = 5.0 * np.array([np.cos(np.pi / 6), np.sin(np.pi / 6)])
    np.testing.assert_allclose(
        turned.Center().toTuple(), frame.to_object(np.array([*middle, -0.5])), atol=1e-9
    )
    radius = plain.outline.radius_mm
    grown = pocket_prism(frame, plain, -1.0, 2.0, 0.3)
    assert grown.Volume() == pytest.approx(np.pi * (radius + 0.3) ** 2 * 3.0)
    drafted = pocket_prism(frame, plain, 0.0, 2.0, 0.0, 5.0)
    wide = radius + 2.0 * np.tan(np.deg2rad(5.0))
    cone = np.pi * 2.0 / 3 * (radius**2 + radius * wide + wide**2)
    assert drafted.Volume() == pytest.approx(cone, rel=1e-6)
    over = tilted.outline.area_mm2 * 0.5 / tilted.axis[2]
    assert pocket_solid(frame, tilted).Volume() == pytest.approx(tilted.volume_mm3 + over, rel=2e-2)
    cone = rod_about_z(2.0, -1.0, 3.0, 1.0)
    assert cone.Volume() == pytest.approx(np.pi * 4.0 / 3 * (4 + 2 + 1))
    one = Block(np.array([1.0, 2.0, 3.0]), frame.axes, np.array([1.0, 2.0, 4.0]))
    assert block_solid(one).Volume() == pytest.approx(64.0)
    box = block_solid(one).BoundingBox()
    np.testing.assert_allclose(
        [box.xmin, box.ymin, box.zmin], one.corners_mm.min(axis=0), atol=1e-6
    )


@pytest.mark.parametrize("name", ["closed capsule", "capsule", "reverse box"])
def test_triangles_of_parts_are_as_on_record(name):
    """Of bodies that are known by their triangles parts are made so; these bodies are exact, and quicker."""
    spec = worked(name)
    spec = spec.changed(core=spec.core.changed(wall_mm=14.0)) if name == "capsule" else spec
    frame, places = board_places(spec)[0]
    pockets = shell_pockets(spec)[0]
    flat = face_frames(spec)[0].tangent(pockets[1].body.centre_mm[:2])
    meshes = {
        "pocket": sampled._pocket(flat, pockets[1]),
        "recess": sampled._recess(spec, frame, *places[1]),
        "wire hole": sampled._wire_hole(spec, frame),
    }
    if name == "capsule":
        meshes["hollow"] = sampled._hollow(spec)
    for locator in locators(spec):
        meshes["hole of a pin"] = sampled._locator_hole(locator)
        if locator.socket is not None:
            meshes["socket"] = sampled._socket(locator.socket)
    assert_on_record("triangles", name, [of_solids(key, [mesh]) for key, mesh in meshes.items()])
