"""A design as the page holds it, made a specification, checked, and saved as TOML."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from design.catalogue.hall_sensors import HALL_PARTS
from design.catalogue.magnets import GRADES
from design.errors import InputError, InstobjError
from design.files import atomic_path
from design.layout.pockets import magnet_bodies, sensor_places
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from design.tables import toml_value
from instobj.commands.run import check
from instobj.commands.specification_file import line_with_value
from instobj.search.outcome.write import write_specification

Design = Mapping[str, Mapping[str, Any]]
"""Keys of [magnets], [sensors], [shell], [silicone], [body] and [limits] that the page changes."""
_OF_EACH_MAGNET = (
    *("depth_mm", "tilt_deg", "north", "part", "remanence_t"),
    *("diameter_mm", "inner_diameter_mm", "height_mm", "size_mm"),
)
_KEYS = {
    "magnets": {"positions_mm", "grade", *_OF_EACH_MAGNET},
    "sensors": {"positions_mm", "depth_below_core_face_mm", "part", "range_mt", "chip"},
    "shell": {"thickness_mm"},
    "silicone": {"name"},
    "body": {"size_mm"},
    "limits": {"use"},
}
SHELL_TABLES = ("shell", "silicone", "body")
"""Tables that the mechanics of the shell depends on."""
_NAMED = re.compile(
    r"magnets\.\w+\[(?P<magnet>\d+)\]|magnet (?P<nth>\d+) of|sensors? (?P<sensor>\d+)(?: and (?P<other>\d+))?"
)


def design_of(spec: ObjectSpec) -> dict[str, dict[str, Any]]:
    """Return the design of a specification: what is given for each magnet as lists, the rest as it is;
    None of places and depths that follow from other keys."""
    magnets = spec.magnets
    one_each: dict[str, Any] = {
        key: _lists(value)
        for key in _OF_EACH_MAGNET
        if isinstance(value := getattr(magnets, key), tuple) and len(value) == magnets.count
    }
    one_each |= {
        "positions_mm": _lists(magnets.positions_mm),
        "grade": _lists(magnets.grade),
        "depth_mm": list(magnets.depths_mm) or None,
        "tilt_deg": _lists(magnets.tilt_deg or ((0.0, 0.0),) * magnets.count),
        "north": list(magnets.north or ("outward",) * magnets.count),
    }
    others = {
        table: {key: _lists(getattr(getattr(spec, table), key)) for key in keys}
        for table, keys in _KEYS.items()
        if table != "magnets"
    }
    return {"magnets": one_each, **others}


def with_design(spec: ObjectSpec, design: Design) -> ObjectSpec:
    """Return the specification with a design; what it repeats stays as it was written.

    Raises
    ------
    InputError
        Another key than `design_of` has, or values that break a rule of the specification.
    """
    usual = design_of(spec)
    changed: dict[str, dict[str, Any]] = {}
    for table, values in design.items():
        foreign = set(values) - _KEYS.get(table, set())
        if foreign or table not in _KEYS:
            raise InputError(f"a design has no {table}.{', '.join(foreign)}. Reload the page")
        changed[table] = {
            k: v for k, v in values.items() if v != usual[table].get(k) and not _default(spec, k, v)
        }
    of_sensors = changed.get("sensors", {})
    if places := of_sensors.get("positions_mm"):
        of_sensors["count_per_face"] = len(places[0])
    if {"part", "range_mt"} & of_sensors.keys():
        now = {"part": spec.sensors.part, "range_mt": spec.sensors.range_mt} | of_sensors
        of_sensors |= _rescaled(spec, now["part"], float(now["range_mt"]))
    of_magnets = changed.get("magnets", {})
    if grade := of_magnets.get("grade"):  # what it is made of decides how strong it is
        of_magnets["remanence_t"] = (
            GRADES.named(grade).remanence_t
            if isinstance(grade, str)
            else [GRADES.named(each).remanence_t for each in grade]
        )
    silicone = changed.pop("silicone", {})  # another one brings all its figures
    parts = {
        table: getattr(spec, table).changed(**values) for table, values in changed.items() if values
    } | ({"silicone": silicone} if silicone else {})
    return spec.changed(**parts)


def _default(spec: ObjectSpec, key: str, value: Any) -> bool:
    """Return whether a value of each magnet says what the left out key says already."""
    usual = {"north": "outward", "tilt_deg": [0.0, 0.0]}
    return key in usual and not getattr(spec.magnets, key) and all(v == usual[key] for v in value)


def _rescaled(spec: ObjectSpec, part: str, range_mt: float) -> dict[str, Any]:
    """Return gain and noise of a chip in a range: noise of the same part is the same in mT. Another part
    takes its narrowest range that holds this one.

    Raises
    ------
    InputError
        No such part or range, or a part whose noise the catalogue does not have.
    """
    sensors, listed = spec.sensors, HALL_PARTS.named(part)
    covering = listed.range_covering(range_mt)
    counts_per_mt = covering.counts_per_mt
    times = counts_per_mt / sensors.counts_per_mt
    if part == sensors.part:
        noise = tuple(times * counts for counts in sensors.noise_counts)
        return {"counts_per_mt": counts_per_mt, "noise_counts": noise}
    if listed.noise is None:
        raise InputError(
            f"the catalogue has no noise of {part}. Choose a chip that has, or give sensors.part with "
            "sensors.noise_counts in the specification"
        )
    noise = listed.noise.scaled(counts_per_mt, sensors.averaging)
    return {
        "range_mt": covering.range_mt,
        "counts_per_mt": counts_per_mt,
        "noise_counts": noise,
    }


def broken_limits(design: ObjectSpec) -> list[dict[str, Any]]:
    """Return the sentences of `instobj check`, each with the numbers of magnets and sensors of a face that
    it names, counted from 0, and the faces; none where it holds for all."""
    try:
        check(design)
    except InstobjError as error:
        return [_limit(line) for line in str(error).split("\n")]
    return []


def _limit(sentence: str) -> dict[str, Any]:
    magnets, sensors = set(), set()
    for name in _NAMED.finditer(sentence):
        if name["magnet"]:
            magnets.add(int(name["magnet"]))
        elif name["nth"]:
            magnets.add(int(name["nth"]) - 1)
        else:
            sensors |= {int(number) - 1 for number in (name["sensor"], name["other"]) if number}
    faces = re.findall(r"\d+", " ".join(re.findall(r"faces? ([\d, ]+)", sentence)))
    parts = {"magnets": sorted(magnets), "sensors": sorted(sensors)}
    return {"text": sentence, **parts, "faces": sorted(map(int, faces))}


def save_design(design: ObjectSpec, source: Path) -> tuple[Path, bool]:
    """Write a design next to its specification under a new name; return the file, and whether comments
    were kept.

    Raises
    ------
    InputError
        The design breaks a limit.
    StoreError
        The folder cannot be written.
    """
    if broken := broken_limits(design):
        sentences = "\n".join(limit["text"] for limit in broken)
        raise InputError(f"not saved, as limits are broken. Mend them first:\n{sentences}")
    path = _free_path(source)
    named = design.changed(name=path.stem)
    try:
        text = edited_text(
            source.read_text(encoding="utf-8-sig"), _changes(load_spec(source), named)
        )
        with atomic_path(path) as temporary:
            temporary.write_text(text, encoding="utf-8")
        if load_spec(path) == named:
            return path, True
    except InputError:
        pass  # a way of writing tables that lines do not follow: written whole instead
    write_specification(design, path.stem, path, source.parent)
    return path, False


def kept_file(design: ObjectSpec, source: Path) -> Path:
    """Return the file that holds a design: the specification, one that was saved of it, or a new one.

    Raises
    ------
    InputError, StoreError
        As `save_design`.
    """
    saved = sorted(source.parent.glob(f"{_stem(source)}_explored_*.toml"))
    for path in filter(Path.is_file, (source, *saved)):
        if load_spec(path).changed(name=design.name) == design:
            return path
    return save_design(design, source)[0]


def _changes(start: ObjectSpec, design: ObjectSpec) -> dict[str, Any]:
    """Return values that differ by their dotted keys, as TOML has them."""
    old, new = (spec.model_dump(mode="json", exclude={"as_built"}) for spec in (start, design))
    tables = [name for name, values in new.items() if isinstance(values, dict)]
    changed = {
        f"{table}.{key}": value
        for table in tables
        for key, value in new[table].items()
        if value != old[table].get(key)
    }
    plain = {key: new[key] for key in new if key not in tables and new[key] != old[key]}
    return plain | changed


def _free_path(source: Path) -> Path:
    numbers = range(1, 10_000)
    paths = (source.with_name(f"{_stem(source)}_explored_{number}.toml") for number in numbers)
    return next(path for path in paths if not path.exists())


def _stem(source: Path) -> str:
    return re.sub(r"_explored_\d+$", "", source.stem)


def edited_text(text: str, changes: Mapping[str, Any]) -> str:
    """Return TOML with other values of dotted keys; every comment and all else stay as they are.

    Knows values of one line under their table's heading: compare what else is read back.
    """
    # Pieces that begin with a heading; the first holds the keys above all tables.
    pieces = re.split(r"^(?=\[)", text, flags=re.M)
    for dotted, value in changes.items():
        table, _, key = dotted.rpartition(".")
        if table and not any(piece.startswith(f"[{table}]") for piece in pieces):
            pieces[-1] += "\n"
            pieces.append(f"[{table}]\n")
        number = next(
            k for k, piece in enumerate(pieces) if piece.startswith(f"[{table}]" * bool(table))
        )
        lines = pieces[number].splitlines(keepends=True)
        line = next((k for k, text in enumerate(lines) if re.match(rf"{key}\s*=", text)), None)
        if line is None:
            lines.insert(bool(table), f"{key} = {toml_value(value)}\n")
        else:
            lines[line] = line_with_value(lines[line].rstrip("\n"), key, value) + "\n"
        pieces[number] = "".join(lines)
    return "".join(pieces)


def shown_places(spec: ObjectSpec) -> dict[str, Any]:
    """Return depths of magnets, and places of sensors face by face, also where they follow from other keys
    (mm)."""
    depths = [round(-float(body.centre_mm[2]), 3) for body in magnet_bodies(spec)[0]]
    places = [np.round([place[:2] for place in face], 3).tolist() for face in sensor_places(spec)]
    return {"depth_mm": depths, "sensors_mm": places}


def _lists(value: Any) -> Any:
    """Return tuples as the lists of TOML and JSON."""
    return [_lists(entry) for entry in value] if isinstance(value, list | tuple) else value
