"""A run on made-up stages: damage is repaired by itself, and another mesh is another result."""

import itertools
import os

import pytest

from design.spec.object import ObjectSpec
from instobj.stages import run as run_module
from instobj.stages.run import Run
from instobj.store.publish import publish
from instobj.store.readers import GRID_SIGNALS, MESH
from instobj.store.stage import Stage


@pytest.fixture
def made(monkeypatch):
    """What the stages made, in order; the mesher gives another mesh each time."""
    made: list[str] = []
    number = itertools.count(1)

    def mesh(context, folder):
        made.append("mesh")
        MESH.path(folder).write_text(f"mesh {next(number)}")

    def signals(context, folder):
        made.append("signals")
        content = MESH.path(context.inputs["mesh"]).read_text()
        GRID_SIGNALS.path(folder).write_text(f"signals of {content}")

    stages = {
        "mesh": Stage("mesh", (), ("mesh",), mesh),
        "signals": Stage("signals", ("mesh",), ("sensors",), signals),
    }
    monkeypatch.setattr(run_module, "STAGES", stages)
    return made


SPEC = ObjectSpec(name="made_up")


def _signals(root):
    """Of a new process: its run knows nothing yet."""
    return Run(SPEC, root=root).require("signals")


def test_a_repeated_run_makes_nothing(tmp_path, made):
    first = _signals(tmp_path)
    again = _signals(tmp_path)
    assert made == ["mesh", "signals"]
    assert (again.reused, again.folder) == (True, first.folder)


def test_another_mesh_from_the_same_specification_makes_later_stages_anew(tmp_path, made):
    first = _signals(tmp_path)
    (folder,) = (tmp_path / "mesh").iterdir()
    for path in folder.iterdir():
        path.unlink()
    folder.rmdir()
    again = _signals(tmp_path)
    assert made == ["mesh", "signals"] * 2
    assert again.folder != first.folder
    assert GRID_SIGNALS.path(again.folder).read_text() == "signals of mesh 2"


def test_a_damaged_mesh_is_made_again_with_what_follows_from_it(tmp_path, made):
    _signals(tmp_path)
    (folder,) = (tmp_path / "mesh").iterdir()
    os.truncate(MESH.path(folder), 3)
    assert GRID_SIGNALS.path(_signals(tmp_path).folder).read_text() == "signals of mesh 2"
    assert made == ["mesh", "signals"] * 2


def test_a_damaged_later_stage_is_made_again_from_the_same_mesh(tmp_path, made):
    first = _signals(tmp_path)
    GRID_SIGNALS.path(first.folder).unlink()
    again = _signals(tmp_path)
    assert made == ["mesh", "signals", "signals"]
    assert (again.folder, again.content) == (first.folder, first.content)


def test_what_is_published_comes_from_a_verified_result(tmp_path, made):
    store, out = tmp_path / "store", tmp_path / "out"
    first = _signals(store)
    os.truncate(GRID_SIGNALS.path(first.folder), 5)
    publish(SPEC, _signals(store), out)
    assert (out / "runs/made_up/signals.nc").read_text() == "signals of mesh 1"


def test_what_objects_share_is_asked_for_and_told_once(tmp_path, made, monkeypatch):
    def of_two(spec):
        changed = (spec.changed(sensors=spec.sensors.changed(averaging=n)) for n in (1, 8))
        return {f"twin {n}": ("signals", one) for n, one in enumerate(changed)}

    def of_both(context, folder):
        GRID_SIGNALS.path(folder).write_text(str(sorted(context.inputs)))

    stage = Stage("both", ("mesh",), (), of_both, of_others=of_two)
    monkeypatch.setitem(run_module.STAGES, "both", stage)
    result = Run(SPEC, root=tmp_path).require("both")
    assert GRID_SIGNALS.path(result.folder).read_text() == "['mesh', 'twin 0', 'twin 1']"
    assert made == ["mesh", "signals", "signals"]


def test_stages_know_what_their_call_asks_for_and_kept_factors_end_with_it(
    tmp_path, made, monkeypatch
):
    calls, released = {}, []

    class Factor:
        def __init__(self, of):
            self.of, self.factor = of, self

        def release(self):
            released.append(self.of)

    def mesh(context, folder):
        MESH.path(folder).write_text("mesh")
        calls[context.spec.name] = context.call
        context.call.factored = Factor(context.spec.name)
        if context.spec.name == "made_up":
            Run(SPEC.changed(name="within"), root=tmp_path).require("mesh")
            assert released == ["within"]

    monkeypatch.setitem(run_module.STAGES, "mesh", Stage("mesh", (), ("name",), mesh))
    run = Run(SPEC, root=tmp_path)
    run.require("signals")
    assert released == ["within", "made_up"]
    assert {name: call.asks_for for name, call in calls.items()} == {
        "made_up": {"mesh", "signals"}, "within": {"mesh"}
    }  # fmt: skip
    assert run.call is None


def test_what_is_stored_is_found_without_making_anything(tmp_path, made, monkeypatch):
    assert Run(SPEC, root=tmp_path).stored("signals") is None
    Run(SPEC, root=tmp_path).require("mesh")
    assert Run(SPEC, root=tmp_path).stored("signals") is None
    first = _signals(tmp_path)
    found = Run(SPEC, root=tmp_path).stored("signals")
    assert found is not None
    assert (found.folder, found.content) == (first.folder, first.content)
    assert made == ["mesh", "signals"]

    def of_another(spec):
        return {"other": ("signals", spec.changed(sensors=spec.sensors.changed(averaging=8)))}

    stage = Stage("both", ("mesh",), (), lambda context, folder: None, of_others=of_another)
    monkeypatch.setitem(run_module.STAGES, "both", stage)
    assert Run(SPEC, root=tmp_path).stored("both") is None
