"""Every proof of the mechanics holds, and notices its planted fault."""

import pytest
import verification_checks_contact
import verification_checks_elements
import verification_checks_magnets
import verification_checks_punch
import verification_checks_shell
from verification import outcome_of

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
