"""Defaults of `history_frames`, `ensemble`, `trees` and `process`, where none are given.

A recording of few presses gets the change over nine frames, up to four networks with trees next to
them: there one network alone errs more than simple regressions do, and has too few validation
presses to calibrate its intervals. A Gaussian process answers where a frame is novel: networks and
trees read known places better, new places worse. Measured on public recordings of 17 and 25
presses. Simulated presses have no hysteresis and are as many as one wants: one network reads single
frames.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from design.spec.object import TrainingSpec
from estimator.frames.dataset import FrameSet

BATCH_FRAMES, LEARNING_RATE, PATIENCE_EPOCHS = 512, 3e-3, 15
"""Settings of training; within a factor of two they hardly matter to what a network of simulated presses
reads."""
INTERVAL_COVER = 0.9
"""Share of frames of new presses whose intervals hold the true value."""
SMALL_PRESSES = 60
"""Fewer presses with contact on the face make a recording small."""


class Choice(NamedTuple):
    """Values of the settings of the same names."""

    history_frames: int
    ensemble: int
    trees: int
    process: bool


PLAIN = Choice(history_frames=0, ensemble=1, trees=0, process=False)
SMALL = Choice(history_frames=9, ensemble=4, trees=50, process=True)


def filled(training: TrainingSpec, choice: Choice = PLAIN) -> TrainingSpec:
    """The settings with a choice's values where they are left out."""
    given = {name: getattr(training, name) for name in Choice._fields}
    return training.model_copy(
        update={
            name: value if given[name] is None else given[name]
            for name, value in choice._asdict().items()
        }
    )


def filled_for(training: TrainingSpec, parts: tuple[FrameSet, FrameSet], face: int) -> TrainingSpec:
    """The settings for training and validation frames of a face."""
    recorded = all(part.source == "recorded" for part in parts)
    presses = sum(_touched(part, face) for part in parts)
    if not (recorded and presses < SMALL_PRESSES):
        return filled(training)
    return filled(training, SMALL._replace(ensemble=max(1, min(SMALL.ensemble, presses))))


def _touched(frames: FrameSet, face: int) -> int:
    """Presses with a contact on the face in frames that can be used."""
    mine = np.any((frames.contact_face == face) & (frames.force_n[..., 2] > 0), axis=1)
    return len(np.unique(frames.press_id[mine & frames.valid]))
