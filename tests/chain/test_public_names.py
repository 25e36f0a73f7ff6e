"""Tests touch public names of the product only, which may move what is private, and no other test file."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj", "studies")
OF_OTHERS = {
    "_replace",
    "_exit",
    "_lru_cache_wrapper",
    "_geomAdaptor",
    "_css",
    "_esm",
    "_FillValue",
}
"""Names with an underscore that Python, the CAD kernel and anywidget give to users."""
_NAMED = re.compile(rf"_[A-Z]\w*|({'|'.join(PACKAGES)})(\.\w+)+")


def is_private(name):
    return name.startswith("_") and not name.startswith("__")


def own_names(tree):
    """What a file defines: private helpers of a test file are its own business."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.attr
        elif isinstance(node, ast.AnnAssign | ast.Assign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (one.id for one in targets if isinstance(one, ast.Name))


def private_uses(tree, own):
    """Lines and private names that are imported, reached through an object, or replaced by name."""
    for node in ast.walk(tree):
        names = []
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in PACKAGES:
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.Attribute):
            names = [node.attr]
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "setattr":
            names = [str(one.value) for one in node.args[1:2] if isinstance(one, ast.Constant)]
        elif isinstance(node, ast.Constant) and _NAMED.fullmatch(str(node.value)):
            names = [node.value.rpartition(".")[2]]
        yield from ((node.lineno, name) for name in names if is_private(name) and name not in own)


@pytest.fixture(scope="module")
def trees():
    files = sorted((ROOT / "tests").rglob("*.py"))
    return {file.relative_to(ROOT).as_posix(): ast.parse(file.read_text("utf-8")) for file in files}


def test_what_tests_share_is_in_no_test_file(trees):
    for path, tree in trees.items():
        imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
        assert not [node for node in imports if ".test_" in (node.module or "")], path


def test_tests_use_public_names_alone(trees):
    support = {
        name for path, tree in trees.items() if "/test_" not in path for name in own_names(tree)
    }
    found = [
        f"{path}:{line} {name}"
        for path, tree in trees.items()
        for line, name in private_uses(tree, support | {*own_names(tree)} | OF_OTHERS)
    ]
    assert not found, "test through public names, or make these public:\n" + "\n".join(found)


def test_private_names_are_found_however_they_are_reached():
    source = (
        "from design.body.meshes import _height_mm\n"
        "found = meshes._width_mm(1)\n"
        'monkeypatch.setattr(meshes, "_depth_mm", 1)\n'
        'monkeypatch.setattr("design.body.meshes._hooks", 1)\n'
        "class Own:\n    def _mine(self):\n        return self._mine\n"
    )
    tree = ast.parse(source)
    assert {line for line, _ in private_uses(tree, {*own_names(tree)})} == {1, 2, 3, 4}
