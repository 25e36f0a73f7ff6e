"""Labels of contact held against signals: contacts called rest, forces without signal, wrong places.

Everything is judged from the recording alone. Thresholds were set on the public recordings, in
which none of these faults was found, and on simulated ones with planted faults.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.contacts import Place, place_text
from estimator.recordings.presses import CONTACT_FORCE_N, runs

LEAST_FRAMES = 5
"""Frames in a row that make a contact; shorter excursions are edges and glitches."""
_HIDDEN_SIGMAS = 6.0
"""Change while no load cell shows a force, over its noise, from which a press is hidden."""
_SILENT_SHARE = 0.1
"""Response over the expected one below which a channel is silent."""
_SILENT_SIGMAS = 5.0
"""Expected response, over its noise, from which that is judged."""
_PRESSED_SHARE = 0.3
"""Share of a press's largest force from which it is held."""
_LOADED_SHARE = 0.5
"""Share of the largest force from which frames are compared."""
_OWN_DISTANCE = 0.4
_DISTANCE_RATIO = 2.5
"""Chord from its own case, and over that to the nearest other case, from which a label is doubted."""


def pressed_faces(
    face: Int[np.ndarray, "frame cell"],
    force_n: Float[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
) -> Int[np.ndarray, "frame cell"]:
    """Face of each load cell where it holds a good share of its press's largest force, else 0."""
    largest = np.zeros(press.max() + 1)
    np.maximum.at(largest, press, force_n.max(axis=1))
    held = force_n >= np.maximum(CONTACT_FORCE_N, _PRESSED_SHARE * largest[press])[:, None]
    return np.where(held, face, NO_FACE)


def contacts_at_rest(
    touching: Bool[np.ndarray, "frame cell"],
    no_contact: Bool[np.ndarray, "frame"],
    press: Int[np.ndarray, "frame"],
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Presses in which a load cell is loaded while the labels say that nothing touches."""
    denied = touching.any(axis=1) & no_contact
    wrong = np.zeros(len(press), dtype=bool)
    faults = []
    for first, last in _long_runs(denied):
        frames = np.isin(press, np.unique(press[first:last]))
        wrong |= frames
        faults.append(
            Fault(
                "contact while labelled rest",
                rows_text(np.arange(first, last)),
                "a load cell holds a force where the labels say that nothing touches",
                "press not used",
            )
        )
    return wrong, faults


def hidden_contacts(
    counts: Float[np.ndarray, "frame 5 sensor 3"],
    rest: Bool[np.ndarray, "frame"],
    stretch: Int[np.ndarray, "frame"],
    block: Int[np.ndarray, "frame"],
    noise_counts: Float[np.ndarray, "5 sensor 3"],
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Frames at rest by the load cells in which a face's signals leave their rest level.

    The level of a block of frames (one session and place) is the median over its stretches of the
    medians at rest. A face's change is the median over its channels of the change against it, in σ
    of the channel; contact is more than 6 in `LEAST_FRAMES` frames in a row.
    """
    hidden = np.zeros(len(rest), dtype=bool)
    faults = []
    for first, last in runs(block):
        part = slice(first, last)
        if rest[part].sum() < 3 * LEAST_FRAMES:
            continue
        change = label_sigmas(counts[part], rest[part], stretch[part], noise_counts)
        for begin, end in _long_runs(rest[part] & (change.max(axis=1) > _HIDDEN_SIGMAS)):
            frames = np.arange(first + begin, first + end)
            face = 1 + int(change[begin:end].mean(axis=0).argmax())
            size = change[begin:end, face - 1].max()
            detail = f"face {face} responds by {size:.0f} σ while no load cell does"
            faults.append(
                Fault("contact while labelled rest", rows_text(frames), detail, "frames not used")
            )
            hidden[frames] = True
    return hidden, faults


def label_sigmas(
    counts: Float[np.ndarray, "frame 5 sensor 3"],
    rest: Bool[np.ndarray, "frame"],
    stretch: Int[np.ndarray, "frame"],
    noise_counts: Float[np.ndarray, "5 sensor 3"],
) -> Float[np.ndarray, "frame 5"]:
    """Median over each face's live channels of |change against rest| / σ."""
    change = np.zeros((len(counts), 5))
    parts = [np.flatnonzero(rest & (stretch == number)) for number in np.unique(stretch[rest])]
    for face in range(5):
        face_counts = counts[:, face].reshape(len(counts), -1)
        sigma = noise_counts[face].ravel()
        live = np.isfinite(face_counts).all(axis=0) & (sigma > 0)
        if live.any():
            level = np.median(
                [np.median(face_counts[rows][:, live], axis=0) for rows in parts], axis=0
            )
            change[:, face] = np.median(np.abs(face_counts[:, live] - level) / sigma[live], axis=1)
    return change


def silent_presses(
    face: Int[np.ndarray, "frame cell"],
    force_n: Float[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
    responses: Float[np.ndarray, "press 5"],
    noise_counts: Float[np.ndarray, "5 sensor 3"],
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Presses whose load cell holds a force while the face that it names does not respond.

    Expected is the median response per newton of all presses that name the face; a press is silent
    below a tenth of it, where it would stand out of the noise by 5 σ.
    """
    finite_noise = noise_counts[np.isfinite(noise_counts)]
    sigma = float(np.median(finite_noise)) if finite_noise.size else 0.0
    rows = loads_of_places(face, force_n, press, responses)
    usual = {f: np.median([row[3] / row[2] for row in rows if row[1] == f]) for _, f, *_ in rows}
    wrong = np.zeros(len(press), dtype=bool)
    faults = []
    for number, named, newton, response in rows:
        expected = usual[named] * newton
        if expected < _SILENT_SIGMAS * sigma or response > _SILENT_SHARE * expected:
            continue
        frames = np.flatnonzero(press == number)
        detail = (
            f"{newton:.1f} N on face {named}, whose sensors change by {response:.0f} counts where "
            f"{expected:.0f} are usual"
        )
        faults.append(Fault("force without signal", rows_text(frames), detail, "press not used"))
        wrong[frames] = True
    return wrong, faults


def loads_of_places(
    face: Int[np.ndarray, "frame cell"],
    force_n: Float[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
    responses: Float[np.ndarray, "press 5"],
) -> list[tuple[int, int, float, float]]:
    """Press, face, force (75th percentile, N) and response (counts) of every load."""
    loads = []
    for first, last in runs(press):
        number = int(press[first])
        for cell in range(face.shape[1]):
            named, newton = int(face[first, cell]), np.percentile(force_n[first:last, cell], 75)
            if named == NO_FACE or newton < CONTACT_FORCE_N:
                continue
            response = responses[number, named - 1]
            if np.isfinite(response):
                loads.append((number, named, float(newton), float(response)))
    return loads


def place_label_faults(
    frames: FrameSet, places: tuple[Place, ...]
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Presses that respond unlike the others of their place, and like those of another place.

    A press's pattern is its mean change under load as a unit vector over the live channels;
    compared are chords to the mean pattern of the other presses of its own place (must exceed 0.4)
    and of each other place with the same faces (2.5 times nearer). A place pressed once cannot be
    judged.
    """
    wrong = np.zeros(len(frames), dtype=bool)
    press, place, pattern = press_patterns(frames)
    pressed, index, count = np.unique(place, return_inverse=True, return_counts=True)
    mean = np.array([pattern[index == number].mean(axis=0) for number in range(len(pressed))])
    likeness: dict[int, int] = {}
    for k in np.flatnonzero(count[index] > 1):
        own_place = index[k]
        others = (mean[own_place] * count[own_place] - pattern[k]) / (count[own_place] - 1)
        near = float(_chords(pattern[k], others[None])[0])
        rivals = _chords(pattern[k], mean)
        same = [_faces(places[other_place]) == _faces(places[place[k]]) for other_place in pressed]
        rivals[~np.array(same)] = np.inf
        rivals[own_place] = np.inf
        best = int(rivals.argmin())
        if near > max(_OWN_DISTANCE, _DISTANCE_RATIO * rivals[best]):
            likeness[int(k)] = int(pressed[best])
    faults = []
    for k, best in likeness.items():
        rows = np.flatnonzero(frames.press_id == press[k])
        wrong[rows] = True
        detail = (
            f"labelled {place_text(places[place[k]])} mm, responds like {place_text(places[best])}"
        )
        swapped = [
            j for j, other_place in likeness.items() if place[j] == best and other_place == place[k]
        ]
        if swapped:
            partner = np.flatnonzero(frames.press_id == press[swapped[0]])
            detail += f", as if swapped with {rows_text(partner)}"
        faults.append(Fault("wrong place label", rows_text(rows), detail, "press not used"))
    return wrong, faults


def restless_presses(
    rest: Bool[np.ndarray, "frame"],
    touching: Bool[np.ndarray, "frame"],
    press: Int[np.ndarray, "frame"],
) -> list[Fault]:
    """One fault where most presses have no frame at rest next to them: then nobody knows their zero."""
    pressed = np.unique(press[touching])
    without = np.setdiff1d(pressed, press[rest])
    if 2 * len(without) <= len(pressed):
        return []
    return [
        Fault(
            "hardly any rest",
            f"{len(without)} of {len(pressed)} presses",
            "no frame at rest beside them: forces count from the lowest one, which may be a press, and "
            "signals from rests of other presses, so that both may be too small",
            "kept; record a second without contact before each press",
        )
    ]


def press_patterns(
    frames: FrameSet,
) -> tuple[Int[np.ndarray, "press"], Int[np.ndarray, "press"], Float[np.ndarray, "press channel"]]:
    """Press id, place id and unit pattern of every press with loaded, usable frames."""
    patterns = [
        (press, place, mean / max(_size(mean), 1e-9))
        for press, place, mean, _ in _loaded_means(frames)
    ]
    if not patterns:
        empty = np.empty(0, dtype=int)
        return empty, empty, np.empty((0, frames.signal_counts[0].size))
    press, place, pattern = zip(*patterns, strict=True)
    return np.array(press), np.array(place), np.array(pattern)


def pattern_noises(frames: FrameSet) -> Float[np.ndarray, "press channel"]:
    """Standard deviation of `press_patterns` by the noise of the readings, that of the zero counted as
    large as the mean's."""
    noise_by_channel = np.nan_to_num(frames.noise_counts)
    noise = np.broadcast_to(noise_by_channel, frames.signal_counts.shape[1:]).ravel()
    noises = [
        noise * np.sqrt(2 / rows) / max(_size(mean), 1e-9)
        for _, _, mean, rows in _loaded_means(frames)
    ]
    return np.array(noises).reshape(-1, len(noise))


def _loaded_means(
    frames: FrameSet,
) -> Iterator[tuple[int, int, Float[np.ndarray, "channel"], int]]:
    """Press id, place id, mean signals and number of the loaded, usable frames of every press."""
    total = np.nansum(frames.force_n[..., 2], axis=1)
    loaded = frames.valid & (frames.place_id >= 0)
    signal = frames.signal_counts.reshape(len(frames), -1)
    for first, last in runs(frames.press_id):
        rows = np.arange(first, last)[loaded[first:last]]
        rows = rows[total[rows] >= _LOADED_SHARE * total[rows].max()] if len(rows) else rows
        if len(rows) >= LEAST_FRAMES:
            yield (
                int(frames.press_id[first]),
                int(frames.place_id[rows[0]]),
                signal[rows].mean(axis=0),
                len(rows),
            )


def _size(mean: Float[np.ndarray, "channel"]) -> float:
    return float(np.sqrt(np.nansum(mean**2)))


def _chords(
    pattern: Float[np.ndarray, "channel"], others: Float[np.ndarray, "place channel"]
) -> Float[np.ndarray, "place"]:
    """Distances of a unit pattern from others, over the channels that both have."""
    return np.sqrt(np.nansum((pattern - others) ** 2, axis=-1))


def _faces(place: Place) -> tuple[int, ...]:
    return tuple(face for face, _, _ in place)


def _long_runs(mask: Bool[np.ndarray, "frame"]) -> list[tuple[int, int]]:
    return [
        (first, last)
        for first, last in runs(mask.astype(int))
        if mask[first] and last - first >= LEAST_FRAMES
    ]
