"""Grooves of a file's body that are finer than the grid on which it is sampled, told and refused."""

import re

import numpy as np
import pytest
import tomli_w
import trimesh

from design.body.roughness import roughness
from design.fit.roughness import check_roughness, rough_patches, roughness_in_words
from design.layout.body import body_of
from design.spec_io import load_spec
from tests.support.cli import assert_one_clear_error, run

RADIUS_MM, HEIGHT_MM, WIDTH_MM, PITCH_MM = 30.0, 60.0, 0.3, 6.0


def lump(folder, depth_mm, levels=(-2, -1, 0, 1, 2)):
    """Specification of a drum with grooves of 0.3 mm round it, magnets between them."""
    half, profile = HEIGHT_MM / 2, [(0.0, -HEIGHT_MM / 2), (RADIUS_MM - 2, -HEIGHT_MM / 2)]
    for level in np.array(levels) * PITCH_MM:
        low, high = level - WIDTH_MM / 2, level + WIDTH_MM / 2
        profile += [(RADIUS_MM, low), (RADIUS_MM - depth_mm, low + 1e-3)]
        profile += [(RADIUS_MM - depth_mm, high - 1e-3), (RADIUS_MM, high)]
    profile += [(RADIUS_MM - 2, half), (0.0, half)]
    drum = trimesh.creation.revolve(np.array(profile), sections=60)
    drum.merge_vertices()
    file = f"drum_{depth_mm:g}.stl"
    drum.export(folder / file)
    content = {
        "name": "drum",
        "body": {"kind": "imported", "file": file, "sensed_faces": [3], "bore_mm": 10.0},
        "sensors": {"count_per_face": 1, "radius_mm": 8.0},
        "magnets": {"positions_mm": [[3.0, 0.0], [-3.0, 9.0]]},
        "contact_grid": {"count": [3, 3], "pitch_mm": 3.0},
    }
    path = folder / "drum.toml"
    path.write_text(tomli_w.dumps(content))
    return path


def load_rough(path):
    """The specification, whose roughness need not be allowed."""
    return load_spec(path, ["silicone.thinnest_wall_mm=5"])


def test_the_floor_of_every_groove_is_found(tmp_path):
    depth_mm = 0.7
    found = roughness(body_of(load_rough(lump(tmp_path, depth_mm))), 3)
    floor = np.hypot(*found.points_mm.T[:2]) < RADIUS_MM - depth_mm + 0.05
    levels = np.unique(np.round(found.points_mm[floor, 2] / PITCH_MM))
    assert set(levels) >= {-2, -1, 0, 1, 2}
    assert 0.7 * depth_mm < found.off_mm[floor].max() < 2 * depth_mm


def test_a_smooth_surface_has_none(tmp_path):
    spec = load_rough(lump(tmp_path, 0.01))
    assert len(roughness(body_of(spec), 3).off_mm) == 0
    assert not [*check_roughness(spec), *roughness_in_words(spec), *rough_patches(spec)]


def test_grooves_are_told_up_to_half_the_thinnest_silicone_and_refused_beyond(tmp_path):
    words = "face 3 has grooves or ridges finer than the grid on which its surface is sampled"
    with pytest.warns(UserWarning, match=words) as warned:
        told = run("check", lump(tmp_path, 0.35), cwd=tmp_path)
    assert told.returncode == 0, told.stderr
    (text,) = [str(one.message) for one in warned if words in str(one.message)]
    off, *place = map(
        float, re.search(r"up to (\S+) mm off, as at \((.*), (.*), (.*)\)", text).groups()
    )
    assert 0.2 < off < 0.5
    assert np.hypot(*place[:2]) == pytest.approx(RADIUS_MM, abs=0.6)
    refused = run("check", lump(tmp_path, 1.0), cwd=tmp_path)
    assert_one_clear_error(
        refused, words, "0.5 mm, half of silicone.thinnest_wall_mm, are", "Smooth the surface"
    )


def test_grooves_beside_what_is_used_do_not_matter(tmp_path):
    """By hand: magnets and locations reach 7.5 mm along the drum, its grooves begin at 12."""
    spec = load_spec(lump(tmp_path, 1.0, levels=(-2, 2)))
    assert rough_patches(spec), "there are grooves on the face"
    assert not [*check_roughness(spec), *roughness_in_words(spec)]
