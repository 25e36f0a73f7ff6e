"""Scene of the assembled object, and its GLB to look at."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.files import atomic_path
from design.layout.boards import board_blocks
from design.layout.places.positions import MagnetLayout, magnet_layout
from design.spec.magnets import MagnetSize
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

ASSEMBLY_NAME = "assembly.glb"
_CORE = (0.35, 0.47, 0.62, 1.0)
_SHELL = (0.93, 0.84, 0.68, 0.45)
_NORTH = (0.80, 0.16, 0.14, 1.0)
_SOUTH = (0.16, 0.32, 0.72, 1.0)
_BOARD = (0.10, 0.45, 0.22, 1.0)
_GLTF_FRAME = np.array([[1e-3, 0, 0, 0], [0, 0, 1e-3, 0], [0, -1e-3, 0, 0], [0, 0, 0, 1.0]])
"""Millimetres with z up to glTF's metres with y up."""


def assembly_scene(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> trimesh.Scene:
    """Core, translucent shell, magnets (north red, south blue) and sensor boards in their places."""
    import trimesh

    scene = trimesh.Scene()
    for name, colour in (("core", _CORE), ("shell", _SHELL)):
        scene.add_geometry(_coloured(meshes[name], colour), node_name=name, geom_name=name)
    for index, (north, south) in enumerate(magnet_halves(spec, magnet_layout(spec))):
        for pole, half, colour in (("north", north, _NORTH), ("south", south, _SOUTH)):
            name = f"magnet_{index + 1}_{pole}"
            scene.add_geometry(_coloured(half, colour), node_name=name, geom_name=name)
    for index, board in enumerate(board_blocks(spec)):
        name, box = f"sensor_{index + 1}", trimesh.creation.box(2 * board.half_mm)
        placed = _coloured(_moved(box, board.axes, board.centre_mm), _BOARD)
        scene.add_geometry(placed, node_name=name, geom_name=name)
    return scene


def write_glb(scene: trimesh.Scene, target: Path) -> None:
    """Write a scene in mm as binary glTF (metres, y up).

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    turned = scene.copy()
    turned.apply_transform(_GLTF_FRAME)
    with atomic_path(target) as path:
        turned.export(path, file_type="glb")


def magnet_halves(
    spec: ObjectSpec, layout: MagnetLayout
) -> list[tuple[trimesh.Trimesh, trimesh.Trimesh]]:
    """North and south half of every magnet, as solid prisms of its outline."""
    import trimesh

    def half_of(size: MagnetSize) -> trimesh.Trimesh:
        half, outer = size.height_mm / 2, size.diameter_mm / 2
        if size.shape == "block":
            return trimesh.creation.box((*size.edges_mm, half))
        if size.shape == "ring":
            return trimesh.creation.annulus(size.inner_diameter_mm / 2, outer, half, sections=48)
        return trimesh.creation.cylinder(outer, half, sections=48)

    sizes = spec.magnets.distinct_sizes
    bodies, halves = [half_of(size) for size in sizes], []
    for centre, frame, number in zip(layout.centre_mm, layout.frames, layout.size, strict=True):
        body, up = bodies[number], sizes[number].height_mm / 4 * frame[:, 2]
        halves.append(tuple(_moved(body, frame, centre + sign * up) for sign in (1, -1)))
    return halves


def _moved(
    mesh: trimesh.Trimesh, frame: Float[np.ndarray, "3 3"], origin_mm: Float[np.ndarray, "3"]
) -> trimesh.Trimesh:
    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = frame, origin_mm
    return mesh.copy().apply_transform(placed)


def _coloured(mesh: trimesh.Trimesh, colour: tuple[float, ...]) -> trimesh.Trimesh:
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    copy = mesh.copy()
    copy.metadata.clear()  # names of temporary files would go into the GLB
    mode = "BLEND" if colour[3] < 1 else "OPAQUE"
    material = PBRMaterial(
        baseColorFactor=colour, metallicFactor=0.1, roughnessFactor=0.7, alphaMode=mode
    )
    copy.visual = TextureVisuals(material=material)
    return copy
