"""Residuals of presses of known travel: every chip's share, and the assumptions in their order."""

import numpy as np

from design.spec_io import load_spec
from estimator.calibration.known_travel.fit import Fitted
from estimator.recordings.formats.travel import TravelRecording
from studies.recorded.travel_suspects import FreedAssumption, draw_residuals
from tests.support.recordings.travel_cases import PAD, POSE, RESTING_MT, pad_model, pressed_places


def test_residuals_say_how_much_of_each_chip_is_unexplained(tmp_path):
    model, tip = pad_model(), pressed_places(5)
    fitted = Fitted(model.design_twin(POSE), RESTING_MT, 0.0)
    change = model.pressed(fitted.twin, tip)
    change[:, 2] *= 2
    place = np.repeat(np.arange(len(tip) // 2), 2)
    judged = TravelRecording(np.arange(50.0), tip, RESTING_MT + change, place)
    suspects = [
        FreedAssumption(name, 1, 0.9, gained, gained - 0.01, gained + 0.01, "0.2")
        for name, gained in (("chips", 0.2), ("scale of travel", 0.0))
    ]
    figure = draw_residuals(
        load_spec(PAD), model, fitted, judged, suspects, tmp_path / "residuals.png"
    )
    axes = figure.axes
    titles = [panel.get_title() for panel in axes[:5]]
    assert titles == [f"chip {k}: {25 if k == 3 else 0} % unexplained" for k in range(1, 6)]
    bars = next(panel for panel in axes if panel.patches)
    widths = dict(
        zip(
            (label.get_text() for label in bars.get_yticklabels()),
            (bar.get_width() for bar in bars.patches),
            strict=True,
        )
    )
    assert widths == {"scale of travel (1): 0.2": 0.0, "chips (1): 0.2": 20.0}
