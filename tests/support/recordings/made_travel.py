"""Presses of known travel on a field made up: motions are place and travel, changes quadratic."""

from types import SimpleNamespace

import numpy as np

from estimator.calibration.known_travel.model import SYMMETRIES, Pose, TravelModel, Twin
from estimator.recordings.formats.travel import TravelRecording

POSE = Pose(np.array([10.0, -4.0]), 0.3, 7.0, 3)
TWIN = Twin(POSE, np.zeros((2, 3)), np.zeros((2, 2)))
RESTING_MT = np.array([[1.0, -2, 3], [4, 5, -6], [0.5, 0, 7]])


class Made(TravelModel):
    """Motions that are place and travel, a field that is quadratic in them."""

    def __init__(self):
        scene = SimpleNamespace(magnets=SimpleNamespace(face=np.ones(2, int)))
        self.__dict__.update(scene=scene, asked=[])

    def covers(self, xy_mm):
        return xy_mm[:, 0] > -4.0

    def motion(self, xy_mm, travel_mm):
        self.asked.append((xy_mm, travel_mm))
        found = np.zeros((len(xy_mm), 2, 6))
        found[:, 0, :2], found[:, :, 2] = xy_mm, -0.6 * travel_mm[:, None]
        return found

    def change(self, twin, motion):
        assert twin is TWIN
        x, y, _ = motion[:, 0, :3].T
        by = -motion[:, 1, 2]
        parts = [x + 0.1 * x * y, 2 * y - 0.05 * y**2, 0.3 * by * x, 0.2 * x**2, by, 0.1 * x - y]
        return np.stack([*parts, by * y, by**2, 0.5 * by - 0.1 * x], axis=1).reshape(-1, 3, 3)


def of_machine(xy_mm, travel_mm):
    """Where a machine goes to press an object's places."""
    turn = np.array([[np.cos(0.3), -np.sin(0.3)], [np.sin(0.3), np.cos(0.3)]])
    xy = POSE.shift_mm + xy_mm @ SYMMETRIES[3].T @ turn.T
    return np.column_stack([xy, 7.0 - travel_mm])


def recording(xy_mm, travel_mm, place, noise_mt=0.0):
    model = Made()
    field = RESTING_MT + model.change(TWIN, model.motion(xy_mm, travel_mm))
    field = field + noise_mt * np.random.default_rng(0).standard_normal((len(xy_mm), 9, 9)).mean(
        axis=2, where=np.tri(9, dtype=bool)
    ).reshape(-1, 3, 3)
    return TravelRecording(np.arange(len(xy_mm)) * 1.0, of_machine(xy_mm, travel_mm), field, place)
