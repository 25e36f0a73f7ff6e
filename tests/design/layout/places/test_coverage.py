"""The share of the sensed surface that contact locations stand for, by hand."""

from pathlib import Path

import numpy as np
import pytest

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, touched_reach_mm
from design.layout.places.coverage import cell_areas_mm2, covered_share, covered_shares
from design.spec_io import load_spec, parse_spec

EXAMPLES = Path(__file__).parents[4] / "examples"


def test_of_the_papers_cube():
    """14 × 14 cells of 3 mm on faces of 42 mm."""
    assert covered_share(parse_spec({"name": "cube"}, "test")) == pytest.approx(1.0, rel=0.005)


def test_of_a_box_with_unequal_faces():
    """One grid of 30 × 30 mm serves faces of 60 × 46, 60 × 42 (two) and 46 × 42 mm (two)."""
    body = {"size_mm": [60.0, 46.0, 42.0]}
    spec = parse_spec({"name": "box", "body": body, "contact_grid": {"count": [10, 10]}}, "test")
    area = 60 * 46 + 2 * 60 * 42 + 2 * 46 * 42
    assert covered_share(spec) == pytest.approx(5 * 30 * 30 / area, rel=0.005)


def test_of_a_ball_area_is_along_the_surface():
    """A cap of 60° has half of its half sphere; a square of ±a along it by numerical integration."""
    ball = load_spec(EXAMPLES / "ball.toml", ["contact_grid.count=[7, 7]"])
    radius = ball.body.size_mm[0] / 2
    reach = radius * np.sin(7 * 3.0 / 2 / radius)
    patch = 2 * np.pi * radius**2 * (1 - np.cos(np.deg2rad(60)))
    x = (np.arange(2000) + 0.5) / 1000 * reach - reach
    square = np.sum(radius / np.sqrt(radius**2 - x[:, None] ** 2 - x**2)) * (reach / 1000) ** 2
    assert len(face_frames(ball)) == 5
    assert covered_shares(ball) == pytest.approx(square / patch, rel=0.01)


def test_cells_of_a_ball_are_those_of_the_closed_form():
    """cos u cos v / √(1 − sin² u − sin² v) for angles u, v of a cell's middle along the sections."""
    ball = load_spec(EXAMPLES / "ball.toml", ["contact_grid.count=[7, 7]"])
    areas, angle = cell_areas_mm2(ball), contact_grid(ball).xy_mm / (ball.body.size_mm[0] / 2)
    expected = np.prod(np.cos(angle), axis=1) / np.sqrt(1 - np.sum(np.sin(angle) ** 2, axis=1))
    assert areas.shape == (5 * 49,)
    np.testing.assert_allclose(areas / 9, np.tile(expected, 5), rtol=0.002)
    assert cell_areas_mm2(parse_spec({"name": "cube"}, "test")) == pytest.approx(9.0)


@pytest.mark.parametrize(
    ("name", "largest", "variation"),
    [
        ("handle", 1.0001, 1e-5),
        ("capsule", 1.035, 0.006),
        ("ball", 1.05, 0.013),
        ("egg", 1.06, 0.013),
        ("hollow_dome", 1.05, 0.012),
        ("pear", 1.075, 0.015),
    ],
)
def test_filled_places_lie_evenly_along_curved_surfaces(name, largest, variation):
    """Even in the plane's x and y, cells up to there were up to 1.31 to 1.42 pitch², coefficients 0.08 to
    0.10. Steeper ones have up to a fifth more."""
    spec = load_spec(EXAMPLES / f"{name}.toml")
    every = cell_areas_mm2(spec) / spec.contact_grid.pitch_mm**2
    cells = every[np.concatenate(_are_gentle(spec))]
    assert cells.max() <= largest
    assert cells.min() >= 0.98
    assert cells.std() / cells.mean() <= variation
    assert 0.98 <= every.min() <= every.max() < 1.22


def _are_gentle(spec):
    """Contact locations of each face have a tip and a pitch all round within the patch."""
    reach = touched_reach_mm(spec) + spec.contact_grid.pitch_mm
    gentle = []
    for frame, there in zip(face_frames(spec), contact_places(spec), strict=True):
        xy = frame.to_plane(contact_grid(spec).xy_mm[there])
        axes = frame.axes_at(xy)
        turn = np.linspace(0, 2 * np.pi, 24)
        ring = reach * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
        around = frame.to_object(np.column_stack([xy, 0 * xy[:, 0]]))[:, None] + np.einsum(
            "pij,rj->pri", axes[..., :2], ring
        )
        normals = np.repeat(axes[..., 2], len(ring), axis=0)
        rim = frame.project_along(around.reshape(-1, 3), normals)[:, :2]
        half = np.where(frame.ends, frame.half_extents_mm, np.inf)
        covered = frame.covers(np.nan_to_num(np.clip(rim, -half, half), nan=np.inf))
        gentle.append(covered.reshape(len(xy), -1).all(axis=1))
    return gentle


@pytest.mark.parametrize("name", ["handle", "ball", "egg", "pear"])
def test_neighbours_on_the_surface_are_a_pitch_apart(name):
    """Straight distances between neighbours in x and in y, by the points on the body alone."""
    spec = load_spec(EXAMPLES / f"{name}.toml")
    grid, pitch = contact_grid(spec), spec.contact_grid.pitch_mm
    places = zip(face_frames(spec), contact_places(spec).copy(), _are_gentle(spec), strict=True)
    for frame, on_lattice, gentle in places:
        on_lattice[on_lattice] = gentle
        xy = frame.to_plane(grid.xy_mm)
        points = frame.to_object(np.column_stack([xy, np.zeros(len(xy))]))
        points = np.where(on_lattice[:, None], points, np.nan).reshape(*grid.shape, 3)
        for axis in (0, 1):
            steps = np.linalg.norm(np.diff(points, axis=axis), axis=-1) / pitch
            assert 0.985 <= np.nanmin(steps) <= np.nanmax(steps) <= 1.07
