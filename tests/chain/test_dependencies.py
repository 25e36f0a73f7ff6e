"""What the packages import is what pyproject.toml declares."""

import ast
import re
import sys
import tomllib
from importlib.metadata import packages_distributions
from pathlib import Path

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj")
ON_BOARDS = ROOT / "instobj" / "firmware" / "pico"
"""MicroPython, which has modules of its own."""
IMPORTED_BY_OTHERS = {"networkx"}
"""What trimesh imports for graphs of faces, which we ask for, and does not require by itself."""


def _imports(source: str) -> set[str]:
    """Top-level names that a file imports, wherever it does."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names.add(str(node.module))
    return {name.partition(".")[0] for name in names}


def _declared() -> dict[str, Requirement]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    lines = [*project["dependencies"], *(line for extra in extras for line in extras[extra])]
    return {_key(one.name): one for one in map(Requirement, lines)}


def _key(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _undeclared(imported: set[str], declared: set[str]) -> set[str]:
    homes = packages_distributions()
    foreign = imported - set(sys.stdlib_module_names) - set(PACKAGES)
    # manifold3d, a bare extension module, stands in no list of its wheel
    return {name for name in foreign if not set(map(_key, homes.get(name, [name]))) & declared}


def test_every_import_of_the_packages_is_declared():
    files = [path for name in PACKAGES for path in (ROOT / name).rglob("*.py")]
    texts = [path.read_text() for path in files if not path.is_relative_to(ON_BOARDS)]
    imported = set().union(*map(_imports, texts)) | IMPORTED_BY_OTHERS
    assert not _undeclared(imported, set(_declared()))


def test_an_import_that_is_not_declared_is_noticed():
    source = "def f():\n    import vtkmodules.util\n    from numpy import array"
    assert _undeclared(_imports(source), {"numpy"}) == {"vtkmodules"}


def test_dependencies_have_bounds_on_both_sides():
    """Calendar versions of xarray alone have no upper one."""
    own = {name for name, one in _declared().items() if name not in ("instobj", "xarray")}
    open_ended = [
        name
        for name in sorted(own)
        if not {"<", ">="} <= {part.operator for part in _declared()[name].specifier}
    ]
    assert not open_ended
