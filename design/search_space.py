"""The layouts that a search may try: named variables ↔ a vector in [0, 1]ⁿ ↔ a specification.

Places are linear in the variables (but for sensors on a ring, whose radius and azimuth are), so that
one map serves a single layout and a batch with gradients. Symmetry turns and mirrors one magnet's
variables about the face's centre.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.magnet_parts import magnet_part
from design.pockets import magnet_bodies
from design.spec import ObjectSpec
from design.spec_as_built import AsBuiltSpec
from design.spec_io import parse_spec
from design.spec_magnets import MagnetSpec
from design.spec_search import VarySpec
from design.spec_sensors import SensorSpec
from design.spec_silicone import SiliconeSpec

Params = Mapping[str, Any]
"""Value of every variable, by name."""

STRUCTURE = (
    "magnet_count",
    "magnet_part",
    "sensor_count",
    "sensor_chip",
    "sensor_turn_deg",
    "sensor_range_mt",
    "shell_thickness_mm",
    "silicone",
    "core_size_mm",
)
"""Choices between which places are not comparable; a batch is scored structure by structure."""


@dataclass(frozen=True)
class Variable:
    """A range from `low` to `high` in the unit of its name, or one of `choices`."""

    name: str
    low: float = 0.0
    high: float = 1.0
    choices: tuple[Any, ...] = ()


@dataclass(frozen=True)
class SearchSpace:
    """A specification and its variables, in the order of the vector."""

    spec: ObjectSpec
    variables: tuple[Variable, ...]

    @property
    def continuous(self) -> tuple[Variable, ...]:
        return tuple(v for v in self.variables if not v.choices)


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


def search_space(spec: ObjectSpec) -> SearchSpace:
    """The variables that `[search]` frees.

    Raises
    ------
    InputError
        Nothing may change, or what may change contradicts the rest of the specification.
    """
    vary = spec.search.vary
    variables = [
        Variable(name, choices=choices)
        for name in STRUCTURE
        if (choices := getattr(vary, name)) is not None
    ]
    variables += _magnet_variables(spec) + _sensor_variables(spec)
    if not variables:
        raise InputError(
            "nothing may change: [search.vary] is empty. Name what may, e.g. magnet_reach_mm = 14.0"
        )
    _check(spec)
    return SearchSpace(spec, tuple(variables))


def structure_of(space: SearchSpace, params: Params) -> tuple[tuple[str, Any], ...]:
    """The choices that decide which layouts can be scored together."""
    return tuple((v.name, params[v.name]) for v in space.variables if v.name in STRUCTURE)


def params_at(space: SearchSpace, unit: Float[np.ndarray, "variable"]) -> dict[str, Any]:
    """Values at a point of the unit cube; choices share [0, 1] evenly."""
    found: dict[str, Any] = {}
    for variable, u in zip(space.variables, unit, strict=True):
        if variable.choices:
            count = len(variable.choices)
            found[variable.name] = variable.choices[min(int(u * count), count - 1)]
        else:
            found[variable.name] = variable.low + float(u) * (variable.high - variable.low)
    return found


def unit_of(space: SearchSpace, params: Params) -> Float[np.ndarray, "variable"]:
    """The point of the unit cube; a choice's is the middle of its share."""
    found = []
    for variable in space.variables:
        value = params[variable.name]
        if variable.choices:
            found.append((variable.choices.index(value) + 0.5) / len(variable.choices))
        else:
            found.append((value - variable.low) / (variable.high - variable.low))
    return np.array(found)


