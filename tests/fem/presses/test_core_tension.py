"""The largest tension at a core that only touches, by hand."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.presses import core_tension as module
from fem.presses.core_tension import CoreTension, largest_core_tension


def tension(pressures, monkeypatch, core=True):
    """Two vertices of 2 and 3 mm² that push 1 N/MPa and 2 N/MPa onto three points of the core."""
    monkeypatch.setattr(module, "surface_weights_mm2", lambda surface: np.array([2.0, 3.0]))
    held = SimpleNamespace(
        force_per_load=np.array([[1.0, 0.5], [-0.2, 0.1], [0.3, -1.0]]),
        weights_mm2=np.array([1.0, 2.0, 4.0]),
        points_mm=np.arange(9.0).reshape(3, 3),
    )
    response = SimpleNamespace(
        core=held if core else None, surfaces=[None], face_loads=lambda index: slice(0, 2)
    )
    return largest_core_tension.__wrapped__(response, 0, np.array(pressures))


def test_tension_is_the_pull_of_a_point_over_its_area_and_the_press_s_force(monkeypatch):
    """Of 0.3, 0.2 and 0.5 N: small presses count as well, those without force do not."""
    found, press = tension([[0.0, 0.0], [0.15, 0.0], [0.1, 0.1]], monkeypatch)
    assert (press, found.point_mm.tolist()) == (1, [3.0, 4.0, 5.0])
    assert_allclose(found.pressure_mpa_per_n, 0.2 * 0.15 / 2 / 0.3)
    found, press = tension([[0.0, 0.0], [0.1, 0.1], [0.0, 0.2 / 3]], monkeypatch)
    assert (press, found.point_mm.tolist()) == (2, [6.0, 7.0, 8.0])
    assert_allclose(found.pressure_mpa_per_n, 1.0 * (0.2 / 3) / 4 / 0.2)


def test_what_has_no_tension_is_refused(monkeypatch):
    with pytest.raises(ValueError, match="none of the presses touches"):
        tension([[0.0, 0.0]], monkeypatch)
    with pytest.raises(ValueError, match="frictionless interface only"):
        tension([[0.1, 0.0]], monkeypatch, core=False)


def test_tensions_are_told_per_newton_with_their_press():
    plain = CoreTension(0.02, np.array([1.0, 2.0, 3.0]))
    place = {"x_mm": 1.0, "y_mm": 2.0, "z_mm": 3.0}
    assert plain.to_dict() == {"largest_tension_kpa_per_n": 20.0} | place
    pressed = CoreTension(0.02, np.array([1.0, 2.0, 3.0]), (4, -5.0, 6.0), 0.25)
    for lone in ({"press": (3, 1.0, 2.0)}, {"force_drop": 0.25}):
        assert replace(plain, **lone).to_dict() == plain.to_dict()
    assert pressed.to_dict() == plain.to_dict() | {
        "press_face": 4,
        "press_x_mm": -5.0,
        "press_y_mm": 6.0,
        "force_drop_where_it_lifts_off": 0.25,
    }
