"""The body in a specification: outer shape, open faces, silicone shell and core.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from design.body.foreign import STEP
from design.body.kinds.base import BodyKind
from design.body.kinds.registry import KINDS
from design.spec.base import Coordinate, Distinct, Length, Offset, SpecPart, Wall

if TYPE_CHECKING:
    KindName = str
else:
    KindName = Literal[tuple(KINDS)]
FaceNumber = Annotated[int, Field(ge=1, le=6)]
"""1 = +z, 2 = −y, 3 = +x, 4 = +y, 5 = −x, 6 = −z."""


MM = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
"""Lengths of the units that files are drawn in."""
Edge = Annotated[float, Field(gt=0, le=1e8)]
"""Edge of a body, mm; the error for one too long names the unit that its file may be drawn in."""
LONGEST_EDGE_MM = (5.0, 1000.0)
"""Longest edge of a body: from a fingertip to a person's arms."""


class BodySpec(SpecPart):
    """Outer shape of the object, silicone and what is inside it, in a box of `size_mm` (x, y, z).

    `kind` is one of `design.body.kinds.registry` (docs/bodies.md); what holds the silicone from
    `inside` is a rigid core unless the kind allows others. `open_faces` have no silicone: there the
    core's cavity runs out, where no whole side opens through a bore of `bore_mm`. The surface of an
    imported body is in `file` (STL, STEP and others), moved so that its box is centred; `scale` is the
    length of its unit in mm (STEP files know theirs), or makes it larger or smaller. `sensed_faces`, by
    default all that are closed, carry magnets and sensors and are pressed.
    """

    kind: KindName = "box"
    size_mm: tuple[Edge, Edge, Edge] = (42.0, 42.0, 42.0)
    open_faces: Annotated[tuple[FaceNumber, ...], Distinct] = (6,)
    sensed_faces: Annotated[tuple[FaceNumber, ...], Distinct] | None = None
    inside: Literal["core", "silicone", "air"] = "core"
    bore_mm: Length = 10.0
    file: str | None = None
    scale: Annotated[float, Field(ge=1e-4, le=1e6)] = 1.0

    def __hash__(self) -> int:
        return hash(self.model_dump_json())

    @property
    def opened(self) -> tuple[int, ...]:
        """`open_faces` where the body has faces that can be open, else none."""
        openable = KINDS[self.kind].openable
        return tuple(sorted(face for face in set(self.open_faces) if face in openable))

    @property
    def sensed(self) -> tuple[int, ...]:
        """Numbers of the sensed faces, in order."""
        closed = tuple(face for face in KINDS[self.kind].faces if face not in self.opened)
        return closed if self.sensed_faces is None else tuple(sorted(self.sensed_faces))

    @model_validator(mode="after")
    def _agrees(self) -> BodySpec:
        for check in (_check_unused, _check_size, _check_faces, _check_inside):
            check(self)
        return self


def _check_unused(body: BodySpec) -> None:
    """Refuse keys that are not of this kind, where they differ from what leaving them out gives."""
    kind = KINDS[body.kind]
    uses = {
        "bore_mm": bool(kind.openable) and not kind.opens_sides,
        "scale": kind.from_file,
        "open_faces": bool(kind.openable) or not body.open_faces,
    }
    for key, used in uses.items():
        value = getattr(body, key)
        if not used and value != BodySpec.model_fields[key].default:
            shown = list(value) if isinstance(value, tuple) else value
            raise ValueError(
                f"body.{key} = {shown!r} has no effect on body.kind = {body.kind!r}. Leave it out"
            )


def _check_size(body: BodySpec) -> None:
    kind = KINDS[body.kind]
    least, most = LONGEST_EDGE_MM
    if not least <= max(body.size_mm) <= most:
        fix = _question(body) if kind.from_file else "Fix body.size_mm, which is in mm"
        size = " × ".join(f"{edge:g}" for edge in body.size_mm)
        raise ValueError(
            f"the longest edge of a body must measure {least:g} to {most:g} mm; got {size} mm. {fix}"
        )
    if not kind.takes_size(body.size_mm):
        raise ValueError(
            f"body.size_mm of a {body.kind} must be {kind.size_rule}; got {list(body.size_mm)}. Fix "
            "the size, or choose another body.kind"
        )


def _question(body: BodySpec) -> str:
    """In which unit a file may be drawn whose surface is too small or too large for a body."""
    least, most = LONGEST_EDGE_MM
    longest = max(body.size_mm)
    step = Path(body.file or "").suffix.lower() in STEP  # in mm already
    units = {} if step else {unit: mm for unit, mm in MM.items() if least <= longest * mm <= most}
    # the power of ten that brings the body nearest to a fist
    factors = units or {"": 10.0 ** -round(float(np.log10(longest / 50)))}
    answers = [
        f"{f'{unit}: ' if unit else ''}body.scale = {body.scale * factor:g} (instobj new: --scale) makes "
        f"it {longest * factor:.4g} mm"
        for unit, factor in factors.items()
    ]
    return f"In which unit is its file drawn? {', '.join(answers)}"


