"""`instobj train --export` and `instobj predict` on files and on a port."""

import csv
import json
import re
import shutil
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from typer.testing import CliRunner

import instobj
from design.errors import InputError, StoreError
from design.spec.object import TrainingSpec
from estimator.deploy.runtime import channel_readings
from estimator.frames.dataset import load_frames, save_frames
from estimator.frames.splits import split_presses
from estimator.networks.face_model import load_model, predict, save_model
from estimator.networks.training.face import FitSettings, fit_estimator
from estimator.recordings.boards.lines import encode_frame
from instobj.cli.app import app
from instobj.commands.assess.tracks import load_estimators
from instobj.commands.predict import export_models, predict_file, predict_port
from instobj.commands.readings import (
    SILENT_FRAMES,
    Zeroing,
    lacks_readings,
    live_frames,
    prediction_path,
)
from tests.support.recordings.dummy_board import (
    CHANNELS,
    RATE_HZ,
    board_lines,
    counts_at,
    dummy_board,
)
from tests.support.recordings.pressed_frames import made_frames

FACE = 3
ONE = {"history_frames": 0, "ensemble": 1, "trees": 0, "process": False}
SMALL = TrainingSpec(hidden_units=(16,), epochs=2, **ONE)
SETTINGS = ["training.hidden_units=[16]", "training.epochs=2", "seed=1"] + [
    f"training.{name}={str(value).lower()}" for name, value in ONE.items()
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    target = tmp_path_factory.mktemp("predict")
    frames = made_frames()
    save_frames(frames, target / "press.nc")
    split = split_presses(frames, 1)
    parts = frames.select(split.train), frames.select(split.validation)
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    save_model(fit_estimator(*parts, FitSettings(FACE, SMALL)), target / "face_3.safetensors")
    torch.set_num_threads(threads)
    export_models([target], target / "robot")
    return target


def test_what_is_no_exported_estimator_or_folder_of_trained_ones_is_one_error(folder, tmp_path):
    with pytest.raises(
        InputError, match=r"not exported yet\. `instobj train --export .*face_3\.safetens"
    ):
        predict_file(folder / "face_3.safetensors", folder / "press.nc")
    with pytest.raises(InputError, match=r"holds no trained estimator \(face_<n>\.safetensors or"):
        export_models([tmp_path], tmp_path)


@pytest.fixture
def several(tmp_path, monkeypatch):
    """Estimators of one face in a folder, in one of its own there, and elsewhere; they are exported in
    no time."""
    monkeypatch.setattr("estimator.networks.face_model.load_model", lambda path: path)
    monkeypatch.setattr(
        "estimator.deploy.export.export_onnx",
        lambda model, target: (
            target.parent.mkdir(parents=True, exist_ok=True),
            target.write_text(str(model)),
        ),
    )
    paths = [tmp_path / name for name in ("runs/cube", "runs/cube/twin", "runs/other")]
    for path in paths:
        path.mkdir(parents=True)
        (path / "face_3.safetensors").touch()
    return paths


def exported(found):
    return [Path(row["path"]) for row in found["files"]]


def test_export_finds_estimators_with_a_twin_and_keeps_them_apart(several, tmp_path):
    plain, twin, _ = several
    names = ["face_3.onnx", "twin/face_3.onnx"]
    assert exported(export_models([plain])) == [plain / name for name in names]
    out = tmp_path / "robot"
    assert exported(export_models([plain], out)) == [out / name for name in names]
    assert exported(export_models([twin])) == [twin / "face_3.onnx"]
    assert (out / "twin" / "face_3.onnx").read_text() == str(twin / "face_3.safetensors")


def judging_line(model):
    """Command that an export names, from the text that it ends."""
    (text,) = export_models([model])["texts"]
    said, line = text.split(": ")
    assert "another recording" in said
    return line


def test_the_command_after_an_export_keeps_the_folder_of_results(several, tmp_path, monkeypatch):
    """Predictions went to `runs` of the folder that the command was called in."""
    read = f"instobj predict {several[0]}/face_3.onnx RECORDING --out {tmp_path}"
    assert judging_line(several[0] / "face_3.safetensors") == read
    assert judging_line(several[0]) == read
    monkeypatch.chdir(tmp_path)
    assert judging_line(Path("runs/cube")) == "instobj predict runs/cube/face_3.onnx RECORDING"
    monkeypatch.chdir(tmp_path / "runs")
    assert "--out" not in judging_line(Path("cube"))


def test_after_an_export_the_training_s_own_data_set_is_not_proposed(several):
    """Figures on what was trained on hold for no other recording."""
    (several[0] / "frames.nc").touch()
    document = export_models([several[0]])
    assert "frames.nc" not in document["next"] + "".join(document["texts"])
    assert document["next"] == "instobj docs calibrate"


def test_two_estimators_that_would_be_one_file_are_refused_before_any_is_written(several, tmp_path):
    plain, _, other = several
    with pytest.raises(InputError, match=r"cube/face_3.* and .*other/face_3.* both become .*robot"):
        export_models([plain, other], tmp_path / "robot")
    assert not (tmp_path / "robot").exists()
    again = export_models([plain / "face_3.safetensors", plain], tmp_path / "robot")
    assert len(again["files"]) == 2


def test_an_export_into_a_file_is_refused_before_an_estimator_is_loaded(
    several, tmp_path, monkeypatch
):
    monkeypatch.setattr("estimator.networks.face_model.load_model", None)
    (tmp_path / "taken").touch()
    with pytest.raises(StoreError, match=r"taken: it is a file, not a folder"):
        export_models([several[0] / "face_3.safetensors"], tmp_path / "taken")


def test_export_writes_into_the_folder_that_is_named_also_if_it_is_this_one(
    several, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, ["train", "--export", "runs/other", "--out", ".", "--json"])
    assert [row["path"] for row in json.loads(done.stdout)["files"]] == ["face_3.onnx"]


def test_predictions_of_an_estimator_with_a_twin_have_a_name_of_their_own(folder, tmp_path):
    (tmp_path / "twin").mkdir()
    shutil.copy(folder / "robot" / "face_3.onnx", tmp_path / "twin")
    found = predict_file(tmp_path / "twin" / "face_3.onnx", folder / "press.nc", tmp_path)
    assert [path.name for path in exported(found)] == ["prediction_twin_face_3.csv"]


def test_what_predict_cannot_use_is_refused_in_a_sentence(folder, tmp_path):
    model = str(folder / "robot" / "face_3.onnx")
    for words, said in (
        (
            [model, "a.csv", "--frames", "3"],
            "--frames stops reading a --port after 3 frames; a.csv",
        ),
        ([str(folder / "robot"), "a.csv"], "robot is a folder. Give one exported estimator"),
    ):
        done = CliRunner().invoke(app, ["predict", *words])
        assert said in str(done.exception)


def test_a_recording_with_fewer_sensors_names_the_channel_that_is_missing(folder, tmp_path):
    """It ended in an IndexError."""
    spoken = lacks_readings(np.zeros((2, 5, 1, 3)), ((3, 0, 2), (103, 1, 0)))
    assert spoken.tolist() == [True, True]
    spoken = lacks_readings(np.zeros((2, 5, 2, 3)), ((3, 0, 2), (103, 1, 0)))
    assert spoken.tolist() == [False, False]


def test_a_folder_in_place_of_a_recording_is_one_error():
    with pytest.raises(InputError, match="is a folder, not a file"):
        prediction_path("contacts.csv", Path("."), Path("."))


def test_predict_a_data_set(folder, tmp_path):
    found = predict_file(folder / "robot" / "face_3.onnx", folder / "press.nc", tmp_path)
    with (tmp_path / "runs" / "press" / "prediction_face_3.csv").open() as file:
        rows = list(csv.DictReader(file))
    frames = load_frames(folder / "press.nc")
    expected = predict(load_model(folder / "face_3.safetensors"), frames).force_n
    np.testing.assert_allclose([float(row["force_n"]) for row in rows], expected, atol=1e-3)
    assert float(rows[7]["force_low_n"]) <= float(rows[7]["force_n"])
    summary = next(iter(found["tables"].values()))[0]
    assert summary["frames"] == len(frames)
    with pytest.raises(InputError, match="zeroed press by press; got --zero first"):
        predict_file(
            folder / "robot" / "face_3.onnx", folder / "press.nc", tmp_path, Zeroing("first")
        )


def test_two_data_sets_give_two_files(folder, tmp_path):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "frames.nc").write_bytes((folder / "press.nc").read_bytes())
        predict_file(
            folder / "robot" / "face_3.onnx", tmp_path / name / "frames.nc", tmp_path / "out"
        )
    written = sorted((tmp_path / "out").rglob("*.csv"))
    assert [path.parent.name for path in written] == ["one", "two"]


