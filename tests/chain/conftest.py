"""Smaller statistics in whole chains; tests beside them show how good the full ones are."""

import pytest

from estimator.calibration import digital_twin
from estimator.evaluation import baselines


@pytest.fixture(autouse=True, scope="module")
def _smaller_statistics():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(baselines, "_TREES", 20)
        patch.setattr(baselines, "_BOOSTS", 30)
        patch.setattr(digital_twin, "_FOLDS", 2)
        yield
