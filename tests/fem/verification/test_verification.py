"""Every proof of the mechanics holds, and notices its planted fault (`make verify`)."""

import pytest

from tests.support.verification import contact, elements, magnets, punch, shell
from tests.support.verification.proof import outcome_of

CHECKS = [
    *elements.CHECKS,
    *magnets.CHECKS,
    *contact.CHECKS,
    *punch.CHECKS,
    *shell.CHECKS,
]


@pytest.mark.slow
@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.name)
def test_the_check_holds_and_notices_its_fault(check, verification_outcomes):
    outcome = outcome_of(check)
    verification_outcomes.append(outcome)
    assert outcome.measured.error <= check.tolerance, outcome.measured.words
    assert not outcome.faulty_error <= check.tolerance, check.fault.words
