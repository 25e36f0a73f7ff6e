"""Checks of casting: the mould's parts in the order in which they come off, pouring, trapped air.

The soft rule: a rigid part may drive into silicone that has room to give way, as long as the strain
of giving way stays below a share of the elongation at break. Room is what the parts that came off
before have left: the plug leaves its cavity to the wall of a one-piece mould; to a plug that is
drawn first, a closed mould leaves none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import ceil
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.body.meshes import (
    Trap,
    Undercut,
    distance_mm,
    largest_ceiling,
    least_draft_deg,
    manifold_of,
    undercut,
)
from design.build.print_settings import layer_mm
from design.fabrication.assembly import largest_common
from design.fabrication.finding import Finding, place_of, status_above
from design.layout.body import body_of
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import (
    COMPLIANCE_FRACTION,
    mould_frame,
    mould_style,
    parting,
    up,
)
from design.layout.mould.pins import Pin, least_rim_mm, loose_pins, pin_kinds
from design.layout.mould.pouring import LEAST_POUR_MM, Hole
from design.layout.surface import finished_surface, sealed_body_surface
from design.mould.flange import PLACES, flanges
from design.mould.openings import (
    air_traps,
    mould_holes,
    seal_holes,
    sealed_round,
)
from design.mould.pins import make_pin
from design.mould.plug import pour_width_mm
from design.solids.booleans import convert_to_triangles
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

CEILING_MM2 = 100.0
PEEL_SHARE = 0.33
"""Share of the elongation at break that peeling out of a mould may take: a third, an estimate."""
NEAR_MM = 0.15
"""Distance from the silicone's surface, within which a face touches it: triangles of both leave theirs by
less."""
OPEN_MM3 = 1e-3
CLOSING = ("mould_box", "mould_half_a", "mould_half_b", "mould_plug", "mould_holder")
"""Parts in the object's frame of which a mould has one each."""


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
    reason = why_no_mould(spec)
    if reason is not None:
        return [Finding("mould", "shell", 0.0, 1.0, "moulds", "fail", reason)]
    findings = [_pour(spec), *_heads(spec), *_flanges(spec)]
    if "shell" not in meshes:
        return findings
    for draw in draws(spec):
        if draw.part in meshes:
            findings += check_draw(spec, draw, meshes[draw.part], meshes["shell"])
    findings += [*check_closing(spec, meshes), *check_air(spec, meshes)]
    return [*findings, *(check_seal_mould(spec, meshes) if spec.shell.seal_layer_mm else [])]


