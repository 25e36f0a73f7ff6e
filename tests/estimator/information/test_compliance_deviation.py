"""Compliance of places against what is wanted."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from design.spec_io import parse_spec
from estimator.information.scores import compliance_deviation

GRID = {"count": [6, 5], "pitch_mm": 3.0}
SPEC = parse_spec({"name": "cube", "contact_grid": GRID}, "made up")
PLACES = contact_grid(SPEC)
EDGE = np.ones((6, 5), bool)
EDGE[1:-1, 1:-1] = False


def soft_edges():
    return np.tile(np.where(EDGE, 0.4, 0.2).ravel(), (2, 1))


def test_a_wanted_map_that_is_met_has_no_deviation():
    wanted = {"everywhere": 0.2, "edge": 0.4, "corner": 0.4}
    assert compliance_deviation(wanted, PLACES, soft_edges()) == pytest.approx(0, abs=1e-12)


def test_deviation_is_relative_and_counts_named_areas_alone():
    assert_allclose(compliance_deviation({"corner": 0.5}, PLACES, soft_edges()), 0.2)
    share = EDGE.mean()  # of places that are twice as soft as wanted
    assert_allclose(compliance_deviation({"everywhere": 0.2}, PLACES, soft_edges()), np.sqrt(share))


def test_nothing_wanted_is_even_softness():
    values = soft_edges()
    assert_allclose(compliance_deviation({}, PLACES, values), values.std() / values.mean())
    assert compliance_deviation({}, PLACES, np.full((5, 30), 0.3)) == pytest.approx(0, abs=1e-12)


def test_an_objective_that_the_lowest_fidelity_cannot_move_is_refused():
    search = {"objectives": ["compliance_deviation"], "vary": {"magnet_reach_mm": 14.0}}
    with pytest.raises(InputError, match="second fidelity level"):
        parse_spec({"name": "cube", "search": search}, "made up")
    search["vary"]["shell_thickness_mm"] = [8.0, 9.0]
    assert parse_spec({"name": "cube", "search": search}, "made up").search.objectives
    with pytest.raises(InputError, match="compliance_mm_per_n"):
        parse_spec({"name": "cube", "search": {"compliance_mm_per_n": {"rim": 0.2}}}, "made up")
