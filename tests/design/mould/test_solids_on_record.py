"""Cheap solids of moulds of objects off their symmetries: volumes, middles and boxes, on record."""

import pytest
from numpy.testing import assert_allclose

from design.layout.core_hold import locators
from design.layout.mould.frame import mould_frame
from design.layout.mould.pins import loose_pins
from design.mould.flange import flanges
from design.mould.halves import _bolt_holes, _dowel, _flange, _half_space
from design.mould.one_piece import make_mould_box, make_seal_mould
from design.mould.pins import fixed_bosses, make_pin, pin_holes
from design.mould.plug import make_mould_holder, make_mould_plug, rod_hole
from design.mould.plug_flange import flange_solids, tabs
from design.mould.walls import block
from design.solids.core import _sockets
from design.solids.shell import locator_hole
from design.spec.object import ObjectSpec
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, of_solids

PLUGGED = ("box", "box open at a side", "cylinder", "dome")


@pytest.mark.parametrize("name", PLUGGED)
def test_what_hangs_in_a_mould_is_as_on_record(name):
    spec = worked(name)
    ends = flanges(spec)
    lines = [
        of_solids("block", [block(spec)]),
        of_solids("flange of the plug", flange_solids(spec)),
        of_solids("tabs", tabs(spec)),
        of_solids("flanges", [_flange(spec, *ends)]),
        of_solids("dowel", [_dowel(spec, *ends[0].places_mm[0], 0.1)]),
        of_solids("bolts", _bolt_holes(spec, *ends)),
        of_solids("halves of space", [_half_space(spec, side) for side in (1, -1)]),
    ]
    if name == "dome":
        lines.append(of_solids("plug", [make_mould_plug(spec)]))
    assert_on_record("mould_solids", name, lines)


def test_boxes_of_a_pad_are_as_on_record():
    spec = worked("pad").changed(shell=worked("pad").shell.changed(seal_layer_mm=0.4))
    boxes = [make_mould_box(spec), make_seal_mould(spec)]
    assert_on_record("mould_solids", "pad", [of_solids("box", boxes)])


@pytest.mark.parametrize("name", ["closed box", "capsule", "closed capsule"])
def test_what_holds_a_core_is_as_on_record(name):
    spec = worked(name)
    pins = [pin for pin in loose_pins(spec) if pin.locator is not None] or loose_pins(spec)[1:2]
    lines = [
        of_solids("pin", [make_pin(spec, pins[0])]),
        of_solids("its holes", pin_holes(spec, pins[0])),
        of_solids("bosses", fixed_bosses(spec, 1)),
        of_solids("sockets", _sockets(spec)),
        of_solids("holes of pins", [locator_hole(locator) for locator in locators(spec)]),
    ]
    if mould_frame(spec).opening == "bore":
        lines.append(of_solids("rod's hole", [rod_hole(spec)]))
        lines.append(of_solids("holder", [make_mould_holder(spec)]))
    assert_on_record("hold_solids", name, lines)


def test_pockets_along_the_pull_are_fixed_bosses_but_where_a_locating_pin_forms_them():
    """Pulled along x: face 3's middle holds a locating pin, its second pocket and face 5's are fixed."""
    content = {
        "body": {"open_faces": []},
        "magnets": {"positions_mm": [[0.0, 0.0], [9.0, 0.0]]},
        "mould": {"parting_azimuth_deg": 0.0},
    }
    spec = ObjectSpec.model_validate({"name": "wide", **content})
    middles = [[boss.Center().toTuple() for boss in fixed_bosses(spec, side)] for side in (1, -1)]
    assert [[x > 0 for x, _, _ in some] for some in middles] == [[True], [False, False]]
    beside = [[yz for _, *yz in some] for some in middles]
    assert_allclose(beside[0], [[0.0, -9.0]], atol=1e-9)
    assert_allclose(beside[1], [[0.0, 0.0], [0.0, -9.0]], atol=1e-9)
    pins = loose_pins(spec)
    assert [pin.frame.number for pin in pins if pin.locator is not None] == [2, 3]
    assert [pin.frame.number for pin in pins if pin.locator is None] == [1, 1, 2, 4, 4, 6, 6]
