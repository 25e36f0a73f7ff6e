"""Shells for bodies that the halves of a mould hook, by hand."""

import re
import warnings
from dataclasses import replace

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.errors import SpecError
from design.fit.everything import problems_of
from design.placement import hooking
from design.placement.asked import place_parts
from design.placement.hooking import (
    castable_request,
    least_hooked_mm,
    shell_variants_of,
    simple_body_text,
    with_thinnest,
)
from design.placement.objects import SHELL_VARIANTS, Request, ShellVariant, spec_of


def lump(longest_mm, scale=1.0):
    file = (("file", "lump.stl"), ("scale", scale))
    return Request("imported", (longest_mm, 0.8 * longest_mm, 0.5 * longest_mm), file=file)


@pytest.mark.parametrize(
    ("hooked_mm", "longest_mm", "first", "thinnest"),
    [
        (0.09, 60.0, SHELL_VARIANTS, SHELL_VARIANTS[-1]),
        (
            0.12,
            60.0,
            [(8, 6), (8, 5), (8, 4), (7, 5), (7, 4), (6, 4), (5, 4)],
            ShellVariant(7.0, 4.0, 3.0),
        ),
        (
            0.06,
            120.0,
            [(8, 6), (8, 5), (8, 4), (7, 5), (7, 4), (6, 4), (5, 4)],
            ShellVariant(7.0, 4.0, 3.0),
        ),
        (0.2, 60.0, [(11, 6), (11, 5), (11, 4), (8, 6)], ShellVariant(11.0, 4.0, 6.0)),
        (0.3, 60.0, SHELL_VARIANTS, SHELL_VARIANTS[-1]),  # which takes 16.5 mm
    ],
)
def test_a_body_that_hooks_gets_a_shell_that_gives_way(
    monkeypatch, hooked_mm, longest_mm, first, thinnest
):
    """By 2 % of its thickness, and a tenth to spare; hooks grow with the body, measured at 60 mm."""
    seen = []
    monkeypatch.setattr(hooking, "least_hooked_mm", lambda body: seen.append(body) or hooked_mm)
    tried = shell_variants_of(lump(longest_mm))
    if first is SHELL_VARIANTS:
        assert tried is SHELL_VARIANTS
    else:
        pairs = [(trim.thickness_mm, trim.pocket_diameter_mm) for trim in tried]
        assert pairs[: len(first)] == first
        assert set(SHELL_VARIANTS) <= set(tried)
    assert with_thinnest(lump(longest_mm)).thinnest == thinnest
    assert {body.size_mm for body in seen} == {(60.0, 48.0, 30.0)}
    assert {dict(body.file)["scale"] for body in seen} == {60.0 / longest_mm}


def test_a_bent_scan_is_refused_with_a_straight_body_that_takes_all_parts(tmp_path):
    """A bow of Ø 24 mm: a straight one of Ø 24 mm would be too thin."""
    bow = trimesh.creation.icosphere(4)
    x, y, z = (bow.vertices * (12, 12, 90)).T
    bow.vertices = np.column_stack([(90 + x) * np.cos(z / 90), y, (90 + x) * np.sin(z / 90)])
    bow.vertices += np.random.default_rng(0).normal(0, 0.1, bow.vertices.shape)
    bow.export(tmp_path / "bow.stl")
    read = body_of_file(tmp_path / "bow.stl")
    request = Request(
        "imported", tuple(read["size_mm"]), file=(("file", read["file"]), ("scale", 1.0))
    )
    with pytest.raises(SpecError, match=r"outside its surface, as of bent and thin") as refused:
        castable_request(replace(request, takes_fewer=True), tmp_path / "castable.stl")
    named = re.findall(r"--kind capsule --size ([\d.]+) ([\d.]+) ([\d.]+)", str(refused.value))
    x, y, z = map(float, named[0])
    assert 24 <= x <= 32
    capsule = Request("capsule", (x, y, z), takes_fewer=True)
    assert problems_of(spec_of(place_parts(capsule))) == []


def test_simple_bodies_that_take_parts_on_some_faces_say_so_before_the_least_that_does_on_all():
    """Scissors as a capsule of 26 × 26 × 193 mm took two sensors on faces 2 to 5 alone."""
    request = Request("imported", (26.0, 60.0, 193.0), file=(("file", "scissors.stl"),))
    request = replace(request, takes_fewer=True)
    text = simple_body_text(request, "capsule", (26.0, 26.0, 193.0))
    sizes = re.findall(r"--kind capsule --size ([\d.]+) ([\d.]+) ([\d.]+)", text)
    some, every = (
        place_parts(replace(request, kind="capsule", size_mm=tuple(map(float, size)), file=()))
        for size in sizes
    )
    assert some["body"]["sensed_faces"] == [2, 3, 4, 5]
    assert "that takes parts on 4 faces; or" in text
    assert "sensed_faces" not in every["body"]
    assert every["sensors"]["count_per_face"] == 3
    thick = simple_body_text(request, "capsule", (60.0, 60.0, 193.0))
    assert thick == "take a simple body, as --kind capsule --size 60 60 193"


def test_what_is_closed_is_said_once_in_the_file_s_own_mm(tmp_path):
    """Hooks and distances are measured on the body made smaller: holes are smaller there."""
    ball = trimesh.creation.icosphere(3, 60.0)
    ball.update_faces(ball.triangles[:, :, 2].max(axis=1) > -55)
    ball.export(tmp_path / "ball.stl")
    with pytest.warns(UserWarning, match="closed small holes"):
        read = body_of_file(tmp_path / "ball.stl")
    file = (("file", read["file"]), ("scale", 1.0))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        castable_request(
            Request("imported", tuple(read["size_mm"]), file=file), tmp_path / "castable.stl"
        )


def test_hooks_are_those_of_the_file_s_content(tmp_path):
    """A ball, then under the same name and in the same box one with dents on four sides."""
    hooked_mm = []
    for deep in (0.0, 0.3):
        ball = trimesh.creation.icosphere(3, 30.0)
        x, y, z = ball.vertices.T
        for axis, aside in ((0, y), (1, x)):
            ball.vertices[:, axis] *= 1 - deep * np.exp(-(aside**2 + z**2) / 150)
        ball.apply_scale(60 / ball.extents)
        ball.export(tmp_path / "ball.stl")
        read = body_of_file(tmp_path / "ball.stl")
        file = (("file", read["file"]), ("scale", 1.0))
        hooked_mm.append(least_hooked_mm(Request("imported", tuple(read["size_mm"]), file=file)))
    assert hooked_mm[0] < 1e-3 < hooked_mm[1]


def test_kinds_know_where_their_halves_hook_nothing(monkeypatch):
    monkeypatch.setattr(hooking, "least_hooked_mm", lambda body: 1 / 0)
    assert shell_variants_of(Request("sphere", (60.0, 60.0, 60.0))) is SHELL_VARIANTS
