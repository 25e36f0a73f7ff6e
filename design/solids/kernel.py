"""CadQuery, imported without what it loads and nothing here asks for: a quarter of its time.

`from design.solids.kernel import cq`. Of VTK it takes the modules that it uses itself, and its kernel
all 150 once more; CasADi solves for assemblies. Both come when they are asked for.
"""

from __future__ import annotations

from design.imports import deferred

with deferred("vtk", "casadi"):
    import cadquery as cq  # noqa: F401
