"""Trials at the lowest fidelity level: refused at once where they cannot end in time."""

import pytest

from design.errors import InputError
from design.spec.search import SearchSpec
from instobj.search.lowest_fidelity import require_in_time


@pytest.mark.parametrize(("steps", "layouts", "fits"), [(300, 1, 100), (60, 5, 20)])
def test_trials_that_cannot_end_in_time_are_refused_with_values_that_can(steps, layouts, fits):
    def require(steps, trial_seconds=2.0):
        search = SearchSpec(polish_steps=steps, trial_seconds=trial_seconds)
        require_in_time(search, 0.02, layouts)

    with pytest.raises(InputError, match=rf"search.polish_steps to {fits} or less.* to 7$"):
        require(steps)
    require(fits)
    require(0)
    require(steps, trial_seconds=7.0)
