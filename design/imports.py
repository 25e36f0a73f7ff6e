"""Modules that wait to be loaded until they are asked for."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from types import ModuleType
from typing import Any

EXTRAS = {
    "aiohttp": "bench",
    "serial": "bench",
    "onnx": "deploy",
    "onnxruntime": "deploy",
    "onnxscript": "deploy",
    "dask": "cluster",
    "distributed": "cluster",
    "fsspec": "cluster",
    "s3fs": "cluster",
    "anywidget": "notebook",
    "traitlets": "notebook",
    "rosbags": "robot",
    "pyarrow": "robot",
    "foxglove": "robot",
}
"""Module → extra of instobj that brings it; a test compares with pyproject.toml."""


def missing_extra(error: ImportError) -> str | None:
    """Return how to install a module that an extra brings; None where it is no extra's."""
    module = (error.name or "").partition(".")[0]
    if module not in EXTRAS:
        return None
    return (
        f"this needs {module}, which is not installed. Run: pip install 'instobj[{EXTRAS[module]}]'"
    )


@contextmanager
def deferred(*names: str) -> Iterator[None]:
    """Defer imports: modules imported inside come empty, and are loaded at the first question, also
    after this. Modules that are there already stay."""
    waiting = {name: _Deferred(name) for name in names if name not in sys.modules}
    sys.modules.update(waiting)
    try:
        yield
    finally:
        for name, module in waiting.items():
            if sys.modules.get(name) is module:
                del sys.modules[name]


class _Deferred(ModuleType):
    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("__"):  # the import system's own questions
            raise AttributeError(attribute)
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), attribute)
