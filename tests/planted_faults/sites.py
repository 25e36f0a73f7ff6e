"""Small faults that somebody could make, and where in a file they could be made.

One fault is one change of one expression: a comparison turned or moved by its limit, plus for minus,
times for divided by, a sign lost, `and` for `or`, a `not` lost, True for False, a number by one or by
a factor of two, least for largest, sine for cosine, an accumulation turned round.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_COMPARED = {
    ast.Lt: ("<=", ">="),
    ast.LtE: ("<", ">"),
    ast.Gt: (">=", "<="),
    ast.GtE: (">", "<"),
    ast.Eq: ("!=",),
    ast.NotEq: ("==",),
    ast.Is: ("is not",),
    ast.IsNot: ("is",),
    ast.In: ("not in",),
    ast.NotIn: ("in",),
}
_COMPUTED = {
    ast.Add: "-",
    ast.Sub: "+",
    ast.Mult: "/",
    ast.Div: "*",
    ast.FloorDiv: "/",
    ast.Pow: "*",
}
_NAMED = {
    "min": "max",
    "max": "min",
    "sin": "cos",
    "cos": "sin",
    "argmin": "argmax",
    "argmax": "argmin",
    "any": "all",
    "all": "any",
    "floor": "ceil",
    "ceil": "floor",
    "nanmin": "nanmax",
    "nanmax": "nanmin",
    "minimum": "maximum",
    "maximum": "minimum",
}


@dataclass(frozen=True)
class Fault:
    """`text` put in place of characters `begin` to `end` of a file; `line` counts from 1."""

    path: str
    line: int
    begin: int
    end: int
    text: str
    kind: str

    def planted_in(self, source: str) -> str:
        """The file with the fault."""
        return source[: self.begin] + self.text + source[self.end :]


def faults_in(root: Path, path: str) -> list[Fault]:
    """Every fault that a file could have, in order of place."""
    source = (root / path).read_text(encoding="utf-8")
    finder = _Finder(path, source)
    finder.visit(ast.parse(source))
    return sorted(finder.found, key=lambda fault: (fault.begin, fault.text))


class _Finder(ast.NodeVisitor):
    """Texts, annotations, messages of errors and imports hold no faults."""

    def __init__(self, path: str, source: str) -> None:
        self.path, self.source = path, source
        self.found: list[Fault] = []
        lines = source.splitlines(keepends=True)
        self._starts = [0]
        for line in lines:
            self._starts.append(self._starts[-1] + len(line))
        self._lines = lines

    def _at(self, line: int, column: int) -> int:
        """Characters before a place; `ast` counts columns in bytes."""
        return self._starts[line - 1] + len(self._lines[line - 1].encode()[:column].decode())

    def _span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return self._at(node.lineno, node.col_offset), self._at(
            node.end_lineno, node.end_col_offset
        )

    def _add(self, begin: int, end: int, text: str, kind: str) -> None:
        line = self.source.count("\n", 0, begin) + 1
        self.found.append(Fault(self.path, line, begin, end, text, kind))

    def _between(self, left: ast.expr, right: ast.expr, old: str, new: str, kind: str) -> None:
        begin, end = self._span(left)[1], self._span(right)[0]
        place = self.source.find(old, begin, end)
        if place >= 0 and "#" not in self.source[begin:end]:
            self._add(place, place + len(old), new, kind)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        return

    def visit_Raise(self, node: ast.Raise) -> None:
        return

    def visit_Assert(self, node: ast.Assert) -> None:
        return

    def visit_arguments(self, node: ast.arguments) -> None:
        for default in [*node.defaults, *(one for one in node.kw_defaults if one)]:
            self.visit(default)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self.visit(node.args)
        for part in node.body:
            self.visit(part)

    def visit_If(self, node: ast.If) -> None:
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            return
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        operands = [node.left, *node.comparators]
        for left, operator, right in zip(operands, node.ops, operands[1:], strict=False):
            for new in _COMPARED[type(operator)]:
                self._between(left, right, _spelt(operator), new, "comparison")
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        new = _COMPUTED.get(type(node.op))
        if new and not _is_text(node.left) and not _is_text(node.right):
            self._between(node.left, node.right, _spelt(node.op), new, "arithmetic")
        if not isinstance(node.op, ast.Mod) or not _is_text(node.left):
            self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        new = _COMPUTED.get(type(node.op))
        if new:
            self._between(node.target, node.value, f"{_spelt(node.op)}=", f"{new}=", "arithmetic")
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
        for left, right in zip(node.values, node.values[1:], strict=False):
            self._between(left, right, old, new, "logic")
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        signs = {ast.USub: ("-", "sign"), ast.Not: ("not ", "logic"), ast.Invert: ("~", "logic")}
        if type(node.op) in signs:
            old, kind = signs[type(node.op)]
            begin = self._span(node)[0]
            self._add(begin, begin + len(old), "", kind)
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        begin, end = self._span(node)
        if isinstance(node.value, bool):
            self._add(begin, end, str(not node.value), "truth")
        elif isinstance(node.value, int):
            self._add(begin, end, str(node.value + 1), "number")
        elif isinstance(node.value, float):
            self._add(begin, end, repr(2 * node.value if node.value else 1.0), "number")

    def visit_Call(self, node: ast.Call) -> None:
        name = node.func
        if isinstance(name, ast.Name) and name.id in _NAMED:
            self._add(*self._span(name), _NAMED[name.id], "function")
        if isinstance(name, ast.Attribute) and name.attr in _NAMED:
            end = self._span(name)[1]
            self._add(end - len(name.attr), end, _NAMED[name.attr], "function")
        self.generic_visit(node)


def _spelt(operator: ast.operator | ast.cmpop) -> str:
    spellings = {
        ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
        ast.Is: "is", ast.IsNot: "is not", ast.In: "in", ast.NotIn: "not in",
        ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "//", ast.Pow: "**",
    }  # fmt: skip
    return spellings[type(operator)]


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def packages_files(root: Path, packages: tuple[str, ...]) -> Iterator[str]:
    """Python files of packages, relative to the root."""
    for package in packages:
        for path in sorted((root / package).rglob("*.py")):
            yield path.relative_to(root).as_posix()
