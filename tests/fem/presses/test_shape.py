"""Shapes of the table's presses: the face follows the tip, magnets move as the table says."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import fem.linear.response
import fem.presses.shape
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout
from fem.linear.core_interface import CoreContact
from fem.linear.factorization import SingularSystemError
from fem.linear.response import build_and_keep_factor
from fem.presses.shape import table_shapes
from tests.support.objects.small_object import small_spec

FACE, PLACE, DEPTH_MM = 2, np.array([[6.0, -3.5]]), 1.5


@pytest.fixture(scope="module")
def shape(rigid_spec, coarse_mesh, rigid_response):
    return table_shapes(rigid_spec, coarse_mesh, rigid_response, FACE, PLACE, DEPTH_MM)[0]


def check_the_face_follows_the_tip(shape, spec):
    """Where it touches the face has sunk by the depth less the tip's profile, weakly."""
    frame = face_frames(spec)[FACE]
    touched = shape.contact_pressure_mpa > 0.02
    place = np.asarray(frame.from_object(shape.nodes_mm[touched]))
    sunk = -(shape.displacement_mm[touched] @ np.asarray(frame.normal))
    distance = np.linalg.norm(place[:, :2] - PLACE[0], axis=1)
    expected = DEPTH_MM - (5 - np.sqrt(25 - distance**2))
    assert_allclose(place[:, 2], 0, atol=1e-6)
    assert touched.sum() > 8
    weights = shape.contact_pressure_mpa[touched]
    assert_allclose(weights @ sunk, weights @ expected, rtol=0.05)
    rms = np.sqrt(weights @ (sunk - expected) ** 2 / weights.sum())
    assert rms < 0.15 * DEPTH_MM, f"{rms:.3f} mm"


def test_the_face_follows_the_tip(shape, rigid_spec):
    check_the_face_follows_the_tip(shape, rigid_spec)


def test_magnets_move_as_by_the_response(shape, rigid_spec, rigid_response):
    """Reciprocity: the same contact pressures on the rows of the condensed compliance."""
    vertices = np.unique(shape.tets[:, :4])
    frame = face_frames(rigid_spec)[FACE]
    place = np.asarray(frame.from_object(shape.nodes_mm[vertices]))
    surface = rigid_response.surfaces[FACE]
    here = [
        vertices[np.argmin(np.linalg.norm(place - [x, y, 0.0], axis=1))] for x, y in surface.xy_mm
    ]
    pressure = shape.contact_pressure_mpa[here]
    rows = rigid_response.compliance[rigid_response.magnet_loads, rigid_response.face_loads(FACE)]
    motion = (rows @ pressure).reshape(-1, 6)
    centres = magnet_layout(rigid_spec).centre_mm
    for magnet in (0, 11, 13):
        nodes = np.unique(shape.tets[shape.magnet == magnet])
        arms = shape.nodes_mm[nodes] - centres[magnet]
        expected = motion[magnet, :3] + np.cross(motion[magnet, 3:], arms)
        assert_allclose(shape.displacement_mm[nodes], expected, atol=1e-9)


def test_silicone_under_the_tip_is_compressed_by_about_its_pressure(shape):
    assert shape.pressure_mpa is not None
    touched = shape.contact_pressure_mpa > 0.02
    ratio = shape.pressure_mpa[touched].mean() / shape.contact_pressure_mpa[touched].mean()
    assert 0.4 < ratio < 1.2
    inside = np.setdiff1d(
        np.unique(shape.tets[shape.magnet >= 0]), np.unique(shape.tets[shape.magnet < 0])
    )
    assert (shape.pressure_mpa[inside] == 0).all()


def test_the_factor_of_the_response_gives_the_same_shapes(small_mesh, small_response):
    spec = small_spec()
    (wanted,) = table_shapes(spec, small_mesh, small_response, FACE, PLACE, DEPTH_MM)
    response, factored = build_and_keep_factor(small_mesh, spec)
    assert factored is not None
    with factored.factor:
        given = spec, small_mesh, response, FACE, PLACE, DEPTH_MM, factored
        (again,) = table_shapes(*given)
    compliance = small_response.compliance
    assert_allclose(response.compliance, compliance, rtol=0, atol=1e-12 * abs(compliance).max())
    for name in ("displacement_mm", "pressure_mpa", "contact_pressure_mpa"):
        value = getattr(wanted, name)
        assert_allclose(getattr(again, name), value, rtol=0, atol=1e-10 * abs(value).max())


def test_loads_that_depend_on_each_other_give_the_response_without_a_factor(
    small_mesh, small_response, monkeypatch
):
    def refused(*_):
        raise SingularSystemError("the compliance of the loads is not positive definite")

    monkeypatch.setattr(fem.linear.response, "LoadedFactor", refused)
    response, factored = build_and_keep_factor(small_mesh, small_spec())
    assert factored is None
    compliance = small_response.compliance
    assert_allclose(response.compliance, compliance, rtol=0, atol=1e-12 * abs(compliance).max())


def test_a_sliding_shell_is_refused(rigid_spec, coarse_mesh, rigid_response):
    from dataclasses import replace

    core = CoreContact.__new__(CoreContact)
    with pytest.raises(InputError, match="bonded to its core"):
        table_shapes(
            rigid_spec, coarse_mesh, replace(rigid_response, core=core), FACE, PLACE, DEPTH_MM
        )
