"""Bayes' optimum with the object's own signals: the best that can be said of a frame by itself.

The object's table gives the signal of every contact case at every phase of its press: a dense grid
of hypotheses with known prior. With Gaussian disturbances (white noise, rounding, the zeroing error
and what drift adds, as one independent offset) each frame has an exact posterior over them, and each
metric its own best answer:

- force error: at every pixel the posterior median, which minimises the expected absolute error
  summed over pixels (`median_map_n`);
- total force: its posterior median (`total_n`);
- similarity and place: the most probable case at its median force (`case_map_n`), the most probable
  exact answer; the posterior mean does better where several places are alike (`mean_map_n`);
- contact: the posterior probability of rest.

Frames are judged one by one, and only contact cases of the protocol are possible: an estimator that
follows a press through time may do better, one that must also consider other places does worse. The
grid of 300 phases costs 0.1 % of the force error, one of 100 0.3 %, against 600 (single contacts of
the paper's cube).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.frames.contact_cases import ContactCase
from estimator.frames.contact_traces import ContactTraces, force_at_travel
from estimator.frames.heatmap import mm_to_pixel
from estimator.signals.monotone import monotone_cubic

PHASES = 300
CHUNK_BYTES = 1.5e8
_ROUNDING_COUNTS = 12**-0.5


@dataclass(frozen=True)
class Hypotheses:
    """Every case at every phase, forces increasing along the phases.

    Attributes
    ----------
    counts : (case, phase, channel), expected changes against rest
    map_n : (case, phase, nx, ny) labels as heatmaps
    rest_share : prior probability of rest; the cases share what is left
    """

    counts: Float[np.ndarray, "case phase channel"]
    map_n: Float[np.ndarray, "case phase nx ny"]
    rest_share: float

    @property
    def total_n(self) -> Float[np.ndarray, "case phase"]:
        """Total force."""
        return self.map_n.sum(axis=(2, 3))


@dataclass(frozen=True)
class BestAnswers:
    """Per frame; see the module."""

    median_map_n: Float[np.ndarray, "frame nx ny"]
    case_map_n: Float[np.ndarray, "frame nx ny"]
    mean_map_n: Float[np.ndarray, "frame nx ny"]
    total_n: Float[np.ndarray, "frame"]
    rest_probability: Float[np.ndarray, "frame"]


def press_hypotheses(
    spec: ObjectSpec,
    cases: Sequence[ContactCase],
    traces: ContactTraces,
    peak_mm: Float[np.ndarray, "case"],
    face: int,
    rest_share: float,
    phases: int = PHASES,
) -> Hypotheses:
    """Hypotheses of periodic presses (raised-cosine travel), labelled on one face."""
    turn = (np.arange(phases) + 0.5) / phases / 2
    travel = peak_mm[:, None] * (1 - np.cos(2 * np.pi * turn)) / 2
    total = force_at_travel(traces, travel)
    values = monotone_cubic(
        traces.force_n, np.concatenate([traces.counts, traces.tip_force_n], axis=2), total
    )
    channels = traces.counts.shape[2]
    grid = contact_grid(spec)
    maps = np.zeros((len(cases), phases, *grid.shape))
    for row, case in enumerate(cases):
        pixel = mm_to_pixel(case.xy_mm, grid.x_mm, grid.y_mm)
        for cell in np.unique(case.cell):
            (tips,) = np.nonzero(case.cell == cell)
            share = values[row, :, channels + tips].sum(axis=0) / len(tips)
            for tip in tips:
                if case.face[tip] == face:
                    maps[row, :, pixel[tip, 0], pixel[tip, 1]] += share
    return Hypotheses(values[..., :channels], maps, rest_share)


def disturbance_sigma(
    spec: ObjectSpec, channels: Int[np.ndarray, "channel"], drift_counts: float = 0.0
) -> Float[np.ndarray, "channel"]:
    """Standard deviation (counts) of a frame: noise, rounding, zeroing error and given drift."""
    noise = np.asarray(spec.sensors.noise_counts, float)[channels % 3]
    offset = np.hypot(spec.sensors.zeroing_counts, drift_counts)
    return np.sqrt(noise**2 + offset**2 + _ROUNDING_COUNTS**2)


def best_answers(
    hypotheses: Hypotheses,
    seen_counts: Float[np.ndarray, "frame channel"],
    sigma_counts: Float[np.ndarray, "channel"],
) -> BestAnswers:
    """Posterior-optimal answers for every frame."""
    parts = [
        _answers(hypotheses, posterior)
        for posterior in chunked_posterior(hypotheses, seen_counts, sigma_counts)
    ]
    return BestAnswers(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def chunked_posterior(
    hypotheses: Hypotheses,
    seen_counts: Float[np.ndarray, "frame channel"],
    sigma_counts: Float[np.ndarray, "channel"],
) -> Iterator[Float[np.ndarray, "some hypothesis"]]:
    """Posteriors of frames, in batches that fit into memory; rest is the last column."""
    channels = hypotheses.counts.shape[-1]
    white = (hypotheses.counts / sigma_counts).reshape(-1, channels)
    chunk = max(1, int(CHUNK_BYTES / 8 / len(white)))
    for seen in np.array_split(seen_counts, int(np.ceil(len(seen_counts) / chunk))):
        yield _posterior(hypotheses, white, seen / sigma_counts)


def _posterior(
    hypotheses: Hypotheses, white: np.ndarray, seen: np.ndarray
) -> Float[np.ndarray, "frame hypothesis"]:
    """Weights of all hypotheses, those of rest last; they add up to 1."""
    half = np.sum(white**2, axis=1) / 2
    log = seen @ white.T - half
    log += np.log((1 - hypotheses.rest_share) / len(white))
    rest = np.full((len(seen), 1), np.log(max(hypotheses.rest_share, 1e-300)))
    log = np.concatenate([log, rest], axis=1)
    log -= log.max(axis=1, keepdims=True)
    weight = np.exp(log)
    return weight / weight.sum(axis=1, keepdims=True)


def _answers(hypotheses: Hypotheses, posterior: np.ndarray) -> tuple[np.ndarray, ...]:
    cases, phases, nx, ny = hypotheses.map_n.shape
    weight = posterior[:, :-1].reshape(-1, cases, phases)
    case_share = weight.sum(axis=2)
    best = case_share.argmax(axis=1)
    row = np.arange(len(weight))
    within = weight[row, best].cumsum(axis=1)
    median = np.argmax(within >= within[:, -1:] / 2, axis=1)
    mean = weight.reshape(len(weight), -1) @ hypotheses.map_n.reshape(-1, nx * ny)
    return (
        _median_maps(hypotheses, weight, case_share),
        hypotheses.map_n[best, median],
        mean.reshape(-1, nx, ny),
        _weighted_median(hypotheses.total_n.ravel(), posterior),
        posterior[:, -1],
    )


def _weighted_median(value: np.ndarray, posterior: np.ndarray) -> Float[np.ndarray, "frame"]:
    """Of the values of all hypotheses, 0 for rest (last)."""
    every = np.append(value, 0.0)
    order = np.argsort(every, kind="stable")
    return every[order][np.argmax(posterior[:, order].cumsum(axis=1) >= 0.5 - 1e-12, axis=1)]


def _median_maps(
    hypotheses: Hypotheses, weight: np.ndarray, case_share: np.ndarray
) -> Float[np.ndarray, "frame nx ny"]:
    """Pixels that are pressed with a probability of at most one half have the median 0."""
    cases, _, nx, ny = hypotheses.map_n.shape
    pressed = hypotheses.map_n[:, -1].reshape(cases, nx * ny) > 0
    share = case_share @ pressed
    medians = np.zeros((len(weight), nx * ny))
    for pixel in np.flatnonzero((share > 0.5).any(axis=0)):
        (mine,) = np.nonzero(pressed[:, pixel])
        (frames,) = np.nonzero(share[:, pixel] > 0.5)
        force = hypotheses.map_n.reshape(*hypotheses.map_n.shape[:2], -1)[mine, :, pixel].ravel()
        order = np.argsort(force)
        mass = weight[np.ix_(frames, mine)].reshape(len(frames), -1)[:, order].cumsum(axis=1)
        missing = 1 - share[frames, pixel][:, None]
        medians[frames, pixel] = force[order][np.argmax(mass + missing >= 0.5, axis=1)]
    return medians.reshape(-1, nx, ny)
