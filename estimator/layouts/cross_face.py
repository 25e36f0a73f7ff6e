"""Effect of presses of one face on its neighbours' sensors, for many layouts at once.

Lowest fidelity level of a layout search, as `estimator.layouts.scoring`, on the same stored
presses: magnets of the pressed face and of its neighbours move, the opposite face's are left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.field.gradient import field_change
from estimator.layouts.batch import Layouts, chip_axes, magnet_axes
from estimator.layouts.press_basis import mixed_rows
from estimator.layouts.scoring import OTHER_ORDER, OWN_ORDER, LayoutScorer

CROSS_FACE_FORCE_N = 10.0
"""Of the presses whose disturbance is scored, as in `estimator.information.cross_face`."""


@dataclass(frozen=True)
class _MovingFace:
    """One face's magnets in the pressed face's frame, and their motions there on a basis."""

    centre_mm: Float[Tensor, "3 layout magnet"]
    axis: Float[Tensor, "3 layout magnet"]
    rows: Float[Tensor, "layout magnet 6 rank"]
    basis: Float[Tensor, "rank place"]


def neighbour_disturbance(
    scorer: LayoutScorer, layouts: Layouts
) -> Float[Tensor, "layout neighbour place"]:
    """Length of the change of each neighbour's own signals, in units of a fresh zero.

    Presses of `CROSS_FACE_FORCE_N` at every contact location, in proportion to the stored ones;
    differentiable. On the paper's cube the median over neighbours and places is 5 % off the full
    chain's.
    """
    presses = scorer.presses
    moving = _moving_faces(scorer, layouts)
    depth = torch.full_like(layouts.sensor_mm[..., :1], -scorer.sensor_depth_mm)
    local = torch.cat([layouts.sensor_mm, depth], dim=-1)
    chips = chip_axes(layouts.sensor_mm, scorer.chip)
    whitened = chips * (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    sizes = []
    for number, (turn, shift) in enumerate(
        zip(presses.turn[: len(moving) - 1], presses.shift_mm, strict=False), start=1
    ):
        sensor = (local @ turn.T + shift).permute(2, 0, 1)
        change = sum(
            _signals(scorer, layouts, sensor, face, OWN_ORDER if index == number else OTHER_ORDER)
            for index, face in enumerate(moving)
        )
        sizes.append((whitened @ turn.T @ change).square().sum((1, 2)).sqrt())
    return torch.stack(sizes, dim=1) * (CROSS_FACE_FORCE_N / presses.force_n)


def _moving_faces(scorer: LayoutScorer, layouts: Layouts) -> list[_MovingFace]:
    """The pressed face, then its neighbours."""
    presses, shape = scorer.presses, layouts.magnet_mm.shape[:2]
    own, other = mixed_rows(presses, layouts.magnet_mm.reshape(-1, 3))
    places = len(presses.places)
    centre = layouts.magnet_mm * torch.tensor([1.0, 1.0, -1.0], dtype=own.dtype)
    centre, axis = centre.permute(2, 0, 1), magnet_axes(layouts)
    pressed = _MovingFace(centre, axis, own.reshape(*shape, 6, -1), presses.own.basis[:, -places:])
    rows = other.reshape(*shape, -1, 6, len(presses.other.basis)).unbind(2)
    return [pressed] + [
        _MovingFace(
            torch.einsum("ij,jlm->ilm", turn, centre) + shift[:, None, None],
            torch.einsum("ij,jlm->ilm", turn, axis),
            row,
            presses.other.basis[:, -places:],
        )
        for row, turn, shift in zip(rows, presses.turn, presses.shift_mm, strict=False)
    ]


def _signals(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor: Float[Tensor, "3 layout sensor"],
    face: _MovingFace,
    order: int,
) -> Float[Tensor, "layout sensor 3 place"]:
    """Change of the field (T) at sensors by one face's magnets, in the pressed face's frame."""
    offset, axis = torch.broadcast_tensors(
        sensor[..., None] - face.centre_mm[:, :, None], face.axis[:, :, None]
    )
    change = field_change(offset, axis, scorer.magnet, order).by_motion
    by_motion = (change * layouts.polarity[:, None]).permute(2, 3, 0, 4, 1).flatten(3)
    rows = face.rows.flatten(1, 2)[:, None]
    return (by_motion @ rows) @ face.basis
