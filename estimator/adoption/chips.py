"""Chips of a foreign log that do not answer, answer in another's column, or give single wrong readings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.optimize import linear_sum_assignment

from estimator.adoption.findings import Finding, numbers_text, share_as_high
from estimator.recordings.checks.readings import blank_chips, constant, equal_frames, standing
from estimator.recordings.checks.readings import without_faults as checked
from estimator.recordings.presses import runs

Counts = Float[np.ndarray, "row chip 3"]
Spans = tuple[tuple[int, int], ...]
_SPIKE = 8.0
"""Size of a single wrong reading over the usual bend of its channel (99th percentile)."""
_LEAST_SPAN = 3
"""Rows in which a chip is silent, at least, to be named by its span."""
_SHIFTS = 200
"""Exchanges of levels behind the null of moved columns."""


@dataclass(frozen=True)
class CleanChips:
    """Counts with NaN for readings that cannot be meant, each in its own chip's place; what was found."""

    counts: Counts
    findings: tuple[Finding, ...]


def clean_chips(counts: Counts) -> CleanChips:
    """Name silent chips, columns that moved with them, constant and wrong readings; take them out."""
    silent = np.asarray(_checked(counts, blank_chips, equal_frames).all(axis=2))
    used = np.where(silent[..., None], np.nan, counts)
    still = _checked(used, constant, standing)
    frozen = np.asarray(still.all(axis=2))
    gone = silent | frozen
    findings = [_silent_finding(counts, silent, *group) for group in _grouped(gone).items()]
    findings += _frozen_findings(counts, frozen)
    used[frozen] = np.nan
    for rows, kept in _moved_columns(used, gone, findings):
        moved = used[rows][:, ~gone[rows].all(axis=0)].copy()
        used[rows] = np.nan
        used[np.flatnonzero(rows)[:, None], kept] = moved
    if (partly := still & ~frozen[..., None]).any():
        findings.append(_still_finding(partly))
        used = np.where(_checked(used, constant, standing), np.nan, used)
    spikes = wrong_readings(used)
    if spikes.any():
        findings.append(_spike_finding(used, spikes))
    return CleanChips(np.where(spikes, np.nan, used), tuple(findings))


def _silent_finding(
    counts: Counts, silent: Bool[np.ndarray, "row chip"], spans: Spans, chips: list[int]
) -> Finding:
    rows = np.zeros(len(counts), bool)
    for first, end in spans:
        rows[first:end] = True
    answers = counts[rows][:, chips][silent[rows][:, chips]]
    value = " or ".join(f"{v:g}" for v in np.unique(answers))
    where = "all rows" if rows.all() else f"rows {_spans_text(spans)}"
    exact = f"all axes exactly {value}" if value else "all axes keep one number"
    return Finding("silent chips", f"chips {numbers_text([c + 1 for c in chips])}, {where}", exact)


def _frozen_findings(counts: Counts, frozen: Bool[np.ndarray, "row chip"]) -> list[Finding]:
    """Name chips that repeat one reading, three at most."""
    findings = []
    for chip in np.flatnonzero(frozen.any(axis=0))[:3].tolist():
        rows = np.flatnonzero(frozen[:, chip])
        reading = ", ".join(f"{v:g}" for v in counts[rows[0], chip])
        where = (
            f"rows {rows[0]}-{rows[-1]}" if len(rows) == np.ptp(rows) + 1 else f"{len(rows)} rows"
        )
        findings.append(
            Finding(
                "wrong readings", f"chip {chip + 1}, {where}: ({reading})", "repeated; not used"
            )
        )
    return findings


