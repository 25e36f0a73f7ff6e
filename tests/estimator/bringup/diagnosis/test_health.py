"""Rates, losses, noise and poles from recordings made by hand."""

import numpy as np
import pytest

from estimator.bringup.asking.asked import Recording
from estimator.bringup.diagnosis.findings import ChipFound
from estimator.bringup.diagnosis.health import health_findings, health_of
from estimator.bringup.diagnosis.levenberg_marquardt import many_most_probable
from estimator.bringup.diagnosis.poles import find_magnet, magnet_findings, pocket_fields
from tests.support.new_objects import SMALL

CHIPS = tuple(ChipFound(site, np.eye(3)) for site in range(10))


def still(**changed):
    rng = np.random.default_rng(0)
    counts = np.round(rng.normal(100, [22, 22, 11], (105, 10, 3)))
    own = {"counts": counts, "sequence": np.arange(105), "board_ms": 95 * np.arange(105)}
    return Recording("still", **(own | changed))


def kinds(recording):
    return {(f.kind, f.where) for f in health_findings(SMALL, recording)}


def test_a_sound_board_has_no_finding_and_its_figures_are_right():
    health = health_of(still())
    assert health.rate_hz == pytest.approx(1000 / 95)
    assert health.lost_share == 0
    assert np.allclose(health.noise_counts, [22, 22, 11], rtol=0.3)
    assert kinds(still()) == set()


def test_drift_is_not_noise():
    drifting = still()
    ramp = np.linspace(0, 300, 105)[:, None, None]
    assert kinds(still(counts=drifting.counts + ramp)) == set()


def test_what_is_wrong_with_a_line_or_a_chip_is_named():
    counts = still().counts
    counts[:, 1] = np.nan
    counts[:, 2, 0] = np.nan
    counts[:, 4, 2] = 7
    counts[:, 6, 1] = 100 + 3 * (counts[:, 6, 1] - 100)
    assert kinds(still(counts=counts)) == {
        ("silent chip", "F1-S2"),
        ("dead axis", "F2-X1"),
        ("dead axis", "F3-Z1"),
        ("noisy channel", "F4-Y1"),
    }
    assert kinds(still(board_ms=190 * np.arange(105))) == {("slow frames", "board")}
    lossy = np.arange(105) + np.arange(105) // 20
    assert kinds(still(sequence=lossy, board_ms=95 * lossy)) == {("lost frames", "board")}
    assert kinds(still(sequence=(np.arange(105) + 65500) % 65536)) == set()
    assert kinds(still(bus_errors=30)) == {("bus errors", "board")}


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda step: step[4], []),
        (lambda step: -step[4], ["flipped magnet"]),
        (lambda step: step[5], ["misplaced magnet"]),
        (lambda step: 0.4 * step[4], ["weak magnet"]),
        (lambda step: 0.05 * step[4], ["weak magnet"]),
    ],
)
def test_poles_and_pockets_are_told_from_the_step(change, expected):
    fields = pocket_fields(SMALL, CHIPS)
    turned = np.einsum("cab,b->ca", fields.uniform, [30.0, -20.0, 10.0])
    found = find_magnet(SMALL, fields, 4, change(fields.step) + turned)
    assert [finding.kind for finding in magnet_findings(SMALL, found)] == expected


def test_linear_problems_side_by_side_have_the_least_squares_answer_and_its_cost():
    rng = np.random.default_rng(1)
    slope, values = rng.standard_normal((20, 3)), rng.standard_normal(20)
    best = np.linalg.lstsq(slope, values, rcond=None)[0]
    many, cost = many_most_probable(lambda x: x @ slope.T - values, np.zeros((4, 3)))
    assert np.allclose(many, best, atol=1e-3)
    assert np.allclose(cost, 0.5 * np.sum((slope @ best - values) ** 2))
