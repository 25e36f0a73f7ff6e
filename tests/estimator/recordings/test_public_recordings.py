"""The two public gripper recordings: faults known to be in them, and an estimator trained on them.

They are not part of the project; without them these tests skip.
"""

import numpy as np
import pytest

from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import (
    evaluate_face,
)
from estimator.frames.heatmap import faces_pressed
from estimator.frames.splits import split_presses
from estimator.networks.training.face import FitSettings, fit_estimator
from estimator.recordings.combine import combine, jumps_between
from estimator.recordings.reading import read_recording
from studies.paper.heatmap_baselines import linear_baseline, mean_map_baseline
from studies.recorded.rest_offset import rest_offset_baseline
from tests.support.recordings.public_recordings import FOLDER, NAMES

pytestmark = pytest.mark.skipif(
    not all((FOLDER / name).is_file() for name in NAMES),
    reason=f"public recordings not found in {FOLDER}; set INSTOBJ_DATA to their folder",
)


@pytest.fixture(scope="module")
def recordings():
    return [read_recording(FOLDER / name) for name in NAMES]


def test_counts_of_presses_and_cases(recordings):
    one, two = (recording.report for recording in recordings)
    assert (one.frames, one.presses, one.sessions, len(one.places)) == (3941, 25, 5, 5)
    assert (two.frames, two.presses, two.sessions, len(two.places)) == (2336, 17, 3, 3)
    assert one.faces_pressed == two.faces_pressed == (3, 5)
    assert (one.tips, two.tips) == (1, 2)


def test_the_force_lags_by_eight_frames(recordings):
    for recording in recordings:
        lag = recording.report.lag
        assert lag.frames == 8
        assert lag.corrected
        assert lag.share_within_2 >= 0.8
        assert lag.residual_corrected < 0.3 * lag.residual_uncorrected


def test_faults_of_the_second_file(recordings):
    found = {(fault.kind, fault.where) for fault in recordings[1].report.faults}
    assert {("dead channel", f"F4-{axis}3") for axis in "XYZ"} <= found
    assert ("lost bits", "F2-S1, rows 0–2335") in found
    assert ("channels left out", "F2-S1") in found
    assert ("wrong face label", "rows 586–733") in found
    assert ("duplicate column names", "Probe_Pos_1, Probe_Pos_2") in found
    assert not any(kind == "doubtful face label" for kind, _ in found)


def test_the_first_file_has_no_faulty_channel(recordings):
    kinds = {fault.kind for fault in recordings[0].report.faults}
    assert not kinds & {"dead channel", "noisy channel", "wrong face label"}


def test_no_label_of_a_place_is_accused(recordings):
    """Opposite places of the second file's third case are 3 pixels off; its presses agree."""
    kinds = {fault.kind for recording in recordings for fault in recording.report.faults}
    assert "labels not opposite" in kinds
    accusing = {"wrong place label", "force without signal", "contact while labelled rest"}
    assert not kinds & (accusing | {"jumping channel", "shell moved"})
    turned = {"force turned", "channel turned", "channels exchanged"}
    assert not kinds & (turned | {"place off the body", "count beyond the chip's range"})


def test_the_chip_that_lost_bits_in_the_second_file_is_left_out_there_alone(recordings):
    """Its numbers crowd at 64, 128, 256 … and its level fell from −2622 to 164 counts."""
    one, two = (recording.frames.signal_counts[:, 1, 0] for recording in recordings)
    assert np.isfinite(one).all()
    assert np.isnan(two).all()
    assert not jumps_between(recordings).any()


def test_noise_is_that_of_the_sensor(recordings):
    for recording in recordings:
        np.testing.assert_allclose(recording.frames.noise_counts, [22, 22, 11], rtol=0.12)


def test_combined_data_set(recordings):
    frames = combine(recordings)
    assert len(frames) == 3941 + 2336
    assert len(np.unique(frames.press_id)) == 42
    assert set(np.unique(frames.place_id)) == set(range(-1, 8))
    assert faces_pressed(frames) == (3, 5)
    assert np.diff(frames.time_s).min() > 0
    own_faces = frames.signal_counts[:, [2, 4]]
    assert np.isfinite(own_faces).all()


def test_estimator_on_held_out_presses(recordings):
    """Same places in training and test, other presses. Chance errs by half the range of force."""
    frames = recordings[0].frames
    split = split_presses(frames, 2)
    parts = frames.select(split.train), frames.select(split.validation)
    # alone and after half of the usual epochs it stays within the limits too
    training = TrainingSpec(history_frames=9, ensemble=1, epochs=20)
    model = fit_estimator(*parts, FitSettings(3, training, seed=2))
    result = evaluate_face(model, frames.select(split.test), frames)
    chance = mean_map_baseline(frames, 3, split)
    ridge = linear_baseline(frames, 3, split)
    assert result.similarity > 0.97
    assert result.location_error_px < 0.5 < chance.location_error_px
    assert result.force_error_percent < 5 < chance.force_error_percent
    assert result.force_error_percent < ridge.force_error_percent
    assert result.non_contact_accuracy > 0.97


def test_rest_level_alone_tells_the_place(recordings):
    """Why locations on these files must be read with care: the rest level gives the case away."""
    baseline = rest_offset_baseline(recordings, seed=1)
    assert baseline.chance == 1 / 8
    assert baseline.accuracy > 3 * baseline.chance
    assert 0 < baseline.presses < 42 / 2  # judged are those that the means do not know
