"""Speed of the mechanics: the table of presses, single solves beside peers, growth with size.

    python benchmarks/mechanics.py [--quick] [--out FOLDER]

Everything in one run on one machine with the same number of threads for all. Rivals take turns
(A B C, A B C, …), and must agree in what they compute. Writes `mechanics.json`. Peers that are not
installed are named with the reason. Finished parts stand in `mechanics_parts_full` until all are: an
interrupted run goes on from them.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from typing import Any

import numpy as np
from harness import conclude, kept, machine, option_parser, parts_folder, peak_memory_gb
from mechanics_peers import Problem
from mechanics_solves import Contest, contests, solve_taylor_hood
from mechanics_table import QUICK_MESH, table
from skfem import MeshTet

from design.spec.object import MeshSpec, ObjectSpec
from fem.linear.factorization import pardiso_available
from fem.mesh.tetrahedra import tetrahedralize

THREADS = 2
AGREEMENT = 2e-6
"""CalculiX prints seven digits."""
GROWTH_CELLS = {True: (5, 8, 10), False: (10, 13, 17, 22, 27, 33)}
"""Cells along the edge of a structured block: (2n + 1)³ nodes, 9 to 300 thousand."""
BLOCK_MM = 42.0


def measure_contest(contest: Contest, rounds: int) -> dict[str, Any]:
    """Seconds of every rival, round by round, and the ratio to the best peer of the round."""
    runs: dict[str, list[dict[str, Any]]] = {name: [] for name in contest.rivals}
    expected = None
    for _ in range(rounds):
        for name, rival in contest.rivals.items():
            solved = rival()
            expected = solved.u_mm if expected is None else expected
            off = float(abs(solved.u_mm - expected).max() / abs(expected).max())
            if off > AGREEMENT:
                raise SystemExit(f"{name} differs by {off:.1e} of the largest displacement")
            times = {"phases_s": solved.wall_s, "total_s": solved.total_s, "difference": off}
            runs[name].append({**times, "processor_s": solved.processor_s})
    ratios = []
    for turn in range(rounds):
        peers = [runs[name][turn]["total_s"] for name in runs if name != "instobj"]
        if peers:
            ratios.append(runs["instobj"][turn]["total_s"] / min(peers))
    return {
        "element": contest.name,
        "vertices": contest.vertices,
        "nodes": contest.nodes,
        "missing": contest.missing,
        "runs": runs,
        "ratio_to_best_peer": _spread(ratios) if ratios else None,
    }


def single_solves(quick: bool) -> list[dict[str, Any]]:
    """The paper's shell without magnets, held at the core."""
    spec = ObjectSpec(name="cube", mesh=QUICK_MESH if quick else MeshSpec(surface_edge_mm=1.3))
    found = tetrahedralize(spec, magnets=False)
    mesh = MeshTet(found.points_mm.T.copy(), found.tets.T.copy())
    half = np.asarray(spec.core_size_mm) / 2 + 0.1
    held = mesh.facets_satisfying(lambda x: np.all(abs(x.T) < half, axis=-1).T, True)
    return [
        measure_contest(contest, 2 if quick else 4) for contest in contests(mesh, held, THREADS)
    ]


def block_of(cells: int) -> dict[str, Any]:
    """One Taylor–Hood solve of a solid block, with this process's peak memory."""
    mesh = MeshTet.init_tensor(*[np.linspace(0, BLOCK_MM, cells + 1)] * 3)
    held = mesh.facets_satisfying(lambda x: x[2] < 1e-9, True)
    solved = solve_taylor_hood(Problem(mesh, held, 0.3, 0.4999))
    return {
        "nodes": (2 * cells + 1) ** 3,
        "phases_s": solved.wall_s,
        "total_s": solved.total_s,
        "peak_gb": peak_memory_gb(),
    }


def in_own_process(*arguments: str) -> dict[str, Any]:
    """This script's JSON for one job, in a process whose peak memory is that job's."""
    done = subprocess.run(
        [sys.executable, __file__, *arguments],
        stdout=subprocess.PIPE,
        text=True,
        check=True,
        env=os.environ | {"MKL_NUM_THREADS": str(THREADS), "OMP_NUM_THREADS": str(THREADS)},
    )
    return json.loads(done.stdout.splitlines()[-1])


def _spread(values: list[float]) -> dict[str, float]:
    return {
        "least": float(min(values)),
        "median": float(np.median(values)),
        "most": float(max(values)),
    }


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    done = result["table"]
    lines = [f"{done['presses']} presses, {done['nodes']} nodes: {done['total_s']:.1f} s"]
    lines += [f"  {name}: {seconds:.2f} s" for name, seconds in done["phases_s"].items()]
    lines.append(f"  peak memory {done['peak_gb']:.2f} GB")
    for name, way in done["ways"].items():
        lines.append(
            f"{name}: {way['press_s']:.3g} s per press, {way['table_s']:.4g} s for the table "
            f"(extrapolated from {way['measured_presses']}), {way['ratio']:.3g} times ours; "
            f"differs by {way['largest_difference']:.1e}"
        )
    for contest in result["single_solves"]:
        lines.append(f"{contest['element']}, {contest['nodes']} nodes")
        for name, runs in contest["runs"].items():
            median = np.median([run["total_s"] for run in runs])
            lines.append(f"  {name}: {median:.2f} s; differs by {runs[0]['difference']:.1e}")
        ratio = contest["ratio_to_best_peer"]
        if ratio:
            lines.append(
                f"  ours to the best peer: {ratio['median']:.2f} "
                f"({ratio['least']:.2f} to {ratio['most']:.2f}), target 1.0"
            )
        lines += [f"  {name}: {why}" for name, why in contest["missing"].items()]
    for row in result["growth"]:
        lines.append(f"{row['nodes']} nodes: {row['total_s']:.2f} s, {row['peak_gb']:.2f} GB")
    return "\n".join(lines)


def main(arguments: list[str] | None = None) -> None:
    """Measure, write, print."""
    parser = option_parser("Mechanics beside peers and slower ways")
    parser.add_argument("--block", type=int, help=argparse.SUPPRESS)
    parser.add_argument("--table", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.block or options.table:
        print(json.dumps(block_of(options.block) if options.block else table(options.quick)))
        return
    solver = "PARDISO (MKL)" if pardiso_available() else "own multifrontal: no MKL on this machine"
    packages = ("numpy", "scipy", "scikit-fem", "mkl", "ngsolve")
    quick = ["--quick"] if options.quick else []
    result = {
        "machine": {**machine(THREADS, packages), "solver": solver},
        "quick": options.quick,
    }
    form = "quick" if options.quick else "full"
    parts = parts_folder("mechanics", form, options, result)

    def block(cells: int) -> dict[str, Any]:
        return kept(parts, f"block_{cells}", lambda: in_own_process("--block", str(cells)))

    result["table"] = kept(parts, "table", lambda: in_own_process("--table", *quick))
    result["single_solves"] = kept(parts, "solves", lambda: single_solves(options.quick))
    result["growth"] = [block(cells) for cells in GROWTH_CELLS[options.quick]]
    conclude("mechanics", options, result, report)
    shutil.rmtree(parts)


if __name__ == "__main__":
    main(sys.argv[1:])
