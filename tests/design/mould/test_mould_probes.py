"""The mould casts the shell, comes apart, and the probes have the paper's tips."""

import cadquery as cq
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.distance import pdist

from design.errors import InputError
from design.layout.mould.closure import flange_span_mm
from design.layout.tips import tip_positions_mm
from design.mould.one_piece import make_mould_box
from design.mould.plug import make_mould_plug
from design.solids.probes import make_probe
from design.solids.shell import make_shell
from design.spec.fabrication import MouldSpec
from design.spec.object import (
    BodySpec,
    ContactGridSpec,
    IndenterSpec,
    MagnetSpec,
    ObjectSpec,
    ShellSpec,
)
from tests.support.objects.shell_volume import cast_cavity

PAPER = ObjectSpec(name="paper")
SKEWED = ObjectSpec(
    name="skewed",
    body=BodySpec(size_mm=(50.0, 46.0, 40.0)),
    shell=ShellSpec(thickness_mm=7.0, pocket_diameter_mm=5.0, pocket_depth_mm=2.5),
    magnets=MagnetSpec(diameter_mm=5.0, positions_mm=((2.0, -1.0), (-9.0, 4.0), (7.0, -9.5))),
)


def assert_casts(cavity, shell):
    """Equal volumes, and nothing of the one outside the other."""
    assert_allclose(cavity.Volume(), shell.Volume(), rtol=1e-6)
    outside = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
    assert_allclose(outside, 0, rtol=0, atol=1e-6 * shell.Volume())


@pytest.mark.parametrize("spec", [PAPER, SKEWED], ids=lambda spec: spec.name)
def test_envelope_less_mould_less_plug_is_the_shell(spec):
    assert_casts(cast_cavity(spec), make_shell(spec))


def changed(**parts):
    return SKEWED.model_copy(update=parts)


@pytest.mark.parametrize("spec", [PAPER, SKEWED], ids=lambda spec: spec.name)
def test_the_plug_fits_the_box_and_draws_straight_out(spec):
    box, plug = make_mould_box(spec), make_mould_plug(spec)
    for way in (0.0, 1.0, 5.0, 30.0):
        drawn = plug.translate(cq.Vector(0, 0, -way))
        assert_allclose(box.intersect(drawn).Volume(), 0, rtol=0, atol=1e-9)
    pushed = plug.translate(cq.Vector(0, 0, 0.2))
    assert box.intersect(pushed).Volume() > 1, "the plate must rest on the tabs"


@pytest.mark.parametrize("spec", [PAPER, SKEWED], ids=lambda spec: spec.name)
def test_silicone_can_be_poured_beside_the_flange(spec):
    box, plug = make_mould_box(spec), make_mould_plug(spec)
    x, _, z = np.asarray(spec.body.size_mm) / 2
    for side in (-1, 1):
        slot = cq.Vector(side * (x - spec.shell.thickness_mm / 2), 0, -z - 2)
        assert not box.isInside(slot)
        assert not plug.isInside(slot)


def test_mould_box_follows_the_docstrings_sum():
    walls = 45 * 45 * 43.5 - 42**3
    bosses, tabs = 25 * np.pi * 9 * 3, 2 * 1.5 * (2 * 30.4 + 4 * 2 * 7.3)
    assert_allclose(make_mould_box(PAPER).Volume(), walls + bosses + tabs, rtol=1e-9)