def test_predictions_go_to_runs_of_this_folder_and_not_beside_their_data_set(
    folder, tmp_path, monkeypatch
):
    path = tmp_path / "elsewhere" / "same" / "frames.nc"
    path.parent.mkdir(parents=True)
    path.write_bytes((folder / "press.nc").read_bytes())
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    given = ["predict", str(folder / "robot" / "face_3.onnx"), str(path)]
    assert CliRunner().invoke(app, given).exit_code == 0
    assert [*tmp_path.rglob("*.csv")] == [tmp_path / "here/runs/same/prediction_face_3.csv"]


def test_predictions_carry_frame_numbers_and_stamps(folder, tmp_path):
    """The 14 frames of a recording, four of which give the zero; a data set's from the first on."""
    path = board_recording(folder, tmp_path / "board.csv")
    predict_file(folder / "robot" / "face_3.onnx", path, tmp_path, Zeroing("first", 4))
    with (tmp_path / "runs/board/prediction_face_3.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [int(row["frame"]) for row in rows] == list(range(4, 14))
    assert [float(row["time_s"]) for row in rows] == [1.7e9 + k / 10 for k in range(4, 14)]
    predict_file(folder / "robot" / "face_3.onnx", folder / "press.nc", tmp_path)
    with (tmp_path / "runs" / "press" / "prediction_face_3.csv").open() as file:
        rows = list(csv.DictReader(file))
    frames = load_frames(folder / "press.nc")
    assert [int(row["frame"]) for row in rows] == list(range(len(frames)))
    np.testing.assert_array_equal([float(row["time_s"]) for row in rows], frames.time_s)


def test_a_folder_that_cannot_be_written_is_told_before_any_work(folder, tmp_path):
    """A file where the folder of results would be made."""
    (tmp_path / "out").write_text("")
    with pytest.raises(StoreError, match="--out"):
        predict_file(folder / "robot" / "face_3.onnx", folder / "press.nc", tmp_path / "out")


def another_object(frames, **changes):
    """The same frames with a second sensor on face 3, or on another grid."""
    if "sensors" in changes:
        second = np.full_like(frames.signal_counts, np.nan)
        second[:, 2] = 5.0
        return replace(frames, signal_counts=np.concatenate([frames.signal_counts, second], axis=2))
    return replace(frames, **changes)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"sensors": 2}, "also has readings of F3-S2, so it is of another object"),
        ({"grid_x_mm": np.array([-4.0, 0.0, 4.0])}, "grid is 3 places from -3 to 3 mm"),
        ({"grid_y_mm": np.array([0.0, 3.0, 6.0])}, "that of .* 3 places from 0 to 6 mm"),
    ],
)
def test_a_model_of_another_object_is_refused(folder, tmp_path, changes, words):
    path = tmp_path / "other.nc"
    save_frames(another_object(load_frames(folder / "press.nc"), **changes), path)
    with pytest.raises(InputError, match=words):
        predict_file(folder / "robot" / "face_3.onnx", path, tmp_path)
    assert not (tmp_path / "runs").exists()


