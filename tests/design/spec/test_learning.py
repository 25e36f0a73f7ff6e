"""Keys of learning that go together: tangential forces, and fingers known to be flat."""

from pathlib import Path

import pytest
from pydantic import ValidationError

from design.errors import SpecError
from design.spec.learning import CollectionSpec
from design.spec_io import load_spec

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_tangential_forces_are_of_one_contact_at_a_time():
    assert CollectionSpec(kind="continuous", contacts=1, tangential_share=0.5).contacts == 1
    for wrong in ({"contacts": 2}, {"kind": "paper"}):
        given = {"kind": "continuous", "tangential_share": 0.5} | wrong
        with pytest.raises(ValidationError, match="tangential_share works with"):
            CollectionSpec.model_validate(given)
    assert CollectionSpec(kind="continuous", contacts=2).tangential_share == 0


def test_flat_fingers_are_refused_where_no_face_is_flat():
    flat_fingers = ["inversion.probes='flat'"]
    assert load_spec(EXAMPLES / "paper_cube.toml", flat_fingers).inversion.probes == "flat"
    with pytest.raises(
        SpecError, match=r'probes = "flat" needs a flat sensed face.*Set it to "free"'
    ):
        load_spec(EXAMPLES / "ball.toml", flat_fingers)
