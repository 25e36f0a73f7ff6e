"""The shell as silicone throughout: one mesh and one response that no magnet layout changes."""

from __future__ import annotations

from design.spec.object import ObjectSpec
from fem.mesh.tetrahedra import TetMesh, tetrahedralize


def without_magnets(spec: ObjectSpec) -> ObjectSpec:
    """The same object for mechanics on a magnet-free mesh: no tie, no stiffness of magnets.

    `fem.linear.response` then gives the surface compliance alone, with no magnet among its loads.
    """
    mechanics = spec.mechanics.model_copy(update={"magnets": "points"})
    return spec.model_copy(update={"mechanics": mechanics})


def magnet_free_mesh(spec: ObjectSpec) -> TetMesh:
    """Tetrahedra of the sealed body without magnets, edges as for the mesh with them.

    Raises
    ------
    InputError
        The mesher fails.
    """
    return tetrahedralize(spec, magnets=False)
