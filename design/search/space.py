"""Space of layouts that a search may try: named variables ↔ a vector in [0, 1]ⁿ ↔ a specification."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil, floor
from typing import Any

import numpy as np
from jaxtyping import Float

from design.catalogue.magnets import MAGNET_PARTS
from design.errors import InputError
from design.layout.body import core_frames, face_frames
from design.layout.pockets import core_pockets, magnet_bodies, sensor_places, shell_pockets
from design.search.faces import group_labels, layout_groups
from design.search.places import choices_of_magnets, magnet_maps, sensor_maps
from design.search.structure import (
    SIZE,
    STRUCTURE,
    part_names,
    with_structure,
)
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from design.spec.search import VarySpec
from design.spec_io import parse_spec

Params = Mapping[str, Any]
"""Value of every variable, by name."""


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
    def continuous_names(self) -> tuple[str, ...]:
        return tuple(v.name for v in self.continuous)

    @property
    def continuous(self) -> tuple[Variable, ...]:
        return tuple(v for v in self.variables if not v.choices)


def search_space(spec: ObjectSpec) -> SearchSpace:
    """The variables that `[search]` frees, in a specification that says so (`with_freedom`).

    Raises
    ------
    InputError
        What may change contradicts the rest of the specification.
    """
    spec = with_freedom(spec)
    vary = spec.search.vary
    variables = [
        Variable(name, choices=choices)
        for name in STRUCTURE
        if (choices := getattr(vary, name)) is not None
    ]
    variables += _magnet_variables(spec) + _sensor_variables(spec)
    _check(spec)
    return SearchSpace(spec, tuple(variables))


def with_freedom(spec: ObjectSpec) -> ObjectSpec:
    """The specification; where `[search.vary]` frees nothing, magnets and sensors over their whole faces,
    each face by itself where its parts lie so."""
    search, layouts = spec.search, spec.search.vary.layouts
    if search.vary != VarySpec(layouts=layouts):
        return spec
    alone = len(spec.magnets.lists) > 1 and len(layout_groups(spec)) == 1
    freed = search.vary.changed(
        layouts="per face" if alone else layouts, **reaches_that_fit_mm(spec)
    )
    return spec.changed(search=search.changed(vary=freed))


def reaches_that_fit_mm(spec: ObjectSpec) -> dict[str, float]:
    """Largest useful `magnet_reach_mm` and `sensor_reach_mm`, in 0.1 mm and no less than what parts have now.

    Magnets of the shell: half the longest face less the zone of its neighbours' pockets and the
    pocket's own reach beyond the magnet's middle. Sensors of the core: half the longest of its faces
    less a wall and what a recess holds beyond its sensor; magnets in the core alike. Shorter sides,
    corners and gaps are limits of the search itself.
    """
    in_core = spec.arrangement == "sensors-in-core"
    pockets = [
        pocket for face in (shell_pockets if in_core else core_pockets)(spec) for pocket in face
    ]
    beyond = max(
        float((pocket.reach_mm - abs(pocket.body.centre_mm[:2])).max()) for pocket in pockets
    )
    deepest = max(pocket.body.height_mm / 2 - float(pocket.body.centre_mm[2]) for pocket in pockets)
    core = max(max(frame.half_extents_mm) for frame in core_frames(spec))
    wall = spec.printer.wall_mm
    outwards = spec.core.recess_outer_radius_mm - spec.sensors.radius_mm
    room = {"magnet": core - wall - beyond, "sensor": core - wall - outwards}
    if in_core:
        longest = max(max(frame.half_extents_mm) for frame in face_frames(spec))
        room["magnet"] = longest - deepest - beyond
    present = {
        "magnet": max(float(abs(pocket.body.centre_mm[:2]).max()) for pocket in pockets),
        "sensor": max(
            max(abs(x), abs(y)) for of_face in sensor_places(spec) for x, y, _ in of_face
        ),
    }
    return {
        f"{part}_reach_mm": max(floor(10 * mm), ceil(10 * present[part])) / 10
        for part, mm in room.items()
    }


def structure_of(space: SearchSpace, params: Params) -> tuple[tuple[str, Any], ...]:
    """The choices that decide which layouts can be scored together."""
    return tuple(
        (v.name, params[v.name])
        for v in space.variables
        if v.name in STRUCTURE or v.name.endswith(SIZE)
    )


def params_at(space: SearchSpace, unit: Float[np.ndarray, "variable"]) -> dict[str, Any]:
    """Values at a point of the unit cube; choices share [0, 1] evenly."""
    params: dict[str, Any] = {}
    for variable, u in zip(space.variables, unit, strict=True):
        if variable.choices:
            count = len(variable.choices)
            params[variable.name] = variable.choices[min(int(u * count), count - 1)]
        else:
            params[variable.name] = variable.low + float(u) * (variable.high - variable.low)
    return params


def unit_of(space: SearchSpace, params: Params) -> Float[np.ndarray, "variable"]:
    """The point of the unit cube; a choice's is the middle of its share."""
    shares = []
    for variable in space.variables:
        value = params[variable.name]
        if variable.choices:
            shares.append((variable.choices.index(value) + 0.5) / len(variable.choices))
        else:
            shares.append((value - variable.low) / (variable.high - variable.low))
    return np.array(shares)


