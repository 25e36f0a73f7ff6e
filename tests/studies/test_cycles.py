"""Loading cycles made of known laws: each law explains its own, and exchanged ways tell history."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.recordings.formats.travel import TravelRecording
from studies.recorded import cycle_laws as cycles
from studies.recorded.cycle_laws import cycles_of, field_laws, force_laws, loop_shares

PERIOD_S, COUNT = 20.0, 6


def made(lag_s=0.0, share=0.0, time_s=3.0, creep=0.0):
    """A sphere's force, 100 (x − 1)^{3/2}, of which a share relaxes; two channels that follow it."""
    time = np.arange(0, COUNT * PERIOD_S, 0.05)
    travel = lambda t: np.where(t < 0, 0, 4 * (1 - np.cos(2 * np.pi * t / PERIOD_S)))  # noqa: E731
    elastic = 100 * np.maximum(travel(time - lag_s) - 1, 0) ** 1.5
    relaxing, kept = np.zeros(len(time)), np.exp(-0.05 / time_s)
    for k in range(1, len(time)):
        relaxing[k] = kept * relaxing[k - 1] + elastic[k] - elastic[k - 1]
    load = elastic - share * (elastic - relaxing)
    load[::2] = np.nan
    rng = np.random.default_rng(2)
    known = np.interp(time, time[1::2], load[1::2])
    field = np.stack([0.01 * known, -0.004 * known, np.zeros(len(time))], axis=1)
    field += creep * time[:, None] + rng.normal(0, 0.002, field.shape)
    tip = np.column_stack([np.full(len(time), 5.0), np.full(len(time), 7.0), 90 - travel(time)])
    place = np.zeros(len(time), int)
    return TravelRecording(1e9 + time, tip, field[:, None], place, load)


def named(scores):
    return {score.law: score for score in scores}


def exchanged(score):
    assert score.exchanged is not None
    return score.exchanged


def test_an_elastic_sphere_is_small_strain_and_needs_nothing_else():
    cycles = cycles_of(made())
    assert (cycles.count, cycles.axis) == (COUNT, "z")
    assert_allclose(cycles.travel_mm.max(), 8, atol=1e-3)
    force = named(force_laws(cycles))
    assert force["small strain"].explained > 0.999
    assert force["elastic, lag"].lag_s == 0
    assert_allclose(exchanged(force["elastic, lag"]), force["elastic, lag"].explained, atol=1e-3)
    field = named(field_laws(cycles))
    assert field["any law of the load"].explained > 0.999
    assert field["small strain"].explained < field["any law of the load"].explained - 1e-3
    assert abs(loop_shares(cycles, 0.0)).max() < 0.01


def test_a_lag_of_the_machine_is_found_and_lets_the_loop_run_backwards():
    cycles = cycles_of(made(lag_s=0.4))
    force = named(force_laws(cycles))
    assert force["elastic, lag"].lag_s == 0.4
    assert force["elastic, lag"].explained > 0.999
    assert exchanged(force["elastic, lag"]) < 0.97
    assert loop_shares(cycles, 0.0)[1:-1].max() < -0.1
    assert abs(loop_shares(cycles, 0.4)).max() < 0.01


def test_relaxation_is_found_beside_a_lag():
    cycles = cycles_of(made(lag_s=0.3, share=0.3))
    force = named(force_laws(cycles))
    found = force["elastic, lag, relaxation"]
    assert (found.lag_s, found.time_s, found.share) == (0.3, 3.0, 0.3)
    assert found.explained > max(0.999, force["elastic, lag"].explained + 1e-3)
    assert exchanged(found) < found.explained - 5e-3
    assert loop_shares(cycles, 0.3)[1:].min() > 0.02


def test_drift_is_no_relaxation():
    """What goes on through all cycles no law of one cycle explains."""
    field = named(field_laws(cycles_of(made(creep=0.02))))
    assert field["elastic, lag, relaxation"].explained < 0.95


def test_what_are_no_cycles_is_said():
    recording = made()
    rows = np.arange(len(recording)) < 2 * len(recording) / COUNT
    with pytest.raises(InputError, match="2 loading cycles"):
        cycles_of(recording.select(rows))
    unloaded = TravelRecording(
        recording.time_s, recording.tip_mm, recording.field_mt, recording.place_id
    )
    with pytest.raises(InputError, match="no loads"):
        cycles_of(unloaded)
    wandering = recording.tip_mm + np.linspace(0, 3, len(recording))[:, None]
    moved = TravelRecording(
        recording.time_s, wandering, recording.field_mt, recording.place_id, recording.load
    )
    with pytest.raises(InputError, match="one axis"):
        cycles_of(moved)


@pytest.mark.parametrize(
    ("axis", "reach_mm", "aside_mm", "named"),
    [(2, 0.51, 0.0, "z"), (2, 0.49, 0.0, ""), (0, -3.0, 0.09, "x"), (1, 2.0, 0.11, "")],
)
def test_cycles_are_half_a_millimetre_long_at_least_and_stray_a_tenth_at_most(
    axis, reach_mm, aside_mm, named
):
    """Either way along any axis; the travel counts from where it begins."""
    recording = made()
    share = (90 - recording.tip_mm[:, 2]) / 8
    tip = np.full((len(share), 3), 5.0)
    tip[:, axis] -= reach_mm * share
    tip[:, (axis + 1) % 3] += aside_mm * share
    moved = replace(recording, tip_mm=tip)
    if named:
        found = cycles_of(moved)
        assert (found.axis, found.count) == (named, COUNT)
        assert_allclose(found.travel_mm.max(), abs(reach_mm), rtol=1e-3)
        assert abs(found.travel_mm[0]) < 1e-9
    else:
        with pytest.raises(InputError, match="one axis"):
            cycles_of(moved)


@pytest.mark.parametrize(("count", "fitted"), [(4, [0, 1]), (5, [0, 1])])
def test_the_later_half_of_the_cycles_judges_what_the_earlier_one_fits(count, fitted):
    """Frames before the first and after the last whole cycle serve neither."""
    cycle = np.repeat([-1, *range(count), -1], 3)
    found = cycles._halves.__wrapped__(SimpleNamespace(count=count, cycle=cycle))
    assert sorted(set(cycle[found[0]])) == fitted
    assert sorted(set(cycle[found[1]])) == list(range(len(fitted), count))
