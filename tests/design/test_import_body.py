"""Bodies from files: STL and STEP, repaired with a warning or refused with the reason."""

import warnings
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.errors import InputError
from design.import_body import body_of_file
from design.layouts import core_frames, face_frames, magnet_layout
from design.sampled_body import measured_distance_mm, sampled_core
from design.sampled_parts import sampled_core_part, sampled_shell
from design.spec_io import load_spec, parse_spec

TEXT = """
name = "pebble"
[body]
kind = "imported"
file = "{file}"
sensed_faces = [1, 3]
[magnets]
positions_mm = [[0, 0]]
[sensors]
positions_mm = [[0, 0]]
[core]
recess_inner_radius_mm = 1.0
recess_outer_radius_mm = 4.0
[contact_grid]
count = [3, 3]
pitch_mm = 3.0
"""
SIZE = (52.0, 46.0, 50.0)


def _pebble(subdivisions: int = 4) -> trimesh.Trimesh:
    """An ellipsoid off the origin."""
    surface = trimesh.creation.icosphere(subdivisions, 0.5)
    surface.apply_scale(SIZE / surface.extents)
    surface.apply_translation((7.0, -4.0, 2.0))
    return surface


def _load(folder: Path, name: str, **overrides: str):
    (folder / "pebble.toml").write_text(TEXT.format(file=name))
    return load_spec(folder / "pebble.toml", [f"{k}={v}" for k, v in overrides.items()])


@pytest.fixture(scope="module")
def pebble(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pebble")
    _pebble().export(folder / "pebble.stl")
    return _load(folder, "pebble.stl")


def test_the_size_is_that_of_the_file_and_the_body_is_centred(pebble):
    assert_allclose(pebble.body.size_mm, SIZE, rtol=1e-5)
    top, side = face_frames(pebble)
    assert_allclose(top.centre_mm, [0, 0, 25], rtol=0, atol=0.05)
    assert_allclose(side.centre_mm, [26, 0, 0], rtol=0, atol=0.05)


def test_magnets_stand_normal_to_the_sampled_surface(pebble):
    axis = magnet_layout(pebble).axis
    assert_allclose(axis, [[0, 0, 1], [1, 0, 0]], rtol=0, atol=0.01)
    inner = core_frames(pebble)[0]
    assert_allclose(inner.centre_mm, [0, 0, 17], rtol=0, atol=0.06)


def test_the_wall_measures_its_thickness_and_the_parts_are_closed(pebble):
    wall = -measured_distance_mm(pebble, np.asarray(sampled_core(pebble).vertices))
    assert 7.9 < wall.min() <= wall.max() < 8.1
    for part in (sampled_shell(pebble), sampled_core_part(pebble)):
        assert part.is_watertight
        assert part.volume > 5000


def test_a_step_file_gives_the_same_body(tmp_path):
    solid = cq.Workplane().box(40, 44, 48).edges().fillet(16).val()
    solid.exportStep(str(tmp_path / "brick.step"))
    spec = _load(tmp_path, "brick.step")
    assert_allclose(spec.body.size_mm, (40, 44, 48), rtol=0, atol=0.05)


def test_a_small_hole_is_closed_with_a_warning(tmp_path):
    surface = _pebble(3)
    surface.update_faces(np.arange(len(surface.faces)) != 5)
    surface.export(tmp_path / "holed.stl")
    with pytest.warns(UserWarning, match="closed small holes with 1 triangles"):
        assert_allclose(body_of_file(tmp_path / "holed.stl")["size_mm"], SIZE, rtol=1e-5)


def test_a_surface_turned_inside_out_is_turned_back(tmp_path):
    surface = _pebble(3)
    surface.invert()
    surface.export(tmp_path / "inverted.stl")
    with pytest.warns(UserWarning, match="turned triangles outwards"):
        body_of_file(tmp_path / "inverted.stl")


def _halved(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.update_faces(surface.triangles_center[:, 2] < surface.centroid[2])
    return surface


def _crossing(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """One closed surface that runs through itself: its top is pushed out at the bottom."""
    points = surface.vertices - surface.bounds.mean(axis=0)
    points[:, 2] = np.where(points[:, 2] > 10, 10 - 3 * (points[:, 2] - 10), points[:, 2])
    return trimesh.Trimesh(points, surface.faces)


@pytest.mark.parametrize(
    ("name", "change", "wanted"),
    [
        ("half.stl", _halved, "is open: .* edges"),
        ("two.stl", lambda one: one + one.copy().apply_translation((99, 0, 0)), "2 separate"),
        ("crossing.stl", _crossing, "crosses itself"),
    ],
)
def test_surfaces_that_enclose_no_body_are_refused(tmp_path, name, change, wanted):
    change(_pebble(3)).export(tmp_path / name)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        with pytest.raises(InputError, match=wanted):
            body_of_file(tmp_path / name)


@pytest.mark.parametrize(
    ("name", "content"), [("text.stl", b"solid of nothing"), ("text.step", b"ISO-10303-21; end")]
)
def test_corrupt_files_are_refused(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match="Export"):
        body_of_file(tmp_path / name)


def test_a_missing_file_and_a_missing_name_are_told(tmp_path):
    with pytest.raises(InputError, match="no body at"):
        body_of_file(tmp_path / "nowhere.stl")
    with pytest.raises(InputError, match="goes with kind = 'imported'"):
        parse_spec({"name": "a", "body": {"kind": "imported"}}, "test")


def test_a_body_too_small_for_its_core_is_refused(tmp_path):
    small = _pebble(3)
    small.apply_scale(0.25)
    small.export(tmp_path / "small.stl")
    with pytest.raises(InputError, match=r"half the core|no room for a core|too small for a patch"):
        _load(tmp_path, "small.stl")
