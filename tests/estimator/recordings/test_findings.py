"""Findings of the checks, whole: kind, place, figures and what was done, on arrays of a few frames."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.recordings.checks import faults, limits, place_labels, press_labels, turned
from estimator.recordings.checks.faults import Fault
from tests.support.recordings.frame_sets import frame_set
from tests.support.recordings.judged_cases import judged, raw_table

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
    assert np.argwhere(faults.dead_channels(counts)[0]).tolist() == [[2, 1, 0], [3, 0, 2]]


def test_a_channel_is_noisy_above_three_times_the_median_of_its_axis():
    noise = NOISE * [1.0, 2.0, 3.0]
    noise[4, 1, 2] = 90.0
    assert not faults.noisy_channels(noise)[0].any()
    noise[4, 1, 2] = 91.0
    noise[0, 0, 0] = np.nan
    assert np.argwhere(faults.noisy_channels(noise)[0]).tolist() == [[4, 1, 2]]
    assert_allclose(faults.axis_noise_counts(noise), [10.0, 20.0, 30.0])
    counts = np.arange(2.0)[:, None, None, None] + still(2)
    counts[:, 1, 0, 1] = 5.0
    assert [*faults.dead_channels(counts)[1], *faults.noisy_channels(noise)[1]] == [
        Fault("dead channel", "F2-Y1", "no varying reading", "set to NaN"),
        Fault("noisy channel", "F5-Z2", "σ 91 counts at rest, 30 are typical of Z", "set to NaN"),
    ]


def test_rest_levels_that_jump_are_named_with_their_press():
    levels = np.stack([np.zeros((5, 2, 3)) for _ in range(4)])
    levels[2:, 3, 1, 0] = 501.0
    levels[1:, 0, 0, 0] = 500.0
    levels[3:] += 151.0
    levels[3:, 0, 1, 1] = 2000.0
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
    table = raw_table(5, "gripper", 2, face=face)
    corrected, found = faults.correct_face_labels(table, press, responses)
    assert corrected.tolist() == [[3, 5], [3, 5], [3, 5], [3, 5], [3, 5]]
    assert [str(one) for one in found] == [
        "wrong face label: rows 2–3: both load cells are said to press face 3; "
        "cell 2 set to face 5, whose sensors respond",
        "wrong face label: rows 4–4: both load cells are said to press face 5; "
        "cell 1 set to face 3, whose sensors respond",
    ]
    alone = raw_table(2, "gripper", 2, face=face[2:4])
    corrected, found = faults.correct_face_labels(alone, press[:2], responses)
    assert corrected.tolist() == [[3, 4], [3, 4]]


def test_a_face_that_answers_three_times_a_named_one_casts_doubt():
    responses = np.array([[10.0, 30.0, 5.0, np.nan, 1.0], [10.0, 31.0, 5.0, np.nan, 1.0]])
    force, face = np.array([[5.0], [0], [5], [0]]), np.ones((4, 1), int)
    case = judged([0, 0, 1, 1], force, face=face, responses=responses)
    doubtful, found = press_labels.doubtful_presses(case)
    assert doubtful.tolist() == [False, False, True, True]
    assert found == [
        Fault(
            "doubtful face label",
            "rows 2–3",
            "face 2 answers 3.1 times as strongly as the labelled face 1",
            "frames not used (--spec judges it by the object's model)",
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
    stamps = np.array([0.0, 0, 1, 1, 0.5])
    table = raw_table(5, duplicate_columns=("X1", "Y1"), time_s=stamps)
    assert faults.stamp_faults(table) == [
        Fault("duplicate column names", "X1, Y1", "named twice", "told apart by their order"),
        Fault("time stamps", "Time", "2 of 5 repeat the one before", "rebuilt from the frame rate"),
        Fault("time stamps", "Time", "1 run backwards", "a new stretch begins there"),
    ]


def test_stamps_that_are_all_the_same_tell_no_rate():
    table = raw_table(4, time_s=np.full(4, 5.0))
    (found,) = faults.stamp_faults(table)
    assert found.detail == "3 of 4 repeat the one before"
    assert found.action.startswith("they tell no frame rate, an assumed one is taken")


def test_a_face_is_pressed_where_its_cell_holds_a_third_of_the_largest_force():
    force = np.array([[10.0, 3.0], [2.9, 3.1], [0.3, 0.29]])
    case = judged([0, 0, 1], force, face=np.array([[3, 5]] * 3))
    found = press_labels.pressed_faces(case)
    assert found.tolist() == [[3, 5], [0, 5], [3, 0]]


def test_five_loaded_frames_called_rest_spoil_their_press():
    force = np.zeros((20, 1))
    force[2:6] = force[11:16] = 0.3
    case = judged(np.repeat([0, 1, 2, 3], 5), force, no_contact=np.ones(20, bool))
    wrong, found = press_labels.contacts_at_rest(case)
    assert np.flatnonzero(wrong).tolist() == list(range(10, 20))
    assert [one.where for one in found] == ["rows 11–15"]


def test_the_longest_level_is_the_middle_of_the_fullest_window():
    force = np.array([0.0, 0.1, 0.2, 5.0, 5.1, 5.2, 5.3, 9.0])
    assert turned.longest_level(force, 0.15) == 5.15
    assert turned.longest_level(force[:4], 0.15) == 0.1


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


def holds_of_two_places(turn=1.0):
    """Force of two places, 30 rows each, and counts that differ where it is not 0."""
    force = np.tile(np.r_[np.zeros(12), np.full(8, 6.0), np.zeros(10)], 2)[:, None]
    counts = np.random.default_rng(0).normal(0, 1, (60, 5, 2, 3))
    counts[:30, 1] += 20 * force[:30, :, None]
    counts[30:, 1] -= 15 * force[30:, :, None]
    where = np.full((60, 1), 2), np.repeat([0, 1], 30)
    return turn * force, counts, where


def test_a_cell_that_counts_the_other_way_throughout_is_turned():
    """Its presses were taken for rest, and rest for presses."""
    force, counts, where = holds_of_two_places(-1.0)
    corrected, (found,) = turned.turned_forces(force, counts, *where, 0.2)
    assert_allclose(corrected, -force)
    assert (found.kind, found.where) == ("force turned", "all rows")
    assert found.detail.startswith("cell 1 shows down to -6.0 N and nothing above its usual level")
    one_place = (where[0], 0 * where[1])
    assert_array_equal(turned.turned_forces(force, counts, *one_place, 0.2)[0], force)


def test_long_holds_with_short_rests_are_not_turned():
    force, counts, where = holds_of_two_places()
    often = np.r_[np.arange(12, 20), np.arange(12, 20), np.arange(20, 26)]
    rows = np.r_[often, often + 30]
    given = force[rows], counts[rows], (where[0][rows], where[1][rows])
    corrected, found = turned.turned_forces(given[0], given[1], *given[2], 0.2)
    assert found == []
    assert_array_equal(corrected, given[0])


def test_presses_without_any_rest_are_told_where_they_are_most():
    press, rest = np.repeat([0, 1, 2, 3], 3), np.zeros(12, bool)
    rest[[0, 3]] = True
    case = judged(press, np.ones((12, 1)), rest=rest)
    assert press_labels.restless_presses(case)[1] == []
    rest[3] = False
    _, (found,) = press_labels.restless_presses(case)
    assert (found.kind, found.where) == ("hardly any rest", "3 of 4 presses")


def test_one_channel_turned_or_two_exchanged_explain_a_difference():
    usual = np.array([0.6, 0.6, 0.4, 0.3, np.nan])
    turned_one = usual * [1, 1, -1, 1, 1]
    assert turned.unlike_model(turned_one, usual) == ("channel turned", (2,))
    exchanged = usual[[3, 1, 2, 0, 4]]
    assert turned.unlike_model(exchanged, usual) == ("channels exchanged", (0, 3))
    assert turned.unlike_model(usual + 0.01, usual) == ("", ())
    noise = np.full(5, 0.15)
    assert turned.unlike_model(turned_one, usual, noise) == ("", ())
    assert turned.unlike_model(turned_one, usual, 0.8 * noise) == ("channel turned", (2,))
    assert turned.unlike_model(exchanged, usual, noise) == ("", ())
    assert turned.unlike_model(exchanged, usual, 0.6 * noise) == ("channels exchanged", (0, 3))
    weak = np.array([0.7, 0.7, 0.09])
    assert turned.unlike_model(weak * [1, 1, -1], weak) == ("", ())


def made(press, place, force, signals, valid=None):
    """A data set of one tip on a face of one sensor."""
    frames = len(press)
    normal_n = np.broadcast_to(np.asarray(force, float), frames)[:, None]
    return frame_set(
        np.asarray(signals, float).reshape(frames, 1, 1, 3),
        np.ones((frames, 1), int),
        np.zeros((frames, 1, 2)),
        normal_n,
        valid=np.ones(frames, bool) if valid is None else valid,
        press_id=np.asarray(press),
        place_id=np.asarray(place),
        faces=np.array([1]),
        noise_counts=np.full(3, 0.01),
    )


def test_patterns_are_means_over_the_frames_of_at_least_half_the_largest_force():
    """Press 0: frames of 10, 10, 5, 5, 5 N count, those of 4.9 N do not. Press 1 has four."""
    force = [4.9, 10, 10, 5, 5, 5, 0, 8, 8, 8, 8]
    press = np.repeat([0, 1], [7, 4])
    place = np.array([3] * 6 + [-1] + [4] * 4)
    signals = np.zeros((11, 3))
    signals[:6, 0] = [1000, 1, 2, 3, 4, 5]
    signals[:6, 1] = [1000, 4, 4, 4, 4, 4]
    signals[7:, 2] = 1.0
    found = place_labels.press_patterns(made(press, place, force, signals))
    assert (found[0].tolist(), found[1].tolist()) == ([0], [3])
    assert_allclose(found[2], [[0.6, 0.8, 0.0]])
    force[10:], press, place = [8, 8], [*press, 1], [*place, 4]
    signals = np.vstack([signals, [[0, np.nan, 1]]])
    found = place_labels.press_patterns(made(press, place, force, signals))
    assert (found[0].tolist(), found[1].tolist()) == ([0, 1], [3, 4])
    assert_array_equal(found[2][1], [0, np.nan, 1])
    valid = np.arange(12) != 5
    left = place_labels.press_patterns(made(press, place, force, signals, valid=valid))
    assert left[0].tolist() == [1]


PLACES = (((3, 1.0, 2.0),), ((3, 4.0, 5.0),), ((4, 1.0, 2.0),))


def of_presses(places, patterns):
    """Presses of five frames each."""
    number = np.repeat(np.arange(len(places)), 5)
    return made(
        number, np.repeat(places, 5), np.full(len(number), 5.0), np.repeat(patterns, 5, axis=0)
    )


def place_faults(places, patterns):
    return place_labels.place_label_faults(of_presses(places, patterns), PLACES)


def test_a_press_unlike_its_place_and_like_another_of_the_same_face_is_mislabelled():
    one, two = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    wrong, found = place_faults([0, 0, 0, 1, 1, 0], [one, one, one, two, two, two])
    assert np.flatnonzero(wrong).tolist() == [25, 26, 27, 28, 29]
    assert [str(one) for one in found] == [
        "wrong place label: rows 25–29: labelled face 3 (1, 2) mm, responds like face 3 (4, 5); "
        "press not used"
    ]
    wrong, found = place_faults([0, 0, 0, 2, 2, 0], [one, one, one, two, two, two])
    assert not found  # alike on another face tells nothing of the place
    wrong, found = place_faults([0, 1, 1], [two, two, two])
    assert not found  # a place pressed once


def test_two_exchanged_presses_name_each_other():
    one, two = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    wrong, found = place_faults([0, 0, 0, 0, 1, 1, 1, 1], [one, one, one, two, two, two, two, one])
    assert np.flatnonzero(wrong).tolist() == [15, 16, 17, 18, 19, 35, 36, 37, 38, 39]
    assert found[0].detail.endswith("responds like face 3 (4, 5), as if swapped with rows 35–39")
    assert found[1].detail.endswith("responds like face 3 (1, 2), as if swapped with rows 15–19")


@pytest.mark.parametrize(("degrees", "mislabelled"), [(22.8, False), (23.2, True)])
def test_a_press_may_be_off_its_place_by_four_tenths_of_its_length(degrees, mislabelled):
    """A chord of 2 sin(φ/2) = 0.4 spans 23.07°; the other place answers as the press does."""
    turned_by = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0])
    straight = np.array([1.0, 0, 0])
    _, found = place_faults([0, 0, 1, 1, 0], [straight, straight, turned_by, turned_by, turned_by])
    assert bool(found) is mislabelled


@pytest.mark.parametrize(("aside", "mislabelled"), [(0.32, True), (0.42, False)])
def test_another_place_must_be_nearer_by_two_and_a_half_times(aside, mislabelled):
    """The press is 0.92 off its own place (54.7°); the other's mean lies at a chord `aside` of it."""

    def at(radians):
        return np.array([np.cos(radians), np.sin(radians), 0])

    press = 2 * np.arcsin(0.92 / 2)
    other = press + 2 * np.arcsin(aside / 2)
    _, found = place_faults([0, 0, 1, 1, 0], [at(0), at(0), at(other), at(other), at(press)])
    assert bool(found) is mislabelled


