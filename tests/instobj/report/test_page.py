"""The report: what is known of the paper's cube is told of no other object; files are linked."""

import re
from pathlib import Path

import pytest

from design.spec_io import load_spec, parse_spec
from estimator.tolerances.result import SEAT_ERROR
from instobj.report import page
from instobj.report.deformation_section import envelope_text
from instobj.report.page import files_beside, is_papers_cube
from instobj.report.pages import render
from instobj.report.verdict import Check, Verdict
from tests.support.markup import assert_short, read, read_unfolded
from tests.support.pictures import save_dot

EXAMPLES = Path(__file__).parents[3] / "examples"
TABLES = (
    *(
        "checks",
        "alternatives",
        "settings",
        "maps",
        "score_rows",
        "cross_face",
        "nuisances",
        "bounds",
        "mechanics",
        "discretisation",
    ),
    *("weak_areas", "weak_maps"),
    *("parts", "stages", "discretisation_header", "grasp_header", "grasp_rows"),
)
TEXTS = (
    *(
        "surroundings",
        "deformation",
        "core",
        "discretisation_note",
        "hash",
        "made_with",
    ),
    *(
        "specification",
        "cross_face_force_n",
        "draws",
        "locations",
        "covered_by_face",
        "unreached",
        "decision",
    ),
    *("weak_text", "edge_text", "located", "delta", "tip", "coarse_mesh"),
)
PICTURES = ("overview", "robustness_picture", "press_curves", "parts_picture", "still", "scene")
PICTURES += ("weak_picture", "delta_map", "compliance")


def page_of(spec, tmp_path, **content):
    """The report with empty tables, but for what is given."""
    save_dot(tmp_path / "picture.png")
    check = Check("bound", "2 mm", "≤ 1 mm", 2.0, "face 1")
    context = {name: [] for name in TABLES} | dict.fromkeys(TEXTS, "")
    context |= dict.fromkeys(PICTURES, tmp_path / "picture.png")
    context |= {"estimator_header": ["frames"], "estimator_rows": [["157"]]}
    context |= {"estimator_judged": "contacts", "estimator_picture": tmp_path / "picture.png"}
    context |= {"parts_folder": "../../cad_out/a/", "files": []}
    context |= {"verdict": Verdict((check,), "bound", 0.5), "seat_error": SEAT_ERROR}
    context["saturation"] = "Of 200 virtual objects out of range: 0.0 % at rest."
    context["budget_forces"] = "8 N or 0.7 of the deepest press"
    return render(
        "report.html.j2", spec=spec, papers_cube=is_papers_cube(spec), **context | content
    )


@pytest.mark.parametrize("name", ["handle", "pear", "better_cube"])
def test_other_objects_are_told_nothing_of_the_paper_s_cube(tmp_path, name):
    spec = load_spec(EXAMPLES / f"{name}.toml")
    told = read(page_of(spec, tmp_path))
    assert "Platsil" not in told
    assert "Knopke" not in told
    assert "paper" not in told
    assert "paper" not in envelope_text(spec, {"shallowest_peak_mm": 1.0, "deepest_peak_mm": 2.0})


def test_the_paper_s_cube_is_told_of_its_silicone(tmp_path):
    assert "Platsil" in read(page_of(load_spec(EXAMPLES / "paper_cube.toml"), tmp_path))


def test_an_estimator_that_was_not_judged_says_why_and_shows_no_table(tmp_path):
    content = {"estimator_rows": [], "estimator_judged": "nothing, as the core has slipped"}
    told = read(page_of(parse_spec({"name": "a"}, "a"), tmp_path, **content))
    assert "Judged: nothing, as the core has slipped." in told
    assert "157" not in told
    assert "157" in read(page_of(parse_spec({"name": "a"}, "a"), tmp_path))


def test_texts_are_text_not_markup(tmp_path):
    verdict = Verdict((Check("bound", "2 mm", "≤ 1 mm", 2.0, "face 1"),), "<script>steal", 0.5)
    page = page_of(parse_spec({"name": "a"}, "a"), tmp_path, verdict=verdict)
    assert "<script>steal" not in page
    assert "&lt;script&gt;steal" in page


