"""Presses on the real object: contact conditions, growth, the layer's force, frames, symmetry."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError, StoreError
from design.layout.places.contact_grid import press_lattice
from design.layout.places.positions import magnet_layout
from fem.contact.complementarity import contact_pressures
from fem.contact.indenter import moved, tip_cells
from fem.contact.refined import cells_compliance, refined_face, spread_cells, wide_block
from fem.presses.results import load_presses, save_presses
from fem.presses.table import (
    press_face,
    press_places,
    profile_moments_mm3,
    simulate_lattice,
    surface_weights_mm2,
)
from tests.support.mechanics.fem_cases import (
    DEPTHS_MM as DEPTHS,
)
from tests.support.mechanics.fem_cases import (
    dimitriadis_force_n,
    forces_near_the_centre,
    random_places,
    relative_mirror_difference,
)

RADIUS = 5.0


@pytest.fixture(scope="module")
def told():
    """Progress lines of the presses."""
    return []


@pytest.fixture(scope="module")
def wide_spec(rigid_spec):
    """Return the cube with a lattice of 3 mm, of a quarter of the places."""
    return rigid_spec.changed(contact_grid={"count": "fill", "pitch_mm": 6.0})


@pytest.fixture(scope="module")
def presses(wide_spec, rigid_response, told):
    return simulate_lattice(wide_spec, rigid_response, told.append)


def nearest_place(spec, x, y):
    distance = np.linalg.norm(press_lattice(spec).xy_mm - [x, y], axis=1)
    assert distance.min() < 1e-9
    return int(np.argmin(distance))


def test_contact_conditions_hold_at_every_press(rigid_spec, rigid_response):
    """Pressure ≥ 0, gap ≥ 0 and never both, over all cells of two faces' presses."""
    tip = tip_cells(rigid_spec.indenter)
    area = tip.patches.area_mm2
    for index, place in ((0, (3.3, -4.7)), (3, (-11.0, 8.0))):
        face = refined_face(rigid_response, index, rigid_spec)
        spread = spread_cells(face, moved(tip.patches, np.array(place)), np.array(place))
        compliance = wide_block(spread) + cells_compliance(tip.patches, rigid_spec)
        for pressure, depth in zip(
            contact_pressures(compliance, tip.height_mm * area, area, DEPTHS), DEPTHS, strict=True
        ):
            gap = compliance @ pressure / area + tip.height_mm - depth
            assert (pressure >= 0).all()
            assert (pressure > 0).sum() > 20
            assert gap.min() > -1e-8
            assert abs(gap[pressure > 0]).max() < 1e-8
            touched = np.linalg.norm(tip.patches.centre_mm[pressure > 0], axis=1)
            assert touched.max() < 0.95 * RADIUS  # the cells under the tip are enough


def test_hats_that_stand_for_the_contact_have_its_force_and_its_place(rigid_spec, rigid_response):
    xy = random_places(6, 10.0)
    presses = press_face(rigid_spec, rigid_response, 3, xy, DEPTHS)
    surface = rigid_response.surfaces[3]
    weights = surface_weights_mm2(surface)
    assert_allclose(presses.vertex_mpa @ weights, presses.force_n, rtol=1e-10)
    middle = (presses.vertex_mpa * weights) @ surface.xy_mm / presses.force_n[..., None]
    assert abs(middle - xy[:, None]).max() < 0.5  # magnets below one side draw the pressure


def test_the_tip_s_profile_is_integrated_against_the_hats(rigid_response):
    """Sum over vertices = ∫ profile dA over the face, in polar coordinates."""
    surface = rigid_response.surfaces[1]
    centre = np.array([[3.3, -4.7]])
    dish = np.pi * RADIUS**3 - 2 * np.pi * RADIUS**3 / 3
    flat = RADIUS * (surface_weights_mm2(surface).sum() - np.pi * RADIUS**2)
    total = profile_moments_mm3(surface, centre, RADIUS).sum()
    assert_allclose(total, dish + flat, rtol=2e-4)
    moments = profile_moments_mm3(surface, centre, RADIUS)[0] / surface_weights_mm2(surface)
    assert np.linalg.norm(surface.xy_mm[np.argmin(moments)] - centre) < 1.5


def test_a_tip_just_touches_a_face_that_lies_higher_just_so(rigid_response):
    surface, centre = rigid_response.surfaces[1], np.array([[3.3, -4.7]])
    lifted = replace(surface, height_mm=np.full(len(surface.xy_mm), 0.7))
    moments = profile_moments_mm3(lifted, centre, RADIUS)
    assert_allclose(moments, profile_moments_mm3(surface, centre, RADIUS), rtol=1e-9, atol=1e-12)


def test_force_rises_faster_than_depth(presses):
    """Every doubling of the depth more than doubles the force, at every place."""
    forces, _ = presses
    assert (forces.force_n > 0).all()
    assert (forces.force_n[..., 1:] > 2 * forces.force_n[..., :-1]).all()


def test_contact_is_not_one_patch_scaled(presses):
    """The area is a sum over cells, so single places step; it hardly ever shrinks."""
    area = presses[0].contact_area_mm2
    mean = area.mean(axis=(0, 1))
    assert mean[2] > 2 * mean[0]
    assert (mean[1:] > 1.25 * mean[:-1]).all()
    assert (area[..., 2] >= area[..., 1]).mean() > 0.98
    assert (area[..., 2] > area[..., 0]).mean() > 0.98


