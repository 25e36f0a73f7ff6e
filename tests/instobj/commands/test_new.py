"""`instobj new`: the template's comments with what was placed, for every kind of body."""

import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
import trimesh

from design.body.castable import noise_mm, traits_of_scan
from design.body.kinds.registry import KINDS
from design.errors import InputError, InstobjError
from design.fabrication.check import Checked, check_fabrication
from design.fabrication.finding import Finding, worst
from design.placement.objects import Request
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.cli.app import with_joined_sizes
from instobj.commands import new
from instobj.commands.new import new_specification, request_of, size_of
from instobj.commands.run import check
from tests.support.cli import run

ROOT = Path(__file__).parents[3]
TEMPLATE = ROOT / "instobj" / "templates" / "cube.toml"
PEAR = ROOT / "examples" / "bodies" / "pear.stl"
SIZES = {
    "box": (60.0, 40.0, 30.0),
    "pad": (60.0, 42.0, 11.0),
    "cylinder": (42.0, 42.0, 60.0),
    "capsule": (44.0, 44.0, 76.0),
    "sphere": (50.0, 50.0, 50.0),
    "ellipsoid": (60.0, 48.0, 48.0),
    "dome": (44.0, 44.0, 28.0),
}


def placed_tables(kind):
    """One magnet and one sensor in the middle, as tables that name every key that is placed."""
    tables = {
        "body": {"kind": kind, "size_mm": [1.0, 2.0, 3.0]},
        "shell": {"thickness_mm": 1.0, "pocket_diameter_mm": 2.0, "pocket_depth_mm": 0.5},
        "magnets": {"diameter_mm": 3.0, "positions_mm": [[0.0, 0.0], [1.0, -2.5]]},
        "contact_grid": {"count": [5, 5], "pitch_mm": 1.5},
        "indenter": {"radius_mm": 3.0},
        "press": {"depths_mm": [0.25, 0.5]},
        "core": {"wall_mm": 5.0, "recess_inner_radius_mm": 0.25},
        "sensors": {"radius_mm": 3.5, "positions_mm": [[0.0, 0.0]], "count_per_face": 1},
    }
    if kind == "imported":
        tables["body"] |= {"file": str(PEAR), "scale": 20.0}
    return tables


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_gets_its_own_lines_with_what_was_placed(kind, tmp_path):
    tables = placed_tables(kind)
    path = new_specification(
        "mine", tmp_path, Request(kind, (1.0, 2.0, 3.0)), lambda _: (tables, [])
    )
    text = path.read_text()
    read = tomllib.loads(text)
    assert read.pop("name") == "mine"
    named = {f"{t}.{k}": v for t, keys in tables.items() for k, v in keys.items()}
    if kind == "imported":
        del named["body.size_mm"]
        named["body.file"] = read["body"]["file"]
        assert (tmp_path / named["body.file"]).resolve() == PEAR
    cube = tomllib.loads(TEMPLATE.read_text())
    for where, value in named.items():
        table, key = where.split(".")
        assert read.get(table, {}).get(key, cube[table].get(key)) == value, where
    for table, keys in read.items():
        for key, value in keys.items():
            if f"{table}.{key}" not in named and not isinstance(value, dict):
                assert cube[table][key] == value, f"{table}.{key} was changed"
    assert ("scale = " in text) is (kind == "imported")
    assert_comments_of_the_kind(kind, text)


def assert_comments_of_the_kind(kind, text):
    """Not the cube's: other kinds by name, what its size, its opening and its slits are."""
    beside = {line.split(" = ")[0]: line.partition("  # ")[2] for line in text.splitlines()}
    others = re.findall(r"\w+", re.findall(rf'^kind = "{kind}".*?# or (.*?):', text, re.M)[0])
    assert {*others, kind} == set(KINDS)
    if kind not in ("box", "imported"):
        assert any(word in text.partition("[shell]")[0] for word in ("diameter", "slab"))
        assert "cube" not in text.partition("[shell]")[0].replace("that of the cube of Knopke", "")
    if "open_faces" in text:
        bored = kind in ("sphere", "ellipsoid", "capsule", "imported")
        assert ("a bore" in beside["open_faces"]) is bored


