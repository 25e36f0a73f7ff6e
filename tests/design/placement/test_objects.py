"""Objects placed from kind and size: everything fits, and refusals name a size that works."""

import re
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.body.surface_chart import steepest_reach_mm
from design.errors import InputError, SpecError
from design.fit.everything import problems_of
from design.layout.boards import (
    mounted_sensors,
    sensor_recesses,
    smallest_recess_wall_mm,
    wire_bundle_mm,
)
from design.layout.body import body_of
from design.layout.places.contact_places import contact_places
from design.layout.places.positions import magnet_layout
from design.layout.pockets import sensor_places
from design.placement import asked, hooking, objects
from design.placement.asked import base_advice, place_parts
from design.placement.objects import (
    Request,
    ShellVariant,
    bare_tables,
    first_fit,
    relaid,
    spec_of,
)
from design.placement.room import (
    low_rim,
    narrow_heads,
    thin_beside_wire_hole,
    thin_over_outlet,
    thin_round_bore,
    tight_marks,
    tight_middle,
    tight_rim,
)

PEAR = Path(__file__).parents[3] / "examples" / "bodies" / "pear.stl"
QUICK = {
    "brick": Request("box", (60.0, 40.0, 30.0), 2, 5),
    "pad": Request("pad", (60.0, 42.0, 11.0), 4),
    "handle": Request("cylinder", (42.0, 42.0, 60.0), 3),
    "dome": Request("dome", (40.0, 40.0, 26.0), 1, 3),
}


@pytest.fixture(scope="module")
def made_tables():
    return {name: place_parts(request) for name, request in QUICK.items()}


@pytest.fixture(scope="module")
def made(made_tables):
    return {name: spec_of(tables) for name, tables in made_tables.items()}


@pytest.mark.parametrize("name", QUICK)
def test_what_is_placed_fits_and_is_what_was_asked_for(name, made):
    spec, request = made[name], QUICK[name]
    assert problems_of(spec) == []
    assert (spec.body.kind, spec.body.size_mm) == (request.kind, request.size_mm)
    assert spec.sensors.count_per_face == request.sensors
    assert len(spec.magnets.positions_mm) == (request.magnets or 5)
    assert contact_places(spec).sum(axis=1).min() >= 16


def test_magnets_go_elsewhere_on_the_same_shell(made_tables):
    first, request = made_tables["pad"], QUICK["pad"]
    others = [*relaid(request, first, (0.5, 0.42))]
    assert others
    for tables in others:
        assert {key: tables[key] for key in ("body", "shell", "core", "sensors")} == {
            key: first[key] for key in ("body", "shell", "core", "sensors")
        }
        assert np.shape(tables["magnets"]["positions_mm"]) == (5, 2)
        assert problems_of(spec_of(tables)) == []
    places = [first, *others]
    assert all(a["magnets"] != b["magnets"] for a, b in combinations(places, 2))


def test_boards_and_magnets_of_a_brick_lie_in_core_and_silicone_by_hand(made):
    """In the box's own coordinates, without frames or distances of the design's."""
    spec = made["brick"]
    outer = np.array(spec.body.size_mm) / 2
    core = outer - spec.shell.thickness_mm
    for sensor in mounted_sensors(spec):
        for block in (sensor.board, sensor.chip):
            reach = abs(block.centre_mm) + abs(block.axes) @ block.half_mm
            assert (reach <= core + 1e-9).all(), sensor.label
    centres = magnet_layout(spec).centre_mm
    assert (abs(centres) < outer).all()
    assert ((abs(centres) > core).sum(axis=1) >= 1).all(), "a magnet lies in the core"
    apart = np.linalg.norm(centres[:, None] - centres[None], axis=-1)
    assert apart[~np.eye(len(centres), dtype=bool)].min() > spec.magnets.diameter_mm + 1


