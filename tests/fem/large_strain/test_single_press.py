"""Moduli at small strain, and presses that large deformation does not know, without a mesh."""

from types import SimpleNamespace

import numpy as np
import pytest
import scipy.sparse as sp
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
from fem.linear.response import FaceSurface

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


def test_the_large_problem_moves_free_nodes_and_presses_the_candidates(monkeypatch):
    """Seven nodes; the third is held by the core, the last two are a magnet's, which moves as one.

    Of the faces' vertices 5, 6, 8 and 9 the second and fourth are candidates.
    """
    owner = np.array([-1, -1, -1, -1, -1, 0, 0])
    asked = []
    monkeypatch.setattr(single_press, "finite_strain_elements", lambda space: "elements")
    monkeypatch.setattr(single_press, "magnet_of_nodes", lambda mesh, space: owner)
    monkeypatch.setattr(
        single_press,
        "shell_body_layout",
        lambda spec: SimpleNamespace(centre_mm=np.array([[1.0, 2.0, 3.0]])),
    )
    monkeypatch.setattr(single_press, "contact_face", lambda *given: asked.append(given) or "face")
    monkeypatch.setattr(single_press, "PressProblem", lambda *given: given)
    held = sp.csr_matrix(np.delete(np.eye(21), [2, 9, 16], axis=1))
    compressibility = np.arange(49.0).reshape(7, 7)
    system = SimpleNamespace(
        space=SimpleNamespace(
            node_count=7, pressure_nodes=np.array([0, 3, 4]), nodes_mm=np.arange(21.0).reshape(7, 3)
        ),
        motion_basis=held,
        mesh=SimpleNamespace(facets=np.array([[5, 6, 9, 1], [6, 8, 8, 2], [8, 9, 5, 3]])),
        operators=SimpleNamespace(compressibility=compressibility),
    )
    found = single_press.press_problem.__wrapped__(
        SPEC,
        SimpleNamespace(magnets=1),
        system,
        MATERIAL,
        "frame",
        np.array([0, 1, 2]),
        np.array([1, 3]),
    )
    elements, material, softness, own, nodes, moved, of_magnet, centre, face, radius = found
    assert (elements, material, face, radius) == ("elements", MATERIAL, "face", 5.0)
    nu = SPEC.silicone.poisson_ratio
    modulus = 2 * (1 + nu) * 0.12
    assert_allclose(softness, (1 + nu) * (1 - 2 * nu) / (modulus * nu))
    assert_allclose(own, compressibility[np.ix_([0, 3, 4], [0, 3, 4])])
    assert_allclose(nodes, system.space.nodes_mm)
    ((mesh, facets, vertices, frame),) = asked
    assert mesh is system.mesh
    assert (facets.tolist(), vertices.tolist(), frame) == ([0, 1, 2], [6, 9], "frame")
    assert moved.tolist() == [True, True, False, True, True, False, False]
    assert of_magnet.tolist() == owner.tolist()
    assert centre.tolist() == [[1, 2, 3]]


def test_candidates_lie_nearer_to_the_tip_than_its_radius(monkeypatch):
    """On the face's own frame, with the material's modulus; a vertex exactly a radius away is none."""
    xy = np.array([[3.0, 0.0], [7.99, 0.0], [8.0, 0.0], [3.0, 4.99], [3.0, -5.01], [0.0, 4.1]])
    asked = {}
    surface = FaceSurface(4, xy, np.array([[0, 1, 2]]))
    monkeypatch.setattr(
        single_press, "elastic_system", lambda mesh, spec: SimpleNamespace(mesh=spec, space=1)
    )
    monkeypatch.setattr(
        single_press, "face_facets", lambda mesh, spec, frame: asked.update(mesh=mesh, frame=frame)
    )
    monkeypatch.setattr(
        single_press, "face_surface", lambda space, facets, frame: (surface, "moments")
    )
    monkeypatch.setattr(single_press, "press_problem", lambda *given: given[-1])
    monkeypatch.setattr(single_press, "PressSetting", lambda *given: given)
    found = single_press.press_setting.__wrapped__(SPEC, None, 4, np.array([3.0, 0.0]), MATERIAL)
    assert asked["frame"].number == 4
    assert asked["mesh"].silicone.youngs_modulus_mpa == pytest.approx(
        2 * (1 + SPEC.silicone.poisson_ratio) * 0.12
    )
    assert found[7].tolist() == found[8].tolist() == [0, 1, 3]
