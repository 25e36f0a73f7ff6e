"""`instobj optimize` as a user meets it: impossible searches, and one search up the whole ladder."""

import json
import tomllib
from pathlib import Path

import pytest

from design.errors import InputError
from design.layout.body import face_frames
from design.search.space import start_params
from design.spec.object import ObjectSpec
from design.spec.search import SearchSpec, VarySpec
from design.spec_io import load_spec, parse_spec
from instobj.search import possible
from instobj.search.lowest_fidelity import pressed_faces
from instobj.search.optimize import optimize
from instobj.search.outcome.write import write_specification
from instobj.search.possible import require_possible
from tests.support.cli import assert_one_clear_error, run

EXAMPLES = Path(__file__).parents[3] / "examples"
FREE = {"magnet_reach_mm": 15.0, "magnet_depth_mm": [2.0, 5.0], "sensor_reach_mm": 10.5}


def specification(**search):
    return parse_spec({"name": "cube", "search": search}, "made up")


def test_a_search_with_room_is_possible():
    assert len(require_possible(specification(vary=FREE)).variables) == 21


def test_what_the_specification_keeps_itself_is_possible(monkeypatch):
    """A layout for each face of a handle: random ones are far from the limits, the start is not, once its
    third board leaves a wall beside the wire hole."""
    monkeypatch.setattr(possible, "WALKS", 0)
    places = "sensors.positions_mm=[[9.0, 0.0], [-9.0, 0.0], [0.0, 8.6]]"
    spec = load_spec(EXAMPLES / "handle.toml", [places])
    free = {"magnet_reach_mm": 15.0, "sensor_reach_mm": 10.0, "layouts": "per face"}
    search = spec.search.changed(vary=spec.search.vary.changed(**free))
    assert len(require_possible(spec.changed(search=search)).variables) == 60
    monkeypatch.setattr(possible, "start_params", lambda space: None)
    with pytest.raises(InputError, match="no layout within the bounds"):
        require_possible(spec.changed(search=search))


IMPOSSIBLE = {
    "pocket gap": {"vary": {"magnet_reach_mm": 4.5}},
    "pockets near the edge": {"vary": {"magnet_sizes": ["D10x3"], "magnet_depth_mm": [5.5, 6.4]}},
    "1.5 mm from both skins": {"vary": {"magnet_depth_mm": [0.6, 5.0]}},
}


@pytest.mark.parametrize("text", IMPOSSIBLE)
def test_bounds_that_exclude_every_layout_are_one_clear_error(text, monkeypatch):
    monkeypatch.setattr(possible, "WALKS", 1)  # of five: what none can keep, the first tells
    with pytest.raises(InputError, match=text):
        require_possible(specification(**IMPOSSIBLE[text]))


LACKING = {
    "no two adjacent faces": ("median_false_force_n", {"body": {"sensed_faces": [3, 5]}}),
}


@pytest.mark.parametrize("limited", [False, True], ids=["objective", "limit"])
@pytest.mark.parametrize("text", LACKING)
def test_scores_that_the_object_has_none_of_are_refused_before_any_mechanics(text, limited):
    name, content = LACKING[text]
    search = {"limits": {"times_start": {name: 1.0}}} if limited else {"objectives": [name]}
    content = {"name": "cube", "search": {"vary": FREE} | search} | content
    with pytest.raises(InputError, match=rf"(?s){name}.*{text}"):
        require_possible(parse_spec(content, "made up"))


def test_faces_that_are_alike_are_pressed_once():
    few = pressed_faces(specification(vary=FREE))
    assert few == {1: (1,), 3: (2, 3, 4, 5)}
    fixed = {"magnet_reach_mm": 15.0}
    assert pressed_faces(specification(vary=fixed)) == {face: (face,) for face in range(1, 6)}


def test_what_only_the_whole_specification_refuses_is_said_too():
    """A fourth sensor a face makes reading them all too slow."""
    search = {"vary": {"sensor_count": [4], "sensor_reach_mm": 10.0}}
    sensors = {"frame_rate_hz": 300.0}
    spec = parse_spec({"name": "cube", "sensors": sensors, "search": search}, "made up")
    with pytest.raises(InputError, match=r"frame_rate_hz = 300 is beyond .* 20 sensors"):
        require_possible(spec)


