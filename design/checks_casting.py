"""Checks of casting: the mould's parts in the order in which they come off, pouring, trapped air.

The soft rule: a rigid part may drive into silicone that has room to give way, as long as the strain
of giving way stays below a share of the elongation at break. Room is what the parts that came off
before have left: the plug leaves its cavity to the wall of a one-piece mould; to a plug that is
drawn first, a closed mould leaves none.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.finding import Finding, at_least, place_of
from design.layouts import face_frames
from design.mesh_checks import high_points, largest_ceiling, least_draft_deg, undercut
from design.mould import has_mould, pour_width_mm
from design.pockets import shell_pockets
from design.shell import cast_envelope
from design.spec import ObjectSpec
from design.split_mould import distinct_pins, parting_normal

if TYPE_CHECKING:
    import trimesh

POUR_MM = 3.0
CEILING_MM2 = 100.0
NO_MOULD = (
    "moulds are made for boxes that are open at the bottom alone: draw one for this body from shell.step "
    "or shell.stl, or print the shell; nothing of casting was checked"
)
_UP = np.array([0.0, 0.0, -1.0])


@dataclass(frozen=True)
class Draw:
    """A part of the mould, the way it is drawn, and the room the silicone then has, mm."""

    part: str
    pull: Float[np.ndarray, "3"]
    room_mm: float


def check_casting(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """Draft and undercuts of every part that was built, the pour opening, trapped air."""
    if spec.silicone.cure == "none":
        return []
    if not has_mould(spec):
        return [Finding("mould", "shell", 0.0, 1.0, "moulds", "warn", NO_MOULD)]
    found = [_pour(spec)]
    for draw in draws(spec):
        if draw.part in meshes:
            found += _draw(spec, draw, meshes[draw.part])
    return found + (_air(spec, meshes["shell"]) if "shell" in meshes else [])


def draws(spec: ObjectSpec) -> list[Draw]:
    """How the mould comes off, part by part, in this order."""
    down = np.array([0.0, 0.0, -1.0])
    cavity = float(min(spec.core_size_mm[:2])) / 2
    if spec.mould.style == "one-piece":
        return [Draw("mould_plug", down, 0.0), Draw("mould_box", -down, cavity)]
    normal, free = parting_normal(spec), float("inf")
    return [
        *_pin_draws(spec),
        Draw("mould_half_a", normal, 0.0),
        Draw("mould_half_b", -normal, 0.0),
        Draw("mould_plug", down, free),
    ]


def _pin_draws(spec: ObjectSpec) -> list[Draw]:
    kinds = distinct_pins(spec)
    faces = zip(face_frames(spec), shell_pockets(spec), strict=True)
    ways = [frame.axes @ pocket.axis for frame, face in faces for pocket in face]
    return [
        Draw("mould_pin" if len(kinds) == 1 else f"mould_pin_{number}", ways[first], 0.0)
        for number, (first, _) in enumerate(kinds, start=1)
    ]


def _draw(spec: ObjectSpec, draw: Draw, mesh: trimesh.Trimesh) -> list[Finding]:
    against = _wetted(spec, mesh)
    found = [_undercut(spec, draw, mesh, against)]
    draft = least_draft_deg(mesh, draw.pull, against)
    if draft is not None:
        limit = spec.printer.draft_deg
        found.append(
            Finding(
                "draft",
                draw.part,
                draft[0],
                limit,
                "°",
                at_least(draft[0], limit) if draft[0] >= limit else "warn",
                "least draft of a wall towards the silicone. Below the limit: use release agent, draw "
                "slowly; silicone lets go, printed layers scratch it",
                place_of(draft[1]),
            )
        )
    return found


def _wetted(spec: ObjectSpec, mesh: trimesh.Trimesh) -> Bool[np.ndarray, "face"]:
    """Faces that lie in the silicone's box, its open side left out: they touch what is cast."""
    box, near = cast_envelope(spec).BoundingBox(), 1e-3
    low = np.array([box.xmin, box.ymin, box.zmin])
    high = np.array([box.xmax, box.ymax, box.zmax])
    centre = mesh.triangles_center
    inside = ((centre > low - near) & (centre < high + near)).all(axis=1)
    return inside & (centre[:, 2] > box.zmin + near)


def _undercut(spec: ObjectSpec, draw: Draw, mesh: trimesh.Trimesh, against: np.ndarray) -> Finding:
    found = undercut(mesh, draw.pull, against)
    strain = found.depth_mm / spec.shell.thickness_mm
    allowed = spec.silicone.peel_share * spec.silicone.elongation_percent / 100
    if not found.depth_mm:
        status, text = "pass", "no undercut along the pull"
    elif found.depth_mm > draw.room_mm:
        status = "fail"
        text = (
            f"{found.area_mm2:.0f} mm² of undercut; the silicone must give way by {found.depth_mm:.2g} mm "
            f"and has {draw.room_mm:.2g} mm of room. Use mould.style = 'split', or leave out what hooks"
        )
    else:
        status = "pass" if strain <= allowed else "fail"
        text = (
            f"{found.area_mm2:.0f} mm² of undercut, to be peeled: about {strain:.0%} of strain of "
            f"{allowed:.0%} allowed, and room to give way"
        )
    limit = min(draw.room_mm, allowed * spec.shell.thickness_mm) if found.depth_mm else 0.0
    place = None if found.place_mm is None else place_of(found.place_mm)
    return Finding("undercut", draw.part, found.depth_mm, limit, "mm", status, text, place)


def _pour(spec: ObjectSpec) -> Finding:
    width = pour_width_mm(spec)
    x, _, z = np.asarray(spec.body.size_mm) / 2
    return Finding(
        "pour opening",
        "mould_plug",
        width,
        POUR_MM,
        "mm",
        at_least(width, POUR_MM),
        "width of the two slots beside the plug's flange; they also let the air out. Below the limit: "
        "thicken the shell",
        place_of((x - width / 2, 0.0, -z)),
    )


def _air(spec: ObjectSpec, shell: trimesh.Trimesh) -> list[Finding]:
    """Air rises to the open side, −z up; it must not be caught on its way."""
    rim = spec.body.size_mm[2] / 2
    traps = high_points(shell, _UP, rim)
    ceiling = largest_ceiling(shell, _UP, rim)
    found = [
        Finding(
            "air traps",
            "shell",
            float(len(traps)),
            0.0,
            "places",
            "fail" if traps else "pass",
            "high points that the rim does not drain. Drill a vent of 1 mm there, or turn the mould",
            place_of(traps[0]) if traps else None,
        )
    ]
    if ceiling is not None:
        found.append(
            Finding(
                "flat ceilings",
                "shell",
                ceiling[0],
                CEILING_MM2,
                "mm²",
                "pass" if ceiling[0] <= CEILING_MM2 else "warn",
                "largest flat surface under which bubbles rest. Above the limit: fill the mould first "
                "and press the plug in tilted, or pour under vacuum",
                place_of(ceiling[1]),
            )
        )
    return found
