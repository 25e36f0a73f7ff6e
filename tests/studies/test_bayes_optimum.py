"""Posterior-optimal answers: a linear toy object at its Cramér–Rao bound, worked cases, the cube."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import contact_grid
from estimator.frames.contact_cases import ContactCase, paper_cases
from estimator.frames.contact_traces import ContactTraces, contact_traces, force_at_travel
from estimator.metrics.heatmaps import contact_errors, force_reference
from estimator.signals.presses import press_signals
from studies.paper.bayes_optimum import (
    Hypotheses,
    best_answers,
    disturbance_sigma,
    press_hypotheses,
)
from studies.paper.narrowest_intervals import best_intervals
from tests.support.mechanics.synthetic_presses import coarse_spec, force_n, synthetic_presses

SIGMA = np.array([2.0, 1.0, 3.0, 1.5])
PHASES = 800


def linear_toy(separation=40.0):
    """Four places of a 2 × 2 grid whose signals are linear in force, far apart from each other."""
    rng = np.random.default_rng(3)
    slopes = rng.normal(0, 1, (4, 4)) + separation * np.eye(4)
    force = np.linspace(0.5, 20, PHASES)
    counts = slopes[:, None] * force[:, None]
    maps = np.zeros((4, PHASES, 2, 2))
    for place in range(4):
        maps[place, :, place // 2, place % 2] = force
    return slopes, Hypotheses(counts, maps, rest_share=0.0)


def frames_of(slopes, count, rng, sigma=SIGMA):
    place, force = rng.integers(0, 4, count), rng.uniform(3, 17, count)
    true = np.zeros((count, 2, 2))
    true[np.arange(count), place // 2, place % 2] = force
    return true, slopes[place] * force[:, None] + rng.normal(0, 1, (count, 4)) * sigma


@pytest.mark.parametrize("fault", ["none", "sigma of one channel ten times too small"])
def test_a_linear_toy_reaches_its_cramer_rao_bound(fault):
    """E|F − F̂| = σ_F √(2/π), place by place; signals with a wrong weight do worse."""
    slopes, hypotheses = linear_toy()
    rng = np.random.default_rng(8)
    noisy = SIGMA * np.array([1, 1, 1, 30.0])
    true, seen = frames_of(slopes, 4000, rng, noisy)
    believed = noisy if fault == "none" else noisy * np.array([1, 1, 1, 0.02])
    found = best_answers(hypotheses, seen, believed)
    total = true.sum(axis=(1, 2))
    for place in range(4):
        mine = true[:, place // 2, place % 2] > 0
        bound = 1 / np.sqrt(np.sum((slopes[place] / noisy) ** 2))
        error = np.mean(abs(found.total_n - total)[mine])
        ratio = error / (bound * np.sqrt(2 / np.pi))
        if place < 3:  # the fourth place speaks through the misjudged channel alone
            assert (abs(ratio - 1) < 0.08) == (fault == "none")


def test_answers_by_hand():
    """Two places, two forces, one channel: posterior odds written out."""
    counts = np.array([[[1.0], [3.0]], [[2.0], [6.0]]])
    maps = np.zeros((2, 2, 1, 2))
    maps[0, :, 0, 0], maps[1, :, 0, 1] = [2.0, 4.0], [5.0, 8.0]
    hypotheses = Hypotheses(counts, maps, rest_share=0.2)
    found = best_answers(hypotheses, np.array([[2.2]]), np.array([0.5]))
    weight = 0.2 * np.exp(-((2.2 - np.array([1, 3, 2, 6.0])) ** 2) / 2 / 0.25)
    rest = 0.2 * np.exp(-(2.2**2) / 2 / 0.25)
    weight, rest = weight / (weight.sum() + rest), rest / (weight.sum() + rest)
    assert_allclose(found.rest_probability, [rest], rtol=1e-9)
    assert_allclose(
        found.mean_map_n[0, 0],
        [weight[0] * 2 + weight[1] * 4, weight[2] * 5 + weight[3] * 8],
        rtol=1e-9,
    )
    assert weight[2] > 0.5
    assert_allclose(found.median_map_n[0, 0], [0.0, 5.0])
    assert_allclose(found.case_map_n[0, 0], [0.0, 5.0])
    assert_allclose(found.total_n, [5.0])
    late = best_answers(hypotheses, np.array([[5.8]]), np.array([0.5]))
    assert_allclose(late.case_map_n[0, 0], [0.0, 8.0])


def test_hypotheses_are_presses_on_their_way_to_the_peak_and_back():
    spec = coarse_spec(collection={"poses": ((), ())})
    signals = press_signals(spec, *synthetic_presses(spec))
    cases = paper_cases(spec, 3)
    found = press_hypotheses(
        spec, cases, contact_traces(spec, signals, cases), np.full(20, 2.5), 3, 0.0, phases=4
    )
    turned = np.deg2rad([22.5, 67.5, 112.5, 157.5])  # the way in; the way out is the same
    travel = 2.5 * np.sin(turned / 2) ** 2
    place = np.array([case.xy_mm[0] for case in cases])
    expected = force_n(3, place[:, None], travel)
    assert_allclose(found.map_n.sum(axis=(2, 3)), expected, rtol=0.02, atol=0.02)


def test_tips_of_one_cell_share_its_force_and_those_of_other_faces_are_not_on_the_map():
    """Signals are in proportion to the force; the third case has one load cell of three tips,
    one of which stands on another face."""
    spec = coarse_spec()
    grid, travel = contact_grid(spec), np.array([0.0, 1.0, 4.0])
    tip_n = np.array([[3.0, 0, 0], [2.0, 5.0, 0], [1.0, 2.0, 6.0]])
    counts = np.array([[10.0, -4.0], [7.0, 1.0], [0.5, 3.0]])
    traces = ContactTraces(
        np.tile(travel, (3, 1)),
        tip_n.sum(axis=1)[:, None] * travel,
        tip_n[:, None] * travel[:, None],
        counts[:, None] * travel[:, None],
    )
    pixels = [[(0, 1)], [(1, 0), (3, 2)], [(2, 2), (2, 2), (1, 4)]]
    faces, cells = ([3], [5, 3], [3, 3, 5]), ([0], [0, 1], [0, 0, 0])
    cases = [
        ContactCase(
            np.array(face),
            np.array([(grid.x_mm[i], grid.y_mm[j]) for i, j in pixel]),
            np.array(cell),
            np.ones(len(face)),
            number,
        )
        for number, (face, pixel, cell) in enumerate(zip(faces, pixels, cells, strict=True))
    ]
    peak = np.array([4.0, 2.0, 3.0])
    found = press_hypotheses(spec, cases, traces, peak, 3, 0.25, phases=3)
    share = (1 - np.cos(np.deg2rad([30.0, 90.0, 150.0]))) / 2
    total = force_at_travel(traces, peak[:, None] * share)
    bears = total / tip_n.sum(axis=1)[:, None]
    assert_allclose(found.counts, counts[:, None] * bears[..., None])
    wanted = np.zeros((3, 3, *grid.shape))
    wanted[0, :, 0, 1] = 3 * bears[0]
    wanted[1, :, 3, 2] = 5 * bears[1]
    wanted[2, :, 2, 2] = 2 * (1 + 2 + 6) / 3 * bears[2]
    assert_allclose(found.map_n, wanted)
    assert_allclose(found.total_n, wanted.sum(axis=(2, 3)))
    assert found.rest_share == 0.25


def test_no_other_answer_does_better_on_a_small_cube():
    """Against shrunk, shifted and sharpened answers on frames drawn from the prior itself."""
    spec = coarse_spec(collection={"poses": ((), ())})
    signals = press_signals(spec, *synthetic_presses(spec))
    cases = paper_cases(spec, 3)
    traces = contact_traces(spec, signals, cases)
    own = np.arange(18, 27)
    hypotheses = press_hypotheses(
        spec, cases, traces, np.full(20, 2.5), 3, rest_share=0.0, phases=200
    )
    hypotheses = Hypotheses(hypotheses.counts[..., own], hypotheses.map_n, 0.0)
    rng = np.random.default_rng(0)
    case, phase = rng.integers(0, 20, 1500), rng.integers(0, 200, 1500)
    true = hypotheses.map_n[case, phase]
    sigma = 3 * disturbance_sigma(spec, own)
    seen = hypotheses.counts[case, phase] + rng.normal(0, 1, (1500, 9)) * sigma
    found = best_answers(hypotheses, seen, sigma)

    def summed(maps):
        return np.abs(maps - true).sum(axis=(1, 2)).mean()

    best = summed(found.median_map_n)
    for other in (found.mean_map_n, found.case_map_n, 0.95 * found.median_map_n):
        assert summed(other) >= best
    total = np.mean(abs(found.total_n - true.sum(axis=(1, 2))))
    for factor in (0.97, 1.03):
        assert np.mean(abs(factor * found.total_n - true.sum(axis=(1, 2)))) > total
    strong = true.max(axis=(1, 2)) > 5
    errors = contact_errors(found.case_map_n[strong], true[strong], force_reference(true))
    assert errors.similarity.mean() > 0.98
    assert np.nanmean(errors.distance_px) < 0.3


def test_sigma_adds_what_disturbs_a_frame():
    spec = coarse_spec()
    sigma = disturbance_sigma(spec, np.array([0, 5]), drift_counts=30.0)
    assert_allclose(sigma**2, [22**2 + 100 + 900 + 1 / 12, 11**2 + 100 + 900 + 1 / 12])


@pytest.mark.parametrize("fault", ["none", "sigma of one channel ten times too small", "no noise"])
def test_intervals_of_a_linear_toy_have_the_width_of_its_bound(fault):
    """Known answer: 1.645 √(σ_F² + σ_label²), σ_F the Cramér–Rao bound, and 90 % inside."""
    slopes, hypotheses = linear_toy(separation=8.0)
    rng = np.random.default_rng(4)
    noisy, label_noise = SIGMA * np.array([1, 1, 1, 30.0]), 0.2
    true, seen = frames_of(slopes, 4000, rng, noisy)
    label = true.sum(axis=(1, 2)) + rng.normal(0, label_noise, len(true))
    believed = noisy * np.array([1, 1, 1, 0.02]) if "sigma" in fault else noisy
    centre = np.array([[-3.0, -3], [-3, 3], [3, -3], [3, 3]])
    noise = 0.0 if fault == "no noise" else label_noise
    found = best_intervals(hypotheses, centre, seen, believed, 0.9, noise)
    right = []
    for place in range(3):  # the fourth place speaks through the misjudged channel alone
        mine = true[:, place // 2, place % 2] > 0
        bound = 1 / np.sqrt(np.sum((slopes[place] / noisy) ** 2))
        known = 1.6449 * np.hypot(bound, label_noise)
        inside = abs(label - found.force_n)[mine] <= found.force_halfwidth_n[mine]
        width = np.median(found.force_halfwidth_n[mine])
        right.append(abs(width / known - 1) < 0.03 and abs(inside.mean() - 0.9) < 0.03)
        if fault == "none":
            assert_allclose(np.median(found.position_radius_mm[mine]), 0.0)
    assert all(right) == (fault == "none")


def test_radius_by_hand():
    """Two places 5 mm apart with posterior odds written out."""
    hypotheses = Hypotheses(
        np.array([[[1.0], [3.0]], [[2.0], [6.0]]]),
        np.array([[[[2.0, 0.0]], [[4.0, 0.0]]], [[[0.0, 5.0]], [[0.0, 8.0]]]]),
        rest_share=0.2,
    )
    weight = np.exp(-((2.2 - np.array([1, 3, 2, 6.0])) ** 2) / 2 / 0.25)
    second = weight[2:].sum() / weight.sum()
    assert 0.6 < second < 0.8
    centre, seen, sigma = np.array([[0.0, 0.0], [3.0, 4.0]]), np.array([[2.2]]), np.array([0.5])
    for cover, radius in ((0.5, 0.0), (0.9, 5 * second)):
        found = best_intervals(hypotheses, centre, seen, sigma, cover, 0.0)
        assert_allclose(found.position_radius_mm, [radius], rtol=1e-9)
        assert_allclose(found.force_n, [5.0])
        share = weight / weight.sum()
        away = np.abs(np.array([2, 4, 5, 8.0]) - 5.0)
        order = np.argsort(away)
        needed = away[order][np.argmax(share[order].cumsum() >= cover)]
        assert_allclose(found.force_halfwidth_n, [needed], atol=1e-6)


def made_hypotheses(seed=0, cases=4, phases=3):
    """Cases that press two pixels of six each, forces increasing along the phases."""
    rng = np.random.default_rng(seed)
    counts = rng.normal(size=(cases, phases, 2))
    maps = np.zeros((cases, phases, 6))
    for case in range(cases):
        for pixel in rng.permutation(6)[:2]:
            maps[case, :, pixel] = np.sort(rng.uniform(0.5, 9, phases))
    return Hypotheses(counts, maps.reshape(cases, phases, 2, 3), rest_share=0.1)


def test_medians_are_those_of_every_pixel_and_of_the_total_force():
    """By sorting the values of all hypotheses and of rest, pixel by pixel."""
    made = made_hypotheses()
    seen = np.random.default_rng(1).normal(size=(40, 2))
    found = best_answers(made, seen, np.full(2, 0.6))
    flat = made.counts.reshape(-1, 2)
    log = -np.sum(((seen[:, None] - flat) / 0.6) ** 2, axis=2) / 2
    weight = 0.9 / len(flat) * np.exp(log)
    rest = 0.1 * np.exp(-np.sum((seen / 0.6) ** 2, axis=1) / 2)
    weight = np.column_stack([weight, rest])
    weight /= weight.sum(axis=1, keepdims=True)

    def median(values, row):
        order = np.argsort(values, kind="stable")
        return values[order][np.searchsorted(weight[row][order].cumsum(), 0.5 - 1e-9)]

    maps = np.concatenate([made.map_n.reshape(-1, 6), np.zeros((1, 6))])
    for row in range(len(seen)):
        wanted = [median(maps[:, pixel], row) for pixel in range(6)]
        assert_allclose(found.median_map_n[row].ravel(), wanted)
        assert_allclose(found.total_n[row], median(maps.sum(axis=1), row))
        of_case = weight[row, :-1].reshape(4, 3)
        best = of_case.sum(axis=1).argmax()
        middle = np.searchsorted(of_case[best].cumsum(), of_case[best].sum() / 2 - 1e-12)
        assert_allclose(found.case_map_n[row], made.map_n[best, middle])
    assert_allclose(found.rest_probability, weight[:, -1])
    assert (found.median_map_n > 0).any()


def test_batches_of_frames_change_no_answer(monkeypatch):
    made, seen = made_hypotheses(), np.random.default_rng(2).normal(size=(7, 2))
    whole = best_answers(made, seen, np.ones(2))
    monkeypatch.setattr("studies.paper.bayes_optimum.CHUNK_BYTES", 8.0 * 12 * 2)
    parts = best_answers(made, seen, np.ones(2))
    for name in ("median_map_n", "case_map_n", "mean_map_n", "total_n", "rest_probability"):
        assert_allclose(getattr(parts, name), getattr(whole, name), rtol=1e-12)
