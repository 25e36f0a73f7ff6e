"""Relief slits halfway between the sides of bodies without edges."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.fabrication.casting import check_seal_mould
from design.layout.blocks import relief_slits, slits_volume_mm3
from design.layout.surface import sealed_body_surface
from design.layout.volumes import sealed_volume_mm3
from design.mould.one_piece import make_seal_mould
from design.solids.booleans import convert_to_triangles, volume_mm3
from design.solids.shell import make_shell
from tests.support.objects.body_cases import body_spec
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

SLITS = {"depth_mm": 3.0, "width_mm": 0.8}


def slit(name, slits=None, **shell):
    return body_spec(name, shell={"slits": SLITS | (slits or {}), **shell})


def test_the_cylinder_s_by_hand():
    """Four of w × d × length, less what the round surface leaves over a chord w wide."""
    spec = slit("cylinder")
    assert len(relief_slits(spec)) == 4
    w, r, length = 0.8, 20.0, 50.0 - 2 * 8.0  # slits end the shell's thickness before the ends
    chord = np.linspace(-w / 2, w / 2, 2001)
    area = np.trapezoid(np.sqrt(r**2 - chord**2) - (r - 3.0), chord)
    assert_allclose(slits_volume_mm3(spec), 4 * area * length, rtol=1e-2)


@pytest.mark.parametrize("name", ["cylinder", "sleeve"])
def test_mesh_and_formula_leave_them_out(name):
    spec = slit(name)
    assert all(abs(block.axes[2, 1]) < 1e-12 for block in relief_slits(spec)), "no plane leans"
    surface = sealed_body_surface(spec)
    assert surface.is_watertight
    assert_allclose(surface.volume, sealed_volume_mm3(spec), rtol=2e-3)
    assert slits_volume_mm3(spec) > 50


@pytest.mark.parametrize(
    ("name", "style"),
    [
        ("cylinder", "one-piece"),
        ("cylinder", "split"),
    ],
)
def test_fins_of_the_mould_cast_them(name, style):
    spec = body_spec(name, shell={"slits": SLITS, "seal_layer_mm": 0.5}, mould={"style": style})
    shell = make_shell(spec)
    assert_allclose(volume_mm3(shell), shell_volume_mm3(spec), rtol=2e-3)
    assert_allclose(volume_mm3(cast_cavity(spec)), volume_mm3(shell), rtol=1e-4)


@pytest.mark.parametrize(
    ("name", "slits", "told"),
    [
        ("cylinder", {"depth_mm": 7.5}, "mm of silicone over the core"),
        ("cylinder", {"width_mm": 26.0}, "no slit along an edge of 50 mm"),
        ("sphere", {}, "fins in their seam would hook"),
        ("ellipsoid", {}, "two halves"),
        ("pad", {}, "has none"),
        ("dome_on_core", {}, "has none"),
        ("cylinder", {"width_mm": 22.0}, "meets a relief slit"),
    ],
)
def test_slits_that_do_not_fit_are_refused(name, slits, told):
    with pytest.raises(InputError, match=told):
        slit(name, slits)


def test_a_seal_box_with_fins_is_left_by_walls_that_fold_inwards():
    spec = body_spec("cylinder", shell={"slits": SLITS, "seal_layer_mm": 0.5})
    (told,) = check_seal_mould(
        spec, {"mould_seal_box": convert_to_triangles(make_seal_mould(spec))}
    )
    assert (told.check, told.status) == ("undercut", "pass")
    assert told.value > 0.5, "the fins hook until the plug is out"
