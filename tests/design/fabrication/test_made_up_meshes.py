"""Checks of fabrication at both sides of their limits, by boxes and made-up measures in place of parts."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.body.meshes import Trap, Undercut
from design.body.triangles import Block
from design.build.parts import Part
from design.fabrication.assembly import check_fits, check_wires, collisions, interference
from design.fabrication.casting import (
    Draw,
    ceiling_finding,
    check_blocked,
    check_closing,
    check_seal_mould,
    check_shared,
    draft_finding,
    traps_finding,
    undercut_finding,
    way_out,
)
from design.fabrication.check import check_solid
from design.fabrication.finding import status_above, worst
from design.fabrication.printing import check_bed, check_edges, check_walls
from design.fabrication.tools import check_tools
from design.layout.boards import Mounted
from design.layout.body import body_of, face_frames
from design.layout.mould.frame import flange_width_mm
from design.layout.mould.pouring import Hole
from design.solids.booleans import convert_to_triangles
from design.solids.core import make_core
from design.solids.jig import make_jig
from design.solids.magnet_template import template_faces
from design.solids.probes import make_probe
from design.solids.sampled import sampled_core_part
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.support.objects.body_cases import body_spec
from tests.support.objects.worked_objects import worked
from tests.support.pages import ROOT
from tests.support.scans import YCB

CUBE = worked("closed box")
DOWN = np.array([0.0, 0.0, -1.0])


def box(low, high):
    return trimesh.creation.box(bounds=np.array([low, high], float))


@pytest.mark.parametrize(("deep", "status"), [(0.0, "pass"), (0.0099, "pass"), (0.011, "fail")])
def test_parts_that_share_more_than_a_cubic_millimetre_do_not_close(deep, status):
    """Boxes of 10 × 10 mm that overlap by 100 mm² times the depth; a third one shares less."""
    meshes = {
        "mould_half_a": box([0, 0, 0], [10, 10, 10]),
        "mould_half_b": box([0, 0, 10 - deep], [10, 10, 20]),
        "mould_plug": box([9, 9, 9.996], [30, 30, 9.998]),
    }
    found = check_shared(CUBE, meshes, (), "mould")
    assert (found.status, found.limit, found.part) == (status, 1.0, "mould")
    assert found.value == pytest.approx(100 * deep if deep else 0.002, rel=0.02)
    if deep:
        assert "most: mould_half_a and mould_half_b" in found.what
        assert found.place_mm == pytest.approx((5, 5, 10 - deep / 2), abs=1e-3)


def test_a_hole_must_be_open_but_for_a_hundredth_of_its_section():
    """A hole of Ø4 along x through a wall of 3 mm, and one that touches a wall by 0.009 mm."""
    way = {
        "start_mm": np.zeros(3),
        "top_mm": np.array([5.0, 0, 0]),
        "end_mm": np.array([20.0, 0, 0]),
    }
    hole = Hole("vent", diameter_mm=4.0, **way)
    wall = box([10, -9, -9], [13, 9, 9])
    (found,) = check_blocked(
        (hole,), {"mould_half_a": wall, "core": box([0, -9, -9], [18, 9, 9])}, "core"
    )
    section = np.pi * 4.0
    assert found.value == pytest.approx(3 * section, rel=0.01)
    assert found.limit == pytest.approx(1e-3 + 0.01 * section)
    assert (found.status, found.part) == ("fail", "mould_half_a")
    for deep, status in ((0.009, "pass"), (0.012, "fail")):
        thin = {"mould_half_b": box([10, -9, -9], [10 + deep, 9, 9])}
        assert check_blocked((hole,), thin)[0].status == status
    holder = {"mould_holder": box([0, -9, -9], [4.9, 9, 9])}
    assert check_blocked((hole,), holder)[0].status == "pass", "within the silicone it may stand"
    assert not check_blocked((), holder)
    assert not check_blocked((hole,), {"core": wall}, "core")
    both = {
        "mould_half_a": thin["mould_half_b"],
        "mould_half_b": wall,
        "plug": thin["mould_half_b"],
    }
    other = replace(hole, start_mm=np.array([0.0, 30, 0]), top_mm=np.array([5.0, 30, 0]))
    for holes in ((hole, other), (other, hole)):
        (found,) = check_blocked(holes, both)
        assert (found.part, found.place_mm) == ("mould_half_b", (0.0, 0.0, 0.0))
        assert found.value == pytest.approx(3 * section, rel=0.01)


@pytest.mark.parametrize(
    ("depth", "room", "status", "limit"),
    [
        (0.0, 0.0, "pass", 0.0),
        (0.159, 0.0, "pass", 0.16),
        (0.161, 0.0, "fail", 0.16),
        (4.9, 5.0, "fail", 2.0),
        (1.99, 5.0, "pass", 2.0),
        (2.01, 5.0, "fail", 2.0),
        (1.5, 1.4, "fail", 1.4),
    ],
)
def test_undercuts_are_peeled_where_there_is_room_and_strain_left(depth, room, status, limit):
    """Shell of 8 mm: 0.16 mm gives way on the spot; 25 % of strain, a third of 75.76 %, are 2 mm of it."""
    spec = CUBE.changed(silicone=CUBE.silicone.changed(elongation_percent=25.0 / 0.33))
    place = np.array([1.0, 2.0, 3.0]) if depth else None
    measured = Undercut(7.0 * (depth > 0), depth, place)
    found = undercut_finding(spec, Draw("mould_box", DOWN, room), measured)
    assert (found.status, found.value) == (status, depth)
    assert found.limit == pytest.approx(limit)
    assert found.place_mm == ((1.0, 2.0, 3.0) if depth else None)


def test_the_way_out_of_an_undercut_is_one_that_is_left():
    whole = CUBE.changed(mould=CUBE.mould.changed(style="one-piece"))
    assert "mould.style" in way_out(whole)
    split = CUBE.changed(mould=CUBE.mould.changed(style="split"))
    assert "mould.parting_azimuth_deg" in way_out(split)


@pytest.mark.parametrize(("draft", "status"), [(0.99, "warn"), (1.0, "pass")])
def test_a_wall_without_draft_is_a_warning(draft, status):
    assert draft_finding(CUBE, "mould_box", draft, np.zeros(3)).status == status


@pytest.mark.parametrize(("area", "status"), [(100.0, "pass"), (100.1, "warn")])
def test_air_rests_under_wide_ceilings(area, status):
    ceiling = ceiling_finding(area, np.zeros(3))
    assert (ceiling.status, ceiling.limit) == (status, 100.0)


def test_air_is_caught_in_traps():
    trap = Trap(np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.0, 1.0]), 0.5)
    vent = Hole("vent", np.zeros(3), np.zeros(3), np.array([0.0, 0, 9.0]), 1.0)
    traps = traps_finding([trap], (vent, vent), "shell")
    assert (traps.status, traps.value, traps.place_mm) == ("fail", 1.0, (1.0, 2.0, 3.0))
    assert (traps.limit, traps.part) == (0.0, "shell")
    assert "2 vents" in traps.what
    assert traps_finding([], (vent,), "shell").status == "pass"
    film = replace(trap, place_mm=np.zeros(3), depth_mm=0.1)
    assert traps_finding([film], (vent,), "shell").status == "fail"
    assert traps_finding([film], (vent,), "shell", film_mm=0.12).status == "warn"
    assert traps_finding([film], (vent,), "shell", film_mm=0.09).status == "fail"
    both = traps_finding([film, trap], (vent,), "shell", film_mm=0.12)
    assert (both.status, both.place_mm) == ("fail", (1.0, 2.0, 3.0))


@pytest.mark.parametrize(
    ("material", "wall", "status", "limit"),
    [
        ("silicone", 0.99, "fail", 1.0),
        ("silicone", 1.24, "warn", 1.0),
        ("silicone", 1.26, "pass", 1.0),
        ("printed", 0.79, "fail", 0.8),
        ("printed", 0.99, "warn", 0.8),
        ("printed", 1.01, "pass", 0.8),
    ],
)
def test_walls_are_thin_by_their_material(material, wall, status, limit):
    plate = box([0, 0, 0], [30, 30, wall])
    (found,) = check_walls(Part("core", lambda: None, material), plate, CUBE)
    assert (found.status, found.limit, found.value) == (status, limit, pytest.approx(wall))


@pytest.mark.parametrize(("name", "told"), [("mould_half_a", True), ("mould_box", False)])
def test_halves_of_moulds_are_told_to_turn_their_seam(name, told):
    (found,) = check_walls(Part(name, lambda: None), box([0, 0, 0], [30, 30, 0.1]), CUBE)
    assert ("mould.parting_azimuth_deg" in found.what) == told


@pytest.mark.parametrize(("angle", "status"), [(39.9, "warn"), (40.1, "pass")])
def test_edges_below_40_degrees_are_a_warning(angle, status):
    height = 20 * np.tan(np.deg2rad(angle))
    ends = [[x, y, z] for x, z in ((0, 0), (20, 0), (20, height)) for y in (0, 30)]
    wedge = trimesh.convex.convex_hull(np.array(ends, float))
    (found,) = check_edges(Part("core", lambda: None), wedge)
    assert (found.status, found.limit) == (status, 40.0)
    assert found.value == pytest.approx(angle)


@pytest.mark.parametrize(
    ("edges", "room"),
    [((240, 220, 220), 0.0), ((100, 241, 50), -1.0), ((221, 1, 221), -1.0), ((10, 10, 10), 210.0)],
)
def test_a_part_lies_on_the_bed_as_fits_best(edges, room):
    """220 × 220 × 240 mm."""
    (found,) = check_bed(Part("core", lambda: None), box([0, 0, 0], edges), CUBE)
    assert found.value == pytest.approx(room)
    assert (found.status, found.limit) == ("pass" if room >= 0 else "fail", 0.0)
    assert not check_bed(Part("shell", lambda: None, "silicone"), box([0, 0, 0], edges), CUBE)


def mounted(number, x, chip_z=-2.0):
    board = Block(np.array([x, 0.0, 0.0]), np.eye(3), np.array([2.0, 2.0, 0.5]))
    return Mounted(
        1, number, board, Block(np.array([x, 0.0, chip_z]), np.eye(3), np.array([1.0, 1.0, 0.5]))
    )


def test_boards_and_chips_share_what_they_share():
    core = box([-9, -9, -9], [9, 9, -1.999])
    (found,) = interference([mounted(1, 0.0)], core)
    assert found.value == pytest.approx(4 * 0.501)
    assert (found.status, found.limit, found.place_mm) == ("fail", 1e-3, (0.0, 0.0, -2.0))
    (clear,) = interference([mounted(1, 0.0)], box([-9, -9, -9], [9, 9, -2.5]))
    assert clear.status == "pass"
    for apart, common in ((3.0, 4.0), (3.9995, 0.002), (3.9999, 0.0004), (4.1, 0.0)):
        (found,) = collisions([mounted(1, 0.0), mounted(2, apart)])
        assert found.value == pytest.approx(common, abs=1e-5)
        assert found.status == ("fail" if common > 1e-3 else "pass")
        assert ("sensor 1 of face 1 and sensor 2" in found.what) == (common > 0)


def test_boards_go_into_their_recesses_with_a_little_room():
    """Recess of 4 × 4 × 2.6 mm; board of 3.8 × 3.6 × 1.2 and chip of 0.9 mm."""
    rooms = {f.check.split(", ")[1]: (f.value, f.status) for f in check_fits(CUBE)}
    assert {f.limit for f in check_fits(CUBE)} == {0.0}
    assert check_fits(CUBE)[0].place_mm == pytest.approx((4.2, 1.5, 18.35))
    assert rooms["across"] == (pytest.approx(0.1), "pass")
    assert rooms["along"] == (pytest.approx(0.2), "pass")
    assert rooms["deep"] == (pytest.approx(0.5), "pass")
    tight = CUBE.changed(sensors=CUBE.sensors.changed(package_mm=(3.97, 4.0, 1.75)))
    rooms = {f.check.split(", ")[1]: f.status for f in check_fits(tight)}
    assert rooms == {"across": "warn", "along": "warn", "deep": "fail"}


def test_wires_go_through_the_narrowest_hole():
    """Eight wires of 0.4 mm fill 70 % of their bundle: Ø1.352."""
    found = check_wires(CUBE)
    assert found.value == pytest.approx(2.2 - 0.4 * np.sqrt(8 / 0.7))
    assert "diameter_mm to 1.36" in found.what
    assert found.limit == 0.0
    assert found.status == "pass"
    narrow = CUBE.changed(core=CUBE.core.changed(wire_hole_side_diameter_mm=1.3))
    assert check_wires(narrow).status == "fail"


def test_the_worst_of_findings_and_their_limits():
    assert [status_above(v, 1.0, 1.25) for v in (0.9999, 1.0, 1.2499, 1.25)] == [
        "fail",
        "warn",
        "warn",
        "pass",
    ]
    assert status_above(float("nan"), 1.0) == "fail"
    assert worst([]) == "pass"


@pytest.mark.parametrize(("edge", "status"), [(0.99, "fail"), (1.01, "pass")])
def test_a_piece_of_less_than_a_cubic_millimetre_is_a_sliver(edge, status):
    piece = box([20, 0, 0], [21, 1, edge])
    both = trimesh.util.concatenate([box([0, 0, 0], [9, 9, 9]), piece])
    findings, mesh = check_solid("core", both, CUBE)
    by = {f.check: f for f in findings}
    assert (by["one solid"].status, by["one solid"].value) == ("fail", 2.0)
    assert by["one solid"].place_mm == pytest.approx((20.5, 0.5, edge / 2))
    assert (by["no slivers"].status, by["closed surface"].status) == (status, "pass")
    assert mesh is both
    limits = {f.check: (f.limit, f.unit) for f in findings}
    assert limits == {
        "one solid": (1.0, "solids"),
        "no slivers": (1.0, "mm³"),
        "closed surface": (1.0, ""),
    }
    whole, _ = check_solid("core", box([0, 0, 0], [9, 9, 9]), CUBE)
    assert [(f.check, f.status, f.value, f.place_mm) for f in whole] == [
        ("one solid", "pass", 1.0, None),
        ("no slivers", "pass", pytest.approx(729.0), pytest.approx((4.5, 4.5, 4.5))),
        ("closed surface", "pass", 1.0, None),
    ]
    open_ = box([0, 0, 0], [9, 9, 9])
    open_.update_faces(np.arange(len(open_.faces)) > 0)
    findings, mesh = check_solid("core", open_, CUBE)
    assert (findings[-1].status, findings[-1].value, mesh) == ("fail", 0.0, None)


@pytest.mark.parametrize(
    ("name", "core"), [("box", False), ("closed box", True), ("capsule", True), ("pad", False)]
)
def test_a_core_that_is_cast_in_must_not_meet_its_mould(name, core):
    """Boxes far from the object's own pins; core and half share 200 mm³, the jig is no part of it."""
    meshes = {
        "mould_half_a": box([900, 0, 0], [910, 10, 10]),
        "core": box([908, 0, 0], [920, 10, 10]),
        "jig": box([900, 0, 0], [910, 10, 10]),
    }
    (found,) = check_closing(worked(name), meshes)
    assert found.value == pytest.approx(200.0 if core else 0.0, abs=1e-6)


