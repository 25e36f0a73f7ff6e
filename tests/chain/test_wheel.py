"""The built wheel, installed away from the checkout: a new object, checked, built and run."""

import json
import os
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

from tests.support.objects.tiny_cube import CHANGES, MECHANICS, MESHED, lend_mechanics

ROOT = Path(__file__).parents[2]
FEW_FRAMES = (
    "protocol.presses_per_place=3",
    "protocol.frames_per_press=[4, 8]",
)
COARSE = [part for key in (*MESHED, *CHANGES, *FEW_FRAMES) for part in ("--set", key)]
THREADS = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
CHAIN = """
import json, sys
from instobj.cli.app import main
from instobj.figures import saving
from instobj.render import raster

saving.DPI, raster.PIXELS = 60, 400
for words in json.loads(sys.argv[1]):
    sys.argv = ["instobj", *words]
    try:
        main()
    except SystemExit as ended:
        if ended.code:
            raise
    print(end="\\f")
"""
"""Several commands in one process, which imports once what each needs, with small pictures; a form feed
after each."""


def _run(*command, cwd, **more):
    """Standard output; the checkout is on no path that Python searches."""
    hidden = ("PYTHONPATH", "INSTOBJ_STORE", "VIRTUAL_ENV")
    environment = {name: value for name, value in os.environ.items() if name not in hidden}
    found = subprocess.run(
        [*map(str, command)], cwd=cwd, env=environment | more, capture_output=True, text=True
    )
    assert found.returncode == 0, found.stderr[-2000:]
    return found.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """The `bin` of an environment that holds the wheel, and takes what it needs from this one.

    A path file adds this environment's packages; path files in there, such as that of an editable
    install, are not read for it.
    """
    folder = tmp_path_factory.mktemp("wheel")
    _run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", folder, cwd=ROOT)
    (wheel,) = folder.glob("instobj-*.whl")
    venv.create(folder / "env", with_pip=False)
    python = folder / "env" / "bin" / "python"
    pip = (sys.executable, "-m", "pip", "--disable-pip-version-check")
    _run(*pip, "--python", python, "install", "-q", "--no-deps", "--no-index", wheel, cwd=folder)
    home = Path(_run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))",
                     cwd=folder).strip())  # fmt: skip
    (home / "needs.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    return python.parent


def test_the_packages_are_those_of_the_wheel(installed, tmp_path):
    modules = "design, estimator, fem, instobj"
    code = f"import {modules}; print(*(m.__file__ for m in ({modules})))"
    found = _run(installed / "python", "-c", code, cwd=tmp_path).split()
    assert len(found) == 4
    assert all(Path(file).is_relative_to(installed.parent) for file in found)


def test_every_file_beside_the_modules_is_in_the_wheel(installed):
    """Templates, tables and the like: a stage of `run` that misses one would fail."""
    home = Path(_run(installed / "python", "-c", "import design; print(*design.__path__)",
                     cwd=installed).strip()).parent  # fmt: skip
    folders = [ROOT / package for package in ("design", "estimator", "fem", "instobj")]
    files = [path for folder in folders for path in folder.rglob("*") if path.is_file()]
    files = [path.relative_to(ROOT) for path in files if "__pycache__" not in path.parts]
    assert {path.suffix for path in files} >= {".py", ".toml", ".css", ".j2"}
    assert not [path for path in files if not (home / path).is_file()]


@pytest.fixture(scope="module")
def tiny(installed, tmp_path_factory):
    """Folder of a new object whose mesh and responses are those that other tests made."""
    folder = tmp_path_factory.mktemp("tiny")
    lend_mechanics(folder / ".instobj")
    return folder


@pytest.fixture(scope="module")
def told(installed, tiny):
    """Return what `new` and `check` of the new object print, and a page of the docs."""
    commands = [["new", "tiny"], ["check", "tiny.toml", *COARSE], ["docs", "recordings"]]
    python = installed / "python"
    return _run(python, "-c", CHAIN, json.dumps(commands), cwd=tiny, **THREADS).split("\f")


def test_a_new_object_is_checked_from_the_wheel(told):
    assert "tiny" in told[1]


@pytest.mark.slow
def test_a_new_object_is_built_and_run_from_the_wheel(installed, told, tiny):
    commands = [["build", "tiny.toml", *COARSE], ["run", "tiny.toml", *COARSE, "--json"]]
    python = installed / "python"
    printed = _run(python, "-c", CHAIN, json.dumps(commands), cwd=tiny, **THREADS).split("\f")
    assert (tiny / "cad_out" / "tiny" / "shell.stl").stat().st_size > 10_000
    assert "<h1>" in (tiny / "cad_out" / "tiny" / "assembly.html").read_text(encoding="utf-8")
    (document,) = json.loads(printed[1])["objects"]
    reused = {row["stage"] for row in document["stages"] if row["reused"]}
    assert reused <= {*MECHANICS, "build"}
    report = (tiny / "runs" / "tiny" / "report.html").read_text(encoding="utf-8")
    assert "<style>" in report
    assert (tiny / "runs" / "tiny" / "scores.csv").is_file()


def test_the_pages_that_messages_name_are_in_the_wheel(installed, told, tmp_path):
    names = _run(installed / "instobj", "docs", cwd=tmp_path).split()
    assert "recordings" in names
    assert told[2] == (ROOT / "docs" / "recordings.md").read_text(encoding="utf-8") + "\n"
