"""Workers that make stages: what they leave out, twins one by one, and commands that ask them."""

import threading
from contextlib import contextmanager
from pathlib import Path

import pytest

from design.errors import InputError
from design.spec_io import load_spec
from instobj.commands import run as commands
from instobj.stages import workers
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import Here
from instobj.store.progress import ProgressLine
from tests.support.objects.tiny_cube import CHANGES, SMALL_CUBE, lend_mechanics


@pytest.fixture
def store(tmp_path, monkeypatch):
    root = tmp_path / "store"
    lend_mechanics(root)
    monkeypatch.setenv("INSTOBJ_STORE", str(root))
    return root


def test_once_there_is_enough_no_further_stage_is_begun(store):
    tasks, _ = tasks_of([load_spec(SMALL_CUBE, CHANGES)])
    asked = iter([False, False, True])
    done = Here().make(tasks, store, print, lambda: next(asked))
    assert list(done) == list(tasks)[:2]


def test_commands_have_their_stages_made_by_the_workers_asked_for(store, tmp_path, monkeypatch):
    asked = []

    @contextmanager
    def opened(count, scheduler, progress):
        asked.append((count, scheduler))
        yield Here()

    monkeypatch.setattr(commands, "open_workers", opened)
    given = [SMALL_CUBE], ("scores",), tmp_path, CHANGES
    (made,) = commands.run_chain(*given, workers=2)["objects"]
    assert all(row["reused"] for row in made["stages"])
    commands.simulate_recordings(
        [SMALL_CUBE], tmp_path, [*CHANGES, "collection.kind=continuous"], 1, "tcp://host:8786"
    )
    assert asked == [(2, None), (1, "tcp://host:8786")]
    commands.run_chain(*given)
    assert len(asked) == 2, "this process alone"
    with pytest.raises(InputError, match="small"):
        commands.run_chain(
            [SMALL_CUBE], ("scores",), tmp_path, [*CHANGES, "press.depths_mm=[0.01,0.02]"], 2
        )


def test_a_scheduler_begins_no_further_stage_once_there_is_enough(monkeypatch):
    """Real scheduler, stages that do nothing: each tells what those before it told."""
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(workers, "work", lambda task, before, root: {
        "key": task["stage"] + "".join(one["key"] for one in before), "error": ""
    })  # fmt: skip
    specs = [load_spec(SMALL_CUBE, [*CHANGES, f"sensors.averaging={n}"]) for n in (1, 32)]
    tasks, last = tasks_of(specs)
    with distributed.Client(
        processes=False, n_workers=1, threads_per_worker=1, dashboard_address=None, memory_limit=0
    ) as client:
        every = workers.OnDask(client)
        assert every.count == 1
        done = every.make(tasks, Path(), print)
        assert {*done} == {*tasks}
        assert done[last[0]["scores"]]["key"].startswith("scoressignalspresses")
        few = every.make(
            tasks_of([load_spec(SMALL_CUBE, [*CHANGES, "sensors.averaging=8"])], ("report",))[0],
            Path(),
            print,
            lambda: True,
        )
    assert 1 <= len(few) < 20


MESHES_AT: list[str] = []
GO_ON = threading.Event()


def first_mesh_never_ends(task, before, root):
    """Stands for a stage's work, on workers that are threads of this process."""
    from distributed import get_worker

    if task["stage"] == "mesh":
        MESHES_AT.append(get_worker().address)
        if len(MESHES_AT) == 1:
            GO_ON.wait(30)
    return {"key": task["stage"], "error": ""}


def test_stages_at_work_are_told_and_those_of_a_lost_worker_are_made_again(monkeypatch):
    """Real scheduler with two workers in this process; the one at work on the mesh is closed."""
    distributed = pytest.importorskip("distributed")
    told: list[str] = []
    MESHES_AT.clear()
    monkeypatch.setattr(workers, "work", first_mesh_never_ends)
    monkeypatch.setattr(workers, "NEWS_EVERY_S", 0.1)
    tasks, (last,) = tasks_of([load_spec(SMALL_CUBE, CHANGES)])
    with (
        distributed.LocalCluster(
            processes=False, n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):

        def step(text):
            if len(MESHES_AT) == 1 and "mesh" in text:
                (lost,) = (w for w in cluster.workers.values() if w.address == MESHES_AT[0])
                cluster.sync(lost.close, executor_wait=False)
            told.append(text)

        monkeypatch.setattr(ProgressLine, "step", lambda self, text: step(text))
        done = workers.OnDask(client, ProgressLine()).make(tasks, Path(), told.append)
        GO_ON.set()
    assert {*done} == {*tasks}
    assert done[last["scores"]] == {"key": "scores", "error": ""}
    assert len(MESHES_AT) == len({*MESHES_AT}) == 2
    assert any("at work or next: " in text and "mesh" in text for text in told)
    assert told[-1].startswith(f"{len(tasks)} of {len(tasks)} stages")