def test_without_the_parts_of_a_seal_mould_nothing_is_checked():
    assert not check_seal_mould(worked("cylinder"), {})


@pytest.mark.parametrize(("wall_mm", "width_mm"), [(0.8, 8.0), (3.0, 10.2)])
def test_a_flange_is_as_wide_as_walls_beside_its_bolts_need(wall_mm, width_mm):
    """Holes of Ø3.4, dowels of Ø4 in holes with 0.1 mm of play all round."""
    spec = worked("sphere")
    printer = spec.printer.changed(wall_mm=wall_mm, clearance_mm=0.1)
    assert flange_width_mm(spec.changed(printer=printer)) == pytest.approx(width_mm)


def on_a_jig(spec, shift_mm=(0.0, 0.0, 0.0)):
    """Findings on the jig of an object whose core is moved, as the wrong seat would move it."""
    make = sampled_core_part if body_of(spec).sampled else make_core
    core = convert_to_triangles(make(spec)).copy()
    core.apply_translation(shift_mm)
    jig = convert_to_triangles(make_jig(spec))
    found = check_tools(spec, {"core": core, "jig": jig})
    return {finding.check: finding for finding in found}["object on its jig"]


def lopsided(folder):
    """A ball of 44 mm whose lower end leans by 24°, from a file, on a bore of 8 mm."""
    ball = trimesh.creation.icosphere(4, 22.0)
    ball.vertices[:, 2] += 0.45 * ball.vertices[:, 1]
    ball.export(folder / "lopsided.stl")
    body = {"kind": "imported", "bore_mm": 8.0, "sensed_faces": [1]}
    content = {"name": "lopsided", "body": body | body_of_file(folder / "lopsided.stl")}
    content |= {"sensors": {"positions_mm": [[0.0, 0.0]], "radius_mm": 4.0}}
    content |= {"core": {"recess_inner_radius_mm": 1.5, "recess_outer_radius_mm": 6.5}}
    return ObjectSpec.model_validate(content)


