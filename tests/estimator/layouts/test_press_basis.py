"""Tables of presses that a batch of layouts can be scored on, and those that it cannot."""

from types import SimpleNamespace

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.layouts.press_basis import _check
from fem.candidates.motions import FaceCandidates

CUBE = ObjectSpec(name="cube")


def lattice(face, reach=18.0, count=4):
    axis = np.linspace(-reach, reach, count)
    return FaceCandidates(face, axis, axis, np.array([2.0, 4.0]))


def check(*lattices, face=1, forces=2, places=(4, 4)):
    motions = SimpleNamespace(
        faces=np.array([one.face for one in lattices]),
        force_n=np.ones((len(lattices), 16, forces)),
        places=SimpleNamespace(shape=places),
        candidates=lattices,
    )
    _check.__wrapped__(CUBE, motions, face)


def test_faces_that_are_alike_share_a_layout_and_one_face_is_enough():
    check(lattice(1))
    check(lattice(1), lattice(3), lattice(5), face=5)
    with pytest.raises(InputError, match=r"face 2 was not pressed. Choose one of \[1, 3\]"):
        check(lattice(1), lattice(3), face=2)


@pytest.mark.parametrize("other", [lattice(3, reach=18.1), lattice(3, count=5)])
def test_faces_that_differ_are_refused_wherever_they_come(other):
    for lattices in ((lattice(1), other), (lattice(1), lattice(2), other), (other, lattice(5))):
        with pytest.raises(InputError, match="one layout cannot be repeated"):
            check(*lattices, face=int(lattices[0].face))
    with pytest.raises(InputError, match="candidates of face 3 are not those of face 1"):
        check(lattice(1), other)


@pytest.mark.parametrize("changes", [{"forces": 1}, {"places": (3, 4)}, {"places": (4, 3)}])
def test_derivatives_need_two_forces_and_four_locations_each_way(changes):
    with pytest.raises(InputError, match="need two forces and four locations per axis"):
        check(lattice(1), **changes)
