"""Exploded view of an object: mould, shell with its magnets, core with its sensor boards, plug."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.files import atomic_path
from design.spec import ObjectSpec
from instobj.report.parts_figure import PartView, camera_axes, depth_image, load_stl, shade

if TYPE_CHECKING:
    import trimesh

_TOWARDS = (1.0, -1.25, 0.6)
_UP = (0.0, 0.0, 1.0)
_GAP_MM = 24.0
_OUT_MM = 7.0
_BOARD = (0.10, 0.45, 0.22)
_NORTH, _SOUTH = (0.80, 0.16, 0.14), (0.16, 0.32, 0.72)
_PRINTED = {
    "core": (0.55, 0.66, 0.78),
    "shell": (0.93, 0.84, 0.68),
    "mould_box": (0.66, 0.77, 0.62),
    "mould_half_a": (0.66, 0.77, 0.62),
    "mould_half_b": (0.58, 0.70, 0.56),
    "mould_plug": (0.76, 0.70, 0.84),
    "mould_holder": (0.76, 0.70, 0.84),
}


@dataclass(frozen=True)
class Piece:
    """Triangles in their place in the view, a colour each, and what is written beside them."""

    mesh: trimesh.Trimesh
    colour: tuple[float, float, float]
    label: str = ""


def draw_exploded(spec: ObjectSpec, folder: Path, png_path: Path) -> Path:
    """Draw the parts of a build above each other, in the order in which they go together."""
    from matplotlib.figure import Figure

    pieces = _pieces(spec, folder)
    whole = _joined([piece.mesh for piece in pieces])
    colours = np.concatenate([np.tile(p.colour, (len(p.mesh.faces), 1)) for p in pieces])
    camera = camera_axes(_TOWARDS, _UP)
    image = depth_image(np.asarray(whole.triangles) @ camera.T)
    picture = shade(image, whole, camera, PartView("all", "", _TOWARDS, _UP, colours))
    left, right, bottom, top = image.extent_mm
    figure = Figure(figsize=(11 * (right - left) / (top - bottom) + 2.4, 11), layout="constrained")
    axes = figure.subplots()
    axes.imshow(picture, extent=image.extent_mm)
    for piece in pieces:
        if piece.label:
            seen = piece.mesh.vertices @ camera.T
            height = (seen[:, 1].min() + seen[:, 1].max()) / 2
            axes.text(right + 2, height, piece.label, va="center", fontsize=12)
    axes.set_axis_off()
    with atomic_path(png_path) as path:
        figure.savefig(path, dpi=90, format="png", bbox_inches="tight")
    return png_path


def _joined(meshes: list[trimesh.Trimesh]) -> trimesh.Trimesh:
    import trimesh

    start = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    return trimesh.Trimesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([m.faces + first for m, first in zip(meshes, start, strict=False)]),
        process=False,
    )


def _pieces(spec: ObjectSpec, folder: Path) -> list[Piece]:
    """From the top: mould, shell with magnets drawn out, core with boards drawn out, plug."""
    parts = {
        name: load_stl(path) for name in _PRINTED if (path := folder / f"{name}.stl").is_file()
    }
    level, pieces = 0.0, []
    for names in (
        ("mould_box",),
        ("mould_half_a", "mould_half_b"),
        ("shell",),
        ("core",),
        ("mould_plug",),
        ("mould_holder",),
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
            aside = _aside(spec, name) + shift
            pieces.append(Piece(_moved(parts[name], aside), _PRINTED[name], name.replace("_", " ")))
        pieces += [Piece(_moved(piece.mesh, shift), piece.colour) for piece in extra]
        level -= high - low + 2 * reach + _GAP_MM
    return pieces


def _aside(spec: ObjectSpec, name: str) -> Float[np.ndarray, "3"]:
    """Halves of a split mould stand apart along the pull."""
    if not name.startswith("mould_half"):
        return np.zeros(3)
    from design.mould_frame import parting

    return (1 if name.endswith("a") else -1) * _OUT_MM * parting(spec).normal


def _around(spec: ObjectSpec, name: str) -> list[Piece]:
    """Magnets or boards of a part, drawn out along their axes."""
    from design.electronics import board_blocks
    from design.layouts import magnet_layout
    from design.scene import magnet_halves

    in_shell = spec.arrangement == "sensors-in-core"
    if name == ("shell" if in_shell else "core"):
        layout = magnet_layout(spec)
        out = _outward(layout.centre_mm, layout.axis) * _OUT_MM
        return [
            Piece(_moved(half, way), colour)
            for halves, way in zip(magnet_halves(spec, layout), out, strict=True)
            for half, colour in zip(halves, (_NORTH, _SOUTH), strict=True)
        ]
    if name == ("core" if in_shell else "shell"):
        import trimesh

        blocks = board_blocks(spec)
        centres = np.stack([block.centre_mm for block in blocks])
        out = _outward(centres, np.stack([block.axes[:, 2] for block in blocks])) * _OUT_MM
        boards = []
        for block, way in zip(blocks, out, strict=True):
            placed = np.eye(4)
            placed[:3, :3], placed[:3, 3] = block.axes, block.centre_mm + way
            box = trimesh.creation.box(2 * block.half_mm)
            boards.append(Piece(box.apply_transform(placed), _BOARD))
        return boards
    return []


def _outward(centre_mm: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Axes turned so that they point away from the middle."""
    sign = np.sign(np.einsum("nk,nk->n", centre_mm - centre_mm.mean(axis=0), axis))
    return np.where(sign < 0, -1.0, 1.0)[:, None] * axis


def _moved(mesh: trimesh.Trimesh, by_mm: np.ndarray) -> trimesh.Trimesh:
    copy = mesh.copy()
    copy.apply_translation(by_mm)
    return copy
