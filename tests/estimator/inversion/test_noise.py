"""Sizes of disturbances that an inversion allows for, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.inversion.model import noise


def signals(change, pressed):
    return SimpleNamespace(delta_counts=change, pressed=pressed)


def test_a_design_errs_as_objects_within_tolerance_differ_from_it(monkeypatch):
    """Rms over the presses that are there; with what meshes differ by."""
    rng = np.random.default_rng(1)
    design = 100 * rng.standard_normal((2, 4, 3, 5, 3))
    pressed = np.ones((2, 4), bool)
    pressed[1, 2] = False
    design[1, 2] = np.nan
    shares = iter((0.1, -0.2, 0.3))
    monkeypatch.setattr(noise, "drawn_assembly", lambda spec, seed: seed)
    monkeypatch.setattr(
        noise, "twin_signals", lambda *given: signals((1 + next(shares)) * design, pressed)
    )
    spec = SimpleNamespace(seed=3)
    found = noise.design_error.__wrapped__(spec, None, None, signals(design, pressed))
    assert found == pytest.approx(np.sqrt((0.01 + 0.04 + 0.09) / 3 + noise.MESH_ERROR**2))


def test_white_noise_and_zeros_are_those_of_the_specification():
    spec = ObjectSpec.model_validate(
        {
            "name": "cube",
            "sensors": {"noise_counts": (3.0, 4.0, 5.0), "zeroing_counts": 6.0},
        }
    )
    found = noise.disturbances(spec, 0.05, 0.02)
    assert_allclose(found.noise_counts, np.tile([3.0, 4.0, 5.0], 15))
    assert_allclose(found.offset_counts, 6.0)
    assert_allclose(found.model_error, np.hypot(0.05, noise.SUM_ERROR))
    assert found.force_error == 0.02
    each = noise.disturbances(spec, np.linspace(0, 0.1, 15)[:, None], 0.0)
    assert_allclose(each.model_error[::3], np.hypot(np.linspace(0, 0.1, 15), noise.SUM_ERROR))


def test_a_frame_s_sigmas_are_noise_of_its_readings_zeros_and_the_model_s_share():
    told = noise.Disturbances(np.full(6, 4.0), np.full(6, 3.0), np.repeat([0.1, 0.5], 3))
    counts = np.array([[30.0, 0, 40, 0, 0, np.nan], [0.0] * 6])
    found = told.observed(counts, np.array([1, 4]))
    own = np.sqrt((16 + 1 / 12) / np.array([1, 4]) + 9)
    assert_allclose(found.counts[0], [30, 0, 40, 0, 0, 0])
    change = 50 / np.sqrt(3)
    assert_allclose(found.sigma[0, :3], np.hypot(own[0], 0.1 * change))
    assert_allclose(found.sigma[0, 3:], [own[0], own[0], noise.BLIND])
    assert_allclose(found.sigma[1], own[1])
    loud = told.observed(np.tile([30.0, 0, 40], (1, 2)))
    assert_allclose(loud.sigma[0, 3:], np.hypot(own[0], 0.5 * change))
    assert noise.MOST_ERROR == 0.25
    strict = np.hypot(own[0], np.repeat([0.1, 0.25], 3) * change)
    assert any(
        np.allclose(value[0], strict) for value in vars(loud).values() if np.ndim(value) == 2
    )
