"""Presses on a loose core: limits of no and of endless friction, the cone, where the work goes."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

import studies.loose_core.coulomb
from design.errors import InputError
from fem.linear.response import build_response
from fem.presses.joint import Tip, press_tips
from studies.loose_core.coulomb import site_axes
from studies.loose_core.press import LooseCore, _Path, at_rest, press_loose
from studies.loose_core.response import loose_shell
from tests.support.objects.small_object import small_spec

TIPS, DEPTHS_MM = [Tip(3, 4.0, -2.0), Tip(1, -5.0, 3.0)], np.array([1.5, 1.0])
STEPS = DEPTHS_MM * np.arange(1, 5)[:, None] / 4
FRICTION = 0.4


@pytest.fixture(scope="module")
def spec():
    return small_spec()


@pytest.fixture(scope="module")
def shell(small_mesh, spec):
    return loose_shell(small_mesh, spec)


@pytest.fixture(scope="module")
def path(spec, shell):
    return press_loose(spec, shell, LooseCore(FRICTION), TIPS, STEPS)


@pytest.fixture(scope="module")
def bonded(spec, shell):
    return press_tips(spec, shell.bonded, TIPS, DEPTHS_MM)


def test_without_displaced_walls_it_is_the_bonded_shell(small_mesh, spec, shell):
    plain = build_response(small_mesh, spec)
    scale = abs(plain.compliance).max()
    assert_allclose(shell.bonded.compliance, plain.compliance, rtol=0, atol=1e-10 * scale)


def test_the_walls_answer_like_a_free_body(shell):
    """Rigid motions of the inner walls move the whole shell and cost nothing; nothing else is free."""
    points = shell.walls.points_mm
    turns = [np.cross(axis, points).ravel() for axis in np.eye(3)]
    rigid = np.array([*(np.tile(axis, len(points)) for axis in np.eye(3)), *turns]).T
    rigid /= np.linalg.norm(rigid, axis=0)
    values = np.linalg.eigvalsh(shell.stiffness)
    assert abs(shell.stiffness @ rigid).max() < 1e-9 * values[-1]
    assert values[6] > 1e-3 * values[-1]
    # a load on the outside is borne whole by the core
    loads = shell.bonded.face_loads(2)
    area = np.zeros(len(shell.bonded.compliance))
    area[loads] = 1.0
    borne = (shell.force_per_load @ area).reshape(-1, 3).sum(axis=0)
    assert_allclose(borne, [42.0**2, 0, 0], rtol=1e-6, atol=1e-5)


def glued(trial_n, friction):
    return trial_n


def test_a_core_that_holds_every_force_is_the_bond(spec, shell, bonded, monkeypatch):
    monkeypatch.setattr(studies.loose_core.coulomb, "onto_cone", glued)
    *_, last = press_loose(spec, shell, LooseCore(0.0), TIPS, DEPTHS_MM[None])
    assert_allclose(last.joint.force_n, bonded.force_n, rtol=1e-4)
    scale = abs(bonded.motion).max(axis=0)
    assert_allclose(last.joint.motion / scale, bonded.motion / scale, rtol=0, atol=1e-3)


def test_much_friction_on_a_stretched_shell_is_nearly_the_bond(spec, shell, bonded):
    """But for a tenth of the sites, along the core's edges, which stretching has opened."""
    *_, last = press_loose(spec, shell, LooseCore(5.0, 0.4), TIPS, DEPTHS_MM[None])
    assert last.walls.slipping.mean() < 0.03
    assert (last.walls.force_n[:, 0] == 0).mean() < 0.12
    assert_allclose(last.joint.force_n, bonded.force_n, rtol=0.01)
    scale = abs(bonded.motion).max(axis=0)
    assert_allclose(last.joint.motion / scale, bonded.motion / scale, rtol=0, atol=0.04)


def test_no_friction_is_the_frictionless_core_that_only_pushes(small_mesh, spec, shell, bonded):
    """Of another solver, whose shell slides with more freedom than hats at the walls' vertices have."""
    sliding = small_spec("frictionless")
    other = press_tips(sliding, build_response(small_mesh, sliding), TIPS, DEPTHS_MM)
    *_, last = press_loose(spec, shell, LooseCore(0.0), TIPS, DEPTHS_MM[None])
    assert (abs(last.walls.force_n[:, 1:]) == 0).all()
    assert_allclose(last.joint.force_n, other.force_n, rtol=0.015)
    assert (last.joint.force_n < 0.9 * bonded.force_n).all()
    assert other.core is not None
    assert_allclose(
        (last.walls.opening_mm > 0).mean(), (other.core.opening_mm > 0).mean(), atol=0.05
    )
    assert last.walls.dissipated_mj == 0


