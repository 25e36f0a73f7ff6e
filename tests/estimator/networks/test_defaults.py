"""Settings that a specification leaves out follow from the number of recorded presses."""

from dataclasses import replace

import pytest

from design.spec.object import TrainingSpec
from estimator.frames.splits import split_presses
from estimator.networks.defaults import PLAIN, SMALL, filled_for
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4


def choice(training, presses, source="recorded", places=range(0, 20, 4)):
    frames = replace(
        synthetic_frames(faces=(FACE,), presses=presses, loaded=6, places=places), source=source
    )
    split = split_presses(frames, 1)
    found = filled_for(
        training, (frames.select(split.train), frames.select(split.validation)), FACE
    )
    return found.history_frames, found.ensemble, found.trees, found.process


def test_few_recorded_presses_get_history_an_ensemble_trees_and_a_process():
    assert SMALL == (9, 4, 50, True)
    assert choice(TrainingSpec(), 5) == SMALL
    assert choice(TrainingSpec(model="whole-object"), 5) == SMALL


@pytest.mark.parametrize(
    ("training", "presses", "source"),
    [
        (TrainingSpec(), 16, "recorded"),
        (TrainingSpec(), 5, "simulated"),
    ],
)
def test_everything_else_gets_one_network_of_single_frames(training, presses, source):
    assert choice(training, presses, source) == PLAIN


def test_what_is_given_stays():
    assert PLAIN == (0, 1, 0, False)
    assert choice(TrainingSpec(history_frames=3), 5) == SMALL._replace(history_frames=3)
    assert choice(TrainingSpec(ensemble=1, trees=0, process=False), 5) == (
        SMALL.history_frames,
        1,
        0,
        False,
    )


def test_an_ensemble_is_no_larger_than_its_presses():
    assert choice(TrainingSpec(), 3, places=range(1)) == SMALL._replace(ensemble=2)
