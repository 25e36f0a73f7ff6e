"""Bars of the robustness budget can be read, also where the worst location is far off the median."""

import pytest
from matplotlib.figure import Figure

from instobj.figures.robustness import draw_panel


@pytest.mark.parametrize(
    ("values", "largest", "scale"),
    [
        ([7.7, 0.54, 0.0, 7.3], [673.0, 5.8, 0.0, 653.0], "log"),
        ([7.7, 0.54, 0.0, 7.3], [21.0, 5.8, 0.0, 24.0], "linear"),
        ([0.0, 0.0], [1.0, 2.0], "linear"),
    ],
)
def test_the_longest_bar_takes_a_part_of_the_axis_that_can_be_seen(values, largest, scale):
    axes = Figure().subplots()
    draw_panel(axes, values, largest)
    assert axes.get_xscale() == scale
    low, high = axes.transAxes.transform([(0, 0), (1, 0)])[:, 0]
    ends = [axes.transData.transform((value, 0))[0] for value in values if value]
    if ends:
        assert 0.05 < (max(ends) - low) / (high - low) < 1
    assert all(low <= axes.transData.transform((one, 0))[0] < high for one in largest if one)
