"""Words of the press rig that hold several figures, and what is refused of them."""

import pytest

from design.errors import InputError
from instobj.bench.rig.plan_options import PLAN_KEYS, plan_choices, port_and_scale
from tests.support.cli import CUBE, assert_one_clear_error, run


def test_a_plan_is_taken_key_by_key():
    words = ["depths_mm=1,2.5", "strokes=9", "speed_mm_s=0.05", "presses=40", "reference_every=0"]
    assert plan_choices(words) == {
        "settings": (("depths_mm", (1.0, 2.5)), ("strokes", 9), ("speed_mm_s", 0.05)),
        "presses": 40,
        "reference_every": 0,
    }
    assert plan_choices([]) == {"settings": ()}


@pytest.mark.parametrize(
    ("word", "told"),
    [
        ("depth=1", "'depth' is no part of a plan.*depths_mm"),
        ("strokes=2.5", "whole number of 1 or more"),
        ("strokes=1,2", "takes one number"),
        ("speed_mm_s=0.04", "0.05 or more"),
        ("dwell_s=-1", "0 or more"),
        ("full_n", "''.*number"),
        ("repeats=0", "1 or more"),
    ],
)
def test_a_word_that_is_no_part_of_a_plan_is_refused(word, told):
    with pytest.raises(InputError, match=told):
        plan_choices([word])


@pytest.mark.parametrize("name", sorted(PLAN_KEYS))
@pytest.mark.parametrize("number", ["nan", "inf", "-inf"])
def test_no_part_of_a_plan_is_endless_or_no_number(name, number):
    """Each passes comparisons with bounds, or none."""
    with pytest.raises(InputError, match="or more"):
        plan_choices([f"{name}={number}"])


def test_a_load_cell_s_port_has_its_newtons_per_unit_behind_it():
    assert port_and_scale(None) == (None, None)
    assert port_and_scale("/dev/ttyUSB1") == ("/dev/ttyUSB1", None)
    assert port_and_scale("/dev/ttyUSB1=-9.8e-3") == ("/dev/ttyUSB1", -9.8e-3)
    for wrong in ("x=0", "x=", "x=nan", "x=grams"):
        with pytest.raises(InputError, match="newtons per unit"):
            port_and_scale(wrong)


@pytest.mark.parametrize(
    "middle", ["1,2", "1,2,3,4,5", "nan,-100,-42", "-150,-100,-42,inf", "a,b,c"]
)
def test_a_middle_that_is_no_place_is_refused(middle, tmp_path):
    """No number at all would pass every comparison with the machine's travel."""
    words = ("bench", "rig", CUBE, "--face", 3, "--middle", middle)
    assert_one_clear_error(run(*words, cwd=tmp_path), "is not X,Y,Z[,TURN]")
