"""The page's server: whom it answers, and that its answers are those of the engine."""

import asyncio
import json
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from aiohttp import ClientSession, web

from instobj.explore.design import design_of, with_design
from instobj.explore.engine import open_coarse_explorer, summary_of
from instobj.explore.server import Session, application
from tests.support.made_explorer import made_explorer


@pytest.fixture
def session(tmp_path):
    return Session(made_explorer(), tmp_path / "cube.toml")


def ask(session, *requests):
    """Status and text of each request: method, path, headers, body."""

    async def answers():
        with ThreadPoolExecutor(1) as checking:
            runner = web.AppRunner(application(session, checking), shutdown_timeout=0.1)
            await runner.setup()
            await web.TCPSite(runner, "127.0.0.1", 0).start()
            url, found = f"http://127.0.0.1:{runner.addresses[0][1]}", []
            async with ClientSession() as client:
                for method, path, headers, body in requests:
                    sent = client.request(method, url + path, headers=headers, data=body)
                    async with sent as answer:
                        found.append((answer.status, await answer.text("latin-1"), answer.headers))
            await runner.cleanup()
            return found

    return asyncio.run(answers())


def question(**more):
    return json.dumps({"design": design_of(made_explorer().spec)} | more)


def test_foreign_names_and_foreign_pages_are_refused(session):
    """A page of evil.example may point its name at this machine, or post to our address from afar."""
    body = question(figure="position", force_n=5.0)
    foreign = [{"Host": "evil.example"}, {"Origin": "http://evil.example"}, {"Origin": "null"}]
    asked = [("POST", "/judge", headers, body) for headers in foreign]
    asked += [("GET", path, foreign[0], None) for path in ("/", "/scene", "/program.js")]
    assert [status for status, *_ in ask(session, *asked)] == [403] * 6
    assert [status for status, *_ in ask(session, ("POST", "/judge", {}, body))] == [200]


def test_the_page_may_run_its_own_program_alone(session):
    ((_, text, headers),) = ask(session, ("GET", "/", {}, None))
    assert "default-src 'none'; script-src 'self';" in headers["Content-Security-Policy"]
    assert text.count("<script") == 1


def test_answers_are_the_engines_figures(session):
    explorer = made_explorer()
    judged, limits, pressed = (
        json.loads(text)
        for _, text, _ in ask(
            session,
            ("POST", "/judge", {}, question(figure="force", force_n=8.0)),
            ("POST", "/limits", {}, question()),
            ("POST", "/press", {}, question(face=3, places=[7], force_n=8.0)),
        )
    )
    found = explorer.judge(explorer.spec, 8.0)
    np.testing.assert_array_equal(judged["values"], found.force_bound_n.ravel())
    assert judged["summary"]["position"]["worst"] == summary_of(found.position_bound_mm).worst
    assert (judged["magnets"], judged["sensors"]) == (25, 15)
    assert limits == {"broken": []}
    counts = explorer.press(explorer.spec, 3, 8.0).counts([7])
    np.testing.assert_allclose(np.reshape(pressed["counts"], (3, 3)), counts, atol=0.051)


@pytest.mark.parametrize(
    ("path", "body", "told"),
    [
        ("/judge", "{", "no JSON"),
        ("/judge", "{}", "asked wrongly"),
        ("/judge", {"figure": "colour", "force_n": 5.0}, "asked wrongly"),
        ("/judge", {"figure": "force", "force_n": 7.0}, "no presses to 7 N"),
        ("/press", {"face": 3, "places": [900], "force_n": 5.0}, "asked wrongly"),
        ("/judge", json.dumps({"design": {"body": {"kind": "box"}}}), "a design has no body"),
    ],
)
def test_a_wrong_question_is_answered_with_what_is_wrong(session, path, body, told):
    body = question(**body) if isinstance(body, dict) else body
    ((status, text, _),) = ask(session, ("POST", path, {}, body))
    assert status == 400
    assert told in json.loads(text)["error"]


def test_another_shell_is_answered_coarse_at_once_and_said_to_be_refined(session):
    design = design_of(made_explorer().spec)
    design["shell"] = {"thickness_mm": 10.0}
    body = json.dumps({"design": design, "figure": "position", "force_n": 5.0})
    (_, judged, _), (_, state, _) = ask(
        session, ("POST", "/judge", {}, body), ("POST", "/state", {}, body)
    )
    spec = with_design(made_explorer().spec, design)
    expected = open_coarse_explorer(spec).judge(spec, 5.0).position_bound_mm
    np.testing.assert_allclose(json.loads(judged)["values"], expected.ravel(), rtol=1e-9)
    told = json.loads(state)
    assert told["scene"] == json.loads(judged)["scene"]
    assert told["scene"].endswith("coarse")
    assert told["refining"]
    assert "own mechanics is being computed" in told["refined"]


def test_a_shell_that_needs_more_memory_than_there_is_stays_coarse_and_says_so(
    session, monkeypatch
):
    monkeypatch.setenv("INSTOBJ_MEMORY_GIB", "3")
    design = design_of(made_explorer().spec)
    design["shell"] = {"thickness_mm": 10.0}
    body = json.dumps({"design": design, "figure": "position", "force_n": 5.0})
    (status, *_), (_, state, _) = ask(
        session, ("POST", "/judge", {}, body), ("POST", "/state", {}, body)
    )
    content = json.loads(state)
    assert status == 200
    assert not content["refining"]
    assert "needs about" in content["refined"]
    assert "mesh.surface_edge_mm" in content["refined"]


def test_a_shell_without_room_is_told_with_what_is_wrong(session):
    design = design_of(made_explorer().spec)
    design["silicone"] = {"name": "chewing gum"}
    body = json.dumps({"design": design, "figure": "position", "force_n": 5.0})
    ((status, text, _),) = ask(session, ("POST", "/judge", {}, body))
    assert status == 400
    assert "chewing gum" in json.loads(text)["error"]