def test_recesses_in_the_ends_of_a_handle_leave_a_wall_to_its_side(made):
    """By hand, on a core of R 13 mm: it was 0.71 mm thick where 0.8 mm can be printed."""
    spec = made["handle"]
    radius = spec.body.size_mm[0] / 2 - spec.shell.thickness_mm
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    for recess in sensor_recesses(spec):
        if recess.face == 1:
            corners = recess.centre_mm + (signs * recess.half_mm) @ recess.axes.T
            assert np.hypot(*corners[:, :2].T).max() < radius - spec.printer.wall_mm


@pytest.mark.parametrize(("away_mm", "tight"), [(8.2, False), (8.4, True)])
def test_a_wall_to_the_side_of_a_cylinder_is_measured_along_the_recess(made, away_mm, tight):
    """By hand, on its flat end of R 13 mm: √(13² − 3.5²) − 3.25 − away, 1 mm needed."""
    spec, sensors = made["handle"], made["handle"].sensors
    middle = [[6.0 * np.cos(angle), 6.0 * np.sin(angle)] for angle in np.deg2rad([0, 120, 240])]
    end = [[away_mm, 0.0], *middle[1:]]
    faces = [end, *[middle] * (len(spec.body.sensed) - 1)]
    recess = {"recess_inner_radius_mm": 2.75, "recess_outer_radius_mm": 9.25}
    placed_so = spec.changed(
        core=spec.core.model_copy(update=recess),
        sensors=sensors.model_copy(update={"radius_mm": 6.0, "positions_mm": faces}),
    )
    assert tight_rim(placed_so) is tight


def test_a_core_that_slopes_away_beside_a_recess_leaves_no_thin_wall_there():
    """On a ball's core wide recesses end in a slope."""
    recess = {"recess_inner_radius_mm": 3.75, "recess_outer_radius_mm": 10.25}
    spec = spec_of(
        {
            "body": {"kind": "sphere", "size_mm": [44.0] * 3},
            "sensors": {"radius_mm": 7.0},
            "core": recess | {"recess_width_mm": 15.0},
        }
    )
    assert low_rim(spec)
    assert not tight_rim(spec)


def test_the_pear_takes_two_sensors_on_every_face():
    read = body_of_file(PEAR)
    request = Request("imported", tuple(read["size_mm"]), 2, 1, (("file", read["file"]),))
    tables = first_fit(request, shells=(ShellVariant(8.0, 6.0, 3.0),), shares=(0.46,))
    assert tables is not None
    spec = spec_of(tables)
    assert [len(face) for face in sensor_places(spec)] == [2] * 5


def test_faces_that_are_too_small_are_not_sensed():
    """A brick was refused as a whole, as its short sides take no four sensors; nine of ten odd bodies too."""
    request = Request("box", (80.0, 60.0, 26.0), 4, 5)
    tables = place_parts(request)
    spec = spec_of(tables)
    assert problems_of(spec) == []
    assert spec.body.sensed == (1, 2, 4)
    assert [len(face) for face in sensor_places(spec)] == [4] * 3
    assert first_fit(replace(request, faces=(1, 3))) is None


def test_a_pad_that_is_too_small_is_refused_with_a_size_that_works():
    with pytest.raises(SpecError, match="too small for 4 sensors") as told:
        place_parts(Request("pad", (20.0, 14.0, 8.0), 4))
    named = re.findall(r"works is about ([\d.]+) × ([\d.]+) × ([\d.]+) mm", str(told.value))
    x, y, z = map(float, named[0])
    assert problems_of(spec_of(place_parts(Request("pad", (x, y, z), 4)))) == []
    with pytest.raises(SpecError, match="too small"):
        place_parts(Request("pad", (0.8 * x, 0.8 * y, 0.8 * z), 4))


