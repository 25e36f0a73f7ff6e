"""The narrowest intervals that hold what they promise, from the posterior of `bayes_optimum`.

Given a contact, half-width and radius hold the labelled force and centre with the wanted
probability, as intervals of trained estimators do; the label has the load cell's noise. Places of
the hypotheses are those of the collection: where the posterior leaves one case alone the radius is
0, and only forces can be compared.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from studies.paper.bayes_optimum import Hypotheses, chunked_posterior

_NOISE_NODES = 41
_HALVINGS = 30


@dataclass(frozen=True)
class BestIntervals:
    """Per frame: half-width about the posterior median of the total force (N), radius about the
    better of the posterior mean and the likeliest case (mm)."""

    force_n: Float[np.ndarray, "frame"]
    force_halfwidth_n: Float[np.ndarray, "frame"]
    position_radius_mm: Float[np.ndarray, "frame"]


def best_intervals(
    hypotheses: Hypotheses,
    centre_mm: Float[np.ndarray, "case 2"],
    seen_counts: Float[np.ndarray, "frame channel"],
    sigma_counts: Float[np.ndarray, "channel"],
    cover: float,
    label_noise_n: float,
) -> BestIntervals:
    """Posterior intervals of frames in contact.

    Parameters
    ----------
    centre_mm : centre of force of each case
    label_noise_n : standard deviation of the labelled force, N; its normal distribution stands as
        41 equally likely values (half-widths off by 1 % of it)
    """
    force_n = hypotheses.total_n.ravel()
    order = np.argsort(force_n, kind="stable")
    cases, phases = hypotheses.total_n.shape
    parts = []
    for weight in chunked_posterior(hypotheses, seen_counts, sigma_counts):
        contact = weight[:, :-1] / weight[:, :-1].sum(axis=1, keepdims=True)
        cumulative = contact[:, order].cumsum(axis=1)
        case_share = contact.reshape(-1, cases, phases).sum(axis=2)
        median = force_n[order][np.argmax(cumulative >= 0.5, axis=1)]
        width = covering_halfwidths(force_n[order], cumulative, median, cover, label_noise_n)
        parts.append((median, width, covering_radii(centre_mm, case_share, cover)))
    return BestIntervals(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def covering_halfwidths(
    force_n: Float[np.ndarray, "hypothesis"],
    cumulative: Float[np.ndarray, "frame hypothesis"],
    median_n: Float[np.ndarray, "frame"],
    cover: float,
    noise_n: float,
) -> Float[np.ndarray, "frame"]:
    """Smallest h with P(|F + noise − median| ≤ h) ≥ cover, by halving; forces ascend."""
    from scipy.special import ndtri

    noise = noise_n * ndtri((np.arange(_NOISE_NODES) + 0.5) / _NOISE_NODES)
    padded = np.concatenate([np.zeros((len(median_n), 1)), cumulative], axis=1)

    def below(limit: np.ndarray, side: str) -> np.ndarray:
        index = np.searchsorted(force_n, limit, side)  # pyright: ignore[reportCallIssue, reportArgumentType]
        return np.take_along_axis(padded, index, axis=1)

    low = np.zeros(len(median_n))
    high = np.full(len(median_n), force_n[-1] - force_n[0] + 10 * noise_n)
    middle = median_n[:, None] - noise
    for _ in range(_HALVINGS):
        tried = (low + high) / 2
        upper, lower = middle + tried[:, None], middle - tried[:, None]
        inside = (below(upper, "right") - below(lower, "left")).mean(axis=1) >= cover
        low, high = np.where(inside, low, tried), np.where(inside, tried, high)
    return high


def covering_radii(
    centre_mm: Float[np.ndarray, "case 2"],
    case_share: Float[np.ndarray, "frame case"],
    cover: float,
) -> Float[np.ndarray, "frame"]:
    about = (case_share @ centre_mm, centre_mm[case_share.argmax(axis=1)])
    radii = []
    for centre in about:
        away = np.linalg.norm(centre_mm - centre[:, None], axis=2)
        order = np.argsort(away, axis=1)
        held = np.take_along_axis(case_share, order, axis=1).cumsum(axis=1) >= cover
        nearest = np.take_along_axis(away, order, axis=1)
        radii.append(nearest[np.arange(len(away)), held.argmax(axis=1)])
    return np.minimum(*radii)
