"""Private names that ruff's rule (`SLF001`) does not see: imports, names in texts, other test files."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = "(design|fem|estimator|instobj|studies)"
PRIVATE = re.compile(
    rf"""(setattr|object)\(\s*[^,()]+,\s*["']_[a-zA-Z]|["']{PACKAGES}(\.\w+)*\._[a-zA-Z]"""
    rf"""|^\s*from {PACKAGES}[\w.]* import (\([^)]*|[^(\n]*)\b_[a-zA-Z]""",
    re.MULTILINE,
)
"""A private name that is replaced in a module, named with it, or imported from it."""
OF_TEST_FILES = re.compile(r"^\s*(from|import) .*\.test_", re.MULTILINE)


def names_in(pattern):
    """Return what matches in each test file and what they share, by file."""
    files = [file for file in sorted((ROOT / "tests").rglob("*.py")) if file != Path(__file__)]
    texts = {str(file.relative_to(ROOT)): file.read_text("utf-8") for file in files}
    return {path: found[0] for path, text in texts.items() if (found := pattern.search(text))}


def test_what_tests_share_is_in_no_test_file():
    assert not names_in(OF_TEST_FILES)


def test_tests_replace_public_names_alone():
    assert not names_in(PRIVATE), "test through public names, or make these public"


@pytest.mark.parametrize(
    "line",
    [
        "from design.body.meshes import _height_mm",
        "from design.body.meshes import (\n    undercut,\n    _height_mm,\n)",
        'monkeypatch.setattr(meshes, "_depth_mm", 1)',
        'monkeypatch.setattr(\n    meshes, "_depth_mm", 1)',
        'patch.object(meshes, "_depth_mm")',
        'monkeypatch.setattr("design.body.meshes._hooks", 1)',
    ],
)
def test_private_names_are_found_in_texts(line):
    assert PRIVATE.search(line)
