"""Recordings made by a shell on one interface are told from those of another, and only then."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

import studies.recorded.interface_fits as interfaces
from estimator.calibration.recorded_presses import RecordedPresses
from studies.loose_core.press import LooseCore
from studies.loose_core.response import loose_shell
from studies.recorded.interface_fits import interface_agreement, preference
from tests.support.objects.small_object import small_mesh, small_spec

pytestmark = pytest.mark.slow
CASES = (((3, -3.0, 2.0),), ((3, 5.0, 4.0),), ((3, 2.5, -6.5),))
COPIES = 2


@pytest.fixture(scope="module")
def spec():
    return small_spec()


@pytest.fixture(scope="module")
def made(spec):
    """Presses recorded of a shell on its core with friction 1, and what each interface says of them."""
    shell = loose_shell(small_mesh(), spec)
    case = np.repeat(np.arange(len(CASES)), COPIES)
    force = np.zeros((len(case), 6))
    force[:, 2] = np.linspace(3, 6, len(case))
    blank = RecordedPresses(
        np.ones((len(case), 45)),
        force,
        case,
        case % 2,
        np.full(len(case), 50),
        CASES,
        np.full(3, 9.0),
    )
    patch = pytest.MonkeyPatch()
    patch.setattr(interfaces, "DEPTHS_MM", (1.0, 2.0))
    counts = {}

    def kept(*given):
        found = predict(*given)
        counts["newest"] = found.counts
        return found

    predict = interfaces.predict
    patch.setattr(interfaces, "predict", kept)
    interface_agreement(spec, shell, blank, "true", LooseCore(1.0))
    signal = counts["newest"][np.arange(len(case)), case]
    signal = signal + np.random.default_rng(1).normal(0, 2, signal.shape)
    presses = replace(blank, signal_counts=signal)
    found = {
        name: interface_agreement(spec, shell, presses, name, core)
        for name, core in {"bonded": None, "true": LooseCore(1.0)}.items()
    }
    patch.undo()
    return presses, found


def test_the_interface_that_made_the_recordings_fits_them(made):
    presses, found = made
    true, bonded = found["true"], found["bonded"]
    rows = np.arange(len(presses))
    assert true.cosine[rows, presses.case].min() > 0.99
    assert true.agreements[0].cosine.value > bonded.agreements[0].cosine.value
    assert_allclose(true.agreements[0].size_ratio, 1, atol=0.05)
    assert true.force_at_2_mm < bonded.force_at_2_mm


def test_it_is_preferred_and_an_interface_to_itself_is_not(made):
    presses, found = made
    told = preference(presses, found["true"], found["bonded"], 1)
    assert told.difference > 0
    assert told.better == told.cases == len(CASES)
    assert told.p_cases == 2 / 2 ** len(CASES)
    same = preference(presses, found["true"], found["true"], 1)
    assert (same.difference, same.p_places, same.p_cases, same.better) == (0, 1, 1, 0)
    turned = preference(presses, found["bonded"], found["true"], 1)
    assert_allclose(turned.difference, -told.difference)
