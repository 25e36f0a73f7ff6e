"""Fabrication checks: faults built on purpose must be found, with value, limit and place."""

import re
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.build.parts import Part
from design.errors import InputError, NotOneSolid
from design.fabrication.assembly import (
    check_electronics,
    check_pockets,
    check_wires,
)
from design.fabrication.casting import check_casting, check_closing, draws
from design.fabrication.check import check_fabrication, check_solid, mesh_of
from design.fabrication.finding import status_above
from design.fabrication.printing import (
    check_bed,
    check_edges,
    check_features,
    check_inhibition,
    check_walls,
)
from design.layout.mould.frame import mould_style, parting
from design.layout.mould.pins import loose_pins
from design.mould.halves import make_mould_half
from design.mould.one_piece import make_mould_box
from design.mould.plug import make_mould_plug
from design.solids.booleans import convert_to_triangles
from design.solids.core import make_core
from design.solids.primitives import box_between
from design.solids.sampled import sampled_core_part
from design.solids.shell import make_shell
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec
from tests.support.objects.body_cases import body_spec


def parsed(**content):
    return parse_spec({"name": "t", **content}, "test")


PAPER = parsed()
EXAMPLES = Path(__file__).parents[3] / "examples"
KEYS = {"core": {"keys": {"positions_mm": [[11.4, 11.2]]}}}


def found(findings, check, part=None):
    (finding,) = [f for f in findings if f.check == check and part in (None, f.part)]
    return finding


def part(name, shape, material="printed"):
    return Part(name, lambda: shape, material)


def test_slivers_beside_the_core_are_found():
    """The authors' core holds separate pieces of 0.54 mm³ (read off their public CAD)."""
    sliver = box_between((20.0, 0.0, 3.0), (20.9, 1.0, 3.6))
    broken = cq.Compound.makeCompound([make_core(PAPER), sliver])
    findings, mesh = check_solid("core", broken, PAPER)
    assert (found(findings, "one solid").status, found(findings, "one solid").value) == ("fail", 2)
    loose = found(findings, "no slivers")
    assert loose.status == "fail"
    assert_allclose(loose.value, 0.54, rtol=1e-9)
    assert_allclose(loose.place_mm, (20.45, 0.5, 3.3), rtol=0, atol=1e-3)
    convert_to_triangles, _ = check_solid("core", mesh_of(broken, PAPER), PAPER)
    assert_allclose(found(convert_to_triangles, "no slivers").value, 0.54, rtol=1e-6)
    whole, _ = check_solid("core", make_core(PAPER), PAPER)
    assert {finding.status for finding in whole} == {"pass"}
    assert mesh is not None


def test_a_void_inside_a_body_is_no_second_body():
    """A shell cast round a core that nothing reaches is one body with two surfaces."""
    hollow = trimesh.boolean.difference([trimesh.creation.box((9, 8, 7)), trimesh.creation.box()])
    assert len(hollow.split(only_watertight=False)) == 2
    findings, _ = check_solid("shell", hollow, PAPER)
    assert found(findings, "one solid").status == "pass"
    assert_allclose(found(findings, "no slivers").value, 9 * 8 * 7, rtol=1e-9)


def test_a_wall_of_0_38_mm_is_found():
    """The authors' core thins to 0.38 mm: here between the recesses and the Ø4 wire hole."""
    thin = parsed(core={"recess_inner_radius_mm": 2.38})
    (wall,) = check_walls(part("core", None), mesh_of(make_core(thin), thin), thin)
    assert wall.status == "fail"
    assert_allclose(wall.value, 0.38, rtol=0, atol=0.04)
    assert_allclose(np.sort(abs(np.array(wall.place_mm)))[-1], 12, rtol=0, atol=1.6)
    (sound,) = check_walls(part("core", None), mesh_of(make_core(PAPER), PAPER), PAPER)
    assert sound.status == "pass"
    assert_allclose(sound.value, 1.5, rtol=1e-4)  # between a recess 3 deep and the cavity, 4.5 wide


