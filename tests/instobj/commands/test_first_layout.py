"""First layouts by their score: better than what rules place, within all limits, the same every time."""

import re

import numpy as np
import pytest

from design.fabrication.layout import failures, layout_findings
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.placement.objects import (
    COARSE,
    SHELL_VARIANTS,
    Request,
    ShellVariant,
    first_fit,
    fitting_tables,
    spec_of,
)
from estimator.field.seating import all_stay, gap_that_holds_mm
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import position_bounds
from estimator.layouts.presses.layer import layer_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.without_mesh import LevelWithoutMesh, coarse, first_score
from instobj.commands.first_layout import BRIEF, gain_text, improved
from instobj.commands.run import check

NEAR = [[-11.6, -1.1], [13.1, 9.0], [-17.4, 8.1], [-20.0, -2.2], [20.9, -7.5]]
PAD = Request("pad", (60.0, 42.0, 11.0), sensors=2, magnets=4)


@pytest.fixture(scope="module")
def placed():
    tables = first_fit(PAD, SHELL_VARIANTS, COARSE)
    assert tables is not None
    return tables


@pytest.fixture(scope="module")
def moved(placed):
    return improved(placed, rounds=2)


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
    again, worth = improved(placed, rounds=2)
    assert (again, worth) == moved


def test_a_search_from_its_own_end_is_never_worse(moved):
    """Other walks find a better layout, or the start stays as it is."""
    tables, worth = improved(moved[0], rounds=1, seed=1)
    assert worth < moved[1] or tables == moved[0]


def test_a_start_that_walks_do_not_mend_is_worth_nothing(placed):
    """Chips of a small range, which saturate wherever they are."""
    broken = placed | {"sensors": placed["sensors"] | {"range_mt": 0.5, "counts_per_mt": 1000.0}}
    assert improved(broken) == (broken, np.inf)


def test_magnets_that_pull_each_other_out_break_the_gap_at_which_they_would_stay():
    """A cylinder's sides, where two magnets that a walk brought together are turned to each other."""
    shell = ShellVariant(8.0, 6.0, 5.0, 3.0)
    placed = next(fitting_tables(Request("cylinder", (50.0, 50.0, 80.0), 2), (shell,), COARSE))
    assert all_stay(spec_of(placed))
    end = placed["magnets"]["positions_mm"][0]
    together = spec_of(
        placed | {"magnets": placed["magnets"] | {"positions_mm": [end, *4 * [NEAR]]}}
    )
    assert not all_stay(together)
    gap, level = gap_that_holds_mm(together), LevelWithoutMesh.create(coarse(together))
    broken = [float(one.losses(one.point)[0]) for one in (level, level.with_gap(gap))]
    assert broken[0] + 0.5 < broken[1]
    assert 0 < gap < 9


def test_bounds_of_few_places_are_those_of_more(placed):
    """What is judged on a coarse grid is that of a finer one, to a third."""
    spec = spec_of(placed)
    fine = spec.changed(contact_grid=spec.contact_grid.changed(pitch_mm=4.0))
    coarser = spec.changed(contact_grid=spec.contact_grid.changed(pitch_mm=6.5))
    medians = [first_score(one).median_mm for one in (fine, coarser)]
    np.testing.assert_allclose(*medians, rtol=0.35)


def test_a_place_has_the_same_bound_among_few_places_and_among_many():
    """Bounds with 1.3 vectors a place, of places 7 mm apart were up to 60 times too small."""
    request = Request("pad", (60.0, 42.0, 11.0), sensors=2, magnets=4)
    spec = spec_of(next(fitting_tables(request, SHELL_VARIANTS[-1:], COARSE)))
    by_place = []
    for pitch in (4.0, 8.0):
        # as odd as even: both have a place in the middle of the face
        gridded = spec.changed(contact_grid={"pitch_mm": pitch, "count": [int(40 / pitch) + 1] * 2})
        face = gridded.body.sensed[0]
        scorer = layout_scorer(gridded, layer_basis(gridded, face))
        (bound,) = position_bounds([scorer], [layouts_of(gridded, face)])
        places = contact_grid(gridded).xy_mm[contact_places(gridded)[0]].round(6).tolist()
        by_place.append(dict(zip(map(tuple, places), bound[0].tolist(), strict=True)))
    many, few = by_place
    shared = [place for place in few if place in many]
    assert len(shared) > 10
    np.testing.assert_allclose(
        [few[place] for place in shared], [many[place] for place in shared], rtol=0.02
    )


def test_what_a_better_layout_would_gain_is_what_first_scores_say(placed, moved):
    """Both bounds fall; of the better layout itself next to nothing is left to gain."""
    said = gain_text(placed)
    shares = [float(share) for share in re.findall(r"(\d+) % smaller", said)]
    assert len(shares) == 2
    found, _ = improved(placed, BRIEF)
    before, after = first_score(spec_of(placed)), first_score(spec_of(found))
    assert shares[0] == pytest.approx(100 * (1 - after.median_mm / before.median_mm), abs=1)
    assert shares[1] == pytest.approx(
        100 * (1 - after.percentile_95_mm / before.percentile_95_mm), abs=1
    )
    turned = found | {"sensors": found["sensors"] | {"rotations_deg": [[0, 0, 90.0]] * 2}}
    left = [float(share) for share in re.findall(r"(\d+) % smaller", gain_text(turned))]
    assert sum(left) < 0.5 * sum(shares)


def test_turns_of_chips_change_bounds_by_the_ratio_of_their_axes_noise_at_most(placed):
    """Any turn's noise lies between that of all axes as quiet and that of all as noisy as one."""
    noises = spec_of(placed).sensors.noise_counts
    quiet, actual, noisy = (
        first_score(spec_of(placed).changed(sensors={"noise_counts": each})).median_mm
        for each in ([min(noises)] * 3, list(noises), [max(noises)] * 3)
    )
    assert quiet <= actual <= noisy
    assert noisy / quiet <= max(noises) / min(noises) + 1e-6
