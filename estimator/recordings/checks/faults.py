"""Faults of recordings, found from the data alone: channels, labels and stamps."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE
from estimator.recordings.table import RawTable, channel_name

NOISY_FACTOR = 3.0
"""Noise over the median of an axis from which a channel is noisy."""
JUMP_COUNTS = 500.0
"""Change of the level at rest between two recordings that is reported."""
_MOVED_COUNTS = 150.0
"""Median change of the channels at rest that is reported."""
_OPPOSITE_MM = 6.0
"""Two hand labels, each good to about one pixel of 3 mm."""


@dataclass(frozen=True)
class Fault:
    """Fault that was found, where, and what was done about it."""

    kind: str
    where: str
    detail: str
    action: str

    def __str__(self) -> str:
        return f"{self.kind}: {self.where}: {self.detail}; {self.action}"


Channels = Bool[np.ndarray, "face sensor 3"]
"""Channels that a check names."""


def rest_noise_counts(
    counts: Float[np.ndarray, "frame face sensor 3"],
    rest: Bool[np.ndarray, "frame"],
    stale: Bool[np.ndarray, "frame face sensor"] | None = None,
) -> Float[np.ndarray, "face sensor 3"]:
    """White noise (counts) of each channel, from the differences of neighbouring rest frames.

    NaN where a channel has no reading in two neighbouring rest frames. Readings that a slow sensor only
    repeats (`stale`) are no second ones.
    """
    pairs = rest[1:] & rest[:-1]
    step = np.diff(counts, axis=0)[pairs]
    is_finite = np.isfinite(step)
    if stale is not None:
        is_finite &= ~stale[1:][pairs][..., None]
    number = is_finite.sum(axis=0)
    mean_square = np.where(is_finite, step, 0.0) ** 2
    return np.where(number > 0, np.sqrt(mean_square.sum(0) / np.maximum(number, 1) / 2), np.nan)


def known_mean(counts: Float[np.ndarray, "frame *channel"]) -> Float[np.ndarray, "*channel"]:
    """Mean of the readings that are there; NaN where there is none."""
    is_finite = np.isfinite(counts)
    number = is_finite.sum(axis=0)
    return np.where(
        number > 0, np.where(is_finite, counts, 0.0).sum(0) / np.maximum(number, 1), np.nan
    )


def axis_noise_counts(noise_counts: Float[np.ndarray, "face sensor 3"]) -> Float[np.ndarray, "3"]:
    """Median over the live channels of each axis, NaN for an axis that has none."""
    live_noise = [axis[np.isfinite(axis)] for axis in np.moveaxis(noise_counts, 2, 0)]
    return np.array([np.median(axis) if len(axis) else np.nan for axis in live_noise])


def dead_channels(
    counts: Float[np.ndarray, "frame face sensor 3"],
) -> tuple[Channels, list[Fault]]:
    """Channels without any reading, or stuck at one value, on faces that have readings at all."""
    is_finite = np.isfinite(counts)
    absent_face = np.all(~is_finite, axis=(0, 2, 3))
    low = np.min(counts, axis=0, where=is_finite, initial=np.inf)
    high = np.max(counts, axis=0, where=is_finite, initial=-np.inf)
    dead = (high <= low) & ~absent_face[:, None, None]
    names = [channel_name(*index) for index in np.argwhere(dead).tolist()]
    return dead, [Fault("dead channel", name, "no varying reading", "set to NaN") for name in names]


def noisy_channels(
    noise_counts: Float[np.ndarray, "face sensor 3"],
) -> tuple[Channels, list[Fault]]:
    """Channels whose rest noise exceeds `NOISY_FACTOR` times the median of their axis."""
    typical, faults = axis_noise_counts(noise_counts), []
    with np.errstate(invalid="ignore"):
        noisy = noise_counts > NOISY_FACTOR * typical
    for index in np.argwhere(noisy).tolist():
        sigma, axis = noise_counts[tuple(index)], index[2]
        detail = f"σ {sigma:.0f} counts at rest, {typical[axis]:.0f} are typical of {'XYZ'[axis]}"
        faults.append(Fault("noisy channel", channel_name(*index), detail, "set to NaN"))
    return noisy, faults


def jumped_channels(
    first_rest_counts: Float[np.ndarray, "face sensor 3"],
    other_rest_counts: Float[np.ndarray, "face sensor 3"],
) -> Bool[np.ndarray, "face sensor 3"]:
    """Channels whose rest level moved by more than `JUMP_COUNTS` between two recordings."""
    with np.errstate(invalid="ignore"):
        return np.abs(other_rest_counts - first_rest_counts) > JUMP_COUNTS


def jump_faults(
    rest_counts: Float[np.ndarray, "press face sensor 3"],
) -> tuple[Channels, list[Fault]]:
    """Channels whose rest level jumps by more than `JUMP_COUNTS` from one press to the next.

    Where many channels move at once the shell moved against the core (or other magnets came
    near): that is reported, and the channels stay, for every press has its own zero.
    """
    jumping = np.zeros(rest_counts.shape[1:], dtype=bool)
    faults = []
    for number, (earlier, later) in enumerate(pairwise(rest_counts), start=1):
        step = np.where(np.isfinite(later - earlier), np.abs(later - earlier), np.nan)
        live = step[np.isfinite(step)]
        if live.size and np.median(live) > _MOVED_COUNTS:
            detail = f"rest moved by {np.median(live):.0f} counts (median of channels)"
            faults.append(
                Fault(
                    "shell moved", f"before press {number}", detail, "kept: zeroed press by press"
                )
            )
            continue
        for index in np.argwhere(step > JUMP_COUNTS).tolist():
            detail = f"rest level {earlier[tuple(index)]:.0f} → {later[tuple(index)]:.0f} counts"
            where = f"{channel_name(*index)}, before press {number}"
            faults.append(Fault("jumping channel", where, detail, "set to NaN"))
            jumping[tuple(index)] = True
    return jumping, faults


def press_responses(
    counts: Float[np.ndarray, "frame face sensor 3"],
    force_n: Float[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
) -> Float[np.ndarray, "press face"]:
    """Change of each face's signals (rms counts over live channels) between rest and full force."""
    return face_sizes(press_changes(counts, force_n, press))


