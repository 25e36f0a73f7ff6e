"""Places given as fractions of the half extents of the faces that parts lie under, in mm."""

from __future__ import annotations

from typing import Any

import numpy as np
from pydantic import ValidationError

from design.errors import SpecError
from design.layout.body import core_frames, face_frames
from design.spec.object import ObjectSpec

KEY = "positions_fraction"
_OF_THE_BODY = ("name", "body", "shell", "arrangement", "mesh")


def with_places_in_mm(content: dict[str, Any]) -> dict[str, Any]:
    """A specification's tables with `positions_mm`, one list per face, where fractions were given.

    (1, 1) is a face's corner of largest x and y, (0, 0) its middle; one list holds for all faces.
    Magnets in the shell are measured on the body's faces, sensors in the core on the core's.

    Raises
    ------
    SpecError
        Fractions next to places in mm, or no lists of pairs from −1 to 1.
    """
    given_tables = [
        name
        for name in ("magnets", "sensors")
        if isinstance(content.get(name), dict) and KEY in content[name]
    ]
    if not given_tables:
        return content
    try:
        body = {name: content[name] for name in _OF_THE_BODY if name in content}
        spec = ObjectSpec.model_validate(body)
    except ValidationError:  # told with all other problems of the specification
        return content | {name: _drop_fractions(content[name]) for name in given_tables}
    return content | {name: _convert_to_mm(spec, name, content[name]) for name in given_tables}


def _drop_fractions(table: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key != KEY}


def _convert_to_mm(spec: ObjectSpec, name: str, table: dict[str, Any]) -> dict[str, Any]:
    if "positions_mm" in table:
        raise SpecError(
            f"{name}.{KEY} and {name}.positions_mm say both where they are. Leave one of the two out"
        )
    in_shell = (name == "magnets") == (spec.arrangement == "sensors-in-core")
    frames = face_frames(spec) if in_shell else core_frames(spec)
    lists = lists_by_face(name, table[KEY], len(frames))
    places = [
        (np.array(fractions, float) * frame.half_extents_mm).round(4).tolist()
        for fractions, frame in zip(lists, frames, strict=True)
    ]
    return _drop_fractions(table) | {"positions_mm": places}


def lists_by_face(name: str, given: Any, faces: int) -> list[Any]:
    """One list of pairs for each face."""
    try:
        lists = given if isinstance(given[0][0], list | tuple) else [given] * faces
        pairs = [np.array(fractions, float) for fractions in lists]
        fits = all(p.ndim == 2 and p.shape[1] == 2 and abs(p).max() <= 1 for p in pairs)
    except (IndexError, KeyError, TypeError, ValueError):
        fits, lists = False, []
    if not fits or len(lists) != faces:
        raise SpecError(
            f"{name}.{KEY} takes pairs from -1 to 1 (0 is a face's middle, 1 its border), one list for all "
            f"faces or one for each of the {faces} sensed ones; got {given!r}"
        )
    return list(lists)
