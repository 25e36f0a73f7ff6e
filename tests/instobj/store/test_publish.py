"""Names of results: data sets of one name in several runs, and beside a run's own files."""

from pathlib import Path
from typing import get_args

import pytest

from design.spec.learning import CollectionKind
from instobj.store.publish import run_folder, run_name


@pytest.mark.parametrize(
    ("data_set", "name"),
    [
        ("runs/cube/frames.nc", "cube"),
        ("runs/cube/frames_grasp.nc", "cube/grasp"),
        ("runs/puck/frames_grasp.nc", "puck/grasp"),
        ("runs/cube/frames_of_monday.nc", "frames_of_monday"),
        ("data/frames_grasp.csv", "frames_grasp"),
        ("data/monday.nc", "monday"),
    ],
)
def test_a_data_set_s_results_are_named_after_it(data_set, name):
    assert run_name(Path(data_set)) == name


def test_simulated_recordings_of_two_objects_and_their_runs_have_folders_of_their_own():
    kinds = [f"frames_{kind}.nc" for kind in get_args(CollectionKind)]
    data_sets = [Path("runs") / run / file for run in ("a", "b") for file in ("frames.nc", *kinds)]
    folders = {run_folder(Path(), run_name(path)) for path in data_sets}
    assert len(folders) == len(data_sets)
