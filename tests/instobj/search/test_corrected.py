"""A leader's walk with the lowest fidelity level corrected by the second: made-up scores, a known optimum."""

from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.search.space import params_at, search_space, unit_of
from design.spec_io import parse_spec
from estimator.layouts.fidelity import SCORE_NAMES, FidelityScore
from estimator.layouts.polish import Judged
from instobj.search import corrected
from instobj.search.verdict import FIRST, SECOND, Promoted

FORCES, FACES, PLACES = (2.0, 8.0), 5, 100
SPACE = search_space(
    parse_spec(
        {
            "name": "cube",
            "search": {
                "vary": {"magnet_reach_mm": 12.0, "sensor_chip": ["inward", "outward"]},
                "forces_n": FORCES,
                "limits": {"times_start": {"median_position_bound_mm": 0.5}},
            },
        },
        "made up",
    )
)
PARAMS = params_at(SPACE, np.array([0.6, *np.tile([0.05, 0.95], 5)])) | {"magnet5_y_mm": 0.0}


def score(worth=1.0, free=0.5, of_objects=0.5):
    bounds = np.full((len(FORCES), FACES, PLACES), worth)
    names = dict.fromkeys(SCORE_NAMES, worth) | {
        "saturation_margin": free,
        "objects_margin": of_objects,
    }
    return FidelityScore(**names, position_bounds_mm=tuple(bounds.ravel()))


def promoted(first, second, spec=SPACE.spec):
    return Promoted("trial 7", 7, spec, {FIRST: first, SECOND: second})


@pytest.fixture
def prepared(monkeypatch):
    """What the lowest level is set up with; its loss is the distance from all variables in the middle."""
    given = []

    def fidelity(space, params, start):
        given.append((space, params, start))
        return SimpleNamespace(space=SimpleNamespace(structured=space.spec))

    def judge(lowest, unit, poles, objectives):
        worth = 1 + ((unit - 0.5) ** 2).sum(dim=1, keepdim=True)
        return Judged(worth, torch.zeros(len(unit), 1), {}, worth)

    monkeypatch.setattr(corrected, "structure_fidelity", fidelity)
    monkeypatch.setattr(corrected, "judge", judge)
    monkeypatch.setattr(corrected, "misfit_of", lambda spec, params: "")
    return given


def test_limits_are_corrected_score_by_score(prepared):
    start = promoted(score(4.0), score(5.0))
    one = promoted(score(1.0, free=0.6), score(2.0, free=0.1))
    corrected.corrected_params(SPACE, PARAMS, start, one)
    (space, params, before), *_ = prepared
    assert before.scores == {"median_position_bound_mm": 2.5, "position_over_limit": 2.5}
    assert before.counts_over_lowest == pytest.approx(1.07 * 0.9 / 0.4)
    crowded = promoted(score(1.0, of_objects=0.1), score(2.0, of_objects=-0.8))
    corrected.corrected_params(SPACE, PARAMS, start, crowded)
    *_, (_, _, before) = prepared
    assert before.counts_over_lowest == pytest.approx(1.07 * 1.8 / 0.9)
    assert (space, params) == (SPACE, PARAMS)


def test_a_walk_goes_downhill_and_no_further_than_the_correction_is_trusted(prepared):
    start, one = promoted(score(4.0), score(5.0)), promoted(score(), score())
    found = corrected.corrected_params(SPACE, PARAMS, start, one)
    assert found is not None
    before, after = (unit_of(SPACE, params) for params in (PARAMS, found))
    assert found["sensor_chip"] == PARAMS["sensor_chip"]
    free = np.array([not v.choices for v in SPACE.variables])
    assert (abs(after[free] - 0.5) <= abs(before[free] - 0.5) + 1e-6).all()
    assert_allclose(abs(after - before)[free][:9], 0.04, atol=1e-3)


def test_nothing_is_returned_where_no_layout_nearby_is_better_or_fits(prepared, monkeypatch):
    start, one = promoted(score(4.0), score(5.0)), promoted(score(), score())
    best = params_at(SPACE, np.full(len(SPACE.variables), 0.5)) | {"sensor_chip": "inward"}
    assert corrected.corrected_params(SPACE, best, start, one) is None
    monkeypatch.setattr(corrected, "misfit_of", lambda spec, params: "does not fit")
    assert corrected.corrected_params(SPACE, PARAMS, start, one) is None