def check_seal_mould(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """The same of the mould that a layer is poured in, where the body is no box on a plug."""
    finished, findings = finished_surface(spec), list[Finding]()
    if mould_frame(spec).opening == "open":
        box = meshes.get("mould_seal_box")
        if box is None or body_of(spec).cuboid:
            return []
        silicone = sealed_body_surface(spec)
        return [check_undercut(spec, _one_piece(spec, "mould_seal_box"), box, silicone)]
    names = ("mould_seal_half_a", "mould_seal_half_b")
    for name, sign in zip(names, (1, -1), strict=True):
        if name in meshes:
            draw = Draw(name, sign * parting(spec).normal, 0.0)
            findings.append(check_undercut(spec, draw, meshes[name], finished))
    held = tuple(pin for pin in loose_pins(spec) if pin.locator is not None)
    shut = {name: meshes[name] for name in (*names, "mould_holder", "core") if name in meshes}
    holes = seal_holes(spec)
    traps = check_traps(spec, sealed_round(spec), holes, names[0])
    return [
        *findings,
        check_shared(spec, shut, held, names[0]),
        traps,
        *check_blocked(holes, shut, "core"),
    ]


def check_closing(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """Largest common volume of two parts of the closed mould, or of one and the core in it."""
    closing = {name: mesh for name, mesh in meshes.items() if name in CLOSING}
    if mould_frame(spec).opening in ("closed", "bore") and "core" in meshes:
        closing["core"] = meshes["core"]
    pins = loose_pins(spec) if mould_style(spec) == "split" else ()
    return [check_shared(spec, closing, pins, "mould")]


def check_shared(
    spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh], pins: tuple[Pin, ...], part: str
) -> Finding:
    placed = list(meshes.items())
    if pins:
        placed += [
            (f"pin {k}", convert_to_triangles(make_pin(spec, p))) for k, p in enumerate(pins, 1)
        ]
    text = (
        "largest common volume of two parts of the closed mould, or of one and the core. Above the limit "
        "the mould does not close: move pockets apart, or choose another mould.style"
    )
    return largest_common("mould closes", part, list(combinations(placed, 2)), text)


def draws(spec: ObjectSpec) -> list[Draw]:
    """Return how the mould comes off, part by part, in this order."""
    frame, free = mould_frame(spec), float("inf")
    plug = [Draw("mould_plug", frame.out, 0.0)] if frame.plugged else []
    if mould_style(spec) == "one-piece":
        return [*plug, _one_piece(spec, "mould_box")]
    pins, normal = loose_pins(spec), parting(spec).normal
    drawn = [Draw(name, pins[first].way, 0.0) for name, first, _ in pin_kinds(pins)]
    if frame.opening == "bore":
        drawn.append(Draw("mould_holder", frame.out, 0.0))
    drawn += [Draw("mould_half_a", normal, 0.0), Draw("mould_half_b", -normal, 0.0)]
    return drawn + [replace(last, room_mm=free) for last in plug if frame.opening == "open"]


def _one_piece(spec: ObjectSpec, part: str) -> Draw:
    """Draw of a mould whose plug comes out first: the silicone can give way by half the narrower width."""
    frame = mould_frame(spec)
    return Draw(part, -frame.out, float(np.ptp(frame.plug_mm, axis=0).min()) / 2)


def check_draw(
    spec: ObjectSpec, draw: Draw, mesh: trimesh.Trimesh, shell: trimesh.Trimesh
) -> list[Finding]:
    draft = least_draft_deg(mesh, draw.pull, wetted_faces(mesh, shell))
    drafts = [] if draft is None else [draft_finding(spec, draw.part, *draft)]
    return [check_undercut(spec, draw, mesh, shell), *drafts]


def draft_finding(spec: ObjectSpec, part: str, draft_deg: float, place: np.ndarray) -> Finding:
    """Finding of the least draft of a part's walls, at a place: too little of it is a warning."""
    limit = spec.printer.preset.draft_deg
    return Finding(
        "draft",
        part,
        draft_deg,
        limit,
        "°",
        status_above(draft_deg, limit) if draft_deg >= limit else "warn",
        "least draft of a wall towards the silicone, which is that of the object's own walls. Below the "
        "limit: use release agent, draw slowly; silicone lets go, printed layers scratch it",
        place_of(place),
    )


def wetted_faces(mesh: trimesh.Trimesh, shell: trimesh.Trimesh) -> Bool[np.ndarray, "face"]:
    """Faces whose middle lies on the silicone's surface."""
    return distance_mm(shell, mesh.triangles_center) < NEAR_MM


def way_out(spec: ObjectSpec) -> str:
    if mould_style(spec) != "split":
        return "Use mould.style = 'split'"
    if body_of(spec).from_file and spec.mould.parting_azimuth_deg is None:
        return "The seam stands where least hooks. Turn the body in its file"
    return "Turn the seam (mould.parting_azimuth_deg)"


def thicker_shell(spec: ObjectSpec, depth_mm: float) -> str:
    """The shell that gives way by so much on the spot, where one twice as thick at most does."""
    thickness = ceil(10 * depth_mm / COMPLIANCE_FRACTION) / 10
    advice = f"make shell.thickness_mm {thickness:g} or more, which gives way by that, "
    return advice if thickness <= 2 * spec.shell.thickness_mm else ""


def check_undercut(
    spec: ObjectSpec, draw: Draw, mesh: trimesh.Trimesh, silicone: trimesh.Trimesh
) -> Finding:
    return undercut_finding(spec, draw, undercut(mesh, draw.pull, wetted_faces(mesh, silicone)))


def undercut_finding(spec: ObjectSpec, draw: Draw, undercut: Undercut) -> Finding:
    """Return whether silicone gives way to an undercut: it needs room, and strain that it bears."""
    strain = undercut.depth_mm / spec.shell.thickness_mm
    room = max(draw.room_mm, COMPLIANCE_FRACTION * spec.shell.thickness_mm)
    allowed = PEEL_SHARE * spec.silicone.elongation_percent / 100
    if not undercut.depth_mm:
        status, text = "pass", "no undercut along the pull"
    elif undercut.depth_mm > room:
        status = "fail"
        text = (
            f"{undercut.area_mm2:.0f} mm² of undercut; the silicone must give way by "
            f"{undercut.depth_mm:.2g} mm and has {room:.2g} mm of room. {way_out(spec)}, "
            f"{thicker_shell(spec, undercut.depth_mm)}"
            "or leave out what hooks"
        )
    else:
        status = "pass" if strain <= allowed else "fail"
        text = (
            f"{undercut.area_mm2:.0f} mm² of undercut, to be peeled: about {strain:.0%} of strain of "
            f"{allowed:.0%} allowed, and room to give way"
        )
    limit = min(room, allowed * spec.shell.thickness_mm) if undercut.depth_mm else 0.0
    place = None if undercut.place_mm is None else place_of(undercut.place_mm)
    return Finding("undercut", draw.part, undercut.depth_mm, limit, "mm", status, text, place)


def _pour(spec: ObjectSpec) -> Finding:
    frame, width = mould_frame(spec), pour_width_mm(spec)
    part = "mould_half_a" if mould_style(spec) == "split" else "mould_box"
    text = {
        "open": "width of the slots beside the plug's flange, or of the open side; they also let the air "
        "out. Below the limit: thicken the shell, or open fewer faces",
        "bore": "diameter of the holes beside the rod; they also let the air out. Below the limit: raise "
        f"mould.pour_mm to {LEAST_POUR_MM:g}",
        "closed": "diameter of the hole at the mould's upper corner. Below the limit: raise mould.pour_mm to "
        f"{LEAST_POUR_MM:g}",
    }[frame.opening]
    place = place_of(frame.rim_mm * up(spec))
    return Finding(
        "pour opening",
        part,
        width,
        LEAST_POUR_MM,
        "mm",
        status_above(width, LEAST_POUR_MM),
        text,
        place,
    )


def _heads(spec: ObjectSpec) -> list[Finding]:
    """Rims of the loose pins' heads, which rest on the mould."""
    pins = loose_pins(spec) if mould_style(spec) == "split" else ()
    if not pins:
        return []
    rim, limit = pins[0].rim_mm, least_rim_mm(spec)
    text = (
        "rim by which the pins' heads rest on the mould, narrowed where pins stand close. Below the "
        "limit pins may go in too far: move pockets apart, or use mould.style = 'one-piece'"
    )
    return [
        Finding(
            "rim of the pins' heads", "mould_pin", rim, limit, "mm", status_above(rim, limit), text
        )
    ]


def _flanges(spec: ObjectSpec) -> list[Finding]:
    """Count the bolts and dowels of a flange that find room between pins."""
    if mould_style(spec) != "split":
        return []
    count = min(len(flange.places_mm) for flange in flanges(spec))
    status = "pass" if count == len(PLACES) else "warn" if count > 1 else "fail"
    text = (
        f"dowels and bolts of a flange, by turns, which find room beside pins and holes, of {len(PLACES)}. "
        "Below the limit nothing holds or finds the halves: turn the seam (mould.parting_azimuth_deg), or "
        "move magnets away from its ends"
    )
    return [Finding("bolts of a flange", "mould_half_a", float(count), 2.0, "", status, text)]


def check_air(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """Air rises to the open side or to vents; it must not be caught on its way."""
    holes, shell = tuple(mould_holes(spec)), meshes["shell"]
    closing = {name: mesh for name, mesh in meshes.items() if name in CLOSING}
    # bubbles lower than the mould's layers are as those under a flat ceiling, which is a warning too
    film_mm = layer_mm(spec.printer, copied=True)
    findings = [check_traps(spec, shell, holes, "shell", film_mm), *check_blocked(holes, closing)]
    ceiling = largest_ceiling(shell, up(spec), mould_frame(spec).rim_mm)
    return findings if ceiling is None else [*findings, ceiling_finding(*ceiling)]


def ceiling_finding(area_mm2: float, place: np.ndarray) -> Finding:
    """Finding of the largest flat surface on which air rests, at a place."""
    return Finding(
        "flat ceilings",
        "shell",
        area_mm2,
        CEILING_MM2,
        "mm²",
        "pass" if area_mm2 <= CEILING_MM2 else "warn",
        "largest flat surface under which bubbles rest. Above the limit: fill the mould first and press "
        "the plug in tilted, or pour under vacuum",
        place_of(place),
    )


def check_traps(
    spec: ObjectSpec,
    silicone: trimesh.Trimesh,
    holes: tuple[Hole, ...],
    part: str,
    film_mm: float = 0.0,
) -> Finding:
    return traps_finding(air_traps(spec, silicone, holes), holes, part, film_mm)


def traps_finding(
    traps: Sequence[Trap], holes: tuple[Hole, ...], part: str, film_mm: float = 0.0
) -> Finding:
    """Finding of high points that neither the open side nor a vent drains; where bubbles are no higher than
    `film_mm`, a warning."""
    vents = sum(hole.use == "vent" for hole in holes)
    deepest = max(traps, key=lambda trap: trap.depth_mm, default=None)
    status, advice = "pass", "Drill one there, or turn the mould"
    if deepest is not None and deepest.depth_mm > film_mm:
        status = "fail"
    elif deepest is not None:
        status, advice = "warn", f"Bubbles are {deepest.depth_mm:.2g} mm high: pour under vacuum"
    return Finding(
        "air traps",
        part,
        float(len(traps)),
        0.0,
        "places",
        status,
        f"high points that neither the open side nor one of {vents} vents drains. {advice}",
        None if deepest is None else place_of(deepest.place_mm),
    )


def check_blocked(
    holes: tuple[Hole, ...], meshes: dict[str, trimesh.Trimesh], beside: str = ""
) -> list[Finding]:
    """Pouring holes and vents against the parts that they go through, but for one."""
    solids = {name: manifold_of(mesh) for name, mesh in meshes.items() if name != beside}
    if not holes or not solids:
        return []
    blocks = [
        (float((solid ^ manifold_of(_passage_in(hole, name).surface())).volume()), name, hole)
        for hole in holes
        for name, solid in solids.items()
    ]
    worst, part, hole = max(blocks, key=lambda block: block[0])
    limit = OPEN_MM3 + 0.01 * float(np.pi * hole.diameter_mm**2 / 4)
    return [
        Finding(
            "holes are open",
            part,
            worst,
            limit,
            "mm³",
            "pass" if worst <= limit else "fail",
            "largest volume of the mould in a hole for pouring or for air. Above the limit: turn the seam "
            "(mould.parting_azimuth_deg) or move pockets",
            place_of(hole.start_mm),
        )
    ]


def _passage_in(hole: Hole, part: str) -> Hole:
    """Return the piece of a hole that a part must leave open: a holder's rod stands in the silicone."""
    return hole.outside if part == "mould_holder" else hole
