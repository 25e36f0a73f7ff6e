"""Lists of poses against the faces' frames."""

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.layout.body import face_frame
from design.spec_io import load_spec
from instobj.bench.rig.command import RigOptions, rig
from instobj.bench.rig.plan import PressSettings, face_places, press_plan


def test_poses_touch_the_surface_and_press_along_its_normal(tmp_path):
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[contact_grid]\ncount = [3, 3]\n')
    out = tmp_path / "poses.json"
    found = rig(RigOptions(path, "poses", out, reference_every=0), lambda _: False)
    spec, document = load_spec(path), json.loads(out.read_text())
    assert found["presses"] == 5 * 9
    assert set(document["frames"]) == {"object", "tool", "pose", "depth_mm"}
    for pose in document["poses"]:
        frame = face_frame(spec, pose["face"])
        tool = Rotation.from_quat([pose[f"quaternion_{axis}"] for axis in "xyzw"]).as_matrix()
        assert np.allclose(tool[:, 2], -frame.normal, atol=1e-5)
        assert np.allclose(tool[:, 0], frame.x, atol=1e-5)
        at = np.array([pose[f"object_{axis}_mm"] for axis in "xyz"])
        local = (at - frame.centre_mm) @ frame.axes
        assert np.allclose(local, [pose["x_mm"], pose["y_mm"], -pose["depth_mm"]], atol=1e-3)
    stops = [pose["stop"] for pose in document["poses"][:8]]
    assert stops == ["above", "near", *["press"] * 4, "surface", "above"]


def test_poses_on_a_ball_lie_as_far_along_it_as_their_places_tell(tmp_path):
    path, out = tmp_path / "ball.toml", tmp_path / "poses.json"
    path.write_text(
        'name = "ball"\n[body]\nkind = "sphere"\nsize_mm = [44, 44, 44]\nbore_mm = 8\n'
        "sensed_faces = [3]\n[contact_grid]\ncount = [5, 3]\npitch_mm = 3.0\n"
        "[magnets]\npositions_mm = [[0, 0]]\n[sensors]\npositions_mm = [[0, 0]]\nradius_mm = 3.5\n"
        "package_mm = [6.6, 3.0, 1.6]\n"
        "[core]\nrecess_inner_radius_mm = 2.0\nrecess_outer_radius_mm = 5.0\n"
    )
    rig(RigOptions(path, "poses", out, reference_every=0), lambda _: False)
    frame, seen = face_frame(load_spec(path), 3), set()
    for pose in json.loads(out.read_text())["poses"]:
        place = np.array([pose["x_mm"], pose["y_mm"]])
        tool = Rotation.from_quat([pose[f"quaternion_{axis}"] for axis in "xyzw"]).as_matrix()
        out_of_it = -tool[:, 2]
        assert np.allclose(
            out_of_it @ np.column_stack([frame.x, frame.y]), np.sin(place / 22), atol=1e-5
        )
        at = np.array([pose[f"object_{axis}_mm"] for axis in "xyz"])
        assert np.allclose(at, (22 - pose["depth_mm"]) * out_of_it, atol=1e-3)
        seen.add(tuple(place.tolist()))
    assert seen == {(x, y) for x in (-6.0, -3.0, 0.0, 3.0, 6.0) for y in (-3.0, 0.0, 3.0)}


def test_unknown_kinds_of_lists_and_machines_are_refused(tmp_path):
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n')
    with pytest.raises(InputError, match=r"\.csv or \.json"):
        rig(RigOptions(path, "poses", tmp_path / "poses.txt"), lambda _: False)
    with pytest.raises(InputError, match="--machine 'ender' is not known"):
        rig(RigOptions(path, "ender"), lambda _: False)
    with pytest.raises(InputError, match=r"a stop would wait for a network.*--machine marlin"):
        rig(RigOptions(path, "octoprint"), lambda _: True)


def test_every_place_is_pressed_once_per_round_with_returns_to_the_middle(tmp_path):
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[contact_grid]\ncount = [3, 5]\n')
    spec = load_spec(path)
    plan = press_plan(spec, 2, PressSettings((1.0,)), seed=4, repeats=2, reference_every=7)
    chosen = [xy for xy, back in zip(plan.places_mm, plan.reference, strict=True) if not back]
    grid = sorted(map(tuple, face_places(spec, 2).tolist()))
    assert sorted(chosen[:15]) == sorted(chosen[15:]) == grid
    assert chosen[:15] != grid
    assert [k for k, back in enumerate(plan.reference) if back] == [0, 8, 16, 24, 32, 35]
    assert all(plan.places_mm[k] == (0.0, 0.0) for k, back in enumerate(plan.reference) if back)
    other = press_plan(spec, 2, PressSettings((1.0,)), seed=5, repeats=2, reference_every=7)
    assert other.places_mm != plan.places_mm


def test_few_places_are_pressed_in_strokes_that_options_change(tmp_path):
    path, out = tmp_path / "cube.toml", tmp_path / "poses.json"
    path.write_text('name = "cube"\n[contact_grid]\ncount = [3, 3]\npitch_mm = 5.0\n')

    def stops(*settings):
        given = {"faces": (3,), "presses": 2, "reference_every": 0}
        few = {"strokes": 9, "stroke_speed_mm_s": 2.0, "depths_mm": (3.0,)} | dict(settings)
        rig(RigOptions(path, "poses", out, settings=tuple(few.items()), **given), lambda _: False)
        poses = [pose for pose in json.loads(out.read_text())["poses"] if pose["press"] == 0]
        return [(pose["stop"], pose["depth_mm"], pose["speed_mm_s"]) for pose in poses]

    again = [("clear", -0.5, 0.0), ("press", 3.0, 2.0)]
    down = [("above", -5.0, 0.0), ("near", -1.0, 0.0), ("press", 3.0, 1.0)]
    assert stops() == [*down, *8 * again, ("above", -5.0, 0.0)]
    two = [*down[:2], ("press", 2.0, 1.0), again[0], ("press", 2.0, 2.0), ("above", -5.0, 0.0)]
    assert stops(("strokes", 2), ("depths_mm", (2.0,))) == two