def test_the_plug_is_the_authors():
    """Volume and corners read off their STEP file: x − 22.5, −(z + 22.5), and −21 − (y − 43.5)."""
    plug = make_mould_plug(PAPER.changed(printer=PAPER.printer.changed(clearance_mm=0.05)))
    assert_allclose(plug.Volume(), 34454.65, rtol=1e-9)
    theirs = [(9.5, 9.5, -9.5), (35.5, 43.5, -35.5)]  # core
    theirs += [(7.5, y, z) for y, z in [(43.5, -1.55), (45.5, -1.55), (45.5, 0.05)]]  # seat
    theirs += [(37.5, y, z) for y, z in [(43.5, 0.05), (43.5, 2.5), (53.5, 2.5)]]  # clip
    theirs += [(37.5, 53.5, -7.5), (28.875, 53.5, -7.5), (16.125, 53.5, -37.5)]  # blocks
    theirs += [(7.5, 45.5, -10.5), (7.5, 48.9, -7.5), (22.5, 53.5, -34.5)]  # gable and chamfers
    x, y, z = np.array(theirs).T
    expected = np.column_stack([x - 22.5, -(z + 22.5), -21 - (y - 43.5)])
    corners = np.array([corner.toTuple() for corner in plug.Vertices()])
    away = np.linalg.norm(corners[None] - expected[:, None], axis=2).min(axis=1)
    assert_allclose(away, 0, atol=1e-3)


@pytest.mark.parametrize("aside_mm", [3.0, 8.0, 40.0])
def test_a_flange_of_any_width_is_whole_and_its_gable_is_no_steeper_than_45_degrees(aside_mm):
    """Of rods and plugs; the grip's ridge rises by half its width, at most to the blocks' top."""
    spec = SKEWED.changed(body=SKEWED.body.changed(size_mm=(2 * aside_mm + 14, 60.0, 44.0)))
    plug, (left, right) = make_mould_plug(spec), flange_span_mm(spec)
    ends = [
        z
        for z in np.arange(0.0, 10.0, 0.05)
        if plug.isInside(cq.Vector((left + right) / 2, 0.0, -22.0 - z - 0.025))
    ]
    assert max(ends) == pytest.approx(2 + min(8, (right - left) / 2), abs=0.06)


def test_box_walls_follow_the_mould_dimensions():
    thick = make_mould_box(PAPER.model_copy(update={"mould": MouldSpec(wall_mm=2.5)})).BoundingBox()
    assert_allclose([thick.xlen, thick.ylen, thick.zlen], [47, 47, 48.5], rtol=0, atol=1e-6)


def test_tips_are_spaced_as_in_the_paper():
    assert_allclose(tip_positions_mm(1), [[0, 0]], rtol=0, atol=0)
    assert_allclose(pdist(tip_positions_mm(2)), [15], rtol=1e-12)
    assert_allclose(pdist(tip_positions_mm(3)), [20, 20, 20], rtol=1e-12)
    for tips in (2, 3):
        assert_allclose(tip_positions_mm(tips).mean(axis=0), 0, rtol=0, atol=1e-12)


def test_large_tips_stay_apart():
    assert_allclose(pdist(tip_positions_mm(2, 9.0)), [27], rtol=1e-12)
    assert_allclose(pdist(tip_positions_mm(3, 9.0)), [36] * 3, rtol=1e-12)


def test_there_is_no_probe_with_four_tips():
    with pytest.raises(InputError, match="1, 2 or 3 tips; got 4"):
        tip_positions_mm(4)


@pytest.mark.parametrize("tips", [1, 2, 3])
@pytest.mark.parametrize("radius", [5.0, 8.0])
def test_probe_volume_and_lowest_points(tips, radius):
    indenter, grid = IndenterSpec(radius_mm=radius), ContactGridSpec(count=(8, 8))
    spec = ObjectSpec(name="probe", indenter=indenter, contact_grid=grid)
    probe, centres = make_probe(spec, tips), tip_positions_mm(tips, radius)
    plate = np.prod(2 * (np.abs(centres).max(axis=0) + radius + 5)) * 4
    tip = 2 / 3 * np.pi * radius**3 + np.pi * radius**2 * 10
    assert_allclose(probe.Volume(), plate + tips * tip, rtol=1e-9)
    for x, y in centres:
        assert probe.isInside(cq.Vector(x, y, 1e-3))
        # Half way up the hemisphere, just inside and just outside the sphere.
        for scale, expected in ((0.999, True), (1.001, False)):
            edge = radius * scale * np.sqrt(0.5)
            assert probe.isInside(cq.Vector(x + edge, y, radius - edge)) is expected