def with_layout(spec: ObjectSpec, params: Params) -> ObjectSpec:
    """The specification with that layout, checked like one read from a file.

    Raises
    ------
    InputError
        Something does not fit.
    """
    space = search_space(spec)
    structured = with_structure(space, params)
    values = np.array([params[v.name] for v in space.continuous], dtype=float)
    content = structured.model_dump(mode="json")
    vary = spec.search.vary
    magnets = magnet_map(space, structured).at(values)
    if vary.magnet_reach_mm is not None:
        content["magnets"]["positions_mm"] = magnets[:, :2].tolist()
    if vary.magnet_depth_mm is not None:
        content["magnets"]["depth_mm"] = magnets[:, 2].tolist()
    if vary.magnet_tilt_deg is not None:
        content["magnets"]["tilt_deg"] = magnets[:, 3:].tolist()
    if vary.magnet_north:
        poles = polarities(space, structured, params)
        content["magnets"]["north"] = ["outward" if pole > 0 else "inward" for pole in poles]
    if vary.sensor_reach_mm is not None:
        places = sensor_map(space, structured).at(values).tolist()
        content["sensors"]["positions_mm"] = [places] * 5
        content["sensors"]["count_per_face"] = len(places)
    return parse_spec(content, "the layout")


def with_structure(space: SearchSpace, params: Params) -> ObjectSpec:
    """The specification with the layout's choices but the old places: not checked as a whole."""
    spec = space.spec
    chosen = {v.name: params[v.name] for v in space.variables if v.name in STRUCTURE}
    update: dict[str, Any] = {"as_built": AsBuiltSpec()}
    if "magnet_part" in chosen:
        update |= _with_part(spec, chosen["magnet_part"])
    if "magnet_count" in chosen:
        unplaced = {"positions_mm": ((0.0, 0.0),) * chosen["magnet_count"]}
        update["magnets"] = update.get("magnets", spec.magnets).model_copy(update=unplaced)
    if "silicone" in chosen:
        update["silicone"] = SiliconeSpec(name=chosen["silicone"])
    update |= _with_sizes(spec, update.get("shell", spec.shell), chosen)
    update["sensors"] = _with_sensors(spec.sensors, chosen)
    return spec.model_copy(update=update)


def magnet_map(space: SearchSpace, structured: ObjectSpec) -> PlaceMap:
    """Where magnets are, for the structure of a specification made by `with_structure`."""
    bodies = magnet_bodies(structured)[0]
    tilts = structured.magnets.tilt_deg or ((0.0, 0.0),) * len(bodies)
    base = np.array(
        [[*(b.centre_mm * [1, 1, -1]), *tilt] for b, tilt in zip(bodies, tilts, strict=True)]
    )
    seats = _seats(space.spec.search.magnet_symmetry, len(bodies))
    columns = {"x_mm": 0, "y_mm": 1, "depth_mm": 2, "tilt_x_deg": 3, "tilt_y_deg": 4}
    return _place_map(space, "magnet", seats, base, columns)


def sensor_map(space: SearchSpace, structured: ObjectSpec) -> PlaceMap:
    """Where sensors are, where they move: one layout for every face."""
    count = structured.sensors.count_per_face
    if space.spec.search.sensor_symmetry == "ring":
        around = np.column_stack([np.zeros(count), 360.0 * np.arange(count) / count])
        matrix = np.zeros((count, 2, len(space.continuous)))
        names = [v.name for v in space.continuous]
        matrix[:, 0, names.index("sensor_radius_mm")] = 1.0
        matrix[:, 1, names.index("sensor_azimuth_deg")] = 1.0
        return PlaceMap(around, matrix, polar=True)
    seats = _seats(space.spec.search.sensor_symmetry, count)
    return _place_map(space, "sensor", seats, np.zeros((count, 2)), {"x_mm": 0, "y_mm": 1})


def polarities(space: SearchSpace, structured: ObjectSpec, params: Params) -> list[float]:
    """1 for every magnet with its north outward, −1 for the others."""
    if not space.spec.search.vary.magnet_north:
        return [float(p) for p in structured.magnets.polarities]
    seats = _seats(space.spec.search.magnet_symmetry, len(structured.magnets.positions_mm))
    return [1.0 if params[f"magnet{s.label}_north"] == "outward" else -1.0 for s in seats]


