"""A fault put into a running process, where the function that holds it changes alone."""

from __future__ import annotations

import ast
import functools
import gc
from collections.abc import Callable, Iterator
from pathlib import Path
from types import CodeType, FunctionType

from tests.planted_faults.sites import Fault

Definition = ast.FunctionDef | ast.AsyncFunctionDef
_MARK = "_planted_fault_is_reached"


def function_of(tree: ast.Module, line: int) -> tuple[str, Definition] | None:
    """Name and definition of the outermost function whose body holds a line.

    None where the line is run as the module is imported: constants, defaults, decorators, classes.
    """
    return next(_outermost(tree.body, line, ""), None)


def _outermost(body: list[ast.stmt], line: int, inside: str) -> Iterator[tuple[str, Definition]]:
    for node in body:
        if not node.lineno <= line <= (node.end_lineno or node.lineno):
            continue
        if isinstance(node, Definition):
            if line >= node.body[0].lineno:
                yield inside + node.name, node
        elif isinstance(node, ast.ClassDef):
            yield from _outermost(node.body, line, f"{inside}{node.name}.")
        else:
            for part in ("body", "orelse", "finalbody"):
                yield from _outermost(getattr(node, part, []), line, inside)


def swap(root: Path, fault: Fault, reached: Callable[[], None]) -> bool:
    """Give every function that was made of the fault's definition the code with the fault.

    The file holds the fault already. `reached` is called the first time that the statement which
    holds it is run. Kept answers of `functools.cache` are dropped. False where no such function is.
    """
    file = root / fault.path
    tree = ast.parse(file.read_text(encoding="utf-8"))
    found = function_of(tree, fault.line)
    if found is None:
        return False
    name, definition = found
    _mark(definition, fault.line)
    first = min(node.lineno for node in [definition, *definition.decorator_list])
    starts = range(first, definition.body[0].lineno + 1)
    whole = compile(ast.fix_missing_locations(tree), str(file), "exec", dont_inherit=True)
    code = next(one for one in _codes(whole) if one.co_qualname == name and _in(one, starts))
    gc.unfreeze()
    functions = [
        one
        for one in gc.get_objects()
        if isinstance(one, FunctionType)
        and one.__code__.co_filename == str(file)
        and one.__code__.co_qualname == name
        and _in(one.__code__, starts)
        and len(one.__code__.co_freevars) == len(code.co_freevars)
    ]
    for function in functions:
        function.__code__ = code
        function.__globals__[_MARK] = functools.cache(reached)
    for kept in gc.get_objects():
        if isinstance(kept, functools._lru_cache_wrapper):  # noqa: SLF001  Python names it so
            kept.cache_clear()
    return bool(functions)


def _in(code: CodeType, starts: range) -> bool:
    return code.co_firstlineno in starts


def _mark(definition: Definition, line: int) -> None:
    """Call the mark before the innermost statement that holds a line."""
    body, place = definition.body, 0
    for node in ast.walk(definition):  # outer ones first
        for inner in (getattr(node, part, None) for part in ("body", "orelse", "finalbody")):
            for number, one in enumerate(inner if isinstance(inner, list) else ()):
                if one.lineno <= line <= (one.end_lineno or one.lineno):
                    body, place = inner, number
    call = ast.parse(f"{_MARK}()").body[0]
    body.insert(place, ast.copy_location(call, body[place]))


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)
