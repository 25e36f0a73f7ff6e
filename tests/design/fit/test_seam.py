"""What a mould's seam does is told before anything is built, by hand, with a seam that does not."""

import re

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.build.parts import Part
from design.fabrication.printing import check_walls
from design.fit import seam
from design.fit.seam import seam_in_words
from design.layout.mould.frame import mould_frame, undercut_depth_mm, up
from design.layout.mould.pouring import pour_holes
from design.spec.object import ObjectSpec


def cylinder(place, **mould):
    """A closed cylinder whose upper magnet stands at a place, its seam across x."""
    content = {
        "name": "cylinder",
        "body": {
            "kind": "cylinder",
            "size_mm": [46.0, 46.0, 46.0],
            "open_faces": [],
            "sensed_faces": [1],
        },
        "shell": {"pocket_diameter_mm": 6.0},
        "magnets": {"positions_mm": [place]},
        "mould": {"style": "split", "parting_azimuth_deg": 0.0, **mould},
    }
    return ObjectSpec.model_validate(content)


def pad(azimuth_deg):
    content = {
        "name": "pad",
        "body": {"kind": "pad", "size_mm": [30.7, 44.3, 13.4]},
        "shell": {"thickness_mm": 8.0},
        "magnets": {"positions_mm": [[-9.0, -3.0]]},
        "mould": {"style": "split", "parting_azimuth_deg": azimuth_deg},
    }
    return ObjectSpec.model_validate(content)


@pytest.mark.parametrize(
    ("away_mm", "thin"), [(3.7, True), (4.1, False), (3.05, False), (0.0, False)]
)
def test_a_thin_wall_beside_a_pin_is_told_with_its_place(away_mm, thin):
    """A pin of 3 mm, whose head rests on the outside, beside a seam across x, through the middle; one on it
    is cut in half, and of one that it cuts near its side wedges are left."""
    spec = cylinder([away_mm, 9.0])
    wall = away_mm - 3.0 - spec.printer.clearance_mm
    assert (0 < wall < spec.printer.wall_mm) is thin
    told = seam_in_words(spec)
    assert len(told) == thin
    for text in told:
        assert f"a wall of {wall:.2g} mm beside the hole for the pin of" in text
        place = [float(x) for x in re.findall(r"at \((.*?)\),", text)[0].split(", ")]
        assert place[:2] == pytest.approx([wall, 9.0], abs=0.06)
        assert place[2] >= 23
        better = float(re.findall(r"parting_azimuth_deg = (\d+)", text)[0])
        assert seam_in_words(cylinder([away_mm, 9.0], parting_azimuth_deg=better)) == []


def test_a_thin_wall_of_a_half_names_the_seam_that_has_none():
    """`check --fabrication` named the key alone."""
    wall = trimesh.creation.box((20.0, 20.0, 0.4))
    (thin,) = check_walls(Part("mould_half_a", lambda: wall), wall, cylinder([3.7, 9.0]))
    assert thin.status == "fail"
    better = float(re.findall(r"mould\.parting_azimuth_deg = (\d+)\)", thin.what)[0])
    turned = cylinder([3.7, 9.0], parting_azimuth_deg=better)
    assert seam_in_words(turned) == []
    (alike,) = check_walls(Part("mould_half_a", lambda: wall), wall, turned)
    assert "(mould.parting_azimuth_deg)" in alike.what, "this seam is not why it is thin"


def test_a_pouring_hole_that_leaves_a_thin_wall_wherever_it_goes_is_told_with_a_seam_that_does_not(
    monkeypatch,
):
    """Of random design 7052 a wall of 0.14 mm beside one was told by nothing before it was built."""
    azimuth = lambda spec: spec.mould.parting_azimuth_deg  # noqa: E731
    monkeypatch.setattr(seam, "hole_thins_the_seam", lambda spec, hole: azimuth(spec) != 177.0)
    spec = cylinder([0.0, 9.0])
    (told,) = seam_in_words(spec)
    (hole,), rim = pour_holes(spec), mould_frame(spec).rim_mm
    assert "they leave a wall thinner than 0.8 mm to the seam" in told
    place = np.array([float(x) for x in re.findall(r"as at \((.*?)\)", told)[0].split(", ")])
    assert np.linalg.norm(np.cross(place - hole.top_mm, up(spec))) == pytest.approx(0, abs=0.1)
    assert max(abs(place)) == pytest.approx(rim, abs=0.06), "where it leaves the block"
    assert told.endswith("mould.parting_azimuth_deg = 177 does without")
    assert seam_in_words(cylinder([0.0, 9.0], parting_azimuth_deg=177.0)) == []


