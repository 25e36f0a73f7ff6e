"""Constants, defaults and limits of all modules of a package, a line each.

    python -m tests.support.recorded_results.constants

writes `tests/references/constants/` anew. Do so after a change that was meant, look at the difference, and
say in the commit why it changed.
"""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from dataclasses import MISSING, fields, is_dataclass
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from types import FunctionType, ModuleType
from typing import Any

from pydantic import BaseModel

from tests.support import typechecks
from tests.support.recorded_results.digests import of_result

FOLDER = Path(__file__).parents[2] / "references" / "constants"
PACKAGES = ("design", "fem", "estimator")
_CONSTANT = re.compile(r"_?[A-Z][A-Z0-9_]*")
_LONGEST = 100
_UNSTABLE = re.compile(r" at 0x|<function|<class|functools|frozenset|\bset\(|array\(|np\.|tensor\(")
_NUMBER = re.compile(r"-?\d+\.\d{10,}(e-?\d+)?")


def lines_of(package: ModuleType) -> list[str]:
    """Every constant, default and limit of a package's modules, by name."""
    names = [one.name for one in walk_packages(package.__path__, f"{package.__name__}.")]
    return sorted({line for name in names for line in _of_module(import_module(name))})


def _of_module(module: ModuleType) -> Iterator[str]:
    from tests.support.smaller_statistics import FULL

    own = _assigned(module)
    for name, value in vars(module).items():
        full = f"{module.__name__}.{name}"
        if isinstance(value, type):
            if value.__module__ == module.__name__:
                yield from _of_class(full, value)
        elif callable(value):
            if getattr(value, "__module__", None) == module.__name__:
                yield from _of_function(full, value)
        elif name in own and _CONSTANT.fullmatch(name) and not _fills(value):
            yield f"{full} = {_told(FULL.get((module, name), value))}"


def _fills(value: Any) -> bool:
    """Whether it is a store, empty as it is imported."""
    return isinstance(value, dict | list | set) and not value


def _assigned(module: ModuleType) -> set[str]:
    tree = ast.parse(inspect.getsource(module))
    targets = [
        target
        for node in tree.body
        if isinstance(node, ast.Assign | ast.AnnAssign)
        for target in (node.targets if isinstance(node, ast.Assign) else [node.target])
    ]
    return {
        node.id for target in targets for node in ast.walk(target) if isinstance(node, ast.Name)
    }


def _of_function(full: str, function: Any) -> Iterator[str]:
    if hasattr(function, "cache_parameters"):
        yield f"{full} keeps={function.cache_parameters()['maxsize']}"
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return
    for one in parameters:
        if one.default is not inspect.Parameter.empty:
            yield f"{full}({one.name}={_told(one.default)})"


def _of_class(full: str, kind: type) -> Iterator[str]:
    if is_dataclass(kind):
        settings = kind.__dataclass_params__  # pyright: ignore[reportAttributeAccessIssue]
        yield f"{full} frozen={settings.frozen} eq={settings.eq} order={settings.order}"
        for field in fields(kind):
            if field.default is not MISSING:
                yield f"{full}.{field.name} = {_told(field.default)}"
            elif field.default_factory is not MISSING:
                yield f"{full}.{field.name} = {_told(field.default_factory())}"
    if issubclass(kind, BaseModel):
        for name, field in kind.model_fields.items():
            default = (
                "required"
                if field.is_required()
                else _told(field.get_default(call_default_factory=True))
            )
            limits = f"{_limits(field.metadata)} {_limits(_inner(field.annotation))}"
            yield f"{full}.{name} = {default} {limits}".strip()
    for name, value in vars(kind).items():
        if (
            isinstance(value, FunctionType)
            and not name.startswith("__")
            and not issubclass(kind, BaseModel)
        ):
            yield from _of_function(f"{full}.{name}", value)
        elif _CONSTANT.fullmatch(name) or (
            isinstance(value, bool | int | float | str) and name[0] != "_"
        ):
            yield f"{full}.{name} = {_told(value)}"


def _inner(annotation: Any) -> list[Any]:
    """Limits of the parts of a type, such as the entries of a tuple."""
    found = list(getattr(annotation, "__metadata__", ()))
    for part in getattr(annotation, "__args__", ()):
        found += _inner(part)
    return found


def _limits(metadata: list[Any]) -> str:
    told = [repr(one) for one in metadata]
    return " ".join(one for one in told if not _UNSTABLE.search(one) and "FieldInfo" not in one)


def _told(value: Any) -> str:
    text = repr(value)
    if len(text) <= _LONGEST and not _UNSTABLE.search(text):
        return _NUMBER.sub(lambda found: f"{float(found[0]):.10g}", text.replace("\n", " "))
    checksum, sums = of_result(value)
    return " ".join(
        [type(value).__name__, f"{checksum:08x}", *(f"{a:.10g} {b:.10g}" for _, a, b in sums)]
    )


def main() -> None:
    typechecks.install(list(PACKAGES))  # as in tests: a checked function is told by its kind alone
    from design.files import atomic_path

    FOLDER.mkdir(parents=True, exist_ok=True)
    for name in PACKAGES:
        with atomic_path(FOLDER / f"{name}.txt") as path:
            path.write_text("\n".join(lines_of(import_module(name))) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
