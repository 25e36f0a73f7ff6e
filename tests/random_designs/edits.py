"""What users change in a specification that stands: single keys, and lists that belong together."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from design.catalogue.magnets import MAGNET_PARTS
from design.spec.object import ObjectSpec
from tests.random_designs.draw import KINDS, Edit

Value = Callable[[np.random.Generator, Any], Any]
"""A new value of a key, from the one that it has."""
_BORED = ("capsule", "sphere", "ellipsoid", "imported")
_CURVED = ("cylinder", *_BORED, "dome")
_ROUND = tuple(kind for kind in KINDS if kind != "pad")
_DEFAULTS = ObjectSpec(name="defaults").model_dump()


def _one_of(*choices: Any) -> Value:
    return lambda rng, now: choices[rng.integers(len(choices))]


def _times(low: float, high: float) -> Value:
    """The value that stands, times a factor."""
    return lambda rng, now: round(now * float(np.exp(rng.uniform(np.log(low), np.log(high)))), 2)


def _plus(low: float, high: float) -> Value:
    return lambda rng, now: round(max(0.1, now + float(rng.uniform(low, high))), 2)


def _from(low: float, high: float) -> Value:
    return lambda rng, now: round(float(rng.uniform(low, high)), 2)


def _edges(low: tuple[float, ...], high: tuple[float, ...]) -> Value:
    return lambda rng, now: rng.uniform(low, high).round(1).tolist()


def _some_faces(rng: np.random.Generator, now: Any) -> list[int]:
    """One to four of the faces that most bodies have closed."""
    return sorted((rng.choice(5, rng.integers(1, 5), replace=False) + 1).tolist())


def value_of(tables: dict[str, Any], where: str) -> Any:
    """What a dotted key stands at, or its default."""
    for holder in (tables, _DEFAULTS):
        for name in where.split("."):
            holder = holder.get(name) if isinstance(holder, dict) else None
        if holder is not None:
            return holder
    return None


def put(tables: dict[str, Any], where: str, value: Any) -> None:
    *above, key = where.split(".")
    holder = tables
    for name in above:
        holder = holder.setdefault(name, {})
    holder[key] = value


KEYS: tuple[tuple[str, Value, tuple[str, ...]], ...] = (
    ("shell.thickness_mm", _times(0.65, 1.5), KINDS),
    ("shell.pocket_diameter_mm", _plus(-0.5, 3.0), KINDS),
    ("shell.pocket_depth_mm", _times(0.6, 1.8), KINDS),
    ("shell.seal_layer_mm", _from(0.2, 1.5), KINDS),
    ("core.wall_mm", _times(0.7, 1.9), KINDS),
    ("core.recess_width_mm", _times(0.9, 1.5), KINDS),
    ("core.recess_inner_radius_mm", _plus(-2.5, 1.0), KINDS),
    ("core.recess_outer_radius_mm", _plus(-1.0, 4.0), KINDS),
    ("core.recess_depth_mm", _plus(-0.7, 1.6), KINDS),
    ("core.wire_hole_top_diameter_mm", _times(0.6, 2.2), KINDS),
    ("core.wire_hole_side_diameter_mm", _times(0.4, 2.0), KINDS),
    ("core.wire_channel_mm", _edges((0.6, 1.0), (2.5, 1.0)), KINDS),
    ("core.wires_per_sensor", _one_of(1, 2, 3, 6), KINDS),
    ("core.bay_mm", _edges((6, 6, 4), (26, 26, 24)), ("box", "cylinder")),
    ("core.bay_mm", _edges((6, 5, 1.5), (30, 24, 4)), ("pad", "dome")),
    ("core.keys.positions_mm", _one_of([[8, 0]], [[0, 9], [0, -9]], [[11.5, 11.5]]), _ROUND),
    ("magnets.height_mm", _one_of(0.8, 1.5, 2.0, 3.0), KINDS),
    ("magnets.diameter_mm", _one_of(3.0, 4.0, 5.0, 8.0), KINDS),
    ("magnets.part", _one_of(*MAGNET_PARTS), KINDS),
    ("magnets.depth_mm", _from(1.6, 5.5), KINDS),
    ("magnets.depth_below_core_face_mm", _from(0.2, 2.0), KINDS),
    ("sensors.depth_below_core_face_mm", _plus(-1.2, 0.9), KINDS),
    ("sensors.package_mm", _edges((3, 3, 0.8), (9, 8, 2)), KINDS),
    ("sensors.chip_mm", _edges((1.5, 1.5, 0.6), (4, 4, 1.6)), KINDS),
    ("sensors.chip", _one_of("outward", "inward"), KINDS),
    ("sensors.part", _one_of("TMAG5273A2", "TMAG5273A1"), KINDS),
    ("body.sensed_faces", _some_faces, ("box", "cylinder", *_BORED)),
    ("body.open_faces", _one_of([], [1], [4], [3, 6], [1, 2], [2, 3, 6], [1, 6]), ("box",)),
    ("body.open_faces", _one_of([], [1], [1, 6]), ("cylinder",)),
    ("body.open_faces", _one_of([]), _BORED),
    ("body.bore_mm", _times(0.4, 1.9), _BORED),
    ("body.inside", _one_of("core", "silicone", "air"), ("dome",)),
    ("arrangement", _one_of("sensors-in-shell"), ("box",)),
    ("mould.style", _one_of("split", "one-piece"), KINDS),
    ("mould.wall_mm", _times(0.6, 3.5), KINDS),
    ("mould.parting_azimuth_deg", _from(-180.0, 180.0), KINDS),
    ("mould.pour_mm", _from(2.5, 12.0), KINDS),
    ("printer.name", _one_of("fdm-0.25", "resin", "sls"), KINDS),
    ("printer.wall_mm", _from(0.4, 1.6), KINDS),
    ("printer.hole_mm", _from(0.5, 2.0), KINDS),
    ("printer.clearance_mm", _from(0.05, 0.4), KINDS),
    ("silicone.name", _one_of("Ecoflex 00-30", "Dragon Skin 10", "Dragon Skin 30"), KINDS),
    ("silicone.thinnest_wall_mm", _from(0.5, 2.0), KINDS),
    ("contact_grid.pitch_mm", _from(1.5, 5.0), KINDS),
    ("indenter.radius_mm", _from(2.0, 9.0), KINDS),
)
"""A key, its new value, and the kinds of body of which users change it."""


def _of_key(where: str, value: Value) -> Edit:
    def edit(rng: np.random.Generator, tables: dict[str, Any]) -> None:
        put(tables, where, value(rng, value_of(tables, where)))
        if where in ("magnets.height_mm", "magnets.diameter_mm"):
            tables["magnets"].pop("part", None)
        if where in ("magnets.part", "magnets.kind"):
            for name in ("shape", "diameter_mm", "height_mm", "inner_diameter_mm", "size_mm"):
                tables["magnets"].pop(name, None)
            tables["magnets"].pop({"magnets.part": "kind", "magnets.kind": "part"}[where], None)
            for name in ("grade", "remanence_t"):
                tables["magnets"].pop(name, None)

    return edit


def _lists(tables: dict[str, Any], name: str) -> list[np.ndarray]:
    """Places of a table's parts: one list, or one for each face."""
    places = value_of(tables, f"{name}.positions_mm")
    if np.ndim(places[0]) == 2:
        return [np.array(one, float) for one in places]
    return [np.array(places, float)]


