"""The zero that follows rest: drift, offsets between presses, a start within a press, long holds."""

import math
import re
from typing import get_args

import numpy as np
import pytest

from design.errors import InputError
from estimator.deploy import zeroing
from estimator.deploy.runtime import LiveReader
from estimator.deploy.zeroing import RestZero, StillReading, StreamZero, is_still, read_through
from tests.support.pages import DOCS

GAIN = np.array([60.0, -35.0, 90.0, 20.0, -15.0, 40.0])
"""Counts per newton of a press; noise below is 20 counts."""
RATE_HZ = 10.0
REST, RISE, HOLD = 25, 8, 60


def read(change, frames=1):
    """A linear estimator: force along the press' own direction, none where it points back."""
    force = max(0.0, float(change @ GAIN / (GAIN @ GAIN)))
    return StillReading(float(force > 0.3), force)


def forces(presses=6, hold=HOLD, seed=0):
    """Presses of different strength with rest before and after each, N."""
    peaks = np.random.default_rng(seed).uniform(6, 15, presses)
    up = np.linspace(0, 1, RISE)
    shape = np.concatenate([np.zeros(REST), up, np.ones(hold), up[::-1], np.zeros(REST)])
    return (peaks[:, None] * shape).ravel()


def stream(force_n, seed=1, hysteresis=0.06, drift_per_s=0.2, jump_counts=40.0):
    """Raw counts: noise, drift that goes on, a shift of rest after every press, hysteresis that
    stays after it."""
    rng = np.random.default_rng(seed)
    loaded = force_n > 0
    number = np.cumsum(np.diff(loaded.astype(int), prepend=0) < 0)
    shift = rng.normal(0, jump_counts, (number.max() + 1, len(GAIN)))[number]
    hung = hysteresis * np.maximum.accumulate(force_n)[:, None] * (~loaded & (number > 0))[:, None]
    drift = (
        drift_per_s * np.arange(len(force_n))[:, None] / RATE_HZ * rng.choice([-1, 1], len(GAIN))
    )
    noise = rng.normal(0, 20, (len(force_n), len(GAIN)))
    return 700 + GAIN * (force_n[:, None] + hung) + shift + drift + noise


def followed(raw, zero):
    """Force read in each frame, NaN before the first zero."""
    found = []
    for number, row in enumerate(raw):
        zero.update(row, number / RATE_HZ)
        found.append(math.nan if zero.level is None else read(row - zero.level).force_n)
    return np.array(found)


def shares(force_n, found, limit=1.0):
    """Rest frames read as more than `limit`, and frames of 2 N and more read as less."""
    rest, pressed = (force_n == 0) & np.isfinite(found), (force_n > 2) & np.isfinite(found)
    return float(np.mean(found[rest] > limit)), float(np.mean(found[pressed] < limit))


@pytest.mark.parametrize("fault", ["none", "zeroed once", "nothing counts as a return"])
def test_offsets_and_drift_between_presses_are_followed(fault, monkeypatch):
    if fault == "nothing counts as a return":
        monkeypatch.setattr(zeroing, "RETURN_SHARE", 0.0)
    force_n = forces()
    raw, zero = stream(force_n), RestZero(8, read)
    if fault == "zeroed once":
        first = raw[:20].mean(axis=0)
        found = np.array([read(row - first).force_n for row in raw])
    else:
        found = followed(raw, zero)
    false, missed = shares(force_n, found, limit=0.5)
    assert (false < 0.12 and missed < 0.01) == (fault == "none")


@pytest.mark.parametrize("start", ["rest", "hold"])
def test_a_start_within_a_press_is_corrected_at_its_end(start):
    force_n = forces(presses=4)
    begin = 0 if start == "rest" else REST + RISE + 10
    found = followed(stream(force_n)[begin:], RestZero(8, read))
    after = REST + RISE + HOLD + RISE + 12 - begin
    false, missed = shares(force_n[begin:][after:], found[after:])
    assert false < 0.05
    assert missed < 0.01


