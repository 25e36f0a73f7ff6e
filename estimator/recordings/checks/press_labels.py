"""Checks of presses: labels and forces held against the signals.

Everything is judged from the recording alone. Thresholds were set on the public recordings, in
which none of these faults was found, and on simulated ones with planted faults. Frames that a check
names are no labels; frames that `hidden_contacts` names give no zero either.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE
from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.checks.judged import Judged, Rows
from estimator.recordings.checks.weak_places import (
    Contrast,
    contrasts,
    expected_responses,
    is_repeated,
    weak_place,
)
from estimator.recordings.contacts import Place
from estimator.recordings.presses import CONTACT_FORCE_N, LEAST_CONTACT_FRAMES, runs

_HIDDEN_SIGMAS = 6.0
"""Change while no load cell shows a force, over its noise, from which a press is hidden."""
_SILENT_SHARE = 0.1
"""Response over the expected one below which a channel is silent."""
_SILENT_SIGMAS = 5.0
"""Expected response, over its noise, from which that is judged."""
_PRESSED_SHARE = 0.3
"""Share of a press's largest force from which it is held."""
_UNEQUAL = 3.0
"""Jaws of the public recordings show 0.6 to 1.6 times one another, 1.01 in the middle."""
_HELD_N = 1.0
"""Force from which a frame is held."""


def restless_presses(case: Judged) -> Rows:
    """One fault where most presses have no frame at rest next to them: then nobody knows their zero."""
    pressed = np.unique(case.press[case.held.any(axis=1)])
    without = np.setdiff1d(pressed, case.press[case.rest])
    if 2 * len(without) <= len(pressed):
        return case.none(), []
    fault = Fault(
        "hardly any rest",
        f"{len(without)} of {len(pressed)} presses",
        "no frame at rest beside them: forces count from the lowest one, which may be a press, and "
        "signals from rests of other presses, so that both may be too small",
        "kept; record a second without contact before each press",
    )
    return case.none(), [fault]


def unequal_jaws(case: Judged) -> Rows:
    """Two jaws of a gripper that show more than three times one another: one cell is in another unit.

    They hold one object, so their forces are equal and opposite.
    """
    held = np.flatnonzero(case.force_n.max(axis=1) > _HELD_N)
    if case.table.kind != "gripper" or not len(held):
        return case.none(), []
    loaded = case.force_n[held]
    loaded = loaded[loaded.max(axis=1) >= np.median(loaded.max(axis=1))]
    ratio = float(np.median(loaded[:, 0]) / max(np.median(loaded[:, 1]), 1e-9))
    if 1 / _UNEQUAL <= ratio <= _UNEQUAL:
        return case.none(), []
    larger, times = (1 if ratio > 1 else 2), max(ratio, 1 / ratio)
    detail = (
        f"cell {larger} shows {times:.3g} times the force of cell {3 - larger}, though jaws press "
        "equally: one of them is in another unit (9.8 or 102: g against N, 1000: kg against g)"
    )
    fault = Fault("forces of another unit", rows_text(held), detail, "no labels there")
    return case.held.any(axis=1) | ~case.rest, [fault]


def doubtful_presses(case: Judged) -> Rows:
    """Presses in which an unnamed face responds far more than a named one: labels not believed.

    At a weak place a true label looks so, too. The specification's model says where such places are;
    without it, presses of the same label that repeat one another do (`is_repeated`).
    """
    doubtful, faults = case.none(), []
    if unequal_jaws(case)[1]:  # which face is pressed cannot be told then
        return doubtful, faults
    weak: dict[Place, list[Contrast]] = {}
    loads = loads_of_places(case)
    for contrast in contrasts(case, pressed_faces(case)):
        by_model = contrast.is_usual
        if is_repeated(case, contrast, loads) if by_model is None else by_model:
            weak.setdefault(contrast.place, []).append(contrast)
            continue
        frames = np.flatnonzero(case.press == contrast.press)
        action = "frames not used"
        if by_model is None:
            action += " (--spec judges it by the object's model)"
        faults.append(Fault("doubtful face label", rows_text(frames), str(contrast), action))
        doubtful[frames] = True
    return doubtful, [*faults, *(weak_place(case, presses) for presses in weak.values())]


def pressed_faces(case: Judged) -> Int[np.ndarray, "frame cell"]:
    """Face of each load cell where it holds a good share of its press's largest force, else 0."""
    largest = np.zeros(case.press.max() + 1)
    np.maximum.at(largest, case.press, case.force_n.max(axis=1))
    least_n = np.maximum(CONTACT_FORCE_N, _PRESSED_SHARE * largest[case.press])
    return np.where(case.force_n >= least_n[:, None], case.face, NO_FACE)


def contacts_at_rest(case: Judged) -> Rows:
    """Presses in which a load cell is loaded while the labels say that nothing touches."""
    wrong, faults = case.none(), []
    for first, last in _long_runs(case.held.any(axis=1) & case.no_contact):
        wrong |= np.isin(case.press, np.unique(case.press[first:last]))
        faults.append(
            Fault(
                "contact while labelled rest",
                rows_text(np.arange(first, last)),
                "a load cell holds a force where the labels say that nothing touches",
                "press not used",
            )
        )
    return wrong, faults


