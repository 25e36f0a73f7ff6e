"""Slips of the core that stay: noticed in frames at rest, and carried over into the readings that follow.

A slip moves all magnets against all chips at once. Six unknowns then explain every channel of an object at
rest, which neither contacts nor a magnet near by do. A single press on a slipped core is less clear, so the
slip is taken from the mean of frames at rest and believed from then on.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.special import chdtrc

from estimator.inversion.explained import UNEXPLAINED
from estimator.inversion.inversion import Inversion
from estimator.inversion.magnets import slip_motions
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.model.whitening import Whitening, whitening

REST_FRAMES = 10
"""Frames at rest on end whose mean is judged."""
_SURE = 8.0
"""Log evidence of a slip over that of rest, and of a magnet near by, from which it is believed. Six unknowns
without a slip reach it with a chance of about 1e-8: log evidence is half of χ² with six degrees of freedom
(48 of them) less the 16 that the prior of the slip costs."""
_STEPS = 4
"""Gauss–Newton steps: signals of slips above 0.3 mm are not linear in them."""
_TRIED = 20
"""Frames without explanation of a data set that are tried, at most."""
_HALF_STEP = 0.1
"""Half the step of central differences, in standard deviations of a slip: 0.01 mm."""


@dataclass(frozen=True)
class Slip:
    """A slip of the core since the calibration.

    Attributes
    ----------
    unknowns : (6,) in standard deviations, as in `slip_columns`
    size_mm : rms motion of what the shell holds against the core
    counts : (channel,) that it adds at rest, against the zero
    columns : (channel, k) what is uncertain of these counts, a standard deviation of each unknown
    """

    unknowns: Float[np.ndarray, "6"]
    size_mm: float
    counts: Float[np.ndarray, "channel"]
    columns: Float[np.ndarray, "channel k"]

    def carried(self) -> Slip:
        """Return the slip once the zero was moved by its counts: what is uncertain of them stays."""
        return replace(self, counts=np.zeros_like(self.counts))

    def zeroed(self) -> Slip:
        """Return the slip once the zero was taken after it."""
        return replace(self.carried(), columns=self.columns[:, :0])


def no_slip(model: ContactModel) -> Slip:
    """Return a core that sits where it was calibrated."""
    return Slip(np.zeros(6), 0.0, np.zeros(model.channels), np.zeros((model.channels, 0)))


def slip_at_rest(
    inversion: Inversion,
    counts: Float[np.ndarray, "channel"],
    frames: int = 1,
    drift_counts: float = 0.0,
    earlier: Slip | None = None,
) -> Slip | None:
    """Return the slip that the mean change of some frames at rest shows; None where rest, a magnet near by
    or nothing explains it better.

    Parameters
    ----------
    counts : mean change against the zero; NaN where a channel has no reading
    drift_counts : deviation of what every channel drifted since the zero
    earlier : the slip that is known already, against which the new one is sought
    """
    model = inversion.model
    earlier = no_slip(model) if earlier is None else earlier
    change = (counts - earlier.counts)[None]
    frame = inversion.disturbances.observed(change, np.array([frames]), drift_counts)
    frame = frame.add_nuisances(earlier.columns)
    # The unknowns of a slip and of what else changes explain any few readings, which then say nothing of one.
    if frame.readings[0] <= inversion.lookalike_columns[0].shape[1]:
        return None
    calm = whitening(frame.still, frame.shared)
    *magnets, slipped = (
        whitening(frame.still, np.hstack([frame.shared, columns]))
        for columns in inversion.lookalike_columns
    )
    near = [_log_evidence(white, frame.counts) for white in magnets]
    others = max(
        _log_evidence(calm, frame.counts), float(np.logaddexp.reduce(near)) - np.log(len(near))
    )
    if _log_evidence(slipped, frame.counts) < others + _SURE:
        return None
    unknowns, added, slopes = np.zeros(6), np.zeros(model.channels), np.zeros((6, model.channels))
    precision = np.eye(6)
    for _ in range(_STEPS):
        slopes = _slopes(model, earlier.unknowns + unknowns)
        white_slopes, residual = calm(slopes[None])[0], calm((frame.counts - added)[None])[0, 0]
        # Most probable t of c = s(t) + noise with t ~ N(0, 1): (1 + J Jᵀ) δ = J r − t, whitened
        precision = np.eye(6) + white_slopes @ white_slopes.T
        unknowns = unknowns + np.linalg.solve(precision, white_slopes @ residual - unknowns)
        added = _counts(model, earlier.unknowns + unknowns) - _counts(model, earlier.unknowns)
    residual = calm((frame.counts - added)[None])[0, 0]
    if chdtrc(int(frame.readings[0]) - 6, residual @ residual) < UNEXPLAINED:
        return None
    # covariance of the unknowns as a product of a root with itself: the columns' own unknowns are N(0, 1)
    root = np.linalg.inv(np.linalg.cholesky(precision)).T
    total = earlier.unknowns + unknowns
    shift_mm = slip_motions(model, total[None])[0, :, :3]
    size_mm = float(np.sqrt((shift_mm**2).sum(axis=1).mean()))
    return Slip(total, size_mm, earlier.counts + added, slopes.T @ root)


def median_slip_mm(inversion: Inversion, unexplained: Float[np.ndarray, "frame channel"]) -> float:
    """Return the median slip that single frames, which no contact explains, show at rest; 0 where most show
    none."""
    few = np.unique(np.linspace(0, len(unexplained) - 1, _TRIED).astype(int))
    slips = (
        [slip_at_rest(inversion, change) for change in unexplained[few]] if len(unexplained) else []
    )
    sizes = [0.0 if slip is None else slip.size_mm for slip in slips]
    return float(np.median(sizes)) if sizes else 0.0


def _log_evidence(white: Whitening, counts: Float[np.ndarray, "1 channel"]) -> float:
    """Return the log density of a frame, but for what all hypotheses of rest share."""
    residual = white(counts[:, None])[0, 0]
    return float(-0.5 * residual @ residual - white.log_spread()[0])


def _counts(model: ContactModel, unknowns: Float[np.ndarray, "6"]) -> Float[np.ndarray, "channel"]:
    """Return the counts that a slip adds at rest, by the exact field."""
    return model.counts_of_motions(slip_motions(model, unknowns[None]))[0]


def _slopes(
    model: ContactModel, unknowns: Float[np.ndarray, "6"]
) -> Float[np.ndarray, "6 channel"]:
    """Return the derivatives of these counts by each unknown."""
    steps = _HALF_STEP * np.vstack([np.eye(6), -np.eye(6)])
    ahead, behind = model.counts_of_motions(slip_motions(model, unknowns + steps)).reshape(
        2, 6, model.channels
    )
    return (ahead - behind) / (2 * _HALF_STEP)
