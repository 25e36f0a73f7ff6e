"""Bays in cores of bodies that are open below, and why others have none."""

import cadquery as cq
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.boards import bay_block
from design.solids.core import make_core
from tests.support.objects.body_cases import body_spec

BAYS = {"cylinder": (13.0, 13.0, 8.0), "dome_on_core": (16.0, 10.0, 5.0)}


@pytest.mark.parametrize("name", BAYS)
def test_the_bay_is_open_below_and_as_large_as_asked(name):
    size = BAYS[name]
    solid = {"core": {"bay_mm": size}}
    plain, bayed = (
        make_core(body_spec(name)),
        make_core(body_spec(name, **solid)),
    )
    block = bay_block(body_spec(name, **solid))
    room = cq.Solid.makeBox(*size, cq.Vector(*(block.centre_mm - block.half_mm)))
    assert_allclose(room.intersect(bayed).Volume(), 0, rtol=0, atol=1e-6)
    assert_allclose(plain.Volume() - bayed.Volume(), room.intersect(plain).Volume(), rtol=1e-4)
    assert plain.Volume() - bayed.Volume() > 50


@pytest.mark.parametrize(
    ("name", "bay", "told"),
    [
        ("sphere", (5.0, 5.0, 5.0), "core of this sphere has neither"),
        ("ellipsoid", (5.0, 5.0, 5.0), "core of this ellipsoid has neither"),
        ("cylinder", (17.0, 17.0, 10.0), "of the core's wall at its upper corners"),
        ("cylinder", (10.0, 8.0, 33.5), "of the core's wall at its upper corners"),
        ("cylinder", (16.5, 5.0, 20.0), "of a sensor's recess"),
        ("hollow_dome", (9.0, 8.0, 2.0), "of a sensor's recess"),
    ],
)
def test_bays_that_cannot_be_are_refused(name, bay, told):
    with pytest.raises(InputError, match=told):
        body_spec(name, core={"bay_mm": bay})
