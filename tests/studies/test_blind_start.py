"""Contacts read from a blind start, against the truth, the bound, and descent from the truth."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.information.fisher import disturbance_counts
from estimator.information.identifiability import identifiability
from estimator.inversion.posterior import most_probable
from estimator.inversion.priors import Priors
from estimator.inversion.problems import BLIND, Observations
from estimator.inversion.search import Search
from studies.blind_start import blind_starts, draw_blind_starts, joined_rows, known_number
from tests.support.mechanics.inverted import expected_counts, inverted
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    contact_grid={"count": (5, 4), "pitch_mm": 6.0},
    score={"force_n": 6.0},
    limits={"use": "bench"},
    indenter={"radius_mm": 4.5},
)
COUNTS, FRAMES = (2, 3), 30


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def rows(presses):
    return blind_starts(SPEC, *presses, COUNTS, frames=FRAMES)


def pick(rows, contacts, sensors, channels):
    return next(
        row
        for row in rows
        if (row.contacts, row.sensors, row.channels) == (contacts, sensors, channels)
    )


def test_one_contact_scatters_as_its_bound_says(presses):
    (own, every) = blind_starts(SPEC, *presses, (3,), (1,), frames=200)
    for row, bound in zip((own, every), identifiability(SPEC, *presses, (3,), (1,)), strict=True):
        share = row.blind_median_mm / bound.bound_median_mm
        assert 0.67 < share < 0.83  # of a normal error along a line, and of a round one
        assert row.blind_median_low_mm < row.blind_median_mm < row.blind_median_high_mm


def test_without_noise_the_contacts_are_where_they_are(presses):
    sensors = SPEC.sensors.changed(noise_counts=(1e-3, 1e-3, 1e-3), zeroing_counts=0.0)
    quiet = SPEC.changed(sensors=sensors)
    for row in blind_starts(quiet, *presses, (3,), (2,), frames=20):
        assert row.blind_median_mm < 1e-3
        assert row.blind_share_within_limit >= 0.95


GUESSED_MM = 10.0
"""Readings this far off are guesses: two random places of the grid are 14 mm apart on average."""


def test_channels_and_sensors_help_and_contacts_hurt(rows):
    for sensors in COUNTS:
        for k in (1, 2, 3):
            own, every = pick(rows, k, sensors, "own"), pick(rows, k, sensors, "all")
            assert every.blind_share_within_limit >= own.blind_share_within_limit
        medians = [pick(rows, k, sensors, "own").blind_median_mm for k in (1, 2, 3)]
        told = np.minimum(medians, GUESSED_MM)
        assert told.tolist() == sorted(told)
    for k in (1, 2, 3):
        assert pick(rows, k, 3, "own").blind_median_mm < pick(rows, k, 2, "own").blind_median_mm


def test_where_the_bound_is_infinite_a_blind_start_still_answers_but_far_off(rows):
    blind = pick(rows, 3, 2, "own")
    assert np.isfinite(blind.blind_90_mm)
    assert blind.blind_median_mm > SPEC.limits.position_bound_mm
    assert blind.blind_share_within_limit < 0.3


def test_bounds_and_blind_starts_share_one_table_and_a_figure(presses, rows, tmp_path):
    bounds = identifiability(SPEC, *presses, COUNTS)
    table = joined_rows(bounds, rows)
    assert len(table) == len(rows) == 12
    for read, bound, blind in zip(table, bounds, rows, strict=True):
        assert (read["contacts"], read["sensors"]) == (blind.contacts, blind.sensors)
        assert read["channels"] == bound.channels
        assert read["bound_median_mm"] == bound.bound_median_mm
        assert read["blind_median_mm"] == blind.blind_median_mm
        assert read["blind_frames"] == FRAMES
    assert "worst" not in table[0]
    draw_blind_starts(SPEC, bounds, rows, tmp_path / "starts.png")
    assert (tmp_path / "starts.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("number", [2, 3])
def test_the_search_for_a_known_number_explains_frames_as_descent_from_the_truth_does(number):
    """From nine channels, where many sets of places are alike."""
    estimator = inverted()
    model = estimator.model.select_face(2)
    priors = replace(estimator.priors, number=(*number * [0.0], 1.0), faces=1)
    rng, frames = np.random.default_rng(3), 40
    grid = np.array([(x, y) for x in (-11.0, 0.0, 11.0) for y in (-11.0, 0.0, 11.0)])
    place = np.stack([rng.permutation(grid)[:number] for _ in range(frames)])
    true = np.concatenate([place, rng.uniform(4, 8, (frames, number, 1))], axis=2)
    face = np.zeros((frames, number), int)
    sigma = disturbance_counts(model.spec.sensors, "fresh", model.channels)
    counts = expected_counts(model, face, true) + sigma * rng.standard_normal((frames, 45))
    of_the_face = np.arange(45) // 9 == 2
    told = np.broadcast_to(np.where(of_the_face, sigma, BLIND), counts.shape)
    seen = Observations(counts, told, told, told)
    found = Search(model, priors).sets_of_number(seen, number)
    assert found.frame.tolist() == list(range(frames))
    assert (found.number == number).all()
    best = most_probable(model, priors, seen, np.arange(frames), face, true)
    assert np.mean(found.misfit < best.misfit + 0.1) >= 0.95


def test_presses_of_one_face_are_those_of_the_object():
    model = inverted().model
    one = model.select_face(3)
    contact = np.array([[[3.0, -4.0, 5.0], [-7.0, 6.0, 3.0]]])
    whole = expected_counts(model, np.full((1, 2), 3), contact)
    assert_allclose(expected_counts(one, np.zeros((1, 2), int), contact), whole, rtol=1e-12)
    assert one.signals.faces.tolist() == [4]


def test_a_known_number_of_tips_is_anywhere_on_the_face_and_two_radii_apart():
    model = SimpleNamespace(
        bounds=(np.array([-9.0, -7.0, 0.05]), np.array([9.0, 7.0, 11.5])), area_mm2=252.0
    )
    found = known_number.__wrapped__(SPEC, model, 2)
    assert found == Priors((0.0, 0.0, 1.0), 1, 252.0, (0.1, 11.5), 9.0)
