"""Sizes of single magnets in a search: variables, layouts, mechanics that are needed, bad input."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.pockets import shell_pockets
from design.search.space import (
    params_at,
    search_space,
    start_params,
    structure_of,
    unit_of,
    with_layout,
)
from design.search.structure import searched_size_variants, size_variants, with_structure
from design.spec_io import parse_spec

PARTS = ["D6x1", "D4x2", "D5x1.5"]
SHELL = {"pocket_diameter_mm": 6.3, "pocket_depth_mm": 3.0}


def specification(vary=None, magnets=None, **search):
    vary = {"magnet_sizes": PARTS} | (vary or {})
    content = {"name": "cube", "shell": SHELL, "search": {"vary": vary} | search}
    return parse_spec(content | {"magnets": magnets or {}}, "made up")


def test_every_magnet_has_its_own_size():
    spec = specification({"magnet_reach_mm": 12.0})
    space = search_space(spec)
    names = [v.name for v in space.variables if v.choices]
    params = dict.fromkeys(names, "D6x1")
    for magnet, name in enumerate(names):
        structured = with_structure(spec, params | {name: "D4x2"})
        small = [k for k, size in enumerate(structured.magnets.sizes) if size.height_mm == 2.0]
        assert small == [magnet]


def test_a_layout_keeps_clearance_and_the_silicone_over_its_tallest_magnet():
    spec = specification()
    params = {f"magnet{k + 1}_size": part for k, part in enumerate([*PARTS, "D4x2", "D4x2"])}
    found = with_layout(spec, params)
    assert found.magnets.part == (*PARTS, "D4x2", "D4x2")
    widths = [2 * pocket.outline.half_mm[0] for pocket in shell_pockets(found)[0]]
    assert_allclose(widths, [6.3, 4.3, 5.3, 4.3, 4.3])
    assert found.shell.pocket_depth_mm == 4.0
    narrow = with_layout(spec, dict.fromkeys(params, "D4x2"))
    assert narrow.shell.pocket_diameter_mm == 4.3
    assert len(narrow.magnets.distinct_sizes) == 1


def test_mechanics_of_all_trials_are_those_of_the_named_sizes():
    """One shell and outline each, whatever else a trial chooses."""
    spec = specification({"magnet_count": [4, 6], "magnet_reach_mm": 12.0})
    space, known = search_space(spec), searched_size_variants(spec)
    shells = {one.magnets.sizes[0]: one.shell.pocket_diameter_mm for one in known}
    assert [one.diameter_mm for one in shells] == [6.0, 4.0, 5.0]
    for unit in np.random.default_rng(2).random((20, len(space.variables))):
        structured = with_structure(spec, params_at(space, unit))
        for one in size_variants(structured):
            assert len(one.magnets.distinct_sizes) == 1
            assert shells[one.magnets.sizes[0]] == one.shell.pocket_diameter_mm


def test_trials_of_other_sizes_are_of_other_structures():
    space = search_space(specification({"magnet_reach_mm": 12.0}))
    params = params_at(space, np.zeros(len(space.variables)))
    assert structure_of(space, params) != structure_of(space, params | {"magnet3_size": "D4x2"})
    assert structure_of(space, params) == structure_of(space, params | {"magnet3_x_mm": 1.0})
    again = params_at(space, unit_of(space, params | {"magnet3_size": "D5x1.5"}))
    assert again["magnet3_size"] == "D5x1.5"


@pytest.mark.parametrize(
    ("magnets", "holds"),
    [
        ({}, True),
        ({"part": ["D6x1", "D4x2", "D4x2", "D5x1.5", "D6x1"]}, True),
        ({"diameter_mm": [6, 4, 4, 5, 6], "height_mm": [1, 2, 2, 1.5, 1]}, True),
        ({"part": "D5x2"}, False),
        ({"diameter_mm": 5.9}, False),
    ],
)
def test_the_start_is_a_layout_where_its_sizes_are_choices(magnets, holds):
    spec = specification(magnets=magnets)
    start = start_params(search_space(spec))
    assert (start is not None) == holds
    if start is not None:
        assert with_layout(spec, start).magnets.sizes == spec.magnets.sizes


WRONG = {
    r"takes round magnets only; got \['B5x5x1'\]": {"vary": {"magnet_sizes": ["B5x5x1"]}},
    "must be of one shape": {"vary": {"magnet_sizes": ["D6x1", "R6x2x2"]}},
    "sold in all grades; got": {"vary": {"magnet_sizes": ["MP 12x5x2 / N38"]}},
    "'D99x1' is not in the catalogue": {"vary": {"magnet_sizes": ["D6x1", "D99x1"]}},
    "or sizes hold for as many as there were": {
        "vary": {"magnet_count": [4], "magnet_reach_mm": 9.0},
        "magnets": {"height_mm": [1, 2, 1, 1, 1]},
    },
}


@pytest.mark.parametrize("text", WRONG)
def test_bad_sizes_are_one_clear_error(text):
    with pytest.raises(InputError, match=text):
        search_space(specification(**WRONG[text]))