def start_params(space: SearchSpace) -> dict[str, Any] | None:
    """The specification's own layout as variables; None where the space does not hold it."""
    spec = space.spec
    values_by_name: dict[str, Any] = {
        "magnet_count": spec.magnets.count,
        "sensor_count": spec.sensors.count_per_face,
        "sensor_chip": spec.sensors.chip,
    }
    tilts = spec.magnets.tilt_deg or ((0.0, 0.0),) * spec.magnets.count
    norths, parts = spec.magnets.north or ("outward",) * len(tilts), part_names(spec.magnets)
    for k, (depth, tilt) in enumerate(zip(_depths(spec), tilts, strict=True), start=1):
        values: dict[str, Any] = {"depth_mm": depth, "tilt_x_deg": tilt[0], "tilt_y_deg": tilt[1]}
        values["north"] = norths[k - 1]
        values["size"] = parts[k - 1]
        values_by_name |= {f"magnet{k}_{name}": value for name, value in values.items()}
    for group, label in zip(layout_groups(spec), group_labels(spec), strict=True):
        face = spec.body.sensed.index(group[0])
        places = {
            "magnet": [body.centre_mm[:2].tolist() for body in magnet_bodies(spec)[face]],
            "sensor": [place[:2] for place in sensor_places(spec)[face]],
        }
        for part, of_part in places.items():
            for k, (x, y) in enumerate(of_part, start=1):
                values_by_name |= {f"{label}{part}{k}_x_mm": x, f"{label}{part}{k}_y_mm": y}
    for variable in space.variables:
        values_by_name.setdefault(
            variable.name, middle_value(variable)
        )  # of parts that the start lacks
    if not all(_holds(v, values_by_name[v.name]) for v in space.variables):
        return None
    return {v.name: values_by_name[v.name] for v in space.variables}


def _depths(spec: ObjectSpec) -> list[float]:
    return [-float(body.centre_mm[2]) for body in magnet_bodies(spec)[0]]


def middle_value(variable: Variable) -> Any:
    return variable.choices[0] if variable.choices else (variable.low + variable.high) / 2


def _holds(variable: Variable, value: Any) -> bool:
    if variable.choices:
        return value in variable.choices
    return variable.low <= value <= variable.high


def with_layout(spec: ObjectSpec, params: Params) -> ObjectSpec:
    """The specification with that layout, checked like one read from a file.

    Places are rounded to 0.01 mm and 0.1°, as drawings give them.

    Raises
    ------
    InputError
        Something does not fit.
    """
    space = search_space(spec)
    structured = with_structure(spec, params)
    names = space.continuous_names
    values = np.array([params[name] for name in names], dtype=float)
    content = structured.model_dump(mode="json")
    vary = spec.search.vary
    magnets = [each.places_at(values) for each in magnet_maps(structured, names)]
    if vary.magnet_reach_mm is not None:
        lists = [places[:, :2].round(2).tolist() for places in magnets]
        content["magnets"]["positions_mm"] = _lists_by_face(spec, lists)
    if vary.magnet_depth_mm is not None:
        content["magnets"]["depth_mm"] = magnets[0][:, 2].round(2).tolist()
    if vary.magnet_tilt_deg is not None:
        content["magnets"]["tilt_deg"] = magnets[0][:, 3:].round(1).tolist()
    if vary.magnet_north:
        content["magnets"]["north"] = choices_of_magnets(structured, params, "north")
    if vary.sensor_reach_mm is not None:
        lists = [
            each.places_at(values).round(2).tolist() for each in sensor_maps(structured, names)
        ]
        content["sensors"]["positions_mm"] = _lists_by_face(spec, lists)
        content["sensors"]["count_per_face"] = len(lists[0])
    return parse_spec(content, "the layout")


