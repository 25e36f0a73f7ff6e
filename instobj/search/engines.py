"""Search engines: Optuna's samplers, asked for batches of layouts and told what they are worth.

A sampler works on a study in memory, which takes it 1 to 30 ms per trial, journals and databases a
hundred. A layout that was improved after it was asked is told as what it became.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator, Sequence
from copy import copy
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
import optuna
from optuna.distributions import BaseDistribution, CategoricalDistribution, FloatDistribution
from optuna.samplers import (
    BaseSampler,
    CmaEsSampler,
    NSGAIIISampler,
    NSGAIISampler,
    RandomSampler,
    TPESampler,
)
from optuna.study import StudyDirection
from optuna.trial import FrozenTrial, Trial, TrialState, create_trial

from design.search.space import Params, Variable
from design.spec.search import Engine

_SAMPLER_STATE = "cma"
"""Optuna pickles this sampler's state into its trials' attributes. It never leaves the memory, and is
never read from stored trials: whoever writes in a shared study could run code here."""


@dataclass(frozen=True)
class Sampling:
    """A sampler's study in memory and the ranges that it samples from.

    `numbers` of its trials, where their choices go by turns, which begin with those of `first`.
    """

    study: optuna.Study
    distributions: dict[str, BaseDistribution]
    seed: int
    first: Params
    numbers: Iterator[int] | None = None


def sampling(
    engine: Engine,
    variables: Sequence[Variable],
    objectives: int,
    seed: int,
    batch: int,
    past: Iterable[FrozenTrial] = (),
    first: Params | None = None,
) -> Sampling:
    """An engine that knows the past trials of its study, and asks for `first` where there are none."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    past = [_without_sampler_state(trial) for trial in past]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
        sampler = _sampler(engine, seed, batch, past)
    study = optuna.create_study(sampler=sampler, directions=[StudyDirection.MINIMIZE] * objectives)
    study.add_trials(past)
    asked = len(past)
    if first is not None and not past:
        study.enqueue_trial(dict(first))
        asked = 1
    numbers = count(asked) if engine == "random" else None
    distributions = {v.name: _distribution(v) for v in variables}
    return Sampling(study, distributions, seed, first or {}, numbers)


def ask(engine: Sampling, trials: int) -> list[Trial]:
    """The next trials; their `params` hold a value for every variable."""
    return [_ask(engine) for _ in range(trials)]


def _ask(engine: Sampling) -> Trial:
    if engine.numbers is not None:
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
    return _without_sampler_state(became)


def tell_failed(engine: Sampling, trial: Trial, reason: str) -> FrozenTrial:
    """A trial that came to nothing; the trial as it is to be kept."""
    engine.study.tell(trial, state=TrialState.FAIL)
    return create_trial(
        state=TrialState.FAIL,
        params=dict(trial.params),
        distributions=engine.distributions,
        user_attrs={"failure": reason},
    )


def _without_sampler_state(trial: FrozenTrial) -> FrozenTrial:
    kept = copy(trial)
    kept.system_attrs = {
        key: value
        for key, value in trial.system_attrs.items()
        if not key.startswith(_SAMPLER_STATE)
    }
    return kept


def _sampler(engine: Engine, seed: int, batch: int, past: list[FrozenTrial]) -> BaseSampler:
    if engine == "random":
        return RandomSampler(seed=seed)
    if engine == "nsga-ii":
        return NSGAIISampler(seed=seed, population_size=max(batch, 20))
    if engine == "nsga-iii":
        return NSGAIIISampler(seed=seed, population_size=max(batch, 20))
    if engine == "cma-es":
        complete = [trial for trial in past if trial.state == TrialState.COMPLETE]
        return CmaEsSampler(
            seed=seed,
            independent_sampler=RandomSampler(seed=seed),
            warn_independent_sampling=False,
            source_trials=[_lengths_only(trial) for trial in complete] or None,
        )
    return TPESampler(seed=seed, constant_liar=True, n_startup_trials=max(batch, 20))


def _lengths_only(trial: FrozenTrial) -> FrozenTrial:
    """What CMA-ES samples of a trial; it starts from no trial that has more."""
    kept: dict[str, BaseDistribution] = {
        name: one
        for name, one in trial.distributions.items()
        if isinstance(one, FloatDistribution) and not one.single()
    }
    return create_trial(
        params={name: trial.params[name] for name in kept}, distributions=kept, values=trial.values
    )


def _distribution(variable: Variable) -> BaseDistribution:
    if variable.choices:
        return CategoricalDistribution(variable.choices)
    return FloatDistribution(variable.low, variable.high)
