"""Spaces of searches and layouts in them, of every symmetry: a page that a person can judge."""

import numpy as np
import pytest

from design.search.places import magnet_maps, polarities, sensor_maps
from design.search.space import params_at, search_space, unit_of, with_layout
from design.search.structure import with_structure
from design.spec.object import ObjectSpec
from tests.support.physics_pages import assert_page

VARY = {
    "magnet_reach_mm": 9.0,
    "magnet_depth_mm": [2.2, 3.4],
    "magnet_tilt_deg": 6.0,
    "magnet_north": True,
    "sensor_reach_mm": 9.5,
}
CASES = {
    "free": {"vary": VARY},
    "per face": {"vary": {"layouts": "per face", "magnet_reach_mm": 30.0, "sensor_reach_mm": 5.0}},
    "counts": {
        "vary": {
            "magnet_reach_mm": 8.0,
            "magnet_count": [2, 5],
            "sensor_count": [1, 2],
            "sensor_reach_mm": 6.0,
        }
    },
    "parts": {
        "vary": {
            "magnet_sizes": ["D4x2", "D5x1.5"],
            "sensor_chip": ["inward", "outward"],
        }
    },
}
BODIES = {"per face": {"size_mm": [42.0, 50.0, 60.0], "sensed_faces": [1, 3]}}


def spec_of(name):
    places = [[0, 0], [9, 9], [-9, 9], [-9, -9], [9, -9]][:2]
    magnets = {"positions_mm": places, "part": "D6x1"}
    body = BODIES.get(name, {"size_mm": [42.0] * 3})
    return ObjectSpec.model_validate(
        {"name": "x", "body": body, "magnets": magnets, "search": CASES[name]}
    )


def of_space(name):
    space = search_space(spec_of(name))
    variables = ", ".join(f"{v.name} {v.low:g} to {v.high:g}" for v in space.variables)
    yield name, variables
    unit = np.random.default_rng(3).uniform(0.3, 0.7, len(space.variables))
    params = params_at(space, unit)
    structured = with_structure(space.spec, params)
    values = np.array([params[key] for key in space.continuous_names], float)
    magnets = magnet_maps(structured, space.continuous_names)
    yield (
        f"{name}: magnets (mm, °)",
        np.concatenate([np.ravel(one.places_at(values)) for one in magnets]),
    )
    if space.spec.search.vary.sensor_reach_mm:
        sensors = sensor_maps(structured, space.continuous_names)
        yield (
            f"{name}: sensors (mm)",
            np.concatenate([np.ravel(one.places_at(values)) for one in sensors]),
        )
    yield f"{name}: poles", polarities(structured, params)


def of_structure(pick):
    spec = spec_of("parts")
    params = {variable.name: variable.choices[pick] for variable in search_space(spec).variables}
    chosen = with_structure(spec, params)
    magnets, shell, sensors = chosen.magnets, chosen.shell, chosen.sensors
    yield (
        f"parts, choice {pick}: magnet, pocket, shell, body (mm), counts a mT, modulus (MPa)",
        [
            magnets.sizes[0].diameter_mm,
            magnets.sizes[0].inner_diameter_mm,
            magnets.sizes[0].height_mm,
            shell.pocket_diameter_mm,
            shell.pocket_depth_mm,
            shell.thickness_mm,
            *chosen.body.size_mm,
            sensors.depth_below_core_face_mm,
            sensors.counts_per_mt,
            chosen.silicone.youngs_modulus_mpa,
        ],
    )


def test_the_page_of_search_spaces():
    spaces = [line for name in CASES for line in of_space(name)]
    assert_page("design/search", [*spaces, *of_structure(0), *of_structure(1)])


@pytest.mark.parametrize("name", CASES)
def test_params_go_to_the_unit_cube_and_back(name):
    space = search_space(spec_of(name))
    unit = np.random.default_rng(3).uniform(0.3, 0.7, len(space.variables))
    params = params_at(space, unit)
    back = params_at(space, unit_of(space, params))
    assert {k: v for k, v in back.items() if isinstance(v, float)} == pytest.approx(
        {k: v for k, v in params.items() if isinstance(v, float)}
    )


def test_a_layout_of_a_space_is_written_into_the_specification():
    """Rounded to 0.01 mm and 0.1°."""
    space = search_space(spec_of("free"))
    params = params_at(space, np.full(len(space.variables), 0.5))
    wanted = {
        "magnet1_x_mm": 5.0049, "magnet1_tilt_y_deg": 2.04, "magnet2_x_mm": -6.0, "magnet2_depth_mm": 2.996,
        "sensor1_y_mm": 8.604, "sensor2_x_mm": -7.4, "sensor2_y_mm": -4.3, "sensor3_x_mm": 7.4,
        "sensor3_y_mm": -4.3, "magnet2_north": "inward", "magnet1_north": "outward",
    }  # fmt: skip
    found = with_layout(space.spec, params | wanted)
    assert found.magnets.positions_mm == ((5.0, 0.0), (-6.0, 0.0))
    assert found.magnets.depth_mm == (2.8, 3.0)
    assert found.magnets.tilt_deg == ((0.0, 2.0), (0.0, 0.0))
    assert found.magnets.north == ("outward", "inward")
    assert found.sensors.positions_mm[0] == ((0.0, 8.6), (-7.4, -4.3), (7.4, -4.3))
