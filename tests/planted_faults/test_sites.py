"""Faults are planted where code is, change one expression, and leave a file that can be read."""

import ast
import random
from pathlib import Path

import pytest

from tests.planted_faults.sites import faults_in, packages_files

ROOT = Path(__file__).parents[2]


def planted(tmp_path, source):
    (tmp_path / "a.py").write_text(source, encoding="utf-8")
    return {fault.planted_in(source) for fault in faults_in(tmp_path, "a.py")}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("ok = a < b\n", {"ok = a <= b\n", "ok = a >= b\n"}),
        ("ok = a is not b\n", {"ok = a is b\n"}),
        ("f = m * a + b\n", {"f = m / a + b\n", "f = m * a - b\n"}),
        ("x -= step\n", {"x += step\n"}),
        ("y = -x if not done else x\n", {"y = x if not done else x\n", "y = -x if done else x\n"}),
        ("both = a and b\n", {"both = a or b\n"}),
        ("w = x.min(axis=1)\n", {"w = x.max(axis=1)\n", "w = x.min(axis=2)\n"}),
        ("µ = 0.5; flag = True\n", {"µ = 1.0; flag = True\n", "µ = 0.5; flag = False\n"}),
    ],
)
def test_a_fault_changes_one_expression(tmp_path, before, after):
    assert planted(tmp_path, before) == after


def test_texts_types_and_messages_hold_no_faults(tmp_path):
    source = '''"""Words 1 < 2."""
from typing import Literal
def f(n: Literal[1, 2]) -> "3 + 4":
    """More: 5 * 6."""
    assert n
    raise ValueError(f"{n + 1} is wrong", 7)
'''
    assert planted(tmp_path, source) == set()


def test_every_fault_of_our_code_leaves_a_file_that_can_be_read():
    files = packages_files(ROOT, ("design", "fem", "estimator"))
    found = [fault for path in files for fault in faults_in(ROOT, path)]
    assert len(found) > 10_000
    for fault in random.Random(1).sample(found, 100):
        ast.parse(fault.planted_in((ROOT / fault.path).read_text(encoding="utf-8")))
