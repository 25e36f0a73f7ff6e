"""Presses of a foreign log: runs of equal labels, what the label means, and the change against rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.adoption.chips import Counts
from estimator.adoption.columns import ForeignLog
from estimator.adoption.findings import CERTAIN, Finding, share_as_high
from estimator.recordings.presses import runs

LEVELS = 60
"""Different labels up to which they may be levels that a machine went to."""
_HELD = 0.6
"""Share of rows that repeat the label before, where it is a level: five rows a press give 0.8."""
_SETTLED = 1 / 3
"""Share of a press's rows before its reading: motors move there."""
_LOADED, _UNLOADED = 0.5, 0.1
"""Shares of a press's largest force above which it is loaded, below which at rest."""
_LONGEST_LAG = 20
"""Rows by which forces may come late, at most."""
_LEAST_ROWS = 3
_SHIFTS = 99
_UNLABELLED_ROWS = 1000
"""Rows of a log without labels that stand for its presses, spread evenly."""


@dataclass(frozen=True)
class ForeignPresses:
    """Change of every chip in every press.

    Attributes
    ----------
    face, place : (press, contact) as labelled; 0 where nothing is said
    label : (press, cell) force, level or travel in the file's own unit
    change : (press, chip, 3) against rest, counts; NaN for a chip that did not answer
    resting : (chip, 3) counts at rest
    rest_scatter : (stretch, chip, 3) stretches at rest against their neighbours': what no press makes
    """

    face: Int[np.ndarray, "press named"]
    place: Int[np.ndarray, "press placed"]
    label: Float[np.ndarray, "press cell"]
    change: Float[np.ndarray, "press chip 3"]
    resting: Float[np.ndarray, "chip 3"]
    rest_scatter: Float[np.ndarray, "stretch chip 3"]

    def __len__(self) -> int:
        return len(self.face)

    @property
    def size(self) -> Float[np.ndarray, "press chip"]:
        """Length of each chip's change, counts."""
        return np.linalg.norm(self.change, axis=2)

    @property
    def labelled(self) -> bool:
        """Return whether the log says which places were pressed."""
        return bool((self.place > 0).any())

    def select(self, rows: np.ndarray) -> ForeignPresses:
        """Some of the presses."""
        return ForeignPresses(
            self.face[rows], self.place[rows], self.label[rows], self.change[rows],
            self.resting, self.rest_scatter,
        )  # fmt: skip


def label_kind(log: ForeignLog, given: str | None) -> tuple[str, Finding]:
    """Tell a force from a level or travel of a machine.

    Levels are few, and each is kept for many rows; a load cell scatters from row to row.
    """
    labels = log.label[np.isfinite(log.label).all(axis=1)]
    if not labels.size:
        return "none", Finding("label", "none", "no column of forces, levels or travels")
    values = np.unique(labels)
    held = float(np.mean(np.all(np.diff(labels, axis=0) == 0, axis=1)))
    kind = "level" if len(values) <= LEVELS and held > _HELD else "force"
    name = f"the file calls it {log.stated!r}; " if log.stated else ""
    evidence = f"{name}{len(values)} values, {100 * held:.1f} % of rows repeat the row before"
    if given is not None:
        kind, evidence = given, f"as stated; {evidence}"
    words = {"level": "level of travel, not a force", "force": "force", "travel": "travel"}
    if kind not in words:
        raise RecordingError(f"label={kind} is no kind of label. Give {', '.join(words)}")
    return kind, Finding("label", words[kind], evidence)


