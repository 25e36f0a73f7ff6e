"""Facts on record: lines of words and numbers in a text file, section by section.

A test hands over what it found as lines; they are compared with the file's, words exactly and numbers
to 1e-4 of their size (or of 0.01). `INSTOBJ_TESTS_FACTS=record .venv/bin/pytest TEST` writes the
sections that a run asks for anew: do so only after a deliberate change, look at the difference, and say
in the commit why it changed.
"""

import os
import re
import warnings
from dataclasses import fields, is_dataclass
from pathlib import Path

import numpy as np

from design.files import atomic_path

FOLDER = Path(__file__).parents[1] / "references"
MODE = "INSTOBJ_TESTS_FACTS"
RECORDS = os.environ.get(MODE) == "record"
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w])")
_FEW = 12
"""Numbers of an array that are told one by one."""


def assert_on_record(file, section, lines, package="design"):
    """Lines of a section as they stand in `tests/references/<package>/<file>.txt`."""
    path, lines = FOLDER / package / f"{file}.txt", list(lines)
    if RECORDS:
        _write(path, section, lines)
    known = sections_of(path).get(section)
    assert known is not None, f"no section {section} in {path}: see {__name__}"
    differ = [pair for pair in _pairs(known, lines) if not alike(*pair)]
    assert not differ, "\n".join(f"- {one}\n+ {two}" for one, two in differ)


def alike(one, two):
    """Whether two lines have the same words, and numbers that are nearly the same."""
    if _NUMBER.sub("#", one) != _NUMBER.sub("#", two):
        return False
    pairs = zip(_NUMBER.findall(one), _NUMBER.findall(two), strict=True)
    return all(abs(float(a) - float(b)) <= 1e-4 * max(abs(float(a)), 0.01) for a, b in pairs)


def told(name, value):
    """One line: the value of a fact, an array's numbers, or means of the columns of a long one.

    Of a long array two means stand there, plain and weighed by the row's number.
    """
    if isinstance(value, str) or value is None:
        return f"{name}: {value}"
    array = np.asarray(value)
    assert array.dtype.kind in "biuf", f"{name} is no array of numbers: {value}"
    array = array.astype(float)
    if array.size <= _FEW:
        return f"{name}: {_numbers(array.ravel())}"
    shape = " × ".join(map(str, array.shape))
    rows = array.reshape(-1, array.shape[-1] if array.ndim > 1 else 1)
    weight = np.arange(1, len(rows) + 1) / len(rows)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # columns without a number
        plain, weighed = np.nanmean(rows, axis=0), np.nanmean(weight[:, None] * rows, axis=0)
    return f"{name}: {shape}, mean {_numbers(plain)}, weighed {_numbers(weighed)}"


def told_whole(name, value, without=()):
    """Lines: every fact of a result, by its names: of dataclasses, lists and mappings of them.

    Facts that another processor may give another sign to are left out by their names.
    """
    if is_dataclass(value):
        names = [field.name for field in fields(value) if field.name not in without]
        value = {field: getattr(value, field) for field in names}
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from told_whole(f"{name}.{key}", inner, without)
    elif isinstance(value, str | bool) or value is None:
        yield told(name, None if value is None else str(value))
    elif isinstance(value, list | tuple) and all(isinstance(one, str) for one in value):
        yield told(name, ", ".join(value))
    elif isinstance(value, list | tuple) and not _are_numbers(value):
        for number, inner in enumerate(value):
            yield from told_whole(f"{name}[{number}]", inner, without)
    else:
        yield told(name, value)


def _are_numbers(values):
    try:
        return np.asarray(values).dtype.kind in "biuf"
    except ValueError:
        return False


def of_solids(name, shapes):
    """One line: volume, area, number of a solid's faces, middle and box (mm) of each solid or closed
    surface.

    Small features of a large solid show in its area and its faces.
    """
    if not shapes:
        return f"{name}: none"
    rows = [_of_solid(shape) for shape in shapes]
    return told(name, rows[0] if len(rows) == 1 else np.array(rows))


def _of_solid(shape):
    if not hasattr(shape, "BoundingBox"):
        return [float(shape.volume), float(shape.area), *shape.center_mass, *shape.bounds.ravel()]
    box = shape.BoundingBox()
    low, high = (box.xmin, box.ymin, box.zmin), (box.xmax, box.ymax, box.zmax)
    sizes = [shape.Volume(), shape.Area(), len(shape.Faces())]
    return [*sizes, *shape.Center().toTuple(), *low, *high]


def _numbers(values):
    return " ".join(f"{float(one) + 0.0:.6g}" for one in np.round(values, 6))


def sections_of(path):
    """Lines of every section, by its name; what stands before the first is left out."""
    found = {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else ():
        if line.startswith("== "):
            found[line.removeprefix("== ")] = lines = []
        elif found and line:
            lines.append(line)
    return found


def _pairs(known, lines):
    longest = max(len(known), len(lines))
    return zip(*([*some, *[""] * (longest - len(some))] for some in (known, lines)), strict=True)


def _write(path, section, lines):
    head = path.read_text(encoding="utf-8").split("== ")[0] if path.exists() else ""
    found = sections_of(path) | {section: lines}
    with atomic_path(path) as temporary:
        text = "\n".join("\n".join([f"== {name}", *rows, ""]) for name, rows in found.items())
        temporary.write_text(head + text, encoding="utf-8")
