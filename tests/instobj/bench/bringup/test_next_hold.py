"""Further holds: asked for where gains are too uncertain, at places that narrow them, up to a limit."""

from dataclasses import replace

import numpy as np
import pytest

from design.layout.body import core_frames
from instobj.bench.bringup.asking.asked import MOST_FURTHER, STILL_AGAIN, asked_of, further_holds
from instobj.bench.bringup.asking.hold_places import BETWEEN_MM, hold_places
from instobj.bench.bringup.diagnosis.chip_findings import wide_gains, widest_gain_sd
from instobj.bench.bringup.diagnosis.chip_fit import fitted
from instobj.bench.bringup.journal import open_journal
from instobj.bench.bringup.next_hold import chips_part, information_of, next_hold
from instobj.bench.bringup.simulated import simulated_object
from instobj.bench.bringup.sources import Simulated
from instobj.bench.bringup.verdict import held_so_far, identified_chips
from tests.support.new_objects import BOX

PLANNED = {asked.name: asked for asked in asked_of(BOX) if asked.step in ("still", "held")}


@pytest.fixture(scope="module")
def held():
    """A box after its planned holds, and its user."""
    made = simulated_object(BOX, 3)
    return made, {name: made.recording(PLANNED[name]) for name in PLANNED if name != STILL_AGAIN}


def intervals(recordings, made):
    chips = identified_chips(BOX, recordings | {STILL_AGAIN: made.recording(PLANNED[STILL_AGAIN])})
    return np.array([chip.mean_gain_interval for chip in chips]), chips


def test_holds_that_are_chosen_narrow_the_widest_gain_more_than_others(held):
    made, recordings = held
    chosen, others = dict(recordings), dict(recordings)
    for _ in range(2):
        hold = next_hold(BOX, chosen)
        chosen[hold.name] = made.recording(hold)
    for hold in further_holds(BOX)[:2]:
        others[hold.name] = made.recording(hold)
    before, chips = intervals(recordings, made)
    assert len(chosen) == len(recordings) + 2
    after = intervals(chosen, made)[0].max()
    assert after < 0.8 * before.max()
    assert after < 0.9 * intervals(others, made)[0].max()
    assert "F5-S2" in wide_gains(BOX, chips, None)


def test_none_is_asked_for_at_the_limit_or_where_tolerance_alone_hides_a_gain(tmp_path, held):
    made, recordings = held
    names = [hold.name for hold in further_holds(BOX)]
    journal = open_journal(tmp_path / "bringup.csv", BOX)
    journal.recordings.update(recordings)
    journal.skipped.update(names[:MOST_FURTHER])
    assert Simulated(made).further(BOX, journal) is None
    assert (
        next_hold(BOX, recordings, names[: MOST_FURTHER - 1]).name not in names[: MOST_FURTHER - 1]
    )
    loose = BOX.changed(tolerances=BOX.tolerances.changed(sensor_gain_relative=0.05))
    assert widest_gain_sd(loose, np.array([3])) == 0
    assert next_hold(loose, recordings) is None
    assert next_hold(BOX, {}) is None


def test_places_between_chips_lie_half_way_along_the_surface_outside_the_core():
    places = {place.chips: place for place in hold_places(BOX)}
    over = [place for place in places.values() if len(place.chips) == 1]
    assert [place.chips[0] for place in over] == [
        n.removeprefix("held ") for n in list(PLANNED)[1:-1]
    ]
    between = places["F1-S1", "F5-S1"]
    a, b = (places[(name,)].foot_mm for name in between.chips)
    edge = np.array([b[0], 0.0, a[2]])
    way = np.linalg.norm(a - edge) + np.linalg.norm(b - edge)
    assert between.face == 1
    assert np.linalg.norm(between.foot_mm - a) == pytest.approx(way / 2)
    for place in places.values():
        height = [(place.stated_mm - frame.centre_mm) @ frame.normal for frame in core_frames(BOX)]
        assert max(height) >= BETWEEN_MM - 1e-9
        assert np.allclose(place.axes.T @ place.axes, np.eye(3))
    assert ("F2-S1", "F4-S1") not in places


def test_candidates_judged_together_tell_what_each_tells_alone(held):
    _, recordings = held
    problem = fitted(*held_so_far(BOX, recordings, drift_followed=True)).problem
    holds = further_holds(BOX)[2:5]
    together = information_of(BOX, problem, holds)
    for hold, told in zip(holds, together, strict=True):
        np.testing.assert_allclose(information_of(BOX, problem, [hold])[0], told, atol=1e-9)
    assert abs(together[0] - together[1]).max() > 0.1 * abs(together[0]).max()


def test_holds_tell_of_chips_what_their_own_poses_leave_open():
    """Of each hold by itself the block of the inverse of the whole information, inverted: six readings,
    two numbers of the pose with their prior, three of the chips; rows beyond count nothing."""
    rng = np.random.default_rng(0)
    alone = rng.normal(size=(2, 6, 5))
    prior = np.diag([0.5, 2.0, 3.0, 0.25])
    slope = np.zeros((2 * 6 + 4 + 3, 4 + 3))
    for k in range(2):
        slope[6 * k : 6 * k + 6, 2 * k : 2 * k + 2] = alone[k, :, :2]
        slope[6 * k : 6 * k + 6, 4:] = alone[k, :, 2:]
    slope[12:16, :4], slope[16:, 4:] = prior, rng.normal(size=(3, 3))
    told = chips_part(slope, 4, 2, 12)
    for k in range(2):
        rows = np.vstack([alone[k], np.eye(2, 5) * np.diag(prior)[2 * k : 2 * k + 2, None]])
        assert np.allclose(told[k], np.linalg.inv(np.linalg.inv(rows.T @ rows)[2:, 2:]))


def test_a_hold_is_as_quiet_as_the_quietest_and_says_nothing_on_silent_channels(held):
    _, recordings = held
    problem = fitted(*held_so_far(BOX, recordings, drift_followed=True)).problem
    hold = further_holds(BOX)[:1]
    (told,) = information_of(BOX, problem, hold)
    noise = np.tile(problem.readings.noise_counts.min(axis=0), (len(problem.readings.counts), 1, 1))
    noise[1:] *= 10
    noisier = replace(problem, readings=replace(problem.readings, noise_counts=noise))
    assert np.allclose(information_of(BOX, noisier, hold), told)
    known = problem.is_read.copy()
    known[2, 1] = False
    (silent,) = information_of(BOX, replace(problem, is_read=known), hold)
    gains = slice(9 * 2 + 3, 9 * 2 + 6)
    assert np.diag(told)[gains].min() > 0
    assert not silent[gains].any()