def _lists_by_face(spec: ObjectSpec, of_groups: list[Any]) -> Any:
    """One list for all faces, or that of its group for each."""
    if len(of_groups) == 1:
        return of_groups[0]
    groups = layout_groups(spec)
    return [
        next(
            group_list for group_list, group in zip(of_groups, groups, strict=True) if face in group
        )
        for face in spec.body.sensed
    ]


def _magnet_variables(spec: ObjectSpec) -> list[Variable]:
    vary, tilt = spec.search.vary, spec.search.vary.magnet_tilt_deg
    variables: list[Variable] = []
    for number in range(1, max(vary.magnet_count or (spec.magnets.count,)) + 1):
        name = f"magnet{number}"
        for label, reach in _reaches(spec, vary.magnet_reach_mm):
            variables += _pair(label + name, ("x_mm", "y_mm"), reach)
        if vary.magnet_depth_mm is not None:
            variables.append(Variable(f"{name}_depth_mm", *vary.magnet_depth_mm))
        turns = None if tilt is None else (tilt, tilt)
        variables += _pair(name, ("tilt_x_deg", "tilt_y_deg"), turns)
        if vary.magnet_sizes is not None:
            variables.append(Variable(name + SIZE, choices=vary.magnet_sizes))
        if vary.magnet_north:
            variables.append(Variable(f"{name}_north", choices=("outward", "inward")))
    return variables


def _sensor_variables(spec: ObjectSpec) -> list[Variable]:
    reach = spec.search.vary.sensor_reach_mm
    if reach is None:
        return []
    counts = spec.search.vary.sensor_count or (spec.sensors.count_per_face,)
    return [
        variable
        for label, most in _reaches(spec, reach)
        for number in range(1, max(counts) + 1)
        for variable in _pair(f"{label}sensor{number}", ("x_mm", "y_mm"), most)
    ]


Reach = tuple[float, float] | None


def _reaches(spec: ObjectSpec, reach_mm: float | None) -> list[tuple[str, Reach]]:
    """Label and largest |x| and |y| of every group; of several no more than the size of their faces."""
    labels = group_labels(spec)
    if reach_mm is None or len(labels) == 1:
        return [(label, None if reach_mm is None else (reach_mm, reach_mm)) for label in labels]
    halves = {frame.number: frame.half_extents_mm for frame in face_frames(spec)}
    firsts = [halves[group[0]] for group in layout_groups(spec)]
    return [
        (label, (min(reach_mm, float(x)), min(reach_mm, float(y))))
        for label, (x, y) in zip(labels, firsts, strict=True)
    ]


def _pair(name: str, axes: tuple[str, str], reach: Reach) -> list[Variable]:
    """Variables of two coordinates; none without a reach."""
    if reach is None:
        return []
    pairs = zip(axes, reach, strict=True)
    return [Variable(f"{name}_{axis}", -most, most) for axis, most in pairs]


def _check(spec: ObjectSpec) -> None:
    vary: VarySpec = spec.search.vary
    magnets = spec.magnets
    _check_sizes(vary, magnets)
    listed = (magnets.depth_mm, magnets.grade, magnets.remanence_t)
    listed += (magnets.part, magnets.diameter_mm, magnets.inner_diameter_mm, magnets.height_mm)
    if vary.magnet_count and (
        magnets.north or magnets.tilt_deg or any(isinstance(entry, tuple) for entry in listed)
    ):
        raise InputError(
            "search.vary.magnet_count changes how many magnets there are, and magnets.north, tilt_deg, "
            "depth_mm, grade, remanence_t or sizes hold for as many as there were. Leave those out"
        )


def _check_sizes(vary: VarySpec, magnets: MagnetSpec) -> None:
    if vary.magnet_sizes is None:
        return
    parts = [MAGNET_PARTS.named(name) for name in vary.magnet_sizes]
    blocks = [part.name for part in parts if part.shape == "block"]
    if blocks:
        raise InputError(
            f"search.vary.magnet_sizes takes round magnets only; got {blocks}. Leave them out"
        )
    if len({part.shape for part in parts}) > 1:
        raise InputError(
            f"search.vary.magnet_sizes must be of one shape; got {list(vary.magnet_sizes)}. Choose disks or "
            "rings"
        )
    graded = [part.name for part in parts if part.grade is not None]
    if graded:
        raise InputError(
            f"search.vary.magnet_sizes takes sizes sold in all grades; got {graded}. Take stock sizes "
            "such as D6x1"
        )
