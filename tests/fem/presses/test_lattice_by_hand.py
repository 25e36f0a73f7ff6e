"""Presses of whole lattices with contact made up: what goes where, and what lies between depths."""

from types import SimpleNamespace

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import press_lattice
from design.spec.object import ObjectSpec
from fem.candidates import presses as candidates
from fem.large_strain import press as large
from fem.large_strain import single_press as single
from fem.large_strain.newton import StepDivergedError
from fem.large_strain.results import LargeStrainPress
from fem.presses.joint import sum_over_spreads

PLAIN = ObjectSpec(name="lattice")
SPEC = PLAIN.changed(press=PLAIN.press.changed(depths_mm=(0.5, 1.0, 2.0)))
FACES = len(face_frames(SPEC))
VERTICES, MAGNETS = 3, 2
LOADS = FACES * VERTICES + 6 * MAGNETS


def response():
    """Loads of all faces' vertices, then of the magnets' motions."""
    return SimpleNamespace(
        surfaces=tuple(SimpleNamespace(number=frame.number) for frame in face_frames(SPEC)),
        compliance=np.random.default_rng(0).normal(size=(LOADS, LOADS)),
        magnet_loads=slice(FACES * VERTICES, LOADS),
        face_loads=lambda index: slice(VERTICES * index, VERTICES * (index + 1)),
        core=None,
    )


def test_between_simulated_depths_pressures_depths_and_forces_are_linear(monkeypatch):
    """Forces 0, 1, 3 and 7 N at depths 0, 0.5, 1 and 2 mm, of the first place; twice that of others."""
    share = np.array([1.0, 3.0, 7.0])
    grid = press_lattice(SPEC)

    def press_places(spec, given, index, xy_mm, depths_mm):
        assert_array_equal(depths_mm, [0.5, 1, 2])
        size = np.where(np.arange(len(xy_mm)) == 0, 1.0, 2.0)
        return size[:, None, None] * share[:, None] * np.array([0.5, 0.25, 0.0])

    monkeypatch.setattr(candidates, "press_places", press_places)
    monkeypatch.setattr(
        candidates, "surface_weights_mm2", lambda surface: np.array([1.0, 2.0, 4.0])
    )
    spec = SPEC.changed(search=SPEC.search.changed(forces_n=(2.0, 5.0, 10.0)))
    found = candidates.presses_at_forces.__wrapped__(spec, response(), 0, (0.5, 1.0))
    assert found.force_n.shape == (len(grid), 6)
    assert_allclose(found.force_n[0], [1, 2, 2.5, 5, 3.5, 7])
    assert_allclose(found.depth_mm[0], [0.5, 0.75, 0.875, 1.5, 1.125, 2])
    assert_allclose(found.force_n[1], [1, 2, 2.5, 5, 5, 10])
    assert_allclose(found.depth_mm[1], [0.25, 0.5, 0.5625, 0.875, 0.875, 1.5])
    assert_allclose(found.pressure_mpa, found.force_n[..., None] * np.array([0.5, 0.25, 0.0]))


def test_cells_act_through_the_columns_of_their_face_s_vertices():
    given = response()
    rng = np.random.default_rng(2)
    spreads = [
        SimpleNamespace(
            patches=SimpleNamespace(area_mm2=np.ones(cells)),
            face=SimpleNamespace(index=index),
            rows=np.array(rows),
            matrix=rng.random((len(rows), cells)),
        )
        for cells, index, rows in ((2, 1, [0, 2]), (3, 0, [1]))
    ]
    pressure, per_load = rng.random(5), rng.random((4, LOADS))
    vertex = np.zeros(LOADS)
    vertex[[3, 5]] = spreads[0].matrix @ pressure[:2]
    vertex[[1]] += spreads[1].matrix @ pressure[2:]
    assert_allclose(
        sum_over_spreads.__wrapped__(given, per_load, spreads, pressure), per_load @ vertex
    )


