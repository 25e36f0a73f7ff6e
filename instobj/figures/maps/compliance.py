"""Maps of compliance: all faces on one scale, with magnets and without them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from design.layout.places.contact_grid import grid_places_in_lattice
from design.spec.object import ObjectSpec
from fem.presses.compliance_map import ComplianceMap
from instobj.figures.maps.overview import FaceMap, draw_overview
from instobj.figures.maps.scale import GAIN_COLOURS, finite_limits
from instobj.store.readers import TIED_COMPLIANCE_MAP

WITH_MAGNETS = TIED_COMPLIANCE_MAP.name
WITHOUT_MAGNETS = "compliance_without_magnets.png"


def draw_compliance(
    spec: ObjectSpec,
    with_magnets: ComplianceMap,
    folder: Path,
    without_magnets: ComplianceMap | None = None,
) -> None:
    """Write `compliance.png`, and `compliance_without_magnets.png` on the same scale."""
    maps = {WITH_MAGNETS: with_magnets}
    if without_magnets is not None:
        maps[WITHOUT_MAGNETS] = without_magnets
    shown = {
        name: compliance.mm_per_n[:, grid_places_in_lattice(spec)]
        for name, compliance in maps.items()
    }
    limits = finite_limits(np.stack(list(shown.values())))
    title = f"Compliance {with_magnets.depth_mm:g} mm deep: indentation depth per newton"
    for name, values in shown.items():
        without = name == WITHOUT_MAGNETS
        what = "magnets left out (drawn where they would be)" if without else "magnets rigid"
        softest, stiffest = np.nanmax(values), np.nanmin(values)
        both = " One scale with and without magnets." if without_magnets is not None else ""
        note = (
            f"Depth over force of the {spec.indenter.kind} pressed {with_magnets.depth_mm:g} mm, "
            f"{what}. Softest {softest:.2f}, stiffest {stiffest:.2f} mm/N; E = "
            f"{spec.silicone.youngs_modulus_mpa:g} MPa, small strain.{both}"
        )
        titled = f"{title}, no magnets" if without else title
        face_map = FaceMap(titled, "mm/N", values, False, GAIN_COLOURS, limits, note)
        draw_overview(spec, face_map, folder / name)
