"""Named silicones and hardness: the modulus, its spread, and what a specification takes from them."""

import pytest
from numpy.testing import assert_allclose

from design.catalogue.silicones import (
    SILICONES,
    modulus_from_shore,
    youngs_modulus_from_shore_00_mpa,
    youngs_modulus_from_shore_a_mpa,
)
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec, spec_hash


def silicone(**figures):
    return parse_spec({"name": "cube", "silicone": figures}, "test").silicone


def test_gent_s_relation_is_the_mean_cone_as_a_flat_punch():
    """F = 2 a E δ / (1 − ν²), ν = ½, a the mean radius of ASTM D2240's truncated cone."""
    assert_allclose(youngs_modulus_from_shore_a_mpa(10.0), 0.414, rtol=1e-3)
    for hardness in (10.0, 37.0, 80.0):
        force_n = 0.549 + 0.07512 * hardness
        punch = 0.75 * force_n / (2 * 0.5156 * 2.54 * (1 - hardness / 100))
        assert_allclose(youngs_modulus_from_shore_a_mpa(hardness), punch, rtol=5e-3)


def test_the_00_relation_is_hertz_s_ball():
    for hardness in (12.0, 55.0):
        depth_mm = 2.5 * (1 - hardness / 100)
        modulus = youngs_modulus_from_shore_00_mpa(hardness)
        force_n = 4 / 3 * modulus / (1 - 0.25) * 1.19**0.5 * depth_mm**1.5
        assert_allclose(force_n, 0.203 + 0.00908 * hardness, rtol=1e-12)


def test_both_scales_agree_where_they_overlap_within_their_spreads():
    """Charts put Shore A10 at about 00-55, A20 at about 00-70."""
    for a, oo in (("A10", "00-55"), ("A20", "OO 70")):
        one, other = modulus_from_shore(a), modulus_from_shore(oo)
        assert one.low_mpa < other.youngs_modulus_mpa < one.high_mpa
        assert other.low_mpa < one.youngs_modulus_mpa < other.high_mpa


@pytest.mark.parametrize("reading", ["D10", "10", "A", "A-5x", "A99", "00-100", ""])
def test_other_hardness_is_refused(reading):
    with pytest.raises(InputError, match="no hardness that can be converted"):
        modulus_from_shore(reading)


@pytest.mark.parametrize("name", SILICONES)
def test_a_preset_gives_every_figure_that_is_left_out(name):
    preset, spec = SILICONES[name], silicone(name=name)
    assert preset.modulus.admits(preset.modulus.youngs_modulus_mpa)
    assert spec.youngs_modulus_mpa == preset.modulus.youngs_modulus_mpa
    assert spec.youngs_modulus_range_mpa == preset.modulus.range_mpa
    assert spec.density_g_per_cm3 == preset.density_g_per_cm3
    assert spec.poisson_ratio == preset.poisson_ratio
    assert spec.modulus_source == preset.modulus.source


def test_harder_dragon_skin_is_stiffer_and_within_gent_s_spread():
    moduli = [SILICONES[f"Dragon Skin {n}"].modulus.youngs_modulus_mpa for n in (10, 20, 30)]
    assert moduli == sorted(moduli)
    for hardness, modulus in zip((10, 20, 30), moduli, strict=True):
        assert modulus_from_shore(f"A{hardness}").admits(modulus)


def test_an_explicit_modulus_goes_before_hardness_and_hardness_before_the_name():
    assert silicone(name="Ecoflex 00-30", modulus_from="A20").youngs_modulus_mpa == pytest.approx(
        0.7345, abs=1e-3
    )
    both = silicone(modulus_from="A20", youngs_modulus_mpa=0.5)
    assert (both.youngs_modulus_mpa, both.modulus_source) == (0.5, "given")
    assert both.relative_spread == pytest.approx((0.4407, 1.9097), abs=1e-3)
    far = silicone(youngs_modulus_mpa=2)
    assert (far.youngs_modulus_range_mpa, far.relative_spread) == (None, None)


def test_an_unknown_name_needs_a_modulus():
    with pytest.raises(InputError, match=r"'Goo' is not in the catalogue.*silicone.modulus_from"):
        silicone(name="Goo")
    assert silicone(name="Goo", youngs_modulus_mpa=0.2).youngs_modulus_range_mpa is None


def test_a_range_must_hold_the_modulus():
    assert silicone(youngs_modulus_range_mpa=[0.3, 0.5]).relative_spread == pytest.approx(
        (0.3 / 0.414, 0.5 / 0.414)
    )
    with pytest.raises(InputError, match=r"around youngs_modulus_mpa = 0.414; got \[0.5, 0.6\]"):
        silicone(youngs_modulus_range_mpa=[0.5, 0.6])


def test_relaxation_keeps_a_solid():
    with pytest.raises(InputError, match=r"sum to less than 1; got 1\.1"):
        silicone(prony=[[0.6, 1], [0.5, 9]])


def test_specifications_with_equal_figures_are_equal():
    spec = parse_spec({"name": "cube", "silicone": {"modulus_from": "A30"}}, "test")
    assert spec_hash(parse_spec(spec.model_dump(mode="json"), "again")) == spec_hash(spec)
    assert spec_hash(ObjectSpec(name="cube", silicone=silicone())) == spec_hash(
        ObjectSpec(name="cube")
    )


def test_hardness_from_0_to_95_is_converted():
    assert (
        modulus_from_shore("A95").youngs_modulus_mpa
        > modulus_from_shore("A0").youngs_modulus_mpa
        > 0
    )
    with pytest.raises(InputError, match="no hardness that can be converted"):
        modulus_from_shore("A95.1")
