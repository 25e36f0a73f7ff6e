"""Order, orientation and handedness of chips, against fields by magpylib."""

from dataclasses import replace

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.optimize import brentq

from design.layout.places.positions import sensor_layout
from estimator.field.sources import magnet_source
from instobj.bench.bringup.asking.held_magnet import held_magnet
from instobj.bench.bringup.diagnosis import channels, chip_fit
from instobj.bench.bringup.diagnosis.channels import find_chips, held_readings, signed_permutations
from instobj.bench.bringup.diagnosis.chip_fit import chips_found, orthogonal_part
from tests.support.new_objects import SMALL
from tests.support.physics_pages import assert_page

CHIPS = 10


def test_there_are_24_rotations_and_24_mirrored_permutations():
    every = signed_permutations()
    assert_array_equal(every[0], np.eye(3))
    assert_array_equal(np.einsum("tab,tcb->tac", every, every), np.tile(np.eye(3), (48, 1, 1)))
    assert len({tuple(one.ravel()) for one in every}) == 48
    assert np.sum(np.linalg.det(every) > 0) == 24
    assert np.linalg.det(every[:24]).min() > 0


def by_magpylib(rng, over=()):
    """Field counts (hold, site, axis) of a magnet held roughly over every site; `over` wrongly."""
    held, layout = held_magnet(SMALL, list(range(CHIPS))), sensor_layout(SMALL)
    disk, rows = magnet_source(SMALL.magnets), []
    for hold in range(CHIPS):
        pose = np.zeros((1, 8))
        pose[0, :5] = rng.normal(0, [3, 3, 2, 0.25, 0.25])
        one = held_magnet(SMALL, [hold])
        axis = one.axis(pose)[0] * (-1 if hold in over else 1)
        magnet = magpylib.magnet.Cylinder(
            polarization=(0, 0, disk.polarization_t), dimension=(disk.diameter_mm, disk.height_mm)
        )
        turn = np.cross([0, 0, 1], axis)
        angle = np.arctan2(np.linalg.norm(turn), axis[2])
        if angle > 1e-9:
            magnet.rotate_from_angax(angle, turn, degrees=False)
        magnet.position = one.centre_mm(pose)[0]
        rows.append(magnet.getB(layout.position_mm))
    return 1e3 * held.counts_per_mt * np.einsum("sac,hsc->hsa", layout.axes, np.stack(rows))


@pytest.fixture(scope="module")
def shuffled():
    """All chips exchanged and turned any of 48 ways, one hold the wrong way round, noise."""
    rng = np.random.default_rng(4)
    site, kind = rng.permutation(CHIPS), rng.integers(48, size=CHIPS)
    fields = by_magpylib(rng, over=(3,))[:, site]
    counts = np.einsum("cab,hcb->hca", signed_permutations()[kind], fields)
    counts = counts + 4 * rng.standard_normal(counts.shape)
    readings = held_readings(SMALL, counts, 2 / 42, 3.0)
    found = find_chips(SMALL, readings, range(CHIPS))
    return site, signed_permutations()[kind], readings, found


def test_chips_in_any_order_and_any_way_round_are_found(shuffled):
    site, turn, _, found = shuffled
    assert_array_equal(found.site, site)
    assert_array_equal(found.turn, turn)
    assert_array_equal(np.flatnonzero(found.model.polarity < 0), [3])


def test_turns_by_any_angle_and_gains_are_measured(shuffled):
    site, turn, readings, found = shuffled
    angle = np.deg2rad(120)
    about_z = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    changed = readings.counts.copy()
    changed[:, 6] = changed[:, 6] @ about_z.T
    changed[:, 2, 1] *= 1.2
    chips = chips_found(held_readings(SMALL, changed, 2 / 42, 3.0), found)
    assert_allclose(chips[6].turn, about_z @ turn[6], atol=0.06)
    gains = np.stack([chip.gain for chip in chips])
    assert gains[2, 1] == pytest.approx(1.2, abs=0.05)
    gains[2, 1] = 1.0
    assert_allclose(gains, 1.0, atol=0.05)
    assert [chip.site for chip in chips] == site.tolist()
    assert [chip.mirrored for chip in chips] == (np.linalg.det(turn) < 0).tolist()


