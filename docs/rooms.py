"""The map of the code in docs/architecture.md: the table of rooms, and the figure of their floors.

A room is a folder of modules. Floors are those that import-linter holds (pyproject.toml): a room
may use the rooms below it. After a change of rooms or floors run `python docs/rooms.py`; a test
compares.
"""

from __future__ import annotations

import ast
import sys
import tomllib
from html import escape
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "architecture.md"
FIGURE = ROOT / "docs" / "rooms.svg"
BEGIN, END = "<!-- rooms: written by docs/rooms.py -->", "<!-- end of rooms -->"

PACKAGES = ("design", "fem", "estimator", "instobj")
QUESTIONS = {
    "design": "What is the object?",
    "fem": "How does it deform?",
    "estimator": "What do the signals tell?",
    "instobj": "What does a user run?",
}
COLUMN, ROW, GAP, TOP = 236, 30, 8, 92
"""Of the figure: width of a package, height of a room, space between, where floors begin."""


def rooms(package: str) -> list[str]:
    """Dotted names of a package's rooms, inner ones after the one that holds them."""
    found = sorted((ROOT / package).rglob("__init__.py"))
    return [".".join(path.parent.relative_to(ROOT).parts) for path in found[1:]]


def first_line(name: str) -> str:
    """First line of the docstring of a room or a module."""
    path = ROOT.joinpath(*name.split("."))
    file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    docstring = ast.get_docstring(ast.parse(file.read_text())) or ""
    return docstring.partition("\n")[0]


def floors(package: str) -> list[list[str]]:
    """Rooms and modules of a package floor by floor, the uppermost first.

    Rooms of which no contract speaks stand on one floor of their own, below the others.
    """
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())
    contracts = [c for c in settings["tool"]["importlinter"]["contracts"] if c["type"] == "layers"]
    layers: list[str] = next(
        (c["layers"] for c in contracts if all(_inside(layer, package) for layer in c["layers"])),
        [],
    )
    stacked = [[name.strip() for name in layer.split("|")] for layer in layers]
    named = {name for floor in stacked for name in floor}
    outer = [room for room in rooms(package) if room.count(".") == 1]
    left = [room for room in outer if room not in named]
    return [*stacked, left] if left else stacked


def _inside(layer: str, package: str) -> bool:
    return all(name.strip().startswith(f"{package}.") for name in layer.split("|"))


def table() -> str:
    """One table per package: its rooms, and what each holds (Markdown)."""
    blocks = []
    for package in PACKAGES:
        rows = [f"| `{room.replace('.', '/')}` | {first_line(room)} |" for room in rooms(package)]
        blocks.append("\n".join([f"| `{package}` | {QUESTIONS[package]} |", "|---|---|", *rows]))
    return "\n\n".join(blocks)


def page_with_table(page: str) -> str:
    """The page with the tables between its two marks made anew."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n\n{table()}\n\n{END}{after}"


def figure() -> str:
    """Floors of the four packages side by side (SVG)."""
    columns = [_column(package, GAP + k * (COLUMN + GAP)) for k, package in enumerate(PACKAGES)]
    high = max(bottom for _, bottom in columns)
    wide = GAP + len(PACKAGES) * (COLUMN + GAP)
    frames = [
        f'<rect x="{GAP + k * (COLUMN + GAP)}" y="44" width="{COLUMN}" height="{high - 44}" rx="8" '
        'fill="none" stroke="#bbb"/>'
        for k in range(len(PACKAGES))
    ]
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high + GAP}" '
        'font-family="system-ui, sans-serif" font-size="14">'
        f'<rect width="{wide}" height="{high + GAP}" fill="#fff"/>'
        '<text x="8" y="28" font-size="16" font-weight="700" fill="#222">A package uses those to '
        "its left, a room those on the floors below it</text>"
    )
    return "\n".join([head, *frames, *(drawn for drawn, _ in columns), "</svg>\n"])


def _column(package: str, left: int) -> tuple[str, int]:
    """A package's floors, and where they end."""
    lines = [_text(left + 12, 66, package, 'font-weight="700" font-size="15"')]
    lines.append(_text(left + 12, 83, QUESTIONS[package], 'font-size="9.5" fill="#555"'))
    top = TOP
    for floor in floors(package):
        for start in range(0, len(floor), 2):
            pair = floor[start : start + 2]
            lines += [_box(name, left, top, k, len(pair)) for k, name in enumerate(pair)]
            top += ROW + 4
        top += GAP - 4
    return "\n".join(lines), top + 2


def _box(name: str, left: int, top: int, index: int, count: int) -> str:
    wide = (COLUMN - 2 * GAP - (count - 1) * 4) / count
    x = left + GAP + index * (wide + 4)
    label = name.partition(".")[2]
    return (
        f'<rect x="{x:g}" y="{top}" width="{wide:g}" height="{ROW}" rx="5" fill="#eef3f8" '
        f'stroke="#1b6ca8"><title>{escape(first_line(name))}</title></rect>'
        + _text(x + wide / 2, top + 20, label, 'text-anchor="middle"')
    )


def _text(x: float, y: float, text: str, style: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" {style}>{escape(text)}</text>'


def main() -> None:
    """Write the tables and the figure."""
    from design.files import atomic_path

    for path, text in ((PAGE, page_with_table(PAGE.read_text())), (FIGURE, figure())):
        with atomic_path(path) as part:
            part.write_text(text)
        print(f"wrote {path.relative_to(ROOT)}")


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT))
    main()
