"""Keys, slits, seal layer, channels and bay: volumes in closed form, and what is refused."""

import cadquery as cq
import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.fit.parts import distance_mm
from design.layout.blocks import core_keys, relief_slits
from design.layout.volumes import sealed_volume_mm3
from design.mould.one_piece import make_seal_mould
from design.solids.body import outer_solid
from design.solids.core import make_core
from design.solids.shell import make_shell
from design.spec_io import parse_spec
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

KEYS = {
    "core": {"keys": {"positions_mm": [[11.5, 11.0], [-11.2, 11.5]], "size_mm": [2.0, 3.0, 1.5]}}
}
SLITS = {"shell": {"slits": {"depth_mm": 3.0, "width_mm": 0.8}}}
LAYER = {"shell": {"seal_layer_mm": 0.7}}
ALL = {
    "body": {"size_mm": [50.0, 46.0, 44.0]},
    "shell": {"seal_layer_mm": 0.7, "slits": {"depth_mm": 2.5, "width_mm": 1.2}},
    "core": {"keys": {"positions_mm": [[12.0, -11.8]], "size_mm": [2.0, 3.0, 2.0]}},
}
CASES = {"keys": KEYS, "slits": SLITS, "seal layer": LAYER, "all": ALL}


def parsed(**content):
    return parse_spec({"name": "t", **content}, "test")


@pytest.mark.parametrize(
    "name", ["all", *(pytest.param(n, marks=pytest.mark.slow) for n in CASES if n != "all")]
)
@pytest.mark.parametrize("style", ["one-piece", "split"])
def test_the_mould_casts_exactly_the_shell(name, style):
    spec = parsed(**CASES[name], mould={"style": style})
    shell, cavity = make_shell(spec), cast_cavity(spec)
    assert_allclose(shell.Volume(), shell_volume_mm3(spec), rtol=1e-9)
    assert_allclose(cavity.Volume(), shell.Volume(), rtol=1e-9)
    outside = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
    assert_allclose(outside, 0, rtol=0, atol=1e-6 * shell.Volume())


def test_volumes_by_hand():
    pockets = 25 * np.pi * 9 * 3
    plain = 42**3 - 26 * 26 * 34
    assert_allclose(sealed_volume_mm3(parsed(**KEYS)), plain - 10 * 2 * 3 * 1.5, rtol=1e-12)
    lengths = 4 * (42 - 2 * 8) + 4 * (42 - 8)  # four edges of the top, four down to the rim
    slits = (0.8 * 3 - 0.8**2 / 4) * lengths
    assert_allclose(shell_volume_mm3(parsed(**SLITS)), plain - pockets - slits, rtol=1e-12)
    thin = (42 - 1.4) ** 2 * (42 - 0.7) - 26 * 26 * 34 - 25 * np.pi * 9 * 2.3
    assert_allclose(shell_volume_mm3(parsed(**LAYER)), thin, rtol=1e-12)


@pytest.mark.parametrize("name", ["keys", "all"])
def test_keys_of_the_core_fill_the_shells_recesses(name):
    spec = parsed(**CASES[name])
    shell, core = make_shell(spec), make_core(spec)
    assert_allclose(shell.intersect(core).Volume(), 0, rtol=0, atol=1e-6)
    for key in core_keys(spec):
        tip = cq.Vector(*(key.centre_mm + 0.9 * key.half_mm[2] * key.axes[:, 2]))
        assert core.isInside(tip)
    shifted = core.translate(cq.Vector(0.5, 0, 0))
    bare = make_core(parsed(**CASES[name] | {"core": {}}))
    locked = (
        shell.intersect(shifted).Volume()
        - shell.intersect(bare.translate(cq.Vector(0.5, 0, 0))).Volume()
    )
    assert locked > 1, "a shift must press the keys into the silicone"


def test_the_second_pour_adds_the_layer_and_fills_the_pockets():
    spec = parsed(**LAYER)
    poured = outer_solid(spec).cut(make_seal_mould(spec), make_shell(spec)).Volume()
    cavity = 26 * 26 * 34
    by_hand = 42**3 - cavity - shell_volume_mm3(spec)
    assert_allclose(poured - cavity, by_hand, rtol=1e-9)


def test_slits_lie_between_the_sensed_faces_alone():
    slits = relief_slits(parsed(**SLITS))
    assert len(slits) == 8
    assert all(abs(slit.axes[:, 1]).max() == pytest.approx(np.sqrt(0.5)) for slit in slits)
    assert not relief_slits(parsed())


def test_wire_channels_reach_every_recess():
    spec = parsed(core={"wire_channel_mm": [1.4, 1.2]})
    plain, channelled = make_core(parsed()), make_core(spec)
    for azimuth in np.deg2rad([240.0, 0.0, 120.0]):  # of face 1's recesses
        middle = 3.2 * np.array([np.cos(azimuth), np.sin(azimuth)])
        point = cq.Vector(*middle, 13 - 1.0)
        assert plain.isInside(point)
        assert not channelled.isInside(point)


def test_a_bay_widens_the_cavity():
    spec = parsed(core={"bay_mm": [18.2, 17.5, 12.0]})
    removed = make_core(parsed()).cut(make_core(spec)).Volume()
    assert 0 < removed < (18.2 * 17.5 - 17 * 17) * 12
    assert not make_core(spec).isInside(cq.Vector(9.0, 0, -12))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ({"core": {"keys": {"positions_mm": [[0, 12]]}}}, "past the core's patch"),
        ({"core": {"keys": {"positions_mm": [[7, 0]]}}}, "sensor's recess"),
        ({"core": {"keys": {"positions_mm": [[0, 1]]}}}, "wire hole"),
        (
            {"core": {"keys": {"positions_mm": [[11, 11], [11.4, 10]], "size_mm": [2, 2, 1.5]}}},
            "meets key 2",
        ),
        (
            {"core": {"keys": {"positions_mm": [[11.4, 11.4]], "size_mm": [3, 3, 5.5]}}},
            "into the pocket of",
        ),
        (KEYS | {"mechanics": {"interface": "frictionless"}}, "cannot slide on a frictionless"),
        ({"shell": {"slits": {"depth_mm": 11}}}, "of silicone over the core"),
        (
            {"magnets": {"positions_mm": [[14.5, 0]]}, "shell": {"slits": {"depth_mm": 6}}},
            "meets a relief slit",
        ),
        ({"shell": {"seal_layer_mm": 2.1}}, "sticking out of the first pour"),
        ({"core": {"wire_channel_mm": [1, 5]}}, "below core.wall_mm"),
        ({"core": {"bay_mm": [21, 10, 10]}}, "less than printer.wall_mm"),
        ({"printer": {"name": "laser"}}, "not in the catalogue"),
    ],
)
def test_what_does_not_fit_is_refused(content, message):
    with pytest.raises(InputError, match=message):
        parsed(**content)


def test_distance_of_points_from_a_convex_polygon():
    square = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    assert distance_mm(square, np.array([1.0, 1.0])) == 0
    assert_allclose(distance_mm(square, np.array([5.0, -4.0])), 5.0, rtol=1e-12)
