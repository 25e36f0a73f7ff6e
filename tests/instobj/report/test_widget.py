"""The widget of a notebook: its program, markup and scene are the report's."""

import sys

import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.stages.run import Run
from instobj.store.content import StoredResult
from instobj.viewer.bundling import program


@pytest.fixture
def run(tmp_path):
    (tmp_path / "scene.bin").write_bytes(b"an archive")
    run = Run(ObjectSpec(name="cube"))
    run.results["scene"] = StoredResult("scene", "0" * 64, tmp_path, True, 0.0, "")
    return run


def test_a_run_gives_its_scene_with_the_program_of_the_report(run):
    pytest.importorskip("anywidget")
    state = run.view().get_state()
    assert state["_esm"].startswith(program())
    assert state["_esm"].rstrip().endswith("export default { render: instobjViewer.render };")
    assert state["scene"] == b"an archive"
    assert 'aria-label="cube in three dimensions"' in state["markup"]
    assert "data-scene" not in state["markup"], "the program of a page must not start it"


def test_without_the_extra_the_error_says_what_to_install(run, monkeypatch):
    monkeypatch.setitem(sys.modules, "anywidget", None)
    monkeypatch.delitem(sys.modules, "instobj.report.widget", raising=False)
    with pytest.raises(InputError, match=r"needs anywidget.*pip install 'instobj\[notebook\]'"):
        run.view()
