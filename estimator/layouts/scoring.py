"""Scores of many layouts in batches on stored motions of candidate magnets, with gradients.

Lowest fidelity level of a layout search. A layout is one face's magnets and sensors, repeated on every face;
magnets are rigid and hold each other in first reflection. Counts are linearised in the magnets' motions
about rest, J = ∂S/∂(motion) · ∂(motion)/∂(x, y, F), with the field's derivatives in closed form and the
motions' compressed (`estimator.layouts.presses.basis`). The other faces' magnets count too, by a lower order
of the series and a shorter basis: cheap, as they are further away and move less.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.layouts.batch import Layouts
from estimator.layouts.bounds import bounds
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.presses.counts import counts_when_pressed
from estimator.layouts.scorer import LayoutScorer
from estimator.layouts.spread import counts_kept

_FORCE_VARIANCE, _CURVE_VARIANCE = 1 / 8, 1 / 128
"""Variances of c and c² − c, which do not correlate; c is the force over its peak, a raised cosine."""


@dataclass(frozen=True)
class PlaceInformation:
    """Bounds and δ (up to a factor that is the same everywhere) of every contact location; the largest
    magnitude of any own channel in counts, at rest and in the deepest simulated presses; and the counts
    there that virtual objects keep to (`estimator.layouts.spread`), with all sensed faces like this one.

    Counts come from scorers of the largest force among those computed together, the others give those at
    rest and 0. The shell without magnets is pressed as deep, by the change with force at the basis's, and the
    pressed face's magnets are where that moves them. The second fidelity level, whose presses reach the same
    depth with more force, had 1.02 to 1.11 times as many (fourteen layouts of the paper's cube) and 1.17
    times (one of a pear, whose presses took a third more force). With boards in the shell, which
    stiffen it more, the chain had 1.57 and 1.72 times as many (two layouts).
    """

    position_bound_mm: Float[Tensor, "layout place"]
    force_bound_n: Float[Tensor, "layout place"]
    sensitivity: Float[Tensor, "layout place"]
    largest_counts: Float[Tensor, "layout"]
    kept_counts: Float[Tensor, "layout"]


def place_information(scorer: LayoutScorer, layouts: Layouts) -> PlaceInformation:
    """Bounds and δ at every contact location, all layouts at once."""
    return places_information([scorer], [layouts])[0]


def places_information(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
) -> list[PlaceInformation]:
    """The same of several scorers."""
    largest_n = max(scorer.presses.force_n for scorer in scorers)
    information = []
    for scorer, batch in zip(scorers, layouts, strict=True):
        changes = press_changes(scorer, batch)
        counts = changes.resting_counts.flatten(1).abs().amax(dim=1)
        kept = torch.zeros_like(counts)
        if scorer.presses.force_n == largest_n:
            pressed = counts_when_pressed(scorer, batch, changes)
            counts = torch.maximum(counts, pressed.counts.abs().amax(dim=1))
            kept = counts_kept(pressed.counts, pressed.sigma, len(scorer.spec.body.sensed))
        by_parameter = changes.by_parameter
        position, force = bounds(by_parameter[:, :, :3])
        sensitivity = press_sensitivity(scorer, by_parameter)
        information.append(PlaceInformation(position, force, sensitivity, counts, kept))
    return information


def press_sensitivity(
    scorer: LayoutScorer, by_parameter: Float[Tensor, "channel layout 4 place"]
) -> Float[Tensor, "layout place"]:
    """√det of the channels' covariance in a press, in units of white noise, signals taken as parabolas over
    force: their change in the press and their slope at its peak."""
    white = scorer.white_share.repeat(len(by_parameter) // 3)[:, None, None]
    at_peak = by_parameter[:, :, 3] * white
    curve = by_parameter[:, :, 2] * white * scorer.presses.force_n - at_peak
    straight, both, bent = (
        (first * second).sum(0)
        for first, second in ((at_peak, at_peak), (at_peak, curve), (curve, curve))
    )
    straight_variance = 1 + _FORCE_VARIANCE * straight
    bent_variance = 1 + _CURVE_VARIANCE * torch.relu(
        bent - _FORCE_VARIANCE * both.square() / straight_variance
    )
    return (straight_variance * bent_variance).sqrt()