def _checked(counts: Counts, *checks: object) -> Bool[np.ndarray, "row chip 3"]:
    """Return the readings that checks of recordings name: those take chips by fives of faces."""
    chips = counts.shape[1]
    padded = np.full((len(counts), 5 * -(-chips // 5), 3), np.nan)
    padded[:, :chips] = counts
    by_face = padded.reshape(len(counts), 5, -1, 3)
    kept, _ = checked(by_face, checks)  # pyright: ignore[reportArgumentType]
    named = np.isnan(kept) & np.isfinite(by_face)
    return named.reshape(padded.shape)[:, :chips]


def _grouped(silent: Bool[np.ndarray, "row chip"]) -> dict[Spans, list[int]]:
    """Return the chips that are silent in the same rows, by their spans."""
    groups: dict[Spans, list[int]] = {}
    for chip in range(silent.shape[1]):
        spans = tuple(
            (a, b)
            for a, b in runs(silent[:, chip].astype(int))
            if silent[a, chip] and b - a >= _LEAST_SPAN
        )
        if spans:
            groups.setdefault(spans, []).append(chip)
    return groups


def _spans_text(spans: Spans) -> str:
    shown = [f"{a}-{b - 1}" for a, b in spans[:3]]
    return ", ".join(shown) + (f" and {len(spans) - 3} more" if len(spans) > 3 else "")


def _moved_columns(
    used: Counts, silent: Bool[np.ndarray, "row chip"], findings: list[Finding]
) -> list[tuple[Bool[np.ndarray, "row"], Int[np.ndarray, "part"]]]:
    """Find rows in which a logger that skips silent chips moved the others into their columns.

    The levels of the chips that answer are laid on those of all chips in the other rows, as they fit best;
    the null does so with the levels exchanged among chips and axes. Returns the chips that columns hold.
    """
    moves = []
    for spans, chips in _grouped(silent).items():
        rows = np.zeros(len(used), bool)
        for first, end in spans:
            rows[first:end] = True
        answering = np.flatnonzero(~silent[rows].all(axis=0))
        full = ~silent.any(axis=1)
        if not full.any() or len(answering) + len(chips) != used.shape[1]:
            continue
        level = np.nanmedian(used[full], axis=0)
        span_level = np.nanmedian(used[rows][:, answering], axis=0)
        as_written = _left(level[answering], span_level)
        kept, residual = _aligned(level, span_level)
        missing = [c for c in range(used.shape[1]) if c not in kept]
        if missing == chips or residual > as_written / 2:
            continue
        rng = np.random.default_rng((0, 21))
        null = [
            _aligned(level, rng.permuted(span_level.ravel()).reshape(-1, 3))[1]
            for _ in range(_SHIFTS)
        ]
        findings.append(
            Finding(
                "columns moved",
                f"chips {numbers_text([c + 1 for c in missing])} are missing in rows {_spans_text(spans)}; "
                f"columns of chips {numbers_text([int(c) + 1 for c in answering])} hold chips "
                f"{_chips_text(kept)}",
                f"levels differ by {residual:.0f} counts, as written by {as_written:.0f}",
                f"{np.median(null):.0f} counts",
                share_as_high([-value for value in null], -residual),
            )
        )
        moves.append((rows, kept))
    return moves


def _chips_text(chips: Int[np.ndarray, "part"]) -> str:
    numbers = [int(chip) + 1 for chip in chips]
    rising = numbers == sorted(numbers)
    return numbers_text(numbers) if rising else f"{', '.join(map(str, numbers))}, in this order"


def _left(levels: np.ndarray, levels_there: np.ndarray) -> float:
    """Root mean square of what two sets of levels differ by."""
    return float(np.sqrt(np.nanmean((levels - levels_there) ** 2)))


def _aligned(level: np.ndarray, part: np.ndarray) -> tuple[Int[np.ndarray, "part"], float]:
    """Lay each chip of a part on another one of all chips, so that levels differ least; rms left."""
    apart = np.sum((part[:, None] - level[None]) ** 2, axis=2)
    row, kept = linear_sum_assignment(apart)
    return kept, float(np.sqrt(apart[row, kept].mean() / 3))


def wrong_readings(counts: Counts) -> Bool[np.ndarray, "row chip 3"]:
    """Return single readings that leave both neighbours, which agree, by far more than any other does."""
    # bend: how far a reading lies off the middle of its two neighbours
    bend = np.zeros(counts.shape)
    bend[1:-1] = np.abs(counts[1:-1] - (counts[:-2] + counts[2:]) / 2)
    apart = np.zeros(counts.shape)
    apart[1:-1] = np.abs(counts[2:] - counts[:-2])
    usual = np.nanpercentile(np.nan_to_num(bend), 99, axis=0)
    return (bend > _SPIKE * np.maximum(usual, 1.0)) & (apart < bend / 2)


def _spike_finding(counts: Counts, spikes: Bool[np.ndarray, "row chip 3"]) -> Finding:
    spots = np.argwhere(spikes)
    shown = "; ".join(
        f"chip {c + 1} {'xyz'[a]}, row {r}: {counts[r, c, a]:g} beside {counts[r - 1, c, a]:g}"
        for r, c, a in spots[:3].tolist()
    )
    more = f" and {len(spots) - 3} more" if len(spots) > 3 else ""
    return Finding(
        "wrong readings", f"{shown}{more}", "single rows whose neighbours agree; not used"
    )


def _still_finding(still: Bool[np.ndarray, "row chip 3"]) -> Finding:
    share = still.mean(axis=0)
    chips = np.flatnonzero(still.any(axis=(0, 2)))
    return Finding(
        "readings that stand still",
        f"chips {numbers_text([int(c) + 1 for c in chips])}, up to {100 * share.max():.0f} % of the rows",
        "keep one number for longer than their noise lets them; not used",
    )
