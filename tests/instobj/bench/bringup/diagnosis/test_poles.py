"""Steps of magnets in their pockets: errors of tolerances, likelihoods and moments by hand."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

from design.layout.places.positions import magnet_layout, sensor_layout
from estimator.field.sources import magnet_source
from instobj.bench.bringup.diagnosis import poles
from instobj.bench.bringup.diagnosis.findings import ChipFound
from tests.support.new_objects import SMALL
from tests.support.physics_pages import assert_page, chosen

SPEC = SMALL.changed(
    tolerances=SMALL.tolerances.changed(
        magnet_seat_mm=0.1,
        sensor_seat_mm=0.2,
        core_shift_mm=0.3,
        magnet_tilt_deg=1.0,
        sensor_rotation_deg=2.0,
        core_yaw_deg=0.5,
        remanence_relative=0.04,
        sensor_gain_relative=0.03,
    )
)
TURN = np.eye(3)[[1, 2, 0]]
CHIPS = tuple(ChipFound([1, 0, *range(2, 10)][k], TURN if k == 3 else np.eye(3)) for k in range(10))


@pytest.fixture(scope="module")
def fields():
    return poles.pocket_fields(SPEC, CHIPS)


def test_steps_are_those_of_magpylibs_disks_as_the_found_chips_read_them(fields):
    magnets, sensors = magnet_layout(SPEC), sensor_layout(SPEC)
    disk = magnet_source(SPEC.magnets)
    for pocket in (0, 7):
        magnet = magpylib.magnet.Cylinder(
            polarization=(0, 0, disk.polarization_t), dimension=(disk.diameter_mm, disk.height_mm)
        )
        axis = magnets.strength[pocket] * magnets.axis[pocket]
        magnet.rotate(Rotation.align_vectors([axis], [[0, 0, 1.0]])[0])
        magnet.position = magnets.centre_mm[pocket]
        for k, chip in enumerate(CHIPS):
            field = 1e3 * SPEC.sensors.counts_per_mt * magnet.getB(sensors.position_mm[chip.site])
            axes = chip.turn @ sensors.axes[chip.site]
            assert_allclose(fields.step[pocket, k], axes @ field, atol=1.5)
            assert_allclose(fields.uniform[k], axes, atol=1e-12)


def test_errors_of_steps_are_those_of_turns_strengths_and_seats_over_the_distance(fields):
    magnets, sensors = magnet_layout(SPEC), sensor_layout(SPEC)
    turns = np.radians([1.0, 2.0, 0.5])
    seats = np.sqrt(2 * 0.1**2 + 0.2**2 + 0.3**2)
    for pocket, chip in ((0, 0), (6, 9)):
        site = CHIPS[chip].site
        away = np.linalg.norm(sensors.position_mm[site] - magnets.centre_mm[pocket])
        relative = np.sqrt(np.sum(turns**2) + 0.04**2 + 0.03**2 + (3 * seats / away) ** 2)
        size = np.linalg.norm(fields.step[pocket, chip])
        assert fields.error[pocket, chip] == pytest.approx(size * relative)
    floor = np.hypot(SPEC.sensors.zeroing_counts, max(SPEC.sensors.noise_counts) / 2)
    sigma = fields.sigma(4)[:, 0]
    assert_allclose(sigma, np.hypot(fields.error[4], floor))


def test_the_cost_is_a_robust_likelihood_at_the_best_uniform_field(fields):
    """The uniform field is found by squares; the cost is 16/2 ln(1 + r²/16) + ln σ of what is left."""
    rng = np.random.default_rng(0)
    change = fields.step[4] + rng.normal(0, 30, (10, 3))
    change[2, 1] = np.nan
    sigma = np.broadcast_to(fields.sigma(4), change.shape)
    limit = 0.1 * SPEC.sensors.counts_per_mt
    for sign in (1.0, -1.0):
        left = change - sign * fields.step[4]

        def squares(uniform, left=left):
            off = (left - np.einsum("cab,b->ca", fields.uniform, uniform)) / sigma
            return np.nansum(off**2) + np.sum((uniform / limit) ** 2)

        best = minimize(squares, np.zeros(3)).x
        off = (left - np.einsum("cab,b->ca", fields.uniform, best)) / sigma
        wanted = np.nansum(8 * np.log1p(off**2 / 16) + np.log(sigma) * np.isfinite(off))
        assert poles.cost_of(fields, 4, sign, change) == pytest.approx(wanted, rel=1e-4)


def test_the_moment_is_that_of_weighted_least_squares_beside_a_uniform_field(fields):
    turned = np.einsum("cab,b->ca", fields.uniform, [60.0, -20.0, 10.0])
    change = -0.7 * fields.step[3] + turned
    change[1, 2] = np.nan
    assert poles.strength_of(fields, 3, change) == pytest.approx(-0.7)
    found = poles.find_magnet(fields, 3, change)
    assert (found.expected_pocket, found.pocket) == (3, 3)
    assert found.strength == pytest.approx(-0.7)
    elsewhere = poles.find_magnet(fields, 3, fields.step[8] + turned)
    assert (elsewhere.expected_pocket, elsewhere.pocket) == (3, 8)


def test_without_any_step_the_pocket_stays_as_asked(fields):
    assert poles.find_magnet(fields, 5, np.full((10, 3), np.nan)).pocket == 5
    nothing = poles.find_magnet(fields, 2, np.zeros((10, 3)))
    assert nothing.strength == pytest.approx(0.0, abs=1e-9)


def test_fields_of_pockets_and_a_magnet_found_are_as_on_the_page(fields):
    change = 0.8 * fields.step[3] + 25 * np.sin(np.arange(30.0)).reshape(10, 3)
    found = poles.find_magnet(fields, 3, change)
    lines = chosen(fields, "step", "error", "uniform")
    lines += chosen(found, "expected_pocket", "pocket", "strength")
    assert_page("instobj/bench/bringup", lines, "poles, ")
