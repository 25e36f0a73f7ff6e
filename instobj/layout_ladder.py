"""The upper rungs of a layout search on the chain's stages: what they need, run and stored."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec import ObjectSpec
from instobj.chain import Chain

if TYPE_CHECKING:
    from estimator.layout_ladder import LadderScore


def chain_score(spec: ObjectSpec) -> LadderScore:
    """Rung three: the score of the chain's own signals, its stages stored and reused."""
    from estimator.layout_ladder import score_signals
    from estimator.signals import load_signals

    folder = Chain(spec).require("signals").folder
    return score_signals(spec, load_signals(Path(folder) / "lattice_signals.nc"))


def score_row(score: LadderScore) -> dict[str, Any]:
    """A score with the names and units that tables show."""
    return {
        "worst place mm": score.worst_position_bound_mm,
        "median place mm": score.median_position_bound_mm,
        "worst force N": score.worst_force_bound_n,
        "next face σ": score.cross_face_sigma,
        "δ 5/50 %": score.sensitivity_ratio,
        "free range": score.saturation_margin,
    }
