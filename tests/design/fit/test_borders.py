"""Refusals of what does not fit, on both sides of their border."""

import re

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.fit.everything import problems_of
from design.fit.parts import distance_mm, recess_outline
from design.spec.object import ObjectSpec
from design.spec_io import with_overrides

KEY = ["core.keys.size_mm=[2.0, 2.0, 1.0]"]
BASES = {
    "cube": [],
    "one magnet": ["magnets.positions_mm=[[0.0, 0.0]]"],
    "ring of 8.5 mm": ["sensors.radius_mm=8.5"],
    "keys": [*KEY, "core.keys.positions_mm=[[0.0, 12.0]]"],
    "key below a magnet": [*KEY, "core.keys.positions_mm=[[10.0, 10.0]]"],
    "slits": ["shell.slits.depth_mm=4.0"],
    "channels": [],
    "cuboid tip": ["indenter.kind=cuboid"],
    "thick shell": ["shell.thickness_mm=9.0", "core.recess_outer_radius_mm=9.0"],
    "sensors in the shell": [
        "arrangement=sensors-in-shell",
        "shell.pocket_depth_mm=4.0",
        "sensors.positions_mm=[[0.0, 0.0]]",
        "sensors.count_per_face=1",
        "magnets.positions_mm=[[6.0, 0.0]]",
    ],
    "ball": [
        "body.kind=sphere",
        "body.size_mm=[50.0, 50.0, 50.0]",
        "contact_grid.count=[3, 3]",
        "magnets.positions_mm=[[0.0, 0.0]]",
    ],
    "pad": ["body.kind=pad", "body.size_mm=[60.0, 80.0, 14.0]", "contact_grid.count=[3, 3]"],
    "dome": ["body.kind=dome", "body.size_mm=[60.0, 60.0, 36.0]", "contact_grid.count=[3, 3]"],
}
BORDERS = """
cube: core.wall_mm | 12.99 | 13.0 | larger than two core walls
cube: core.recess_depth_mm | 4.49 | 4.5 | recess_depth_mm must be below
cube: core.recess_outer_radius_mm | 12.99 | 13.0 | recess_outer_radius_mm < half
cube: core.recess_inner_radius_mm | 10.99 | 11.0 | recess_outer_radius_mm < half
cube: core.wire_hole_side_diameter_mm | 8.96 | 8.99 | they would touch in a line
cube: core.wire_hole_side_diameter_mm | 16.99 | 17.0 | below the core's cavity
cube: core.wire_hole_top_diameter_mm | 16.99 | 17.0 | below the core's cavity
cube: shell.pocket_depth_mm | 7.99 | 8.0 | pocket_depth_mm must be below
cube: shell.pocket_diameter_mm | 6.0 | 5.99 | must fit below the seal
cube: shell.pocket_diameter_mm | 6.0 | 5.99 | narrower than the magnets
cube: shell.pocket_diameter_mm | 6.0 | 5.99 | pocket 6 mm wide or more
cube: magnets.height_mm | 2.99 | 3.0 | pocket deeper than 3 mm
cube: shell.seal_layer_mm | 2.0 | 2.01 | sticking out of the first pour
cube: as_built.magnets | [{face=1,magnet=2,dent_mm=1.99}] | [{face=1,magnet=2,dent_mm=2.0}] | reaches
cube: magnets.height_mm | 2.99 | 3.0 | must fit below the seal
one magnet: magnets.depth_mm | 0.51 | 0.5 | does not seal the magnet
one magnet: magnets.depth_mm | 7.49 | 7.5 | does not seal the magnet
cube: magnets.positions_mm | [[17.9, 0.0]] | [[18.01, 0.0]] | outside the shell's face
cube: magnets.positions_mm | [[0.0, -17.9]] | [[0.0, -18.01]] | outside the shell's face
cube: magnets.positions_mm | [[0, 0], [6.01, 0]] | [[0, 0], [6.0, 0]] | touch or overlap
cube: magnets.positions_mm | [[14.99, 0]] | [[15.0, 0]] | zone of the neighbouring
cube: sensors.depth_below_core_face_mm | 3.0 | 3.01 | must not exceed core.recess_depth
cube: sensors.radius_mm | 12.99 | 13.0 | outside the core: it must be below 13
cube: sensors.radius_mm | 4.5 | 4.49 | must lie in the core's recess
cube: sensors.radius_mm | 11.0 | 11.01 | must lie in the core's recess
cube: sensors.positions_mm | [[10.58, 0.0]] | [[10.59, 0.0]] | outside the core's face
cube: sensors.positions_mm | [[0.0, -10.58]] | [[0.0, -10.59]] | outside the core's face
ring of 8.5 mm: sensors.positions_mm | [[10.49, 0.0]] | [[10.5, 0.0]] | outside the core's face
ring of 8.5 mm: sensors.positions_mm | [[0.0, 10.49]] | [[0.0, 10.5]] | outside the core's face
cube: press.depths_mm | [1.0, 4.8] | [1.0, 4.81] | below 60 % of shell
thick shell: press.depths_mm | [1.0, 4.99] | [1.0, 5.0] | below the indenter's height
cuboid tip: indenter.size_mm | [42.0, 10.0] | [42.01, 10.0] | larger than the face of 42 mm
cuboid tip: indenter.size_mm | [10.0, 42.0] | [10.0, 42.01] | larger than the face of 42 mm
cube: contact_grid.count | [14, 4] | [15, 4] | count\\[0\\] × pitch_mm, half a pitch
cube: contact_grid.count | [4, 14] | [4, 15] | count\\[1\\] × pitch_mm, half a pitch
keys: core.keys.positions_mm | [[11.99, 0.0]] | [[12.01, 0.0]] | past the core's patch
keys: core.keys.positions_mm | [[0.0, 11.99]] | [[0.0, 12.01]] | past the core's patch
keys: core.keys.positions_mm | [[0.0, 3.01]] | [[0.0, 2.99]] | over the wire hole
keys: core.keys.positions_mm | [[0, 12], [2.01, 12]] | [[0, 12], [1.99, 12]] | meets key 2
keys: core.keys.size_mm | [2.0, 2.0, 7.99] | [2.0, 2.0, 8.0] | size_mm must be below shell
key below a magnet: core.keys.size_mm | [2.0, 2.0, 4.99] | [2.0, 2.0, 5.0] | into the pocket
slits: shell.slits.depth_mm | 9.89 | 9.9 | of silicone over the core
slits: shell.slits.width_mm | 18.17 | 18.18 | leaves no slit
channels: core.wire_channel_mm | [2.0, 4.49] | [2.0, 4.5] | must be below core.wall_mm
cube: core.bay_mm | [18.39, 9.0, 9.0] | [18.41, 9.0, 9.0] | less than printer.wall_mm
cube: core.bay_mm | [9.0, 18.39, 9.0] | [9.0, 18.41, 9.0] | less than printer.wall_mm
cube: core.bay_mm | [9.0, 9.0, 22.19] | [9.0, 9.0, 22.21] | less than printer.wall_mm
sensors in the shell: shell.pocket_depth_mm | 1.61 | 1.6 | a sensor board of
sensors in the shell: magnets.height_mm | 4.49 | 4.5 | deep in a core wall of
sensors in the shell: magnets.positions_mm | [[5.01, 0.0]] | [[5.0, 0.0]] | meets the wire hole
ball: shell.pocket_depth_mm | 7.99 | 8.0 | does not lie within the 8 mm
ball: press.depths_mm | [1.0, 4.8] | [1.0, 4.81] | 60% of the silicone
ball: body.bore_mm | 33.99 | 34.0 | below the core's width, 34 mm
ball: sensors.depth_below_core_face_mm | 3.0 | 3.01 | must not exceed core.recess_depth
dome: core.recess_depth_mm | 5.99 | 6.0 | the rigid base is 6 mm thick
dome: shell.thickness_mm | 29.99 | 30.0 | below the dome's radius of 30 mm
pad: core.recess_depth_mm | 5.99 | 6.0 | the rigid base is 6 mm thick
pad: core.recess_outer_radius_mm | 49.99 | 50.0 | recess_outer_radius_mm < the reach
pad: core.recess_inner_radius_mm | 10.99 | 11.0 | recess_outer_radius_mm < the reach
pad: shell.pocket_depth_mm | 7.99 | 8.0 | does not lie within the 8 mm
pad: magnets.height_mm | 2.99 | 3.0 | Make shell.pocket_depth_mm more than 3
pad: magnets.depth_mm | 0.51 | 0.5 | stands 0 mm out of the curved face
pad: magnets.positions_mm | [[0, 0], [6.01, 0]] | [[0, 0], [6.0, 0]] | touch or overlap
pad: magnets.positions_mm | [[27.0, 0]] | [[27.01, 0]] | outside face 1
pad: sensors.positions_mm | [[30.0, 0]] | [[30.01, 0]] | outside the core's patch
pad: core.bay_mm | [58.39, 9.0, 1.0] | [58.41, 9.0, 1.0] | of the core's wall at its upper corners
"""
"""Object and key, a value that fits, one that does not, and what is said then alone."""


