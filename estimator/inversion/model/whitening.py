"""Whitening of frames: disturbances made independent and of unit size, nuisances integrated out."""

from __future__ import annotations

from dataclasses import dataclass

from jaxtyping import Float

from estimator.inversion.model.arrays import Array, library
from estimator.inversion.model.columns import Columns


@dataclass(frozen=True)
class Whitening(Columns):
    """Linear map W of each frame's counts, with WᵀW the inverse of their covariance Σ.

    Σ = D (1 + Σᵢ sᵢ² uᵢuᵢᵀ) D, with D of the independent deviations and sᵢ, uᵢ the singular values
    and left vectors of D⁻¹A. A holds the nuisances' columns. Then W = (1 − Σᵢ gᵢ uᵢuᵢᵀ) D⁻¹ with
    g = 1 − 1/√(1 + s²), and its first factor is symmetric.

    Attributes
    ----------
    weight : (frame, channel) diagonal of D⁻¹
    shared : (frame, k, channel) rows √gᵢ uᵢ
    """

    weight: Float[Array, "frame channel"]
    shared: Float[Array, "frame k channel"]

    def __call__(
        self, rows: Float[Array, "frame row channel"]
    ) -> Float[Array, "frame row channel"]:
        """Return W of rows of counts of each frame."""
        return self._less_shared(rows * self.weight[:, None])

    def transposed(
        self, white: Float[Array, "frame row channel"]
    ) -> Float[Array, "frame row channel"]:
        """Return Wᵀ of rows: a whitened press times a row is the press in counts times this."""
        return self._less_shared(white) * self.weight[:, None]

    def taken(self) -> Float[Array, "frame k channel"]:
        """Return rows q of each frame with WᵀW = D⁻² − Σ qqᵀ."""
        # s²/(1 + s²) = g (2 − g), and g is the squared length of a row of `shared`
        share = (self.shared * self.shared).sum(axis=2)
        return self.shared * ((2 - share) ** 0.5)[..., None] * self.weight[:, None]

    def log_spread(self) -> Float[Array, "frame"]:
        """Return by how much the nuisances widen a frame's signals: ½ log det(1 + Σᵢ sᵢ² uᵢuᵢᵀ)."""
        share = (self.shared * self.shared).sum(axis=2)
        # ½ log(1 + s²) = −log(1 − g)
        return -library(share).log1p(-share).sum(axis=1)

    def _less_shared(self, white: Array) -> Array:
        if not self.shared.shape[1]:
            return white
        return white - (white @ self.shared.swapaxes(1, 2)) @ self.shared


def whitening(
    sigma: Float[Array, "frame channel"], columns: Float[Array, "*frame channel k"]
) -> Whitening:
    """Return the whitening of frames with independent deviations and nuisances, common to all or of each."""
    xp, scaled = library(sigma), columns / sigma[..., None]
    square, turn = xp.linalg.eigh(scaled.swapaxes(1, 2) @ scaled)
    # √g u = D⁻¹A v √g / s, and g / s² = 1 / (r (r + 1)) with r = √(1 + s²): no division by s = 0
    root = (1 + square.clip(0)) ** 0.5
    shared = (scaled @ turn) / ((root * (root + 1)) ** 0.5)[:, None]
    return Whitening(1 / sigma, shared.swapaxes(1, 2))
