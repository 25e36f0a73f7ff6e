"""Agreement and rivals on a field made up: every number worked out another way."""

from dataclasses import astuple

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel import agreement
from estimator.calibration.known_travel.agreement import figures, travel_agreement
from estimator.calibration.known_travel.fit import Fitted
from estimator.calibration.known_travel.model import TravelModel
from tests.support.recordings.made_travel import RESTING_MT, TWIN, Made, recording

XY = np.random.default_rng(1).uniform(-5, 5, (12, 2))
TRAVEL = np.array([-0.5, 0.25, 0.5, 1.0, 1.25, 1.5, 1.75, 0.0, 2.0, 2.5, 2.75, 3.25])


def test_agreement_is_told_by_travel_beyond_a_depth_and_beside_exchanged_places_and_chips():
    """Travels of exactly 0, 1 and 2 mm begin the next millimetre; one press alone is not told."""
    model, place = Made(), np.arange(12)
    judged = recording(XY, TRAVEL, place, 0.5)
    registered = recording(XY[::-1], TRAVEL + 1, place, 0.5)
    fitted = Fitted(TWIN, RESTING_MT, 0.0)
    found = travel_agreement.__wrapped__(model, fitted, registered, judged, 4, beyond_mm=2.0)
    recorded = judged.field_mt - RESTING_MT
    predicted = model.change(TWIN, model.motion(XY, TRAVEL))

    def same(one, rows):
        assert_allclose(astuple(one), astuple(figures(predicted[rows], recorded[rows])))

    same(found.all, np.arange(12))
    same(found.beyond, [9, 10, 11])
    assert found.beyond_mm == 2
    assert list(found.by_travel) == ["0 to 1 mm", "1 to 2 mm", "2 to 3 mm"]
    same(found.by_travel["0 to 1 mm"], [1, 2, 7])
    same(found.by_travel["1 to 2 mm"], [3, 4, 5, 6])
    same(found.by_travel["2 to 3 mm"], [8, 9, 10])
    exchanged = [xy for xy, _ in model.asked[1:5]]
    for xy, one in zip(exchanged, found.places_exchanged, strict=True):
        assert_allclose(np.sort(xy, axis=0), np.sort(XY, axis=0))
        assert abs(xy - XY).max() > 1
        moved = model.change(TWIN, model.motion(xy, TRAVEL))
        assert_allclose(astuple(one), astuple(figures(moved, recorded)))
    orders = [(0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]
    for order, one in zip(orders, found.chips_permuted, strict=True):
        assert_allclose(astuple(one), astuple(figures(predicted[:, order], recorded)))


def test_rivals_are_fitted_to_the_registered_presses_alone():
    """One sinks all magnets by a share of the travel in twentieths, the other knows slopes."""
    model, place = Made(), np.arange(12)
    judged = recording(XY, TRAVEL, place, 0.5)
    registered = recording(XY[::-1] / 4, TRAVEL + 1, place, 0.5)
    found = agreement.rival_figures.__wrapped__(
        model, Fitted(TWIN, RESTING_MT, 0.0), registered, judged
    )
    assert list(found) == ["all magnets sink alike", "mean of the registered presses"]
    recorded, known = judged.field_mt - RESTING_MT, registered.field_mt - RESTING_MT
    shown = TRAVEL + 1

    def sunk(by_mm):
        return np.stack(
            [0 * by_mm] * 4 + [by_mm, 0 * by_mm, 0 * by_mm, by_mm**2, 0.5 * by_mm], axis=1
        )

    left = {k: np.sum((known.reshape(-1, 9) - sunk(k / 20 * shown)) ** 2) for k in range(1, 21)}
    best = min(left, key=left.get)
    assert 1 < best < 20
    alike = figures(sunk(best / 20 * TRAVEL).reshape(-1, 3, 3), recorded)
    assert_allclose(astuple(found["all magnets sink alike"]), astuple(alike))
    slope = np.linalg.lstsq(shown[:, None], known.reshape(-1, 9))[0]
    mean = figures((TRAVEL[:, None] * slope).reshape(-1, 3, 3), recorded)
    assert_allclose(astuple(found["mean of the registered presses"]), astuple(mean))


@pytest.mark.parametrize(
    ("xy", "covered"),
    [((-3.75, 1.0), True), ((-3.81, 1.0), False), ((6.79, 1), True), ((6.81, 1), False),
     ((0, -0.79), True), ((0, -0.81), False), ((0, 8.79), True), ((0, 8.81), False)],
)  # fmt: skip
def test_the_table_covers_places_0_2_mm_within_its_border(xy, covered):
    model = object.__new__(TravelModel)
    model.__dict__.update(x_mm=np.array([-4.0, 1, 7]), y_mm=np.array([-1.0, 2, 9]))
    assert model.covers(np.array([[1.0, 2], xy])).tolist() == [True, covered]
