"""Views in a real browser: beside each other, of a search's layouts, and as a widget of a notebook."""

import base64
import json
import re
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from design.layout.body import face_frames
from design.spec_io import parse_spec
from instobj import viewer
from instobj.commands.comparison import write_comparison_page
from instobj.report.pages import render, style
from instobj.report.widget import object_view
from instobj.search.outcome.layouts import ShownLayout, layouts_scene
from instobj.viewer.bundling import program
from instobj.viewer.scene import face_content
from tests.support.browser import Browser, chromium
from tests.support.objects.made_histories import history_of_three, made_up_layouts
from tests.support.objects.made_scene import DEPTHS_MM, write_made_scene
from tests.support.pictures import save_dot

GRIDS = {"near": ([5, 5], 5.0), "far": ([7, 7], 4.0)}
STIFFNESS = {"near": 2.0, "far": 3.0}


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """Folder, specifications and the numbers that the page should show."""
    folder, specs, numbers = tmp_path_factory.mktemp("compared"), [], {}
    for name, (count, pitch_mm) in GRIDS.items():
        grid = {"count": count, "pitch_mm": pitch_mm}
        body = {"sensed_faces": [1, 3]}
        specs.append(parse_spec({"name": name, "body": body, "contact_grid": grid}, name))
        (folder / name).mkdir()
        numbers[name] = write_made_scene(specs[-1], folder / name, STIFFNESS[name])
    save_dot(folder / "comparison.png")
    rows = [{"object": name, "place mm": 0.1 * k} for k, name in enumerate(GRIDS, start=1)]
    write_comparison_page(specs, [folder / name for name in GRIDS], rows, folder / "comparison.png")
    return folder, numbers


@pytest.fixture(scope="module")
def browser():
    if chromium() is None:
        pytest.skip("no Chromium on this machine")
    with Browser(1000, 700) as browser:
        yield browser


def open_page(browser, path, views):
    """Open a page and wait until so many views stand."""
    ready = "[...document.querySelectorAll('.viewer')].filter((v) => v.dataset.ready).length"
    browser.events.clear()
    browser.open(path, f"{ready} === {views}")


@pytest.fixture(scope="module")
def page(told, browser):
    open_page(browser, told[0] / "comparison.html", 2)
    return browser


def named(view, name):
    return f"document.querySelectorAll('.viewer')[{view}].querySelector('[data-name=\"{name}\"]')"


def move(page, view, name, value):
    """As a person does: the value, then the events that tell of it."""
    page.ask(f"(() => {{ const one = {named(view, name)}; one.value = '{value}';"
             "for (const kind of ['input', 'change']) one.dispatchEvent(new Event(kind, {bubbles: true}));"
             "})()")  # fmt: skip


def shown(page, view, name):
    return page.ask(f"{named(view, name)}.textContent")


def test_a_press_on_one_goes_to_the_nearest_place_and_depth_of_the_other(page, told):
    _, numbers = told
    move(page, 0, "face", 1)
    move(page, 0, "x", 4)  # 10 mm; the other has 8 and 12 mm, and takes the first
    move(page, 0, "depth", 3)
    assert [shown(page, view, "place") for view in (0, 1)] == [
        "face 3 (10, 0) mm",
        "face 3 (8, 0) mm",
    ]
    assert [shown(page, view, "travel") for view in (0, 1)] == [f"{DEPTHS_MM[-1]:.2f} mm"] * 2
    for view, (name, place) in enumerate((("near", 4 * 5 + 2), ("far", 5 * 7 + 3))):
        assert shown(page, view, "force") == f"{numbers[name]['force_n'][1, place, 2]:.2f} N"
        cells = page.ask(
            f"Array.from({named(view, 'counts')}.rows, (r) => Number(r.cells[2].textContent))"
        )
        np.testing.assert_array_equal(cells, numbers[name]["counts"][1, place, 2, :, 0])
    move(page, 1, "depth", 1)
    assert shown(page, 0, "travel") == f"{DEPTHS_MM[0]:.2f} mm", "and the other way round"


