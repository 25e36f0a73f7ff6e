from dataclasses import replace

import numpy as np
import pytest
from synthetic_frames import synthetic_frames

from design.errors import InputError
from estimator.splits import split_places, split_presses, split_sessions

SPLITS = [split_presses, split_places, split_sessions]


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(presses=5, rest=2, loaded=5)


@pytest.mark.parametrize("splitter", SPLITS)
def test_parts_cover_everything_once(frames, splitter):
    split = splitter(frames, 3)
    assert np.all(split.train.astype(int) + split.validation + split.test == 1)
    assert split.train.sum() > split.test.sum() > 0
    assert split.validation.sum() > 0


@pytest.mark.parametrize("splitter", SPLITS)
def test_no_press_leaks(frames, splitter):
    split = splitter(frames, 3)
    parts = [set(frames.press_id[part]) for part in (split.train, split.validation, split.test)]
    assert not parts[0] & parts[1]
    assert not parts[0] & parts[2]
    assert not parts[1] & parts[2]


def test_a_random_split_of_frames_would_be_caught(frames):
    """The leak test above fails on the protocol that it guards against."""
    train = np.random.default_rng(0).random(len(frames)) < 0.6
    assert set(frames.press_id[train]) & set(frames.press_id[~train])


def test_presses_are_stratified_by_place(frames):
    split = split_presses(frames, 8)
    for place in np.unique(frames.place_id[frames.place_id >= 0]):
        here = frames.place_id == place
        counts = [len(set(frames.press_id[here & part])) for part in vars(split).values()]
        assert counts == [3, 1, 1]


def test_rest_travels_with_its_press(frames):
    split = split_presses(frames, 8)
    for press in np.unique(frames.press_id):
        assert len(set(split.test[frames.press_id == press])) == 1


def test_unseen_places_are_unseen(frames):
    split = split_places(frames, 1)
    seen = set(frames.place_id[split.train]) - {-1}
    assert seen
    assert not seen & set(frames.place_id[split.test])


def test_sessions_stay_whole(frames):
    split = split_sessions(frames, 1)
    assert not set(frames.session_id[split.train]) & set(frames.session_id[split.test])


@pytest.mark.parametrize("splitter", SPLITS)
def test_seed_decides(frames, splitter):
    first, again = splitter(frames, 5), splitter(frames, 5)
    assert np.array_equal(first.test, again.test)
    assert any(not np.array_equal(first.test, splitter(frames, seed).test) for seed in range(6, 12))


def test_places_with_few_presses_are_pooled():
    split = split_presses(synthetic_frames(presses=1, faces=(2,), rest=1, loaded=3), 0)
    assert split.train.any()
    assert split.validation.any()
    assert split.test.any()


def test_too_little_is_refused(frames):
    few = frames.select(frames.press_id < 2)
    for splitter, what in zip(SPLITS, ("presses", "contact cases", "sessions"), strict=True):
        with pytest.raises(InputError, match=f"at least 3 {what}"):
            splitter(few, 0)


@pytest.mark.parametrize("shares", [(0.5, 0.2, 0.2), (1.2, -0.1, -0.1), (1.0, 0.0, 0.0)])
def test_shares_must_add_up(frames, shares):
    with pytest.raises(InputError, match="add up to 1"):
        split_presses(frames, 0, shares)


def test_a_press_across_sessions_is_refused(frames):
    torn = replace(frames, session_id=np.arange(len(frames)) // 6)
    with pytest.raises(InputError, match="one session"):
        split_sessions(torn, 0)
