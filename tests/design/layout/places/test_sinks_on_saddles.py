"""Boards on a saddle, as on a peanut's waist: the middle of an edge stands out before any corner does."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from design.layout.body import core_frames
from design.layout.places.positions import sinks_of_boards_mm
from design.spec.object import ObjectSpec


@dataclass(frozen=True)
class Saddle:
    """Height (x² / along − y² / across) / 2, its radii in mm."""

    along_mm: float
    across_mm: float

    def evaluate(self, xy_mm):
        x, y = xy_mm[..., 0], xy_mm[..., 1]
        slopes = np.stack([x / self.along_mm, -y / self.across_mm], axis=-1)
        return (x**2 / self.along_mm - y**2 / self.across_mm) / 2, slopes


@pytest.mark.parametrize(("along_mm", "across_mm"), [(20.0, 12.0), (-20.0, 12.0)])
def test_a_board_sinks_until_no_point_of_its_rim_stands_out(along_mm, across_mm):
    """2.7 mm³ of boards of 6.6 × 6.2 mm stood in the silicone of a peanut."""
    spec = ObjectSpec.model_validate(
        {"name": "peanut", "body": {"kind": "sphere", "size_mm": [60.0] * 3}}
    )
    saddle = Saddle(along_mm, across_mm)
    frame = replace(core_frames(spec)[0], relief=saddle)
    (sink,) = sinks_of_boards_mm(spec, frame, np.array([[0.0, 0.0, 0.0]]))
    tangential, radial, _ = spec.sensors.package_mm
    core = spec.core
    middle = (core.recess_inner_radius_mm + core.recess_outer_radius_mm) / 2
    steps = np.linspace(-0.5, 0.5, 81)
    x, y = np.meshgrid(middle - spec.sensors.radius_mm + radial * steps, tangential * steps)
    deepest = -saddle.evaluate(np.stack([x, y], axis=-1))[0].min()
    assert sink == pytest.approx(deepest, abs=0.02)
