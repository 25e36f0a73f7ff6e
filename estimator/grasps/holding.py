"""Figures of taking and holding an object: loading rate, creep, contact slip, steadiness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

_RATE_FRAMES = 3
"""Frames over which a slope is taken: two would show noise."""
_REFERENCE_FRAMES = 3
"""Frames whose median is where a contact began and ended."""
_SLIP_SIGMAS = 5.0
"""Scatters by which a contact must have moved to count as slipped."""
LEAST_SLIP_MM = 0.3
"""Least distance that counts as slip: below, estimators drift."""
_NORMAL_MAD = 1.4826
"""Standard deviation over median absolute deviation of a normal error."""


def loading_rate_n_per_s(
    time_s: Float[np.ndarray, "frame"], force_n: Float[np.ndarray, "frame"]
) -> float:
    """Steepest rise of a force: largest least-squares slope over three frames; NaN where there are fewer."""
    slopes = []
    for first in range(len(force_n) - _RATE_FRAMES + 1):
        window = slice(first, first + _RATE_FRAMES)
        centred = time_s[window] - time_s[window].mean()
        if (square := float(centred @ centred)) > 0:
            slopes.append(float(centred @ force_n[window]) / square)
    return max(slopes, default=float("nan"))


def creep_per_decade(
    time_s: Float[np.ndarray, "frame"], force_n: Float[np.ndarray, "frame"]
) -> float:
    """Change of a held force per tenfold time, as a share of its mean: negative where it relaxes.

    Slope of the force against log10 of the time since the hold began, by least squares; the first
    frame has no logarithm. NaN with fewer than four frames.
    """
    if len(force_n) < 4 or not np.all(np.diff(time_s) > 0):
        return float("nan")
    decades = np.log10(time_s[1:] - time_s[0])
    centred = decades - decades.mean()
    return float(centred @ force_n[1:] / (centred @ centred) / force_n.mean())


def unsteadiness(force_n: Float[np.ndarray, "frame"]) -> float:
    """Root mean square deviation of a held force from its mean, over that mean."""
    return float(np.std(force_n) / np.mean(force_n))


@dataclass(frozen=True)
class Slip:
    """Motion of a contact along the surface while it is held.

    `onset_s` is NaN where it did not slip. `distance_mm` is where it ended against where it began.
    """

    onset_s: float
    distance_mm: float

    @property
    def slipped(self) -> bool:
        """Return whether there was slip."""
        return not np.isnan(self.onset_s)


def contact_slip(
    time_s: Float[np.ndarray, "frame"], centre_mm: Float[np.ndarray, "frame 2"]
) -> Slip:
    """Onset and distance of slip of a face's centre of force.

    The onset is the first frame from which on the centre stays further from its beginning than
    `LEAST_SLIP_MM` and five scatters. The scatter is a robust one of successive differences, so
    that a slow slip does not widen it. Give NaN for frames in which
    another contact takes part: it moves the centre as well.
    """
    present = np.isfinite(centre_mm).all(axis=1)
    time_s, centre_mm = time_s[present], centre_mm[present]
    if len(centre_mm) < 2 * _REFERENCE_FRAMES:
        return Slip(float("nan"), float("nan"))
    begin = np.median(centre_mm[:_REFERENCE_FRAMES], axis=0)
    away = np.linalg.norm(centre_mm - begin, axis=1)
    steps = np.diff(centre_mm, axis=0)
    # differences of two frames scatter √2 times as much as one
    scatter = _NORMAL_MAD * float(np.median(abs(steps - np.median(steps, axis=0)))) / np.sqrt(2)
    moved = away > max(LEAST_SLIP_MM, _SLIP_SIGMAS * scatter)
    distance = float(np.linalg.norm(np.median(centre_mm[-_REFERENCE_FRAMES:], axis=0) - begin))
    still = np.flatnonzero(~moved)
    onset = 0 if not len(still) else int(still[-1]) + 1
    slipped = len(moved) - onset >= _REFERENCE_FRAMES
    return Slip(float(time_s[onset]) if slipped else float("nan"), distance)
