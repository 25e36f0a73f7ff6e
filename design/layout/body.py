"""The body that a specification describes, its sensed faces and the core's.

Object frame: origin at the middle of the body's box, face 1 outward = +z, 2 = −y, 3 = +x, 4 = +y,
5 = −x, 6 = −z, on curved bodies the patches about those directions.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from design.body.imported import file_digest
from design.body.kinds.registry import KINDS
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.body.kinds.base import BodyKind
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec


@cached_geometry
def body_of(spec: ObjectSpec) -> BodyKind:
    """The body with the measures of the specification: ask it, not `spec.body.kind`."""
    body = spec.body
    return KINDS[body.kind](
        size_mm=body.size_mm,
        thickness_mm=spec.shell.thickness_mm,
        envelope_mm=spec.mesh.envelope_mm / 2,
        opened=body.opened,
        bore_mm=body.bore_mm,
        inside=body.inside,
        file=body.file,
        scale=body.scale,
        digest=file_digest(body.file),
    )


@cached_geometry
def face_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces of the body, in the order of their numbers."""
    body = body_of(spec)
    hole = body.bore_mm / 2 if body.opening == "bore" else 0.0
    return tuple(replace(body.frame(number), hole_mm=hole) for number in spec.body.sensed)


def face_frame(spec: ObjectSpec, number: int) -> FaceFrame:
    """The sensed face of that number; KeyError where there is none."""
    return {frame.number: frame for frame in face_frames(spec)}[number]


@cached_geometry
def core_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces' frames moved inwards onto the core's faces."""
    body = body_of(spec)
    return tuple(body.core_frame(number) for number in spec.body.sensed)