def test_sensors_in_the_shell_have_layouts_within_all_limits():
    reverse = load_spec(EXAMPLES / "reverse_cube.toml")
    vary = VarySpec(magnet_reach_mm=11.0, magnet_north=True, sensor_reach_mm=17.0)
    space = require_possible(reverse.changed(search=reverse.search.changed(vary=vary)))
    names = {"magnet4_y_mm", "magnet4_north", "sensor3_x_mm"}
    assert names < {variable.name for variable in space.variables}
    close = reverse.silicone.changed(thinnest_wall_mm=15.0)
    with pytest.raises(InputError, match="pocket"):
        require_possible(space.spec.changed(silicone=close))


def test_depths_of_magnets_in_the_core_and_lists_of_faces_are_refused():
    reverse = load_spec(EXAMPLES / "reverse_cube.toml")
    vary = VarySpec(magnet_reach_mm=11.0, magnet_depth_mm=(2.0, 5.0))
    with pytest.raises(InputError, match="magnet_depth_mm is that of magnets in the shell"):
        require_possible(reverse.changed(search=reverse.search.changed(vary=vary)))
    lists = {"magnets": {"positions_mm": [[[8, 8], [-8, -8]]] * 5}, "search": {"vary": FREE}}
    with pytest.raises(InputError, match=r'layouts = "per face"'):
        require_possible(parse_spec({"name": "cube"} | lists, "made up"))


def test_tilts_on_a_curved_body_are_refused_before_any_mechanics():
    spec = load_spec(EXAMPLES / "ball.toml")
    search = spec.search.changed(vary=VarySpec(magnet_reach_mm=8.0, magnet_tilt_deg=10.0))
    with pytest.raises(InputError, match="known on flat faces only"):
        require_possible(spec.changed(search=search))


def test_a_patch_with_too_few_locations_for_slopes_is_refused():
    spec = load_spec(EXAMPLES / "ball.toml", ["contact_grid.pitch_mm=14.0"])
    search = spec.search.changed(vary=VarySpec(magnet_reach_mm=8.0))
    with pytest.raises(InputError, match=r"contact locations (in a row|on a face), for slopes"):
        require_possible(spec.changed(search=search))


UNSEARCHED = {
    "bonded core": {"mechanics": {"interface": "frictionless"}},
    "without friction": {"indenter": {"friction": "sticking"}},
    "4 contact locations in a row": {"contact_grid": {"count": [3, 6], "pitch_mm": 3.0}},
    "sensors.rotations_deg": {"sensors": {"rotations_deg": [[0.0, 0.0, 5.0]] * 3}},
    "round magnets": {"magnets": {"shape": "block", "size_mm": [5.0, 5.0]}},
}


@pytest.mark.parametrize("text", UNSEARCHED)
def test_what_no_level_can_score_is_refused_before_any_mechanics(text):
    content = UNSEARCHED[text]
    search = {"vary": FREE} | content.get("search", {})
    with pytest.raises(InputError, match=text):
        require_possible(parse_spec({"name": "cube"} | content | {"search": search}, "made up"))


def test_a_written_layout_is_read_back(tmp_path):
    magnets = {
        "positions_mm": [[0, 1], [9, 8]],
        "depth_mm": [2.0, 3.1],
        "north": ["outward", "inward"],
    }
    sensors = {"positions_mm": [[0.5, 8.2], [-7.1, -4.2]], "chip": "outward"}
    content = {
        "name": "cube",
        "magnets": magnets,
        "sensors": sensors,
        "silicone": {"modulus_from": "A20"},
    }
    spec = parse_spec(content, "made up")
    write_specification(spec, "again", tmp_path / "again.toml", tmp_path)
    again = load_spec(tmp_path / "again.toml")
    assert again.name == "again"
    changed = {
        name for name in ObjectSpec.model_fields if getattr(again, name) != getattr(spec, name)
    }
    assert changed == {"name"}


def test_a_written_layout_names_a_mesh_that_is_coarser_than_the_default(tmp_path):
    """A final run took over the coarse mesh of a search without a word."""
    path = tmp_path / "best.toml"
    for mesh, named in ({}, False), ({"edge_mm": 6.0}, True), ({"edge_mm": 3.0}, False):
        write_specification(
            parse_spec({"name": "cube", "mesh": mesh}, "made up"), "a", path, tmp_path
        )
        comments = [line for line in path.read_text().splitlines() if line.startswith("#")]
        assert [("edge_mm" in line and "surface" not in line) for line in comments] == [
            True
        ] * named
    assert load_spec(path).mesh.edge_mm == 3.0


