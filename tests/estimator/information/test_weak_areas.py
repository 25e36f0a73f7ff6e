"""Weak areas: the measure that bounds follow is found, on flat and curved bodies."""

import csv

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.places.measures import MEASURES, PlaceMeasures, place_measures
from design.spec_io import load_spec
from estimator.information.weak_areas import (
    Third,
    WeakAreas,
    save_weak_areas_csv,
    thirds_of,
    weak_areas,
)
from tests.support.objects.made_scores import scores_of
from tests.support.pages import ROOT


@pytest.fixture(scope="module")
def ball():
    return load_spec(ROOT / "examples/ball.toml")


@pytest.fixture(scope="module")
def pear():
    return load_spec(ROOT / "examples/pear.toml", ["body.sensed_faces=[2]"])


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("name", MEASURES)
def test_the_measure_that_bounds_follow_is_told(pear, name, sign):
    value = getattr(place_measures(pear), name).round(5)  # as ranks are taken
    found = weak_areas(pear, scores_of(pear, np.exp(sign * value / np.nanstd(value))))
    assert found.told_by == name
    assert_allclose(found.rank_correlation[name], sign)
    low, middle, high = (third for third in found.thirds if third.measure == name)
    assert (low.bound_mm < middle.bound_mm < high.bound_mm) == (sign > 0)
    assert low.places + middle.places + high.places == np.isfinite(value).sum()
    extreme = np.nanquantile(value, 0.9 if sign > 0 else 0.1)
    assert sign * (found.weakest_tenth[name] - extreme) >= -1e-9


def test_curvature_tells_no_location_of_a_ball_from_another(ball):
    measures = place_measures(ball)
    found = weak_areas(ball, scores_of(ball, 1 + 1 / measures.border_mm))
    assert set(found.rank_correlation) == {"border_mm", "magnet_mm", "path_mm"}
    assert found.told_by == "border_mm"
    assert found.edge_ratio > 1


def test_the_edges_signal_path_is_that_of_the_third_whose_bound_is_the_edges(pear):
    measures = place_measures(pear)
    scores = scores_of(pear, measures.path_mm)
    border, path = (measure[scores.judged] for measure in (measures.border_mm, measures.path_mm))
    outer, *_, inner = thirds_of(border)
    found = weak_areas(pear, scores)
    assert_allclose(found.edge_paths_mm, [np.median(path[outer]), np.median(path[inner])])
    weak = [np.quantile(path[third], 0.95, method="lower") for third in (outer, inner)]
    assert_allclose(found.edge_ratio, weak[0] / weak[1])


def test_edges_of_which_only_a_part_is_weak_are_weak(pear):
    """A tenth of the outer third four times as uncertain as all the rest: medians do not feel it."""
    border = place_measures(pear).border_mm
    nearest = border <= np.nanquantile(border, 0.04)
    found = weak_areas(pear, scores_of(pear, np.where(nearest, 4.0, 1.0)))
    outer, *_, inner = (third for third in found.thirds if third.measure == "border_mm")
    assert_allclose(outer.bound_mm / inner.bound_mm, 4.0)
    assert_allclose(found.edge_ratio, 4.0)


def test_blind_locations_are_weak_and_the_table_keeps_them(pear, tmp_path):
    border = place_measures(pear).border_mm
    blind = np.where(border < np.nanquantile(border, 0.4), np.inf, 1.0)
    scores = scores_of(pear, blind)
    found = weak_areas(pear, scores)
    assert np.isinf(found.edge_ratio)
    assert found.rank_correlation["border_mm"] < -0.7
    save_weak_areas_csv(found, scores, tmp_path / "weak.csv")
    with (tmp_path / "weak.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == scores.places.sum()
    assert {float(row["position_bound_mm"]) for row in rows} == {1.0, np.inf}
    assert_allclose([float(row["border_mm"]) for row in rows], border[scores.places])


def test_locations_that_lie_alike_have_no_weak_areas():
    spec = load_spec(
        ROOT / "examples/hall_skin.toml",
        ["contact_grid.count=[2, 2]", "magnets.positions_mm=[[0.0, 0.0]]"],
    )
    spec = spec.changed(body=spec.body.changed(size_mm=(40.0, 40.0, spec.body.size_mm[2])))
    found = weak_areas(spec, scores_of(spec, np.ones(4)))
    assert found.told_by is None
    assert np.isnan(found.edge_ratio)


def test_the_edge_s_ratio_is_of_the_third_nearest_the_border_over_the_innermost():
    thirds = [
        Third(name, 0.0, 1.0, 9, bound)
        for name, bounds in (("path_mm", (9.0, 8.0)), ("border_mm", (0.75, 0.5, 0.3)))
        for bound in bounds
    ]
    measures = PlaceMeasures(*np.zeros((len(MEASURES), 1, 1)))
    assert WeakAreas(measures, {}, tuple(thirds), {}).edge_ratio == pytest.approx(2.5)
    assert np.isnan(WeakAreas(measures, {}, tuple(thirds[:2]), {}).edge_ratio)
