"""Recordings that a machine labelled by its travel: forces by mechanics, held against simulated truth."""

import csv
import json
import tomllib

import numpy as np
import pytest

from design.errors import InputError, RecordingError
from design.layout.places.contact_grid import PlaceGrid
from design.spec_io import load_spec, with_overrides
from design.tables import toml_text
from estimator.frames.dataset import load_frames
from estimator.frames.press_protocol import simulate_presses
from estimator.recordings.combine import combine
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording
from estimator.recordings.travel_labels import TravelForces
from estimator.signals.interpolation import depth_at_force, press_traces
from fem.presses.results import PressForces
from instobj.bench.live.source import data_set_table
from instobj.commands.training import travel_forces
from instobj.stages.run import Run
from instobj.store.readers import SIGNALS
from tests.support.cli import run
from tests.support.objects.tiny_cube import CHANGES, SMALL_CUBE, lend_mechanics
from tests.support.recordings.generic_csv import write_generic_csv

STIFFER = 1.2
"""Modulus of the true object over its specification's, which says 0.36 to 1.30."""
EXACT = [
    "protocol.lateral_jitter_mm=0.0",
    "protocol.force_noise_n=0.0",
    "protocol.presses_per_place=8",
]
COEFFICIENT = 2.5
"""N per mm to the power 3/2: the law of a sphere on a half space (Hertz)."""


def done(*arguments, cwd):
    found = run(*arguments, cwd=cwd)
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    """The small cube pressed at its places: the same presses labelled by force and by travel."""
    folder = tmp_path_factory.mktemp("travel")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INSTOBJ_STORE", str(folder / "store"))
        lend_mechanics(folder / "store")
        content = with_overrides(tomllib.loads(SMALL_CUBE.read_text()), [*CHANGES, *EXACT])
        (folder / "cube.toml").write_text(toml_text(content))
        spec = load_spec(folder / "cube.toml")
        signals = Run(spec).read(SIGNALS)
        frames = simulate_presses(spec, signals, "made")
        table = data_set_table(frames)
        touched = np.flatnonzero(table.face[:, 0] > 0)
        traces = press_traces(signals, table.face[touched, 0], *table.tip_xy_mm[touched, 0, 0].T)
        travel = np.zeros(len(frames))
        travel[touched] = depth_at_force(traces, table.force_n[touched])[:, 0]
        table.force_n[:] *= STIFFER
        write_generic_csv(table, folder / "force.csv")
        relabelled(folder / "force.csv", folder / "travel.csv", "travel_mm", travel)
        relabelled(folder / "force.csv", folder / "level.csv", "level_0.5_mm", travel / 0.5)
        yield folder


def relabelled(source, target, name, values):
    """The recording with a machine's label in place of the load cell's."""
    rows = list(csv.reader(source.open()))
    force = rows[0].index("cell1_force_n")
    with target.open("w", newline="") as file:
        for row, value in zip(rows, [name, *values], strict=True):
            csv.writer(file).writerow([*row[:force], *row[force + 1 :], value])


def of_few_places(source, target):
    """The recording without the presses at six of its nine places."""
    rows = list(csv.reader(source.open()))
    x, y = (rows[0].index(f"cell1_{axis}1_mm") for axis in "xy")
    few = sorted({(row[x], row[y]) for row in rows[1:]})[:4]  # rest, and three places
    with target.open("w", newline="") as file:
        csv.writer(file).writerows([rows[0], *(row for row in rows[1:] if (row[x], row[y]) in few)])


def forces_of(folder, name):
    done("recordings", f"{name}.csv", "--spec", "cube.toml", "--json", cwd=folder)
    return load_frames(folder / "runs" / name / "frames.nc")


def test_forces_of_travel_hold_the_true_ones_within_the_interval_of_the_modulus(bench):
    measured, told = forces_of(bench, "force"), forces_of(bench, "travel")
    both = (measured.contact_face[:, 0] > 0) & (told.contact_face[:, 0] > 0)
    assert both.sum() > 0.8 * (measured.contact_face[:, 0] > 0).sum()
    true_n, given_n = measured.force_n[both, 0, 2], told.force_n[both, 0, 2]
    np.testing.assert_allclose(given_n, true_n / STIFFER, rtol=0.02, atol=0.02)
    low, high = told.force_factors
    silicone = load_spec(bench / "cube.toml").silicone
    ends = np.array(silicone.youngs_modulus_range_mpa) / silicone.youngs_modulus_mpa
    np.testing.assert_allclose((low, high), ends)
    assert (low * given_n < true_n).all()
    assert (true_n < high * given_n).all()
    assert (measured.travel_mm, measured.force_factors) == (None, None)