def test_networks_on_another_grid_than_the_specification_name_the_step_that_helps(folder, tmp_path):
    """Networks of recordings that were read without --spec were refused without a word on it."""
    spec = tmp_path / "cube.toml"
    spec.write_text('name = "cube"\ncontact_grid.count = [4, 4]\n')
    with pytest.raises(
        InputError, match=r"`instobj recordings FILES --spec .*cube\.toml`, and train"
    ):
        load_estimators(folder / "face_3.safetensors", spec)


def test_evaluation_refuses_a_model_of_another_object(folder):
    other = another_object(load_frames(folder / "press.nc"), sensors=2)
    with pytest.raises(InputError, match="so it is of another object"):
        instobj.evaluate(load_model(folder / "face_3.safetensors"), other)


def board_recording(folder, path):
    """The first press as raw counts in the generic format, stamped in seconds since 1970."""
    frames = load_frames(folder / "press.nc").select(np.arange(14))
    raw = 700.0 + frames.signal_counts[:, [2], 0][:, 0]
    lines = ["time_s,F3-X1,F3-Y1,F3-Z1,cell1_face,cell1_x1_mm,cell1_y1_mm,cell1_force_n"]
    force = np.nan_to_num(frames.force_n[:, 0, 2])
    for k, row in enumerate(raw.round(1)):
        label = "3,-3,3" if force[k] > 0 else ",,"
        lines.append(f"{1.7e9 + k / 10:.1f},{row[0]},{row[1]},{row[2]},{label},{force[k]:.3f}")
    path.write_text("\n".join(lines) + "\n")
    return path


