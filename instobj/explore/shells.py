"""Shells that the page asks for: each coarse within seconds, then by its own mechanics."""

from __future__ import annotations

import json
from asyncio import Lock, Task, create_task, to_thread
from collections.abc import Callable
from dataclasses import dataclass, field

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from instobj.explore.design import SHELL_TABLES
from instobj.explore.engine import Explorer, open_explorer, open_shell
from instobj.search.apart import WorkerProcess
from instobj.stages.resources import require_memory, search_seconds
from instobj.store.keys import content_key

_MINUTE_S, _LONGEST_S = 60.0, 12 * 3600.0
_NAME_LENGTH = 16
"""Hexadecimal digits of a shell's name: two alike are less likely than 1e-15."""


@dataclass
class Shells:
    """Explorers by shell. One shell at a time is refined, in a process that ends where another is asked for;
    finished stages stay in the store."""

    by_key: dict[str, Explorer]
    _opening: Lock = field(default_factory=Lock)
    _refined: str = ""
    _worker: WorkerProcess | None = None
    _task: Task[None] | None = None
    _trouble: dict[str, str] = field(default_factory=dict)

    @classmethod
    def beginning_with(cls, explorer: Explorer) -> Shells:
        """Return the shells of a session that begins with one of them."""
        return cls({shell_key(explorer.spec): explorer})

    def explorer_of(self, design: ObjectSpec) -> Explorer:
        """Return the best explorer of a design's shell that there is.

        Raises
        ------
        KeyError
            `open` was not awaited.
        """
        return self.by_key[shell_key(design)]

    def name_of(self, design: ObjectSpec) -> str:
        """Return a name that changes where contact locations or accuracy do."""
        key = shell_key(design)
        return f"{key} {'coarse' if self.by_key[key].coarse else 'full'}"

    async def open(self, design: ObjectSpec) -> None:
        """Make the shell of a design ready: from the store, or else coarse, and begin to refine it where
        this machine has the memory.

        Raises
        ------
        InputError
            A shell or a face without room for candidates, or a design that cannot be scored so.
        """
        key = shell_key(design)
        async with self._opening:
            if key not in self.by_key:
                self.by_key[key] = await to_thread(open_shell, design)
        if self.by_key[key].coarse and self._refined != key and key not in self._trouble:
            self.close()
            try:
                require_memory("candidates", design)
            except InputError as error:
                self._trouble[key] = str(error)
                return
            self._refined, self._worker = key, WorkerProcess(_mechanics, None)
            self._task = create_task(self._refine(key, design, self._worker))

    def told(self, design: ObjectSpec) -> str:
        """Say what is being refined, or why it cannot be; nothing where the design's shell is exact."""
        key = shell_key(design)
        if not self.by_key[key].coarse:
            return ""
        if key in self._trouble:
            return f"The shell's own mechanics cannot be had: {self._trouble[key]}"
        minutes = max(1, round(search_seconds(design).lowest / _MINUTE_S))
        return f"The shell's own mechanics is being computed: about {minutes} min of a free core."

    def is_refining(self, design: ObjectSpec) -> bool:
        """Return whether the shell of a design is to become exact."""
        key = shell_key(design)
        return self.by_key[key].coarse and key not in self._trouble

    def close(self) -> None:
        """End what is being refined."""
        self._refined = ""
        if self._worker is not None:
            self._worker.close()
            self._worker = None

    async def _refine(self, key: str, design: ObjectSpec, worker: WorkerProcess) -> None:
        try:
            await to_thread(worker.ask, design.model_dump_json(), _LONGEST_S)
            self.by_key[key] = await to_thread(open_explorer, design)
        except Exception as error:  # a closed connection, too: then another shell is at work
            if self._worker is worker:
                self._trouble[key] = str(error)
        finally:
            worker.close()


def shell_key(spec: ObjectSpec) -> str:
    """Return a name of the shell: its body, thickness and silicone."""
    tables = {name: getattr(spec, name).model_dump(mode="json") for name in SHELL_TABLES}
    return content_key(tables)[:_NAME_LENGTH]


def _mechanics(_: None) -> Callable[[str], None]:
    """Return what makes mechanics in another process."""
    return _make_mechanics


def _make_mechanics(content: str) -> None:
    open_explorer(parse_spec(json.loads(content), "the page's design"))
