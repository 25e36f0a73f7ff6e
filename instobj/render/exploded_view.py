"""Exploded view of an object: mould, shell with its magnets, core with its sensor boards, plug."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.render.pieces import COLOURS, POLES, Piece, load_stl, picture_of

_TOWARDS = (1.0, -1.25, 0.6)
"""Direction from the object to the viewer."""
_UP = (0.0, 0.0, 1.0)
"""Direction that is up in the picture."""
_HEIGHT_INCHES, _LABEL_INCHES = 11.0, 2.4
"""Height of the picture, and room for the names of the parts."""
_GAP_MM = 24.0
"""Gap between parts."""
_OUT_MM = 7.0
"""Distance by which a part is drawn out."""


def draw_exploded(spec: ObjectSpec, folder: Path, png_path: Path) -> Path:
    """Draw the parts of a build above each other, in the order in which they go together."""
    pieces = _pieces(spec, folder)
    picture = picture_of(pieces, _TOWARDS, _UP)
    left, right, bottom, top = picture.extent_mm
    figure, axes = picture.figure(_HEIGHT_INCHES * (right - left) / (top - bottom), _LABEL_INCHES)
    for piece in pieces:
        if piece.label:
            on_screen = piece.mesh.vertices @ picture.camera.T
            height = (on_screen[:, 1].min() + on_screen[:, 1].max()) / 2
            axes.text(right + 2, height, piece.label, va="center", fontsize=12)
    return save_figure(figure, png_path)


def _pieces(spec: ObjectSpec, folder: Path) -> list[Piece]:
    """From the top: mould, shell with magnets drawn out, core with boards drawn out, plug."""
    parts = {name: load_stl(path) for name in COLOURS if (path := folder / f"{name}.stl").is_file()}
    level, pieces = 0.0, []
    for label, names in (
        ("mould box", ("mould_box",)),
        ("mould halves", ("mould_half_a", "mould_half_b")),
        ("shell", ("shell",)),
        ("core", ("core",)),
        ("mould plug", ("mould_plug",)),
        ("mould holder", ("mould_holder",)),
    ):
        present = [name for name in names if name in parts]
        if not present:
            continue
        extra = _around(spec, present[0])
        low = min(parts[name].bounds[0, 2] for name in present)
        high = max(parts[name].bounds[1, 2] for name in present)
        reach = _OUT_MM if extra else 0.0
        shift = np.array([0.0, 0.0, level - high - reach])
        for name in present:
            text = label if name == present[0] else ""
            piece = Piece(parts[name], COLOURS[name], text)
            pieces.append(piece.moved(_aside(spec, name) + shift))
        pieces += [piece.moved(shift) for piece in extra]
        level -= high - low + 2 * reach + _GAP_MM
    return pieces


def _aside(spec: ObjectSpec, name: str) -> Float[np.ndarray, "3"]:
    """Halves of a split mould stand apart along the pull."""
    if not name.startswith("mould_half"):
        return np.zeros(3)
    from design.layout.mould.frame import parting

    return (1 if name.endswith("a") else -1) * _OUT_MM * parting(spec).normal


def _around(spec: ObjectSpec, name: str) -> list[Piece]:
    """Magnets or boards of a part, drawn out along their axes."""
    from design.body.triangles import block_surface
    from design.build.scene import magnet_halves
    from design.layout.boards import board_blocks
    from design.layout.places.positions import magnet_layout

    in_shell = spec.arrangement == "sensors-in-core"
    if name == ("shell" if in_shell else "core"):
        layout = magnet_layout(spec)
        out = _outward(layout.centre_mm, layout.axis) * _OUT_MM
        return [
            Piece(half, colour).moved(way)
            for halves, way in zip(magnet_halves(spec, layout), out, strict=True)
            for half, colour in zip(halves, POLES, strict=True)
        ]
    if name == ("core" if in_shell else "shell"):
        blocks = board_blocks(spec)
        centres = np.stack([block.centre_mm for block in blocks])
        out = _outward(centres, np.stack([block.axes[:, 2] for block in blocks])) * _OUT_MM
        return [
            Piece(block_surface(block), COLOURS["board"]).moved(way)
            for block, way in zip(blocks, out, strict=True)
        ]
    return []


def _outward(centre_mm: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Axes turned so that they point away from the middle."""
    # n part, k coordinate: which side of the middle its axis points to
    sign = np.sign(np.einsum("nk,nk->n", centre_mm - centre_mm.mean(axis=0), axis))
    return np.where(sign < 0, -1.0, 1.0)[:, None] * axis
