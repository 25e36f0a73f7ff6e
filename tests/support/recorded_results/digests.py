"""Arguments and results of functions as a few numbers.

Arrays become their size, Σ|v| and Σ v cos(1.3 k + 0.7): a change of any entry, its sign or its place
shows. Texts, truth and kinds become a checksum.
"""

from __future__ import annotations

import weakref
import zlib
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import lru_cache, partial
from pathlib import Path
from types import BuiltinFunctionType, FunctionType
from typing import Any

import numpy as np
import scipy.sparse as sp

PACKAGES = ("design.", "fem.", "estimator.")
MOST_NUMBERS = 200_000
MOST_OF_ARGUMENTS = 2_000
"""Of an array; of a longer one, evenly spaced entries (of an argument also the sum of all)."""
MOST_BYTES = 2_000_000
"""Of a file that is read for its checksum."""
MOST_LEAVES = 6
"""Of a result that are kept apart; further ones are put together in turn."""
_DEEPEST = 12
_CHECKOUT = str(Path(__file__).parents[3])
"""Absolute paths count from here."""


class Opaque(Exception):
    """Something whose content cannot be told."""


class Digest:
    """Texts and numbers of a value, in order."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.numbers: list[np.ndarray] = []

    def checksum(self) -> int:
        return zlib.crc32("\n".join(self.texts).replace(_CHECKOUT, "").encode())

    def sums(self) -> list[tuple[int, float, float]]:
        """Size, Σ|v| and Σ v cos(…) of each array, or of every `MOST_LEAVES`-th put together."""
        groups = self.numbers
        if len(groups) > MOST_LEAVES:
            groups = [np.concatenate(groups[k::MOST_LEAVES]) for k in range(MOST_LEAVES)]
        return [_sums(group, MOST_NUMBERS)[:3] for group in groups]


def of_result(value: Any) -> tuple[int, list[tuple[int, float, float]]]:
    """Checksum of the texts and sums of the numbers; what cannot be told is left out."""
    digest = Digest()
    _add(digest, value, lenient=True)
    return digest.checksum(), digest.sums()


def of_arguments(*values: Any) -> str:
    """Key of arguments, the same for numbers that agree to some six digits.

    Raises `Opaque` for arguments that hold files without end, processes, networks and the like.
    """
    digest = Digest()
    for value in values:
        _add(digest, value, lenient=False)
    sums = (_sums(group, MOST_OF_ARGUMENTS) for group in digest.numbers)
    texts = [f"{size} {_short(a)} {_short(b)} {_short(c)}" for size, a, b, c in sums]
    whole = "\n".join([*digest.texts, *texts]).replace(_CHECKOUT, "")
    return f"{zlib.crc32(whole.encode()):08x}"


def _short(number: float) -> str:
    return "0" if abs(number) < 1e-9 else f"{number:.6e}"


def _sums(values: np.ndarray, most: int) -> tuple[int, float, float, float]:
    """Size, Σ|v|, Σ v cos(…) and Σ v, the last of more entries."""
    size, whole = values.size, 0.0
    if size > most:
        whole = float(values[:: size // 1_000_000 + 1].sum())
        values = values[:: size // most + 1]
    finite = np.isfinite(values)
    if not finite.all():
        size += 1_000_003 * int((~finite).sum())
        values, whole = np.where(finite, values, 0.0), 0.0
    return size, float(abs(values).sum()), float(values @ _turned(values.size)), whole


@lru_cache(maxsize=2_000)
def _turned(size: int) -> np.ndarray:
    return np.cos(1.3 * np.arange(size) + 0.7)


def _add(digest: Digest, value: Any, lenient: bool, depth: int = 0) -> None:
    try:
        _add_known(digest, value, lenient, depth)
    except Opaque:
        if not lenient:
            raise
        digest.texts.append(type(value).__qualname__)


def _add_known(digest: Digest, value: Any, lenient: bool, depth: int) -> None:
    if depth > _DEEPEST:
        raise Opaque
    if value is None or isinstance(value, str | bytes | bool | np.bool_ | Enum | np.str_):
        digest.texts.append(repr(value))
    elif isinstance(value, int | float | complex | np.number):
        _add_array(digest, np.asarray(value), lenient, depth)
    elif isinstance(value, np.ndarray):
        _add_array(digest, value, lenient, depth)
    else:
        digest.texts.append(type(value).__qualname__)
        for name, part in _parts(value, lenient):
            digest.texts.append(name)
            _add(digest, part, lenient, depth + 1)


def _add_array(digest: Digest, value: np.ndarray, lenient: bool, depth: int) -> None:
    if value.dtype == object:
        for part in value.flat:
            _add(digest, part, lenient, depth + 1)
    elif value.dtype.kind in "biuf":
        if value.ndim:
            digest.texts.append(f"{value.dtype.kind}{value.shape}")
        digest.numbers.append(np.asarray(value, float).ravel())
    elif value.dtype.kind == "c":
        digest.numbers.append(
            np.concatenate([value.real.ravel(), value.imag.ravel()]).astype(float)
        )
    else:
        digest.texts.append(f"{zlib.crc32(repr(value.tolist()).encode())}")


def _parts(value: Any, lenient: bool) -> Iterator[tuple[str, Any]]:
    """Named parts of something that is made of others."""
    if isinstance(value, list | tuple):
        yield from (("", part) for part in value)
    elif isinstance(value, dict):
        yield from (
            (repr(key) if isinstance(key, str | int | tuple) else "", part)
            for key, part in value.items()
        )
    elif isinstance(value, set | frozenset):
        yield from (("", part) for part in sorted(value, key=repr))
    elif isinstance(value, range | slice):
        yield repr(value), None
    elif isinstance(value, Path):
        yield from _of_path(value, lenient)
    elif isinstance(value, np.random.Generator):
        yield repr(value.bit_generator.state), None
    elif sp.issparse(value):
        entries = sp.coo_array(value)
        yield "", entries.shape
        yield "", np.asarray(entries.data) * np.cos(entries.row + 0.3) * np.cos(0.7 * entries.col)
    elif hasattr(value, "model_dump") and not isinstance(value, type):
        yield _of_model(value), None
    elif is_dataclass(value) and not isinstance(value, type):
        yield from ((field.name, getattr(value, field.name, None)) for field in fields(value))
    else:
        yield from _of_foreign(value, lenient)


_models: dict[int, str] = {}
"""Checksums of the parts of specifications that live, which cannot change, by their identity."""


def _of_model(value: Any) -> str:
    key = id(value)
    if key not in _models:
        _models[key] = f"{zlib.crc32(value.model_dump_json().replace(_CHECKOUT, '').encode()):08x}"
        weakref.finalize(value, _models.pop, key, None)
    return _models[key]


def _of_foreign(value: Any, lenient: bool) -> Iterator[tuple[str, Any]]:
    kind = type(value)
    module = f"{kind.__module__}."
    if module == "torch." and kind.__name__ in ("Tensor", "Parameter"):
        yield "", value.detach().cpu().numpy()
    elif module.startswith("torch.") and kind.__name__ in ("dtype", "device"):
        yield repr(value), None
    elif module.startswith("skfem.mesh"):
        yield "", value.p
        yield "", value.t
    elif kind.__name__ == "Trimesh":
        yield "", value.vertices.view(np.ndarray)
        yield "", value.faces.view(np.ndarray)
    elif kind.__name__ == "DataArray":
        yield "", value.values
    elif isinstance(value, type | BuiltinFunctionType) or (
        isinstance(value, FunctionType)
        and not lenient
        and not value.__closure__
        and "<" not in value.__qualname__
    ):
        yield f"{value.__module__}.{value.__qualname__}", None
    elif isinstance(value, partial) and not lenient:
        yield "", (value.func, value.args, value.keywords)
    elif module.startswith(PACKAGES) and hasattr(value, "__dict__"):
        yield "", vars(value)
    elif lenient and kind.__module__.startswith("cadquery") and hasattr(value, "BoundingBox"):
        box = value.BoundingBox()
        yield "", [box.xmin, box.xmax, box.ymin, box.ymax, box.zmin, box.zmax]
        yield "", [len(value.Faces()), len(value.Edges())]
    else:
        raise Opaque


def _of_path(path: Path, lenient: bool) -> Iterator[tuple[str, Any]]:
    try:
        folder = path.is_dir()
    except OSError:  # a name that no file can have
        raise Opaque from None
    if folder:
        raise Opaque
    if lenient or not path.is_file():
        yield path.suffix, None
    elif path.stat().st_size > MOST_BYTES:
        raise Opaque
    else:
        yield f"{path.suffix} {zlib.crc32(path.read_bytes())}", None