def test_levels_are_travel_in_steps_that_the_column_names(bench):
    told, levels = forces_of(bench, "travel"), forces_of(bench, "level")
    np.testing.assert_allclose(levels.travel_mm, told.travel_mm, atol=1e-9)
    np.testing.assert_allclose(levels.force_n, told.force_n, atol=1e-9)


def test_a_data_set_labelled_by_travel_trains_and_is_judged_in_mm_and_in_newtons(bench):
    forces_of(bench, "travel")
    tiny = ["training.epochs=40", "training.hidden_units=[16, 16]", "training.ensemble=1"]
    tiny += ["training.trees=0", "training.process=false"]
    sets = [f"--set={setting}" for setting in tiny]
    found = done("train", "runs/travel/frames.nc", *sets, "--json", cwd=bench)
    tables = found["objects"][0]["summary"]
    ((row,),) = (rows for title, rows in tables.items() if title.startswith("labels of travel"))
    metrics = json.loads((bench / "runs/travel/metrics.json").read_text())
    (errors,) = metrics["travel"]
    assert row["travel mm"] == pytest.approx(errors["mean_travel_error_mm"])
    told = load_frames(bench / "runs/travel/frames.nc")
    assert (row["low ×"], row["high ×"]) == pytest.approx(tuple(told.force_factors))
    spread_mm = float(np.std(told.travel_mm[told.contact_face[:, 0] > 0]))
    assert 0 < errors["mean_travel_error_mm"] < spread_mm


def test_a_twin_adds_presses_to_those_labelled_by_travel(bench):
    """Judged in mm of travel on presses held out, as without the twin."""
    forces_of(bench, "travel")
    tiny = ["training.epochs=20", "training.hidden_units=[16, 16]", "training.ensemble=1"]
    tiny += ["training.trees=0", "training.process=false"]
    sets = [f"--set={setting}" for setting in tiny]
    twin = ["--twin", "cube.toml"]
    trained = done("train", "runs/travel/frames.nc", *twin, *sets, "--json", cwd=bench)
    tables = trained["objects"][0]["summary"]
    ((row,),) = (rows for title, rows in tables.items() if title.startswith("labels of travel"))
    told = load_frames(bench / "runs/travel/frames.nc")
    spread_mm = float(np.std(told.travel_mm[told.contact_face[:, 0] > 0]))
    assert 0 < row["travel mm"] < spread_mm
    assert (row["low ×"], row["high ×"]) == pytest.approx(tuple(told.force_factors))


def test_validation_takes_travel_for_what_it_is(bench):
    """Motions at a travel do not depend on the modulus: agreement as good as with the true forces' ratio."""
    of_few_places(bench / "travel.csv", bench / "few.csv")
    document = done("validate", "cube.toml", "few.csv", "--json", cwd=bench)
    assert "tells nothing about the silicone" in document["texts"][0]
    face = document["validation"]["agreement"][0]
    assert face["cosine"]["value"] > 0.98
    assert face["size_ratio"] == pytest.approx(1.0, abs=0.05)


def test_the_self_test_reads_the_rest_of_presses_labelled_by_travel(bench):
    self_tests = [
        run("bench", "selftest", "cube.toml", f"{name}.csv", "--json", cwd=bench)
        for name in ("travel", "force")
    ]
    by_travel, by_force = (json.loads(test.stdout)["frames"] for test in self_tests)
    assert by_travel == pytest.approx(by_force, rel=0.1)


def test_labels_of_travel_need_mechanics_and_stay_apart_from_forces(bench):
    with pytest.raises(RecordingError, match=r"machine's travel and no force\. Give --spec"):
        read_recording(bench / "travel.csv")
    spec = load_spec(bench / "cube.toml")
    grid = np.array([-6.0, 0.0, 6.0])
    mechanics = hertz(spec.press.depths_mm)
    pair = [
        read_recording(bench / f"{name}.csv", (grid, grid), mechanics=mechanics)
        for name in ("force", "travel")
    ]
    with pytest.raises(InputError, match="1 of 2 recordings are labelled by travel"):
        combine(pair)


