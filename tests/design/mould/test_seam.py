"""Walls that holes leave to the seam of a mould's halves."""

import numpy as np
import pytest

from design.layout.mould.frame import parting, thin_at_seam
from design.layout.mould.pins import pins_thin_the_seam
from design.spec.object import ObjectSpec

BALL = {"name": "ball", "body": {"kind": "sphere", "size_mm": [60.0] * 3}}
UPRIGHT = np.array([[0.0, 0.0, 10.0], [0.0, 0.0, 40.0]])


@pytest.mark.parametrize(
    ("aside_mm", "thin"),
    [(0.0, False), (1.85, False), (2.0, True), (2.75, True), (2.85, False), (-2.75, True)],
)
def test_a_hole_beside_the_seam_leaves_a_wall_or_is_cut_by_it(aside_mm, thin):
    """A hole of radius 2 mm, walls of 0.8 mm; beyond cos 15° of the radius the seam leaves a wedge."""
    spec = ObjectSpec.model_validate(BALL)
    ends = UPRIGHT + aside_mm * parting(spec).normal
    assert thin_at_seam(spec, ends, 2.0) is thin
    assert thin_at_seam(spec, ends[::-1], 2.0) is thin


@pytest.mark.parametrize(
    ("lean_deg", "aside_mm", "thin"),
    [
        (14.0, 1.8, True),  # cut at 1.8 mm, where it begins, with a wall of 0 to 0.8 mm farther on
        (14.0, -0.3, True),  # from one side to the other
        (0.5, 1.5, False),  # cut over all of its length
        (14.0, 2.9, False),
        (16.0, 1.8, False),  # where it leaves the seam a wedge of 16°
        (90.0, 2.3, False),
    ],
)
def test_a_hole_that_leans_is_cut_by_the_seam_and_leaves_a_wall_farther_on(
    lean_deg, aside_mm, thin
):
    """Of radius 2 mm and 10 mm long: a lump's pin leant by 14.4°, was cut at its head, and left 0.05 mm."""
    spec = ObjectSpec.model_validate(BALL)
    normal, lean = parting(spec).normal, np.deg2rad(lean_deg)
    way = np.cos(lean) * np.array([0.0, 0.0, 1.0]) + np.sin(lean) * normal
    ends = np.array([0.0, 0.0, 20.0]) + aside_mm * normal + np.array([[0.0], [10.0]]) * way
    assert thin_at_seam(spec, ends, 2.0) is thin
    assert thin_at_seam(spec, ends[::-1], 2.0) is thin


def test_turning_the_seam_takes_it_from_a_pin():
    """A pin at azimuth 0, from 30 mm outwards, of 3.1 mm with its play, in walls of 0.8 mm. Seams whose
    normals lie beyond 82.5° leave less, 30 · sin 7° − 3.1 = 0.56 mm at 83° (0.64 mm by rays through the
    mould's half). Its head rests on the outside, and has no hole (1.4 mm by rays at 81°)."""
    given = BALL | {"magnets": {"positions_mm": [[0.0, 0.0]]}}
    thin = {}
    for azimuth in (45.0, 81.0, 82.0, 83.0, 90.0):
        spec = ObjectSpec.model_validate(given | {"mould": {"parting_azimuth_deg": azimuth}})
        thin[azimuth] = pins_thin_the_seam(spec)
    assert thin == {45.0: False, 81.0: False, 82.0: False, 83.0: True, 90.0: False}
