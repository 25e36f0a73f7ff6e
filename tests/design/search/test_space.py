"""A search's variables ↔ vector ↔ specification: symmetry, choices, what contradicts itself."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.search.places import polarities
from design.search.space import (
    Variable,
    middle_value,
    params_at,
    search_space,
    start_params,
    unit_of,
    with_layout,
)
from design.search.structure import with_structure
from design.spec_io import parse_spec


def specification(**search):
    return parse_spec({"name": "cube", "search": search}, "made up")


EVERYTHING = {
    "magnet_count": [4, 5],
    "magnet_sizes": ["D6x1", "D5x1"],
    "magnet_reach_mm": 13.0,
    "magnet_depth_mm": [2.0, 4.0],
    "magnet_tilt_deg": 10.0,
    "magnet_north": True,
    "sensor_count": [3, 4],
    "sensor_reach_mm": 9.0,
    "sensor_chip": ["inward", "outward"],
}


def test_vectors_and_values_are_inverse():
    space = search_space(specification(vary=EVERYTHING))
    for vector in np.random.default_rng(1).random((20, len(space.variables))):
        params = params_at(space, vector)
        again = params_at(space, unit_of(space, params))
        assert again.keys() == params.keys()
        for name, value in params.items():
            assert again[name] == (pytest.approx(value) if isinstance(value, float) else value)


def feasible(spec, seed=0, tries=4000):
    """A random layout that passes the specification's checks."""
    space = search_space(spec)
    rng = np.random.default_rng(seed)
    for _ in range(tries):
        params = params_at(space, rng.random(len(space.variables)))
        try:
            return params, with_layout(spec, params)
        except InputError:
            continue
    raise AssertionError("no layout fits")


def test_a_layout_is_a_specification_with_the_chosen_parts():
    spec = specification(vary=EVERYTHING)
    params, found = feasible(spec)
    assert len(found.magnets.positions_mm) == params["magnet_count"]
    assert found.magnets.part[0] == params["magnet1_size"]
    assert found.sensors.count_per_face == params["sensor_count"]
    assert found.sensors.chip == params["sensor_chip"]
    for k, (x, y, _) in enumerate(found.sensors.places[0], start=1):
        assert x == pytest.approx(params[f"sensor{k}_x_mm"], abs=0.0051)
        assert y == pytest.approx(params[f"sensor{k}_y_mm"], abs=0.0051)
    for k, place in enumerate(found.magnets.positions_mm):
        wanted = (params[f"magnet{k + 1}_x_mm"], params[f"magnet{k + 1}_y_mm"])
        assert_allclose(place, wanted, atol=0.0051)
        assert found.magnets.north[k] == params[f"magnet{k + 1}_north"]


SIZES = [f"magnet{k}_size" for k in range(1, 6)]
VARY = {
    k: EVERYTHING[k]
    for k in ("magnet_reach_mm", "magnet_depth_mm", "magnet_tilt_deg", "magnet_north")
}


def test_poles_leave_grades_as_they_are():
    magnets = {"positions_mm": [[8, 8], [-8, -8]], "north": ["outward", "inward"]}
    magnets |= {"grade": ["N35", "N52"]}
    content = {"name": "a", "magnets": magnets, "search": {"vary": {"magnet_north": True}}}
    spec = parse_spec(content, "made up")
    params = {"magnet1_north": "inward", "magnet2_north": "inward"}
    assert_allclose(polarities(spec, params), [-1.0, -1.45 / 1.20])
    assert with_layout(spec, params).magnets.grade == ("N35", "N52")


def test_another_magnet_in_the_core_leaves_the_boards_pockets_as_they_are():
    spec = specification(vary={"magnet_sizes": ["D6x1", "D8x2"]})
    reverse = spec.model_copy(update={"arrangement": "sensors-in-shell"})
    larger = with_structure(reverse, dict.fromkeys(SIZES, "D8x2"))
    assert larger.shell == spec.shell
    assert {size.diameter_mm for size in larger.magnets.sizes} == {8.0}


def test_a_larger_magnet_keeps_its_pockets_clearance_and_seal():
    spec = specification(vary={"magnet_sizes": ["D6x1", "D8x2"]})
    wide = with_structure(spec, dict.fromkeys(SIZES, "D8x2"))
    assert wide.shell.pocket_diameter_mm - wide.magnets.sizes[0].diameter_mm == pytest.approx(0.0)
    assert wide.shell.pocket_depth_mm - wide.magnets.sizes[0].height_mm == pytest.approx(2.0)


def test_the_start_is_a_point_of_its_own_space():
    vary = EVERYTHING | {"magnet_depth_mm": [2.0, 4.0]}
    spec = specification(vary=vary)
    start = start_params(search_space(spec))
    assert start is not None
    again = with_layout(spec, start)
    assert again.magnets.positions_mm == spec.magnets.positions_mm
    assert again.magnets.depths_mm == (2.5,) * 5
    assert again.silicone == spec.silicone
    assert_allclose(
        np.array(again.sensors.places[0])[:, :2],
        np.array(spec.sensors.places[0])[:, :2],
        atol=0.0051,
    )


@pytest.mark.parametrize(
    "search",
    [
        {"vary": {"magnet_reach_mm": 9.0}},
        {"vary": {"sensor_chip": ["outward"]}},
    ],
)
def test_a_space_without_the_start_says_so(search):
    assert start_params(search_space(specification(**search))) is None


WRONG = {
    "magnet_count needs": {"vary": {"magnet_count": [4, 5]}},
    "must rise": {"vary": {"magnet_depth_mm": [4.0, 2.0]}},
    "names one twice": {"objectives": ["worst_force_bound_n", "worst_force_bound_n"]},
}


@pytest.mark.parametrize("text", WRONG)
def test_contradictions_are_one_clear_error(text):
    with pytest.raises(InputError, match=text):
        search_space(specification(**WRONG[text]))


def test_parts_that_the_start_lacks_begin_in_the_middle():
    assert middle_value(Variable("a", low=2.0, high=5.0)) == 3.5
    assert middle_value(Variable("b", choices=(3, 1))) == 3


def test_more_or_fewer_magnets_take_no_list_of_grades():
    magnets = {"positions_mm": [[8, 8], [-8, -8]], "grade": ["N35", "N52"]}
    search = {"vary": {"magnet_count": [2, 3], "magnet_reach_mm": 12.0}}
    spec = parse_spec({"name": "a", "magnets": magnets, "search": search}, "made up")
    with pytest.raises(InputError, match="grade, remanence_t or sizes hold for as many"):
        search_space(spec)
