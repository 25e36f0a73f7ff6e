"""Signs turned and channels exchanged in a part of a recording, found by how a place usually answers."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.checks.faults import Fault, known_mean, rows_text
from estimator.recordings.checks.place_labels import pattern_noises, press_patterns
from estimator.recordings.presses import CONTACT_FORCE_N, LEAST_CONTACT_FRAMES, runs
from estimator.recordings.table import channel_name

_ALIKE = 0.5
"""Cosine between the changes above and below rest: 1 where a force has the wrong sign, else −1."""
_HARDLY_ANY = 0.01
_LEAST_BLOCKS = 2
_ALIKE_AT_REST = 0.3
"""Scatter of signals over places at rest, over that in holds."""
_ANSWERS = 0.1
"""Share of a press's pattern (length 1) from which the sign of a channel counts."""
_BEYOND_NOISE = 3.0
"""Standard deviations: at places that hardly answer, noise alone turns channels."""
_REST_AGREES = 0.25
"""Length of the change of the other channels, of a pattern of length 1, below which they agree."""
_EXCHANGE_GAIN = 4.0


def turned_forces(
    force_n: Float[np.ndarray, "frame cell"],
    counts: Float[np.ndarray, "frame face sensor 3"],
    face: Int[np.ndarray, "frame cell"],
    block: Int[np.ndarray, "frame"],
    rest_force_n: float,
) -> tuple[Float[np.ndarray, "frame cell"], list[Fault]]:
    """Forces with the sign of those rows turned back in which a load cell shows pulls for presses.

    Rest is the level at which a cell dwells longest. Frames below it are presses with a wrong sign
    where the signals of the face change in the same direction as above it; were that level a hold,
    they would change in opposite ones. Said only where one place has both, or where no row is above that
    level: the cell counts the other way throughout then.
    """
    corrected, faults = force_n.copy(), []
    for cell in range(force_n.shape[1]):
        level = longest_level(force_n[:, cell], rest_force_n)
        above = force_n[:, cell] > level + CONTACT_FORCE_N
        below = force_n[:, cell] < level - CONTACT_FORCE_N
        at_level = np.abs(force_n[:, cell] - level) <= rest_force_n
        if above.mean() < _HARDLY_ANY and _rests_above(counts, block, at_level, force_n[:, cell]):
            corrected[:, cell] = 2 * level - force_n[:, cell]
            lowest = force_n[:, cell].min() - level
            detail = (
                f"cell {cell + 1} shows down to {lowest:.1f} N and nothing above its usual level, at which "
                "the signals of all places are alike, as at rest"
            )
            faults.append(Fault("force turned", "all rows", detail, "sign turned back"))
            continue
        if not change_alike(counts, face[:, cell], block, (at_level, above, below)):
            continue
        for first, last in runs((force_n[:, cell] < level - rest_force_n).astype(int)):
            if not below[first:last].any():
                continue
            rows = np.arange(first, last)
            corrected[rows, cell] = 2 * level - force_n[rows, cell]
            detail = (
                f"cell {cell + 1} shows down to {force_n[rows, cell].min() - level:.1f} N against "
                "rest, while the face answers as to a press"
            )
            faults.append(Fault("force turned", rows_text(rows), detail, "sign turned back"))
    return corrected, faults


def _rests_above(
    counts: Float[np.ndarray, "frame face sensor 3"],
    block: Int[np.ndarray, "frame"],
    at_level: Bool[np.ndarray, "frame"],
    force_n: Float[np.ndarray, "frame"],
) -> bool:
    """Return whether a cell that goes below its usual level alone rests there: the signals of all places
    are then alike there, and differ where it is lowest; were the level a hold, it would be the other way
    round."""
    middle = (np.median(force_n[at_level]) + force_n.min()) / 2
    lowest = force_n < middle
    means = []
    for first, last in runs(block):
        rows = [first + np.flatnonzero(part[first:last]) for part in (at_level, lowest)]
        if min(map(len, rows)) >= LEAST_CONTACT_FRAMES:
            means.append([known_mean(counts[part]) for part in rows])
    if len(means) < _LEAST_BLOCKS:
        return False
    scatter = np.sqrt(np.nanmean(np.var(means, axis=0), axis=(1, 2, 3)))
    return bool(scatter[0] < _ALIKE_AT_REST * scatter[1])


