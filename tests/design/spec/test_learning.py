"""Collections that go together: tangential forces are those of one contact anywhere."""

import pytest
from pydantic import ValidationError

from design.spec.learning import CollectionSpec


def test_tangential_forces_are_of_one_contact_at_a_time():
    assert CollectionSpec(kind="continuous", contacts=1, tangential_share=0.5).contacts == 1
    for wrong in ({"contacts": 2}, {"kind": "paper"}):
        given = {"kind": "continuous", "tangential_share": 0.5} | wrong
        with pytest.raises(ValidationError, match="tangential_share works with"):
            CollectionSpec.model_validate(given)
    assert CollectionSpec(kind="continuous", contacts=2).tangential_share == 0
