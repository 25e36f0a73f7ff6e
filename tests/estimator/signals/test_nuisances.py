"""Changes since the zero: sizes by hand, and the counts that the whole forward chain adds for them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.signals.nuisances import magnet_columns, nuisance_columns, nuisances
from estimator.signals.presses import rest_counts

CUBE = ObjectSpec(name="cube")


def used(spec, **sizes):
    return spec.changed(tolerances=spec.tolerances.changed(**sizes))


def test_a_turned_object_sees_a_field_change_as_its_chips_stand():
    """By the forward chain: counts at rest in a field less those without."""
    columns = nuisance_columns(used(CUBE, temperature_k=0.0))
    assert columns.shape == (45, 3)
    rng = np.random.default_rng(1)
    for direction in rng.standard_normal((3, 3)):
        size_ut = 30.0
        field_ut = size_ut * direction / np.linalg.norm(direction)
        around = CUBE.environment.changed(earth_ut=tuple(field_ut.tolist()))
        change = rest_counts(CUBE.changed(environment=around)) - rest_counts(CUBE)
        assert_allclose(columns @ (field_ut / (np.sqrt(2 / 3) * 50.0)), change.ravel(), atol=1e-8)


def test_the_field_s_deviation_is_that_of_two_random_directions():
    """Of 50 µT: 41 µT along each coordinate of the object."""
    directions = np.random.default_rng(2).standard_normal((2, 20_000, 3))
    directions /= np.linalg.norm(directions, axis=2, keepdims=True)
    drawn_ut = 50.0 * np.std(directions[1] - directions[0], axis=0)
    ambient, _ = nuisances(CUBE)
    assert_allclose(drawn_ut, ambient.deviation, rtol=0.02)


def test_warm_magnets_lose_a_share_of_what_is_seen_at_rest():
    columns = nuisance_columns(used(CUBE, earth_field_ut=0.0, temperature_k=3.0))
    warm = CUBE.changed(magnets=CUBE.magnets.changed(remanence_t=1.43 * (1 - 3 * 0.0011)))
    assert_allclose(columns[:, 0], (rest_counts(warm) - rest_counts(CUBE)).ravel(), atol=1e-8)
    around = CUBE.changed(environment=CUBE.environment.changed(earth_ut=60.0))
    assert_allclose(nuisance_columns(around), nuisance_columns(CUBE))


def test_an_object_that_stands_still_has_none():
    bench = CUBE.changed(limits=CUBE.limits.changed(use="bench"))
    assert nuisances(bench) == ()
    assert nuisance_columns(bench).shape == (45, 0)
    assert nuisance_columns(used(CUBE, earth_field_ut=0.0, temperature_k=0.0)).shape == (45, 0)
    assert [one.name for one in nuisances(CUBE)] == ["ambient field", "temperature"]


def test_gains_of_drawn_chips_count():
    """Errors of chips that the specification draws scale the field's columns as they do its counts."""
    wrong = CUBE.changed(sensors=CUBE.sensors.changed(chip_spread=(0.1, 0.0)))
    north = wrong.environment.changed(earth_ut=(10.0, 0.0, 0.0))
    change = rest_counts(wrong.changed(environment=north)) - rest_counts(wrong)
    columns = nuisance_columns(wrong)[:, 0] * 10 / (np.sqrt(2 / 3) * 50)
    assert_allclose(columns, change.ravel(), atol=1e-8)


@pytest.mark.parametrize(("shell", "distance_mm"), [(0, 50), (1, 70), (2, 110)])
def test_columns_of_a_magnet_hold_what_magnets_near_the_object_add(shell, distance_mm):
    """Exact disks in place of dipoles, by the forward chain: Ø10 × 5 mm, by shell of distances."""
    columns, rng = magnet_columns(CUBE)[shell], np.random.default_rng(5)
    left, whole, size = [], [], []
    for place, axis in rng.standard_normal((12, 2, 3)):
        position = tuple((distance_mm * place / np.linalg.norm(place)).tolist())
        remanence_t = tuple((1.4 * axis / np.linalg.norm(axis)).tolist())
        magnet = {"position_mm": position, "size_mm": (10.0, 5.0), "remanence_t": remanence_t}
        around = CUBE.environment.changed(magnets=[magnet])
        change = (rest_counts(CUBE.changed(environment=around)) - rest_counts(CUBE)).ravel()
        unknowns = np.linalg.lstsq(columns, change, rcond=None)[0]
        left.append(np.linalg.norm(change - columns @ unknowns))
        whole.append(np.linalg.norm(change))
        size.append(np.linalg.norm(columns))
    assert np.linalg.norm(left) < 0.1 * np.linalg.norm(whole)
    # what is expected of such a magnet is as large as what it adds
    assert 0.5 < np.linalg.norm(whole) / np.linalg.norm(size) < 2
