"""Constants, defaults of functions and keys, and limits of keys are those that are on record."""

import pytest

import design
import estimator
import fem
from tests.support.recorded_results.constants import FOLDER, lines_of


@pytest.mark.parametrize("package", [design, estimator, fem], ids=lambda package: package.__name__)
def test_no_constant_or_default_changes_unseen(package):
    """Deliberate ones: python -m tests.support.recorded_results.constants. New ones may be missing."""
    text = (FOLDER / f"{package.__name__}.txt").read_text(encoding="utf-8")
    recorded = {line.partition("=")[0]: line for line in text.splitlines()}
    found = {line.partition("=")[0]: line for line in lines_of(package)}
    both = recorded.keys() & found.keys()
    assert {name: found[name] for name in both} == {name: recorded[name] for name in both}
    assert len(both) > 0.8 * len(found)
