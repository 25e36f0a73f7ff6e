"""Lowest fidelity level of a search: scores trials in batches, structure by structure, and polishes them.

Runs in a separate process. The mechanics of every shell comes from the store (stage
`candidates`): minutes the first time that a thickness, core, silicone or magnet's outline comes up.
"""

from __future__ import annotations

import json
import time
import zlib
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from weakref import WeakValueDictionary

import numpy as np
import torch

from design.errors import InputError
from design.fabrication.layout import failures, layout_findings
from design.layout.body import body_of, face_frames
from design.search.places import polarities
from design.search.space import (
    SearchSpace,
    params_at,
    search_space,
    start_params,
    structure_of,
    unit_of,
    with_layout,
)
from design.search.structure import size_variants, with_structure
from design.spec.learning import SATURATION_MARGIN
from design.spec.object import ObjectSpec
from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from design.spec_io import parse_spec
from estimator.field.device import compute_device
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import (
    DEARER,
    batch_scores,
)
from estimator.layouts.limits.rules import RULES
from estimator.layouts.polish import (
    Judge,
    Judged,
    LowestFidelity,
    judge,
    polish,
    population,
    populations,
    runs_together,
    walk,
)
from estimator.layouts.presses.basis import PressBasis, faces_differ, press_bases
from estimator.layouts.scorer import LayoutScorer, layout_scorer
from estimator.layouts.vectors import layout_space
from estimator.signals.hall import full_scale_counts
from fem.candidates.motions import load_candidates
from instobj.search.joined import START_SHARE, fit_budget, plan_trial
from instobj.search.time_limit import FIRST_LOOK_S
from instobj.search.trials import Scored
from instobj.stages.run import Run

_UNFIT_MM = 0.5
"""For what only the specification's own check refuses."""
_START_RATE = 0.01
"""Share of every variable's range: steps of the start's walk, short compared with what its limits leave."""
_START_STEPS = 300
"""At most: on a handle 200 found 0.928, 300 0.927 and 600 0.925 of the start's bound."""

_CHAIN_OVER_LOWEST = {"flat": 1.155, "curved": 1.25, "sensors-in-shell": 1.7}
"""Factor measured with `estimator.layouts.scoring.PlaceInformation`: at flat and curved faces above
sensors in the core (of a pear the chain had 1.20 times as many), and of boards. The leaders' walk takes
their own figure."""

_HELD: WeakValueDictionary[tuple[str, int, float, bool, str], PressBasis] = WeakValueDictionary()
"""Press bases of scorers: structures that differ in single magnets' sizes share them, at tens of MB
each."""


@dataclass(frozen=True)
class TimedTrials:
    """Trials of one structure, which shall have a result by `ends_at`, as `time.time()`."""

    trials: list[dict[str, Any]]
    ends_at: float

    def __len__(self) -> int:
        """Return the number of trials."""
        return len(self.trials)

    @property
    def left_s(self) -> float:
        """Return the seconds that are left, `FIRST_LOOK_S` at least, where mechanics were slow to read.

        Clocks of several machines agree within a second or so.
        """
        return max(self.ends_at - time.time(), FIRST_LOOK_S)


Evaluate = Callable[[TimedTrials], list[Scored]]


@dataclass(frozen=True)
class StartScores:
    """The specification as it is at the lowest level.

    `counts_over_lowest`: the largest counts that layouts have in the chain, over those of the lowest level.
    """

    scores: dict[str, float]
    counts_over_lowest: float


def lowest_fidelity(question: tuple[str, int, float]) -> Evaluate:
    """The function that scores trials of one structure; takes and gives what pipes can carry.

    Of a specification as JSON, how many generations a trial has once trials are joined, fewer where time is
    short (`fit_budget`), and seconds for those of the specification's own layout. Where these are finite,
    other trials follow, and half of the time is kept for them. On the device that `INSTOBJ_DEVICE` names.
    """
    content, generations, first_s = question
    torch.set_num_threads(1)
    device = compute_device()
    space = search_space(parse_spec(json.loads(content), "the specification"))
    device_context = (
        nullcontext() if device.type == "cpu" else device
    )  # a context that costs each call a little
    with device_context:
        # the first structure shares the bases of these, which take longest to make
        held = [*scorers(space.spec, single_faces(space.spec.body.sensed))]
        start = start_scores(space.spec)
    start_layout = start_params(space)
    by_structure: dict[Any, tuple[LowestFidelity, float, SearchSpace]] = {}

    def evaluate(timed: TimedTrials) -> list[Scored]:
        trials, starting = timed.trials, timed.trials == [start_layout]
        structure = structure_of(space, trials[0])
        if structure not in by_structure:
            lowest, generation_s, planned = structure_fidelity(space, trials[0], start), 0.0, space
            held.clear()
            if space.spec.search.polish_steps:
                generation_s = seconds_per_generation(space, lowest, trials[0], len(trials))
                planned = fit_budget(space, generations, generation_s, len(trials), timed.left_s)
            by_structure[structure] = lowest, generation_s, planned
        lowest, generation_s, planned = by_structure[structure]
        planned, seconds = plan_trial(
            planned, generation_s * len(trials), timed.left_s, first_s if starting else None
        )
        return [
            replace(scored, start_scores=start.scores)
            for scored in score_trials(planned, lowest, trials, seconds)
        ]

    def evaluate_there(timed: TimedTrials) -> list[Scored]:
        with device_context:
            return evaluate(timed)

    return evaluate_there


