"""Random specifications: every part is one valid solid, and the mould casts the shell."""

import signal
import time
from contextlib import contextmanager

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.fabrication import mesh_of
from design.mould import cast_cavity
from design.parts import parts_of
from design.shell import make_shell
from design.spec import ObjectSpec
from design.volumes import shell_volume_mm3

TIMEOUT_S = 120
"""For one object; on a quiet core it takes 3 to 10 s."""


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
    more = draw(extras(min(size) / 2 - thickness, thickness))
    content["shell"] |= more.pop("shell_extras")
    content["core"] |= more.pop("core_extras")
    content |= more
    try:
        return ObjectSpec.model_validate(content)
    except ValidationError:
        assume(False)


@st.composite
def extras(draw, half_core, thickness):
    """Keys at a corner of the core, slits, a seal layer, channels, either mould; each half the time."""
    at = half_core - 1.05
    corner = st.tuples(*[st.sampled_from([-at, at])] * 2)
    chosen = {
        "keys": {"positions_mm": [draw(corner)], "size_mm": [2.0, 2.0], "height_mm": 0.8},
        "slits": {
            "depth_mm": draw(between(1.0, 0.9 * thickness)),
            "width_mm": draw(between(0.5, 1.5)),
        },
        "seal_layer_mm": draw(between(0.2, 0.6)),
        "wire_channel_width_mm": draw(between(0.8, 1.6)),
    }
    kept = {key: value for key, value in chosen.items() if draw(st.booleans())}
    shell = {key: kept[key] for key in ("slits", "seal_layer_mm") if key in kept}
    core = {key: kept[key] for key in ("keys", "wire_channel_width_mm") if key in kept}
    style = draw(st.sampled_from(["one-piece", "split"]))
    return {"shell_extras": shell, "core_extras": core, "mould": {"style": style}}


class TooSlow(BaseException):
    """A build hung: not an error that a build could catch."""


@contextmanager
def within(seconds):
    """Raise TooSlow when the block takes longer (on the main thread)."""

    def stop(number, frame):
        raise TooSlow(f"a build took more than {seconds} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def assert_sound(spec):
    """Every part is one closed solid, and the mould casts the shell, of the volume in closed form."""
    with within(TIMEOUT_S):
        for part in parts_of(spec):
            solid = part.make()
            assert solid.isValid()
            assert len(solid.Solids()) == 1
            assert solid.Volume() > 0
            if part.name in ("core", "shell"):
                assert mesh_of(solid, spec).is_watertight
        shell, cavity = make_shell(spec), cast_cavity(spec)
        assert_allclose(shell.Volume(), shell_volume_mm3(spec), rtol=1e-8)
        assert_allclose(cavity.Volume(), shell.Volume(), rtol=1e-6)
        difference = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
        assert_allclose(difference, 0, rtol=0, atol=1e-6 * shell.Volume())
        assert np.isfinite(shell.Center().toTuple()).all()


@settings(max_examples=5, deadline=None, derandomize=True)
@given(spec=specifications())
def test_random_objects_build_and_their_mould_casts_their_shell(spec):
    assert_sound(spec)


@pytest.mark.slow
@settings(max_examples=200, deadline=None, derandomize=True)
@given(spec=specifications())
def test_two_hundred_random_objects_build(spec):
    assert_sound(spec)


def test_a_build_that_hangs_is_stopped():
    with pytest.raises(TooSlow), within(1):
        time.sleep(20)
