"""HTML of which a self-contained page is made: tables, notes and pictures within the file."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from pathlib import Path

_STYLE = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")


def page(title: str, sections: Sequence[str]) -> str:
    """A whole document; sections are HTML."""
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{text(title)}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{_STYLE}</style></head>'
        f"<body><main>{''.join(sections)}</main></body></html>\n"
    )


def table(header: Sequence[str], rows: Sequence[Sequence[str]], escape: bool = True) -> str:
    """Cells are text (HTML without `escape`); pass, FAIL and NO are coloured. No names: no head."""
    clean = text if escape else str
    head = "".join(f"<th>{text(name)}</th>" for name in header) if any(header) else ""
    body = "".join(
        f"<tr>{''.join(f'<td>{_marked(clean(cell))}</td>' for cell in row)}</tr>" for row in rows
    )
    return f"<div class='scroll'><table><tr>{head}</tr>{body}</table></div>"


def note(content: str) -> str:
    """A paragraph in small grey print."""
    return f"<p class='note'>{text(content)}</p>"


def image(path: Path, alt: str) -> str:
    """A PNG within the page."""
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{text(alt)}" src="data:image/png;base64,{data}">'


def text(value: str) -> str:
    """Escaped."""
    return html.escape(value)


def _marked(cell: str) -> str:
    style = {"pass": "go", "FAIL": "no-go", "NO": "no-go"}.get(cell)
    return f"<span class='{style}'>{cell}</span>" if style else cell