def test_the_jig_s_post_is_judged_in_the_core_of_a_lopsided_body(tmp_path):
    """A post that is too high by a millimetre, as one by the flat's middle alone was, is found."""
    spec = lopsided(tmp_path)
    assert (on_a_jig(spec).status, on_a_jig(spec).value) == ("pass", 0.0)
    sunk = on_a_jig(spec, (0.0, 0.0, -1.0))
    assert (sunk.status, sunk.part) == ("fail", "jig")
    assert sunk.value == pytest.approx(1.0, abs=0.5), "by so much it stands too high"
    assert sunk.place_mm[2] < 0, "at the lower end"


PEAR = YCB / "YcbPear_vhacd.obj"


@pytest.mark.skipif(not PEAR.is_file(), reason=f"the scan {PEAR} is not on this machine")
def test_a_real_pear_stands_on_its_jig():
    """Its post ran 1.98 mm³ into the core, so that every press was 1.5 mm off in z."""
    body = {"kind": "imported", "scale": 1000.0, "sensed_faces": [1]} | body_of_file(PEAR, 1000.0)
    spec = ObjectSpec.model_validate({"name": "pear", "body": body, "sensors": {"radius_mm": 7.5}})
    stands = on_a_jig(spec)
    assert (stands.status, stands.value) == ("pass", 0.0)
    high = on_a_jig(spec, (0.0, 0.0, -1.5))
    assert high.status == "fail"
    assert high.value == pytest.approx(1.5, abs=0.5)