def test_faces_that_are_left_out_are_told(tmp_path):
    tables = placed_tables("box")
    tables["body"]["sensed_faces"] = [2, 4]
    with pytest.warns(UserWarning, match="only faces 2 and 4 can take 3 sensors"):
        path = new_specification(
            "mine", tmp_path, Request("box", (1.0, 2.0, 3.0)), lambda _: (tables, [])
        )
    assert tomllib.loads(path.read_text())["body"]["sensed_faces"] == [2, 4]


def test_parts_longer_than_the_printers_bed_take_a_larger_one(tmp_path):
    """The largest bed of the catalogue takes 60 mm more along one edge, 80 mm along two."""
    for name, short, given, said in (
        (
            "mine",
            3.0,
            300.0,
            r"3 mm too large for a printer of 220 × 220 × 240 mm: printer\.bed_mm",
        ),
        ("longer", 70.0, 300.0, r"70 mm too large .* check --fabrication says"),
        ("larger", 90.0, None, r"90 mm too large .* and for one of 300 × 300 × 300 mm"),
    ):
        bed = Finding("fits the bed", "mould_half_a", -short, 0.0, "mm", "fail", "")
        request = Request("box", (200.0, 50.0, 50.0))
        with pytest.warns(UserWarning, match=said) as told:
            path = new_specification(
                name, tmp_path, request, lambda _, bed=bed: (placed_tables("box"), [bed])
            )
        assert len(told) == 1
        printer = tomllib.loads(path.read_text()).get("printer")
        assert printer == (given and {"bed_mm": [given] * 3})


THIN = Finding("thinnest wall", "mould_half_a", 0.5, 0.8, "mm", "fail", "thicken it")
THIN_CORE = Finding("thinnest wall", "core", 0.5, 0.8, "mm", "fail", "thicken it")
HOOKED = Finding("undercut", "mould_half_a", 1.9, 0.14, "mm", "fail", "leave out what hooks")
RIM = Finding("rim of the pins' heads", "mould_pin", 0.2, 0.4, "mm", "fail", "move pockets apart")


def of_all(thickness):
    """Seams of a ball's shell: as placed, and turned by 6° either way."""
    return [(thickness, None), (thickness, 51.0), (thickness, 39.0)]


@pytest.mark.parametrize(
    ("failing", "asked", "taken", "failed"),
    [
        ([[]], [(8, None)], 0, []),
        ([[THIN], []], [(8, None), (8, 51.0)], 1, []),
        ([[THIN], [THIN], []], [(8, None), (8, 51.0), (8, 39.0)], 2, []),
        ([[THIN_CORE], []], [(8, None), (7, None)], 1, []),
        ([[THIN, RIM], [RIM], []], [(8, None), (7, None), (6, None)], 2, []),
        ([[RIM], [RIM]], [(8, None), (7, None)], 0, [RIM]),
        ([[RIM, THIN_CORE], [RIM], [RIM]], [(8, None), (7, None), (6, None)], 1, [RIM]),
        ([[HOOKED]], [(8, None)], 0, [HOOKED]),
        ([[THIN]] * 3 + [[THIN]] * 3 + [[]], [*of_all(8), *of_all(7), (6, None)], 6, []),
        ([[THIN]] * 9, [*of_all(8), *of_all(7), *of_all(6)], 0, [THIN]),
    ],
)
def test_what_is_placed_is_tried_until_it_can_be_made(monkeypatch, failing, asked, taken, failed):
    """The seam is turned where the mould's walls are thin; other shells where it is anything else."""
    tried = []

    def checked(spec, **_):
        tried.append((spec.shell.thickness_mm, spec.mould.parting_azimuth_deg))
        return Checked(failing[len(tried) - 1], {})

    body = {"kind": "sphere", "size_mm": [60.0] * 3}
    shells = [{"body": body, "shell": {"thickness_mm": thick}} for thick in (8.0, 7.0, 6.0)]
    monkeypatch.setattr(new, "placements", lambda request: iter(shells))
    monkeypatch.setattr(new, "leaves_walls", lambda tables: True)
    monkeypatch.setattr(new, "relaid", lambda request, tables: iter(()))
    monkeypatch.setattr("design.fabrication.check.check_fabrication", checked)
    tables, found = new.made(Request("sphere", (60.0, 60.0, 60.0)))
    assert tried == asked
    assert tables["shell"]["thickness_mm"] == asked[taken][0]
    assert tables.get("mould", {}).get("parting_azimuth_deg") == asked[taken][1]
    assert found == failed