def test_changes_at_rest_are_medians_over_the_live_channels_of_a_face():
    counts = still(6)
    counts[:, 0, 0] = np.array([0.0, 2, 4, 6, 50, 80])[:, None] * [1, 2, 3]
    counts[:, 1, 0, 0] = [5.0, np.nan, 5, 5, 35, 65]
    counts[:, 1, :, 1:] = np.array([5.0, 5, 5, 5, 25, 45])[:, None, None]
    counts[:, 1, 1, 0] = 1e6
    counts[5, 1, 1, 0] = 2e6
    rest = np.array([True] * 4 + [False] * 2)
    noise = np.full((5, 2, 3), 10.0)
    noise[1, 1, 0] = 0.0
    noise[2] = np.nan
    stretch = np.array([0, 0, 1, 1, 1, 1])
    case = judged(
        np.zeros(6, int), np.zeros((6, 1)), counts=counts, rest=rest, stretch=stretch,
        noise_counts=noise,
    )  # fmt: skip
    found = press_labels.sigmas_from_rest(case, slice(0, 6))
    # face 1: levels are the median of both stretches' medians, 1 and 5 → 3; three channels of six move
    first = np.median(
        abs(np.array([0.0, 2, 4, 6, 50, 80])[:, None] - 3) * [1, 2, 3, 0, 0, 0], axis=1
    )
    assert_allclose(found[:, 0], first / 10)
    assert_allclose(found[:, 1], [0, 0, 0, 0, 2, 4])
    assert not found[:, 2:].any()


