"""Figures of one design at a time against the search's own scores and against Fisher's bounds."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.pockets import magnet_bodies
from estimator.information.fisher import DETECTION_DISTANCE, disturbance_counts
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import batch_scores
from estimator.layouts.presses.layer import layer_of
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.without_mesh import first_score
from estimator.signals.hall import full_scale_counts
from estimator.signals.nuisances import nuisance_columns
from instobj.explore.design import design_of, with_design
from instobj.explore.engine import open_coarse_explorer, skin_profile_mm, summary_of
from tests.support.made_explorer import FORCES_N, made_explorer


def moved(**magnets):
    """The made-up cube with other magnets."""
    spec = made_explorer().spec
    design = design_of(spec)
    return with_design(spec, design | {"magnets": design["magnets"] | magnets})


def counts_of(pressed):
    """Change in counts of every channel, press by press."""
    return np.stack([pressed.counts([k]).ravel() for k in range(len(pressed.changes))])


DESIGNS = {
    "as it is": {},
    "moved and turned over": {
        "positions_mm": [[1.0, 2.0], [11.0, 9.0], [-8.0, 12.0], [-10.0, -9.0], [9.0, -11.0]],
        "north": ["outward", "inward", "outward", "inward", "outward"],
        "depth_mm": [2.5, 3.0, 3.5, 4.0, 2.6],
    },
    "one less": {
        "positions_mm": [[0.0, 0.0], [10.0, 10.0], [-10.0, 10.0], [-10.0, -10.0]],
        "north": ["outward"] * 4,
        "tilt_deg": [[0.0, 0.0], [5.0, 0.0], [0.0, 0.0], [0.0, -9.0]],
    },
}


@pytest.mark.parametrize("magnets", DESIGNS.values(), ids=DESIGNS)
@pytest.mark.parametrize("force_n", FORCES_N)
def test_figures_are_the_searchs_scores_of_the_same_design(magnets, force_n):
    explorer, design = made_explorer(), moved(**magnets)
    index = FORCES_N.index(force_n)
    scorers = [layout_scorer(design, one[0][index]) for one in explorer.presses.values()]
    layouts = [layouts_of(design, face) for face in explorer.presses]
    with torch.no_grad():
        scores = batch_scores(scorers, layouts, ())
    found = explorer.judge(design, force_n)
    place, force = summary_of(found.position_bound_mm), summary_of(found.force_bound_n)
    assert_allclose(place.worst, float(scores["worst_position_bound_mm"]), rtol=1e-5)
    assert_allclose(
        place.percentile_95, float(scores["percentile_95_position_bound_mm"]), rtol=1e-5
    )
    assert_allclose(place.median, float(scores["median_position_bound_mm"]), rtol=1e-5)
    assert_allclose(force.worst, float(scores["worst_force_bound_n"]), rtol=1e-5)
    assert found.position_bound_mm[place.face, place.place] == place.worst
    assert not found.beyond


def test_a_press_tells_the_ellipse_whose_size_the_map_shows():
    """By another way: singular values in double precision instead of elimination in single."""
    explorer, design = made_explorer(), moved(**DESIGNS["moved and turned over"])
    mapped = explorer.judge(design, 5.0).position_bound_mm
    for row, face in enumerate(explorer.presses):
        pressed = explorer.press(design, face, 5.0)
        told = [pressed.position_mm2([place])[0] for place in range(len(pressed.changes))]
        size = np.sqrt(np.trace(told, axis1=1, axis2=2))
        assert_allclose(size, mapped[row], rtol=2e-3)


def test_the_least_force_is_where_the_counts_stand_five_sigma_off_rest():
    explorer = made_explorer()
    # Chips so noisy that half of the places are felt at 5 N, others between two forces or never.
    white = explorer.press(explorer.spec, 3, 5.0)
    counts = np.linalg.norm(counts_of(white), axis=1)
    noise = float(np.median(counts)) / DETECTION_DISTANCE
    noisy = explorer.spec.sensors.changed(noise_counts=(noise,) * 3, zeroing_counts=0.0)
    design = explorer.spec.changed(sensors=noisy)
    least = explorer.least_forces_n(design)
    face, row = 3, list(explorer.presses).index(3)
    presses = [explorer.press(design, face, force) for force in FORCES_N]
    distance = [np.linalg.norm(one.changes[:, :, 3], axis=1) for one in presses]
    for place, found in enumerate(least[row]):
        expected = np.interp(
            DETECTION_DISTANCE, [0.0, *(d[place] for d in distance)], [0.0, *FORCES_N], right=np.inf
        )
        assert_allclose(found, expected, rtol=1e-4)
    assert np.isinf(least[row]).any()
    assert ((least[row] > FORCES_N[0]) & (least[row] < FORCES_N[-1])).any()


def test_a_part_beyond_what_is_known_is_told_and_judged_at_the_nearest_place():
    explorer = made_explorer()
    places = [list(place) for place in explorer.spec.magnets.lists[0]]
    far, edge = (
        moved(positions_mm=[[x, 0.0], *places[1:]], depth_mm=[3.0] * 5) for x in (20.9, 1000.0)
    )
    first, second = (explorer.judge(design, 5.0) for design in (far, edge))
    assert first.beyond
    assert_allclose(first.position_bound_mm, second.position_bound_mm)


def test_the_range_in_use_is_the_searchs_largest_counts_over_full_scale():
    """At the largest force, whose presses are the deepest."""
    explorer, design = made_explorer(), moved(**DESIGNS["moved and turned over"])
    scorers = [layout_scorer(design, of_face[0][-1]) for of_face in explorer.presses.values()]
    with torch.no_grad():
        scores = batch_scores(scorers, [layouts_of(design, f) for f in explorer.presses], ())
    largest = explorer.range_used(design) * full_scale_counts(design.sensors)
    assert_allclose(largest, float(scores["largest_counts"]), rtol=1e-7)


def test_two_presses_at_once_add_up_and_blur_each_other():
    """Another way: Schur's complement of the second press in the information of both."""
    explorer, places = made_explorer(), [7, 12]
    pressed = explorer.press(explorer.spec, 3, 5.0)
    one, other = (pressed.changes[place, :, :3] for place in places)
    seen = one.T @ one - one.T @ other @ np.linalg.solve(other.T @ other, other.T @ one)
    both = pressed.position_mm2(places)
    assert_allclose(both[0], np.linalg.inv(seen)[:2, :2], rtol=1e-6)
    assert_allclose(both, pressed.position_mm2(places[::-1])[::-1], rtol=1e-6)
    alone = pressed.position_mm2([7])[0]
    assert np.trace(both[0]) > 1.05 * np.trace(alone)
    assert_allclose(pressed.counts(places), pressed.counts([7]) + pressed.counts([12]))


