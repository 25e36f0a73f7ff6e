"""Findings of the checks, whole: kind, place, figures and what was done, on arrays of a few frames."""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from estimator.recordings.checks import faults, labels, turned
from estimator.recordings.checks.faults import Fault

NOISE = np.full((5, 2, 3), 10.0)


def still(frames):
    return np.zeros((frames, 5, 2, 3))


def test_noise_at_rest_is_that_of_steps_between_neighbouring_rest_frames():
    counts = still(5)
    counts[:, 0, 0, 0] = [0.0, 2.0, -1.0, 50.0, 9.0]
    counts[:, 0, 0, 1] = [np.nan, 4.0, 0.0, 1.0, 1.0]
    counts[:, 0, 0, 2] = [1.0, np.nan, 3.0, 1.0, 1.0]
    noise = faults.rest_noise_counts(counts, np.array([True, True, True, False, True]))
    assert_allclose(noise[0, 0], [np.sqrt((4 + 9) / 2 / 2), np.sqrt(16 / 2), np.nan])
    mean = faults.known_mean(counts)
    assert_allclose(mean[0, 0], [12.0, 1.5, 1.5])
    assert np.isnan(faults.known_mean(np.full((2, 5, 1, 3), np.nan))).all()


def test_a_channel_that_never_changes_is_dead_unless_its_whole_face_is_absent():
    counts = np.arange(3.0)[:, None, None, None] + still(3)
    counts[:, 1] = np.nan
    counts[:, 2, 1, 0] = np.nan
    counts[:, 3, 0, 2] = 7.0
    assert np.argwhere(faults.dead_channels(counts)).tolist() == [[2, 1, 0], [3, 0, 2]]


def test_a_channel_is_noisy_above_three_times_the_median_of_its_axis():
    noise = NOISE * [1.0, 2.0, 3.0]
    noise[4, 1, 2] = 90.0
    assert not faults.noisy_channels(noise).any()
    noise[4, 1, 2] = 91.0
    noise[0, 0, 0] = np.nan
    assert np.argwhere(faults.noisy_channels(noise)).tolist() == [[4, 1, 2]]
    assert_allclose(faults.axis_noise_counts(noise), [10.0, 20.0, 30.0])
    counts = np.arange(2.0)[:, None, None, None] + still(2)
    counts[:, 1, 0, 1] = 5.0
    assert faults.channel_faults(counts, noise) == [
        Fault("dead channel", "F2-Y1", "no varying reading", "set to NaN"),
        Fault("noisy channel", "F5-Z2", "σ 91 counts at rest, 30 are typical of Z", "set to NaN"),
    ]


def test_rest_levels_that_jump_are_named_with_their_press():
    levels = np.stack([np.zeros((5, 2, 3)) for _ in range(4)])
    levels[2:, 3, 1, 0] = 501.0
    levels[1:, 0, 0, 0] = 500.0
    levels[3:] += 151.0
    levels[3:, 4, 1, 2] = np.nan
    jumping, found = faults.jump_faults(levels)
    assert np.argwhere(jumping).tolist() == [[3, 1, 0]]
    assert found == [
        Fault(
            "jumping channel", "F4-X2, before press 2", "rest level 0 → 501 counts", "set to NaN"
        ),
        Fault(
            "shell moved",
            "before press 3",
            "rest moved by 151 counts (median of channels)",
            "kept: zeroed press by press",
        ),
    ]
    quiet = np.stack([levels[0], levels[0] + 150.0])
    assert faults.jump_faults(quiet)[1] == []
    assert np.argwhere(faults.jumped_channels(levels[0], levels[2])).tolist() == [[3, 1, 0]]


