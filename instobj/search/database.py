"""Databases that many machines share for one search: opened, asked again, never quoted with secrets."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import optuna
from optuna.storages import RDBStorage

from design.errors import InputError

_PAUSES_S = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 60.0)
"""Two minutes in all: a server's restart takes less."""
_OPENING_PAUSES_S = (0.2, 0.4, 0.8, 1.6)
_MADE_MEANWHILE = ("already exists", "duplicate key", "UNIQUE constraint")
"""What databases say where another worker has just made the tables."""
_HIDDEN = "***"
_SECRET_KEYS = ("password", "passwd", "pwd", "sslpassword", "token")

Say = Callable[[str], None]
Answer = TypeVar("Answer")


def open_database(url: str) -> RDBStorage:
    """Optuna's tables in a database, made where they are missing.

    Workers that start together make the tables at the same time; those that come second try again.

    Raises
    ------
    InputError
        Not an address, no driver for it, or nobody answers there.
    """
    where = without_secrets(url)
    try:
        return again_after(
            _OPENING_PAUSES_S,
            lambda: RDBStorage(url, engine_kwargs={"pool_pre_ping": True}),
            lambda error: any(known in str(error) for known in _MADE_MEANWHILE),
        )
    except ImportError as error:
        raise InputError(
            f"the database {where} needs a driver: {first_line(error)}. `pip install "
            "'instobj[cluster]'` brings that of PostgreSQL"
        ) from None
    except Exception as error:  # drivers raise errors that share no base class
        raise InputError(
            f"cannot reach the database {where}: {_scrubbed(first_line(error), url)}. Check that it "
            "runs, its address, user and password"
        ) from None


def patiently(
    action: Callable[[], Answer], say: Say, sleep: Callable[[float], Any] = time.sleep
) -> Answer:
    """What `action` returns; a database that does not answer is asked again for two minutes.

    Raises
    ------
    optuna.exceptions.StorageInternalError, sqlalchemy.exc.SQLAlchemyError
        It still does not answer.
    """
    from sqlalchemy.exc import SQLAlchemyError

    def told(pause_s: float) -> None:
        say(f"the database does not answer; again in {pause_s:g} s")
        sleep(pause_s)

    lost = (optuna.exceptions.StorageInternalError, SQLAlchemyError)
    return again_after(_PAUSES_S, action, lambda error: isinstance(error, lost), told)


def again_after(
    pauses_s: Iterable[float],
    action: Callable[[], Answer],
    passes: Callable[[Exception], bool],
    sleep: Callable[[float], Any] | None = None,
) -> Answer:
    """What `action` returns, tried again after each pause where its error is one that passes."""
    for pause_s in pauses_s:
        try:
            return action()
        except Exception as error:
            if not passes(error):
                raise
            (sleep or time.sleep)(pause_s)
    return action()


def without_secrets(url: str) -> str:
    """An address for people: passwords in it or in its query are not shown."""
    from sqlalchemy.engine import make_url

    try:
        parsed = make_url(url)
    except Exception:  # a malformed address: show no more than its kind
        return f"{url.partition('://')[0]}://…"
    query = {
        key: _HIDDEN if any(secret in key.lower() for secret in _SECRET_KEYS) else value
        for key, value in parsed.query.items()
    }
    return parsed.set(query=query).render_as_string(hide_password=True)


def first_line(error: BaseException) -> str:
    """An error's cause in one line."""
    cause = error.__cause__ if error.__cause__ is not None else error
    return str(cause).strip().splitlines()[0] if str(cause).strip() else type(cause).__name__


def _scrubbed(text: str, url: str) -> str:
    """Drivers quote what they were given: without the address and its secrets."""
    from sqlalchemy.engine import make_url

    secrets = [url]
    try:
        parsed = make_url(url)
    except Exception:
        return "it is not an address such as postgresql+psycopg://user:password@host:5432/name"
    secrets += [parsed.password] if parsed.password else []
    for key, value in parsed.query.items():
        if any(secret in key.lower() for secret in _SECRET_KEYS):
            secrets += [value] if isinstance(value, str) else list(value)
    for secret in secrets:
        text = text.replace(str(secret), _HIDDEN)
    return text
