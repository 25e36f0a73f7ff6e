"""Tables of what can be bought, in the TOML files of this folder, and look-ups in them by name."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import TypeVar

from pydantic import ConfigDict, TypeAdapter, with_config

from design.errors import InputError

Row = TypeVar("Row")


class Catalogue(dict[str, Row]):
    """Rows by their names.

    Attributes
    ----------
    key : what gives a name, a key of a specification or an option
    otherwise : what can be done where no row fits, behind the names
    """

    def __init__(self, rows: Mapping[str, Row], key: str, otherwise: str) -> None:
        super().__init__(rows)
        self.key, self.otherwise = key, otherwise

    def named(self, name: str) -> Row:
        """Return the row of that name.

        Raises
        ------
        InputError
            No such row.
        """
        if name not in self:
            raise InputError(
                f"{self.key} = {name!r} is not in the catalogue. Choose one of {', '.join(self)}"
                f"{self.otherwise}"
            )
        return self[name]


def read_table(file: str, row: type[Row], key: str = "name", otherwise: str = "") -> Catalogue[Row]:
    """Return the rows of `file`.toml by their names, each a dataclass of type `row`; with `key` and
    `otherwise` as in `Catalogue`.

    Rows hold their name where they have a field for it. A row with the key `like` has what it does not
    give from that earlier row. A key that is no field, or a value of another type, is a fault of the
    file, which pydantic reports.
    """
    text = (Path(__file__).parent / f"{file}.toml").read_text(encoding="utf-8")
    named = any(field.name == "name" for field in fields(row))  # pyright: ignore[reportArgumentType]
    strict = TypeAdapter(with_config(ConfigDict(extra="forbid"))(row))
    whole: dict[str, dict[str, object]] = {}
    for name, values in tomllib.loads(text).items():
        base = whole[values.pop("like")] if "like" in values else {}
        whole[name] = base | values | ({"name": name} if named else {})
    rows = {name: strict.validate_python(values) for name, values in whole.items()}
    return Catalogue(rows, key, otherwise)
