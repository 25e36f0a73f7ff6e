"""Sticking presses of several indenters by hand: whose cells are whose, heights, forces and shear."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.layout.tips import tip_heights_mm, tip_places_mm, tip_shape
from design.spec.object import ObjectSpec
from fem.contact.indenter import tip_cells
from fem.contact.traction import TractionResponse
from fem.presses import sticking
from fem.presses.joint import Tip
from fem.presses.sticking import StickingState

SPEC = ObjectSpec(name="cube")
TIPS = (Tip(3, 10.0, -6.0), Tip(5, -8.0, 2.0))


def made(monkeypatch):
    asked = []

    def traction_response(spec, mesh, faces, groups):
        asked.append((faces, groups))
        count = sum(len(group.area_mm2) for group in groups)
        eye = np.eye(3 * count).reshape(3, count, 3, count)
        return TractionResponse(eye, np.zeros((12, 3, count)))

    monkeypatch.setattr(sticking, "traction_response", traction_response)
    return sticking.sticking_setting.__wrapped__(SPEC, None, TIPS), asked


def test_every_indenter_has_the_cells_of_the_tip_about_its_own_place(monkeypatch):
    setting, ((faces, groups),) = made(monkeypatch)
    cut = tip_cells(SPEC.indenter)
    count = len(cut.height_mm)
    assert list(faces) == [3, 5]
    assert_allclose(groups[0].centre_mm, cut.patches.centre_mm + np.array([10, -6]))
    assert_allclose(groups[1].centre_mm, cut.patches.centre_mm + np.array([-8, 2]))
    for part in (slice(0, count), slice(count, 2 * count)):
        assert_array_equal(setting.cells.height_mm[part], cut.height_mm)
        assert_array_equal(setting.cells.patches.centre_mm[part], cut.patches.centre_mm)
        assert_array_equal(setting.cells.patches.area_mm2[part], cut.patches.area_mm2)
        assert_array_equal(setting.cells.patches.variance_mm2[part], cut.patches.variance_mm2)
    assert setting.indenter.tolist() == [0] * count + [1] * count
    assert setting.tips == TIPS


def small(compliance=None):
    """Five cells of two indenters, of different areas."""
    area = np.array([1.0, 2.0, 0.5, 3.0, 1.5])
    patches = SimpleNamespace(area_mm2=area, centre_mm=np.zeros((5, 2)))
    rng = np.random.default_rng(1)
    root = rng.normal(size=(15, 15))
    compliance = root @ root.T if compliance is None else compliance
    response = TractionResponse(compliance.reshape(3, 5, 3, 5), rng.normal(size=(12, 3, 5)))
    return SimpleNamespace(
        spec=SPEC, tips=TIPS, cells=SimpleNamespace(patches=patches),
        indenter=np.array([0, 0, 1, 1, 1]), response=response,
    )  # fmt: skip


def state(traction, touching, **more):
    nothing = np.zeros((2, 5))
    given = {"height_mm": np.zeros(5), "anchor_mm": nothing, "path_mm": nothing} | more
    return StickingState(traction, np.array(touching), **given)


def test_forces_and_areas_are_sums_over_the_cells_of_an_indenter():
    setting, traction = small(), np.random.default_rng(2).normal(size=(3, 5))
    found = sticking.joint_press_of.__wrapped__(
        setting, state(traction, [True, False, True, True, False]), np.array([1.0, 2.0])
    )
    area = setting.cells.patches.area_mm2
    for tip, cells in enumerate(([0, 1], [2, 3, 4])):
        assert_allclose(found.force_n[tip], traction[0, cells] @ area[cells])
        assert_allclose(found.shear_n[tip, 0], traction[1, cells] @ area[cells])
        assert_allclose(found.shear_n[tip, 1], traction[2, cells] @ area[cells])
    assert_allclose(found.contact_area_mm2, [1.0, 3.5])
    motion = np.einsum("mic,ic->m", setting.response.motion, traction)
    assert_allclose(found.motion, motion.reshape(2, 6))
    assert_array_equal(found.depth_mm, [1.0, 2.0])


def test_tractions_move_touching_cells_as_wanted_and_others_bear_none():
    setting, wanted = small(), np.random.default_rng(3).normal(size=(3, 5))
    touching = np.array([True, False, True, True, False])
    traction = sticking.tractions_of.__wrapped__(setting, wanted, touching)
    assert not traction[:, ~touching].any()
    moved = sticking.displacement_mm.__wrapped__(setting, state(traction, touching))
    assert_allclose(moved[:, touching], wanted[:, touching])
    none = sticking.tractions_of.__wrapped__(setting, wanted, np.zeros(5, bool))
    assert not none.any()


def test_touching_cells_keep_their_place_on_the_indenter_and_lift_off_where_they_are_pulled(
    monkeypatch,
):
    """Cells that do not move each other: 1 mm³/MPa each, 2 mm³/MPa along the surface."""
    setting = small(np.diag(np.repeat([1.0, 2.0, 2.0], 5)))
    setting.spec = SPEC.changed(indenter=SPEC.indenter.changed(direction_deg=(30.0, 0.0)))
    heights = np.array([0.1, 0.9, 2.5, 1.0, 1.3])
    slid = []

    def heights_mm(given, slip_mm):
        slid.append(slip_mm)
        return heights

    monkeypatch.setattr(sticking, "heights_mm", heights_mm)
    for name in ("displacement_mm", "tractions_of"):
        monkeypatch.setattr(sticking, name, getattr(sticking, name).__wrapped__)
    traction = np.zeros((3, 5))
    traction[1, 3] = 0.75  # moves cell 3 by 2 · 0.75 / 3 mm along x
    before = state(
        traction,
        [True, False, False, True, False],
        height_mm=np.array([0.2, 0, 0, 2.25, 0]),
        anchor_mm=np.array([[0.3, 0, 0, 0.4, 0], [0.0, 0, 0, -0.1, 0]]),
        path_mm=np.array([[0.1] * 5, [0.0] * 5]),
    )
    found = sticking.next_state.__wrapped__(setting, before, np.array([1.0, 2.0]))
    aside = np.tan(np.deg2rad(30)) * np.array([1.0, 1, 2, 2, 2])
    (slip,) = slid
    assert_allclose(slip, [aside - [0, 0, 0, 0.5, 0], np.zeros(5)], atol=1e-12)
    assert_allclose(found.path_mm, [aside, np.zeros(5)], atol=1e-12)
    # 0 stays; 1 comes in with 0.1 mm; 2 stays beside; 3 is lifted by 0.25 mm; 4 comes in with 0.7 mm
    assert found.touching.tolist() == [True, True, False, False, True]
    area = setting.cells.patches.area_mm2
    assert_allclose(found.traction_mpa[0], np.array([0.8, 0.1, 0, 0, 0.7]) * area)
    sideways = np.array([0.3 + aside[0], aside[1] - 0.1, 0, 0, aside[4] - 0.1])
    assert_allclose(found.traction_mpa[1], sideways * area / 2, atol=1e-12)
    assert_allclose(found.height_mm, [0.2, 0.9, 2.5, 2.25, 1.3])
    assert_allclose(found.anchor_mm[0], [0.3, -0.1, -0.1, 0.4, -0.1], atol=1e-12)


def test_cells_that_were_slid_over_lie_under_another_part_of_the_tip():
    """Heights change as the tip's own surface, over the mean of a cell; beside the tip there is none."""
    spec = SPEC.changed(indenter=SPEC.indenter.changed(tip_count=2))
    cells, shape = tip_cells(spec.indenter), tip_shape(spec.indenter)
    setting = SimpleNamespace(spec=spec, cells=cells, shape=shape)
    slip = np.array([0.3, -0.2])[:, None] * np.ones((2, len(cells.height_mm)))
    found = sticking.heights_mm.__wrapped__(setting, slip)
    local = cells.patches.centre_mm - tip_places_mm(spec.indenter)[cells.tip]
    radius = spec.indenter.radius_mm
    inside = np.linalg.norm(local - [0.3, -0.2], axis=1) < radius - 1
    assert inside.sum() > 20

    def ball(xy):
        return radius - np.sqrt(radius**2 - np.sum(xy**2, axis=1))

    wanted = cells.height_mm[inside] + ball(local[inside] - [0.3, -0.2]) - ball(local[inside])
    assert_allclose(found[inside], wanted, atol=1e-9)
    assert_allclose(tip_heights_mm(shape, local[inside]), ball(local[inside]), atol=1e-9)
    far = sticking.heights_mm.__wrapped__(setting, slip + 50)
    assert np.isposinf(far).all()


@pytest.mark.parametrize("seed", range(6))
def test_cells_in_contact_press_and_others_lie_below_the_indenter(monkeypatch, seed):
    """Cells that move each other: those that are pushed up beside come in, those that are pulled go."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(15, 15))
    setting = small(root @ root.T + 10 * np.eye(15))
    heights = rng.uniform(0, 3, 5)
    monkeypatch.setattr(sticking, "heights_mm", lambda given, slip_mm: heights)
    for name in ("displacement_mm", "tractions_of"):
        monkeypatch.setattr(sticking, name, getattr(sticking, name).__wrapped__)
    nothing = state(np.zeros((3, 5)), [False] * 5)
    depth = np.array([1.0, 2.0])
    found = sticking.next_state.__wrapped__(setting, nothing, depth)
    reach = depth[setting.indenter] - heights
    moved = sticking.displacement_mm(setting, found)
    there = found.touching
    assert there.any()
    assert (found.traction_mpa[0, there] > 0).all()
    assert not found.traction_mpa[:, ~there].any()
    assert_allclose(moved[0, there], reach[there])
    assert_allclose(moved[1:, there], 0, atol=1e-12)
    assert (moved[0, ~there] >= reach[~there] - 1e-8).all()