def _check_faces(body: BodySpec) -> None:
    kind = KINDS[body.kind]
    unknown = [face for face in body.open_faces if face not in kind.openable]
    if kind.openable and unknown:
        raise ValueError(
            f"body.open_faces of a {body.kind} may name {list(kind.openable)}; got {unknown}. Leave "
            "those out"
        )
    closed = [face for face in kind.faces if face not in body.opened]
    if not closed:
        raise ValueError("body.open_faces leaves no face of silicone. Close one of them")
    if kind.falls_apart(closed):
        raise ValueError(
            f"body.open_faces leaves two faces {closed} that do not meet: the shell would be in two "
            "pieces. Close another face, or open one of the two"
        )
    wrong = [face for face in body.sensed_faces or () if face not in closed]
    if wrong or body.sensed_faces == ():
        raise ValueError(
            f"body.sensed_faces must name some of the closed faces {closed}; got "
            f"{list(body.sensed_faces or ())}. Fix it, or leave it out to take them all"
        )


def _check_inside(body: BodySpec) -> None:
    kind = KINDS[body.kind]
    if body.inside not in kind.insides:
        raise ValueError(
            f"body.inside = {body.inside!r} is for "
            f"{_kinds(lambda body_kind: body.inside in body_kind.insides)}; got body.kind = "
            f"{body.kind!r}. Leave it out"
        )
    if kind.from_file != (body.file is not None):
        raise ValueError(
            f"body.file goes with body.kind = {_kinds(lambda body_kind: body_kind.from_file)}; got "
            f"{body.kind!r} and file = {body.file!r}. Give both or neither"
        )


def _kinds(which: Callable[[type[BodyKind]], bool]) -> str:
    return " or ".join(repr(name) for name, kind in KINDS.items() if which(kind))


class SlitsSpec(SpecPart):
    """Relief slits along the edges between sensed faces, against pressure on the neighbours.

    Each runs from the edge `depth_mm` inwards along the bisector of the two faces, `width_mm` wide,
    and ends a shell's thickness before the corners of the body; a depth of 0 leaves them out.
    """

    width_mm: Length = 1.0
    depth_mm: Offset = 0.0


class ShellSpec(SpecPart):
    """Silicone walls and the moulded pockets that take the magnets.

    Round bodies lie in pockets of `pocket_diameter_mm`; blocks and sensor boards in pockets of
    their own outline. With a `seal_layer_mm` the shell is cast thinner by that much on every sensed
    face and gets its size in a second pour, which covers the pockets with a layer in one piece.
    """

    thickness_mm: Wall = 8.0
    pocket_diameter_mm: Length = 6.0
    pocket_depth_mm: Length = 3.0
    seal_layer_mm: Offset = 0.0
    slits: SlitsSpec = SlitsSpec()


class KeysSpec(SpecPart):
    """Blocks on every sensed face of the core that lock the shell against slipping.

    Each stands at a place of `positions_mm` (x, y in the face's frame); `size_mm` are its edges along
    the face's x and y, and its height into the silicone. Without places there are none.
    """

    positions_mm: tuple[tuple[Coordinate, Coordinate], ...] = ()
    size_mm: tuple[Length, Length, Length] = (3.0, 3.0, 1.5)


HUB_DEPTH_MM = 0.5
"""Depth of the recess round the wire hole in the core's faces, as in the authors' core."""


class CoreSpec(SpecPart):
    """Rigid printed core that fills the shell's cavity down to the core's own height.

    A `wire_channel_mm` (width, depth) whose width is above 0 cuts channels from each sensor's recess to
    the wire hole. `bay_mm` widens or deepens the cavity by a box of that
    size (x, y, depth from the open face) for a board and a battery. In a body without an open face it is a
    room about the core's middle, and the core is printed in two parts. The wires only enter the checks.
    """

    wall_mm: Wall = 4.5
    recess_width_mm: Length = 7.0
    recess_inner_radius_mm: Length = 4.5
    recess_outer_radius_mm: Length = 11.0
    recess_depth_mm: Length = 3.0
    wire_hole_top_diameter_mm: Length = 2.0
    wire_hole_side_diameter_mm: Length = 4.0
    wire_channel_mm: tuple[Offset, Length] = (0.0, 1.0)
    wires_per_sensor: Annotated[int, Field(ge=1, le=20)] = 4
    bay_mm: tuple[Length, Length, Length] | None = None
    keys: KeysSpec = KeysSpec()
