"""Fidelity levels of a search: how each scores layouts, and the file of what it said of them.

A search that was broken off goes on from there, layout by layout.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from design.files import atomic_path
from design.spec.object import ObjectSpec
from estimator.layouts.fidelity import FidelityScore, lowest_fidelity_score
from estimator.layouts.scorer import LayoutScorer
from instobj.search.fidelity import (
    chain_score,
    chain_seconds,
    score_of,
    second_score,
    second_seconds,
)
from instobj.search.lowest_fidelity import scorers, single_faces
from instobj.search.trials import search_key
from instobj.search.verdict import FIRST, LAST, SECOND, Promoted
from instobj.stages.makers.magnet_free import forget_shell
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import Here, Say, Workers
from instobj.store.content import store_root
from instobj.store.readers import SECOND_FIDELITY, SIGNALS

_KEPT = {field.name for field in fields(FidelityScore)}

Score = Callable[[ObjectSpec], FidelityScore]


def lowest_scoring() -> AbstractContextManager[Score]:
    """Scorers of the lowest level, the same ones for layouts of the same chips and magnets."""
    scorers_by_key: dict[tuple[Any, ...], tuple[LayoutScorer, ...]] = {}

    def score(spec: ObjectSpec) -> FidelityScore:
        key = spec.sensors.chip, *spec.magnets.sizes
        if key not in scorers_by_key:
            scorers_by_key[key] = scorers(spec, single_faces(spec.body.sensed))
        return lowest_fidelity_score(spec, scorers_by_key[key])

    return nullcontext(score)


@contextmanager
def second_scoring() -> Iterator[Score]:
    """One factorization for all layouts of a shell that follow each other."""
    try:
        yield second_score
    finally:
        forget_shell()


@dataclass(frozen=True)
class Level:
    """Way to score layouts that follow each other, the stages that it needs, and what they took, s."""

    scoring: Callable[[], AbstractContextManager[Score]]
    stages: tuple[str, ...] = ()
    seconds: Callable[[ObjectSpec], float] = lambda spec: 0.0


LEVELS = {
    FIRST: Level(lowest_scoring),
    SECOND: Level(second_scoring, (SECOND_FIDELITY.stage,), second_seconds),
    LAST: Level(lambda: nullcontext(chain_score), (SIGNALS.stage,), chain_seconds),
}


@dataclass(frozen=True)
class Levels:
    """Fidelity levels, whose scores are kept in the file `path`; `say` gets each step in words."""

    path: Path
    say: Say
    workers: Workers = field(default_factory=Here)
    table: Mapping[str, Level] = field(default_factory=lambda: LEVELS)

    def make(
        self,
        layouts: Sequence[Promoted],
        stages: tuple[str, ...],
        enough: Callable[[], bool] = lambda: False,
    ) -> None:
        """Make stages of several layouts side by side where there are several workers.

        Scoring, which takes one layout after the other, then finds them in the store. What fails here is
        made again by whoever needs it, and reported there.
        """
        if self.workers.count > 1:
            tasks, _ = tasks_of([layout.spec for layout in layouts], stages)
            self.workers.make(tasks, store_root(), self.say, enough)

    def score(
        self, layouts: Sequence[Promoted], name: str, enough: Callable[[], bool] = lambda: False
    ) -> list[Promoted]:
        """Fill in a level of the start and of layouts after it, from the file or scored again.

        Layouts that cannot be scored fall out, with a reason. Once `enough`, what is neither on file nor
        the start or the first layout falls out too.
        """
        scored_layouts = (
            json.loads(self.path.read_text(encoding="utf-8")) if self.path.is_file() else {}
        )
        scored: list[Promoted] = []
        with self.table[name].scoring() as score:
            for layout in layouts:
                key = f"{name} {search_key(layout.spec)}"
                step = f"fidelity level {name}: {layout.label}"
                if scored_layouts.get(key, {}).keys() != _KEPT:
                    # the start and one layout are scored however late it is
                    if len(scored) > 1 and enough():
                        self.say(f"{step} falls out: time runs short")
                        continue
                    self.say(step)
                    try:
                        scored_layouts[key] = asdict(score(layout.spec))
                    except (ValueError, ArithmeticError) as error:
                        if layout.trial is None:
                            raise
                        self.say(f"{step} falls out: {error}")
                        continue
                    with atomic_path(self.path) as temporary:
                        temporary.write_text(json.dumps(scored_layouts, indent=1), encoding="utf-8")
                layout.levels[name] = score_of(scored_layouts[key])
                scored.append(layout)
        return scored
