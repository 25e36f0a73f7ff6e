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

Chips = tuple[Float[Tensor, "3 layout sensor"], Float[Tensor, "layout sensor 3 3"]]
"""Sensing points (mm), coordinates first, and chip axes as rows."""


def own_magnets(presses: PressBasis, layouts: Layouts) -> Magnets:
    """Return the magnets of the pressed face."""
    if presses.patches:
        return _magnets_of_patch(presses, presses.patches[0], layouts)
    xyd = layouts.magnet_mm
    centre = torch.stack([xyd[..., 0], xyd[..., 1], -xyd[..., 2]])
    return centre, magnet_axes(layouts)


def other_magnets(
    presses: PressBasis, layouts: Layouts
) -> tuple[Float[Tensor, "3 layout magnet face"], Float[Tensor, "3 layout magnet face"]]:
    """Return the magnets of the other faces, in their order."""
    if presses.patches:
        each = [_magnets_of_patch(presses, patch, layouts) for patch in presses.patches[1:]]
        none = layouts.magnet_mm.permute(2, 0, 1)[..., None][..., :0]
        centre, axis = (
            torch.cat([none, *(parts[k][..., None] for parts in each)], dim=-1) for k in (0, 1)
        )
        return centre, axis
    centre, axis = own_magnets(presses, layouts)
    # g other face, j axis of its frame, i axis of this one's, b layout, m magnet
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
    index = 0 if neighbour is None else 1 + neighbour
    if presses.patches:
        frame, surface = presses.patches[0].surface.frame, presses.patches[index].surface
        point, axes = surface.chips(layouts.layouts_of_face(surface.number).sensor_mm)
        turn = torch.as_tensor(frame.axes.copy(), dtype=point.dtype)
        centre = torch.as_tensor(frame.centre_mm.copy(), dtype=point.dtype)
        return ((point - centre) @ turn).permute(2, 0, 1), axes @ turn
    depth = torch.full_like(layouts.sensor_mm[..., :1], -depth_mm)
    local = torch.cat([layouts.sensor_mm, depth], dim=-1)
    axes = chip_axes(layouts.sensor_mm, on_board)
    if neighbour is None:
        return local.permute(2, 0, 1), axes
    turn, shift = presses.turn[neighbour], presses.shift_mm[neighbour]
    return (local @ turn.T + shift).permute(2, 0, 1), axes @ turn.T


def magnets_under(
    patch: Patch, layouts: Layouts
) -> tuple[Float[Tensor, "layout magnet 3"], Float[Tensor, "layout magnet 3 3"]]:
    """Centres and axes of a patch's magnets as its surface places them, in the object's frame."""
    surface, face_layouts = patch.surface, layouts.layouts_of_face(patch.surface.number)
    return face_layouts.kept("under", (surface,), lambda: surface.magnets(face_layouts.magnet_mm))


def _magnets_of_patch(presses: PressBasis, patch: Patch, layouts: Layouts) -> Magnets:
    frame, layouts = presses.patches[0].surface.frame, layouts.layouts_of_face(patch.surface.number)
    centre, axes = magnets_under(patch, layouts)
    turn = torch.as_tensor(frame.axes.copy(), dtype=centre.dtype)
    middle = torch.as_tensor(frame.centre_mm.copy(), dtype=centre.dtype)
    axis = (axes @ magnet_axes(layouts).permute(1, 2, 0)[..., None])[..., 0]
    return ((centre - middle) @ turn).permute(2, 0, 1), (axis @ turn).permute(2, 0, 1)