def test_files_beside_the_page_are_linked(tmp_path):
    (tmp_path / "maps").mkdir()
    for name in ("scores.csv", "maps/a #1.png", "kept_in_the_store.bin"):
        (tmp_path / name).write_bytes(b"")
    files = files_beside({"scores": tmp_path})
    page = page_of(parse_spec({"name": "a"}, "a"), tmp_path, files=files)
    assert '<a href="scores.csv">scores.csv</a>' in page
    assert '<a href="maps/a%20%231.png">maps/a #1.png</a>' in page
    assert "kept_in_the_store" not in page
    assert '<a href="../../cad_out/a/">' in page


def test_the_page_says_what_to_change_first_and_of_delta_near_its_end(tmp_path):
    content = {
        "decision": ("Take magnets of N52", "Next to try: other places"),
        "delta": "4.1",
    }
    told = read(page_of(parse_spec({"name": "a"}, "a"), tmp_path, **content))
    assert "Take magnets of N52. Next to try: other places." in told.split("Press it")[0]
    before, after = told.split("Convex-hull sensitivity δ", 1)
    assert "δ" not in before
    assert "Median: 4.1 counts 9 /N" in after


@pytest.mark.parametrize(("covered", "warned"), [(0.44, True), (0.93, False)])
def test_the_page_begins_with_the_share_of_the_surface_that_it_judges(tmp_path, covered, warned):
    verdict = Verdict((Check("bound", "2 mm", "≤ 1 mm", 2.0, "face 1"),), "bound", covered)
    told = read(page_of(parse_spec({"name": "a"}, "a"), tmp_path, verdict=verdict))
    first = told.split("Press it")[0]
    assert f"{100 * covered:.0f} % of the sensed surface" in first
    assert ("Nothing is said about the rest" in first) == warned


@pytest.mark.parametrize(
    ("tables", "told"),
    [
        ({}, "14 × 14 contact locations per face"),
        ({"body": {"sensed_faces": [3]}}, "14 × 14 contact locations"),
        ({"body": {"size_mm": [50.0, 42.0, 42.0]}}, " to "),
    ],
)
def test_contact_locations_are_counted_per_face_where_there_are_several(tables, told):
    found = page.locations_line(parse_spec({"name": "a", **tables}, "a"))
    assert found == told or (told == " to " and re.fullmatch(r"\d+ to \d+ .* per face", found))


@pytest.mark.parametrize("size_mm", [[42.0, 42.0, 42.0], [60.0, 50.0, 42.0]])
def test_a_page_is_short_before_anything_is_unfolded(tmp_path, size_mm):
    """Every table full; the first screen keeps the verdict, one change to copy, and the edges."""
    rows = [["mid-edge", *(f"{number / 7:.2f}" for number in range(8))]] * 8
    tables = ("checks", "alternatives", "mechanics", "discretisation")
    named_rows = [dict(enumerate(row)) for row in rows]
    records = ("score_rows", "bounds", "cross_face", "weak_areas", "parts")
    content = dict.fromkeys(tables, rows) | dict.fromkeys(records, named_rows)
    content |= {
        "settings": ["[sensors]", "count_per_face = 4"],
        "decision": ("Helps most alone: one more sensor (+15 € for parts, +75 min by hand)",),
        "edge_text": "1.5 times as uncertain as the middle",
        "cross_face_force_n": 10.0,
        "surroundings": " ".join(f"{number} counts" for number in range(100)),
        "weak_text": "Weak locations are those where 12 of 30 lie",
    }
    spec = parse_spec({"name": "a", "body": {"size_mm": size_mm}}, "a")
    made = page_of(spec, tmp_path, **content)
    assert_short(made)
    first = read_unfolded(made).split("Press it")[0]
    for told in ("NO-GO", "[sensors] count_per_face = 4", "+15 €", "Edges : 1.5 times"):
        assert told in first
    assert "12 of 30" in read(made), "what is folded is there"
