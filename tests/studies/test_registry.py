"""Experiments by name: listed, run, written, and refused where there is none."""

import csv
import json

import pytest

from design.errors import InputError
from studies import registry
from studies.registry import Study, StudyResult, run_study, studies

ROWS = [{"variant": "a", "worst place mm": 1.5}, {"variant": "b", "worst place mm": 0.7}]


def made_up(spec, folder, quick):
    (folder / "figure.png").write_bytes(b"\x89PNG")
    return StudyResult(ROWS, [f"{spec.name}, seed {spec.seed}, quick: {quick}"])


@pytest.fixture
def _one_study(monkeypatch):
    study = Study("made-up", "Nothing.", made_up)
    monkeypatch.setattr(registry, "studies", lambda: {study.name: study})


@pytest.fixture
def spec_file(tmp_path):
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n')
    return path


@pytest.mark.usefixtures("_one_study")
def test_an_experiment_writes_its_table_and_what_it_made(tmp_path, spec_file):
    found = run_study("made-up", spec_file, tmp_path, True, ["seed=5"])
    folder = tmp_path / "runs" / "cube" / "experiments" / "made-up"
    rows = list(csv.DictReader((folder / "made-up.csv").read_text().splitlines()))
    assert [(row["variant"], float(row["worst place mm"])) for row in rows] == [
        ("a", 1.5),
        ("b", 0.7),
    ]
    stored = json.loads((folder / "made-up.json").read_text())
    assert (stored["spec"], stored["quick"], stored["rows"]) == ("cube", True, ROWS)
    assert found["texts"] == ["cube, seed 5, quick: True"]
    written = {row["path"] for row in found["files"]}
    assert written == {str(folder / f"made-up.{end}") for end in ("csv", "json")} | {
        str(folder / "figure.png")
    }


@pytest.mark.usefixtures("_one_study")
def test_an_unknown_experiment_is_refused_with_those_that_there_are(tmp_path, spec_file):
    with pytest.raises(InputError, match=r"no experiment is called 'other'. Choose one of made-up"):
        run_study("other", spec_file, tmp_path, False, [])
    assert not (tmp_path / "runs").exists()


def test_names_are_unique_and_explained():
    names = [study.name for study in studies().values()]
    assert len(names) == len(set(names)) > 5
    assert all(study.help.endswith(".") for study in studies().values())