def test_a_map_has_one_scale_for_both(page, told):
    _, numbers = told
    move(page, 1, "map", "bound")
    every = np.concatenate([one["bound_mm"].ravel() for one in numbers.values()])
    for view in (0, 1):
        ticks = f"{named(view, 'legend')}.querySelectorAll('.ticks span')"
        ends = page.ask(f"Array.from({ticks}, (tick) => Number(tick.textContent))")
        assert ends[0] == pytest.approx(every.min(), rel=5e-3)
        assert ends[-1] == pytest.approx(every.max(), rel=5e-3)
        assert page.ask(f"{named(view, 'map')}.value") == "bound"


def pixels(browser, selector):
    """What the window shows of an element once two frames are drawn."""
    browser.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    box = browser.ask(
        f"(({{left, top, right, bottom}}) => [left, top, right, Math.min(bottom, innerHeight)])"
        f"(document.querySelector('{selector}').getBoundingClientRect())"
    )
    return np.asarray(Image.open(BytesIO(browser.picture())).convert("RGB").crop(box), int)


def test_the_pointer_shows_the_ellipse_of_the_nearest_location_and_its_bound(page, told):
    _, numbers = told
    move(page, 0, "map", "")
    move(page, 0, "opacity", 100)
    move(page, 0, "depth", 0)
    box = page.ask(
        "(({left, top, width, height}) => [left, top, width, height])"
        f"((one => (one.scrollIntoView(), one.getBoundingClientRect()))({named(0, 'canvas')}))"
    )
    before = pixels(page, "canvas")
    at = box[0] + 0.61 * box[2], box[1] + 0.57 * box[3]
    page.send("Input.dispatchMouseEvent", type="mouseMoved", x=at[0], y=at[1])
    after = pixels(page, "canvas")
    told_there = shown(page, 0, "under")
    found = re.fullmatch(r"face (\d) \((.*), (.*)\) mm: σ (.*) × (.*) mm", told_there)
    assert found, told_there
    face, x, y, most, least = map(float, found.groups())
    assert face == 3
    place = 5 * round(x / 5 + 2) + round(y / 5 + 2)  # 5 × 5 locations, 5 mm apart
    bound = numbers["near"]["bound_mm"][1, place]
    assert (most, least) == (pytest.approx(bound, rel=5e-3), pytest.approx(bound / 2, rel=5e-3))
    drawn = (abs(after - before).max(axis=2) > 40)[40:]  # below the line of text
    assert drawn.sum() > 15
    rows, columns = np.nonzero(drawn)
    middle = np.array([columns.mean() + box[0], rows.mean() + 40 + box[1]])
    assert np.linalg.norm(middle - at) < 0.1 * box[2], "about the pointer"


def complaints(page, path):
    """What a page complained about, and what it asked for beside itself."""
    return page.problems() + [one for one in page.requests() if one != path.as_uri()]


def test_linked_views_complain_of_nothing_and_ask_no_network(page, told):
    assert complaints(page, told[0] / "comparison.html") == []


HOST = """<!doctype html><meta charset="utf-8"><div id="cell"></div><script type="module">
const state = {state};
const scene = Uint8Array.from(atob(state.scene), (letter) => letter.charCodeAt(0));
const traits = {{ ...state, scene: new DataView(scene.buffer) }};
const module = URL.createObjectURL(new Blob([state._esm], {{ type: "text/javascript" }}));
const {{ default: widget }} = await import(module);
await widget.render({{ model: {{ get: (name) => traits[name] }}, el: document.getElementById("cell") }});
</script>"""
"""What anywidget does in the front end: it imports the module and hands it the model's traits."""


@pytest.mark.slow
def test_the_widget_of_a_notebook_shows_the_same_numbers(told, browser):
    folder, numbers = told
    state = object_view("near", (folder / "near" / "scene.bin").read_bytes()).get_state()
    assert ".viewer" in state["_css"]
    kept = {name: state[name] for name in ("_esm", "markup")}
    kept["scene"] = base64.b64encode(state["scene"]).decode()
    path = folder / "host.html"
    path.write_text(HOST.format(state=json.dumps(kept).replace("</", "<\\/")), encoding="utf-8")
    open_page(browser, path, 1)
    move(browser, 0, "face", 1)
    move(browser, 0, "depth", 2)
    assert shown(browser, 0, "place") == "face 3 (0, 0) mm"
    assert shown(browser, 0, "force") == f"{numbers['near']['force_n'][1, 12, 1]:.2f} N"
    blob = [one for one in browser.requests() if not one.startswith("blob:")]
    assert blob == [path.as_uri()]
    assert browser.problems() == []


