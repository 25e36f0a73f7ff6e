"""Sensors within magnets are refused, wherever both are."""

import numpy as np
import pytest

from design.errors import InputError
from estimator.field.models import FieldModel
from estimator.field.sources import DiskMagnet
from estimator.signals.field_setup import check_sensor_clear

MODEL = FieldModel(DiskMagnet(6.0, 2.0, 1.3), "exact")
ONE = np.zeros(1, int)
UP = (0.0, 0.0, 1.0)


def vector(place):
    return tuple(np.array([component]) for component in place)


@pytest.mark.parametrize("centre", [(9.0, 0.0, 0.0), (0.0, -8.0, 0.0), (0.0, 0.0, 7.0)])
def test_a_sensor_is_refused_in_a_magnet_and_not_beside_it(centre):
    magnet = vector(centre), vector(UP), vector(UP)
    with pytest.raises(InputError, match="onto a sensor"):
        check_sensor_clear(vector(np.add(centre, (2.9, 0.0, 0.9))), magnet, MODEL, ONE)
    for aside in [(3.1, 0.0, 0.0), (0.0, 3.1, 0.0), (0.0, 0.0, 1.1)]:
        check_sensor_clear(vector(np.add(centre, aside)), magnet, MODEL, ONE)