@pytest.mark.parametrize(
    ("kind", "size", "sensors", "faces"),
    [
        ("sphere", (30.0, 30.0, 30.0), 1, 5),  # two find room on one face alone
        ("capsule", (26.0, 26.0, 150.0), 2, 4),  # three find room on one face alone
        ("box", (60.0, 40.0, 30.0), 3, 5),
    ],
)
def test_a_small_body_takes_as_many_sensors_as_it_can(kind, size, sensors, faces):
    request = Request(kind, size, takes_fewer=True)
    spec = spec_of(place_parts(request))
    assert problems_of(spec) == []
    assert (spec.sensors.count_per_face, len(spec.body.sensed)) == (sensors, faces)


def test_a_shell_that_leaves_a_core_in_pieces_is_not_placed(tmp_path):
    """A stopper on a neck of Ø 12 mm: `new` ended with an error in the midst of its search."""
    parts = [
        trimesh.creation.cylinder(30.0, 80.0, sections=64),
        trimesh.creation.cylinder(6.0, 40.0, sections=64).apply_translation((0.0, 0.0, 50.0)),
        trimesh.creation.icosphere(3, 16.0).apply_translation((0.0, 0.0, 75.0)),
    ]
    trimesh.boolean.union(parts, engine="manifold").export(tmp_path / "stopped.stl")
    read = body_of_file(tmp_path / "stopped.stl")
    shell = ShellVariant(8.0, 6.0, 3.0)
    request = Request("imported", tuple(read["size_mm"]), 1, 1, (("file", read["file"]),))
    request = replace(request, faces=(3,), thinnest=shell)
    with pytest.raises(InputError, match="leave 2 pieces of core"):
        body_of(spec_of(bare_tables(request, shell))).core_surface()
    assert first_fit(request, (shell,), (0.46,)) is None


def test_magnets_of_a_narrow_pad_keep_silicone_at_its_sides():
    """0.81 mm were left beside them (limit 1 mm): check --fabrication failed."""
    spec = spec_of(place_parts(Request("pad", (22.4, 49.0, 12.6), 2, 6)))
    x, y = np.abs(spec.magnets.positions_mm).max(axis=0)
    radius = spec.shell.pocket_diameter_mm / 2
    assert min(11.2 - x, 24.5 - y) - radius >= 1.25 * spec.silicone.thinnest_wall_mm


@pytest.mark.parametrize(
    ("request_", "works"),
    [
        (Request("box", (900.0, 900.0, 20.0)), "With its short edges longer about 900 × 900 ×"),
        (Request("pad", (30.0, 30.0, 3.0)), "with its short edges longer about 30 × 30 ×"),
        (Request("pad", (30.0, 30.0, 10.0), 6, 5), "5 sensors per face would fit"),
        (Request("box", (30.0, 30.0, 30.0), 1, 12), "5 magnets per face would fit"),
    ],
)
def test_what_would_fit_instead_is_named_and_fits(request_, works):
    with pytest.raises(SpecError, match=works) as told:
        place_parts(request_)
    for size in re.findall(r"about ([\d.]+) × ([\d.]+) × ([\d.]+) mm", str(told.value)):
        works = place_parts(replace(request_, size_mm=tuple(map(float, size))))
        assert problems_of(spec_of(works)) == [], "or check refuses the size that is named"
    for what in ("sensor", "magnet"):
        for count in re.findall(rf"(\d+) {what}s? per face would", str(told.value)):
            place_parts(replace(request_, **{f"{what}s": int(count)}))


def test_where_not_even_one_sensor_finds_room_the_refusal_says_what_was_asked():
    """It said "too small for 1 sensor", and named the size of one, whoever asked for the usual three."""
    request = Request("box", (16.0, 16.0, 16.0), takes_fewer=True)
    said = r"too small for 3 sensors and a magnet per face \(even for 1 sensor\)"
    with pytest.raises(SpecError, match=said) as told:
        place_parts(request)
    (size,) = re.findall(r"works is about ([\d.]+) × ([\d.]+) × ([\d.]+) mm", str(told.value))
    tables = place_parts(replace(request, size_mm=tuple(map(float, size))))
    assert tables["sensors"]["count_per_face"] == 3
    with pytest.raises(SpecError, match=r"too small for 3 sensors and a magnet per face\. The"):
        place_parts(replace(request, takes_fewer=False))


