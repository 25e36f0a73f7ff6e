"""Magnets as they are written: parts, grades, shapes and lists that agree, on both sides of each border."""

import pytest

from design.errors import SpecError
from design.spec.magnets import MagnetSpec
from design.spec_io import parse_spec

TWO = ((0.0, 0.0), (9.0, 0.0))


def refused(message, **keys):
    with pytest.raises(SpecError, match=message):
        MagnetSpec(**keys)


def test_a_hole_belongs_to_rings_and_is_smaller_than_they_are():
    for hollow in ({"shape": "ring"},):
        assert MagnetSpec(inner_diameter_mm=5.99, **hollow).inner_diameter_mm == 5.99
        refused("must be below magnets.diameter_mm = 6; got 6", inner_diameter_mm=6.0, **hollow)
    refused("needs magnets.inner_diameter_mm above 0", shape="ring")
    for solid in ({}, {"shape": "block"}):
        refused("belongs to a ring", inner_diameter_mm=2.0, **solid)


def test_a_part_and_a_grade_fill_in_what_is_not_given():
    part = MagnetSpec(part="R8x4x2")
    assert (part.shape, part.diameter_mm, part.inner_diameter_mm, part.height_mm) == (
        "ring",
        8,
        4,
        2,
    )
    assert (part.remanence_t, part.grade) == (1.43, None)
    sold = MagnetSpec(part="MP 12x5x2 / N38")
    assert (sold.grade, sold.remanence_t) == ("N38", 1.24)
    assert MagnetSpec(part="MP 12x5x2 / N38", remanence_t=1.1).grade is None
    assert MagnetSpec(grade="N52").remanence_t == 1.45
    refused("height_mm = 1.0 contradicts magnets.part = 'R8x4x2'", part="R8x4x2", height_mm=1.0)


@pytest.mark.parametrize(
    ("key", "each", "wrong"),
    [
        ("depth_mm", (2.0, 3.0), (2.0,)),
        ("tilt_deg", ((0.0, 1.0), (2.0, 3.0)), ((0.0, 1.0),) * 3),
        ("north", ("inward", "outward"), ("inward",)),
    ],
)
def test_lists_have_one_entry_for_each_magnet(key, each, wrong):
    assert getattr(MagnetSpec(positions_mm=TWO, **{key: each}), key) == each
    refused(f"{key} needs one entry for each of the 2", positions_mm=TWO, **{key: wrong})


def test_places_are_of_all_faces_or_of_each():
    one = MagnetSpec(positions_mm=TWO)
    assert (one.count, one.lists, one.polarities) == (2, (TWO,), (1, 1))
    assert MagnetSpec(positions_mm=TWO, north=("inward", "outward")).polarities == (-1, 1)
    each = MagnetSpec(positions_mm=(TWO, ((1.0, 1.0), (2.0, 2.0))))
    assert (each.count, len(each.lists)) == (2, 2)
    refused("as many places on every face", positions_mm=(TWO, ((1.0, 1.0),)))
    assert MagnetSpec().depths_mm == ()
    assert MagnetSpec(positions_mm=TWO, depth_mm=2.5).depths_mm == (2.5, 2.5)
    assert MagnetSpec(positions_mm=TWO, depth_mm=(2.5, 3.0)).depths_mm == (2.5, 3.0)


def test_a_grade_holds_within_its_remanence():
    assert MagnetSpec(grade="N52", remanence_t=1.48).grade == "N52"
    refused("lies outside grade N52", grade="N52", remanence_t=1.49)


@pytest.mark.parametrize(
    ("places", "where"),
    [
        ([[float("nan"), 0]], r"magnets\.positions_mm\.0\.0: "),
        ([[[0, 0]], [[1, "a"]]], r"magnets\.positions_mm\.1\.0\.1: "),
        ([], r"magnets\.positions_mm: "),
    ],
)
def test_wrong_places_are_named_by_keys_and_numbers_alone(places, where):
    """Not by which of the two forms of the list was taken."""
    with pytest.raises(SpecError, match=f"- {where}"):
        parse_spec({"name": "a", "magnets": {"positions_mm": places}}, "a.toml")
