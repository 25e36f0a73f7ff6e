"""Posterior-optimal answers and intervals, by sorting all hypotheses and by hand."""

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import contact_grid
from estimator.frames.contact_cases import ContactCase
from estimator.frames.contact_traces import ContactTraces, force_at_travel
from studies.paper.bayes_optimum import (
    Hypotheses,
    best_answers,
    disturbance_sigma,
    press_hypotheses,
)
from studies.paper.narrowest_intervals import best_intervals
from tests.support.mechanics.synthetic_presses import coarse_spec


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


def test_sigma_adds_what_disturbs_a_frame():
    spec = coarse_spec()
    sigma = disturbance_sigma(spec, np.array([0, 5]), drift_counts=30.0)
    assert_allclose(sigma**2, [22**2 + 100 + 900 + 1 / 12, 11**2 + 100 + 900 + 1 / 12])


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
        assert_allclose(found.mean_map_n[row].ravel(), weight[row] @ maps)
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
