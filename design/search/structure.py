"""Structures of a search: specifications with other parts, counts and sizes at the old places."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from design.catalogue.magnets import MAGNET_PARTS
from design.search.places import choices_of_magnets
from design.spec.assembly import AsBuiltSpec
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from design.spec.sensors import SensorSpec

STRUCTURE = (
    "magnet_count",
    "sensor_count",
    "sensor_chip",
)
"""Choices between which places are not comparable; a batch is scored structure by structure."""
SIZE = "_size"
"""Ends the names of choices of single magnets' sizes, which are of the structure too."""


def with_structure(spec: ObjectSpec, params: Mapping[str, Any]) -> ObjectSpec:
    """The specification with the layout's choices but the old places: not validated as a whole.

    What was measured on the built object goes, as another object is meant.
    """
    chosen = {name: params[name] for name in STRUCTURE if name in params}
    update: dict[str, Any] = {"as_built": AsBuiltSpec()}
    magnets = spec.magnets
    if "magnet_count" in chosen:
        magnets = magnets.changed(**_unplaced(spec, chosen["magnet_count"]))
        update["magnets"] = magnets
    if spec.search.vary.magnet_sizes is not None:
        counted = _constructed(spec, {"magnets": magnets})
        parts = tuple(choices_of_magnets(counted, params, "size"))
        update |= _with_magnets(spec, _with_parts(magnets, parts))
    update["sensors"] = _with_sensors(spec, chosen)
    return _constructed(spec, update)


def _unplaced(spec: ObjectSpec, count: int) -> dict[str, Any]:
    """Magnets of which all that the search varies is still to be given."""
    vary = spec.search.vary
    varied = {
        "depth_mm": (vary.magnet_depth_mm, None),
        "tilt_deg": (vary.magnet_tilt_deg, ()),
        "north": (vary.magnet_north or None, ()),
    }
    reset = {name: empty for name, (range_, empty) in varied.items() if range_ is not None}
    return reset | {"positions_mm": ((0.0, 0.0),) * count}


def _with_parts(magnets: MagnetSpec, part: str | tuple[str, ...]) -> MagnetSpec:
    """Magnets of another size, or of a size each."""
    kept = magnets.model_dump(
        exclude={"shape", "diameter_mm", "inner_diameter_mm", "size_mm", "height_mm"}
    )
    return MagnetSpec.model_validate({**kept, "part": part})


def _with_magnets(spec: ObjectSpec, new: MagnetSpec) -> dict[str, Any]:
    """Other magnets, with their pockets' clearance and the silicone above the tallest unchanged; in the core
    they fill their pockets."""
    if spec.arrangement == "sensors-in-shell":
        return {"magnets": new}
    old, shell = spec.magnets, spec.shell
    wider, taller = (
        max(getattr(size, name) for size in new.sizes)
        - max(getattr(size, name) for size in old.sizes)
        for name in ("diameter_mm", "height_mm")
    )
    pocket = {
        "pocket_diameter_mm": round(shell.pocket_diameter_mm + wider, 9),
        "pocket_depth_mm": round(shell.pocket_depth_mm + taller, 9),
    }
    return {"magnets": new, "shell": shell.changed(**pocket)}


def _with_sensors(spec: ObjectSpec, chosen: dict[str, Any]) -> SensorSpec:
    """A board turned over lies on its recess's floor where it was flush with the core, and back."""
    sensors = spec.sensors
    content = sensors.model_dump(exclude_none=True)
    if "sensor_count" in chosen:
        content.pop("positions_mm", None)
        content["count_per_face"] = chosen["sensor_count"]
    if "sensor_chip" in chosen:
        content["chip"] = chosen["sensor_chip"]
        if chosen["sensor_chip"] != sensors.chip:
            depth = spec.core.recess_depth_mm - sensors.depth_below_core_face_mm
            content["depth_below_core_face_mm"] = depth
    return SensorSpec.model_validate(content)


def size_variants(spec: ObjectSpec) -> list[ObjectSpec]:
    """The specification with all magnets of one of its sizes, size by size, pockets as they are for it: not
    validated as a whole. Itself where there is one size, or sensors move and magnets do not."""
    magnets = spec.magnets
    if len(magnets.distinct_sizes) == 1 or spec.arrangement == "sensors-in-shell":
        return [spec]
    return [
        _constructed(
            spec,
            _with_magnets(
                spec,
                magnets.changed(
                    part=None,
                    diameter_mm=size.diameter_mm,
                    inner_diameter_mm=size.inner_diameter_mm,
                    height_mm=size.height_mm,
                ),
            ),
        )
        for size in magnets.distinct_sizes
    ]


def searched_size_variants(spec: ObjectSpec) -> list[ObjectSpec]:
    """The same for the specification's own sizes and all that `search.vary.magnet_sizes` names."""
    by_size = {of_size.magnets.sizes[0]: of_size for of_size in size_variants(spec)}
    if spec.arrangement == "sensors-in-core":
        for name in spec.search.vary.magnet_sizes or ():
            of_size = _constructed(spec, _with_magnets(spec, _with_parts(spec.magnets, name)))
            by_size.setdefault(of_size.magnets.sizes[0], of_size)
    return list(by_size.values())


def _constructed(spec: ObjectSpec, update: dict[str, Any]) -> ObjectSpec:
    """Not validated as a whole."""
    fields = spec.model_fields_set | update.keys()
    return ObjectSpec.model_construct(fields, **(dict(spec) | update))


def part_names(magnets: MagnetSpec) -> list[str | None]:
    """Catalogued part of every magnet; None of a size that is none."""
    return [_part_name(magnets, index) for index in range(magnets.count)]


def _part_name(magnets: MagnetSpec, index: int) -> str | None:
    if magnets.parts:
        return magnets.parts[index]
    size = magnets.sizes[index]
    figures = {key: getattr(size, key) for key in ("shape", "height_mm", "diameter_mm")}
    figures["inner_diameter_mm"] = size.inner_diameter_mm
    return next((name for name, part in MAGNET_PARTS.items() if part.figures() == figures), None)
