"""Rows, zero, contacts and rest as the page gets them, with an estimator that does as it is told."""

import threading
from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from estimator.grasps.measures import conditions_of, measured_grasps
from estimator.inversion.condition import object_condition
from instobj.bench.live.contacts import Found, placed_contact, placed_label, placed_labels
from instobj.bench.live.health import DRIFTING, GOOD
from instobj.bench.live.watch import Watch
from instobj.commands.assess.groups import with_ends
from instobj.commands.assess.sentences import answer_text
from tests.estimator.grasps.grasps_by_hand import joined, squeeze

SPEC = ObjectSpec(name="cube")
NAMES = channel_names(SPEC)
LEVEL = np.arange(45) * 10.0


class Told:
    """Finds a contact while the first channel is beyond 500 counts."""

    channels, presses = (), None

    def __init__(self):
        self.seen, self.passed, self.zeroed = [], [], 0

    def feed(self, raw_counts, time_s, left_out=None):
        self.seen.append(time_s)
        self.left_out = left_out
        if np.isnan(raw_counts[1, 0, 2]):
            raise InputError("channel F2-Z1 gives no reading")
        pressed = raw_counts[0, 0, 0] > 500
        row = placed_contact(SPEC, (1, 3.0, -2.0), (0.5, 4.0, 0.2), np.zeros(2))
        return Found(np.array([row])[: int(pressed)], True)

    def pass_by(self, raw_counts, time_s, left_out=None):
        self.passed.append(time_s)

    def rezero(self):
        self.zeroed += 1


def watching(estimator=None, zero_frames=5):
    watch = Watch(SPEC, estimator, zero_frames)
    watch.take_header(NAMES)
    return watch


def feed(watch, values, start_s=100.0):
    for number, value in enumerate(values):
        at = start_s + number / 200
        watch.take_row(at, at - 50.0, tuple(LEVEL + value))


def test_contacts_are_placed_on_a_curved_body_by_lengths_along_it():
    body = {"kind": "sphere", "size_mm": [44.0, 44.0, 44.0], "sensed_faces": [1]}
    ball = ObjectSpec.model_validate({"name": "ball", "body": body})
    label = placed_label(ball, 1, 22 * np.pi / 6, 0.0, 2.0)
    sine, cosine = np.sin(np.pi / 6), np.cos(np.pi / 6)
    np.testing.assert_allclose(label[4:7], [22 * sine, 0.0, 22 * cosine], atol=1e-6)
    np.testing.assert_allclose(label[7:], [sine, 0.0, cosine], atol=1e-6)


def test_names_are_in_the_order_of_sensors_and_axes():
    assert NAMES[:4] == ["F1-X1", "F1-Y1", "F1-Z1", "F1-X2"]
    assert NAMES[9] == "F2-X1"
    assert NAMES[-1] == "F5-Z3"


def test_changes_count_from_the_mean_of_the_first_frames():
    watch = watching()
    feed(watch, [1, 3, 1, 3, 2, 50])
    rows, missed = watch.rows_after(0, 400)
    assert missed == 0
    assert np.isnan(rows[3].change).all()
    np.testing.assert_allclose(rows[5].change, 48.0)
    np.testing.assert_allclose(rows[5].raw, LEVEL + 50)
    assert rows[5].time_s == pytest.approx(rows[5].arrived_s - 50.0)


def test_counts_that_are_changes_already_keep_their_values():
    watch = watching(zero_frames=0)
    feed(watch, [7.0])
    np.testing.assert_allclose(watch.rows_after(0, 1)[0][0].change, LEVEL + 7)


def test_a_viewer_far_behind_gets_the_newest_and_the_number_of_the_others():
    watch = watching()
    feed(watch, range(1000))
    rows, missed = watch.rows_after(200, 400)
    assert missed == 400
    assert [row.number for row in rows] == list(range(600, 1000))
    assert watch.rows_after(1000, 400) == ([], 0)


def test_a_slow_estimator_reads_the_newest_row_and_its_zero_sees_the_others():
    told = Told()
    watch = watching(told)
    feed(watch, range(10))
    watch.read_next()
    np.testing.assert_allclose(told.seen, [50.0 + 9 / 200])
    np.testing.assert_allclose(told.passed, 50.0 + np.arange(9) / 200)


