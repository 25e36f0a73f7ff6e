"""Processor time of the chain from nothing, stage by stage: the paper's cube.

    python benchmarks/chain.py [--quick] [--mesh STORE] [--out FOLDER]

Every stage is made once, in one call as `instobj run` does it, in an empty store: time of the process and
its children. The mesher takes what it likes and gives another mesh each time: `--mesh` takes that of
another store. Writes `chain.json`.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from harness import Result, machine, run

from design.spec_io import load_spec
from instobj.stages.run import Run
from instobj.stages.table import STAGES
from instobj.store.content import StoredResult
from instobj.store.stage import Call, Stage

EXAMPLES = Path(__file__).parents[1] / "examples"
MADE = ("build", "mesh", "response", "shapes", "presses", "signals", "scores", "robustness")


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


def measure(quick: bool, mesh_of: Path | None) -> Result:
    """Seconds by stage, and in all."""
    example = "gallery/small_cube.toml" if quick else "paper_cube.toml"
    spec = load_spec(EXAMPLES / example)
    STAGES["chain"] = Stage("all of them", MADE, (), lambda context, folder: None)
    try:
        with tempfile.TemporaryDirectory() as store:
            if mesh_of is not None:
                shutil.copytree(mesh_of / "mesh", Path(store) / "mesh")
            run = TimedRun(spec, root=Path(store))
            run.require("chain")
    finally:
        del STAGES["chain"]
    stages = {name: round(run.processor_s[name], 2) for name in MADE}
    return {
        "machine": machine(1, ["numpy", "scipy", "pypardiso"]),
        "quick": quick,
        "mesh_given": mesh_of is not None,
        "stages_s": stages,
        "all_s": round(sum(stages.values()), 2),
    }


def report(result: Result) -> str:
    """Stage by stage."""
    rows = [f"{name:12s} {seconds:7.1f} s" for name, seconds in result["stages_s"].items()]
    return "\n".join([*rows, f"{'all':12s} {result['all_s']:7.1f} s"])


if __name__ == "__main__":
    run(measure, report, mesh=(Path, None, "store whose mesh is taken"))
