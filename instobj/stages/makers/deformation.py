"""Makers of the stages that show and correct deformation: shapes of presses, large-strain presses."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.files import atomic_path
from design.spec.object import ObjectSpec
from instobj.store.readers import CORRECTION, LARGE_STRAIN, MESH, RESPONSE, SECTION

if TYPE_CHECKING:
    from fem.large_strain.results import LargeStrainPress
    from fem.presses.results import MagnetMotions, PressForces
    from instobj.store.stage import StageContext

_SHOWN_DEPTH_MM = 2.0
"""Depth of the press that is shown, at most."""
_APART_MM = 1.0
"""Distance of the places that are shown, at least."""


def make_shapes(context: StageContext, folder: Path) -> None:
    """Shapes of two presses of the table, at the centre and at the edge of the first face.

    A shell that slides on its core has none: the stage is then empty.
    """
    from design.layout.body import face_frames
    from design.layout.places.contact_places import outermost_mm
    from fem.presses.shape import save_deformed_shape, table_shapes
    from instobj.figures.section import SectionPanel, draw_sections

    spec, response = context.spec, context.read(RESPONSE)
    if response.core is not None:
        return
    context.step("shapes under two presses")
    places = [(0.0, 0.0), (float(outermost_mm(spec)[0]), 0.0)]
    depth = min(_SHOWN_DEPTH_MM, spec.press.depths_mm[-1])
    mesh = context.read(MESH)
    shapes = table_shapes(spec, mesh, response, 0, np.array(places), depth, context.call.factored)
    context.call.end()
    frame = face_frames(spec)[0]
    panels = []
    for (x, y), shape in zip(places, shapes, strict=True):
        name = f"face_{frame.number}_{x:g}_{y:g}"
        save_deformed_shape(shape, folder / "shapes" / f"{name}.vtu")
        title = f"Face {frame.number}, ({x:g}, {y:g}) mm, {depth:g} mm deep, small strain"
        plane_mm = frame.to_plane(np.array([x, y]))
        panels.append(
            SectionPanel(
                title,
                shape,
                frame.tangent(plane_mm),
                (plane_mm[0], plane_mm[1]),
                depth,
                tip_radius_mm(spec),
            )
        )
    draw_sections(panels, SECTION.path(folder))


def make_large_strain(context: StageContext, folder: Path) -> None:
    """Press a few places of the first face with large deformation and fit the correction.

    Nothing is made where `mechanics.correction` is "none". A press that diverges counts with the
    depths that it reached.
    """
    spec = context.spec
    content: dict[str, Any] = {"correction": None, "presses": []}
    if spec.mechanics.correction == "large-strain":
        content = _presses_and_fit(context)
    with atomic_path(LARGE_STRAIN.path(folder)) as temporary:
        temporary.write_text(json.dumps(content, indent=1), encoding="utf-8")


def correct_table(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, folder: Path
) -> tuple[PressForces, MagnetMotions]:
    """The table corrected by what `make_large_strain` left in its folder; unchanged without."""
    from fem.large_strain.correction import corrected_table

    correction = CORRECTION.read(folder)
    if correction is None:
        return forces, motions
    return corrected_table(spec, forces, motions, correction)


def correction_places_mm(spec: ObjectSpec) -> list[tuple[float, float]]:
    """Centre, middle of an edge, corner, over the outermost magnet, on the way there, off centre.

    All within the contact grid, and the whole tip on a flat face: a press with large deformation
    does not hang over. Places less than 1 mm from an earlier one are left out.
    """
    from design.layout.body import face_frames
    from design.layout.places.contact_places import outermost_mm
    from design.layout.pockets import magnet_places
    from design.layout.tips import footprint_mm

    frame, reach = face_frames(spec)[0], outermost_mm(spec)
    if frame.flat:
        room = frame.half_extents_mm - abs(footprint_mm(spec.indenter)).max(axis=0)
        if frame.round:  # a corner of the rectangle of places lies on the circle
            room = room / np.sqrt(2)
        reach = np.minimum(reach, room)
    outer = max(magnet_places(spec)[0], key=lambda place: float(np.hypot(*place)))
    magnet = np.clip(outer, -reach, reach)
    wanted = (0 * reach, reach * [1, 0], reach, magnet, magnet / 2, reach * [0.4, 0])
    places: list[np.ndarray] = []
    for place in wanted:
        if all(np.hypot(*(place - earlier)) >= _APART_MM for earlier in places):
            places.append(place)
    return [(round(float(x), 4), round(float(y), 4)) for x, y in places]


def tip_radius_mm(spec: ObjectSpec) -> float | None:
    """Radius of a tip that is a sphere in section, else None."""
    return spec.indenter.radius_mm if spec.indenter.kind == "hemisphere" else None


def _presses_and_fit(context: StageContext) -> dict[str, Any]:
    from dataclasses import asdict

    from fem.large_strain.correction import fit_correction, leave_one_out, press_pair

    spec = context.spec
    presses = [_press(context, place) for place in correction_places_mm(spec)]
    pairs = [press_pair(spec, press) for press in presses]
    thickness = spec.shell.thickness_mm
    return {
        "correction": asdict(fit_correction(pairs, thickness)),
        "error": asdict(leave_one_out(pairs, thickness)),
        "presses": [_row(press) for press in presses],
    }


def _press(context: StageContext, place: tuple[float, float]) -> LargeStrainPress:
    """One press on a mesh of its own, fine at the contact."""
    from fem.large_strain.hyperelastic import neo_hookean
    from fem.large_strain.press import press_large_strain
    from fem.mesh.tetrahedra import tetrahedralize_for_press

    spec, face = context.spec, 1
    where = f"location ({place[0]:g}, {place[1]:g}) mm"
    context.step(f"{where}: mesh")
    mesh = tetrahedralize_for_press(spec, face, *place)
    silicone = spec.silicone
    material = neo_hookean(silicone.youngs_modulus_mpa, silicone.poisson_ratio)
    return press_large_strain(
        spec,
        mesh,
        face,
        *place,
        spec.press.depths_mm,
        material,
        lambda text: context.step(f"{where}: {text}"),
    )


def _row(press: LargeStrainPress) -> dict[str, Any]:
    from fem.large_strain.results import linearity_limits

    limits = linearity_limits(press)
    return {
        "x_mm": press.x_mm,
        "y_mm": press.y_mm,
        "status": press.status,
        "converged_depth_mm": press.converged_depth_mm,
        "five_percent_mm": limits.five_percent_mm,
        "twenty_percent_mm": limits.twenty_percent_mm,
        "depth_mm": press.depth_mm.tolist(),
        "force_n": press.force_n.tolist(),
        "linear_force_n": press.linear_force_n.tolist(),
    }
