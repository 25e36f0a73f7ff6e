"""Keywords that guard say so everywhere: results are immutable, lists end together, files run no code."""

import ast
from functools import cache
from pathlib import Path

import design
import estimator
import fem

ROOT = Path(__file__).parents[2]
GUARDS = {"frozen": True, "strict": True, "allow_pickle": False, "allow_inf_nan": False}

UNEQUAL = {
    "design/spec/mechanics.py": 1,
    "estimator/frames/collection.py": 1,
    "estimator/information/fisher.py": 1,
    "estimator/layouts/cross_face.py": 1,
    "estimator/networks/forest.py": 2,
    "estimator/networks/network.py": 1,
    "estimator/recordings/formats/files.py": 1,
    "fem/mesh/surfaces.py": 1,
}
"""How often a file takes lists together of which one is longer on purpose."""


@cache
def modules(package):
    """Syntax tree of every file of a package, by its name."""
    files = sorted((ROOT / package).rglob("*.py"))
    return {file.relative_to(ROOT).as_posix(): ast.parse(file.read_text("utf-8")) for file in files}


def unguarded(tree):
    """Keywords of calls that say the other of what guards."""
    calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call))
    said = [one for call in calls for one in call.keywords if one.arg in GUARDS]
    return [
        one.arg
        for one in said
        if isinstance(one.value, ast.Constant) and one.value.value is not GUARDS[one.arg]
    ]


def test_dataclasses_are_frozen_lists_zipped_strictly_numbers_finite_and_nothing_unpickled():
    """In the packages that make results; pages and figures of `instobj` may end a list early."""
    found = {
        path: names
        for package in (design, fem, estimator)
        for path, tree in modules(package.__name__).items()
        if (names := unguarded(tree))
    }
    assert found == {path: ["strict"] * number for path, number in UNEQUAL.items()}


def test_what_does_not_guard_is_found():
    source = "@dataclass(frozen={})\nclass A:\n    x: float = Field(allow_inf_nan={})\n"
    assert unguarded(ast.parse(source.format("False", "True"))) == ["frozen", "allow_inf_nan"]
    assert unguarded(ast.parse(source.format("True", "False"))) == []