def test_a_chip_that_meets_its_recess_is_found():
    """In the authors' core chip and recess share 0.2 mm of depth."""
    shallow = PAPER.changed(core=PAPER.core.changed(recess_depth_mm=2.65))
    findings = check_electronics(shallow, mesh_of(make_core(shallow), shallow))
    deep = found(findings, "board in its recess, deep")
    assert deep.status == "fail"
    assert_allclose(deep.value, -0.2, rtol=0, atol=1e-9)
    common = found(findings, "boards and chips clear of the core")
    assert common.status == "fail"
    assert_allclose(common.value, 2.9 * 2.8 * 0.2, rtol=1e-6)
    for finding in check_electronics(PAPER, mesh_of(make_core(PAPER), PAPER)):
        assert finding.status == "pass", finding


def test_boards_that_overlap_and_wires_too_thick_are_found():
    crowded = parsed(sensors={"count_per_face": 4, "frame_rate_hz": 5.0})
    findings = check_electronics(crowded, mesh_of(make_core(crowded), crowded))
    assert found(findings, "boards clear of each other").status == "pass"
    wide = PAPER.changed(
        sensors=PAPER.sensors.changed(package_mm=(8.5, 6.2, 1.6)),
        core=PAPER.core.changed(wire_hole_side_diameter_mm=1.6, wire_hole_top_diameter_mm=1.6),
    )
    findings = check_electronics(wide, mesh_of(make_core(wide), wide))
    assert found(findings, "board in its recess, across").value == pytest.approx(-0.75)
    assert found(findings, "boards and chips clear of the core").status == "fail"
    assert found(findings, "wires in their hole").status == "fail"


def test_all_wires_have_a_way_out():
    """Six faces of 12 wires of 0.4 mm leave by two holes of 2 mm, which take 0.7 · (2 / 0.4)² = 17 each."""
    core = {
        "wires_per_sensor": 12,
        "wire_hole_side_diameter_mm": 2.0,
        "wire_hole_top_diameter_mm": 2.0,
    }
    spec = body_spec("closed_box", core=core)
    way = found(check_electronics(spec, mesh_of(make_core(spec), spec)), "wires in their way out")
    assert (way.status, way.value) == ("fail", 2 * 17 - 72)


def test_boards_in_the_same_place_share_their_overlap():
    """Two boards of 6.6 × 6.2 × 1.6 mm, turned alike, 1.5 mm apart along their width or length."""
    sensors = PAPER.sensors.changed(positions_mm=[[[2.0, 0.0], [3.5, 0.0]]] * 5, count_per_face=2)
    findings = check_electronics(PAPER.changed(sensors=sensors), mesh_of(make_core(PAPER), PAPER))
    shared = found(findings, "boards clear of each other")
    assert shared.status == "fail"
    assert_allclose(shared.value, 6.6 * (6.2 - 1.5) * 1.6, rtol=1e-6)


def test_thin_silicone_is_found_where_it_is():
    close = parsed(magnets={"positions_mm": [[0, 0], [6.6, 0], [-9, 4]]})
    findings = check_pockets(close)
    spacing = found(findings, "pocket spacing")
    assert spacing.status == "fail"
    assert_allclose(spacing.value, 0.6, rtol=0, atol=1e-9)
    shell = mesh_of(make_shell(close), close)
    (wall,) = check_walls(part("shell", None, "silicone"), shell, close)
    assert wall.status == "fail"
    assert_allclose(wall.value, 0.6, rtol=0, atol=0.1)  # by rays, between facets of both pockets
    deep = parsed(shell={"pocket_depth_mm": 7.3}, magnets={"positions_mm": [[1, 2]]})
    breakthrough = found(check_pockets(deep), "breakthrough")
    assert (breakthrough.status, breakthrough.value) == ("fail", pytest.approx(0.7))
    high = parsed(magnets={"depth_mm": 1.2})
    assert found(check_pockets(high), "seal over the magnets").value == pytest.approx(0.7)


