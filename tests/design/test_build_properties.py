"""Random specifications: every part is one valid solid, and the mould casts the shell."""

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.mould import cast_cavity
from design.parts import parts_of
from design.shell import make_shell
from design.spec import ObjectSpec
from design.volumes import shell_volume_mm3


def between(low, high):
    return st.floats(low, high, allow_nan=False).map(lambda value: round(value, 2))


@st.composite
def specifications(draw):
    """Valid objects that differ in every dimension that the parts depend on."""
    thickness = draw(between(5.0, 9.0))
    size = [2 * thickness + draw(between(25.0, 34.0)) for _ in range(3)]
    wall = draw(between(3.0, 5.0))
    diameter, depth = draw(between(3.0, 6.5)), draw(between(1.5, 3.5))
    room = min(size) / 2 - depth - diameter / 2 - 0.1
    count = draw(st.integers(1, 4))
    places = draw(st.lists(st.tuples(*[between(-room, room)] * 2), min_size=count, max_size=count))
    content = {
        "name": "random",
        "body": {"size_mm": size},
        "shell": {
            "thickness_mm": thickness,
            "pocket_diameter_mm": diameter,
            "pocket_depth_mm": depth,
        },
        "magnets": {"diameter_mm": diameter, "height_mm": 0.8, "positions_mm": places},
        "core": {
            "wall_mm": wall,
            "recess_depth_mm": wall - 0.5,
            "recess_width_mm": draw(between(3.0, 7.0)),
        },
        "sensors": {
            "count_per_face": draw(st.integers(1, 4)),
            "depth_below_core_face_mm": 1.0,
            "first_azimuth_deg": draw(st.tuples(*[between(0.0, 360.0)] * 5)),
        },
        "press": {"depths_mm": [0.5, 1.0]},
        "indenter": {"radius_mm": draw(between(2.0, 10.0))},
    }
    try:
        return ObjectSpec.model_validate(content)
    except ValidationError:
        assume(False)


@settings(max_examples=8, deadline=None, derandomize=True)
@given(spec=specifications())
def test_random_objects_build_and_their_mould_casts_their_shell(spec):
    for part in parts_of(spec):
        solid = part.make()
        assert solid.isValid()
        assert solid.Volume() > 0
    shell, cavity = make_shell(spec), cast_cavity(spec)
    assert_allclose(shell.Volume(), shell_volume_mm3(spec), rtol=1e-8)
    assert_allclose(cavity.Volume(), shell.Volume(), rtol=1e-6)
    difference = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
    assert_allclose(difference, 0, rtol=0, atol=1e-6 * shell.Volume())
    assert np.isfinite(shell.Center().toTuple()).all()
