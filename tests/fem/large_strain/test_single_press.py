"""Moduli at small strain, and presses that large deformation does not know, without a mesh."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from fem.large_strain import single_press
from fem.large_strain.hyperelastic import yeoh
from fem.large_strain.single_press import (
    lame_of,
    require_press,
    sphere_centre_mm,
    with_modulus_of,
)

SPEC = ObjectSpec(name="cube")
MATERIAL = yeoh(0.06)
"""Of a shear modulus of twice its first constant."""


def test_a_material_s_modulus_at_small_strain_is_three_times_that_of_shear_and_a_little_less():
    nu = SPEC.silicone.poisson_ratio
    modulus = 2 * (1 + nu) * 0.12
    assert_allclose(MATERIAL.shear_modulus_mpa, 0.12)
    assert_allclose(with_modulus_of(SPEC, MATERIAL).silicone.youngs_modulus_mpa, modulus)
    lame = lame_of(SPEC, MATERIAL)
    assert_allclose(lame.shear_modulus_mpa, 0.12)
    assert_allclose(lame.inverse_lambda_per_mpa, (1 + nu) * (1 - 2 * nu) / (modulus * nu))


def test_the_tip_s_middle_stands_its_radius_above_how_deep_it_is_pressed():
    frame = face_frames(SPEC)[2]
    setting = SimpleNamespace(spec=SPEC, frame=frame, xy_mm=np.array([3.0, -4.0]))
    found = sphere_centre_mm.__wrapped__(setting, 1.5)
    assert_allclose(found, frame.to_object(np.array([3.0, -4.0, 3.5])))


@pytest.mark.parametrize(
    ("x_mm", "y_mm", "depths_mm", "said"),
    [
        (16.01, 0.0, [1.0], "hangs over the border"),
        (0.0, -16.01, [1.0], "hangs over the border"),
        (0.0, 0.0, [], "must increase from above 0"),
        (0.0, 0.0, [0.0, 1.0], "must increase from above 0"),
        (0.0, 0.0, [1.0, 1.0], "must increase from above 0"),
        (0.0, 0.0, [1.0, 5.0], "stay below the tip's radius"),
    ],
)
def test_presses_over_the_border_or_too_deep_are_refused(x_mm, y_mm, depths_mm, said):
    require_press(SPEC, 3, 16.0, -16.0, [1e-3, 1.0, 4.99])
    with pytest.raises(InputError, match=said):
        require_press(SPEC, 3, x_mm, y_mm, depths_mm)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"indenter": {"kind": "flat"}}, "presses one hemisphere"),
        ({"indenter": {"tip_count": 2}}, "presses one hemisphere"),
        ({"indenter": {"direction_deg": [5.0, 0.0]}}, "presses one hemisphere"),
        ({"indenter": {"friction": "sticking"}}, "presses one hemisphere"),
        ({"mechanics": {"interface": "frictionless"}}, "need a bonded core"),
        ({"mechanics": {"slip": {"shift_mm": [0.1, 0.0, 0.0]}}}, "a core that has slipped"),
        ({"body": {"sensed_faces": [1]}}, "face 3 is not sensed"),
        ({"body": {"kind": "sphere", "size_mm": [50.0, 50.0, 50.0]}}, "face 3 is curved"),
    ],
)
def test_what_large_deformation_does_not_know_is_refused(changes, said):
    spec = ObjectSpec.model_validate({"name": "x"} | changes)
    with pytest.raises(InputError, match=said):
        require_press(spec, 3, 0.0, 0.0, [1.0])


@pytest.mark.parametrize("magnets", ["rigid", "points"])
def test_magnets_are_rigid_where_the_specification_says_so(magnets):
    spec = SPEC.changed(mechanics=SPEC.mechanics.changed(magnets=magnets))
    setting = object.__new__(single_press.PressSetting)
    setting.__dict__["spec"] = spec
    assert setting.rigid_magnets == (magnets == "rigid")
