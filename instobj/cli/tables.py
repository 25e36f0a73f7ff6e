"""Results as tables on a terminal."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import Any

from rich.box import SIMPLE
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table

from instobj.report.cells import shown, turned
from instobj.report.surroundings import surroundings_lines
from instobj.report.verdict import SCORES_TITLE
from instobj.store import readers

HEADLINES = ("verdict", SCORES_TITLE, "read worse than the bound", "not judged")
"""Titles of a summary with a verdict that a terminal shows; the rest is in `--json`."""
_MOST_COLUMNS = 12
_MOST_LABELS = 3
"""Leading columns that may name a row, at most."""
_LONGEST_WORD = 16
_NUMBER = re.compile(r"^[^A-Za-z/_]*\d[^A-Za-z/_]*([eE][-+]?\d+)?[^A-Za-z/_]*$")
"""A word that is one number, with its sign, unit sign or brackets."""


def print_result(result: dict[str, Any]) -> None:
    """Print the document that a command returned."""
    console = Console(highlight=False)
    for row in result.get("specifications", ()):
        console.print(
            f"{row['spec']}: valid. {row['magnets']} magnets, {row['sensors']} sensors; largest "
            f"field at rest {row['largest_field_at_rest_mt']:g} of ±{row['range_mt']:g} mT"
        )
        least, most = row["cell_areas_mm2"]
        each = f"{least:.3g}" if most < 1.005 * least else f"{least:.3g} to {most:.3g}"
        console.print(
            f"  {row['contact_locations']} contact locations cover {100 * row['covered_share']:.0f} % of "
            f"the sensed surface, {each} mm² each"
        )
        console.print(f"  {row['mass']}")
        console.print(f"  {row['outlook']}")
        console.print(
            f"  modulus {row['modulus']}. Force at a given depth: {row['force_at_a_travel']}"
        )
        for line in surroundings_lines(row["surroundings"]):
            console.print(f"  {line}")
    for item in result.get("fabrication", ()):
        _print_findings(console, item)
    for text in result.get("texts", ()):
        console.print(text)
    for item in result.get("objects", ()):
        console.rule(item["name"])
        _print_summary(console, _headlines(item["summary"]))
        if item is result["objects"][-1]:
            _print_next(console, result)
        _print_files(console, item["files"])
    if "comparison" in result:
        console.rule("comparison")
        title = (
            "medians over the contact locations that reach the force, fresh baseline unless stated. place, "
            "force: position and force bound; detect: least force that is felt; bounds read: own = the "
            "sensors of the pressed face, all = of every face"
        )
        _print_rows(console, title, turned(result["comparison"]["rows"]))
        _print_files(console, result["comparison"]["files"])
    for title, rows in result.get("tables", {}).items():
        _print_rows(console, title, rows)
    _print_files(console, result.get("files", ()))
    if not result.get("objects"):
        _print_next(console, result)


def _print_next(console: Console, result: dict[str, Any]) -> None:
    if "next" in result:
        console.print(f"next: {result['next']}", soft_wrap=True)


def _print_findings(console: Console, item: dict[str, Any]) -> None:
    """Print what did not pass, in full, and how much did."""
    console.rule(f"{item['name']}: fabrication on {item['printer']}, {item['silicone']}")
    rows = [
        {
            "status": finding["status"],
            "part": finding["part"],
            "check": finding["check"],
            "value": finding["value"],
            "limit": finding["limit"],
            "unit": finding["unit"],
            "place, mm": "" if finding["place_mm"] is None else _place(finding["place_mm"]),
        }
        for finding in item["findings"]
        if finding["status"] != "pass"
    ]
    failed = sum(row["status"] == "fail" for row in rows)
    onwards = f"stop: `build` refuses what fails ({failed})" if failed else "go on: nothing fails"
    onwards += "; warnings alone stop nothing" if len(rows) > failed else ""
    passed = len(item["findings"]) - len(rows)
    console.print(f"{passed} of {len(item['findings'])} checks pass; {onwards}")
    if rows:
        _print_rows(console, "not passed", rows)
    alike: dict[tuple[str, str, str], list[str]] = {}
    for finding in item["findings"]:
        if finding["status"] != "pass":
            key = finding["status"], finding["check"], finding["what"]
            alike.setdefault(key, []).append(finding["part"])
    for (status, check, what), parts in alike.items():
        console.print(f"{status}: {', '.join(parts)}, {check}: {what}")
    _print_files(console, item["files"])


def _place(place_mm: list[float]) -> str:
    return ", ".join(f"{value:.1f}" for value in place_mm)


def _headlines(summary: dict[str, Any]) -> dict[str, Any]:
    """Return what decides something where there is a verdict, else all there is.

    A run's verdict says what to change and its page has the scores; a score's verdict stands with them.
    """
    if "verdict" not in summary:
        return summary
    left_out = SCORES_TITLE if "what to change" in summary["verdict"] else None
    return {title: summary[title] for title in HEADLINES if title in summary and title != left_out}


def _print_summary(console: Console, summary: dict[str, Any]) -> None:
    for title, values in summary.items():
        if isinstance(values, list):
            _print_rows(console, title, values)
        elif all(isinstance(value, str) for value in values.values()):
            console.print(f"[bold]{title}[/bold]")
            for name, value in values.items():
                console.print(f"  {name}: {shown(value)}", soft_wrap=True)
        else:
            line = ", ".join(f"{name} {shown(value)}" for name, value in values.items())
            console.print(f"[bold]{title}[/bold]: {line}")


def _print_rows(console: Console, title: str, rows: list[dict[str, Any]]) -> None:
    """A table below its title; two or more where its words and numbers would not fit the width unbroken."""
    if not rows:
        console.print(f"[bold]{title}[/bold]: nothing")
        return
    names = list(dict.fromkeys(name for row in rows for name in row))
    rows = [{name: row.get(name) for name in names} for row in rows]
    console.print(title, style="table.title")
    for columns, widths in _tables(rows, console.width):
        table = Table(box=SIMPLE, padding=(0, 0, 0, 1))
        for (name, *_), width in zip(columns, widths or [None] * len(columns), strict=True):
            table.add_column(name, justify="right", width=width, overflow="fold")
        for cells in zip(*(values for _, *values in columns), strict=True):
            table.add_row(*cells)
        console.print(table)


def _tables(
    rows: list[dict[str, Any]], room: int
) -> list[tuple[list[list[str]], list[int] | None]]:
    """Columns and widths of one table, or of several: then each begins with what names the rows."""
    names = list(rows[0])
    label_count = _label_count(rows)
    labels, figures = names[:label_count], names[label_count:]
    columns, widths = _laid_out(rows, room, _words)
    if widths is None and len(figures) <= 1:
        columns, widths = _laid_out(rows, room, _numbers)
    if widths is not None or len(figures) <= 1:
        return [(columns, widths)]
    half = (len(figures) + 1) // 2
    parts = (figures[:half], figures[half:])
    return [
        table
        for part in parts
        for table in _tables([{name: row[name] for name in (*labels, *part)} for row in rows], room)
    ]


def _label_count(rows: list[dict[str, Any]]) -> int:
    """Leading columns whose values together name each row: 1 where three do not."""
    for count in range(1, _MOST_LABELS + 1):
        if len({tuple(map(shown, list(row.values())[:count])) for row in rows}) == len(rows):
            return count
    return 1


def _laid_out(
    rows: list[dict[str, Any]], room: int, kept: Callable[[list[str]], list[str]]
) -> tuple[list[list[str]], list[int] | None]:
    """Columns and their widths, transposed where they are many or their words do not fit, and of a single
    row where its names do not fit in a line.

    Where the words fit neither way only those `kept` stay whole: no widths where they fit neither way.
    """
    columns = _columns(rows)
    widths = _widths(columns, room, _parts)
    many = len(columns) > _MOST_COLUMNS and len(rows) < len(columns)
    many = many or (len(rows) == 1 and _widths(columns, room, list) is None)
    if len(columns) == 1 or (widths and not many):
        return columns, widths
    flipped = [list(line) for line in zip(*columns, strict=True)]
    flipped_widths = _widths(flipped, room, _parts)
    if flipped_widths:
        return flipped, flipped_widths
    broken = [(layout, _widths(layout, room, kept)) for layout in (columns, flipped)]
    fitting = [pair for pair in broken if pair[1]]
    return fitting[-1 if many else 0] if fitting else (columns, None)


def _columns(rows: list[dict[str, Any]]) -> list[list[str]]:
    """Name and values of every column, as printed."""
    return [[name, *(shown(row[name]) for row in rows)] for name in rows[0]]


def _widths(
    columns: list[list[str]], room: int, whole: Callable[[list[str]], list[str]]
) -> list[int] | None:
    """Characters for every column, broken between its `whole` parts; None where they do not fit.

    The widest columns are narrowed first, none below its longest whole part.
    """
    room -= 2 * len(columns) + 1
    full = [max(map(cell_len, column)) for column in columns]
    least = [max(map(cell_len, whole(column)), default=1) for column in columns]
    for most in range(max(full), 0, -1):
        widths = [max(part, min(most, width)) for part, width in zip(least, full, strict=True)]
        if sum(widths) <= room:
            return widths
    return None


def _parts(column: list[str]) -> list[str]:
    """Words of a column."""
    return " ".join(column).split()


def _words(column: list[str]) -> list[str]:
    """Words of a usual length and all that hold a number; the beginnings of others (paths, hashes)."""
    return [word if _NUMBER.search(word) else word[:_LONGEST_WORD] for word in _parts(column)]


def _numbers(column: list[str]) -> list[str]:
    """Words that hold a number, and marks as short; at least four characters of any other."""
    return [word if _NUMBER.search(word) else word[:4] for word in _parts(column)]


_OPENED_FIRST = (
    readers.REPORT.name,
    "search.html",
    readers.ASSEMBLY_SHEET.name,
    readers.PARTS_PICTURE.name,
    readers.FINDINGS_PICTURE.name,
    readers.BOUND_OVERVIEW.name,
    readers.HELD_OUT_PICTURE.name,
    readers.OVER_TIME_PICTURE.name,
    readers.ROBUSTNESS_PICTURE.name,
    readers.CALIBRATION_PICTURE.name,
)
"""Files that a person opens first, where a command wrote them."""
_ALL_NAMED = 6
"""Paths up to which all are named in a line."""


def _print_files(console: Console, files: Any) -> None:
    """Each file where they are few, else the folders; last the one to open first."""
    paths = [Path(row["path"]) for row in files]
    lines = [f"wrote {row['path']} ({_size(row['bytes'])})" for row in files]
    if len(paths) > _ALL_NAMED:
        lines = [_folder_line(folder, files) for folder in _folders(paths)]
    ranked = (
        path
        for name in _OPENED_FIRST
        for path in paths
        if f"/{path.as_posix()}".endswith(f"/{name}")
    )
    for line in (*lines, *(f"open  {path}" for path in islice(ranked, 1))):
        console.print(line, soft_wrap=True)


def _folder_line(folder: Path, files: Any) -> str:
    inside = [row["bytes"] for row in files if Path(row["path"]).is_relative_to(folder)]
    return f"wrote {len(inside)} files, {_size(sum(inside))}, to {folder}/"


def _folders(paths: list[Path]) -> list[Path]:
    """Folders of the paths that lie within no other of them."""
    parents = {path.parent for path in paths}
    return sorted(
        folder for folder in parents if not any(parent in folder.parents for parent in parents)
    )


def _size(count: int) -> str:
    return f"{count / 1e6:.1f} MB" if count >= 1e5 else f"{count / 1e3:.1f} kB"
