"""What residuals point to: an assumption that is wrong explains most, one that is right gains nothing."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.calibration.known_travel.fit import drawn_places, fit_pose
from estimator.recordings.formats.travel import TravelRecording
from studies.recorded.travel_suspects import ranked_suspects
from tests.support.recordings.travel_cases import (
    POSE,
    RESTING_MT,
    pad_model,
    pressed_places,
    recorded,
)


@pytest.fixture(scope="module")
def model():
    return pad_model()


@pytest.fixture(scope="module")
def bulging(model):
    """The same pad, whose magnets move aside three times as far."""
    aside = np.arange(len(model.coefficients)) % 6 < 2
    return replace(
        model, coefficients=np.where(aside[:, None, None, None], 3, 1) * model.coefficients
    )


def ranked(model, bulging, field_mt, tip, seed=0):
    place = np.repeat(np.arange(len(tip) // 2), 2)
    recording = TravelRecording(np.arange(len(tip), dtype=float), tip, field_mt, place)
    shown = drawn_places(recording, 0.4, seed)
    parts = recording.select(shown), recording.select(~shown)
    near = replace(POSE, shift_mm=POSE.shift_mm + 0.3, contact_mm=POSE.contact_mm - 0.2)
    registered = fit_pose(model, parts[0], model.design_twin(near))
    others = {"bulging": (bulging, lambda share: f"{share:.2f}")}
    return ranked_suspects(model, registered, *parts, others, seed)


def noisy(model, change):
    noise = 0.005 * np.random.default_rng(1).standard_normal(change.shape)
    return RESTING_MT + change + noise


def test_nothing_gains_where_the_model_is_right(model, bulging):
    tip = pressed_places(7)
    for one in ranked(model, bulging, recorded(model, tip), tip):
        assert one.explained > 0.98, one.name
        assert abs(one.gained) < 0.004, one.name
        assert one.low <= one.gained <= one.high


def test_chips_that_read_otherwise_come_first(model, bulging):
    tip = pressed_places(7)
    matrix = np.eye(3) + 0.25 * np.random.default_rng(2).standard_normal((5, 3, 3))
    change = np.einsum("sij,nsj->nsi", matrix, model.pressed(model.design_twin(POSE), tip))
    first, second, *_ = ranked(model, bulging, noisy(model, change), tip)
    assert first.name == "chips"
    assert first.numbers == 45
    assert first.low > 0.02
    assert first.explained > 0.98
    assert first.gained > second.gained + 0.01


def test_a_machine_that_leans_comes_first(model, bulging):
    tip = pressed_places(7)
    lower = tip.copy()
    lower[:, 2] += (tip[:, :2] - POSE.shift_mm) @ np.array([0.06, -0.03])
    change = model.pressed(model.design_twin(POSE), lower)
    first = ranked(model, bulging, noisy(model, change), tip)[0]
    assert first.name == "machine leans"
    assert float(first.finding.rstrip("°")) == pytest.approx(
        np.rad2deg(np.hypot(0.06, 0.03)), rel=0.1
    )


def test_another_mechanics_comes_first_with_its_share(model, bulging):
    tip = pressed_places(7)
    given = POSE.locate_tips(tip)
    motion = 0.3 * model.motion(*given) + 0.7 * bulging.motion(*given)
    change = model.change(model.design_twin(POSE), motion)
    first = ranked(model, bulging, noisy(model, change), tip)[0]
    assert first.name == "bulging"
    assert float(first.finding) == pytest.approx(0.7, abs=0.1)


def test_weak_magnets_come_first_with_their_strength(model, bulging):
    tip = pressed_places(7)
    weak = model.pressed(replace(model.design_twin(POSE), strength=0.7), tip)
    first = ranked(model, bulging, noisy(model, weak), tip)[0]
    assert first.name == "magnets"
    assert first.low > 0.002
    assert first.explained > 0.99
    assert float(first.finding.split("×")[1]) == pytest.approx(0.7, abs=0.08)
