"""An object's parts as numbers: closed single solids, volumes by hand, what the mould misses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cadquery as cq
import trimesh
from pydantic import ValidationError
from random_objects import with_file

from design.body import SAMPLED
from design.body_volume import body_volume_mm3
from design.errors import InputError
from design.fabrication import mesh_of
from design.mould import cast_cavity, has_mould
from design.parts import Part, parts_of
from design.shell import make_shell
from design.spec import ObjectSpec
from design.volumes import shell_volume_mm3

FITTED = ("core", "shell")
"""Parts that differ with the body in every dimension; their triangles are looked at too."""


def measure_object(question: dict[str, Any]) -> dict[str, Any]:
    """Numbers of the object in `question`, or why its specification is refused.

    `folder` takes files, `every_part` says whether more than core and shell are built.
    """
    try:
        spec = ObjectSpec.model_validate(with_file(question["object"], Path(question["folder"])))
    except (ValidationError, InputError) as error:
        return {"refused": str(error)}
    wanted = [p for p in parts_of(spec) if question["every_part"] or p.name in FITTED]
    return {
        "parts": {part.name: _measured(part, spec) for part in wanted},
        "shell_mm3": shell_volume_mm3(spec),
        "pockets_mm3": body_volume_mm3(spec) - shell_volume_mm3(spec),
        "mould_misses_mm3": _mould_misses_mm3(spec),
    }


def _measured(part: Part, spec: ObjectSpec) -> dict[str, Any]:
    shape = part.make()
    if isinstance(shape, trimesh.Trimesh):
        outsides = sum(bool(p.volume > 0) for p in shape.split(only_watertight=False))
        sound = bool(shape.is_watertight and shape.is_winding_consistent)
        return {"solids": outsides, "closed": sound, "volume_mm3": float(shape.volume)}
    sound = shape.isValid() and (part.name not in FITTED or mesh_of(shape, spec).is_watertight)
    return {
        "solids": len(shape.Solids()),
        "closed": bool(sound),
        "volume_mm3": shape.Volume(),
    }


def _mould_misses_mm3(spec: ObjectSpec) -> float | None:
    """Volume in which what the mould casts differs from the shell; None where there is no mould."""
    if spec.body.kind in SAMPLED or not has_mould(spec):
        return None
    shell, cast = make_shell(spec), cast_cavity(spec)
    return _volume(cast.cut(shell)) + _volume(shell.cut(cast))


def _volume(shape: cq.Shape) -> float:
    return sum(solid.Volume() for solid in shape.Solids())
