"""Journal of a run on a press rig: its plan, and which presses were begun and finished.

One JSON document per line, forced to disk, so that a run goes on after a kill: what was finished is
not pressed again, what was only begun is.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from design.errors import InputError, StoreError
from design.files import write_whole
from instobj.bench.rig.mounting import Mounting
from instobj.bench.rig.plan import PressPlan, plan_of


@dataclass
class Journal:
    """Plan and progress; `finished` are the presses that are done, with what was noted.

    `session` is the recording's number for this mounting of the object.
    """

    path: Path
    plan: PressPlan
    mounting: Mounting
    session: int
    finished: dict[int, dict[str, Any]] = field(default_factory=dict)

    @property
    def remaining(self) -> list[int]:
        """Numbers of the presses to do, in their order."""
        return [k for k in range(len(self.plan)) if k not in self.finished]

    def begin(self) -> None:
        """Write the plan, unless it stands there already."""
        if not self.path.exists():
            self.path.parent.mkdir(parents=True, exist_ok=True)
            mounting = asdict(self.mounting)
            self.note("plan", plan=asdict(self.plan), mounting=mounting, session=self.session)

    def note(self, event: str, **content: Any) -> None:
        """Append what happened.

        Raises
        ------
        StoreError
            It cannot be written.
        """
        _append(self.path, {"event": event, **content})
        if event == "finished":
            self.finished[content["press"]] = content


def journal_path(recording: Path, face: int) -> Path:
    """Beside a recording, one per face."""
    return recording.with_name(f"{recording.stem}.face_{face}.rig.jsonl")


def new_journal(recording: Path, plan: PressPlan, mounting: Mounting) -> Journal:
    """The journal of a run that has not begun; its session follows those of other faces.

    Raises
    ------
    InputError
        There is one already.
    """
    path = journal_path(recording, plan.face)
    if path.exists():
        raise InputError(f"{path} is there: this run was begun. Give --resume, or another --out")
    others = len(list(recording.parent.glob(f"{recording.stem}.face_*.rig.jsonl")))
    return Journal(path, plan, mounting, others + 1)


def resumed_journal(path: Path) -> Journal:
    """The journal of a run that was interrupted; a line that was cut off is removed.

    Raises
    ------
    InputError
        There is none, or it is damaged.
    """
    try:
        content = path.read_bytes()
    except OSError:
        raise InputError(f"there is no {path} to go on from. Leave --resume out") from None
    whole = content.rfind(b"\n") + 1
    try:
        first, *rest = (json.loads(line) for line in content[:whole].splitlines())
        plan, where = plan_of(first["plan"]), first["mounting"]
        x, y, z = where["middle_mm"]
        mounting = Mounting((float(x), float(y), float(z)), float(where["turn_deg"]))
        finished = {event["press"]: event for event in rest if event["event"] == "finished"}
        session = int(first["session"])
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"{path} is damaged ({error!r}). Give another --out") from None
    if whole < len(content):
        os.truncate(path, whole)
    return Journal(path, plan, mounting, session, finished)


def _append(path: Path, document: dict[str, Any]) -> None:
    try:
        handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
        try:
            write_whole(handle, (json.dumps(document) + "\n").encode())
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as error:
        raise StoreError(f"cannot write {path}: {error.strerror}. Make room") from None
