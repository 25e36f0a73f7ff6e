"""Simple readings of contacts, beside which those by inversion stand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from instobj.experiments.paper.grasps import fitted_to_single_faces, one_face_at_a_time
from instobj.experiments.paper.object import SimulatedObject

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion
    from estimator.inversion.readings import ContactSets

Found = list[tuple[int, float, float, float]]
"""Face, x, y (mm) and force (N) of the contacts of a frame."""


def pursued(inversion: Inversion, frames: FrameSet) -> ContactSets:
    """Matching pursuit: presses of the dictionary, 3 mm apart, one after the other, their signals
    added and all forces refitted, as long as half χ² falls by more than 3/2 ln(channels) (BIC)."""
    from scipy.optimize import nnls

    from estimator.inversion.matching import all_counts

    presses, faces = inversion.search.dictionary, inversion.model.signals.faces
    seen = inversion.disturbances.observed(all_counts(frames))
    every: list[Found] = []
    for counts, sigma in zip(seen.counts, seen.sigma, strict=True):
        white, target = (presses.counts / sigma).T.astype(float), counts / sigma
        chosen: list[int] = []
        scale, left = np.zeros(0), target
        while len(chosen) < inversion.priors.most:
            along = left @ white / np.linalg.norm(white, axis=0)
            tried = [*chosen, int(np.argmax(along))]
            refitted, misfit = nnls(white[:, tried], target)
            if left @ left - misfit**2 < 3 * np.log(len(target)):
                break
            chosen, scale = tried, refitted
            left = target - white[:, chosen] @ scale
        contact = presses.contact[chosen, 0]
        every.append(
            [
                (int(faces[presses.face[k]]), x, y, factor * force)
                for k, (x, y, force), factor in zip(chosen, contact, scale, strict=True)
                if factor > 0
            ]
        )
    return _sets(every)


def of_networks(recorded: SimulatedObject, frames: FrameSet) -> ContactSets:
    """The whole-object networks of both faces, fitted to the paper's collection of the object itself,
    single faces pressed: every patch of pixels above 0.9 times the smallest contact force is one
    contact at its centre of force."""
    from scipy.ndimage import center_of_mass, label

    from estimator.metrics.heatmaps import NON_CONTACT_SHARE
    from estimator.networks.face_model import predict_heatmaps

    single = one_face_at_a_time(recorded)
    every: list[Found] = [[] for _ in range(len(frames))]
    for face in recorded.spec.collection.grasp_faces:
        model, reference = fitted_to_single_faces(recorded, single, face, "whole-object")
        limit = NON_CONTACT_SHARE * reference.smallest_contact_n
        for found, heatmap in zip(every, predict_heatmaps(model, frames), strict=True):
            patches, count = label(heatmap >= limit, np.ones((3, 3)))  # pyright: ignore[reportGeneralTypeIssues]
            for number in range(1, count + 1):
                i, j = center_of_mass(heatmap, patches, number)
                x, y = (
                    float(np.interp(at, np.arange(len(grid)), grid))
                    for at, grid in ((i, model.grid_x_mm), (j, model.grid_y_mm))
                )
                found.append((face, x, y, float(heatmap[patches == number].sum())))
    return _sets(every)


def _sets(every: list[Found]) -> ContactSets:
    """Without any uncertainty."""
    from estimator.inversion.readings import ContactSets

    slots = max(1, *map(len, every))
    values = np.full((len(every), slots, 4), np.nan)
    for row, found in zip(values, every, strict=True):
        row[: len(found)] = np.array(found).reshape(-1, 4)
    face = np.nan_to_num(values[..., 0]).astype(int)
    unknown = np.full((*face.shape, 3, 3), np.nan)
    pulls, ones = np.full((*face.shape, 2), np.nan), np.ones(len(every))
    return ContactSets(face, values[..., 1:3], values[..., 3], unknown, pulls, pulls, ones, ones)
