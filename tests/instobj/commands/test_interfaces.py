"""What `instobj interfaces` says of its p values."""

import pytest

from estimator.calibration.interfaces import Preference
from instobj.commands.recorded.interfaces import _preference_row, _text


@pytest.mark.parametrize(
    ("p_places", "p_cases", "tried", "said"),
    [
        (0.011, 0.008, 4, "preferred to bonded"),
        (0.016, 0.03, 1, "preferred to bonded"),
        (0.016, 0.03, 4, "not told from bonded"),
        (0.4, 0.001, 4, "not told from bonded"),
    ],
)
def test_an_interface_is_preferred_by_p_corrected_for_those_tried(p_places, p_cases, tried, said):
    one = Preference("friction", "bonded", 0.06, 0.02, p_places, p_cases, 7, 8)
    assert said in _text(one, tried)
    row = _preference_row(one, tried)
    assert row["p, corrected"] == pytest.approx(min(1, tried * max(p_places, p_cases)))
