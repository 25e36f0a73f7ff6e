"""Build every part of an object, write STL and STEP files, and describe them in a manifest."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib.metadata import version
from pathlib import Path

import cadquery as cq
import numpy as np

from design.core import make_core
from design.errors import InputError
from design.files import atomic_path
from design.manifest import BuildManifest, PartManifest, remove_manifest
from design.mould import make_mould_box, make_mould_plug
from design.probes import make_probe
from design.shell import make_shell
from design.spec import ObjectSpec
from design.spec_io import spec_hash

STL_TOLERANCE_MM = 0.05
STL_ANGLE_RAD = 0.2

_LIBRARIES = ("instobj", "cadquery", "cadquery-ocp", "trimesh", "numpy")

PART_BUILDERS: dict[str, Callable[[ObjectSpec], cq.Solid]] = {
    "core": make_core,
    "shell": make_shell,
    "mould_box": make_mould_box,
    "mould_plug": make_mould_plug,
    "probe_1": partial(make_probe, tips=1),
    "probe_2": partial(make_probe, tips=2),
    "probe_3": partial(make_probe, tips=3),
}
"""Every part that a build writes, in the order of the manifest."""


def build_object(
    spec: ObjectSpec,
    folder: Path | str,
    progress: Callable[[str], None] = lambda message: None,
) -> BuildManifest:
    """Write {part}.stl, {part}.step and manifest.json (last) into the folder; return the manifest.

    All parts but the probes are in the object's frame. Lengths are in mm, volumes in mm³. Nothing
    is written before every part has been built, and an earlier build's manifest goes first: a
    manifest always describes the files beside it.

    Raises
    ------
    InputError
        The dimensions give no valid part, or the folder cannot be written.
    """
    solids = {}
    for name, make in PART_BUILDERS.items():
        progress(f"building {name}")
        solids[name] = make(spec)
    remove_manifest(folder)
    parts = []
    for name, solid in solids.items():
        progress(f"writing {name}")
        parts.append(write_part(name, solid, Path(folder)))
    versions = {library: version(library) for library in _LIBRARIES}
    manifest = BuildManifest(spec.name, spec_hash(spec), tuple(parts), versions)
    path = manifest.write(folder)
    progress(f"wrote {path}")
    return manifest


def write_part(name: str, solid: cq.Solid, folder: Path) -> PartManifest:
    """Write one part as STEP and STL, and measure both the solid and the STL as read back.

    Raises
    ------
    InputError
        The folder cannot be written, or the part touches itself so that its surface is not closed.
    """
    # The bounding box is read first: a triangulated shape would be measured by its triangles.
    box, centre = solid.BoundingBox(), solid.Center()
    stl_volume, watertight, triangles = _write_stl(solid, folder / f"{name}.stl")
    _write_step(solid, folder / f"{name}.step")
    return PartManifest(
        name=name,
        volume_mm3=solid.Volume(),
        bounding_box_mm=((box.xmin, box.ymin, box.zmin), (box.xmax, box.ymax, box.zmax)),
        centre_of_mass_mm=centre.toTuple(),
        face_count=len(solid.Faces()),
        solid_count=len(solid.Solids()),
        stl_volume_mm3=stl_volume,
        stl_watertight=watertight,
        stl_triangles=triangles,
    )


def _write_step(solid: cq.Solid, target: Path) -> None:
    from OCP.IFSelect import IFSelect_RetDone  # pyright: ignore[reportAttributeAccessIssue]

    with atomic_path(target) as path:
        if solid.exportStep(str(path)) != IFSelect_RetDone:
            raise InputError(f"cannot write {target}. Choose a writable folder with room left")


def _write_stl(solid: cq.Solid, target: Path) -> tuple[float, bool, int]:
    import trimesh

    with atomic_path(target) as path:
        if not solid.exportStl(str(path), STL_TOLERANCE_MM, STL_ANGLE_RAD, relative=False):
            raise InputError(f"cannot write {target}. Choose a writable folder with room left")
        mesh = trimesh.load_mesh(path)
        # The kernel closes the poles of spheres with triangles that repeat a vertex.
        corners = np.sort(mesh.faces, axis=1)
        mesh.update_faces((np.diff(corners, axis=1) > 0).all(axis=1))
        if not mesh.is_watertight:
            raise InputError(
                f"the surface of {target.stem} is not closed: two of its recesses or pockets touch "
                "in a line. Move them apart, or let them overlap, by 0.01 mm or more"
            )
        mesh.export(path)
    return float(mesh.volume), bool(mesh.is_watertight), len(mesh.faces)
