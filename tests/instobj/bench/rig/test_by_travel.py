"""Presses labelled by travel, without a load cell: touched by the chips, bounded from the stated surface."""

import csv
import re

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.frames.dataset import NO_FACE
from estimator.recordings.boards.growing import finish_recording
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.generic import generic_columns
from instobj.bench.rig.contact_law import contact_law, travel_bound_mm
from instobj.bench.rig.dialects import DIALECTS
from instobj.bench.rig.plan import stops_of
from tests.support.rig_in_memory import CHANNELS, TOP_MM, Bench, FollowsForce, at_bench

SPEC = ObjectSpec(name="cube", contact_grid={"count": [2, 2], "pitch_mm": 12.0})
SETTINGS = {"depths_mm": (1.0, 2.0), "dwell_s": 0.4, "rest_s": 0.7, "full_n": 10.0}
SETTINGS |= {"clearance_mm": 3.0}
LIMIT_N = 10.0 * 4 / 3


class WithoutCell(Bench):
    """The bench whose board reads no load cell."""

    def __init__(self, silicone=None, **settings):
        super().__init__(silicone or FollowsForce(), **settings)
        self.cell = lambda _: None


def pressed(bench, folder, settings=SETTINGS, presses=2, **choice):
    """The error that ended a run by travel, None of a whole one, and the presses that were done."""
    with at_bench(
        bench, SPEC, SETTINGS | settings, folder, presses=presses, by_travel=True, **choice
    ) as (_, go, journal):
        try:
            go()
        except InputError as error:
            return str(error), journal.finished
    return None, journal.finished


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("strokes", [1, 3])
def test_a_rig_without_a_load_cell_records_labels_by_travel(tmp_path, dialect, strokes):
    bench = WithoutCell(dialect=dialect)
    error, done = pressed(bench, tmp_path, {"strokes": strokes})
    assert error is None
    assert len(done) == 2
    assert max(bench.depths) == pytest.approx(2.0, abs=0.1)
    loads = np.array([0.0, *bench.depths]) > 1.9
    assert np.sum(loads[1:] & ~loads[:-1]) == 2 * strokes
    assert bench.depth_mm <= -2.0
    with (tmp_path / "run.csv").open() as file:
        header, *rows = csv.reader(file)
    assert header == generic_columns(list(CHANNELS), 1, 1, travel=True, force=False)
    for row in rows:  # as `bench collect` labels by travel: a place and its travel, or nothing
        assert {bool(cell) for cell in row[-4:]} in ({True}, {False})
        assert row[2] == "0" or not row[-1]  # what rests carries none
    finish_recording(tmp_path / "run.csv", tmp_path / "run.nc")
    table = read_table(tmp_path / "run.nc")
    assert table.labelled_by_travel
    touched = table.face[:, 0] != NO_FACE
    assert touched.sum() > 10 * strokes
    assert table.travel_mm[touched].min() > 0
    assert table.travel_mm[touched].max() == pytest.approx(2.0, abs=0.015)


@pytest.mark.parametrize("seed", [1, 2])
def test_travel_is_labelled_within_a_tenth_of_a_millimetre(tmp_path, seed):
    """Touch by chips alone, on an object of which two places in four are far from all but one chip."""
    bench = WithoutCell(seed=seed)
    labels = []
    with at_bench(bench, SPEC, SETTINGS, tmp_path, presses=2, by_travel=True) as (station, go, _):
        bench.act = lambda: labels.append(station.surface_mm - TOP_MM)
        go()
    assert abs(labels[-1]) < 0.1


@pytest.mark.parametrize("off_mm", [-0.6, 0.4, 0.8])
def test_nothing_goes_below_the_bound_from_the_stated_surface(tmp_path, off_mm):
    """The surface is stated higher or lower than it is; the bound follows what was stated."""
    bench = WithoutCell()
    bound_mm = travel_bound_mm(SPEC, LIMIT_N)
    pressed(bench, tmp_path, {"depths_mm": (bound_mm - 0.01,)}, middle_z_mm=TOP_MM + off_mm)
    assert max(bench.depths) <= bound_mm - max(off_mm, 0.0) + 0.1
    assert max(bench.depths) <= bound_mm - off_mm + 0.02


