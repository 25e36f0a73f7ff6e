"""The explorer as a widget of a notebook: design and map as traits, without a notebook and in Chromium."""

import base64
import json
import time

import numpy as np
import pytest

from instobj.explore.design import with_design
from tests.support.browser import Browser, chromium
from tests.support.made_explorer import made_explorer

pytest.importorskip("anywidget")

from instobj.explore.widget import DesignView


@pytest.fixture
def view(tmp_path):
    return DesignView(made_explorer(), tmp_path / "cube.toml")


def expected(design, force_n=5.0):
    explorer = made_explorer()
    return explorer.judge(with_design(explorer.spec, design), force_n).position_bound_mm.ravel()


def moved(view, xy=(3.0, -4.0)):
    design = json.loads(json.dumps(view.design))
    design["magnets"]["positions_mm"][2] = list(xy)
    return design


def test_positions_go_in_and_the_map_comes_out(view):
    start = np.array(view.map["values"], float)
    np.testing.assert_array_equal(start, expected(view.design))
    view.design = moved(view)
    after = np.array(view.map["values"], float)
    np.testing.assert_array_equal(after, expected(view.design))
    assert not np.array_equal(start, after)
    view.force_n = 8.0
    np.testing.assert_array_equal(view.map["values"], expected(view.design, 8.0))


def test_an_impossible_design_is_told_by_the_map(view):
    possible = moved(view)
    view.design = {"magnets": {"positions_mm": "nowhere"}}
    assert "positions_mm" in view.map["error"]
    view.design = possible
    assert "error" not in view.map


HOST = """<!doctype html><meta charset="utf-8"><style>{css}</style><div id="cell"></div><script type="module">
const traits = {traits};
traits.scene = new DataView(Uint8Array.from(atob(traits.scene), (letter) => letter.charCodeAt(0)).buffer);
const heard = {{}};
window.sent = [];
window.model = {{
  get: (name) => traits[name],
  set(name, value) {{ traits[name] = value; heard[`change:${{name}}`]?.forEach((act) => act()); }},
  on: (name, act) => (heard[name] ??= []).push(act),
  send: (message) => window.sent.push(message),
  save_changes: () => window.sent.push({{ question: "judge" }}),
  hear: (message) => heard["msg:custom"].forEach((act) => act(message, [])),
}};
const module = URL.createObjectURL(new Blob([traits._esm], {{ type: "text/javascript" }}));
const {{ default: widget }} = await import(module);
widget.render({{ model, el: document.getElementById("cell") }});
</script>"""
"""The front end's half of a notebook: the model holds traits and messages that a test carries to Python."""


class Notebook:
    """A kernel's half: what the front end sets and sends reaches the widget, and back."""

    def __init__(self, page, view):
        self.page, self.view = page, view

    def carry(self, until):
        """Traits and messages, until an expression of the page is true, for a minute at most."""
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if self.page.ask(until):
                return
            for message in self.page.ask("sent.splice(0)"):
                if message["question"] == "judge":
                    names = ("design", "figure", "force_n", "request")
                    with self.view.hold_trait_notifications():
                        for name in names:
                            setattr(self.view, name, self.page.ask(f"model.get('{name}')"))
                    self._set("map", self.view.map)
                elif message["question"] == "limits":
                    self._hear(message, {"broken": []})
                elif message["question"] == "range":
                    self._hear(message, {"range_used": 0.5})
                else:
                    state = {"scene": "x full", "refined": "", "refining": False}
                    work = {"command": "", "running": False, "line": "", "layouts": []}
                    self._hear(message, state | {"work": work})
        raise AssertionError(f"never true: {until}\n{self.page.problems()}")

    def _hear(self, message, answer):
        self.page.ask(f"model.hear({json.dumps({'number': message['number'], 'answer': answer})})")

    def _set(self, name, value):
        self.page.ask(f"model.set('{name}', {json.dumps(value)})")


@pytest.mark.skipif(chromium() is None, reason="no Chromium on this machine")
def test_the_front_end_sends_positions_and_shows_the_map(view, tmp_path):
    state = view.get_state()
    names = ("_esm", "markup", "design", "figure", "force_n", "map", "request")
    traits = {name: state[name] for name in names}
    traits["scene"] = base64.b64encode(state["scene"]).decode()
    path = tmp_path / "host.html"
    packed = json.dumps(traits).replace("</", "<\\/")
    path.write_text(HOST.format(css=state["_css"], traits=packed), encoding="utf-8")
    with Browser(1100, 900) as page:
        page.open(path, "window.sent?.length")
        notebook = Notebook(page, view)
        ready = "document.getElementById('instobj-explore').dataset.ready === 'yes'"
        notebook.carry(f"{ready} && instobjExplore.idle()")
        box = "document.querySelector('[data-name=x]')"
        page.ask("instobjExplore.state().chosen = {kind: 'magnet', face: 2, number: 2}; 1")
        page.ask(f"{box}.value = '3.5'; {box}.dispatchEvent(new Event('change')); 1")
        notebook.carry("instobjExplore.idle()")
        assert view.design["magnets"]["positions_mm"][2][0] == 3.5
        shown = np.array(page.ask("instobjExplore.map()"), float)
        np.testing.assert_array_equal(shown, np.float32(expected(view.design)))
        page.ask(f"model.set('design', {json.dumps(moved(view))})")
        notebook.carry("instobjExplore.idle()")
        assert page.ask("instobjExplore.state().design.magnets.positions_mm[2]") == [3.0, -4.0]
        assert page.problems() == []
