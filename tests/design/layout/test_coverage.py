"""The share of the sensed surface that contact locations stand for, by hand."""

from pathlib import Path

import numpy as np
import pytest

from design.layout.body import face_frames
from design.layout.places.coverage import cell_areas_mm2, covered_share
from design.spec_io import load_spec, parse_spec

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_of_the_papers_cube():
    """10 × 10 cells of 3 mm on faces of 42 mm."""
    assert covered_share(parse_spec({"name": "cube"}, "test")) == pytest.approx(
        (30 / 42) ** 2, rel=0.005
    )


def test_of_a_box_with_unequal_faces():
    """One grid of 30 × 30 mm serves faces of 60 × 46, 60 × 42 (two) and 46 × 42 mm (two)."""
    body = {"size_mm": [60.0, 46.0, 42.0]}
    spec = parse_spec({"name": "box", "body": body, "contact_grid": {"count": [10, 10]}}, "test")
    area = 60 * 46 + 2 * 60 * 42 + 2 * 46 * 42
    assert covered_share(spec) == pytest.approx(5 * 30 * 30 / area, rel=0.005)


def test_of_a_ball_area_is_along_the_surface():
    """A cap of 60° has half of its half sphere; a square of ±a by numerical integration."""
    ball = load_spec(EXAMPLES / "ball.toml", ["contact_grid.count=[7, 7]"])
    radius, reach = ball.body.size_mm[0] / 2, 7 * 3.0 / 2
    patch = 2 * np.pi * radius**2 * (1 - np.cos(np.deg2rad(60)))
    x = (np.arange(2000) + 0.5) / 1000 * reach - reach
    square = np.sum(radius / np.sqrt(radius**2 - x[:, None] ** 2 - x**2)) * (reach / 1000) ** 2
    assert len(face_frames(ball)) == 5
    assert covered_share(ball) == pytest.approx(square / patch, rel=0.01)


def test_cells_of_a_ball_are_larger_where_it_leans():
    """1 / cos of the slope, at the middle and by the outermost corner of 7 × 7 cells of 3 mm."""
    ball = load_spec(EXAMPLES / "ball.toml", ["contact_grid.count=[7, 7]"])
    radius, middle = ball.body.size_mm[0] / 2, np.hypot(9.0, 9.0)
    areas = cell_areas_mm2(ball)
    assert areas.shape == (5 * 49,)
    assert areas.min() == pytest.approx(9.0, rel=0.005)
    assert areas.max() == pytest.approx(9 * radius / np.sqrt(radius**2 - middle**2), rel=0.01)
    assert cell_areas_mm2(parse_spec({"name": "cube"}, "test")) == pytest.approx(9.0)
