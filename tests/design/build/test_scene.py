"""3MF and GLB read back, and what jig and template are for."""

import json
import struct
import xml.etree.ElementTree as ET
import zipfile

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.build.scene import GLTF_FRAME, assembly_scene, write_glb
from design.build.slicer_file import write_3mf
from design.layout.boards import mounted_sensors, wire_bundle_mm
from design.layout.body import core_frames, face_frames
from design.layout.places.positions import sensor_layout
from design.solids.core import make_core
from design.solids.jig import make_jig
from design.solids.magnet_template import make_magnet_template, template_faces
from design.solids.shell import make_shell
from design.spec_io import parse_spec

MODEL = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def parsed(**content):
    return parse_spec({"name": "t", **content}, "test")


def read_3mf(path):
    with zipfile.ZipFile(path) as archive:
        root = ET.fromstring(archive.read("3D/3dmodel.model"))
    assert root.get("unit") == "millimeter"
    corners = [[float(v.get(a)) for a in "xyz"] for v in root.iter(f"{MODEL}vertex")]
    faces = [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in root.iter(f"{MODEL}triangle")]
    return trimesh.Trimesh(np.array(corners), np.array(faces), process=False)


def test_3mf_holds_the_mesh_in_millimetres(tmp_path):
    mesh = trimesh.creation.box(bounds=[(0, 0, 0), (3, 4, 5.5)])
    write_3mf(mesh, "a <part>", tmp_path / "part.3mf")
    back = read_3mf(tmp_path / "part.3mf")
    assert back.is_watertight
    assert_allclose(back.volume, 66, rtol=1e-9)
    assert_allclose(back.bounds, mesh.bounds, rtol=0, atol=1e-9)
    first = (tmp_path / "part.3mf").read_bytes()
    write_3mf(mesh, "a <part>", tmp_path / "part.3mf")
    assert (tmp_path / "part.3mf").read_bytes() == first


def test_glb_shows_every_magnet_with_its_poles_in_metres(tmp_path):
    spec = parsed(magnets={"positions_mm": [[0, 0], [8, 5]], "north": ["outward", "inward"]})
    body = trimesh.creation.box((42, 42, 42))
    write_glb(assembly_scene(spec, {"core": body, "shell": body}), tmp_path / "a.glb")
    scene = trimesh.load(tmp_path / "a.glb")
    assert_allclose(scene.extents, 0.042, rtol=1e-6)
    names = set(scene.geometry)
    assert sum(name.startswith("magnet_") for name in names) == 2 * 10
    assert sum(name.startswith("sensor_") for name in names) == 15

    def height(name):  # on face 1, which glTF's y axis points to
        placed = scene.geometry[name].copy().apply_transform(scene.graph.get(name)[0])
        return placed.bounds.mean(axis=0)[1]

    assert height("magnet_1_north") > height("magnet_1_south"), "north outward"
    assert height("magnet_2_north") < height("magnet_2_south"), "north inward"
    content = (tmp_path / "a.glb").read_bytes()
    length = struct.unpack("<I", content[12:16])[0]
    assert json.loads(content[20 : 20 + length])["asset"]["version"] == "2.0"


@pytest.mark.parametrize("chip", ["inward", "outward"])
def test_boards_lie_in_their_recesses_and_chips_where_they_sense(chip):
    spec = parsed(
        sensors={"chip": chip, "depth_below_core_face_mm": 0.6 if chip == "outward" else 2.3}
    )
    mounted, layout = mounted_sensors(spec), sensor_layout(spec)
    half = make_core(spec)
    for sensor, position in zip(mounted, layout.position_mm, strict=True):
        local = (position - sensor.chip.centre_mm) @ sensor.chip.axes
        assert (abs(local) < sensor.chip.half_mm + 1e-9).all(), "the sensing point is in the chip"
        frame = next(f for f in core_frames(spec) if f.number == sensor.face)
        top = frame.from_object(sensor.board.centre_mm)[2] + 0.8
        assert_allclose(top, 0.0 if chip == "inward" else -1.4, rtol=0, atol=1e-9)
        assert not half.isInside(cq.Vector(*sensor.board.centre_mm))


def test_wires_of_a_face_as_a_bundle():
    assert_allclose(wire_bundle_mm(parsed()), 0.4 * np.sqrt(12 / 0.7), rtol=1e-12)


def test_the_jig_holds_the_core_and_leaves_the_silicone_free():
    spec = parsed(body={"size_mm": [50.0, 46.0, 44.0]})
    jig, core, shell = make_jig(spec), make_core(spec), make_shell(spec)
    assert_allclose(jig.intersect(core).Volume(), 0, rtol=0, atol=1e-6)
    assert_allclose(jig.intersect(shell).Volume(), 0, rtol=0, atol=1e-6)
    for way in ((0.3, 0, 0), (0, -0.3, 0)):
        assert jig.intersect(core.translate(cq.Vector(*way))).Volume() > 1, "it must centre"
    assert jig.intersect(shell.translate(cq.Vector(0, 0, -0.2))).Volume() > 1, "the rim rests on it"
    open_below = cq.Vector(0, 0, jig.BoundingBox().zmin + 0.5)
    assert not jig.isInside(open_below), "wires leave through the post"


def test_the_template_opens_over_every_pocket_and_tells_poles_apart():
    magnets = {"positions_mm": [[3, -2], [-9, 8]], "north": ["outward", "inward"]}
    spec = parsed(body={"size_mm": [50.0, 46.0, 44.0]}, magnets=magnets)
    assert template_faces(spec) == {1: (1,), 2: (2, 4), 3: (3, 5)}
    other = parsed(body={"size_mm": [50.0, 46.0, 44.0]}, magnets=magnets | {"north": []})
    for face in (1, 2, 3):
        template = make_magnet_template(spec, face)
        frame = next(frame for frame in face_frames(spec) if frame.number == face)
        half = frame.half_extents_mm
        for x, y in magnets["positions_mm"]:
            assert not template.isInside(cq.Vector(x, y, 1.5))
        assert template.isInside(cq.Vector(-half[0] - 1, 0, -2)), "a lip finds the edge"
        assert not template.isInside(cq.Vector(half[0] - 0.5, half[1] - 0.5, 1.5)), "cut corner"
        bar = 2 * 1.05 * 0.9 * 0.8  # the second bar of +, less the crossing
        plus = make_magnet_template(other, face)
        assert_allclose(template.Volume() - plus.Volume(), bar, rtol=1e-6)


def test_the_glb_s_frame_is_a_turn_in_metres_with_y_up():
    turn = GLTF_FRAME[:3, :3] / 1e-3
    assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)
    assert_allclose(np.linalg.det(turn), 1)
    assert_allclose(GLTF_FRAME @ [0, 0, 1000, 1], [0, 1, 0, 1], atol=1e-12)
    assert_allclose(GLTF_FRAME @ [1000, 0, 0, 1], [1, 0, 0, 1], atol=1e-12)
    assert_allclose(GLTF_FRAME @ [0, 1000, 0, 1], [0, 0, -1, 1], atol=1e-12)
    assert_allclose(GLTF_FRAME @ [0, 0, 0, 1], [0, 0, 0, 1])
