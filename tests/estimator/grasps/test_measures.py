"""Measures of whole grasps on a track whose truth is known."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.grasps.damage import DamageLimit
from estimator.grasps.measures import measured_grasps
from estimator.grasps.protocols import MEASURES, PROTOCOLS
from estimator.recordings.attitude import GRAVITY_M_S2, recorded_motion
from tests.estimator.grasps.grasps_by_hand import CONDITIONS, joined, squeeze


def test_a_squeeze_in_figures():
    (grasp,) = measured_grasps(squeeze(10.0), CONDITIONS)
    value = {name: reading.value for name, reading in grasp.readings.items()}
    assert value["peak_n"] == pytest.approx(20.0)
    assert value["mean_n"] == pytest.approx(20.0, rel=0.02)
    assert value["finger_n"] == pytest.approx(10.0)
    assert value["grasp_n"] == pytest.approx(10.0, abs=0.05)  # a median of draws of 0.1 N
    assert value["loading_n_per_s"] == pytest.approx(20.0)
    assert value["asymmetry"] == pytest.approx(0.0, abs=0.005)
    assert value["equilibrium_p"] > 0.9
    assert value["closed"] == 1.0
    assert value["friction_needed"] < 0.01
    assert value["slip_mm"] == pytest.approx(0.0, abs=1e-9)
    assert np.isnan(value["slip_onset_s"])
    assert np.isnan(value["friction_used"])
    assert grasp.opposed
    assert set(grasp.faces) == {3, 5}


def test_every_measure_is_defined_and_every_protocol_uses_measures():
    (grasp,) = measured_grasps(squeeze(), CONDITIONS)
    assert set(grasp.readings) == set(MEASURES)
    assert all(one.definition and one.source for one in MEASURES.values())
    for protocol in PROTOCOLS.values():
        assert protocol.headline in protocol.measures
        assert MEASURES[protocol.headline].better
        assert set(protocol.measures) <= set(MEASURES)


def test_unequal_jaws_are_asymmetric_and_out_of_equilibrium():
    (grasp,) = measured_grasps(squeeze(10.0, shares=(1.0, 0.8)), CONDITIONS)
    assert grasp.readings["asymmetry"].value == pytest.approx(
        -1 / 9, abs=0.005
    )  # face 3 pushes along −x
    assert grasp.readings["equilibrium_p"].value < 1e-3
    assert grasp.readings["net_force_n"].value == pytest.approx(2.0, abs=0.1)


def test_the_weight_explains_the_difference_of_jaws():
    heavy = replace(CONDITIONS, weight_n=2.0)
    (grasp,) = measured_grasps(squeeze(10.0, shares=(1.0, 0.8)), heavy)
    assert grasp.readings["equilibrium_p"].value > 0.05


def test_depth_pressure_and_energy_under_flat_jaws_are_not_known():
    """They are those of round tips; forces, balance and slip are of either."""
    track = squeeze(10.0)
    (tips,) = measured_grasps(track, CONDITIONS)
    (closing,) = measured_grasps(replace(track, jaws=track.time_s < 1.5), CONDITIONS)
    (jaws,) = measured_grasps(replace(track, jaws=track.total_n > 15.0), CONDITIONS)
    for name, reading in tips.readings.items():
        of_tips, of_closing, of_jaws = (
            [*vars(grasp.readings[name]).values()] for grasp in (tips, closing, jaws)
        )
        flat = name in ("depth_mm", "pressure_mpa", "energy_mj")
        assert not flat or reading.value > 0
        np.testing.assert_array_equal(of_closing, of_tips, err_msg=name)
        np.testing.assert_array_equal(of_jaws, [np.nan] * 3 if flat else of_tips, err_msg=name)


def lying(track, down, jolt_m_s2=0.0):
    """Motion of an object whose weight pulls that way; a jolt at 3 s."""
    motion = np.zeros((len(track.time_s), 6))
    motion[:, :3] = -GRAVITY_M_S2 * np.asarray(down)
    motion[30, :3] *= 1 + jolt_m_s2 / GRAVITY_M_S2
    return recorded_motion(track.time_s, motion)


@pytest.mark.parametrize(("down", "balanced"), [((1.0, 0.0, 0.0), True), ((0.0, 0.0, -1.0), False)])
def test_an_imu_says_which_way_the_weight_pulls_and_how_hard_the_object_was_hit(down, balanced):
    """Face 3 pushes along −x with 2 N more than its opposite: a weight along +x alone explains it."""
    track = squeeze(10.0, shares=(1.0, 0.8))
    heavy = replace(CONDITIONS, weight_n=2.0, motion=lying(track, down, 25.0))
    (grasp,) = measured_grasps(track, heavy)
    assert (grasp.readings["equilibrium_p"].value > 0.05) == balanced
    assert grasp.readings["jolt_m_s2"].value == pytest.approx(25.0)


def test_an_accelerated_object_balances_with_the_acceleration_only():
    """The weight pulls along −z, friction bears it. Face 3 pushes by 2 N more, as that takes the object of
    2 N along −x at 1 g: known to an IMU that feels it, out of balance for one that feels rest."""
    track = squeeze(10.0, shares=(1.0, 0.8))
    for along, balanced in (((1.0, 0.0, -1.0), True), ((-1.0, 0.0, -1.0), False)):
        moved = replace(CONDITIONS, weight_n=2.0, motion=lying(track, along))
        (grasp,) = measured_grasps(track, moved)
        assert (grasp.readings["equilibrium_p"].value > 0.05) == balanced


def test_chances_of_damage_count_what_the_object_takes_to_accelerate_at_the_peak():
    """Jaws read as 10 and 8 N: the difference is the object's, or an error of either."""
    track = squeeze(10.0, shares=(1.0, 0.8), sigma_n=0.6)
    limit = DamageLimit("fruit", "force_n", 10.0, 0.02, "made up")
    chances = []
    for along in ((1.0, 0.0, -1.0), (0.0, 0.0, -1.0)):
        moved = replace(CONDITIONS, weight_n=2.0, motion=lying(track, along), limits=(limit,))
        (grasp,) = measured_grasps(track, moved)
        chances.append(grasp.readings["damage_fruit"].value)
    assert chances[0] == pytest.approx(0.5, abs=0.1)
    assert chances[1] < chances[0] - 0.1


