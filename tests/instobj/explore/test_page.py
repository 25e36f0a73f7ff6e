"""The explorer's page in a real browser: parts dragged by the mouse, and what the page says of it."""

import asyncio
import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from aiohttp import web

from design.layout.body import face_frames
from design.spec_io import load_spec
from instobj.explore.design import broken_limits, with_design
from instobj.explore.engine import open_coarse_explorer, summary_of
from instobj.explore.server import Session, application
from tests.support.browser import Browser, chromium
from tests.support.made_explorer import made_explorer

pytestmark = pytest.mark.skipif(chromium() is None, reason="no Chromium on this machine")
READY = (
    'document.getElementById("instobj-explore")?.dataset.ready === "yes" && instobjExplore.idle()'
)
MAGNET = 12
"""The third of face 3, which looks at the camera."""


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """Address of the page and the folder that it saves into."""
    folder = tmp_path_factory.mktemp("explored")
    spec = made_explorer().spec
    noise = f"noise_counts = {list(spec.sensors.noise_counts)}\nzeroing_counts = 0.01\n"
    (folder / "cube.toml").write_text(
        'name = "cube"  # mine\n[contact_grid]\ncount = [5, 4]\npitch_mm = 6.0\n'
        f"[sensors]\n{noise}[tolerances]\nearth_field_ut = {spec.tolerances.earth_field_ut}\n"
        f'[search]\nforces_n = {list(spec.search.forces_n)}\n[limits]\nuse = "bench"\n'
    )
    app = application(Session(made_explorer(), folder / "cube.toml"), ThreadPoolExecutor(1))
    listening = socket.create_server(("127.0.0.1", 0))
    quiet = {"print": None, "handle_signals": False, "loop": asyncio.new_event_loop()}
    served_there = {"sock": listening, **quiet}
    threading.Thread(target=web.run_app, args=(app,), kwargs=served_there, daemon=True).start()
    return f"http://127.0.0.1:{listening.getsockname()[1]}/", folder


@pytest.fixture(scope="module")
def browser():
    with Browser(1100, 800) as browser:
        yield browser


@pytest.fixture
def page(served, browser):
    """The page as it opens."""
    browser.events.clear()
    browser.send("Page.navigate", url=served[0])
    browser.wait(READY)
    return browser


def mouse(page, kind, x, y, modifiers=0):
    page.send(
        "Input.dispatchMouseEvent",
        type=kind, x=x, y=y, button="left", buttons=1, clickCount=1, modifiers=modifiers,
    )  # fmt: skip


def drag(page, by_px):
    """The magnet, in eight steps."""
    x, y = page.ask(f'instobjExplore.where("magnet", {MAGNET})')
    mouse(page, "mousePressed", x, y)
    for share in np.linspace(0.125, 1, 8):
        mouse(page, "mouseMoved", x + share * by_px[0], y + share * by_px[1])
    mouse(page, "mouseReleased", x + by_px[0], y + by_px[1])
    page.wait("instobjExplore.idle()")


def design(page):
    return page.ask("instobjExplore.state().design")


def shown(page, name):
    return page.ask(f"document.querySelector('[data-name=\"{name}\"]').innerText")


def click(page, name):
    page.ask(f"document.querySelector('[data-name=\"{name}\"]').click()")
    page.wait("instobjExplore.idle()")


def numbers(page):
    """Median, 95th percentile and worst as the page writes them."""
    rows = "document.querySelectorAll('[data-name=numbers] tr')"
    return page.ask(f"Array.from({rows}, (row) => row.cells[1].textContent).slice(0, 3)")


def expected(page, force_n=5.0):
    explorer = made_explorer()
    return explorer.judge(with_design(explorer.spec, design(page)), force_n).position_bound_mm