@pytest.mark.parametrize("example", ["ball", pytest.param("handle", marks=pytest.mark.slow)])
def test_an_empty_table_moves_magnets_and_sensors_over_the_whole_face(example):
    spec = load_spec(EXAMPLES / f"{example}.toml")
    space = require_possible(spec.changed(search=SearchSpec()))
    assert len(space.variables) >= 2 * (spec.magnets.count + spec.sensors.count_per_face)
    reach = space.spec.search.vary.magnet_reach_mm
    edge = max(max(frame.half_extents_mm) for frame in face_frames(spec))
    assert 0.6 * edge < reach < edge
    assert start_params(space) is not None, "the search holds the layout that it begins with"


def test_lists_of_faces_are_searched_each_by_itself_where_nothing_is_named():
    lists = {"magnets": {"positions_mm": [[[8, k], [-8, -8]] for k in range(5)]}}
    space = require_possible(parse_spec({"name": "cube"} | lists, "made up"))
    assert space.spec.search.vary.layouts == "per face"


def test_too_little_time_is_refused_and_leaves_nothing_to_resume(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[search.vary]\nmagnet_reach_mm = 14.0\n')
    for _ in range(2):
        with pytest.raises(
            InputError, match=r"search\.seconds = 20 ends before .* give --set search\.seconds=\d+$"
        ):
            optimize(path, tmp_path, ["search.seconds=20"], False)
    assert not list((tmp_path / "runs").glob("**/trials.jsonl"))


def test_an_impossible_search_ends_with_one_error(tmp_path, monkeypatch):
    monkeypatch.setattr(possible, "WALKS", 1)
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[search.vary]\nmagnet_reach_mm = 14.0\n')
    with pytest.raises(InputError, match="pocket gap"):
        optimize(path, tmp_path, ["search.vary.magnet_reach_mm=4.5"], False)


SMALL = """
name = "small"
[mesh]
edge_mm = 8.0
surface_edge_mm = 3.5
rim_edge_ratio = 1
[contact_grid]
count = [4, 4]
pitch_mm = 6.0
[press]
depths_mm = [1.0, 2.0, 4.0]
[search]
trials = 24
polish_steps = 20
finalists = 1
[search.vary]
magnet_reach_mm = 15.0
magnet_depth_mm = [1.6, 5.5]
sensor_reach_mm = 10.5
"""


@pytest.mark.slow
def test_a_search_climbs_the_ladder_and_goes_on(tmp_path):
    (tmp_path / "small.toml").write_text(SMALL)
    done = run("optimize", "small.toml", "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    folder = tmp_path / "runs/small/search"
    results = json.loads((folder / "search.json").read_text())
    assert results["better"] == document["better"]
    assert load_spec(folder / "best.toml").name == "small_best"
    assert results["gains"] == document["gains"]
    assert document["gains"] in (folder / "best.toml").read_text().splitlines()[0]
    ratio = results["ratios"]["worst_position_bound_mm"]
    assert ratio["low"] <= ratio["high"]
    last = [one["rungs"].get("3") for one in (results["start"], *results["leaders"])]
    start, (best,) = last[0], [scores for scores in last[1:] if scores]
    wanted = start["worst_position_bound_mm"] / best["worst_position_bound_mm"]
    assert ratio["design"] == pytest.approx(wanted, rel=0.15)
    finalist = folder / "finalist_1.toml"
    assert "search" not in tomllib.loads(finalist.read_text())
    assert run("check", finalist, cwd=tmp_path).returncode == 0
    page = (folder / "search.html").read_text()
    for shown in ("before", "after", "after the search over before"):
        assert f'alt="Position bound {shown}" src="data:image/webp' in page
    for shown in ("Best so far against layouts scored", "Core, shell and mould"):
        assert f'alt="{shown}" src="data:image/webp' in page
    _assert_resumed(tmp_path, folder)


def _assert_resumed(tmp_path, folder):
    kept = (folder / "trials.jsonl").read_bytes()
    refused = run("optimize", "small.toml", cwd=tmp_path)
    assert_one_clear_error(refused, "--resume")
    changed = run("optimize", "small.toml", "--resume", "--set", "score.force_n=6", cwd=tmp_path)
    assert_one_clear_error(changed, "another specification")
    assert (folder / "trials.jsonl").read_bytes() == kept
    more = run(
        "optimize", "small.toml", "--resume", "--set", "search.trials=36", "--json", cwd=tmp_path
    )
    assert more.returncode == 0, more.stderr
    counts = next(iter(json.loads(more.stdout)["tables"].values()))[0]
    trials_before = (
        kept.count(b"\n") - 1
    )  # below its heading; restarts may be merged to fewer, longer ones
    assert trials_before < counts["trials"] <= 36