@pytest.mark.parametrize("row", BORDERS.strip().splitlines())
def test_it_fits_up_to_the_border_and_not_beyond(row):
    given, fits, refused, words = row.split(" | ")
    base, key = given.split(": ")

    def said(value):
        content = with_overrides({"name": "x"}, [*BASES[base], f"{key}={value}"])
        found = problems_of(ObjectSpec.model_validate(content))
        return [text for text in found if re.search(words, text)]

    assert not said(fits)
    assert said(refused)


@pytest.mark.parametrize(
    ("key", "placed", "fits", "refused", "words"),
    [
        (
            "magnets",
            {"size_mm": [3.0, 4.0]},
            [23.51, 0, 0],
            [23.5, 0, 0],
            "may reach",
        ),
        (
            "magnets",
            {"size_mm": [3.0, 4.0]},
            [0, 0, -23.51],
            [0, 0, -23.5],
            "may reach",
        ),
        (
            "magnets",
            {"size_mm": [3.0, 4.0]},
            [22.6, 23, 0],
            [22.4, 23, 0],
            "may reach",
        ),
        ("steel_plates", {"normal": [0, 0, 2.0]}, [0, 0, -21.0], [0, 0, -20.99], "into the steel"),
        ("steel_plates", {"normal": [-3.0, 0, 0]}, [21.0, 9, 0], [20.99, 9, 0], "into the steel"),
        ("steel_plates", {"normal": [1.0, 1, 0]}, [-42.0, 0, 0], [-41.99, 0, 0], "into the steel"),
    ],
)
def test_surroundings_stay_outside(key, placed, fits, refused, words):
    """Half edges of 21 mm; a magnet of Ø3 × 4 mm turns within 2.5 mm."""
    for position, told in ((fits, False), (refused, True)):
        content = {"name": "x", "environment": {key: [placed | {"position_mm": position}]}}
        found = problems_of(ObjectSpec.model_validate(content))
        assert [words in text for text in found] == [True] * told


def test_points_lie_so_far_from_a_polygon():
    oblong = np.array([[2.0, 1], [-2, 1], [-2, -1], [2, -1]])
    for point, away in (
        ([0, 0], 0),
        ([2, 1], 0),
        ([3, 0], 1),
        ([0, -3], 2),
        ([5, 5], 5),
        ([-5, -5], 5),
    ):
        assert distance_mm(oblong, np.array(point, float)) == pytest.approx(away)


def test_recesses_turn_and_move_with_their_sensors():
    spec = ObjectSpec(name="x")
    at_0, at_90 = (
        recess_outline(spec, *place) for place in ((9.585, 0.0, 0.0), (0.0, 8.585, np.pi / 2))
    )
    assert_allclose([at_0.min(axis=0), at_0.max(axis=0)], [[5.5, -3.5], [12.0, 3.5]], atol=1e-9)
    assert_allclose([at_90.min(axis=0), at_90.max(axis=0)], [[-3.5, 4.5], [3.5, 11.0]], atol=1e-9)
