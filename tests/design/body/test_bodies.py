"""Every kind of body: volumes by hand, walls as measured, parts that are one closed solid."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.body.sampled import measured_distance_mm, sampled_core
from design.layout.body import body_of, face_frames
from design.layout.surface import sealed_body_surface
from design.layout.volumes import sealed_volume_mm3
from design.solids.body import outer_solid
from design.solids.core import make_core
from design.solids.sampled import sampled_core_part, sampled_shell
from design.solids.shell import cavity, make_shell
from tests.support.objects.body_cases import BODIES, body_spec

EXACT = [name for name in BODIES if name != "ellipsoid"]


def _ball(radius: float) -> float:
    return 4 / 3 * np.pi * radius**3


def _bored(radius: float, bore: float) -> float:
    return 2 / 3 * np.pi * (radius**3 - (radius**2 - bore**2) ** 1.5)


BY_HAND = {
    "pad": 40 * 30 * 6,
    "cylinder": np.pi * (20**2 * 50 - 12**2 * 42),
    "sleeve": np.pi * (20**2 - 12**2) * 50,
    "capsule": _ball(20) - _ball(12) + np.pi * (20**2 - 12**2) * 24 - _bored(20, 4) + _bored(12, 4),
    "sphere": _ball(22) - _ball(14) - _bored(22, 4) + _bored(14, 4),
    "solid_dome": _ball(12) / 2,
    "hollow_dome": (_ball(18) - _ball(13)) / 2,
    "dome_on_core": (_ball(20) - _ball(12)) / 2,
    "two_open": 42 * 44 * 46 - 34 * 28 * 38,
    "closed_box": 42 * 44 * 46 - 26 * 28 * 30,
}


@pytest.mark.parametrize("name", EXACT)
def test_solids_and_formulas_have_the_volume_by_hand(name):
    spec = body_spec(name)
    assert_allclose(sealed_volume_mm3(spec), BY_HAND[name], rtol=1e-12)
    holes = cavity(spec, 0.5)
    sealed = outer_solid(spec).cut(*holes) if holes else outer_solid(spec)
    assert_allclose(sealed.Volume(), BY_HAND[name], rtol=1e-9)


@pytest.mark.parametrize("name", EXACT)
def test_the_mesher_s_surface_is_closed_and_has_that_volume(name):
    spec = body_spec(name)
    surface = sealed_body_surface(spec)
    assert surface.is_watertight
    assert_allclose(surface.volume, BY_HAND[name], rtol=2e-3)


@pytest.mark.parametrize("name", EXACT)
def test_shell_and_core_are_single_solids_with_their_pockets(name):
    spec = body_spec(name)
    shell, core = make_shell(spec), make_core(spec)
    assert shell.isValid()
    assert core.isValid()
    faces = len(spec.body.sensed)
    pockets = faces * np.pi * 3**2 * 3
    if name == "closed_box":
        # two pins of a wire hole's width held the core; each meets a pocket
        pockets += 2 * (np.pi * 2**2 * 8 - 3 * _lens_mm2(2.0, 3.0, 5**0.5))
    assert 0.9 * pockets < BY_HAND[name] - shell.Volume() <= pockets * (1 + 1e-9)


def _lens_mm2(r, s, d):
    """Area that two circles share."""
    along = (d**2 + r**2 - s**2) / (2 * d)
    halves = r**2 * np.arccos(along / r) + s**2 * np.arccos((d - along) / s)
    return halves - d * np.sqrt(r**2 - along**2)


def test_an_ellipsoid_s_core_has_steiner_s_volume():
    """Of the inner parallel body: V − t S + t² M − 4π/3 t³, S and M by quadrature."""
    spec, t = body_spec("ellipsoid"), 8.0
    a, b, c = 30.0, 25.0, 22.0
    theta = np.pi * (np.arange(400) + 0.5) / 400
    phi = 2 * np.pi * (np.arange(400) + 0.5) / 400
    u, v = np.meshgrid(theta, phi, indexing="ij")
    n = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)])
    support = np.sqrt((a * n[0]) ** 2 + (b * n[1]) ** 2 + (c * n[2]) ** 2)
    mean_curvature = float((support * np.sin(u)).sum() * (np.pi / 400) * (2 * np.pi / 400))
    area = a * b * c * np.sqrt((n[0] / a) ** 2 + (n[1] / b) ** 2 + (n[2] / c) ** 2) * np.sin(u)
    surface = float(area.sum() * (np.pi / 400) * (2 * np.pi / 400))
    parallel = 4 / 3 * np.pi * a * b * c - t * surface + t**2 * mean_curvature - _ball(t)
    assert_allclose(sampled_core(body_of(spec)).volume, parallel, rtol=5e-3)
    assert_allclose(body_of(spec).outer_surface().volume, 4 / 3 * np.pi * a * b * c, rtol=1e-9)


def test_a_sampled_wall_measures_its_thickness_everywhere():
    body = body_of(body_spec("ellipsoid"))
    inner = np.asarray(sampled_core(body).vertices)
    wall = -measured_distance_mm(body.outer_surface(), inner)
    assert 7.95 < wall.min() <= wall.max() < 8.05
    assert -measured_distance_mm(body.outer_surface(), 1.02 * inner).max() < 7.95  # planted fault


def test_sampled_parts_are_closed_and_fill_the_body_together():
    spec = body_spec("ellipsoid")
    shell, core = sampled_shell(spec), sampled_core_part(spec)
    assert shell.is_watertight
    assert core.is_watertight
    assert core.body_count == 1
    assert shell.body_count == 1  # outside and inside meet in the holes of two locating pins
    pockets = 6 * np.pi * 3**2 * 3 + 2 * np.pi * 2**2 * 8
    removed = (
        body_of(spec).outer_surface().volume - sampled_core(body_of(spec)).volume - shell.volume
    )
    assert 0.9 * pockets < removed < pockets


@pytest.mark.parametrize("name", sorted(BODIES))
def test_the_core_ends_where_the_inner_surface_is(name):
    """Points one thickness below a patch lie on the core, or in a hollow or solid dome nowhere."""
    spec = body_spec(name)
    for frame in face_frames(spec):
        below = frame.to_object(np.array([[1.0, 2.0, -spec.shell.thickness_mm]]))
        distance = body_of(spec).core_distance_mm(below)
        if spec.body.inside == "core":
            assert abs(distance[0]) < 0.03
        else:
            assert distance[0] > 1


LONG = {"package_mm": [6.6, 6.2, 1.6]}


@pytest.mark.parametrize(
    ("name", "changes", "wanted"),
    [
        ("cylinder", {"body": {"size_mm": [40, 41, 50]}}, "x and y alike"),
        ("capsule", {"body": {"size_mm": [40, 40, 40]}}, "alike, the diameter, and z above it"),
        ("capsule", {"body": {"open_faces": [1]}}, r"may name \[6\]"),
        (
            "capsule",
            {"contact_grid": {"count": [8, 8], "pitch_mm": 6.0}},
            "leave face 1, an ellipse",
        ),
        ("sphere", {"body": {"open_faces": [1]}}, r"may name \[6\]"),
        ("sphere", {"body": {"sensed_faces": [6]}}, "closed faces"),
        ("sphere", {"body": {"inside": "air"}}, "is for 'dome'"),
        ("sphere", {"magnets": {"positions_mm": [[15.5, 0.0], [-15.5, 0.0]]}}, "touch or overlap"),
        ("sphere", {"contact_grid": {"pitch_mm": 16.0}}, "leave face 1, an ellipse"),
        ("sphere", {"mechanics": {"interface": "frictionless"}}, "for boxes only"),
        ("hollow_dome", {"shell": {"thickness_mm": 18}}, "below the dome's radius"),
        ("solid_dome", {"body": {"size_mm": [24, 24, 13]}}, "rigid base is 1 mm"),
        ("solid_dome", {"sensors": {"positions_mm": [[13.0, 0.0]]}}, "outside the core's patch"),
        ("pad", {"sensors": {"positions_mm": [[[0, 0]], [[1, 1]]]}}, "holds 2 lists"),
        ("cylinder", {"sensors": {"positions_mm": [[15.0, 0.0]]} | LONG}, "1.1 mm out of the core"),
        ("pad", {"sensors": {"positions_mm": [[18.0, 0.0]]} | LONG}, "1.1 mm out of the core"),
        ("closed_box", {"body": {"open_faces": [1, 2, 3, 4, 5, 6]}}, "no face of silicone"),
        ("closed_box", {"body": {"open_faces": [2, 3, 4, 5]}}, "in two pieces"),
        (
            "pad",
            {"core": {"recess_inner_radius_mm": 3.264, "recess_outer_radius_mm": 6.9}},
            r"begins 2 mm .* where half of core.wire_hole_side_diameter_mm = 2",
        ),
    ],
)
def test_what_does_not_fit_is_refused_with_the_reason(name, changes, wanted):
    with pytest.raises(ValueError, match=wanted):
        body_spec(name, **changes)


@pytest.mark.parametrize("name", BODIES)
def test_the_outside_of_a_body_is_that_without_its_inside(name):
    """A pad's slab is as thick as its shell: by `outside` it had no sides, and its seam hooked nothing."""
    body = body_of(body_spec(name))
    outer = body.outer_surface()
    assert body.outside.outer_surface().volume == pytest.approx(outer.volume)
    assert_allclose(body.outside.outer_surface().bounds, outer.bounds, atol=1e-9)
