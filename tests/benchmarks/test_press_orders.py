"""Error of a calibrated twin at places whose deepest press stays below the judged forces."""

from dataclasses import replace

import numpy as np

from benchmarks.rig.press_orders import FACE, left_share
from benchmarks.rig.sessions import LEVELS_N, hidden_object, recorded
from design.layout.places.contact_grid import contact_grid
from estimator.calibration.twin.digital_twin import calibrate
from estimator.calibration.twin.pressed_places import pressed_places
from instobj.bench.rig.plan import PressSettings, press_plan, stops_of
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses


def test_places_that_yield_at_two_newtons_are_judged_at_their_deepest_press():
    spec = coarse_spec()
    forces, motions = synthetic_presses(spec)
    edge = np.linspace(0.1, 1.0, forces.force_n.shape[1])[:, None]
    table = replace(forces, force_n=forces.force_n * edge), motions
    hidden = hidden_object(spec, table, FACE, 0)
    xy = contact_grid(spec).xy_mm
    assert hidden.traces(xy).force_n[:, -1].min() < LEVELS_N[-1]
    plan = press_plan(spec, FACE, PressSettings(stops_of(spec)), 0, 1, 10)
    twin = calibrate(spec, *table, pressed_places(spec, recorded(hidden, plan, table[0], 1), FACE))
    assert 0 < left_share(hidden, table, twin, xy) < 0.2
