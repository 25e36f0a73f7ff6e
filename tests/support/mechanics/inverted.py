"""An object of analytic presses, and the estimator that inverts it."""

from functools import lru_cache

import numpy as np

from design.layout.places.contact_grid import contact_grid
from estimator.information.shear import ShearSignals
from estimator.inversion.inversion import Inversion, inversion
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, face_motion, synthetic_presses
from tests.support.recordings.frame_sets import frame_set

SPEC = coarse_spec(contact_grid={"count": (9, 9), "pitch_mm": 3.0})
SHARE = 0.5
PULLING = SPEC.changed(inversion=SPEC.inversion.changed(tangential_share=SHARE))
"""The same object where contacts may pull sideways."""


def shear_of(spec):
    """Some 58 counts per newton, other at every place and depth."""
    grid, depth = contact_grid(spec), np.asarray(spec.press.depths_mm)
    slope = np.random.default_rng(1).normal(0, 58, (5, 1, 1, 2, 15, 3))
    turned = 1 + 0.02 * grid.xy_mm[:, 0] + 0.01 * grid.xy_mm[:, 1]
    growing = 1 + 0.1 * depth
    per_n = slope * (turned[:, None] * growing)[None, :, :, None, None, None]
    return ShearSignals(np.arange(1, 6), grid, depth, per_n)


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
    """Undisturbed changes of counts. What contacts do to each other comes from the exact field of their
    summed motions, which the model that reads them takes to second order."""
    filled = face >= 0
    moved = np.zeros((*face.shape, *model.rest.shape))
    each = model.motions.expected(face[filled], contact[filled])
    moved[filled] = each.reshape(-1, *model.rest.shape)
    exact = model.counts_of_motions(np.concatenate([moved[filled], moved.sum(axis=1)]))
    alone = np.zeros((*face.shape, exact.shape[1]))
    alone[filled] = exact[: -len(face)]
    together = exact[-len(face) :] - alone.sum(axis=1)
    return model.singles(face, contact)[:, :, 0].sum(axis=1) + together


def motion_of(face, contact):
    """Motions of the magnets under all contacts of each frame, by the object's own law."""
    moved = np.zeros((len(face), 25, 6))
    for row, slot in np.argwhere(face >= 0):
        x, y, force = contact[row, slot]
        moved[row] += face_motion(SPEC, face[row, slot] + 1, np.array([x, y]), np.array(force))
    return moved


def right(found, face):
    """Frames with as many contacts on every face."""
    faces = np.sort(np.where(face >= 0, face + 1, 0), axis=1)
    return np.all(np.sort(found.face, axis=1) == faces, axis=1)


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
    signal = np.zeros((len(face), 5, 3, 3))
    return frame_set(signal, face, xy, force, source="simulated")
