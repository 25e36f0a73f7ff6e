"""Rows of a table of contacts, and figures of agreement, every entry by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.distance import cosine
from scipy.special import ndtri

from estimator.calibration.known_travel import agreement
from estimator.metrics.contacts import MatchedContacts, contact_rows
from estimator.metrics.cross_correlation import align
from studies.paper import narrowest_intervals

NAN = np.nan
MATCHED = MatchedContacts(
    true_number=np.array([1, 1, 2, 0, 1]),
    found_number=np.array([1, 2, 2, 1, 0]),
    right=np.array([True, False, True, False, False]),
    face_force_n=np.array([0.99, 1.0, 4.0, 0.0, 3.99]),
    total_error_n=np.array([0.5, -1.0, 2.0, 0.25, -3.99]),
    tips=np.array([1, 1, 2, 0, 1]),
    explained=np.array([True, True, False, True, False]),
    frame=np.array([0, 1, 2, 2]),
    distance_mm=np.array([1.0, 5.5, 2.0, 5.0]),
    force_error_n=np.array([0.5, -0.5, 1.0, -2.0]),
    pull_error_n=np.array([0.1, NAN, 0.2, 0.4]),
    pull_n=np.array([1.0, NAN, 2.0, 3.0]),
    place_covered=np.array([True, False, True, False]),
    force_covered=np.array([True, True, True, False]),
)


def test_every_entry_of_every_row():
    rows = contact_rows(MATCHED, np.array([0.5, 0.6, 0.7, NAN, 0.8]))
    names = ("tips a face", "force", "frames", "number right %", "missed a frame", "ghosts a frame")
    assert [tuple(row[name] for name in names) for row in rows] == [
        (1, "0 to 1 N", 1, 100.0, 0.0, 0.0),
        (1, "1 to 4 N", 2, 0.0, 1.0, 1.0),
        (2, "from 4 N", 1, 100.0, 0.0, 0.0),
        (0, "rest", 1, 0.0, 0.0, 1.0),
    ]
    distances = ("distance mm", "95th percentile mm", "bound mm")
    assert [tuple(row[name] for name in distances) for row in rows] == [
        (1.0, 1.0, 0.5),
        (5.5, 5.5, 0.7),
        (3.5, 4.85, 0.7),
        (None, None, None),
    ]
    forces = ("total force N", "each force N", "tangential error N", "tangential force N")
    assert [tuple(row[name] for name in forces) for row in rows] == [
        (0.5, 0.5, 0.1, 1.0),
        (2.495, 0.5, None, None),
        (2.0, 1.5, 0.3, 2.5),
        (0.25, None, None, None),
    ]
    shares = ("place in 90 % region %", "force in 90 % interval %", "not explained %")
    assert [tuple(row[name] for name in shares) for row in rows] == [
        (100.0, 100.0, 0.0),
        (0.0, 100.0, 50.0),
        (50.0, 50.0, 100.0),
        (None, None, 0.0),
    ]
    assert contact_rows(MATCHED)[0]["bound mm"] is None


def test_agreement_counts_cosines_shares_signs_and_size():
    predicted = np.array([[[1.0, 0.0, 0.0]], [[0.0, 2.0, 0.0]], [[0.0, 0.0, 0.0]]])
    recorded = np.array([[[2.0, 0.03, 0.0]], [[0.0, 2.0, -0.04]], [[0.04, 0.0, 0.0]]])
    found = agreement.figures(predicted, recorded)
    left = 1 + 0.03**2 + 0.04**2 + 0.04**2
    whole = 4 + 0.03**2 + 4 + 0.04**2 + 0.04**2
    mean = recorded.mean(axis=0)
    cosines = [2 / np.hypot(2, 0.03), 2 / np.hypot(2, 0.04), 0.0]
    assert (found.presses, found.cosine) == (3, pytest.approx(np.median(cosines)))
    assert found.explained == pytest.approx(1 - left / whole)
    assert found.between == pytest.approx(1 - left / np.sum((recorded - mean) ** 2))
    assert found.signs == 0.5  # of 2.0, 2.0, −0.04 and 0.04
    assert found.size == pytest.approx((2 + 4) / (1 + 4))


def test_orders_of_chips_are_all_but_the_true_one():
    orders = agreement.chip_orders(3)
    assert len(orders) == len(set(orders)) == 5
    assert (0, 1, 2) not in orders
    assert len(agreement.chip_orders(6)) == 120


def test_the_radius_holds_the_wanted_share_about_the_better_centre():
    centre = np.array([[0.0, 0.0], [3.0, 0.0], [0.0, 4.0], [9.0, 0.0]])
    share = np.array([[0.6, 0.2, 0.15, 0.05], [0.95, 0.05, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0]])
    found = narrowest_intervals.covering_radii(centre, share, 0.9)
    # first: about the likeliest 4.0, about the mean (1.05, 0.6) its third nearest
    mean = share[0] @ centre
    about_mean = np.sort(np.linalg.norm(centre - mean, axis=1))[2]
    assert_allclose(found, [min(4.0, about_mean), 0.0, 1.5])


def test_the_halfwidth_holds_the_wanted_share_of_force_and_noise():
    force = np.array([1.0, 2.0, 3.0, 4.0, 5.0])
    share = np.array([[0.1, 0.2, 0.4, 0.2, 0.1]])
    width = lambda cover, noise: narrowest_intervals.covering_halfwidths(  # noqa: E731
        force, share.cumsum(axis=1), np.array([3.0]), cover, noise
    )[0]
    assert width(0.39, 0.0) == pytest.approx(0.0, abs=1e-6)
    assert width(0.41, 0.0) == pytest.approx(1.0, abs=1e-6)
    assert width(0.79, 0.0) == pytest.approx(1.0, abs=1e-6)
    assert width(0.81, 0.0) == pytest.approx(2.0, abs=1e-6)
    alone = narrowest_intervals.covering_halfwidths(
        force[2:3], np.ones((1, 1)), np.array([3.0]), 0.9, 0.5
    )[0]
    assert alone == pytest.approx(0.5 * ndtri(38.5 / 41), abs=1e-6)  # 37 of 41 nodes are 90 %


def test_maps_are_aligned_by_their_shortest_best_displacement():
    true = np.zeros((3, 4, 5))
    true[:, 1, 1], true[:, 2, 1] = 2.0, 1.0
    predicted = np.roll(true, (1, 2), axis=(1, 2))
    predicted[1] = 3.0
    predicted[2] = -true[2]
    found = align(predicted, true)
    assert_allclose(found.displacement_px[0], [1.0, 2.0])
    assert np.isnan(found.displacement_px[1]).all()
    assert found.similarity[1] == 0.0
    centred = true[0] - true[0].mean()
    shifted = np.zeros_like(centred)
    shifted[1:, 2:] = centred[:-1, :-2]
    own = predicted[0] - predicted[0].mean()
    assert found.similarity[0] == pytest.approx((own * shifted).sum() / (centred**2).sum())


def test_a_tie_holds_the_wanted_share():
    """A quarter, a half and a quarter are exact: the middle one alone holds a half."""
    force, share = np.array([1.0, 2.0, 4.5]), np.array([[0.25, 0.5, 0.25]])
    found = narrowest_intervals.covering_halfwidths(
        force, share.cumsum(axis=1), np.array([2.0]), 0.5, 0.0
    )
    assert_allclose(found, 0, atol=1e-6)


def test_figures_of_rows_are_rounded_to_a_micrometre_a_millinewton_and_a_tenth_of_a_percent():
    """Thirds and sevenths: three frames of one tip each, of which the first is right."""
    third, first = np.full(3, 1 / 3), np.array([True, False, False])
    thirds = MatchedContacts(
        np.ones(3, int), np.array([2, 2, 1]), first, np.full(3, 2.0), np.array([1, 1, 0]) / 7,
        np.ones(3, int), first, np.arange(3), third, np.array([1, -1, 0]) / 7, third, third / 2,
        first, ~first,
    )  # fmt: skip
    (row,) = contact_rows(thirds, np.full(3, 2 / 3))
    assert row == {
        "tips a face": 1,
        "force": "1 to 4 N",
        "frames": 3,
        "number right %": 33.3,
        "missed a frame": 0.0,
        "ghosts a frame": 0.667,
        "distance mm": 0.333,
        "95th percentile mm": 0.333,
        "bound mm": 0.667,
        "total force N": 0.095,
        "each force N": 0.095,
        "place in 90 % region %": 33.3,
        "force in 90 % interval %": 66.7,
        "not explained %": 66.7,
        "tangential error N": 0.333,
        "tangential force N": 0.167,
    }


def test_cosines_of_changes_of_hundredths_of_a_millitesla_are_those_of_large_ones():
    """Lengths below 1 mT², above no sign: only signs know a size."""
    rng = np.random.default_rng(8)
    predicted, recorded = rng.normal(0, 3, (2, 5, 2, 3))
    small, large = (agreement.figures(s * predicted, s * recorded) for s in (0.01, 1.0))
    wanted = [1 - cosine(p.ravel(), m.ravel()) for p, m in zip(predicted, recorded, strict=True)]
    assert large.cosine == pytest.approx(np.median(wanted))
    for name in ("cosine", "explained", "between", "size"):
        assert getattr(small, name) == pytest.approx(getattr(large, name)), name
