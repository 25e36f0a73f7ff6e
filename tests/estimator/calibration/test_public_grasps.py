"""The public recordings of a gripper through the inversion, where they are at hand: the object that was
pressed is not the drawing, and that is said of every frame."""

import numpy as np
import pytest

from estimator.calibration.twin import unknowns
from estimator.calibration.twin.grasp_twin import calibrate_on_cases
from estimator.calibration.twin.inverted_twin import inverted_grasps
from estimator.calibration.twin.pressed_cases import pressed_cases
from estimator.frames.windows import all_counts
from estimator.recordings.reading import read_recording
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses
from tests.support.recordings.public_recordings import FOLDER, NAMES

pytestmark = pytest.mark.skipif(
    not all((FOLDER / name).exists() for name in NAMES),
    reason=f"the public recordings are not at {FOLDER}; set INSTOBJ_DATA",
)
SPEC = coarse_spec(contact_grid={"count": (10, 10), "pitch_mm": 3.0})


@pytest.fixture(scope="module")
def one_tip():
    return read_recording(FOLDER / NAMES[0]).frames


@pytest.fixture(scope="module")
def estimator():
    """Calibrated on the recording of two tips per jaw, with presses that need no mesh."""
    forces, motions = synthetic_presses(SPEC)
    seen = pressed_cases(SPEC, read_recording(FOLDER / NAMES[1]).frames, forces)
    assert (len(seen), seen.faces, (seen.face > 0).sum(axis=1).tolist()) == (3, (3, 5), [4, 4, 4])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(unknowns, "ITERATIONS", 1)
        twin = calibrate_on_cases(SPEC, forces, motions, seen)
    assert np.median(twin.left_share) > 0.5
    return inverted_grasps(SPEC, (forces, motions), twin, seen)


def test_no_loaded_frame_is_called_explained(estimator, one_tip):
    loaded = np.flatnonzero(one_tip.valid & (np.nansum(one_tip.force_n[..., 2], axis=1) > 16))
    found, _ = estimator.read(all_counts(one_tip)[loaded[:: len(loaded) // 20]])
    assert not found.explained.any()
    assert np.nanmedian(found.position_radius_mm) > 3


def test_rest_is_not_called_a_press_for_sure(estimator, one_tip):
    resting = np.flatnonzero(one_tip.valid & (one_tip.place_id < 0))
    found, _ = estimator.read(all_counts(one_tip)[resting[:: len(resting) // 20]])
    assert np.mean((found.number == 0) | ~found.explained) > 0.7
