"""One linear elastic problem in NGSolve and CalculiX, where installed.

Every peer gets the same straight-sided tetrahedra, the same held facets and the same body force
b = G x + c, and returns the displacement of every vertex, with the seconds that assembly,
factorization and solution took. Reading the mesh is not counted, except for CalculiX, which tells
only its total: its time without factorization is that of the same input with one element.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from skfem import Basis, ElementTetP2, LinearForm, MeshTet

BODY_FORCE_SLOPE = np.array([[0.3, -0.2, 0.5], [0.7, -0.4, 0.1], [-0.6, 0.8, 0.9]]) * 1e-5
BODY_FORCE_N_PER_MM3 = np.array([1e-4, -2e-4, 3e-4])


@dataclass(frozen=True)
class Problem:
    """Silicone held at some boundary facets, under the body force."""

    mesh: MeshTet
    held: np.ndarray
    youngs_modulus_mpa: float
    poisson_ratio: float

    @property
    def lame_mpa(self) -> tuple[float, float]:
        """Shear modulus μ and λ."""
        nu = self.poisson_ratio
        mu = self.youngs_modulus_mpa / (2 * (1 + nu))
        return mu, 2 * mu * nu / (1 - 2 * nu)

    def nodal_forces(self) -> np.ndarray:
        """(3, P2 node), N, in scikit-fem's numbering."""
        basis = Basis(self.mesh, ElementTetP2(), intorder=3)

        def component(i: int) -> LinearForm:
            return LinearForm(
                lambda v, w: (
                    v
                    * (BODY_FORCE_N_PER_MM3[i] + np.einsum("j,j...->...", BODY_FORCE_SLOPE[i], w.x))
                )
            )

        return np.array([component(i).assemble(basis) for i in range(3)])


@dataclass(frozen=True)
class Solved:
    """Displacement of every vertex (3, vertex) in mm, wall seconds by phase, processor seconds."""

    u_mm: np.ndarray
    wall_s: dict[str, float]
    processor_s: float

    @property
    def total_s(self) -> float:
        return sum(self.wall_s.values())


def why_no_ngsolve() -> str | None:
    """None where NGSolve can be imported, else the reason."""
    try:
        import_module("ngsolve")
    except ImportError as error:
        return f"not installed ({error}); pip install ngsolve"
    return None


def why_no_calculix() -> str | None:
    """None where the program ccx is found, else the reason."""
    return None if shutil.which("ccx") else "no program ccx; Debian: apt install calculix-ccx"


def why_no_dolfinx() -> str | None:
    """None where dolfinx can be imported, else the reason."""
    try:
        import_module("dolfinx")
    except ImportError:
        return "not installed; PyPI has no wheels of it"
    return None


def netgen_mesh(problem: Problem) -> Any:
    """The same mesh in NGSolve, its boundary named `held` and `free`."""
    ngsolve, netgen = import_module("ngsolve"), import_module("netgen.meshing")
    source, mesh = problem.mesh, netgen.Mesh(dim=3)
    points = [mesh.Add(netgen.MeshPoint(netgen.Pnt(*p))) for p in source.p.T.tolist()]
    for number in (1, 2):
        mesh.Add(netgen.FaceDescriptor(surfnr=number, domin=1, bc=number))
    mesh.SetMaterial(1, "silicone")
    boundary = source.boundary_facets()
    kinds = np.where(np.isin(boundary, problem.held), 1, 2)
    corners = np.asarray(source.facets)[:, boundary].T
    for kind, facet in zip(kinds.tolist(), corners.tolist(), strict=True):
        mesh.Add(netgen.Element2D(kind, [points[i] for i in facet]))
    for tet in source.t.T.tolist():
        mesh.Add(netgen.Element3D(1, [points[i] for i in tet]))
    mesh.SetBCName(0, "held")
    mesh.SetBCName(1, "free")
    return ngsolve.Mesh(mesh)


def solve_with_ngsolve(problem: Problem, mesh: Any, mixed: bool, inverse: str) -> Solved:
    """P2 displacement, or Taylor–Hood where `mixed`, with one of NGSolve's direct solvers."""
    ng: Any = import_module("ngsolve")

    mu, lam = problem.lame_mpa
    started, cpu = time.perf_counter(), time.process_time()
    with ng.TaskManager():
        displacement = ng.VectorH1(mesh, order=2, dirichlet="held")
        space = displacement * ng.H1(mesh, order=1) if mixed else displacement
        trial, test = space.TnT()
        (u, p), (v, q) = (trial, test) if mixed else ((trial, 0), (test, 0))
        strain_u, strain_v = ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v))
        form = 2 * mu * ng.InnerProduct(strain_u, strain_v)
        if mixed:
            form += -p * ng.div(v) - q * ng.div(u) - p * q / lam
        else:
            form += lam * ng.div(u) * ng.div(v)
        matrix = ng.BilinearForm(space, symmetric=True)
        matrix += form * ng.dx
        load = ng.LinearForm(space)
        load += ng.InnerProduct(_body_force(ng), v) * ng.dx(bonus_intorder=1)
        matrix.Assemble()
        load.Assemble()
        assembled = time.perf_counter()
        factor = matrix.mat.Inverse(space.FreeDofs(), inverse=inverse)
        factored = time.perf_counter()
        solution = ng.GridFunction(space)
        solution.vec.data = factor * load.vec
    wall = {
        "assemble": assembled - started,
        "factor": factored - assembled,
        "solve": time.perf_counter() - factored,
    }
    field = solution.components[0] if mixed else solution
    vertices = problem.mesh.p.shape[1]
    u_mm = np.array([field.components[i].vec.FV().NumPy()[:vertices] for i in range(3)])
    return Solved(u_mm, wall, time.process_time() - cpu)