def test_an_axis_that_does_not_answer_is_dead_and_the_turn_still_known(shuffled):
    _, turn, readings, found = shuffled
    silent = readings.counts.copy()
    silent[:, 5, 2] = 4 * np.random.default_rng(0).standard_normal(CHIPS)
    chips = chips_found(held_readings(SMALL, silent, 2 / 42, 3.0), found)
    assert chips[5].dead == (False, False, True)
    assert np.isnan(chips[5].gain[2])
    assert_allclose(chips[5].turn, turn[5], atol=0.06)
    assert sum(any(chip.dead) for chip in chips) == 1


def test_a_dead_axis_tells_no_handedness():
    mirrored = np.diag([-1.0, 1.0, 1.0])
    turn = orthogonal_part(np.diag([0.05, 1.0, 0.9]), np.array([True, False, False]), mirrored)
    assert_allclose(turn, np.eye(3), atol=1e-9)


def test_the_errors_of_held_readings_are_those_of_all_tolerances_together():
    spec = SMALL.changed(
        tolerances=SMALL.tolerances.changed(
            sensor_gain_relative=0.03,
            sensor_rotation_deg=2.0,
            remanence_relative=0.04,
            sensor_seat_mm=0.2,
        ),
        sensors=SMALL.sensors.changed(chip_spread=(0.02, 0.015)),
    )
    counts = np.zeros((3, CHIPS, 3))
    found = held_readings(spec, counts, np.array([0.25, 1.0, 0.04]), 6.0)
    squares = 0.03**2 + 0.02**2 + 2 * 0.015**2 + 2 * np.radians(2.0) ** 2 + 0.04**2 + 0.01**2
    assert found.relative == pytest.approx(np.sqrt(squares))
    assert found.seat_mm == 0.2
    noise = np.array(spec.sensors.noise_counts)
    for row, share in enumerate((0.5, 1.0, 0.2)):
        assert_allclose(found.noise_counts[row], np.tile(np.hypot(share * noise, 6.0), (CHIPS, 1)))
    alike = held_readings(spec, counts, 0.25, 6.0)
    assert_allclose(alike.noise_counts, np.tile(found.noise_counts[:1], (3, 1, 1)))


def test_residuals_grow_as_a_logarithm_beyond_four():
    off = np.array([0.0, 1.0, -4.0, 400.0, np.nan])
    half_square = 0.5 * 16 * np.log1p((np.nan_to_num(off) / 4) ** 2)
    assert_allclose(0.5 * channels.capped_misfit(off) ** 2, half_square)
    assert_allclose(np.sign(channels.capped_misfit(off)), [0, 1, -1, 1, 0])


def made_up(holds=(0, 4, 7)):
    """A small problem: readings of three holds with a gap, poses off the stated ones."""
    rng = np.random.default_rng(2)
    model = held_magnet(SMALL, list(holds))
    pose = rng.normal(size=(len(holds), 8)) * [2, 2, 1, 0.1, 0.1, 3, 3, 3]
    counts = model.counts(pose) + rng.normal(0, 20, (len(holds), CHIPS, 3))
    counts[1, 2, 1] = np.nan
    return held_readings(SMALL, counts, 0.1, 3.0), model, pose


def test_what_tolerances_leave_of_a_field_grows_with_the_cube_of_nearness():
    readings, model, pose = made_up()
    size = np.linalg.norm(model.counts(pose), axis=2)
    away = model.distance_mm(pose)
    wanted = size * np.sqrt(readings.relative**2 + (3 * readings.seat_mm / away) ** 2)
    assert_allclose(channels.model_error(readings, model, pose), wanted)


def as_named(model, pose):
    """Every chip at the place that its number names, as designed."""
    turn = np.tile(np.eye(3), (CHIPS, 1, 1))
    return channels.Arrangement(np.arange(CHIPS), turn, model, pose, 0.0)


