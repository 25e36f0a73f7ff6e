"""Readers of places from the field: the nearest press, a twin's table, a Gaussian process, both."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel.fit import Fitted, drawn_places
from estimator.calibration.known_travel.model import TravelModel
from estimator.recordings.formats.travel import TravelRecording
from studies.recorded.travel_places import (
    PlaceErrors,
    gaussian_process,
    place_errors,
    places_by_twin,
    readers,
)
from tests.support.recordings.made_travel import TWIN
from tests.support.recordings.travel_cases import (
    POSE,
    RESTING_MT,
    pad_model,
    pressed_places,
    presses_of,
    recorded,
)


def test_a_twin_helps_to_read_places_that_nobody_pressed():
    model, tip = pad_model(), pressed_places()
    recording = presses_of(tip, recorded(model, tip))
    shown = drawn_places(recording, 0.25, 0)
    right = Fitted(model.design_twin(POSE), RESTING_MT, 0.0)
    found = readers(model, right, recording.select(shown), recording.select(~shown), 0)
    alone, process, both = (
        found[name].place_rms_mm
        for name in ("twin alone", "Gaussian process", "twin and Gaussian process")
    )
    assert both < 1.1 * alone
    assert both < 0.7 * process < found["middle of the labelled places"].place_rms_mm


def test_errors_of_places_are_distances_in_the_plane_and_of_the_travel():
    true = np.zeros((3, 3))
    read = np.array([[3.0, 4.0, 0.2], [0.0, 1.0, -0.4], [0.6, 0.8, 0.9]])
    rms = np.sqrt((25 + 1 + 1) / 3), np.sqrt((0.04 + 0.16 + 0.81) / 3)
    wanted = PlaceErrors(1.0, rms[0], 0.4, rms[1])
    for name, value in vars(wanted).items():
        assert getattr(place_errors(read, true), name) == pytest.approx(value), name


def test_between_nodes_the_twin_reads_their_mean_by_likelihood():
    """Six nearest nodes, of exp(−d²/2) each, in units of what the twin leaves and of a twentieth of
    the mean variance of that."""
    model = object.__new__(TravelModel)
    model.__dict__["pressed"] = lambda _, tip: (
        np.stack([tip, tip * [0.5, 2, 1]], axis=1) + 0.01 * tip[:, :1, None]
    )
    sizes = np.array([0.4, 0.9, 0.3, 0.7, 1.5, 0.2])
    left = np.sqrt(6) * np.vstack([np.diag(sizes), -np.diag(sizes)]).reshape(12, 2, 3)
    tip = np.array([[0.3, 0.2, 0.1], [3.0, 4.0, 2.0], [1.4, 2.6, 0.9]])
    fitted = Fitted(TWIN, np.arange(6.0).reshape(2, 3), 0.0)
    field = fitted.resting_mt + model.pressed(None, tip) + 0.3
    known = np.random.default_rng(0).uniform(0, 3, (12, 3))
    of_known = fitted.resting_mt + model.pressed(None, known) + left
    labelled = TravelRecording(np.arange(12.0), known, of_known, np.arange(12))
    asked = TravelRecording(np.arange(3.0), tip, field, np.arange(3))
    found = places_by_twin(model, fitted, labelled, asked)
    axes = np.arange(0.3, 3.31, 1.0), np.arange(0.2, 4.21, 1.0), np.arange(0.1, 2.11, 0.5)
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    variance = sizes**2 + 0.05 * np.mean(sizes**2)
    for read, seen in zip(found, field, strict=True):
        off = (seen - fitted.resting_mt - model.pressed(None, nodes)).reshape(-1, 6)
        d2 = np.sum(off**2 / variance, axis=1)
        near = np.argsort(d2)[:6]
        assert_allclose(read, np.average(nodes[near], axis=0, weights=np.exp(-d2[near] / 2)))


def test_a_process_reads_targets_of_any_size_and_middle_and_uses_all_presses_in_the_end():
    """Learnt on 12 of 40 presses, conditioned on all of them: between these the curve is known."""
    x = np.linspace(0, 9, 40)[:, None]
    asked = np.linspace(0.4, 8.7, 30)[:, None]
    y, wanted = (
        np.hstack([np.sin(at / 2), 50 + 3 * np.cos(at / 2), -7 + 0.1 * at]) for at in (x, asked)
    )
    inputs, query = np.hstack([1e3 + x, -2 * x]), np.hstack([1e3 + asked, -2 * asked])
    found = gaussian_process(inputs, y, query, 1, most=12)
    assert (abs(found - wanted) < [0.02, 0.06, 0.01]).all()
