"""State of a board in words: a battery's charge, a cable's supply, or neither."""

import pytest

from estimator.recordings.boards.lines import Status
from instobj.bench.collect.board_state import status_text, supply_text


def status(supply_mv):
    return Status(3000, supply_mv, 0, 0, 0, "power", (24.0, 25.0))


@pytest.mark.parametrize(
    ("supply_mv", "text"),
    [
        (4200, "battery 4.20 V, about 100 %"),
        (3840, "battery 3.84 V, about 50 %"),
        (3400, "battery 3.40 V, about 2 %: charge it"),
        (3100, "battery 3.10 V, about 0 %: charge it"),
        (5006, "supply 5.01 V"),
        (None, ""),
    ],
)
def test_a_battery_says_its_charge_and_a_cable_its_supply(supply_mv, text):
    assert supply_text(status(supply_mv)) == text
    words = status_text(status(supply_mv))
    assert words.startswith(
        "board: sensors 24.0 to 25.0 °C, 0 silent" + (text and f", {text}") + ";"
    )
