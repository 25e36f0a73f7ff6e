"""Flanges of the seam as numbers: notches for pins by hand, and flanges that no length helps."""

import numpy as np
import pytest

from design.layout.mould.frame import mould_frame
from design.mould import flange
from design.mould.flange import FLANGE_LENGTH_MM, Flange, flanges
from tests.support.objects.body_cases import body_spec


@pytest.mark.parametrize(
    ("pierced", "notches"),
    [
        ([(10.0, 12.0)], [(10.0, 12.0)]),
        ([(16.0, 20.0), (10.0, 12.0)], [(10.0, 12.0), (16.0, 20.0)]),  # 4 mm are left between
        ([(15.9, 20.0), (10.0, 12.0)], [(10.0, 20.0)]),
        ([(4.0, 6.0), (10.0, 12.0), (15.0, 17.0)], [(4.0, 6.0), (10.0, 17.0)]),
        ([(10.0, 30.0), (12.0, 14.0)], [(10.0, 30.0)]),
        ([(3.9, 6.0)], [(-11.0, 6.0)]),  # too little of it would hang on the block
        ([(4.0, 6.0)], [(4.0, 6.0)]),
        ([(34.0, 36.1)], [(34.0, 41.0)]),
        ([(34.0, 36.0)], [(34.0, 36.0)]),
        ([(-14.0, -10.0), (40.0, 44.0)], []),  # beyond its ends
        ([None, (-14.0, -9.9)], [(-11.0, -9.9)]),
    ],
)
def test_notches_are_joined_where_too_little_flange_is_between(monkeypatch, pierced, notches):
    """Of a flange from −10 to 40 mm beside a block that begins at 0."""
    spec = body_spec("closed_box")
    monkeypatch.setattr(flange, "pierced_levels", lambda spec, pin, low, high: pin)
    block = type("Frame", (), {"low_mm": np.zeros(3)})
    monkeypatch.setattr(flange, "mould_frame", lambda spec: block)
    assert list(flange.notches_of.__wrapped__(spec, pierced, 0.0, 8.0, -10.0, 40.0)) == notches


def test_flanges_that_no_length_helps_are_as_short_as_they_may_be(monkeypatch):
    spec = body_spec("closed_box")
    frame = mould_frame(spec)
    monkeypatch.setattr(Flange, "places_mm", [])
    for one in flanges(spec):
        top = frame.rim_mm if not frame.plugged else one.top_mm
        assert one.top_mm == top
        assert one.bottom_mm == min(frame.low_mm[2], top - FLANGE_LENGTH_MM)
