"""Where contact locations lie: distances and curvature against closed forms."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.body.surface_chart import Cap, cap_frame, flat_frame
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.measures import (
    SENSOR_SHARE,
    border_distance_mm,
    curvature,
    place_measures,
    signal_paths_mm,
)
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.support.pages import ROOT

PLACES = np.array([[0.0, 0.0], [5.0, -3.0], [9.0, 4.0], [-2.0, 8.0]])


def test_a_box_is_flat_and_its_border_is_the_nearest_edge():
    frame = flat_frame(1, np.array([30.0, 20.0, 15.0]))
    x, y = abs(PLACES).T
    assert_allclose(border_distance_mm(frame, PLACES), np.minimum(30 - x, 20 - y))
    assert_allclose(curvature(frame, PLACES), 0.0)


def test_a_ball_curves_evenly_and_its_border_lies_at_60_degrees():
    radius = 25.0
    frame = cap_frame(1, np.full(3, radius), np.zeros(3))
    polar = np.arcsin(np.hypot(*PLACES.T) / radius)
    assert_allclose(curvature(frame, PLACES), 1 / radius, rtol=1e-5)
    assert_allclose(border_distance_mm(frame, PLACES), radius * (np.pi / 3 - polar), rtol=2e-3)


def test_round_a_cylinder_the_curvature_is_half_as_large():
    frame = replace(flat_frame(3, np.full(3, 20.0)), relief=Cap((np.inf, 20.0, 20.0)))
    assert_allclose(curvature(frame, PLACES), 1 / 40, rtol=1e-5)


def test_a_signal_path_is_the_shortest_over_a_body_to_the_part_nearest_to_it():
    moving, fixed = (
        np.array([[0.0, 0, 5], [6, 0, 5]]),
        np.array([[0.0, 3, 1], [6, 8, 5], [6, 0, -1]]),
    )
    between = np.array([5.0, 6.0])
    away = np.array([[1.0, 7.0], [4.0, 0.5]])
    wanted = (away + SENSOR_SHARE * between).min(axis=1)
    assert_allclose(signal_paths_mm(away, moving, fixed), wanted)
    assert_allclose(wanted, [1 + SENSOR_SHARE * 5, 0.5 + SENSOR_SHARE * 6])


@pytest.mark.parametrize("kind", ["box", "cylinder"])
def test_the_nearest_magnet_may_belong_to_another_face(kind):
    spec = ObjectSpec.model_validate(
        {
            "name": "one",
            "body": {"kind": kind, "size_mm": [42.0, 42.0, 48.0]},
            "magnets": {"positions_mm": [[12.0, 0.0]]},
        }
    )
    found, grid = place_measures(spec), contact_grid(spec)
    frames = face_frames(spec)
    spots = np.stack([frame.to_object(np.array([12.0, 0.0, 0.0])) for frame in frames])
    place = int(np.argmin(np.hypot(*(grid.xy_mm - [-13.5, 1.5]).T)))
    for row, frame in enumerate(frames):
        point = frame.to_object(np.append(frame.to_plane(grid.xy_mm[place]), 0.0))
        away = np.linalg.norm(point - spots, axis=1)
        assert_allclose(found.magnet_mm[row, place], away.min())
    assert (found.magnet_mm[:, place] < np.hypot(*(grid.xy_mm[place] - [12.0, 0.0])) - 1).any()


@pytest.mark.parametrize("arrangement", ["sensors-in-core", "sensors-in-shell"])
def test_the_signal_path_goes_over_the_best_magnet_to_a_sensor_of_the_face(arrangement):
    example = "reverse_cube" if arrangement == "sensors-in-shell" else "paper_cube"
    spec = load_spec(ROOT / f"examples/{example}.toml")
    found, grid = place_measures(spec), contact_grid(spec)
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    moving, face, fixed, other = magnets.centre_mm, magnets.face, sensors.position_mm, sensors.face
    if arrangement == "sensors-in-shell":
        moving, face, fixed, other = fixed, other, moving, face
    top = [point for point, number in zip(fixed, other, strict=True) if number == 1]
    place = int(np.argmin(np.hypot(*(grid.xy_mm - [7.5, 1.5]).T)))
    touched = np.append(grid.xy_mm[place], 21.0)
    paths = []
    for point, number in zip(moving, face, strict=True):
        spot = {1: [*point[:2], 21.0], 2: [point[0], -21.0, point[2]], 3: [21.0, *point[1:]]}
        away = np.linalg.norm(touched - spot.get(int(number), [-99.0] * 3))
        paths.append(away + 0.6 * min(np.linalg.norm(point - sensor) for sensor in top))
    assert_allclose(found.path_mm[0, place], min(paths), rtol=1e-6)