def silent_presses(case: Judged) -> Rows:
    """Presses whose load cell holds a force while the face that it names does not respond.

    Expected is the median response per newton of all presses that name the face; a press is silent
    below a tenth of it, where it would stand out of the noise by 5 σ. Where the specification's model
    answers less, its answer is the expected one.
    """
    finite_noise = case.noise_counts[np.isfinite(case.noise_counts)]
    sigma = float(np.median(finite_noise)) if finite_noise.size else 0.0
    rows = loads_of_places(case)
    usual = {f: np.median([row[3] / row[2] for row in rows if row[1] == f]) for _, f, *_ in rows}
    wrong, faults = case.none(), []
    for number, named, newton, response in rows:
        expected = usual[named] * newton
        if expected < _SILENT_SIGMAS * sigma or response > _SILENT_SHARE * expected:
            continue
        model = expected_responses(case, number)
        if model is not None and response > _SILENT_SHARE * model[named - 1]:
            continue
        frames = np.flatnonzero(case.press == number)
        detail = (
            f"{newton:.1f} N on face {named}, whose sensors change by {response:.0f} counts where "
            f"{expected:.0f} are usual"
        )
        faults.append(Fault("force without signal", rows_text(frames), detail, "press not used"))
        wrong[frames] = True
    return wrong, faults


def loads_of_places(case: Judged) -> list[tuple[int, int, float, float]]:
    """Press, face, force (75th percentile, N) and response (counts) of every load."""
    loads = []
    for first, last in runs(case.press):
        number = int(case.press[first])
        for cell in range(case.face.shape[1]):
            named = int(case.face[first, cell])
            newton = np.percentile(case.force_n[first:last, cell], 75)
            if named == NO_FACE or newton < CONTACT_FORCE_N:
                continue
            response = case.responses[number, named - 1]
            if np.isfinite(response):
                loads.append((number, named, float(newton), float(response)))
    return loads


def hidden_contacts(case: Judged) -> Rows:
    """Frames at rest by the load cells in which a face's signals leave their rest level.

    The level of a block of frames (one session and place) is the median over its stretches of the
    medians at rest. A face's change is the median over its channels of the change against it, in σ
    of the channel; contact is more than 6 in `LEAST_CONTACT_FRAMES` frames in a row.
    """
    hidden, faults = case.none(), []
    for first, last in runs(case.block):
        part = slice(first, last)
        if case.rest[part].sum() < 3 * LEAST_CONTACT_FRAMES:
            continue
        change = sigmas_from_rest(case, part)
        for begin, end in _long_runs(case.rest[part] & (change.max(axis=1) > _HIDDEN_SIGMAS)):
            frames = np.arange(first + begin, first + end)
            face = 1 + int(change[begin:end].mean(axis=0).argmax())
            size = change[begin:end, face - 1].max()
            detail = f"face {face} responds by {size:.0f} σ while no load cell does"
            faults.append(
                Fault("contact while labelled rest", rows_text(frames), detail, "frames not used")
            )
            hidden[frames] = True
    return hidden, faults


def sigmas_from_rest(case: Judged, part: slice) -> Float[np.ndarray, "frame face"]:
    """Median over each face's live channels of |change against rest| / σ, in a part of the frames."""
    counts, rest, stretch = case.table.counts[part], case.rest[part], case.stretch[part]
    change = np.zeros((len(counts), counts.shape[1]))
    parts = [np.flatnonzero(rest & (stretch == number)) for number in np.unique(stretch[rest])]
    for face in range(counts.shape[1]):
        face_counts = counts[:, face].reshape(len(counts), -1)
        sigma = case.noise_counts[face].ravel()
        live = np.isfinite(face_counts).all(axis=0) & (sigma > 0)
        if live.any():
            levels = [np.median(face_counts[rows][:, live], axis=0) for rows in parts]
            off = np.abs(face_counts[:, live] - np.median(levels, axis=0))
            change[:, face] = np.median(off / sigma[live], axis=1)
    return change


def _long_runs(mask: Bool[np.ndarray, "frame"]) -> list[tuple[int, int]]:
    return [
        (first, last)
        for first, last in runs(mask.astype(int))
        if mask[first] and last - first >= LEAST_CONTACT_FRAMES
    ]


PRESSES: tuple[Callable[[Judged], Rows], ...] = (
    restless_presses,
    unequal_jaws,
    doubtful_presses,
    contacts_at_rest,
    silent_presses,
)
"""Checks of presses, in the order of the report."""


def judge_presses(case: Judged) -> Rows:
    """Frames that one of `PRESSES` names, and what was named."""
    named, faults = case.none(), []
    for check in PRESSES:
        rows, check_faults = check(case)
        named, faults = named | rows, faults + check_faults
    return named, faults
