"""Long work of the page: commands that run as they are shown, and layouts of a search that still goes on."""

import asyncio
import time

import numpy as np
import pytest

from design.errors import InputError
from design.search.space import search_space, start_params, with_layout
from design.spec.silicone import SiliconeSpec
from design.spec_io import load_spec
from instobj.explore.design import design_of, kept_file, with_design
from instobj.explore.engine import open_coarse_explorer
from instobj.explore.work import Work, confirmed_rows
from instobj.search.trials import Trial, open_trials
from instobj.stages.run import Run

TINY = """name = "tiny"
[body]
sensed_faces = [1]
[contact_grid]
count = [3, 3]
pitch_mm = 6.0
[press]
depths_mm = [1.0, 2.0]
[mesh]
edge_mm = 8.0
surface_edge_mm = 3.0
envelope_mm = 0.1
[score]
channels = "own"
[search]
forces_n = [2.0]
"""
CUBE = 'name = "mine"\n[search]\nseconds = 60\n'


@pytest.fixture
def cube(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))  # without any mechanics
    (tmp_path / "mine.toml").write_text(CUBE)
    return tmp_path / "mine.toml"


def test_a_command_is_stopped_at_once_and_only_one_runs(cube):
    async def run():
        work = Work()
        await work.confirm(cube, 2.0)
        with pytest.raises(InputError, match="run is at work"):
            await work.improve(cube, 60.0)
        began = time.monotonic()
        await work.stop()
        return work.told(), time.monotonic() - began

    told, took_s = asyncio.run(run())
    assert told["command"] == f"instobj run {cube} --to scores --set score.force_n=2"
    assert not told["running"]
    assert took_s < 12


def test_layouts_of_a_search_are_shown_while_it_writes_and_can_be_taken(cube):
    spec = load_spec(cube)
    space = search_space(spec)
    start = start_params(space)
    kept = open_trials(spec, cube.parent / "runs/mine/search/trials.jsonl")
    moved = {**start, space.continuous_names[0]: start[space.continuous_names[0]] + 0.5}
    name = spec.search.objectives[0]
    for number, (params, worth) in enumerate([(start, 3.0), (moved, 2.0), (start, 1.0)]):
        broken = 0.0 if number < 2 else 1.0
        kept.keep([Trial(params, (worth,), {name: worth}, broken, "", 1, number)])
    with kept.path.open("ab") as stream:
        stream.write(b'{"params": {')  # a trial that is being written
    told = Work(["optimize"], cube).told()
    assert [one["label"].split(":")[0] for one in told["layouts"]] == ["trial 1", "trial 0"]
    taken = with_design(spec, told["layouts"][0]["design"])
    found = with_layout(space.spec, moved)
    assert design_of(taken) == design_of(found)
    places = np.subtract(taken.magnets.lists[0], spec.magnets.lists[0])
    assert np.abs(places).max() == pytest.approx(0.5)
    assert kept.path.read_bytes().endswith(b'{"params": {')


def test_a_design_that_is_there_is_not_saved_again(cube):
    spec = load_spec(cube)
    assert kept_file(spec, cube) == cube
    design = design_of(spec)
    design["shell"]["thickness_mm"] = 9.5
    design["silicone"]["name"] = "Ecoflex 00-30"
    changed = with_design(spec, design)
    assert changed.silicone == SiliconeSpec(name="Ecoflex 00-30")  # with all its figures
    path = kept_file(changed, cube)
    assert path.name == "mine_explored_1.toml"
    assert kept_file(changed, cube) == path
    assert load_spec(path).silicone.youngs_modulus_mpa == changed.silicone.youngs_modulus_mpa
    assert load_spec(path).shell.thickness_mm == 9.5


def test_a_confirmed_design_shows_page_and_chain_side_by_side(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    path = tmp_path / "tiny.toml"
    path.write_text(TINY)
    explorer = open_coarse_explorer(load_spec(path))
    assert confirmed_rows(explorer, path, 2.0) == []  # nothing is computed here
    scores = Run(load_spec(path, ["score.force_n=2.0"])).scores
    rows = {one["name"]: one for one in confirmed_rows(explorer, path, 2.0)}
    place = rows["error of the place, mm: half are below"]
    assert place["chain"] == pytest.approx(float(np.nanmedian(scores.position_bound_mm)))
    quick = explorer.judge(load_spec(path), 2.0).position_bound_mm
    assert place["page"] == pytest.approx(float(np.nanmedian(quick)))
    assert 0.3 < place["chain"] / place["page"] < 3  # both read the chips of the pressed face
    assert rows["error of the force, N: worst"]["chain"] == float(scores.force_bound_n.max())
