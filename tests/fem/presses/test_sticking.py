"""Sticking friction: Spence's punch, the incompressible half-space, shear of oblique paths."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.tips import tip_shape
from fem.contact.complementarity import contact_pressures
from fem.contact.half_space import traction_compliance
from fem.contact.indenter import tip_cells
from fem.contact.traction import TractionResponse, traction_response
from fem.presses import sticking
from fem.presses.joint import Tip, press_tips
from fem.presses.sticking import StickingSetting, press_sticking, sticking_setting
from tests.support.mechanics.block_cases import spec_of
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA

PLACE = Tip(3, 4.0, -6.0)


def on_half_space(poisson_ratio, fault=None, **indenter):
    spec = spec_of(poisson_ratio, friction="sticking", **indenter)
    cells = tip_cells(spec.indenter)
    count = len(cells.height_mm)
    compliance = traction_compliance(
        cells.patches, cells.patches, YOUNGS_MODULUS_MPA, poisson_ratio
    )
    if fault == "coupling":
        compliance[0, :, 1:] *= 1.5
        compliance[1:, :, 0] *= 1.5
    response = TractionResponse(compliance, np.zeros((6, 3, count)))
    owner = np.zeros(count, int)
    return StickingSetting(spec, (PLACE,), cells, owner, tip_shape(spec.indenter), response)


def frictionless_n(setting, depth_mm):
    cells, area = setting.cells, setting.cells.patches.area_mm2
    normal = setting.response.compliance[0, :, 0]
    return contact_pressures(normal, cells.height_mm * area, area, np.array([depth_mm]))[0] @ area


def stiffening(poisson_ratio, fault=None, **indenter):
    setting = on_half_space(poisson_ratio, fault, **indenter)
    return press_sticking(setting, np.array([0.25]))[-1].force_n[0] / frictionless_n(setting, 0.25)


@pytest.mark.parametrize("poisson_ratio", [0.01, 0.3])
def test_spence_s_punch(poisson_ratio):
    """F/F₀ = (1 − ν) ln(3 − 4ν)/(1 − 2ν) of a flat punch: Spence, Proc. R. Soc. A 305 (1968) 55."""
    nu = poisson_ratio
    exact = (1 - nu) * np.log(3 - 4 * nu) / (1 - 2 * nu)
    assert_allclose(stiffening(nu, kind="flat", radius_mm=3.0), exact, rtol=0.004)
    assert abs(stiffening(nu, "coupling", kind="flat", radius_mm=3.0) / exact - 1) > 0.01


PYRAMID = ((0.0, 0.0, 0.0), *((x, y, 3.0) for x in (-4.0, 4.0) for y in (-4.0, 4.0)))


@pytest.mark.parametrize(
    "indenter",
    [{}, {"kind": "cuboid", "size_mm": (5.0, 3.0)}, {"kind": "stl", "vertices_mm": PYRAMID}],
)
def test_friction_changes_nothing_on_an_incompressible_half_space(indenter):
    assert_allclose(stiffening(0.5, **indenter), 1, rtol=1e-9)


def test_a_punch_dragged_sideways_bears_mindlin_s_shear():
    """Q = 8 G a δ_t/(2 − ν), sticking everywhere (Johnson, Contact Mechanics, 7.2)."""
    nu, angle = 0.5, 20.0
    setting = on_half_space(nu, kind="flat", radius_mm=3.0, direction_deg=(angle, 0.0))
    press = press_sticking(setting, np.array([0.2]))[-1]
    shear_modulus = YOUNGS_MODULUS_MPA / (2 * (1 + nu))
    sideways = 0.2 * np.tan(np.deg2rad(angle))
    assert_allclose(press.shear_n[0, 0], 8 * shear_modulus * 3 * sideways / (2 - nu), rtol=0.015)
    assert abs(press.shear_n[0, 1]) < 1e-9


@pytest.fixture(scope="module")
def cube(coarse_mesh, rigid_spec):
    """The paper's cube under sticking indenters: a sphere straight and oblique, a flat punch."""
    changes = {
        "straight": {},
        "oblique": {"direction_deg": (0.0, 30.0)},
        "flat": {"kind": "flat", "radius_mm": 4.0},
    }

    responses = {}

    def known(spec, mesh, faces, groups):
        """Of the same cells, pressed straight or obliquely."""
        parts = [part for g in groups for part in (g.area_mm2, g.centre_mm, g.variance_mm2)]
        key = b"".join(np.ascontiguousarray(part).tobytes() for part in parts)
        if key not in responses:
            responses[key] = traction_response(spec, mesh, faces, groups)
        return responses[key]

    @cache
    def setting(name):
        indenter = rigid_spec.indenter.model_copy(update={"friction": "sticking", **changes[name]})
        spec = rigid_spec.model_copy(update={"indenter": indenter})
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(sticking, "traction_response", known)
            return sticking_setting(spec, coarse_mesh, [PLACE])

    return setting


