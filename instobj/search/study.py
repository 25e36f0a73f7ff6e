"""Finished trials of a search, kept in a journal file or a database that many machines share.

Only finished trials are written, each in one go: whatever happens to a process, at most the trials
that it was working on are lost. A journal's last line may be cut short by a full disk or a power
cut; it is dropped when the journal is opened again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import optuna
from optuna.storages import BaseStorage, JournalStorage
from optuna.storages.journal import JournalFileBackend, JournalFileSymlinkLock
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, TrialState

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.search.database import first_line, open_database, patiently, without_secrets
from instobj.store.keys import content_key

_BUDGET = ("trials", "seconds", "leaders", "finalists", "polish_steps")
"""Of `[search]`: may change while a study goes on."""
_MATTERS_NOT = ("name", "as_built", "collection")
"""The study is found by its name; the others change no score on any level."""
_KEY = "specification"


@dataclass(frozen=True)
class KeptStudy:
    """A study in its storage; `where` names that for people, `say` is told when it does not answer."""

    study: optuna.Study
    where: str
    say: Callable[[str], None] = lambda text: None

    def keep(self, trials: list[FrozenTrial]) -> None:
        """Add finished trials.

        Raises
        ------
        InputError
            The storage cannot be written.
        """
        for trial in trials:
            self._asked(lambda trial=trial: self.study.add_trial(trial), "keep trials in")

    def trials(self) -> list[FrozenTrial]:
        """All finished trials, in the order in which they were kept.

        Raises
        ------
        InputError
            The storage cannot be read.
        """
        return self._asked(lambda: self.study.get_trials(deepcopy=False), "read trials from")

    def _asked(self, action: Callable[[], Any], what: str) -> Any:
        from sqlalchemy.exc import SQLAlchemyError

        try:
            return patiently(action, self.say) if "://" in self.where else action()
        except (*_FAULTS, SQLAlchemyError) as error:
            raise InputError(
                f"cannot {what} {self.where}: {first_line(error)}. What was kept before is safe: fix "
                "that, then go on with --resume"
            ) from error

    def finished(self) -> list[FrozenTrial]:
        """Those that have values."""
        return [trial for trial in self.trials() if trial.state == TrialState.COMPLETE]


_FAULTS = (OSError, optuna.exceptions.StorageInternalError)


def open_study(
    spec: ObjectSpec,
    storage: str | Path,
    resume: bool = False,
    join: bool = False,
    say: Callable[[str], None] = lambda text: None,
) -> KeptStudy:
    """The study of this specification: a new one, or with `resume` the one that is there.

    With `join` either of the two: what workers want.

    Raises
    ------
    InputError
        The storage cannot be reached or read, there is a study already (or, to resume, none), or it
        is one of another specification.
    """
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    where = without_secrets(str(storage)) if "://" in str(storage) else str(storage)
    backend = _storage(storage, where)
    known = spec.name in optuna.get_all_study_names(backend)
    if known and not (resume or join):
        raise InputError(
            f"{where} holds a search of {spec.name!r} already. Go on with --resume, or give the "
            "specification another name to start anew"
        )
    if resume and not known:
        raise InputError(
            f"{where} holds no search of {spec.name!r} to resume. Leave --resume out to start one"
        )
    study = _loaded(spec, backend) if known else _created(spec, backend)
    _require_same(study, spec, where)
    found = KeptStudy(study, where, say)
    if any("scorings" not in trial.user_attrs for trial in found.finished()):
        raise InputError(
            f"{where} holds a search of {spec.name!r} by an earlier version, which did not keep how many "
            "layouts it scored. Give the specification another name to start anew"
        )
    return found


def _loaded(spec: ObjectSpec, backend: BaseStorage) -> optuna.Study:
    """Writes nothing, unlike the creation of a study that exists."""
    sampler = optuna.samplers.RandomSampler()
    return optuna.load_study(study_name=spec.name, storage=backend, sampler=sampler)


def _created(spec: ObjectSpec, backend: BaseStorage) -> optuna.Study:
    """Or loaded, where another worker has just created it."""
    return optuna.create_study(
        study_name=spec.name,
        storage=backend,
        directions=[StudyDirection.MINIMIZE] * len(spec.search.objectives),
        load_if_exists=True,
        sampler=optuna.samplers.RandomSampler(),
    )


def study_key(spec: ObjectSpec) -> str:
    """SHA-256 of what scores on any level depend on; only the budget of the search may change."""
    alike = ObjectSpec.model_validate(spec.model_dump(mode="json"))  # defaults like what was read
    content = alike.model_dump(mode="json")
    for name in _BUDGET:
        del content["search"][name]
    del content["limits"]["use"]  # its figures stand beside it
    return content_key({name: part for name, part in content.items() if name not in _MATTERS_NOT})


def repair_journal(path: Path) -> None:
    """Drop a last line that was cut short.

    Raises
    ------
    InputError
        The file cannot be read or written, or is no journal.
    """
    if not path.is_file():
        return
    content = path.read_bytes()
    whole = content.rfind(b"\n") + 1
    first = content[: content.find(b"\n") + 1]
    if whole and b'"op_code"' not in first:
        raise InputError(
            f"{path} is no journal of a search. Move it away, or give another --storage"
        )
    if whole < len(content):
        _drop_cut_line(path)


def _drop_dangling_lock(path: Path) -> None:
    """Remove a lock that points nowhere: its process was killed in another folder, or long ago.

    Optuna gives a lock up once the file that it points to has not changed for a while; where there
    is none, it waits for ever. A lock of today points to the journal itself.
    """
    lock = Path(f"{path}.lock")
    if lock.is_symlink() and not lock.exists():
        lock.unlink(missing_ok=True)


def _drop_cut_line(path: Path) -> None:
    lock = JournalFileSymlinkLock(str(path))  # another process may just be writing that line
    lock.acquire()
    try:
        whole = path.read_bytes().rfind(b"\n") + 1
        with path.open("r+b") as stream:
            stream.truncate(whole)
    finally:
        lock.release()


def _storage(storage: str | Path, where: str) -> BaseStorage:
    if "://" in str(storage):
        return open_database(str(storage))
    path = Path(storage).resolve()  # a lock is a link to it, which must hold from any folder
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        _drop_dangling_lock(path)
        repair_journal(path)
        return JournalStorage(JournalFileBackend(str(path)))
    except OSError as error:
        raise InputError(
            f"cannot keep a search in {where}: {error.strerror}. Make room, or give another --storage"
        ) from error
    except (ValueError, KeyError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"{where} cannot be read as a journal: {first_line(error)}. Restore it from a copy, or "
            "move it away to start anew"
        ) from error


def _require_same(study: optuna.Study, spec: ObjectSpec, where: str) -> None:
    key, kept = study_key(spec), study.user_attrs.get(_KEY)
    if kept is None:
        study.set_user_attr(_KEY, key)
    elif kept != key:
        raise InputError(
            f"{where} holds a search of another specification named {spec.name!r} "
            f"({kept[:12]}, now {key[:12]}): its trials cannot be compared. Undo the change (only the "
            "budget of [search] may change), or give the specification another name"
        )
