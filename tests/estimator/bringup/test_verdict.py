"""Faults planted in simulated new objects are named; healthy objects raise no alarm."""

import pytest

from design.spec.object import ObjectSpec
from estimator.bringup.asking.asked import asked_of
from estimator.bringup.simulated import brought_up, parse_fault, simulated_object
from estimator.bringup.verdict import judge
from tests.support.new_objects import BOX, SMALL

SPEC = ObjectSpec.model_validate({"name": "cube", "sensors": {"cross_axis_tolerance": 0.01}})
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
    return found(spec, brought_up(made))


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


@pytest.mark.slow
@pytest.mark.parametrize("chip", ["F1-S1", "F5-S2"])
def test_a_gain_is_named_where_two_chips_a_face_are_far_from_the_next(chip):
    for seed in range(4):
        assert named(BOX, seed, f"gain={chip}=1.1") == {("gain", chip)}
