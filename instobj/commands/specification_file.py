"""Text of a specification to start from: lines of the template that matter, and what was placed."""

from __future__ import annotations

import os
import re
import tomllib
from pathlib import Path
from typing import Any

from design.body.kinds.base import BodyKind
from design.body.kinds.registry import KINDS
from design.placement.objects import Tables
from design.spec.body import BodySpec
from design.tables import toml_value

TEMPLATE = Path(__file__).parents[1] / "templates" / "cube.toml"
"""Every key with its default: the page `instobj docs specification`."""

ESSENTIAL = {
    "name",
    *(f"body.{key}" for key in ("kind", "size_mm", "open_faces")),
    "shell.thickness_mm",
    "silicone.name",
    *(f"magnets.{key}" for key in ("part", "diameter_mm", "height_mm", "remanence_t")),
    "magnets.positions_mm",
    *(f"sensors.{key}" for key in ("part", "count_per_face", "radius_mm", "first_azimuth_deg")),
    "score.force_n",
    "score.channels",
    *(f"limits.{key}" for key in ("use", "position_bound_mm", "detectable_force_n")),
    "search.seconds",
    *(f"search.vary.{key}" for key in ("layouts", "magnet_reach_mm", "sensor_reach_mm")),
}
"""Keys that are written next to those placed; the others have their defaults."""

_HEADING = re.compile(r"\[([\w.]+)\]")
_LINE = re.compile(r"(?:# )?(\w+) = ")
_COMMENT = re.compile(r"\s+# .*$")
_DEFAULTS = re.compile(r"^# Every value below is the default.*$", re.MULTILINE)
_COLUMN = 28
"""Column at which comments begin."""
_COMMENTS = {
    "contact_grid.count": "as many as fit on each face; or x and y for all of them, such as [10, 10]",
}
"""Comments of placed objects, where the template's are the cube's."""
_OF_BORED = {
    "body.open_faces": "[6]: a bore through -z, by whose rod the core is held while it is cast in; []: none",
    "body.bore_mm": "through the open face 6",
}
"""Those of bodies that open by a bore."""


def specification_text(name: str, out: Path, tables: Tables | None = None) -> str:
    """Return the text of `NAME.toml` in a folder: the paper's cube, or an object with placed tables."""
    text = TEMPLATE.read_text(encoding="utf-8")
    kind = KINDS[tables["body"].get("kind", BodySpec().kind) if tables else BodySpec().kind]
    values: dict[str, Any] = {"name": name, "body.kind": kind.name}
    keys = set(ESSENTIAL)
    if tables is not None:
        values |= {f"{t}.{k}": value for t, placed in tables.items() for k, value in placed.items()}
        keys = (keys | _off_default(values)) - _not_taken(kind)
        text = _DEFAULTS.sub(_about(kind), text)
    if kind.from_file:
        values["body.file"] = Path(os.path.relpath(values["body.file"], out)).as_posix()
    comments = _comments(kind) if tables is not None else {}
    text = text.replace("OTHER KINDS", ", ".join(name for name in KINDS if name != kind.name))
    return _filled(text, keys, values, comments)


def _filled(text: str, keys: set[str], values: dict[str, Any], comments: dict[str, str]) -> str:
    """Return the template's opening lines, and those of some keys with their values and tables."""
    kept: list[str] = []
    where, heading = "", ""
    for line in text.splitlines():
        table, key = _HEADING.match(line), _LINE.match(line)
        if table:
            where = table[1]
            heading = _commented(line, comments.get(where))
        name = ".".join(filter(None, (where, key[1] if key else "")))
        if key and name in keys:
            kept += ["", heading] if heading else []
            heading = ""
            filled = line_with_value(line, key[1], values[name]) if name in values else line
            kept.append(_commented(filled, comments.get(name)))
        elif not where and not key:
            kept.append(line)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(kept) + "\n")


def _off_default(values: dict[str, Any]) -> set[str]:
    """Return the dotted keys whose value differs from the template's."""
    usual = tomllib.loads(TEMPLATE.read_text(encoding="utf-8"))
    return {
        name
        for name, value in values.items()
        if "." in name and usual[name.split(".")[0]].get(name.split(".")[1]) != value
    }


def _not_taken(kind: type[BodyKind]) -> set[str]:
    """Return essential keys that a kind, or sensors placed one by one, do not take."""
    takes = {
        "body.open_faces": bool(kind.openable),
        "body.size_mm": not kind.from_file,
        "sensors.first_azimuth_deg": False,
    }
    return {key for key, taken in takes.items() if not taken}


def _comments(kind: type[BodyKind]) -> dict[str, str]:
    """Return what stands next to keys and above tables of a placed object of a kind."""
    bored = _OF_BORED if kind.openable and not kind.opens_sides else {}
    return _COMMENTS | bored | dict(kind.comments)


def _about(kind: type[BodyKind]) -> str:
    body = "body of a file" if kind.from_file else kind.name
    return (
        f"# Magnets, sensors, core and contact locations of this {body} were placed by `instobj new`;\n"
        "# every other value is that of the cube of Knopke et al., RA-L 2024."
    )


def _commented(line: str, comment: str | None) -> str:
    """Return a line with another comment, in the same column; None keeps its own."""
    if comment is None:
        return line
    gap = re.search(r"\s+(?=# [^#]*$)", line)
    return _COMMENT.sub(f"{gap[0] if gap else '  '}# {comment}", line)


def line_with_value(line: str, key: str, value: Any) -> str:
    """Return a line of TOML with another value; its comment stays, in its column where there is room."""
    comment = _COMMENT.search(line)
    written = f"{key} = {toml_value(value)}"
    past = "" if len(written) < _COLUMN else "    "
    return f"{written:<{_COLUMN}}{past}{comment[0].strip()}" if comment else written