def ruled(monkeypatch, rule):
    """Let what a rule allows be all that finds room."""
    for module in (objects, asked):
        monkeypatch.setattr(module, "fitting", lambda request, *_: iter([{}] * rule(request)))
        monkeypatch.setattr(module, "roomy_faces", lambda _: ())
    monkeypatch.setattr(asked, "fits_roughly", rule)
    monkeypatch.setattr(hooking, "least_hooked_mm", lambda _: 0.0)


def test_what_works_for_one_sensor_alone_is_named_as_such(monkeypatch):
    ruled(monkeypatch, lambda request: request.sensors == 1 and request.size_mm[0] >= 30)
    with pytest.raises(SpecError, match=r"With 1 sensor: The smallest .* is about 30 × 30 × 30 mm"):
        place_parts(Request("box", (20.0, 20.0, 20.0), takes_fewer=True))


def test_grooves_are_named_next_to_what_works(monkeypatch, tmp_path):
    """They were left out once a way was named; they may be why nothing fits."""
    ruled(monkeypatch, lambda request: request.kind == "imported" and request.size_mm[0] >= 50)
    ridged = trimesh.creation.icosphere(4, 12.0)
    shift = 0.6 * np.sin(9 * ridged.vertices[:, 0])
    ridged.vertices += shift[:, None] * ridged.vertices / 12.0
    ridged.export(tmp_path / "ridged.stl")
    read = body_of_file(tmp_path / "ridged.stl")
    file = (("file", read["file"]), ("scale", 1.0))
    with pytest.raises(SpecError, match=r"too small for .* Face 2 has grooves .* works is about 5"):
        place_parts(Request("imported", tuple(read["size_mm"]), 1, 1, file, faces=(2,)))


def test_a_plate_too_thin_for_its_core_s_walls_is_offered_as_a_pad():
    plate = Request("box", (40.0, 30.0, 12.0), 1, 1)
    (told,) = base_advice(plate)
    assert "--kind pad" in told
    assert problems_of(spec_of(place_parts(replace(plate, kind="pad")))) == []
    assert not [*base_advice(replace(plate, size_mm=(40.0, 30.0, 16.0)))], "no plate"
    assert not [*base_advice(replace(plate, size_mm=(40.0, 30.0, 4.0)))], "nor room in a pad"


def test_a_core_of_no_size_has_faces_of_no_size():
    """A sphere of 12 mm with the shell's 6 mm: told to be too small, not divided by."""
    assert steepest_reach_mm(0.0, 0.0) == steepest_reach_mm(-1.0, -1.0) == 0
    assert steepest_reach_mm(20.0, 20.0) > 15


def test_a_body_thinner_than_its_silicone_is_too_small_and_no_crash():
    """An ellipsoid's core is an offset of its triangles: here of less than nothing."""
    request = Request("ellipsoid", (10.0, 10.0, 10.0))
    assert first_fit(request, shells=(ShellVariant(8.0, 6.0, 3.0),)) is None


def test_a_core_that_is_tight_when_flat_is_tight_when_sunk(made):
    """So that the quick judgement of the placement refuses nothing that would fit."""
    spec = made["handle"]
    assert smallest_recess_wall_mm(spec) <= smallest_recess_wall_mm(spec, sunk=False)


def test_a_size_that_the_kind_does_not_take_is_refused_with_its_rule():
    with pytest.raises(SpecError, match="three times its diameter"):
        place_parts(Request("sphere", (50.0, 50.0, 40.0)))


def test_a_long_box_senses_all_its_faces_by_a_coarser_grid():
    """At 3 mm its lattice would have more than a hundred locations along an edge: two faces were left out."""
    tables = place_parts(Request("box", (320.0, 100.0, 100.0), sensors=2, magnets=1))
    assert "sensed_faces" not in tables["body"]
    pitch = tables["contact_grid"]["pitch_mm"]
    assert 320.0 / 100 < pitch <= tables["shell"]["thickness_mm"]


