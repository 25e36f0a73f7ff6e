"""Verdicts on grasps whose truth is known: good, not good, or not to be said."""

from dataclasses import replace

import numpy as np

from estimator.grasps.damage import DamageLimit
from estimator.grasps.measures import measured_grasps
from estimator.grasps.verdict import force_half_width, median_of, verdict_of
from tests.estimator.grasps.grasps_by_hand import CONDITIONS, joined, squeeze

PLUM = DamageLimit("plum", "force_n", 9.0, 0.1, "made up")
WITH_PLUM = replace(CONDITIONS, limits=(PLUM,))


def judged(conditions=WITH_PLUM, **how):
    grasps = measured_grasps(joined(*[squeeze(**how)] * 3), conditions)
    return verdict_of(grasps, conditions), grasps


def test_a_light_steady_squeeze_is_good():
    verdict, _ = judged(peak_n=5.0)
    assert verdict.answer == "good"
    assert verdict.balanced
    assert not verdict.named(good=False)
    assert not verdict.named(good=None)


def test_a_squeeze_that_breaks_plums_is_not_and_says_so():
    verdict, _ = judged(peak_n=12.0)
    assert verdict.answer == "not good"
    assert [one.name for one in verdict.named(good=False)] == ["damage_plum"]


def test_a_contact_that_slides_is_no_good_hold():
    verdict, _ = judged(peak_n=5.0, slide_mm=4.0)
    assert "slip_mm" in [one.name for one in verdict.named(good=False)]
    assert verdict.answer == "not good"


def test_too_little_friction_is_not_good():
    """Jaws on neighbouring faces close no grasp with the friction assumed."""
    slippery = replace(CONDITIONS, friction=0.1)
    verdict, _ = judged(slippery, peak_n=5.0, faces=(3, 1), sigma_n=3.0)
    assert "friction_needed" in [one.name for one in verdict.named(good=False)]


def test_contacts_out_of_balance_say_nothing():
    verdict, _ = judged(peak_n=5.0, shares=(1.0, 0.6))
    assert not verdict.balanced
    assert verdict.answer == "cannot be said"


def test_a_force_that_is_hardly_known_leaves_damage_open():
    verdict, grasps = judged(peak_n=8.0, sigma_n=2.5)
    assert verdict.answer == "cannot be said"
    assert [one.name for one in verdict.named(good=None)] == ["damage_plum"]
    # two contacts of 2.5 N each, 90 %: 1.645 · √2 · 2.5 N of 16 N
    assert abs(force_half_width(grasps) - 1.645 * np.sqrt(2) * 2.5 / 16) < 0.02


def test_the_interval_covers_what_grasps_and_estimator_leave_open():
    _, grasps = judged(peak_n=5.0, sigma_n=0.5)
    peak = median_of(grasps, "peak_n")
    own = grasps[0].readings["peak_n"]
    assert peak.low <= own.low < peak.value < own.high <= peak.high
