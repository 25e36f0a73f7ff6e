"""Still picture of the whole object: a quarter of the silicone cut away, magnets, core and boards."""

from __future__ import annotations

from pathlib import Path

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.render.pieces import COLOURS, POLES, Piece, load_stl, picture_of, without_quarter

_TOWARDS, _UP = (1.0, -1.25, 0.9), (0.0, 0.0, 1.0)
"""Direction from the object to the viewer, and the one that is up in the picture."""


def draw_still(spec: ObjectSpec, build: Path, png_path: Path) -> Path:
    """Draw the object of a build's folder, with its axes and a bar of 10 mm."""
    picture = picture_of(_pieces(spec, build), _TOWARDS, _UP)
    figure, axes = picture.figure(6.4)
    picture.add_axes_and_scale(axes)
    return save_figure(figure, png_path)


def _pieces(spec: ObjectSpec, build: Path) -> list[Piece]:
    from design.body.triangles import block_surface
    from design.build.scene import magnet_halves
    from design.layout.boards import board_blocks
    from design.layout.places.positions import magnet_layout

    shell = without_quarter(load_stl(build / "shell.stl"))
    pieces = [Piece(load_stl(build / "core.stl"), COLOURS["core"]), Piece(shell, COLOURS["shell"])]
    for halves in magnet_halves(spec, magnet_layout(spec)):
        pieces += [Piece(half, c) for half, c in zip(halves, POLES, strict=True)]
    return [
        *pieces,
        *(Piece(block_surface(block), COLOURS["board"]) for block in board_blocks(spec)),
    ]
