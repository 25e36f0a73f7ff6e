"""The solver without MKL beside PARDISO, and beside SuperLU with the same order of elimination.

    python benchmarks/solvers.py [--quick] [--out FOLDER]

The job is the product's own: the compliance of all loads of an object's response, on its default
mesh, for several bodies. Every solver works in a process of its own, on one thread, so that each has
its own peak of memory. SuperLU, the twenty lines that would do without a solver of ours, cannot give
a Schur complement: it solves every load; some are solved and the time is scaled to all. Writes
`solvers.json`; a run that was broken off goes on with the next solver.
"""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg
from harness import conclude, kept, machine, option_parser, parts_folder, peak_memory_gb

from design.spec_io import load_spec
from fem.linear.dissection import dissect
from fem.linear.factorization import compliance_of_loads
from fem.linear.response import elastic_system, system_loads
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import load_mesh, save_mesh, tetrahedralize

EXAMPLES = Path(__file__).parents[1] / "examples"
BODIES = ("paper_cube", "handle", "pear", "hall_skin")
COARSE = ("mesh.edge_mm=9", "mesh.surface_edge_mm=3.6", "mesh.rim_edge_ratio=1",
          "mesh.envelope_mm=0.1")  # fmt: skip
SOLVERS = ("PARDISO", "multifrontal", "SuperLU")
_SOLVED = 128
AIM = 5.0


def measured(body: str, overrides: tuple[str, ...], mesh: Path, solver: str) -> dict[str, Any]:
    """One solver on one body: processor time, peak memory, and some entries of the compliance."""
    spec, tetrahedra = load_spec(EXAMPLES / f"{body}.toml", list(overrides)), load_mesh(mesh)
    system = elastic_system(tetrahedra, spec)
    matrix, (_, loads) = system.matrix, system_loads(tetrahedra, system, spec)
    before, start = peak_memory_gb(), time.process_time()
    solve = _by_superlu if solver == "SuperLU" else _by_product(solver)
    solved = solve(matrix, loads)
    return {
        "unknowns": shape_of(matrix)[0],
        "loads": shape_of(loads)[1],
        "cpu_s": time.process_time() - start + solved.get("more_s", 0.0),
        "memory_gb": peak_memory_gb(),
        "memory_before_gb": before,
        "corner": solved["corner"].tolist(),
    }


def _by_product(solver: str) -> Callable[[sp.csr_matrix, sp.csr_matrix], dict[str, Any]]:
    def solve(matrix: sp.csr_matrix, loads: sp.csr_matrix) -> dict[str, Any]:
        os.environ["INSTOBJ_MKL"] = "1" if solver == "PARDISO" else "0"
        return {"corner": compliance_of_loads(matrix, loads).matrix[:_SOLVED, :_SOLVED]}

    return solve


def _by_superlu(matrix: sp.csr_matrix, loads: sp.csr_matrix) -> dict[str, Any]:
    late = matrix.diagonal() <= 0
    order = dissect(matrix, late, np.zeros_like(late)).order
    factor = scipy.sparse.linalg.splu(
        sp.csc_matrix(matrix[order][:, order]),
        permc_spec="NATURAL",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    some = sp.csr_matrix(loads[:, :_SOLVED])
    start = time.process_time()
    x = np.empty(shape_of(some))
    x[order] = factor.solve(some[order].toarray())
    count = shape_of(loads)[1]
    share = max(0.0, count / shape_of(some)[1] - 1)
    return {"corner": some.T @ x, "more_s": share * (time.process_time() - start)}


def run(body: str, overrides: tuple[str, ...], parts: Path) -> dict[str, Any]:
    """All solvers on one body, and how far they are off the first."""
    mesh = parts / f"{body}.npz"
    if not mesh.is_file():
        parts.mkdir(parents=True, exist_ok=True)
        save_mesh(tetrahedralize(load_spec(EXAMPLES / f"{body}.toml", list(overrides))), mesh)
    rows = {}
    for solver in SOLVERS:

        def apart(solver: str = solver) -> dict[str, Any]:
            with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as one:
                return one.submit(measured, body, overrides, mesh, solver).result()

        rows[solver] = kept(parts, f"{body}_{solver}", apart)
        print(f"{body}: {solver}: {rows[solver]['cpu_s']:.1f} s", file=sys.stderr)
    reference = np.array(rows["PARDISO"]["corner"])
    for row in rows.values():
        off = abs(np.array(row.pop("corner")) - reference).max() / abs(reference).max()
        row |= {"off": float(off), "times_pardiso": row["cpu_s"] / rows["PARDISO"]["cpu_s"]}
    return rows


def report(result: dict[str, Any]) -> str:
    """A line per body and solver."""
    lines = ["body, solver: unknowns, loads, processor time, × PARDISO, peak GB, off"]
    for body, rows in result["bodies"].items():
        lines += [
            f"{body}, {solver}: {row['unknowns']}, {row['loads']}, {row['cpu_s']:.1f} s, "
            f"{row['times_pardiso']:.2f}, {row['memory_gb']:.1f}, {row['off']:.1e}"
            for solver, row in rows.items()
        ]
    return "\n".join(lines)


def main() -> None:
    options = option_parser(__doc__.splitlines()[0]).parse_args()
    result: dict[str, Any] = {"machine": machine(1, ("numpy", "scipy", "pypardiso")), "aim": AIM}
    parts = parts_folder("solvers", "quick" if options.quick else "full", options, result)
    bodies = ("hall_skin",) if options.quick else BODIES
    overrides = COARSE if options.quick else ()
    result["bodies"] = {body: run(body, overrides, parts) for body in bodies}
    conclude("solvers", options, result, report)
    shutil.rmtree(parts)


if __name__ == "__main__":
    main()