def meshes_of(spec):
    parts = {"mould_plug": make_mould_plug, "shell": make_shell}
    if mould_style(spec) == "one-piece":
        parts["mould_box"] = make_mould_box
    else:
        parts["mould_half_a"] = lambda spec: make_mould_half(spec, 1)
    return {name: mesh_of(make(spec), spec) for name, make in parts.items()}


def test_the_papers_box_is_peeled_off_its_side_bosses():
    findings = check_casting(PAPER, meshes_of(PAPER))
    hook = found(findings, "undercut", "mould_box")
    assert hook.status == "pass", "the plug leaves room, and the strain is small"
    assert_allclose(hook.value, 3.0, rtol=0, atol=1e-6)
    assert "565 mm²" in hook.what  # the lower halves of 20 bosses: 20 · π · 3 · 3
    assert found(findings, "undercut", "mould_plug").value == 0
    assert found(findings, "draft", "mould_box").status == "warn"
    assert found(findings, "air traps").status == "pass"
    ceiling = found(findings, "flat ceilings")
    assert (ceiling.status, ceiling.value) == ("warn", pytest.approx(26 * 26))
    assert found(findings, "pour opening").value == pytest.approx(6.0)


def test_keys_on_the_plug_need_the_split_mould():
    closed = parsed(**KEYS)
    hook = found(check_casting(closed, meshes_of(closed)), "undercut", "mould_plug")
    assert hook.status == "fail"
    assert_allclose(hook.value, 1.5, rtol=0, atol=1e-6)
    assert "split" in hook.what
    split = parsed(**KEYS, mould={"style": "split"})
    findings = check_casting(split, meshes_of(split))
    assert found(findings, "undercut", "mould_plug").status == "pass"
    assert found(findings, "undercut", "mould_half_a").value == 0


def test_a_seam_beside_the_edges_is_an_undercut():
    skew = parsed(mould={"style": "split", "parting_azimuth_deg": 20.0})
    hook = found(check_casting(skew, meshes_of(skew)), "undercut", "mould_half_a")
    assert hook.status == "fail"
    assert "Turn the seam" in hook.what
    assert hook.value > 1


def test_stiff_rubber_may_not_be_peeled():
    stiff = parsed(silicone={"elongation_percent": 60.0})
    hook = found(check_casting(stiff, meshes_of(stiff)), "undercut", "mould_box")
    assert hook.status == "fail"
    assert not check_casting(parsed(silicone={"name": "TPU 85A"}), {})


def test_every_part_of_the_mould_is_drawn_once_and_the_halves_apart():
    spec = parsed(mould={"style": "split"})
    drawn = draws(spec)
    assert [draw.part for draw in drawn] == [
        *("mould_pin", "mould_half_a", "mould_half_b", "mould_plug")
    ]
    assert_allclose(drawn[1].pull, parting(spec).normal)
    assert_allclose(drawn[2].pull, -parting(spec).normal)


def test_printers_limits():
    small = parsed(printer={"bed_mm": [40.0, 60.0, 60.0]})
    (bed,) = check_bed(part("box", None), mesh_of(make_mould_box(small), small), small)
    assert (bed.status, bed.value) == ("fail", pytest.approx(-5.0))
    needle = parsed(
        magnets={"diameter_mm": 0.6, "positions_mm": [[0, 0]]},
        shell={"pocket_diameter_mm": 0.6},
        core={"wire_hole_top_diameter_mm": 0.5},
    )
    faults = {(f.check, f.part) for f in check_features(needle) if f.status != "pass"}
    assert faults == {
        ("smallest feature", "core"),
        ("smallest feature", "mould_box"),
        ("slenderness", "mould_box"),
    }
    assert all(f.status == "pass" for f in check_features(PAPER))


