"""Constants, defaults of functions and keys, and limits of keys are those that are on record."""

import pytest

import design
import estimator
import fem
from tests.support.recorded_results.constants import FOLDER, lines_of


@pytest.mark.parametrize("package", [design, estimator, fem], ids=lambda package: package.__name__)
def test_no_constant_or_default_changes_unseen(package):
    """Deliberate ones: python -m tests.support.recorded_results.constants"""
    recorded = (FOLDER / f"{package.__name__}.txt").read_text(encoding="utf-8").splitlines()
    found = lines_of(package)
    assert sorted({*found} ^ {*recorded}) == []
