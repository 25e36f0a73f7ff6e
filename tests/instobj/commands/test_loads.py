"""Presses with small strain and grasps from the command line: places, refusals, files, figures."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import IndenterSpec, ObjectSpec
from fem.presses.joint import JointPress, Tip
from instobj.commands.presses.grasp import grasp_specification, unbalanced_moment_nmm
from instobj.commands.presses.loads import sensor_rows, superposition_row
from instobj.commands.presses.places import Place, check_places, jaw_given, places_given
from instobj.figures.loads import Pressed, draw_loads
from tests.support import cli
from tests.support.cli import CUBE

SPEC = ObjectSpec(name="cube")
COARSE = ["--set", "mesh.surface_edge_mm=2", "--set", "mesh.edge_mm=6"]


def joint(tips, depth, force):
    count = len(tips)
    return JointPress(
        tuple(tips),
        np.array(depth, float),
        np.array(force, float),
        np.zeros((count, 2)),
        np.ones(count),
        np.zeros((25, 6)),
    )


def test_places_are_read_and_pressed_2_mm_deep_unless_told():
    places = places_given(["3:5,-4", "1:0,2.5,0.7"])
    assert places == [
        Place(3, 5.0, -4.0, 2.0),
        Place(1, 0.0, 2.5, 0.7),
    ]
    assert jaw_given("5:-7.5,0;7.5,1") == [Place(5, -7.5, 0.0, 0.0), Place(5, 7.5, 1.0, 0.0)]


@pytest.mark.parametrize("text", ["3", "3:1", "x:1,2", "3:1,2,3,4", "3:nan,1", "3:1;2"])
def test_places_that_cannot_be_read_are_refused(text):
    with pytest.raises(InputError, match="FACE:X,Y"):
        places_given([text])


def test_no_place_at_all_is_refused():
    with pytest.raises(InputError, match="--at"):
        places_given([])


@pytest.mark.parametrize(
    ("place", "indenter", "words"),
    [
        (Place(6, 0.0, 0.0, 1.0), {}, "not sensed"),
        (Place(1, 21.1, 0.0, 1.0), {}, "lands at x = 21.1 mm"),
        (Place(1, 17.0, 0.0, 1.0), {"friction": "sticking"}, "misses the body"),
        (Place(1, 0.0, 0.0, 5.0), {}, "Press less deep"),
        (Place(1, 0.0, 0.0, -1.0), {}, "Press less deep"),
        (Place(1, 18.8, 0.0, 3.0), {"direction_deg": (40.0, 0.0)}, "misses the body"),
        (Place(1, 0.0, 0.0, 1.0), {"tip_count": 2, "radius_mm": 15.0}, "more than face 1"),
    ],
)
def test_one_bad_press_is_told_of_and_the_others_are_kept(place, indenter, words):
    spec = SPEC.model_copy(update={"indenter": IndenterSpec(**indenter)})
    with pytest.raises(InputError, match=words):
        check_places(spec, [place], to_depth=True)
    if indenter.get("tip_count") is None:
        fine = Place(4, 2.0, 3.0, 1.0)
        checked = check_places(spec, [place, fine], to_depth=True)
        assert checked.good == (fine,)
        (refused,) = checked.refused
        assert refused["press"] == str(place)


def test_places_on_a_ball_are_told_along_its_surface():
    """A quarter of a turn of R 25 mm is 39 mm; 18.5 mm along it are 16.9 mm in the plane."""
    body = {"kind": "sphere", "size_mm": [50.0] * 3, "sensed_faces": [1]}
    ball = ObjectSpec.model_validate({"name": "ball", "body": body})
    checked = check_places(
        ball, [Place(1, 18.5, 0.0, 1.0), Place(1, 23.0, 0.0, 1.0)], to_depth=True
    )
    assert checked.good == (Place(1, 18.5, 0.0, 1.0),)
    assert "misses the body" in checked.refused[0]["error"]
    assert "±26.18 mm" in checked.refused[0]["error"]


def test_superposition_is_compared_with_the_joint_press():
    tips = [Tip(1, -5.0, 0.0), Tip(1, 6.0, 1.0)]
    alone = [joint(tips[:1], [1], [2.0]), joint(tips[1:], [1], [2.5])]
    pressed = Pressed([], np.zeros((25, 6)), [joint(tips, [1, 1], [2.2, 2.8])], alone)
    changes = np.zeros((3, 2, 3))
    changes[0, 0], changes[1, 0], changes[2, 1, 2] = [30, 0, 0], [30, 0, 0], 3
    row = superposition_row(pressed, changes)
    assert_allclose(list(row.values()), [-10, 10, 3], rtol=1e-12)


def test_sensors_are_numbered_face_by_face():
    rows = sensor_rows(SPEC, np.arange(45.0).reshape(15, 3))
    assert [row["sensor"] for row in rows] == [1, 2, 3] * 5
    assert [row["face"] for row in rows[::3]] == [1, 2, 3, 4, 5]
    assert rows[4]["ΔY"] == 13.0


def test_jaws_beside_each_other_leave_a_moment():
    """10 N at y = 2 on face 3 (+x) and at y = −1 of the object on face 5: 30 N mm about z."""
    press = joint([Tip(3, 0.0, 2.0), Tip(5, 0.0, 1.0)], [1, 1], [10.0, 10.0])
    assert_allclose(unbalanced_moment_nmm(SPEC, press), [0, 0, 30], rtol=0, atol=1e-9)
    facing = joint([Tip(3, 0.0, 2.0), Tip(5, 0.0, -2.0)], [1, 1], [10.0, 10.0])
    assert_allclose(unbalanced_moment_nmm(SPEC, facing), 0, rtol=0, atol=1e-9)


def test_the_figure_is_drawn(tmp_path):
    tips = [Tip(1, -5.0, 0.0), Tip(1, 6.0, 1.0)]
    curve = [joint(tips, [0.5, 0.5], [1, 1.1]), joint(tips, [1, 1], [2.2, 2.8])]
    alone = [joint(tips[:1], [1], [2.0]), joint(tips[1:], [1], [2.5])]
    change = np.linspace(-90, 60, 45).reshape(15, 3)
    draw_loads(SPEC, Pressed([], np.zeros((25, 6)), curve, alone), change, tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("jaws", "overrides", "words"),
    [
        (["3:0,0"], [], "two jaws; got 1"),
        (["3:0,0", "1:0,0"], [], "not opposite"),
        (["3:0,0", "6:0,0"], [], "face 6 is not sensed"),
        (["3:0,0", "5:21.5,0"], [], "misses the body"),
        (["3:0,0", "5;0,0"], [], "FACE:X,Y"),
        (["3:0,0", "5:0,0"], ["indenter.friction=sticking"], "frictionless"),
        (["3:0,0", "5:0,0"], ["mechanics.slip.shift_mm=[1, 0, 0]"], "no slip"),
    ],
)
def test_grasps_that_make_no_sense_are_refused_before_any_work(jaws, overrides, words, tmp_path):
    with pytest.raises(InputError, match=words):
        grasp_specification(CUBE, jaws, 5.0, tmp_path, overrides)
    assert not list(tmp_path.iterdir())


def run(*arguments, cwd):
    return cli.run(*arguments, "--json", *COARSE, cwd=cwd)


def test_large_deformation_says_what_it_cannot(tmp_path):
    for arguments, words in (
        (("--at", "1:1,2", "--force", 3), "--material linear"),
        (
            ("--at", "1:1,2", "--set", "indenter.direction_deg=[20,0]"),
            "straight and without friction",
        ),
        (("--at", "1:1,2", "--set", "indenter.kind=flat"), "one hemisphere"),
    ):
        done = run("press", CUBE, "--material", "neo-hookean", *arguments, cwd=tmp_path)
        assert done.returncode == 2
        assert words in json.loads(done.stdout)["error"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("loads")


@pytest.mark.slow
def test_presses_together_with_one_refused(folder):
    done = run(
        "press", CUBE, "--at", "1:5,-4,1", "--at", "3:0,3,1.2",
        "--at", "1:-8,4,1", "--at", "1:19,0,1", cwd=folder,
    )  # fmt: skip
    assert done.returncode == 2
    document = json.loads(done.stdout)
    summary = document["objects"][0]["summary"]
    assert [row["face"] for row in summary["presses"]] == [1, 3, 1]
    for row in summary["presses"]:
        assert 0.85 < row["alone N"] / row["N"] <= 1.01
    assert summary["refused"][0]["press"] == "face 1 at (19, 0) mm"
    assert abs(summary["superposition of single presses"]["force off %"]) < 10
    for file in document["objects"][0]["files"]:
        assert (folder / file["path"]).stat().st_size == file["bytes"]


@pytest.mark.slow
def test_a_press_to_a_force_with_and_without_friction(folder):
    travel = []
    for friction in ("none", "sticking"):
        done = run(
            "press", CUBE, "--at", "1:5,-4", "--force", 3,
            "--set", f"indenter.friction={friction}", cwd=folder,
        )  # fmt: skip
        assert done.returncode == 0
        (row,) = json.loads(done.stdout)["objects"][0]["summary"]["presses"]
        assert_allclose(row["N"], 3, rtol=1e-4)
        travel.append(row["travel mm"])
    assert_allclose(travel[0], travel[1], rtol=0.05)


@pytest.mark.slow
def test_a_grasp_with_flat_jaws(folder):
    jaws = ["--set", "indenter.kind=cuboid", "--set", "indenter.size_mm=[30, 24]"]
    done = run("press", CUBE, "--jaw", "3:0,0", "--jaw", "5:0,0", "--force", 12, *jaws, cwd=folder)
    assert done.returncode == 0
    summary = json.loads(done.stdout)["objects"][0]["summary"]
    assert_allclose([row["N"] for row in summary["presses"]], 12, rtol=1e-5)
    left, right = (row["travel mm"] for row in summary["presses"])
    assert_allclose(left, right, rtol=0.03)
    assert summary["grasp"]["moment the jaws leave, N mm"] < 1e-6
    assert max(row["σ"] for row in summary["signal changes, counts"]) > 3
