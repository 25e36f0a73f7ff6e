"""Rates, losses, noise and poles from recordings made by hand."""

import numpy as np
import pytest

from instobj.bench.bringup.asking.asked import Recording
from instobj.bench.bringup.diagnosis.findings import ChipFound
from instobj.bench.bringup.diagnosis.health import Health, health_findings, health_of, line_findings
from instobj.bench.bringup.diagnosis.poles import find_magnet, magnet_findings, pocket_fields
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
    found = find_magnet(fields, 4, change(fields.step) + turned)
    assert [finding.kind for finding in magnet_findings(SMALL, found)] == expected


def made(rate_hz, lost=0.0, damaged=0, errors=None):
    return Health(rate_hz, lost, damaged, errors, np.ones((10, 3)))


@pytest.mark.parametrize(
    ("sound", "wrong", "measured"),
    [
        (made(9.451), made(9.449), "9.4 per second, 10.5 asked for"),
        (made(10.5, 0.01), made(10.5, 0.011), "1.1% of frames lost, 0 damaged lines"),
        (made(10.5, damaged=2), made(10.5, damaged=3), "0.0% of frames lost, 3 damaged lines"),
        (made(10.5, errors=2), made(10.5, errors=3), "3 failed transfers in 200 frames"),
    ],
)
def test_a_line_is_judged_at_both_sides_of_its_limits(sound, wrong, measured):
    assert SMALL.sensors.frame_rate_hz == 10.5
    assert list(line_findings(SMALL, sound, 200)) == []
    (found,) = line_findings(SMALL, wrong, 200)
    assert found.measured == measured


def test_noise_is_that_of_steps_and_half_of_them_must_be_known():
    counts = np.zeros((9, 10, 3))
    counts[:, 0, 0] = [0, 2, 0, 2, 0, 2, 0, 2, 0]
    counts[[1, 3], 0, 1] = np.nan
    counts[[1, 4, 6], 0, 2] = np.nan
    recording = Recording(
        "still", counts, np.array([0, 1, 2, 3, 65535, 0, 1, 2, 3]), 100 * np.arange(9)
    )
    health = health_of(recording)
    assert health.noise_counts[0, 0] == pytest.approx(np.sqrt(4 / 2))
    assert health.noise_counts[0, 1] != health.noise_counts[0, 1]  # four of eight steps
    assert np.isnan(health.noise_counts[0, 2])
    sent = 1 + 3 + 65532 + 4
    assert health.lost_share == pytest.approx(1 - 9 / sent)
    assert health.rate_hz == pytest.approx((sent - 1) / 0.8)
    once = Recording("still", counts[:1], np.array([5]), np.array([40]))
    assert np.isnan(health_of(once).rate_hz)


def test_noise_of_twice_the_specification_is_told_with_its_figures():
    quiet = np.tile([0.0, 1.0], 60)[:100, None, None] * np.ones((1, 10, 3))
    counts = quiet * np.array([22, 22, 11]) * 2**0.5
    counts[:, 0, 0] *= 2.01
    counts[:, 1, 2] = 7.0
    recording = Recording("still", counts, np.arange(100), 95 * np.arange(100))
    found = [(one.kind, one.where, one.measured) for one in health_findings(SMALL, recording)]
    assert found == [
        ("noisy channel", "F1-X1", "44 counts rms at rest, 22 by the specification"),
        ("dead axis", "F1-Z2", "stuck at 7 counts"),
    ]
