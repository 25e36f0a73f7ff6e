"""Which way the magnets' north poles point: axes, as-built magnets, layouts of a search, input."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import SpecError
from design.layout.places.positions import magnet_layout
from design.spec.assembly import AsBuiltSpec, BuiltMagnet
from design.spec.object import MagnetSpec, ObjectSpec
from estimator.layouts.batch import layouts_of, magnet_axes
from estimator.signals.presses import rest_counts

PLACES = ((2.0, -1.0), (-9.0, 4.0), (7.0, -9.5))
TILTS = ((12.0, -20.0), (0.0, 25.0), (-8.0, 3.0))
WAYS = ("outward", "inward", "inward")
SIGNS = np.array([1.0, -1.0, -1.0])


def cube(north=(), **more):
    magnets = MagnetSpec(positions_mm=PLACES, tilt_deg=TILTS, north=north)
    return ObjectSpec(name="cube", magnets=magnets, **more)


def test_an_inward_north_turns_the_axis_of_that_magnet_on_every_face():
    outward, mixed = magnet_layout(cube()), magnet_layout(cube(WAYS))
    assert_allclose(mixed.axis, outward.axis * np.tile(SIGNS, 5)[:, None], rtol=0, atol=1e-15)
    assert_allclose(mixed.centre_mm, outward.centre_mm, rtol=0, atol=0)
    assert_allclose(mixed.strength, 1.0, rtol=0, atol=0)


def test_turning_every_pole_turns_the_field():
    assert_allclose(rest_counts(cube(("inward",) * 3)), -rest_counts(cube()), rtol=1e-12)


def test_what_was_measured_goes_before_the_design():
    """A measured axis points north, whatever the design; a measured remanence keeps the pole."""
    found = (
        BuiltMagnet(face=3, magnet=2, axis=(0.0, 0.0, 1.0)),
        BuiltMagnet(face=3, magnet=3, remanence_t=1.2),
    )
    built = magnet_layout(cube(WAYS, as_built=AsBuiltSpec(magnets=found)))
    designed = magnet_layout(cube(WAYS))
    assert_allclose(built.axis[7], [1, 0, 0], rtol=0, atol=1e-15)  # face 3 looks along +x
    assert_allclose(built.axis[8], designed.axis[8], rtol=0, atol=1e-15)
    assert_allclose(built.strength[8], 1.2 / 1.43, rtol=1e-12)


def test_a_search_starts_from_the_designs_poles():
    spec = cube(WAYS)
    layout = layouts_of(spec, 1)
    axes = layout.polarity[0] * magnet_axes(layout)[:, 0]
    assert_allclose(axes.T.numpy(), magnet_layout(spec).axis[:3], rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    ("north", "message"),
    [
        (("inward",), "north needs one entry for each of the 3"),
        (("up",) * 3, "'outward' or 'inward'"),
    ],
)
def test_poles_that_make_no_sense_are_refused(north, message):
    with pytest.raises(SpecError, match=message):
        cube(north)
