"""`instobj adopt` as a user meets it: a log of others, what it shows, what is asked, what is written."""

import json

import numpy as np
import pytest

from tests.support.cli import run
from tests.support.recordings.foreign_logs import ForeignObject, make_log
from tests.support.recordings.public_recordings import FOLDER
from tests.support.recordings.travel_cases import PAD, pad_model, pressed_places, recorded
from tests.support.recordings.travel_cases import write_recording as write_folder

CUBE = FOLDER.parent / "instrumented-cube" / "Balanced.csv.gz"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    here = tmp_path_factory.mktemp("adopt")
    log = make_log(ForeignObject(), faces=(2,), shape=(4, 4), pitch=(10, 12), levels=3, rows=5)
    counts = log.counts.copy()
    counts[:100, 9] = 0
    np.savetxt(here / "log.csv", log.with_counts(counts).columns(), delimiter=",", fmt="%d")
    return here


def test_a_log_is_identified_in_few_lines_and_what_it_cannot_tell_is_asked(folder):
    done = run("adopt", "log.csv", cwd=folder)
    assert done.returncode == 0
    assert len(done.stdout.splitlines()) < 40
    for text in ("chips 10, rows 0-99", "chips under face 2: chips 4-6", "4 rows of 4", "step_mm"):
        assert text in done.stdout


def test_answers_leave_fewer_questions_and_json_holds_each_finding_with_its_null(folder):
    (folder / "known.toml").write_text("step_mm = 1.0\n")
    done = run(
        "adopt",
        "log.csv",
        "--known",
        "known.toml",
        "--known",
        "pitch_mm=[10,12]",
        "--json",
        cwd=folder,
    )
    found = json.loads(done.stdout)
    assert [question["answer"] for question in found["questions"]] == [
        "--spec my_object.toml (instobj new writes one)"
    ]
    assert found["adoption"]["chips_of_face"] == {"2": [4, 5, 6]}
    (order,) = found["adoption"]["orders_of_places"]
    assert order["p"] < 0.02 < order["null_median"]
    assert json.loads((folder / "runs" / "log" / "adoption.json").read_text()) == found["adoption"]


def test_a_log_without_labels_is_asked_for_them_and_not_fitted(folder):
    bare = np.loadtxt(folder / "log.csv", delimiter=",")[:, 3:]
    np.savetxt(folder / "bare.csv", bare, delimiter=",", fmt="%d")
    done = run("adopt", "bare.csv", "--spec", PAD, cwd=folder)
    assert done.returncode == 0
    for text in ("chips that answer: chips 4-6", "not fitted: no column says", "columns=face,"):
        assert text in done.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nothing.csv"], "no recording at nothing.csv"),
        (["log.csv", "--known", "colour=red"], "--known colour is not asked for"),
        (["log.csv", "--known", "step_mm=-1"], "step_mm must be a length in mm"),
        (["log.csv", "--known", "absent.toml"], "Give KEY=VALUE, or a TOML file"),
        (["log.csv", "--known", "label=colour"], "label=colour is no kind of label"),
        (["log.csv", "--known", "columns=face,chips"], "State the columns"),
        (["log.csv", "log.csv", "--spec", "absent.toml"], "absent.toml"),
    ],
)
def test_bad_input_ends_with_one_error_that_says_the_way_out(folder, words, message):
    done = run("adopt", *words, cwd=folder)
    assert done.returncode == 2
    assert message in done.stderr.replace("\n", " ")
    assert "Traceback" not in done.stderr


def test_without_a_specification_the_arrangement_is_said_to_need_one(folder):
    done = run("adopt", "log.csv", cwd=folder)
    assert done.returncode == 0
    text = " ".join(done.stdout.split())
    assert "arrangement, normal or reverse: in no log alone" in text
    assert "--spec FILE with the places of chips and magnets" in text


def test_a_specification_of_another_object_is_refused(folder):
    known = ("--known", "step_mm=1", "--known", "pitch_mm=[10,12]")
    done = run("adopt", "log.csv", *known, "--spec", PAD, cwd=folder)
    assert done.returncode == 2
    assert "3 chips answer under face 2" in done.stderr


def test_folders_of_known_travel_tell_the_order_of_their_chips(tmp_path):
    order = [3, 0, 4, 1, 2]
    field = recorded(pad_model(), pressed_places())
    write_folder(tmp_path / "press", pressed_places(), field[:, np.argsort(order)])
    done = run("adopt", "press", "--spec", PAD, cwd=tmp_path)
    assert done.returncode == 0
    assert "columns 4, 1, 5, 2, 3" in done.stdout
    assert "--spec" in run("adopt", "press", cwd=tmp_path).stderr


@pytest.mark.slow
@pytest.mark.skipif(not CUBE.exists(), reason=f"no recording at {CUBE}")
def test_the_second_instrumented_cube_follows_from_travel_alone(tmp_path):
    """Half of its places are held out; the fitted specification passes `instobj check`."""
    spec = PAD.parents[1] / "studies" / "instrumented_cube.toml"
    known = ("--known", "step_mm=1", "--known", "pitch_mm=[7.8,9.6]")
    done = run("adopt", CUBE, "--spec", spec, *known, "--json", cwd=tmp_path)
    found = json.loads(done.stdout)["adoption"]
    figures = found["fit"]["1"]
    assert figures["beyond 1 mm"]["cosine"] > 0.85
    assert figures["beyond 1 mm"]["explained"] > 0.7
    assert (
        figures["nulls, median and best"]["places exchanged"]["cosine"][1]
        < figures["all"]["cosine"] - 0.1
    )
    assert figures["order of chips"] == 1
    (arrangement,) = [one for one in found["findings"] if one["question"] == "arrangement"]
    assert arrangement["answer"].startswith("reverse")
    assert arrangement["p"] < 0.05
    written = "runs/Balanced/instrumented_cube_adopted.toml"
    assert run("check", written, cwd=tmp_path).returncode == 0
