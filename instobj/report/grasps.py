"""Page of `instobj assess`: the sentence first, then figure, tables, definitions and limits."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.files import atomic_path
from instobj.report.pages import render


def write_grasps_page(
    path: Path, document: dict[str, Any], figure: Path, definitions: list[list[str]]
) -> Path:
    """Write the page from the document of the command; `definitions` rows are measure, definition, source."""
    tables = [
        (title, list(rows[0]), [[_cell(value) for value in row.values()] for row in rows])
        for title, rows in document["tables"].items()
    ]
    page = render(
        "assess.html.j2", document=document, tables=tables, figure=figure, definitions=definitions
    )
    with atomic_path(path) as temporary:
        temporary.write_text(page, encoding="utf-8")
    return path


def _cell(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)