def test_the_netcdf_of_a_travel_recording_is_the_same_recording(bench, tmp_path):
    table = read_table(bench / "travel.csv")
    write_generic_netcdf(table, tmp_path / "travel.nc")
    again = read_table(tmp_path / "travel.nc")
    assert again.labelled_by_travel
    assert again.digest == table.digest
    np.testing.assert_array_equal(again.travel_mm, table.travel_mm)


def test_the_mechanics_of_a_specification_say_what_its_sensors_answer(bench):
    """Presses at a node of the lattice, at the force of a simulated depth and beyond the deepest."""
    spec = load_spec(bench / "cube.toml")
    signals, mechanics = Run(spec).read(SIGNALS), travel_forces(spec)
    node = int(np.argmin(np.abs(signals.lattice.xy_mm).sum(axis=1)))
    faces, sensors = len(signals.faces), len(signals.baseline_counts) // len(signals.faces)
    forces_n = np.array([signals.force_n[0, node, 1], 2 * signals.force_n[0, node, -1]])
    places_mm = np.tile(signals.lattice.xy_mm[node], (2, 1))
    changes = mechanics.signal_changes(np.full(2, signals.faces[0]), places_mm, forces_n)
    expected = signals.delta_counts[0, node, [1, -1]].reshape(2, faces, sensors, 3)
    np.testing.assert_allclose(changes[:, signals.faces - 1], expected, atol=1e-6)
    assert mechanics.places_mm(int(signals.faces[0])).tolist() == signals.lattice.xy_mm.tolist()
    assert mechanics.signal_changes(np.ones(1, int), np.full((1, 2), 99.0), forces_n[:1]) is None


def hertz(depths_mm, spread=(0.5, 2.0)):
    """Mechanics of a half space under a sphere, the same at every place of face 1."""
    depth, line = np.array(depths_mm), np.linspace(-12.0, 12.0, 9)
    force = np.broadcast_to(COEFFICIENT * depth**1.5, (1, 81, len(depth))).copy()
    forces = PressForces(np.array([1]), PlaceGrid(line, line), depth, force, 0 * force)
    return TravelForces(lambda: forces, np.array(spread))


def test_the_force_at_a_travel_is_that_of_the_law():
    travel = np.array([0.3, 0.8, 1.7, 2.0])
    xy = np.array([[0.0, 0.0], [3.0, -4.0], [-11.0, 11.0], [6.0, 1.0]])
    found = hertz((0.5, 1.0, 1.5, 2.0)).press_forces(np.ones(4, int), xy, travel)
    np.testing.assert_allclose(found, COEFFICIENT * travel**1.5, rtol=1e-6)


def test_a_machine_s_last_step_is_the_deepest_press_still():
    ends = hertz((1.0, 2.0)).press_forces(np.ones(2, int), np.zeros((2, 2)), np.array([2.0, 2.01]))
    assert ends[0] == ends[1] == pytest.approx(COEFFICIENT * 2.0**1.5)


def test_a_travel_beyond_the_simulated_presses_is_refused():
    with pytest.raises(RecordingError, match=r"reach 2.5 mm.*press.depths_mm"):
        hertz((1.0, 2.0)).press_forces(np.ones(1, int), np.zeros((1, 2)), np.array([2.5]))


@pytest.mark.parametrize(
    ("column", "value", "words"),
    [("travel_mm", "", "its travel is missing"), ("cell1_face", "", "a place")],
)
def test_half_a_label_is_refused(bench, tmp_path, column, value, words):
    rows = list(csv.reader((bench / "travel.csv").open()))
    face = rows[0].index("cell1_face")
    first = next(k for k, row in enumerate(rows[1:], 1) if row[face])
    rows[first][rows[0].index(column)] = value
    with (tmp_path / "half.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    with pytest.raises(RecordingError, match=words):
        read_recording(tmp_path / "half.csv", mechanics=hertz((1.0, 2.0)))
