"""Frames that a network is trained on: which are kept, joined, disturbed and left out, by hand."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from estimator.frames.face_data import face_data, live_channels
from estimator.networks.training import data as module
from estimator.networks.training.data import (
    Augmentation,
    Disturbances,
    batch_of,
    disturbed,
    elsewhere_counts,
    joined,
    press_folds,
    thinned,
    with_contacts,
)
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4


@pytest.fixture(scope="module")
def data():
    """40 presses of face 4 and 40 of face 2, 4 frames at rest and 6 loaded each."""
    return face_data(synthetic_frames(presses=2, loaded=6), FACE)


def test_signals_from_elsewhere_are_those_of_frames_with_other_faces_pressed_alone(data):
    found = elsewhere_counts(data, live_channels(data))
    others = np.any(data.frames.contact_face == 2, axis=1)
    assert others.sum() == 240
    wanted = data.frames.signal_counts[others][:, 3].reshape(240, 9)
    assert_allclose(found, wanted, rtol=1e-6)


def test_rest_and_other_presses_are_thinned_to_three_for_ten_contacts(data, monkeypatch):
    kept = thinned(data, 3)
    pressed = np.any(kept.frames.contact_face == 2, axis=1)
    assert (kept.contact.sum(), kept.rest.sum(), pressed.sum()) == (240, 72, 72)
    assert (np.diff(kept.frames.time_s) > 0).all()
    monkeypatch.setattr(module, "NEGATIVES_PER_CONTACT", 0.3001)
    assert thinned(data, 3).rest.sum() == 73
    monkeypatch.setattr(module, "NEGATIVES_PER_CONTACT", 9.0)
    assert len(thinned(data, 3)) == len(data)


def test_joined_frames_are_those_of_both_in_order(data):
    one, other = data.select(np.arange(5)), data.select(np.arange(100, 103))
    both = joined(one, other)
    assert_array_equal(both.frames.time_s, data.frames.time_s[[0, 1, 2, 3, 4, 100, 101, 102]])
    assert_array_equal(both.rest, np.concatenate([one.rest, other.rest]))
    assert_array_equal(both.heatmap_n[5:], other.heatmap_n)
    assert both.face == FACE


def test_folds_hold_whole_presses_and_those_of_each_case_are_spread(data):
    fold = press_folds(data, 2, 5)
    assert set(fold) == {0, 1}
    for press in np.unique(data.frames.press_id):
        assert len(set(fold[data.frames.press_id == press])) == 1
    for place in np.unique(data.frames.place_id[data.contact]):
        assert set(fold[(data.frames.place_id == place) & data.contact]) == {0, 1}
    with pytest.raises(InputError, match="41 needs as many presses on face 4; got 40"):
        press_folds(data, 41, 5)
    assert len(set(press_folds(data, 40, 5))) == 40


def test_data_without_a_contact_are_refused(data):
    assert with_contacts(data, "training") is data
    with pytest.raises(InputError, match="face 4 has no contact in the validation part"):
        with_contacts(data.select(~data.contact), "validation")


def test_targets_are_shares_forces_over_the_scale_and_centres(data):
    channels = live_channels(data)
    batch = batch_of(data, channels, 2.0, 1)
    touched = torch.as_tensor(data.contact)
    normal = data.heatmap_n.sum(axis=(1, 2))
    pressed = torch.as_tensor(normal[data.contact][:, None])
    assert_allclose(batch.share.sum(dim=1), data.contact, atol=1e-6)
    assert_allclose(batch.share[touched] * pressed / 2, batch.maps[touched], rtol=1e-5)
    assert_allclose(batch.force[:, 0], normal / 2, rtol=1e-5)
    assert_array_equal(batch.contact, data.contact)
    assert_allclose(batch.centre_mm[touched], data.centre_mm[data.contact], rtol=1e-5)
    assert_array_equal(batch.centre_mm[~touched], 0)
    assert len(batch) == len(data)
    assert batch_of(data, channels, 2.0, 3).force.shape == (len(data), 3)


def test_disturbances_have_the_sizes_that_they_are_given():
    counts = torch.zeros(20_000, 2)
    sources = Disturbances(
        torch.tensor([1.0, 3.0]), torch.tensor([1.0, 0.0]), torch.full((1, 2), 100.0)
    )

    def found(**sizes):
        augmentation = Augmentation(**({"offset_counts": 0.0, "noise_sigmas": 0.0} | sizes))
        return disturbed(counts, sources, augmentation, torch.Generator().manual_seed(1)).numpy()

    assert_array_equal(found(), 0)
    assert_allclose(found(noise_sigmas=2.0).std(axis=0), [2, 6], rtol=0.03)
    assert_allclose(found(offset_counts=5.0).std(axis=0), [5, 0], rtol=0.03)
    assert_allclose(found(noise_sigmas=2.0, offset_counts=5.0).std(axis=0)[0], 29**0.5, rtol=0.03)
    added = found(other_faces=0.25)
    assert set(np.unique(added)) == {0.0, 100.0}
    assert_allclose(added.mean(axis=0), 25, rtol=0.05)
    warm = replace(sources, nuisances=torch.tensor([[30.0, -40.0]]))
    changed = disturbed(
        counts, warm, Augmentation(0.0, 0.0), torch.Generator().manual_seed(2)
    ).numpy()
    assert_allclose(changed.std(axis=0), [30, 40], rtol=0.03)
    assert_allclose(changed[:, 1], -4 / 3 * changed[:, 0], rtol=1e-5)
    none = replace(sources, elsewhere=torch.zeros(0, 2))
    augmentation = Augmentation(0.0, 0.0, 0.5)
    assert_array_equal(disturbed(counts, none, augmentation, torch.Generator()), 0)
