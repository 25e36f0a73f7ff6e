"""Picture of the printed and cast parts of a build, from its STL files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from design.build.manifest import MANIFEST_NAME, BuildManifest, PartManifest
from instobj.figures.saving import save_figure
from instobj.render.pieces import COLOURS, Direction, Piece, cut_open, load_stl, picture_of

if TYPE_CHECKING:
    import trimesh
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class PartView:
    """View of one part: direction towards the viewer, and object axis drawn upwards."""

    part: str
    title: str
    towards_viewer: Direction
    up: Direction
    cut_open: bool = False


VIEWS = {
    view.part: view
    for view in (
        PartView("core", "Core, from +x, −y and +z", (1, -1.25, 1), (0, 0, 1)),
        PartView("shell", "Shell, cut open", (1, -1.25, 0.9), (0, 0, 1), True),
        PartView(
            "mould_box",
            "Mould box, open side up",
            (0.7, -1, -1.6),
            (0, 0, -1),
        ),
        PartView(
            "mould_half_a",
            "Mould half, from its seam",
            (-1, -0.8, 0.7),
            (0, 0, 1),
        ),
        PartView("mould_plug", "Mould plug", (1.2, -0.9, 0.7), (0, 0, 1)),
        PartView("mould_holder", "Rod for the core", (1.2, -0.9, 0.7), (0, 0, 1)),
        PartView("jig", "Jig", (0.7, -1, 1), (0, 0, 1)),
        PartView("magnet_template", "Magnet template", (0.5, -0.9, 1.6), (0, 0, 1)),
    )
}
"""Parts in the order shown, where the build has them."""


def draw_parts(folder: Path | str, png_path: Path | str) -> Path:
    """Draw core, shell (cut open), mould, jig and template of a build into one PNG.

    Parameters
    ----------
    folder
        The folder that `design.build.export.build_object` wrote, or the manifest.json in it.
    png_path
        The picture to write.

    Raises
    ------
    InputError
        The folder holds no manifest or lacks a part's STL, or the picture cannot be written.
    """
    from matplotlib.figure import Figure

    folder = Path(folder)
    folder = folder.parent if folder.name == MANIFEST_NAME else folder
    manifest = BuildManifest.read(folder)
    figure = Figure(figsize=(15.5, 11.4), layout="constrained")
    figure.suptitle(f"Parts of {manifest.name}", fontsize=15)
    shown = {part.name for part in manifest.parts}
    views = [view for name, view in VIEWS.items() if name in shown]
    places = figure.subplots(2, 3).ravel()
    for axes in places:
        axes.set_axis_off()
    for axes, view in zip(places, views, strict=False):
        _draw_view(axes, view, load_stl(folder / f"{view.part}.stl"), manifest.part(view.part))
    target = Path(png_path)
    save_figure(figure, target)
    return target


def _draw_view(axes: Axes, view: PartView, mesh: trimesh.Trimesh, part: PartManifest) -> None:
    piece = Piece(mesh, COLOURS[view.part])
    pieces = [cut_open(piece) if view.cut_open else piece]
    picture = picture_of(pieces, view.towards_viewer, view.up)
    picture.show(axes)
    size = " × ".join(f"{edge:.4g}" for edge in part.size_mm)
    axes.set_title(
        f"{view.title}\n{size} mm, {part.volume_mm3 / 1000:.2f} cm³",
        fontsize=12,
        y=1.0,  # given, it is not looked for among ticks that do not show
    )
    picture.add_axes_and_scale(axes)
