"""Exported estimators: the same figures as the trained ones, without torch."""

import copy
import json
import subprocess
import sys
from dataclasses import replace

import numpy as np
import onnx
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError, InstobjError
from design.spec.object import TrainingSpec
from estimator.deploy import export
from estimator.deploy.export import export_onnx, require_parity
from estimator.deploy.runtime import LiveReader, load_deployed, predict_with_gaps
from estimator.frames.splits import split_presses
from estimator.networks.face_model import predict
from estimator.networks.prediction import UNITS
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4
SMALL = TrainingSpec(
    hidden_units=(24,),
    epochs=2,
    ensemble=2,
    history_frames=2,
    trees=4,
    process=True,
)


@pytest.fixture(scope="module")
def frames():
    made = synthetic_frames(presses=3)
    made.signal_counts[:, 3, 1, 2] = np.nan
    return made


@pytest.fixture(scope="module")
def model(frames):
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    split = split_presses(frames, 1)
    parts = frames.select(split.train), frames.select(split.validation)
    fitted = fit_estimator(*parts, FitSettings(FACE, SMALL, axes=3))
    torch.set_num_threads(threads)
    assert fitted.network.forest is not None
    assert fitted.network.process is not None
    fitted.network.force_share.fill_(0.4)  # of so few frames, trees are given no share
    fitted.network.place_shares.copy_(torch.tensor([0.5, 0.2, 0.3]))
    return fitted


@pytest.fixture(scope="module")
def path(model, tmp_path_factory):
    target = tmp_path_factory.mktemp("deployed") / "face_4.onnx"
    export_onnx(model, target)
    return target


@pytest.fixture(scope="module")
def certain(model):
    """A model as sure of its pixels as long training makes it: most weights underflow to zero.

    One member, without trees and process: its graph is made in half the time.
    """
    sure = copy.deepcopy(model)
    sure.network.members = sure.network.members[:1]
    sure.network.forest = sure.network.process = None
    with torch.no_grad():
        for member in sure.network.members:
            member.heads.weight *= 100
            member.sharpness.fill_(4.0)
    return sure


@pytest.fixture(scope="module")
def certain_path(certain, tmp_path_factory):
    target = tmp_path_factory.mktemp("certain") / "certain.onnx"
    export_onnx(certain, target)
    return target


def test_a_model_that_is_certain_of_its_pixels_exports_without_a_nan(certain, certain_path, frames):
    """Fails with `optimize=True`: 0/0 where weights underflow (the first such file: 67 % NaN)."""
    loud = replace(frames, signal_counts=100 * frames.signal_counts)
    trained = predict(certain, loud)
    deployed = predict_with_gaps(load_deployed(certain_path), loud)[1]
    for name in UNITS:
        expected = getattr(trained, name)
        assert np.isfinite(expected).all()
        assert_allclose(
            getattr(deployed, name), expected, rtol=0, atol=1e-3 * np.abs(expected).max()
        )


def test_a_model_that_is_sure_of_rest_is_exported(model, tmp_path):
    """Its force at rest is far below a newton's millionth, of which single precision leaves a tenth: sixty
    presses trained such ones, and none could be exported."""
    sure = copy.deepcopy(model)
    for member in sure.network.members:
        with torch.no_grad():
            member.heads.bias -= 40.0
            member.heads.bias[: member.pixels] += 40.0
    export_onnx(sure, tmp_path / "sure.onnx")
    assert (tmp_path / "sure.onnx").is_file()


def test_an_export_that_differs_from_the_model_is_not_written(certain, tmp_path, monkeypatch):
    export = torch.onnx.export
    monkeypatch.setattr(
        "torch.onnx.export",
        lambda *given, **options: export(*given, **{**options, "optimize": True}),
    )
    with pytest.raises(InputError, match=r"bad\.onnx is not written: in \d+ % of test frames"):
        export_onnx(certain, tmp_path / "bad.onnx")
    assert list(tmp_path.iterdir()) == []


def test_an_error_of_the_trees_or_the_process_is_refused(model, path):
    """2 % of what they say: less than 1e-3 of what networks say far outside training."""
    wrong = copy.deepcopy(model)
    wrong.network.forest.answer *= 0.98
    with pytest.raises(InputError, match=r"the exported \w+ is not that of the trained model"):
        require_parity(wrong, path, path)
    wrong = copy.deepcopy(model)
    wrong.network.process.force.weights *= 0.98
    with pytest.raises(InputError, match=r"the exported \w+ is not that of the trained model"):
        require_parity(wrong, path, path)


def test_one_frame_of_one_output_that_is_off_is_enough(model, path, monkeypatch):
    told, name = export.open_session(path), "xy_mm"

    class Off:
        def run(self, names, given):
            outputs = [np.array(one) for one in told.run(names, given)]
            output = outputs[list(UNITS).index(name)]
            output[7] += 0.1 * abs(output).max()
            return outputs

    monkeypatch.setattr(export, "open_session", lambda written: Off())
    with pytest.raises(
        InputError, match=f"not written: in 0.17 % of .* the exported {name} is not"
    ):
        require_parity(model, path, path)


def test_trees_process_and_novelty_are_in_the_file(model, frames, path):
    """Each tree's path, not only its mean: readings on changes that training never saw agree too."""
    deployed = load_deployed(path)
    louder = replace(frames, signal_counts=3 * frames.signal_counts)
    trained, found = predict(model, louder), predict_with_gaps(deployed, louder)[1]
    for name in UNITS:
        expected = getattr(trained, name)
        assert np.abs(expected).max() > 0
        assert_allclose(getattr(found, name), expected, rtol=0, atol=1e-5 * np.abs(expected).max())
    assert np.array_equal(found.novel, found.novelty > 1)
    assert found.novel.mean() > 0.3 > predict(model, frames).novel.mean()


