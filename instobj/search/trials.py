"""Finished trials of a search, kept in one file of JSON lines.

The first line names the search. Each other line is a finished trial, written to the disk in one go:
whatever happens to a process, at most the trials that it was working on are lost. A last line that a
full disk or a power cut left unfinished is dropped when the file is opened again.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.store.keys import content_key

_BUDGET = ("trials", "seconds", "finalists", "polish_steps")
"""Keys of `[search]` that may change while a search goes on."""
_MATTERS_NOT = ("name", "as_built", "collection")
"""The first line holds the name; the others change no score on any level."""
_LOWEST_LEVEL = 2
"""Version of the lowest level's scores: raise it when they change, so that trials of both are not mixed.
2: bounds of coarse grids, which were 0.41 to 0.93 times too small."""


@dataclass(frozen=True)
class Scored:
    """Outcome of a trial: its polished variables, values to minimise and scores.

    `broken_mm` is 0 where every limit is kept; `misfit` says which is broken most, or what else does not
    fit. `scorings` are the layouts that were scored for it, `generations` those planned for its run.
    `start_scores` are those of the specification's own layout at the same level. They come with
    each trial, as only the processes that score trials have them.
    """

    params: dict[str, Any]
    values: tuple[float, ...]
    scores: dict[str, float]
    broken_mm: float
    misfit: str
    scorings: int
    generations: int = field(default=0, kw_only=True)
    start_scores: dict[str, float] = field(default_factory=dict, kw_only=True)

    @property
    def feasible(self) -> bool:
        """Return whether it has a result that keeps every limit."""
        return bool(self.values) and self.broken_mm == 0 and not self.misfit


@dataclass(frozen=True)
class Trial(Scored):
    """A finished trial: its place in the file, and why it has no result, or nothing."""

    number: int
    failure: str = ""


def failed_trial(number: int, params: dict[str, Any], why: str) -> Trial:
    """Return a trial that came to nothing."""
    return Trial(params, (), {}, 0.0, "", 0, number, why)


@dataclass
class KeptTrials:
    """Trials of a search in the file `path`, in the order in which they were kept."""

    path: Path
    trials: list[Trial] = field(default_factory=list)
    _length: int = 0
    _head: bytes = b""

    @property
    def finished(self) -> list[Trial]:
        """Those that have values."""
        return [trial for trial in self.trials if not trial.failure]

    def keep(self, trials: Iterable[Trial]) -> None:
        """Add finished trials.

        Raises
        ------
        InputError
            The file cannot be written, or another process adds trials to it.
        """
        new = list(trials)
        self._append("".join(json.dumps(asdict(trial)) + "\n" for trial in new))
        self.trials += new

    def _append(self, lines: str) -> None:
        try:
            with self.path.open("a+b") as stream:
                length = stream.seek(0, os.SEEK_END)
                stream.seek(0)
                # a search of another specification, begun meanwhile, has a head as long
                if length != self._length or stream.read(len(self._head)) != self._head:
                    raise InputError(
                        f"another process works on the search in {self.path}. Wait for its end, then go "
                        "on with --resume"
                    )
                stream.write(lines.encode())
                stream.flush()
                os.fsync(stream.fileno())
        except OSError as error:
            raise InputError(
                f"cannot keep trials in {self.path}: {error.strerror}. What was kept before is safe: "
                "make room, then go on with --resume"
            ) from error
        self._length += len(lines.encode())


def open_trials(spec: ObjectSpec, path: Path, resume: bool = False) -> KeptTrials:
    """Begin the file of this specification's search, or with `resume` read the one that is there.

    A file without a trial is gone on with where it is of this specification, as another process may make its
    mechanics; else, left by a search that was broken off, it is begun again.

    Raises
    ------
    InputError
        The file cannot be read or written, or is no such file; there is a search already (or, to resume,
        none), or it is one of another specification.
    """
    head = {"search": spec.name, "specification": search_key(spec)}
    first_line = json.dumps(head) + "\n"
    try:
        has_search = path.is_file() and path.stat().st_size > 0
        if has_search and not resume and read_trials(path):
            raise InputError(
                f"{path} holds a search already. Go on with --resume, or give the specification another "
                "name to start anew"
            )
        if resume and not has_search:
            raise InputError(f"{path} holds no search to resume. Leave --resume out to start one")
        if has_search and (resume or path.read_bytes().startswith(first_line.encode())):
            return _read(path, head)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"")
    except OSError as error:
        raise InputError(
            f"cannot keep a search in {path}: {error.strerror}. Make room, or give another --out"
        ) from error
    kept = KeptTrials(path)
    kept._append(first_line)
    kept._head = first_line.encode()
    return kept


def search_key(spec: ObjectSpec) -> str:
    """SHA-256 of what scores on any level depend on; only the budget of the search may change.

    The version of the lowest level's scores counts too.
    """
    alike = ObjectSpec.model_validate(spec.model_dump(mode="json"))  # defaults like what was read
    content = alike.model_dump(mode="json")
    for name in _BUDGET:
        del content["search"][name]
    if spec.limits.use != "bench":
        # Figures of a use stand next to it; "bench" alone changes bounds besides.
        del content["limits"]["use"]
    kept = {name: part for name, part in content.items() if name not in _MATTERS_NOT}
    return content_key(kept | {"lowest level": _LOWEST_LEVEL})


def read_trials(path: Path) -> list[Trial]:
    """Return the finished trials in a file that a search may be writing; none where there is no file.

    Raises
    ------
    InputError
        It is no file of a search, or holds a line that is no trial.
    """
    content = path.read_bytes() if path.is_file() else b""
    return _trials(path, _records(path, content)) if b"\n" in content else []


def _records(path: Path, content: bytes) -> list[dict[str, Any]]:
    """Return the first line and the whole ones after it."""
    lines = content[: content.rfind(b"\n") + 1].decode(errors="replace").splitlines()
    records = [_record(path, number, line) for number, line in enumerate(lines, start=1)]
    if not records or records[0].keys() != {"search", "specification"}:
        raise InputError(f"{path} is no file of a search. Move it away to start anew")
    return records


def _trials(path: Path, records: list[dict[str, Any]]) -> list[Trial]:
    try:
        return [_trial(**record) for record in records[1:]]
    except TypeError as error:
        raise InputError(
            f"{path} holds a trial that cannot be read ({error}). Restore the file from a copy, or move "
            "it away to start anew"
        ) from None


def _read(path: Path, head: dict[str, str]) -> KeptTrials:
    content = path.read_bytes()
    records = _records(path, content)
    _require_same(path, records[0], head)
    trials, whole = _trials(path, records), content.rfind(b"\n") + 1
    if whole < len(content):
        with path.open("r+b") as stream:
            stream.truncate(whole)
    return KeptTrials(path, trials, whole, content[: content.find(b"\n") + 1])


def _trial(values: list[float], **others: Any) -> Trial:
    return Trial(values=tuple(values), **others)


def _record(path: Path, number: int, line: str) -> dict[str, Any]:
    try:
        record = json.loads(line)
    except ValueError:
        record = None
    if not isinstance(record, dict):
        raise InputError(
            f"{path}, line {number}: no trial of a search. Restore the file from a copy, or move it away "
            "to start anew"
        )
    return record


def _require_same(path: Path, kept: dict[str, str], head: dict[str, str]) -> None:
    if kept["search"] != head["search"]:
        raise InputError(
            f"{path} holds no search of {head['search']!r} but one of {kept['search']!r}. Leave --resume "
            "out to start one elsewhere"
        )
    was, now = kept["specification"], head["specification"]
    if was != now:
        raise InputError(
            f"{path} holds a search of another specification named {head['search']!r}, or of an earlier "
            f"version ({was[:12]}, now {now[:12]}): its trials cannot be compared. Undo the change (only the "
            "budget of [search] may change), or give the specification another name"
        )
