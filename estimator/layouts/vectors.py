"""Batches of layouts as points of a search space.

One structure (counts, parts, shell) of `design.search.space` at a time; everything continuous has
gradients.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.layout.pockets import sensor_places
from design.search.faces import layout_groups
from design.search.places import PlaceMap, magnet_maps, sensor_maps
from design.search.space import SearchSpace
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts, layouts_by_face, magnets_below_mm


@dataclass(frozen=True)
class LayoutSpace:
    """A structure of a search space as tensors; `layout_space` makes it.

    `low` and `span` take the unit cube to values; `groups` are the faces that share a layout, and maps
    those of `design.search.space` for each; no maps of sensors where they stay. `gap_mm` of silicone is left
    between pockets, where that is more than can be cast.
    """

    structured: ObjectSpec
    low: Float[Tensor, "variable"]
    span: Float[Tensor, "variable"]
    groups: tuple[tuple[int, ...], ...]
    magnets: tuple[PlaceMap, ...]
    sensors: tuple[PlaceMap, ...]
    gap_mm: float = 0.0


def layout_space(
    space: SearchSpace, structured: ObjectSpec, dtype: torch.dtype = torch.float32
) -> LayoutSpace:
    """Set up one structure, a specification that `design.search.space.with_structure` made."""
    low = np.array([v.low for v in space.continuous])
    high = np.array([v.high for v in space.continuous])
    moving = space.spec.search.vary.sensor_reach_mm is not None
    return LayoutSpace(
        structured,
        torch.as_tensor(low, dtype=dtype),
        torch.as_tensor(high - low, dtype=dtype),
        layout_groups(structured),
        magnet_maps(structured, space.continuous_names),
        sensor_maps(structured, space.continuous_names) if moving else (),
    )


def layouts_at(
    space: LayoutSpace,
    unit: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    face: int,
) -> Layouts:
    """Layouts of one face at points of the unit cube of the continuous variables; where there are several
    groups, with those of all faces."""
    values = space.low + unit * space.span
    if len(space.groups) == 1:
        return _layouts(space, values, polarity, face, 0)
    layouts_of_faces: dict[int, Layouts] = {}
    for index, group in enumerate(space.groups):
        # Sensors that stay lie on each face as they do; else the faces of a group share one object.
        each = (
            [_layouts(space, values, polarity, group[0], index)] * len(group)
            if space.sensors
            else [_layouts(space, values, polarity, number, index) for number in group]
        )
        layouts_of_faces |= dict(zip(group, each, strict=True))
    return layouts_by_face(layouts_of_faces, face)


def _layouts(
    space: LayoutSpace,
    values: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    face: int,
    group: int,
) -> Layouts:
    magnets = _places(space.magnets[group], values)
    if not space.sensors:
        placed = sensor_places(space.structured)[space.structured.body.sensed.index(face)]
        fixed = [(x, y) for x, y, _ in placed]
        sensors = torch.as_tensor(fixed, dtype=values.dtype).expand(len(values), -1, -1)
    else:
        sensors = _places(space.sensors[group], values)
    below = torch.tensor([0.0, 0.0, magnets_below_mm(space.structured)], dtype=values.dtype)
    return Layouts(magnets[..., :3] + below, torch.deg2rad(magnets[..., 3:]), polarity, sensors)


def _places(
    places: PlaceMap, values: Float[Tensor, "layout variable"]
) -> Float[Tensor, "layout part column"]:
    matrix, constant = (
        torch.as_tensor(part, dtype=values.dtype) for part in (places.matrix, places.constant)
    )
    # p part, c column (x, y, …), v variable, l layout
    return constant + torch.einsum("pcv,lv->lpc", matrix, values)
