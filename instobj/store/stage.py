"""Stages of the chain: their contract, and what they work from."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.files import atomic_path
from design.spec.object import ObjectSpec
from instobj.store.readers import Content, ResultFile

if TYPE_CHECKING:
    from fem.linear.response import FactoredObject

Step = Callable[[str], None]


@dataclass(eq=False)
class Call:
    """The stages that one call of a run asks for, and what one leaves in memory for a later one.

    `factored` is the response operator's (1.5 GB on the paper's cube), kept where "shapes" is asked for.
    """

    asks_for: frozenset[str] = frozenset()
    factored: FactoredObject | None = None

    def end(self) -> None:
        """Give the memory back."""
        if self.factored is not None:
            self.factored.factor.release()
        self.factored = None


@dataclass(frozen=True)
class StageContext:
    """Context that a stage works from: the specification, the folders of the stages it needs, and the
    call."""

    spec: ObjectSpec
    inputs: dict[str, Path]
    key: str
    step: Step
    call: Call = field(default_factory=Call)

    def read(self, file: ResultFile[Content]) -> Content:
        """A result file of a stage that this one needs."""
        return file.read(self.inputs[file.stage])


def _none(spec: ObjectSpec) -> dict[str, tuple[str, ObjectSpec]]:
    return {}


@dataclass(frozen=True)
class Stage:
    """A stage of the chain.

    `depends_on` names parts of the specification (dotted where only one field matters), or
    "shell_bodies", what is cast into the silicone, which follows from several of them (or
    "shell_body_cylinder", cross-section and height of one such body); `version` is raised when the code
    would give another result from the same inputs. `of_others` says which results of other objects
    it needs besides, derived from its own: name → stage and specification.
    """

    title: str
    needs: tuple[str, ...]
    depends_on: tuple[str, ...]
    make: Callable[[StageContext, Path], None]
    version: int = 1
    of_others: Callable[[ObjectSpec], dict[str, tuple[str, ObjectSpec]]] = _none


def write_json(content: dict[str, Any], path: Path) -> None:
    """Write JSON that is complete or absent."""
    with atomic_path(path) as temporary:
        temporary.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")
