"""Locations, tips and parts as built of objects off their symmetries: a page that can be judged."""

import numpy as np
import pytest

from design.layout.dents import dents_mm, sunk_mm
from design.layout.places.contact_grid import contact_grid, grid_places_in_lattice, press_lattice
from design.layout.places.contact_places import (
    contact_places,
    outermost_mm,
    pressed_nodes,
    shared_counts,
    touched_reach_mm,
)
from design.layout.places.coverage import cell_areas_mm2
from design.layout.places.measures import place_measures
from design.layout.places.positions import (
    chip_on_board,
    live_channels,
    magnet_layout,
    mounted_stack,
    sensor_layout,
    slipped,
)
from design.layout.tips import (
    footprint_mm,
    path_mm,
    tip_heights_mm,
    tip_places_mm,
    tip_shape,
    tips_overlap,
)
from design.spec.mechanics import IndenterSpec, SlipSpec
from design.spec.object import ObjectSpec
from tests.support.objects.worked_objects import OBJECTS, WORKED_TIPS, worked
from tests.support.physics_pages import assert_page

FILLED = {
    "box": {"pitch_mm": 3.3},
    "pad": {"pitch_mm": 4.1},
    "closed cylinder": {"pitch_mm": 5.2},
    "dome": {"pitch_mm": 3.7},
}
TIPS = {
    "hemisphere": {"radius_mm": 3.5, "tip_count": 2, "turn_deg": (30.0, 0.0, 0.0)},
    "flat": WORKED_TIPS["flat"],
    "cuboid": WORKED_TIPS["cuboid"],
    "rounded cuboid": {"kind": "cuboid", "size_mm": [6.0, 4.0], "fillet_mm": 1.0},
    "cylinder": WORKED_TIPS["cylinder"],
    "stl": WORKED_TIPS["stl"] | {"direction_deg": [10.0, -20.0]},
}
AS_BUILT = {
    "magnets": [
        {"face": 2, "magnet": 1, "centre_mm": [3.1, -5.8, -2.4], "axis": [0.1, -0.2, 2.0]},
        {"face": 3, "magnet": 2, "flipped": True, "remanence_t": 1.2, "dent_mm": 0.7},
    ],
    "sensors": [
        {"face": 2, "sensor": 2, "position_mm": [-2.1, 4.8, -2.0], "rotation_deg": [2, -5, 20]},
        {"face": 4, "sensor": 1, "dead": ["X", "Z"]},
    ],
}


def of_locations(name):
    base = worked(name)
    spec = base.changed(contact_grid=base.contact_grid.changed(count="fill", **FILLED[name]))
    grid, lattice = contact_grid(spec), press_lattice(spec)
    measures = place_measures(spec)
    yield (
        f"{name}: grid, lattice, shared; pressed; outermost, reach (mm)",
        [
            *grid.shape,
            *lattice.shape,
            *shared_counts(spec),
            float(np.sum(contact_places(spec))),
            float(np.sum(pressed_nodes(spec))),
            float(np.sum(grid_places_in_lattice(spec))),
            *outermost_mm(spec),
            touched_reach_mm(spec),
        ],
    )
    yield f"{name}: cells (mm²)", cell_areas_mm2(spec)
    every = [np.ravel(value) for value in vars(measures).values()]
    yield f"{name}: distances to border, magnet and along the path (mm)", np.concatenate(every)


def of_tip(name):
    indenter = IndenterSpec.model_validate(TIPS[name])
    across = np.linspace(-3.2, 3.4, 9)
    lines = np.stack(np.meshgrid(across, across, indexing="ij"), axis=-1).reshape(-1, 2)
    yield f"tip, {name}: heights (mm)", tip_heights_mm(tip_shape(indenter), lines)
    yield (
        f"tip, {name}: footprint, places, path (mm)",
        [
            *np.ravel(footprint_mm(indenter)),
            *np.ravel(tip_places_mm(indenter)),
            *np.ravel(path_mm(indenter, [1.0, 3.0])),
        ],
    )


def of_built(name):
    spec = ObjectSpec.model_validate(OBJECTS[name] | {"as_built": AS_BUILT})
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    slip = SlipSpec(shift_mm=(0.3, -0.2, 0.5), rotation_deg=(2.0, -3.0, 5.0))
    moved, turned = slipped(magnets, slip), slipped(sensors, slip)
    built = [magnets.axis, magnets.side, sensors.axes.reshape(-1, 3)]
    yield (
        f"{name}, as built: magnets and sensors (mm)",
        np.vstack([magnets.centre_mm, sensors.position_mm]),
    )
    yield f"{name}, as built: their axes", np.vstack(built)
    yield f"{name}, slipped (mm)", np.vstack([moved.centre_mm, turned.position_mm])
    across = np.linspace(-9.0, 9.0, 25)
    lattice = np.stack(np.meshgrid(across, across, indexing="ij"), axis=-1).reshape(-1, 2)
    sunk = [sunk_mm(spec, face, lattice) for face in spec.body.sensed[1:3]]
    yield f"{name}, dented (mm)", np.array(sunk)
    yield (
        f"{name}: live channels, strength, dents (mm)",
        [
            float(np.sum(live_channels(spec))),
            float(np.sum(magnets.strength)),
            float(np.sum(dents_mm(spec))),
        ],
    )


def test_the_page_of_places():
    locations = [line for name in FILLED for line in of_locations(name)]
    tips = [line for name in TIPS for line in of_tip(name)]
    assert_page("design/places", [*locations, *tips, *of_built("box")])


@pytest.mark.parametrize(
    ("size", "way", "apart_mm"), [((6.0, 4.0), (1.0, 0.0), 6.0), ((6.0, 4.0), (0.0, -1.0), 4.0)]
)
def test_tips_overlap_up_to_their_width(size, way, apart_mm):
    tip = IndenterSpec(kind="cuboid", size_mm=size)
    for change, meet in ((-0.01, True), (0.01, False)):
        assert tips_overlap(tip, (apart_mm + change) * np.array(way)) == meet


def test_boards_and_chips_either_way_up():
    """By hand: recess of 2.5 to 6.5 mm, 2.6 mm deep, about sensors at 4.8; board 1.2, chip 0.9 mm."""
    spec = worked("box")
    place = (4.2, 1.5, np.arctan2(1.5, 4.2))
    radial = np.array([4.2, 1.5]) / np.hypot(4.2, 1.5)
    for chip, board_top, chip_top in (("inward", 0.0, -1.2), ("outward", -1.4, -0.5)):
        turned = spec.changed(sensors=spec.sensors.changed(chip=chip))
        stack = mounted_stack(turned, place)
        np.testing.assert_allclose(stack.board_xy_mm, [4.2, 1.5] - 0.3 * radial)
        np.testing.assert_allclose([stack.board_top_mm, stack.chip_top_mm], [board_top, chip_top])
        signs = np.diag(chip_on_board(turned.sensors))
        np.testing.assert_allclose(signs, [1, 1, 1] if chip == "inward" else [-1, 1, -1])
