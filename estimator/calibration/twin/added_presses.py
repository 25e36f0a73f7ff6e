"""Presses that the twin of one object adds to its labelled ones, at every place of a face."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from design.spec.object import LARGEST_SEED, ObjectSpec
from estimator.calibration.twin.digital_twin import CalibratedTwin
from estimator.frames.collection import joined
from estimator.frames.dataset import FrameSet
from estimator.frames.press_protocol import simulate_presses
from estimator.signals.presses import Progress, Signals

PRESSES_PER_PLACE = 3
"""Presses simulated at each place by each draw."""
FRAMES_PER_PRESS = 12
"""Frames of each press."""
REST_FRAMES_PER_PRESS = 4
"""Frames at rest with each press."""
_FIRST_SEED = 50_000
"""Added to the specification's seed: draws are never the hidden object of a study."""


def with_presses_of_twin(parts: tuple[FrameSet, FrameSet], simulated: FrameSet) -> FrameSet:
    """The first part, for training, with presses that `calibrated_frames` simulated.

    Press ids are unique over both parts; the second one, which stops the training and calibrates the
    intervals, stays what was labelled.
    """
    taken = max(int(part.press_id.max()) for part in parts) + 1
    return joined([parts[0], replace(simulated, press_id=simulated.press_id + taken)])


def calibrated_frames(
    twin: CalibratedTwin, draws: int, progress: Progress | None = None
) -> FrameSet:
    """Presses of every place of the face on what its labelled presses leave possible of one object.

    A session is a draw. Presses are those of `[protocol]`, fewer and shorter: 48 frames per place and draw.
    """
    parts = []
    for number in range(draws):
        if progress is not None:
            progress(f"presses of twin {number + 1} of {draws}")
        drawn = _drawn(twin.unknowns.spec, number)
        parts.append(_one_session(drawn, twin.signals(np.random.default_rng((drawn.seed, 9)))))
    return joined(parts)


def _drawn(spec: ObjectSpec, number: int) -> ObjectSpec:
    protocol = spec.protocol.changed(
        presses_per_place=PRESSES_PER_PLACE,
        frames_per_press=(REST_FRAMES_PER_PRESS, FRAMES_PER_PRESS),
    )
    return spec.changed(seed=(spec.seed + _FIRST_SEED + number) % LARGEST_SEED, protocol=protocol)


def _one_session(drawn: ObjectSpec, signals: Signals) -> FrameSet:
    frames = simulate_presses(drawn, signals, f"seed {drawn.seed}")
    frames.session_id[:] = 0
    return frames
