"""What the report tries next stays valid where the magnets were given by their grade."""

import pytest

from design.spec_io import parse_spec
from instobj.stages.makers.alternatives import _CHANGES


@pytest.mark.parametrize("change", _CHANGES)
def test_changes_of_a_graded_magnet_are_valid_specifications(change):
    spec = parse_spec({"name": "cube", "magnets": {"grade": "N42"}}, "test")
    other = parse_spec(_CHANGES[change](spec).model_dump(mode="json"), change)
    assert other != spec
    if "remanence" in change:
        assert other.magnets.remanence_t == pytest.approx(1.2 * 1.31)