def test_a_magnet_follows_the_mouse_and_the_numbers_are_pythons(page, served):
    before = design(page)
    drag(page, (24, -10))
    after = design(page)
    moved = np.subtract(after["magnets"]["positions_mm"], before["magnets"]["positions_mm"])
    assert np.linalg.norm(moved, axis=1).round(6).astype(bool).tolist() == [0, 0, 1, 0, 0]
    values = expected(page)
    np.testing.assert_array_equal(page.ask("instobjExplore.map()"), np.float32(values.ravel()))
    summary = summary_of(values)
    for text, value in zip(
        numbers(page), (summary.median, summary.percentile_95, summary.worst), strict=True
    ):
        assert float(text) == pytest.approx(value, rel=5.1e-3)
    worst = page.ask("document.querySelectorAll('[data-name=numbers] tr')[2].cells[0].textContent")
    limit = made_explorer().spec.limits.position_bound_mm
    assert worst == f"worst place (for a go {limit:g} or less), mm"
    assert all(one.startswith(served[0]) for one in page.requests())
    assert page.problems() == []


def test_undo_and_redo_restore_to_the_digit(page):
    start, numbers_before = design(page), numbers(page)
    map_before = page.ask("instobjExplore.map()")
    drag(page, (20, 14))
    moved = design(page)
    assert moved != start
    click(page, "undo")
    assert (design(page), numbers(page)) == (start, numbers_before)
    assert page.ask("instobjExplore.map()") == map_before
    click(page, "redo")
    assert design(page) == moved
    for kind in ("keyDown", "keyUp"):
        page.send("Input.dispatchKeyEvent", type=kind, key="z", code="KeyZ", modifiers=2)
    page.wait("instobjExplore.idle()")
    assert design(page) == start


def test_what_breaks_a_limit_is_told_with_checks_sentence(page):
    assert "All limits of instobj check are kept" in shown(page, "limits")
    page.ask("instobjExplore.state().design.magnets.positions_mm[1] = [3, 0]")
    click(page, "add-magnet")
    assert "magnet 1, magnet 2: the pockets of magnets.positions_mm[0] = (0, 0) and" in shown(
        page, "limits"
    )
    assert len(design(page)["magnets"]["north"]) == 6
    click(page, "save")
    page.wait("document.getElementById('trouble').innerText.startsWith('not saved')")


@pytest.mark.parametrize(("kind", "name"), [("magnet", "magnet"), ("sensor", "chip")])
def test_parts_are_added_where_every_limit_is_kept_until_there_is_no_room(page, kind, name):
    spec = made_explorer().spec
    taken = [design(page)]
    while not (trouble := shown(page, "trouble")):
        click(page, f"add-{kind}")
        taken.append(design(page))
        assert broken_limits(with_design(spec, taken[-1])) == []
    assert len(taken) > 2
    assert taken[-1] == taken[-2]
    assert trouble.startswith(f"No room for one more {name} on every face was found: ")


def test_the_page_opens_at_the_force_that_is_judged_though_no_search_names_it(page):
    spec = made_explorer().spec
    assert spec.score.force_n not in spec.search.forces_n
    assert (
        page.ask("document.querySelector('[data-name=force]').value") == f"{spec.score.force_n:g}"
    )
    judged = made_explorer().judge(spec, spec.score.force_n).position_bound_mm
    np.testing.assert_array_equal(page.ask("instobjExplore.map()"), np.float32(judged.ravel()))


def test_a_press_shows_each_chips_counts(page):
    x, y = page.ask(f'instobjExplore.where("magnet", {MAGNET})')
    mouse(page, "mousePressed", x, y, modifiers=8)
    mouse(page, "mouseReleased", x, y, modifiers=8)
    page.wait("document.querySelectorAll('[data-name=counts] tr').length === 3")
    (at,) = page.ask("instobjExplore.state().presses")
    explorer = made_explorer()
    face = list(explorer.presses)[at["face"]]
    pressed = explorer.press(explorer.spec, face, 5.0)
    told = page.ask(
        "Array.from(document.querySelectorAll('[data-name=counts] td'), (cell) => "
        "Number(cell.textContent.split(' ±')[0].replace('−', '-')))"
    )
    np.testing.assert_allclose(told, pressed.counts([at["place"]]).ravel(), atol=0.56)
    most = np.sqrt(np.linalg.eigvalsh(pressed.position_mm2([at["place"]])[0])[-1])
    assert f"mm to {most:#.3g} ×" in shown(page, "pressed")