def test_without_an_imu_or_while_it_is_silent_no_jolt_is_known():
    track = squeeze(10.0, shares=(1.0, 0.8))
    silent = recorded_motion(track.time_s, np.full((len(track.time_s), 6), np.nan))
    for conditions in (CONDITIONS, replace(CONDITIONS, motion=silent)):
        (grasp,) = measured_grasps(track, replace(conditions, weight_n=2.0))
        assert np.isnan(grasp.readings["jolt_m_s2"].value)
        assert grasp.readings["equilibrium_p"].value > 0.05


def test_a_contact_that_slides_in_the_hold():
    (grasp,) = measured_grasps(squeeze(slide_mm=4.0), CONDITIONS)
    assert grasp.readings["slip_mm"].value == pytest.approx(4.0)
    # the hold begins at 1.9 s, the contact jumps between 2.9 and 3 s
    assert grasp.readings["slip_onset_s"].value == pytest.approx(1.05)
    assert grasp.readings["slip_n"].value == pytest.approx(20.0, rel=0.03)


def test_a_tip_that_is_missed_for_the_rest_of_a_hold_is_no_slip():
    track = squeeze(10.0)
    face, xy, force = (
        np.concatenate([a, a[:, :1]], axis=1) for a in (track.face, track.xy_mm, track.force_n)
    )
    xy[:, 0, 1], force[:, 2] = xy[:, 0, 1] + 20.0, 0.1 * force[:, 2]  # a weak second tip, then lost
    face[34:, 2], xy[34:, 2], force[34:, 2] = 0, np.nan, np.nan
    covariance = np.concatenate([track.covariance, track.covariance[:, :1]], axis=1)
    lost = replace(track, face=face, xy_mm=xy, force_n=force, covariance=covariance)
    (grasp,) = measured_grasps(lost, CONDITIONS)
    assert grasp.readings["slip_mm"].value == 0.0