@pytest.mark.parametrize(
    ("clear", "asked"),
    [({(8, 39), (7, None)}, [(8, 39), (7, None)]), ({(6, 51)}, [(6, 51)]), (set(), [(8, None)])],
)
def test_only_seams_that_leave_walls_are_tried_unless_there_are_none(monkeypatch, clear, asked):
    tried = []

    def seam(spec):
        return spec.shell.thickness_mm, spec.mould.parting_azimuth_deg

    def checked(spec, **_):
        tried.append(seam(spec))
        return Checked([THIN], {})

    body = {"kind": "sphere", "size_mm": [60.0] * 3}
    shells = [{"body": body, "shell": {"thickness_mm": thick}} for thick in (8.0, 7.0, 6.0)]
    monkeypatch.setattr(new, "placements", lambda request: iter(shells))
    monkeypatch.setattr(new, "leaves_walls", lambda tables: seam(new.spec_of(tables)) in clear)
    monkeypatch.setattr(new, "relaid", lambda request, tables: iter(()))
    monkeypatch.setattr("design.fabrication.check.check_fabrication", checked)
    assert new.made(Request("sphere", (60.0, 60.0, 60.0)))[1] == [THIN]
    assert tried == asked


@pytest.mark.parametrize(
    ("clear", "failing", "taken"),
    [
        ({(7, 2.0)}, [[]], (7, 2.0)),  # of no shell's own magnets
        ({(8, None), (8, 3.0)}, [[THIN], []], (8, 3.0)),
        ({(8, None), (7, 1.0), (7, 2.0)}, [[THIN], [THIN], [RIM]], (8, None)),
        ({(8, None), (8, 1.0)}, [[RIM, THIN]], (8, None)),  # which magnets elsewhere do not mend
    ],
)
def test_where_no_seam_leaves_walls_magnets_go_elsewhere(monkeypatch, clear, failing, taken):
    """Of a file's body with nine magnets per face (random request 63) every seam met a pin."""
    tried = []

    def of(tables):
        magnets = tables.get("magnets", {}).get("positions_mm", [[None]])
        return tables["shell"]["thickness_mm"], magnets[0][0]

    def checked(tables, **_):
        tried.append(of(tables))
        return Checked(failing[len(tried) - 1], {})

    def relaid(request, tables):
        return iter(tables | {"magnets": {"positions_mm": [[x, 0.0]]}} for x in (1.0, 2.0, 3.0))

    shells = [{"shell": {"thickness_mm": thick}} for thick in (8.0, 7.0)]
    monkeypatch.setattr(new, "placements", lambda request: iter(shells))
    monkeypatch.setattr(new, "seams_of", lambda tables: iter([tables]))
    monkeypatch.setattr(new, "spec_of", lambda tables: tables)
    monkeypatch.setattr(new, "parts_somewhere", lambda tables: True)
    monkeypatch.setattr(new, "leaves_walls", lambda tables: of(tables) in clear)
    monkeypatch.setattr(new, "relaid", relaid)
    monkeypatch.setattr("design.fabrication.check.check_fabrication", checked)
    tables, _ = new.made(Request("sphere", (60.0, 60.0, 60.0)))
    assert of(tables) == taken
    assert len(tried) == len(failing)


def test_what_no_placement_mends_is_told_with_its_numbers(tmp_path):
    hooked = (placed_tables("box"), [HOOKED])
    with pytest.warns(
        UserWarning, match=r"mould_half_a, undercut: 1\.9 mm, limit 0\.14\. leave out"
    ):
        new_specification("mine", tmp_path, Request("box", (50.0, 50.0, 50.0)), lambda _: hooked)