def test_a_template_is_judged_on_the_face_that_it_serves():
    """Of a cube with a bump of 2 × 2 × 2 mm under the middle of a template's sheet."""
    spec = worked("box")
    core = box([-13, -13, -13], [13, 13, 13])
    (first, numbers), *_ = template_faces(spec).items()
    frame = next(frame for frame in face_frames(spec) if frame.number == numbers[0])
    template = box([-15, -15, 0], [15, 15, 3])
    name = "magnet_template" if len(template_faces(spec)) == 1 else f"magnet_template_face_{first}"
    outside = frame.centre_mm + 1.0 * frame.normal
    bump = box(outside - 1, outside + 1)
    found = check_tools(spec, {"core": core, "shell": bump, name: template})
    worst_of = {finding.check: finding for finding in found}["template on its face"]
    assert worst_of.status == "fail"
    assert worst_of.value == pytest.approx(8.0, rel=1e-3)
    assert worst_of.place_mm == pytest.approx(outside, abs=1e-3)
    clear = check_tools(spec, {"core": core, name: template})
    assert {finding.status for finding in clear} == {"pass"}


def beside_a_jig(spec, meshes):
    """The finding on probes beside a jig, that core and jig alone do not concern."""
    found = check_tools(spec, meshes | {"core": CORE})
    return {finding.check: finding for finding in found}["probes clear of the jig"]