def press_changes(
    counts: Float[np.ndarray, "frame face sensor 3"],
    force_n: Float[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
) -> Float[np.ndarray, "press face sensor 3"]:
    """Return the mean change (counts) of every channel between rest and full force of each press."""
    total = force_n.sum(axis=1)
    changes = np.full((press.max() + 1, *counts.shape[1:]), np.nan)
    for number in range(len(changes)):
        frames = np.flatnonzero(press == number)
        low, high = np.percentile(total[frames], [15, 75])
        rest, loaded = frames[total[frames] <= low], frames[total[frames] >= high]
        changes[number] = counts[loaded].mean(axis=0) - counts[rest].mean(axis=0)
    return changes


def face_sizes(
    changes: Float[np.ndarray, "*press face sensor 3"],
) -> Float[np.ndarray, "*press face"]:
    """Return the rms over each face's live channels; NaN where a face has none."""
    live = np.isfinite(changes).sum(axis=(-2, -1))
    square_sum = np.nansum(changes**2, axis=(-2, -1))
    return np.where(live > 0, np.sqrt(square_sum / np.maximum(live, 1)), np.nan)


def correct_face_labels(
    table: RawTable, press: Int[np.ndarray, "frame"], responses: Float[np.ndarray, "press face"]
) -> tuple[Int[np.ndarray, "frame cell"], list[Fault]]:
    """Face labels of a gripper with both cells on different faces.

    Two jaws cannot press one face. The cell whose label departs from its own usual face gets
    that face; where no face is usual, the second cell gets the strongest responding other
    face.
    """
    face = table.face.copy()
    faults: list[Fault] = []
    if table.kind != "gripper":
        return face, faults
    clash = face[:, 0] == face[:, 1]
    usual = [_mode(face[~clash, cell]) if (~clash).any() else 0 for cell in range(2)]
    for number in np.unique(press[clash]):
        frames = np.flatnonzero((press == number) & clash)
        named = int(face[frames[0], 0])
        cell = 0 if usual[0] not in (0, named) else 1
        corrected = usual[cell] or _strongest_other(responses[number], named)
        face[frames, cell] = corrected
        detail = f"both load cells are said to press face {named}"
        action = f"cell {cell + 1} set to face {corrected}, whose sensors respond"
        faults.append(Fault("wrong face label", rows_text(frames), detail, action))
    return face, faults


def mirror_faults(
    face: Int[np.ndarray, "frame cell"],
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"],
    block: Int[np.ndarray, "frame"],
) -> list[Fault]:
    """Gripper cases on faces 3 and 5 whose places are not opposite: x3 = x5, y3 = −y5, ±6 mm.

    Of probes with several tips the centres count: jaws may hold them turned.
    """
    faults = []
    for number in np.unique(block):
        frames = np.flatnonzero(block == number)
        cells, tips = face[frames[0]], tip_xy_mm[frames[0]]
        if set(cells.tolist()) != {3, 5} or np.isnan(tips).any():
            continue
        on_3, on_5 = (tips[cells == side][0] for side in (3, 5))
        mirrored = on_5.mean(axis=0) * [1.0, -1.0]
        apart_mm = float(np.abs(on_3.mean(axis=0) - mirrored).max())
        if apart_mm > _OPPOSITE_MM + 1e-6:
            detail = f"places {on_3.tolist()} and {on_5.tolist()} mm are {apart_mm:g} mm off"
            faults.append(
                Fault("labels not opposite", rows_text(frames), detail, "kept as labelled")
            )
    return faults


def unread_faces(
    counts: Float[np.ndarray, "frame face sensor 3"], face: Int[np.ndarray, "frame cell"]
) -> list[Fault]:
    """Faces that labels say are pressed, without a single reading of their own."""
    read = np.any(np.isfinite(counts), axis=(0, 2, 3))
    labelled = np.unique(face[face != NO_FACE]).tolist()
    return [
        Fault(
            "pressed face without readings",
            f"face {n}",
            "it has no channel in the recording",
            "kept",
        )
        for n in labelled
        if not read[n - 1]
    ]


def stamp_faults(table: RawTable) -> list[Fault]:
    """Repeated or backward time stamps and duplicate column names."""
    faults = []
    if table.duplicate_columns:
        names = ", ".join(table.duplicate_columns)
        faults.append(
            Fault("duplicate column names", names, "named twice", "told apart by their order")
        )
    step = np.diff(table.time_s)
    if np.any(step == 0):
        detail = f"{int(np.sum(step == 0))} of {len(step) + 1} repeat the one before"
        rebuilt = "rebuilt from the frame rate"
        if not step.any():
            rebuilt = "they tell no frame rate, an assumed one is taken; give stamps in s"
        faults.append(Fault("time stamps", "Time", detail, rebuilt))
    if np.any(step < 0):
        detail = f"{int(np.sum(step < 0))} run backwards"
        faults.append(Fault("time stamps", "Time", detail, "a new stretch begins there"))
    return faults


def _mode(values: Int[np.ndarray, "n"]) -> int:
    names, counts = np.unique(values, return_counts=True)
    return int(names[counts.argmax()])


def _strongest_other(response: Float[np.ndarray, "face"], named: int) -> int:
    candidates = np.where(
        np.isnan(response) | (np.arange(1, len(response) + 1) == named), -1.0, response
    )
    return 1 + int(candidates.argmax())


def rows_text(frames: Int[np.ndarray, "n"]) -> str:
    """Rows as counted from 0 below the header."""
    return f"rows {frames[0]}–{frames[-1]}"