BALL = {"body": {"kind": "sphere", "size_mm": [60.0] * 3}}


@pytest.mark.parametrize(
    ("clear", "failed", "tables", "said"),
    [
        (True, [THIN], BALL, "to where pins and holes leave it walls, does not make them thicker"),
        (
            False,
            [THIN],
            BALL,
            "turned by up to 90°, meets a pin, a pouring hole or a vent wherever",
        ),
        (False, [THIN], BALL | {"mould": {"parting_azimuth_deg": 51.0}}, "does not make them"),
        (True, [THIN, HOOKED], BALL, None),
        (True, [THIN], {"body": {"size_mm": [60.0] * 3}}, None),
    ],
)
def test_why_no_turn_of_the_seam_helps_is_told(monkeypatch, clear, failed, tables, said):
    """Not where anything else fails, for which it is not turned, nor of a mould in one piece."""
    monkeypatch.setattr("design.mould.openings.holes_thin_walls", lambda spec: not clear)
    told = new.told_unmade(failed, tables)
    assert ("seam" in told.partition("thicken it")[2]) is (said is not None)
    assert said is None or said in told


def test_seams_are_turned_to_where_neither_pins_nor_holes_are(monkeypatch):
    """By 6° and 12° one way holes are beside it, by 6° the other way a pin, as placed both."""
    monkeypatch.setattr(
        "design.mould.openings.holes_thin_walls",
        lambda spec: spec.mould.parting_azimuth_deg in (None, 51.0, 57.0),
    )
    monkeypatch.setattr(
        "design.layout.mould.pins.pins_thin_the_seam",
        lambda spec: spec.mould.parting_azimuth_deg in (None, 39.0),
    )
    clear = filter(new.leaves_walls, new.seams_of(BALL))
    turned = [one["mould"]["parting_azimuth_deg"] for one in clear]
    assert turned[:4] == [33.0, 63.0, 27.0, 75.0]


def test_seams_go_into_windows_between_pins_that_turns_miss(monkeypatch):
    """Nine magnets a face of an ellipsoid left three windows, of 1 to 4° each."""
    monkeypatch.setattr("design.mould.openings.holes_thin_walls", lambda spec: False)
    for module in ("design.layout.mould.pins", "design.fit.seam"):
        monkeypatch.setattr(
            f"{module}.pins_thin_the_seam",
            lambda spec: not 70.0 < (spec.mould.parting_azimuth_deg or 0.0) < 74.5,
        )
    (turned,) = filter(new.leaves_walls, new.seams_of(BALL))
    assert turned["mould"]["parting_azimuth_deg"] == 72.0, "the middle of the window"


def test_the_seam_of_a_file_s_body_goes_where_it_hooks_least_deep(monkeypatch):
    """A lump's stood where 0.21 mm hooked, of 0.16 mm that give way; turned by 95° 0.13 mm do, by 97°
    0.11 mm."""
    depths = {None: 0.206, 95.0: 0.13, 97.0: 0.11, 96.0: 0.118, 30.0: 0.161}

    def azimuth(tables):
        return tables.get("mould", {}).get("parting_azimuth_deg")

    def deep(spec):
        return depths.get(spec.mould.parting_azimuth_deg, 0.3)

    monkeypatch.setattr(new, "undercut_depth_mm", deep)
    monkeypatch.setattr("design.placement.hooking.undercut_depth_mm", deep)
    lump = {"body": {"kind": "imported", "file": str(PEAR), "size_mm": [60.0] * 3}}
    assert [azimuth(tables) for tables in new.seams_of(lump)] == [97.0, 96.0, 95.0]
    depths[None] = 0.15
    assert [azimuth(tables) for tables in new.seams_of(lump)] == [None, 97.0, 96.0, 95.0]
    depths.clear()
    assert [*new.seams_of(lump)] == [lump], "no turn helps"
    assert next(new.seams_of(BALL)) == BALL, "kinds know where theirs hooks nothing"
    whole = {"body": {"size_mm": [60.0] * 3}}
    assert [*new.seams_of(whole)] == [whole], "a mould in one piece has no seam"


