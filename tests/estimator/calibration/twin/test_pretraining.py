"""Pre-training on twins and fine-tuning on few presses of an object that no twin is."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from design.spec.object import TrainingSpec
from estimator.calibration.twin.pretraining import split_twins, twin_frames, with_presses_of_twin
from estimator.evaluation.evaluation import evaluate_face
from estimator.frames.press_protocol import simulate_presses
from estimator.networks.training.face import FitSettings, fit_estimator
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    seed=5,
    contact_grid={"count": (3, 3), "pitch_mm": 6.0},
    protocol={
        "presses_per_place": 3,
        "frames_per_press": (3, 10),
        "peak_force_n": (6.0, 9.0),
    },
)
TRAINING = TrainingSpec(hidden_units=(64, 64), epochs=12)
FACE = 3


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def twins(presses):
    return twin_frames(SPEC, *presses, 5)


def test_twins_differ_and_are_never_divided(twins):
    assert len(np.unique(twins.session_id)) == 5
    split = split_twins(twins)
    assert not split.test.any()
    assert np.unique(twins.session_id[split.validation]).tolist() == [4]
    assert not set(twins.press_id[split.train]) & set(twins.press_id[split.validation])
    touched = twins.contact_face[:, 0] == FACE
    means = [
        np.abs(twins.signal_counts[touched & (twins.session_id == k), 2]).mean() for k in range(5)
    ]
    assert np.std(means) > 0.01 * np.mean(means)


def test_twins_are_reproducible(presses, twins):
    again = twin_frames(SPEC, *presses, 2)
    first = twins.session_id < 2
    np.testing.assert_array_equal(again.signal_counts, twins.signal_counts[first])


def test_few_presses_go_further_from_pretrained(presses, twins):
    """One object with errors of its own, one press per place: with pre-training and without."""
    split = split_twins(twins)
    parts = twins.select(split.train), twins.select(split.validation)
    pretrained = fit_estimator(*parts, FitSettings(FACE, TRAINING, 1))
    hidden = twin_signals(SPEC, drawn_assembly(SPEC, 777), *presses)
    real = simulate_presses(SPEC, hidden, "hidden")
    few, check, test = (real.select(real.session_id == k) for k in range(3))
    settings = FitSettings(FACE, TRAINING, 1)
    tuned = fit_estimator(few, check, settings, start=pretrained)
    anew = fit_estimator(few, check, settings)
    errors = [evaluate_face(one, test, real).force_error_percent for one in (tuned, anew)]
    assert errors[0] < 0.7 * errors[1]
    untuned = evaluate_face(pretrained, test, real).force_error_percent
    assert errors[0] < untuned


def test_presses_of_a_calibrated_twin_are_numbered_behind_those_of_both_parts(twins):
    """The training part alone goes with them; the part that stops training stays as it was."""
    rows = [np.flatnonzero(twins.press_id == press)[:3] for press in (0, 1, 2)]
    few = twins.select(np.concatenate(rows[:2]))
    stopping = replace(few, press_id=few.press_id + 7)
    for parts in ((few, stopping), (stopping, few)):
        found = with_presses_of_twin(parts, few)
        begin, added = np.split(found.press_id, [len(few)])
        assert_array_equal(begin, parts[0].press_id)
        assert_array_equal(added - added[0], few.press_id)
        assert added[0] > max(part.press_id.max() for part in parts)
        assert_array_equal(found.signal_counts[: len(few)], parts[0].signal_counts)