def test_a_long_hold_is_no_rest():
    """Ten minutes at one force: still, but read as a contact throughout."""
    force_n = np.concatenate([forces(presses=1, hold=6000)])
    found = followed(stream(force_n, drift_per_s=0.05), RestZero(8, read))
    assert shares(force_n, found)[1] < 0.001
    held = found[force_n == force_n.max()]
    assert abs(held.mean() - force_n.max()) < 0.5


def read_what_fits(change, frames=1):
    """The same where a press or rest leaves 40 counts (rms) at most; else neither explains the change."""
    still = read(change, frames)
    left = change - still.force_n * GAIN
    return still._replace(explained=bool(np.sqrt(np.mean(left**2)) < 40.0))


@pytest.mark.parametrize(("kept_n", "levels"), [(0.4, 2), (3.0, 1)])
def test_a_press_is_let_go_by_the_shape_of_the_step_however_chips_drifted(kept_n, levels):
    """Chips drift apart by 300 counts in a hold, so that nothing explains what is seen; then it ends, and
    creep of the silicone stays, or a part of the press."""
    force_n = np.concatenate([np.zeros(30), np.full(200, 8.0), np.full(60, kept_n)])
    ramp = np.clip(np.arange(len(force_n)) - 45, 0, 150)[:, None] / 150
    drift = 300.0 * ramp * [1.0, 1.0, -1.0, -1.0, 1.0, -1.0]
    noise = np.random.default_rng(1).normal(0, 20, drift.shape)
    raw, zero = 700 + GAIN * force_n[:, None] + drift + noise, RestZero(8, read_what_fits)
    followed(raw, zero)
    assert zero.starts == levels
    assert (abs(zero.level - raw[-20:].mean(axis=0)).max() < 30) == (levels == 2)


@pytest.mark.parametrize(("rate_n_per_s", "seen"), [(0.1, True), (0.004, False)])
def test_a_slow_press_is_seen_and_a_slower_one_is_drift(rate_n_per_s, seen):
    """The price that the module names: between these rates of force lies the limit."""
    force_n = np.concatenate([np.zeros(100), np.arange(0, 4, rate_n_per_s / RATE_HZ)])
    found = followed(stream(force_n, jump_counts=0.0, drift_per_s=0.0), RestZero(8, read))
    assert (found[-20:].mean() > 3.0) == seen


def test_stillness_needs_no_noise_level():
    rng = np.random.default_rng(2)
    for sigma in (0.5, 20.0, 300.0):
        windows = rng.normal(0, sigma, (300, 8, 9))
        assert np.mean([is_still(window) for window in windows]) > 0.75
        ramp = sigma * np.arange(8)[:, None]
        assert np.mean([is_still(window + ramp) for window in windows]) < 0.05
    assert is_still(np.zeros((8, 3)))


def test_a_window_does_not_span_a_pause():
    zero = RestZero(8, read)
    for number in range(14):
        zero.update(np.full(6, 5.0), number / RATE_HZ + (20.0 if number > 6 else 0.0))
    assert zero.level is None
    zero.update(np.full(6, 5.0), 21.4)
    assert zero.level is not None


@pytest.mark.parametrize("every", [1, 4])
def test_at_200_hz_presses_are_no_rest(every):
    """Eight frames last 40 ms there, in which a press of 2 s moves less than the noise; a reader that reads
    every fourth frame alone shows the zero the others."""
    rng, zero = np.random.default_rng(5), RestZero(8, read)
    time_s = np.arange(0, 20, 1 / 200)
    force_n = 5 * np.maximum(0.0, np.sin(np.pi * (time_s - 2) / 2)) * (time_s > 2)
    found = np.full(len(time_s), math.nan)
    for number, row in enumerate(700 + GAIN * force_n[:, None] + rng.normal(0, 20, (4000, 6))):
        if number % every:
            zero.pass_by(row, float(time_s[number]))
            continue
        zero.update(row, float(time_s[number]))
        found[number] = math.nan if zero.level is None else read(row - zero.level).force_n
    told = np.isfinite(found)
    assert told.mean() > 0.9 / every
    assert abs(found - force_n)[told].mean() < 0.3
    assert abs(found - force_n)[told & (force_n > 2)].max() < 1.5


