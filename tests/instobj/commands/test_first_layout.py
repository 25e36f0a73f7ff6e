"""First layouts by their score: better than what rules place, within all limits, the same every time."""

import numpy as np
import pytest

from design.fabrication.layout import failures, layout_findings
from design.placement.objects import COARSE, SHELL_VARIANTS, Request, first_fit, spec_of
from estimator.layouts.without_mesh import LevelWithoutMesh, coarse, first_score
from instobj.commands.first_layout import improved
from instobj.commands.run import check

PAD = Request("pad", (60.0, 42.0, 11.0), sensors=2, magnets=4)


@pytest.fixture(scope="module")
def placed():
    tables = first_fit(PAD, SHELL_VARIANTS, COARSE)
    assert tables is not None
    return tables


@pytest.fixture(scope="module")
def moved(placed):
    return improved(placed, walks=3, steps=12)


def test_a_short_search_finds_better_places_that_pass_every_check(placed, moved):
    tables, worth = moved
    level = LevelWithoutMesh.create(coarse(spec_of(placed)))
    assert worth < float(level.losses(level.point)[0])
    before, after = first_score(spec_of(placed)), first_score(spec_of(tables))
    assert after.percentile_95_mm < before.percentile_95_mm
    check(spec_of(tables))
    assert not failures(layout_findings(spec_of(tables)))
    for table in set(tables) - {"magnets", "sensors"}:
        assert tables[table] == placed[table]


def test_the_same_seed_gives_the_same_places(placed, moved):
    again, worth = improved(placed, walks=3, steps=12)
    assert (again, worth) == moved


def test_a_start_that_nothing_beats_stays(placed):
    """No step: the end of the only walk is its beginning."""
    assert improved(placed, walks=1, steps=0)[0] == placed


def test_bounds_of_few_places_are_those_of_more(placed):
    """What is judged on a coarse grid is that of a finer one, to a third."""
    spec = spec_of(placed)
    fine = spec.changed(contact_grid=spec.contact_grid.changed(pitch_mm=4.0))
    coarser = spec.changed(contact_grid=spec.contact_grid.changed(pitch_mm=6.5))
    medians = [first_score(one).median_mm for one in (fine, coarser)]
    np.testing.assert_allclose(*medians, rtol=0.35)
