"""Height of first touch from steps down into materials of any stiffness."""

import numpy as np
import pytest

from instobj.bench.rig.touch import felt_enough, first_touch_mm

TOUCH_N = 0.2


@pytest.mark.parametrize("stiffness", [0.3, 1.0, 3.0, 10.0, 30.0])
@pytest.mark.parametrize(("tip", "power"), [("hemisphere", 1.5), ("flat", 1.0)])
def test_the_surface_is_found_in_soft_and_in_stiff_materials(tip, power, stiffness):
    rng = np.random.default_rng(3)
    for surface_mm in rng.uniform(-30.5, -29.5, 20):
        heights, forces = [], []
        while not felt_enough(np.array(forces), TOUCH_N):
            heights.append(-29.0 - 0.1 * len(heights))
            depth_mm = max(surface_mm - heights[-1], 0.0)
            forces.append(stiffness * depth_mm**power + 0.005 * rng.standard_normal())
        found = first_touch_mm(np.array(heights), np.array(forces), TOUCH_N, tip)
        assert found == pytest.approx(surface_mm, abs=0.06)