def test_contacts_stand_on_the_body_and_push_inwards():
    watch = watching(Told())
    feed(watch, [600.0] * 6)
    watch.read_next()
    (row,) = watch.reading.read.contacts
    np.testing.assert_allclose(row[6:9], [3.0, -2.0, 21.0])
    np.testing.assert_allclose(row[9:12], [0, 0, 1])
    np.testing.assert_allclose(row[12:], [0, 0, -4.0])
    assert watch.reading.arrived_s == pytest.approx(100.025)


class Squeezed(Told):
    """Reads a hand-made grasp, a frame of it for each row."""

    def __init__(self, track):
        super().__init__()
        self.track = track

    def feed(self, raw_counts, time_s, left_out=None):
        row = len(self.seen)
        frame = self.track.select(slice(row, row + 1))
        self.seen.append(time_s)
        return Found(np.zeros((0, 15)), bool(frame.explained[0]), track=frame)


@pytest.mark.parametrize("explained", [True, False])
def test_a_grasp_that_has_ended_has_the_answer_of_assess(explained):
    track = squeeze(10.0)
    watch = watching(Squeezed(replace(track, explained=np.full(len(track), explained))))
    for row in range(len(track)):
        feed(watch, [0.0], 100.0 + row)
        watch.read_next()
    (grasp,) = watch.state()["grasps"]
    conditions = conditions_of(SPEC)
    expected = measured_grasps(track, conditions)
    unexplained = float(not explained)
    assert grasp["text"] == answer_text("grasp 1", expected, unexplained, "inversion", conditions)
    if explained:
        assert grasp["text"].startswith("grasp 1: good (one grasp)")
        assert "--limit" not in grasp["text"]  # an option of `assess`
        assert grasp["peak_n"] == with_ends(expected[0].readings["peak_n"])
        assert grasp["slip_mm"] == "0"
    else:
        assert "cannot be said" in grasp["text"]
        assert set(grasp) == {"grasp", "text"}


def test_a_grasp_that_cannot_be_measured_is_said_and_reading_goes_on():
    """Nothing can be drawn from a covariance that is not finite."""
    broken = squeeze(10.0)
    track = joined(replace(broken, covariance=broken.covariance * np.nan), squeeze(4.0))
    watch = watching(Squeezed(track))
    for row in range(len(track)):
        feed(watch, [0.0], 100.0 + row)
        watch.read_next()
    lost, measured = watch.state()["grasps"]
    assert lost["text"].startswith("grasp 1: cannot be measured: ")
    assert set(lost) == {"grasp", "text"}
    assert measured["text"].startswith("grasp 2: good")


def test_a_chip_that_stands_still_is_left_out_and_told():
    reader = Told()
    watch, rng = watching(reader), np.random.default_rng(0)
    noise = rng.normal(0, 20, (40, len(NAMES))).round()
    noise[20:, :3] = noise[20, :3]
    feed(watch, noise)
    watch.read_next()
    assert NAMES[:3] == ["F1-X1", "F1-Y1", "F1-Z1"]
    assert reader.left_out[0, 0].all()
    assert reader.left_out.sum() == 3
    assert watch.state()["trouble"].startswith("F1-S1: standing still or without an answer")


def test_a_reading_that_fails_is_told_and_ends_with_its_cause(monkeypatch):
    monkeypatch.setattr("instobj.bench.live.watch.AGAIN_S", 0.0)
    watch = watching(Told())
    feed(watch, [600.0])
    watch.read_next()
    silent = LEVEL.copy()
    silent[NAMES.index("F2-Z1")] = np.nan
    watch.take_row(101.0, 51.0, tuple(silent))
    watch.read_next()
    assert watch.state()["trouble"] == "channel F2-Z1 gives no reading"
    assert len(watch.reading.read.contacts) == 0
    feed(watch, [0.0], 102.0)
    watch.read_next()
    assert watch.state()["trouble"] == ""


def played(watch, values, start_s):
    """Rows with a little noise, each read, and the state asked for as viewers do."""
    for number, value in enumerate(values):
        feed(watch, [value + 3 * (-1) ** number], start_s + number / 20)
        watch.read_next()
        if number % 5 == 0:
            watch.state()
    return watch.state()