def test_responses_are_root_mean_squares_between_rest_and_full_force():
    force = np.array([[0.0, 0.0], [0.0, 0.0], [1.0, 1.0], [5.0, 5.0], [5.0, 5.0]] * 2)
    counts = still(10)
    counts[3:5, 1, 0, 0], counts[3:5, 1, 0, 1] = 30.0, 40.0
    counts[:2, 1, 0, 2] = 12.0
    counts[8:, 1, 1, 0] = np.nan
    counts[5:, 0] = np.nan
    found = faults.press_responses(counts, force, np.repeat([0, 1], 5))
    assert_allclose(found[0], [0, np.sqrt((900 + 1600 + 144) / 6), 0, 0, 0])
    assert np.isnan(found[1, 0])
    assert_allclose(found[1, 1:], 0)


def test_two_jaws_on_one_face_are_told_apart_by_the_usual_or_the_strongest_face():
    face = np.array([[3, 5], [3, 5], [3, 3], [3, 3], [5, 5]])
    responses = np.array([[1.0, 2.0, 9.0, 3.0, np.nan]] * 3)
    press = np.array([0, 0, 1, 1, 2])
    table = SimpleNamespace(kind="gripper", face=face)
    corrected, found = faults.correct_face_labels.__wrapped__(table, press, responses)
    assert corrected.tolist() == [[3, 5], [3, 5], [3, 5], [3, 5], [3, 5]]
    assert [str(one) for one in found] == [
        "wrong face label: rows 2–3: both load cells are said to press face 3; "
        "cell 2 set to face 5, whose sensors respond",
        "wrong face label: rows 4–4: both load cells are said to press face 5; "
        "cell 1 set to face 3, whose sensors respond",
    ]
    alone = SimpleNamespace(kind="gripper", face=face[2:4])
    corrected, found = faults.correct_face_labels.__wrapped__(alone, press[:2], responses)
    assert corrected.tolist() == [[3, 4], [3, 4]]


def test_a_face_that_answers_three_times_a_named_one_casts_doubt():
    responses = np.array([[10.0, 30.0, 5.0, np.nan, 1.0], [10.0, 31.0, 5.0, np.nan, 1.0]])
    pressed, press = np.array([[1], [0], [1], [0]]), np.array([0, 0, 1, 1])
    doubtful, found = faults.doubtful_presses(pressed, press, responses)
    assert doubtful.tolist() == [False, False, True, True]
    assert found == [
        Fault(
            "doubtful face label",
            "rows 2–3",
            "face 2 responds 31 counts, a named face only 10",
            "frames not used",
        )
    ]


def test_jaws_must_be_opposite_to_six_millimetres():
    face = np.array([[3, 5], [3, 5], [3, 4]])
    tips = np.zeros((3, 2, 1, 2))
    tips[0, :, 0] = [[1.0, 2.0], [7.0, -2.0]]
    tips[1, :, 0] = [[1.0, 2.0], [1.5, 4.5]]
    assert faults.mirror_faults(face, tips, np.array([0, 1, 2])) == [
        Fault(
            "labels not opposite",
            "rows 1–1",
            "places [[1.0, 2.0]] and [[1.5, 4.5]] mm are 6.5 mm off",
            "kept as labelled",
        )
    ]


def test_stamps_that_repeat_or_run_backwards_are_counted():
    table = SimpleNamespace(duplicate_columns=("X1", "Y1"), time_s=np.array([0.0, 0, 1, 1, 0.5]))
    assert faults.stamp_faults.__wrapped__(table) == [
        Fault("duplicate column names", "X1, Y1", "named twice", "told apart by their order"),
        Fault("time stamps", "Time", "2 of 5 repeat the one before", "rebuilt from the frame rate"),
        Fault("time stamps", "Time", "1 run backwards", "a new stretch begins there"),
    ]


def test_a_face_is_pressed_where_its_cell_holds_a_third_of_the_largest_force():
    force = np.array([[10.0, 3.0], [2.9, 3.1], [0.3, 0.29]])
    found = labels.pressed_faces(np.array([[3, 5]] * 3), force, np.array([0, 0, 1]))
    assert found.tolist() == [[3, 5], [0, 5], [3, 0]]