def sticking_over_frictionless(setting, depth_mm, spec, response):
    stuck = press_sticking(setting, np.array([depth_mm]))[-1]
    indenter = setting.spec.indenter.model_copy(update={"friction": "none"})
    free = press_tips(
        spec.model_copy(update={"indenter": indenter}), response, [PLACE], np.array([depth_mm])
    )
    assert abs(stuck.shear_n[0]).max() < 0.1 * stuck.force_n[0]
    return stuck.force_n[0] / free.force_n[0]


def test_a_flat_punch_that_sticks_is_stiffer(cube, rigid_spec, rigid_response):
    """With one and the same contact friction only takes freedom away."""
    ratio = sticking_over_frictionless(cube("flat"), 1.0, rigid_spec, rigid_response)
    assert 1.005 < ratio < 1.2


def test_a_sphere_s_force_hardly_changes_and_not_at_the_first_touch(
    cube, rigid_spec, rigid_response
):
    """Deep presses come out some per cent softer: what is touched late has been pressed outwards."""
    args = (rigid_spec, rigid_response)
    assert_allclose(sticking_over_frictionless(cube("straight"), 0.2, *args), 1, rtol=0.003)
    assert_allclose(sticking_over_frictionless(cube("straight"), 2.0, *args), 1, rtol=0.05)


def test_pressures_alone_act_as_in_the_response_operator(cube, rigid_spec, rigid_response):
    """Normal tractions, condensed beside tangential ones, move the magnets as the operator says."""
    setting = cube("straight")
    area = setting.cells.patches.area_mm2
    compliance = setting.response.compliance[0, :, 0]
    pressure = contact_pressures(compliance, setting.cells.height_mm * area, area, np.array([1.5]))[
        0
    ]
    free = press_tips(rigid_spec, rigid_response, [PLACE], np.array([1.5]))
    assert_allclose(pressure @ area, free.force_n[0], rtol=1e-6)
    motion = (setting.response.motion[:, 0] @ pressure).reshape(-1, 6)
    assert_allclose(motion, free.motion, rtol=0, atol=1e-6 * abs(free.motion).max())


def test_an_oblique_path_drags_the_magnets_along(cube):
    """Face 3's y is the object's +y: the shear acts, and the magnet below moves, that way."""
    straight = press_sticking(cube("straight"), np.array([1.0]))[-1]
    oblique = press_sticking(cube("oblique"), np.array([1.0]))[-1]
    assert oblique.shear_n[0, 1] > 0.2 * oblique.force_n[0]
    assert abs(oblique.shear_n[0, 0]) < 0.15 * oblique.shear_n[0, 1]
    below = 10  # the centre magnet of face 3
    assert (oblique.motion - straight.motion)[below, 1] > 0.03


def test_a_press_goes_to_its_force_or_says_how_much_it_bears(monkeypatch):
    """Of an indenter that bears 3 N at 1 mm and as the depth to the power of 1.5."""

    def bears(setting, depth_mm):
        return [SimpleNamespace(force_n=3.0 * depth_mm**1.5, depth_mm=depth_mm)]

    monkeypatch.setattr(sticking, "press_sticking", bears)
    spec = SimpleNamespace(shell=SimpleNamespace(thickness_mm=8.0))
    setting = SimpleNamespace(tips=(PLACE,), shape=SimpleNamespace(height_mm=5.0), spec=spec)
    press = sticking.press_sticking_to_force.__wrapped__
    deepest = sticking.LARGEST_SHARE * 5.0
    most = 3.0 * deepest**1.5
    for force in (1e-3, 1.5, 3.0, 0.999 * most):
        (found,) = press(setting, force)
        assert_allclose(found.depth_mm, (force / 3) ** (2 / 3), atol=2e-6)
    for force in (0.0, -1.0, 1.001 * most):
        with pytest.raises(InputError, match=f"bears {most:.3g} N at {deepest:.3g} mm"):
            press(setting, force)
    setting.tips = (PLACE, PLACE)
    with pytest.raises(InputError, match="one press at a time goes to a force; got 2"):
        press(setting, 1.0)
