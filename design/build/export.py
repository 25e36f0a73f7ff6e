"""Export of every part of an object as STL, 3MF and STEP files, described in a manifest."""

# pyright: reportAttributeAccessIssue=false
from __future__ import annotations

import io
import re
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from design.build.manifest import BuildManifest, PartManifest, remove_manifest
from design.build.parts import Part, parts_of
from design.build.print_settings import PrintSettings, print_settings
from design.build.scene import ASSEMBLY_NAME, assembly_scene, write_glb
from design.build.slicer_file import write_3mf
from design.errors import InputError
from design.files import atomic_path
from design.solids.booleans import TRIANGLES, convert_to_triangles, stl_surface
from design.solids.kernel import cq
from design.spec.object import ObjectSpec
from design.spec_io import spec_hash

if TYPE_CHECKING:
    import trimesh

_STEP_TIME = re.compile(rb"(FILE_NAME\('[^']*',\s*)'[^']*'")
_STEP_COUNT = re.compile(rb"('Open CASCADE STEP translator [\d.]+) \d+'")
_LIBRARIES = ("instobj", "cadquery", "cadquery-ocp", "trimesh", "numpy")


def build_object(
    spec: ObjectSpec,
    folder: Path | str,
    progress: Callable[[str], None] = lambda message: None,
) -> BuildManifest:
    """Write {part}.stl, .3mf, .step, assembly.glb and manifest.json (last); return the manifest.

    Probes and magnet templates are in their own frames, all other parts in the object's. Lengths
    are in mm, volumes in mm³. Nothing is written before every part has been built, and an earlier
    build's manifest goes first: a manifest always describes the files next to it.

    Raises
    ------
    InputError
        The dimensions give no valid part, or the folder cannot be written.
    """
    parts, solids = parts_of(spec), {}
    for part in parts:
        progress(f"building {part.name}")
        solids[part.name] = part.make()
    remove_manifest(folder)
    written, meshes = [], {}
    for part in parts:
        progress(f"writing {part.name}")
        manifest, meshes[part.name] = write_part(part, solids[part.name], Path(folder), spec)
        written.append(manifest)
    progress("writing the assembly")
    write_glb(assembly_scene(spec, meshes), Path(folder) / ASSEMBLY_NAME)
    versions = {library: version(library) for library in _LIBRARIES}
    manifest = BuildManifest(spec.name, spec_hash(spec), tuple(written), versions)
    path = manifest.write(folder)
    progress(f"wrote {path}")
    return manifest


def write_part(
    part: Part, solid: cq.Solid | trimesh.Trimesh, folder: Path, spec: ObjectSpec
) -> tuple[PartManifest, trimesh.Trimesh]:
    """Write one part as STEP, STL and 3MF; measure both the solid and the STL as read back.

    What is known by its triangles has no STEP, and its faces are its triangles.

    Raises
    ------
    InputError
        The folder cannot be written, or the part touches itself so that its surface is not closed.
    """
    target = folder / f"{part.name}.stl"
    if isinstance(solid, cq.Shape):
        # The bounding box is read first: a triangulated shape would be measured by its triangles.
        box, centre = solid.BoundingBox(), solid.Center()
        measures = {
            "volume_mm3": solid.Volume(),
            "bounding_box_mm": ((box.xmin, box.ymin, box.zmin), (box.xmax, box.ymax, box.zmax)),
            "centre_of_mass_mm": centre.toTuple(),
            "face_count": len(solid.Faces()),
            "solid_count": len(solid.Solids()),
        }
        mesh = printed = _write_stl(convert_to_triangles(solid, TRIANGLES, False), target)
        _write_step(solid, target.with_suffix(".step"))
    else:
        measures = {
            "volume_mm3": float(solid.volume),
            "bounding_box_mm": tuple(map(tuple, solid.bounds.tolist())),
            "centre_of_mass_mm": tuple(solid.center_mass.tolist()),
            "face_count": len(solid.faces),
            "solid_count": int(solid.body_count),
        }
        mesh, printed = _write_stl(solid, target), solid
    manifest = PartManifest(
        name=part.name,
        **measures,
        stl_volume_mm3=float(mesh.volume),
        stl_watertight=bool(mesh.is_watertight),
        stl_triangles=len(mesh.faces),
        material=part.material,
        count=part.count,
        printing=_write_3mf(part, printed, folder, spec),
    )
    return manifest, mesh


def _write_3mf(
    part: Part, mesh: trimesh.Trimesh, folder: Path, spec: ObjectSpec
) -> PrintSettings | None:
    settings = print_settings(spec, part.name, mesh, part.material == "printed")
    write_3mf(mesh, part.name, folder / f"{part.name}.3mf", settings, spec.printer.bed_mm[:2])
    return settings


def _write_step(solid: cq.Solid, target: Path) -> None:
    """Write with CadQuery's settings, through memory; equal solids give equal files."""
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer

    writer, content = STEPControl_Writer(), io.BytesIO()
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 1)
    Interface_Static.SetIVal_s("write.precision.mode", 0)
    Interface_Static.SetCVal_s("xstep.cascade.unit", "MM")
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    writer.Transfer(solid.wrapped, STEPControl_AsIs)
    if writer.WriteStream(content) != IFSelect_RetDone:
        raise InputError(f"{target.stem} cannot be written as STEP. Change its dimensions a little")
    with atomic_path(target) as path:
        path.write_bytes(_without_changing_marks(content.getvalue()))


def _without_changing_marks(step: bytes) -> bytes:
    """STEP without the time in its header, and without the kernel's count of models of this process."""
    step = _STEP_TIME.sub(rb"\1'1980-01-01T00:00:00'", step, count=1)
    return _STEP_COUNT.sub(rb"\1 1'", step)


def _write_stl(surface: trimesh.Trimesh, target: Path) -> trimesh.Trimesh:
    """Write a surface, and return it as the file holds it.

    Raises
    ------
    InputError
        It does not close in the precision of the file, or the folder cannot be written.
    """
    written = stl_surface(surface)
    if written is None:
        raise InputError(
            f"the surface of {target.stem} is not closed: two of its recesses or pockets touch in a line. "
            "Move them apart, or let them overlap, by 0.01 mm or more"
        )
    with atomic_path(target) as path:
        written.export(path)
    return written