def seconds_per_generation(
    space: SearchSpace, lowest: LowestFidelity, params: dict[str, Any], layouts: int
) -> float:
    """Seconds that as many layouts as a generation of one layout's CMA-ES has in the mean take here among
    `layouts`, in generations as small as the last; the faster of two. 0 for choices alone."""
    free = sum(not v.choices for v in space.variables)
    if not free:
        return 0.0
    drawn, sizes = np.random.default_rng(0), populations(free, space.spec.search.polish_steps)
    together = min(layouts, runs_together(torch.get_default_device(), max(sizes)))
    size, taken = together * sizes[-1], []
    units = torch.as_tensor(drawn.random((size, free)), dtype=torch.float32)
    poles = torch.tensor(polarities(lowest.space.structured, params)).expand(size, -1)
    for _ in range(2):
        began = time.monotonic()
        with torch.no_grad():
            judge(lowest, units, poles, space.spec.search.objectives).objectives.cpu()
        taken.append(time.monotonic() - began)
    return min(taken) / size * population(free)


def structure_fidelity(
    space: SearchSpace, params: dict[str, Any], start: StartScores
) -> LowestFidelity:
    """Scorers of a structure, from stored mechanics or after it."""
    structured = with_structure(space.spec, params)
    limits = structured.search.limits.times_start
    most_counts = full_scale_counts(structured.sensors) / start.counts_over_lowest
    at_most = {
        "largest_counts": (1 - SATURATION_MARGIN) * most_counts,
        "kept_counts": most_counts,
    } | {
        name: 1 / (factor * start.scores[name])
        if name in OBJECTIVES_TO_MAXIMIZE
        else factor * start.scores[name]
        for name, factor in limits.items()
    }
    all_scorers = scorers(structured, pressed_faces(structured))
    return LowestFidelity(layout_space(space, structured), all_scorers, at_most)


def scorers(spec: ObjectSpec, faces: Mapping[int, tuple[int, ...]]) -> tuple[LayoutScorer, ...]:
    """A scorer for every judged force and pressed face, on the stage `candidates` of every size; places of
    parts, which that does not depend on, need not fit yet."""
    folders = [
        (variant, Run(variant, checked=False).require("candidates").folder)
        for variant in size_variants(spec)
    ]
    by_face = {
        face: [_presses(variant, folder, face) for variant, folder in folders] for face in faces
    }
    return tuple(
        layout_scorer(spec, [of_size[index] for of_size in by_face[face]], faces=len(alike))
        for index in range(len(spec.scoring_forces_n))
        for face, alike in faces.items()
    )


def _presses(spec: ObjectSpec, folder: Path, face: int) -> tuple[PressBasis, ...]:
    """The bases of one size's candidates, force by force; those of scorers which still are, where they are
    the same."""
    shared = spec.model_dump_json(exclude={"magnets"})
    forces_n = spec.scoring_forces_n
    keys = [(str(folder), face, force, faces_differ(spec), shared) for force in forces_n]
    bases = [_HELD.get(key) for key in keys]
    if None in bases:
        bases = press_bases(spec, load_candidates(folder), face, forces_n)
        _HELD.update(zip(keys, bases, strict=True))
    return tuple(basis for basis in bases if basis is not None)


def pressed_faces(spec: ObjectSpec) -> dict[int, tuple[int, ...]]:
    """Faces that are pressed, and the faces that each stands for, itself included.

    On a cube whose sensors move, the side faces are alike.
    """
    sensed = spec.body.sensed
    cube = body_of(spec).cuboid and len(set(spec.body.size_mm)) == 1
    alike = cube and not faces_differ(spec) and spec.search.vary.sensor_reach_mm is not None
    if not alike or 6 in sensed or not {1, 3} <= {*sensed}:
        return single_faces(sensed)
    return {1: (1,), 3: tuple(face for face in sensed if face != 1)}


def single_faces(faces: tuple[int, ...]) -> dict[int, tuple[int, ...]]:
    """Faces that stand for themselves."""
    return {face: (face,) for face in faces}


def start_scores(spec: ObjectSpec) -> StartScores:
    """Lowest-fidelity scores of the specification as it is."""
    all_scorers = scorers(spec, single_faces(spec.body.sensed))
    layouts = [layouts_of(spec, scorer.presses.face) for scorer in all_scorers]
    with torch.no_grad():
        scores = batch_scores(all_scorers, layouts, DEARER)
    start_values = {name: float(value) for name, value in scores.items()}
    return StartScores(start_values, counts_over_lowest(spec))


