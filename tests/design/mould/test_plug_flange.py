"""The flange of a plug in numbers: how wide it is, and what cuts its gable."""

from dataclasses import replace

import cadquery as cq
import numpy as np
import pytest

from design.layout.core_hold import core_outlet
from design.layout.mould.closure import FLANGE_HEIGHT_MM, flange_span_mm
from design.layout.mould.frame import mould_frame
from design.mould.plug import make_mould_holder
from design.mould.plug_flange import (
    CHAMFER_MM,
    flange_solids,
    grip_half_mm,
    grip_solid,
    prism_over_slope,
    tabs,
)
from design.solids.primitives import OVERSHOOT_MM, box_between
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec


def box(thickness_mm, **mould):
    return ObjectSpec.model_validate(
        {"name": "box", "shell": {"thickness_mm": thickness_mm}, "mould": mould}
    )


@pytest.mark.parametrize(("thickness_mm", "over"), [(8.0, 2.0), (10.0, 2.0), (6.0, 1.5)])
def test_a_flange_lies_over_the_rim_by_2_mm_or_a_quarter_of_the_shell(thickness_mm, over):
    edge = 21.0 - thickness_mm
    assert flange_span_mm(box(thickness_mm)) == pytest.approx((-edge - over, edge + over))


def test_a_rod_s_flange_is_as_wide_as_the_rod():
    assert flange_span_mm(body_spec("sphere")) == pytest.approx((-4.0, 4.0))


def test_a_grip_stays_between_its_blocks_where_they_do_not_meet():
    frame = mould_frame(box(8.0))
    assert grip_half_mm(frame) == pytest.approx(frame.high_mm[1] + 2.5 - 10)
    half = frame.high_mm.copy()
    least = CHAMFER_MM + OVERSHOOT_MM
    for inner, wanted in ((least + 0.1, least + 0.1), (least - 0.1, 0.0)):
        half[1] = inner + 7.5
        assert grip_half_mm(replace(frame, high_mm=half)) == pytest.approx(wanted)


def test_what_is_over_a_slope_is_a_prism_with_both_chamfers_and_ends_on_the_slope():
    frame, inner = mould_frame(box(8.0)), 12.0
    foot, ridge = (frame.axes @ np.array(p) for p in ((-6.0, 0.0, 30.0), (0.0, 0.0, 34.0)))
    solid = prism_over_slope(frame, foot, ridge, inner)
    high, rise = 4 * FLANGE_HEIGHT_MM, np.linalg.norm(ridge - foot)
    section = 2 * inner * (high - CHAMFER_MM) + (2 * inner - CHAMFER_MM) * CHAMFER_MM
    assert solid.Volume() == pytest.approx(section * (rise + 2 * high), rel=1e-6)
    middle = np.array(solid.Center().toTuple())
    assert middle @ frame.length_axis == pytest.approx(0, abs=1e-6)
    slope = (ridge - foot) / rise
    above = np.cross(slope, frame.length_axis)
    above *= np.sign(above @ frame.out)
    for share in (0.0, 0.5, 1.0):
        place = foot + share * (ridge - foot)
        assert solid.isInside(cq.Vector(*(place + 0.05 * above)))
        assert not solid.isInside(cq.Vector(*(place - 0.05 * above)))
        for side in (1, -1):
            edge = place + side * (inner - CHAMFER_MM) * frame.length_axis
            assert solid.isInside(cq.Vector(*(edge + 0.3 * above)))
            assert not solid.isInside(
                cq.Vector(*(edge + 0.3 * side * frame.length_axis + 0.2 * above))
            )


def test_a_grip_is_a_gable_and_its_chamfers_widen_it():
    """Between the chamfers a roof of the width and height given, with full ends."""
    frame = mould_frame(box(8.0))
    grip = grip_solid(frame, (-6.0, 6.0), 12.0, (30.0, 36.0))
    roof = 2 * (12.0 - CHAMFER_MM) * 12.0 * 6.0 / 2
    assert roof < grip.Volume() < 24 * 12 * 6
    assert grip.isInside(cq.Vector(*(frame.axes @ np.array([0.0, 0.0, 35.9]))))
    assert not grip.isInside(cq.Vector(*(frame.axes @ np.array([3.2, 0.0, 33.0]))))
    assert grip.isInside(cq.Vector(*(frame.axes @ np.array([2.8, 0.0, 33.0]))))


def test_a_holder_s_nose_has_the_printer_s_play_in_the_core():
    spec = body_spec("sphere")
    outlet = core_outlet(spec)
    tip = box_between((-20.0, -20.0, outlet.nose_mm - 0.01), (20.0, 20.0, outlet.nose_mm + 1))
    widest = make_mould_holder(spec).intersect(tip).BoundingBox().ymax
    assert widest == pytest.approx(outlet.radius_mm - spec.printer.clearance_mm, abs=0.02)


def test_measures_are_those_of_the_authors_mould():
    """Read off their STEP file: the walls' seats and posts, the flange over them, its clips and grip."""
    frame, (bridge, grip, clip, block, *_) = mould_frame(box(8.0)), flange_solids(box(8.0))
    levels = {
        name: np.round(sorted((one.BoundingBox().zmin, one.BoundingBox().zmax)), 6)
        for name, one in (("bridge", bridge), ("grip", grip), ("clip", clip), ("block", block))
    }
    rim = frame.rim_mm  # towards −z, as face 6 is open
    assert levels["bridge"] == pytest.approx([-rim - 2, -rim])
    assert levels["clip"] == pytest.approx([-rim - 10, -rim])
    assert levels["block"] == pytest.approx([-rim - 10, -rim - 2])
    assert levels["grip"][1] == pytest.approx(-rim - 2)
    along = [
        abs(np.array([one.BoundingBox().ymin, one.BoundingBox().ymax])) for one in (clip, block)
    ]
    wall = frame.high_mm[1]
    if abs(frame.length_axis[0]) > 0.5:
        along = [
            abs(np.array([one.BoundingBox().xmin, one.BoundingBox().xmax])) for one in (clip, block)
        ]
    assert sorted(along[0]) == pytest.approx([wall + 0.1, wall + 2.5])
    assert sorted(along[1]) == pytest.approx([wall + 2.5 - 10, wall + 2.5])
    raised = [
        np.round([one.BoundingBox().zmin, one.BoundingBox().zmax], 6) for one in tabs(box(8.0))
    ]
    tops = sorted({-float(low) - rim for low, _ in raised})
    assert tops == pytest.approx([2.0, 4.0])
