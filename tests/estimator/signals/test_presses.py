"""Signals of presses against an independent field simulation, and their files."""

from dataclasses import replace

import magpylib
import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.errors import InputError, StoreError
from design.layout.places.contact_grid import grid_places_in_lattice
from design.layout.places.positions import magnet_layout, sensor_layout
from estimator.field.vectors import rotate
from estimator.signals.field_setup import min_distance_mm, scene
from estimator.signals.presses import (
    load_signals,
    press_signals,
    require_finite,
    rest_counts,
    saturation_margin,
    save_grid_signals,
    save_signals,
)
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec()
POLARIZATION_T = 1.43 / (1 + 0.05 * 0.7145899)  # Ø6 × 1 mm: 1 less Nagaoka's coefficient


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def signals(presses):
    return press_signals(SPEC, *presses)


def oracle_counts(motion):
    """Counts (sensor, axis) by magpylib with scipy's rotations, magnet by magnet."""
    magnets, sensors = magnet_layout(SPEC), sensor_layout(SPEC)
    field = np.zeros((len(sensors.face), 3))
    for centre, axis, (*shift, rx, ry, rz) in zip(
        magnets.centre_mm, magnets.axis, motion, strict=True
    ):
        magnet = magpylib.magnet.Cylinder(
            polarization=POLARIZATION_T * axis_to_z(axis)[1], dimension=(6e-3, 1e-3)
        )
        magnet.rotate(axis_to_z(axis)[0])
        magnet.rotate(Rotation.from_rotvec([rx, ry, rz]))
        magnet.position = (centre + shift) / 1e3
        field += magnet.getB(sensors.position_mm / 1e3)
    return 820e3 * np.einsum("sac,sc->sa", sensors.axes, field)


def axis_to_z(axis):
    """A rotation that takes z to `axis`, and the polarization direction before it."""
    turn, _ = Rotation.align_vectors([axis], [[0, 0, 1]])
    return turn, np.array([0, 0, 1.0])


def test_every_press_matches_magpylib_with_all_magnets_and_all_sensors(presses, signals):
    rest = oracle_counts(np.zeros((25, 6)))
    assert_allclose(signals.baseline_counts, rest, rtol=0, atol=1e-3 * abs(rest).max())
    for face, place, step in ((0, 11, 5), (2, 63, 4), (4, 40, 5)):
        motion = presses[1].motion[face, place, step]
        delta = oracle_counts(motion) - rest
        found = signals.delta_counts[face, place, step]
        assert_allclose(found, delta, rtol=0, atol=3e-3 * abs(delta).max())


def test_presses_are_seen_by_other_faces(signals):
    other = sensor_layout(SPEC).face != 3
    assert abs(signals.delta_counts[2, :, -1][:, other]).max() > 50


def test_rest_gives_no_change(presses):
    still = replace(presses[1], motion=np.zeros_like(presses[1].motion))
    delta = press_signals(SPEC, presses[0], still).delta_counts
    assert_allclose(delta, 0, atol=1e-8)


def test_rotation_is_finite_rodrigues():
    rng = np.random.default_rng(1)
    turns = np.concatenate(
        [rng.normal(size=(50, 3)), 1e-9 * rng.normal(size=(5, 3)), np.zeros((1, 3))]
    )
    vectors = rng.normal(size=(56, 3))
    assert_allclose(rotate(vectors, turns), Rotation.from_rotvec(turns).apply(vectors), atol=1e-13)


def test_nearest_distance_counts_the_motion(presses):
    magnets, sensors = magnet_layout(SPEC), sensor_layout(SPEC)
    motion = np.zeros((1, 25, 6))
    # a sensor 15° beside a corner magnet: radii 8.585 and 10√2 mm, 7.8 mm apart in depth
    at_rest = np.hypot(abs(8.585 * np.exp(1j * np.pi / 12) - 10 * 2**0.5), 7.8)
    assert_allclose(min_distance_mm(scene(SPEC), motion), at_rest, rtol=1e-9)
    towards = sensors.position_mm[3] - magnets.centre_mm[8]
    motion[0, 8, :3] = towards * (1 - 5 / np.linalg.norm(towards))
    assert_allclose(min_distance_mm(scene(SPEC), motion), 5.0, rtol=1e-9)


def test_near_magnets_use_the_exact_cylinder(presses):
    magnets, sensors = magnet_layout(SPEC), sensor_layout(SPEC)
    motion = np.zeros_like(presses[1].motion)
    motion[0, 0, 0, 8, :3] = sensors.position_mm[3] - magnets.centre_mm[8] + 1.0 * magnets.axis[8]
    delta = press_signals(SPEC, presses[0], replace(presses[1], motion=motion)).delta_counts
    expected = oracle_counts(motion[0, 0, 0]) - oracle_counts(np.zeros((25, 6)))
    assert_allclose(delta[0, 0, 0], expected, rtol=1e-6, atol=1e-4)
    motion[0, 0, 0, 8, :3] -= 0.7 * magnets.axis[8]
    with pytest.raises(InputError, match="onto a sensor"):
        press_signals(SPEC, presses[0], replace(presses[1], motion=motion))


