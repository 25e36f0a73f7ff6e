"""Pins that hold a core that is cast in, where the surface leans in the middle of a face."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from design.layout.body import core_frames, face_frames
from design.layout.core_hold import _locator
from design.layout.pockets import Body, Outline, Pocket
from design.spec_io import parse_spec

SPEC = parse_spec({"name": "closed", "body": {"open_faces": []}}, "test")


@dataclass(frozen=True)
class Slope:
    """A plane through the middle of the patch that rises along x."""

    per_mm: float

    def at(self, xy_mm):
        xy = np.asarray(xy_mm, float)
        return self.per_mm * xy[..., 0], np.stack(
            [np.full(xy.shape[:-1], self.per_mm), np.zeros(xy.shape[:-1])], axis=-1
        )


def leaning(number, per_mm):
    frame, core = (
        f[SPEC.body.sensed.index(number)] for f in (face_frames(SPEC), core_frames(SPEC))
    )
    return replace(frame, relief=Slope(per_mm)), core


def pocket_at(x_mm):
    body = Body(np.array([x_mm, 0.0, -1.5]), np.eye(3), Outline((3.0, 3.0), True), 3.0, "a magnet")
    return Pocket(body, Outline((3.0, 3.0), True))


@pytest.mark.parametrize("per_mm", [0.0, 0.3])
def test_a_pin_runs_through_the_middles_of_face_and_core(per_mm):
    """Along the leaning surface's normal it missed the core's hole: 51 mm³ of core on a closed pear."""
    face, core = leaning(3, per_mm)
    locator = _locator(SPEC, face, core, ())
    for share in (0.0, 0.5, 1.0):
        at = locator.frame.to_object(np.array([0.0, 0.0, -share * locator.depth_mm]))
        expected = face.centre_mm + share * (core.centre_mm - face.centre_mm)
        np.testing.assert_allclose(at, expected, atol=1e-12)
    np.testing.assert_allclose(locator.frame.tangent(np.zeros(2)).normal, face.normal)


def test_a_pocket_in_the_middle_is_one_with_the_pin_only_where_the_surface_is_level():
    level, core = leaning(3, 0.0)
    assert len(_locator(SPEC, level, core, (pocket_at(0.0),)).pockets) == 1
    steep, core = leaning(3, 0.3)
    assert _locator(SPEC, steep, core, (pocket_at(0.0),)) is None


def test_a_pin_keeps_further_from_pockets_that_lean_towards_it():
    """Hole of Ø4, pocket of Ø6, gap 0.8 mm: 5.8 mm apart on a level face, 8.1 mm at a slope of 0.3."""
    face, core = leaning(3, 0.3)
    assert _locator(SPEC, face, core, (pocket_at(7.5),)) is None
    assert _locator(SPEC, face, core, (pocket_at(8.3),)).pockets == ()
    level, core = leaning(3, 0.0)
    assert _locator(SPEC, level, core, (pocket_at(6.0),)).pockets == ()
