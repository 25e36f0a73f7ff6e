"""False alarms: thresholds and rates by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from studies.paper.false_alarms import false_alarms, fixed_threshold_n, noticed_from


def maps(*largest):
    frames = np.zeros((len(largest), 2, 3))
    frames[:, 1, 2] = largest
    return frames


def test_the_threshold_lets_the_wanted_share_of_rest_frames_pass():
    predicted = maps(*np.arange(200) / 100.0, 50.0)
    rest = np.arange(201) < 200
    threshold = fixed_threshold_n(predicted, rest, rate=0.01)
    assert threshold == 1.97
    found = false_alarms(predicted, np.zeros((201, 2, 3)), rest, threshold)
    assert_allclose(found.false_alarm_rate, 0.01, rtol=1e-12)
    with pytest.raises(InputError, match="at least 100 rest frames"):
        fixed_threshold_n(predicted[:99], rest[:99])


def test_rates_by_hand():
    """Rest 0.1, 0.6; pressed elsewhere 9; contacts of 1, 2, 3, 4 N seen as 0.2, 0.7, 0.4, 5."""
    predicted = maps(0.1, 0.6, 9.0, 0.2, 0.7, 0.4, 5.0)
    true = maps(0, 0, 0, 1.0, 2.0, 3.0, 4.0)
    rest = np.array([True, True, False, False, False, False, False])
    found = false_alarms(predicted, true, rest, 0.5)
    assert (found.false_alarm_rate, found.miss_rate) == (0.5, 0.5)
    assert found.noticed_from_n == 4.0
    lower = false_alarms(predicted, true, rest, 0.3)
    assert (lower.false_alarm_rate, lower.miss_rate) == (0.5, 0.25)
    assert false_alarms(predicted, true, rest, 0.1).noticed_from_n == 1.0
    assert false_alarms(predicted, true, rest, 10.0).summary()["noticed_from_n"] is None


def test_a_force_isnoticed_from_where_nineteen_of_twenty_raise_the_alarm():
    force = np.arange(40.0, 0, -1)
    alarm = np.ones(40, bool)
    alarm[19] = False  # of 21 N: nineteen of the twenty at least as strong are noticed
    assert noticed_from(force, alarm) == 1.0
    alarm[38] = False
    assert noticed_from(force, alarm) == 1.0
    alarm[39] = False
    assert noticed_from(force, alarm) == 3.0
    early = np.ones(40, bool)
    early[18] = False
    assert noticed_from(force[:19], early[:19]) == 23.0
    assert np.isnan(noticed_from(force[:3], ~early[:3]))
