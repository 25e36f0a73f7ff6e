"""Simulated recordings whole: the paper's collection, parallel-jaw grasps, presses anywhere.

Travel is a raised cosine of a phase: periodic, or in handling closed, held and released once. Signals
follow it at once; the felt force follows `silicone.prony`. A case is zeroed once, with an error,
and drifts from there; white noise, rounding, clipping and the load cells' noise come on top.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.spec.object import ObjectSpec
from estimator.frames.collection_recipe import (
    Recipe,
    handling_recipe,
    periodic_recipe,
    scattered_recipe,
)
from estimator.frames.contact_cases import contact_groups
from estimator.frames.contact_traces import ContactTraces, JointMechanics, force_at_travel
from estimator.frames.dataset import NO_FACE, PER_FRAME_FIELDS, FrameSet
from estimator.frames.press_protocol import (
    LEAST_FORCE_NOISES,
    REST_PLACE_ID,
    disturbed,
    simulated_frames,
)
from estimator.frames.tangential import pulled_counts
from estimator.information.shear import ShearSignals
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import Progress, Signals
from fem.presses.viscoelastic import relaxed_force_n

BLOCK_FRAMES = 20_000
"""Frames simulated at once: it bounds the memory."""


def simulate_collection(
    spec: ObjectSpec,
    signals: Signals,
    spec_hash: str,
    mechanics: JointMechanics | None = None,
    progress: Progress | None = None,
    shear: ShearSignals | None = None,
) -> FrameSet:
    """All frames of `spec.collection`, fixed by `spec.seed`.

    `mechanics` is needed where several tips press at once, `shear` for tangential forces. Labels:
    places as pressed; the force of each load cell with its noise, shared equally by its tips.
    `true_force_n` holds what every tip bears. A period is a press (`press_id`), a case a session,
    zeroed once. Contact frames labelled below 2.5 σ of the load cell are invalid.

    Raises
    ------
    InputError
        As `contact_traces` and `contact_groups`; tangential forces without `shear`.
    """
    rng = np.random.default_rng((spec.seed, 3))
    kind = spec.collection.kind
    if kind == "continuous":
        recipe = scattered_recipe(spec, signals, mechanics, rng, progress, shear)
        return _recorded(spec, signals, recipe, rng, spec_hash)
    parts = []
    for cases in contact_groups(spec):
        make = handling_recipe if kind == "handling" else periodic_recipe
        recipe = make(spec, signals, cases, mechanics, rng, progress)
        parts.append(_recorded(spec, signals, recipe, rng, spec_hash))
        if progress is not None:
            progress(f"face {cases[0].face[0]}: {len(parts[-1])} frames of {len(cases)} cases")
    return joined(parts)


def joined(parts: Sequence[FrameSet]) -> FrameSet:
    """Parts of one recording one after the other, with ids and times that go on.

    All get the contact slots of the part with the most. Labels of travel, which simulated parts lack, go.
    """
    press = session = 0
    slots = max(part.contact_face.shape[1] for part in parts)
    parts = [with_slots(part, slots) for part in parts]
    start_s, numbered = 0.0, []
    for part in parts:
        step_s = part.time_s[1] - part.time_s[0]
        numbered.append(
            replace(
                part,
                press_id=part.press_id + press,
                session_id=part.session_id + session,
                time_s=part.time_s + start_s,
            )
        )
        press, session = (
            int(ids.max()) + 1 for ids in (numbered[-1].press_id, numbered[-1].session_id)
        )
        start_s = float(numbered[-1].time_s[-1] + step_s)
    true = () if any(part.true_force_n is None for part in parts) else ("true_force_n",)
    names = (*PER_FRAME_FIELDS, *true)
    whole = {name: np.concatenate([getattr(part, name) for part in numbered]) for name in names}
    return replace(
        parts[0], **({"true_force_n": None, "zero_error": None, "travel_mm": None} | whole)
    )


def with_slots(frames: FrameSet, slots: int) -> FrameSet:
    """The frames with empty contact slots added."""
    more = slots - frames.contact_face.shape[1]
    if not more:
        return frames

    def padded(values: np.ndarray, empty: float | int) -> np.ndarray:
        width = [(0, 0), (0, more), *[(0, 0)] * (values.ndim - 2)]
        return np.pad(values, width, constant_values=empty)

    true = frames.true_force_n
    return replace(
        frames,
        contact_face=padded(frames.contact_face, NO_FACE),
        contact_xy_mm=padded(frames.contact_xy_mm, np.nan),
        force_n=padded(frames.force_n, np.nan),
        true_force_n=None if true is None else padded(true, np.nan),
    )


def _recorded(
    spec: ObjectSpec,
    signals: Signals,
    recipe: Recipe,
    rng: np.random.Generator,
    spec_hash: str,
) -> FrameSet:
    contacts, frames = len(recipe.cases), recipe.turns.shape[1]
    counts = np.zeros((len(recipe.turns), frames, signals.baseline_counts.size))
    forces = []
    block = max(1, BLOCK_FRAMES // frames)
    for start in range(0, len(recipe.turns), block):
        part = slice(start, min(start + block, contacts))
        if start < contacts:
            felt, counts[part] = pressed_tips(spec, recipe, part)
            forces.append(felt)
        rows = slice(start, start + block)
        counts[rows] = disturbed(spec, signals, counts[rows], rng)
    return _labelled(spec, recipe, np.concatenate(forces), counts, rng, spec_hash)


def pressed_tips(
    spec: ObjectSpec, recipe: Recipe, part: slice
) -> tuple[Float[np.ndarray, "case frame tip"], Float[np.ndarray, "case frame channel"]]:
    """Forces felt at all tips (N) and undisturbed changes of counts of some cases."""
    all_traces = recipe.traces
    traces = ContactTraces(
        all_traces.travel_mm[part],
        all_traces.force_n[part],
        all_traces.tip_force_n[part],
        all_traces.counts[part],
    )
    turns = recipe.turns[part]
    travel = recipe.peak_mm[part, None] * (1 - np.cos(2 * np.pi * turns)) / 2
    total = force_at_travel(traces, travel)
    both = np.concatenate([traces.counts, traces.tip_force_n], axis=2)
    values = monotone_cubic(traces.force_n, both, total)
    channels = traces.counts.shape[2]
    elastic = values[..., channels:]
    felt = relaxed_force_n(
        total, np.arange(len(total[0])) / spec.sensors.frame_rate_hz, spec.silicone.prony
    )
    ratio = np.divide(felt, total, out=np.zeros_like(felt), where=total > 0)
    counts = values[..., :channels]
    if recipe.pull is not None:
        pull = recipe.pull.select(part)
        counts = counts + pulled_counts(pull.slopes, total, felt[..., None] * pull.share[:, None])
    return elastic * ratio[..., None], counts


def _labelled(
    spec: ObjectSpec,
    recipe: Recipe,
    felt_n: Float[np.ndarray, "case frame tip"],
    counts: Float[np.ndarray, "every frame channel"],
    rng: np.random.Generator,
    spec_hash: str,
) -> FrameSet:
    cases, frames = recipe.turns.shape
    contact = tip_values(recipe, "face", NO_FACE, int)
    places = tip_values(recipe, "xy_mm", np.nan, float)
    pressed = (contact != NO_FACE)[:, None] & recipe.moving[:, None]
    true, label, sure = _forces(spec, recipe, felt_n, rng)
    identity = np.full(cases, REST_PLACE_ID)
    identity[: len(recipe.cases)] = [case.place_id for case in recipe.cases]
    count, slots = cases * frames, contact.shape[1]

    def fill_contacts(values: np.ndarray, empty: float | int) -> np.ndarray:
        shown = pressed.reshape(*pressed.shape, *[1] * (values.ndim - 3))
        return np.where(shown, values, empty).reshape(count, *values.shape[2:])

    return simulated_frames(
        spec,
        spec_hash,
        counts,
        contact_face=fill_contacts(contact[:, None] + np.zeros((1, frames, 1), int), NO_FACE),
        contact_xy_mm=fill_contacts(places[:, None] + np.zeros((1, frames, 1, 1)), np.nan),
        force_n=fill_contacts(label, np.nan),
        valid=np.broadcast_to(sure | ~recipe.moving, (cases, frames)).ravel(),
        press_id=press_ids(recipe),
        place_id=np.where(recipe.moving, identity[:, None], REST_PLACE_ID).ravel(),
        session_id=np.repeat(np.arange(cases), frames),
        true_force_n=fill_contacts(true, np.nan).reshape(count, slots, 3),
    )


def tip_values(recipe: Recipe, name: str, empty: float | int, kind: type) -> np.ndarray:
    """An attribute of every tip of every case, padded; cases without contact are empty."""
    tips = recipe.traces.tip_force_n.shape[2]
    first = np.asarray(getattr(recipe.cases[0], name))
    values = np.full((len(recipe.turns), tips, *first.shape[1:]), empty, dtype=kind)
    for row, case in zip(values, recipe.cases, strict=False):
        row[: len(case.face)] = getattr(case, name)
    return values


def _forces(
    spec: ObjectSpec,
    recipe: Recipe,
    felt_n: Float[np.ndarray, "case frame tip"],
    rng: np.random.Generator,
) -> tuple[np.ndarray, np.ndarray, Bool[np.ndarray, "every frame"]]:
    """True and labelled forces (every, frame, tip, 3), and which frames press beyond doubt."""
    noise = spec.protocol.force_noise_n
    shape = (*recipe.turns.shape, felt_n.shape[2])
    true, label = np.zeros(shape), np.zeros(shape)
    sure = np.ones(shape[:2], bool)
    true[: len(felt_n)] = felt_n
    for row, case in enumerate(recipe.cases):
        for cell in np.unique(case.cell):
            (tips,) = np.nonzero(case.cell == cell)
            shown = felt_n[row][:, tips].sum(axis=1) + rng.normal(0, noise, shape[1])
            label[row][:, tips] = (shown / len(tips))[:, None]
            sure[row] &= shown > LEAST_FORCE_NOISES * noise
    direction = np.zeros((shape[0], 3))
    direction[:, 2] = 1.0
    if recipe.pull is not None:
        direction[:, :2] = recipe.pull.share
    true, label = (values[..., None] * direction[:, None, None] for values in (true, label))
    if recipe.pull is not None:  # a cell of three axes shows each with its own noise
        label[..., :2] = true[..., :2] + rng.normal(0, noise, (*shape, 2))
    return true, label, sure


def press_ids(recipe: Recipe) -> Int[np.ndarray, "frame"]:
    """A new press with every period of every case."""
    turn = np.floor(recipe.turns).astype(int)
    first = np.concatenate([[0], np.cumsum(turn.max(axis=1) + 1)[:-1]])
    return (first[:, None] + turn).ravel()
