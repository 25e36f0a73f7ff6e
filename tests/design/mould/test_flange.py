"""Flanges of the seam as numbers: notches for pins by hand, and flanges that no length helps."""

import numpy as np
import pytest

from design.layout.mould.frame import Parting, mould_frame
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
    monkeypatch.setattr(flange, "_levels", lambda spec, pin, low, high: pin)
    block = type("Frame", (), {"low_mm": np.zeros(3)})
    monkeypatch.setattr(flange, "mould_frame", lambda spec: block)
    assert list(flange._notches.__wrapped__(spec, pierced, 0.0, 8.0, -10.0, 40.0)) == notches


def test_flanges_that_no_length_helps_are_as_short_as_they_may_be(monkeypatch):
    spec = body_spec("closed_box")
    frame = mould_frame(spec)
    monkeypatch.setattr(Flange, "places_mm", [])
    for one in flanges(spec):
        top = frame.rim_mm if not frame.plugged else one.top_mm
        assert one.top_mm == top
        assert one.bottom_mm == min(frame.low_mm[2], top - FLANGE_LENGTH_MM)


@pytest.mark.parametrize(("azimuth_deg", "offset_mm"), [(0.0, 3.0), (30.0, 7.0), (130.0, -11.0)])
def test_a_seam_beside_the_middle_begins_and_ends_where_it_crosses_the_block(
    monkeypatch, azimuth_deg, offset_mm
):
    """As found by steps of a hundredth of a millimetre along it."""
    spec = body_spec("closed_box")
    frame, turn = mould_frame(spec), np.deg2rad(azimuth_deg)
    normal = np.cos(turn) * frame.across + np.sin(turn) * frame.along
    monkeypatch.setattr(flange, "parting", lambda spec: Parting(normal, offset_mm))
    at = np.arange(-200.0, 200.0, 0.01)
    line = offset_mm * normal + at[:, None] * np.cross(frame.out, normal)
    places = line @ frame.axes
    inside = np.all((places >= frame.low_mm) & (places <= frame.high_mm), axis=1)
    wanted = at[inside][[0, -1]]
    assert np.allclose(flange._block_ends_mm(spec, frame), wanted, atol=0.02)
