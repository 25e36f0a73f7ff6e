"""Every global name that a function uses exists: linters miss those behind jaxtyping's strings."""

import builtins
import dis
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ALWAYS = {*dir(builtins), "__file__", "__name__", "__doc__", "__annotations__"}


def _code_objects(code):
    yield code
    for constant in code.co_consts:
        if hasattr(constant, "co_code"):
            yield from _code_objects(constant)


def undefined_names(source):
    """Names that some function loads as globals and that the module never binds."""
    module = compile(source, "module", "exec", dont_inherit=True)
    bound, loaded = set(ALWAYS), set()
    for code in _code_objects(module):
        for step in dis.get_instructions(code):
            if step.opname == "STORE_GLOBAL" or (code is module and step.opname == "STORE_NAME"):
                bound.add(step.argval)
            elif step.opname == "LOAD_GLOBAL":
                loaded.add(step.argval)
    return loaded - bound


@pytest.mark.parametrize(
    "package", ["design", "fem", "estimator", "instobj", "benchmarks", "tests"]
)
def test_no_function_uses_a_name_that_does_not_exist(package):
    missing = {
        str(path.relative_to(ROOT)): names
        for path in sorted((ROOT / package).rglob("*.py"))
        if (names := undefined_names(path.read_text(encoding="utf-8")))
    }
    assert not missing


def test_a_forgotten_import_is_found():
    assert undefined_names("def f():\n    return json.dumps(len([]))\n") == {"json"}
    assert undefined_names("import json\ndef f():\n    return json.dumps({})\n") == set()
