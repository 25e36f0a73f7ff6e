"""A page of physics for each room: at most 30 lines of numbers that a person can judge.

A page is a text file in `tests/references/`: a heading of lines with "# ", then one line for each
quantity, with its unit in its name. Words are compared exactly, numbers to 1e-4 of their size (or of
0.01). Of more than twelve numbers the shape, the range and the root mean square stand there. After a
deliberate change paste the lines that the failing test prints, and say in the commit why they changed.
"""

import re
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parents[1] / "references"
MOST_LINES = 30
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w])")
_FEW = 12


def assert_page(page, quantities, part=""):
    """Quantities, a name and a text or numbers each, as they stand on a room's page.

    Where several tests share a page, each names its part, with which its lines begin.
    """
    lines = [line_of(f"{part}{name}", value) for name, value in quantities]
    text = (FOLDER / f"{page}.txt").read_text(encoding="utf-8")
    known = [line for line in text.splitlines() if line and not line.startswith("# ")]
    assert len(known) <= MOST_LINES
    known = [line for line in known if line.startswith(part)]
    longest = max(len(known), len(lines))
    pairs = zip(*([*some, *[""] * (longest - len(some))] for some in (known, lines)), strict=True)
    differ = [pair for pair in pairs if not alike(*pair)]
    assert not differ, "\n".join(f"- {one}\n+ {two}" for one, two in differ)


def alike(one, two):
    """Whether two lines have the same words, and numbers that are nearly the same."""
    if _NUMBER.sub("#", one) != _NUMBER.sub("#", two):
        return False
    pairs = zip(_NUMBER.findall(one), _NUMBER.findall(two), strict=True)
    return all(abs(float(a) - float(b)) <= 1e-4 * max(abs(float(a)), 0.01) for a, b in pairs)


def chosen(result, *names):
    """Quantities of a result by the names of its fields, which carry their units."""
    return [(name, getattr(result, name)) for name in names]


def line_of(name, value):
    """One line of a page; of many numbers, those that are finite."""
    if isinstance(value, str):
        return f"{name}: {value}"
    array = np.asarray(value, dtype=float)
    if array.size <= _FEW:
        return f"{name}: {_numbers(array.ravel())}"
    finite = array[np.isfinite(array)]
    rms = np.sqrt(np.mean(finite**2))
    least, largest, rms = (_numbers([one]) for one in (finite.min(), finite.max(), rms))
    shape = " × ".join(map(str, array.shape))
    return f"{name}: {shape} from {least} to {largest}, rms {rms}"


def _numbers(values):
    return " ".join(f"{float(one) + 0.0:.6g}" for one in np.round(values, 6))
