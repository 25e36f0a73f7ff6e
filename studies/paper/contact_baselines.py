"""Simple readings of contacts, with which those by inversion are compared."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Int

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion
    from estimator.inversion.readings import ContactSets
    from estimator.networks.face_model import FaceModel

FrameContacts = list[tuple[int, float, float, float]]
"""Face, x, y (mm) and force (N) of the contacts of a frame."""


def pursued(inversion: Inversion, frames: FrameSet) -> ContactSets:
    """Matching pursuit: presses of the dictionary, 3 mm apart, one after the other, their signals
    added and all forces refitted, as long as half χ² falls by more than 3/2 ln(channels) (BIC)."""
    from scipy.optimize import nnls

    from estimator.frames.windows import all_counts

    presses, faces = inversion.search.dictionary, inversion.model.signals.faces
    observed = inversion.disturbances.observed(all_counts(frames))
    contacts: list[FrameContacts] = []
    for counts, sigma in zip(observed.counts, observed.sigma, strict=True):
        white, target = (presses.counts / sigma).T.astype(float), counts / sigma
        chosen: list[int] = []
        scale, residual = np.zeros(0), target
        while len(chosen) < inversion.priors.most:
            correlation = residual @ white / np.linalg.norm(white, axis=0)
            tried = [*chosen, int(np.argmax(correlation))]
            refitted, misfit = nnls(white[:, tried], target)
            if residual @ residual - misfit**2 < 3 * np.log(len(target)):
                break
            chosen, scale = tried, refitted
            residual = target - white[:, chosen] @ scale
        contact = presses.contact[chosen, 0]
        contacts.append(
            [
                (int(faces[presses.face[k]]), x, y, factor * force)
                for k, (x, y, force), factor in zip(chosen, contact, scale, strict=True)
                if factor > 0
            ]
        )
    return contact_sets_of(contacts)


def patches(
    models: Sequence[tuple[FaceModel, float]], frames: FrameSet, rows: Int[np.ndarray, "chosen"]
) -> ContactSets:
    """Heatmaps of networks, each with the smallest force of a contact: every patch of pixels above 0.9
    times that is one contact at its centre of force. The networks see all frames, those before each too;
    read are the given rows."""
    from scipy.ndimage import center_of_mass, label

    from estimator.metrics.heatmaps import NON_CONTACT_SHARE
    from estimator.networks.face_model import predict_heatmaps

    contacts: list[FrameContacts] = [[] for _ in rows]
    for model, smallest_n in models:
        limit = NON_CONTACT_SHARE * smallest_n
        for row, heatmap in zip(contacts, predict_heatmaps(model, frames)[rows], strict=True):
            patch, count = label(heatmap >= limit, np.ones((3, 3)))  # pyright: ignore[reportGeneralTypeIssues]
            for number in range(1, count + 1):
                i, j = center_of_mass(heatmap, patch, number)
                x, y = (
                    float(np.interp(index, np.arange(len(grid)), grid))
                    for index, grid in ((i, model.grid_x_mm), (j, model.grid_y_mm))
                )
                row.append((model.face, x, y, float(heatmap[patch == number].sum())))
    return contact_sets_of(contacts)


def contact_sets_of(contacts: list[FrameContacts]) -> ContactSets:
    """Without any uncertainty."""
    from estimator.inversion.model.forward import NONE
    from estimator.inversion.readings import ContactSets

    slots = max(1, *map(len, contacts))
    values = np.full((len(contacts), slots, 4), np.nan)
    for row, frame in zip(values, contacts, strict=True):
        row[: len(frame)] = np.array(frame).reshape(-1, 4)
    face = np.nan_to_num(values[..., 0]).astype(int)
    unknown = np.full((*face.shape, 3, 3), np.nan)
    pulls, ones = np.full((*face.shape, 2), np.nan), np.ones(len(contacts))
    out, sizes = np.full(len(contacts), NONE), np.full((*face.shape, 2, 2), np.nan)
    places = face, values[..., 1:3], values[..., 3]
    none = np.zeros((len(contacts), 0))
    return ContactSets(*places, unknown, pulls, pulls, ones, ones, out, none, none, pulls, sizes)
