"""Drift while contacts stay, apart from creep and from changes of the contacts by its shape.

Channels drift independently, as random walks. Contacts that press more or slide, and silicone that creeps
under them, change channels along the few patterns of the contacts themselves. Where a hold has changed along
these by no more than drift may, it is steady, and all that its channels change by is taken for drift (Kalman
filter of random walks). A larger change is the contacts', at once or slowly: it is given back.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float, Int
from scipy.stats import chi2

_TIMES_S = np.array([4.0, 30.0, 240.0])
"""Times over which a hold's changes are judged against drift."""
_CHANCE = 1e-5
"""Chance that a judgement takes drift for a change of the contacts: a thousandth in half an hour, which
holds some 500 changes over 4 s."""
_OTHERS = 10
"""Frames on end with other contacts, after which a hold is another: a frame may be misread."""


@dataclass
class HeldDrift:
    """Drift of every channel since contacts became steady, and how well it is known.

    Attributes
    ----------
    noise : (channel, channel) covariance of what changes from frame to frame (counts²), nuisances included
    rate : by how much the variance of drift grows (counts²/s)
    unknown_counts2 : variance of the drift that no hold has shown since the last rest (counts²), in
        the middle of all directions; infinite before the first hold
    alike : frames on end with contacts on the same faces, until they are held
    """

    noise: Float[np.ndarray, "channel channel"]
    rate: float
    unknown_counts2: float = math.inf
    alike: int = 0
    _faces: tuple[int, ...] = ()
    _others: int = 0
    _held: Float[np.ndarray, "channel"] | None = None
    _patterns: Float[np.ndarray, "channel pattern"] = field(
        default_factory=lambda: np.zeros((0, 0))
    )
    _covariance: Float[np.ndarray, "drift_and_held drift_and_held"] = field(
        default_factory=lambda: np.zeros((0, 0))
    )
    _lately: Float[np.ndarray, "time channel"] = field(default_factory=lambda: np.zeros((3, 0)))
    _spread: Float[np.ndarray, "time"] = field(default_factory=lambda: np.zeros(3))

    @property
    def steady(self) -> bool:
        """Return whether contacts are held, so that drift is known."""
        return self._held is not None

    def forget(self) -> None:
        """Forget the hold: contacts are others or gone."""
        self._held, self._others, self.alike = None, 0, 0

    def pass_by(self, elapsed_s: float) -> None:
        """Let all drift for so long; for an infinite time, all that is known of it ends."""
        self.unknown_counts2 += self.rate * elapsed_s
        channels = len(self.noise)
        kept = np.exp(-elapsed_s / _TIMES_S)
        # sums of independent steps, each q dt in every direction, weighed by exp(−t/τ)
        self._lately, self._spread = (
            kept[:, None] * self._lately,
            kept**2 * self._spread + self.rate * min(elapsed_s, _TIMES_S[-1]),
        )
        if self.steady:
            self._covariance[range(channels), range(channels)] += self.rate * elapsed_s

    def is_of(self, faces: Int[np.ndarray, "contact"]) -> bool:
        """Return whether contacts on these faces are those held; forget the hold where others stay."""
        alike = self._faces == (now := tuple(np.sort(faces).tolist()))
        if not self.steady:
            self.alike, self._faces = self.alike * alike + 1, now
            return False
        self._others = 0 if alike else self._others + 1
        if self._others > _OTHERS:
            self.forget()
        return alike

    def begin(
        self,
        faces: Int[np.ndarray, "contact"],
        change: Float[np.ndarray, "channel"],
        frames: int,
        slopes: Float[np.ndarray, "pattern channel"],
    ) -> None:
        """Take still contacts for steady: the mean change of some frames against the zero, NaN where a
        channel has none, and the derivatives of their signals."""
        self._faces, self._held, self._others = tuple(np.sort(faces).tolist()), change, 0
        self._patterns = np.linalg.qr(np.vstack([slopes, np.nan_to_num(change)]).T)[0]
        self._covariance = np.kron([[0.0, 0.0], [0.0, 1.0]], self.noise / frames)
        self._lately, self._spread = np.zeros((len(_TIMES_S), len(change))), 0 * _TIMES_S

    def follow(self, change: Float[np.ndarray, "channel"]) -> Float[np.ndarray, "channel"]:
        """Return by how much all drifted since the last of these, against a zero that followed until then."""
        assert self._held is not None
        both = np.hstack([np.eye(len(change)), np.eye(len(change))])
        # frames show drift and what is held added up: y = H x + noise, gain P Hᵀ (H P Hᵀ + noise)⁻¹
        shown = both @ self._covariance
        gain = np.linalg.solve(shown @ both.T + self.noise, shown).T
        # a channel without a reading is where it was
        drifted, held = (gain @ np.nan_to_num(change - self._held)).reshape(2, -1)
        self._covariance, self._held = self._covariance - gain @ shown, self._held + held
        of_drift = self._covariance[: len(change), : len(change)]
        self.unknown_counts2 = float(np.median(np.linalg.eigvalsh(of_drift)))
        self._lately = self._lately + drifted
        pattern_counts = self._lately @ self._patterns
        most = chi2.isf(_CHANCE, pattern_counts.shape[1]) * self._spread
        (changed,) = np.nonzero((pattern_counts**2).sum(axis=1) > most)
        if len(changed):
            self.forget()
            return drifted - self._patterns @ pattern_counts[changed[-1]]
        return drifted
