"""Order of demoulding in one picture, step by step, and the same of the mould for a seal layer."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from design.layout.mould.frame import mould_frame, mould_style, parting
from design.layout.surface import sealed_body_surface
from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.render.pieces import COLOURS, Piece, load_stl, picture_of
from instobj.render.raster import camera_axes

if TYPE_CHECKING:
    import trimesh

    from design.layout.mould.pins import Pin

_SHOWN = (
    *("mould_box", "mould_half_a", "mould_half_b", "mould_plug", "mould_holder", "shell"),
    *("mould_seal_box", "mould_seal_half_a", "mould_seal_half_b"),
)
_DRAWN_MM, _GAP_MM, _COLUMNS = 14.0, 18.0, 3
_APART = 0.55
"""Distance that parts are drawn, as a share of the body's largest edge."""


@dataclass(frozen=True)
class Step:
    """Step that is done, and all that is seen then."""

    text: str
    pieces: tuple[Piece, ...]


def draw_demoulding(spec: ObjectSpec, folder: Path, pins: tuple[Pin, ...], target: Path) -> Path:
    """Draw the steps row by row, as the mould stands when silicone is poured.

    `folder` holds a build with a mould, `pins` are its loose pins (none of a mould in one piece).
    """
    frame = mould_frame(spec)
    split = mould_style(spec) == "split"
    normal = parting(spec).normal if split else frame.across
    towards = np.cross(frame.out, normal) + 0.45 * normal + 0.7 * frame.out
    view = _direction(towards), _direction(frame.out)
    camera = camera_axes(*view)
    parts = {
        name: Piece(load_stl(path), COLOURS[name])
        for name in _SHOWN
        if (path := folder / f"{name}.stl").is_file()
    }
    shown = split_steps(spec, parts, pins) if split else one_piece_steps(spec, parts)
    shown += _seal_steps(spec, parts, pins)
    placed, places = _place_in_columns(shown, camera)
    picture = picture_of(placed, *view)
    figure, axes = picture.figure(12.0)
    for number, (step, (x, y)) in enumerate(zip(shown, places, strict=True), start=1):
        axes.text(x, y, f"{number}  {step.text}", ha="center", va="top", fontsize=11)
    return save_figure(figure, target)


def split_steps(spec: ObjectSpec, parts: dict[str, Piece], pins: tuple[Pin, ...]) -> list[Step]:
    """Pins outwards (and the rod), halves along the pull, then what is left."""
    frame, normal = mould_frame(spec), parting(spec).normal
    apart = _APART * max(spec.body.size_mm)
    bodies = tuple(Piece(_body(pin), COLOURS["pin"]) for pin in pins)
    out = tuple(piece.moved(_DRAWN_MM * pin.way) for pin, piece in zip(pins, bodies, strict=True))
    halves = (parts["mould_half_a"], parts["mould_half_b"])
    opened = (halves[0].moved(apart * normal), halves[1].moved(-apart * normal))
    rod = tuple(parts[name] for name in ("mould_holder",) if name in parts)
    plug = tuple(parts[name] for name in ("mould_plug",) if name in parts)
    drawn = tuple(piece.moved(apart * frame.out) for piece in rod)
    steps = [
        Step("closed, until it has cured", (*halves, *bodies, *rod, *plug)),
        Step("draw all pins outwards", (*halves, *out, *rod, *plug)),
    ]
    if rod:
        steps.append(Step("draw the rod", (*halves, *drawn)))
    steps.append(Step("part the halves", (*opened, parts["shell"], *plug)))
    if plug:
        last = Step("peel the shell off the plug", (parts["shell"], _away(spec, plug[0])))
    else:
        last = Step("cut the sprues; the core stays in", (parts["shell"],))
    return [*steps, last]


def one_piece_steps(spec: ObjectSpec, parts: dict[str, Piece]) -> list[Step]:
    """The plug first, where there is one; then the walls fold inwards off the bosses."""
    box, shell, out = parts["mould_box"], parts["shell"], mould_frame(spec).out
    plug = tuple(parts[name] for name in ("mould_plug",) if name in parts)
    steps = [Step("closed, until it has cured", (box, shell, *plug))]
    if plug:
        steps.append(Step("draw the plug straight out", (box, shell, _away(spec, plug[0]))))
    apart = (0.5 + _APART) * max(spec.body.size_mm)
    text = "fold its walls inwards and peel it out" if plug else "peel it out from its edge"
    return [*steps, Step(text, (box, shell.moved(apart * out)))]


def _seal_steps(spec: ObjectSpec, parts: dict[str, Piece], pins: tuple[Pin, ...]) -> list[Step]:
    """The second pour, where there is one: the mould closed, and what comes out of it."""
    if not spec.shell.seal_layer_mm:
        return []
    finished = Piece(sealed_body_surface(spec), COLOURS["shell"])
    inside = tuple(parts[name] for name in ("mould_plug", "mould_holder") if name in parts)
    if "mould_seal_box" in parts:
        box = parts["mould_seal_box"]
        pour = Step("pour the layer in the seal box", (box, parts["shell"], *inside))
        apart = (0.5 + _APART) * max(spec.body.size_mm) * mould_frame(spec).out
        slits = bool(spec.shell.slits.depth_mm)
        inside = () if slits else inside
        text = "draw the plug, fold the walls inwards" if slits else "draw it out"
        out = Step(text, tuple(piece.moved(apart) for piece in (finished, *inside)))
        return [pour, Step(out.text, (box, *out.pieces))]
    held = tuple(Piece(_body(pin), COLOURS["pin"]) for pin in pins if pin.locator is not None)
    apart = _APART * max(spec.body.size_mm) * parting(spec).normal
    halves = (parts["mould_seal_half_a"], parts["mould_seal_half_b"])
    opened = (halves[0].moved(apart), halves[1].moved(-apart))
    return [
        Step("pour the layer in the seal halves", (*halves, *held, *inside)),
        Step("draw what holds the core, part them", (*opened, finished)),
    ]


def _away(spec: ObjectSpec, piece: Piece) -> Piece:
    return piece.moved((0.4 + _APART) * max(spec.body.size_mm) * mould_frame(spec).out)


def _body(pin: Pin) -> trimesh.Trimesh:
    """A pin as a shank and its head."""
    import trimesh

    shank = trimesh.creation.cylinder(pin.radius_mm, segment=pin.axis_mm, sections=24)
    wide = pin.radius_mm + pin.rim_mm
    head = trimesh.creation.cylinder(wide, segment=pin.head_axis_mm, sections=24)
    return cast("trimesh.Trimesh", trimesh.util.concatenate([shank, head]))


def _place_in_columns(
    steps: list[Step], camera: np.ndarray
) -> tuple[list[Piece], list[tuple[float, float]]]:
    """Pieces of all steps, in rows, and where each step's text begins (right, up)."""
    spans = []
    for step in steps:
        on_screen = np.concatenate([piece.mesh.vertices @ camera[:2].T for piece in step.pieces])
        spans.append((on_screen.min(axis=0), on_screen.max(axis=0)))
    wide, tall = np.max([high - low for low, high in spans], axis=0) + _GAP_MM
    placed, places = [], []
    for index, (step, (low, high)) in enumerate(zip(steps, spans, strict=True)):
        middle = np.array([index % _COLUMNS * wide, -(index // _COLUMNS) * tall])
        shift = (middle - (low + high) / 2) @ camera[:2]
        placed += [piece.moved(shift) for piece in step.pieces]
        places.append((float(middle[0]), float(middle[1] - (high - low)[1] / 2 - 3.0)))
    return placed, places


def _direction(vector: np.ndarray) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return (x, y, z)
