"""A pad pressed over its face: motions in closed form, recordings in the format of the eFlesh project."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from design.layout.places.contact_grid import PlaceGrid
from design.layout.places.positions import magnet_layout
from design.spec_io import load_spec
from estimator.calibration.known_travel.model import Pose, travel_model
from estimator.recordings.formats.travel import TravelRecording
from fem.presses.results import MagnetMotions

PAD = Path(__file__).parents[3] / "examples" / "eflesh_pad.toml"
POSE = Pose(np.array([290.0, -101.5]), 0.06, 147.0, 4)
"""Mirrored: the machine's x is the object's y."""
RESTING_MT = np.arange(15.0).reshape(5, 3)


def pad_model():
    """Magnets sink and move aside as bells about the place pressed, linear in the travel."""
    spec = load_spec(PAD)
    axis = np.linspace(-21, 21, 15)
    lattice, travel = PlaceGrid(axis, axis), np.array([1.0, 2.0, 4.0, 7.0])
    layout = magnet_layout(spec)
    offset = layout.centre_mm[None, :, :2] - lattice.xy_mm[:, None]
    bell = np.exp(-np.sum(offset**2, axis=-1) / (2 * 9.0**2))
    per_mm = np.zeros((len(lattice), len(layout.face), 6))
    per_mm[..., 2] = -0.25 * bell
    per_mm[..., :2] = 0.02 * bell[..., None] * offset
    per_mm[..., 3] = -0.01 * bell * offset[..., 1]
    motion = per_mm[None, :, None] * travel[None, None, :, None, None]
    return travel_model(spec, MagnetMotions(np.array([1]), lattice, travel, motion))


def pressed_places(count=9, presses=2, seed=3):
    """Places of a square grid about the object's, at random travels: (press, 3) of the machine."""
    rng = np.random.default_rng(seed)
    axis = np.linspace(-14, 14, count)
    xy = PlaceGrid(axis, axis).xy_mm + np.array([289.0, -100.0])
    xy = np.repeat(np.round(xy), presses, axis=0)
    return np.column_stack([xy, rng.uniform(141, 145, len(xy))])


def write_recording(folder, tip_mm, field_mt):
    """`sensor.csv` and `states.csv` as the project publishes them."""
    folder.mkdir(exist_ok=True)
    time = 1.7421e9 + 4.25 * np.arange(len(tip_mm))[:, None]
    sensor = np.hstack([time, 1e3 * field_mt.reshape(len(tip_mm), -1)])
    np.savetxt(folder / "sensor.csv", sensor, delimiter=",", fmt="%.6f")
    np.savetxt(folder / "states.csv", np.hstack([time + 0.002, tip_mm]), delimiter=",", fmt="%.6f")
    return folder


def recorded(model, tip_mm, noise_mt=0.005, **off):
    """Field of the object as it lies, `off` from its design, with noise."""
    twin = replace(model.design_twin(POSE), **off)
    noise = noise_mt * np.random.default_rng(0).standard_normal((len(tip_mm), 5, 3))
    return RESTING_MT + model.pressed(twin, tip_mm) + noise


def presses_of(tip_mm, field_mt):
    """A recording of these presses, places numbered by x and y."""
    _, place = np.unique(tip_mm[:, :2], axis=0, return_inverse=True)
    return TravelRecording(np.arange(len(tip_mm), dtype=float), tip_mm, field_mt, place.ravel())