def test_a_load_is_the_third_quartile_of_a_cell_over_its_press():
    force = np.array([[0.0, 9], [1, 9], [2, 9], [3, 9], [4, 9], [0.3, 0.2], [0.3, 0.2]])
    face = np.array([[2, 0]] * 5 + [[4, 5]] * 2)
    press = np.array([0] * 5 + [1] * 2)
    responses = np.array([[np.nan, 70.0, 1, 2, 3], [1.0, 2, 3, 40, 5]])
    case = judged(press, force, face=face, responses=responses)
    assert press_labels.loads_of_places(case) == [
        (0, 2, 3.0, 70.0),
        (1, 4, 0.3, 40.0),
    ]
    responses[1, 3] = np.nan
    assert len(press_labels.loads_of_places(case)) == 1


def test_a_place_beyond_the_object_is_told_once_with_its_rows():
    tips = np.zeros((4, 1, 2, 2))
    tips[1, 0, 1] = tips[3, 0, 0] = [3.0, -21.5]
    tips[2, 0, 0] = [21.0, -21.0]
    tips[0, 0, 1] = np.nan
    far, found = limits.places_off_the_body(tips, limits.Limits(1.0, 21.0))
    assert far.tolist() == [False, True, False, True]
    assert [str(one) for one in found] == [
        "place off the body: rows 1–3: (3, -21.5) mm lies beyond ±21 mm; frames not used (with --spec "
        "the object's size counts, else three times the grid's reach)"
    ]


