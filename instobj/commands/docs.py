"""Pages of the documentation that messages and templates name."""

from __future__ import annotations

from pathlib import Path

from design.errors import InputError
from instobj.commands.specification_file import TEMPLATE

_PACKAGE = Path(__file__).parents[1]
_FOLDERS = (_PACKAGE / "docs", _PACKAGE.parent / "docs")
"""In an installed wheel, and in a checkout."""
_GALLERIES = (_PACKAGE / "docs" / "gallery", _PACKAGE.parent / "examples" / "gallery")
"""Scripts of the gallery, in the same two places."""
_KEYS = "specification"
"""Name under which the template with every key is printed."""


def page_names() -> list[str]:
    """Names of the pages, in order: those at the top first, then those of each folder, then the gallery's."""
    folder = _folder()
    kinds = ("", "reference", "measured", "verification")
    paths = [path for kind in kinds for path in sorted((folder / kind).glob("*.md"))]
    pages = [path.relative_to(folder).with_suffix("").as_posix() for path in paths]
    at_top = sorted({_KEYS, *(name for name in pages if "/" not in name)} - {"index"})
    below = [name for name in pages if "/" in name and name != "reference/specification"]
    return [*at_top, *below, *_scripts()]


def page_text(name: str) -> str:
    """A page (Markdown), all keys of a specification (TOML), or a script of the gallery (Python).

    Raises
    ------
    InputError
        No page has that name.
    """
    if name not in page_names():
        raise InputError(f"no page is called {name!r}. Choose one of {', '.join(page_names())}")
    if name == _KEYS:
        return TEMPLATE.read_text(encoding="utf-8")
    if name in (scripts := _scripts()):
        return scripts[name].read_text(encoding="utf-8")
    return (_folder() / f"{name}.md").read_text(encoding="utf-8")


def _scripts() -> dict[str, Path]:
    """Return the gallery's scripts by their names; none where an installation left them out."""
    folder = next((folder for folder in _GALLERIES if folder.is_dir()), None)
    paths = [] if folder is None else sorted(folder.glob("[0-9][0-9]_*.py"))
    return {f"gallery/{path.stem}": path for path in paths}


def _folder() -> Path:
    return next(folder for folder in _FOLDERS if folder.is_dir())