def test_drift_is_the_change_between_rests_and_a_press_is_none():
    watch = watching(Told())
    assert played(watch, [0.0] * 60, 100.0)["health"] == [GOOD] * 45
    played(watch, [900.0] * 60, 103.0)
    assert DRIFTING not in watch.state()["health"]
    state = played(watch, [100.0] * 60, 106.0)
    assert state["health"] == [DRIFTING] * 45
    np.testing.assert_allclose(watch.rows_after(0, 1)[0][0].change, 0.0, atol=6)
    watch.rezero()
    assert played(watch, [100.0] * 60, 109.0)["health"] == [GOOD] * 45
    assert played(watch, [200.0] * 60, 112.0)["health"] == [DRIFTING] * 45


def test_a_zero_taken_under_a_press_heals_at_the_first_rest():
    watch = watching(Told())
    played(watch, [900.0] * 20, 100.0)
    state = played(watch, [0.0] * 60, 101.0)
    assert state["health"] == [GOOD] * 45
    np.testing.assert_allclose(watch.rows_after(0, 1)[0][0].change, 0.0, atol=6)


def test_the_zero_button_reaches_the_estimator_between_two_frames():
    told = Told()
    watch = watching(told)
    feed(watch, range(6))
    watch.rezero()
    watch.read_next()
    assert told.zeroed == 1
    assert watch.state()["zeroed"] is False


def test_labels_and_news_are_handed_on():
    watch = watching()
    watch.take_labels([[3.0, 1.0, 2.0, 5.0], [6.0, 0.0, 0.0, 1.0]])
    watch.news = {"rate_hz": 200}
    assert watch.state()["rate_hz"] == 200
    assert watch.labels.shape == (1, 10)
    np.testing.assert_allclose(watch.labels[0, 4:7], [21.0, 2.0, -1.0])
    assert placed_labels(SPEC, []).shape == (0, 10)


def test_rows_come_in_while_viewers_ask():
    """Without the lock, viewers would meet a deque that changes under them."""
    watch = watching()
    adding = threading.Thread(target=feed, args=(watch, range(1500)))
    adding.start()
    seen = 0
    while adding.is_alive() or seen < 1500:
        rows, missed = watch.rows_after(seen, 400)
        assert [row.number for row in rows] == list(range(seen + missed, seen + missed + len(rows)))
        seen += missed + len(rows)


def test_what_was_not_read_is_no_rest():
    """An estimator that hangs for two seconds of a press does not make its level the zero."""
    watch = watching(Told())
    played(watch, [0.0] * 60, 100.0)
    feed(watch, [900.0] * 40, 103.0)
    for number in range(8):
        at = 103.2 + number / 4
        watch.take_row(at, at, tuple(LEVEL + 900.0))
    watch.state()
    np.testing.assert_allclose(watch.rows_after(0, 1)[0][0].change, 900.0, atol=6)
    watch.take_row(106.0, 106.0, tuple(LEVEL))
    watch.read_next()
    watch.state()
    np.testing.assert_allclose(watch.rows_after(0, 1)[0][0].change, 0.0, atol=6)
    assert DRIFTING not in watch.state()["health"]


def test_a_chip_that_contacts_are_read_without_is_told():
    told = Told()
    told.feed = lambda *_: Found(np.zeros((0, 15)), True, "F3-2")
    watch = watching(told)
    feed(watch, range(6))
    watch.read_next()
    assert watch.state()["trouble"] == "F3-2: its readings fit no contact, left out"


def test_a_slipped_core_is_named_with_what_to_do():
    slipped = object_condition(0.0, slip_mm=0.07)
    reader = Told()
    reader.feed = lambda *_: Found(np.zeros((0, 15)), True, condition=slipped)
    watch = watching(reader)
    assert watch.state()["condition"] == "fine"
    feed(watch, range(6))
    watch.read_next()
    state = watch.state()
    assert state["condition"] == state["trouble"] == str(slipped)
    assert state["trouble"].startswith("recalibrate: the core slipped by about 0.07 mm")
