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
from design.search.places import PlaceMap, magnet_map, sensor_map
from design.search.space import SearchSpace
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts


@dataclass(frozen=True)
class LayoutSpace:
    """A structure of a search space as tensors; `layout_space` makes it.

    `low` and `span` take the unit cube to values; maps are those of `design.search.space`, that of
    sensors None where they stay.
    """

    structured: ObjectSpec
    low: Float[Tensor, "variable"]
    span: Float[Tensor, "variable"]
    magnets: PlaceMap
    sensors: PlaceMap | None


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
        magnet_map(structured, space.continuous_names),
        sensor_map(structured, space.continuous_names) if moving else None,
    )


def layouts_at(
    space: LayoutSpace,
    unit: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    face: int,
) -> Layouts:
    """Layouts of one face at points of the unit cube of the continuous variables."""
    values = space.low + unit * space.span
    magnets = _places(space.magnets, values)
    if space.sensors is None:
        placed = sensor_places(space.structured)[space.structured.body.sensed.index(face)]
        fixed = [(x, y) for x, y, _ in placed]
        sensors = torch.as_tensor(fixed, dtype=unit.dtype).expand(len(unit), -1, -1)
    else:
        sensors = _places(space.sensors, values)
    if space.sensors is not None and space.sensors.polar:
        azimuth = torch.deg2rad(sensors[..., 1])
        sensors = sensors[..., :1] * torch.stack([azimuth.cos(), azimuth.sin()], dim=-1)
    return Layouts(magnets[..., :3], torch.deg2rad(magnets[..., 3:]), polarity, sensors)


def _places(
    places: PlaceMap, values: Float[Tensor, "layout variable"]
) -> Float[Tensor, "layout part column"]:
    matrix, constant = (
        torch.as_tensor(part, dtype=values.dtype) for part in (places.matrix, places.constant)
    )
    return constant + torch.einsum("pcv,lv->lpc", matrix, values)
