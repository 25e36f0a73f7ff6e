"""The rules of the house that a test can hold."""

import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj")
HEAVY = ("torch", "cadquery", "matplotlib", "xarray", "magpylib", "skfem", "pyvista", "trimesh")


def _heavy_imports(module: str) -> set[str]:
    code = f"import sys, {module}; print(*[m for m in {HEAVY!r} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT
    )
    return set(done.stdout.split())


@pytest.mark.parametrize(
    ("module", "allowed"),
    [
        ("design.spec.object", set()),
        ("design.layout.positions", set()),
        ("instobj.cli.app", set()),
        ("instobj.commands.run", set()),
        ("estimator.field.models", set()),
        ("estimator.signals.presses", set()),
        ("estimator.frames.dataset", set()),
        ("estimator.deploy.runtime", set()),
        ("instobj.commands.predict", set()),
        ("estimator.boards.link", set()),
        ("instobj.commands.collect", set()),
        ("fem.presses.results", set()),
        ("estimator.information.scores", {"xarray"}),
    ],
)
def test_light_modules_import_nothing_heavy(module, allowed):
    assert _heavy_imports(module) <= allowed


def test_package_init_files_import_nothing():
    for package in PACKAGES:
        lines = (ROOT / package / "__init__.py").read_text().splitlines()
        assert not [line for line in lines if line.startswith(("import", "from"))]


def test_imports_flow_one_way():
    done = subprocess.run(
        [str(Path(sys.executable).parent / "lint-imports")],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=False,
    )
    assert done.returncode == 0, done.stdout


def test_a_planted_back_arrow_breaks_the_contract_of_design(tmp_path):
    """A copy of design in which the lowest room asks the one above what fits."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"][
        "contracts"
    ]
    inside = next(c for c in contracts if c.get("containers") == ["design"])
    settings = ["[importlinter]", "root_package = design", "[importlinter:contract:1]"]
    settings += ["name = inside design", "type = layers", "containers = design", "layers ="]
    settings += [f"    {layer}" for layer in inside["layers"]]
    (tmp_path / ".importlinter").write_text("\n".join(settings))
    shutil.copytree(ROOT / "design", tmp_path / "design")

    def lint():
        command = [str(Path(sys.executable).parent / "lint-imports"), "--no-cache"]
        environment = os.environ | {"PYTHONPATH": str(tmp_path)}
        return subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
        )

    assert lint().returncode == 0
    with (tmp_path / "design/spec/body.py").open("a") as module:
        module.write("\nfrom typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n")
        module.write("    from design.fit.everything import require_fit\n")
    broken = lint()
    assert broken.returncode == 1
    assert "design.spec is not allowed to import design.fit" in broken.stdout