def settle(monkeypatch, breaks, depths):
    """Depths that were tried, and those that were given; `breaks` tells which tries diverge."""
    tried = []

    def equilibrium(problem, state, centre):
        tried.append(round(float(centre), 4))
        if breaks(float(centre), state):
            raise StepDivergedError("it diverges")
        return float(centre)

    monkeypatch.setattr(large, "undeformed", lambda problem: 0.0)
    monkeypatch.setattr(large, "equilibrium", equilibrium)
    monkeypatch.setattr(large, "sphere_centre_mm", lambda setting, depth: depth)
    setting, told = SimpleNamespace(problem=None), []
    states = large.converged_states.__wrapped__(setting, depths, told.append)
    return tried, [depth for depth, _ in states], told


def test_load_steps_are_halved_where_they_diverge_and_grow_again(monkeypatch):
    longest = large.LARGEST_STEP_MM
    tried, given, told = settle(monkeypatch, lambda at, state: False, (longest / 2, 2 * longest))
    assert_allclose(tried, np.array([0.5, 1.5, 2.0]) * longest, atol=1e-4)
    assert_allclose(given, [longest / 2, 2 * longest])
    assert told[-1] == f"{2 * longest:.3g} of {2 * longest:.3g} mm"
    tried, given, told = settle(
        monkeypatch, lambda at, state: at - state > 0.3 * longest, (longest,)
    )
    assert_allclose(np.array(tried)[:6] / longest, [1, 0.5, 0.25, 0.75, 0.5, 1.0], atol=1e-3)
    assert given == [longest]
    assert told[0] == f"{longest:.3g} mm: it diverges; the load step is halved"


def test_a_press_ends_at_its_last_equilibrium_which_is_told_once(monkeypatch):
    longest = large.LARGEST_STEP_MM
    _, given, _ = settle(monkeypatch, lambda at, state: at > longest, (longest, 2 * longest))
    assert given == [longest]
    tried, given, _ = settle(
        monkeypatch, lambda at, state: at > 1.5 * longest, (longest, 3 * longest)
    )
    assert given[0] == longest
    assert 1.4 * longest < given[-1] <= 1.5 * longest
    smallest = min(abs(np.diff(sorted(set(tried)))))
    assert large.SMALLEST_STEP_MM <= smallest + 1e-9 < 2 * large.SMALLEST_STEP_MM


def test_the_converged_depth_is_the_last_one():
    press = object.__new__(LargeStrainPress)
    press.__dict__["depth_mm"] = np.array([0.5, 1.0, 1.75])
    assert press.converged_depth_mm == 1.75


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"x_mm": 100.0}, "hangs over"), ({"y_mm": -100.0}, "hangs over"),
        ({"face": 9}, "not sensed"), ({"depths_mm": ()}, "increase"),
        ({"depths_mm": (0.0, 1.0)}, "increase"), ({"depths_mm": (1.0, 1.0)}, "increase"),
        ({"depths_mm": (1.0, 0.5)}, "increase"),
    ],
)  # fmt: skip
def test_presses_that_cannot_be_are_refused(change, words):
    given = {"face": 3, "x_mm": 0.0, "y_mm": 0.0, "depths_mm": (0.5, 1.0)}
    large.require_press(SPEC, **given)
    with pytest.raises(InputError, match=words):
        large.require_press(SPEC, **{**given, **change})


def test_a_tip_may_stand_flush_with_the_border_and_press_almost_its_radius_deep():
    frame = next(frame for frame in face_frames(SPEC) if frame.number == 3)
    radius, (x, y) = SPEC.indenter.radius_mm, frame.half_extents_mm
    deepest = min(radius, SPEC.shell.thickness_mm)
    for side in (1, -1):
        large.require_press(SPEC, 3, side * (x - radius), side * (y - radius), (deepest - 1e-6,))
        for at in ((side * (x - radius + 1e-6), 0.0), (0.0, side * (y - radius + 1e-6))):
            with pytest.raises(InputError, match="hangs over"):
                large.require_press(SPEC, 3, *at, (1.0,))
    with pytest.raises(InputError, match=f"{deepest:g} mm"):
        large.require_press(SPEC, 3, 0.0, 0.0, (deepest,))