def test_predict_a_recording_zeroes_by_its_first_frames(folder, tmp_path):
    path = board_recording(folder, tmp_path / "board.csv")
    predict_file(folder / "robot" / "face_3.onnx", path, tmp_path, Zeroing("first", 4))
    with (tmp_path / "runs" / "board" / "prediction_face_3.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 10
    with pytest.raises(InputError, match=r"Take fewer frames as rest .--zero first:5"):
        predict_file(folder / "robot" / "face_3.onnx", path, tmp_path, Zeroing("first", 14))
    with pytest.raises(
        InputError, match=r"never 20 at rest on end.*first frames as rest .--zero first"
    ):
        predict_file(folder / "robot" / "face_3.onnx", path, tmp_path, Zeroing("rest", 20))


def test_a_recording_without_load_cells_is_read_all_the_same(folder, tmp_path):
    model, path = folder / "robot" / "face_3.onnx", board_recording(folder, tmp_path / "board.csv")
    predict_file(model, path, tmp_path, Zeroing("first", 4))
    rows = [line.split(",")[:4] for line in path.read_text().splitlines()]
    bare = tmp_path / "bare.csv"
    bare.write_text("\n".join(",".join(row) for row in rows) + "\n")
    predict_file(model, bare, tmp_path, Zeroing("first", 4))
    found, expected = (
        (tmp_path / "runs" / name / "prediction_face_3.csv").read_text()
        for name in ("bare", "board")
    )
    assert found == expected
    for cell, words in (("x", "line 4, column F3-Y1: 'x' is not"), ("1e9", "counts reach 1e\\+09")):
        rows[3][2] = cell
        bare.write_text("\n".join(",".join(row) for row in rows) + "\n")
        with pytest.raises(InputError, match=words):
            predict_file(model, bare, tmp_path)


def test_rows_that_repeat_the_one_before_are_told(folder, tmp_path):
    path = tmp_path / "twice.csv"
    counts = np.random.default_rng(0).normal(700, 20, (60, 3)).round().repeat(2, axis=0)
    rows = [f"{k / 20:.2f},{row[0]},{row[1]},{row[2]}" for k, row in enumerate(counts)]
    path.write_text("\n".join(["time_s,F3-X1,F3-Y1,F3-Z1", *rows]) + "\n")
    with pytest.raises(InputError, match="the row before in 60 of 120 rows, so that rest does not"):
        predict_file(folder / "robot" / "face_3.onnx", path, tmp_path)


def test_frames_that_lack_a_reading_are_passed_over_and_counted(folder, tmp_path):
    """One lost reading of three channels; a channel that never speaks is still refused."""
    model, path = folder / "robot" / "face_3.onnx", board_recording(folder, tmp_path / "board.csv")
    rows = [line.split(",") for line in path.read_text().splitlines()]
    rows[10][2] = ""
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    found = predict_file(model, path, tmp_path, Zeroing("first", 4))
    with (tmp_path / "runs/board/prediction_face_3.csv").open() as file:
        assert [int(row["frame"]) for row in csv.DictReader(file)] == [*range(4, 9), *range(10, 14)]
    (summary,) = next(iter(found["tables"].values()))
    told = ("frames", "frames that lack a reading", "frames before a zero")
    assert [summary[name] for name in told] == [9, 1, 4], "14 frames in all"
    for row in rows[1:]:
        row[2] = ""
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    with pytest.raises(InputError, match="channel F3-Y1, which the model uses"):
        predict_file(model, path, tmp_path, Zeroing("first", 4))
    frames = load_frames(folder / "press.nc")
    frames.signal_counts[5, 2, 0, 1] = np.nan
    save_frames(frames, tmp_path / "lost.nc")
    summary = next(iter(predict_file(model, tmp_path / "lost.nc", tmp_path)["tables"].values()))[0]
    assert (summary["frames"], summary["frames that lack a reading"]) == (len(frames) - 1, 1)


class Heard:
    """A reader that keeps what it is fed; as strict as the real ones."""

    def __init__(self):
        self.fed = []

    leaves_out = False

    def feed(self, raw_counts, time_s, left_out):
        channel_readings(raw_counts, ((3, 0, 1),))
        self.fed.append(time_s)
        return time_s

    def miss(self):
        self.fed.append(None)


def test_a_board_may_miss_readings_until_a_channel_is_silent(monkeypatch):
    """Frames 2, 5, 6 lack a reading, and all from frame 9 on."""
    counts = np.zeros((40, 5, 1, 3))
    counts[[2, 5, 6, *range(9, 40)], 2, 0, 1] = np.nan
    sent = (SimpleNamespace(counts=one, time_s=float(k)) for k, one in enumerate(counts))
    monkeypatch.setattr("estimator.recordings.boards.link.board_readings", lambda *_: sent)
    reader = Heard()
    frames = live_frames(reader, ((3, 0, 1),), "port", 9600)
    read = [next(frames) for _ in range(6)]
    assert [one.number for one in read] == [0, 1, 3, 4, 7, 8]
    assert [one.line["unread_frames"] for one in read] == [0, 0, 1, 1, 3, 3]
    with pytest.raises(InputError, match="channel F3-Y1, which"):
        next(frames)
    assert reader.fed[9:] == [None] * SILENT_FRAMES


def resting_lines(k):
    """Frames of a board on which nothing presses, as long as a zero that follows rest wants."""
    return encode_frame(k, round(1000 * k / RATE_HZ), counts_at(k % 20))


def test_predict_live_from_a_board(folder):
    with dummy_board(resting_lines) as port:
        lines = list(predict_port(folder / "robot" / "face_3.onnx", port, Zeroing(), 5))
    assert len(lines) == 5
    assert set(json.loads(lines[0])) >= {"time_s", "force_n", "x_mm", "contact"}
    assert "F3-X1" in CHANNELS


def lossy_lines(k):
    """Every tenth frame is lost, and every eighth arrives with a changed digit."""
    line = board_lines(k, loads=False)
    return b"" if k % 10 == 5 else line.replace(b",", b";", 1) if k % 8 == 1 else line


def test_a_live_reading_tells_lost_frames_and_damaged_lines(folder):
    with dummy_board(lines=lossy_lines) as port:
        lines = list(predict_port(folder / "robot" / "face_3.onnx", port, Zeroing("none"), 60))
    first, last = json.loads(lines[0]), json.loads(lines[-1])
    assert 5 <= last["damaged_lines"] - first["damaged_lines"] <= 12
    assert 10 <= last["lost_frames"] - first["lost_frames"] <= 20


def test_the_live_baud_rate_reaches_the_port(folder, monkeypatch):
    asked = []

    def refused(port, baud, **_):
        asked.append((port, baud))
        raise ValueError("no such rate")

    monkeypatch.setattr("serial.Serial", refused)
    given = ["predict", str(folder / "robot" / "face_3.onnx"), "--port", "none@57600"]
    result = CliRunner().invoke(app, given)
    assert "no such rate" in str(result.exception)
    assert asked == [("none", 57600)]


def test_the_share_that_an_interval_held_is_measured_where_forces_are_known(folder, tmp_path):
    """What the calibration promises is told apart from what the labels of this file show."""
    true, target = made_frames(), tmp_path / "heavier.nc"
    normal = true.force_n.copy()
    normal[..., 2] *= 3.0  # labels that the estimator was not trained on
    save_frames(replace(true, force_n=normal), target)
    (own,), (other,) = (
        next(
            iter(predict_file(folder / "robot" / "face_3.onnx", path, tmp_path)["tables"].values())
        )
        for path in (folder / "press.nc", target)
    )
    assert own["force interval should hold"] == other["force interval should hold"] == 0.9
    assert own["of frames pressed"] == int(np.sum(true.contact_face == FACE))
    assert own["force interval held"] > 0.7 > other["force interval held"]


def judged(document):
    """Rows of errors against labels, by what read."""
    tables = document["tables"]
    titles = [title for title in tables if title.startswith("against the labels")]
    return {row["read by"]: row for title in titles for row in tables[title]}


def test_errors_are_measured_against_labels_beside_a_simple_regression(folder, tmp_path):
    """Errors are worked out by hand from the predictions; regressions learn from the model's data set."""
    model, true = tmp_path / "face_3.onnx", made_frames()
    shutil.copy(folder / "robot" / "face_3.onnx", model)
    save_frames(true, tmp_path / "frames.nc")
    other = replace(true, signal_counts=1.1 * true.signal_counts)
    save_frames(other, tmp_path / "other.nc")
    document = predict_file(model, tmp_path / "other.nc", tmp_path)
    with open(document["files"][0]["path"]) as table:
        rows = list(csv.DictReader(table))
    pressed = np.flatnonzero((true.contact_face == FACE).any(axis=1))
    force_n, x_mm, y_mm = (
        np.array([float(rows[k][name]) for k in pressed]) for name in ("force_n", "x_mm", "y_mm")
    )
    missed_n = np.abs(force_n - true.force_n[pressed, 0, 2])
    away_mm = np.hypot(*(np.array([x_mm, y_mm]).T - true.contact_xy_mm[pressed, 0]).T)
    network, simple, worse = judged(document).values()
    expected = np.concatenate([np.percentile(e, [50, 95]) for e in (missed_n, away_mm)])
    np.testing.assert_allclose(list(network.values())[1:5], expected, atol=2e-3)
    # made frames are linear in force: two epochs of a network are worse
    assert {simple["read by"], worse["read by"]} == {"ridge", "nearest neighbours"}
    assert simple["force error, median N"] <= worse["force error, median N"]
    assert simple["force error, median N"] < network["force error, median N"]
    (better,) = [text for text in document["texts"] if "reads force better" in text]
    assert f"{simple['force error, median N']:.3g} instead of" in better
    assert network["frames"] == simple["frames"] == len(pressed)
    assert len(judged(predict_file(model, tmp_path / "frames.nc", tmp_path))) == 1


def test_pressed_frames_that_nothing_explains_are_judged_apart(folder, tmp_path):
    """An interval that held 88 % stood next to "do not believe these"."""
    true = made_frames()
    far, force_n = true.signal_counts.copy(), true.force_n.copy()
    rows = np.flatnonzero((true.contact_face == FACE).any(axis=1))[::2]
    far[rows] *= 40.0
    force_n[rows] *= 40.0
    save_frames(replace(true, signal_counts=far, force_n=force_n), tmp_path / "far.nc")
    texts = predict_file(folder / "robot" / "face_3.onnx", tmp_path / "far.nc", tmp_path)["texts"]
    (text,) = [text for text in texts if "labelled force" in text]
    percents = re.search(
        r"Of (\d+) pressed frames that .*explains, (\d+)% have .*Of \d+ other .*, (\d+)% have", text
    )
    novel, held, others = map(int, percents.groups())
    assert held <= 1 < 90 < others
    assert len(rows) <= novel < 1.1 * len(rows)
    assert max(len(sentence.split()) for sentence in text.split(". ")) <= 20


def test_more_tips_than_were_trained_on_are_the_cause_and_decide_what_comes_next(folder, tmp_path):
    """More tips are no cause of anything where frames are explained."""
    model, true = tmp_path / "face_3.onnx", made_frames()
    shutil.copy(folder / "robot" / "face_3.onnx", model)
    save_frames(true, tmp_path / "frames.nc")
    twice = replace(
        true,
        signal_counts=40.0 * true.signal_counts,
        contact_face=np.repeat(true.contact_face, 2, axis=1),
        contact_xy_mm=np.repeat(true.contact_xy_mm, 2, axis=1),
        force_n=np.repeat(true.force_n, 2, axis=1),
    )
    save_frames(twice, tmp_path / "twice.nc")
    far = replace(true, signal_counts=40.0 * true.signal_counts)
    save_frames(far, tmp_path / "far.nc")
    save_frames(replace(true, signal_counts=1.1 * true.signal_counts), tmp_path / "near.nc")
    explained = replace(twice, signal_counts=1.1 * true.signal_counts)
    save_frames(explained, tmp_path / "explained.nc")
    several, guessed, near, twice_near = (
        predict_file(model, tmp_path / f"{name}.nc", tmp_path)
        for name in ("twice", "far", "near", "explained")
    )
    said = " ".join(several["texts"])
    assert "up to two tips on face 3; the network was trained on one" in said
    assert "distance from the labelled centre of force" in said
    assert "Likely causes" not in said
    assert "Likely causes" in " ".join(guessed["texts"])
    assert several["next"] == "instobj docs inversion"
    assert guessed["next"] == "instobj docs calibrate"
    assert near["next"] == twice_near["next"] == "instobj docs live"
    assert "two tips" not in " ".join(twice_near["texts"])


def test_a_recording_that_was_trained_on_is_named(folder, tmp_path):
    """The data set in the estimator's folder shows it; readings that are a tenth larger are none of it."""
    model = tmp_path / "face_3.onnx"
    shutil.copy(folder / "robot" / "face_3.onnx", model)
    frames = made_frames()
    save_frames(frames, tmp_path / "frames.nc")
    save_frames(replace(frames, signal_counts=1.1 * frames.signal_counts), tmp_path / "new.nc")
    own, other = (
        predict_file(model, tmp_path / name, tmp_path)["texts"] for name in ("frames.nc", "new.nc")
    )
    assert any("frames.nc is what face_3.onnx was trained on" in text for text in own)
    assert not any("trained on:" in text for text in other)


def test_without_load_cells_no_share_is_claimed(folder, tmp_path):
    frames = made_frames()
    nothing = replace(
        frames,
        contact_face=np.zeros_like(frames.contact_face),
        contact_xy_mm=np.full_like(frames.contact_xy_mm, np.nan),
        force_n=np.full_like(frames.force_n, np.nan),
    )
    save_frames(nothing, tmp_path / "rest.nc")
    model = folder / "robot" / "face_3.onnx"
    (row,) = next(iter(predict_file(model, tmp_path / "rest.nc", tmp_path)["tables"].values()))
    assert "not known" in row["force interval held"]
    assert judged(predict_file(model, tmp_path / "rest.nc", tmp_path)) == {}
