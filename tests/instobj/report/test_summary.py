"""Numbers that the command line shows of stages."""

import pytest

from design.spec.object import ObjectSpec
from instobj.report.summary import difference_row, identify_title


@pytest.mark.parametrize(("presses", "shown"), [(1, "–"), (2, "0.25")])
def test_one_press_has_no_range(presses, shown):
    """Its mean, drawn anew, is always itself: ± 0.00 was shown as if it were certain."""
    row = {"name": "ridge", "presses": presses}
    row["force_n_less_model"] = {"mean": -0.5, "low": -0.75, "high": -0.25}
    assert difference_row(row, "force_n_less_model", "N") == {"Δ N": "-0.50", "± N": shown}


def test_bounds_of_several_contacts_tell_their_force_and_their_limit():
    spec = ObjectSpec.model_validate({"name": "cube", "score": {"force_n": 4.5}})
    told = identify_title(spec.changed(limits=spec.limits.changed(position_bound_mm=1.25)))
    assert "each of 4.5 N or what its deepest press reaches" in told
    assert told.endswith("ok: sets whose every contact is bounded within 1.25 mm")
    assert "score.force_n" in identify_title(None)
