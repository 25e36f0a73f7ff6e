"""Shapes and types of every annotated public function are enforced while the tests run."""

from pathlib import Path

import pytest
from jaxtyping import install_import_hook

install_import_hook(["design", "fem", "estimator"], "beartype.beartype")

VERIFICATION_OUTCOMES = pytest.StashKey[list]()


def pytest_addoption(parser):
    parser.addoption(
        "--verification-page",
        metavar="DIR",
        type=Path,
        help="write the table and figures of tests/fem/verification/test_verification.py into this folder",
    )


def pytest_configure(config):
    config.stash[VERIFICATION_OUTCOMES] = []


@pytest.fixture
def verification_outcomes(request):
    """Outcomes of checks, written as a page when the run ends."""
    return request.config.stash[VERIFICATION_OUTCOMES]


def pytest_sessionfinish(session):
    folder = session.config.getoption("--verification-page")
    outcomes = session.config.stash[VERIFICATION_OUTCOMES]
    if folder and outcomes:
        from tests.support.verification import write_page

        write_page(outcomes, folder)
