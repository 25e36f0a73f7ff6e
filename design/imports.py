"""Modules that wait to be loaded until they are asked for."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module, metadata
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
    "mcap": "robot",
    "foxglove": "robot",
}
"""Module → extra of instobj that brings it; a test compares with pyproject.toml."""


LIGHT = "instobj-robot"
"""Distribution of the same packages without what only designs and trains (`robot/pyproject.toml`)."""


def missing_extra(error: ImportError) -> str | None:
    """Return how to install a module that an extra or the whole of instobj brings; None for others."""
    module = (error.name or "").partition(".")[0]
    offered = _extras_of_light()
    if module not in EXTRAS and offered is None:
        return None
    extra = EXTRAS.get(module)
    source = LIGHT if extra in (offered or ()) else "instobj"
    wanted = f"'{source}[{extra}]'" if extra else source
    return f"this needs {module}, which is not installed. Run: pip install {wanted}"


def _extras_of_light() -> list[str] | None:
    """Return the extras of the light distribution; None where it is not what is installed."""
    try:
        return metadata.metadata(LIGHT).get_all("Provides-Extra", [])
    except metadata.PackageNotFoundError:
        return None


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
