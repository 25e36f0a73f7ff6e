"""A shared store in object storage: results that other machines made, fetched and sent whole.

The store of the machine stays what runs read and write. A result that it lacks is fetched from the
shared store, and one that the shared store lacks is sent there: the files under `<stage>/<key>/<content>/`,
which nobody changes, and last the record `<stage>/<key>/stage.json`, which names them. So a result is
there whole or not at all, also where two machines send the same one at once.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from design.errors import StoreError
from instobj.store.record import (
    RECORD,
    DamagedResult,
    content_of,
    flush_tree,
    read_record,
    result_files,
    verify,
)

if TYPE_CHECKING:
    from fsspec import AbstractFileSystem

URL = "INSTOBJ_SHARED_STORE"


@dataclass(frozen=True)
class SharedStore:
    """Object storage at a URL, by fsspec; `root` is the path within it."""

    url: str
    files: AbstractFileSystem
    root: str

    def fetch(self, stage: str, key: str, folder: Path) -> dict[str, Any] | None:
        """Fill an empty folder with a result and return its verified record; None where there is none.

        A damaged result loses its record there, so that it can be sent again.

        Raises
        ------
        DamagedResult
            What lies there is not what was sent.
        StoreError
            The storage does not answer, or refuses.
        """
        place = self._place(stage, key)
        with self._answering():
            try:
                self.files.get_file(f"{place}/{RECORD}", str(folder / RECORD))
            except FileNotFoundError:
                return None
        try:
            record = self._files_of_record(place, key, folder)
        except DamagedResult:
            with self._answering():
                self.files.rm_file(f"{place}/{RECORD}")
            raise
        flush_tree(folder)
        return record

    def _files_of_record(self, place: str, key: str, folder: Path) -> dict[str, Any]:
        record = read_record(folder)
        if record["key"] != key:
            raise DamagedResult(f"{RECORD} is of another result")
        for name in record["files"]:
            path = folder / _path_within(name)
            path.parent.mkdir(parents=True, exist_ok=True)
            with self._answering():
                try:
                    self.files.get_file(f"{place}/{content_of(record)}/{name}", str(path))
                except FileNotFoundError:
                    raise DamagedResult(f"{name} is missing") from None
        verify(folder, record, by_hash=True)
        return record

    def send(self, stage: str, key: str, folder: Path) -> None:
        """Send a whole result, unless one of that key is there.

        Raises
        ------
        StoreError
            The storage does not answer, refuses, or is full.
        """
        place = self._place(stage, key)
        with self._answering():
            if self.files.exists(f"{place}/{RECORD}"):
                return
            content = content_of(read_record(folder))
            for path in [*result_files(folder), folder / RECORD]:
                name = path.relative_to(folder).as_posix()
                target = f"{place}/{name}" if name == RECORD else f"{place}/{content}/{name}"
                self.files.put_file(str(path), target)

    def _place(self, stage: str, key: str) -> str:
        return f"{self.root}/{stage}/{key}"

    @contextmanager
    def _answering(self) -> Iterator[None]:
        try:
            yield
        except StoreError:
            raise
        except Exception as error:  # every kind of storage has errors of its own
            raise StoreError(
                f"the shared store {self.url} cannot be used: {_first_line(error)}. Results that were made "
                f"are kept in the store of this machine. Check address and credentials, or unset {URL}"
            ) from error


def shared_store() -> SharedStore | None:
    """The store that `INSTOBJ_SHARED_STORE` names (`s3://bucket/folder`); None where it is not set.

    Raises
    ------
    StoreError
        No such kind of address, or the package for it is not installed.
    """
    url = os.environ.get(URL)
    if not url:
        return None
    from fsspec.core import url_to_fs

    kind = urlsplit(url).scheme
    folders = {"auto_mkdir": True} if kind == "file" else {}  # object storage has none
    try:
        files, root = url_to_fs(url, **folders)
    except ImportError as error:
        raise StoreError(
            f"{URL} = {url} needs a package that is not installed ({error}). For s3:// install "
            f"instobj[cluster]; for {kind}:// the package of fsspec for it"
        ) from None
    except ValueError as error:
        raise StoreError(
            f"{URL} = {url} is no address that fsspec knows ({error}). Give one like s3://bucket/folder"
        ) from None
    return SharedStore(url, files, root.rstrip("/"))


def _path_within(name: str) -> PurePosixPath:
    """A file's name within its result; nothing that leads out of it."""
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts or "\\" in name or ":" in name:
        raise DamagedResult(f"{name!r} is no name within a result")
    return path


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]
