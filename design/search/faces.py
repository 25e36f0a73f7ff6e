"""Faces that share a layout in a search."""

from __future__ import annotations

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from design.spec.worked_out import once

_ALIKE = 0.1
"""By which half extents of faces of one size may differ, of the larger."""


@once
def layout_groups(spec: ObjectSpec) -> tuple[tuple[int, ...], ...]:
    """Sensed faces that share a layout, by `search.vary.layouts`: all, those of one size, or none."""
    way, frames = spec.search.vary.layouts, face_frames(spec)
    if way == "one":
        return (spec.body.sensed,)
    groups: list[list[FaceFrame]] = []
    for frame in frames:
        known = [group for group in groups if way == "per size" and _alike(frame, group[0])]
        if known:
            known[0].append(frame)
        else:
            groups.append([frame])
    return tuple(tuple(frame.number for frame in group) for group in groups)


def group_labels(spec: ObjectSpec) -> tuple[str, ...]:
    """Return what names of variables begin with, group by group; nothing where there is one."""
    groups = layout_groups(spec)
    return ("",) if len(groups) == 1 else tuple(f"face{group[0]}_" for group in groups)


def _alike(a: FaceFrame, b: FaceFrame) -> bool:
    pairs = zip(a.half_extents_mm, b.half_extents_mm, strict=True)
    near = all(abs(one - other) <= _ALIKE * max(one, other) for one, other in pairs)
    return near and a.round == b.round and a.flat == b.flat