def test_seams_that_hook_least_are_tried_first(monkeypatch):
    """Of a vase of six flutes a turn by a whole one hooks nothing, one by 6° does."""

    def depth_mm(spec):
        azimuth = spec.mould.parting_azimuth_deg
        return 0.0 if azimuth is None else (azimuth - 45) % 60 / 60

    monkeypatch.setattr(new, "undercut_depth_mm", depth_mm)
    first, second, third, *_ = new.seams_of(BALL)
    assert first == BALL
    assert second["mould"]["parting_azimuth_deg"] == 105.0
    assert third["mould"]["parting_azimuth_deg"] == -15.0


def test_what_was_written_is_said_with_what_comes_next(tmp_path):
    """Somebody who names the file gets that file, not one that ends twice."""
    done = run("new", "avocado.toml", cwd=tmp_path)
    wrote, placed, chosen, expected, covered, taking, following = done.stdout.splitlines()
    assert wrote == "wrote avocado.toml"
    assert "5 magnets and 3 sensors on each of faces [1, 2, 3, 4, 5]" in placed
    assert chosen.startswith("magnets Ø6 × 1 mm and sensors of ±40 mT")
    assert re.match(
        r"expect position bounds of [0-9.]+ mm \(median, within a factor of 2\.5\)", expected
    )
    assert re.fullmatch(r"contact locations cover \d+ % of the sensed surface", covered)
    assert re.match(r"scores \(`instobj score`\) take \d+ to \d+ min and ", taking)
    assert following == "next: instobj check avocado.toml"
    assert [path.name for path in tmp_path.glob("*.toml")] == ["avocado.toml"]


def test_without_options_the_cube_of_the_paper_is_written(tmp_path):
    assert request_of() is None
    path = new_specification("mine", tmp_path)
    cube = load_spec(ROOT / "examples" / "paper_cube.toml")
    assert load_spec(path).changed(name="x") == cube.changed(name="x")
    assert len(path.read_text().splitlines()) <= 60
    with pytest.raises(InputError, match="already there"):
        new_specification("mine", tmp_path)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"kind": "ball", "size_mm": (1.0, 1.0, 1.0)}, "Choose one of box, pad"),
        ({"kind": "box"}, "Add --size"),
        ({"kind": "imported"}, "--from FILE goes with"),
        ({"size_mm": (1.0, 1.0, 1.0), "file": PEAR}, "Leave it out, or use --scale"),
        ({"file": PEAR, "scale": 0.0}, "above 0 and finite; got 0"),
        ({"file": PEAR, "scale": float("nan")}, "above 0 and finite; got nan"),
        ({"size_mm": (60.0, 40.0, 30.0), "sensors": 0}, "--sensors must be 1 or more; got 0"),
        ({"size_mm": (60.0, 40.0, 30.0), "magnets": 0}, "--magnets must be 1 or more; got 0"),
        ({"sensors": 2}, "--sensors 2 goes with --kind and --size"),
        ({"magnets": 4}, "--magnets 4 goes with --kind and --size"),
        ({"size_mm": (60.0, 40.0, 30.0), "scale": 2.0}, "--scale 2.0 goes with --from FILE"),
    ],
)
def test_options_that_do_not_go_together_are_refused(options, said):
    with pytest.raises(InputError, match=said):
        request_of(**options)


