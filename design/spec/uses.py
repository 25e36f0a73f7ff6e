"""Keys that only some kinds use: a key that was written for another kind is refused, not left unread."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from design.errors import SpecError
from design.spec.object import ObjectSpec

_NETWORKS = ("compact", "whole-object")
_ROUND_TIPS, _SPLIT = ("hemisphere", "flat", "cylinder", "ellipsoid"), (None, "split")
USES: dict[str, tuple[str, tuple[Any, ...]]] = {
    "indenter.radius_mm": ("indenter.kind", _ROUND_TIPS),
    "indenter.size_mm": ("indenter.kind", ("cuboid", "cylinder", "ellipsoid")),
    "indenter.fillet_mm": ("indenter.kind", ("flat", "cuboid")),
    "indenter.vertices_mm": ("indenter.kind", ("stl",)),
    "magnets.depth_below_core_face_mm": ("arrangement", ("sensors-in-shell",)),
    "mould.parting_azimuth_deg": ("mould.style", _SPLIT),
    "collection.frames_per_case": ("collection.kind", ("paper", "grasp", "handling")),
    "collection.non_contact_cases": ("collection.kind", ("paper",)),
    "collection.poses": ("collection.kind", ("paper", "handling")),
    "collection.grasp_faces": ("collection.kind", ("grasp", "handling")),
    "collection.grasp_force_n": ("collection.kind", ("grasp", "handling")),
    "collection.random_grasps": ("collection.kind", ("grasp", "handling")),
    "collection.presses": ("collection.kind", ("continuous",)),
    "collection.contacts": ("collection.kind", ("continuous",)),
    "training.hidden_units": ("training.model", _NETWORKS),
    "training.epochs": ("training.model", _NETWORKS),
}
"""Key → key that decides, and its values with which the first is used."""


def require_used(content: dict[str, Any], keys: Iterable[str] = tuple(USES)) -> None:
    """Refuse those keys of a parsed specification that its kinds do not use.

    A key that repeats its default says nothing wrong, and passes.

    Raises
    ------
    SpecError
        Which keys, and the values of another key with which they would be used.
    """
    unused = []
    for key in keys:
        deciding, values = USES.get(key, ("", ()))
        if not deciding or _value(content, key) == _value({}, key):
            continue
        value = _value(content, deciding)
        if value not in values:
            wanted = " or ".join(repr(allowed) for allowed in values if allowed is not None)
            unused.append(
                f"{key} = {_value(content, key)!r} has no effect with {deciding} = {value!r}. Leave it out, "
                f"or give {deciding} = {wanted}"
            )
    if unused:
        raise SpecError("\n".join(unused))


def _value(content: dict[str, Any], key: str) -> Any:
    """Return what is written, or the default."""
    table, _, name = key.partition(".")
    default = ObjectSpec.model_fields[table].default
    given = content.get(table, default)
    if not name:
        return given
    written = isinstance(given, dict) and name in given
    return _convert_to_lists(given[name] if written else getattr(default, name))


def _convert_to_lists(value: Any) -> Any:
    """Return tuples as the lists that TOML gives."""
    return (
        [_convert_to_lists(entry) for entry in value] if isinstance(value, list | tuple) else value
    )
