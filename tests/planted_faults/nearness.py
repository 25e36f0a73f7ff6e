"""Which tests are nearest to a file of the code, by what imports it."""

from __future__ import annotations

import ast
from collections import deque
from collections.abc import Iterator
from pathlib import Path


def importers(root: Path) -> dict[str, set[str]]:
    """File → files that import it, also inside functions; `__init__.py` files hold nothing.

    Who imports a whole package (`import fem`) goes through all of its files. Test files use what the
    `conftest.py` of their folder or of one above it imports; that of all tests makes no results.
    """
    paths = (path for path in root.rglob("*.py") if path.name != "__init__.py")
    files = {path.relative_to(root).as_posix() for path in paths}
    found: dict[str, set[str]] = {file: set() for file in files}
    for file in files:
        for imported in _imported(root, file):
            inside = [one for one in files if imported.endswith("/") and one.startswith(imported)]
            for one in [imported, *inside]:
                if one in files:
                    found[one].add(file)
        if file.endswith("/conftest.py") and file != "tests/conftest.py":
            folder = file.removesuffix("conftest.py")
            found[file] |= {one for one in files if one.startswith(folder)} - {file}
    return found


def _imported(root: Path, file: str) -> Iterator[str]:
    for node in ast.walk(ast.parse((root / file).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            for name in (node.module, *(f"{node.module}.{alias.name}" for alias in node.names)):
                yield f"{name.replace('.', '/')}.py"
        elif isinstance(node, ast.Import):
            for alias in node.names:
                yield f"{alias.name.replace('.', '/')}.py"
                if "." not in alias.name and alias.name != "instobj":  # whose names are lazy
                    yield f"{alias.name}/"


def nearest(path: str, tests: list[str], imported_by: dict[str, set[str]]) -> list[str]:
    """Tests that a fault in a file may reach, those that most likely notice it first.

    First those of the same name and room, then by how many imports lie between, those of other rooms
    one step later. The room of a file is the nearest one above it that has tests.
    """
    steps = {path: 0}
    waiting = deque([path])
    while waiting:
        file = waiting.popleft()
        for importer in sorted(imported_by.get(file, ())):
            if importer not in steps:
                steps[importer] = steps[file] + 1
                waiting.append(importer)
    own, room = f"test_{Path(path).stem}.py", room_of(path, tests)

    def rank(test: str) -> tuple[bool, int, bool]:
        file = Path(test.split("::")[0])
        elsewhere = file.parent != room
        return elsewhere or file.name != own, steps[file.as_posix()] + elsewhere, elsewhere

    return sorted((test for test in tests if test.split("::")[0] in steps), key=rank)


def room_of(path: str, tests: list[str]) -> Path | None:
    """Folder of a file's own tests: the nearest one above it that holds any."""
    rooms = {Path(test.split("::")[0]).parent for test in tests}
    return next((one for one in Path("tests", path).parents if one in rooms), None)
