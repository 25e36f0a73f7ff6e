"""What presses of one face do to its neighbours' sensors, for many layouts at once.

First rung of a layout search, as `estimator.layout_scoring`, on the same stored presses: the
neighbour's own magnets move where the press bends the silicone near them, the pressed face's
magnets move far more but further away. The others are left out.
"""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.field_gradient import field_change
from estimator.layout_batch import Layouts, chip_axes, magnet_axes
from estimator.layout_scoring import OTHER_ORDER, OWN_ORDER, LayoutScorer
from estimator.press_basis import mixed_rows

CROSS_FACE_FORCE_N = 10.0
"""Of the presses whose disturbance is scored, as in `estimator.cross_face`."""


def neighbour_disturbance(
    scorer: LayoutScorer, layouts: Layouts
) -> Float[Tensor, "layout neighbour place"]:
    """Length of the change of each neighbour's own signals, in units of a fresh zero.

    Presses of `CROSS_FACE_FORCE_N` at every contact place, in proportion to the stored ones;
    differentiable. The median over neighbours and places is within 5 % of the full chain's on the
    paper's cube.
    """
    presses = scorer.presses
    own_rows, other_rows = mixed_rows(presses, layouts.magnet_mm.reshape(-1, 3))
    shape, places = layouts.magnet_mm.shape[:2], len(presses.places)
    pressed = own_rows.reshape(*shape, 6, -1)
    neighbours = other_rows.reshape(*shape, -1, 6, len(presses.other.basis))
    whitened = chip_axes(layouts.sensor_mm, scorer.chip)
    whitened = whitened * (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    sensor = _sensors(scorer, layouts)
    near = _change(scorer, layouts, sensor, OWN_ORDER)
    sizes = []
    for turn, shift, rows in zip(
        presses.turn, presses.shift_mm, neighbours.unbind(2), strict=False
    ):
        moved = torch.einsum("lmkir,ij->lmkjr", rows.unflatten(2, (2, 3)), turn).flatten(2, 3)
        own = torch.einsum("aklsm,lmkr->lsar", near, moved)
        seen = torch.einsum("ij,jls->ils", turn, sensor) + shift[:, None, None]
        far = _change(scorer, layouts, seen, OTHER_ORDER)
        across = torch.einsum("ab,aklsm,lmkr->lsbr", turn, far, pressed)
        change = (whitened @ own) @ presses.other.basis[:, -places:]
        change = change + (whitened @ across) @ presses.own.basis[:, -places:]
        sizes.append(change.square().sum((1, 2)).sqrt())
    return torch.stack(sizes, dim=1) * (CROSS_FACE_FORCE_N / presses.force_n)


def _sensors(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "3 layout sensor"]:
    depth = torch.full_like(layouts.sensor_mm[..., :1], -scorer.sensor_depth_mm)
    return torch.cat([layouts.sensor_mm, depth], dim=-1).permute(2, 0, 1)


def _change(
    scorer: LayoutScorer, layouts: Layouts, sensor: Float[Tensor, "3 layout sensor"], order: int
) -> Float[Tensor, "3 6 layout sensor magnet"]:
    """Change of the field at sensors with the motions of one face's magnets, all in its frame."""
    xyd = layouts.magnet_mm
    centre = torch.stack([xyd[..., 0], xyd[..., 1], -xyd[..., 2]])
    offset, axis = torch.broadcast_tensors(
        sensor[..., None] - centre[:, :, None], magnet_axes(layouts)[:, :, None]
    )
    return field_change(offset, axis, scorer.magnet, order).by_motion * layouts.polarity[:, None]
