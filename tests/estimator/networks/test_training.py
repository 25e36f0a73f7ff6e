"""Estimators trained on a small synthetic data set whose truth is known."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose, assert_array_equal
from safetensors.torch import load_file, save_file

from design.errors import InputError, StoreError
from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import evaluate_face
from estimator.frames.face_data import FaceData, face_data, live_channels
from estimator.frames.press_protocol import with_nuisances
from estimator.frames.splits import split_presses
from estimator.networks.face_model import (
    MODEL_FORMAT,
    description,
    load_model,
    predict,
    predict_heatmaps,
    save_model,
)
from estimator.networks.network import HeadsNetwork
from estimator.networks.tensor_file import save_tensors
from estimator.networks.training import face as face_training
from estimator.networks.training.face import FitSettings, fit_estimator
from studies.paper.heatmap_baselines import linear_baseline, mean_map_baseline
from tests.support.recordings.synthetic_frames import synthetic_frames

QUICK = TrainingSpec(hidden_units=(96, 96), epochs=30)
SHORT = QUICK.model_copy(update={"epochs": 2})
FACE = 4


def train_face(frames, face, training, seed, progress=None, split=None, **more):
    split = split or split_presses(frames, seed)
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(face, training, seed, **more), progress=progress)


@pytest.fixture(scope="module")
def frames():
    made = synthetic_frames(presses=6)
    made.signal_counts[:, 3, 1, 2] = np.nan
    return made


@pytest.fixture(scope="module")
def split(frames):
    return split_presses(frames, 7)


@pytest.fixture(scope="module")
def model(frames, split):
    return train_face(frames, FACE, QUICK, seed=7, split=split)


@pytest.fixture(scope="module")
def result(model, frames, split):
    return evaluate_face(model, frames.select(split.test), frames)


def test_face_data_selects_valid_frames(frames):
    hidden = replace(frames, valid=np.arange(len(frames)) >= 100)
    data = face_data(hidden, FACE)
    assert len(data) == len(frames) - 100
    assert data.contact.sum() == np.sum(hidden.contact_face[hidden.valid] == FACE)
    assert_array_equal(data.rest, hidden.contact_face[hidden.valid, 0] == 0)
    assert (1, 2) not in live_channels(data)
    assert len(live_channels(data)) == 8


def test_estimator_is_good(result):
    assert result.similarity > 0.97
    assert result.location_error_px < 0.25
    assert result.force_error_percent < 8
    assert result.non_contact_accuracy > 0.95
    assert result.other_face_accuracy > 0.9


def test_estimator_beats_the_baselines(result, frames, split):
    ridge = linear_baseline(frames, FACE, split)
    chance = mean_map_baseline(frames, FACE, split)
    assert result.force_error_percent < 0.5 * ridge.force_error_percent
    assert ridge.location_error_px < chance.location_error_px
    assert result.contact_frames == ridge.contact_frames == chance.contact_frames


def test_the_ridge_baseline_stays_on_the_processor(frames, split, monkeypatch):
    """Whatever networks are trained on; "meta" stands for a card, whose tensors NumPy cannot read."""
    monkeypatch.setattr(face_training, "compute_device", lambda: torch.device("meta"))
    assert FitSettings(FACE).device == "meta"
    assert np.isfinite(linear_baseline(frames, FACE, split).force_error_n)


def test_dead_channels_are_left_out(model):
    assert len(model.channels) == 8
    assert (4, 1, 2) not in model.channels
    sigma = model.network.members[0].sigma_counts
    assert_allclose(sigma, [22, 20, 11, 22, 20, 22, 20, 11])


def test_the_seed_alone_tells_the_weights_and_the_caller_s_state_comes_back(frames, split):
    """One thread trains; threads and random numbers of the caller are as before."""
    signal, before, seen, found = frames.select(np.arange(50)), torch.get_num_threads(), [], []
    for callers, seed in ((11, 1), (12, 1), (11, 2)):
        torch.manual_seed(callers)
        expected = torch.rand(3)
        torch.manual_seed(callers)
        torch.set_num_threads(2)
        try:
            told = lambda *_: seen.append(torch.get_num_threads())  # noqa: E731
            model = train_face(frames, FACE, SHORT, seed, told, split)
            assert torch.get_num_threads() == 2
        finally:
            torch.set_num_threads(before)
        assert torch.equal(torch.rand(3), expected)
        found.append(predict_heatmaps(model, signal))
    assert set(seen) == {1}
    assert_array_equal(found[1], found[0])
    assert np.any(found[2] != found[0])


def test_test_presses_are_never_used(frames, split):
    """Nonsense in the test part changes nothing; in the validation part it does."""
    probe, found = frames.select(np.arange(50)), {}
    for part in ("none", "test", "validation"):
        signal = frames.signal_counts.copy()
        signal[getattr(split, part, [])] *= -3
        spoilt = replace(frames, signal_counts=signal)
        found[part] = predict_heatmaps(train_face(spoilt, FACE, SHORT, 7, split=split), probe)
    assert_array_equal(found["test"], found["none"])
    assert np.any(found["validation"] != found["none"])


def test_the_network_learns_from_the_training_part(frames, split):
    """Places that only the training part holds are known afterwards."""
    odd = np.unique(frames.press_id[(frames.place_id >= 0) & (frames.place_id % 2 == 1)])
    hidden = np.isin(frames.press_id, odd)
    lean = replace(split, validation=split.validation & ~hidden)
    model = train_face(frames, FACE, QUICK, seed=7, split=lean)
    known = evaluate_face(model, frames.select(split.test & hidden), frames)
    assert known.contact_frames > 100
    assert known.location_error_px < 0.25


def test_early_stopping_and_progress(frames, split):
    calls = []
    spec, told = QUICK.model_copy(update={"epochs": 200}), lambda *call: calls.append(call)
    train_face(frames, FACE, spec, 1, told, split=split, patience_epochs=2)
    epochs, totals, scores = zip(*calls, strict=True)
    assert epochs == tuple(range(1, len(calls) + 1))
    assert set(totals) == {200}
    assert len(calls) < 200
    assert len(calls) - 1 - int(np.argmin(scores)) == 2


def test_save_and_load(model, frames, tmp_path):
    save_model(model, tmp_path / "m" / "face4.safetensors")
    loaded = load_model(tmp_path / "m" / "face4.safetensors")
    signal = frames.select(np.arange(80))
    assert_array_equal(predict_heatmaps(loaded, signal), predict_heatmaps(model, signal))
    assert loaded.channels == model.channels
    assert (loaded.face, loaded.architecture.hidden_units) == (FACE, (96, 96))


def test_a_changed_byte_anywhere_in_a_model_is_one_error(model, tmp_path):
    path = tmp_path / "m.safetensors"
    save_model(model, path)
    whole = path.read_bytes()
    for at in np.random.default_rng(5).integers(len(whole), size=60).tolist():
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1 :])
        with pytest.raises(StoreError, match=r"m\.safetensors"):
            load_model(path)


@pytest.mark.parametrize("damage", ["foreign", "cut", "no description", "format", "weights"])
def test_bad_model_files(model, tmp_path, damage):
    path = tmp_path / "m.safetensors"
    save_model(model, path)
    weights = load_file(path)
    if damage == "foreign":
        path.write_text("hello")
    elif damage == "cut":
        path.write_bytes(path.read_bytes()[:-100])
    elif damage == "no description":
        save_file(weights, path)
    elif damage == "format":
        save_tensors(weights, {"format": 9}, path)
    else:
        description = {"format": MODEL_FORMAT, "face": 4, "channels": [[4, 0, 0]], "grid_x_mm": [0]}
        save_tensors(weights, description, path)
    with pytest.raises(StoreError, match=r"m\.safetensors"):
        load_model(path)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        (None, [1, 2]),
        (None, "text"),
        ("history_frames", 10**30),
        ("history_frames", float("inf")),
        ("channels", [[4, 0, float("inf")]]),
        ("architecture", []),
        ("hidden_units", []),
        ("members", 10**12),
    ],
)
def test_a_description_of_other_types_or_sizes_is_one_error(model, tmp_path, key, value):
    path = tmp_path / "m.safetensors"
    save_model(model, path)
    described = description(model)
    if key is None:
        described = value
    elif key in described:
        described[key] = value
    else:
        described["architecture"][key] = value
    save_tensors(load_file(path), described, path)
    with pytest.raises(StoreError, match=r"m\.safetensors.*(Give a trained|Train the) model"):
        load_model(path)


def test_a_model_that_is_saved_again_is_the_same_byte_by_byte(model, tmp_path):
    contents = set()
    for number in range(8):  # the library takes any of two orders
        save_model(model, tmp_path / f"{number}.safetensors")
        contents.add((tmp_path / f"{number}.safetensors").read_bytes())
    assert len(contents) == 1


def test_a_model_may_look_back_a_hundred_frames(model, tmp_path):
    path = tmp_path / "m.safetensors"
    save_model(model, path)
    for frames, sound in ((100, True), (101, False), (-1, False)):
        save_tensors(load_file(path), description(model) | {"history_frames": frames}, path)
        if sound:
            assert load_model(path).history_frames == frames
        else:
            with pytest.raises(StoreError, match="frames of history"):
                load_model(path)


def test_missing_model(tmp_path):
    with pytest.raises(InputError, match="no model at"):
        load_model(tmp_path / "none")


def test_prediction_refuses_missing_readings(model, frames):
    few = frames.select(np.arange(5))
    few.signal_counts[2, 3, 0, 1] = np.nan
    with pytest.raises(InputError, match="channels F4-Y1"):
        predict_heatmaps(model, few)
    with pytest.raises(InputError, match="needs sensor 3 of faces"):
        predict_heatmaps(model, replace(few, signal_counts=few.signal_counts[:, :, :2]))


def test_prediction_shape_and_units(model, frames):
    heatmaps = predict_heatmaps(model, frames.select(np.arange(7)))
    assert heatmaps.shape == (7, 4, 5)
    assert heatmaps.min() >= 0
    assert predict_heatmaps(model, frames.select(np.arange(0))).shape == (0, 4, 5)


def test_scaling_by_hand():
    """The first layer sees arcsinh(ΔS / 3σ), arcsinh(1) = ln(1 + √2), and ΔS / 30σ."""
    network = HeadsNetwork(np.array([22.0, 11.0, 5.0]), np.zeros(1), np.zeros(1), (3,), 1.0)
    seen = []
    network.trunk.register_forward_pre_hook(lambda _, given: seen.append(given[0]))
    network.heads_of(torch.tensor([[66.0, -33.0, 0.0]]))
    assert_allclose(
        seen[0], [[np.log(1 + 2**0.5), -np.log(1 + 2**0.5), 0, 0.1, -0.1, 0]], rtol=1e-6
    )


def test_errors_of_the_user(frames, split, model):
    with pytest.raises(InputError, match="face 9 is not in the data set"):
        train_face(frames, 9, QUICK, 0)
    with pytest.raises(InputError, match="no contact in the training part"):
        train_face(frames, 1, QUICK, 0, split=split)
    with pytest.raises(InputError, match="no valid frame"):
        face_data(replace(frames, valid=np.zeros(len(frames), dtype=bool)), FACE)
    with pytest.raises(InputError, match="grid_x_mm"):
        evaluate_face(replace(model, grid_x_mm=model.grid_x_mm + 1), frames)
    silent = frames.select(np.arange(2))
    silent.signal_counts[:] = np.nan
    with pytest.raises(InputError, match="every channel of face"):
        live_channels(FaceData(FACE, silent, np.ones((2, 3, 4, 5)), np.zeros(2) > 0))


def test_a_network_that_knows_nuisances_reads_turned_frames_nearly_as_those_at_rest(frames, split):
    """Two nuisances of 80 counts in all channels; one that does not know them errs far more."""
    columns = np.random.default_rng(3).normal(0, 80, (*frames.signal_counts.shape[1:], 2))
    training = QUICK.changed(model="whole-object")
    still = face_data(frames.select(split.test), FACE)
    turned = replace(still, frames=with_nuisances(still.frames, columns, 5))

    def error_n(model, data):
        pressed = data.contact
        force_n = data.heatmap_n.sum(axis=(1, 2))
        return np.sqrt(np.mean((predict(model, data.frames).force_n - force_n)[pressed] ** 2))

    taught = train_face(frames, FACE, training, 7, split=split, nuisances=columns)
    ignorant = train_face(frames, FACE, training, 7, split=split)
    assert error_n(taught, turned) < 1.2 * error_n(taught, still)
    assert error_n(taught, turned) < 0.8 * error_n(ignorant, turned)
