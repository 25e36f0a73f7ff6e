"""Faces that share a layout in a search."""

from __future__ import annotations

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

_ALIKE = 0.1
"""Share by which half extents of faces of one size may differ, of the larger."""


@cached_geometry
def layout_groups(spec: ObjectSpec) -> tuple[tuple[int, ...], ...]:
    """Sensed faces that share a layout, by `search.vary.layouts`: all, those of one size, or none."""
    way, frames = spec.search.vary.layouts, face_frames(spec)
    if way == "one":
        return (spec.body.sensed,)
    groups: list[list[FaceFrame]] = []
    for frame in frames:
        alike_groups = [group for group in groups if way == "per size" and _alike(frame, group[0])]
        if alike_groups:
            alike_groups[0].append(frame)
        else:
            groups.append([frame])
    return tuple(tuple(frame.number for frame in group) for group in groups)


def group_labels(spec: ObjectSpec) -> tuple[str, ...]:
    """Return what names of variables begin with, group by group; nothing where there is one."""
    groups = layout_groups(spec)
    return ("",) if len(groups) == 1 else tuple(f"face{group[0]}_" for group in groups)


def _alike(a: FaceFrame, b: FaceFrame) -> bool:
    pairs = zip(a.half_extents_mm, b.half_extents_mm, strict=True)
    near = all(abs(half_a - half_b) <= _ALIKE * max(half_a, half_b) for half_a, half_b in pairs)
    return near and a.round == b.round and a.flat == b.flat
