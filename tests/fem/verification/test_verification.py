"""Every proof of the mechanics holds, and notices its planted fault."""

import pytest

from tests.support import (
    verification_checks_contact,
    verification_checks_elements,
    verification_checks_magnets,
    verification_checks_punch,
    verification_checks_shell,
)
from tests.support.verification import outcome_of

CHECKS = [
    *verification_checks_elements.CHECKS,
    *verification_checks_magnets.CHECKS,
    *verification_checks_contact.CHECKS,
    *verification_checks_punch.CHECKS,
    *verification_checks_shell.CHECKS,
]


@pytest.mark.parametrize(
    "check",
    [pytest.param(check, id=check.name, marks=[pytest.mark.slow] * check.slow) for check in CHECKS],
)
def test_the_check_holds_and_notices_its_fault(check, verification_outcomes):
    outcome = outcome_of(check)
    verification_outcomes.append(outcome)
    assert outcome.measured.error <= check.tolerance, outcome.measured.words
    assert not outcome.faulty_error <= check.tolerance, check.fault.words
