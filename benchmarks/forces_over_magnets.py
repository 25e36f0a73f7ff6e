"""Forces of a sphere over and beside magnets by an independent code: NGSolve and Netgen's own geometry.

    python benchmarks/forces_over_magnets.py cube 0 --edge 0.45 --order 3

Half a cube, ball or capsule of the examples, cut at y = 0; the sphere of R 5 mm lands at (x, 0) of a face.
Taylor–Hood elements, curved; magnets are 3000 times as stiff as silicone. Pressure is P1 on the surface,
not negative, without friction, and gaps are weak: one factorization, then non-negative least squares.
Nothing is shared with `fem`. Needs `pip install ngsolve scipy`; 10 s to 10 min, by edge and order.
`tests/fem/contact/test_forces_over_magnets.py` holds what it gave.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
from scipy.optimize import nnls

E_MPA, NU, TIP_MM, SHELL_MM = 0.414, 0.4999, 5.0, 8.0
REACH_MM, STIFFER = 3.7, 3e3
PLACES_MM = {"cube": (0.0, 3.0, 5.0), "ball": (0.0, 3.0, 4.5), "capsule": (0.0, 3.0, 5.0)}
BULK_MM, RIM_MM = 3.0, 0.45
RADIUS_MM, HALF_LENGTH_MM = {"ball": 25.0, "capsule": 22.0}, 16.0
"""Radii of the round bodies; half the straight part of the capsule."""


@dataclass(frozen=True)
class Body:
    """Silicone and magnets about the face's middle, z outward; how far z reaches down."""

    shell: Any
    magnets: list[Any]


def body(kind: str) -> Body:
    """Upper part of an example's shell; it ends 16 mm or more beside the press, free."""
    occ: Any = import_module("netgen.occ")
    point, z = occ.Pnt, occ.Z
    half = occ.Box(point(-60, 0, -60), point(60, 60, 60))
    disk = occ.Cylinder(point(0, 0, -3), z, 3, 1)
    if kind == "cube":
        shell = occ.Box(point(-21, 0, -20), point(21, 21, 0)) - occ.Box(
            point(-13, 0, -20), point(13, 13, -8)
        )
        at = [(0, 0), (10, 10), (-10, 10)]
        return Body(shell, [disk.Move(occ.Vec(a, b, 0)) * half for a, b in at])
    radius = RADIUS_MM[kind]
    half = half * occ.Box(point(-60, 0, -radius - 2), point(60, 60, 60))
    if kind == "ball":
        centre = point(0, 0, -radius)
        shell = occ.Sphere(centre, radius) * half - occ.Sphere(centre, radius - SHELL_MM)
        turns = [occ.Axis(centre, occ.Y)] * 3
        angles = np.degrees(np.array([0.0, 9.0, -9.0]) / radius)
        discs = [disk.Rotate(t, a) * half for t, a in zip(turns, angles, strict=True)]
        return Body(shell, discs)

    def capsule(r: float) -> Any:
        ends = [point(s * HALF_LENGTH_MM, 0, -radius) for s in (-1, 1)]
        side = occ.Cylinder(ends[0], occ.X, r, 2 * HALF_LENGTH_MM)
        return side + occ.Sphere(ends[0], r) + occ.Sphere(ends[1], r)

    shell = capsule(radius) * half - capsule(radius - SHELL_MM)
    return Body(shell, [disk.Move(occ.Vec(a, 0, 0)) * half for a in (0, 10, -10)])


def mesh_of(kind: str, x_mm: float, edge_mm: float) -> Any:
    """Curved mesh with the place pressed at the origin; boundaries named top, held, cut."""
    occ: Any = import_module("netgen.occ")
    netgen: Any = import_module("netgen.meshing")
    made = body(kind)
    shell = made.shell
    for magnet in made.magnets:
        shell = shell - magnet
    if kind == "ball":
        middle = occ.Axis(occ.Pnt(0, 0, -RADIUS_MM[kind]), occ.Y)
        turn = -float(np.degrees(x_mm / RADIUS_MM[kind]))
        shell, *magnets = (s.Rotate(middle, turn) for s in (shell, *made.magnets))
    else:
        shell, *magnets = (s.Move(occ.Vec(-x_mm, 0, 0)) for s in (shell, *made.magnets))
    shell.mat("silicone")
    for magnet in magnets:
        magnet.mat("magnet")
        for rim in magnet.edges:
            rim.maxh = RIM_MM
    wanted = netgen.MeshingParameters(maxh=BULK_MM, grading=0.35)
    for r in (0.0, 1.2, 2.4, 3.2):
        for angle in np.linspace(0, np.pi, max(2, int(4 * r) + 2)):
            at = (r * np.cos(angle), r * np.sin(angle), -0.02)
            wanted.RestrictH(x=at[0], y=at[1], z=at[2], h=edge_mm * (1.3 if r > 3 else 1.0))
    mesh = occ.OCCGeometry(occ.Glue([shell, *magnets])).GenerateMesh(wanted)
    points = np.array([p.p for p in mesh.Points()])
    of_face: dict[int, list[int]] = {}
    for element in mesh.Elements2D():
        of_face.setdefault(element.index, []).extend(v.nr - 1 for v in element.vertices)
    for index, vertices in of_face.items():
        mesh.SetBCName(index - 1, _name(kind, points[vertices], x_mm))
    curved = import_module("ngsolve").Mesh(mesh)
    curved.Curve(3)
    return curved


