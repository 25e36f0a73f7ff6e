"""Spaces of searches, and layouts in them, on record: names, ranges and places of every symmetry."""

import numpy as np
import pytest

from design.search.places import magnet_maps, polarities, sensor_maps
from design.search.space import params_at, search_space, start_params, unit_of, with_layout
from design.search.structure import STRUCTURE, structure_choices, with_structure
from design.spec.object import ObjectSpec
from tests.support.recorded_facts import assert_on_record, told

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
            "magnet_part": ["D4x2", "MP 12x5x2 / N38"],
            "shell_thickness_mm": [8.0, 9.5],
            "silicone": ["Ecoflex 00-30", "Dragon Skin 20"],
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


@pytest.mark.parametrize("name", CASES)
def test_a_space_is_as_on_record(name):
    space = search_space(spec_of(name))
    lines = [
        f"{v.name}: {v.low:g} to {v.high:g}{f', {list(v.choices)}' if v.choices else ''}"
        for v in space.variables
    ]
    start = start_params(space)
    lines.append(f"start: {start}")
    unit = np.random.default_rng(3).uniform(0.3, 0.7, len(space.variables))
    params = params_at(space, unit)
    structured = with_structure(space.spec, params)
    values = np.array([params[key] for key in space.continuous_names], float)
    for key, maps in (("magnets", magnet_maps), ("sensors", sensor_maps)):
        if key == "magnets" or space.spec.search.vary.sensor_reach_mm:
            lines += [told(key, one.at(values)) for one in maps(structured, space.continuous_names)]
    lines.append(told("poles", polarities(structured, params)))
    assert_on_record("search", name, lines)
    back = params_at(space, unit_of(space, params))
    assert {k: v for k, v in back.items() if isinstance(v, float)} == pytest.approx(
        {k: v for k, v in params.items() if isinstance(v, float)}
    )


@pytest.mark.parametrize("pick", [0, 1])
def test_structures_take_their_choices(pick):
    spec = spec_of("parts")
    params = {
        key: getattr(spec.search.vary, key)[pick]
        for key in STRUCTURE
        if getattr(spec.search.vary, key)
    }
    found = with_structure(spec, params)
    chosen = structure_choices(found)
    magnets, shell = found.magnets, found.shell
    lines = [
        f"choices: {chosen}",
        told(
            "magnet",
            [
                magnets.diameter_mm,
                magnets.inner_diameter_mm,
                magnets.height_mm,
                magnets.remanence_t,
            ],
        ),
        told(
            "shell",
            [
                shell.thickness_mm,
                shell.pocket_diameter_mm,
                shell.pocket_depth_mm,
                *found.body.size_mm,
            ],
        ),
        told(
            "sensors",
            [
                found.sensors.depth_below_core_face_mm,
                found.sensors.counts_per_mt,
                *found.sensors.noise_counts,
            ],
        ),
        told("silicone", [found.silicone.youngs_modulus_mpa, found.silicone.density_g_per_cm3]),
    ]
    assert_on_record("search", f"parts, choice {pick}", lines)


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
