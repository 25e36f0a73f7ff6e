"""A channel that its chip clips counts nothing: every bound is that without the channel."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.information.cross_face import cross_face_disturbance
from estimator.information.ellipses import position_covariances_mm2
from estimator.information.identifiability import jacobians_of, set_information
from estimator.information.scores import score_places
from estimator.signals.hall import full_scale_counts
from estimator.signals.live import read_change
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import designed
from estimator.tolerances.budget import outcome_of, setting_of
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

FACE, SENSOR, AXIS = 3, 1, 2
DEAD = {"sensors": [{"face": FACE, "sensor": SENSOR, "dead": ["Z"]}]}
ROW = 3 * (FACE - 1) + SENSOR - 1
GRID = {"contact_grid": {"count": (4, 4), "pitch_mm": 6.0}, "score": {"force_n": 6.0}}
SPEC, WITHOUT = coarse_spec(**GRID), coarse_spec(**GRID, as_built=DEAD)
MOST = full_scale_counts(SPEC.sensors)


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


def clipped(signals, when):
    """Signals with one channel beyond its range at rest, or by every press but not at rest."""
    rest, delta = signals.baseline_counts.copy(), signals.delta_counts.copy()
    rest[ROW, AXIS] = MOST + 50.0 if when == "at rest" else MOST - 1e-3
    if when == "in the press":
        delta[..., ROW, AXIS] = abs(delta[..., ROW, AXIS]) + 20.0
    return replace(signals, baseline_counts=rest, delta_counts=delta)


@pytest.fixture(params=["at rest", "in the press"])
def stands_still(request, signals):
    return clipped(signals, request.param)


def bounds_of(spec, signals):
    scores = score_places(spec, signals)
    return {
        "position": scores.position_bound_mm,
        "force": scores.force_bound_drifted_n,
        "ellipse": position_covariances_mm2(spec, signals, scores),
        **{
            f"k = 1, face {face.face}": set_information(face.whitened).position_bound_mm
            for face in jacobians_of(spec, signals, np.arange(16))
        },
    }


def test_every_bound_is_that_without_the_channel(signals, stands_still):
    found, wanted = bounds_of(SPEC, stands_still), bounds_of(WITHOUT, signals)
    with_it = bounds_of(SPEC, signals)
    for name, bound in wanted.items():
        assert_allclose(found[name], bound, rtol=1e-6, err_msg=name)
        assert not np.allclose(with_it[name], bound, rtol=1e-3) or name not in ("position", "own")


def test_what_is_detected_and_read_from_other_faces_is_that_without_it(signals):
    still = clipped(signals, "at rest")
    found, wanted = score_places(SPEC, still), score_places(WITHOUT, signals)
    assert_allclose(found.detectable_force_n, wanted.detectable_force_n, rtol=1e-9)
    cross, without = cross_face_disturbance(SPEC, still), cross_face_disturbance(WITHOUT, signals)
    assert_allclose(cross.false_force_n, without.false_force_n, rtol=1e-9)


def test_delta_takes_a_clipped_channel_for_its_noise_alone(signals):
    """δ has the volume of all channels: a channel that stands still adds its noise."""
    still = signals.delta_counts.copy()
    still[..., ROW, AXIS] = 0.0
    wanted = score_places(SPEC, replace(signals, delta_counts=still)).delta_raw
    found = score_places(SPEC, clipped(signals, "at rest")).delta_raw
    assert_allclose(found, wanted, rtol=1e-9)
    assert np.max(score_places(SPEC, signals).delta_raw[FACE - 1] / wanted[FACE - 1]) > 1.3


def test_chips_tell_changes_up_to_their_range():
    rest = np.array([30000.0, -32000.0, 33000.0])
    change = np.array([[2000.0, 500.0, -9000.0], [5000.0, -900.0, 10.0]])
    wanted = [[2000.0, 500.0, 0.0], [MOST - 30000, 32000 - MOST, 0.0]]
    assert_allclose(read_change(rest, change, MOST), wanted)


@pytest.mark.parametrize("channels", ["own", "all"])
def test_a_virtual_object_knows_no_more_than_its_live_channels(channels):
    score = {"score": {"force_n": 6.0, "channels": channels}}
    spec, without = (coarse_spec(**(GRID | score), as_built=one) for one in ({}, DEAD))
    presses = synthetic_presses(spec)
    design = designed(spec)
    offset_mt = design.scene.chips.offset_mt.copy()
    offset_mt[ROW, AXIS] += 2 * spec.sensors.range_mt
    chips = replace(design.scene.chips, offset_mt=offset_mt)
    found = outcome_of(
        setting_of(spec, *presses), replace(design, scene=replace(design.scene, chips=chips))
    )
    wanted = outcome_of(setting_of(without, *presses), designed(without))
    assert_allclose(found.position_mm, wanted.position_mm, rtol=1e-6)
    assert_allclose(found.force_n, wanted.force_n, rtol=1e-6)
    assert not found.delta[FACE - 1][:, 0 if channels == "own" else 3 * ROW + AXIS].any() or (
        channels == "own"
    )
