"""Magnets and chips of layouts where they lie, in the pressed face's frame, with gradients.

Of faces that are flat and alike one layout is turned from face to face; where faces differ every part
lies under its own surface (`estimator.layouts.surfaces`).
"""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.layouts.batch import Layouts, chip_axes, magnet_axes
from estimator.layouts.near_field import Magnets
from estimator.layouts.presses.basis import Patch, PressBasis
from estimator.layouts.surfaces import to_object, turned_to_object

Chips = tuple[Float[Tensor, "3 layout sensor"], Float[Tensor, "layout sensor 3 3"]]
"""Sensing points (mm), coordinates first, and chip axes as rows."""


def own_magnets(presses: PressBasis, layouts: Layouts) -> Magnets:
    """Return the magnets of the pressed face."""
    if presses.patches:
        centre, axis = _magnets_of_patch(presses.patches[0], layouts)
        return centre.permute(2, 0, 1), axis.permute(2, 0, 1)
    xyd = layouts.magnet_mm
    centre = torch.stack([xyd[..., 0], xyd[..., 1], -xyd[..., 2]])
    return centre, magnet_axes(layouts)


def other_magnets(
    presses: PressBasis, layouts: Layouts
) -> tuple[Float[Tensor, "3 layout magnet face"], Float[Tensor, "3 layout magnet face"]]:
    """Return the magnets of the other faces, in their order."""
    if len(presses.patches) > 1:
        each = [_magnets_of_patch(patch, layouts) for patch in presses.patches[1:]]
        centre, axis = (torch.stack(parts) for parts in zip(*each, strict=True))
        # g other face, j axis of its frame, i axis of this one's, b layout, m magnet
        turned, axes = (
            torch.einsum("gij,gbmj->ibmg", presses.turn, part) for part in (centre, axis)
        )
        return turned + presses.shift_mm.T[:, None, None], axes
    centre, axis = own_magnets(presses, layouts)
    turned = torch.einsum("gij,jbm->ibmg", presses.turn, centre)
    centres = turned + presses.shift_mm.T[:, None, None]
    return centres, torch.einsum("gij,jbm->ibmg", presses.turn, axis)


def chips(
    presses: PressBasis,
    layouts: Layouts,
    depth_mm: float,
    on_board: Float[Tensor, "3 3"],
    neighbour: int | None = None,
) -> Chips:
    """Return the chips of the pressed face, or of the other face of that index.

    `depth_mm` is their depth below a flat face, `on_board` their axes as columns on the board."""
    if presses.patches:
        index = 0 if neighbour is None else 1 + neighbour
        frame, surface = presses.patches[0].surface.frame, presses.patches[index].surface
        local, columns = surface.chips(layouts.layouts_of_face(surface.number))
        turn = local.new_tensor(frame.axes.tolist())
        point = to_object(surface.chip_frame, local) - local.new_tensor(frame.centre_mm.tolist())
        axes = turned_to_object(surface.chip_frame, columns.transpose(-1, -2)) @ turn
        return (point @ turn).permute(2, 0, 1), axes
    depth = torch.full_like(layouts.sensor_mm[..., :1], -depth_mm)
    local = torch.cat([layouts.sensor_mm, depth], dim=-1)
    axes = chip_axes(layouts.sensor_mm, on_board)
    if neighbour is None:
        return local.permute(2, 0, 1), axes
    turn, shift = presses.turn[neighbour], presses.shift_mm[neighbour]
    return (local @ turn.T + shift).permute(2, 0, 1), axes @ turn.T


def _magnets_of_patch(
    patch: Patch, layouts: Layouts
) -> tuple[Float[Tensor, "layout magnet 3"], Float[Tensor, "layout magnet 3"]]:
    """Centres and axes of a face's magnets, in the coordinates of its own frame."""
    surface, of_face = patch.surface, layouts.layouts_of_face(patch.surface.number)

    def turned() -> tuple[Tensor, Tensor]:
        centre, axes = surface.magnets(of_face)
        return centre, (axes @ magnet_axes(of_face).permute(1, 2, 0)[..., None])[..., 0]

    return of_face.kept(("turned magnets", surface.shape), (), turned)
