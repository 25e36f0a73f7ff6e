"""Draw the split mould of a specification as it goes together, the way it stands when it is poured.

python examples/draw_mould.py docs/fabrication_ball.png examples/ball.toml
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import trimesh

from design.core_hold import locators
from design.mould_frame import mould_frame, parting
from design.mould_pins import loose_pins, make_pin
from design.mould_plug import make_mould_holder, make_mould_plug
from design.mould_room import core_outside
from design.parts import parts_of
from design.solid_ops import as_triangles
from design.spec import ObjectSpec
from design.spec_io import load_spec
from design.split_mould import make_mould_half
from instobj.report.parts_figure import PartView, camera_axes, depth_image, shade

HALF, OTHER_HALF, ROD = (0.66, 0.77, 0.62), (0.58, 0.70, 0.56), (0.76, 0.70, 0.84)
CORE, PIN, SHELL = (0.55, 0.66, 0.78), (0.80, 0.45, 0.30), (0.93, 0.84, 0.68)
APART = 0.75
"""How far the halves are drawn, of the body's largest edge."""


def pieces(
    spec: ObjectSpec, apart_mm: float
) -> list[tuple[trimesh.Trimesh, tuple[float, float, float]]]:
    """Half B with what it holds where it stands, half A and the pins drawn out."""
    frame, normal = mould_frame(spec), parting(spec).normal
    core = {part.name: part for part in parts_of(spec)}["core"]
    shown = [
        (_moved(make_mould_half(spec, 1), apart_mm * normal), HALF),
        (_moved(make_mould_half(spec, -1), -apart_mm * normal), OTHER_HALF),
        (_moved(core.make() if frame.opening != "closed" else core_outside(spec)), CORE),
    ]
    if frame.plugged:
        made = make_mould_holder(spec) if frame.opening == "bore" else make_mould_plug(spec)
        shown.append((_moved(made), ROD))
    for pin in loose_pins(spec):
        side = float(np.sign(np.round(pin.axis_mm[1] @ normal, 6)))
        shown.append((_moved(make_pin(spec, pin), side * apart_mm * normal + 16.0 * pin.way), PIN))
    return shown


def _moved(shape: object, by_mm: np.ndarray | None = None) -> trimesh.Trimesh:
    mesh = as_triangles(shape).copy()  # pyright: ignore[reportArgumentType]
    mesh.apply_translation(np.zeros(3) if by_mm is None else by_mm)
    return mesh


def joined(meshes: list[trimesh.Trimesh]) -> trimesh.Trimesh:
    """All triangles as one mesh."""
    start = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    return trimesh.Trimesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([m.faces + first for m, first in zip(meshes, start, strict=False)]),
        process=False,
    )


def draw(spec: ObjectSpec, target: Path) -> None:
    """One picture; `out`, the side that is poured into, is up."""
    from matplotlib.figure import Figure

    frame = mould_frame(spec)
    shown = pieces(spec, APART * max(spec.body.size_mm))
    whole = joined([mesh for mesh, _ in shown])
    colours = np.concatenate([np.tile(colour, (len(mesh.faces), 1)) for mesh, colour in shown])
    side = np.cross(frame.out, parting(spec).normal)
    x, y, z = (side + 0.35 * parting(spec).normal + 0.6 * frame.out).tolist()
    up_x, up_y, up_z = frame.out.tolist()
    view = PartView("mould", "", (x, y, z), (up_x, up_y, up_z), colours)
    camera = camera_axes(view.towards_viewer, view.up)
    image = depth_image(np.asarray(whole.triangles) @ camera.T)
    picture = shade(image, whole, camera, view)
    left, right, bottom, top = image.extent_mm
    figure = Figure(figsize=(11, 11 * (top - bottom) / (right - left)), layout="constrained")
    axes = figure.subplots()
    axes.imshow(picture, extent=image.extent_mm)
    axes.set_axis_off()
    held = "locating pins" if locators(spec) else "rod" if frame.opening == "bore" else "plug"
    axes.set_title(f"Split mould of {spec.name}: halves, pins drawn outwards, core and {held}")
    axes.plot([left + 4, left + 24], [bottom + 3] * 2, color="black", lw=2)
    axes.text(left + 14, bottom + 4, "20 mm", ha="center", va="bottom")
    figure.savefig(target, dpi=90)


if __name__ == "__main__":
    draw(load_spec(sys.argv[2]), Path(sys.argv[1]))