def test_a_seam_between_the_steps_is_named_where_no_step_does_without(monkeypatch):
    """`new` found seams in windows between pins where `check` said that there was none."""
    clear = (51.5, 53.5)
    free = lambda spec: clear[0] < spec.mould.parting_azimuth_deg < clear[1]  # noqa: E731
    monkeypatch.setattr(seam, "hole_thins_the_seam", lambda spec, hole: not free(spec))
    monkeypatch.setattr(seam, "pins_thin_the_seam", lambda spec: not free(spec))
    (told,) = seam_in_words(cylinder([0.0, 9.0]))
    assert clear[0] < float(re.findall(r"azimuth_deg = ([\d.]+) does without", told)[0]) < clear[1]


def test_a_seam_that_is_not_along_a_pad_s_sides_hooks():
    """Random design 7009: of each end wall the part beyond the seam stands in the way of its half."""
    spec, lean = pad(173.47), np.tan(np.deg2rad(180 - 173.47))
    hooked = (30.7 / 2 - 44.3 / 2 * lean) * lean
    assert undercut_depth_mm(spec) == pytest.approx(hooked, rel=0.02)
    (told,) = seam_in_words(spec)
    assert f"hook the body by about {hooked:.2g} mm, and the silicone gives way by 0.16 mm" in told
    assert told.endswith("mould.parting_azimuth_deg = 0 does without")
    assert seam_in_words(pad(0.0)) == []


def slit_box(**mould):
    """A closed cube with one slit, along the edge between +x and +y."""
    content = {
        "name": "box",
        "body": {"kind": "box", "size_mm": [42.0] * 3, "open_faces": [], "sensed_faces": [3, 4]},
        "shell": {"slits": {"depth_mm": 2.4}},
        "mould": mould,
    }
    return ObjectSpec.model_validate(content)


@pytest.mark.parametrize(
    ("azimuth_deg", "hooked_mm"),
    [(45.0, 0.0), (42.0, 2.4 * np.tan(np.deg2rad(3))), (27.0, 2.4 * np.tan(np.deg2rad(18)))],
)
def test_fins_of_slits_hook_unless_they_lie_along_the_pull(azimuth_deg, hooked_mm):
    """Random design 7120, a closed box: by hand, the depth of a slit times the tangent of its angle to the
    pull, where 2 % of 8 mm give way."""
    told = [
        one for one in seam_in_words(slit_box(parting_azimuth_deg=azimuth_deg)) if "fins" in one
    ]
    assert len(told) == (hooked_mm > 0.16)
    for text in told:
        assert f"1 of 1 slits hook the halves of the mould, as by about {hooked_mm:.2g} mm" in text
        assert text.endswith("mould.parting_azimuth_deg = 45 does without")


def test_fins_that_no_seam_frees_are_told_with_a_mould_that_does():
    """Halfway between four sides two lie in the seam that the two others are drawn along."""
    body = {"kind": "cylinder", "size_mm": [40.0, 40.0, 50.0]}
    shell = {"slits": {"depth_mm": 3.0, "width_mm": 0.8}}
    content = {"name": "cylinder", "body": body, "shell": shell, "mould": {"style": "split"}}
    (told,) = seam_in_words(ObjectSpec.model_validate(content))
    assert "2 of 4 slits hook" in told
    assert told.endswith('cut the slits after casting, or choose mould.style = "one-piece"')


def test_where_nothing_is_moulded_in_halves_nothing_is_told():
    assert seam_in_words(cylinder([3.7, 9.0], style="one-piece")) == []
    assert seam_in_words(cylinder([3.7, 9.0]).changed(silicone={"cure": "none"})) == []


def tilted_block(folder, tilt_deg):
    """A block of 50 × 40 × 60 mm from a file, turned in it about x and y, so that no level way frees it."""
    block = trimesh.creation.box((50.0, 40.0, 60.0)).subdivide().subdivide()
    for axis in ([1, 0, 0], [0, 1, 0]):
        turn = trimesh.transformations.rotation_matrix(np.deg2rad(tilt_deg), axis)
        block.apply_transform(turn)
    block.export(folder / f"block_{tilt_deg:g}.stl")
    body = {"kind": "imported", "sensed_faces": [3]}
    body |= body_of_file(folder / f"block_{tilt_deg:g}.stl")
    content = {"name": "block", "body": body, "magnets": {"positions_mm": [[0.0, 0.0]]}}
    return ObjectSpec.model_validate(content)


def test_a_file_s_body_that_every_seam_hooks_is_told_by_check(tmp_path):
    """`check` called the foam brick valid; `check --fabrication` failed, and named a seam that it has not."""
    spec = tilted_block(tmp_path, 20.0)
    assert undercut_depth_mm(spec) > 1
    (text,) = [one for one in seam_in_words(spec) if "hook the body" in one]
    assert "check --fabrication fails on it" in text
    assert "turn the body in its file" in text
    assert "parting_azimuth_deg" not in text
    straight = tilted_block(tmp_path, 0.0)
    assert not [one for one in seam_in_words(straight) if "hook" in one]
