"""Shells for a file's body: silicone that gives way where the halves of its mould hook it.

A half may drive into the silicone by a share of its thickness (`COMPLIANCE_FRACTION`), so that a body that
hooks takes a thick shell: with smaller magnets where the usual ones find no room, or a thicker one than
usual, whose magnets lie as far from the core as under the others.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from design.body.castable import castable_body, traits_of_scan
from design.body.imported import body_of_file, file_digest, read_surface
from design.body.kinds.capsule import Capsule
from design.body.kinds.ellipsoid import Ellipsoid
from design.body.kinds.registry import KINDS
from design.body.sampled import measured_distance_mm
from design.errors import SpecError
from design.files import atomic_path
from design.layout.mould.frame import COMPLIANCE_FRACTION, undercut_depth_mm
from design.placement.objects import (
    COARSE,
    SHELL_VARIANTS,
    Request,
    ShellVariant,
    Tables,
    bare_tables,
    fitting_most,
    spec_of,
)

if TYPE_CHECKING:
    import trimesh

_AZIMUTHS_DEG = tuple(np.arange(0.0, 180.0, 5.0).tolist())
_MOST_REFINED, _FINER_DEG = 3, (-2.0, -1.0, 1.0, 2.0)
"""Number of best seams of a file's body round which finer ones are tried, and steps of these."""
_LOOKED_AT_MM = 60.0
"""Longest edge of a body whose hooks are measured; they grow as it does."""
_NOTHING_MM = 0.03
"""Hook of a body 60 mm long under which every shell gives way."""
_SPARE, _EXACT_MM = 1.1, 1e-6
"""Factor by which the mould's triangles may hook deeper."""
_THICKEST_MM = 16.0
"""Thickest shell that is proposed against a hooking seam."""
_THICK = 0.12
"""Share of a body's shortest edge that a shell takes at most, besides sensors and core: in a pear 66 mm wide
no shell of 10 mm was placed."""
_MOST_OFF, _MOST_FILLED = 0.15, 0.15
"""Distance of a castable body to its scan, as a share of its shortest edge, and share of its surface that may
lie farther off, over hollows that are filled: beyond, it is another body."""
_GROWTHS = (1.0, 1.15, 1.3, 1.5, 1.75, 2.0)
"""Factors on the shortest edge of a simple body that is named in place of a file's."""
_LEAST_DEEP = 0.25
"""Depth of the middle of a body's box below its surface, as a share of its shortest edge, at least."""
_SILICONE_BELOW_MM = SHELL_VARIANTS[0].thickness_mm - SHELL_VARIANTS[0].pocket_depth_mm


def turned(tables: Tables, azimuth_deg: float) -> Tables:
    """The same with the seam of its mould at an azimuth."""
    return tables | {"mould": {"parting_azimuth_deg": azimuth_deg}}


def hooked_by_azimuth_mm(tables: Tables) -> dict[float, float]:
    """Return how deep halves hook the body, of seams 5° apart and finer next to those which hook least."""

    def depths(azimuths: Iterable[float]) -> dict[float, float]:
        return {
            azimuth: undercut_depth_mm(spec_of(turned(tables, azimuth))) for azimuth in azimuths
        }

    coarse = depths(_AZIMUTHS_DEG)
    least = sorted(coarse, key=lambda azimuth: coarse[azimuth])[:_MOST_REFINED]
    return coarse | depths(azimuth + shift for azimuth in least for shift in _FINER_DEG)


def castable_request(request: Request, target: Path) -> tuple[Request, str]:
    """Return the request for the scan's `castable_body`, written to `target`, and what was done in words.

    The request itself and "" of a file that is neither noisy nor askew, where silicone gives way by what the
    best seam about z hooks.

    Raises
    ------
    SpecError
        No seam lets the body go, and its hollows are too deep to be filled.
    """
    if not KINDS[request.kind].from_file:
        return request, ""
    file = dict(request.file)
    scan = read_surface(file["file"], file["scale"])
    why = traits_of_scan(scan)
    if not why:
        needed_mm, usual_mm = _needed_mm(request), SHELL_VARIANTS[0].thickness_mm
        thickest_mm = float(np.clip(_THICK * min(request.size_mm), usual_mm, _THICKEST_MM))
        if needed_mm <= thickest_mm:
            return request, ""
        hooked, gives = (COMPLIANCE_FRACTION * d for d in (needed_mm / _SPARE, thickest_mm))
        why = f"halves of a mould hook this body by {hooked:.2g} mm; silicone gives way by {gives:.2g}"
    castable = castable_body(scan)
    x, y, z = castable.surface.extents
    most_mm, off_mm, out_mm = _MOST_OFF * min(x, y, z), castable.off_mm, castable.evened_mm
    filled = float(np.mean(off_mm > most_mm))
    if out_mm > most_mm or filled > _MOST_FILLED:
        raise SpecError(
            f"{why}. Made even about a plane, its hollows filled, it would be another body: {filled:.0%} "
            f"of it over {most_mm:.2g} mm off the scan, which stands out of it by up to {out_mm:.2g} mm. "
            "Moulds of more than two halves are not made. Fill the hollows in the program that made the "
            f"file; or {simple_body_text(request, Ellipsoid.name, (x, y, z)) or 'choose another shape'}"
        )
    deep_mm = -float(measured_distance_mm(castable.surface, np.zeros((1, 3)))[0])
    if deep_mm < _LEAST_DEEP * min(x, y, z):
        side = "below" if deep_mm > 0 else "outside"
        raise SpecError(
            f"the middle of this body's box lies {abs(deep_mm):.2g} mm {side} its surface, as of bent and "
            "thin bodies: there the core is held, and its wires leave. Straighten it; or "
            f"{simple_body_text(request, Capsule.name, (min(x, y), min(x, y), z)) or 'choose another shape'}"
        )
    text = (
        f"{why}: {target} is designed instead, a smooth body {x:.4g} × {y:.4g} × {z:.4g} mm without hollows, "
        f"whose sides are mirror images. Half of it lies within {np.median(off_mm):.2g} mm of the scan, 95 % "
        f"within {np.percentile(off_mm, 95):.2g} mm, all within {off_mm.max():.2g} mm, over hollows that are "
        f"filled; the scan stands out of it by up to {out_mm:.2g} mm"
    )
    return _request_of(request, castable.surface, target), text


