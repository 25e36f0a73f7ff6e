"""Lengths along the central sections of a patch, against closed forms."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.special import ellipeinc

from design.body.section_lengths import section_lengths
from design.body.surface_chart import Cap, cap_frame, flat_frame
from design.layout.body import face_frame, face_frames
from tests.support.objects.body_cases import body_spec


def test_on_flat_faces_places_are_those_of_the_plane_bit_for_bit():
    frame = flat_frame(2, np.array([30.0, 20.0, 15.0]))
    places = np.random.default_rng(0).normal(0, 9, (50, 2))
    assert_array_equal(frame.to_plane(places), places)
    assert_array_equal(frame.from_plane(places), places)
    assert_array_equal(frame.lengths_mm, [[-15.0, -30.0], [15.0, 30.0]])
    assert_array_equal(frame.area_stretch(places), 1.0)


def test_along_a_cylinder_lengths_are_its_own_and_round_it_they_are_arcs():
    frame = face_frame(body_spec("sleeve"), 3)
    places = np.random.default_rng(1).uniform(-1, 1, (50, 2)) * [20.0, 20.0]
    plane = frame.to_plane(places)
    assert_array_equal(plane[:, 0], places[:, 0])
    assert_allclose(plane[:, 1], 20 * np.sin(places[:, 1] / 20), atol=1e-8)
    assert_allclose(frame.area_stretch(places), 1.0, atol=1e-6)


def test_along_an_ellipsoid_they_are_elliptic_integrals():
    """With y = b sin t along the section of semi-axes b and c, the length is b E(t, 1 − c²/b²)."""
    frame = cap_frame(1, np.array([30.0, 25.0, 22.0]), np.zeros(3))
    turn = np.linspace(-1.1, 1.1, 23)
    for axis, across in enumerate((30.0, 25.0)):
        xy = np.zeros((len(turn), 2))
        xy[:, axis] = across * np.sin(turn)
        exact = across * ellipeinc(turn, 1 - (22 / across) ** 2)
        assert_allclose(frame.from_plane(xy)[:, axis], exact, atol=1e-7)


@pytest.mark.parametrize("name", ["cylinder", "capsule", "sphere", "hollow_dome", "ellipsoid"])
def test_there_and_back(name):
    for frame in face_frames(body_spec(name)):
        plane = np.random.default_rng(2).uniform(-1, 1, (200, 2)) * frame.half_extents_mm
        assert_allclose(frame.to_plane(frame.from_plane(plane)), plane, rtol=0, atol=1e-6)


def test_steps_along_a_section_that_is_not_symmetric_are_even():
    """The planted fault: the plane's own steps are a tenth too long at one end."""

    class Leaning(Cap):
        def evaluate(self, xy_mm):
            height, slope = super().evaluate(xy_mm)
            x = xy_mm[..., 0]
            steeper = np.stack([-0.1 * x**2 / 15, 0 * x], axis=-1) / 3
            return height - 0.1 * x**3 / 135, slope + steeper

    relief = Leaning((25.0, 25.0, 25.0))
    section = section_lengths(lambda t: relief.evaluate(t[..., None] * [1.0, 0.0])[1][..., 0], 15.0)
    assert section is not None
    assert section_lengths(np.zeros_like, 15.0) is None
    fine = np.linspace(-15, 15, 30001)
    points = np.column_stack([fine, relief.evaluate(np.column_stack([fine, 0 * fine]))[0]])
    walked = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    walked -= walked[15000]
    assert abs(walked[0]) < walked[-1] - 0.3
    assert_allclose(section.to_lengths(fine), walked, atol=1e-5)
    at = np.interp(section.to_plane(np.arange(-15.0, 16.0, 3.0)), fine, walked)
    assert_allclose(np.diff(at), 3.0, atol=1e-5)
    assert abs(np.diff(np.interp(np.arange(-15.0, 16.0, 3.0), fine, walked)) - 3.0).max() > 0.3


def test_beyond_its_ends_a_section_goes_on_straight():
    frame = cap_frame(1, np.full(3, 20.0), np.zeros(3))
    (_, low), (_, high) = frame.lengths_mm
    assert high == pytest.approx(20 * np.pi / 3, abs=1e-6)
    assert low == -high
    beyond = frame.to_plane(np.array([[0.0, high + 2.0]]))[0, 1]
    assert beyond == pytest.approx(20 * np.sin(np.pi / 3) + 2 * 0.5, abs=1e-5)


def test_a_border_is_told_along_the_surface():
    border = cap_frame(1, np.full(3, 20.0), np.zeros(3)).border_mm()
    reach = 20 * np.sin(np.pi / 3)
    assert_allclose(np.hypot(*(20 * np.sin(border / 20)).T), reach, atol=1e-6)
    assert_allclose(abs(flat_frame(1, np.full(3, 20.0)).border_mm()), 20.0)
