"""Pieces of the mould for the page, and how each leaves when it opens."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.layout.mould.frame import mould_frame, parting
from design.spec.object import ObjectSpec
from instobj.render.pieces import load_stl

if TYPE_CHECKING:
    import trimesh

_HALVES_OUT, _PINS_OUT = 0.9, 0.5


@dataclass(frozen=True)
class MouldPiece:
    """A piece in its closed place; it moves by `pull_mm` from `begins` to `ends` of the opening."""

    name: str
    mesh: trimesh.Trimesh
    pull_mm: Float[np.ndarray, "3"]
    begins: float = 0.0
    ends: float = 1.0

    @property
    def content(self) -> dict[str, Any]:
        """Everything but the triangles."""
        pull = np.round(self.pull_mm, 3).tolist()
        return {"name": self.name, "pull_mm": pull, "begins": self.begins, "ends": self.ends}


def mould_pieces(spec: ObjectSpec, build: Path) -> list[MouldPiece]:
    """Pins first, then halves or box, then plug or rod, the cast shell where it is among them.

    Empty where the body has no mould.
    """
    built = {path.stem for path in build.glob("mould_*.stl")}
    if not built:
        return []
    frame, size = mould_frame(spec), float(max(spec.body.size_mm))
    shell = load_stl(build / "shell.stl")
    if "mould_box" in built:
        height = float(np.ptp(shell.bounds, axis=0) @ abs(frame.out))
        pieces = [
            MouldPiece("mould box", load_stl(build / "mould_box.stl"), 0 * frame.out),
            MouldPiece("cast shell", shell, 1.2 * height * frame.out, 0.0, 0.7),
        ]
        plug_mm = 2.4 * height
    else:
        pieces = [MouldPiece("cast shell", shell, 0 * frame.out), *_pins(spec, build)]
        pull = _HALVES_OUT * size * parting(spec).normal
        for name, sign in (("mould_half_a", 1), ("mould_half_b", -1)):
            part = load_stl(build / f"{name}.stl")
            pieces.append(MouldPiece(name.replace("_", " "), part, sign * pull, 0.35, 0.75))
        if frame.opening != "open":
            pieces.append(MouldPiece("core, cast in", load_stl(build / "core.stl"), 0 * frame.out))
        plug_mm = size
    for name in ("mould_plug", "mould_holder"):
        if name in built:
            part = load_stl(build / f"{name}.stl")
            pieces.append(MouldPiece(name.replace("_", " "), part, plug_mm * frame.out, 0.0, 1.0))
    return pieces


def _pins(spec: ObjectSpec, build: Path) -> list[MouldPiece]:
    """Every loose pin in its place: pins of a kind are alike in the frames of their pockets."""
    from design.layout.mould.pins import Pin, loose_pins, pins_of_kinds

    pins, pieces = loose_pins(spec), []
    length = _PINS_OUT * float(max(spec.body.size_mm))

    def own_frame(pin: Pin) -> tuple[np.ndarray, np.ndarray]:
        return pin.frame.to_object(np.append(pin.pocket.body.centre_mm[:2], 0.0)), pin.frame.axes

    for name, members in pins_of_kinds(pins):
        mesh = load_stl(build / f"{name}.stl")
        origin, axes = own_frame(pins[members[0]])
        local = (np.asarray(mesh.vertices) - origin) @ axes
        for index in members:
            place, turned = own_frame(pins[index])
            moved = mesh.copy()
            moved.vertices = place + local @ turned.T
            pull = length * pins[index].way
            pieces.append(MouldPiece(name.replace("_", " "), moved, pull, 0.0, 0.35))
    return pieces
