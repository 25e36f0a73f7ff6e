"""Core of a closed body in two parts round a bay: they close it, come apart, and hold what was drawn."""

import re
from copy import deepcopy

import numpy as np
import pytest

from design.build.parts import parts_of
from design.fit.everything import problems_of
from design.layout.boards import LID_RIM_MM, bay_block
from design.solids.booleans import common, volume_mm3
from design.solids.core import make_core, make_core_base, make_core_lid
from design.solids.primitives import box_between
from design.spec.object import ObjectSpec
from design.spec_io import with_overrides
from tests.support.objects.worked_objects import OBJECTS

BAYS = {"closed box": [18, 16, 20], "closed cylinder": [8, 9, 10]}


def with_bay(name, bay_mm):
    return ObjectSpec.model_validate(
        with_overrides(deepcopy(OBJECTS[name]), [f"core.bay_mm={bay_mm}"])
    )


@pytest.fixture(scope="module", params=BAYS)
def made(request):
    spec = with_bay(request.param, BAYS[request.param])
    return spec, make_core(spec), make_core_base(spec), make_core_lid(spec)


def test_base_and_lid_are_the_core_and_a_rim_that_stands_in_the_bay(made):
    spec, core, base, lid = made
    assert list(problems_of(spec)) == []
    assert volume_mm3(common(base, lid)) == pytest.approx(0.0, abs=1e-3)
    x, y = np.array(spec.core.bay_mm[:2]) - 2 * spec.printer.clearance_mm
    wall = 2 * spec.printer.wall_mm
    rim = LID_RIM_MM * (x * y - (x - wall) * (y - wall))
    assert volume_mm3(base) + volume_mm3(lid) == pytest.approx(volume_mm3(core) + rim, rel=1e-5)


def test_a_board_goes_in_from_above_before_the_lid_does(made):
    spec, _, base, lid = made
    bay = bay_block(spec)
    board = box_between(-bay.half_mm + 0.01, (*(bay.half_mm[:2] - 0.01), 40.0))
    assert volume_mm3(common(base, board)) == pytest.approx(0.0, abs=1e-3)
    free = box_between(-bay.half_mm, bay.half_mm - np.array([0.0, 0.0, LID_RIM_MM]))
    assert volume_mm3(common(lid, free)) == pytest.approx(0.0, abs=1e-3)
    for way_mm in (0.5, 1.0, 3.0):  # it lifts off straight
        assert volume_mm3(common(base, lid.translate((0, 0, way_mm)))) == pytest.approx(0, abs=1e-3)


def test_the_parts_to_print_are_named_where_a_bay_is_closed_in():
    names = [part.name for part in parts_of(with_bay("closed box", [18, 16, 20]))]
    assert {"core_base", "core_lid"} < set(names)
    bare = ObjectSpec.model_validate(deepcopy(OBJECTS["closed box"]))
    assert not {"core_base", "core_lid"} & {part.name for part in parts_of(bare)}


@pytest.mark.parametrize(
    ("name", "bay_mm", "words"),
    [
        ("closed box", [18, 16, 34], "of the core's wall|sensor's recess"),
        ("closed box", [1.5, 16, 20], "no room for the lid's rim"),
        ("closed sphere", [8, 8, 9], "in the way of pins.*Move shell pockets"),
        ("sphere", [8, 8, 9], "leave no face open"),
    ],
)
def test_a_closed_bay_that_does_not_fit_is_refused(name, bay_mm, words):

    sentences = list(problems_of(with_bay(name, bay_mm)))
    assert any(re.search(words, sentence) for sentence in sentences), sentences
