"""Long work of the page: a search or a whole chain, as the command that the page shows, one at a time."""

from __future__ import annotations

import asyncio
import os
import shlex
import signal
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.search.space import search_space, with_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.explore.design import design_of
from instobj.explore.engine import Explorer, summary_of
from instobj.search.optimize import BEST
from instobj.search.outcome.figures import LABELS
from instobj.search.trials import Trial, read_trials
from instobj.stages.run import Run
from instobj.store.publish import run_folder

OUT = Path()
"""Folder of `runs/`, as of the commands."""
_MOST = 8
"""Candidates that are shown, the best first."""
_ENDING_S = 10.0
"""Time that a command gets to end by itself."""
_POLITE = 10
"""Niceness of commands: hands that drag a part go first."""


@dataclass
class Work:
    """The last command that the page began: its words, the last line that it wrote, how it ended."""

    words: list[str] = field(default_factory=list)
    path: Path = OUT
    line: str = ""
    _process: Process | None = None
    _reading: asyncio.Task[None] | None = None
    _designs: dict[int, dict[str, Any]] = field(default_factory=dict)

    @property
    def running(self) -> bool:
        """Return whether it still runs."""
        return self._process is not None and self._process.returncode is None

    async def improve(self, path: Path, seconds: float) -> None:
        """Search from a specification's layout, or go on with its search.

        Raises
        ------
        InputError
            Something runs already, or the time is no number of seconds.
        """
        if not 1 <= seconds <= 1e6:
            raise InputError(f"a search takes 1 to 1e6 s; got {seconds:g}. Give another time")
        kept = _folder(path) / "trials.jsonl"
        options = ["--set", f"search.seconds={seconds:g}", *["--resume"] * kept.is_file()]
        await self._start(["optimize", str(path), *options], path)

    async def confirm(self, path: Path, force_n: float) -> None:
        """Run the whole chain of a specification up to its scores at a force.

        Raises
        ------
        InputError
            Something runs already.
        """
        options = ["--to", "scores", "--set", f"score.force_n={force_n:g}"]
        await self._start(["run", str(path), *options], path)

    async def stop(self) -> None:
        """End the command as Ctrl-C does, which keeps what it has; then for certain."""
        if self._process is None or not self.running:
            return
        self._process.send_signal(signal.SIGINT)
        with suppress(TimeoutError):
            await asyncio.wait_for(self._process.wait(), _ENDING_S)
        with suppress(ProcessLookupError):  # what it began, too
            os.killpg(self._process.pid, signal.SIGKILL)
        await self._process.wait()

    def told(self) -> dict[str, Any]:
        """Return the command, whether it runs, its last line, and layouts of a search."""
        command = shlex.join(["instobj", *self.words]) if self.words else ""
        failed = not self.running and self._process is not None and self._process.returncode
        layouts = self._layouts() if self.words[:1] == ["optimize"] else []
        return {
            "command": command,
            "running": self.running,
            "line": self.line,
            "failed": bool(failed),
            "layouts": layouts,
        }

    async def _start(self, words: list[str], path: Path) -> None:
        if self.running:
            raise InputError(f"{self.words[0]} is at work. Stop it, or wait for its end")
        self.words, self.path, self.line, self._designs = words, path, "", {}
        command = (sys.executable, "-m", "instobj", *words)
        # A session of its own: Ctrl-C in the terminal reaches the server alone, which ends it.
        self._process = await asyncio.create_subprocess_exec(
            *command, stdin=DEVNULL, stdout=DEVNULL, stderr=PIPE, start_new_session=True
        )
        with suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, self._process.pid, _POLITE)
        self._reading = asyncio.create_task(self._read(self._process))

    async def _read(self, process: Process) -> None:
        assert process.stderr is not None
        async for line in process.stderr:
            self.line = line.decode(errors="replace").strip() or self.line
        await process.wait()

    def _layouts(self) -> list[dict[str, Any]]:
        """Trials that keep every limit, the best first, behind what the search wrote as its best."""
        folder, spec = _folder(self.path), load_spec(self.path)
        trials = [trial for trial in read_trials(folder / "trials.jsonl") if trial.feasible]
        space = search_space(spec)
        shown = sorted(trials, key=lambda trial: trial.values[0])[:_MOST]
        for trial in shown:
            if trial.number not in self._designs:
                self._designs[trial.number] = design_of(with_layout(space.spec, trial.params))
        layouts = [
            {"label": _told(trial, spec), "design": self._designs[trial.number]} for trial in shown
        ]
        best = folder / BEST
        if best.is_file() and not self.running:
            about = best.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ")
            layouts.insert(0, {"label": about, "design": design_of(load_spec(best))})
        return layouts


def _told(trial: Trial, spec: ObjectSpec) -> str:
    name = spec.search.objectives[0]
    return f"trial {trial.number}: {LABELS[name]} {trial.scores[name]:.3g}, over all forces"


def _folder(path: Path) -> Path:
    return run_folder(OUT, load_spec(path).name) / "search"


def confirmed_rows(explorer: Explorer, path: Path, force_n: float) -> list[dict[str, Any]]:
    """Return figures of the page and of the whole chain of a saved design; none where it is not stored."""
    design = load_spec(path, [f"score.force_n={force_n:g}"])
    run = Run(design)
    if run.stored("scores") is None:
        return []
    quick, scores = explorer.judge(design, force_n), run.scores
    rows = []
    for title, now, then in (
        ("error of the place, mm", quick.position_bound_mm, scores.position_bound_mm),
        ("error of the force, N", quick.force_bound_n, scores.force_bound_n),
    ):
        values = np.asarray(then.values, dtype=float)
        page, chain = summary_of(now), summary_of(values)
        rows += [
            {"name": f"{title}: {which}", "page": getattr(page, key), "chain": getattr(chain, key)}
            for which, key in (
                ("half are below", "median"),
                ("95 of 100 are below", "percentile_95"),
                ("worst", "worst"),
            )
        ]
    return rows
