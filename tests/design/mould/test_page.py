"""Moulds of objects off their symmetries, and what checks measure: a page that a person can judge."""

import numpy as np

from design.fabrication.assembly import check_pockets
from design.fabrication.casting import draws
from design.fabrication.layout import layout_findings
from design.fabrication.printing import check_features, check_inhibition
from design.layout.mould.pins import least_rim_mm, loose_pins, pins_by_kind
from design.layout.template_marks import mark_places, pockets_by_face, thinnest_mark_wall_mm
from design.mould.flange import flanges
from design.mould.openings import mould_holes, seal_holes
from design.mould.plug import pour_width_mm
from design.mould.plug_flange import flange_span_mm
from tests.support.objects.worked_objects import worked
from tests.support.physics_pages import assert_page

SPLIT = ("closed box", "box open at a side", "cylinder", "capsule")
CHECKED = ("box", "cylinder", "capsule", "reverse box", "dome")


def of_pins(name):
    spec = worked(name)
    pins = loose_pins(spec)
    yield (
        f"{name}: seats, tops, rims, radii of pins (mm)",
        [[pin.seat_mm, pin.top_mm, pin.rim_mm, pin.radius_mm] for pin in pins],
    )
    ends = [end for pin in pins for end in (pin.axis_mm, pin.head_axis_mm, pin.shank_axis_mm)]
    yield f"{name}: axes of pins (mm)", np.concatenate(ends)
    kinds = ", ".join(f"{kind.count} × {kind.name}" for kind in pins_by_kind(spec))
    yield f"{name}: pins with a rim of {least_rim_mm(spec):g} mm", kinds
    for flange in flanges(spec)[:1]:
        span = [flange.low_mm, flange.high_mm, flange.bottom_mm, flange.top_mm]
        yield f"{name}: flange, dowels and bolts (mm)", [*span, *np.ravel(flange.places_mm)]


def of_pouring():
    for name in ("closed box", "capsule", "closed sphere"):
        holes = (*mould_holes(worked(name)), *seal_holes(worked(name)))
        yield (
            f"{name}: pouring holes (mm)",
            [
                *(
                    one
                    for hole in holes
                    for one in (*hole.start_mm, *hole.end_mm, hole.diameter_mm)
                ),
            ],
        )


def of_checks(name):
    spec = worked(name)
    recesses = spec.body.kind == "box" and spec.arrangement == "sensors-in-core"
    measured = [
        *layout_findings(spec, recesses=recesses),
        *check_features(spec),
        *check_inhibition(spec),
        *([] if recesses else check_pockets(spec)),
    ]
    counts = [sum(one.status == way for one in measured) for way in ("pass", "warn", "fail")]
    yield f"{name}: passed, warned, failed checks", counts
    yield f"{name}: values and limits of checks", [[one.value, one.limit] for one in measured]
    frame, pockets = pockets_by_face(spec)[0]
    marks = mark_places(spec, pockets, frame.half_extents_mm)
    pulls = [[*draw.pull, min(draw.room_mm, 99.0)] for draw in draws(spec)]
    yield (
        f"{name}: marks, wall beside them, flange, pouring, pulls",
        [
            *np.ravel(marks),
            min(thinnest_mark_wall_mm(spec), 99.0),
            *flange_span_mm(spec),
            pour_width_mm(spec),
            *np.ravel(pulls),
        ],
    )


def test_the_page_of_moulds():
    pins = [line for name in SPLIT[:3] for line in of_pins(name)]
    checks = [line for name in CHECKED for line in of_checks(name)]
    assert_page("design/mould", [*pins, *of_pouring(), *checks])
