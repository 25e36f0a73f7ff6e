"""What `python -m studies interfaces` says of its p values."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from estimator.recordings.formats.files import read_table
from instobj.stages.run import Run
from studies.loose_core import response
from studies.recorded import interface_fits as compared
from studies.recorded.interface_fits import Preference
from studies.recorded.interfaces import _preference_row, _text, interfaces_on
from tests.support.recordings.generic_csv import write_generic_csv
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper


@pytest.mark.parametrize(
    ("p_places", "p_cases", "tried", "said"),
    [
        (0.011, 0.008, 4, "preferred to bonded"),
        (0.016, 0.03, 1, "preferred to bonded"),
        (0.016, 0.03, 4, "not told from bonded"),
        (0.4, 0.001, 4, "not told from bonded"),
    ],
)
def test_an_interface_is_preferred_by_p_corrected_for_those_tried(p_places, p_cases, tried, said):
    one = Preference("friction", "bonded", 0.06, 0.02, p_places, p_cases, 7, 8)
    assert said in _text(one, tried)
    row = _preference_row(one, tried)
    assert row["p, corrected"] == pytest.approx(min(1, tried * max(p_places, p_cases)))


def test_sensors_without_columns_are_told_and_left_out(tmp_path, monkeypatch):
    """Recordings without the third sensors of face 3; what the mechanics would say is made up."""
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    table = read_table(write_gripper(tmp_path / "own.csv", gripper_arrays(presses=1)))
    counts = table.counts.copy()
    counts[:, 2, 2] = np.nan
    write_generic_csv(replace(table, counts=counts), tmp_path / "less.csv")
    given = []

    def agreement(spec, shell, presses, name, core):
        given.append(presses)
        ones = np.ones((len(presses), len(presses.cases)))
        return compared.InterfaceAgreement(name, (), ones, 1.0, 1.0)

    monkeypatch.setattr(compared, "interface_agreement", agreement)
    monkeypatch.setattr(response, "loose_shell", lambda mesh, spec: SimpleNamespace())
    monkeypatch.setattr(Run, "read", lambda run, stage: None)
    found = interfaces_on(tmp_path / "cube.toml", [tmp_path / "less.csv"], tmp_path, [])
    assert (
        "left out of all figures: sensor 3 of face 3; judged on the other 14 of 15"
        in (found["texts"][0])
    )
    assert found["interfaces"]["sensors_not_recorded"] == [(3, 3)]
    silent = np.isnan(given[0].signal_counts).all(axis=0)
    assert np.flatnonzero(silent).tolist() == [24, 25, 26]
