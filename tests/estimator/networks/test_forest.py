"""Trees as tensors against scikit-learn's own, and beside networks in an estimator."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import evaluate_face
from estimator.frames.face_data import channel_counts, face_data, live_channels
from estimator.frames.splits import split_presses
from estimator.networks.face_model import predict
from estimator.networks.forest import LEAST_FRAMES_OF_LEAF, MOST_LEVELS, fit_forest
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4
WITH_TREES = TrainingSpec(hidden_units=(32,), epochs=4, ensemble=2, trees=10)


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(faces=(FACE,), presses=4, loaded=12, places=range(0, 20, 4))


def fitted(frames, training):
    split = split_presses(frames, 1)
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(FACE, training, 1)), frames.select(split.test)


def test_the_tensors_answer_as_scikit_learn(frames):
    from sklearn.ensemble import ExtraTreesRegressor

    data = face_data(frames, FACE)
    channels = live_channels(data)
    counts = channel_counts(data.frames, channels).astype(np.float32)
    seen = counts + np.random.default_rng(0).normal(0, 60, counts.shape).astype(np.float32)
    force_n, xy_mm = fit_forest(data, channels, 7, seed=3)(torch.as_tensor(seen))
    oracle = ExtraTreesRegressor(
        7, min_samples_leaf=LEAST_FRAMES_OF_LEAF, max_depth=MOST_LEVELS, random_state=3
    )
    touched = data.contact
    total = data.heatmap_n.sum(axis=(1, 2))
    assert_allclose(force_n.numpy(), oracle.fit(counts, total).predict(seen), atol=1e-4)
    expected = oracle.fit(counts[touched], data.centre_mm[touched]).predict(seen)
    assert_allclose(xy_mm.numpy(), expected, atol=1e-4)
    assert np.ptp(xy_mm.numpy(), axis=0).min() > 3.0


def test_trees_beside_networks_help_and_heatmaps_add_up_to_the_force(frames):
    plain, test = fitted(frames, WITH_TREES.model_copy(update={"trees": 0}))
    model, _ = fitted(frames, WITH_TREES)
    errors = [evaluate_face(one, test, frames).total_force_error_n for one in (model, plain)]
    assert errors[0] < 0.9 * errors[1]
    found = predict(model, face_data(test, FACE).frames)
    assert_allclose(found.heatmap_n.sum(axis=(1, 2, 3)), found.force_n, atol=1e-4)
    assert float(model.network.force_share) > 0
    assert_allclose(float(model.network.place_shares.sum()), 1.0)
