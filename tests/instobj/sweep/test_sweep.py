"""Sweeps of small objects: stages made once, the same on several workers, failures told."""

import csv

import pytest

from design.errors import InputError
from design.spec_io import load_spec
from estimator.frames.dataset import load_frames
from instobj.stages import workers
from instobj.stages.run import Run
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import Here, open_workers
from instobj.store.progress import show_progress
from instobj.store.readers import METRICS
from instobj.store.shared import URL
from instobj.sweep import outcome
from instobj.sweep.outcome import draw_sweep, variant_row
from instobj.sweep.study import Study, Variant, load_study
from instobj.sweep.sweep import sweep
from tests.support.objects.tiny_cube import CHANGES, SMALL_CUBE, lend_mechanics


def write_study(folder, text):
    values = "\n".join(f'"{key}" = {value}' for key, value in (c.split("=", 1) for c in CHANGES))
    path = folder / "study.toml"
    path.write_text(f'name = "s"\nspecification = "{SMALL_CUBE}"\n[set]\n{values}\n{text}')
    return path


NOISE = '[grid]\n"sensors.averaging" = [1, 32]\n"shell.thickness_mm" = [8.0, 30.0]\n'


def test_stages_that_specifications_share_are_one_task():
    quiet, loud, thin = (
        load_spec(SMALL_CUBE, [*CHANGES, change])
        for change in ("sensors.averaging=32", "sensors.averaging=1", "shell.thickness_mm=7.5")
    )
    tasks, last = tasks_of([quiet, loud, thin])
    assert len({keys["scores"] for keys in last}) == 3
    count = {
        name: sum(task.stage == name for task in tasks.values()) for name in ("mesh", "presses")
    }
    assert count == {"mesh": 2, "presses": 2}
    order = list(tasks)
    for key, task in tasks.items():
        assert all(order.index(need) < order.index(key) for need in task.needs)


def test_what_takes_longest_comes_first_and_answers_keep_their_order():
    thin, thick = (
        load_spec(SMALL_CUBE, [*CHANGES, f"shell.thickness_mm={mm}"]) for mm in (7.5, 8.5)
    )
    tasks, last = tasks_of([thin, thick], ("response",))
    assert [task.spec for task in tasks.values()] == [thick, thick, thin, thin]
    assert [tasks[keys["response"]].spec for keys in last] == [thin, thick]


