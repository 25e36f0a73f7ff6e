"""Finished trials of a search, kept in a journal file or a database that many machines share.

Only finished trials are written, each in one go: whatever happens to a process, at most the trials
that it was working on are lost. A journal's last line may be cut short by a full disk or a power
cut; it is dropped when the journal is opened again.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import optuna
from optuna.storages import BaseStorage, JournalStorage, RDBStorage
from optuna.storages.journal import JournalFileBackend, JournalFileSymlinkLock
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, TrialState

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.store.content import content_key

_BUDGET = ("trials", "seconds", "trial_seconds", "batch", "leaders", "finalists", "polish_steps")
"""Of `[search]`: may change while a study goes on."""
_MATTERS = (
    *("arrangement", "body", "shell", "silicone", "magnets", "core", "sensors", "contact_grid"),
    *("indenter", "press", "mesh", "mechanics", "score", "limits", "search"),
)
_KEY = "specification"


@dataclass(frozen=True)
class KeptStudy:
    """A study in its storage; `where` names that for people."""

    study: optuna.Study
    where: str

    def keep(self, trials: list[FrozenTrial]) -> None:
        """Add finished trials.

        Raises
        ------
        InputError
            The storage cannot be written.
        """
        try:
            self.study.add_trials(trials)
        except _FAULTS as error:
            raise InputError(
                f"cannot keep trials in {self.where}: {_first_line(error)}. What was kept before is "
                "safe: mend that, then go on with --resume"
            ) from error

    def trials(self) -> list[FrozenTrial]:
        """All finished trials, in the order in which they were kept."""
        return self.study.get_trials(deepcopy=False)

    def finished(self) -> list[FrozenTrial]:
        """Those that have values."""
        return [trial for trial in self.trials() if trial.state == TrialState.COMPLETE]


_FAULTS = (OSError, optuna.exceptions.StorageInternalError)


def open_study(
    spec: ObjectSpec, storage: str | Path, resume: bool = False, join: bool = False
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
    where = _without_password(str(storage))
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
    return KeptStudy(study, where)


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
    """SHA-256 of what trials depend on: the budget of the search, training and so on may change."""
    alike = ObjectSpec.model_validate(spec.model_dump(mode="json"))  # defaults like what was read
    content = alike.model_dump(mode="json")
    for name in _BUDGET:
        del content["search"][name]
    return content_key({name: content[name] for name in _MATTERS})


def mend_journal(path: Path) -> None:
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
        return _database(str(storage), where)
    path = Path(storage)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        mend_journal(path)
        return JournalStorage(JournalFileBackend(str(path)))
    except OSError as error:
        raise InputError(
            f"cannot keep a search in {where}: {error.strerror}. Make room, or give another --storage"
        ) from error
    except (ValueError, KeyError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"{where} cannot be read as a journal: {_first_line(error)}. Restore it from a copy, or "
            "move it away to start anew"
        ) from error


def _database(url: str, where: str) -> BaseStorage:
    import sqlalchemy.exc

    try:
        return RDBStorage(url, engine_kwargs={"pool_pre_ping": True})
    except (sqlalchemy.exc.SQLAlchemyError, *_FAULTS) as error:
        raise InputError(
            f"cannot reach the database {where}: {_first_line(error)}. Check that it runs, its "
            "address, user and password"
        ) from error
    except ImportError as error:
        raise InputError(
            f"the database {where} needs a driver: {_first_line(error)}. `pip install "
            "instobj[postgresql]` brings that of PostgreSQL"
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


def _without_password(url: str) -> str:
    head, at, tail = url.rpartition("@")
    if not at or "://" not in head:
        return url
    scheme, _, user = head.partition("://")
    return f"{scheme}://{user.partition(':')[0]}@{tail}"


def _first_line(error: BaseException) -> str:
    cause = error.__cause__ if error.__cause__ is not None else error
    return str(cause).strip().splitlines()[0] if str(cause).strip() else type(cause).__name__