def test_chips_that_hide_a_contact_at_first_do_not_lower_the_bound(tmp_path):
    """They see nothing of the first 0.6 mm, so that the surface seems lower; presses end where they would."""
    bench = WithoutCell()
    bound_mm = travel_bound_mm(SPEC, LIMIT_N)
    level = np.round(820 * bench.silicone.field_mt(0.0, np.zeros(2)))

    def counts(values):
        hidden = level + np.round(22 * bench.rng.standard_normal((3, 3)))
        return values if bench.depth_mm > 0.6 else hidden

    bench.counts = counts
    error, done = pressed(bench, tmp_path, {"depths_mm": (bound_mm - 0.01,)})
    assert error is not None or len(done) == 2
    assert 1.0 < max(bench.depths) <= bound_mm + 0.02


@pytest.mark.parametrize("off_mm", [-2.0, 8.0, -8.0])
def test_a_surface_that_is_not_where_it_was_stated_is_refused(tmp_path, off_mm):
    bench = WithoutCell()
    error, _ = pressed(bench, tmp_path, middle_z_mm=TOP_MM + off_mm)
    assert re.search("--middle", error), error
    assert "The tip is up" in error
    assert max(bench.depths) < 2.0 - min(off_mm, 0.0) * (off_mm > -3)


def test_dead_chips_end_the_way_down_a_millimetre_below_the_stated_surface(tmp_path):
    bench = WithoutCell()
    level = np.round(820 * bench.silicone.field_mt(0.0, np.zeros(2)))
    bench.counts = lambda _: level + np.round(22 * bench.rng.standard_normal((3, 3)))
    error, _ = pressed(bench, tmp_path)
    assert "no chip sees a contact" in error
    assert max(bench.depths) == pytest.approx(1.0, abs=0.02)


def test_small_losses_of_steps_are_found_at_the_next_return_to_the_middle(tmp_path):
    bench = WithoutCell()
    lost = []

    def lose():
        if bench.pressing:
            lost.append(True)
        elif lost and bench.depth_mm < -2.0:
            lost.clear()
            bench.machine.shift = bench.machine.shift - np.array([0.0, 0.0, 0.2])

    bench.act = lose
    error, done = pressed(bench, tmp_path, presses=4, reference_every=2)
    assert "the reference place is touched at Z" in error
    assert len(done) == 3
    assert max(bench.depths) < 2.5


def test_the_bound_of_travel_holds_the_force_at_the_stiffest_silicone():
    law, silicone = contact_law(SPEC), SPEC.silicone
    stiffer = silicone.youngs_modulus_range_mpa[1] / silicone.youngs_modulus_mpa
    bound_mm = travel_bound_mm(SPEC, LIMIT_N)
    assert law.force_n(bound_mm, stiffer) == pytest.approx(LIMIT_N, rel=0.01)
    assert travel_bound_mm(SPEC, 1e4) == SPEC.press.depths_mm[-1]
    unknown = SPEC.changed(silicone=silicone.changed(youngs_modulus_range_mpa=None))
    assert travel_bound_mm(unknown, LIMIT_N) < bound_mm
    assert stops_of(SPEC, 10.0, by_travel=True)[-1] <= bound_mm < stops_of(SPEC, 10.0)[-1] + 0.5


@pytest.mark.parametrize(
    ("change", "settings", "words"),
    [
        ({}, {"depths_mm": (2.8,)}, "without a load cell presses end at"),
        ({"indenter": {"tip_count": 2}}, {}, "presses of one tip"),
    ],
)
def test_plans_without_a_bound_are_refused_before_anything_moves(tmp_path, change, settings, words):
    bench = WithoutCell()
    spec = ObjectSpec(name="cube", contact_grid=SPEC.contact_grid, **change)
    with (
        at_bench(bench, spec, SETTINGS | settings, tmp_path, by_travel=True) as (_, go, _journal),
        pytest.raises(InputError, match=words),
    ):
        go()
    assert bench.machine.lines == []
