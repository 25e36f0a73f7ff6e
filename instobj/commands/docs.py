"""Pages of the documentation that messages and templates name."""

from __future__ import annotations

from pathlib import Path

from design.errors import InputError

_PACKAGE = Path(__file__).parents[1]
_FOLDERS = (_PACKAGE / "docs", _PACKAGE.parent / "docs")
"""In an installed wheel, and in a checkout."""


def page_names() -> list[str]:
    """Names of the pages, in order."""
    return sorted(path.stem for path in _folder().glob("*.md") if path.stem != "index")


def page_text(name: str) -> str:
    """A page (Markdown).

    Raises
    ------
    InputError
        No page has that name.
    """
    if name not in page_names():
        raise InputError(f"no page is called {name!r}. Choose one of {', '.join(page_names())}")
    return (_folder() / f"{name}.md").read_text(encoding="utf-8")


def _folder() -> Path:
    return next(folder for folder in _FOLDERS if folder.is_dir())
