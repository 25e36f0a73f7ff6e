"""Weak places: there another face answers more strongly than the pressed one, though the label is true.

A wrong label of a face looks the same. The model of the object's specification distinguishes them, where
that is known, else the other presses of the recording.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from estimator.recordings.checks.faults import Fault, face_sizes
from estimator.recordings.checks.judged import Judged
from estimator.recordings.checks.place_labels import chords
from estimator.recordings.contacts import Place, contact_place, place_text
from estimator.recordings.presses import CONTACT_FORCE_N
from estimator.recordings.table import faces_of

_DOUBT_FACTOR = 3.0
"""Response of another face, over the weakest of the named ones, from which a label is doubted; with a model,
that ratio over the model's."""
_REPEATED_FACTOR = 6.0
"""The same ratio, up to which repetition may excuse it: 3.1 to 5.1 at weak places of a simulated box."""
_ALIKE_CHORD, _UNLIKE_CHORD = 0.5, 1.0
"""Chords of two presses' unit patterns, below which they are of one place (29°), above which not of one face
(60°). Repeated weak presses of a simulated box lie within 0.35, weak ones and those of the other face beyond
1.2."""
_LEAST_ALIKE = 2
"""Other presses of the same label that repeat a pattern, at least."""
_WEAK_SHARE = 0.5
"""Share of a face's usual response per newton below which it is not pressed itself."""

Load = tuple[int, int, float, float]
"""Press, face, force (N) and response of that face (counts)."""


@dataclass(frozen=True)
class Contrast:
    """Press in which a face that no label names (`stronger`) answers far more than a `named` one.

    `times` is the ratio of the two answers. `place` is what the labels say. `model` is what the
    specification's model says of it; None without one, or where it does not reach.
    """

    press: int
    place: Place
    stronger: int
    named: int
    times: float
    model: ModelAnswer | None = None

    @property
    def is_usual(self) -> bool | None:
        """Return whether the model answers like that; None without one."""
        if self.model is None:
            return None
        return not self.model.likelier and self.times <= _DOUBT_FACTOR * self.model.times

    def __str__(self) -> str:
        if np.isinf(self.times):
            return f"face {self.stronger} answers, and the labelled face {self.named} does not"
        times = _times_text(self.times)
        text = f"face {self.stronger} answers {times} as strongly as the labelled face {self.named}"
        return text if self.model is None else f"{text}{self.model}"


@dataclass(frozen=True)
class ModelAnswer:
    """Answer of the specification's model to the labelled press: `times` as in `Contrast`, and the place of
    the other face that responds more alike (`likelier`; empty where there is none)."""

    times: float
    likelier: Place

    def __str__(self) -> str:
        text = (
            f"in the model {_times_text(self.times)}" if self.times > 1 else "no more in the model"
        )
        alike = f", where a press at {place_text(self.likelier)} mm answers more alike"
        return f", {text}{alike if self.likelier else ''}"


def contrasts(case: Judged, pressed: Int[np.ndarray, "frame cell"]) -> list[Contrast]:
    """Return the presses in which an unnamed face answers three times as strongly as a named one.

    `pressed` is the face of each load cell where it is held, else 0.
    """
    doubted, faces = [], faces_of(case.table.counts)
    for number, response in enumerate(case.responses):
        frames = np.flatnonzero(case.press == number)
        is_named = np.isin(faces, pressed[frames])
        unnamed_response = np.where(is_named | np.isnan(response), 0.0, response)
        weakest = np.min(response, where=is_named, initial=np.inf)
        if not unnamed_response.max() > _DOUBT_FACTOR * weakest:
            continue
        stronger = 1 + int(unnamed_response.argmax())
        named = 1 + int(np.flatnonzero(is_named & (response == weakest))[0])
        times = float(unnamed_response.max() / weakest) if weakest > 0 else np.inf
        contrast = Contrast(number, _place_of(case, frames), stronger, named, times)
        doubted.append(replace(contrast, model=_answer_of_model(case, contrast)))
    return doubted


def _answer_of_model(case: Judged, contrast: Contrast) -> ModelAnswer | None:
    """Return what the specification's model answers to a press as it is labelled; None without one.

    The other hypothesis is a press of the other face with the force on the named one, at any place.
    """
    expected = _expected_answers(case, contrast.press)
    if expected is None or case.mechanics is None:
        return None
    answers, face, tip_n = expected
    sizes = face_sizes(answers.sum(axis=0))
    named_size, other_size = sizes[contrast.named - 1], sizes[contrast.stronger - 1]
    if not named_size > 0:
        return None
    places_mm = case.mechanics.places_mm(contrast.stronger)
    on_other, is_named = np.full(len(places_mm), contrast.stronger), face == contrast.named
    every_n = np.full(len(places_mm), tip_n[is_named].sum())
    others = case.mechanics.signal_changes(on_other, places_mm, every_n)
    likelier: Place = ()
    if others is not None and len(others):
        change = case.changes[contrast.press]
        in_its_stead = answers[~is_named].sum(axis=0) + _live_answers(case, others)
        hypotheses = np.concatenate([[answers.sum(axis=0)], in_its_stead])
        is_shared = np.isfinite(hypotheses[0])
        off = chords(_unit(change[is_shared]), _unit(hypotheses[:, is_shared]))
        x_mm, y_mm = places_mm[off[1:].argmin()].tolist()
        likelier = ((contrast.stronger, x_mm, y_mm),) if off[1:].min() < off[0] else ()
    # a face that ought to answer less than the named one may still answer as much
    return ModelAnswer(max(1.0, float(np.nan_to_num(other_size / named_size))), likelier)


