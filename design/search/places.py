"""Places of magnets and sensors in a search: linear in its variables, under a symmetry.

Sensors on a ring are linear in radius and azimuth. One map thus serves a single layout and a batch
with gradients. Symmetry turns and mirrors one magnet's variables about the face's centre.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from jaxtyping import Float

from design.layout.pockets import magnet_bodies
from design.spec.object import ObjectSpec
from design.spec.search import VarySpec


@dataclass(frozen=True)
class Seat:
    """Where a magnet or sensor comes from: variables of `label`, moved and turned by matrices."""

    label: str
    place: tuple[tuple[float, float], tuple[float, float]]
    turn: tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True)
class PlaceMap:
    """Places of parts as constant + matrix · continuous variables; `polar`: radius and azimuth.

    Columns of a magnet: x, y, depth (mm), tilt about x and y (degrees). Of a sensor: x, y (mm), or
    radius (mm) and azimuth (degrees).
    """

    constant: Float[np.ndarray, "part column"]
    matrix: Float[np.ndarray, "part column variable"]
    polar: bool = False

    def at(self, values: Float[np.ndarray, "variable"]) -> Float[np.ndarray, "part column"]:
        found = self.constant + self.matrix @ values
        if not self.polar:
            return found
        radius, azimuth = found[:, 0], np.deg2rad(found[:, 1])
        return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth)], axis=1)


def magnet_map(structured: ObjectSpec, names: tuple[str, ...]) -> PlaceMap:
    """Where magnets are, of what `with_structure` made; `names` are the continuous variables'."""
    bodies = magnet_bodies(structured)[0]
    tilts = structured.magnets.tilt_deg or ((0.0, 0.0),) * len(bodies)
    base = np.array(
        [[*(b.centre_mm * [1, 1, -1]), *tilt] for b, tilt in zip(bodies, tilts, strict=True)]
    )
    seats = seats_of(structured.search.magnet_symmetry, len(bodies))
    columns = {"x_mm": 0, "y_mm": 1, "depth_mm": 2, "tilt_x_deg": 3, "tilt_y_deg": 4}
    return _place_map(structured.search.vary, names, "magnet", seats, base, columns)


def sensor_map(structured: ObjectSpec, names: tuple[str, ...]) -> PlaceMap:
    """Where sensors are, where they move: one layout for every face."""
    count = structured.sensors.count_per_face
    if structured.search.sensor_symmetry == "ring":
        around = np.column_stack([np.zeros(count), 360.0 * np.arange(count) / count])
        matrix = np.zeros((count, 2, len(names)))
        matrix[:, 0, names.index("sensor_radius_mm")] = 1.0
        matrix[:, 1, names.index("sensor_azimuth_deg")] = 1.0
        return PlaceMap(around, matrix, polar=True)
    seats = seats_of(structured.search.sensor_symmetry, count)
    return _place_map(
        structured.search.vary, names, "sensor", seats, np.zeros((count, 2)), {"x_mm": 0, "y_mm": 1}
    )


def polarities(structured: ObjectSpec, params: Mapping[str, Any]) -> list[float]:
    """1 for every magnet with its north outward, −1 for the others."""
    if not structured.search.vary.magnet_north:
        return [float(p) for p in structured.magnets.polarities]
    seats = seats_of(structured.search.magnet_symmetry, structured.magnets.count)
    return [1.0 if params[f"magnet{s.label}_north"] == "outward" else -1.0 for s in seats]


def _place_map(
    vary: VarySpec,
    names: tuple[str, ...],
    part: str,
    seats: tuple[Seat, ...],
    base: Float[np.ndarray, "part column"],
    columns: dict[str, int],
) -> PlaceMap:
    """Columns that have variables are theirs, moved by the seats; all others stay as they are."""
    constant = base.copy()
    matrix = np.zeros((*base.shape, len(names)))
    for row, seat in enumerate(seats):
        prefix = f"{part}{seat.label}_"
        for first, moved in ((0, seat.place), (3, seat.turn)):
            pair = [
                prefix + name for name, column in columns.items() if column in (first, first + 1)
            ]
            if _freed(vary, part, first):
                constant[row, first : first + 2] = 0.0
            for k, name in enumerate(pair):
                if name in names:
                    matrix[row, first : first + 2, names.index(name)] = np.asarray(moved)[:, k]
        if prefix + "depth_mm" in names:
            constant[row, 2] = 0.0
            matrix[row, 2, names.index(prefix + "depth_mm")] = 1.0
    return PlaceMap(constant, matrix)


def _freed(vary: VarySpec, part: str, first_column: int) -> bool:
    if first_column == 0:
        return getattr(vary, f"{part}_reach_mm") is not None
    return part == "magnet" and vary.magnet_tilt_deg is not None


_ONE = ((1.0, 0.0), (0.0, 1.0))
_NONE = ((0.0, 0.0), (0.0, 0.0))
_MIRROR = ((-1.0, 0.0), (0.0, 1.0))
_MIRROR_TURN = ((1.0, 0.0), (0.0, -1.0))
"""Tilts are axial vectors: mirrored in x, that about y changes its sign."""
_ON_X0 = ((0.0, 0.0), (0.0, 1.0))
_ON_X0_TURN = ((1.0, 0.0), (0.0, 0.0))


@cache
def seats_of(symmetry: str, count: int) -> tuple[Seat, ...]:
    if symmetry == "free":
        return tuple(Seat(str(k + 1), _ONE, _ONE) for k in range(count))
    if symmetry == "mirrored":
        pairs = [
            Seat(str(k + 1), *matrices)
            for k in range(count // 2)
            for matrices in ((_ONE, _ONE), (_MIRROR, _MIRROR_TURN))
        ]
        return (*pairs, *([Seat("_axis", _ON_X0, _ON_X0_TURN)] if count % 2 else []))
    quarter = [
        _ONE,
        ((0.0, -1.0), (1.0, 0.0)),
        ((-1.0, 0.0), (0.0, -1.0)),
        ((0.0, 1.0), (-1.0, 0.0)),
    ]
    fours = [Seat(str(k + 1), turn, turn) for k in range(count // 4) for turn in quarter]
    return (*fours, *([Seat("_centre", _NONE, _NONE)] if count % 4 else []))


def generators(symmetry: str, counts: tuple[int, ...]) -> list[Seat]:
    """One seat for each label that any of the counts needs."""
    found: dict[str, Seat] = {}
    for count in sorted(counts):
        for seat in seats_of(symmetry, count):
            found.setdefault(seat.label, seat)
    return list(found.values())
