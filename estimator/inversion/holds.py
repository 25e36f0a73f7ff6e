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
from jaxtyping import Bool, Float, Int
from scipy.linalg import solve_triangular
from scipy.special import chdtri

from estimator.inversion.problems import BLIND

_TIMES_S = np.array([4.0, 30.0, 240.0])
"""Times over which a hold's changes are judged against drift: contacts that press more or slide, silicone
that creeps under a fresh load, and creep of minutes. Each is some eight times the one before, so that a
change of any length is near one of them."""
_CHANCE = 1e-5
"""Chance that one judgement takes drift for a change of the contacts. Half an hour of judgements, 20 a second
by four patterns, ends a steady hold in one of 16 cases (simulated, drift known exactly). Another begins."""
_CHANCE_OF_FRAME = 1e-8
"""Chance that noise of one frame ends a steady hold: half an hour has 36 000 at 20 a second."""
_MISREAD_FRAMES = 10
"""Frames on end with contacts on other faces after which the hold has ended: fewer may be misread."""


@dataclass
class HeldDrift:
    """Drift of every channel since contacts became steady, and how well it is known.

    Attributes
    ----------
    noise : (channel, channel) covariance of what changes from frame to frame (counts²), nuisances included
    rate : by how much the variance of drift grows (counts²/s)
    unknown_counts2 : variance of the drift that no hold has shown since the last rest (counts²), in
        the middle of all directions; 0 at rest, infinite after a pause
    same_s : time for which contacts have been on the same faces, until they are held
    """

    noise: Float[np.ndarray, "channel channel"]
    rate: float
    unknown_counts2: float = 0.0
    same_s: float = 0.0
    _before: float = 0.0
    _faces: tuple[int, ...] = ()
    _misread: int = 0
    _read: Bool[np.ndarray, "channel"] = field(default_factory=lambda: np.zeros(0, bool))
    _held: Float[np.ndarray, "channel"] | None = None
    _patterns: Float[np.ndarray, "channel pattern"] = field(
        default_factory=lambda: np.zeros((0, 0))
    )
    _covariance: Float[np.ndarray, "drift_and_held drift_and_held"] = field(
        default_factory=lambda: np.zeros((0, 0))
    )
    _lately: Float[np.ndarray, "time channel"] = field(
        default_factory=lambda: np.zeros((len(_TIMES_S), 0))
    )
    _spread: Float[np.ndarray, "time"] = field(default_factory=lambda: np.zeros(len(_TIMES_S)))

    @property
    def steady(self) -> bool:
        """Return whether contacts are held, so that drift is known."""
        return self._held is not None

    def forget(self) -> None:
        """Forget the hold: contacts are others or gone."""
        self._held, self._faces, self._misread, self.same_s = None, (), 0, 0.0

    def drift_for(self, elapsed_s: float) -> None:
        """Let all drift for so long; after an infinite time nothing is known of it, and no hold goes on."""
        if math.isinf(elapsed_s):
            self.unknown_counts2 = math.inf
            self.forget()
            return
        self.same_s += elapsed_s
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
        same = self._faces == (now := tuple(np.sort(faces).tolist()))
        if not self.steady:
            self.same_s, self._faces = self.same_s if same else 0.0, now
            return False
        self._misread = 0 if same else self._misread + 1
        if self._misread > _MISREAD_FRAMES:
            self.forget()
        return same

    def begin(
        self,
        faces: Int[np.ndarray, "contact"],
        change: Float[np.ndarray, "channel"],
        frames: int,
        slopes: Float[np.ndarray, "pattern channel"],
    ) -> None:
        """Take still contacts for steady: the mean change of some frames against the zero, NaN where a
        channel has none, and the derivatives of their signals. What drifted before is within that change,
        and stays unknown."""
        self._faces, self._held, self._misread = tuple(np.sort(faces).tolist()), change, 0
        self._before, self._read = self.unknown_counts2, np.isfinite(change)
        self._patterns = np.linalg.qr(np.vstack([slopes, np.nan_to_num(change)]).T)[0]
        self._covariance = np.kron([[0.0, 0.0], [0.0, 1.0]], self.noise / frames)
        self._lately, self._spread = np.zeros((len(_TIMES_S), len(change))), 0 * _TIMES_S

    def follow(self, change: Float[np.ndarray, "channel"]) -> Float[np.ndarray, "channel"]:
        """Return by how much all drifted since the last of these, against a zero that followed until then.

        A frame that neither drift nor noise explains ends the hold, and shows no drift.
        """
        assert self._held is not None
        channels = len(change)
        apart = change - self._held
        live = np.isfinite(apart) & (self.noise.diagonal() < BLIND**2)
        noise = self.noise + np.diag(np.where(live, 0.0, BLIND**2))
        # Kalman update of x = (drift, held) by y = H x + noise, H = (1 1): with the Cholesky factor L of
        # S = H P Hᵀ + noise the gain P Hᵀ S⁻¹ is (L⁻¹ H P)ᵀ L⁻¹, and P loses (L⁻¹ H P)ᵀ (L⁻¹ H P).
        shown = self._covariance[:channels] + self._covariance[channels:]
        factor = np.linalg.cholesky(shown[:, :channels] + shown[:, channels:] + noise)
        white = solve_triangular(factor, np.column_stack([np.nan_to_num(apart), shown]), lower=True)
        innovation, gain = white[:, 0], white[:, 1:]
        # a contact that jumped along its face, or presses otherwise after frames that were not read
        if innovation @ innovation > chdtri(max(1, live.sum()), _CHANCE_OF_FRAME):
            self.forget()
            return np.zeros(channels)
        drifted, held = (innovation @ gain).reshape(2, channels)
        self._covariance, self._held = self._covariance - gain.T @ gain, self._held + held
        if live.any():
            of_drift = self._covariance[:channels, :channels][np.ix_(live, live)]
            self.unknown_counts2 = self._before + float(np.median(np.linalg.eigvalsh(of_drift)))
        # what a channel drifted while it had no reading shows at once, and is no change of the contacts
        self._lately, self._read = self._lately + np.where(self._read, drifted, 0.0), live
        pattern_counts = self._lately @ self._patterns
        most = chdtri(pattern_counts.shape[1], _CHANCE) * self._spread
        (changed,) = np.nonzero((pattern_counts**2).sum(axis=1) > most)
        if len(changed):
            self.forget()
            return drifted - self._patterns @ pattern_counts[changed[-1]]
        return drifted