def longest_level(force_n: Float[np.ndarray, "frame"], width_n: float) -> float:
    """Middle of the window of that half-width which holds most frames."""
    ordered = np.sort(force_n)
    number = np.searchsorted(ordered, ordered + 2 * width_n, side="right") - np.arange(len(ordered))
    first = int(number.argmax())
    return float(np.median(ordered[first : first + number[first]]))


def change_alike(
    counts: Float[np.ndarray, "frame face sensor 3"],
    face: Int[np.ndarray, "frame"],
    block: Int[np.ndarray, "frame"],
    parts: tuple[Bool[np.ndarray, "frame"], ...],
) -> bool:
    """Return whether the face's signals change in one direction in both parts against the first."""
    cosines = []
    for first, last in runs(block):
        named = int(face[first])
        rows = [first + np.flatnonzero(part[first:last]) for part in parts]
        if named == NO_FACE or min(map(len, rows)) < LEAST_CONTACT_FRAMES:
            continue
        face_counts = counts[:, named - 1].reshape(len(counts), -1)
        level, above, below = (face_counts[part].mean(axis=0) for part in rows)
        up, down = above - level, below - level
        is_finite = np.isfinite(up) & np.isfinite(down)
        size = np.linalg.norm(up[is_finite]) * np.linalg.norm(down[is_finite])
        if size > 0:
            cosines.append(float(up[is_finite] @ down[is_finite] / size))
    return bool(cosines) and float(np.median(cosines)) > _ALIKE


def turned_channels(
    frames: FrameSet,
) -> tuple[Bool[np.ndarray, "face sensor 3"], list[Fault]]:
    """Channels that answer with turned sign, or in another's place, in some presses of a place.

    Any two presses of a place are compared; all other channels must agree. Places pressed once, and
    channels that hardly answer, cannot be judged.
    """
    press, place, pattern = press_patterns(frames)
    noise = pattern_noises(frames)
    shape = frames.signal_counts.shape[1:]
    pairs_by_fault: dict[tuple[str, tuple[int, ...]], list[tuple[int, int]]] = {}
    for first, second in combinations(range(len(press)), 2):
        if place[first] == place[second]:
            larger = np.fmax(noise[first], noise[second])
            kind, channels = unlike_model(pattern[second], pattern[first], larger)
            if channels:
                pairs_by_fault.setdefault((kind, channels), []).append((first, second))
    wrong, faults = np.zeros(shape, dtype=bool), []
    for (kind, channels), pairs in pairs_by_fault.items():
        indices = [tuple(int(i) for i in np.unravel_index(c, shape)) for c in channels]
        for index in indices:
            wrong[index] = True
        earlier, later = min(pairs, key=lambda pair: pair[1] - pair[0])
        last = np.flatnonzero(frames.press_id == press[earlier])[-1]
        begin = np.flatnonzero(frames.press_id == press[later])[0]
        where = f"{' and '.join(channel_name(*index) for index in indices)}, rows {last}–{begin}"
        detail = f"presses of one place before and after answer unlike ({len(pairs)} pairs)"
        faults.append(Fault(kind, where, detail, "set to NaN"))
    return wrong, faults


def unlike_model(
    pattern: Float[np.ndarray, "channel"],
    usual: Float[np.ndarray, "channel"],
    noise: Float[np.ndarray, "channel"] | float = 0.0,
) -> tuple[str, tuple[int, ...]]:
    """Kind of fault and the channels that explain why two presses of a place differ by more than their
    noise, if any do."""
    step = np.nan_to_num(pattern - usual)
    largest = np.argsort(-np.abs(step))[:2].tolist()
    channel = largest[0]
    beyond = _BEYOND_NOISE * np.broadcast_to(noise, step.shape)
    strong = min(abs(pattern[channel]), abs(usual[channel])) > max(_ANSWERS, beyond[channel])
    if (
        strong
        and pattern[channel] * usual[channel] < 0
        and _length(np.delete(step, channel)) < _REST_AGREES
    ):
        return "channel turned", (channel,)
    for a, b in combinations(sorted(largest), 2):
        exchanged = pattern.copy()
        exchanged[[a, b]] = pattern[[b, a]]
        rest = _length(np.nan_to_num(exchanged - usual))
        clear = np.all(np.abs(step[[a, b]]) > beyond[[a, b]])
        if clear and _length(step) > max(_REST_AGREES, _EXCHANGE_GAIN * rest):
            return "channels exchanged", (a, b)
    return "", ()


def _length(vector: Float[np.ndarray, "n"]) -> float:
    return float(np.sqrt(np.sum(vector**2)))