def test_the_first_look_has_the_bounds_of_new_and_few_places():
    spec = made_explorer().spec
    explorer = open_coarse_explorer(spec)
    force = spec.score.force_n
    summary = summary_of(explorer.judge(spec, force).position_bound_mm)
    expected = first_score(spec)
    assert summary.median == pytest.approx(expected.median_mm, rel=1e-4)
    assert summary.percentile_95 == pytest.approx(expected.percentile_95_mm, rel=1e-4)


def test_magnets_move_in_a_press_as_disks_in_the_layer():
    """Displacements and rotations of every magnet of the face under each press, in the face's frame."""
    spec = made_explorer().spec
    explorer = open_coarse_explorer(spec)
    force = spec.score.force_n
    motions = explorer.press(spec, 3, force).motions
    bodies = magnet_bodies(spec)[list(explorer.presses).index(3)]
    for number, body in enumerate(bodies):
        away = body.centre_mm[:2] - explorer.grid.xy_mm
        moved = layer_of(spec).motions(away, -body.centre_mm[2:], force)[:, 0, 3]
        largest = np.abs(moved[:, :3]).max()
        # rows between candidates and a basis of few vectors: a twentieth of the largest
        assert_allclose(motions[:, number, :3], moved[:, :3], atol=0.05 * largest)
        assert_allclose(motions[:, number, 3:], moved[:, 3:], atol=0.05 * np.abs(moved).max())


def test_the_skin_is_pressed_as_deep_as_the_layer_says_and_keeps_its_volume():
    spec = made_explorer().spec
    away, inward, _ = skin_profile_mm(spec, 5.0).T
    assert inward[0] == pytest.approx(layer_of(spec).contact(5.0)[1], rel=0.02)
    # An incompressible layer: what goes in round the press comes out farther away.
    volume = np.trapezoid(inward * away, away) / np.trapezoid(abs(inward) * away, away)
    assert abs(volume) < 0.1
    assert inward.min() < 0


def test_forces_and_faces_that_are_not_at_hand_are_refused():
    explorer = made_explorer()
    with pytest.raises(InputError, match=r"no presses to 3 N .*2, 5, 8 N"):
        explorer.judge(explorer.spec, 3.0)
    with pytest.raises(InputError, match=r"face 6 is not sensed. Press one of \[1, 2"):
        explorer.press(explorer.spec, 6, 5.0)


@pytest.mark.parametrize("channels", ["all", "own"])
def test_disturbances_are_unknowns_that_all_chips_read(channels):
    """Another way: nuisances as parameters, with their prior and all chips that are read as observations."""
    explorer, still = made_explorer(), moved(**DESIGNS["moved and turned over"])
    still = still.changed(score=still.score.changed(channels=channels))
    design = still.changed(limits=still.limits.changed(use="grasp"))
    columns = nuisance_columns(design)
    white = columns / disturbance_counts(design.sensors, "fresh", len(columns))[:, None]
    position = explorer.judge(design, 5.0).position_bound_mm
    force = explorer.judge(design, 5.0).force_bound_n
    count = 3 * design.sensors.count_per_face
    for row, face in enumerate(explorer.presses):
        rows_of_face = np.arange(row * count, (row + 1) * count)
        seen = np.arange(len(white)) if channels == "all" else rows_of_face
        slopes = explorer.press(design, face, 5.0).changes[:, :, :3]
        for place, slope in enumerate(slopes):
            rows = np.zeros((len(white), 3))
            rows[rows_of_face] = slope
            model = np.hstack([rows, white])[seen]
            information = model.T @ model + np.diag([0.0] * 3 + [1.0] * white.shape[1])
            variance = np.diag(np.linalg.inv(information))
            assert_allclose(position[row, place], np.sqrt(variance[:2].sum()), rtol=2e-3)
            assert_allclose(force[row, place], np.sqrt(variance[2]), rtol=2e-3)
    ellipse = explorer.press(design, 3, 5.0).position_mm2([7])[0]
    row = list(explorer.presses).index(3)
    assert_allclose(np.sqrt(np.trace(ellipse)), position[row, 7], rtol=2e-3)
    assert (position > explorer.judge(still, 5.0).position_bound_mm).all()
    least = [explorer.least_forces_n(one) for one in (still, design)]
    assert (least[1] >= least[0]).all()
    assert (least[1] > least[0]).any()


def test_a_summary_leaves_out_places_that_a_face_has_not():
    values = np.array([[1.0, np.nan, 3.0], [2.0, np.inf, 4.0]])
    found = summary_of(values)
    assert (found.face, found.place, found.worst) == (1, 1, np.inf)
    assert found.median == 3.0
