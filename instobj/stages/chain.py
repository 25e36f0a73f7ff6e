"""Chain of stages for one specification: reuses what the store holds, makes the rest."""

from __future__ import annotations

import platform
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.stages.inputs import stage_inputs
from instobj.stages.resources import require_memory
from instobj.stages.table import STAGES
from instobj.store.content import StoredResult, content_key, store_root, stored
from instobj.store.progress import ProgressLine
from instobj.store.stage import StageContext

_LIBRARIES = ("instobj",)


@dataclass
class Chain:
    """Stage results of one specification, made on demand in the order of their needs."""

    spec: ObjectSpec
    progress: ProgressLine = field(default_factory=ProgressLine)
    root: Path = field(default_factory=store_root)
    results: dict[str, StoredResult] = field(default_factory=dict)

    def require(self, name: str) -> StoredResult:
        """The stage's result, after those of every stage that it needs."""
        if name in self.results:
            return self.results[name]
        stage = STAGES[name]
        require_memory(name, self.spec)
        needs = {need: self.require(need) for need in stage.needs}
        for need, (other, spec) in stage.of_others(self.spec).items():
            needs[need] = self._of(spec).require(other)
        keys = {need: result.key for need, result in needs.items()}
        inputs = stage_inputs(stage, self.spec, keys, _versions())
        folders = {need: result.folder for need, result in needs.items()}

        def make(folder: Path) -> None:
            key = content_key({"stage": name, "inputs": inputs})
            context = StageContext(self.spec, folders, key, self.progress.step)
            try:
                stage.make(context, folder)
            except MemoryError:
                raise InputError(
                    f"{stage.title}: the machine has no more memory. End other programs, or make the "
                    "object's mesh, contact grid or data sets smaller"
                ) from None

        with self.progress.stage(stage.title):
            result = stored(self.root, name, inputs, make)
        self.results[name] = result
        how = "reused, first made in" if result.reused else "made in"
        self.progress.say(f"{stage.title}: {how} {result.seconds:.1f} s")
        return result

    def _of(self, spec: ObjectSpec) -> Chain:
        """The chain of another specification, on the same store."""
        return self if spec == self.spec else Chain(spec, self.progress, self.root)


def _versions() -> dict[str, str]:
    return {name: version(name) for name in _LIBRARIES} | {"machine": platform.machine()}
