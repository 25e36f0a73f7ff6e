"""Training on a data set with presses of the object's calibrated twin beside it."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from estimator.calibration.twin import inverted_twin
from estimator.frames.dataset import save_frames
from estimator.frames.press_protocol import simulate_presses
from estimator.frames.splits import split_presses
from estimator.networks.face_model import load_model, predict
from estimator.signals.nuisances import ambient_field
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from instobj.commands import training
from instobj.commands.run import run_estimator
from instobj.commands.training import twin_of_data
from instobj.report.summary import summarize
from instobj.stages.makers import learning
from instobj.stages.makers.twin import (
    TwinOfData,
    require_same_object,
    verdict,
)
from instobj.store.content import StoredResult
from instobj.store.publish import run_folder
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

FACE = 3
SPEC = coarse_spec(
    seed=5,
    contact_grid={"count": (4, 4), "pitch_mm": 6.0},
    protocol={
        "presses_per_place": 6,
        "frames_per_press": (3, 12),
        "peak_force_n": (6.0, 9.0),
    },
)
SETTINGS = ["training.epochs=3", "training.hidden_units=[16, 16]", "seed=2"]
LONGER = ["training.epochs=30", *SETTINGS[1:]]


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def frames(presses):
    """Presses of an object of its own at every place but those of the last row."""
    signals = twin_signals(SPEC, drawn_assembly(SPEC, 77), *presses)
    frames = simulate_presses(SPEC, signals, "object")
    on_face = np.isin(frames.press_id, frames.press_id[frames.contact_face[:, 0] == FACE])
    return frames.select(on_face & (frames.place_id % 1000 < 12))


@pytest.fixture
def twin(presses):
    return TwinOfData(SPEC, presses, "synthetic", 5)


@pytest.fixture(scope="module")
def parts(frames):
    split = split_presses(frames, 1)
    return frames.select(split.train), frames.select(split.validation)


@pytest.fixture(scope="module")
def calibrated(presses, frames, parts):
    """A twin that was asked for a face with too few places, then for one with enough; what it added."""
    twin = TwinOfData(SPEC, presses, "synthetic", 5)
    few = frames.select(frames.place_id % 1000 < 2)
    twin.extended((few, few), FACE, lambda text: None)
    return twin, twin.extended(parts, FACE, lambda text: None)


def test_presses_at_every_place_join_both_parts(parts, calibrated):
    twin, (train, validation) = calibrated
    assert validation is parts[1]
    np.testing.assert_array_equal(train.signal_counts[: len(parts[0])], parts[0].signal_counts)
    places = np.unique(train.place_id[train.place_id >= 0])
    assert places.tolist() == [3000 + place for place in range(16)]
    drawn = set(train.press_id[len(parts[0]) :])
    assert not drawn & (set(parts[0].press_id) | set(validation.press_id))
    row = twin.rows[1]
    assert row["places"] == 12
    assert row["signals left %, places left out"] < 0.5 * row["signals left %, design"]
    assert row["helps"] == "yes"
    assert len(row["places mm"]) == len(row["left %"]) == len(row["left by design %"]) == 12


def test_the_command_writes_models_and_what_was_calibrated(
    frames, calibrated, tmp_path, monkeypatch
):
    twin, joined = calibrated
    monkeypatch.setattr(TwinOfData, "extended", lambda *given: joined)
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    monkeypatch.setattr(training, "twin_of_data", lambda *given: twin)
    save_frames(frames, tmp_path / "cube.nc")
    plain = run_estimator([tmp_path / "cube.nc"], ("networks",), tmp_path, SETTINGS)
    beside = run_folder(tmp_path, "cube") / "face_3.safetensors"
    written = beside.read_bytes()
    found = run_estimator(
        [tmp_path / "cube.nc"], ("networks",), tmp_path, SETTINGS, tmp_path / "cube.toml"
    )
    target = run_folder(tmp_path, "cube") / "twin"
    assert beside.read_bytes() == written
    assert not beside.with_name("calibration.json").exists()
    assert (plain["objects"][0]["name"], found["objects"][0]["name"]) == ("cube", "cube/twin")
    assert (target / "face_3.safetensors").is_file()
    assert (target / "calibration.png").stat().st_size > 5000
    _, row = json.loads((target / "calibration.json").read_text())["faces"]
    _, shown = found["objects"][0]["summary"]["calibrated twin (medians over labelled places)"]
    assert shown["signals left %, design"] == row["signals left %, design"] > 0
    assert shown["face"] == FACE
    wider = load_model(target / "face_3.safetensors").network.state_dict()
    alone = load_model(beside).network.state_dict()
    assert not all(wider[name].equal(alone[name]) for name in wider)
    assert "calibrated twin (medians over labelled places)" not in plain["objects"][0]["summary"]
    monkeypatch.setattr(learning, "train_networks", None)
    run_estimator([tmp_path / "cube.nc"], ("networks",), tmp_path, SETTINGS)


def test_a_twin_s_networks_know_that_the_object_is_turned(
    frames, calibrated, tmp_path, monkeypatch
):
    """Forces that they read change less as the field turns, where the specification's use is no bench."""
    monkeypatch.setattr(TwinOfData, "extended", lambda *given: calibrated[1])
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    save_frames(frames, tmp_path / "cube.nc")
    columns = ambient_field(SPEC).columns
    unknowns = np.random.default_rng(6).standard_normal((len(frames), columns.shape[1]))
    turning = (unknowns @ columns.T).reshape(frames.signal_counts.shape)
    turned = replace(frames, signal_counts=frames.signal_counts + turning)
    changed_n = {}
    for use in ("bench", "grasp"):
        twin = replace(calibrated[0], spec=SPEC.changed(limits=SPEC.limits.changed(use=use)))
        monkeypatch.setattr(training, "twin_of_data", lambda *given, made=twin: made)
        given = [tmp_path / "cube.nc"], ("networks",), tmp_path / use, LONGER
        run_estimator(*given, tmp_path / "cube.toml")
        model = load_model(run_folder(tmp_path / use, "cube") / "twin" / f"face_{FACE}.safetensors")
        still, moved = (predict(model, each).force_n for each in (frames, turned))
        changed_n[use] = np.median(np.abs(moved - still))
    assert changed_n["grasp"] < 0.7 * changed_n["bench"]


