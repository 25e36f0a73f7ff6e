"""Forces and magnets' motions at borders, corners and over edges of the paper's cube, by NGSolve.

    python benchmarks/forces_over_edges.py 21 0 --edge 0.55
    python benchmarks/forces_over_edges.py 21 0 --lean 45 --edge 0.6 --sphere

The sphere of R 5 mm lands at (x, y) of the top face, its way leaning outwards by `--lean` degrees. Shell with
the magnets of the top and of the side +x; Taylor–Hood elements, magnets 3000 times as stiff. Tractions of hat
functions in all three directions are condensed on every face under the tip; contact is then the same as in
`fem` (pressure and gap along the way) or, with `--sphere`, that of the sphere itself: pressure along its
normals and gaps to it where the surface has moved to. Nothing is shared with `fem`. Needs `pip install
ngsolve scipy`; 1 to 5 min. `tests/fem/contact/test_forces_over_edges.py` holds what it gave.
"""

from __future__ import annotations

import argparse
from importlib import import_module
from typing import Any

import numpy as np
from ngsolve_shell import shell_system
from scipy.optimize import nnls

E_MPA, NU, TIP_MM, HALF_MM, SHELL_MM = 0.414, 0.4999, 5.0, 21.0, 8.0
TOP_MM = [(0, 0), (10, 10), (10, -10), (-10, 10), (-10, -10)]
SIDE_MM = [(10, -11), (-10, -11), (0, -21), (10, -31), (-10, -31)]
BULK_MM, RIM_MM, LOW_MM = 4.0, 1.0, 36.0
NEVER_MM, NEAR_MM = 10.0, 0.6
DEPTHS_MM = (0.5, 1.0, 2.0, 3.0)


def mesh_of(x_mm: float, y_mm: float, edge_mm: float, reach_mm: float) -> tuple[Any, int]:
    """Shell with the place at the origin, faces named; number of magnets. A place at y = 0 has half of it."""
    occ, netgen = import_module("netgen.occ"), import_module("netgen.meshing")
    point, inner = occ.Pnt, HALF_MM - SHELL_MM
    shell = occ.Box(point(-HALF_MM, -HALF_MM, -LOW_MM), point(HALF_MM, HALF_MM, 0))
    shell -= occ.Box(point(-inner, -inner, -LOW_MM), point(inner, inner, -SHELL_MM))
    magnets = [occ.Cylinder(point(x, y, -3), occ.Z, 3, 1) for x, y in TOP_MM]
    magnets += [occ.Cylinder(point(HALF_MM - 3, y, z), occ.X, 3, 1) for y, z in SIDE_MM]
    if y_mm == 0:
        half = occ.Box(point(-60, 0, -60), point(60, 60, 60))
        centres = [y for _, y in TOP_MM] + [y for y, _ in SIDE_MM]
        magnets = [m * half for m, y in zip(magnets, centres, strict=True) if y >= 0]
        shell = shell * half
    for index, magnet in enumerate(magnets):
        shell = shell - magnet
        magnet.mat(f"magnet{index}")
        for rim in magnet.edges:
            rim.maxh = RIM_MM
    shell.mat("silicone")
    wanted = netgen.MeshingParameters(maxh=BULK_MM, grading=0.35)
    steps = np.arange(-reach_mm + 0.25, reach_mm, 0.5)
    for x, y, z in np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3):
        inside = max(x + x_mm, y + y_mm) < HALF_MM and z < 0
        at_face = min(HALF_MM - x - x_mm, HALF_MM - y - y_mm, -z) < 0.5
        if inside and at_face and np.linalg.norm([x, y, z]) < reach_mm:
            wanted.RestrictH(x=x + x_mm, y=y + y_mm, z=z, h=edge_mm)
    mesh = occ.OCCGeometry(occ.Glue([shell, *magnets])).GenerateMesh(wanted)
    points = np.array([p.p for p in mesh.Points()])
    vertices: dict[int, list[int]] = {}
    for element in mesh.Elements2D():
        vertices.setdefault(element.index, []).extend(v.nr - 1 for v in element.vertices)
    for index, own in vertices.items():
        mesh.SetBCName(index - 1, _name(points[own], y_mm == 0))
    return import_module("ngsolve").Mesh(mesh), len(magnets)


def _name(points: np.ndarray, half: bool) -> str:
    x, y, z = points.T
    inner = HALF_MM - SHELL_MM
    if half and abs(y).max() < 1e-6:
        return "cut"
    for name, away in (("top", z), ("side", x - HALF_MM), ("end", y - HALF_MM)):
        if abs(away).max() < 1e-6:
            return name
    core = np.maximum(np.maximum(abs(x), abs(y)) - inner, z + SHELL_MM)
    return "held" if abs(core).max() < 0.1 else "free"


