"""One made-up object whose layouts are scored in batches on one face."""

import pytest

from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from tests.support.mechanics.candidate_cases import FACE, made_up_motions, made_up_spec


@pytest.fixture(scope="session")
def spec():
    return made_up_spec()


@pytest.fixture(scope="session")
def motions(spec):
    return made_up_motions(spec)


@pytest.fixture(scope="session")
def presses(spec, motions):
    return press_basis(spec, motions, FACE)


@pytest.fixture(scope="session")
def scorer(spec, presses):
    return layout_scorer(spec, presses)