def test_features_are_told_with_their_places():
    """By hand, of the paper's cube: a core of 26 mm from face 6 at −21 up to 13, magnets in pockets 4.5 mm
    from its middle."""
    narrow = parsed(
        core={"wire_hole_side_diameter_mm": 0.5, "wire_channel_mm": [0.4, 1.0]} | KEYS["core"]
    )
    places = {f.what.split(":")[0]: f.place_mm for f in check_features(narrow)}
    assert None not in places.values()
    assert places["wire hole, top"] == (0.0, 0.0, 13.0)
    assert places["wire hole, sides"] == (0.0, -13.0, 0.0)
    assert places["anti-slip key"][:2] == (11.4, 11.2)
    (wires,) = [
        f
        for f in check_electronics(narrow, mesh_of(make_core(PAPER), PAPER))
        if f.check == "wires in their hole"
    ]
    assert (wires.status, wires.place_mm) == ("fail", (0.0, -13.0, 0.0))
    assert "core.wire_hole_side_diameter_mm to" in wires.what


def test_holes_that_a_body_does_not_have_are_not_told():
    """A pad has a wire hole on its face 1 alone, an egg's has the diameter of those at the sides."""
    for kind, key in (
        ("pad", "wire_hole_side_diameter_mm"),
        ("ellipsoid", "wire_hole_top_diameter_mm"),
    ):
        spec = body_spec(kind, core={key: 0.5})
        assert not [f for f in check_features(spec) if f.status == "fail"], kind
        assert check_wires(spec).status == "pass"


@pytest.mark.parametrize(
    ("table", "change", "check", "key"),
    [
        ("core", {"wire_hole_top_diameter_mm": 0.5}, check_features, "wire_hole_top_diameter_mm"),
        ("core", {"wire_hole_side_diameter_mm": 0.5}, check_features, "wire_hole_side_diameter_mm"),
        ("core", {"wire_channel_mm": [0.4, 1.0]}, check_features, "wire_channel_mm"),
        ("shell", {"slits": {"depth_mm": 5.0, "width_mm": 0.5}}, check_features, "slits.depth_mm"),
    ],
)
def test_the_value_that_a_finding_tells_passes(table, change, check, key):
    def told(spec):
        pattern = rf"{table}\.{re.escape(key)} (?:of|to) ([\d.]+)"
        texts = [f.what for f in check(spec) if f.status != "pass"]
        return [float(found[1]) for text in texts if (found := re.search(pattern, text))]

    def changed_to(value):
        *outer, last = key.split(".")
        written = {last: [value, 1.0] if last == "wire_channel_mm" else value}
        return parsed(**{table: {outer[0]: change[outer[0]] | written} if outer else written})

    (value,) = told(parsed(**{table: change}))
    assert not told(changed_to(value))
    worse = 1.05 if key.endswith("depth_mm") else 0.95
    assert told(changed_to(worse * value)) == [value]


def test_a_printers_profile_is_a_file_that_users_edit(tmp_path):
    spec = tmp_path / "cube.toml"
    spec.write_text('name = "cube"\nprinter = "bench.toml"\n')
    with pytest.raises(InputError, match=r"no printer profile at .*bench\.toml"):
        load_spec(spec)
    profile = tmp_path / "bench.toml"
    profile.write_text('name = "resin"\nwall_mm = 0.7\n')
    printer = load_spec(spec).printer
    assert (printer.name, printer.preset.process, printer.wall_mm) == ("resin", "resin", 0.7)
    profile.write_text('name = "bench"\nwall_mm = 0.7\n')
    with pytest.raises(InputError, match="'bench' is not in the catalogue"):
        load_spec(spec)


def test_platinum_silicone_on_resin_prints_is_warned_of():
    cases = {
        ("resin", "Platsil Gel-10"): "warn",
        ("fdm-0.4", "Platsil Gel-10"): "pass",
        ("resin", "TPU 85A"): "pass",
    }
    for (printer, silicone), status in cases.items():
        spec = parsed(printer={"name": printer}, silicone={"name": silicone})
        assert check_inhibition(spec)[0].status == status