def test_too_few_frames_are_refused():
    with pytest.raises(InputError, match="5 frames or more; got 2"):
        RestZero(2, read)


def test_the_page_of_estimators_tells_every_baseline_and_its_numbers():
    page = (
        (DOCS / "reference" / "estimators.md").read_text().partition("| `--zero` | baseline |")[2]
    )
    rows = re.findall(r"^\| `(\w+)`( \(default\))? \|", page, re.MULTILINE)[:3]
    assert [row[0] for row in rows] == list(get_args(zeroing.ZeroMode))
    assert [row[0] for row in rows if row[1]] == [LiveReader.__dataclass_fields__["zero"].default]
    told = (
        f"{zeroing.ZERO_FRAMES} frames (`rest:20`: 20; {zeroing.LEAST_FRAMES} or more)",
        f"less than {zeroing.RETURN_SHARE:.0%} of".replace("%", " %"),
        f"at most {zeroing.DRIFT_COUNTS_PER_S:g} count/s",
    )
    assert [words for words in told if words not in page] == []


class Following:
    """A zero whose reader tells force and contact as scripted: (change, contact, force) by the sum."""

    def __init__(self, contact=0.0, force=0.0, back=0.0):
        self.said = {True: (contact, force), False: (0.0, back)}
        self.zero = RestZero(8, self.read)
        self.zero.level = np.zeros(2)

    def read(self, change, frames):
        return StillReading(*self.said[bool(change.sum() >= 0)])

    def considered(self, level, elapsed_s=1.0, largest_n=10.0):
        self.zero.largest_n = largest_n
        self.zero.consider(np.array(level), elapsed_s)
        return self.zero.level.tolist(), self.zero.largest_n


@pytest.mark.parametrize(
    ("contact", "force", "back", "level", "largest"),
    [
        (1.0, 5.0, 0.0, [0.0, 0.0], 10.0),  # held
        (1.0, 1.5, 0.0, [40.0, 3.0], 10.0),  # fallen to 0.15 of the largest: rest
        (1.0, 1.51, 0.0, [0.0, 0.0], 10.0),
        (0.49, 5.0, 0.0, [1.0, 1.0], 10.0),  # no contact: followed by a count a second
        (0.5, 5.0, 0.0, [0.0, 0.0], 10.0),
        (1.0, 5.0, 10.0, [0.0, 0.0], 10.0),  # its opposite reads twice the force: not more
        (1.0, 5.0, 10.1, [40.0, 3.0], 0.0),  # more: the zero lay within a press
        (1.0, 0.0, 1.0, [40.0, 3.0], 10.0),
        (1.0, 0.4, 1.01, [40.0, 3.0], 0.0),
    ],
)
def test_a_still_level_is_rest_drift_or_a_hold(contact, force, back, level, largest):
    found = Following(contact, force, back).considered([40.0, 3.0])
    assert found == (level, largest)


def test_a_faint_force_is_followed_as_drift_up_to_five_seconds_at_a_time():
    faint = Following(contact=1.0, force=0.29)
    assert faint.considered([40.0, -0.5], largest_n=0.1) == ([1.0, -0.5], 0.1)
    strong = Following(contact=1.0, force=0.3)
    assert strong.considered([40.0, 3.0], largest_n=0.1) == ([0.0, 0.0], 0.1)
    late = Following(contact=0.0, force=5.0)
    assert late.considered([40.0, 3.0], elapsed_s=60.0)[0] == [5.0, 3.0]
    down = Following(contact=0.0, force=0.0, back=0.0)
    down.said[False] = (0.0, 5.0)
    down.said[True] = (0.0, 5.0)
    assert down.considered([-40.0, -3.0], elapsed_s=2.0)[0] == [-2.0, -2.0]


