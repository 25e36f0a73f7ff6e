"""Places that nobody pressed: place and travel read from the field, learnt from few labelled places.

Three readers learn from the same labelled presses and are judged on all other places at unknown travel:
the nearest labelled press; a Gaussian process of place and travel over the readings; and the same on
top of the twin, which reads a table of its own presses first and has the process correct what is left.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.spatial import KDTree

from estimator.calibration.known_travel.fit import Fitted, left_over
from estimator.calibration.known_travel.model import TravelModel
from estimator.recordings.formats.travel import TravelRecording

TABLE_MM = (1.0, 0.5)
"""Steps of the twin's table in place and travel."""
MOST_PRESSES = 500
"""Presses that are judged, at most, drawn at random."""
_NEIGHBOURS = 6
"""Nodes of the table from which a place is taken."""
_LEAST_SHARE = 0.05
"""Of the mean variance, kept in every direction of what a twin leaves."""


@dataclass(frozen=True)
class PlaceErrors:
    """Distance of the place read from that pressed, and of the travel, mm: medians and rms."""

    place_median_mm: float
    place_rms_mm: float
    travel_median_mm: float
    travel_rms_mm: float


def readers(
    model: TravelModel,
    fitted: Fitted,
    labelled: TravelRecording,
    judged: TravelRecording,
    seed: int,
) -> dict[str, PlaceErrors]:
    """Errors of every reader on the judged presses, and of the middle of the labelled ones."""
    known, true = labelled.tip_mm, judged.tip_mm
    shown, asked = (r.field_mt.reshape(len(r), -1) for r in (labelled, judged))
    scale = shown.std(axis=0)
    shown, asked = shown / scale, asked / scale
    twin_known, twin_asked = (
        places_by_twin(model, fitted, labelled, r) for r in (labelled, judged)
    )
    correction = gaussian_process(
        np.hstack([shown, twin_known]), known - twin_known, np.hstack([asked, twin_asked]), seed
    )
    found = {
        "middle of the labelled places": np.broadcast_to(known.mean(axis=0), true.shape),
        "nearest labelled press": known[_nearest(shown, asked)],
        "Gaussian process": gaussian_process(shown, known, asked, seed),
        "twin alone": twin_asked,
        "twin and Gaussian process": twin_asked + correction,
    }
    return {name: place_errors(read, true) for name, read in found.items()}


def places_by_twin(
    model: TravelModel, fitted: Fitted, labelled: TravelRecording, asked: TravelRecording
) -> Float[np.ndarray, "press 3"]:
    """Machine's place whose predicted field is nearest, in units of what the twin leaves on labels.

    The mean of the nearest nodes of the table, weighed by their likelihood.
    """
    left = left_over(model, fitted, labelled).reshape(len(labelled), -1)
    covariance = left.T @ left / len(left)
    floor = _LEAST_SHARE * np.trace(covariance) / len(covariance)
    root = np.linalg.cholesky(np.linalg.inv(covariance + floor * np.eye(len(covariance))))
    low, high = asked.tip_mm.min(axis=0), asked.tip_mm.max(axis=0)
    steps = (TABLE_MM[0], TABLE_MM[0], TABLE_MM[1])
    axes = [np.arange(a, b + step / 2, step) for a, b, step in zip(low, high, steps, strict=True)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    predicted = (fitted.resting_mt + model.pressed(fitted.twin, nodes)).reshape(len(nodes), -1)
    table, readings = predicted @ root, asked.field_mt.reshape(len(asked), -1) @ root
    distance, index = KDTree(table).query(readings, k=_NEIGHBOURS)
    weight = np.exp(-(distance**2 - distance[:, :1] ** 2) / 2)
    # Posterior mean under Gaussian noise, over the nearest nodes: p press, k neighbour, d coordinate
    return np.einsum("pk,pkd->pd", weight / weight.sum(axis=1, keepdims=True), nodes[index])


def _nearest(shown: np.ndarray, asked: np.ndarray) -> np.ndarray:
    return np.asarray(KDTree(shown).query(asked)[1])


def gaussian_process(
    inputs: np.ndarray, targets: np.ndarray, asked: np.ndarray, seed: int, most: int = MOST_PRESSES
) -> Float[np.ndarray, "press 3"]:
    """Gaussian processes of all targets over the principal directions of the inputs."""
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

    middle, spread = inputs.mean(axis=0), inputs.std(axis=0)
    x, query = (inputs - middle) / spread, (asked - middle) / spread
    size, offset = targets.std(axis=0), targets.mean(axis=0)
    y = (targets - offset) / size
    chosen = np.random.default_rng(seed).permutation(len(x))[:most]
    kernel = ConstantKernel(1.0) * RBF(4.0) + WhiteKernel(0.01)
    with warnings.catch_warnings():  # at a bound where the twin leaves nothing but noise
        warnings.simplefilter("ignore", ConvergenceWarning)
        process = GaussianProcessRegressor(kernel, random_state=seed).fit(x[chosen], y[chosen])
    if len(chosen) < len(x):
        process = GaussianProcessRegressor(process.kernel_, optimizer=None).fit(x, y)  # pyright: ignore[reportArgumentType]
    return np.asarray(process.predict(query)) * size + offset


def place_errors(read_mm: np.ndarray, true_mm: np.ndarray) -> PlaceErrors:
    place = np.linalg.norm(read_mm[:, :2] - true_mm[:, :2], axis=1)
    travel = np.abs(read_mm[:, 2] - true_mm[:, 2])
    return PlaceErrors(
        float(np.median(place)),
        float(np.sqrt(np.mean(place**2))),
        float(np.median(travel)),
        float(np.sqrt(np.mean(travel**2))),
    )
