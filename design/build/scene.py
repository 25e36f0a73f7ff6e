"""Meshes for other programs: 3MF of a part for the slicer, GLB of the assembled object to look at."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

import numpy as np
from jaxtyping import Float

from design.errors import StoreError
from design.files import atomic_path
from design.layout.boards import board_blocks
from design.layout.positions import MagnetLayout, magnet_layout
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

_MODEL = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_MODEL_TYPE = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"
_FIRST_DATE = (1980, 1, 1, 0, 0, 0)


def write_3mf(mesh: trimesh.Trimesh, name: str, target: Path) -> None:
    """One object in millimetres, by the 3MF core specification; equal meshes give equal files.

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    corners = "".join(f'<vertex x="{x:.6g}" y="{y:.6g}" z="{z:.6g}"/>' for x, y, z in mesh.vertices)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in mesh.faces)
    model = (
        f'<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xmlns="{_MODEL}"><resources>'
        f'<object id="1" name={quoteattr(name)} type="model"><mesh><vertices>{corners}</vertices>'
        f"<triangles>{triangles}</triangles></mesh></object></resources>"
        '<build><item objectid="1"/></build></model>'
    )
    types = (
        f'<?xml version="1.0" encoding="UTF-8"?><Types xmlns="{_PACKAGE}/content-types">'
        '<Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Default Extension="model" ContentType="{_MODEL_TYPE}"/></Types>'
    )
    relations = (
        f'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="{_PACKAGE}/relationships">'
        '<Relationship Id="rel0" Target="/3D/3dmodel.model" '
        'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
    )
    contents = {
        "[Content_Types].xml": types,
        "_rels/.rels": relations,
        "3D/3dmodel.model": model,
    }
    with atomic_path(target) as path, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for inside, text in contents.items():
            entry = zipfile.ZipInfo(inside, _FIRST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text)


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
    try:
        with atomic_path(target) as path:
            turned.export(path, file_type="glb")
    except StoreError:
        raise
    except OSError as error:
        raise StoreError(f"cannot write {target}: {error.strerror}. Make room there") from error


def magnet_halves(
    spec: ObjectSpec, layout: MagnetLayout
) -> list[tuple[trimesh.Trimesh, trimesh.Trimesh]]:
    """North and south half of every magnet, as solid prisms of its outline."""
    import trimesh

    magnets, quarter = spec.magnets, spec.magnets.height_mm / 4
    if magnets.shape == "block":
        body = trimesh.creation.box((*magnets.size_mm, 2 * quarter))
    elif magnets.shape == "ring":
        radii = (magnets.inner_diameter_mm / 2, magnets.diameter_mm / 2)
        body = trimesh.creation.annulus(*radii, 2 * quarter, sections=48)
    else:
        body = trimesh.creation.cylinder(magnets.diameter_mm / 2, 2 * quarter, sections=48)
    halves = []
    for centre, axis, side in zip(layout.centre_mm, layout.axis, layout.side, strict=True):
        frame = np.column_stack([side, np.cross(axis, side), axis])
        halves.append(
            tuple(_moved(body, frame, centre + sign * quarter * axis) for sign in (1, -1))
        )
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
    mode = "BLEND" if colour[3] < 1 else "OPAQUE"
    material = PBRMaterial(
        baseColorFactor=colour, metallicFactor=0.1, roughnessFactor=0.7, alphaMode=mode
    )
    copy.visual = TextureVisuals(material=material)
    return copy