@pytest.mark.parametrize(
    ("edge_mm", "asked"),
    [
        (0.05, r"m: body\.scale = 1000 \(instobj new: --scale\) makes it 50 mm"),
        (45e3, r"body\.scale = 0\.001 \(instobj new: --scale\) makes it 45 mm"),
    ],
)
def test_a_file_in_metres_is_answered_with_a_question(edge_mm, asked):
    body = {"kind": "imported", "file": "fruit.stl", "size_mm": [edge_mm] * 3}
    with pytest.raises(ValueError, match=f"In which unit is its file drawn.*{asked}"):
        ObjectSpec.model_validate({"name": "x", "body": body})


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_what_is_placed_can_be_printed_cast_and_assembled(kind, tmp_path):
    file = PEAR if kind == "imported" else None
    path = new_specification("mine", tmp_path, request_of(kind, SIZES.get(kind), file=file))
    spec = load_spec(path)
    check(spec)
    findings = check_fabrication(spec).findings
    assert worst(findings) != "fail", [f for f in findings if f.status == "fail"]


def test_a_placed_box_is_written_in_sixty_lines(tmp_path):
    path = new_specification("mine", tmp_path, Request("box", (60.0, 40.0, 30.0)), new.made)
    assert len(path.read_text().splitlines()) <= 60
    assert check(load_spec(path)).sensors == 15


@pytest.mark.parametrize(
    ("text", "kind", "edges"),
    [
        ("60 60 85", "ellipsoid", (60, 60, 85)),
        ("60x60x85", "ellipsoid", (60, 60, 85)),
        ("70,50,35", "box", (70, 50, 35)),
        ("70mm 50mm 35mm", None, (70, 50, 35)),
        ("70", "sphere", (70, 70, 70)),
    ],
)
def test_sizes_are_taken_as_people_write_them(text, kind, edges):
    assert size_of(text, kind) == edges


@pytest.mark.parametrize(("text", "kind"), [("70 50", "box"), ("70", "cylinder"), ("wide", "box")])
def test_a_size_that_is_none_says_how_many_lengths_it_takes(text, kind):
    with pytest.raises(InputError, match=rf"three lengths in mm.*{text}.*--size 70 50 35"):
        size_of(text, kind)


@pytest.mark.parametrize("text", ["-60 45 40", "0 45 40", "nan 45 40", "60 inf 40"])
def test_a_length_that_is_none_is_told_by_the_option_that_was_typed(text):
    """The error named `body.size_mm.0`, a key that whoever types --size has not seen."""
    with pytest.raises(InputError, match=rf"--size is three lengths above 0 in mm; got {text}"):
        size_of(text, "box")


@pytest.mark.parametrize(
    ("word", "kind"),
    [("cube", "box"), ("ball", "sphere"), ("spher", "sphere"), ("can", "cylinder")],
)
def test_a_word_for_a_shape_proposes_its_kind(word, kind):
    with pytest.raises(InputError, match=f"Did you mean {kind}\\?"):
        request_of(kind=word, size_mm=(60.0, 60.0, 60.0))


def test_a_word_for_no_shape_lists_the_kinds():
    with pytest.raises(InputError, match=r"not known\. Choose one of box"):
        request_of(kind="zzz", size_mm=(60.0, 60.0, 60.0))


def test_sizes_of_the_command_line_are_joined():
    words = ["new", "a", "--kind", "box", "--size", "60", "40", "30", "--sensors", "2"]
    assert with_joined_sizes(words) == [*words[:5], "60 40 30", "--sensors", "2"]
    assert with_joined_sizes(["new", "--size", "60", "40", "30", "a"]) == [
        "new",
        "--size",
        "60 40 30",
        "a",
    ]
    assert with_joined_sizes(["new", "a", "--size", "70"]) == ["new", "a", "--size", "70"]


def test_a_size_of_one_length_is_one_error_with_an_example(tmp_path):
    done = run("new", "a", "--kind", "cylinder", "--size", "70", cwd=tmp_path)
    assert done.returncode == 2
    assert "three lengths in mm" in done.stderr


@pytest.mark.parametrize(
    ("name", "out"), [("-", "."), ("there", "."), ("mine", "a_file"), ("mine", "a_file/deeper")]
)
def test_what_cannot_be_written_is_told_before_parts_are_placed(tmp_path, name, out):
    (tmp_path / "there.toml").touch()
    (tmp_path / "a_file").touch()
    asked = []
    with pytest.raises(InstobjError, match=r"cannot name|already there|cannot write"):
        new_specification(
            name,
            tmp_path / out,
            Request("box", (60.0, 40.0, 30.0)),
            lambda request: (asked.append(request), (placed_tables("box"), []))[1],
        )
    assert asked == []