def test_a_probe_is_judged_beside_the_jig_where_it_comes_down_furthest():
    """By hand, of the paper's cube: at z = −13.5 a plate of 20 × 20 × 4 mm begins 15 − 4 mm outside the
    face and ends at −23.5; a plate without a pedestal, up to 16 mm outside, lies below −21."""
    spec = ObjectSpec(name="cube").changed(press={"depths_mm": (1.0, 4.0)})
    plate = box([-37, -37, -27], [37, 37, -21])
    meshes = {"jig": plate, "probe_1": convert_to_triangles(make_probe(spec, 1))}

    def beside(**grid):
        return beside_a_jig(spec.changed(contact_grid=grid), meshes)

    lowest = beside(count=(10, 10), pitch_mm=3.0)
    assert (lowest.status, lowest.part) == ("warn", "jig")
    assert lowest.value == pytest.approx(20 * 4 * 2.5, rel=0.05)
    assert "most: probe_1 and jig" in lowest.what
    middle = beside(count=(2, 2), pitch_mm=3.0)
    assert (middle.status, middle.value) == ("pass", 0.0)
    grid = {"count": (10, 10), "pitch_mm": 3.0}
    oblique = [
        spec.changed(contact_grid=grid, indenter={"direction_deg": (lean, 0.0)})
        for lean in (-30.0, 30.0)
    ]
    further = max(beside_a_jig(leaning, meshes).value for leaning in oblique)
    wanted = 20 * 4 * (2.5 + 4 * np.tan(np.pi / 6))
    assert further == pytest.approx(wanted, rel=0.05), "an oblique path leads down"