def find_presses(
    log: ForeignLog, counts: Counts, kind: str
) -> tuple[ForeignPresses, list[Finding]]:
    """Cut a log into presses; rows stand for them, at place 0, where no column names places or faces.

    Raises
    ------
    RecordingError
        No press in it.
    """
    if not (log.place.shape[1] or log.face.shape[1]):
        return _unlabelled(counts), []
    face, place = _whole(log.face, log.place.shape[1]), _whole(log.place, log.face.shape[1])
    label = log.label if log.label.shape[1] else np.ones((len(counts), 1))
    label, findings = np.nan_to_num(label), []
    if kind == "force":
        label, findings = _without_lag(label, counts)
    idle = ~(place > 0).any(axis=1) | ~(face > 0).any(axis=1)
    if kind != "force":
        idle |= np.all(label == 0, axis=1)
    keys = np.column_stack([face, place, idle, *(label.T if kind != "force" else ())])
    _, block = np.unique(keys, axis=0, return_inverse=True)
    spans = [(a, b) for a, b in runs(block.ravel()) if b - a >= _LEAST_ROWS]
    cut = _cut_forces if kind == "force" else _cut_levels
    return cut(face, place, label, counts, spans, np.asarray(idle)), findings


def _unlabelled(counts: Counts) -> ForeignPresses:
    """Return rows against the level that most have: a log without labels has no more of its chips."""
    level = _median(counts)
    rows = counts[:: max(1, len(counts) // _UNLABELLED_ROWS)]
    zero = np.zeros((len(rows), 1), int)
    return ForeignPresses(zero + 1, zero, 0.0 * zero, rows - level, level, rows[:0])


def _whole(labels: Float[np.ndarray, "row contact"], others: int) -> Int[np.ndarray, "row contact"]:
    """Return labels as whole numbers, 0 where empty; ones where the file has none of this kind."""
    if labels.shape[1] == 0:
        return np.ones((len(labels), max(1, others)), int)
    return np.nan_to_num(labels).astype(int)


def _cut_levels(
    face: np.ndarray, place: np.ndarray, label: np.ndarray, counts: Counts,
    spans: list[tuple[int, int]], idle: Bool[np.ndarray, "row"],
) -> ForeignPresses:  # fmt: skip
    pressed = [(a, b) for a, b in spans if not idle[a]]
    resting = [(a, b) for a, b in spans if idle[a]]
    if not pressed:
        raise RecordingError("it holds no press: every row is labelled as rest")
    levels = np.array([_settled(counts, *span) for span in pressed])
    middle = np.array([(a + b) / 2 for a, b in pressed])
    first = [a for a, _ in pressed]
    if resting:
        rest_at = np.array([(a + b) / 2 for a, b in resting])
        rest = _interpolated(
            middle, rest_at, np.array([_settled(counts, *span) for span in resting])
        )
    else:
        rest = np.broadcast_to(_lowest(place[first], label[first], levels), levels.shape)
    scatter = _rest_scatter(counts, resting)
    return ForeignPresses(
        face[first], place[first], label[first], levels - rest, np.nanmedian(rest, axis=0), scatter
    )


def _settled(counts: Counts, first: int, end: int) -> Float[np.ndarray, "chip 3"]:
    """Return the median of a stretch after its first third, NaN for chips that do not answer."""
    part = counts[first + int(_SETTLED * (end - first)) : end]
    return _median(part)


def _median(part: np.ndarray) -> np.ndarray:
    """Median along the rows, NaN without a warning where none has a reading."""
    silent = ~np.isfinite(part).any(axis=0)
    return np.where(silent, np.nan, np.nanmedian(np.where(silent, 0.0, part), axis=0))


def _interpolated(
    middle_row: np.ndarray, known_at: np.ndarray, known_levels: np.ndarray
) -> np.ndarray:
    """Interpolate levels at rest along the rows, each channel over the stretches in which it answers."""
    flat = known_levels.reshape(len(known_levels), -1)
    levels = np.full((len(middle_row), flat.shape[1]), np.nan)
    for channel, values in enumerate(flat.T):
        if (live := np.isfinite(values)).any():
            levels[:, channel] = np.interp(middle_row, known_at[live], values[live])
    return levels.reshape(len(middle_row), *known_levels.shape[1:])


def _lowest(place: np.ndarray, label: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """Stand in for rest that was not recorded: the median over places of each one's lowest level."""
    total = label.sum(axis=1)
    lowest = [
        levels[rows[np.argmin(total[rows])]]
        for key in np.unique(place, axis=0)
        if len(rows := np.flatnonzero((place == key).all(axis=1)))
    ]
    return _median(np.array(lowest))


def _rest_scatter(counts: Counts, resting: list[tuple[int, int]]) -> np.ndarray:
    """Cut rest into stretches of 50 rows, each against the median of all."""
    parts = [counts[k : k + 50] for a, b in resting for k in range(a, b - 9, 50)]
    levels = np.array([_median(part) for part in parts]).reshape(-1, *counts.shape[1:])
    return levels - _median(levels) if len(levels) else levels


def _cut_forces(
    face: np.ndarray, place: np.ndarray, label: np.ndarray, counts: Counts,
    spans: list[tuple[int, int]], idle: Bool[np.ndarray, "row"],
) -> ForeignPresses:  # fmt: skip
    """Compare the loaded rows of each stretch of one label with those at rest, press by press."""
    total = label.sum(axis=1)
    rows, changes, rests, loads = [], [], [], []
    for first, end in spans:
        force = total[first:end]
        low, high = force.min(), force.max()
        loaded = force > low + _LOADED * (high - low)
        unloaded = force < low + _UNLOADED * (high - low)
        if idle[first] or min(loaded.sum(), unloaded.sum()) < _LEAST_ROWS:
            continue
        part = counts[first:end]
        rest = _median(part[unloaded])
        rows.append(first)
        rests.append(rest)
        changes.append(_median(part[loaded]) - rest)
        loads.append(np.median(label[first:end][loaded], axis=0))
    if not rows:
        raise RecordingError("it holds no press: forces do not rise and fall under any label")
    resting = np.array(rests)
    scatter = np.diff(resting, axis=0) if len(resting) > 1 else resting[:0]
    return ForeignPresses(
        face[rows], place[rows], np.array(loads), np.array(changes), _median(resting), scatter
    )


def _without_lag(
    label: Float[np.ndarray, "row cell"], counts: Counts
) -> tuple[Float[np.ndarray, "row cell"], list[Finding]]:
    """Bring forces to the rows whose signals they go with, by the best correlation with those."""
    activity = np.abs(counts - _median(counts)).reshape(len(counts), -1)
    activity = np.nan_to_num(activity / np.maximum(_median(activity), 1e-9)).mean(axis=1)
    total = label.sum(axis=1)
    fits = _lag_fits(total, activity)
    lag = int(np.argmax(fits))
    if lag == 0:
        return label, []
    rng = np.random.default_rng(22)
    # One shift each: presses in a steady beat would meet themselves again if the null sought its lag.
    null = [
        float(np.corrcoef(np.roll(total, int(by)), activity)[0, 1])
        for by in rng.integers(len(total) // 10, 9 * len(total) // 10, _SHIFTS)
    ]
    p = share_as_high(null, fits[lag])
    moved = np.concatenate([label[lag:], np.repeat(label[-1:], lag, axis=0)])
    answer = f"{lag} rows behind the chips; corrected"
    if p > CERTAIN:
        moved, answer = label, "cannot be told: forces stay as written"
    return moved, [
        Finding(
            "lag of forces", answer,
            f"correlation with the signals {fits[lag]:.2f} at {lag} rows, as written {fits[0]:.2f}",
            f"{np.median(null):.2f}", p,
        )
    ]  # fmt: skip


def _lag_fits(total: Float[np.ndarray, "row"], activity: Float[np.ndarray, "row"]) -> list[float]:
    """Correlation of forces with the signals at every lag in rows, 0 of forces that never change."""
    lags = range(min(_LONGEST_LAG, len(total) // 4) + 1)
    # a constant has no correlation
    if not total.std() or not activity.std():
        return [0.0]
    return [float(np.corrcoef(total[lag:], activity[: len(activity) - lag])[0, 1]) for lag in lags]