def test_a_face_without_a_twin_stands_in_the_table(calibrated, tmp_path):
    """Before one that has."""
    calibrated[0].write(tmp_path)
    rows = summarize({"networks": StoredResult("networks", "", tmp_path, True, 0.0, "")})
    without, calibrated = rows["calibrated twin (medians over labelled places)"]
    assert without.keys() == calibrated.keys()
    assert (without["places"], without["signals left %, design"]) == (0, None)
    assert without["helps"].startswith("not used: ")
    assert calibrated["helps"] == "yes"
    assert (tmp_path / "calibration.png").is_file()


@pytest.mark.parametrize(
    ("numbers", "said"),
    [
        ((4.0, 20.0, 0), "yes"),
        (
            (2.5, 2.4, 0),
            "yes: the object is as drawn within 2.4 % of its signals (calibrated within 2.5 %",
        ),
        ((0.0, 0.0, 0), "yes: the object is as drawn within 2 % of its signals"),
        ((5.9, 4.5, 0), "yes: the object is as drawn within 4.5 %"),
        ((10.1, 9.0, 0), "no: train without"),
        ((30.0, 2.5, 0), "no: train without"),
        ((11.0, 40.0, 0), "no: train without"),
        ((6.0, 8.0, 0), "no: train without"),
        ((4.0, 20.0, 2), "no: 2 numbers at their limits"),
    ],
)
def test_the_verdict_on_a_twin(numbers, said):
    assert verdict(*numbers).startswith(said)


@pytest.mark.slow
def test_a_foreign_object_is_not_explained(frames, twin):
    """Places exchanged: no object within tolerances gives such signals."""
    wrong = frames.select(np.arange(len(frames)))
    pressed = wrong.contact_face[:, 0] == FACE
    wrong.contact_xy_mm[pressed, 0] = np.roll(
        np.unique(wrong.contact_xy_mm[pressed, 0], axis=0), 5, 0
    )[wrong.place_id[pressed] % 1000]
    split = split_presses(wrong, 1)
    twin.extended(
        (wrong.select(split.train), wrong.select(split.validation)), FACE, lambda text: None
    )
    assert twin.rows[0]["helps"].startswith("no: ")


def test_an_inverted_twin_reads_with_the_recording_s_noise(frames, twin, monkeypatch):
    asked = []
    monkeypatch.setattr(inverted_twin, "inverted_twin", lambda *args: asked.append(args[-1]))
    monkeypatch.setattr(twin, "calibrated", lambda *_: (None, 0.03))
    recorded = replace(frames, source="recorded", noise_counts=np.array([3.0, np.nan, 70.0]))
    for known in (recorded, frames):
        twin.inverted(known, lambda _: None)
    own = SPEC.sensors.noise_counts
    np.testing.assert_allclose(asked, [[3.0, own[1], 70.0], own])


def test_what_a_twin_does_not_serve_is_told_before_anything_is_simulated(frames, twin, tmp_path):
    other = coarse_spec(contact_grid={"count": (5, 4), "pitch_mm": 5.0})
    with pytest.raises(InputError, match=r"4 × 4 contact locations .* 5 × 4"):
        require_same_object(other, frames)
    few = frames.select(frames.place_id % 1000 < 2)
    assert twin.extended((few, few), FACE, lambda text: None) == (few, few)
    assert "Press more places one by one" in twin.rows[-1]["helps"]
    path = tmp_path / "object.toml"
    path.write_text('name = "synthetic"\n[contact_grid]\ncount = [4, 4]\npitch_mm = 6.0\n')
    with pytest.raises(InputError, match="Press more places one by one"):
        twin_of_data(path, few, SPEC.training)
    for name, value in (("history_frames", 9), ("ensemble", 2), ("model", "whole-object")):
        asked = SPEC.training.model_copy(update={name: value})
        with pytest.raises(InputError, match=f"--twin serves .* training.{name} = "):
            twin_of_data(path, frames, asked)
    with pytest.raises(InputError, match="--twin is for data sets"):
        run_estimator([Path("a.toml")], ("networks",), Path(), [], Path("a.toml"))