def test_one_file_says_what_goes_in_and_comes_out(path):
    graph = onnx.load(path)
    found = json.loads({p.key: p.value for p in graph.metadata_props}["instobj"])
    assert found["channel_names"][0] == "F4-X1"
    assert "F4-Z2" not in found["channel_names"]
    assert found["channel_names"][-1] == "dF4-Z3"
    assert found["units"] == UNITS
    assert found["history_frames"] == 2
    assert not [t for t in graph.graph.initializer if t.data_location == onnx.TensorProto.EXTERNAL]


def test_live_readings_are_those_of_the_recording(frames, path):
    """Raw counts, frame by frame, zeroed by the first frames at rest."""
    deployed = load_deployed(path)
    press = frames.select(frames.press_id == 23)
    raw = 1000.0 + press.signal_counts
    reader = LiveReader(deployed, "first", zero_frames=4)
    found = [reader.feed(one) for one in raw]
    assert [one is None for one in found] == [True] * 4 + [False] * (len(raw) - 4)
    zeroed = replace(press, signal_counts=press.signal_counts - press.signal_counts[:4].mean(0))
    expected = predict_with_gaps(deployed, zeroed)[1].force_n[4:]
    assert_allclose([one.force_n[0] for one in found[4:]], expected, rtol=1e-5, atol=1e-5)
    as_they_are = LiveReader(deployed, "none")
    changes = [as_they_are.feed(one).force_n[0] for one in zeroed.signal_counts]
    assert_allclose(changes[4:], expected, rtol=1e-5, atol=1e-5)
    reader.rezero()
    assert reader.feed(raw[0]) is None


def test_changes_keep_their_span_over_a_missed_frame(frames, path):
    """The model reads changes over two frames: the one after a missed frame is read as without it."""
    deployed = load_deployed(path)
    raw = frames.select(frames.press_id == 23).signal_counts
    whole, stuttering = LiveReader(deployed, "none"), LiveReader(deployed, "none")
    expected = [whole.feed(one).force_n[0] for one in raw]
    for one in raw[:6]:
        stuttering.feed(one)
    stuttering.miss()
    assert stuttering.feed(raw[7]).force_n[0] == expected[7]


def test_a_channel_without_a_reading_is_named(frames, path):
    reader = LiveReader(load_deployed(path), "first", zero_frames=1)
    raw = np.zeros((5, 3, 3))
    raw[3, 0, 1] = np.nan
    with pytest.raises(InputError, match="channel F4-Y1, which the model uses"):
        reader.feed(raw)
    broken = frames.signal_counts.copy()
    broken[5, 3, 0, 1] = np.nan
    with_readings, _ = predict_with_gaps(load_deployed(path), replace(frames, signal_counts=broken))
    assert not with_readings[5]
    assert with_readings[:5].all()


@pytest.mark.parametrize("damage", ["missing", "text", "cut", "foreign"])
def test_bad_files_give_one_clear_error(path, tmp_path, damage):
    bad = tmp_path / "bad.onnx"
    if damage == "text":
        bad.write_text("hello")
    elif damage == "cut":
        bad.write_bytes(path.read_bytes()[:-2000])
    elif damage == "foreign":
        graph = onnx.load(path)
        del graph.metadata_props[:]
        onnx.save(graph, bad)
    with pytest.raises(InputError, match=r"bad\.onnx") as raised:
        load_deployed(bad)
    assert len(str(raised.value)) < 400


def test_tensors_in_other_files_are_refused(path, tmp_path, monkeypatch):
    """In the folder where the command runs, which onnxruntime would read."""
    monkeypatch.chdir(tmp_path)
    graph = onnx.load(path)
    onnx.save(graph, "face.onnx", save_as_external_data=True, size_threshold=0, location="weights")
    with pytest.raises(InputError, match=r"in another file, which is not read. Give a file that"):
        load_deployed("face.onnx")


@pytest.mark.slow
def test_a_second_export_is_the_same_byte_by_byte(certain, tmp_path):
    paths = [tmp_path / name for name in ("first.onnx", "again.onnx")]
    for target in paths:
        export_onnx(certain, target)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_a_changed_byte_anywhere_in_an_exported_file_is_one_error(certain_path, tmp_path):
    bad, whole = tmp_path / "bad.onnx", certain_path.read_bytes()
    for at in np.random.default_rng(5).integers(len(whole), size=25).tolist():
        bad.write_bytes(whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1 :])
        with pytest.raises(InstobjError, match=r"bad\.onnx"):
            load_deployed(bad)


def test_prediction_loads_no_torch(path):
    code = (
        "import sys, pathlib, numpy as np\n"
        "from estimator.deploy.runtime import load_deployed, LiveReader\n"
        "import estimator.inversion.tracking, instobj.commands.predict\n"
        f"reader = LiveReader(load_deployed(pathlib.Path({str(path)!r})), 'first', 1)\n"
        "reader.feed(np.zeros((5, 3, 3))); found = reader.feed(np.ones((5, 3, 3)))\n"
        "assert found is not None and found.force_n.shape == (1,)\n"
        "assert 'torch' not in sys.modules, 'torch was imported'\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
