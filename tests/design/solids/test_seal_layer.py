"""Seal layers on bodies of every kind: what the first pour casts, and the mould of the second."""

import pytest
from numpy.testing import assert_allclose

from design.body.meshes import distance_mm
from design.build.parts import parts_of
from design.errors import InputError
from design.fabrication.casting import check_casting
from design.layout.body import body_of
from design.layout.core_hold import locators
from design.layout.surface import cast_surface
from design.layout.volumes import sealed_volume_mm3
from design.mould.one_piece import make_seal_mould
from design.mould.plug import make_mould_plug
from design.solids.body import outer_solid
from design.solids.booleans import convert_to_triangles, volume_mm3
from design.solids.sampled import sampled_shell
from design.solids.shell import cavity, make_shell
from tests.random_designs.judge import violations
from tests.support.objects.body_cases import body_spec
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

LAYER_MM = 0.6
OPEN = ("cylinder", "sleeve", "dome_on_core", "solid_dome", "pad")
CAST_IN = ("sphere", "capsule", "ellipsoid")


def layered(name, **changes):
    return body_spec(name, shell={"seal_layer_mm": LAYER_MM}, **changes)


def shell_of(spec):
    return sampled_shell(spec) if body_of(spec).sampled else make_shell(spec)


@pytest.mark.parametrize(
    "name", [*OPEN, *(pytest.param(name, marks=pytest.mark.slow) for name in CAST_IN)]
)
def test_the_first_pour_is_the_formulas_and_the_mould_casts_it(name):
    spec = layered(name)
    shell = volume_mm3(shell_of(spec))
    assert_allclose(shell, shell_volume_mm3(spec), rtol=2e-3)  # mouths on slopes
    thick = shell_volume_mm3(body_spec(name))
    assert thick - shell > 0.3 * LAYER_MM / spec.shell.thickness_mm * thick
    assert_allclose(volume_mm3(cast_cavity(spec)), shell, rtol=1e-4)


@pytest.mark.parametrize("name", ["cylinder", "dome_on_core"])
def test_the_second_pour_fills_up_to_the_body_s_size(name):
    """Of a shell on its plug in the seal box."""
    spec = layered(name)
    room = outer_solid(spec).cut(make_seal_mould(spec), make_mould_plug(spec), make_shell(spec))
    layer = sealed_volume_mm3(spec) - make_shell(spec).Volume()
    assert_allclose(room.Volume(), layer, rtol=1e-5)
    assert not any(volume_mm3(room.intersect(solid)) > 1e-6 for solid in cavity(spec))


@pytest.mark.parametrize("name", ["ellipsoid", "sphere", "capsule", "cylinder"])
def test_the_layer_is_as_thick_all_over(name):
    spec = layered(name)
    inner, outer = cast_surface(spec), body_of(spec).outer_surface()
    points = inner.vertices[:: max(1, len(inner.vertices) // 400)]
    beside = points[points[:, 2] > -spec.body.size_mm[2] / 2 + 1e-6]  # but for an open end
    assert_allclose(distance_mm(outer, beside), LAYER_MM, rtol=0, atol=0.04)


def test_a_closed_body_is_held_beside_its_magnets_in_both_pours():
    spec = layered("ellipsoid", magnets={"positions_mm": [[0.0, 0.0]]})
    assert len(locators(spec)) == 2
    assert all(not locator.pockets for locator in locators(spec))
    names = [part.name for part in parts_of(spec)]
    assert {"mould_seal_half_a", "mould_seal_half_b", "mould_locator_1"} <= set(names)
    assert "mould_seal_box" not in names


def test_a_layer_thicker_than_the_cover_over_a_rim_is_refused():
    """On the axis the silicone is thicker than over the magnet's rim."""
    with pytest.raises(InputError, match="sticking out of the first pour"):
        body_spec("sphere", shell={"seal_layer_mm": 1.95})
    body_spec("pad", shell={"seal_layer_mm": 1.95})


@pytest.mark.slow
@pytest.mark.parametrize("name", CAST_IN)
def test_the_mould_of_the_second_pour_closes_round_the_shell_and_opens(name):
    spec = layered(name)
    built = {
        p.name: convert_to_triangles(p.make()) for p in parts_of(spec) if "probe" not in p.name
    }
    assert not [told for told in violations(spec, built) if "board" not in told]
    seal = [f for f in check_casting(spec, built) if f.part.startswith("mould_seal")]
    assert {f.check for f in seal} >= {"undercut", "mould closes", "air traps"}
    assert not [f for f in seal if f.status == "fail"]
    shifted = built["mould_seal_half_a"].copy().apply_translation([0, 0, 2.0])
    found = check_casting(spec, built | {"mould_seal_half_a": shifted})
    assert any(f.status == "fail" and f.part.startswith("mould_seal") for f in found)
