"""Numbers that the command line shows of stages."""

import pytest

from instobj.report.summary import _difference


@pytest.mark.parametrize(("presses", "shown"), [(1, "–"), (2, "0.25")])
def test_one_press_has_no_range(presses, shown):
    """Its mean, drawn anew, is always itself: ± 0.00 was shown as if it were certain."""
    row = {"name": "ridge", "presses": presses}
    row["force_n_less_model"] = {"mean": -0.5, "low": -0.75, "high": -0.25}
    assert _difference(row, "force_n_less_model", "N") == {"Δ N": "-0.50", "± N": shown}