def test_the_largest_force_is_remembered_for_five_seconds_after_its_press():
    zero = RestZero(8, read)

    def at(time_s, force_n):
        zero.now_s = time_s
        zero.note_force(force_n)
        return zero.largest_n, zero.loaded_s

    assert at(1.0, 0.3)[0] == 0.0
    assert at(2.0, 0.31) == (0.31, 2.0)
    assert at(3.0, 8.0) == (8.0, 3.0)
    assert at(4.0, 1.2) == (8.0, 3.0)
    assert at(4.5, 1.21) == (8.0, 4.5)
    assert at(9.5, 0.0) == (8.0, 4.5)
    assert at(9.6, 0.0) == (0.0, 4.5)


def test_windows_last_six_tenths_of_a_second_and_eight_frames():
    zero = RestZero(8, lambda change, frames: StillReading(0.0, 0.0))
    for number in range(20):
        zero.pass_by(np.zeros(1), 0.05 * number)
    times = [time_s for time_s, _ in zero.window]
    assert times == pytest.approx([0.05 * k for k in range(7, 20)])
    slow = RestZero(5, lambda change, frames: StillReading(0.0, 0.0))
    for number in range(9):
        slow.pass_by(np.zeros(1), float(number))
    assert [time_s for time_s, _ in slow.window] == [4.0, 5.0, 6.0, 7.0, 8.0]
    unknown = RestZero(5, lambda change, frames: StillReading(0.0, 0.0))
    assert [unknown.pass_by(np.zeros(1)) for _ in range(2)] == pytest.approx([0.1, 0.1])
    assert slow.pass_by(np.zeros(1), 0.0) == -8.0
    assert len(slow.window) == 1


def test_modes_of_a_stream_s_zero():
    first = zeroing.StreamZero("first", 2, read)
    rows = [np.full(6, value) for value in (1.0, 3.0, 50.0)]
    assert [first.update(row, 0.0) is None for row in rows] == [True, True, False]
    assert first.update(rows[2], 0.0).tolist() == [2.0] * 6
    assert zeroing.StreamZero("none", 2, read).update(rows[0], 0.0).tolist() == [0.0] * 6


def test_a_level_that_is_given_is_rest_at_its_first_frame():
    """So drift since then is known, and holds against it are followed."""
    zero = StreamZero("rest", 8, read, level=np.full(6, 700.0))
    ages = []
    for number in range(3):
        zero.update(np.full(6, 700.0) + 8 * GAIN, 1e6 + number)
        ages.append(zero.age_s)
    assert ages == [0.0, 1.0, 2.0]


def test_a_mean_of_still_frames_begins_no_earlier_than_asked():
    """Its time counts: frames that pass by are in the window too, 0.6 s long."""
    zero = StreamZero("rest", 8, read, level=np.zeros(6))
    for number in range(10):
        zero.update(np.full(6, 5.0) + 8 * GAIN, 0.1 * number)
        zero.pass_by(np.full(6, 5.0) + 8 * GAIN, 0.1 * number + 0.02)
    assert zero.still_change(0.5) is None
    change, frames = zero.still_change(0.7)
    assert change.tolist() == pytest.approx((5.0 + 8 * GAIN).tolist())
    assert frames == 13


def test_what_holds_moved_is_given_back_where_it_is_a_press():
    """A hold's drift along the press is judged with what is followed at rest, but one long past is not."""
    for elapsed_s, back in ((1.0, True), (6000.0, False)):
        zero = RestZero(8, read, read)
        zero.start(np.zeros(6))
        zero.drift(2 * GAIN, 1.0)
        zero.drift(np.zeros(6), elapsed_s)
        zero.consider(2 * GAIN + 0.5, 1.0)
        assert (zero.level @ GAIN < 0.1 * GAIN @ GAIN) == back


