"""Rows of several arrays together: chosen, and put one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

from jaxtyping import Bool, Int

from estimator.inversion.model.arrays import Array, concatenated, rows_of

Kind = TypeVar("Kind", bound="Columns")


class Columns:
    """Base of frozen dataclasses all of whose fields are arrays with one row an item."""

    def __len__(self) -> int:
        return len(self._columns()[0])

    def select(self: Kind, rows: Int[Array, "n"] | Bool[Array, "all"]) -> Kind:
        """The given rows, in order."""
        return type(self)(*(rows_of(column, rows) for column in self._columns()))

    def replaced(self: Kind, rows: Int[Array, "some"], others: Kind) -> Kind:
        """The same with some rows replaced."""
        columns = [column + 0 for column in self._columns()]
        for column, replacement in zip(columns, others._columns(), strict=True):
            column[rows] = replacement
        return type(self)(*columns)

    @classmethod
    def joined(cls: type[Kind], parts: Sequence[Kind]) -> Kind:
        """Parts one after the other."""
        return cls(*map(concatenated, zip(*(part._columns() for part in parts), strict=True)))

    def _columns(self) -> list[Any]:
        return [getattr(self, name) for name in self.__dataclass_fields__]  # pyright: ignore[reportAttributeAccessIssue]
