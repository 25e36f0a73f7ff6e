"""How many contacts can be told apart: rank, condition and bounds against first principles."""

import csv

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from estimator.information.contact_sets import contact_sets, spread_places
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.identifiability import (
    comparable_sensor_counts,
    identifiability,
    save_identifiability,
    set_information,
    whitened_jacobians,
)
from estimator.information.scores import score_places
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    contact_grid={"count": (5, 4), "pitch_mm": 6.0},
    score={"force_n": 6.0, "channels": "own"},
    limits={"use": "bench"},
    indenter={"radius_mm": 4.5},
)


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def rows(presses):
    return identifiability(SPEC, *presses, sensor_counts=(2, 3), contact_counts=(1, 2, 3))


def pick(rows, contacts, sensors, channels):
    return next(
        row
        for row in rows
        if (row.contacts, row.sensors, row.channels) == (contacts, sensors, channels)
    )


def test_one_contact_with_the_specified_sensors_has_the_bounds_of_the_scores(presses, rows):
    scores = score_places(SPEC, press_signals(SPEC, *presses))
    places = spread_places(SPEC)
    bound = np.sort(scores.position_bound_mm[:, places].ravel())
    row = pick(rows, 1, 3, "own")
    assert row.sets == bound.size
    assert_allclose(row.bound_median_mm, np.quantile(bound, 0.5, method="inverted_cdf"))
    assert_allclose(row.bound_90_mm, np.quantile(bound, 0.9, method="inverted_cdf"))
    assert_allclose(row.bound_share_within_limit, np.mean(bound <= SPEC.limits.position_bound_mm))


def test_two_sensors_cannot_tell_three_contacts_and_three_sensors_have_full_rank(rows):
    short = pick(rows, 3, 2, "own")
    assert (short.unknowns, short.signals, short.rank_least) == (9, 6, 6)
    assert short.condition_median == short.bound_median_mm == np.inf
    assert short.bound_share_within_limit == 0
    enough = pick(rows, 3, 3, "own")
    assert (enough.signals, enough.rank_least) == (9, 9)
    assert pick(rows, 3, 2, "all").rank_least == 9


def test_more_sensors_and_channels_help_and_more_contacts_hurt(rows):
    for k in (1, 2, 3):
        for sensors in (2, 3):
            own, every = pick(rows, k, sensors, "own"), pick(rows, k, sensors, "all")
            assert every.bound_median_mm < own.bound_median_mm
            assert every.bound_share_within_limit >= own.bound_share_within_limit
        assert pick(rows, k, 3, "own").told_median >= pick(rows, k, 2, "own").told_median
    medians = [pick(rows, k, 3, "own").bound_median_mm for k in (1, 2, 3)]
    assert medians == sorted(medians)


def test_information_of_a_set_is_that_of_its_inverse():
    jacobian = np.random.default_rng(4).normal(size=(6, 9, 6)) * [30, 20, 9, 25, 15, 8]
    info = set_information(jacobian)
    covariance = np.linalg.inv(jacobian.swapaxes(1, 2) @ jacobian)
    variance = np.diagonal(covariance, axis1=1, axis2=2).reshape(6, 2, 3)
    assert_allclose(info.position_bound_mm, np.sqrt(variance[:, :, :2].sum(axis=2)), rtol=1e-8)
    assert_allclose(info.force_bound_n, np.sqrt(variance[:, :, 2]), rtol=1e-8)
    assert_allclose(info.condition, np.linalg.cond(jacobian), rtol=1e-8)
    least = np.linalg.norm(np.einsum("scp,sp->sc", jacobian, info.blindest.reshape(6, -1)), axis=1)
    assert_allclose(least, np.linalg.svd(jacobian, compute_uv=False)[:, -1], rtol=1e-8)
    single = set_information(jacobian[:, :, :3])
    bounds = cramer_rao_bounds(jacobian[:, :, :3], np.ones(9))
    assert_allclose(single.position_bound_mm[:, 0], bounds.position_mm, rtol=1e-9)


def test_two_contacts_at_one_place_are_blind_to_what_they_exchange():
    one = np.random.default_rng(5).normal(size=(1, 9, 3))
    info = set_information(np.concatenate([one, one], axis=2))
    assert info.rank[0] == 3
    assert np.isinf(info.condition[0])
    assert_allclose(info.blindest[0, 0], -info.blindest[0, 1], atol=1e-9)


def test_whitening_uses_the_fresh_zero_and_every_face(presses):
    jacobians = whitened_jacobians(SPEC, *presses, spread_places(SPEC), 3)
    assert [face.face for face in jacobians] == [1, 2, 3, 4, 5]
    assert_allclose(jacobians[3].face_channels, jacobians[3].whitened[:, 27:36])
    sigma = disturbance_counts(SPEC.sensors, "fresh", 45)
    noisier = SPEC.model_copy(
        update={"sensors": SPEC.sensors.model_copy(update={"zeroing_counts": 100.0})}
    )
    other = whitened_jacobians(noisier, *presses, spread_places(SPEC), 3)
    loss = disturbance_counts(noisier.sensors, "fresh", 45) / sigma
    assert_allclose(jacobians[1].whitened, other[1].whitened * loss[:, None], rtol=1e-9)


def _distances(xy):
    return np.linalg.norm(xy[:, None] - xy, axis=2)[np.triu_indices(len(xy), 1)]


def test_tips_of_a_set_do_not_touch():
    places = spread_places(SPEC)
    xy = contact_grid(SPEC).xy_mm[places]
    wide = SPEC.model_copy(update={"indenter": SPEC.indenter.model_copy(update={"radius_mm": 5.0})})
    pairs = contact_sets(wide, places, 2)
    apart = np.linalg.norm(xy[pairs[:, 0]] - xy[pairs[:, 1]], axis=1)
    assert apart.min() >= 10.0
    assert len(pairs) == 20 * 19 // 2 - np.sum(_distances(xy) < 10)
    assert len(pairs) < 20 * 19 // 2
    huge = SPEC.model_copy(
        update={"indenter": SPEC.indenter.model_copy(update={"radius_mm": 12.0})}
    )
    with pytest.raises(InputError, match=r"3 tips of radius 12 mm do not fit"):
        contact_sets(huge, places, 3)


def test_the_worst_set_is_named(rows):
    worst = pick(rows, 2, 3, "own").worst
    assert worst.xy_mm.shape == (2, 2)
    assert_allclose(np.linalg.norm(worst.direction), 1)
    assert worst.condition > pick(rows, 2, 3, "own").condition_median


def test_other_numbers_of_sensors_are_compared_where_mechanics_allows():
    assert comparable_sensor_counts(SPEC) == (1, 2, 3, 4, 5)
    shell = SPEC.model_copy(update={"arrangement": "sensors-in-shell"})
    assert comparable_sensor_counts(shell) == (3,)


def test_the_table_holds_every_row_without_its_worst_set(rows, tmp_path):
    save_identifiability(rows, tmp_path / "identifiability.csv")
    with (tmp_path / "identifiability.csv").open(newline="") as file:
        back = list(csv.DictReader(file))
    assert len(back) == len(rows) == 12
    for read, row in zip(back, rows, strict=True):
        assert (int(read["contacts"]), int(read["sensors"])) == (row.contacts, row.sensors)
        assert float(read["bound_median_mm"]) == row.bound_median_mm
    assert "worst" not in back[0]