def test_usual_limits_are_of_16_bits_and_three_times_the_grid():
    grid = {"grid_x_mm": np.array([-6.0, 7.0]), "grid_y_mm": np.array([-8.0, 6.0])}
    assert limits.usual_limits(raw_table(3, **grid)) == limits.Limits(32768.0, 24.0)


def test_changes_are_alike_where_most_blocks_say_so():
    """Blocks of fifteen frames: rest, above and below. Cosines 1, −1 and 0.6 have the median 0.6."""
    part = np.tile(np.repeat([0, 1, 2], 5), 3)
    parts = tuple(part == number for number in range(3))
    block = np.repeat([0, 1, 2], 15)
    counts = still(45)
    ups = [(10.0, 0.0), (10.0, 0.0), (10.0, 0.0)]
    downs = [(5.0, 0.0), (-5.0, 0.0), (3.0, 4.0)]
    for number, (up, down) in enumerate(zip(ups, downs, strict=True)):
        for kind, change in ((1, up), (2, down)):
            rows = (block == number) & (part == kind)
            counts[rows, 1, 0, :2] = change
    counts[:, 1, 1, 1] = np.nan
    counts += 100.0
    face = np.full(45, 2)
    assert turned.change_alike(counts, face, block, parts)
    two = slice(15, 45)
    halves = tuple(mask[two] for mask in parts)
    assert not turned.change_alike(
        counts[two], face[two], block[two], halves
    )  # median of −1 and 0.6
    assert not turned.change_alike(counts, 0 * face, block, parts)
    one = slice(0, 14)  # four frames below
    assert not turned.change_alike(
        counts[one], face[one], block[one], tuple(mask[one] for mask in parts)
    )


