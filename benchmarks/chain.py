"""Processor time of the chain from nothing, stage by stage: the paper's cube, or a cube of any size.

    python benchmarks/chain.py [--quick] [--mesh STORE] [--edge MM] [--out FOLDER]

Every stage is made once, in one call as `instobj run` does it, in an empty store: time of the process and
its children, and the largest memory of any of them. The mesher takes what it likes and gives another mesh
each time: `--mesh` takes that of another store. With `--edge` a cube of that edge is placed as `instobj
new` does, with as many sensors on a face as fit, three at most; it is not built, and the error of its mesh
is estimated too. Writes `chain.json`.
"""

from __future__ import annotations

import os
import resource
import shutil
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from harness import Result, machine, peak_memory_gb, run

from design.errors import InputError
from design.placement.objects import Request, spec_of
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.commands.new import designed
from instobj.commands.outlook import with_edges_that_fit
from instobj.stages.run import Run
from instobj.stages.table import STAGES
from instobj.store.content import StoredResult
from instobj.store.readers import DISCRETISATION
from instobj.store.stage import Call, Stage

EXAMPLES = Path(__file__).parents[1] / "examples"
MADE = ("build", "mesh", "response", "shapes", "presses", "signals", "scores", "robustness")
MADE_OF_ANY_SIZE = (*MADE[1:-1], "coarse_response", "discretisation")


@dataclass(eq=False)
class TimedRun(Run):
    """A run that keeps each stage's own processor time."""

    processor_s: dict[str, float] = field(default_factory=dict)

    def _made(self, name: str, call: Call) -> StoredResult:
        for need in STAGES[name].needs:
            self.require(need)
        began = processor_seconds()
        result = super()._made(name, call)
        self.processor_s[name] = processor_seconds() - began
        return result


def processor_seconds() -> float:
    """Of this process and of the children that have ended."""
    return sum(os.times()[:4])


def measure(quick: bool, mesh_of: Path | None, edge_mm: float | None) -> Result:
    """Seconds by stage, and in all."""
    began = processor_seconds()
    if edge_mm is None:
        example = "gallery/small_cube.toml" if quick else "paper_cube.toml"
        spec, made = load_spec(EXAMPLES / example), MADE
    else:
        spec, made = placed_cube(edge_mm), MADE_OF_ANY_SIZE
    placed_s = processor_seconds() - began
    STAGES["chain"] = Stage("all of them", made, (), lambda context, folder: None)
    try:
        with tempfile.TemporaryDirectory() as store:
            if mesh_of is not None:
                shutil.copytree(mesh_of / "mesh", Path(store) / "mesh")
            run = TimedRun(spec, root=Path(store))
            run.require("chain")
            error = None
            if edge_mm is not None:
                error = DISCRETISATION.read(run.require("discretisation").folder)
    finally:
        del STAGES["chain"]
    stages = {name: round(run.processor_s[name], 2) for name in made}
    # of the children Linux keeps the largest, in KiB
    children_gb = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024**2
    return {
        "machine": machine(1, ["numpy", "scipy", "pypardiso"]),
        "quick": quick,
        "mesh_given": mesh_of is not None,
        "object": f"{spec!r}",
        "edges_mm": [spec.mesh.surface_edge_mm, spec.mesh.edge_mm],
        "placed_s": round(placed_s, 2),
        "stages_s": stages,
        "all_s": round(sum(stages.values()), 2),
        "peak_gib": round(max(peak_memory_gb(), children_gb), 2),
        "discretisation": error,
    }


def placed_cube(edge_mm: float) -> ObjectSpec:
    """Return a cube as `instobj new` places it, with three sensors on a face or as many as fit.

    Raises
    ------
    InputError
        Not even one fits.
    """
    for sensors in (3, 2, 1):
        request = Request("box", (edge_mm, edge_mm, edge_mm), sensors)
        try:
            return spec_of(with_edges_that_fit(request, designed(request)[0]))
        except InputError:
            if sensors == 1:
                raise
    raise AssertionError


def report(result: Result) -> str:
    """Stage by stage."""
    rows = [f"{name:12s} {seconds:7.1f} s" for name, seconds in result["stages_s"].items()]
    rows += [f"{'all':12s} {result['all_s']:7.1f} s", f"peak memory {result['peak_gib']:.1f} GiB"]
    error = result["discretisation"]
    rows += [
        f"{step['depth_mm']:g} mm deep: error {step['force_rms']:.1%} of force, "
        f"{step['motion_rms']:.1%} of motions"
        for step in (error["steps"] if error else ())
        if step["force_rms"] is not None
    ]
    return "\n".join([result["object"], *rows])


if __name__ == "__main__":
    run(
        measure,
        report,
        mesh=(Path, None, "store whose mesh is taken"),
        edge=(float, None, "edge of a cube (mm) that is placed and scored instead"),
    )