def test_knife_edges_are_warned_of():
    wedge = cq.Solid.makeWedge(10, 4, 20, 0, 0, 0, 20)
    (edge,) = check_edges(part("wedge", wedge), mesh_of(wedge, PAPER))
    assert edge.status == "warn"
    assert_allclose(edge.value, np.degrees(np.arctan2(4, 10)), rtol=1e-6)
    ridge = [(0, 0), (10, 0), (10, 5), (5.002, 5), (5, 5.004), (4.998, 5), (0, 5)]  # 53°, no part's
    extruded = cq.Workplane().polyline(ridge).close().extrude(10).val()
    assert check_edges(part("ridge", extruded), mesh_of(extruded, PAPER))[0].value > 89.9
    box = box_between((0.0, 0.0, 0.0), (1.0, 2.0, 3.0))
    assert check_edges(part("box", box), mesh_of(box, PAPER))[0].value == pytest.approx(90)


def test_limits_are_met_by_equality():
    assert status_above(1.0, 1.0) == status_above(1 - 1e-9, 1.0) == "pass"
    assert status_above(0.99, 1.0) == status_above(float("nan"), 1.0) == "fail"
    assert status_above(1.1, 1.0, 1.25) == "warn"


def test_pieces_are_handed_on():
    with pytest.raises(NotOneSolid) as caught:
        make_core(
            PAPER.model_copy(
                update={
                    "core": PAPER.core.model_copy(
                        update={
                            "wire_hole_top_diameter_mm": 60.0,
                            "wire_hole_side_diameter_mm": 60.0,
                        }
                    )
                }
            )
        )
    assert caught.value.shape.Volume() >= 0


@pytest.mark.slow
def test_a_sampled_part_in_pieces_is_a_finding_and_the_checks_go_on():
    wide = {"wire_hole_side_diameter_mm": 24.0}  # leaves four corners of a core 44 × 34 × 28 mm
    checked = check_fabrication(body_spec("ellipsoid", core=wide, mesh={"envelope_mm": 0.6}))
    whole = found(checked.findings, "one solid", "core")
    assert (whole.status, whole.value) == ("fail", 4)
    assert abs(np.asarray(whole.place_mm))[:2].min() > 8
    assert found(checked.findings, "fits the bed", "core").status == "pass"
    assert found(checked.findings, "one solid", "probe_3").status == "pass"


@pytest.mark.slow
def test_the_papers_object_passes_with_the_warnings_it_deserves():
    checked = check_fabrication(PAPER)
    assert not [f for f in checked.findings if f.status == "fail"]
    warned = {f.check for f in checked.findings if f.status == "warn"}
    assert warned == {"draft", "flat ceilings"}


def test_heads_of_pins_leave_the_plug_its_room():
    """Clips that reached below the rim shared 2 × 13.19 mm³ with the heads of these pins."""
    text = {"mould": {"style": "split"}, "magnets": {"positions_mm": [[14, 0], [-14, 0]]}}
    spec = parse_spec({"name": "cube", **text}, "test")
    plug = make_mould_plug(spec)
    (closes,) = check_closing(spec, {"mould_plug": convert_to_triangles(plug)})
    assert (closes.status, closes.value) == ("pass", 0)


def test_rims_of_heads_beside_the_open_end_of_a_cylinder_stay_below_the_clips():
    """By hand: the clips end at the rim, 30 mm from the middle; the pocket's edge is at 29.5 mm."""
    body = {"kind": "cylinder", "size_mm": [50, 50, 60], "open_faces": [6]}
    content = {"name": "c", "body": body | {"sensed_faces": [2, 3, 4, 5]}}
    content |= {"mould": {"style": "split"}, "magnets": {"positions_mm": [[26.5, 0.0]]}}
    pins = loose_pins(ObjectSpec.model_validate(content))
    assert len(pins) == 4
    assert_allclose([pin.rim_mm for pin in pins], 30 - 0.1 - 29.5, atol=1e-9)


@pytest.mark.slow
def test_locating_pins_meet_the_core_s_holes_where_the_surface_leans():
    """A closed pear with magnets at its patches' sides: pins along the surface's normal cut 51.5 mm³."""
    changes = ["body.open_faces=[]", "magnets.positions_mm=[[9,0],[-9,0]]"]
    spec = load_spec(EXAMPLES / "pear.toml", changes)
    (closes,) = check_closing(spec, {"core": sampled_core_part(spec)})
    assert closes.status == "pass"
    assert closes.value < 1