def shift_click(page, x, y, alt=False):
    for kind in ("mousePressed", "mouseReleased"):
        mouse(page, kind, x, y, modifiers=9 if alt else 8)


def test_two_presses_bend_the_skin_and_move_the_magnets(page):
    presses = "instobjExplore.state().presses"
    x, y = page.ask(f'instobjExplore.where("magnet", {MAGNET})')
    before = np.array(page.ask(f'instobjExplore.at("magnet", {MAGNET})'))
    assert page.ask("instobjExplore.dent()") == 0
    shift_click(page, x, y)
    page.wait("instobjExplore.dent() > 0.1")
    (first,) = page.ask(presses)
    shift_click(page, *page.ask(f'instobjExplore.where("magnet", {MAGNET - 2})'), alt=True)
    page.wait("document.querySelector('[data-name=pressed]').innerText.includes('Both presses')")
    places = [one["place"] for one in page.ask(presses)]
    assert places[0] == first["place"] != places[1]
    explorer = made_explorer()
    face = list(explorer.presses)[first["face"]]
    pressed = explorer.press(explorer.spec, face, 5.0)
    told = page.ask(
        "Array.from(document.querySelectorAll('[data-name=counts] td'), (cell) => "
        "Number(cell.textContent.split(' ±')[0].replace('−', '-')))"
    )
    np.testing.assert_allclose(told, pressed.counts(places).ravel(), atol=0.56)
    frame = face_frames(explorer.spec)[first["face"]]
    moved = pressed.motions[places, MAGNET % 5, :3].sum(axis=0) @ frame.axes.T
    now = np.array(page.ask(f'instobjExplore.at("magnet", {MAGNET})'))
    np.testing.assert_allclose(now - before, moved, atol=2e-4)
    click(page, "release")
    assert page.ask("instobjExplore.dent()") == 0
    np.testing.assert_array_equal(page.ask(f'instobjExplore.at("magnet", {MAGNET})'), before)


def test_a_thicker_shell_is_judged_coarse_within_ten_seconds_and_undone_to_the_digit(page):
    map_before = page.ask("instobjExplore.map()")
    began = time.monotonic()
    page.ask(
        "(() => { const one = document.querySelector('[data-name=thickness]'); one.value = '10'; "
        "one.dispatchEvent(new Event('change')); })()"
    )
    page.wait("instobjExplore.idle() && !instobjExplore.exact()")
    assert time.monotonic() - began < 10
    spec = with_design(made_explorer().spec, design(page))
    assert spec.shell.thickness_mm == 10
    judged = open_coarse_explorer(spec).judge(spec, 5.0)
    np.testing.assert_allclose(
        page.ask("instobjExplore.map()"), np.float32(judged.position_bound_mm.ravel()), rtol=1e-6
    )
    assert shown(page, "accuracy").startswith("First look")
    assert shown(page, "level").startswith("A first look")
    assert "own mechanics is being computed" in shown(page, "refined")
    click(page, "undo")
    page.wait("instobjExplore.exact()")
    page.wait("instobjExplore.idle()")
    assert page.ask("instobjExplore.map()") == map_before
    assert shown(page, "accuracy").startswith("Quick model")
    assert shown(page, "level") == ""


def test_a_search_is_begun_with_the_command_that_is_shown(page, served):
    _, folder = served
    page.ask("document.querySelector('[data-name=seconds]').value = 30")
    click(page, "improve")
    page.wait("document.querySelector('[data-name=work-line]').innerText.startsWith('ended early')")
    command = f"instobj optimize {folder}/cube.toml --set search.seconds=30"
    assert shown(page, "work-command") == command
    assert "search.seconds = 30 ends before a search has a result" in shown(page, "work-line")
    assert page.ask("document.querySelector('[data-name=improve]').disabled") is False


