"""Made-up scores of the layout that a search starts from."""

import numpy as np

from estimator.layouts.fidelity import FidelityScore

START = FidelityScore(
    worst_position_bound_mm=1.5,
    percentile_99_position_bound_mm=1.2,
    percentile_95_position_bound_mm=1.0,
    median_position_bound_mm=0.5,
    position_over_limit=1.2,
    worst_force_bound_n=2.5,
    median_false_force_n=1.2,
    percentile_95_false_force_n=3.0,
    sensitivity_ratio=0.3,
    saturation_margin=0.8,
    objects_margin=0.4,
    position_bounds_mm=tuple(np.linspace(0.3, 1.5, 200).tolist()),
)