def test_grasps_of_one_track_are_numbered():
    grasps = measured_grasps(joined(squeeze(4.0), squeeze(9.0), squeeze(6.0)), CONDITIONS)
    assert [grasp.grasp.number for grasp in grasps] == [1, 2, 3]
    assert [round(g.readings["peak_n"].value) for g in grasps] == [8, 18, 12]


def test_intervals_hold_the_truth_as_often_as_they_say():
    rng = np.random.default_rng(6)
    names = {"peak_n": 20.0, "grasp_n": 10.0, "asymmetry": 0.0}
    inside = dict.fromkeys(names, 0)
    for _ in range(40):
        true = squeeze(10.0, sigma_n=0.5)
        error = 0.5 * rng.standard_normal(2)  # one error for the whole grasp
        force = true.force_n.copy()
        force[..., 2] = np.where(true.face > 0, np.maximum(force[..., 2] + error, 0.05), np.nan)
        (grasp,) = measured_grasps(replace(true, force_n=force), CONDITIONS)
        for name, value in names.items():
            inside[name] += grasp.readings[name].low <= value <= grasp.readings[name].high
    for name, count in inside.items():
        assert count / 40 >= 0.78, name  # 90 % within 2.5 standard errors


def test_a_few_frames_that_scatter_much_by_chance_leave_what_lasts_uncertain():
    """The mean of twelve frames, whose errors last by half, errs as far as it says: seldom much farther."""
    rng, misses = np.random.default_rng(9), []
    held = squeeze(10.0, sigma_n=0.5).select(np.arange(20, 32))
    for _ in range(1500):
        force = held.force_n.copy()
        lasting, fresh = rng.standard_normal(2), rng.standard_normal((12, 2))
        force[..., 2] += np.sqrt(0.5) * 0.5 * (lasting + fresh)
        mean = replace(held, force_n=force).averaged(np.arange(12))
        misses.append((mean.normal_n[0] - 10.0) / np.sqrt(mean.covariance[0, :, 4, 4]))
    assert np.mean(np.square(misses)) == pytest.approx(1.0, abs=0.25)
    assert np.mean(np.abs(misses) > 3) < 0.01


def test_every_figure_lies_within_its_own_interval():
    """Drawn grasps with tangential forces: ratios and lengths of noisy vectors are skew."""
    rng = np.random.default_rng(8)
    for _ in range(25):
        true = squeeze(rng.uniform(4, 12), sigma_n=0.8)
        covariance, force = true.covariance.copy(), true.force_n.copy()
        covariance[..., range(4), range(4)] = np.where(true.face > 0, 1.0, 0.0)[..., None]
        force[..., :2] = np.where(true.face[..., None] > 0, rng.normal(0, 0.3, 2), np.nan)
        (grasp,) = measured_grasps(replace(true, force_n=force, covariance=covariance), CONDITIONS)
        for name, reading in grasp.readings.items():
            assert not reading.value < reading.low, name
            assert not reading.value > reading.high, name


def test_places_of_a_peak_that_nothing_explains_are_not_believed():
    track = squeeze(10.0)
    assert measured_grasps(track, CONDITIONS)[0].placed
    lost = replace(track, explained=np.arange(len(track)) % 60 != int(track.total_n.argmax()))
    assert not measured_grasps(lost, CONDITIONS)[0].placed


def test_damage_is_told_for_the_grasp_and_by_place():
    limit = DamageLimit("plum", "force_n", 9.0, 0.1, "made up")
    (grasp,) = measured_grasps(
        squeeze(9.0, shares=(1.0, 0.6)), replace(CONDITIONS, limits=(limit,))
    )
    assert grasp.readings["damage_plum"].value == pytest.approx(0.5, abs=0.1)
    weak, strong = sorted(place["damage_plum"] for place in grasp.places)
    assert strong == pytest.approx(0.5, abs=0.1)
    assert weak < 1e-4
    assert {place["face"] for place in grasp.places} == {3, 5}


def test_contacts_all_round_are_no_pinch():
    (grasp,) = measured_grasps(squeeze(faces=(3, 1)), CONDITIONS)
    assert not grasp.opposed


def test_rest_is_no_grasp():
    rest = squeeze(0.0)
    assert measured_grasps(rest, CONDITIONS) == []
