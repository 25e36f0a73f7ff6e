"""Places of magnets and sensors in a search, linear in its variables.

One map thus serves a single layout and a batch with gradients.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from design.layout.pockets import magnet_bodies
from design.search.faces import group_labels, layout_groups
from design.spec.object import ObjectSpec

_COLUMNS = ("x_mm", "y_mm", "depth_mm", "tilt_x_deg", "tilt_y_deg")


@dataclass(frozen=True)
class PlaceMap:
    """Places of parts as constant + matrix · continuous variables.

    Columns of a magnet: x, y, depth (mm), tilt about x and y (degrees). Of a sensor: x, y (mm).
    """

    constant: Float[np.ndarray, "part column"]
    matrix: Float[np.ndarray, "part column variable"]

    def places_at(self, values: Float[np.ndarray, "variable"]) -> Float[np.ndarray, "part column"]:
        """The places of these values of the variables."""
        return self.constant + self.matrix @ values


def magnet_maps(structured: ObjectSpec, names: tuple[str, ...]) -> tuple[PlaceMap, ...]:
    """Return where magnets are, of what `with_structure` made, for each of `layout_groups`; `names` are the
    continuous variables'."""
    count = structured.magnets.count
    tilts = structured.magnets.tilt_deg or ((0.0, 0.0),) * count
    maps = []
    for group, label in zip(layout_groups(structured), group_labels(structured), strict=True):
        bodies = magnet_bodies(structured)[structured.body.sensed.index(group[0])]
        base = np.array(
            [[*(b.centre_mm * [1, 1, -1]), *tilt] for b, tilt in zip(bodies, tilts, strict=True)]
        )
        maps.append(_place_map(names, label, "magnet", base))
    return tuple(maps)


def sensor_maps(structured: ObjectSpec, names: tuple[str, ...]) -> tuple[PlaceMap, ...]:
    """Return where sensors are, where they move: one layout for every face of a group."""
    still = np.zeros((structured.sensors.count_per_face, 2))
    return tuple(_place_map(names, label, "sensor", still) for label in group_labels(structured))


def polarities(structured: ObjectSpec, params: Mapping[str, Any]) -> list[float]:
    """Polarization of every magnet over that of the specification's first; negative for north inward."""
    magnets = structured.magnets
    signs, strengths = magnets.polarities, magnets.strengths
    if structured.search.vary.magnet_north:
        norths = choices_of_magnets(structured, params, "north")
        signs = tuple(1 if way == "outward" else -1 for way in norths)
    return [float(sign * strength) for sign, strength in zip(signs, strengths, strict=True)]


def choices_of_magnets(
    structured: ObjectSpec, params: Mapping[str, Any], name: Literal["north", "size"]
) -> list[str]:
    """Return what a trial chose for every magnet of a face."""
    return [params[f"magnet{k}_{name}"] for k in range(1, structured.magnets.count + 1)]


def _place_map(
    names: tuple[str, ...], label: str, part: str, base: Float[np.ndarray, "part column"]
) -> PlaceMap:
    """Columns that have variables are theirs, all others stay as they are.

    Names of x and y begin with the group's label; depths and tilts are those of all groups.
    """
    constant, matrix = base.copy(), np.zeros((*base.shape, len(names)))
    for row in range(len(base)):
        for column, name in enumerate(_COLUMNS[: base.shape[1]]):
            variable = f"{label if column < 2 else ''}{part}{row + 1}_{name}"
            if variable in names:
                constant[row, column] = 0.0
                matrix[row, column, names.index(variable)] = 1.0
    return PlaceMap(constant, matrix)