def test_a_deeper_simulation_does_not_depend_on_the_steps_before_it(rigid_spec, rigid_response):
    xy = random_places(5, 10.0)
    stepped = press_places(rigid_spec, rigid_response, 4, xy, DEPTHS)[:, -1]
    at_once = press_places(rigid_spec, rigid_response, 4, xy, DEPTHS[-1:])[:, 0]
    assert_allclose(stepped, at_once, rtol=0, atol=1e-9 * stepped.max())


def test_layer_force_without_magnets(rigid_spec, plain_response):
    """1.69 N at 1 mm and 5.5 N at 2 mm on an endless layer; this coarse mesh is below."""
    mean = forces_near_the_centre(rigid_spec, plain_response, 60).mean(axis=(0, 1))
    assert_allclose(mean[1:], [1.69, 5.5], rtol=0.10)
    assert_allclose(mean[1], dimitriadis_force_n(1.0, RADIUS, 8.0), rtol=0.10)


@pytest.mark.parametrize("xy", [(21.2, 0.0), (0.0, -21.2)])
def test_a_tip_that_lands_beside_the_face_is_refused(rigid_spec, rigid_response, xy):
    with pytest.raises(InputError, match="misses face 4"):
        press_places(rigid_spec, rigid_response, 3, np.array([[0.0, 0.0], xy]), DEPTHS)


@pytest.mark.parametrize(
    ("xy", "magnet", "centre"),
    [
        ((9.0, -6.0), 14, (18.5, -10.0, -10.0)),
        ((-12.0, 9.0), 12, (18.5, 10.0, 10.0)),
        ((6.0, 3.0), 10, (18.5, 0.0, 0.0)),
    ],
)
def test_a_press_on_face_3_pushes_its_nearest_magnet_inwards(
    wide_spec, presses, xy, magnet, centre
):
    """Face 3: normal +x, its x axis is −z, its y axis +y; the magnet's place is spelt out here."""
    _, motions = presses
    assert_allclose(magnet_layout(wide_spec).centre_mm[magnet], centre, rtol=0, atol=1e-9)
    motion = motions.motion[2, nearest_place(wide_spec, *xy), -1]
    inwards = -motion[:, 0]
    assert int(np.argmax(inwards)) == magnet
    assert inwards[magnet] > 0.03


def test_magnets_beside_a_press_are_pushed_away_from_it(wide_spec, presses):
    """At (+6, +3) on face 3, that is y = 3, z = −6: the silicone gives way sideways."""
    _, motions = presses
    motion = motions.motion[2, nearest_place(wide_spec, 6.0, 3.0), -1]
    _, y, z = motion[10, :3]  # at y = 0, z = 0
    assert y < -0.05
    assert z > 1.4 * abs(y)
    _, y, z = motion[11, :3]  # at y = 10, z = −10
    assert y > 0.1
    assert z < -0.1


def test_a_magnet_beside_the_press_tilts_towards_it(wide_spec, presses):
    """Press face 3 at (+3, 0): its x is −z, so the centre magnet's −z edge sinks towards −x.

    (ω × r)_x = ω_y r_z: ω_y > 0, and the north (+x) leans towards the press, (ω × x̂)_z = −ω_y.
    """
    _, motions = presses
    omega = motions.motion[2, nearest_place(wide_spec, 3.0, 0.0), -1, 10, 3:]
    assert omega[1] > 0.05
    assert abs(omega[1]) > 5 * max(abs(omega[0]), abs(omega[2]))


def test_mirrored_presses_agree_within_the_mesh_s_own_scatter(wide_spec, presses):
    """1 to 2 % with surface edges of 1.7 mm, small contacts no worse than large ones."""
    difference = relative_mirror_difference(presses[0].force_n[0], wide_spec)
    assert (difference < 0.03).all()


def test_progress_is_told_face_by_face(presses, told):
    assert [line.split(":")[0] for line in told] == [f"face {n}" for n in range(1, 6)]


def test_saved_presses_come_back_alike_with_axes_in_order(presses, wide_spec, tmp_path):
    forces, motions = presses
    places = len(press_lattice(wide_spec))
    assert forces.force_n.shape == (5, places, 3)
    assert motions.motion.shape == (5, places, 3, 25, 6)
    save_presses(forces, motions, tmp_path / "presses.nc")
    read_forces, read_motions = load_presses(tmp_path / "presses.nc")
    for saved, read in ((forces, read_forces), (motions, read_motions)):
        for name in set(vars(saved)) - {"lattice"}:
            np.testing.assert_array_equal(getattr(read, name), getattr(saved, name))
        np.testing.assert_array_equal(read.lattice.xy_mm, press_lattice(wide_spec).xy_mm)
    assert list(read_forces.faces) == [1, 2, 3, 4, 5]


def test_presses_of_another_schema_are_refused(presses, tmp_path, monkeypatch):
    from fem.presses import results

    other = replace(results.PRESSES_KIND, schema=("schema_version", 999))
    monkeypatch.setattr(results, "PRESSES_KIND", other)
    forces, motions = presses
    save_presses(forces, motions, tmp_path / "presses.nc")
    monkeypatch.undo()
    with pytest.raises(StoreError, match="schema"):
        load_presses(tmp_path / "presses.nc")
