"""Presses of tips off the middle, on faces that are half-spaces, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest

from design.spec.silicone import PronyTermSpec
from fem.presses.compliance_map import compliance_map
from fem.presses.discretisation import coarser, mesh_difference, sample_presses
from fem.presses.joint import Tip, press_path, press_tips, refined_faces
from fem.presses.table import simulate_lattice
from fem.presses.to_force import press_to_force, squeeze
from fem.presses.viscoelastic import relaxed_force_n
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import coarse_spec
from tests.support.recorded_facts import assert_on_record, told, told_whole

SPEC = coarse_spec(
    contact_grid={"count": (2, 3), "pitch_mm": 4.0},
    press={"depths_mm": (0.6, 1.4)},
    magnets={"positions_mm": [[3.0, -6.0], [-7.0, 2.0]]},
    silicone={"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.47},
)
PRONY = (PronyTermSpec(fraction=0.3, time_s=2.0), PronyTermSpec(fraction=0.1, time_s=20.0))
TIPS = Tip(3, 2.0, -7.0), Tip(3, -4.0, 5.5)


def on_record(section, lines):
    assert_on_record("presses", section, lines, "fem")


@pytest.fixture(scope="module")
def response():
    return half_space_response(SPEC, 13, 0.1)


def test_presses_of_a_lattice_are_as_on_record(response):
    forces, motions = simulate_lattice(SPEC, response)
    lines = [*told_whole("forces", forces), told("motions", motions.motion)]
    on_record("lattice", [*lines, *told_whole("compliance", compliance_map(forces))])


def test_joint_presses_are_as_on_record(response):
    depths = np.array([[0.5, 0.3], [1.2, 1.0]])
    path = press_path(SPEC, response, list(TIPS), depths, refined_faces(SPEC, response))
    lines = [line for one in path for line in told_whole("on a path", one)]
    lines += told_whole("at once", press_tips(SPEC, response, list(TIPS), depths[1]))
    on_record("joint presses", lines)


def test_presses_to_a_force_are_as_on_record(response):
    lines = [
        *told_whole("to 2 N", press_to_force(SPEC, response, ((TIPS[0],), (TIPS[1],)), 2.0)),
        *told_whole("squeezed", squeeze(SPEC, response, ((TIPS[0],), (Tip(5, -3.0, 4.0),)), 3.0)),
        told("relaxed", relaxed_force_n(np.arange(12.0).reshape(2, 6), np.arange(6) / 2, PRONY)),
    ]
    on_record("to a force", lines)


def test_samples_of_presses_are_as_on_record(response):
    one, other = (sample_presses(SPEC, made) for made in (half_space_response(SPEC, 9), response))
    lines = [
        *told_whole("sample", one),
        *told_whole("difference", mesh_difference(one, other)),
        f"coarser: {coarser(SPEC).mesh}",
    ]
    on_record("samples", lines)