def simple_body_text(request: Request, kind: str, size_mm: tuple[float, float, float]) -> str:
    """Return the options of the least body of a kind that takes all parts on all its faces, and of the least
    that does on some of them where that is smaller; empty where none fits."""
    x, y, z = (float(np.ceil(2 * edge) / 2) for edge in size_mm)
    on_some = ""
    for growth in _GROWTHS:
        least = float(np.ceil(2 * growth * min(x, y, z)) / 2)
        grown = (max(x, least), max(y, least), max(z, least))
        if not KINDS[kind].takes_size(grown):
            continue
        wanted = replace(request, kind=kind, size_mm=grown, file=(), faces=None)
        tables = next(fitting_most(wanted, SHELL_VARIANTS[-1:], COARSE), None)
        if tables is None:
            continue
        body = f"--kind {kind} --size {' '.join(f'{edge:g}' for edge in grown)}"
        faces = tables["body"].get("sensed_faces", ())
        if not faces:
            return f"{on_some}; or {body}, on all" if on_some else f"take a simple body, as {body}"
        plural = "s" * (len(faces) > 1)
        on_some = on_some or (
            f"take a simple body, as {body}, that takes parts on {len(faces)} face{plural}"
        )
    return on_some


def _request_of(request: Request, surface: trimesh.Trimesh, target: Path) -> Request:
    """Return the request for a surface, which is written to `target`."""
    with atomic_path(target) as path:
        surface.export(path, file_type="stl")
    read = body_of_file(target)
    size_mm = tuple(read["size_mm"])
    return replace(request, size_mm=size_mm, file=(("file", read["file"]), ("scale", 1.0)))


def shell_variants_of(request: Request) -> tuple[ShellVariant, ...]:
    """Shells that are tried, first the ones that give way by what the halves hook; `SHELL_VARIANTS` where
    they do not."""
    needed = _needed_mm(request)
    if needed <= SHELL_VARIANTS[-1].thickness_mm or needed > _THICKEST_MM:
        return SHELL_VARIANTS
    thick = [shell for shell in SHELL_VARIANTS if shell.thickness_mm >= needed - _EXACT_MM]
    if not thick:
        high = float(np.ceil(needed - _EXACT_MM))
        thick = [
            replace(SHELL_VARIANTS[0], thickness_mm=high, pocket_depth_mm=high - _SILICONE_BELOW_MM)
        ]
    widths = sorted({shell.pocket_diameter_mm for shell in SHELL_VARIANTS}, reverse=True)
    firm = [
        replace(shell, pocket_diameter_mm=width)
        for shell in thick
        for width in widths
        if width <= shell.pocket_diameter_mm
    ]
    return (*firm, *(shell for shell in SHELL_VARIANTS if shell not in firm))


def with_thinnest(request: Request) -> Request:
    """The same, under the thinnest of its shells that give way."""
    needed = _needed_mm(request)
    yielding = [
        shell for shell in shell_variants_of(request) if shell.thickness_mm >= needed - _EXACT_MM
    ]
    if not yielding:
        return replace(request, thinnest=SHELL_VARIANTS[-1])
    thinnest = min(yielding, key=lambda shell: (shell.thickness_mm, shell.pocket_diameter_mm))
    return replace(request, thinnest=thinnest)


def _needed_mm(request: Request) -> float:
    """Silicone that gives way by what the best seam hooks; 0 of kinds whose halves hook nothing."""
    if not KINDS[request.kind].from_file:
        return 0.0
    file, longest = dict(request.file), max(request.size_mm)
    scale = float(file.get("scale", 1.0)) * _LOOKED_AT_MM / longest
    x, y, z = (round(_LOOKED_AT_MM * edge / longest, 4) for edge in request.size_mm)
    alike = Request(
        request.kind, (x, y, z), file=tuple((file | {"scale": round(scale, 9)}).items())
    )
    return _SPARE * least_hooked_mm(alike) * longest / _LOOKED_AT_MM / COMPLIANCE_FRACTION


def least_hooked_mm(request: Request) -> float:
    """Return how deep halves hook the body at the best azimuth; the seam in y = 0, where castable bodies
    have it, is taken if it hooks next to nothing."""
    return _least_hooked_mm(request, file_digest(str(dict(request.file)["file"])))


@lru_cache(maxsize=16)
def _least_hooked_mm(request: Request, digest: str | None) -> float:
    """Return the same, kept while the file's content is."""
    tables = bare_tables(request, SHELL_VARIANTS[-1])
    across_y = undercut_depth_mm(spec_of(turned(tables, 90.0)))
    return across_y if across_y <= _NOTHING_MM else min(hooked_by_azimuth_mm(tables).values())
