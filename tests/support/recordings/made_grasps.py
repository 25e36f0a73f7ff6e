"""Recordings of grasps on an object off the design: one, two or three tips on each of two faces."""

from dataclasses import replace

import numpy as np

from design.layout.places.contact_grid import contact_grid
from design.layout.tips import tip_positions_mm
from estimator.frames.dataset import FrameSet
from estimator.inversion.model.forward import contact_model
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.inverted import SPEC, expected_counts, labelled_frames, presses

FACES = (3, 5)
FRAMES = 16
"""Of a press: a rest frame, then a force that grows to its peak and falls."""
_PRESSES = 2


def built_object(seed=4):
    """Its forward model: single presses of an object within tolerances."""
    forces, motions, _ = presses()
    built = twin_signals(SPEC, drawn_assembly(SPEC, seed), forces, motions)
    return contact_model(SPEC, forces, motions, built)


def grasps(model, tips, cases, seed=0, peak_n=16.0) -> FrameSet:
    """Labelled frames of `cases` grasps with so many tips on each of two faces, each pressed twice."""
    rng = np.random.default_rng((seed, tips))
    share = np.concatenate([[0.0], np.sin(np.pi * (np.arange(FRAMES - 1) + 0.5) / (FRAMES - 1))])
    frames = cases * _PRESSES * FRAMES
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    for case in range(cases):
        rows = slice(case * _PRESSES * FRAMES, (case + 1) * _PRESSES * FRAMES)
        force = np.tile(share, _PRESSES) * peak_n / tips * rng.uniform(0.9, 1.1)
        for jaw, row in enumerate(np.flatnonzero(np.isin(model.signals.faces, FACES))):
            slots = slice(jaw * tips, (jaw + 1) * tips)
            face[rows, slots] = np.where(force > 0, row, -1)[:, None]
            contact[rows, slots, :2] = _standing(tips, rng)
            contact[rows, slots, 2] = force[:, None]
    counts = expected_counts(model, face, contact)
    counts += rng.normal(0, 1, counts.shape) * np.tile(SPEC.sensors.noise_counts, 15)
    zero = rng.normal(0, SPEC.sensors.zeroing_counts, (cases * _PRESSES, 45))
    counts += zero.repeat(FRAMES, axis=0)
    there, grid = (face >= 0)[..., None], contact_grid(SPEC)
    number = np.where(face >= 0, model.signals.faces[face], 0)
    placed = np.where(there, contact, np.nan)
    press = np.arange(frames) // FRAMES
    return replace(
        labelled_frames(number, placed[..., :2], placed[..., 2]),
        signal_counts=counts.reshape(frames, 5, 3, 3),
        press_id=press,
        place_id=np.where(there.any(axis=(1, 2)), press // _PRESSES, -1),
        grid_x_mm=grid.x_mm,
        grid_y_mm=grid.y_mm,
        noise_counts=np.asarray(SPEC.sensors.noise_counts, float),
        spec_hash=f"grasps-{tips}",
        source="recorded",
    )


def both(first: FrameSet, second: FrameSet) -> FrameSet:
    """Two recordings of one object as one data set."""
    from estimator.frames.dataset import PER_FRAME_FIELDS

    moved = replace(
        second,
        press_id=second.press_id + first.press_id.max() + 1,
        place_id=np.where(second.place_id < 0, -1, second.place_id + first.place_id.max() + 1),
        session_id=second.session_id + 1,
    )
    return replace(
        first,
        **{
            name: np.concatenate([getattr(first, name), getattr(moved, name)])
            for name in PER_FRAME_FIELDS
        },
    )


def _standing(tips, rng):
    """Tips of the paper's probes, turned and shifted within the table."""
    angle = rng.uniform(0, 2 * np.pi)
    c, s = np.cos(angle), np.sin(angle)
    places = tip_positions_mm(tips, 5.0) @ np.array([[c, s], [-s, c]])
    room = 11.0 - abs(places).max(axis=0)
    return places + rng.uniform(-1, 1, 2) * np.maximum(room, 0.0)
