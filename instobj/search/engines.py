"""Random layouts that a search begins from, their choices by turns, on an Optuna study in memory.

Journals and databases take a hundred times as long as memory. A layout that was improved after it was
asked is told as what it became.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
import optuna
from optuna.distributions import BaseDistribution, CategoricalDistribution, FloatDistribution
from optuna.samplers import RandomSampler
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, Trial, TrialState, create_trial

from design.search.space import Params, Variable


@dataclass(frozen=True)
class Sampling:
    """A study in memory and the ranges that it samples from.

    `numbers` of its trials, whose choices go by turns, which begin with those of `first`.
    """

    study: optuna.Study
    distributions: dict[str, BaseDistribution]
    seed: int
    first: Params
    numbers: Iterator[int]


def sampling(
    variables: Sequence[Variable],
    objectives: int,
    seed: int,
    past: Iterable[FrozenTrial] = (),
    first: Params | None = None,
) -> Sampling:
    """Random layouts that go on after the past trials of a study, and begin with `first` where there are
    none."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    past = list(past)
    study = optuna.create_study(
        sampler=RandomSampler(seed=seed), directions=[StudyDirection.MINIMIZE] * objectives
    )
    study.add_trials(past)
    begun = first is not None and not past
    if begun:
        study.enqueue_trial(dict(first or {}))
    distributions = {v.name: _distribution(v) for v in variables}
    return Sampling(study, distributions, seed, first or {}, count(1 if begun else len(past)))


def ask(engine: Sampling, trials: int) -> list[Trial]:
    """The next trials; their `params` hold a value for every variable."""
    return [_ask(engine) for _ in range(trials)]


def _ask(engine: Sampling) -> Trial:
    engine.study.enqueue_trial(_choices_by_turns(engine, next(engine.numbers)))
    return engine.study.ask(engine.distributions)


def _choices_by_turns(engine: Sampling, number: int) -> dict[str, Any]:
    """What a trial takes of each list of choices: all of a list once before one comes again, in an order that
    is new every time, so that few trials leave none out."""
    found = {}
    for place, (name, one) in enumerate(engine.distributions.items()):
        if isinstance(one, CategoricalDistribution):
            turn, index = divmod(number, len(one.choices))
            order = np.random.default_rng([engine.seed, place, turn]).permutation(len(one.choices))
            drawn = [one.choices[k] for k in order]
            if turn == 0 and engine.first.get(name) in drawn:
                drawn.remove(engine.first[name])
                drawn.insert(0, engine.first[name])
            found[name] = drawn[index]
    return found


def tell(
    engine: Sampling,
    trial: Trial,
    params: Params,
    values: Sequence[float],
    user_attrs: dict[str, object],
) -> FrozenTrial:
    """What became of an asked trial, and what that is worth; the trial as it is to be kept."""
    system = trial.storage.get_trial_system_attrs(trial._trial_id)
    became = create_trial(
        params=dict(params),
        distributions=engine.distributions,
        values=list(values),
        user_attrs=user_attrs,
        system_attrs=system,
    )
    engine.study.tell(trial, state=TrialState.FAIL)
    engine.study.add_trial(became)
    return became


def tell_failed(engine: Sampling, trial: Trial, reason: str) -> FrozenTrial:
    """A trial that came to nothing; the trial as it is to be kept."""
    engine.study.tell(trial, state=TrialState.FAIL)
    return create_trial(
        state=TrialState.FAIL,
        params=dict(trial.params),
        distributions=engine.distributions,
        user_attrs={"failure": reason},
    )


def _distribution(variable: Variable) -> BaseDistribution:
    if variable.choices:
        return CategoricalDistribution(variable.choices)
    return FloatDistribution(variable.low, variable.high)