def test_friction_lies_between_its_limits_and_in_its_cone(spec, shell, path, bonded):
    last = path[-1]
    free = press_loose(spec, shell, LooseCore(0.05), TIPS, DEPTHS_MM[None])[-1]
    assert (last.joint.force_n > 1.01 * free.joint.force_n).all()
    assert (last.joint.force_n < 0.99 * bonded.force_n).all()
    push, drag = last.walls.force_n[:, 0], np.linalg.norm(last.walls.force_n[:, 1:], axis=1)
    assert (push >= 0).all()
    assert (drag <= FRICTION * push * (1 + 1e-9)).all()
    assert_allclose(drag[last.walls.slipping], FRICTION * push[last.walls.slipping], rtol=1e-9)
    assert 0.02 < last.walls.slipping.mean() < 0.6
    assert (last.walls.opening_mm * push == 0).all()


def test_the_shell_balances(spec, shell, path):
    """Pushes and drags of the core hold the tips' forces, face 3 outward +x and face 1 +z."""
    last = path[-1]
    axes = site_axes(shell.walls.normal)
    total = np.einsum("sij,si->j", axes, last.walls.force_n)
    on_3, on_1 = last.joint.force_n
    assert_allclose(total, [on_3, 0, on_1], atol=0.01 * on_3)


def test_work_is_stored_or_lost_by_slip(spec, shell, path, bonded):
    """Pressed and half let go: ½ (pᵀ C p + uᵀ K u) and what slip has lost are the work of the tips;
    the shell pushes less on the way back."""
    lost = np.array([press.walls.dissipated_mj for press in path])
    assert (np.diff(lost) > 0).all()
    rest = at_rest(spec, shell, LooseCore(FRICTION))
    way = _Path(spec, shell, LooseCore(FRICTION), TIPS, rest)
    cells, state, pressure, work = way.cells, rest, np.zeros(len(way.cells.gap_mm)), 0.0
    shares = [*np.arange(1, 9) / 8, 7 / 8, 6 / 8, 5 / 8, 4 / 8]
    forces = {0.0: np.zeros(2)}
    for before, share in pairwise([0.0, *shares]):
        old = pressure
        pressure, state = way.body.advance(state, way.core_mm, way.gap(share * DEPTHS_MM), old)
        deeper = (share - before) * DEPTHS_MM[cells.tip]
        work += (old + pressure) / 2 @ (cells.area_mm2 * deeper)
        force = way.press(share * DEPTHS_MM, pressure, state).joint.force_n
        if before > share:
            assert (force < 0.999 * forces[share]).all()
        forces[share] = force
    u = state.displacement_mm
    stored = (pressure @ cells.compliance @ pressure + u @ shell.stiffness @ u) / 2
    assert state.dissipated_mj > 0.03 * stored
    assert_allclose(work, stored + state.dissipated_mj, rtol=0.01)


def test_what_it_cannot_do_is_said(small_mesh, spec, shell):
    with pytest.raises(InputError, match="friction coefficient"):
        LooseCore(-0.1)
    oblique = spec.changed(indenter={"direction_deg": [10, 0]})
    with pytest.raises(InputError, match="straight down"):
        press_loose(oblique, shell, LooseCore(0.3), TIPS, STEPS)
    keyed = spec.changed(core={"keys": {"positions_mm": [[9, 9]]}})
    with pytest.raises(InputError, match="plain box"):
        loose_shell(small_mesh, keyed)


def test_rest_of_a_stretched_shell_is_where_the_core_holds_it(spec, shell):
    rest = at_rest(spec, shell, LooseCore(FRICTION, 0.2))
    assert (rest.force_n[:, 0] > 0).mean() > 0.9
    assert_allclose(rest.relative_mm[rest.force_n[:, 0] > 0, 0], 0, atol=1e-4)
    same = press_loose(spec, shell, LooseCore(FRICTION, 0.2), TIPS, STEPS[:1], rest)[0]
    again = press_loose(spec, shell, LooseCore(FRICTION, 0.2), TIPS, STEPS[:1])[0]
    assert_allclose(same.joint.force_n, again.joint.force_n)
    assert replace(same.joint, core=None).force_n.min() > 0