def test_another_force_and_a_pinned_design(page):
    page.ask(
        "(() => { const one = document.querySelector('[data-name=force]'); one.value = '8'; "
        "one.dispatchEvent(new Event('change')); })()"
    )
    page.wait("instobjExplore.idle()")
    np.testing.assert_array_equal(
        page.ask("instobjExplore.map()"), np.float32(expected(page, 8.0).ravel())
    )
    click(page, "pin")
    start = expected(page, 8.0)
    drag(page, (24, -10))
    click(page, "difference")
    ratio = expected(page, 8.0) / start
    np.testing.assert_allclose(page.ask("instobjExplore.map()"), ratio.ravel(), rtol=1e-6)
    assert "above 1 is worse" in page.ask("document.querySelector('.legend').innerText")


def choose(page, name, value):
    """Another entry of a list, as a hand chooses it."""
    page.ask(
        f"(() => {{ const list = document.querySelector('[data-name=\"{name}\"]'); "
        f"list.value = '{value}'; list.dispatchEvent(new Event('change')); }})()"
    )
    page.wait("instobjExplore.idle()")


def test_grade_chip_and_disturbances_change_the_map_and_are_saved(page, served, tmp_path):
    map_before = np.array(page.ask("instobjExplore.map()"))
    for act, tables in (
        (lambda: choose(page, "grade", "N35"), {"magnets": {"grade": "N35"}}),
        (
            lambda: choose(page, "chip-part", "TMAG5273A2"),
            {"sensors": {"part": "TMAG5273A2", "range_mt": 133}},
        ),
        (lambda: click(page, "disturbed"), {"limits": {"use": "grasp"}}),
    ):
        act()
        for table, values in tables.items():
            assert values.items() <= design(page)[table].items()
        after = np.array(page.ask("instobjExplore.map()"))
        np.testing.assert_array_equal(after, np.float32(expected(page).ravel()))
        # less field, more noise, and unknowns: each blurs every place
        assert (after > map_before).all()
        map_before = after
    assert shown(page, "range") == "±133 mT\n±266 mT"
    _, folder = served
    made_before = set(folder.glob("*.toml"))
    click(page, "save")
    page.wait("document.querySelectorAll('[data-name=commands] code').length === 3")
    (saved,) = set(folder.glob("*.toml")) - made_before
    spec = load_spec(saved)
    assert (spec.magnets.grade, spec.sensors.part, spec.limits.use) == (
        "N35",
        "TMAG5273A2",
        "grasp",
    )
    for _ in range(3):
        click(page, "undo")
    assert page.ask("document.querySelector('[data-name=disturbed]').checked") is False
    assert shown(page, "range") == "±40 mT\n±80 mT"
    assert design(page)["magnets"]["grade"] is None


def test_a_saved_design_has_its_commands(page, served):
    _, folder = served
    click(page, "save")
    page.wait("document.querySelectorAll('[data-name=commands] code').length === 3")
    path = shown(page, "commands").split("instobj check ")[1].split("\n")[0]
    assert path.startswith(f"{folder}/cube_explored_")
    assert "# mine" in Path(path).read_text()


def test_an_exported_page_is_pressed_and_not_dragged(browser, tmp_path):
    session = Session(made_explorer(), tmp_path / "cube.toml")
    (tmp_path / "page.html").write_text(session.exported())
    browser.send("Page.navigate", url="about:blank")  # the page before asks its server no more
    browser.wait("location.href === 'about:blank'")
    browser.events.clear()
    browser.open(tmp_path / "page.html", READY)
    start = design(browser)
    drag(browser, (24, -10))
    assert design(browser) == start
    x, y = browser.ask(f'instobjExplore.where("magnet", {MAGNET})')
    mouse(browser, "mousePressed", x, y, modifiers=8)
    mouse(browser, "mouseReleased", x, y, modifiers=8)
    browser.wait("document.querySelectorAll('[data-name=counts] tr').length === 3")
    assert browser.requests() == [(tmp_path / "page.html").as_uri()]
    assert browser.problems() == []
