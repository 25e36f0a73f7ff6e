"""Mass, centre and inertia of an object: core, silicone, magnets and sensor boards.

Wires are left out. Prints count as solid, and pockets as filled round their magnets.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from design.body.meshes import boolean_of
from design.body.triangles import block_surface
from design.build.parts import parts_of
from design.errors import NotOneSolid
from design.layout.blocks import core_keys, relief_slits
from design.layout.boards import board_blocks
from design.layout.body import body_of
from design.layout.places.positions import magnet_layout, shell_body_layout
from design.solids.body import outer_solid
from design.solids.booleans import Shape, cut
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM
from design.solids.shell import cavity, slit_fins
from design.spec.magnets import MagnetSize
from design.spec.object import ObjectSpec

MAGNET_G_PER_CM3 = 7.5
"""Sintered NdFeB (Arnold Magnetic Technologies, data sheets of N35 to N52: 7.5)."""
BOARD_G_PER_CM3 = 1.85
"""FR-4 laminate (Isola, data sheet of 370HR: 1.8 to 1.9); a chip's package is as heavy within 10 %."""
_G_PER_MM3 = 1e-3
"""Grams in a mm³ at a density of 1 g/cm³."""


@dataclass(frozen=True)
class Mass:
    """Mass (g), centre (mm) and inertia about that centre (g mm²), along the object's axes."""

    mass_g: float
    centre_mm: Float[np.ndarray, "3"]
    inertia_g_mm2: Float[np.ndarray, "3 3"]

    def scaled(self, factor: float) -> Mass:
        """Return the same body of another density; a negative one takes it out of another body."""
        return Mass(factor * self.mass_g, self.centre_mm, factor * self.inertia_g_mm2)


def masses_of(spec: ObjectSpec) -> dict[str, Mass]:
    """Return the mass of each kind of part: core, shell, magnets and boards."""
    printed = spec.printer.preset.density_g_per_cm3
    silicone = spec.silicone.density_g_per_cm3
    core = next(part for part in parts_of(spec) if part.name == "core")
    magnets = _magnets(spec)
    boards = [
        _placed(_block(2 * board.half_mm), board.centre_mm, board.axes)
        for board in board_blocks(spec)
    ]
    embedded = magnets if spec.arrangement == "sensors-in-core" else boards
    shell = [solid_mass(_sealed_shell(spec), silicone)]
    # what lies in the silicone displaces it: as much as the body's own volume, of its density
    shell += [
        body.scaled(-silicone * volume * _G_PER_MM3 / body.mass_g)
        for body, volume in zip(embedded, shell_body_layout(spec).volume_mm3, strict=True)
    ]
    return {
        "core": solid_mass(core.make(), printed),
        "shell": total(shell),
        "magnets": total([magnet.scaled(MAGNET_G_PER_CM3) for magnet in magnets]),
        "boards": total([board.scaled(BOARD_G_PER_CM3) for board in boards]),
    }


def mass_text(spec: ObjectSpec) -> str:
    """Return the mass of the whole object, of its parts, and its centre, or why they are unknown."""
    try:
        masses = masses_of(spec)
    except NotOneSolid as error:
        return f"mass is unknown: {error}"
    whole = total(masses.values())
    parts = ", ".join(f"{part} {mass.mass_g:.1f}" for part, mass in masses.items())
    # a centre at −0.04 is one at 0
    centre = ", ".join(f"{round(x, 1) + 0.0:.1f}" for x in whole.centre_mm.tolist())
    return f"{whole.mass_g:.1f} g without wires ({parts}), centre of mass at ({centre}) mm"


def total(masses: Iterable[Mass]) -> Mass:
    """Return several bodies as one, by the parallel axis theorem."""
    bodies = list(masses)
    mass = sum(body.mass_g for body in bodies)
    centre = sum((body.mass_g * body.centre_mm for body in bodies), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for body in bodies:
        away = body.centre_mm - centre
        # Steiner: I + m (|d|² 1 − d dᵀ) about a point at −d from the body's centre
        moved = away @ away * np.eye(3) - np.outer(away, away)
        inertia += body.inertia_g_mm2 + body.mass_g * moved
    return Mass(float(mass), centre, inertia)


def solid_mass(solid: Shape, density_g_per_cm3: float) -> Mass:
    """Return the mass of a homogeneous solid or closed surface in mm."""
    factor = density_g_per_cm3 * _G_PER_MM3
    if isinstance(solid, cq.Shape):
        inertia = np.array(cq.Shape.matrixOfInertia(solid))
        centre = np.array(solid.Center().toTuple())
        return Mass(factor * solid.Volume(), centre, factor * inertia)
    figures: Any = solid.mass_properties
    inertia = np.asarray(figures.inertia, float)
    centre = np.asarray(figures.center_mass, float)
    return Mass(factor * float(figures.volume), centre, factor * inertia)


def _sealed_shell(spec: ObjectSpec) -> Shape:
    """Return the silicone with its pockets filled, bodies in it included."""
    if not body_of(spec).sampled:
        return cut(outer_solid(spec), *cavity(spec, OVERSHOOT_MM), *slit_fins(spec))
    removed = [block_surface(block) for block in (*core_keys(spec), *relief_slits(spec))]
    room = body_of(spec).cavity_surface()
    removed += [] if room is None else [room]
    return boolean_of("difference", [body_of(spec).outer_surface(), *removed])


def _magnets(spec: ObjectSpec) -> list[Mass]:
    """Return every magnet at a density of 1 g/cm³."""
    layout, sizes = magnet_layout(spec), spec.magnets.distinct_sizes
    return [
        _placed(_magnet(sizes[number]), centre, axes)
        for centre, axes, number in zip(layout.centre_mm, layout.frames, layout.size, strict=True)
    ]


def _magnet(size: MagnetSize) -> Mass:
    """Return a magnet at the origin, its height along z, at 1 g/cm³."""
    if size.shape == "block":
        return _block(np.array([*size.edges_mm, size.height_mm]))
    hollow = size.inner_diameter_mm if size.shape == "ring" else 0.0
    squares = (size.diameter_mm**2 + hollow**2) / 4
    mass = _G_PER_MM3 * np.pi / 4 * (size.diameter_mm**2 - hollow**2) * size.height_mm
    # hollow cylinder: m (R² + r²) / 2 about its axis, m (3 (R² + r²) + h²) / 12 across it
    across = (3 * squares + size.height_mm**2) / 12
    return Mass(float(mass), np.zeros(3), mass * np.diag([across, across, squares / 2]))


def _block(edges_mm: Float[np.ndarray, "3"]) -> Mass:
    mass, squares = _G_PER_MM3 * np.prod(edges_mm), np.square(edges_mm)
    # box: m (b² + c²) / 12 about the axis along a
    inertia = mass * np.diag(squares.sum() - squares) / 12
    return Mass(float(mass), np.zeros(3), inertia)


def _placed(body: Mass, centre_mm: Float[np.ndarray, "3"], axes: Float[np.ndarray, "3 3"]) -> Mass:
    return Mass(body.mass_g, np.asarray(centre_mm, float), axes @ body.inertia_g_mm2 @ axes.T)
