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


def read_table(file: str, row: type[Row]) -> dict[str, Row]:
    """Return the rows of `file`.toml by their names, each a dataclass of type `row`.

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
    return {name: strict.validate_python(values) for name, values in whole.items()}


def row_named(rows: Mapping[str, Row], name: str, key: str, otherwise: str = "") -> Row:
    """Return the row of that name, which `key` of a specification or an option gives.

    Raises
    ------
    InputError
        No such row; with all names, and what can be done `otherwise`.
    """
    if name not in rows:
        raise InputError(
            f"{key} = {name!r} is not in the catalogue. Choose one of {', '.join(rows)}{otherwise}"
        )
    return rows[name]
