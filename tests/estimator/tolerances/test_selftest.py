"""Faults planted in simulated resting signals are found; healthy objects raise no alarm."""

from dataclasses import replace

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.signals.presses import rest_counts
from estimator.tolerances.assembly import draw
from estimator.tolerances.selftest import (
    _design,
    _rest,
    false_alarm_rate,
    rank,
    rest_model,
    self_test,
)

SPEC = ObjectSpec(name="cube")
RNG = np.random.default_rng(2)
KINDS = ("flipped magnet", "swapped sensors", "swapped channels", "dead sensor", "dead channel")


@pytest.fixture(scope="module")
def model():
    return rest_model(SPEC)


def healthy(seed):
    design, field = _design(SPEC)
    rng = np.random.default_rng(seed)
    return _rest(SPEC, draw(SPEC, design, rng), field) + 10 * rng.standard_normal(45)


def planted(counts, fault, rng):
    counts = counts if fault.shift is None else counts + fault.shift
    counts = counts.copy() if fault.order is None else counts[fault.order]
    counts[list(fault.silent)] = rng.uniform(-32000, 32000, len(fault.silent))
    return counts


def found_of(model, kind, objects=15):
    """Share of planted faults of a kind that are named exactly, each on an object of its own."""
    rng = np.random.default_rng(5)
    faults = [fault for fault in model.faults if fault.kind == kind]
    hypotheses = [(), *((fault,) for fault in model.faults)]
    named = 0
    for seed in range(objects):
        fault = faults[rng.integers(len(faults))]
        best = rank(model, planted(healthy(seed), fault, rng), hypotheses)[0]
        named += best.name == str(fault)
    return named / objects


@pytest.mark.parametrize("kind", KINDS)
def test_single_faults_are_named(model, kind):
    """Swapped channels that read nearly the same are missed, and do no harm."""
    assert found_of(model, kind) >= (0.6 if kind == "swapped channels" else 0.8)


def test_a_wrong_model_of_flips_names_none(model):
    wrong = tuple(f if f.shift is None else replace(f, shift=-f.shift) for f in model.faults)
    rng, hypotheses = np.random.default_rng(8), [(), *((fault,) for fault in wrong)]
    counts = planted(healthy(0), model.faults[6], rng)
    best = rank(replace(model, faults=wrong), counts, hypotheses)[0]
    assert best.name != str(model.faults[6])


def test_two_faults_are_named(model):
    flipped = next(f for f in model.faults if f.where == "magnet 2 of face 4")
    swapped = next(f for f in model.faults if f.where == "F1-S2 and F3-S1")
    counts = planted(planted(healthy(3), flipped, RNG), swapped, RNG)
    best = self_test(SPEC, model, counts, healthy_objects=2).best
    assert {str(f) for f in best.faults} == {str(flipped), str(swapped)}
    assert best.fit > 0.001


def test_healthy_objects_raise_no_alarm(model):
    assert false_alarm_rate(SPEC, model, 300) <= 0.05
    result = self_test(SPEC, model, healthy(11), healthy_objects=2)
    assert result.best.name == "as specified"
    assert result.believed


def test_dead_channels_are_left_out(model):
    counts = healthy(4)
    counts[[7, 8]] = np.nan
    assert self_test(SPEC, model, counts, healthy_objects=2).best.name == "as specified"


def test_what_no_fault_explains_is_not_believed(model):
    counts = healthy(4) + 1500 * np.sin(np.arange(45.0))
    assert not self_test(SPEC, model, counts, healthy_objects=2).believed


def test_a_flip_that_is_known_raises_no_alarm(model):
    found = {"magnets": [{"face": 4, "magnet": 2, "flipped": True}]}
    known = ObjectSpec.model_validate({"name": "cube", "as_built": found})
    flip = next(f for f in model.faults if f.where == "magnet 2 of face 4")
    hypotheses = [(), *((fault,) for fault in model.faults)]
    counts = healthy(6) + flip.shift
    assert rank(model, counts, hypotheses)[0].faults == (flip,)
    moved = replace(model, mean=rest_counts(known).ravel())
    assert rank(moved, counts, hypotheses)[0].faults == ()
