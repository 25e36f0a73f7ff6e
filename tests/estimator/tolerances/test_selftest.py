"""Faults planted in simulated resting signals are found; healthy objects raise no alarm."""

from dataclasses import replace

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.signals.presses import rest_counts
from estimator.tolerances import selftest
from estimator.tolerances.assembly import draw
from estimator.tolerances.selftest import (
    design_at_rest,
    false_alarm_rate,
    rank,
    rest_model,
    resting_counts,
    self_test,
)

SPEC = ObjectSpec(name="cube")
RNG = np.random.default_rng(2)
KINDS = ("flipped magnet", "swapped sensors", "swapped channels", "dead sensor", "dead channel")


@pytest.fixture(scope="module")
def model():
    return rest_model(SPEC)


def healthy(seed):
    design, field = design_at_rest(SPEC)
    rng = np.random.default_rng(seed)
    return resting_counts(SPEC, draw(SPEC, design, rng), field) + 10 * rng.standard_normal(45)


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


def test_every_magnet_pair_of_sensors_pair_of_channels_sensor_and_channel_may_be_at_fault(model):
    counted = {kind: sum(one.kind == kind for one in model.faults) for kind in KINDS}
    assert counted == {
        "flipped magnet": 25,
        "swapped sensors": 15 * 14 // 2,
        "swapped channels": 45 * 44 // 2,
        "dead sensor": 15,
        "dead channel": 45,
    }
    first = {kind: next(one for one in model.faults if one.kind == kind) for kind in KINDS}
    assert str(first["flipped magnet"]) == "flipped magnet: magnet 1 of face 1"
    assert first["dead sensor"].silent == (0, 1, 2)
    swapped = first["swapped sensors"].order
    assert swapped[:6].tolist() == [3, 4, 5, 0, 1, 2]
    assert swapped[6:].tolist() == list(range(6, 45))
    last = [one for one in model.faults if one.kind == "swapped channels"][-1]
    assert last.order.tolist() == [*range(43), 44, 43]
    dead = [one for one in model.faults if one.kind == "dead channel"]
    assert [one.silent for one in dead] == [(channel,) for channel in range(45)]
    dead = [one for one in model.faults if one.kind == "dead sensor"]
    assert [one.silent for one in dead] == [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(15)]
    assert len({str(one) for one in model.faults}) == len(model.faults)


def test_a_flip_shifts_the_rest_by_twice_its_own_field(model):
    """Without plates the field is the sum over magnets; a flip turns one of them round."""
    flips = [one.shift for one in model.faults if one.kind == "flipped magnet"]
    _, field = design_at_rest(SPEC)
    whole = rest_counts(SPEC, field).ravel()
    offset = whole + 0.5 * np.sum(flips, axis=0)
    assert abs(offset).max() < 1e-6 * abs(whole).max()


def test_silent_channels_are_marginalised_as_if_they_were_not_there():
    """The quadratic form and the determinant of the others' own covariance."""
    rng = np.random.default_rng(0)
    root = rng.normal(size=(6, 6))
    covariance = root @ root.T + np.eye(6)
    made = selftest.RestModel(np.zeros(6), covariance, (), 1e9)
    residual = rng.normal(size=(3, 6))
    silent = np.zeros((3, 6), bool)
    silent[1, [0, 4]] = silent[2, 3] = True
    distance, log_volume = selftest.quadratic_forms(made, residual, silent)
    whole = np.linalg.slogdet(covariance)[1]
    for row in range(3):
        here = ~silent[row]
        block = covariance[np.ix_(here, here)]
        wanted = residual[row, here] @ np.linalg.solve(block, residual[row, here])
        assert distance[row] == pytest.approx(wanted)
        assert log_volume[row] == pytest.approx(np.linalg.slogdet(block)[1] - whole, abs=1e-9)


def test_pairs_of_faults_count_in_one_order_alone(model):
    a, b, c = model.faults[:3]
    pairs = [selftest.Hypothesis(pair, 0.0, 1.0) for pair in ((a, b), (b, a), (a, c), (a,), (b, a))]
    kept = selftest.distinct_faults(pairs)
    assert [one.faults for one in kept] == [(a, b), (a, c), (a,)]
    assert kept[0].name == f"{a} and {b}"
    assert selftest.Hypothesis((), 0.0, 1.0).name == "as specified"


def test_noise_beside_tolerances_adds_its_variance_to_every_channel():
    """4 and 3 counts of readings and of zeroing: 25 more on the diagonal, 9 without the readings'."""
    small = {"magnets": {"positions_mm": [[2.0, -3.0]]}, "body": {"sensed_faces": [1]}}

    def made(zeroing_counts, *noise_counts):
        sensors = {"sensors": {"zeroing_counts": zeroing_counts}}
        spec = ObjectSpec.model_validate({"name": "small", **small, **sensors})
        return rest_model(spec, *noise_counts).covariance

    without = made(0.0)
    np.testing.assert_allclose(made(3.0) - without, 9 * np.eye(9), atol=1e-7)
    np.testing.assert_allclose(made(3.0, 4.0) - without, 25 * np.eye(9), atol=1e-7)