def _place_map(
    space: SearchSpace,
    part: str,
    seats: tuple[Seat, ...],
    base: Float[np.ndarray, "part column"],
    columns: dict[str, int],
) -> PlaceMap:
    """Columns that have variables are theirs, moved by the seats; all others stay as they are."""
    constant, names = base.copy(), [v.name for v in space.continuous]
    matrix = np.zeros((*base.shape, len(names)))
    for row, seat in enumerate(seats):
        prefix = f"{part}{seat.label}_"
        for first, moved in ((0, seat.place), (3, seat.turn)):
            pair = [
                prefix + name for name, column in columns.items() if column in (first, first + 1)
            ]
            if _freed(space, part, first):
                constant[row, first : first + 2] = 0.0
            for k, name in enumerate(pair):
                if name in names:
                    matrix[row, first : first + 2, names.index(name)] = np.asarray(moved)[:, k]
        if prefix + "depth_mm" in names:
            constant[row, 2] = 0.0
            matrix[row, 2, names.index(prefix + "depth_mm")] = 1.0
    return PlaceMap(constant, matrix)


def _freed(space: SearchSpace, part: str, first_column: int) -> bool:
    vary = space.spec.search.vary
    if first_column == 0:
        return getattr(vary, f"{part}_reach_mm") is not None
    return part == "magnet" and vary.magnet_tilt_deg is not None


def _magnet_variables(spec: ObjectSpec) -> list[Variable]:
    vary, symmetry = spec.search.vary, spec.search.magnet_symmetry
    counts = vary.magnet_count or (len(spec.magnets.positions_mm),)
    found: list[Variable] = []
    for seat in _generators(symmetry, counts):
        name = f"magnet{seat.label}"
        found += _pair(name, ("x_mm", "y_mm"), vary.magnet_reach_mm, seat.place)
        if vary.magnet_depth_mm is not None:
            found.append(Variable(f"{name}_depth_mm", *vary.magnet_depth_mm))
        found += _pair(name, ("tilt_x_deg", "tilt_y_deg"), vary.magnet_tilt_deg, seat.turn)
        if vary.magnet_north:
            found.append(Variable(f"{name}_north", choices=("outward", "inward")))
    return found


def _sensor_variables(spec: ObjectSpec) -> list[Variable]:
    reach, symmetry = spec.search.vary.sensor_reach_mm, spec.search.sensor_symmetry
    if reach is None:
        return []
    counts = spec.search.vary.sensor_count or (spec.sensors.count_per_face,)
    if symmetry == "ring":
        turn = 360.0 / min(counts)
        return [Variable("sensor_radius_mm", 0.0, reach), Variable("sensor_azimuth_deg", 0.0, turn)]
    return [
        variable
        for seat in _generators(symmetry, counts)
        for variable in _pair(f"sensor{seat.label}", ("x_mm", "y_mm"), reach, seat.place)
    ]


def _pair(name: str, axes: tuple[str, str], reach: float | None, matrix: Any) -> list[Variable]:
    """Variables of two coordinates, without those that the seat's matrix drops."""
    if reach is None:
        return []
    kept = [axis for axis, column in zip(axes, np.asarray(matrix).T, strict=True) if column.any()]
    return [Variable(f"{name}_{axis}", -reach, reach) for axis in kept]


_ONE = ((1.0, 0.0), (0.0, 1.0))
_NONE = ((0.0, 0.0), (0.0, 0.0))
_MIRROR = ((-1.0, 0.0), (0.0, 1.0))
_MIRROR_TURN = ((1.0, 0.0), (0.0, -1.0))
"""Tilts are axial vectors: mirrored in x, that about y changes its sign."""
_ON_X0 = ((0.0, 0.0), (0.0, 1.0))
_ON_X0_TURN = ((1.0, 0.0), (0.0, 0.0))


