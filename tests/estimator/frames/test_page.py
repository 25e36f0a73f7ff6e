"""Plans of presses, contact cases and simulated frames: a page that a person can judge."""

import numpy as np

from estimator.frames.collection import simulate_collection
from estimator.frames.contact_cases import grasp_cases, paper_cases, random_case
from estimator.frames.face_data import face_data, live_channels, with_history
from estimator.frames.heatmap import force_heatmaps
from estimator.frames.press_protocol import nominal_peaks, plan_presses, simulate_presses
from estimator.frames.splits import split_paper_random_frames, split_places, split_presses
from estimator.frames.windows import chosen_rows
from tests.support.mechanics.odd_presses import SPEC, signals
from tests.support.physics_pages import assert_page, chosen

PRESSED = SPEC.changed(
    protocol=SPEC.protocol.changed(
        presses_per_place=3, frames_per_press=(2, 5), peak_force_n=(3.0, 6.0)
    ),
    collection=SPEC.collection.changed(
        faces=(2, 5), frames_per_case=12, non_contact_cases=2, poses=((), ()),
    ),
)  # fmt: skip
POSED = PRESSED.changed(
    collection=SPEC.collection.changed(
        poses=(((0.5, -2.0, 30.0),), ((-1.0, -2.0, 100.0),)), grasp_faces=(2, 4)
    )
)


def of_presses(frames):
    peaks, plan = nominal_peaks(PRESSED, signals()), plan_presses(PRESSED, signals())
    yield from chosen(peaks, "common_travel_mm", "force_n", "depth_mm")
    yield from chosen(plan, "face", "place", "x_mm", "y_mm", "peak_force_n")
    yield from chosen(frames, "signal_counts", "force_n", "time_s", "valid", "noise_counts")
    collected = simulate_collection(PRESSED, signals(), "hash")
    yield "collected frames (counts)", collected.signal_counts
    yield "collected forces (N)", collected.force_n


def of_cases():
    rng = np.random.default_rng(8)
    yield "numbers of cases: paper's, grasps", [len(paper_cases(POSED, 3)), len(grasp_cases(POSED))]
    for number in (0, 1):
        case = random_case(PRESSED, rng, number, 1)
        yield f"random case {number}, places (mm)", case.xy_mm
    triple = paper_cases(POSED, 3)[-1]
    yield "three tips on a face (mm)", triple.xy_mm
    yield "three tips a jaw (mm)", grasp_cases(POSED)[9].xy_mm


def of_learning(frames):
    data = face_data(frames, 4)
    yield "force spread over labels (N)", force_heatmaps(frames, 4)
    yield "centres (mm)", data.centre_mm
    every = live_channels(data, every_face=True)
    yield "channels of a face, of all", [len(live_channels(data)), len(every)]
    late = with_history(frames.select(np.arange(40)), 3)
    yield "with history (counts)", late.signal_counts
    yield "chosen rows", chosen_rows(frames, 9, 2)
    for name, split in (
        ("presses", split_presses(frames, 5)),
        ("places", split_places(frames, 5)),
        ("frames", split_paper_random_frames(frames, 5)),
    ):
        yield f"split by {name}: training rows", split.train


def test_the_page_of_frames():
    frames = simulate_presses(PRESSED, signals(), "hash")
    assert_page("estimator/frames", [*of_presses(frames), *of_cases(), *of_learning(frames)])