def test_saturation_margin_is_of_the_largest_reading(signals):
    largest = abs(signals.baseline_counts + signals.delta_counts).max()
    assert_allclose(saturation_margin(signals, SPEC), 1 - largest / 32767, rtol=1e-12)
    narrow = coarse_spec(sensors={"range_mt": largest / 820 * 0.8})
    assert_allclose(saturation_margin(signals, narrow), -0.25, atol=1e-3)


def test_rest_saturation_is_refused(presses):
    narrow = coarse_spec(sensors={"range_mt": abs(rest_counts(SPEC)).max() / 820 * 0.9})
    with pytest.raises(InputError, match="saturates at rest"):
        press_signals(narrow, *presses)


def test_signals_survive_their_file(signals, tmp_path):
    save_signals(signals, tmp_path / "signals.nc")
    back = load_signals(tmp_path / "signals.nc")
    for name in ("faces", "depth_mm", "force_n", "delta_counts", "baseline_counts"):
        np.testing.assert_array_equal(getattr(back, name), getattr(signals, name))
    np.testing.assert_array_equal(back.lattice.xy_mm, signals.lattice.xy_mm)
    with pytest.raises(InputError, match="no signals at"):
        load_signals(tmp_path / "other.nc")
    (tmp_path / "text.nc").write_text("no data")
    with pytest.raises(StoreError, match="not a file of signals"):
        load_signals(tmp_path / "text.nc")


def test_grid_signals_hold_contact_places_and_one_noisy_reading(signals, tmp_path):
    save_grid_signals(SPEC, signals, tmp_path / "grid.nc", seed=5)
    with xr.open_dataset(tmp_path / "grid.nc") as data:
        assert dict(data.sizes) == {"face": 5, "place": 20, "step": 6, "sensor": 15, "axis": 3}
        place = grid_places_in_lattice(SPEC)[7]
        assert_allclose(signals.lattice.xy_mm[place], [data.x_mm[7], data.y_mm[7]])
        np.testing.assert_array_equal(data.delta_counts[:, 7], signals.delta_counts[:, place])
        error = data.reading_counts - data.baseline_counts - data.delta_counts
        assert_allclose(error.std(("face", "place", "step", "sensor")), [22, 22, 11], rtol=0.05)
        assert data.force_n.attrs["units"] == "N"
        assert data.axis.values.tolist() == ["X", "Y", "Z"]


def test_a_press_that_adds_to_the_baseline_counts_with_it(signals):
    """A channel at 1000 that a press takes by 500 more uses 1500 counts of the scale."""
    made = replace(
        signals,
        baseline_counts=np.full_like(signals.baseline_counts, 1000.0),
        delta_counts=np.full_like(signals.delta_counts, 500.0),
    )
    assert_allclose(saturation_margin(made, SPEC), 1 - 1500 / 32767, rtol=1e-12)


def told(signals):
    with pytest.raises(InputError) as caught:
        require_finite(SPEC, signals)
    return str(caught.value)


def test_channels_that_are_not_finite_are_named_four_at_most(signals):
    require_finite(SPEC, signals)
    delta, baseline = signals.delta_counts.copy(), signals.baseline_counts.copy()
    delta[2, 40, 1, 4, 2] = delta[2, 41, 1, 4, 2] = np.nan
    baseline[14, 0] = np.inf
    two = replace(signals, delta_counts=delta, baseline_counts=baseline)
    assert told(two).startswith("signals are not finite on F2-Z2, F5-X3 (2 presses on the worst).")
    baseline[:2] = np.nan
    many = replace(signals, delta_counts=delta, baseline_counts=baseline)
    assert "F1-X1, F1-Y1, F1-Z1, F1-X2 and 4 more (" in told(many)
    force = signals.force_n.copy()
    force[0, 3, :2] = np.nan
    assert told(replace(signals, force_n=force)).startswith("the force of 2 presses is not finite")


def test_saturation_margin_is_that_at_rest_where_presses_take_from_it(signals):
    """Of a reading of −20000 counts, which every press makes a tenth smaller."""
    baseline = np.zeros_like(signals.baseline_counts)
    baseline[2, 1], baseline[0, 0] = -20000.0, 900.0
    delta = np.broadcast_to(-0.1 * baseline, signals.delta_counts.shape)
    eased = replace(signals, baseline_counts=baseline, delta_counts=delta)
    assert_allclose(saturation_margin(eased, SPEC), 1 - 20000 / 32767, rtol=1e-12)