def test_a_body_that_nothing_helps_is_not_grown_beyond_what_a_body_may_measure(monkeypatch):
    monkeypatch.setattr(objects, "fitting_tables", lambda *_: iter(()))
    for module in (objects, asked):
        monkeypatch.setattr(module, "roomy_faces", lambda _: ())
    with pytest.raises(
        SpecError,
        match=r"no place was found for 3 sensors and a magnet per face .*nor at any size up to",
    ):
        place_parts(Request("dome", (500.0, 500.0, 260.0)))


def test_a_small_eggs_bore_leaves_a_wall_to_the_recesses_beside_it():
    """A rod of 9 mm left 0.66 mm of core behind the recesses of faces 2 and 4."""
    spec = spec_of(place_parts(Request("ellipsoid", (36.0, 34.0, 40.0), sensors=1, magnets=3)))
    assert spec.body.bore_mm == 8.0
    floors = np.array([r.corners_mm for r in sensor_recesses(spec) if r.face in (2, 4)])
    wall = float(abs(floors[..., 1]).min()) - spec.body.bore_mm / 2
    assert wall >= spec.printer.wall_mm


@pytest.mark.parametrize(
    ("length", "coarsest"), [(42.0, 3.0), (78.0, 3.0), (104.0, 4.0), (290.0, 8.0), (955.0, 10.0)]
)
def test_the_coarsest_pitch_follows_the_size_up_to_the_shells_thickness(length, coarsest):
    """26 locations in a row, no farther apart than the shell of 8 mm is thick, and at most 100 in a row."""
    spec = spec_of({"body": {"size_mm": [length, 42.0, 42.0]}})
    assert objects.pitches_mm(spec)[0] == coarsest


def test_the_widest_tip_and_the_coarsest_pitch_leave_every_face_sixteen_places(monkeypatch):
    """Of a made-up body whose smallest face has so many places at each tip and pitch."""
    places = {(5.0, 3.0): 15, (5.0, 2.5): 40, (5.0, 2.0): 15, (5.0, 1.5): 15, (5.0, 1.0): 15}
    places |= {(4.0, 3.0): 15, (4.0, 2.5): 16, (4.0, 2.0): 60}

    def counted(spec):
        count = places[spec.indenter.radius_mm, spec.contact_grid.pitch_mm]
        return np.arange(80) < np.array([[80], [count]])

    def fits(spec, mould):
        return (spec.indenter.radius_mm, spec.contact_grid.pitch_mm) != (5.0, 2.5)

    monkeypatch.setattr(objects, "contact_places", counted)
    monkeypatch.setattr(objects, "fits", fits)
    tables = {"shell": {"thickness_mm": 9.0}, "name": "made-up"}
    found = objects.with_contacts.__wrapped__(tables)
    assert found["indenter"] == {"radius_mm": 4.0}
    assert found["contact_grid"] == {"count": "fill", "pitch_mm": 2.5}
    assert found["press"]["depths_mm"] == [0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5]
    assert found["shell"] == tables["shell"]


def test_electronics_of_a_face_by_hand():
    """Recesses reach 3.25 mm to both sides of the boards' middles; holes take the wires of all."""
    request = Request("box", (60.0, 60.0, 60.0), 2)
    tables = objects.electronics_tables(request, [np.array([[6.0, 8.0], [-9.004, 0.0]])] * 5)
    assert tables["sensors"] == {
        "count_per_face": 2, "radius_mm": 9.0, "positions_mm": [[6.0, 8.0], [-9.0, 0.0]],
    }  # fmt: skip
    core = tables["core"]
    assert (core["recess_inner_radius_mm"], core["recess_outer_radius_mm"]) == (5.75, 12.25)
    assert core["wire_hole_top_diameter_mm"] == objects.hole_mm(2) >= 2.0
    assert core["wire_hole_side_diameter_mm"] == max(3.0, objects.hole_mm(2))
    near = objects.electronics_tables(request, [np.zeros((1, 2))] * 4 + [np.ones((1, 2))])
    assert near["sensors"]["radius_mm"] == 3.5
    assert near["sensors"]["positions_mm"] == [[[0.0, 0.0]]] * 4 + [[[1.0, 1.0]]]