def test_the_misfit_is_minus_the_logarithm_of_the_likelihood_axis_by_axis():
    readings, model, pose = made_up()
    turns = signed_permutations()[[0, 5, 30]]
    found = channels.misfit_of(readings, model, pose, turns)
    field, error = model.counts(pose), channels.model_error(readings, model, pose)
    for hold, chip, site, turn in ((0, 1, 3, 2), (1, 2, 2, 1), (2, 9, 0, 0)):
        sigma = np.hypot(error[hold, site], readings.noise_counts[hold, chip])
        off = (readings.counts[hold, chip] - turns[turn] @ field[hold, site]) / sigma
        terms = 8 * np.log1p(off**2 / 16) + np.log(sigma)
        assert found[hold, chip, site, turn] == pytest.approx(np.nansum(terms), rel=1e-9)


def test_an_arrangement_costs_its_misfit_and_what_hypotheses_cost():
    readings, model, pose = made_up(range(CHIPS))
    found = channels.assigned_sites(readings, model, pose)
    assert_array_equal(found.site, np.arange(CHIPS))
    assert_array_equal(found.turn, np.tile(np.eye(3), (CHIPS, 1, 1)))
    turns = signed_permutations()
    misfit = channels.misfit_of(readings, model, pose, turns).sum(axis=0)
    own = misfit[np.arange(CHIPS), np.arange(CHIPS), 0].sum()
    prior = 0.5 * np.sum(model.off_prior(pose) ** 2)
    assert found.cost == pytest.approx(own + prior)
    over = replace(model, polarity=-model.polarity)
    mirrored = channels.assigned_sites(readings, over, pose)
    assert np.linalg.det(mirrored.turn).max() < 0
    assert mirrored.cost > found.cost + CHIPS * 5.0
    order = np.array([1, 0, *range(2, CHIPS)])
    exchanged = replace(
        readings, counts=readings.counts[:, order], noise_counts=readings.noise_counts[:, order]
    )
    swapped = channels.assigned_sites(exchanged, model, pose)
    assert_array_equal(swapped.site, order)
    assert swapped.cost == pytest.approx(found.cost + 2 * 7.0)
    counts = readings.counts.copy()
    counts[:, 3] = counts[:, 3] @ turns[7].T
    turned = channels.assigned_sites(replace(readings, counts=counts), model, pose)
    assert_array_equal(turned.turn[3], turns[7])
    assert turned.cost == pytest.approx(found.cost + 7.0, abs=2.0)
    counts = readings.counts.copy()
    counts[:, 3] *= -1
    reversed_ = channels.assigned_sites(replace(readings, counts=counts), model, pose)
    assert_array_equal(reversed_.turn[3], -np.eye(3))
    assert reversed_.cost == pytest.approx(found.cost + 7.0 + 9.0)


def test_chips_go_where_the_magnet_moves_them_most_and_unheld_places_keep_theirs():
    counts = np.full((2, 4, 3), 1.0)
    counts[0, 1], counts[1, 2] = 900.0, 700.0
    readings = channels.HeldReadings(counts, np.ones((2, 4, 3)), 0.05, 0.2)
    assert channels.sites_by_response(readings, [2, 0]).tolist() == [1, 2, 0, 3]
    assert channels.sites_by_response(readings, [1, 2]).tolist() == [0, 1, 2, 3]
    near = np.zeros((2, 2, 3))
    near[:, :, 1] = [[2.0, 7.0], [0.0, 2.0]]  # of two chips: (2 + 1)(2 + 1) against (7 + 1)(0 + 1)
    two = channels.HeldReadings(near, np.ones((2, 2, 3)), 0.05, 0.2)
    assert channels.sites_by_response(two, [0, 1]).tolist() == [0, 1]
    near[0, 1, 1] = 9.0
    assert channels.sites_by_response(two, [0, 1]).tolist() == [1, 0]
    nothing = replace(readings, counts=np.full((2, 4, 3), np.nan))
    assert channels.sites_by_response(nothing, [2, 3]).tolist() == [0, 1, 2, 3]


