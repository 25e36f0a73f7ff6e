"""An object's parts as numbers: closed single solids, volumes by hand, what the mould misses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import trimesh
from pydantic import ValidationError

from design.build.parts import Part, parts_of
from design.errors import InputError
from design.fabrication.check import mesh_of
from design.layout.body import body_of
from design.layout.core_hold import has_mould
from design.layout.pockets import shell_pockets
from design.mould.room import cast_room
from design.solids.booleans import Shape, convert_to_triangles, cut, volume_mm3
from design.spec.object import ObjectSpec
from design.spec_io import check
from tests.support.objects.random_objects import with_file
from tests.support.objects.shell_volume import shell_volume_mm3
from tests.support.objects.whole_mould import inside_of_mould, mould_around

FITTED = ("core", "shell")
"""Parts that differ with the body in every dimension; their triangles are looked at too."""

FLAT = ("box", "pad")
_TRIANGLES_MM = 0.005


def measuring(folder: Path) -> Callable[[tuple[dict[str, Any], bool]], dict[str, Any]]:
    """Return the function that gives numbers of an object, or why its specification is refused.

    `folder` takes files; with `everything` more than core, shell and moulds of flat faces is built.
    """

    def measure(question: tuple[dict[str, Any], bool]) -> dict[str, Any]:
        content, everything = question
        try:
            spec = check(ObjectSpec.model_validate(with_file(content, folder)))
        except (ValidationError, InputError) as error:
            return {"refused": str(error)}
        return _numbers(spec, everything)

    return measure


def _numbers(spec: ObjectSpec, everything: bool) -> dict[str, Any]:
    solids = {part.name: part.make() for part in parts_of(spec) if _looked_at(part, everything)}
    missed = None
    if has_mould(spec) and (everything or spec.body.kind in FLAT):
        tools = [*mould_around(spec), *inside_of_mould(spec)]
        solids |= {f"mould {number}": tool for number, tool in enumerate(tools)}
        missed = _missed_mm3(spec, solids["shell"], tools)
    return {
        "parts": {name: _measured(name, shape, spec) for name, shape in solids.items()},
        "shell_mm3": shell_volume_mm3(spec),
        "pockets_mm3": body_of(spec).volume_mm3() - shell_volume_mm3(spec),
        "mould_misses_mm3": missed,
        "pocket_mm3": shell_pockets(spec)[0][0].volume_mm3,
    }


def _looked_at(part: Part, everything: bool) -> bool:
    """Moulds are built once, for what they cast."""
    return part.name in FITTED or (everything and not part.name.startswith("mould"))


def _measured(name: str, shape: Shape, spec: ObjectSpec) -> dict[str, Any]:
    if isinstance(shape, trimesh.Trimesh):
        outsides = sum(bool(p.volume > 0) for p in shape.split(only_watertight=False))
        sound = bool(shape.is_watertight and shape.is_winding_consistent)
        return {"solids": outsides, "closed": sound, "volume_mm3": float(shape.volume)}
    sound = shape.isValid() and (name not in FITTED or mesh_of(shape, spec).is_watertight)
    return {"solids": len(shape.Solids()), "closed": bool(sound), "volume_mm3": shape.Volume()}


def _missed_mm3(spec: ObjectSpec, shell: Shape, tools: list[Shape]) -> float:
    """Volume in which what the mould's parts leave of the envelope differs from the shell.

    Solids of flat faces are compared exactly. The kernel cannot subtract many that share a curved
    face (it drops pins): of those it is what triangles within 5 µm of both differ by beyond that.
    """
    room, slack = cast_room(spec), 0.0
    if spec.body.kind not in FLAT:
        room, shell, *tools = (convert_to_triangles(shape) for shape in (room, shell, *tools))
        slack = _TRIANGLES_MM * float(2 * shell.area)
    cast = cut(room, *tools)
    apart = volume_mm3(cut(cast, shell)) + volume_mm3(cut(shell, cast))
    return max(0.0, apart - slack)