def test_a_hole_is_a_tenth_wider_than_the_wires_through_it_in_half_millimetres():
    for sensors in range(1, 13):
        bundle = wire_bundle_mm(spec_of({"sensors": {"count_per_face": sensors}}))
        hole = objects.hole_mm(sensors)
        assert hole == 2.0 or 1.1 * bundle <= hole < 1.1 * bundle + 0.5
        assert 2 * hole == round(2 * hole)
    assert objects.hole_mm(12) > 3 > objects.hole_mm(1)


def test_a_core_s_wall_leaves_a_millimetre_behind_the_deepest_recess():
    for depth, wall in ((2.5, 4.0), (3.0, 4.0), (3.1, 4.5), (3.6, 5.0)):
        assert objects.wall_mm(spec_of({"core": {"recess_depth_mm": depth}})) == wall
    room = 13.0
    assert objects.wall_mm(spec_of({"core": {"recess_depth_mm": room}})) is None
    assert objects.wall_mm(spec_of({"core": {"recess_depth_mm": room - 0.1}})) == 14.0


def test_a_request_grows_to_half_millimetres_or_in_its_short_edges_alone():
    request = Request("box", (30.0, 20.1, 10.0), 1, 1, (("scale", 2.0), ("file", "a.stl")))
    grown = asked.grown_request(request, 1.1)
    assert grown.size_mm == pytest.approx((33.0, 22.11, 11.0)), "as the file is, at that scale"
    assert dict(grown.file) == {"scale": pytest.approx(2.2), "file": "a.stl"}
    odd = asked.grown_request(
        replace(request, file=(("scale", 0.03), ("file", "a.stl"))), 1.0936717
    )
    assert dict(odd.file)["scale"] == pytest.approx(0.03282), "0.032810 rounded up, as it is named"
    assert odd.size_mm == pytest.approx((32.82, 20.1 * 1.094, 10.94))
    plain = asked.grown_request(Request("box", (30.0, 20.1, 10.0)), 1.1)
    assert (plain.size_mm, plain.file) == ((33.0, 22.5, 11.0), ())
    assert asked.thickened_request(request, 1.26).size_mm == (30.0, 20.1, 13.0)
    assert asked.thickened_request(request, 2.5).size_mm == (30.0, 25.0, 25.0)


def test_a_face_without_a_patch_is_left_out_of_the_largest(tmp_path):
    """An edge of 34° points to face 2 of a wedge, too steep for a patch: `new` told that alone, and not
    which size works with which faces."""
    path = tmp_path / "wedge.stl"
    corners = [[x, y, z] for x, y in ((0, -30), (17, 25), (-17, 25)) for z in (-15, 15)]
    trimesh.Trimesh(corners).convex_hull.export(path)
    read = body_of_file(path)
    request = Request("imported", tuple(read["size_mm"]), 3, None, (("file", read["file"]),))
    assert first_fit(request, (ShellVariant(5.0, 4.0, 3.0),)) is None


