"""Figures of a silicone that are left out: from its name, its hardness, or none."""

import re

import pytest

from design.catalogue.silicones import SILICONES, modulus_from_shore
from design.errors import InputError
from design.spec.silicone import SiliconeSpec

OWN = {"name": "own rubber"}


def silicone(**given):
    return SiliconeSpec.model_validate(given)


@pytest.mark.parametrize("name", SILICONES)
def test_a_name_gives_all_figures(name):
    preset, found = SILICONES[name], silicone(name=name)
    assert found.youngs_modulus_mpa == preset.modulus.youngs_modulus_mpa
    assert found.youngs_modulus_range_mpa == preset.modulus.range_mpa
    assert found.modulus_source == preset.modulus.source
    assert (found.poisson_ratio, found.density_g_per_cm3) == (
        preset.poisson_ratio,
        preset.density_g_per_cm3,
    )
    assert (found.cure, found.casting) == (preset.casting.cure, preset.casting)


@pytest.mark.parametrize(
    ("given", "modulus", "spread", "source"),
    [
        ({"youngs_modulus_mpa": 0.5}, 0.5, (0.15, 0.54), "given"),
        ({"youngs_modulus_mpa": 0.55}, 0.55, None, "given"),
        ({**OWN, "youngs_modulus_mpa": 0.5}, 0.5, None, "given"),
        ({**OWN, "youngs_modulus_mpa": 0.5, "modulus_from": "a.csv"}, 0.5, None, "fitted to a.csv"),
        (
            {**OWN, "youngs_modulus_mpa": 0.5, "youngs_modulus_range_mpa": [0.4, 0.6]},
            0.5,
            (0.4, 0.6),
            "given",
        ),
    ],
)
def test_a_given_modulus_keeps_the_interval_that_holds_it(given, modulus, spread, source):
    found = silicone(**given)
    assert (found.youngs_modulus_mpa, found.youngs_modulus_range_mpa) == (modulus, spread)
    assert found.modulus_source == source
    if spread:
        assert found.relative_spread == pytest.approx((spread[0] / modulus, spread[1] / modulus))
    else:
        assert found.relative_spread is None


def test_hardness_goes_before_the_name_and_an_unknown_name_needs_a_modulus():
    estimate = modulus_from_shore("A20")
    for name in ("own rubber", "Platsil Gel-10"):
        found = silicone(name=name, modulus_from="A20")
        assert found.youngs_modulus_mpa == estimate.youngs_modulus_mpa
        assert found.youngs_modulus_range_mpa == estimate.range_mpa
        assert found.modulus_source == estimate.source
    with pytest.raises(ValueError, match="is not in the catalogue"):
        silicone(**OWN)
    assert silicone(**OWN, youngs_modulus_mpa=0.4).casting is None
    with pytest.raises(ValueError, match="is read where a specification is loaded"):
        silicone(**OWN, modulus_from="a.csv")


def test_skins_are_stiffer_right_under_the_surface():
    skins = [[1.0, 5.0], [1.0, 2.0]]
    assert silicone(youngs_modulus_mpa=0.4).surface_modulus_mpa == 0.4
    assert silicone(youngs_modulus_mpa=0.4, layers=skins).surface_modulus_mpa == pytest.approx(2.0)


@pytest.mark.parametrize("reading", ["A10", "a 0", "A95", "A-33.5"])
def test_hardness_a_by_gent(reading):
    hardness = float(re.findall(r"[\d.]+", reading)[0])
    wanted = 0.0981 * (56 + 7.66 * hardness) / (0.137505 * (254 - 2.54 * hardness))
    found = modulus_from_shore(reading)
    assert found.youngs_modulus_mpa == pytest.approx(wanted, rel=1e-9)
    assert found.range_mpa == pytest.approx((0.3 * wanted, 1.3 * wanted))


@pytest.mark.parametrize("reading", ["00-30", "oo 50", "OO0", "00-95"])
def test_hardness_00_by_hertz(reading):
    """Ball of 1.19 mm, 2.5 (1 − S/100) mm deep with 0.203 + 0.00908 S newtons, ν = ½."""
    hardness = float(re.findall(r"[\d.]+", reading[2:])[0])
    depth, force = 2.5 * (1 - hardness / 100), 0.203 + 0.00908 * hardness
    wanted = 0.75 * 0.75 * force / (1.19**0.5 * depth**1.5)
    found = modulus_from_shore(reading)
    assert found.youngs_modulus_mpa == pytest.approx(wanted, rel=1e-9)
    assert found.range_mpa == pytest.approx((0.4 * wanted, 2.1 * wanted))


@pytest.mark.parametrize("reading", ["B10", "A96", "A-", "00", "A1e3", "", "10A"])
def test_other_scales_are_refused(reading):
    with pytest.raises(InputError, match="is no hardness that can be converted"):
        modulus_from_shore(reading)
