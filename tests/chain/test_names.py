"""Every global name that a function uses exists: linters miss those behind jaxtyping's strings."""

import ast
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


class _WithoutTypeChecking(ast.NodeTransformer):
    """What `if TYPE_CHECKING:` imports is not there when the program runs."""

    def visit_If(self, node):
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            node.body = [ast.Pass(lineno=node.lineno, col_offset=0)]
        return self.generic_visit(node)


def undefined_names(source):
    """Names that some function loads as globals and that the module never binds."""
    tree = _WithoutTypeChecking().visit(ast.parse(source))
    module = compile(tree, "module", "exec", dont_inherit=True)
    bound, loaded = set(ALWAYS), set()
    for code in _code_objects(module):
        for step in dis.get_instructions(code):
            if step.opname == "STORE_GLOBAL" or (code is module and step.opname == "STORE_NAME"):
                bound.add(step.argval)
            elif step.opname == "LOAD_GLOBAL":
                loaded.add(step.argval)
    return loaded - bound


@pytest.mark.parametrize(
    "package", ["design", "fem", "estimator", "instobj", "benchmarks", "studies"]
)
def test_no_function_uses_a_name_that_does_not_exist(package):
    missing = {
        str(path.relative_to(ROOT)): names
        for path in sorted((ROOT / package).rglob("*.py"))
        if (names := undefined_names(path.read_text(encoding="utf-8")))
    }
    assert not missing


def test_a_forgotten_import_is_found():
    for_types = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import json\n"
    assert undefined_names(for_types + "def f():\n    return json.dumps(1)\n") == {"json"}
    assert undefined_names("def f():\n    return json.dumps(len([]))\n") == {"json"}
    assert undefined_names("import json\ndef f():\n    return json.dumps({})\n") == set()
