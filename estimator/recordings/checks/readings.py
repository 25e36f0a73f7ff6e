"""Readings that no working sensor gives: constant, dropped to one value, clipped, copied, of another unit.

Every check takes raw counts and returns the readings that it names (same shape) and one sentence for each
cause. Proof of a fault is what noise cannot do: keep one number, or hit one number far more often than its
neighbours. Recordings without noise (simulated ones) therefore show none of it.
"""

from __future__ import annotations

from collections.abc import Callable
from hashlib import blake2b

import numpy as np
from jaxtyping import Bool, Float

from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.presses import runs
from estimator.recordings.table import channels_text

Counts = Float[np.ndarray, "frame face sensor 3"]
Readings = Bool[np.ndarray, "frame face sensor 3"]
Found = tuple[Readings, list[Fault]]

_FALSE_ALARMS = 2e-5
"""Runs of equal readings expected by chance in one channel, over all its readings."""
_LEAST_REPEATS = 3.0
LEAST_TURNS = 0.35
"""Share of steps that go the other way than the step before: 2/3 of white noise, near 0 of none."""
_ROUNDS = 6
"""Rounds of the search, at most."""
NO_ANSWER = (0.0, -1.0)
"""Counts that buses give for a chip that does not answer: lines held low, and held high."""
_LEAST_HITS = 8
"""Times that one value must stand out by, at least."""
_NEIGHBOURS = 5
"""Values on each side that one is compared with."""
_MOST_HITS = 3
"""Numbers that a sound channel drops to or ends at: 0 and both ends. More are bits lost on the way."""
_HIT_SIGMAS = 7.0
"""Standard deviations (Poisson) by which one value must stand out."""
_SPREAD_COUNTS = 2.0
"""Noise from which readings spread over enough values for one of them to stand out."""
_FEW_SPANS = 3
"""Spans of rows up to which all are named."""
_LEAST_COPY = 5
"""Rows of a copy, at least."""
_FINEST_COUNTS = 0.29
"""Noise (counts) of rounding to whole counts: 1/√12."""
_MOST_SPOILT = 0.1
"""Share of a channel's readings that may be spoilt."""
NOISE_FRAMES = 13
"""Frames in which a channel shows its noise: 0.13 s at 100 Hz."""
_NOISE_RANK, _NOISE_FACTOR = 4, 6.0
"""Six of the ten third differences of a window reach the one of this rank. Where that exceeds six
times what is usual, each of the six is beyond 3.3 σ. Ten times the noise is found with 95 %."""
_NOTHING = "readings not used"


def has_noise(counts: Counts) -> bool:
    """Return whether readings scatter as those of real sensors: most channels turn back and forth."""
    turning = []
    for channel in counts.reshape(len(counts), -1).T:
        step = np.diff(channel[np.isfinite(channel)])
        step = step[step != 0]
        if len(step) > 2 * _LEAST_REPEATS:
            turning.append(np.mean(step[1:] * step[:-1] < 0))
    return bool(turning) and float(np.median(turning)) >= LEAST_TURNS


def too_long(repeated: Bool[np.ndarray, "reading"]) -> Bool[np.ndarray, "reading"]:
    """Readings of runs in which more repeat the one before than chance allows.

    The chance of a repeat is the share of repeats outside such runs, found by rounds. A
    sensor slower than its logger repeats often, and so may repeat for longer.
    """
    in_long_run = np.zeros(len(repeated), bool)
    stretches = [(a, b) for a, b in runs(repeated.astype(int)) if repeated[a]]
    for _ in range(_ROUNDS):
        free = repeated[~in_long_run]
        share = float(np.mean(free)) if len(free) else 0.0
        least = longest_by_chance(np.array(max(share, 1 / len(repeated))), len(repeated))
        now = np.zeros(len(repeated), bool)
        for first, last in stretches:
            # the reading before the first repeat has the same value: it stood still, too
            now[max(0, first - 1) : last] |= last - first >= least
        if np.array_equal(now, in_long_run):
            break
        in_long_run = now
    return in_long_run


def longest_by_chance(share: Float[np.ndarray, "*channel"], readings: int) -> np.ndarray:
    """Return the repeats on end that chance makes `_FALSE_ALARMS` times in n readings, 3 at least.

    `share` of the readings repeat, more than 0; where all do, no run is too long.
    """
    # A run of k repeats has the chance share^k, and may begin at each of the readings.
    with np.errstate(divide="ignore"):
        longest = np.log(_FALSE_ALARMS / max(readings, 1)) / np.log(share)
    return np.where(share >= 1, np.inf, np.maximum(longest, _LEAST_REPEATS))


