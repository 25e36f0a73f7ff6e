"""What a body may be, on both sides of each border."""

import re
from itertools import combinations

import pytest

from design.errors import SpecError
from design.spec.body import MM, BodySpec
from design.spec.object import ObjectSpec, ShellSpec


def refused(message, **keys):
    with pytest.raises(SpecError, match=message):
        BodySpec(**keys)


def test_the_longest_edge_measures_5_to_1000_mm():
    for longest, beyond in ((5.0, 4.99), (1000.0, 1000.1)):
        assert BodySpec(size_mm=(longest, 3.0, 4.0)).size_mm[0] == longest
        refused(r"must measure 5 to 1000 mm; got .* which is in mm", size_mm=(beyond, 3.0, 4.0))
    assert BodySpec(size_mm=(1.0, 5.0, 1.0)).size_mm == (1.0, 5.0, 1.0)


@pytest.mark.parametrize(
    ("size_mm", "said"),
    [
        (
            (0.02, 0.04, 0.05),
            ["m: body.scale = 1000 (instobj new: --scale) makes it 50 mm", "makes it 1.27 mm"],
        ),
        ((0.4, 0.5, 0.5), ["--scale) makes it 5 mm", "--scale) makes it 500 mm"]),
        ((4e-4, 2e-4, 4e-4), ["body.scale = 100000 (instobj new: --scale) makes it 40 mm"]),
        ((2e4, 3e3, 2e4), ["body.scale = 0.001 (instobj new: --scale) makes it 20 mm"]),
        ((1600.0, 300.0, 900.0), ["body.scale = 0.01 (instobj new: --scale) makes it 16 mm"]),
        ((1560.0, 300.0, 900.0), ["body.scale = 0.1 (instobj new: --scale) makes it 156 mm"]),
    ],
)
def test_a_file_drawn_in_another_unit_is_told_with_units_that_work(size_mm, said):
    with pytest.raises(SpecError) as error:
        BodySpec(kind="imported", file="a.stl", open_faces=(), size_mm=size_mm)
    for words in said:
        size = float(re.search(r"makes it (\S+) mm", words)[1])
        assert (words in str(error.value)) == (5 <= size <= 1000), words


def test_units_in_mm():
    assert MM == {"mm": 1, "cm": 10, "m": 1000, "in": 25.4}


def test_open_and_sensed_faces():
    assert BodySpec().opened == (6,)
    assert BodySpec().sensed == (1, 2, 3, 4, 5)
    assert BodySpec(open_faces=(6, 3)).opened == (3, 6)
    assert BodySpec(open_faces=()).sensed == (1, 2, 3, 4, 5, 6)
    assert BodySpec(sensed_faces=(4, 1)).sensed == (1, 4)
    refused("must name some of the closed faces", sensed_faces=(6,))
    refused("must name some of the closed faces", sensed_faces=())
    refused("leaves no face of silicone", open_faces=(1, 2, 3, 4, 5, 6))


@pytest.mark.parametrize("closed", list(combinations(range(1, 7), 2)), ids=str)
def test_two_closed_faces_must_meet(closed):
    """Opposite ones: 1 and 6, 2 and 4, 3 and 5."""
    opened = tuple({1, 2, 3, 4, 5, 6} - set(closed))
    if closed in ((1, 6), (2, 4), (3, 5)):
        refused(rf"two faces \[{closed[0]}, {closed[1]}\] that do not meet", open_faces=opened)
    else:
        assert BodySpec(open_faces=opened).sensed == closed


def test_insides_and_files_go_with_their_kinds():
    assert BodySpec(kind="dome", size_mm=(40, 40, 24), inside="air", open_faces=()).inside == "air"
    refused("is for 'dome'", inside="air")
    refused("Give both or neither", file="a.stl")
    refused("Give both or neither", kind="imported", open_faces=())


def test_the_core_is_the_body_less_the_shell_on_every_side():
    body, shell = BodySpec(size_mm=(46.0, 50.0, 57.0)), ShellSpec(thickness_mm=8.5)
    assert ObjectSpec(name="x", body=body, shell=shell).core_size_mm == (29.0, 33.0, 40.0)
