"""Named silicones and hardness: the modulus, its spread, and what a specification takes from them."""

import pytest

from design.catalogue.silicones import (
    SILICONES,
    modulus_from_shore,
)
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec, spec_hash


def silicone(**figures):
    return parse_spec({"name": "cube", "silicone": figures}, "test").silicone


def test_both_scales_agree_where_they_overlap_within_their_spreads():
    """Charts put Shore A10 at about 00-55, A20 at about 00-70."""
    for a, oo in (("A10", "00-55"), ("A20", "OO 70")):
        one, other = modulus_from_shore(a), modulus_from_shore(oo)
        assert one.low_mpa < other.youngs_modulus_mpa < one.high_mpa
        assert other.low_mpa < one.youngs_modulus_mpa < other.high_mpa


def test_harder_dragon_skin_is_stiffer_and_within_gent_s_spread():
    moduli = [SILICONES[f"Dragon Skin {n}"].modulus.youngs_modulus_mpa for n in (10, 20, 30)]
    assert moduli == sorted(moduli)
    for hardness, modulus in zip((10, 20, 30), moduli, strict=True):
        assert modulus_from_shore(f"A{hardness}").admits(modulus)


def test_a_range_must_hold_the_modulus():
    assert silicone(youngs_modulus_range_mpa=[0.3, 0.5]).relative_spread == pytest.approx(
        (0.3 / 0.414, 0.5 / 0.414)
    )
    with pytest.raises(InputError, match=r"around youngs_modulus_mpa = 0.414; got \[0.5, 0.6\]"):
        silicone(youngs_modulus_range_mpa=[0.5, 0.6])


def test_specifications_with_equal_figures_are_equal():
    spec = parse_spec({"name": "cube", "silicone": {"modulus_from": "A30"}}, "test")
    assert spec_hash(parse_spec(spec.model_dump(mode="json"), "again")) == spec_hash(spec)
    assert spec_hash(ObjectSpec(name="cube", silicone=silicone())) == spec_hash(
        ObjectSpec(name="cube")
    )