def _body_force(ng: Any) -> Any:
    place = (ng.x, ng.y, ng.z)
    return ng.CoefficientFunction(
        tuple(
            float(BODY_FORCE_N_PER_MM3[i])
            + sum(float(BODY_FORCE_SLOPE[i, j]) * place[j] for j in range(3))
            for i in range(3)
        )
    )


def solve_with_calculix(problem: Problem, threads: int) -> Solved:
    """Plain P2 (C3D10) with CalculiX's default direct solver (SPOOLES), as a whole program."""
    with tempfile.TemporaryDirectory() as folder:
        _write_calculix_input(problem, Path(folder) / "job.inp")
        started = time.perf_counter()
        done = subprocess.run(
            ["ccx", "job"],
            cwd=folder,
            env={"OMP_NUM_THREADS": str(threads), "PATH": "/usr/bin:/bin:/usr/local/bin"},
            capture_output=True,
            text=True,
            check=True,
        )
        wall = time.perf_counter() - started
        if "*ERROR" in done.stdout:
            raise RuntimeError(done.stdout[-800:])
        u_mm = _read_calculix_displacements(Path(folder) / "job.dat", problem.mesh.p.shape[1])
    return Solved(u_mm, {"whole program": wall}, wall)


def _write_calculix_input(problem: Problem, path: Path) -> None:
    basis = Basis(problem.mesh, ElementTetP2(), intorder=2)
    nodes, tets = basis.doflocs.T, np.asarray(basis.element_dofs)
    held = np.unique(np.asarray(basis.get_dofs(facets=problem.held).all()))
    forces = problem.nodal_forces()
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1},{x:.12g},{y:.12g},{z:.12g}" for i, (x, y, z) in enumerate(nodes)]
    lines.append("*ELEMENT, TYPE=C3D10, ELSET=BODY")
    lines += [
        f"{e + 1}," + ",".join(str(n + 1) for n in tet)
        for e, tet in enumerate(_c3d10_elements(nodes, tets).T.tolist())
    ]
    lines += ["*NSET, NSET=VERTICES, GENERATE", f"1,{problem.mesh.p.shape[1]}"]
    lines += ["*MATERIAL, NAME=SILICONE", "*ELASTIC"]
    lines += [f"{problem.youngs_modulus_mpa:.12g},{problem.poisson_ratio:.12g}"]
    lines += ["*SOLID SECTION, ELSET=BODY, MATERIAL=SILICONE", "*BOUNDARY"]
    lines += [f"{n + 1},1,3" for n in held.tolist()]
    lines += ["*STEP", "*STATIC", "*CLOAD"]
    free = np.setdiff1d(np.arange(len(nodes)), held)
    lines += [f"{n + 1},{i + 1},{forces[i, n]:.12g}" for n in free.tolist() for i in range(3)]
    lines += ["*NODE PRINT, NSET=VERTICES", "U", "*END STEP", ""]
    path.write_text("\n".join(lines))


def _c3d10_elements(nodes: np.ndarray, tets: np.ndarray) -> np.ndarray:
    """Nodes (10, tet) in CalculiX's order: corners turned positive, then edges 12 23 13 14 24 34."""
    corner = nodes[tets[:4]]
    turned = np.linalg.det((corner[1:] - corner[0]).transpose(1, 0, 2)) < 0
    elements = np.empty_like(tets)
    for which, corners in ((~turned, (0, 1, 2, 3)), (turned, (0, 2, 1, 3))):
        elements[:, which] = tets[np.ix_(_c3d10_rows(nodes, tets, corners), which)]
    return elements


def _c3d10_rows(nodes: np.ndarray, tets: np.ndarray, corners: tuple[int, ...]) -> list[int]:
    """Rows of scikit-fem's P2 element that are those corners and the edges between them."""
    place, middles = nodes[tets[:4, 0]], nodes[tets[4:, 0]]
    edges = [(corners[a], corners[b]) for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
    distance = [np.linalg.norm(middles - (place[a] + place[b]) / 2, axis=1) for a, b in edges]
    return [*corners, *(4 + int(np.argmin(d)) for d in distance)]


def _read_calculix_displacements(path: Path, vertices: int) -> np.ndarray:
    rows = [line.split() for line in path.read_text().splitlines()]
    values = np.array(
        [[float(cell) for cell in row] for row in rows if len(row) == 4 and row[0].isdigit()]
    )
    u = np.zeros((3, vertices))
    u[:, values[:, 0].astype(int) - 1] = values[:, 1:].T
    return u
