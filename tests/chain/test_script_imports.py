"""Every module and name of this repository that a script imports exists: nothing runs most scripts."""

import ast
import sys
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest

import instobj

ROOT = Path(__file__).parents[2]
SCRIPTS = ("benchmarks", "docs", "examples", "studies", "robot", "ros2")
ROOTS = (ROOT, ROOT / "benchmarks", ROOT / "docs", ROOT / "ros2" / "instobj_ros")
"""Folders in which a script's imports are looked up, with the script's own folder."""
NOT_INSTALLED = {"ament_index_python", "geometry_msgs", "instobj_msgs", "launch", "launch_ros",
                 "netgen", "ngsolve", "rclpy", "setuptools", "std_msgs"}  # fmt: skip
"""Packages of ROS 2 and NGSolve, which the tests do not need."""


def module_path(name, roots):
    """Return the file or folder of a module, None where the repository has none of that name."""
    for root in roots:
        path = root.joinpath(*name.split("."))
        if path.with_suffix(".py").is_file():
            return path.with_suffix(".py")
        if path.is_dir() and any(path.rglob("*.py")):
            return path
    return None


def _is_known(package):
    return package in sys.stdlib_module_names or find_spec(package) is not None


@cache
def bound_names(file):
    """Return the names that a module binds outside its functions and classes."""
    if file == Path(instobj.__file__):
        return set(instobj.__all__) | set(instobj.HOME_OF)
    names, waiting = set(), [ast.parse(file.read_text(encoding="utf-8"))]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            names.add(node.name)
            continue
        if isinstance(node, ast.alias):
            names.add((node.asname or node.name).partition(".")[0])
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names.add(node.id)
        waiting.extend(ast.iter_child_nodes(node))
    return names


def _has_name(path, name, roots, module):
    if path.is_dir() and module_path(f"{module}.{name}", roots):
        return True
    file = path / "__init__.py" if path.is_dir() else path
    return name == "*" or (file.is_file() and name in bound_names(file))


def missing_imports(source, folder):
    """Return what a script of a folder imports and neither the repository nor Python has."""
    for node in ast.walk(ast.parse(source)):
        roots = (folder, *ROOTS)
        if isinstance(node, ast.Import):
            wanted = [(alias.name, ()) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            if node.level:
                roots = ((folder, *folder.parents)[node.level - 1],)
            wanted = [(node.module or "", [alias.name for alias in node.names])]
        else:
            continue
        for module, names in wanted:
            package = module.partition(".")[0]
            if package in NOT_INSTALLED:
                continue
            path = module_path(module, roots)
            if path is None:
                if module_path(package, roots) or not _is_known(package):
                    yield module
            else:
                yield from (f"{module}.{name}" for name in names
                            if not _has_name(path, name, roots, module))  # fmt: skip


def test_what_scripts_import_exists():
    files = [file for folder in SCRIPTS for file in sorted((ROOT / folder).rglob("*.py"))]
    missing = {
        str(file.relative_to(ROOT)): names
        for file in files
        if (names := [*missing_imports(file.read_text("utf-8"), file.parent)])
    }
    assert len(files) > 50
    assert not missing


@pytest.mark.parametrize(
    ("line", "missing"),
    [
        ("from studies.recorded.no_study import rest", ["studies.recorded.no_study"]),
        ("def f():\n    from studies.registry import Study, no_name", ["studies.registry.no_name"]),
        ("from design.spec import object, no_module", ["design.spec.no_module"]),
        ("from instobj import load_spec, no_name", ["instobj.no_name"]),
        ("import no_neighbour", ["no_neighbour"]),
        ("import harness, design.no_room, numpy.no_name", ["design.no_room"]),
    ],
)
def test_a_missing_module_or_name_is_noticed(line, missing):
    assert [*missing_imports(line, ROOT / "benchmarks")] == missing