def test_a_sweep_writes_what_single_runs_find_and_goes_on_where_it_was(
    tmp_path, monkeypatch, capfd
):
    lend_mechanics(tmp_path / "store")
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    path = write_study(tmp_path, NOISE)
    show_progress()
    found = sweep(path, tmp_path)
    assert "left out" in capfd.readouterr().err
    with (tmp_path / "runs/s/sweep/sweep.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [bool(row["error"]) for row in rows] == [False, True, False, True]
    loud, quiet = (float(row["place mm"]) for row in rows[::2])
    assert loud > 1.5 * quiet
    alone = Run(
        load_spec(SMALL_CUBE, [*CHANGES, "sensors.averaging=32"])
    ).scores.position_bound_mm.median()
    assert quiet == pytest.approx(float(alone), rel=1e-12)
    page = (tmp_path / "runs/s/sweep/sweep.html").read_text(encoding="utf-8")
    assert "2 of 4 objects taken to scores" in " ".join(page.split())
    assert "data:image/webp" in page
    before = {file.stat().st_mtime_ns for file in (tmp_path / "store").rglob("*.npz")}
    again = sweep(path, tmp_path)
    assert again["rows"] == found["rows"]
    assert {file.stat().st_mtime_ns for file in (tmp_path / "store").rglob("*.npz")} == before


def test_scores_that_differ_little_stand_within_their_panels(monkeypatch, tmp_path):
    kept = []
    monkeypatch.setattr(outcome, "save_figure", lambda figure, path: kept.append(figure))
    rows = [{"shell.thickness_mm": 7.0 + n, "place mm": 0.44 + 0.02 * n} for n in range(3)]
    rows.append({"shell.thickness_mm": 30.0, "place mm": float("inf")})
    study = Study("s", ("scores",), (Variant("a", {"shell.thickness_mm": 7.0}, None),))
    assert draw_sweep(study, rows, tmp_path / "sweep.png")
    (panel,) = kept[0].axes
    low, high = panel.get_ylim()
    assert low == 0
    assert 0.5 < high < 0.6


def test_scores_that_another_machine_made_come_from_the_shared_store(tmp_path, monkeypatch):
    lend_mechanics(tmp_path / "worker")
    study = load_study(write_study(tmp_path, '[grid]\n"sensors.averaging" = [32]\n'))
    (variant,) = study.variants
    assert variant.spec is not None
    tasks, (last,) = tasks_of([variant.spec])
    here = tmp_path / "here"

    def row():
        done = Here().make(tasks, tmp_path / "worker", print)
        return variant_row(variant, {"scores": done[last["scores"]]}, here, tmp_path)

    assert URL in row()["error"]
    monkeypatch.setenv(URL, f"file://{tmp_path / 'bucket'}")
    of_worker = row()
    monkeypatch.delenv(URL)
    assert of_worker == row()
    assert of_worker["place mm"] > 0


def test_a_sweep_takes_specifications_to_frames_and_estimators(tmp_path, monkeypatch):
    lend_mechanics(tmp_path / "store")
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    stages = 'stages = ["frames", "metrics"]\n'
    path = write_study(tmp_path, '[grid]\n"protocol.presses_per_place" = [4, 5]\n')
    path.write_text(stages + path.read_text(encoding="utf-8"), encoding="utf-8")
    found = sweep(path, tmp_path)
    few, many = found["rows"]
    assert many["frames"] == pytest.approx(1.25 * few["frames"], rel=0.02)
    run = Run(load_spec(SMALL_CUBE, [*CHANGES, "protocol.presses_per_place=5"]))
    alone = METRICS.read(run.require("metrics").folder)["baselines"]
    (model,) = (row for row in alone if row["name"] == "model")
    assert many["read place mm"] == pytest.approx(model["place_mm"], rel=1e-12)
    assert many["best simple force %"] == pytest.approx(
        min(row["total_force_percent"] for row in alone if row is not model), rel=1e-12
    )
    for row in found["rows"]:
        frames = load_frames(tmp_path / "runs" / row["object"] / "frames.nc")
        assert len(frames) == row["frames"]
        assert (tmp_path / "runs" / row["object"] / "metrics.json").is_file()
    page = (tmp_path / "runs/s/sweep/sweep.html").read_text(encoding="utf-8")
    assert "2 of 2 objects taken to frames, metrics" in " ".join(page.split())


def test_without_anything_to_score_there_is_one_error(tmp_path, monkeypatch):
    lend_mechanics(tmp_path / "store")
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    path = write_study(tmp_path, '[grid]\n"press.depths_mm" = [[0.01, 0.02]]')
    with pytest.raises(InputError, match="no specification"):
        sweep(path, tmp_path)


def test_a_scheduler_that_does_not_answer_is_one_error(tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr(workers, "ANSWER_S", 0.5)
    with (
        pytest.raises(InputError, match="no Dask scheduler answers"),
        open_workers(1, "tcp://127.0.0.1:1"),
    ):
        pass


@pytest.mark.slow
def test_two_workers_find_what_one_process_finds_though_one_is_killed(tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    import psutil

    path = write_study(tmp_path, '[grid]\n"shell.thickness_mm" = [8.0, 7.5]\n')
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    monkeypatch.setattr(workers, "NEWS_EVERY_S", 0.0)
    killed, made = [], []

    def finished(self, task, outcome):
        made.append(task.key)
        if not killed:
            children = [
                p for p in psutil.Process().children() if "spawn_main" in " ".join(p.cmdline())
            ]
            killed.append(children[0].pid)
            children[0].kill()

    monkeypatch.setattr(workers.WorkersProgress, "finished", finished)
    two = sweep(path, tmp_path, workers=2)
    assert killed
    assert all("error" not in row for row in two["rows"])
    assert len(made) == len(set(made)) == 12
    monkeypatch.undo()
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    assert sweep(path, tmp_path)["rows"] == two["rows"]
