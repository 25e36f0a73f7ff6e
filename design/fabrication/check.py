"""Fabrication checks of a whole object: what printing, casting and assembly will stumble over.

Limits come from `[printer]` and `[silicone]` of the specification. Parts are measured as solids and
as the triangles that are printed. What is only estimated says so: the strain of peeling a shell off
an undercut is taken as the undercut's depth over the thickness of the wall that gives way.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from design.build.parts import parts_of
from design.errors import NotOneSolid
from design.fabrication.assembly import (
    check_electronics,
    check_pockets,
)
from design.fabrication.casting import check_casting
from design.fabrication.finding import Finding, Place, place_of, status_above
from design.fabrication.printing import (
    check_bed,
    check_edges,
    check_features,
    check_inhibition,
    check_walls,
)
from design.fabrication.tools import check_tools
from design.solids.booleans import TRIANGLES, convert_to_triangles, stl_surface
from design.solids.kernel import cq
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

SLIVER_MM3 = 1.0
"""Separate pieces below this volume come loose in the print."""


@dataclass(frozen=True)
class Checked:
    """Findings, and the triangles of every part whose surface closes."""

    findings: list[Finding]
    meshes: dict[str, trimesh.Trimesh]


def check_fabrication(
    spec: ObjectSpec,
    progress: Callable[[str], None] = lambda message: None,
    but: Collection[str] | None = None,
) -> Checked:
    """All checks of an object, part by part; with `but`, up to the first failure of a check that it lacks.

    A part that falls into pieces is a finding itself; where its surface does not close, the checks
    that need it are left out.
    """
    findings = list[Finding]()
    meshes: dict[str, trimesh.Trimesh] = {}
    for finding in _findings(spec, meshes, progress, failures_alone=but is not None):
        findings.append(finding)
        if but is not None and finding.status == "fail" and finding.check not in but:
            break
    return Checked(findings, meshes)


def _findings(
    spec: ObjectSpec,
    meshes: dict[str, trimesh.Trimesh],
    progress: Callable[[str], None],
    failures_alone: bool,
) -> Iterator[Finding]:
    """Yield findings as parts are made; `meshes` takes the triangles of each part that closes."""
    for part in parts_of(spec):
        progress(f"checking {part.name}")
        try:
            shape = part.make()
        except NotOneSolid as error:
            shape = error.shape
        solid_findings, mesh = check_solid(part.name, shape, spec)
        yield from solid_findings
        if mesh is not None:
            meshes[part.name] = mesh
            yield from check_walls(part, mesh, spec, failures_alone)
            yield from (*check_edges(part, mesh), *check_bed(part, mesh, spec))
    yield from (*check_features(spec), *check_inhibition(spec), *check_pockets(spec))
    if "core" in meshes:
        progress("checking boards, chips and wires")
        yield from check_electronics(spec, meshes["core"])
    progress("checking the jig and the templates")
    yield from check_tools(spec, meshes)
    progress("checking the mould")
    yield from check_casting(spec, meshes)


def check_solid(
    name: str, shape: cq.Shape | trimesh.Trimesh, spec: ObjectSpec
) -> tuple[list[Finding], trimesh.Trimesh | None]:
    """One valid solid without slivers, closed as triangles; the mesh where it is closed.

    Closed as it is written: in the single precision of an STL, which may join corners.
    """
    mesh = mesh_of(shape, spec) if isinstance(shape, cq.Shape) else shape
    pieces = sorted(_pieces(shape))
    single = len(pieces) == 1 and (not isinstance(shape, cq.Shape) or shape.isValid())
    text = (
        "the part is one valid solid"
        if single
        else f"the part falls into pieces or is not valid: {_apart(name)}"
    )
    place = None if single or not pieces else pieces[0][1]
    status = "pass" if single else "fail"
    findings = [Finding("one solid", name, float(len(pieces)), 1.0, "solids", status, text, place)]
    if pieces:
        findings.append(_sliver(name, *pieces[0]))
    closed = bool(mesh.is_watertight and mesh.is_winding_consistent)
    closed = closed and stl_surface(mesh) is not None
    text = (
        "the triangles close round a volume, outwards throughout, in the precision of the STL; where they "
        f"do not, two cuts touch in a line: {_apart(name)} by 0.01 mm"
    )
    status = "pass" if closed else "fail"
    findings.append(Finding("closed surface", name, float(closed), 1.0, "", status, text))
    return findings, mesh if closed else None


def _apart(part: str) -> str:
    """Return what to change where cuts of a part graze each other."""
    if not part.startswith(("mould_half", "mould_seal_half")):
        return "move its recesses, holes or pockets apart"
    return "turn the seam (mould.parting_azimuth_deg), or move its magnets,"


def _sliver(name: str, volume_mm3: float, place: Place) -> Finding:
    text = (
        "volume of the smallest piece: what is smaller comes loose. Let cuts overlap clearly or keep "
        "them apart"
    )
    status = status_above(volume_mm3, SLIVER_MM3)
    return Finding("no slivers", name, volume_mm3, SLIVER_MM3, "mm³", status, text, place)


def _pieces(shape: cq.Shape | trimesh.Trimesh) -> list[tuple[float, Place]]:
    """Volume (mm³) and middle of every separate piece; a void inside one (its triangles look inwards)
    is none."""
    if isinstance(shape, cq.Shape):
        return [(s.Volume(), place_of(s.Center().toTuple())) for s in shape.Solids()]
    pieces = [piece for piece in shape.split(only_watertight=False) if piece.volume > 0]
    return [(float(piece.volume), place_of(piece.center_mass)) for piece in pieces]


def mesh_of(shape: cq.Shape, spec: ObjectSpec) -> trimesh.Trimesh:
    """Triangles of a shape, as `build` writes them."""
    return convert_to_triangles(shape, TRIANGLES, False)
