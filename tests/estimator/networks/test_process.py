"""A Gaussian process as tensors against scikit-learn's own, and beside networks where frames are novel."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose, assert_array_equal

from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import evaluate_intervals, interval_errors
from estimator.frames.face_data import channel_counts, face_data, live_channels
from estimator.frames.splits import split_presses
from estimator.networks import process as module
from estimator.networks.face_model import load_model, predict, save_model
from estimator.networks.process import fit_process
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4
CHECKERBOARD = (0, 2, 4, 6, 8, 10, 12, 14, 16, 18)
INSIDE = (7, 11, 13)
"""Places of the grid of 4 × 5 between those of the checkerboard, 3 mm from each."""
QUIET = {"faces": (FACE,), "loaded": 14, "noise": 0.1, "zero_error": 1.0}
TRAINING = TrainingSpec(hidden_units=(48,), epochs=15, ensemble=2, trees=10, process=True)


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(presses=4, places=CHECKERBOARD, **QUIET)


@pytest.fixture(scope="module")
def between():
    """Presses of places between those of `frames`."""
    return synthetic_frames(presses=2, places=INSIDE, seed=4, **QUIET)


def fitted(frames, training):
    split = split_presses(frames, 1)
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(FACE, training, 1))


@pytest.fixture(scope="module")
def model(frames):
    return fitted(frames, TRAINING)


@pytest.fixture(scope="module")
def plain(frames):
    """The same without a process."""
    return fitted(frames, TRAINING.model_copy(update={"process": False}))


def errors(model, frames):
    """Mean errors of force (N) and place (mm) in frames pressed firmly."""
    data = face_data(frames, FACE)
    data = data.select(data.heatmap_n.sum(axis=(1, 2)) > 4)
    found, missed_n, away_mm = interval_errors(model, data)
    return np.array([missed_n.mean(), away_mm.mean()]), found


def test_the_tensors_answer_as_scikit_learn(frames, monkeypatch):
    """The same kernel, the same frames: mean of its exact process, place within the grid."""
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
    from sklearn.preprocessing import StandardScaler

    data = face_data(frames, FACE)
    channels = live_channels(data)
    kernels = iter([(2.0, 3.0, 0.01), (1.5, 2.5, 0.02)])
    monkeypatch.setattr(module, "chosen_kernel", lambda *_: next(kernels))
    touched, total = data.contact, data.heatmap_n.sum(axis=(1, 2))
    counts = channel_counts(data.frames, channels)
    seen = counts + np.random.default_rng(0).normal(0, 60, counts.shape)
    with torch.inference_mode():
        force_n, xy_mm = fit_process(data, channels, 0)(torch.as_tensor(seen.astype(np.float32)))
    for said, kernel, rows, target in (
        (force_n[:, None], (2.0, 3.0, 0.01), touched | ~touched, total[:, None]),
        (xy_mm, (1.5, 2.5, 0.02), touched, data.centre_mm),
    ):
        variance, length, noise = kernel
        scaler = StandardScaler().fit(counts[rows])
        spread = np.sqrt(target[rows].var(axis=0).mean())
        middle = target[rows].mean(axis=0)
        oracle = GaussianProcessRegressor(
            ConstantKernel(variance) * RBF(length) + WhiteKernel(noise), optimizer=None
        ).fit(scaler.transform(counts[rows]), (target[rows] - middle) / spread)
        expected = oracle.predict(scaler.transform(seen)).reshape(len(seen), -1) * spread + middle
        if target.shape[1] == 1:
            expected = np.maximum(expected, 0)
        else:
            outside = (np.abs(expected) > [4.5, 6.0]).any(axis=1).mean()
            assert outside > 0.1
            expected = np.clip(expected, [-4.5, -6.0], [4.5, 6.0])
        assert_allclose(said.numpy(), expected, atol=2e-4)
        assert np.ptp(said.numpy(), axis=0).min() > 3.0


def test_the_kernel_is_that_of_greatest_likelihood():
    """Drawn from a known process: its length and noise are found."""
    from sklearn.gaussian_process.kernels import RBF

    rng = np.random.default_rng(3)
    seen = rng.uniform(-3, 3, (module.FRAMES_OF_KERNEL, 2))
    lower = np.linalg.cholesky(RBF(1.5)(seen) + 1e-8 * np.eye(len(seen)))
    aim = lower @ rng.normal(size=(len(seen), 2)) + 0.1 * rng.normal(size=(len(seen), 2))
    _, length, noise = module.chosen_kernel(seen, aim)
    assert length == pytest.approx(1.5, rel=0.15)
    assert noise == pytest.approx(0.01, rel=0.2)


def test_new_places_between_known_ones_are_read_by_the_process(model, plain, between):
    """There it errs least, and the model's answer goes over to it."""
    mine, found = errors(model, between)
    assert found.novel.mean() > 0.9
    without, _ = errors(plain, between)
    assert mine[0] < 0.75 * without[0]
    assert mine[1] < 0.9 * without[1]


def test_known_places_are_read_as_without_the_process(model, plain, frames):
    test = frames.select(split_presses(frames, 1).test)
    (mine, found), (without, _) = errors(model, test), errors(plain, test)
    assert found.novel.mean() < 0.15
    assert_allclose(mine, without, rtol=0.1)


def test_intervals_hold_at_new_places_because_they_are_wider(model, frames, between):
    report = evaluate_intervals(model, between)
    assert report.force_cover > 0.85
    assert report.position_cover > 0.85
    known = evaluate_intervals(model, frames.select(split_presses(frames, 1).test))
    assert known.force_cover > 0.8
    assert report.median_position_radius_mm > 2 * known.median_position_radius_mm
    slope = model.network.coverage.place_slope_mm
    kept = slope.clone()
    slope.fill_(0.0)
    without = evaluate_intervals(model, between)
    slope.copy_(kept)
    assert without.position_cover < 0.6, "planted fault: radii that do not grow"


def test_a_process_and_trees_survive_the_file(model, between, tmp_path):
    save_model(model, tmp_path / "face.safetensors")
    loaded = load_model(tmp_path / "face.safetensors")
    for part in ("process", "forest"):
        kept = getattr(loaded.architecture, part)
        assert kept == getattr(model.architecture, part) is not None
    found, again = (predict(one, between) for one in (model, loaded))
    for name in ("force_n", "xy_mm", "force_halfwidth_n", "position_radius_mm", "novelty"):
        assert_array_equal(getattr(again, name), getattr(found, name))
