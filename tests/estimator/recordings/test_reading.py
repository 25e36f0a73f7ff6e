"""Recordings: every fault is planted in a file made here, found and corrected."""

import json
from dataclasses import asdict

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.frames.heatmap import force_heatmaps
from estimator.recordings.checks.faults import mirror_faults
from estimator.recordings.combine import combine
from estimator.recordings.reading import read_recording
from tests.support.physics_pages import assert_page, chosen
from tests.support.recordings.made_recordings import (
    PRESS,
    REST,
    gripper_arrays,
    write_gripper,
    write_training,
)


@pytest.fixture(scope="module")
def clean(tmp_path_factory):
    return read_recording(write_gripper(tmp_path_factory.mktemp("r") / "a.csv", gripper_arrays()))


def kinds(recording):
    return {fault.kind for fault in recording.report.faults}


def test_what_a_clean_file_holds(clean):
    """Labels 54 and 23 of face 3 are pixels (5, 6) and (2, 2), 57 and 28 of face 5 (5, 3), (2, 7)."""
    report = clean.report
    assert (report.presses, report.sessions, report.faces_pressed) == (6, 2, (3, 5))
    assert report.places == (
        ((3, -7.5, -7.5), (5, -7.5, 7.5)),
        ((3, 1.5, 4.5), (5, 1.5, -4.5)),
    )
    assert report.contact_frames + report.rest_frames + report.unused_frames == report.frames
    assert kinds(clean) == {"time stamps"}
    assert_allclose(report.frame_rate_hz, 10.5, rtol=0.01)


@pytest.mark.parametrize("lag", [0, 5])
def test_lag_is_estimated_and_corrected(tmp_path, lag):
    arrays = gripper_arrays(lag=lag)
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays))
    assert abs(recording.report.lag.frames - lag) <= (0 if lag else 1)
    assert recording.report.lag.share_within_2 == 1.0
    assert recording.frames.lag_frames == (lag if lag else 0)
    truth = arrays[1][lag : lag + 60, 0]
    shown = np.nan_to_num(recording.frames.force_n[:60, 0, 2])
    assert_allclose(shown[truth > 0.4], truth[truth > 0.4], atol=0.02)


def test_signals_are_changes_from_the_rest_before_each_press(clean):
    frames = clean.frames
    early_rest = np.arange(len(frames)) % PRESS < REST - 10
    mean = frames.signal_counts[early_rest].mean(axis=0)
    assert_allclose(mean, np.zeros((5, 3, 3)), atol=8)
    _, _, counts, _ = gripper_arrays()
    expected = counts.reshape(-1, 5, 3, 3) - clean.rest_counts[frames.press_id]
    assert_allclose(frames.signal_counts, expected, atol=1e-9)