@pytest.mark.slow
def test_the_layouts_of_a_search_move_and_the_front_chooses_among_them(told, browser):
    layouts = made_up_layouts()
    layouts.append(ShownLayout("trial 9", layouts[1].spec, (0.5, 5.0)))
    scene = base64.b64encode(layouts_scene(layouts, history_of_three())).decode()
    path = told[0] / "layouts.html"
    view = render("layouts.html.j2", scene=scene, objectives=2)
    page = f"<!doctype html><style>{style('viewer.css')}</style>{view}<script>{program()}</script>"
    path.write_text(page, encoding="utf-8")
    open_page(browser, path, 1)
    after = pixels(browser, "canvas")
    move(browser, 0, "share", 0)
    before = pixels(browser, "canvas")
    changed = (abs(after - before).max(axis=2) > 20).mean()
    assert 0.005 < changed < 0.5
    cells = (
        f"Array.from({named(0, 'scores')}.rows, (r) => Array.from(r.cells, (c) => c.textContent))"
    )
    assert [row[1:] for row in browser.ask(cells)] == [["2.00", "1.00"], ["–", "3.00"]]
    box = browser.ask(
        "(({left, top, width, height}) => [left + width / 2, top + height / 2])"
        "((e => (e.scrollIntoView(), e.getBoundingClientRect()))"
        "(document.querySelector('[data-layout=\"2\"]')))"
    )
    browser.click(*box)
    assert browser.ask(f"{named(0, 'layout')}.selectedOptions[0].text") == "trial 9"
    assert [row[2] for row in browser.ask(cells)] == ["0.500", "5.00"]
    assert complaints(browser, path) == []


def test_points_of_a_curved_face_are_told_along_it_and_back(browser, tmp_path):
    """The page's own functions, on the tables that a scene holds."""
    body = {"kind": "capsule", "size_mm": [44.0, 44.0, 80.0], "sensed_faces": [3]}
    (frame,) = face_frames(parse_spec({"name": "capsule", "body": body}, "capsule"))
    source = (Path(viewer.__file__).parent / "source" / "maps.js").read_text(encoding="utf-8")
    functions = source[
        source.index("export function placeOn") : source.index("export function shown")
    ]
    path = tmp_path / "empty.html"
    path.write_text("<p></p>", encoding="utf-8")
    browser.open(path, "true")
    places = np.array([[0.0, 0.0], [22.0, -15.0], [-38.5, 4.0], [3.0, 19.0]])
    plane = frame.to_plane(places)
    points = frame.to_object(np.column_stack([plane, np.zeros(len(plane))]))
    found = browser.ask(
        f"(() => {{ {functions.replace('export ', '')}\n"
        f"const face = {json.dumps(face_content(frame))};"
        f"return [{points.tolist()}.map((p) => placeOn(face, ...p)),"
        f"{places.tolist()}.map((p) => inPlane(face, p))];"
        "})()"
    )
    np.testing.assert_allclose(found, [places, plane], atol=0.01)
    assert abs(plane - places).max() > 1.0


def test_maps_of_faces_are_printed_side_by_side(browser, tmp_path):
    page = tmp_path / "page.html"
    maps = '<div class="grid"><p>1</p><p>2</p><p>3</p></div>'
    html = (
        f"<!doctype html><style>{style('page.css')}</style><main style='width: 700px'>{maps}</main>"
    )
    page.write_text(html, encoding="utf-8")
    browser.open(page, "document.readyState === 'complete'")
    columns = (
        "getComputedStyle(document.querySelector('.grid')).gridTemplateColumns.split(' ').length"
    )
    assert browser.ask(columns) == 1
    browser.send("Emulation.setEmulatedMedia", media="print")
    assert browser.ask(columns) == 2
    browser.send("Emulation.setEmulatedMedia", media="")
