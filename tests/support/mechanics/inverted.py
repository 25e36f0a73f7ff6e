"""An object of analytic presses, and the estimator that inverts it."""

from functools import lru_cache

import numpy as np

from estimator.frames.dataset import FrameSet
from estimator.inversion.inversion import Inversion, inversion
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(contact_grid={"count": (9, 9), "pitch_mm": 3.0})


@lru_cache(maxsize=1)
def presses():
    """Forces, motions and signals of the object."""
    forces, motions = synthetic_presses(SPEC)
    return forces, motions, press_signals(SPEC, forces, motions)


@lru_cache(maxsize=2)
def inverted(probes: str = "free") -> Inversion:
    """Its estimator, exact but for interpolation."""
    spec = SPEC.changed(inversion=SPEC.inversion.changed(probes=probes))
    return inversion(spec, *presses(), model_error=0.0, force_error=0.0)


def contacts(rng, frames: int, number: int, force_n=(2.0, 8.0), slots: int = 6):
    """Faces (frame, slot) and contacts (frame, slot, 3) anywhere, tips on a face 10.5 mm apart."""
    face, contact = np.full((frames, slots), -1), np.zeros((frames, slots, 3))
    for row in range(frames):
        while True:
            on, xy = rng.integers(0, 5, number), rng.uniform(-12, 12, (number, 2))
            away = np.linalg.norm(xy[:, None] - xy, axis=2) + 99 * (on[:, None] != on)
            if np.all(away + 99 * np.eye(number) > 10.5):
                break
        face[row, :number], contact[row, :number, :2] = on, xy
        contact[row, :number, 2] = rng.uniform(*force_n, number)
    return face, contact


def expected_counts(model, face, contact):
    """Undisturbed changes of counts."""
    return model.singles(face, contact)[:, :, 0].sum(axis=1) + model.interaction(face, contact)


def noisy_counts(estimator, face, contact, rng, turned=True):
    """As frames show them, each of an object that has turned and warmed up, or of one that stands still."""
    counts = expected_counts(estimator.model, face, contact)
    told = estimator.disturbances
    sigma = np.hypot(told.noise_counts, told.offset_counts)
    noisy = counts + sigma * rng.standard_normal(counts.shape)
    unknowns = turned * rng.standard_normal((len(counts), told.columns.shape[1]))
    return noisy + unknowns @ told.columns.T


def frame_covariance(seen, row):
    """Of one frame's counts about what contacts give: independent noise, and nuisances."""
    return np.diag(seen.sigma[row] ** 2) + seen.columns @ seen.columns.T


def labelled_frames(face, xy, force):
    """Labelled frames without signals worth the name."""
    frames = len(face)
    return FrameSet(
        signal_counts=np.zeros((frames, 5, 3, 3)),
        contact_face=face,
        contact_xy_mm=xy,
        force_n=np.stack([0 * force, 0 * force, force], axis=-1),
        valid=np.ones(frames, bool),
        press_id=np.arange(frames),
        place_id=np.zeros(frames, int),
        session_id=np.zeros(frames, int),
        time_s=np.arange(frames) / 10,
        faces=np.arange(1, 6),
        grid_x_mm=np.arange(3.0),
        grid_y_mm=np.arange(3.0),
        noise_counts=np.ones(3),
        source="simulated",
        spec_hash="x",
        seed=1,
    )