def test_the_zero_comes_from_before_the_press(tmp_path):
    """A rest level that shifts by 150 counts during the first press."""
    arrays = gripper_arrays()
    shift = PRESS // 2
    arrays[2][shift:, 0, 0] += 150
    frames = read_recording(write_gripper(tmp_path / "a.csv", arrays)).frames
    shown = frames.signal_counts[:, 0, 0, 0]
    assert_allclose(shown[: REST // 2].mean(), 0, atol=15)
    assert_allclose(shown[PRESS - REST // 2 : PRESS].mean(), 150, atol=25)
    assert_allclose(shown[PRESS : PRESS + REST // 2].mean(), 0, atol=25)


def test_a_press_without_rest_before_it_is_zeroed_from_the_rest_after(tmp_path, clean):
    cut = [array[REST + 3 :] for array in gripper_arrays()]
    recording = read_recording(write_gripper(tmp_path / "a.csv", cut))
    assert recording.report.presses_zeroed_after == 1
    assert clean.report.presses_zeroed_after == 0
    assert_allclose(recording.rest_counts[0], clean.rest_counts[0], atol=25)


def test_contacts_lie_at_the_labelled_places(clean):
    frames = clean.frames
    chosen = frames.select((frames.session_id == 0) & (frames.contact_face[:, 0] == 3))
    assert_allclose(chosen.contact_xy_mm[:, 0], np.tile([1.5, 4.5], (len(chosen), 1)))
    assert force_heatmaps(chosen, 3)[:, 2, 5, 6].min() >= 0.3


def test_ambiguous_frames_are_not_valid(clean):
    force = np.nan_to_num(clean.frames.force_n[..., 2])
    valid = clean.frames.valid
    assert force[valid].max(axis=1)[clean.frames.place_id[valid] < 0].max() == 0
    assert np.all(np.sum(force[valid] > 0, axis=1) % 2 == 0)
    assert 0 < np.sum(~valid) < 0.3 * len(valid)


def test_time_axis_increases_and_keeps_pauses(clean):
    step = np.diff(clean.frames.time_s)
    assert step.min() > 0
    assert_allclose(np.median(step), 1 / 10.5, rtol=0.01)
    assert np.sum(step > 10) == 5


def test_a_press_is_not_cut_and_holds_its_rest(clean):
    frames = clean.frames
    assert_array_equal(np.bincount(frames.press_id), [PRESS] * 6)
    for press in range(6):
        mine = frames.valid & (frames.press_id == press)
        assert np.any(frames.place_id[mine] < 0)
        assert np.any(frames.place_id[mine] >= 0)


def test_two_presses_in_one_stretch_are_told_apart(tmp_path):
    time, force, counts, case = gripper_arrays()
    seamless = np.floor(1_700_000_000 + np.arange(len(time)) / 10.5)
    recording = read_recording(write_gripper(tmp_path / "a.csv", (seamless, force, counts, case)))
    assert recording.report.presses == 6
    step = np.bincount(recording.frames.press_id)
    assert abs(step - PRESS).max() <= 12


def test_dead_channel(tmp_path):
    arrays = gripper_arrays()
    arrays[2][:, 3, 6:] = np.nan
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays))
    dead = {f.where for f in recording.report.faults if f.kind == "dead channel"}
    assert dead == {"F4-X3", "F4-Y3", "F4-Z3"}
    alive = np.isfinite(recording.frames.signal_counts).all(axis=0)
    assert alive.sum() == 42
    assert not alive[3, 2].any()


def test_noisy_channel(tmp_path):
    arrays = gripper_arrays()
    arrays[2][:, 1, 1] += np.round(np.random.default_rng(5).normal(0, 100, len(arrays[0])))
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays))
    assert [f.where for f in recording.report.faults if f.kind == "noisy channel"] == ["F2-Y1"]
    assert recording.report.noise_counts["F2-Y1"] == pytest.approx(102, rel=0.15)
    assert_allclose(recording.frames.noise_counts, [20, 20, 20], rtol=0.1)


@pytest.mark.parametrize("cell", [0, 1])
def test_wrong_face_label(tmp_path, cell):
    arrays = gripper_arrays()
    faces = np.tile([3, 5], (len(arrays[0]), 1))
    faces[PRESS : 2 * PRESS, cell] = (5, 3)[cell]
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays, faces=faces))
    fault = next(f for f in recording.report.faults if f.kind == "wrong face label")
    assert fault.where == f"rows {PRESS}–{2 * PRESS - 1}"
    assert recording.report.sessions == 2
    straight = read_recording(write_gripper(tmp_path / "b.csv", arrays))
    assert_array_equal(recording.frames.contact_face, straight.frames.contact_face)


def test_wrong_face_label_in_the_whole_file_is_found_by_the_response(tmp_path):
    arrays = gripper_arrays()
    faces = np.full((len(arrays[0]), 2), 3)
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays, faces=faces))
    assert recording.report.faces_pressed == (3, 5)


@pytest.mark.parametrize("number", [0, 1])
def test_label_of_a_face_that_does_not_respond_is_doubted(tmp_path, number):
    arrays = gripper_arrays()
    faces = np.tile([3, 5], (len(arrays[0]), 1))
    doubted = slice(number * PRESS, (number + 1) * PRESS)
    faces[doubted, 1] = 1
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays, faces=faces))
    assert "doubtful face label" in kinds(recording)
    assert not recording.frames.valid[doubted].any()
    assert np.delete(recording.frames.valid, doubted).any()


def test_labels_that_are_not_opposite(tmp_path):
    """Label 54 is (5, 6) on face 3; opposite on face 5 is (5, 3), label 57."""
    cases = ((54, 54), (23, 28))
    recording = read_recording(write_gripper(tmp_path / "a.csv", gripper_arrays(cases), cases))
    assert "labels not opposite" in kinds(recording)


def test_probes_of_three_tips_are_opposite_by_their_centres():
    """A triangle mirrored and turned by 180° lies 8.7 mm off tip by tip, and about one centre."""
    triangle = 5.0 * np.array([[0.0, 1.0], [-np.sqrt(0.75), -0.5], [np.sqrt(0.75), -0.5]])
    face, block, middle = np.array([[3, 5]]), np.array([0]), np.array([2.0, 3.0])
    for away_mm, kept in ((0.0, True), (5.0, True), (7.0, False)):
        there = middle * (1, -1) + np.array([away_mm, 0.0])
        tips = np.stack([triangle + middle, there - triangle])
        assert (mirror_faults(face, tips[None], block) == []) == kept


