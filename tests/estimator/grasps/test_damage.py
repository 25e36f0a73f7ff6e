"""Hertz against its own formulas, probabilities against drawn fruits, and limits in files."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

from design.errors import InputError
from estimator.grasps.damage import (
    SHIPPED,
    DamageLimit,
    Sphere,
    damage_probability,
    energy_mj,
    indentation_mm,
    mean_pressure_mpa,
    patch_radius_mm,
    read_limits,
)

PAIR = Sphere(1.2, 0.35, 4.4)
LIMIT = DamageLimit("fruit", "pressure_mpa", 0.3, 0.25, "made up", "", 1.2, 0.35, 38.0)


def test_force_follows_depth_to_the_power_of_three_halves():
    force = np.array([0.5, 2.0, 9.0])
    depth = indentation_mm(force, PAIR)
    assert_allclose(force, 4 / 3 * PAIR.plane_modulus_mpa * np.sqrt(PAIR.radius_mm) * depth**1.5)


def test_the_pressure_over_the_patch_is_the_force():
    force = np.array([3.0])
    radius = patch_radius_mm(force, PAIR)[0]
    largest = 1.5 * mean_pressure_mpa(force, PAIR)[0]
    # Hertz's pressure p₀ √(1 − r²/a²) over the disc
    carried = quad(lambda r: 2 * np.pi * r * largest * np.sqrt(1 - (r / radius) ** 2), 0, radius)[0]
    assert carried == pytest.approx(3.0, rel=1e-6)


def test_the_energy_is_the_work_along_the_depth():
    depth = indentation_mm(np.array([6.0]), PAIR)[0]
    stiff = 4 / 3 * PAIR.plane_modulus_mpa * np.sqrt(PAIR.radius_mm)
    assert energy_mj(np.array([6.0]), PAIR)[0] == pytest.approx(
        quad(lambda d: stiff * d**1.5, 0, depth)[0]
    )


def test_no_force_presses_nothing():
    assert mean_pressure_mpa(np.zeros(2), PAIR).tolist() == [0, 0]


@pytest.mark.parametrize("quantity", ["force_n", "pressure_mpa", "strain", "energy_mj"])
def test_half_of_the_fruits_break_at_the_median(quantity):
    force = np.array([4.0])
    at = DamageLimit("fruit", quantity, 1.0, 0.2, "made up").load(force, 5.0)
    limit = DamageLimit("fruit", quantity, float(at[0]), 0.2, "made up")
    assert limit.probability(limit.load(force, 5.0))[0] == pytest.approx(0.5)
    assert limit.probability(limit.load(2 * force, 5.0))[0] > 0.7


def test_probabilities_are_those_of_drawn_fruits():
    rng = np.random.default_rng(5)
    forces = rng.uniform(2, 14, 40)
    broken, told = [], []
    for force in forces:
        pressed = np.abs(force + 0.3 * rng.standard_normal((64, 2)))
        told.append(damage_probability(LIMIT, pressed, 5.0)[0].mean())
        fruits = 0.3 * np.exp(0.25 * rng.standard_normal(4000))
        load = LIMIT.load(np.abs(force + 0.3 * rng.standard_normal((4000, 2))), 5.0).max(axis=1)
        broken.append(np.mean(load > fruits))
    assert np.ptp(told) > 0.5  # else it proves nothing
    assert_allclose(told, broken, atol=0.05)


def test_one_fruit_has_one_limit_for_all_its_contacts():
    force = np.full((1, 3), 5.0)
    whole, each = damage_probability(LIMIT, force, 5.0)
    assert whole.mean() == pytest.approx(each[0])


def test_a_sharper_tip_damages_sooner():
    force = np.array([4.0])
    assert LIMIT.load(force, 2.0)[0] > LIMIT.load(force, 20.0)[0]


def test_shipped_limits_name_their_sources():
    limits = read_limits(str(SHIPPED))
    assert [limit.name for limit in limits] == [
        "apple", "pear", "tomato", "strawberry", "kiwi", "egg",
    ]  # fmt: skip
    assert all(len(limit.source) > 40 and limit.note for limit in limits)
    assert [limit.name for limit in read_limits("egg")] == ["egg"]


OWN = 'name = "plum"\nquantity = "force_n"\nmedian = 12\nspread = 0.2\nsource = "our test rig"\n'


def test_own_limits_are_read(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(f"[[limit]]\n{OWN}")
    (limit,) = read_limits(str(path))
    assert (limit.name, limit.median) == ("plum", 12)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "holds no"),
        ("[[limit", "cannot be read"),
        ("limit = 3", "holds no"),
        (f"[[limit]]\n{OWN}colour = 3", "colour"),
        ('[[limit]]\nname = "plum"', "median"),
        (f"[[limit]]\n{OWN}".replace("12", "-1"), "above 0"),
        (f"[[limit]]\n{OWN}".replace("12", "nan"), "above 0"),
        (f"[[limit]]\n{OWN}".replace("12", '"12"'), "above 0"),
        (f"[[limit]]\n{OWN}".replace("force_n", "colour"), "quantity is one of"),
        (f"[[limit]]\n{OWN}poisson = 0.7", "at most 0.5"),
    ],
)
def test_bad_limits_are_one_clear_error(tmp_path, content, said):
    path = tmp_path / "own.toml"
    path.write_text(content)
    with pytest.raises(InputError, match=said):
        read_limits(str(path))


def test_an_unknown_fruit_and_a_missing_file_are_named():
    with pytest.raises(InputError, match="apple, pear, tomato"):
        read_limits("durian")
    with pytest.raises(InputError, match="cannot be read"):
        read_limits("nowhere.toml")
