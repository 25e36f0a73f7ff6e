"""Plans of presses, contact cases and simulated frames, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest

from estimator.frames.collection import simulate_collection
from estimator.frames.contact_cases import grasp_cases, paper_cases, random_case
from estimator.frames.face_data import face_data, live_channels, with_history
from estimator.frames.heatmap import force_heatmaps, label_grid_mm, mm_to_pixel, pixel_to_mm
from estimator.frames.press_protocol import nominal_peaks, plan_presses, simulate_presses
from estimator.frames.splits import split_paper_random_frames, split_places, split_presses
from estimator.frames.windows import chosen_rows, window_means
from tests.support.mechanics.odd_presses import SPEC, signals
from tests.support.recorded_facts import assert_on_record, told, told_whole

PRESSED = SPEC.changed(
    protocol=SPEC.protocol.changed(
        presses_per_place=3, frames_per_press=5, rest_frames_per_press=2, peak_force_n=(3.0, 6.0)
    ),
    collection=SPEC.collection.changed(
        faces=(2, 5), frames_per_case=12, non_contact_cases=2, dual_poses=(), triple_poses=(),
    ),
)  # fmt: skip


def on_record(section, lines):
    assert_on_record("frames", section, lines, "estimator")


@pytest.fixture(scope="module")
def frames():
    return simulate_presses(PRESSED, signals(), "hash")


def test_simulated_presses_are_as_on_record(frames):
    lines = [
        *told_whole("peaks", nominal_peaks(PRESSED, signals())),
        *told_whole("plan", plan_presses(PRESSED, signals())),
        *told_whole("frames", frames),
    ]
    on_record("presses", lines)


def test_a_simulated_collection_is_as_on_record():
    on_record("collection", told_whole("frames", simulate_collection(PRESSED, signals(), "hash")))


def test_cases_of_contacts_are_as_on_record():
    rng = np.random.default_rng(8)
    posed = PRESSED.changed(
        collection=SPEC.collection.changed(
            dual_poses=((0.5, -2.0, 30.0),), triple_poses=((-1.0, -2.0, 100.0),), grasp_faces=(2, 4)
        )
    )
    cases = {
        "of the paper": paper_cases(posed, 3)[-3:],
        "grasps": grasp_cases(posed)[::3],
        "at random": [random_case(PRESSED, rng, number, 1) for number in (0, 1)],
    }
    on_record("cases", told_whole("cases", cases))


def test_what_is_learned_from_is_as_on_record(frames):
    data = face_data(frames, 4)
    late = with_history(frames.select(np.arange(40)), 3)
    means = window_means(frames.select(np.arange(60)), 3)
    lines = [
        told("heat", force_heatmaps(frames, 4).sum(axis=(0, 1))),
        told("centres", data.centre_mm),
        f"channels: {len(live_channels(data))} of {len(live_channels(data, every_face=True))}",
        *told_whole("history", late),
        *told_whole("windows", means if isinstance(means, tuple) else [means]),
        told("chosen", chosen_rows(frames, 9, 2)),
        told("pixels", mm_to_pixel(np.array([[0.4, -7.0], [13.0, 2.9]]), *label_grid_mm())),
        told("places", pixel_to_mm(np.array([[0, 3], [9, 6]]), *label_grid_mm())),
    ]
    on_record("learned from", lines)


def test_splits_are_as_on_record(frames):
    splits = {
        "presses": split_presses(frames, 5),
        "places": split_places(frames, 5),
        "frames": split_paper_random_frames(frames, 5),
    }
    on_record("splits", told_whole("splits", splits))
