"""The rules of the house that a test can hold."""

import subprocess
import sys
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
