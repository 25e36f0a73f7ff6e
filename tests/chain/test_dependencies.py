"""What the packages import is what pyproject.toml declares."""

import ast
import re
import subprocess
import sys
import tomllib
from importlib.metadata import packages_distributions, requires
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from design.imports import EXTRAS

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj", "studies")
ON_BOARDS = ROOT / "instobj" / "bench" / "firmware" / "micropython"
"""MicroPython, which has modules of its own."""
IMPORTED_BY_OTHERS = {"networkx": "torch"}
"""What trimesh imports for graphs of faces, which we ask for, and does not require → who does."""
CORES = {"pydantic_core": "pydantic", "OCP": "cadquery", "vtkmodules": "pyvista"}
"""Compiled core of a declared package, which bounds its versions on both sides → that package."""
HOMES = {
    "networkx": "networkx",
    "pydantic_core": "pydantic-core",
    "OCP": "cadquery-ocp",
    "vtkmodules": "vtk",
}
"""Module → distribution."""
MOST_MANDATORY = 22


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
    foreign = imported - set(sys.stdlib_module_names) - set(PACKAGES) - set(CORES)
    # manifold3d, a bare extension module, stands in no list of its wheel
    return {name for name in foreign if not set(map(_key, homes.get(name, [name]))) & declared}


def test_every_import_of_the_packages_is_declared():
    files = [path for name in PACKAGES for path in (ROOT / name).rglob("*.py")]
    texts = [path.read_text() for path in files if not path.is_relative_to(ON_BOARDS)]
    imported = set().union(*map(_imports, texts))
    assert not _undeclared(imported, set(_declared()))


def test_what_no_line_declares_comes_bounded_with_a_declared_package():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    mandatory = {_key(Requirement(line).name) for line in project["dependencies"]}
    for name, package in (CORES | IMPORTED_BY_OTHERS).items():
        assert package in mandatory
        brought = [Requirement(line) for line in requires(package) or ()]
        needed = [one for one in brought if _key(one.name) == HOMES[name] and not one.marker]
        bounds = "".join(str(one.specifier) for one in needed)
        assert ">" in bounds or "==" in bounds, f"{package} does not bring {name}"
        assert name in IMPORTED_BY_OTHERS or "<" in bounds or "==" in bounds


def test_packages_that_everyone_installs_stay_few():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert len(project["dependencies"]) <= MOST_MANDATORY


def test_an_import_that_is_not_declared_is_noticed():
    source = "def f():\n    import PIL.Image\n    from numpy import array"
    assert _undeclared(_imports(source), {"numpy"}) == {"PIL"}


def test_the_extras_that_messages_name_are_those_declared():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"][
        "optional-dependencies"
    ]
    brought = {extra: {_key(Requirement(line).name) for line in extras[extra]} for extra in extras}
    names = {"serial": "pyserial", "foxglove": "foxglove-sdk"}
    for module, extra in EXTRAS.items():
        assert names.get(module, module) in brought[extra]
    packages = set().union(
        *(brought[extra] for extra in ("bench", "deploy", "cluster", "notebook", "robot"))
    )
    assert packages == {names.get(module, module) for module in EXTRAS}


@pytest.mark.parametrize(
    ("module", "command", "extra"),
    [
        ("onnxruntime", ["predict", "face.onnx", "a.csv"], "deploy"),
        ("serial", ["predict", "contacts.nc", "--port", "/dev/none"], "bench"),
        ("aiohttp", ["bench", "live", "--demo"], "bench"),
        ("distributed", ["run", "cube.toml", "--to", "mesh", "--workers", "2"], "cluster"),
    ],
)
def test_without_an_extra_one_sentence_says_what_to_install(tmp_path, module, command, extra):
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    (tmp_path / "face.onnx").write_bytes(b"no model")
    (tmp_path / "a.csv").write_text("time_s,F1-X1\n")
    code = f"import sys; sys.modules[{module!r}] = None\nfrom instobj.cli.app import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", code, *command], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 2
    if "contacts.nc" not in command:
        assert done.stderr.splitlines()[-1].endswith(f"pip install 'instobj[{extra}]'")
    assert "Traceback" not in done.stderr


def test_dependencies_have_bounds_on_both_sides():
    """Calendar versions of xarray alone have no upper one."""
    own = {name for name, one in _declared().items() if name not in ("instobj", "xarray")}
    open_ended = [
        name
        for name in sorted(own)
        if not {"<", ">="} <= {part.operator for part in _declared()[name].specifier}
    ]
    assert not open_ended