def test_turned_channels_are_told_by_the_nearest_pair_of_presses_of_a_place():
    usual = np.array([0.6, 0.64, 0.48])
    other = np.array([0.0, 0.6, 0.8])
    patterns = [usual, usual, other, usual * [1, -1, 1], usual * [1, -1, 1]]
    wrong, found = turned.turned_channels(of_presses([0, 0, 1, 0, 0], patterns))
    assert np.argwhere(wrong).tolist() == [[0, 0, 1]]
    assert [str(one) for one in found] == [
        "channel turned: F1-Y1, rows 9–15: presses of one place before and after answer unlike "
        "(4 pairs); set to NaN"
    ]
    wrong, found = turned.turned_channels(of_presses([0, 0], [usual, usual[[2, 1, 0]]]))
    assert np.argwhere(wrong).tolist() == []
    swapped = np.array([0.8, 0.6, 0.0])
    wrong, found = turned.turned_channels(of_presses([0, 0], [swapped, swapped[[2, 1, 0]]]))
    assert np.argwhere(wrong).tolist() == [[0, 0, 0], [0, 0, 2]]
    assert found[0].where == "F1-X1 and F1-Z1, rows 4–5"


@pytest.mark.parametrize(("away", "found"), [(0.1, "channels exchanged"), (0.2, "")])
def test_an_exchange_must_explain_a_difference_four_times_better(away, found):
    """Channels 0 and 2 exchanged leave `away` of the third unexplained, of √(2 · 0.4² + away²)."""
    usual = np.array([0.7, 0.5, 0.3])
    pattern = usual[[2, 1, 0]] + [0.0, away, 0.0]
    whole = np.sqrt(2 * 0.4**2 + away**2)
    assert (whole > 4 * away) == bool(found)
    assert turned.unlike_model(pattern, usual)[0] == found


def test_a_difference_of_a_quarter_is_no_exchange():
    usual = np.array([0.6, 0.5, 0.43])
    assert turned.unlike_model(usual[[2, 1, 0]], usual) == ("", ())
    usual = np.array([0.6, 0.5, 0.42])
    assert turned.unlike_model(usual[[2, 1, 0]], usual) == ("channels exchanged", (0, 2))


def test_rest_is_the_lowest_15_and_full_force_the_highest_25_frames_of_a_hundred():
    """Frame k of 101 bears k N and one channel reads 1 where k is 15 or 75, another where 16 or 74."""
    force = np.arange(101.0)[:, None]
    counts = still(101)
    counts[[15, 75], 2] = 1.0
    counts[[16, 74], 3] = 1.0
    found = faults.press_responses(counts, force, np.zeros(101, int))
    assert_allclose(found[0, 2], 1 / 16 - 1 / 26)
    assert found[0, 3] == 0