def blank_chips(counts: Counts) -> Found:
    """Chips whose axes all read 0, or all −1, at once: they do not answer."""
    frames, faces, sensors, _ = counts.shape
    named, faults = np.zeros(counts.shape, bool), []
    for value in NO_ANSWER:
        chips = np.all(counts == value, axis=3)
        # three levels that happen to lie at 0 meet there once in a recording, hardly twice
        chips &= (chips.sum(axis=0) > 1) & np.any(counts != value, axis=(0, 3))
        mask = np.broadcast_to(chips[..., None], (frames, faces, sensors, 3))
        faults += _faults("no answer", mask, counts, f"read {value:g} on all axes")
        named |= mask
    return named, faults


def equal_frames(counts: Counts) -> Found:
    """Frames in which every channel reads one and the same number: the board sent no readings."""
    flat = counts.reshape(len(counts), -1)
    is_finite = np.isfinite(flat)
    high = np.max(flat, axis=1, where=is_finite, initial=-np.inf)
    low = np.min(flat, axis=1, where=is_finite, initial=np.inf)
    rows = (high == low) & (is_finite.sum(axis=1) > 3)
    rows &= bool(np.any(high > low))
    mask = is_finite.reshape(counts.shape) & rows[:, None, None, None]
    return mask, _faults("no answer", mask, counts, "read one number in every channel")


def hit_values(counts: Counts) -> Found:
    """Single numbers hit far more often than their neighbours: clipping, and drop-outs."""
    faults: list[Fault] = []
    clipped, dropped, garbled = (np.zeros(counts.shape, bool) for _ in range(3))
    for index in np.ndindex(*counts.shape[1:]):
        column = (slice(None), *index)
        hits = _hits(counts[column])
        garbled[column] = (len(hits) > _MOST_HITS) & np.isfinite(counts[column])
        for value, extreme in hits[: _MOST_HITS * (len(hits) <= _MOST_HITS)]:
            (clipped if extreme else dropped)[column] |= counts[column] == value
    faults += _faults(
        "lost bits", garbled, counts, "prefer some numbers (powers of 2?) all the time"
    )
    for value in np.unique(counts[dropped]):
        mask = dropped & (counts == value)
        faults += _faults("drop-outs", mask, counts, f"drop to {value:g} and come back")
    for index in np.argwhere(clipped.any(axis=0)).tolist():
        mask = np.zeros(counts.shape, bool)
        column = (slice(None), *index)
        mask[column] = clipped[column]
        limits = " and ".join(f"{value:g}" for value in np.unique(counts[mask]))
        faults += _faults("clipped", mask, counts, f"end at {limits}, as if cut off there", 0)
    return clipped | dropped | garbled, faults


def _hits(channel: Float[np.ndarray, "frame"]) -> list[tuple[float, bool]]:
    """Numbers that one channel hits too often, and whether they are its largest or smallest."""
    values = channel[np.isfinite(channel)]
    value, number = np.unique(values, return_counts=True)
    step = np.abs(np.diff(values))
    if len(value) < 4 * _NEIGHBOURS or np.median(step[step > 0]) < _SPREAD_COUNTS:
        return []
    padded = np.pad(number.astype(float), _NEIGHBOURS, constant_values=np.nan)
    beside = np.lib.stride_tricks.sliding_window_view(padded, 2 * _NEIGHBOURS + 1)
    usual = np.nanmean(np.delete(beside, _NEIGHBOURS, axis=1), axis=1)
    # beyond the scatter of a Poisson number, where neighbours are hit `usual` times
    most = usual + _HIT_SIGMAS * np.sqrt(usual) + _LEAST_HITS
    hits = []
    for k in np.flatnonzero(number > most).tolist():
        parts = [b - a for a, b in runs((values == value[k]).astype(int)) if values[a] == value[k]]
        if number[k] - max(parts) > most[k]:  # else it stood still once: `standing` says so
            extreme = k in (0, len(value) - 1) and value[k] not in NO_ANSWER
            hits.append((float(value[k]), extreme))
    return hits


def standing(counts: Counts) -> Found:
    """Chips, and single channels, that keep one number for longer than their noise lets them."""
    named = np.zeros(counts.shape, bool)
    for face, sensor in np.ndindex(*counts.shape[1:3]):
        for axes in (slice(0, 3), slice(0, 1), slice(1, 2), slice(2, 3)):
            chip = counts[:, face, sensor, axes]
            rows = np.flatnonzero(np.isfinite(chip).all(axis=1))
            values = chip[rows]
            if len(values) < 2 or np.all(values == values[0]):
                continue  # a dead channel
            repeated = np.r_[False, np.all(values[1:] == values[:-1], axis=1)]
            named[rows[too_long(repeated)], face, sensor, axes] = True
    return named, _faults(
        "standing still", named, counts, "keep their numbers, which noise does not let"
    )


