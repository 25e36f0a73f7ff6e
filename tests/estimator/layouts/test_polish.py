"""Lowest fidelity level of a search: pooled scores, limits, and gradient descent."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose, assert_array_equal
from scipy.stats import gmean

from design.search.space import search_space
from design.search.structure import with_structure
from design.spec.object import ScoreSpec
from design.spec.search import OVER_LIMIT, SearchSpec
from estimator.layouts import polish as polishing
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import (
    DEARER,
    batch_scores,
    position_bounds,
    scores_at_one_force,
)
from estimator.layouts.cross_face import false_forces_n
from estimator.layouts.fidelity import lowest_fidelity_score
from estimator.layouts.polish import Judged, LowestFidelity, judge, polish
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.scoring import PlaceInformation
from estimator.layouts.vectors import layout_space
from tests.support.mechanics.candidate_cases import made_up_motions, made_up_spec, random_layouts

FACES = (1, 3)
OBJECTIVES = ("worst_position_bound_mm",)
COUNT = 12


@pytest.fixture(scope="module")
def lowest():
    vary = {"magnet_reach_mm": 14.0, "magnet_depth_mm": [2.0, 5.0], "sensor_reach_mm": 10.0}
    search = SearchSpec.model_validate({"vary": vary})
    spec = made_up_spec().model_copy(update={"search": search})
    motions = made_up_motions(spec)
    scorers = tuple(layout_scorer(spec, press_basis(spec, motions, face)) for face in FACES)
    space = search_space(spec)
    tensors = layout_space(space, with_structure(spec, {}))
    return LowestFidelity(tensors, scorers, {})


@pytest.fixture(scope="module")
def units(lowest):
    return torch.as_tensor(np.random.default_rng(2).random((COUNT, len(lowest.space.low)))).float()


POLES = torch.ones(COUNT, 5)


def judged(lowest, units, objectives=OBJECTIVES):
    with torch.no_grad():
        return judge(lowest, units, POLES[: len(units)], objectives)


def polished(lowest, units, steps=8):
    weights = torch.ones(len(units), 1)

    def judge_at(point, rows):
        return judge(lowest, point, POLES[rows], OBJECTIVES)

    return polish(judge_at, units, steps, weights)


def test_every_force_counts_alike(lowest):
    """Steps of two forces by hand: geometric means of the scores at each."""
    spec, forces = lowest.space.structured, (3.0, 8.0)
    low, high = (made_up_motions(spec.changed(score=ScoreSpec(force_n=n))) for n in forces)
    low.by_candidate[..., :3] *= 0.5
    both = replace(
        low,
        force_n=np.concatenate([low.force_n, high.force_n], axis=2),
        depth_mm=np.concatenate([low.depth_mm, high.depth_mm], axis=2),
        by_candidate=np.concatenate([low.by_candidate, high.by_candidate], axis=2),
        presses=np.concatenate(
            [
                np.concatenate([low.presses, 0 * high.presses], axis=3),
                np.concatenate([0 * low.presses, high.presses], axis=3),
            ],
            axis=2,
        ),
        strain=np.concatenate([low.strain, high.strain], axis=1),
    )
    pooled = [
        layout_scorer(spec, press_basis(spec, both, face, n)) for n in forces for face in FACES
    ]
    alone = [
        [layout_scorer(spec, press_basis(spec, motions, face, n)) for face in FACES]
        for motions, n in zip((low, high), forces, strict=True)
    ]
    layouts = [random_layouts(4, seed=face) for face in FACES]
    found = batch_scores(pooled, layouts * 2, DEARER)
    each = [batch_scores(scorers, layouts, DEARER) for scorers in alone]
    for name in (
        "percentile_99_position_bound_mm",
        "worst_force_bound_n",
    ):
        a, b = (scores[name] for scores in each)
        assert abs(a / b - 1).mean() > 0.1
        assert_allclose(found[name], (a * b).sqrt(), rtol=1e-4)
    assert_allclose(found["median_false_force_n"], each[1]["median_false_force_n"], rtol=1e-4)
    bounds = torch.cat(position_bounds(pooled, layouts * 2), dim=1)
    limit, edge = spec.limits.position_bound_mm, max(spec.body.size_mm)
    assert 0.05 < (bounds > limit).float().mean() < 0.95, "some count, some do not"
    wanted = gmean(bounds.clamp(limit, edge) / limit, axis=1)
    assert_allclose(found[OVER_LIMIT], wanted, rtol=1e-5)


def test_a_face_that_stands_for_others_counts_as_often(lowest):
    layouts = [random_layouts(3, seed=face) for face in FACES]
    four = [
        replace(scorer, faces=count) for scorer, count in zip(lowest.scorers, (1, 4), strict=True)
    ]
    top, side = position_bounds(lowest.scorers, layouts)
    found = batch_scores(four, layouts, DEARER)
    every = np.concatenate([top, *(4 * [side])], axis=1)
    for name, percent in (("median", 50), ("percentile_95", 95)):
        wanted = np.percentile(every, percent, axis=1)
        assert_allclose(found[f"{name}_position_bound_mm"], wanted, rtol=1e-5)
    forces = [false_forces_n(*pair) for pair in zip(lowest.scorers, layouts, strict=True)]
    every = np.concatenate([one.flatten(1) for one in (forces[0], *(4 * [forces[1]]))], axis=1)
    assert_allclose(found["median_false_force_n"], np.median(every, axis=1), rtol=1e-5)
    wanted = np.percentile(every, 95, axis=1)
    assert_allclose(found["percentile_95_false_force_n"], wanted, rtol=1e-4)


def test_scores_beyond_their_limits_break_them_by_ten_millimetres_for_each_times(lowest, units):
    free = judged(lowest, units)
    limited = judged(replace(lowest, at_most={OBJECTIVES[0]: 1.0, OVER_LIMIT: 1.0}), units)
    over = sum(torch.relu(limited.scores[name] - 1) for name in (OBJECTIVES[0], OVER_LIMIT))
    assert (over > 0).all()
    assert_allclose(limited.broken_mm - free.broken_mm, 10 * over, rtol=1e-4)


def test_dear_scores_are_worked_out_only_where_they_are_named(lowest):
    layouts = [layouts_of(lowest.space.structured, face) for face in FACES]
    found = batch_scores(lowest.scorers, layouts, ["median_false_force_n"])
    assert {*DEARER} & {*found} == {"median_false_force_n"}


def test_the_score_of_a_level_has_every_score_of_a_batch(lowest):
    spec = lowest.space.structured
    layouts = [layouts_of(spec, face) for face in FACES]
    found = batch_scores(lowest.scorers, layouts, DEARER)
    wanted = lowest_fidelity_score(spec, lowest.scorers)
    for name in (*OBJECTIVES, *DEARER):
        assert_allclose(float(found[name][0]), getattr(wanted, name), rtol=1e-5)


def test_polish_improves_every_layout_and_fixes_what_is_broken(lowest, units):
    units = units[:2]
    before, after = judged(lowest, units), judged(lowest, polished(lowest, units))
    assert (after.penalized <= before.penalized * 1.0001).all()
    assert float((after.penalized / before.penalized).log().mean()) < -1
    assert int((after.broken_mm == 0).sum()) > int((before.broken_mm == 0).sum())


def test_generations_are_drawn_as_the_package_draws_them():
    """Means, spreads and the share moved to the bounds, of points far out and oblique."""
    search = polishing.Generations(
        np.array([0.9, 0.2]),
        0.3,
        bounds=np.array([[0.0, 1.0]] * 2),
        cov=np.array([[1.0, 0.6], [0.6, 0.5]]),
        seed=1,
        population_size=4000,
        n_max_resampling=1,
    )
    drawn = search.ask_all(), np.array([search.ask() for _ in range(4000)])
    assert all(((points >= 0) & (points <= 1)).all() for points in drawn)
    moved = [np.isin(points, (0.0, 1.0)).any(axis=1).mean() for points in drawn]
    assert 0.2 < moved[1] < 0.6
    assert abs(moved[0] - moved[1]) < 0.05
    assert_allclose(drawn[0].mean(axis=0), drawn[1].mean(axis=0), atol=0.02)
    assert_allclose(np.cov(drawn[0].T), np.cov(drawn[1].T), atol=0.004)


def test_a_run_is_broad_for_half_of_its_layouts_the_broader_the_longer():
    assert polishing.populations(31, 600) == [12 * 14] * 200 + [4 * 14] * 600
    assert polishing.populations(31, 300) == [6 * 14] * 200 + [4 * 14] * 300
    assert polishing.populations(31, 30) == [14] * 240
    for generations in (1, 4, 75, 100, 299, 300):
        sizes = polishing.populations(31, generations)
        more = sum(sizes) - generations * polishing.population(31)
        assert -sizes[-1] < more < sizes[0]
        assert sizes[-1] == 14 or len(sizes) >= 400
    assert polishing.populations(31, 0) == []


def test_narrower_generations_come_from_the_same_distribution():
    search = polishing.Generations(
        np.full(2, 0.5), 0.05, bounds=np.array([[0.0, 1.0]] * 2), seed=3, population_size=40
    )
    for _ in range(20):
        points = search.ask_all()
        search.tell([(at, float((at[0] - 0.6) ** 2 + 9 * (at.sum() - 1) ** 2)) for at in points])
    narrow = search.resize(4000)
    assert search.resize(40) is search
    spread = narrow.ask_all(), np.concatenate([search.ask_all() for _ in range(100)])
    means = [points.mean(axis=0) for points in spread]
    covariances = [np.cov(points.T) for points in spread]
    assert_allclose(*means, atol=0.1 * float(np.sqrt(covariances[1].max())))
    assert_allclose(*covariances, rtol=0.2, atol=0.05 * float(covariances[1].max()))
    assert abs(np.corrcoef(spread[0].T)[0, 1]) > 0.5


def worth(objectives, broken_mm):
    return Judged(objectives, broken_mm[:, None], {}, objectives)


def test_runs_that_are_judged_side_by_side_end_as_if_alone(monkeypatch):
    """As on a graphics card, in groups of two; one run has converged before the others."""

    def judge_at(point, rows):
        batches.append(rows.tolist())
        wanted = torch.tensor([0.2, 0.5, 0.7])[rows]
        away = ((point - wanted[:, None]) ** 2).sum(dim=1)
        flat = torch.where(rows == 1, torch.tensor(1.0), 1 + away)
        other = 2 + (point[:, 0] - 0.5) ** 2
        broken = torch.relu(point[:, 1] - 0.6)
        return worth(torch.stack([flat, other], dim=1), broken)

    begin = torch.rand(3, 2, generator=torch.Generator().manual_seed(3))
    weights = torch.tensor([[1.0, 0.0], [1.0, 0.0], [0.3, 0.7]])
    batches: list[list[int]] = []
    alone = polish(judge_at, begin, 40, weights)
    assert all(len({*rows}) == 1 for rows in batches)
    monkeypatch.setattr(polishing, "runs_together", lambda device, variables: 2)
    batches = []
    assert_array_equal(polish(judge_at, begin, 40, weights), alone)
    groups = {tuple(sorted({*rows})) for rows in batches}
    assert groups == {(0, 1), (0,), (2,)}


@pytest.mark.parametrize("variables", [1, 6])
def test_the_penalty_grows_so_that_what_is_forbidden_is_crossed(variables, monkeypatch):
    """The best place lies behind a forbidden wall; with all of the penalty from the start a run stays
    on its own side."""

    def judge_at(point, rows):
        first = point[:, 0]
        away = ((point - 0.9) ** 2).sum(dim=1)
        wall = torch.relu(0.25 - (first - 0.5).abs())
        return worth((10 + away)[:, None], wall)

    begin = torch.full((1, variables), 0.1)
    monkeypatch.setattr(polishing, "SPREAD", 0.03)
    end = polish(judge_at, begin, 120, torch.ones(1, 1))
    assert float((end - 0.9).abs().max()) < 0.02


@pytest.mark.parametrize(
    ("asked", "sought"),
    [
        ("worst_position_bound_mm", "percentile_95_position_bound_mm"),
        ("percentile_99_position_bound_mm", "percentile_95_position_bound_mm"),
        ("percentile_95_position_bound_mm", "percentile_95_position_bound_mm"),
        ("median_position_bound_mm", "median_position_bound_mm"),
    ],
)
def test_what_a_few_places_decide_is_eased_to_the_95th_percentile(lowest, units, asked, sought):
    found = judged(lowest, units[:3], (asked, "worst_force_bound_n"))
    assert_allclose(found.objectives[:, 0], found.scores[asked])
    assert_allclose(found.eased[:, 0], found.scores[sought])
    assert_allclose(found.eased[:, 1], found.scores["worst_force_bound_n"])


@pytest.mark.parametrize("progress", [0.0, 0.25, 0.5, 1.0])
def test_generations_are_told_what_is_eased_at_first_and_what_is_asked_in_the_end(progress):
    run = polishing.Evolution(0, torch.full((2,), 0.5), torch.tensor([2.0]))
    points = run.ask(24)
    assert len(points) == 24
    value, eased = np.random.default_rng(1).random((2, len(points)))
    value[3], eased[4] = np.inf, np.inf
    penalty = np.ones(len(points))
    kept = []
    run.search.tell = kept.extend
    run.tell(polishing.Worth(points, value, eased, penalty, torch.zeros(len(points), 1)), progress)
    told = np.array([one for _, one in kept])
    own = {0.0: 0.0, 0.25: 0.5, 0.5: 1.0, 1.0: 1.0}[progress]
    share = polishing.share_of_penalty(progress)
    usual = np.setdiff1d(np.arange(len(points)), [3, 4])
    expected = own * value[usual] + (1 - own) * eased[usual] + 2 * np.log(1 + share)
    assert_allclose(told[usual], expected)
    assert np.isinf(told[[3, 4]]).all()


@pytest.mark.parametrize(("generations", "plain"), [(20, True), (45, True), (120, False)])
def test_a_run_too_short_for_broad_generations_is_plain_cma_es(generations, plain, monkeypatch):
    told, tell = [], polishing.Evolution.tell

    def spied(run, worth, progress):
        told.append((progress, len(worth.points)))
        tell(run, worth, progress)

    def judge_at(point, rows):
        away = ((point - 0.3) ** 2).sum(dim=1)
        return worth((1 + away)[:, None], torch.relu(point[:, 0] - 0.9))

    monkeypatch.setattr(polishing.Evolution, "tell", spied)
    polish(judge_at, torch.full((1, 31), 0.5), generations, torch.ones(1, 1))
    progress, sizes = zip(*told, strict=True)
    assert (set(progress) == {1.0}) == plain
    assert (set(sizes) == {14}) == plain
    assert sum(sizes) >= 0.9 * generations * polishing.population(31)


def test_a_run_passes_by_what_only_the_eased_objective_sees_past():
    """What is asked is best in a narrow hole, and rises towards it all the way round; what is eased falls."""

    def judge_at(point, rows):
        away = ((point - 0.85) ** 2).sum(dim=1).sqrt()
        asked = torch.where(away < 0.15, 1 + away, 4 - away)
        broken = torch.zeros(len(point))
        return Judged(asked[:, None], broken[:, None], {}, (1 + away)[:, None])

    begin = torch.full((1, 6), 0.1)
    end = polish(judge_at, begin, 60, torch.ones(1, 1))
    assert float((end - 0.85).abs().max()) < 0.02


def test_what_keeps_all_limits_goes_before_what_gains_by_breaking_one_by_a_hair():
    """The penalty is too small to tell; beyond 0.8 nothing has a value and nothing is broken."""

    def judge_at(point, rows):
        first = point[:, 0]
        value = torch.where(first >= 0.8, torch.nan, 2 - first)
        return worth(value[:, None], 1e-6 * torch.relu(0.6 - (first - 1).abs()) * (first < 0.8))

    def loss(point):
        return judge_at(point, None).loss(torch.ones(1))

    begin = torch.full((1, 3), 0.1)
    run, walk = (
        polish(judge_at, begin, 60, torch.ones(1, 1)),
        polishing.descend(loss, begin, 60, 0.05),
    )
    for end in (run, walk):
        assert 0.3 < float(end[0, 0]) <= 0.4
        assert float(judge_at(end, None).broken_mm) == 0
    inside = polishing.descend(loss, torch.full((1, 3), 0.5), 60, 0.05)
    assert float(inside[0, 0]) > 0.7, "where all that it finds breaks the limit, the best of that"


def test_layouts_without_a_value_are_never_taken():
    def judge_at(point, rows):
        value = torch.where(point[:, 0] > 0.5, torch.nan, 2 - point[:, 0])
        return worth(value[:, None], torch.zeros(len(point)))

    end = polish(judge_at, torch.full((1, 3), 0.1), 60, torch.ones(1, 1))
    assert float(end[0, 0]) == pytest.approx(0.5, abs=0.01)


def test_a_limit_over_the_start_is_a_broken_limit(lowest, units):
    free = judged(lowest, units)
    median = free.scores["median_position_bound_mm"]
    most = float(median.median())
    tight = judged(replace(lowest, at_most={"median_position_bound_mm": most}), units)
    extra = 10 * torch.relu(median / most - 1)
    assert_allclose(tight.broken_mm - free.broken_mm, extra, rtol=1e-3, atol=1e-4)
    ratio = free.scores["sensitivity_ratio"]
    least = float(ratio.median())
    tight = judged(replace(lowest, at_most={"sensitivity_ratio": 1 / least}), units)
    assert ((tight.broken_mm > free.broken_mm) == (ratio < least * 0.9999)).all()


def test_objectives_to_maximize_are_turned_over(lowest, units):
    found = judged(lowest, units, ("sensitivity_ratio", "worst_force_bound_n"))
    assert_allclose(found.objectives[:, 0], 1 / found.scores["sensitivity_ratio"], rtol=1e-6)


def test_counts_beyond_a_limit_break_it(lowest, units):
    free = judged(lowest, units)
    most = float(free.scores["largest_counts"].median())
    limited = judged(replace(lowest, at_most={"largest_counts": most}), units)
    over = torch.relu(free.scores["largest_counts"] / most - 1)
    assert 0 < (over > 0).sum() < COUNT
    assert_allclose(limited.broken_mm - free.broken_mm, polishing.MM_PER_EXCESS * over, atol=1e-5)


def made_judged(objectives, broken=0.0):
    count = len(objectives)
    at = torch.tensor(objectives)
    return Judged(at, torch.full((count, 1), broken), {}, at)


def test_a_tenth_of_a_millimetre_doubles_every_objective():
    given = [[2.0, 5.0], [3.0, 7.0]]
    assert_allclose(made_judged(given).penalized, given)
    assert_allclose(made_judged(given, broken=0.1).penalized, 2 * np.array(given), rtol=1e-6)
    assert_allclose(made_judged(given, broken=0.2).penalty, [2.0, 2.0])


@pytest.mark.parametrize(("variables", "layouts"), [(1, 48), (2, 48), (10, 80), (40, 120)])
def test_a_generation_is_eight_times_hansens(variables, layouts):
    assert (
        polishing.population(variables) == layouts == 8 * (4 + int(3 * np.log(max(variables, 2))))
    )


@pytest.mark.parametrize(
    ("progress", "share"), [(0.0, 1e-3), (0.25, 10**-1.5), (0.5, 1.0), (0.9, 1.0), (1.0, 1.0)]
)
def test_penalties_grow_from_a_thousandth_to_all(progress, share):
    assert polishing.share_of_penalty(progress) == pytest.approx(share)


def test_a_descent_finds_the_least_point_of_the_cube_and_keeps_the_best_of_its_walk():
    middle = torch.tensor([[0.3, 0.6], [0.7, 1.4]])
    begin = torch.full((2, 2), 0.5)

    def loss(point):
        return (point - middle).square().sum(dim=1)

    found = polishing.descend(loss, begin, 40, rate=0.1)
    assert_allclose(found, [[0.3, 0.6], [0.7, 1.0]], atol=0.02)
    assert_array_equal(polishing.descend(loss, begin, 0), begin)
    calls = []

    def counted(point):
        calls.append(point.detach().clone())
        return loss(point)

    once = polishing.descend(counted, begin, 50, over=lambda: len(calls) > 1)
    assert len(calls) == 2
    assert_array_equal(once, calls[1])
    far = polishing.descend(loss, begin, 1, rate=0.1)
    assert_allclose(abs(far - begin), 0.1, atol=1e-5)


def test_a_layout_without_a_gradient_stays_and_the_others_go_on():
    begin = torch.full((2, 2), 0.5)

    def loss(point):
        wrong = torch.tensor([[torch.nan, 1.0], [1.0, 1.0]])
        return (point * wrong).sum(dim=1)

    seen = []

    def watched(point):
        seen.append(point.detach().clone())
        return loss(point)

    polishing.descend(watched, begin, 3)
    assert_array_equal(seen[-1][0], begin[0])
    assert (seen[-1][1] < begin[1]).all()


def test_scores_of_one_force_pool_faces_as_often_as_they_stand_for(lowest):
    """Two scorers, the second of which stands for three faces, with made-up values of each place."""
    scorers = [replace(lowest.scorers[0], faces=1), replace(lowest.scorers[1], faces=3)]
    rng = np.random.default_rng(5)
    layouts = [layouts_of(lowest.space.structured, face) for face in FACES]
    count = [one.presses.count for one in scorers]
    values = [rng.uniform(0.1, 9.0, (3, 1, n)) for n in count]
    places = [
        PlaceInformation(*(torch.as_tensor(part) for part in value), *torch.zeros(2, 1))
        for value in values
    ]
    found = scores_at_one_force(scorers, layouts, places, ())
    position, force, delta = (
        np.concatenate([values[0][k, 0], np.tile(values[1][k, 0], 3)]) for k in range(3)
    )
    low, middle = np.percentile(delta, [5, 50])
    wanted = {
        "worst_position_bound_mm": position.max(),
        "percentile_99_position_bound_mm": np.percentile(position, 99),
        "percentile_95_position_bound_mm": np.percentile(position, 95),
        "median_position_bound_mm": np.median(position),
        "position_over_limit": gmean(np.clip(position, 1.5, 42) / 1.5),
        "worst_force_bound_n": force.max(),
        "sensitivity_ratio": low / middle,
    }
    assert found.keys() == wanted.keys()
    for name, value in wanted.items():
        assert_allclose(float(found[name]), value, err_msg=name)
