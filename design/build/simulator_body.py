"""Content of files for physics simulators: an object's mass, surfaces, frames and contacts."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.body.triangles import block_surface
from design.build.convex_pieces import ConvexPieces, convex_pieces
from design.build.masses import Mass
from design.build.scene import magnet_halves
from design.layout.boards import board_blocks
from design.layout.body import body_of
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

_ROUNDING_MM = 1e-3
"""Distance by which corners of an STL file may lie off their plane: it holds single precision."""
Frames = dict[str, tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]]
"""Origin (mm) and axes (columns) by name."""


@dataclass(frozen=True)
class ContactSpring:
    """Spring and damper of one contact point: stiffness with its range, damping, and friction.

    Attributes
    ----------
    n_per_mm, lowest_n_per_mm, highest_n_per_mm : stiffness of the indenter's tip
    n_s_per_mm : damping
    friction : coefficient
    source : of the stiffness, in words
    """

    n_per_mm: float
    lowest_n_per_mm: float
    highest_n_per_mm: float
    n_s_per_mm: float
    friction: float
    source: str


@dataclass(frozen=True)
class SimulatorBody:
    """All that files for simulators hold of one object.

    Attributes
    ----------
    name : of letters, digits and underscores alone, as USD takes it
    visual : surfaces by the name of their part, mm
    collision : convex pieces of the outer surface, and the base that it stands on
    frames : chips' sensing points with the chips' axes; magnets with the polarization along z
    """

    name: str
    mass: Mass
    visual: dict[str, trimesh.Trimesh]
    collision: ConvexPieces
    frames: Frames
    contact: ContactSpring

    @property
    def comment(self) -> str:
        """Return what a reader of a file should know, for its head."""
        spring = self.contact
        return (
            f"Lengths in m. A contact point has {spring.n_per_mm:.3g} N/mm "
            f"({spring.lowest_n_per_mm:.3g} to {spring.highest_n_per_mm:.3g}), {spring.source}. "
            f"Collision meshes reach {self.collision.error_mm:.2g} mm beyond the surface at most."
        )

    @property
    def meshes(self) -> dict[str, trimesh.Trimesh]:
        """Return all surfaces by the name of their file."""
        pieces = {f"collision_{k}": piece for k, piece in enumerate(self.collision.pieces, 1)}
        return self.visual | pieces


def frames_of(spec: ObjectSpec) -> Frames:
    """Return the frames of all chips and magnets."""
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    chips = zip(sensors.position_mm, sensors.axes.swapaxes(1, 2), strict=True)
    bodies = zip(magnets.centre_mm, magnets.frames, strict=True)
    named = {f"sensor_{k}": (place, axes) for k, (place, axes) in enumerate(chips, 1)}
    return named | {f"magnet_{k}": (place, axes) for k, (place, axes) in enumerate(bodies, 1)}


def visual_surfaces(
    spec: ObjectSpec, core: trimesh.Trimesh, shell: trimesh.Trimesh
) -> dict[str, trimesh.Trimesh]:
    """Return surfaces of core, shell, all magnets and all boards, mm."""
    import trimesh

    halves = [half for pair in magnet_halves(spec, magnet_layout(spec)) for half in pair]
    boards = [block_surface(board) for board in board_blocks(spec)]
    joined: list[Any] = [trimesh.util.concatenate(surfaces) for surfaces in (halves, boards)]
    return {"core": core, "shell": shell, "magnets": joined[0], "boards": joined[1]}


def collision_pieces(
    spec: ObjectSpec, core: trimesh.Trimesh, tolerance_mm: float, most: int
) -> ConvexPieces:
    """Return convex pieces of all that can be touched: the outer surface, and a base under it.

    Holes for wires are closed.
    """
    import trimesh

    body = body_of(spec)
    outside = convex_pieces(body.outer_surface(), tolerance_mm, most)
    if not body.on_base:
        return outside
    # the silicone begins at the base's top
    below = core.vertices[:, 2] <= body.corners_mm[0][2] + _ROUNDING_MM
    base = trimesh.convex.convex_hull(core.vertices[below])
    return replace(outside, pieces=(*outside.pieces, base))