def test_one_wrong_reading_does_not_move_the_zero():
    rows = np.tile([700.0, -20.0], (8, 1)) + np.arange(8)[:, None]
    wrong = rows.copy()
    wrong[3, 1] += 65_536
    np.testing.assert_allclose(zeroing.level_of(wrong), zeroing.level_of(rows), atol=1.0)


def test_a_window_that_a_press_begins_in_is_no_return():
    """A weak hold that scatters no more than noise: its first frame read alone shows the press."""
    force_n = np.concatenate([np.zeros(20), np.full(200, 1.2)])
    found = followed(
        stream(force_n, jump_counts=0.0, drift_per_s=0.0, hysteresis=0.0), RestZero(8, read)
    )
    assert abs(found[-150:].mean() - 1.2) < 0.1


def test_what_is_neither_rest_nor_press_leaves_the_zero_alone():
    zero = RestZero(8, lambda change, frames: StillReading(0.0, 0.0, explained=False))
    zero.level = np.zeros(2)
    zero.consider(np.array([400.0, -300.0]), 1.0)
    assert zero.level.tolist() == [0.0, 0.0]


def drifting(force_n, window_s=600.0):
    """The zero of a force that grows by 0.01 N/s beside slow drift, by a reader that knows drift."""

    def read_drift(followed, frames):
        # 49 counts of drift in ten minutes: the force along the press' direction within 2 σ is none
        sigma_n = 49.0 / np.linalg.norm(GAIN)
        found = read(followed)
        return StillReading(float(found.force_n > 2 * sigma_n), found.force_n)

    zero = RestZero(8, read, read_drift)
    return followed(stream(force_n, jump_counts=0.0, drift_per_s=0.02, hysteresis=0.0), zero)


def test_a_press_that_grows_slower_than_drift_is_seen_where_drift_is_known():
    force_n = np.concatenate([np.zeros(100), np.minimum(np.arange(0, 6, 0.0008), 4.0)])
    assert abs(drifting(force_n)[-300:].mean() - 4.0) < 0.5
    assert drifting(np.zeros(6000))[100:].max() < 1.0


class Changes:
    """A reader of changes, whose estimator is `read`."""

    def __init__(self):
        self.rezero()

    def rezero(self, level=None):
        self.level = StreamZero("rest", 8, read, level=level)

    def force_n(self, raw, time_s):
        zero = self.level.update(raw, time_s)
        return None if zero is None else read(raw - zero).force_n


def read_file(force_n, cells=None):
    """Force in every frame of a file and what is said; load cells where `cells` tells their force."""
    raw, reader = stream(force_n), Changes()
    loaded = None if cells is None else cells >= 0.3
    return read_through(len(raw), lambda n: reader.force_n(raw[n], n / RATE_HZ), reader, loaded)


@pytest.mark.parametrize("has_cells", [False, True])
def test_frames_of_a_file_that_begins_in_a_press_are_read_against_the_rest_that_follows(has_cells):
    force_n = forces(presses=4)[REST + RISE + 10 :]
    found, texts = read_file(force_n, force_n if has_cells else None)
    assert len(texts) == 1
    assert "does not begin at rest" in texts[0]
    error = np.abs(np.array(found, float) - force_n)
    assert error[: HOLD - 10].mean() < 0.12 * force_n.max()  # hysteresis and the shift of a press


def test_a_file_that_begins_at_rest_is_read_once():
    force_n = forces(presses=3)
    found, texts = read_file(force_n, force_n)
    assert texts == []
    assert found[0] is None
    assert np.mean(np.abs(np.array(found[12:], float) - force_n[12:])) < 1.0


def test_a_file_without_rest_is_told_by_its_load_cells():
    found, texts = read_file(np.full(80, 8.0), np.full(80, 8.0))
    assert all(one is None for one in found)
    assert "no still frames are at rest" in texts[0]
