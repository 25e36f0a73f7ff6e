"""Splits of a data set: no press in two parts, and what is refused."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from design.errors import InputError
from estimator.frames import splits
from estimator.frames.splits import (
    split_paper_random_frames,
    split_places,
    split_presses,
)
from tests.support.recordings.synthetic_frames import synthetic_frames

SPLITS = [split_presses, split_places]


def shared_presses(frames, split):
    """Presses with frames in more than one part."""
    parts = [np.unique(frames.press_id[part]) for part in vars(split).values()]
    presses, counts = np.unique(np.concatenate(parts), return_counts=True)
    return presses[counts > 1]


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
    assert not len(shared_presses(frames, split))


def test_the_paper_random_split_leaks_and_is_caught(frames):
    """The leak test above fails on the protocol that it guards against."""
    split = split_paper_random_frames(frames, 3)
    sizes = [part.sum() / len(frames) for part in (split.train, split.validation, split.test)]
    np.testing.assert_allclose(sizes, [0.6, 0.2, 0.2], atol=2 / len(frames))
    assert np.all(split.train.astype(int) + split.validation + split.test == 1)
    assert len(shared_presses(frames, split)) > 0.9 * len(np.unique(frames.press_id))


def remembered_error_n(frames, split):
    """Force error (N) of the nearest training frame's label: pure memory of the signals."""
    counts = frames.signal_counts.reshape(len(frames), -1)
    force = np.nan_to_num(frames.force_n[:, 0, 2])
    pressed = frames.place_id >= 0
    train, test = split.train & pressed, split.test & pressed
    square = np.sum(counts[train] ** 2, axis=1)
    nearest = np.argmin(square - 2 * counts[test] @ counts[train].T, axis=1)
    return float(np.abs(force[train][nearest] - force[test]).mean())


def test_shuffled_labels_destroy_the_score_of_held_out_presses():
    """Force labels exchanged among presses: nothing can be learned but which press a frame is of.

    Whole presses held out, memory falls to chance; with the paper's split it still looks good.
    """
    honest = synthetic_frames(presses=5, rest=2, loaded=12, seed=3, zero_error=150.0)
    rng = np.random.default_rng(5)
    scale = rng.permutation(np.geomspace(0.2, 3.0, len(np.unique(honest.press_id))))
    shuffled = replace(honest, force_n=honest.force_n * scale[honest.press_id][:, None, None])
    force = np.nan_to_num(shuffled.force_n[:, 0, 2])[shuffled.place_id >= 0]
    chance_n = float(np.abs(force - np.median(force)).mean())
    held_out = remembered_error_n(shuffled, split_presses(shuffled, 1))
    leaked = remembered_error_n(shuffled, split_paper_random_frames(shuffled, 1))
    assert held_out > 0.9 * chance_n
    assert leaked < 0.5 * chance_n
    assert remembered_error_n(honest, split_presses(honest, 1)) < 0.5 * held_out


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


@pytest.mark.parametrize("splitter", SPLITS)
def test_seed_decides(frames, splitter):
    first, again = splitter(frames, 5), splitter(frames, 5)
    assert np.array_equal(first.test, again.test)
    assert any(not np.array_equal(first.test, splitter(frames, seed).test) for seed in range(6, 12))


@pytest.mark.parametrize("seed", range(6))
def test_every_place_pressed_twice_is_trained_on(seed):
    """Of two presses one trains; the others are shared between validation and test."""
    frames = synthetic_frames(presses=2, faces=(2, 4), rest=1, loaded=3)
    split = split_presses(frames, seed)
    places = set(frames.place_id[frames.place_id >= 0])
    assert set(frames.place_id[split.train]) - {-1} == places
    held_out = [set(frames.place_id[part]) - {-1} for part in (split.validation, split.test)]
    assert held_out[0] | held_out[1] == places
    assert not held_out[0] & held_out[1]
    assert abs(len(held_out[0]) - len(held_out[1])) <= 1


def test_a_place_pressed_twice_is_trained_on_beside_one_pressed_once():
    frames = synthetic_frames(presses=2, places=[0, 1], faces=(2,), rest=1, loaded=3)
    few = frames.select(frames.press_id != 3)
    for seed in range(6):
        split = split_presses(few, seed)
        assert 2000 in few.place_id[split.train]
        assert all(part.any() for part in vars(split).values())


def test_places_with_few_presses_are_pooled():
    split = split_presses(synthetic_frames(presses=1, faces=(2,), rest=1, loaded=3), 0)
    assert split.train.any()
    assert split.validation.any()
    assert split.test.any()


def test_too_little_is_refused(frames):
    few = frames.select(frames.press_id < 2)
    for splitter, what in zip(SPLITS, ("presses", "contact cases"), strict=True):
        with pytest.raises(InputError, match=f"at least 3 {what}"):
            splitter(few, 0)


def test_of_two_presses_the_spare_ones_go_to_validation_and_test_alike():
    frames = synthetic_frames(presses=2, faces=(2, 4), rest=1, loaded=3)
    split = split_presses(frames, 3)
    counts = [len(np.unique(frames.press_id[part])) for part in (split.validation, split.test)]
    assert counts == [20, 20]


@pytest.mark.parametrize(
    ("count", "sizes"),
    [
        (10, [6, 2, 2]),
        (7, [4, 2, 1]),  # 4.2, 1.4, 1.4: the first of the equal remainders
        (3, [1, 1, 1]),
        (2, [1, 1, 0]),  # 1.2, 0.4, 0.4
        (1, [1, 0, 0]),
        (0, [0, 0, 0]),
    ],
)
def test_members_are_shared_out_by_the_largest_remainder(count, sizes):
    parts = splits.split_parts(count)
    assert np.bincount(parts, minlength=3).tolist() == sizes
    assert (np.diff(parts) >= 0).all()


def test_a_press_shows_the_case_of_most_of_its_frames():
    given = SimpleNamespace(
        press_id=np.array([7, 7, 7, 7, 2, 2, 2, 9, 9]),
        place_id=np.array([-1, 4, 5, 5, 4, 5, -1, -1, -1]),
    )
    presses, places = splits.press_places.__wrapped__(given)
    assert (presses.tolist(), places.tolist()) == ([2, 7, 9], [4, 5, -1])
    given.place_id[:] = -1
    assert splits.press_places.__wrapped__(given)[1].tolist() == [-1, -1, -1]


def test_an_empty_part_gets_a_lone_press_of_the_most_crowded_one():
    part = np.array([0, 0, 0, 1, 1])
    single = np.array([False, True, False, True, False])
    assert splits.fill_empty(part, single).tolist() == [0, 2, 0, 1, 1]
    assert splits.fill_empty(part, 0 * single > 0).tolist() == [0, 0, 2, 1, 1]
    assert splits.fill_empty(np.zeros(3, int), np.zeros(3, bool)).tolist() == [0, 2, 1]
    assert splits.fill_empty(np.array([2, 2, 1, 0]), np.ones(4, bool)).tolist() == [2, 2, 1, 0]


def test_every_contact_case_is_held_out_by_some_seed(frames):
    """The first case's number is 0, as in recordings."""
    first = frames.place_id[frames.place_id >= 0].min()
    place = np.where(frames.place_id >= 0, frames.place_id - first, -1)
    counted = replace(frames, place_id=place)
    tested = [set(place[split_places(counted, seed).test].tolist()) for seed in range(40)]
    assert set.union(*tested) - {-1} == set(place.tolist()) - {-1}