def _name(kind: str, points: np.ndarray, x_mm: float) -> str:
    """By the distance of a face's vertices from the outer surface, 0 or one shell."""
    x, y, z = points.T
    if abs(y).max() < 1e-6:
        return "cut"
    if kind == "cube":
        inside = np.maximum(abs(x + x_mm), y)
        core = abs(np.maximum(inside - 13, z + 8)).max() < 1e-6
        return "top" if abs(z).max() < 1e-6 else "held" if core else "free"
    along = x - np.clip(x, -HALF_LENGTH_MM - x_mm, HALF_LENGTH_MM - x_mm) * (kind == "capsule")
    depth = RADIUS_MM[kind] - np.sqrt(along**2 + y**2 + (z + RADIUS_MM[kind]) ** 2)
    close = [abs(depth).max() < 1e-3, abs(depth - SHELL_MM).max() < 1e-3]
    return "top" if close[0] else "held" if close[1] else "free"


def forces_n(mesh: Any, depths_mm: np.ndarray, order: int) -> np.ndarray:
    """Force of the sphere at each depth; both halves."""
    ng: Any = import_module("ngsolve")
    mu, lam = E_MPA / 2 / (1 + NU), E_MPA * NU / (1 + NU) / (1 - 2 * NU)
    stiff = mesh.MaterialCF({"magnet": STIFFER}, default=1.0)
    space = ng.VectorH1(mesh, order=order, dirichlet="held", dirichlety="cut") * ng.H1(
        mesh, order=order - 1
    )
    (u, p), (v, q) = space.TnT()
    strain = ng.InnerProduct(ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v)))
    matrix = ng.BilinearForm(space, symmetric=True)
    matrix += (
        2 * mu * stiff * strain - p * ng.div(v) - q * ng.div(u) - p * q / (lam * stiff)
    ) * ng.dx
    inverse = matrix.Assemble().mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    normal, top = ng.specialcf.normal(3), ng.ds("top", bonus_intorder=2)
    hats = ng.H1(mesh, order=1, definedon=mesh.Boundaries("top"))
    pressure, test = hats.TnT()
    load = ng.BilinearForm(trialspace=hats, testspace=space)
    load += -pressure * (v * normal) * top
    load = load.Assemble().mat
    points = np.array([mesh.vertices[k].point for k in range(mesh.nv)])
    on_top = np.array([hats.FreeDofs()[k] for k in range(mesh.nv)])
    near = (np.hypot(*points[:, :2].T) < REACH_MM) & (points[:, 2] > -SHELL_MM / 2)
    (chosen,) = np.nonzero(on_top & near)
    unit, given, moved = ng.GridFunction(hats), *(space_vector(ng, space) for _ in range(2))
    answer, compliance = unit.vec.CreateVector(), np.zeros((len(chosen),) * 2)
    for column, vertex in enumerate(chosen.tolist()):
        unit.vec[:] = 0
        unit.vec[vertex] = 1.0
        given.data = load * unit.vec
        moved.data = inverse * given
        answer.data = load.T * moved
        compliance[:, column] = answer.FV().NumPy()[chosen]

    def moments(value: Any) -> np.ndarray:
        form = ng.LinearForm(hats)
        form += value * test * ng.ds("top", bonus_intorder=6)
        return form.Assemble().vec.FV().NumPy()[chosen].copy()

    # along the surface's normal a gap along z is shorter by the normal's z
    square = TIP_MM**2 - ng.x**2 - ng.y**2
    gap = TIP_MM - ng.sqrt(ng.IfPos(square, square, 0)) - ng.z
    upright, lifted = moments(normal[2]), moments(gap * normal[2])
    lower = np.linalg.cholesky((compliance + compliance.T) / 2)
    pressures = [
        nnls(lower.T, np.linalg.solve(lower, depth * upright - lifted), maxiter=20000)[0]
        for depth in depths_mm
    ]
    return np.array([2 * one @ upright for one in pressures])


def space_vector(ng: Any, space: Any) -> Any:
    """A vector of a space's unknowns."""
    return ng.GridFunction(space).vec.CreateVector()


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kind", choices=tuple(PLACES_MM))
    parser.add_argument("x_mm", type=float, nargs="?", help="left out: three places")
    parser.add_argument("--edge", type=float, default=0.35, help="under the tip, mm")
    parser.add_argument("--order", type=int, default=2, help="of displacements")
    options = parser.parse_args()
    try:
        import_module("ngsolve").SetNumThreads(1)
    except ImportError:
        parser.exit(2, "NGSolve is not installed: pip install ngsolve\n")
    depths = np.array([0.5, 1.0, 2.0])
    for x in PLACES_MM[options.kind] if options.x_mm is None else (options.x_mm,):
        found = forces_n(mesh_of(options.kind, x, options.edge), depths, options.order)
        told = ", ".join(f"{d:g} mm: {f:.3f} N" for d, f in zip(depths, found, strict=True))
        print(f"{options.kind} at x = {x:g} mm: {told}", flush=True)


if __name__ == "__main__":
    main()
