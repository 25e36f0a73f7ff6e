"""Predicted against recorded changes: ten contact locations are named, more have one colour."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import RecordedPresses
from estimator.calibration.validation import Predictions
from instobj.figures.validation import draw_scatter

SPEC = ObjectSpec.model_validate({"name": "one", "body": {"sensed_faces": [1]}})


@pytest.mark.parametrize(("count", "named"), [(10, True), (100, False)])
def test_no_two_contact_locations_share_a_colour_in_the_list(count, named):
    cases = tuple(((1, float(k), 0.0),) for k in range(count))
    signal = np.arange(9.0 * count).reshape(count, 9)
    zeros = np.zeros(count, int)
    presses = RecordedPresses(
        signal, np.ones((count, 6)), np.arange(count), zeros, zeros + 9, cases, np.ones(3)
    )
    counts = np.broadcast_to(signal[:, None], (count, count, 9))
    predictions = Predictions(counts, np.broadcast_to(counts, (1, *counts.shape)))
    figure = Figure(figsize=(4.4, 5.6), layout="constrained")
    axes = figure.subplots()
    draw_scatter(axes, SPEC, presses, predictions, 1)
    figure.draw_without_rendering()
    legend = axes.get_legend()
    assert legend is not None
    assert len(legend.get_texts()) == (count + 1 if named else 1)
    assert len({str(line.get_color()) for line in axes.lines[:count]}) == (count if named else 1)
    assert axes.get_position().height > 0.3
