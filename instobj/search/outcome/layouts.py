"""Layouts of a search in three dimensions: where every part of start, leaders and front lies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from design.body.triangles import Block
from design.layout.boards import board_blocks, mounted_sensors
from design.layout.body import body_of, face_frames
from design.layout.places.positions import magnet_layout
from design.layout.pockets import magnet_bodies, sensor_places
from design.search.space import SearchSpace, with_layout
from design.spec.object import ObjectSpec
from instobj.search.outcome.figures import LABELS
from instobj.search.outcome.history import History, front_rows
from instobj.search.outcome.moves import paired
from instobj.search.trials import KeptTrials
from instobj.search.verdict import FIRST, Promotion, score_at
from instobj.viewer.archive import pack
from instobj.viewer.scene import Arrays, add_surface
from instobj.viewer.surface import shaded_part

_MOST_OF_FRONT = 40
"""Layouts of the front that are shown, spread over it."""


@dataclass(frozen=True)
class ShownLayout:
    """A layout with its objectives at the lowest fidelity level, as trials have them."""

    label: str
    spec: ObjectSpec
    scores: tuple[float, ...]


def shown_layouts(
    space: SearchSpace, kept: KeptTrials, promotion: Promotion, history: History
) -> list[ShownLayout]:
    """The start, the leaders with the best of them first, then the rest of the front."""
    finished = kept.finished
    row_of = {trial.number: row for row, trial in enumerate(finished)}
    layouts = [ShownLayout(promotion.start.label, promotion.start.spec, tuple(history.start))]
    named_layouts = {layout.label: layout for layout in (*promotion.finalists, *promotion.leaders)}
    promoted = {layout.trial for layout in named_layouts.values()}
    for layout in named_layouts.values():
        if layout.corrected:
            values = tuple(score_at(name, layout, FIRST) for name in history.names)
            layouts.append(ShownLayout(layout.label, layout.spec, values))
        elif layout.trial is not None:
            values = tuple(history.values[row_of[layout.trial]])
            layouts.append(ShownLayout(layout.label, layout.spec, values))
    front = front_rows(history)
    spread = np.linspace(0, len(front) - 1, min(len(front), _MOST_OF_FRONT)).round().astype(int)
    for row in (front[place] for place in spread):
        trial = finished[row]
        if trial.number not in promoted and trial.feasible:
            spec = with_layout(space.spec, trial.params)
            layouts.append(ShownLayout(f"trial {trial.number}", spec, tuple(history.values[row])))
    return layouts


def layouts_scene(layouts: Sequence[ShownLayout], history: History) -> bytes:
    """The archive that the page reads; each layout's parts are paired with the start's."""
    start = layouts[0].spec
    size_mm = np.max([layout.spec.body.size_mm for layout in layouts], axis=0)
    trials = history.values[history.feasible, :2] if len(history.names) > 1 else np.zeros((0, 2))
    content = {
        "size_mm": size_mm.tolist(),
        "objectives": [LABELS[name] for name in history.names],
        "trials": _rounded(trials),
        "faces": [
            {
                "number": frame.number,
                "centre_mm": frame.centre_mm.tolist(),
                "normal": frame.normal.tolist(),
            }
            for frame in face_frames(start)
        ],
        "layouts": [_layout(layout, start) for layout in layouts],
    }
    return pack(content, _surfaces(start))


def _surfaces(spec: ObjectSpec) -> Arrays:
    """Body and core of an object that is no box; a search changes neither."""
    arrays: Arrays = {}
    body = body_of(spec)
    if not body.cuboid:
        core = body.core_surface()
        add_surface(arrays, "body", shaded_part(body.outer_surface()))
        if core is not None:
            add_surface(arrays, "core", shaded_part(core))
    return arrays


def _layout(shown: ShownLayout, start: ObjectSpec) -> dict[str, Any]:
    """Parts as centre (mm), axes as columns row by row, half edges (mm).

    Body and core of boxes, which a search may make larger; others have surfaces of their own.
    """
    spec = shown.spec
    size = np.asarray(spec.body.size_mm) / 2
    half = (size, body_of(spec).core_half_mm) if body_of(spec).cuboid else (np.ones(3),) * 2
    return {
        "label": shown.label,
        "scores": [score if np.isfinite(score) else None for score in shown.scores],
        "body": _part(np.zeros(3), np.eye(3), half[0]),
        "core": _part(np.zeros(3), np.eye(3), half[1]),
        **parts_of(spec),
        "magnet_from": _origins(_magnet_places(start), _magnet_places(spec)),
        "sensor_from": _origins(_sensor_places(start), _sensor_places(spec)),
    }


def parts_of(spec: ObjectSpec) -> dict[str, list[dict[str, Any]]]:
    """Magnets, chips and boards as centre (mm), axes as columns row by row, half edges (mm); face by face."""
    return {
        "magnets": _magnets(spec),
        "chips": _blocks([mounted.chip for mounted in mounted_sensors(spec)]),
        "boards": _blocks(board_blocks(spec)),
    }


def _magnets(spec: ObjectSpec) -> list[dict[str, Any]]:
    layout, bodies = magnet_layout(spec), (body for face in magnet_bodies(spec) for body in face)
    return [
        _part(centre, turn, np.array([*[body.outline.radius_mm] * 2, body.height_mm / 2]))
        for centre, turn, body in zip(layout.centre_mm, layout.frames, bodies, strict=True)
    ]


def _blocks(blocks: list[Block]) -> list[dict[str, Any]]:
    return [_part(block.centre_mm, block.axes, block.half_mm) for block in blocks]


def _part(centre_mm: np.ndarray, axes: np.ndarray, half: np.ndarray) -> dict[str, Any]:
    return {"at": _rounded(centre_mm), "axes": _rounded(axes.ravel()), "half": _rounded(half)}


def _rounded(values: np.ndarray) -> list[Any]:
    return np.round(values, 4).tolist()


_PlacesOfFaces = list[Float[np.ndarray, "part 2"]]


def _magnet_places(spec: ObjectSpec) -> _PlacesOfFaces:
    return [np.array([body.centre_mm[:2] for body in face]) for face in magnet_bodies(spec)]


def _sensor_places(spec: ObjectSpec) -> _PlacesOfFaces:
    return [np.array(face)[:, :2] for face in sensor_places(spec)]


def _origins(places_before: _PlacesOfFaces, places_after: _PlacesOfFaces) -> list[int]:
    """Return which part of the start each part was, face by face; −1 for a new one."""
    origins, first = [], 0
    for old, new in zip(places_before, places_after, strict=True):
        pairs = {now: was for was, now in paired(old, new)}
        origins += [first + pairs[k] if k in pairs else -1 for k in range(len(new))]
        first += len(old)
    return origins