@cache
def _seats(symmetry: str, count: int) -> tuple[Seat, ...]:
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


def _generators(symmetry: str, counts: tuple[int, ...]) -> list[Seat]:
    """One seat for each label that any of the counts needs."""
    found: dict[str, Seat] = {}
    for count in sorted(counts):
        for seat in _seats(symmetry, count):
            found.setdefault(seat.label, seat)
    return list(found.values())


def _with_part(spec: ObjectSpec, name: str) -> dict[str, Any]:
    """Another magnet, with the pocket's clearance and the silicone above it unchanged."""
    old, part = spec.magnets, magnet_part(name)
    graded = {} if part.grade is None else {"grade": part.grade}
    kept = old.model_dump(
        exclude={"shape", "diameter_mm", "inner_diameter_mm", "size_mm", "height_mm"}
    )
    if graded:
        kept.pop("remanence_t")
    new = MagnetSpec.model_validate({**kept, **graded, "part": name})
    wider, taller = new.diameter_mm - old.diameter_mm, new.height_mm - old.height_mm
    shell = spec.shell
    pocket = {
        "pocket_diameter_mm": shell.pocket_diameter_mm + wider,
        "pocket_depth_mm": shell.pocket_depth_mm + taller,
    }
    return {"magnets": new, "shell": shell.model_copy(update=pocket)}


def _with_sizes(spec: ObjectSpec, shell: Any, chosen: dict[str, Any]) -> dict[str, Any]:
    if not {"shell_thickness_mm", "core_size_mm"} & chosen.keys():
        return {"shell": shell}
    thickness = chosen.get("shell_thickness_mm", shell.thickness_mm)
    edges = spec.core_size_mm
    if "core_size_mm" in chosen:
        edges = (chosen["core_size_mm"],) * 3
    size = tuple(edge + 2 * thickness for edge in edges)
    return {
        "shell": shell.model_copy(update={"thickness_mm": thickness}),
        "body": spec.body.model_copy(update={"size_mm": size}),
    }


def _with_sensors(sensors: SensorSpec, chosen: dict[str, Any]) -> SensorSpec:
    content = sensors.model_dump(exclude_none=True)
    if "sensor_count" in chosen:
        content.pop("positions_mm", None)
        content["count_per_face"] = chosen["sensor_count"]
    if "sensor_chip" in chosen:
        content["chip"] = chosen["sensor_chip"]
    if "sensor_turn_deg" in chosen:
        content["mount_rotation_deg"] = (0.0, 0.0, chosen["sensor_turn_deg"])
    if "sensor_range_mt" in chosen:
        for key in ("counts_per_mt", "noise_counts"):
            del content[key]
        content["range_mt"] = chosen["sensor_range_mt"]
    return SensorSpec.model_validate(content)


def _check(spec: ObjectSpec) -> None:
    vary: VarySpec = spec.search.vary
    if spec.search.magnet_symmetry == "four-fold":
        counts = vary.magnet_count or (len(spec.magnets.positions_mm),)
        wrong = [count for count in counts if count % 4 > 1]
        if wrong:
            raise InputError(
                f'search.magnet_symmetry = "four-fold" takes 4, 5, 8, 9 … magnets; got {wrong}. Change '
                "search.vary.magnet_count, or the symmetry"
            )
    for name in vary.magnet_part or ():
        if magnet_part(name).shape == "block":
            raise InputError(
                f"search.vary.magnet_part = {name!r} is a block; a search takes round magnets only. "
                "Leave it out"
            )
    magnets = spec.magnets
    if vary.magnet_count and (
        magnets.north or magnets.tilt_deg or isinstance(magnets.depth_mm, tuple)
    ):
        raise InputError(
            "search.vary.magnet_count changes how many magnets there are, and magnets.north, tilt_deg "
            "or depth_mm hold for as many as there were. Leave those out"
        )