def _put_places(tables: dict[str, Any], name: str, lists: list[np.ndarray]) -> None:
    """In the place of what stood, with what else is given of as many parts."""
    table = tables.setdefault(name, {})
    table.pop("positions_fraction", None)
    if len(lists[0]) != len(_lists(tables, name)[0] if table.get("positions_mm") else ()):
        for key in ("tilt_deg", "north", "rotations_deg", "count_per_face"):
            table.pop(key, None)
        if isinstance(table.get("depth_mm"), list):
            table.pop("depth_mm")
    rounded = [one.round(2).tolist() for one in lists]
    table["positions_mm"] = rounded if len(rounded) > 1 else rounded[0]


def _magnets_moved(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    reach = rng.uniform(0.5, 4.0)
    moved = [one + rng.normal(0, reach, one.shape) for one in _lists(tables, "magnets")]
    _put_places(tables, "magnets", moved)


def _magnets_spread(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    wider = rng.uniform(0.6, 2.2)
    _put_places(tables, "magnets", [wider * one for one in _lists(tables, "magnets")])


def _fewer_magnets(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    lists = _lists(tables, "magnets")
    kept = int(rng.integers(1, len(lists[0]) + 1))
    _put_places(tables, "magnets", [one[:kept] for one in lists])


def _magnet_lattice(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    """Up to four by three, alike on all faces."""
    columns, rows = rng.integers(1, 5), rng.integers(1, 4)
    pitch = rng.uniform(5.5, 14.0, 2)
    x, y = np.meshgrid(np.arange(columns) - (columns - 1) / 2, np.arange(rows) - (rows - 1) / 2)
    _put_places(tables, "magnets", [np.column_stack([x.ravel(), y.ravel()]) * pitch])


def _magnets_in_fractions(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    count = int(rng.integers(1, 6))
    _put_places(tables, "magnets", [np.zeros((count, 2))])
    del tables["magnets"]["positions_mm"]
    tables["magnets"]["positions_fraction"] = rng.uniform(-0.75, 0.75, (count, 2)).round(2).tolist()


def _magnets_each(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    """A depth, a tilt and a pole of each."""
    if "positions_fraction" in tables.get("magnets", {}):
        return
    count, table = len(_lists(tables, "magnets")[0]), tables.setdefault("magnets", {})
    which = int(rng.integers(1, 8))
    if which & 1:
        table["depth_mm"] = rng.uniform(1.6, 5.0, count).round(2).tolist()
    if which & 2:
        table["tilt_deg"] = rng.uniform(-20, 20, (count, 2)).round(1).tolist()
    if which & 4:
        table["north"] = [("inward", "outward")[k] for k in rng.integers(0, 2, count)]


def _other_magnets(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    """Blocks or rings."""
    table = tables.setdefault("magnets", {})
    for name in ("part", "grade", "inner_diameter_mm"):
        table.pop(name, None)
    if rng.random() < 0.5:
        table |= {"shape": "block", "size_mm": rng.uniform(2.5, 8.0, 2).round(1).tolist()}
    else:
        outer = round(float(rng.uniform(4.0, 8.0)), 1)
        table |= {"shape": "ring", "diameter_mm": outer, "inner_diameter_mm": round(outer / 3, 2)}


def _sensor_ring(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    table = tables.setdefault("sensors", {})
    for name in ("positions_mm", "rotations_deg"):
        table.pop(name, None)
    table["count_per_face"] = int(rng.integers(1, 7))
    table["radius_mm"] = round(value_of(tables, "sensors.radius_mm") * rng.uniform(0.8, 1.6), 2)
    table["first_azimuth_deg"] = rng.uniform(0, 360, int(rng.choice([1, 5]))).round(1).tolist()


def _sensors_placed(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    """On two or three spots about the middle."""
    count, turn = int(rng.integers(1, 4)), rng.uniform(0, 2 * np.pi)
    angles = turn + 2 * np.pi * np.arange(count) / count + rng.normal(0, 0.2, count)
    radius = value_of(tables, "sensors.radius_mm") * rng.uniform(0.9, 1.3, count)
    places = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    table = tables.setdefault("sensors", {})
    for name in ("count_per_face", "rotations_deg"):
        table.pop(name, None)
    table["positions_mm"] = places.round(2).tolist()


def _sensors_moved(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    if value_of(tables, "sensors.positions_mm") is None:
        return _sensors_placed(rng, tables)
    moved = [one + rng.normal(0, 0.8, one.shape) for one in _lists(tables, "sensors")]
    _put_places(tables, "sensors", moved)


def _slits(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    width, depth = rng.uniform([0.6, 1.0], [2.5, 7.0]).round(2).tolist()
    put(tables, "shell.slits", {"width_mm": width, "depth_mm": depth})


def _keys(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    count, reach = int(rng.integers(1, 4)), rng.uniform(4, 16)
    width, length, height = rng.uniform(1.0, 6.0, 3).round(1).tolist()
    places = rng.uniform(-reach, reach, (count, 2)).round(1).tolist()
    table = {"positions_mm": places, "size_mm": [width, length, height]}
    put(tables, "core.keys", table)


def _deep_channels(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    put(tables, "core.wire_channel_mm", rng.uniform([0.8, 0.4], [4.0, 3.0]).round(2).tolist())


def _wider_boards(rng: np.random.Generator, tables: dict[str, Any]) -> None:
    """Boards with recesses to match, as of another breakout board."""
    across, along = rng.uniform(4.0, 10.0, 2).round(1).tolist()
    put(tables, "sensors.package_mm", [across, along, 1.6])
    put(tables, "core.recess_width_mm", round(across + 0.4, 2))
    middle = value_of(tables, "sensors.radius_mm")
    put(tables, "core.recess_inner_radius_mm", round(max(0.3, middle - along / 2 - 0.3), 2))
    put(tables, "core.recess_outer_radius_mm", round(middle + along / 2 + 0.3, 2))


_JOINT: tuple[tuple[Edit, tuple[str, ...]], ...] = (
    (_magnets_moved, KINDS),
    (_magnets_spread, KINDS),
    (_fewer_magnets, KINDS),
    (_magnet_lattice, KINDS),
    (_magnets_in_fractions, KINDS),
    (_magnets_each, ("box", "pad")),
    (_magnets_each, _CURVED),
    (_other_magnets, KINDS),
    (_sensor_ring, KINDS),
    (_sensors_placed, KINDS),
    (_sensors_moved, KINDS),
    (_slits, ("box", "cylinder")),
    (_keys, _ROUND),
    (_deep_channels, KINDS),
    (_wider_boards, KINDS),
)
EDITS: tuple[tuple[Edit, tuple[str, ...]], ...] = (
    *((_of_key(where, value), kinds) for where, value, kinds in KEYS),
    *_JOINT,
)
"""All that users change, and of which kinds."""
