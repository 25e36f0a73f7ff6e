"""Radii and half-widths that hold nine tenths of normal errors, by drawing them."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.inversion.explained import UNEXPLAINED
from estimator.inversion.readings import COVERAGE, ContactSets


def sets(covariance, face=(3, 0)):
    face = np.array([face])
    xy, force = np.zeros((1, 2, 2)), np.full((1, 2), 4.0)
    one = np.ones(1)
    both = np.stack([covariance, np.full((3, 3), np.nan)])[None]
    return ContactSets(
        face,
        xy,
        force,
        both,
        xy,
        xy,
        one,
        one,
        np.full(len(one), -1),
        *[np.zeros((len(one), 0))] * 2,
        np.full_like(xy, np.nan),
        np.full((*xy.shape, 2), np.nan),
    )


@pytest.mark.parametrize(
    "sizes", [(1.0, 0.0, 0.5), (2.0, 2.0, 1.0), (0.5, 1.5, 2.0), (0.2, 3.0, 0.1)]
)
def test_nine_tenths_of_normal_errors_lie_within(sizes):
    turn = np.linalg.qr(np.random.default_rng(2).normal(size=(2, 2)))[0]
    covariance = np.zeros((3, 3))
    covariance[:2, :2] = turn @ np.diag(np.square(sizes[:2])) @ turn.T
    covariance[2, 2] = sizes[2] ** 2
    found = sets(covariance)
    assert COVERAGE == 0.9
    x, y, force = np.random.default_rng(1).standard_normal((3, 200_000)) * np.array(sizes)[:, None]
    within = np.hypot(x, y) <= found.position_radius_mm[0, 0]
    assert_allclose(within.mean(), 0.9, atol=0.012)
    assert_allclose((abs(force) <= found.force_halfwidth_n[0, 0]).mean(), 0.9, atol=0.003)
    assert np.isnan(found.position_radius_mm[0, 1])


def test_an_error_common_to_all_forces_widens_them_alone():
    found = sets(np.diag([1.0, 2.0, 0.09])).with_force_error(0.1)
    assert_allclose(found.covariance[0, 0], np.diag([1.0, 2.0, 0.09 + 0.16]))


def test_frames_are_counted_and_explained_down_to_a_thousandth():
    found = sets(np.eye(3))
    assert_array_equal(found.number, [1])
    assert_array_equal(sets(np.eye(3), face=(3, 5)).number, [2])
    assert found.explained.all()
    assert UNEXPLAINED == 1e-3
    assert replace(found, p_value=np.array([1e-3])).explained.all()
    assert not replace(found, p_value=np.array([0.99e-3])).explained.any()