def tin(folder, height_mm=90.0, lid_mm=5.0):
    """A tin whose lids lie that deep, as a file."""
    body = trimesh.creation.cylinder(30, height_mm, sections=64)
    lids = [trimesh.creation.cylinder(27, 2 * lid_mm, sections=64) for _ in range(2)]
    for lid, side in zip(lids, (-1, 1), strict=True):
        lid.apply_translation([0, 0, side * height_mm / 2])
    path = folder / "tin.stl"
    trimesh.boolean.difference([body, *lids], engine="manifold").export(path)
    return path


def test_a_scan_that_hooks_is_designed_without_its_hollows(tmp_path):
    """Nothing stays of it where its parts find no place."""
    asked, castable = [], tmp_path / "mine_castable.stl"

    def no_place(request):
        asked.append(request)
        assert castable.is_file()
        raise InputError("too small")

    request = request_of(file=tin(tmp_path))
    with (
        pytest.warns(
            UserWarning, match=r"e_castable\.stl is designed instead.* 5 mm, over hollows"
        ),
        pytest.warns(
            UserWarning, match=r"a cylinder within 0\.0.*`--kind cylinder --size 60 60 90`"
        ),
        pytest.raises(InputError, match="too small"),
    ):
        new_specification("mine", tmp_path, request, no_place)
    assert [path.name for path in tmp_path.iterdir()] == ["tin.stl"]
    (changed,) = asked
    assert dict(changed.file) == {"file": str(castable), "scale": 1.0}
    assert changed.size_mm == pytest.approx((60, 60, 90), abs=0.1)
    castable.touch()
    with pytest.raises(InputError, match=r"mine_castable\.stl is already there"):
        new_specification("mine", tmp_path, request, no_place)


def test_a_noisy_scan_is_designed_smooth(tmp_path):
    """Corners lie 0.1 mm off along their normals; the file stays as it is. Facets that leave the smooth body
    by 0.05 mm count as some noise."""
    scan = trimesh.load_mesh(PEAR)
    scan.vertices += scan.vertex_normals * np.random.default_rng(2).normal(0, 0.1, (2562, 1))
    scan.export(tmp_path / "scan.stl")
    written = (tmp_path / "scan.stl").read_bytes()
    asked = []

    def placed(request):
        asked.append(request)
        return placed_tables("box") | {"body": {"kind": "box", "size_mm": [50.0, 50.0, 50.0]}}, []

    with pytest.warns(UserWarning, match=r"noisy, by 0\.098 mm: .* is designed instead"):
        new_specification("mine", tmp_path, request_of(file=tmp_path / "scan.stl"), placed)
    castable = tmp_path / "mine_castable.stl"
    assert [dict(request.file)["file"] for request in asked] == [str(castable)]
    assert noise_mm(trimesh.load_mesh(castable)) < 0.02
    assert traits_of_scan(trimesh.load_mesh(castable)) == ""
    assert (tmp_path / "scan.stl").read_bytes() == written


def test_a_scan_with_deep_hollows_is_refused_with_what_works(monkeypatch, tmp_path):
    """Three arms from a corner. How deep halves hook them takes 10 s, and is computed above."""
    monkeypatch.setattr("design.placement.hooking.least_hooked_mm", lambda request: 20.0)
    arms = [trimesh.creation.box(np.where(np.eye(3)[axis], 80.0, 10.0)) for axis in range(3)]
    for axis, arm in enumerate(arms):
        arm.apply_translation(35.0 * np.eye(3)[axis])
    file = tmp_path / "arms.stl"
    trimesh.boolean.union(arms, engine="manifold").export(file)
    with pytest.raises(
        InputError, match=r"% of it over 7\.9 mm off the scan.*--kind ellipsoid --size"
    ):
        new_specification("mine", tmp_path, request_of(file=file))
    assert not list(tmp_path.glob("*castable*"))
