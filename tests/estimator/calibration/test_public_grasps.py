"""The public recordings of a gripper through the inversion, where they are at hand: the object that was
pressed is not the drawing, and that is said of every frame."""

import numpy as np
import pytest

from estimator.frames.windows import all_counts
from estimator.inversion.inversion import inversion
from estimator.inversion.model.noise import design_error
from estimator.recordings.reading import read_recording
from estimator.signals.presses import press_signals
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
    """The design's, with presses that need no mesh."""
    presses = synthetic_presses(SPEC)
    signals = press_signals(SPEC, *presses)
    error = design_error(SPEC, *presses, signals)
    return inversion(SPEC, *presses, signals, error, SPEC.tolerances.modulus_relative)


def test_no_loaded_frame_is_called_explained(estimator, one_tip):
    loaded = np.flatnonzero(one_tip.valid & (np.nansum(one_tip.force_n[..., 2], axis=1) > 16))
    found, _ = estimator.read(all_counts(one_tip)[loaded[:: len(loaded) // 20]])
    assert not found.explained.any()
    assert np.nanmedian(found.position_radius_mm) > 3


def test_rest_is_not_called_a_press_for_sure(estimator, one_tip):
    resting = np.flatnonzero(one_tip.valid & (one_tip.place_id < 0))
    found, _ = estimator.read(all_counts(one_tip)[resting[:: len(resting) // 20]])
    assert np.mean((found.number == 0) | ~found.explained) > 0.7
