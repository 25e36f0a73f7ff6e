"""A whole build: golden geometry, files on disk, the manifest, and errors that users meet."""

import json
import subprocess
import sys
import time
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

import cadquery as cq
import pytest
import trimesh
from numpy.testing import assert_allclose

import design.solids.shell
from design.build.export import build_object
from design.build.manifest import BuildManifest
from design.build.parts import parts_of
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.pockets import shell_pockets
from design.spec.object import CoreSpec, MagnetSpec, ObjectSpec, ShellSpec
from design.spec_io import check, parse_spec, spec_hash
from tests.support.objects.golden_geometry import golden_geometry

PAPER = ObjectSpec(name="paper")
PART_NAMES = [part.name for part in parts_of(PAPER)]
GOLDEN = golden_geometry()["paper_cube"]["parts"]


@pytest.fixture(scope="module")
def build(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cad_out") / "paper"
    messages = []
    return folder, build_object(PAPER, folder, messages.append), messages


def assert_golden(part):
    """Compare a part of the manifest with its reference; a part without reference fails."""
    golden = GOLDEN[part.name]
    assert part.face_count == golden["faces"]
    assert_allclose(part.volume_mm3, golden["volume_mm3"], rtol=1e-8)
    assert_allclose(part.bounding_box_mm, golden["box_mm"], rtol=0, atol=1e-5)
    assert_allclose(part.centre_of_mass_mm, golden["centre_of_mass_mm"], rtol=0, atol=1e-5)


def test_the_manifest_has_every_part_in_order(build):
    assert [part.name for part in build[1].parts] == PART_NAMES


@pytest.mark.parametrize("name", PART_NAMES)
def test_golden_geometry(build, name):
    assert_golden(build[1].part(name))


def test_a_part_without_reference_fails(build):
    with pytest.raises(KeyError):
        assert_golden(replace(build[1].part("shell"), name="unheard_of"))


@pytest.mark.parametrize("name", PART_NAMES)
def test_stl_is_watertight_and_as_large_as_the_solid(build, name):
    folder, manifest, _ = build
    part, mesh = manifest.part(name), trimesh.load_mesh(folder / f"{name}.stl")
    assert part.solid_count == 1
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert part.stl_watertight
    assert len(mesh.faces) == part.stl_triangles
    assert_allclose(mesh.volume, part.stl_volume_mm3, rtol=1e-9)
    assert_allclose(mesh.volume, part.volume_mm3, rtol=2e-3)
    assert_allclose(mesh.bounds, part.bounding_box_mm, rtol=0, atol=0.02)


def test_shell_stl_is_within_a_twentieth_of_a_percent(build):
    shell = build[1].part("shell")
    assert_allclose(shell.stl_volume_mm3, shell.volume_mm3, rtol=5e-4)


@pytest.mark.parametrize("name", PART_NAMES)
def test_step_reads_back_as_the_same_solid(build, name):
    folder, manifest, _ = build
    shape = cq.importers.importStep(str(folder / f"{name}.step")).val()
    assert len(shape.Solids()) == 1
    assert_allclose(shape.Volume(), manifest.part(name).volume_mm3, rtol=1e-8)


def test_the_folder_holds_the_parts_and_the_manifest_only(build):
    folder, _, messages = build
    expected = {f"{name}.{kind}" for name in PART_NAMES for kind in ("stl", "step", "3mf")}
    assert {path.name for path in folder.iterdir()} == expected | {"manifest.json", "assembly.glb"}
    steps = [f"{doing} {name}" for doing in ("building", "writing") for name in PART_NAMES]
    assert messages[:-2] == steps
    assert messages[-1] == f"wrote {folder / 'manifest.json'}"


def test_a_second_build_is_the_same_byte_by_byte(build, tmp_path):
    """In one process, whose kernel counts its models, and with temporary files of other names."""
    folder, _, _ = build
    build_object(PAPER, tmp_path)
    names = sorted(path.name for path in folder.iterdir())
    assert sorted(path.name for path in tmp_path.iterdir()) == names
    assert {Path(name).suffix for name in names} >= {".step", ".stl", ".3mf", ".glb", ".json"}
    for name in names:
        assert (tmp_path / name).read_bytes() == (folder / name).read_bytes(), name


def test_manifest_on_disk_is_the_one_returned(build):
    folder, manifest, _ = build
    assert BuildManifest.read(folder) == manifest
    assert BuildManifest.from_json(manifest.to_json()) == manifest
    assert (manifest.name, manifest.spec_hash) == ("paper", spec_hash(PAPER))
    assert manifest.library_versions["cadquery"] == version("cadquery")
    content = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    assert content["parts"][1]["name"] == "shell"


@pytest.mark.parametrize(
    "text", ["{", "[]", "{}", '{"parts": [{}]}', '{"parts": [], "name": "a", "other": 1}']
)
def test_what_is_no_manifest_is_refused(text, tmp_path):
    (tmp_path / "manifest.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"manifest\.json is not a build manifest"):
        BuildManifest.read(tmp_path)


def test_a_folder_without_manifest_is_named(tmp_path):
    with pytest.raises(InputError, match=r"cannot read .*manifest\.json"):
        BuildManifest.read(tmp_path)


def test_an_unwritable_folder_is_an_input_error(tmp_path):
    blocked = tmp_path / "a_file"
    blocked.write_text("in the way", encoding="utf-8")
    with pytest.raises(InputError, match=r"cannot write .*a_file/paper.*writable folder"):
        build_object(PAPER, blocked / "paper")
    assert blocked.read_text(encoding="utf-8") == "in the way"


def test_an_interrupted_build_leaves_no_manifest(tmp_path):
    def stop_at_the_mould(message):
        if message == "writing mould_box":
            raise KeyboardInterrupt

    (tmp_path / "manifest.json").write_text("of an earlier build", encoding="utf-8")
    with pytest.raises(KeyboardInterrupt):
        build_object(PAPER, tmp_path, stop_at_the_mould)
    written = {f"{n}.{kind}" for n in ("core", "shell") for kind in ("stl", "step", "3mf")}
    assert {path.name for path in tmp_path.iterdir()} == written


def test_a_specification_without_valid_parts_leaves_the_folder_alone(tmp_path):
    (tmp_path / "manifest.json").write_text("of an earlier build", encoding="utf-8")
    unchecked = PAPER.model_copy(
        update={"core": CoreSpec(wire_hole_top_diameter_mm=60.0, wire_hole_side_diameter_mm=60.0)}
    )
    with pytest.raises(InputError, match="core must be one closed body"):
        build_object(unchecked, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["manifest.json"]


def test_pockets_that_touch_in_a_line_are_refused(tmp_path):
    touching = MagnetSpec(positions_mm=((0.0, 0.0), (6.0, 0.0)))
    with pytest.raises(InputError, match=r"positions_mm\[1\] = \(6, 0\) touch or overlap"):
        check(ObjectSpec(name="touching", magnets=touching))
    with pytest.raises(InputError, match="surface of shell is not closed"):
        build_object(PAPER.model_copy(update={"magnets": touching}), tmp_path)
    assert not (tmp_path / "shell.stl").exists()
    assert not (tmp_path / "manifest.json").exists()


def test_golden_geometry_catches_a_lost_face(tmp_path, monkeypatch):
    monkeypatch.setattr(design.solids.shell, "face_frames", lambda spec: face_frames(spec)[:4])
    monkeypatch.setattr(design.solids.shell, "shell_pockets", lambda spec: shell_pockets(spec)[:4])
    manifest = build_object(PAPER, tmp_path)
    with pytest.raises(AssertionError):
        assert_golden(manifest.part("shell"))


def test_spec_hash_tells_specifications_apart_and_equal_ones_alike():
    assert spec_hash(PAPER) == spec_hash(ObjectSpec(name="paper"))
    assert len(spec_hash(PAPER)) == 64
    for other in (
        ObjectSpec(name="paper2"),
        ObjectSpec(name="paper", seed=2),
        ObjectSpec(name="paper", shell=ShellSpec(pocket_depth_mm=2.999)),
    ):
        assert spec_hash(other) != spec_hash(PAPER)


def test_spec_hash_does_not_see_whether_a_default_was_written_out():
    written = parse_spec(
        {"name": "paper", "sensors": {"first_azimuth_deg": [240, 180.0, 240, 60, 300]}}, "test"
    )
    assert spec_hash(written) == spec_hash(PAPER)


def test_light_modules_load_no_cad_kernel():
    code = (
        "import sys, design.build.manifest, design.layout.tips, design.layout.volumes; "
        "import instobj.render.parts; "
        "print([m for m in ('cadquery', 'OCP', 'trimesh', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.slow
def test_the_papers_cube_is_built_and_written_in_five_seconds(tmp_path):
    build_object(PAPER, tmp_path / "warm")  # imports are not counted
    started = time.process_time()
    build_object(PAPER, tmp_path / "timed")
    assert time.process_time() - started < 5
