"""What the report alone shows, as stages."""

import numpy as np
import pytest

from design.layout.places.contact_grid import press_lattice
from design.spec.object import ObjectSpec
from estimator.signals.presses import Signals
from instobj.stages.makers.report import TravelSpread, travel_spread

SPEC = ObjectSpec(name="cube")
UNKNOWN = ObjectSpec.model_validate({"name": "cube", "silicone": {"youngs_modulus_mpa": 2.0}})


def test_travel_grows_where_the_silicone_is_softer():
    """Force 6 δ newtons everywhere; 15 N take 2.5 mm at E, 6 δ (0.54 / 0.414) takes 1.917 mm."""
    lattice, depths = press_lattice(SPEC), np.array([1.0, 2.0, 4.0])
    force = np.broadcast_to(6 * depths, (5, len(lattice), 3)).copy()
    empty = np.zeros((5, len(lattice), 3, 15, 3))
    signals = Signals(np.arange(1, 6), lattice, depths, force, empty, np.zeros((15, 3)))
    found = travel_spread(SPEC, signals)
    assert isinstance(found, TravelSpread)
    assert found.nominal_mm == pytest.approx(2.5)
    assert found.stiffest_mm == pytest.approx(2.5 * 0.414 / 0.54)
    assert found.softest_mm is None
    assert travel_spread(UNKNOWN, signals) is None