def expected_responses(case: Judged, press: int) -> Float[np.ndarray, "face"] | None:
    """Return the answer (rms counts) of each face to a press as it is labelled, by the specification's model;
    None without one, or where it does not reach."""
    expected = _expected_answers(case, press)
    return None if expected is None else face_sizes(expected[0].sum(axis=0))


def _expected_answers(
    case: Judged, press: int
) -> (
    tuple[Float[np.ndarray, "tip face sensor 3"], Int[np.ndarray, "tip"], Float[np.ndarray, "tip"]]
    | None
):
    """Return the model's answers (counts) to each labelled tip of a press, its face and its force (N)."""
    if case.mechanics is None:
        return None
    frames = np.flatnonzero(case.press == press)
    strongest = _strongest(case, frames)
    held_n = np.percentile(case.force_n[frames], 75, axis=0)
    tips_mm = case.table.tip_xy_mm[strongest]
    is_pressed = (held_n >= CONTACT_FORCE_N)[:, None] & np.isfinite(tips_mm).all(axis=2)
    cell, tip = np.nonzero(is_pressed)
    face, tip_n = case.face[strongest, cell], (held_n / np.maximum(is_pressed.sum(axis=1), 1))[cell]
    answers = case.mechanics.signal_changes(face, tips_mm[cell, tip], tip_n)
    return None if answers is None else (_live_answers(case, answers), face, tip_n)


def _live_answers(
    case: Judged, answers: Float[np.ndarray, "press face sensor 3"]
) -> Float[np.ndarray, "press side chip 3"]:
    """Return a model's answers of the channels that a recording has; NaN where one of them has none."""
    is_live = np.asarray(np.isfinite(case.table.counts).any(axis=0))
    faces, sensors = np.minimum(answers.shape[1:3], is_live.shape[:2])
    recorded = np.full((len(answers), *is_live.shape), np.nan)
    recorded[:, :faces, :sensors] = answers[:, :faces, :sensors]
    recorded[:, ~is_live] = np.nan
    return recorded


def _strongest(case: Judged, frames: Int[np.ndarray, "n"]) -> int:
    """Return the frame of the largest force."""
    return int(frames[case.force_n[frames].sum(axis=1).argmax()])


def _place_of(case: Judged, frames: Int[np.ndarray, "n"]) -> Place:
    """Return what the labels say of a press where it is strongest."""
    row = _strongest(case, frames)
    return contact_place(case.face[row], case.table.tip_xy_mm[row])


def _unit(changes: Float[np.ndarray, "*press channel"]) -> Float[np.ndarray, "*press channel"]:
    """Return patterns of size 1 over the live channels."""
    return changes / np.maximum(np.sqrt(np.nansum(changes**2, axis=-1, keepdims=True)), 1e-9)


def is_repeated(case: Judged, contrast: Contrast, loads: list[Load]) -> bool:
    """Return whether a weak place explains a contrast better than a wrong label of single presses.

    Most other presses of the same label, two at least, respond alike. None whose label names the other face
    does, and that face answers less than half as strongly per newton as where it is pressed, but no more
    than six times as strongly as the named one.
    """
    rivals = {
        press: response / newton
        for press, face, newton, response in loads
        if face == contrast.stronger
    }
    newton = max((newton for press, _, newton, _ in loads if press == contrast.press), default=0.0)
    if not contrast.place or not rivals or not newton or contrast.times > _REPEATED_FACTOR:
        return False
    repeats = [
        int(number)
        for number in np.unique(case.press)
        if number != contrast.press
        and _place_of(case, np.flatnonzero(case.press == number)) == contrast.place
    ]
    pattern = _unit(case.changes.reshape(len(case.changes), -1))
    is_alike = chords(pattern[contrast.press], pattern[repeats]) < _ALIKE_CHORD
    is_unlike = chords(pattern[contrast.press], pattern[list(rivals)]) > _UNLIKE_CHORD
    per_newton = case.responses[contrast.press, contrast.stronger - 1] / newton
    return bool(
        is_alike.sum() >= max(_LEAST_ALIKE, (len(repeats) + 1) // 2)
        and is_unlike.all()
        and per_newton < _WEAK_SHARE * np.median(list(rivals.values()))
    )


def weak_place(case: Judged, presses: list[Contrast]) -> Fault:
    """Return what is said of the presses of one weak place."""
    first, most = presses[0], max(presses, key=lambda contrast: contrast.times)
    where = f"{place_text(first.place)} mm, {len(presses)} press{'es' * (len(presses) > 1)}"
    where += f" from row {np.flatnonzero(case.press == first.press)[0]}"
    if first.model is not None:
        return Fault("weak place", where, f"{most}", "label believed, frames used")
    detail = (
        f"{most}; presses of this label do alike, none of face {most.stronger}, weak here too, does"
    )
    return Fault(
        "weak place", where, detail, "frames used (--spec judges it by the object's model)"
    )


def _times_text(times: float) -> str:
    return f"{times:.0f} times" if times >= 10 else f"{times:.2g} times"
