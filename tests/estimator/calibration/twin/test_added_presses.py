"""Presses of a twin beside labelled ones."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_array_equal

from estimator.calibration.twin.added_presses import with_presses_of_twin
from tests.support.recordings.synthetic_frames import synthetic_frames


def test_presses_of_a_calibrated_twin_are_numbered_behind_those_of_both_parts():
    """The training part alone goes with them; the part that stops training stays as it was."""
    frames = synthetic_frames(presses=1)
    rows = [np.flatnonzero(frames.press_id == press)[:3] for press in (0, 1)]
    few = frames.select(np.concatenate(rows))
    stopping = replace(few, press_id=few.press_id + 7)
    for parts in ((few, stopping), (stopping, few)):
        found = with_presses_of_twin(parts, few)
        begin, added = np.split(found.press_id, [len(few)])
        assert_array_equal(begin, parts[0].press_id)
        assert_array_equal(added - added[0], few.press_id)
        assert added[0] > max(part.press_id.max() for part in parts)
