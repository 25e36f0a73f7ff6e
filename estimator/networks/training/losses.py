"""Training loss of the network."""

from __future__ import annotations

import torch
from torch import Tensor, nn

from estimator.networks.network import HeadsNetwork
from estimator.networks.training.data import Batch

_FORCE_WEIGHT = 8.0
"""Weight of the error of force; the cross-entropy of contact has 1."""
_CENTRE_WEIGHT = 0.3
"""Weight of the centre's distance (mm), each times √force."""
_SPREAD_WEIGHT = 0.1
"""Weight of the likelihood of the errors' sizes."""


def heads_loss(network: HeadsNetwork, counts: Tensor, target: Batch) -> Tensor:
    """Cross-entropy of the shares of force (unless the position is continuous), absolute error of
    force and centre, cross-entropy of contact, and the likelihood of the errors' sizes.

    Place is weighted by √force: a faint press says little about where it is. The sizes of errors
    are exponentially distributed about their spreads, with the errors themselves held fixed, so
    that the spreads do not buy themselves worse estimates.
    """
    heads = network.heads_of(counts)
    normal, touched = target.force[:, -1], target.contact
    weight = torch.sqrt(normal)
    missed = (heads.force - target.force).abs()
    away = (heads.xy_mm - target.centre_mm).square().sum(dim=1).add(1e-6).sqrt()
    touch = nn.functional.binary_cross_entropy_with_logits(heads.contact_logit, touched)
    spread = _size_likelihood(missed[:, -1], heads.force_spread) + _size_likelihood(
        away, heads.position_spread_mm
    )
    loss = _FORCE_WEIGHT * missed.sum(dim=1).mean() + touch
    loss = loss + _CENTRE_WEIGHT * (weight * away).mean()
    loss = loss + _SPREAD_WEIGHT * (touched * spread).mean()
    if not network.continuous:
        log_share = torch.log_softmax(heads.share_logits, dim=1)
        loss = loss - (weight * (target.share * log_share).sum(dim=1)).mean()
    return loss


def _size_likelihood(size: Tensor, spread: Tensor) -> Tensor:
    return torch.log(spread) + size.detach() / spread
