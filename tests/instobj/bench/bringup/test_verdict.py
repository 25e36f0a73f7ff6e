"""Faults planted in simulated new objects are named; healthy objects raise no alarm."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from instobj.bench.bringup.asking.asked import asked_of
from instobj.bench.bringup.simulated import parse_fault, simulated_object
from instobj.bench.bringup.verdict import judge
from tests.support.new_objects import SMALL

SPEC = ObjectSpec.model_validate({"name": "cube", "sensors": {"chip_spread": [0.0, 0.01]}})
PLANTED = {
    "swap=F1-S2,F3-S1": ("swapped chips", "F1-S2 and F3-S1"),
    "turn=F5-S1": ("turned chip", "F5-S1"),
    "twist=F4-S1": ("turned chip", "F4-S1"),
    "mirror=F4-S2": ("mirrored chip", "F4-S2"),
    "flip=F3-M2": ("flipped magnet", "F3-M2"),
    "dead=F4-Y1": ("dead axis", "F4-Y1"),
    "stuck=F2-X2": ("dead axis", "F2-X2"),
    "silent=F2-S1": ("silent chip", "F2-S1"),
    "gain=F2-S2=1.1": ("gain", "F2-S2"),
}


def named(spec, seed, *faults):
    made = simulated_object(spec, seed, tuple(map(parse_fault, faults)))
    return found(spec, {asked.name: made.recording(asked) for asked in asked_of(spec)})


def found(spec, recordings):
    return {(finding.kind, finding.where) for finding in judge(spec, recordings).findings}


def test_a_healthy_object_raises_no_alarm():
    made = simulated_object(SMALL, 1)
    assert found(SMALL, {asked.name: made.recording(asked) for asked in asked_of(SMALL)}) == set()


@pytest.mark.slow
@pytest.mark.parametrize("fault", PLANTED)
def test_every_planted_fault_is_named_alone_in_each_of_20_objects(fault):
    wrong = {s: seen for s in range(20) if (seen := named(SPEC, s, fault)) != {PLANTED[fault]}}
    assert not wrong


@pytest.mark.slow
def test_50_healthy_objects_raise_no_alarm():
    assert not {s: seen for s in range(100, 150) if (seen := named(SPEC, s))}


def test_a_recording_is_offset_and_field_and_noise_and_marks_what_does_not_answer():
    made = simulated_object(SMALL, 3)
    asked = next(one for one in asked_of(SMALL) if one.step == "still")
    made.offset[:], made.slope_per_ms[:] = 500.0, 0.0
    made.silent[0, 1] = made.stuck[1, 2] = made.dead[2, 0] = True
    counts = made.recording(asked).counts
    rest = np.ones_like(made.silent)
    rest[0, 1] = rest[1, 2] = False
    assert np.isnan(counts[:, 0, 1]).all()
    assert np.ptp(counts[:, 1, 2]) == 0
    earth = 1e-3 * 65 * SMALL.sensors.counts_per_mt * 1.2
    assert (abs(counts.mean(axis=0) - 500)[rest] < earth + 20).all()
    assert counts[:, 2, 0].mean() == pytest.approx(500, abs=20)