def copied_rows(counts: Counts) -> Found:
    """Blocks of frames that were there before, number for number, under other stamps."""
    is_finite = np.isfinite(counts).reshape(len(counts), -1)
    flat = np.nan_to_num(counts.reshape(len(counts), -1), nan=np.inf)
    rows = np.flatnonzero(2 * is_finite.sum(axis=1) > is_finite.any(axis=0).sum())
    # a slower sensor repeats rows: of those on end, the first counts
    rows = (
        rows[np.r_[True, np.any(flat[rows[1:]] != flat[rows[:-1]], axis=1)]] if len(rows) else rows
    )
    first: dict[bytes, int] = {}
    back = np.array(
        [k - first.setdefault(flat[row].tobytes(), k) for k, row in enumerate(rows)], int
    )
    mask, faults = np.zeros(counts.shape, bool), []
    for begin, end in runs(back) if len(back) else []:
        if not back[begin] or end - begin < _LEAST_COPY:
            continue
        last = int(rows[end]) if end < len(rows) else len(counts)
        copy = np.arange(rows[begin], last)
        source = rows[begin - back[begin]] + np.arange(len(copy))
        mask[copy] = True
        detail = f"repeat {rows_text(source)} number for number under other time stamps"
        faults.append(Fault("copied rows", rows_text(copy), detail, "copies not used"))
    return mask, faults


def fingerprints(counts: Counts) -> Float[np.ndarray, "frame face"]:
    """Return a number that the counts of a face share with copies of them alone (equal by chance once in
    2^52); NaN where a face has no reading, and throughout without noise, where equal counts say nothing."""
    prints = np.full(counts.shape[:2], np.nan)
    if has_noise(counts):
        for frame, face in np.argwhere(np.isfinite(counts).any(axis=(2, 3))).tolist():
            digest = blake2b(np.ascontiguousarray(counts[frame, face]).tobytes(), digest_size=8)
            # 52 bits are whole numbers of a float
            prints[frame, face] = int.from_bytes(digest.digest()) >> 12
    return prints


def counts_of_another_unit(counts: Counts) -> Found:
    """Channels whose noise and steps no converter of whole counts has: divided by 1000, or in mT."""
    mask = np.zeros(counts.shape, bool)
    for index in np.ndindex(*counts.shape[1:]):
        readings = counts[(slice(None), *index)]
        readings = readings[np.isfinite(readings)]
        step = np.abs(np.diff(readings))
        if np.any(step > 0):
            # 0.6745: the median of |x| of a normal x; two readings make a step
            noise = np.median(step[step > 0]) / 0.6745 / np.sqrt(2)
            whole = np.all(readings == np.round(readings))
            tens = np.all(readings % 10 == 0)
            mask[(slice(None), *index)] = tens or (not whole and noise < _FINEST_COUNTS)
    mask &= np.isfinite(counts)
    text = (
        "change by fractions of a count, or by tens alone, as no converter does: they were divided or "
        "multiplied (by 1000?), or are in mT; give raw counts"
    )
    return mask, _faults("counts of another unit", mask, counts, text)


def constant(counts: Counts) -> Found:
    """Channels that show one number throughout, while others move."""
    is_finite = np.isfinite(counts)
    first = np.nan_to_num(counts[is_finite.argmax(axis=0), *np.indices(counts.shape[1:])])
    dead = np.all((counts == first) | ~is_finite, axis=0) & (is_finite.sum(axis=0) > 1)
    mask = is_finite & dead
    return mask, _faults("standing still", mask, counts, "show one number throughout")


def noise_levels(window: Float[np.ndarray, "frame *channel"]) -> Float[np.ndarray, "*channel"]:
    """Return a measure of each channel's noise over `NOISE_FRAMES` frames; 0 where readings miss.

    Third differences hardly feel presses (a tap of 5 Hz at 50 frames/s keeps a quarter), and a jump
    touches four of the ten: fewer than half.
    """
    third = np.abs(np.diff(window, n=3, axis=0))
    return np.nan_to_num(np.partition(third, _NOISE_RANK, axis=0)[_NOISE_RANK])


def is_noisy(
    level: Float[np.ndarray, "*frame face sensor 3"], usual: Float[np.ndarray, "face sensor 3"]
) -> Bool[np.ndarray, "*frame face sensor 3"]:
    """Return which noise levels are far above what is usual on most chips, axis by axis."""
    live = np.where(usual > 0, usual, np.nan).reshape(-1, 3)
    with np.errstate(invalid="ignore"):
        typical = [np.median(axis[axis > 0]) if np.any(axis > 0) else np.inf for axis in live.T]
    return level > _NOISE_FACTOR * np.array(typical)