def counts_over_lowest(spec: ObjectSpec) -> float:
    """The most that layouts of this body are taken to have in the chain."""
    kind = spec.arrangement
    if kind == "sensors-in-core":
        kind = "flat" if all(frame.flat for frame in face_frames(spec)) else "curved"
    return _CHAIN_OVER_LOWEST[kind]


def score_trials(
    space: SearchSpace,
    lowest: LowestFidelity,
    trials: list[dict[str, Any]],
    seconds: float = np.inf,
) -> list[Scored]:
    """Polish and score trials of one structure; deterministic where `seconds` break nothing off.

    The specification's own layout also walks down the gradient: a run of generations crosses the whole
    space and may not come back. Half of the time is kept for that.
    """
    began = time.monotonic()
    spec, structured = space.spec, lowest.space.structured
    flags = [not v.choices for v in space.variables]
    units = np.array([unit_of(space, trial) for trial in trials])
    poles = torch.tensor([polarities(structured, trial) for trial in trials])

    scorings = np.zeros(len(trials), int)

    def judge_at(point: torch.Tensor, rows: torch.Tensor) -> Judged:
        np.add.at(scorings, rows.cpu().numpy(), 1)
        return judge(lowest, point, poles[rows], spec.search.objectives)

    point = torch.as_tensor(units[:, flags], dtype=torch.float32)
    if spec.search.polish_steps and any(flags):
        weights, begin = _weights(units, spec), point
        start_rows = _start_rows(space, units)
        polish_s = (START_SHARE if start_rows else 1.0) * seconds
        point = polish(
            judge_at,
            begin,
            spec.search.polish_steps,
            weights,
            lambda: time.monotonic() - began >= polish_s,
        )
        for row in start_rows:
            point[row] = _better(
                judge_at,
                row,
                (point[row], begin[row]),
                weights[row],
                lambda: time.monotonic() - began >= seconds,
            )
    with torch.no_grad():
        judged = judge_at(point, torch.arange(len(point)))
    units[:, flags] = point.cpu().numpy()
    scored, limits = [], [*RULES, *lowest.at_most]
    for row, (unit, trial) in enumerate(zip(units, trials, strict=True)):
        params = params_at(space, unit) | {
            v.name: trial[v.name] for v in space.variables if v.choices
        }
        scored.append(_scored(spec, params, judged, row, limits, int(scorings[row])))
    return scored


def _start_rows(space: SearchSpace, units: np.ndarray) -> list[int]:
    """Trials that are the specification's own layout."""
    start = start_params(space)
    if start is None:
        return []
    return np.flatnonzero(np.isclose(units, unit_of(space, start)).all(axis=1)).tolist()


def _better(
    judge_at: Judge,
    row: int,
    points: tuple[torch.Tensor, torch.Tensor],
    weights: torch.Tensor,
    over: Callable[[], bool],
) -> torch.Tensor:
    """Return the better of a trial's end and of a walk from its beginning, until the time is `over`."""
    end, begin = points

    def judged_at(point: torch.Tensor) -> Judged:
        return judge_at(point, torch.full((len(point),), row))

    walked = walk(judged_at, begin[None], weights, _START_STEPS, _START_RATE, over)
    both = torch.cat([end[None], walked])
    with torch.no_grad():
        return both[judged_at(both).loss(weights).nan_to_num(torch.inf).argmin()]


def _scored(
    spec: ObjectSpec,
    params: dict[str, Any],
    judged: Judged,
    row: int,
    limits: Sequence[str],
    scorings: int,
) -> Scored:
    """Outcome of one layout; `limits` name what `judged.broken` holds."""
    broken, worse = float(judged.broken_mm[row]), 1.0
    if broken > 0:
        misfit = f"the limit of {limits[int(judged.broken[row].argmax())]}"
    elif misfit := misfit_of(spec, params):
        worse += _UNFIT_MM
    values = tuple(worse * float(value) for value in judged.penalized[row])
    scores = {name: float(value[row]) for name, value in judged.scores.items()}
    steps = spec.search.polish_steps
    return Scored(params, values, scores, broken, misfit, scorings, generations=steps)


def misfit_of(spec: ObjectSpec, params: dict[str, Any]) -> str:
    """Return what the specification's own check and fabrication's say of a layout; nothing where it fits."""
    try:
        layout_spec = with_layout(spec, params)
    except InputError as error:
        return str(error)
    recessed = spec.arrangement == "sensors-in-core"
    moved = recessed and spec.search.vary.sensor_reach_mm is not None
    failed = failures(layout_findings(layout_spec, recesses=moved))
    if failed:
        return "cannot be fabricated: " + "; ".join(failed)
    return ""


def _weights(units: np.ndarray, spec: ObjectSpec) -> torch.Tensor:
    """Directions towards the front: one per layout, drawn from the layout itself, so repeatable."""
    count = len(spec.search.objectives)
    if count == 1:
        return torch.ones(len(units), 1)
    seeds = [zlib.crc32(row.tobytes()) for row in units]
    drawn = [np.random.default_rng(seed).dirichlet(np.ones(count)) for seed in seeds]
    return torch.as_tensor(np.array(drawn), dtype=torch.float32)