def tools_of(spec, *tips):
    probes = {f"probe_{count}": convert_to_triangles(make_probe(spec, count)) for count in tips}
    return {"jig": convert_to_triangles(make_jig(spec)), **probes}


@pytest.mark.parametrize("name", ["handle", "ball", "pear"])
def test_the_pedestal_of_an_example_s_jig_keeps_it_clear_of_every_probe(name):
    """Also by the three tips on a ball's slopes, whose plate comes down 10 mm below the ball."""
    spec = load_spec(ROOT / "examples" / f"{name}.toml")
    beside = beside_a_jig(spec, tools_of(spec, 1, 2, 3))
    assert (beside.status, beside.value) == ("pass", 0.0)


def test_locations_beside_the_rim_of_a_recess_cannot_be_pressed_and_are_told():
    """A closed cylinder lies 3 mm deep in its jig; the lowest presses on its side begin at its rim."""
    spec = body_spec("cylinder", body={"open_faces": []})
    spec = spec.changed(contact_grid={"count": "fill", "pitch_mm": 1.0})
    beside = beside_a_jig(spec, tools_of(spec, 1))
    assert beside.status == "warn"
    assert "hold the object otherwise" in beside.what


CORE = box([-5, -5, -5], [5, 5, 5])
"""A core that touches no jig."""