def noisy(counts: Counts) -> Found:
    """Channels that are far noisier than other chips' for a while: a loose wire, a chip that fails."""
    mask = np.zeros(counts.shape, bool)
    if len(counts) < NOISE_FRAMES:
        return mask, []
    level = np.zeros((len(counts) - NOISE_FRAMES + 1, *counts.shape[1:]))
    for index in np.ndindex(*counts.shape[1:]):
        channel = counts[(slice(None), *index)]
        windows = np.lib.stride_tricks.sliding_window_view(channel, NOISE_FRAMES)
        level[(slice(None), *index)] = noise_levels(windows.T)
    loud = is_noisy(level, np.median(level, axis=0))
    for late in range(NOISE_FRAMES):
        mask[late : late + len(loud)] |= loud
    mask &= np.isfinite(counts)
    return mask, _faults("noisy channel", mask, counts, "are far noisier than those of other chips")


Check = Callable[[Counts], Found]
STREAM: tuple[Check, ...] = (equal_frames, blank_chips, hit_values, constant, standing, noisy)
CHECKS: tuple[Check, ...] = (
    equal_frames,
    blank_chips,
    hit_values,
    standing,
    copied_rows,
    counts_of_another_unit,
)
"""Checks of raw counts, in this order: what one names, the next do not see. `STREAM` is for readings
without labels; recordings call constant channels dead."""


def without_faults(
    counts: Counts, checks: tuple[Check, ...] = CHECKS
) -> tuple[Counts, list[Fault]]:
    """Counts with NaN for readings that a check names, and what was named."""
    faults: list[Fault] = []
    if not has_noise(counts):
        return counts, faults
    for check in checks:
        mask, check_faults = check(counts)
        counts, faults = np.where(mask, np.nan, counts), faults + check_faults
    return counts, faults


def spoilt_channels(
    counts: Float[np.ndarray, "frame face sensor 3"], lost: Bool[np.ndarray, "frame face sensor 3"]
) -> tuple[Bool[np.ndarray, "face sensor 3"], list[Fault]]:
    """Channels of which more than a tenth of the readings is `lost` to faults: to leave them out costs
    less than their frames. Frames that lack half of the channels count for none."""
    has_reading = np.isfinite(counts) | lost
    whole = 2 * lost.sum(axis=(1, 2, 3)) >= has_reading.sum(axis=(1, 2, 3))
    part = (lost & ~whole[:, None, None, None]).sum(axis=0)
    share = part / np.maximum((has_reading & ~whole[:, None, None, None]).sum(axis=0), 1)
    spoilt = share > _MOST_SPOILT
    channels = [tuple(index) for index in np.argwhere(spoilt).tolist()]
    if not channels:
        return spoilt, []
    detail = f"more than {100 * _MOST_SPOILT:.0f} % of their readings are named above"
    where = channels_text(channels, np.any(has_reading, axis=0))
    return spoilt, [Fault("channels left out", where, detail, "set to NaN")]


def _faults(
    kind: str, mask: Readings, counts: Counts, detail: str, few_spans: int = _FEW_SPANS
) -> list[Fault]:
    """Return a sentence for channels that share their rows, for each span of rows where they are few."""
    alike: dict[bytes, list[tuple[int, ...]]] = {}
    for index in np.argwhere(mask.any(axis=0)).tolist():
        # spans that chance repeats made a row or two longer are one and the same
        spans = [(a, b) for a, b in runs(mask[(slice(None), *index)].astype(int))]
        spans = [(a, b) for a, b in spans if mask[(a, *index)]]
        shown = spans if len(spans) <= few_spans else [(spans[0][0], spans[-1][1])]
        for first, last in shown:
            key = next((k for k in alike if _near(k, (first, last))), _key(first, last))
            alike.setdefault(key, []).append(tuple(index))
    live = np.asarray(np.isfinite(counts).any(axis=0))
    faults = []
    for key, channels in alike.items():
        first, last = np.frombuffer(key, int)
        part = mask[first:last][(slice(None), *np.array(channels).T)]
        where = f"{channels_text(channels, live)}, {rows_text(np.arange(first, last))}"
        rows = int(part.any(axis=1).sum())
        number = "" if part.all() else f" ({rows} rows of {last - first})"
        faults.append(Fault(kind, where, detail + number, _NOTHING))
    return faults


def _key(first: int, last: int) -> bytes:
    return np.array([first, last]).tobytes()


def _near(key: bytes, span: tuple[int, int]) -> bool:
    return bool(np.all(np.abs(np.frombuffer(key, int) - span) <= _LEAST_REPEATS))
