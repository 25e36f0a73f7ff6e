"""Sockets for the pins that hold a core whose wire holes lie under magnets."""

import cadquery as cq
import numpy as np
import pytest

from design.layout.boards import sensor_recesses
from design.layout.body import body_of, face_frames
from design.layout.core_hold import locators, why_no_mould
from design.layout.core_sockets import CLEAR_MM
from design.layout.places.positions import magnet_layout
from design.mould.pins import loose_pins, make_pin
from design.solids.booleans import common, volume_mm3
from design.solids.core import make_core
from design.solids.sampled import sampled_core_part
from design.spec_io import load_spec
from tests.support.objects.body_cases import body_spec
from tests.support.pages import ROOT

BLOCKED = {"magnets": {"positions_mm": [[3.0, 0.0]]}}
CLOSED = {"body": {"open_faces": []}}


def closed(name):
    if name == "pear":
        return load_spec(ROOT / "examples/pear.toml", ["body.open_faces=[]"])
    return body_spec(name, **({} if name == "ellipsoid" else CLOSED | BLOCKED))


NAMES = ("sphere", "capsule", "cylinder", "ellipsoid", "pear")


@pytest.mark.parametrize("name", NAMES)
def test_two_pins_well_aside_hold_the_core_clear_of_all_else(name):
    spec = closed(name)
    assert why_no_mould(spec) is None
    one, other = held = locators(spec)
    assert abs(one.frame.normal @ other.frame.normal) < 0.6
    for locator in held:
        if locator.socket is None:
            continue
        face, x, y = locator.place
        frame = {f.number: f for f in face_frames(spec)}.get(face) or body_of(spec).frame(face)
        np.testing.assert_allclose(
            frame.to_object(np.array([x, y, 0.0])), locator.frame.centre_mm, atol=1e-9
        )
        axis = locator.frame.centre_mm - np.linspace(0, 1, 60)[:, None] * (
            locator.frame.centre_mm - locator.socket.end_mm
        )
        core = body_of(spec).core_distance_mm(axis)
        in_core = np.linalg.norm(axis - locator.frame.centre_mm, axis=1) > locator.depth_mm
        assert ((core < 0.05) == in_core).mean() > 0.97
        layout = magnet_layout(spec)
        least = locator.radius_mm + spec.shell.pocket_diameter_mm / 2 + CLEAR_MM
        for centre, along in zip(layout.centre_mm, layout.axis, strict=True):
            above = (axis[~in_core] - centre) @ along * np.sign(centre @ along) > -0.5
            away = np.linalg.norm(np.cross(axis[~in_core] - centre, along), axis=1)
            assert (away[above] > least - 1e-6).all()
        for recess in sensor_recesses(spec):
            beside = (abs((axis[in_core] - recess.centre_mm) @ recess.axes) - recess.half_mm).clip(
                0
            )
            room = np.linalg.norm(beside, axis=1).min() - locator.radius_mm
            assert room > spec.printer.wall_mm


@pytest.mark.parametrize("name", ["cylinder", "ellipsoid"])
def test_the_core_has_the_holes_and_pins_fit_them(name):
    spec = closed(name)
    sampled = body_of(spec).sampled
    core = sampled_core_part(spec) if sampled else make_core(spec)
    for pin in loose_pins(spec):
        locator = pin.locator
        if locator is None or locator.socket is None:
            continue
        middle = locator.frame.centre_mm - (locator.depth_mm + 3.0) * locator.frame.normal
        inside = core.contains([middle])[0] if sampled else core.isInside(cq.Vector(*middle))
        assert not inside
        assert volume_mm3(common(core, make_pin(spec, pin))) < 0.02 if sampled else 1e-6


def test_bodies_that_are_open_have_no_sockets():
    assert locators(body_spec("sphere")) == ()
