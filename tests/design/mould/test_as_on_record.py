"""Moulds of objects off their symmetries as numbers, and what checks of fabrication say, on record."""

import numpy as np
import pytest

from design.build.print_settings import layer_mm
from design.fabrication.assembly import check_pockets
from design.fabrication.casting import _heads, _pour, draws
from design.fabrication.layout import layout_findings
from design.fabrication.printing import check_features, check_inhibition
from design.layout.mould.frame import mould_frame
from design.layout.mould.pins import (
    least_rim_mm,
    loose_pins,
    pins_by_kind,
    pins_thin_the_seam,
)
from design.layout.template_marks import mark_places, pockets_by_face, thinnest_mark_wall_mm
from design.mould.flange import flanges
from design.mould.openings import mould_holes, seal_holes, sealed_round
from design.mould.plug import pour_width_mm
from design.mould.plug_flange import flange_span_mm
from design.solids.magnet_template import template_faces
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, told

SPLIT = ("closed box", "box open at a side", "cylinder", "capsule", "closed sphere")
CHECKED = ("box", *SPLIT, "reverse box", "pad", "dome")
POURED = ("closed box", "capsule", "closed sphere")


def ends(axes):
    return np.concatenate(axes)


@pytest.mark.parametrize("name", SPLIT)
def test_pins_and_flanges_are_as_on_record(name):
    spec = worked(name)
    pins = loose_pins(spec)
    lines = [
        told("pins", [[pin.seat_mm, pin.top_mm, pin.rim_mm, pin.radius_mm] for pin in pins]),
        told("their axes", ends([pin.axis_mm for pin in pins])),
        told("heads", ends([pin.head_axis_mm for pin in pins])),
        told("shanks", ends([pin.shank_axis_mm for pin in pins])),
        told("least rim, thin seam", [least_rim_mm(spec), pins_thin_the_seam(spec)]),
    ]
    for kind in pins_by_kind(spec):
        held = ", which holds the core" if kind.holds_core else ""
        lines.append(told(f"{kind.count} × {kind.name}{held}", kind.places))
    for flange in flanges(spec):
        sizes = [flange.low_mm, flange.high_mm, flange.bottom_mm, flange.top_mm]
        lines += [
            told("flange", [*sizes, min(flange.pierced_mm, 1e6)]),
            told("notches", flange.notches or [0.0]),
            told("dowels and bolts", flange.places_mm),
        ]
    assert_on_record("split_moulds", name, lines)


@pytest.mark.parametrize("name", POURED)
def test_pouring_holes_are_as_on_record(name):
    spec = worked(name)
    lines = [
        told("hole", [*hole.start_mm, *hole.top_mm, *hole.end_mm, hole.diameter_mm])
        for hole in (*mould_holes(spec), *seal_holes(spec))
    ]
    if mould_frame(spec).opening == "bore":
        lines.append(
            told("sealed", [sealed_round(spec).volume, *sealed_round(spec).bounds.ravel()])
        )
    assert_on_record("pouring", name, [*lines, told("vents", spec.printer.hole_mm)])


def of_finding(finding):
    place = "" if finding.place_mm is None else f" at {finding.place_mm}"
    return f"{finding.status}: {finding.told}{place}: {finding.what.split('.')[0]}"


@pytest.mark.parametrize("name", CHECKED)
def test_what_is_checked_without_a_solid_is_as_on_record(name):
    spec = worked(name)
    recesses = spec.body.kind == "box" and spec.arrangement == "sensors-in-core"
    found = [
        *layout_findings(spec, recesses=recesses),
        *check_features(spec),
        *check_inhibition(spec),
        *([] if recesses else check_pockets(spec)),
        _pour(spec),
        *_heads(spec),
    ]
    lines = [of_finding(finding) for finding in found]
    for draw in draws(spec):
        lines.append(told(f"draw {draw.part}", [*draw.pull, min(draw.room_mm, 1e6)]))
    lines += [
        told("flange's span, pouring", [*flange_span_mm(spec), pour_width_mm(spec)]),
        told("layers", [layer_mm(spec.printer, copied) for copied in (True, False)]),
    ]
    frame, pockets = pockets_by_face(spec)[0]
    marks = mark_places(spec, pockets, frame.half_extents_mm)
    lines += [
        told("marks", marks),
        told("wall beside them", min(thinnest_mark_wall_mm(spec), 1e6)),
        f"templates: {template_faces(spec)}",
    ]
    assert_on_record("checks", name, lines)
