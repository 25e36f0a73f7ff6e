"""Rankings: medians and intervals, tests, grasps needed; exchanged labels rank nothing."""

import numpy as np
import pytest

from estimator.grasps.ranking import (
    LEVEL,
    compare,
    exchanged_share,
    grasps_needed,
    median_interval,
    share_larger,
)


def drawn(seed, sizes=(10, 10), shift=0.0):
    rng = np.random.default_rng(seed)
    return {
        name: rng.gamma(9.0, 1.0, size) + shift * row
        for row, (name, size) in enumerate(zip("abcd", sizes, strict=False))
    }


def test_a_large_difference_is_sure_and_a_null_one_rarely():
    surely = [compare(drawn(seed, shift=8.0))[0].sure for seed in range(60)]
    falsely = [compare(drawn(seed))[0].sure for seed in range(600)]
    assert np.mean(surely) >= 0.95
    assert np.mean(falsely) <= LEVEL + 0.02  # 2 standard errors of 600 draws


def test_four_grippers_alike_are_rarely_ranked_at_all():
    falsely = [any(d.sure for d in compare(drawn(s, (8, 8, 8, 8)))) for s in range(200)]
    assert np.mean(falsely) <= LEVEL + 0.03


def test_pairs_that_differ_little_beside_their_sequence_are_ranked_by_pairs_alone():
    rng = np.random.default_rng(1)
    sequence = rng.uniform(2, 20, 15)
    groups = {"a": sequence, "b": sequence + 0.5 + 0.2 * rng.standard_normal(15)}
    assert compare(groups, paired=True)[0].sure
    assert not compare(groups)[0].sure
    assert compare(groups, paired=True)[0].shift == pytest.approx(0.5, abs=0.15)


def test_paired_null_is_rarely_ranked():
    falsely = []
    for seed in range(400):
        rng = np.random.default_rng(seed)
        sequence = rng.uniform(2, 20, 10)
        groups = {name: sequence + rng.standard_normal(10) for name in "ab"}
        falsely.append(compare(groups, paired=True)[0].sure)
    assert np.mean(falsely) <= LEVEL + 0.025


def test_exchanged_labels_rank_nothing_even_of_grippers_that_differ():
    assert exchanged_share(drawn(3, shift=8.0), draws=300) <= 0.08
    paired = drawn(4, shift=8.0)
    assert exchanged_share(paired, paired=True, draws=300) <= 0.08


def test_the_interval_of_the_median_covers_it():
    true = np.median(np.random.default_rng(0).gamma(9.0, 1.0, 400_000))
    ends = [median_interval(drawn(seed, (20,))["a"]) for seed in range(300)]
    covered = np.mean([low <= true <= high for _, low, high in ends])
    assert 0.90 <= covered <= 0.99


def test_the_grasps_said_to_be_needed_make_the_ranking_sure():
    rng = np.random.default_rng(2)
    many = [rng.normal(shift, 1, 4000) for shift in (0.0, 1.0)]
    needed = grasps_needed(share_larger(*many, paired=False), paired=False)
    sure = [
        compare({"a": rng.normal(0, 1, needed), "b": rng.normal(1, 1, needed)})[0].sure
        for _ in range(300)
    ]
    assert np.mean(sure) == pytest.approx(0.8, abs=0.08)


def test_few_grasps_ask_for_more_and_none_are_no_ranking():
    (few,) = compare({"a": np.array([1.0, 2.0]), "b": np.array([3.0, 4.0])})
    assert not few.sure
    assert few.more_grasps >= 1
    (alike,) = compare({"a": np.ones(5), "b": np.ones(5)})
    assert not alike.sure
    assert alike.more_grasps is None
    (empty,) = compare({"a": np.zeros(0), "b": np.ones(5)})
    assert not empty.sure
    assert empty.more_grasps is None
    assert np.isnan(median_interval(np.array([np.nan]))[0])