def test_small_strain_on_the_press_s_own_mesh_is_the_contact_of_its_compliance(monkeypatch):
    """Twelve motions (the last six a magnet's), two pressures of the element, three cells near the tip:
    compliance by a dense solve, pressures that are none or press, motions by the columns of the loads."""
    rng = np.random.default_rng(3)
    root = rng.normal(size=(14, 14))
    matrix = root @ root.T + 14 * np.eye(14)
    basis = np.linalg.qr(rng.normal(size=(15, 12)))[0]
    moments, near = rng.random((5, 4)), np.array([0, 2, 3])
    normal, weights = np.array([0.0, 0.6, 0.8]), np.array([1.0, 9.0, 2.0, 3.0])
    system = SimpleNamespace(
        matrix=sp.csr_matrix(matrix), motion_basis=sp.csr_matrix(basis), space=None
    )
    setting = SimpleNamespace(
        system=system, near=near, moments=sp.csc_matrix(moments), surface=None,
        mesh=SimpleNamespace(magnets=1),
        frame=SimpleNamespace(normal=normal), spec=PLAIN, xy_mm=np.zeros(2),
    )  # fmt: skip
    monkeypatch.setattr(single, "surface_weights_mm2", lambda surface: weights)
    monkeypatch.setattr(
        single, "profile_moments_mm3", lambda *given: np.array([[0.0, 7.0, 0.6, 3.0]])
    )
    depths = np.array([0.2, 0.6])
    found = single.linear_press.__wrapped__(setting, depths)
    loads = np.vstack(
        [basis.T @ np.concatenate([-part * moments[:, near] for part in normal]), np.zeros((2, 3))]
    )
    solution = np.linalg.solve(matrix, loads)
    compliance = loads.T @ solution
    moved = solution[6:12]
    for depth, row in zip(depths, found.rows, strict=True):
        gap = np.array([0.0, 0.6, 3.0]) - depth * weights[near]
        best = [
            (np.linalg.solve(compliance[np.ix_(on, on)], -gap[on]), on)
            for on in ([0], [1], [2], [0, 1], [0, 2], [1, 2], [0, 1, 2])
        ]
        (pressure,) = [
            full
            for some, on in best
            for full in [np.bincount(on, some, minlength=3)]
            if (some > 0).all() and (compliance @ full + gap > -1e-9).all()
        ]
        assert row.depth_mm == depth
        assert_allclose(row.force_n, pressure @ weights[near])
        assert_allclose(row.contact_area_mm2, weights[near][pressure > 0].sum())
        assert_allclose(row.motion.ravel(), moved @ pressure)
    assert_allclose(found.contact_mpa, pressure)
    assert_allclose(found.unknowns, solution @ pressure)


@pytest.mark.parametrize(
    ("off", "sound"), [(0.0099, True), (-0.0099, True), (0.0101, False), (-0.0101, False)]
)
def test_a_material_has_the_specification_s_modulus_to_a_hundredth(off, sound):
    silicone = PLAIN.silicone
    shear_mpa = silicone.youngs_modulus_mpa / 2 / (1 + silicone.poisson_ratio)
    material = SimpleNamespace(shear_modulus_mpa=(1 + off) * shear_mpa, name="made")
    check = single.require_modulus.__wrapped__
    if sound:
        return check(PLAIN, material)
    wanted = (1 + off) * silicone.youngs_modulus_mpa
    with pytest.raises(InputError, match=f"Set it to {wanted:.4g}"):
        check(PLAIN, material)
    stiff = single.with_modulus_of.__wrapped__(PLAIN, material)
    assert_allclose(stiff.silicone.youngs_modulus_mpa, wanted)