def test_two_tips_share_the_force(tmp_path):
    cases = (((35, 86), (38, 83)), ((22, 79), (8, 53)))
    recording = read_recording(write_gripper(tmp_path / "a.csv", gripper_arrays(cases), cases))
    frames = recording.frames
    assert frames.contact_face.shape[1] == 4
    assert "duplicate column names" in kinds(recording)
    loaded = frames.valid & (frames.place_id >= 0)
    assert_allclose(frames.force_n[loaded, 0, 2], frames.force_n[loaded, 1, 2])
    peak = frames.force_n[frames.session_id == 0][:, :2, 2].sum(axis=1)
    assert_allclose(np.nanmax(peak), 17.0, atol=0.02)


def test_a_missing_reading_spoils_its_frame_alone(tmp_path):
    arrays = gripper_arrays()
    arrays[2][50, 2, 3] = np.nan
    recording = read_recording(write_gripper(tmp_path / "a.csv", arrays))
    assert not recording.frames.valid[50]
    assert recording.frames.valid[51]


def test_report_is_printable_and_json(clean):
    text = str(clean.report)
    assert "force lag: 8 frames (corrected)" in text
    assert "grams-force" in text
    assert json.loads(json.dumps(asdict(clean.report)))["lag"]["frames"] == 8


def test_combine_recognises_the_same_place_in_two_files(clean, tmp_path):
    other = read_recording(write_gripper(tmp_path / "b.csv", gripper_arrays(noise=21)))
    both = combine([clean, other])
    assert set(np.unique(both.place_id)) == {-1, 0, 1}


@pytest.mark.parametrize(("sign", "offset", "rest_case"), [(-1.0, 5.0, True), (1.0, -2.0, False)])
def test_training_file(tmp_path, sign, offset, rest_case):
    labels = {34: (34,), 77: (77,)} | ({0: (0,)} if rest_case else {})
    path = write_training(tmp_path / "t.csv", labels, sign=sign, offset=offset)
    recording = read_recording(path)
    frames = recording.frames
    assert recording.report.kind == "training"
    assert recording.report.presses == 8
    assert frames.lag_frames == 0
    assert_allclose(np.nanmax(frames.force_n), 12.0, atol=0.15)
    assert np.isnan(frames.signal_counts[:, [0, 2, 3, 4]]).all()
    assert np.isfinite(frames.signal_counts[:, 1]).all()
    chosen = frames.select(frames.session_id == 0)
    pixel = np.argwhere(force_heatmaps(chosen, 2)[:, 2].sum(axis=0) > 0)
    assert pixel.tolist() == [[3, 6]]


@pytest.mark.parametrize("places", [{1: (35, 86), 2: (12, 63)}, {1: (35, 50, 86), 2: (1, 3, 60)}])
def test_training_file_of_several_tips(tmp_path, places):
    recording = read_recording(write_training(tmp_path / "t.csv", places))
    assert recording.report.tips == len(places[1])
    maps = force_heatmaps(recording.frames, 2)[:, 2]
    loaded = recording.frames.valid & (recording.frames.place_id >= 0)
    assert_array_equal(np.sum(maps[loaded] > 0, axis=(1, 2)), len(places[1]))


def of_recording(recording):
    frames = recording.frames
    return [
        *chosen(frames, "signal_counts", "force_n", "contact_face", "valid", "press_id", "time_s"),
        *chosen(frames, "noise_counts", "lag_frames"),
        ("rest (counts)", recording.rest_counts),
    ]


def test_a_clean_recording_is_as_on_the_page(clean):
    assert_page("estimator/recordings", of_recording(clean), "clean, ")


def test_a_damaged_recording_is_as_on_the_page(tmp_path):
    """A dead, a noisy and a jumping channel, a wrong face, and few frames at rest."""
    time, force, counts, case = gripper_arrays(presses=4, lag=5, seed=3)
    rng = np.random.default_rng(1)
    counts[:, 1, 4] = 17
    counts[:, 2, 3] += np.round(rng.normal(0, 150, len(counts)))
    counts[len(counts) // 2 :, 4, 0] += 900
    path = write_gripper(tmp_path / "a.csv", (time, force, counts, case))
    assert_page("estimator/recordings", of_recording(read_recording(path)), "damaged, ")