@pytest.mark.parametrize(
    "wrong",
    [
        "tight_middle",
        "tight_core",
        "tight_core, as sunk",
        "tight_rim",
        "wall_mm",
        "thin_over_outlet",
        "thin_beside_wire_hole",
    ],
)
def test_a_pattern_that_is_tight_in_any_one_way_is_left_out(monkeypatch, wrong):
    """The first of two patterns, which is wrong in one way alone, gives way to the second."""
    spec_of_tables = lambda tables: tables["core"]["number"]  # noqa: E731
    monkeypatch.setattr(objects, "spec_of", spec_of_tables)
    numbers = iter((1, 2))
    monkeypatch.setattr(
        objects, "electronics_tables", lambda *_: {"core": {"number": next(numbers)}}
    )
    ways = ("tight_middle", "tight_rim", "low_rim", "thin_over_outlet", "thin_beside_wire_hole")
    for name in ways:
        monkeypatch.setattr(objects, name, lambda spec, name=name: (spec, wrong) == (1, name))
    unsunk = lambda spec, sunk: wrong == ("tight_core, as sunk" if sunk else "tight_core")  # noqa: E731
    monkeypatch.setattr(
        objects, "tight_core", lambda spec, sunk=True: spec == 1 and unsunk(spec, sunk)
    )
    monkeypatch.setattr(
        objects, "wall_mm", lambda spec: None if (spec, wrong) == (1, "wall_mm") else 2.0 + spec
    )
    monkeypatch.setattr(objects, "body_of", lambda spec: SimpleNamespace(opening="plane"))
    monkeypatch.setattr(objects, "fits", lambda spec: True)
    square = ((1.0, 0.0), (0.0, 1.0))
    found = objects.with_patterns.__wrapped__(
        QUICK["pad"], {}, [np.ones(2)], [(0.5, np.array(square)), (0.4, np.array(square))]
    )
    assert found == {"core": {"number": 2, "wall_mm": 4.0}}


def closed_cylinder(places):
    """With pockets of 6 mm in its upper end; its mould is one of halves, with pins."""
    body = {"kind": "cylinder", "size_mm": [60.0] * 3, "open_faces": [], "sensed_faces": [1]}
    shell = {"pocket_diameter_mm": 6.0}
    return spec_of({"body": body, "shell": shell, "magnets": {"positions_mm": places}})


@pytest.mark.parametrize(("apart_mm", "narrow"), [(6.8, True), (7.0, False), (12.0, False)])
def test_heads_of_pins_that_stand_close_have_narrow_rims(apart_mm, narrow):
    """Half of what is left between two pockets of 6 mm and their pins' play, of 0.4 mm or more."""
    spec = closed_cylinder([[0.0, 6.0], [apart_mm, 6.0]])
    assert ((apart_mm - 6.0 - spec.printer.clearance_mm) / 2 < 0.4) is narrow
    assert narrow_heads(spec) is narrow
    one_piece = spec.changed(mould={"style": "one-piece"}, body=spec.body.changed(open_faces=[6]))
    assert not narrow_heads(one_piece)


def test_marks_that_find_no_room_are_told_of_flat_faces_alone():
    crowded = [[x, y] for x in (-8.0, 0.0, 8.0) for y in (-8.0, 0.0, 8.0)]
    spec = closed_cylinder(crowded)
    for kind, tight in (("box", True), ("sphere", False)):
        body = {"kind": kind, "size_mm": [30.0] * 3, "sensed_faces": [1]}
        assert tight_marks(spec.changed(body=body)) is tight
    assert not tight_marks(closed_cylinder([[0.0, 0.0], [12.0, 0.0]]))


def test_patterns_that_cannot_be_made_come_last(monkeypatch):
    request = Request("pad", (60.0, 42.0, 11.0), 1, 4)

    def places(*hard):
        monkeypatch.setattr(objects, "HARD_TO_MAKE", hard)
        tables = first_fit(request, objects.SHELL_VARIANTS[2:3], shares=(0.5, 0.4))
        assert tables is not None
        return tables["magnets"]["positions_mm"]

    first = places()
    second = places(lambda spec: spec.magnets.positions_mm == spec_of_places(first))
    assert second != first
    assert places(lambda spec: True) == first


def spec_of_places(places):
    return spec_of({"magnets": {"positions_mm": places}}).magnets.positions_mm


