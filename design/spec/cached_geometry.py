"""Geometry of a specification, computed once.

Frames, pockets, layouts and the mould's frame follow from a specification alone and are asked for
at more than a hundred places. A function marked `cached_geometry` keeps its result for as long as the
specification lives. That is sound because specifications are frozen: a change makes another object
(`SpecPart.changed`), for which everything is computed again. Results are shared, so their arrays are
made read-only.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cache, wraps
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

Found = TypeVar("Found")
KEPT_RESULTS: dict[int, dict[str, Any]] = {}
"""Results by the identity of a living specification, then by function; hashing its content costs more than
most of what is kept here."""
_PLAIN = frozenset((float, np.float64, int, bool, str, type(None)))


@dataclass(frozen=True)
class SpecAlike:
    """A specification and the key by which it equals others: the parts on which a result depends, with the
    digest of a body's file, and what the result is of.

    Functions with `lru_cache` take it, for costly results that many specifications share.
    """

    spec: ObjectSpec = field(compare=False)
    key: tuple[Any, ...]


def cached_geometry(work_out: Callable[[ObjectSpec], Found]) -> Callable[[ObjectSpec], Found]:
    """Keep the result of a function of a specification, computed once for each specification object."""
    name = f"{work_out.__module__}.{work_out.__qualname__}"

    @wraps(work_out)
    def kept(spec: ObjectSpec) -> Found:
        results = _results_of(spec)
        if name not in results:
            results[name] = read_only(work_out(spec))
        return results[name]

    return kept


def _results_of(spec: ObjectSpec) -> dict[str, Any]:
    key = id(spec)
    if key not in KEPT_RESULTS:
        KEPT_RESULTS[key] = {}
        weakref.finalize(spec, KEPT_RESULTS.pop, key, None)
    return KEPT_RESULTS[key]


def read_only(result: Any) -> Any:
    """The result, every array in its tuples and dataclasses locked."""
    if isinstance(result, np.ndarray):
        result.flags.writeable = False
        return result
    parts = result if isinstance(result, tuple) else _values(result)
    for part in parts:
        if type(part) not in _PLAIN:  # most of what results hold
            read_only(part)
    return result


def _values(result: Any) -> list[Any]:
    return [getattr(result, name) for name in _field_names(type(result))]


@cache
def _field_names(kind: type) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else ()