class Condensed:
    """Compliance of hat tractions (direction, hat) near a place, and magnets' mean displacements."""

    def __init__(self, mesh: Any, magnets: int, place: np.ndarray, reach_mm: float, half: bool):
        ng: Any = import_module("ngsolve")
        held = "cut" if half else ""
        space, v, inverse, means = shell_system(mesh, magnets, E_MPA, NU, held)
        points = np.array([mesh.vertices[k].point for k in range(mesh.nv)])
        near = np.linalg.norm(points - place, axis=1) < reach_mm
        loads, weights, centres = [], [], []
        for name in ("top", "side", "end"):
            hats = ng.H1(mesh, order=1, definedon=mesh.Boundaries(name))
            chosen = np.nonzero(near & np.array([hats.FreeDofs()[k] for k in range(mesh.nv)]))[0]
            trial, test = hats.TnT()
            moments = []
            for value in (ng.CF(1.0), ng.x, ng.y, ng.z):
                form = ng.LinearForm(hats)
                form += value * test * ng.ds(name)
                moments.append(form.Assemble().vec.FV().NumPy()[chosen].copy())
            weights.append(moments[0])
            centres.append(np.transpose(moments[1:]) / moments[0][:, None])
            for k in range(3):
                load = ng.BilinearForm(trialspace=hats, testspace=space)
                load += trial * v[k] * ng.ds(name)
                loads.append((k, hats, load.Assemble().mat, chosen))
        self.weight, self.centre_mm = np.concatenate(weights), np.concatenate(centres)
        loads.sort(key=lambda load: load[0])  # directions first, as columns are counted
        given, moved = ng.GridFunction(space).vec, ng.GridFunction(space).vec
        compliance, motion = [], []
        for _, hats, load, chosen in loads:
            unit = ng.GridFunction(hats).vec
            for vertex in chosen.tolist():
                unit[:] = 0
                unit[vertex] = 1.0
                given.data = load * unit
                moved.data = inverse * given
                motion.append(np.array(means) @ moved.FV().NumPy())
                column = []
                for _, other, answer, rows in loads:
                    work = ng.GridFunction(other).vec
                    work.data = answer.T * moved
                    column.append(work.FV().NumPy()[rows].copy())
                compliance.append(np.concatenate(column))
        matrix = np.array(compliance)
        self.compliance, self.motion = (matrix + matrix.T) / 2, np.array(motion).T

    def pressed(self, ways: np.ndarray, gap_mm: np.ndarray) -> np.ndarray:
        """Tractions (direction · hat) along each hat's way (hat, 3) that are complementary to its gap."""
        (near,) = np.nonzero(gap_mm < NEAR_MM)
        count = len(self.weight)
        spread = np.zeros((3 * count, len(near)))
        for k in range(3):
            spread[k * count + near, np.arange(len(near))] = ways[near, k]
        lower = np.linalg.cholesky(spread.T @ self.compliance @ spread)
        gap = (self.weight * gap_mm)[near]
        return spread @ nnls(lower.T, -np.linalg.solve(lower, gap), maxiter=30000)[0]

    def along(self, centre: np.ndarray, way: np.ndarray) -> np.ndarray:
        """Pressure and gap along the way of the sphere."""
        away = self.centre_mm - centre
        ahead = away @ way
        root = ahead**2 - np.sum(away**2, axis=1) + TIP_MM**2
        gap = np.where(root > 0, ahead - np.sqrt(np.clip(root, 0, None)), NEVER_MM)
        return self.pressed(np.tile(way, (len(gap), 1)), gap)

    def sphere(self, centre: np.ndarray) -> np.ndarray:
        """Pressure along the sphere's normals, gaps to it where the surface has moved to: fixed points."""
        moved, tractions = np.zeros_like(self.centre_mm), np.zeros(0)
        for _ in range(60):
            away = self.centre_mm + moved - centre
            distance = np.linalg.norm(away, axis=1)
            ways = away / distance[:, None]
            gap = distance - TIP_MM - np.sum(ways * moved, axis=1)
            tractions = self.pressed(ways, gap)
            change = (self.compliance @ tractions).reshape(3, -1).T / self.weight[:, None] - moved
            moved = moved + 0.6 * change
            if abs(change).max() < 1e-4:
                break
        return tractions


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("x_mm", type=float)
    parser.add_argument("y_mm", type=float)
    parser.add_argument(
        "--lean", type=float, default=0.0, help="degrees; at a corner half to each side"
    )
    parser.add_argument("--edge", type=float, default=0.6, help="under the tip, mm")
    parser.add_argument("--sphere", action="store_true", help="the sphere's own normals")
    options = parser.parse_args()
    ng: Any = import_module("ngsolve")
    ng.SetNumThreads(1)
    half = options.y_mm == 0
    place = np.array([options.x_mm, options.y_mm, 0.0])
    outwards = np.array([1.0, 0.0, 0.0]) if half else np.array([1.0, 1.0, 0.0]) / np.sqrt(2)
    lean = np.radians(options.lean)
    way = -(np.cos(lean) * np.array([0.0, 0.0, 1.0]) + np.sin(lean) * outwards)
    mesh, magnets = mesh_of(options.x_mm, options.y_mm, options.edge, TIP_MM)
    condensed = Condensed(mesh, magnets, place, TIP_MM - 0.6, half)
    for depth in DEPTHS_MM:
        centre = place - (TIP_MM - depth) * way
        tractions = condensed.sphere(centre) if options.sphere else condensed.along(centre, way)
        force = (2 if half else 1) * tractions.reshape(3, -1) @ condensed.weight
        moved = (condensed.motion @ tractions).reshape(-1, 3)
        print(f"{depth:g} mm: {force @ way:.4f} N; magnets {moved.round(5).tolist()}", flush=True)


if __name__ == "__main__":
    main()
