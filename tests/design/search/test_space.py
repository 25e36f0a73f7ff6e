"""A search's variables ↔ vector ↔ specification: symmetry, choices, what contradicts itself."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.search.space import (
    Variable,
    _middle,
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
    "magnet_part": ["D6x1", "D5x1"],
    "magnet_reach_mm": 13.0,
    "magnet_depth_mm": [2.0, 4.0],
    "magnet_tilt_deg": 10.0,
    "magnet_north": True,
    "sensor_count": [3, 4],
    "sensor_reach_mm": 9.0,
    "sensor_chip": ["inward", "outward"],
    "sensor_turn_deg": [0.0, 30.0],
    "sensor_range_mt": [40.0, 80.0],
    "shell_thickness_mm": [8.0, 9.0],
    "silicone": ["Platsil Gel-10", "Ecoflex 00-30"],
    "core_size_mm": [26.0, 28.0],
}
SYMMETRIES = ("free", "mirrored", "four-fold")


@pytest.mark.parametrize("symmetry", SYMMETRIES)
def test_vectors_and_values_are_inverse(symmetry):
    space = search_space(specification(vary=EVERYTHING, magnet_symmetry=symmetry))
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


def test_a_ring_of_the_fewest_sensors_turns_as_far_as_to_its_like():
    space = search_space(specification(vary=EVERYTHING, sensor_symmetry="ring"))
    azimuth = next(v for v in space.variables if v.name == "sensor_azimuth_deg")
    assert (azimuth.low, azimuth.high) == (0.0, 120.0)


def test_a_layout_is_a_specification_with_the_chosen_parts():
    spec = specification(vary=EVERYTHING, sensor_symmetry="ring")
    params, found = feasible(spec)
    assert len(found.magnets.positions_mm) == params["magnet_count"]
    assert found.magnets.part == params["magnet_part"]
    assert found.sensors.count_per_face == params["sensor_count"]
    assert found.silicone.name == params["silicone"]
    assert found.sensors.range_mt == params["sensor_range_mt"]
    assert found.sensors.counts_per_mt == pytest.approx(820.0 * 40 / params["sensor_range_mt"])
    assert found.sensors.mount_rotation_deg[2] == params["sensor_turn_deg"]
    assert_allclose(found.core_size_mm, params["core_size_mm"], atol=1e-9)
    assert found.shell.thickness_mm == params["shell_thickness_mm"]
    x, y = np.array(found.sensors.places[0])[:, :2].T
    assert_allclose(np.hypot(x, y), params["sensor_radius_mm"], atol=0.01)
    for k, place in enumerate(found.magnets.positions_mm):
        wanted = (params[f"magnet{k + 1}_x_mm"], params[f"magnet{k + 1}_y_mm"])
        assert_allclose(place, wanted, atol=0.0051)
        assert found.magnets.north[k] == params[f"magnet{k + 1}_north"]


def axes_of(spec):
    """Centre and north of every magnet of face 1."""
    from design.layout.places.positions import magnet_layout

    layout = magnet_layout(spec)
    own = layout.face == 1
    return layout.centre_mm[own], layout.axis[own]


MIRROR = np.diag([-1.0, 1.0, 1.0])
QUARTER = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def is_mapped_onto_itself(spec, matrix):
    centre, axis = axes_of(spec)
    moved = np.hstack([centre @ matrix.T, axis @ matrix.T])
    both = np.hstack([centre, axis])
    return all(np.abs(both - row).max(axis=1).min() < 1e-9 for row in moved)


VARY = {
    k: EVERYTHING[k]
    for k in ("magnet_reach_mm", "magnet_depth_mm", "magnet_tilt_deg", "magnet_north")
}


@pytest.mark.parametrize(("symmetry", "matrix"), [("mirrored", MIRROR), ("four-fold", QUARTER)])
def test_symmetric_layouts_are_symmetric_and_others_are_not(symmetry, matrix):
    spec = specification(vary=VARY, magnet_symmetry=symmetry)
    _, found = feasible(spec)
    assert is_mapped_onto_itself(found, matrix)
    _, free = feasible(specification(vary=VARY))
    assert not is_mapped_onto_itself(free, matrix)
    tilted = list(found.magnets.tilt_deg)
    tilted[0] = (-tilted[0][0], tilted[0][1])
    wrong = found.model_copy(
        update={"magnets": found.magnets.model_copy(update={"tilt_deg": tuple(tilted)})}
    )
    assert not is_mapped_onto_itself(wrong, matrix)


def test_a_larger_magnet_keeps_its_pockets_clearance_and_seal():
    spec = specification(vary={"magnet_part": ["D6x1", "D8x2"]})
    wide = with_structure(spec, {"magnet_part": "D8x2"})
    assert wide.shell.pocket_diameter_mm - wide.magnets.diameter_mm == pytest.approx(0.0)
    assert wide.shell.pocket_depth_mm - wide.magnets.height_mm == pytest.approx(2.0)


def test_a_thicker_shell_keeps_the_core():
    spec = specification(vary={"shell_thickness_mm": [8.0, 9.5]})
    thick = with_layout(spec, {"shell_thickness_mm": 9.5})
    assert thick.core_size_mm == pytest.approx(spec.core_size_mm)
    assert thick.body.size_mm == pytest.approx((45.0, 45.0, 45.0))


def test_the_start_is_a_point_of_its_own_space():
    vary = EVERYTHING | {"core_size_mm": [26.0, 28.0], "magnet_depth_mm": [2.0, 4.0]}
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
        {"vary": {"shell_thickness_mm": [9.0, 10.0]}},
        {"vary": {"magnet_reach_mm": 13.0}, "magnet_symmetry": "mirrored"},
    ],
)
def test_a_space_without_the_start_says_so(search):
    assert start_params(search_space(specification(**search))) is None


WRONG = {
    "nothing may change": {},
    "four-fold": {
        "vary": {"magnet_reach_mm": 13.0, "magnet_count": [6]},
        "magnet_symmetry": "four-fold",
    },
    "block": {"vary": {"magnet_part": ["B5x5x1"]}},
    "not a known part": {"vary": {"magnet_part": ["D99x1"]}},
    "magnet_count needs": {"vary": {"magnet_count": [4, 5]}},
    "must rise": {"vary": {"magnet_depth_mm": [4.0, 2.0]}},
    "takes a single objective": {
        "engine": "cma-es",
        "objectives": ["worst_position_bound_mm", "worst_force_bound_n"],
    },
    "names one twice": {"objectives": ["cost", "cost"]},
    "more leaders": {"leaders": 1, "finalists": 2},
    "arranges sensors anew": {"sensor_symmetry": "ring"},
}


@pytest.mark.parametrize("text", WRONG)
def test_contradictions_are_one_clear_error(text):
    with pytest.raises(InputError, match=text):
        search_space(specification(**WRONG[text]))


def test_parts_that_the_start_lacks_begin_in_the_middle():
    assert _middle(Variable("a", low=2.0, high=5.0)) == 3.5
    assert _middle(Variable("b", choices=(3, 1))) == 3
