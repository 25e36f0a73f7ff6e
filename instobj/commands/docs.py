"""Pages of the documentation that messages and templates name."""

from __future__ import annotations

from pathlib import Path

from design.errors import InputError
from instobj.commands.specification_file import TEMPLATE

_PACKAGE = Path(__file__).parents[1]
_FOLDERS = (_PACKAGE / "docs", _PACKAGE.parent / "docs")
"""In an installed wheel, and in a checkout."""
_KEYS = "specification"
"""Name under which the template with every key is printed."""


def page_names() -> list[str]:
    """Names of the pages, in order."""
    folder = _folder()
    paths = [*folder.glob("*.md"), *folder.glob("reference/*.md")]
    pages = {path.relative_to(folder).with_suffix("").as_posix() for path in paths}
    return sorted((pages - {"index", "reference/specification"}) | {_KEYS})


def page_text(name: str) -> str:
    """A page (Markdown), or all keys of a specification (TOML).

    Raises
    ------
    InputError
        No page has that name.
    """
    if name not in page_names():
        raise InputError(f"no page is called {name!r}. Choose one of {', '.join(page_names())}")
    if name == _KEYS:
        return TEMPLATE.read_text(encoding="utf-8")
    return (_folder() / f"{name}.md").read_text(encoding="utf-8")


def _folder() -> Path:
    return next(folder for folder in _FOLDERS if folder.is_dir())
