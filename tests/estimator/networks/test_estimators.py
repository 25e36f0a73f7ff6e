"""Estimators by name, their outputs, intervals, history and resumption, on synthetic frames."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError, StoreError
from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import evaluate_face, evaluate_intervals
from estimator.frames.face_data import face_data, with_history
from estimator.frames.splits import split_places, split_presses
from estimator.networks.face_model import predict
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4
QUICK = TrainingSpec(hidden_units=(64, 64), epochs=25)


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(presses=6)


def fitted(frames, training, seed=3, split=None, progress=None, **more):
    split = split or split_presses(frames, seed)
    settings = FitSettings(FACE, training, seed, **more)
    parts = frames.select(split.train), frames.select(split.validation)
    model = fit_estimator(*parts, settings, progress)
    return model, frames.select(split.test)


@pytest.fixture(scope="module")
def compact(frames):
    return fitted(frames, QUICK)


def test_members_are_calibrated_on_folds_and_cover(frames):
    model, test = fitted(frames, QUICK.model_copy(update={"ensemble": 3, "epochs": 12}))
    report = evaluate_intervals(model, test)
    assert 0.8 < report.force_cover < 0.99
    assert 0.8 < report.position_cover < 0.99
    assert report.calibration_presses == 100
    assert model.architecture.members == 3


def test_one_network_covers_too_and_its_intervals_tell_sure_from_unsure(compact):
    model, test = compact
    report = evaluate_intervals(model, test)
    assert 0.8 < report.force_cover < 0.99
    data = face_data(test, FACE)
    found = predict(model, data.frames)
    force = data.heatmap_n.sum(axis=(1, 2))
    faint, firm = (
        found.position_radius_mm[part] for part in ((force > 0) & (force < 2), force > 8)
    )
    assert np.median(faint) > 1.5 * np.median(firm)


def test_position_output_reaches_places_never_trained_on(frames):
    split = split_places(frames, 1)
    heatmap, test = fitted(frames, QUICK, split=split)
    position, _ = fitted(frames, QUICK, split=split, continuous=True)
    seen = [evaluate_face(model, test, frames).location_error_px for model in (position, heatmap)]
    assert seen[0] < seen[1]
    data = face_data(test, FACE)
    contact = data.select(data.contact)
    away = predict(position, contact.frames).xy_mm - contact.centre_mm
    assert np.median(np.hypot(*away.T)) < 3.0


def test_centre_is_in_mm_on_the_face(compact):
    model, test = compact
    data = face_data(test, FACE)
    contact = data.select(data.contact & (data.heatmap_n.max(axis=(1, 2)) > 5))
    away = predict(model, contact.frames).xy_mm - contact.centre_mm
    assert np.abs(away).mean(axis=0).max() < 0.6


@pytest.mark.slow
def test_whole_object_reads_every_face_and_copes_with_other_faces():
    """Presses of two faces at once, which neither model saw: their signals add up."""
    frames = synthetic_frames(presses=5, loaded=12, cross=0.5)
    wide = QUICK.model_copy(update={"hidden_units": (128, 128), "epochs": 40})
    model, test = fitted(frames, wide.model_copy(update={"model": "whole-object"}))
    own, _ = fitted(frames, wide)
    assert len(model.channels) == 45
    mine = test.select(test.contact_face[:, 0] == FACE)
    theirs = test.select(test.contact_face[:, 0] == 2)
    row = np.arange(len(mine)) % len(theirs)
    both = replace(mine, signal_counts=mine.signal_counts + theirs.signal_counts[row])
    errors = [evaluate_face(one, both, frames).force_error_percent for one in (model, own)]
    assert errors[0] < 0.6 * errors[1]


def test_three_axes(frames):
    tangential = 0.3 * frames.force_n[..., 2]
    force = frames.force_n.copy()
    sway = np.sin(frames.press_id * 1.7)[:, None]
    force[..., 0] = tangential * sway
    signal = frames.signal_counts.copy()
    signal[:, :, 0, 1] += 200 * np.nan_to_num(force[:, :1, 0])
    sheared = replace(frames, force_n=force, signal_counts=signal)
    model, test = fitted(sheared, QUICK, axes=3)
    data = face_data(test, FACE)
    contact = data.select(data.contact)
    found = predict(model, contact.frames).heatmap_n
    assert found.shape[1:] == (3, 4, 5)
    true_x, found_x = (maps.sum(axis=(2, 3))[:, 0] for maps in (contact.force_maps_n, found))
    assert np.corrcoef(true_x, found_x)[0, 1] > 0.95
    assert np.abs(found[:, 1]).max() < 1.5


def test_history_is_the_change_within_the_press(frames):
    few = frames.select(np.arange(60))
    wide = with_history(few, 3)
    change = few.signal_counts[10] - few.signal_counts[7]
    assert_allclose(wide.signal_counts[10, 5:], change)
    start = int(np.flatnonzero(np.diff(few.press_id))[0]) + 1
    assert_allclose(wide.signal_counts[start, 5:], 0.0, atol=1e-12)
    step = few.signal_counts[start + 2] - few.signal_counts[start]
    assert_allclose(wide.signal_counts[start + 2, 5:], step)
    assert wide.faces.tolist() == [1, 2, 3, 4, 5, 101, 102, 103, 104, 105]


def test_a_lost_reading_costs_frames_not_the_change_of_its_channel(frames):
    few = frames.select(np.arange(60))
    few.signal_counts[10, 2, 0, 1] = np.nan
    wide = with_history(few, 3)
    assert np.flatnonzero(few.valid & ~wide.valid).tolist() == [13]
    few.signal_counts[:, 2, 0, 1] = np.nan
    assert (with_history(few, 3).valid == few.valid).all()


def test_history_takes_off_hysteresis(frames):
    """Signals that lag: the same force shows otherwise while loading and unloading."""
    force = np.nan_to_num(frames.force_n[:, 0, 2])
    rise = np.gradient(force) * (frames.contact_face[:, 0] > 0)
    lagging = frames.signal_counts * (1 - 0.25 * np.tanh(rise))[:, None, None, None]
    moved = replace(frames, signal_counts=lagging)
    plain, test = fitted(moved, QUICK)
    history, _ = fitted(moved, QUICK.model_copy(update={"history_frames": 2}))
    errors = [evaluate_face(model, test, moved).force_error_percent for model in (history, plain)]
    assert errors[0] < 0.8 * errors[1]


class _Interruption(Exception):
    pass


def test_an_interrupted_training_ends_as_if_it_had_not_been(frames, tmp_path, monkeypatch):
    monkeypatch.setattr("estimator.networks.training.fitting.SAVE_EVERY_S", 0.0)
    training = QUICK.model_copy(update={"epochs": 6, "ensemble": 2})
    whole, test = fitted(frames, training)
    calls = []

    def interrupt(epoch, epochs, loss):
        calls.append((epoch, epochs))
        if len(calls) == 9:
            raise _Interruption

    with pytest.raises(_Interruption):
        fitted(frames, training, progress=interrupt, checkpoint=tmp_path)
    assert calls == [(epoch, 12) for epoch in range(1, 10)], "of both members"
    resumed = []
    model, _ = fitted(
        frames, training, progress=lambda *call: resumed.append(call[0]), checkpoint=tmp_path
    )
    assert resumed == [9, 10, 11, 12]
    assert_array_equal(predict(model, test).heatmap_n, predict(whole, test).heatmap_n)
    with pytest.raises(InputError, match="other data or settings"):
        fitted(frames, training.model_copy(update={"epochs": 7}), checkpoint=tmp_path)
    (tmp_path / "member_0.safetensors").write_text("spoilt")
    with pytest.raises(StoreError, match="Delete it"):
        fitted(frames, training, checkpoint=tmp_path)
