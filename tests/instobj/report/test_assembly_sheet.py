"""Assembly sheet: figures by hand, every magnet's pole, every wire."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.build.amounts import printed_items, silicone_amount
from design.build.manifest import BuildManifest, PartManifest
from design.build.masses import mass_text
from design.build.order_list import order_list
from design.build.print_settings import PrintSettings
from design.build.slicing import PrintJob
from design.catalogue.bus_parts import MEGA2560
from design.layout.mould.pins import PinKind, loose_pins, pins_by_kind
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec
from design.wiring.bus_plan import all_plans, plan_or_none
from design.wiring.dealing import MIXED
from instobj.render.exploded_view import draw_exploded
from instobj.report.assembly_sheet import assembly_sheet
from instobj.report.assembly_steps import steps
from tests.support.pictures import save_dot


def parsed(**content):
    return parse_spec({"name": "t", **content}, "test")


def manifest_of(*names):
    box = ((0.0, 0.0, 0.0), (10.0, 20.0, 30.0))
    parts = [
        PartManifest(n, 6000.0, box, (5.0, 10.0, 15.0), 6, 1, 6000.0, True, 12, m, c)
        for n, m, c in names
    ]
    return BuildManifest("t", "0" * 64, tuple(parts), {})


BALL = {
    "magnets": {"positions_mm": [[0, 0]]},
    "sensors": {"positions_mm": [[0, 6]], "radius_mm": 6.0},
    "contact_grid": {"count": [3, 3]},
}
EVERY_PART = ("core", "shell", "jig", "magnet_template")
EXAMPLES = Path(__file__).parents[3] / "examples"
MANIFEST = manifest_of(
    ("core", "printed", 1), ("shell", "silicone", 1), ("mould_pin", "printed", 25)
)


def test_silicone_by_hand():
    amount = silicone_amount(parsed())
    volume = (
        42**3 - 26 * 26 * 34 - 25 * np.pi * 9 * 1
    ) / 1e3  # pockets are filled over the magnets
    assert_allclose(amount.volume_cm3, volume, rtol=1e-12)
    assert_allclose(amount.mass_g, 1.07 * volume, rtol=1e-12)
    assert_allclose(amount.parts_g, [1.15 * 1.07 * volume / 2] * 2, rtol=1e-12)
    unknown = parsed(silicone={"name": "own", "youngs_modulus_mpa": 0.3})
    assert silicone_amount(unknown).parts_g is None
    assert "as the maker says" in silicone_amount(unknown).mixing


def test_a_bay_in_a_closed_core_is_filled_and_closed_before_casting():
    closed = parsed(body={"open_faces": []}, core={"bay_mm": [9, 9, 9]})
    listed = steps(closed, ("core", "core_base", "core_lid"))
    order = [next(k for k, step in enumerate(listed) if word in step) for word in
             ("core.3mf is not printed", "charged battery into core_base", "release agent")]  # fmt: skip
    assert order == sorted(order)
    assert not any("core_lid" in step for step in steps(parsed(body={"open_faces": []}), ("core",)))


def test_prints_are_counted_and_weighed_as_solid():
    items = {item.item: item for item in printed_items(parsed(), MANIFEST)}
    pins = items["print mould_pin"]
    assert (pins.count, pins.volume_cm3) == (25, 150.0)
    assert_allclose(pins.mass_g, 150 * 1.27, rtol=1e-6)
    assert "print shell" not in items


def test_prints_have_time_and_filament_where_a_slicer_says_them(tmp_path):
    settings = PrintSettings(0.2, 4, 100, True, 0.0, (0.0, 0.0, -1.0))
    parts = [
        replace(p, printing=settings) if p.name in ("core", "mould_pin") else p
        for p in MANIFEST.parts
    ]
    manifest, picture = replace(MANIFEST, parts=tuple(parts)), tmp_path / "picture.png"
    save_dot(picture)
    pins = {"mould_pin": PrintJob(6.0, 0.5)}
    page = assembly_sheet(parsed(), manifest, picture, jobs=pins)
    assert "All pieces but for core, which PrusaSlicer refuses: 2 h 30 min and 12 g" in page, (
        "25 pins"
    )
    assert "<td>6 min</td>" in page
    assert "<td>–</td>" in page, "the core was refused"
    assert "With PrusaSlicer installed" in assembly_sheet(parsed(), manifest, picture)


def test_the_sheet_names_every_sensor_that_is_ordered(tmp_path):
    """Four chips of a bus have four addresses, which four orderable variants have."""
    spec = parsed()
    plan = next(plan for plan in all_plans(spec, MEGA2560).plans if plan.way == MIXED)
    ordered = order_list(spec, plan)
    pieces = {l.number: l.pieces for l in ordered if l.number.startswith("TMAG5273")}
    assert (len(pieces), sum(pieces.values())) == (4, 15)
    save_dot(tmp_path / "picture.png")
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png", (), plan, ordered)
    assert all(f"<td>{number}</td>" in page for number in pieces)


def test_the_sheet_shows_every_pole_and_every_wire(tmp_path):
    spec = parsed(magnets={"positions_mm": [[0, 0], [9, 8]], "north": ["outward", "inward"]})
    for name in ("core", "shell", "mould_box", "mould_plug"):
        trimesh.creation.box((20, 20, 20)).export(tmp_path / f"{name}.stl")
    picture = draw_exploded(spec, tmp_path, tmp_path / "exploded.png")
    page = assembly_sheet(spec, MANIFEST, picture, (), plan_or_none(spec, MEGA2560))
    faces = re.findall(r"<figure>.*?</figure>", page, re.S)
    assert len(faces) == 5
    assert page.count('<figure class="boards">') == 5
    assert mass_text(spec) in page
    for face in faces:
        poles = re.findall(r'cx="([-\d.]+)" cy="([-\d.]+)".*?>([NS])</text>', face)
        assert poles == [("0", "-0", "N"), ("9", "-8", "S")], "y points up, outward poles"
    assert len(re.findall(r"<td>\d+ to \d+</td>", page)) == 15
    assert "57 to 60" in page
    assert page.count(" buffered, read at 0x") == 15
    assert "<td>245</td>" in page, "face 1: 200 of lead, 7.75, 4.5 of wall, 29.5 to the opening"
    assert "http" not in page.replace("http-equiv", ""), "nothing is loaded from outside"


def test_the_sheet_shows_how_every_board_lies_and_where_its_chip_points(tmp_path):
    """Sensor 1 at azimuth 0, chip inward: board at (r, 0), X along −y (down), Y along +x (right)."""
    save_dot(tmp_path / "picture.png")
    spec = parsed(sensors={"first_azimuth_deg": [0.0, 90.0, 0.0, 0.0, 0.0]})
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png")
    faces = re.findall(r'<figure class="boards">.*?</figure>', page, re.S)
    assert [face.count("<polygon") for face in faces] == [3] * 5
    lines = [
        np.array(re.findall(r"M (\S+) (\S+) l (\S+) ([-\d.]+)", face), float) for face in faces
    ]
    x_axis, y_axis = lines[0][:2, 2:]
    assert x_axis[1] > 4
    assert abs(x_axis[0]) < 0.01
    assert y_axis[0] > 4
    assert abs(y_axis[1]) < 0.01
    at = lines[0][0, :2]
    assert at[0] > 5, "to the right of the middle"
    assert abs(at[1]) < 0.5
    assert lines[1][0, 1] < -5, "azimuth 90°: above the middle"


def test_faces_of_unequal_sizes_are_drawn_at_one_scale(tmp_path):
    """The widest is 55 mm wide; a magnet of 6 mm is as large on every face."""
    save_dot(tmp_path / "picture.png")
    spec = parsed(body={"size_mm": [60.0, 44.0, 50.0]})
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png")
    faces = re.findall(r'<svg width="([\d.]+)mm" viewBox="\S+ \S+ ([\d.]+) \S+">', page)
    widths, boxes = np.array(faces, float).T
    assert_allclose(boxes, 2 * [68, 58, 58, 58, 58])
    assert_allclose(widths, 55 / 68 * boxes, atol=0.01)


def test_sensors_that_the_paper_s_board_cannot_read_have_no_empty_column(tmp_path):
    save_dot(tmp_path / "picture.png")
    spec = parsed()
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png")
    assert "<th>on the Arduino Mega 2560</th>" not in page
    assert "No board of the catalogue can read these sensors" in page
    plan = plan_or_none(spec, MEGA2560)
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png", (), plan)
    assert "on the Arduino Mega 2560" in page
    assert "--board mega2560" in page
    assert "can read these sensors" not in page


def test_a_face_without_magnets_is_drawn_where_a_pin_stands_in_it(tmp_path):
    """A pin at (4, -9) of face 6, which senses nothing, beside one that forms a pocket of face 1."""
    save_dot(tmp_path / "picture.png")
    spec = parsed(
        body={"open_faces": [], "sensed_faces": [1, 2]}, magnets={"positions_mm": [[9, 8]]}
    )
    pins = [
        PinKind("mould_pin", 1, ((1, 9.0, 8.0),), False),
        PinKind("mould_locator_1", 1, ((6, 4.0, -9.0),), True),
    ]
    page = assembly_sheet(spec, MANIFEST, tmp_path / "picture.png", pins)
    faces = re.findall(r"<figure>.*?face (\d) .*?</figure>", page, re.S)
    assert faces == ["1", "2", "6"]
    (last,) = re.findall(r"<figure>(?:(?!<figure>).)*?face 6 .*?</figure>", page, re.S)
    assert re.findall(r'cx="(\S+)" cy="(\S+)"', last) == [("4", "9")]
    assert re.findall(r">(P\d)</text>", last) == ["P2"]


def test_a_body_without_template_and_jig_is_told_of_neither(tmp_path):
    """An imported body, closed: a dozen pins of several kinds, each with its places."""
    spec = load_spec(EXAMPLES / "pear.toml")
    kinds = pins_by_kind(spec)
    save_dot(tmp_path / "exploded.png")
    page = assembly_sheet(
        spec, manifest_of(("core", "printed", 1)), tmp_path / "exploded.png", kinds
    )
    assert "no magnet template" in page
    assert "Lay the magnet template" not in page
    assert "by the maps above" in page
    assert "on its jig" not in page
    assert "no printed jig" in page
    assert sum(kind.count for kind in kinds) == len(loose_pins(spec))
    rows = dict(re.findall(r"<td>(P\d+)</td><td>(\w+)</td>", page))
    assert list(rows.values()) == [kind.name for kind in kinds]
    marks = re.findall(r'fill="#444">(P\d+)</text>', page)
    assert len(marks) == sum(len(kind.places) for kind in kinds)
    for number, kind in enumerate(kinds, start=1):
        assert marks.count(f"P{number}") == len(kind.places)


def test_a_built_template_and_jig_are_told(tmp_path):
    save_dot(tmp_path / "exploded.png")
    names = [(name, "printed", 1) for name in EVERY_PART]
    page = assembly_sheet(parsed(), manifest_of(*names), tmp_path / "exploded.png")
    assert "Lay the magnet template" in page
    assert "by the template and the maps above" in page
    assert "on its jig" in page
    assert "Pins of the mould" not in page


def test_the_exploded_view_shows_magnets_of_both_poles_and_boards(tmp_path):
    from matplotlib.image import imread

    for name in ("core", "shell", "mould_box", "mould_plug"):
        size = 26 if name == "core" else 42
        trimesh.creation.box((size, size, size)).export(tmp_path / f"{name}.stl")
    spec = parsed(magnets={"positions_mm": [[-9, 0], [9, 8]], "north": ["outward", "inward"]})
    picture = imread(draw_exploded(spec, tmp_path, tmp_path / "exploded.png"))[..., :3]
    red, green, blue = np.moveaxis(picture, -1, 0)
    seen = {
        "north": (red > 2 * green) & (red > 2 * blue) & (red > 0.3),
        "south": (blue > 2 * red) & (blue > 1.5 * green) & (blue > 0.3),
        "boards": (green > 1.7 * red) & (green > 1.5 * blue),
    }
    for what, pixels in seen.items():
        assert pixels.mean() > 2e-4, what
    north, south, boards = (np.nonzero(seen[what])[0].mean() for what in seen)
    assert max(north, south) < boards, "the shell with its magnets stands above the core"


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ({}, "pot life 6 min"),
        (
            {"silicone": {"name": "mine", "youngs_modulus_mpa": 0.3}},
            "pot life see the maker's sheet",
        ),
        ({"silicone": {"name": "TPU 85A"}}, "Print the shell in TPU 85A"),
        ({"mould": {"style": "split"}}, "push all pins in"),
        ({"body": {"open_faces": []}}, "locating pins into the core's holes"),
        ({"body": {"open_faces": []}}, "Stand the mould on the corner"),
        ({"printer": {"name": "resin"}}, "inhibits platinum silicone"),
        ({"shell": {"seal_layer_mm": 0.8}}, "the layer of 0.8 mm"),
        ({"core": {"keys": {"positions_mm": [[11.4, 11.4]]}}}, "keys must snap"),
        (
            {"arrangement": "sensors-in-shell", "magnets": {"positions_mm": [[6, 6]]}},
            "Glue the magnets",
        ),
    ],
)
def test_steps_follow_the_object(content, told):
    assert any(told in step for step in steps(parsed(**content), EVERY_PART))


@pytest.mark.parametrize("open_faces", [[], [6]])
def test_a_mould_is_sprayed_before_it_is_closed_round_the_core(open_faces):
    spec = parsed(
        body={"kind": "sphere", "size_mm": [50, 50, 50], "open_faces": open_faces}, **BALL
    )
    (step,) = (step for step in steps(spec, EVERY_PART) if "release agent" in step)
    assert 0 <= step.index("Spray") < step.index("Join the mould's halves")


def test_a_plate_is_not_pushed_into_its_slab():
    told = " ".join(steps(load_spec(EXAMPLES / "hall_skin.toml"), ("core", "shell", "mould_box")))
    assert "Lay the shell on it" in told
    assert "Push it in" not in told
    assert "Push it in" in " ".join(steps(parsed(), EVERY_PART))


def test_without_a_mould_nothing_of_it_is_named():
    body = {"kind": "sphere", "size_mm": [60.0] * 3, "open_faces": [], "sensed_faces": [2]}
    blocked = ObjectSpec.model_validate(
        {
            "name": "t",
            "body": body,
            "magnets": {"positions_mm": [[3.0, 0.0]]},
            "core": {"wire_hole_side_diameter_mm": 44.0},
        }
    )
    told = " ".join(steps(blocked, ("core", "shell")))
    assert "No mould was built" in told
    assert "halves" not in told


def test_every_grade_has_its_places():
    magnets = {
        "positions_mm": [[0, 0], [9, 8], [-9, 8]],
        "north": ["outward", "inward", "inward"],
        "grade": ["N52", "N35", "N52"],
        "remanence_t": [1.43, 1.2, 1.46],
    }
    spec = parsed(magnets=magnets)
    told = " ".join(steps(spec, ["core", "shell"]))
    assert "On every face: magnets 1, 3 N52; magnet 2 N35." in told
    assert "several kinds" not in " ".join(steps(parsed(magnets={"grade": "N52"}), ["core"]))