def test_five_loaded_frames_called_rest_spoil_their_press():
    touching = np.zeros((20, 1), bool)
    touching[2:6] = touching[11:16] = True
    wrong, found = labels.contacts_at_rest(touching, np.ones(20, bool), np.repeat([0, 1, 2, 3], 5))
    assert np.flatnonzero(wrong).tolist() == list(range(10, 20))
    assert [one.where for one in found] == ["rows 11–15"]


def test_a_change_of_more_than_six_sigma_at_rest_is_a_hidden_contact():
    counts = still(40)
    counts[20:25, 2] = 61.0
    counts[30:34, 3] = 90.0
    counts[35:40, 1] = 60.0
    rest, zeros = np.ones(40, bool), np.zeros(40, int)
    hidden, found = labels.hidden_contacts(counts, rest, zeros, zeros, NOISE)
    assert np.flatnonzero(hidden).tolist() == [20, 21, 22, 23, 24]
    assert found == [
        Fault(
            "contact while labelled rest",
            "rows 20–24",
            "face 3 responds by 6 σ while no load cell does",
            "frames not used",
        )
    ]


def test_a_press_below_a_tenth_of_the_usual_answer_is_silent():
    face, press = np.full((12, 1), 2), np.repeat([0, 1, 2], 4)
    force = np.full((12, 1), 5.0)
    responses = np.zeros((3, 5))
    responses[:, 1] = [1000.0, 1000.0, 99.0]
    wrong, found = labels.silent_presses(face, force, press, responses, NOISE)
    assert np.flatnonzero(wrong).tolist() == [8, 9, 10, 11]
    assert found[0].detail == (
        "5.0 N on face 2, whose sensors change by 99 counts where 1000 are usual"
    )
    responses[2, 1] = 101.0
    assert not labels.silent_presses(face, force, press, responses, NOISE)[1]
    responses[:, 1] = [49.0, 49.0, 1.0]
    assert not labels.silent_presses(face, force, press, responses, NOISE)[1]


def test_the_longest_level_is_the_middle_of_the_fullest_window():
    force = np.array([0.0, 0.1, 0.2, 5.0, 5.1, 5.2, 5.3, 9.0])
    assert turned._longest_level(force, 0.15) == 5.15
    assert turned._longest_level(force[:4], 0.15) == 0.1


def test_forces_are_turned_back_where_the_face_answers_as_to_a_press():
    force = np.zeros((40, 1))
    force[10:16, 0], force[25:31, 0] = 4.0, -3.0
    counts = still(40)
    counts[10:16, 1, :, 0], counts[25:31, 1, :, 0] = 100.0, 80.0
    where = np.full((40, 1), 2), np.zeros(40, int)
    corrected, found = turned.turned_forces(force, counts, *where, 0.2)
    assert_allclose(corrected, abs(force))
    assert found == [
        Fault(
            "force turned",
            "rows 25–30",
            "cell 1 shows down to -3.0 N against rest, while the face answers as to a press",
            "sign turned back",
        )
    ]
    counts[25:31] *= -1
    corrected, found = turned.turned_forces(force, counts, *where, 0.2)
    assert not found
    assert_array_equal(corrected, force)


def test_one_channel_turned_or_two_exchanged_explain_a_difference():
    usual = np.array([0.6, 0.6, 0.4, 0.3, np.nan])
    turned_one = usual * [1, 1, -1, 1, 1]
    assert turned._unlike(turned_one, usual) == ("channel turned", (2,))
    exchanged = usual[[3, 1, 2, 0, 4]]
    assert turned._unlike(exchanged, usual) == ("channels exchanged", (0, 3))
    assert turned._unlike(usual + 0.01, usual) == ("", ())
    weak = np.array([0.7, 0.7, 0.09])
    assert turned._unlike(weak * [1, 1, -1], weak) == ("", ())