def test_a_hold_is_turned_over_where_that_is_likelier_by_five():
    readings, model, pose = made_up()
    counts = readings.counts.copy()
    counts[1] = -counts[1]
    found = channels.with_polarities(replace(readings, counts=counts), as_named(model, pose))
    uniform = pose.copy()
    uniform[:, 5:] = 0
    assert found.polarity.tolist() == [1.0, -1.0, 1.0]
    quiet = replace(readings, counts=0 * readings.counts)
    undecided = channels.with_polarities(quiet, as_named(model, uniform))
    assert undecided.polarity.tolist() == [1.0, 1.0, 1.0]


def test_gains_stand_over_their_median_and_intervals_are_of_differences_to_the_mean():
    """Two chips; of the second only X answers, and errors of all entries are alike and free."""
    matrix = np.stack([np.diag([1.0, 1.1, 1.2]), np.diag([1.3, 9.0, 9.0])])
    known = np.array([[True] * 3, [True, False, False]])
    value, interval = chip_fit.relative_gains(matrix, 0.01 * np.eye(18), known)
    middle = np.median([1.0, 1.1, 1.2, 1.3])
    assert_allclose(value, np.array([[1.0, 1.1, 1.2, 1.1], [1.3, np.nan, np.nan, 1.3]]) / middle)
    axis = np.sqrt(0.01 * (0.75**2 + 3 * 0.25**2))
    chip = np.sqrt(0.01 * (3 * (1 / 3 - 0.25) ** 2 + 0.25**2))
    wanted = 1.96 * np.array([[axis] * 3 + [chip], [axis, np.nan, np.nan, axis]]) / middle
    assert_allclose(interval, wanted)


def test_matrices_of_chips_are_those_of_least_squares_and_weak_axes_are_dead():
    readings, model, pose = made_up((0, 1, 2, 3, 4))
    about = signed_permutations()[5]
    field = model.counts(pose)
    counts = np.einsum("ab,hcb->hca", about, field)
    counts[:, 0, 1] *= 0.29
    counts[:, 1, 2] *= 0.31
    counts[:3, 2, 0] = np.nan
    found = as_named(model, pose)
    turns, dead = chip_fit.linear_chips(replace(readings, counts=counts), found)
    assert np.argwhere(dead).tolist() == [[0, 1], [2, 0]]
    assert_allclose(turns[3:], np.tile(about, (CHIPS - 3, 1, 1)), atol=1e-9)
    three = counts.copy()
    three[:, 2, 0] = np.einsum("b,hb->h", about[0], field[:, 2])
    three[:2, 2, 0] = np.nan
    assert not chip_fit.linear_chips(replace(readings, counts=three), found)[1][2].any()


def test_what_is_found_of_chips_is_as_on_the_page(shuffled):
    _, _, readings, found = shuffled
    lines = [("sites", found.site), ("poses", found.pose), ("cost", found.cost)]
    for chip in chips_found(readings, found)[::4]:
        lines += [
            (f"chip at {chip.site}, turn", chip.turn),
            (f"chip at {chip.site}, gains ±", [*chip.gain, *chip.gain_interval]),
        ]
    assert_page("instobj/bench/bringup", lines, "chips, ")


def test_what_turns_a_hold_over_is_weighed_by_the_errors_of_its_readings():
    """Readings that are a share of the prediction: just beyond the share at which both ways round are
    apart by five, by hand, and just before it."""
    readings, model, pose = made_up()
    pose[:, 5:] = 0  # a uniform field does not turn with the magnet
    field, hold = model.counts(pose), 2
    error = channels.model_error(readings, model, pose)[hold, :, None]
    sigma = np.hypot(error, readings.noise_counts[hold])

    def apart(share):
        off = [(share - sign) * field[hold] / sigma for sign in (1.0, -1.0)]
        return np.subtract(*(np.sum(8 * np.log1p(one**2 / 16)) for one in off))

    border = brentq(lambda share: apart(share) - channels.TURNED_OVER, -0.9, 0.0)
    assert -0.5 < border < -1e-4
    for share, way in ((1.01 * border, -1.0), (0.99 * border, 1.0)):
        counts = field.copy()
        counts[hold] *= share
        found = channels.with_polarities(replace(readings, counts=counts), as_named(model, pose))
        assert found.polarity.tolist() == [1.0, 1.0, way]