@pytest.mark.parametrize(("away_mm", "thin"), [(5.81, True), (6.1, True), (6.3, False)])
def test_a_recess_that_leans_towards_the_wire_hole_of_its_face_leaves_a_wall_at_its_floor(
    away_mm, thin
):
    """By hand, round a cylinder's core of R 30.5 mm (random request 386), beside a hole of R 1.5 mm: in the
    plane of the face 1.06 mm are left to a place 5.81 mm from the middle, where 0.8 mm can be printed."""
    radius, half = 30.5, 3.25
    content = {
        "body": {"kind": "cylinder", "size_mm": [73.0, 73.0, 30.0], "sensed_faces": [3]},
        "shell": {"thickness_mm": 6.0},
        "core": {
            "recess_inner_radius_mm": away_mm - half,
            "recess_outer_radius_mm": away_mm + half,
            "wire_hole_side_diameter_mm": 3.0,
        },
        "sensors": {
            "count_per_face": 2,
            "radius_mm": away_mm,
            "positions_mm": [[0.0, -away_mm], [0.0, away_mm]],
        },
    }
    spec = spec_of(content)
    lean = np.arcsin(away_mm / radius)
    (recess, _) = sensor_recesses(spec)
    depth = 2 * float(recess.half_mm[2])
    wall = away_mm - half * np.cos(lean) - depth * np.sin(lean) - 1.5
    assert bool(wall < spec.printer.wall_mm) is thin
    assert thin_beside_wire_hole(spec) is thin
    assert not tight_middle(spec)


@pytest.mark.parametrize(("bore_mm", "thin"), [(11.4, False), (12.0, True), (13.8, True)])
def test_a_bore_leaves_a_wall_to_the_side_of_a_narrow_core(bore_mm, thin):
    """By hand, in a capsule's core of R 7 mm, along its side and on for 18° of its round end: 0.8 mm can be
    printed."""
    body = {"kind": "capsule", "size_mm": [30.0, 30.0, 60.0], "bore_mm": bore_mm}
    spec = spec_of({"body": body, "shell": {"thickness_mm": 8.0}})
    wall = float(7.0 * np.cos(np.deg2rad(18.0)) - bore_mm / 2)
    assert (wall < spec.printer.wall_mm) is thin
    assert thin_round_bore(spec) is thin


def test_a_core_that_slopes_away_from_its_bore_has_an_edge_and_no_wall():
    """On a ball's core of R 9 mm a bore of 8 mm meets the surface at 64°."""
    body = {"kind": "sphere", "size_mm": [34.0] * 3, "bore_mm": 8.0}
    assert not thin_round_bore(spec_of({"body": body, "shell": {"thickness_mm": 8.0}}))


@pytest.mark.parametrize(("diameter_mm", "thin"), [(21.4, True), (22.0, False)])
def test_a_recess_leaves_a_floor_over_the_way_of_the_wires(diameter_mm, thin):
    """By hand, below a board of 6.6 × 6.2 mm whose corners touch the core; 0.463 mm by rays through the core
    of a ball of 21.4 mm that `instobj new` placed."""
    floor = np.sqrt((diameter_mm / 2 - 5.0) ** 2 - 3.3**2 - 3.1**2) - 3.0
    spec = spec_of(
        {
            "body": {"kind": "sphere", "size_mm": [diameter_mm] * 3, "sensed_faces": [1]},
            "shell": {"thickness_mm": 5.0},
            "core": {
                "wall_mm": 6.5,
                "recess_inner_radius_mm": 0.25,
                "recess_outer_radius_mm": 6.75,
            },
            "sensors": {"count_per_face": 1, "radius_mm": 3.5, "positions_mm": [[0.0, 0.0]]},
        }
    )
    (recess,) = sensor_recesses(spec)
    assert recess.centre_mm[2] - recess.half_mm[2] == pytest.approx(floor, abs=0.01)
    assert thin_over_outlet(spec) is thin
    hollow = spec.changed(core=spec.core.changed(wall_mm=2.0))
    assert not thin_over_outlet(hollow), "its cavity is what wires leave by"
