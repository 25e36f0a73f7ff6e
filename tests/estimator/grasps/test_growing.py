"""Grasps of contacts that come frame by frame: those of the whole recording."""

import numpy as np

from estimator.grasps.growing import GrowingGrasps
from estimator.grasps.measures import measured_grasps
from tests.estimator.grasps.grasps_by_hand import CONDITIONS, joined, squeeze


def fed(track, growing):
    """Grasps with the frame in which each was measured."""
    frames = [track.select(slice(row, row + 1)) for row in range(len(track))]
    return [(row, grasp) for row, frame in enumerate(frames) for grasp in growing.feed(frame)]


def phases(grasp):
    """Number, level, regrasps, and the ends of the phases from the grasp's first frame on."""
    ends = [getattr(grasp, name) - grasp.start for name in ("hold", "release", "end")]
    return grasp.number, grasp.level_n, grasp.regrasps, *ends


def test_grasps_that_come_frame_by_frame_are_those_of_the_whole_recording():
    track = joined(squeeze(10.0), squeeze(4.0, slide_mm=3.0), squeeze(0.2), squeeze(7.0))
    whole = measured_grasps(track, CONDITIONS)
    grown = [grasp for _, grasp in fed(track, GrowingGrasps(CONDITIONS))]
    assert len(grown) == len(whole) == 3
    for grasp, expected in zip(grown, whole, strict=True):
        assert phases(grasp.grasp) == phases(expected.grasp)
        assert (grasp.start_s, grasp.end_s) == (expected.start_s, expected.end_s)
        for name, reading in expected.readings.items():
            figures = [vars(one).values() for one in (grasp.readings[name], reading)]
            np.testing.assert_array_equal(*map(list, figures), err_msg=name)


def test_a_grasp_is_measured_a_third_of_a_second_after_it_has_ended():
    track = squeeze(10.0)
    ((row, grasp),) = fed(track, GrowingGrasps(CONDITIONS))
    # frames are 0.1 s apart
    assert 0.15 < track.time_s[row] - grasp.end_s < 0.55


def test_a_grasp_whose_zero_is_taken_again_is_forgotten():
    track, growing = joined(squeeze(10.0), squeeze(4.0)), GrowingGrasps(CONDITIONS)
    assert fed(track.select(slice(0, 30)), growing) == []
    growing.forget()
    ((_, grasp),) = fed(track.select(slice(55, None)), growing)
    assert grasp.grasp.number == 1
    assert grasp.readings["peak_n"].value == 8.0
    _, expected = measured_grasps(track, CONDITIONS)
    assert (grasp.start_s, grasp.end_s) == (expected.start_s, expected.end_s)
