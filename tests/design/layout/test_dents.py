"""Dents of the seals: shape, depth as found, and what is refused."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.dents import dents_mm, sunk_mm
from design.spec_io import parse_spec
from fem.large_strain.single_press import require_press


def parsed(**parts):
    return parse_spec({"name": "cube", **parts}, "test")


def sunk(face, magnet, depth_mm):
    return {"magnets": [{"face": face, "magnet": magnet, "dent_mm": depth_mm}]}


FOUND = sunk(3, 2, 0.9)


def test_a_dent_is_a_paraboloid_over_its_pocket():
    """Deepest in the middle of the mouth, a quarter less half-way to the rim, flush beyond it."""
    dents = [sunk(2, magnet, 0.4)["magnets"][0] for magnet in range(1, 6)]
    spec = parsed(as_built={"magnets": dents})
    places = np.array([[10, 10], [10, 11.5], [8.5, 10], [10, 13], [-6.9, -10], [5, 5]], float)
    expected = [0.4, 0.3, 0.3, 0, 0.4 * (1 - (3.1 / 3) ** 2), 0]
    assert_allclose(sunk_mm(spec, 2, places), np.clip(expected, 0, None), atol=1e-12)


def test_dents_over_blocks_and_tilted_magnets_lie_over_their_mouths():
    magnets = {"shape": "block", "size_mm": [5.0, 3.0], "positions_mm": [[2, 1]]}
    block = parsed(magnets=magnets, as_built=sunk(1, 1, 0.4))
    assert_allclose(sunk_mm(block, 1, np.array([[2, 1], [3.25, 1], [2, 1.75]])), [0.4, 0.3, 0.3])
    tilted = parsed(
        magnets={"positions_mm": [[2, 1]], "tilt_deg": [[0, 10]]}, as_built=sunk(1, 1, 0.4)
    )
    mouth = [2 + 2.5 * np.tan(np.deg2rad(10)), 1]
    assert_allclose(sunk_mm(tilted, 1, np.array([mouth])), 0.4)


def test_the_seal_of_the_magnet_that_is_named_has_the_dent():
    spec = parsed(as_built=FOUND)
    expected = np.zeros((5, 5))
    expected[2, 1] = 0.9
    assert_allclose(dents_mm(spec), expected)
    assert not dents_mm(parsed()).any()


@pytest.mark.parametrize(
    ("parts", "words"),
    [
        ({"as_built": sunk(1, 1, 2.1)}, r"a dent of 2.1 mm on face 1 reaches .*there are 2 mm"),
        ({"as_built": sunk(3, 2, 3.0)}, "on face 3 reaches"),
        ({"as_built": FOUND, "mechanics": {"correction": "large-strain"}}, "correction"),
        ({"as_built": FOUND, "mechanics": {"slip": {"shift_mm": [0.5, 0, 0]}}}, "mechanics.slip"),
        ({"as_built": FOUND, "indenter": {"friction": "sticking"}}, "indenter.friction"),
        ({"as_built": sunk(1, 1, -0.1)}, "dent_mm"),
    ],
)
def test_dents_that_cannot_be_are_refused(parts, words):
    with pytest.raises(InputError, match=words):
        parsed(**parts)


def test_a_press_with_large_deformation_refuses_dents():
    with pytest.raises(InputError, match=r"dents of the seals .* small strain"):
        require_press(parsed(as_built=FOUND), 1, 0.0, 0.0, [1.0])
