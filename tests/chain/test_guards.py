"""Keywords that guard say so everywhere: results are immutable, lists end together, files run no code.

And defaults of functions and fields, on record: nothing but their choice makes most of them right.
"""

import ast
from functools import cache
from pathlib import Path

import pytest

import design
import estimator
import fem
from tests.support.recorded_facts import FOLDER, RECORDS, assert_on_record, sections_of

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


def defaults(tree, inside=""):
    """Lines: default numbers and truth values of functions and of fields of classes, but seeds."""
    for node in getattr(tree, "body", []):
        if isinstance(node, ast.ClassDef):
            fields = [one for one in node.body if isinstance(one, ast.AnnAssign | ast.Assign)]
            for field in fields:
                name = ast.unparse(getattr(field, "target", None) or field.targets[0])
                yield from _default(f"{inside}{node.name}.{name}", field.value)
            yield from defaults(node, f"{inside}{node.name}.")
        elif isinstance(node, ast.FunctionDef):
            args = [*node.args.posonlyargs, *node.args.args]
            given = [*zip(reversed(args), reversed(node.args.defaults), strict=False)][::-1]
            given += zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True)
            for argument, value in given:
                yield from _default(f"{inside}{node.name}({argument.arg})", value)


def _default(name, value):
    parts = ast.walk(value) if value else ()
    numbers = [one for one in parts if isinstance(getattr(one, "value", None), int | float)]
    if numbers and not name.endswith("(seed)"):
        yield f"{name} = {ast.unparse(value)}"


@pytest.mark.parametrize("package", [design, fem, estimator], ids=lambda package: package.__name__)
def test_defaults_are_as_on_record(package):
    """Those on record, that is; keys of a specification are in `tests/design/spec/test_keys.py`."""
    lines = [
        f"{path.removesuffix('.py').replace('/', '.')}: {line}"
        for path, tree in modules(package.__name__).items()
        if not path.startswith("design/spec/")
        for line in defaults(tree)
    ]
    known = sections_of(FOLDER / "chain" / "defaults.txt").get(package.__name__, [])
    names = {line.split(" = ")[0] for line in known}
    told = [line for line in lines if RECORDS or line.split(" = ")[0] in names]
    assert_on_record("defaults", package.__name__, told, "chain")


def test_defaults_of_functions_methods_and_fields_are_found():
    source = "def f(a, b=2, *, c=-0.5, d=None): ...\nclass A:\n    e = True\n    def g(self, h=(1, 2)): ..."
    assert list(defaults(ast.parse(source))) == [
        "f(b) = 2",
        "f(c) = -0.5",
        "A.e = True",
        "A.g(h) = (1, 2)",
    ]
