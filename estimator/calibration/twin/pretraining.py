"""Presses of many twins of a design, to train estimators before the first press of the real object.

Each twin has magnets, sensors, remanence, modulus and core off the design within `tolerances`, as a
built object has, a slipped core among them (`tolerances.core_shift_mm`, `core_yaw_deg`): what is
learnt from all of them together leans on no single one.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from design.spec.object import LARGEST_SEED, ObjectSpec
from estimator.calibration.twin.digital_twin import CalibratedTwin
from estimator.frames.collection import joined
from estimator.frames.dataset import FrameSet
from estimator.frames.press_protocol import simulate_presses
from estimator.frames.splits import Split
from estimator.signals.presses import Progress, Signals
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from fem.presses.results import MagnetMotions, PressForces

PRESSES_PER_PLACE = 3
"""Presses simulated at each place of each twin."""
FRAMES_PER_PRESS = 12
"""Frames of each press."""
REST_FRAMES_PER_PRESS = 4
"""Frames at rest with each press."""
VALIDATION_SHARE = 0.2
"""Share of the twins that validate."""
_FIRST_SEED = 50_000
"""Added to the specification's seed: pre-training twins are never the experiments' hidden twin."""


def twin_frames(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    twins: int,
    progress: Progress | None = None,
) -> FrameSet:
    """Presses of every place on each of `twins` objects, fixed by `spec.seed`; a session is a twin.

    Presses are those of `[protocol]`, fewer and shorter: 48 frames per place and twin.
    """
    parts = []
    for number, drawn in enumerate(drawn_twins(spec, twins), 1):
        if progress is not None:
            progress(f"presses of twin {number} of {twins}")
        parts.append(frames_of_twin(drawn, forces, motions))
    return joined(parts)


def drawn_twins(spec: ObjectSpec, count: int) -> list[ObjectSpec]:
    """A specification per twin: its seed draws it, its protocol has fewer and shorter presses."""
    return [_drawn(spec, number) for number in range(count)]


def frames_of_twin(
    drawn: ObjectSpec, forces: PressForces, motions: MagnetMotions, progress: Progress | None = None
) -> FrameSet:
    """Presses of every place on the object that a specification of `drawn_twins` draws: one session."""
    signals = twin_signals(drawn, drawn_assembly(drawn, drawn.seed), forces, motions, progress)
    return _one_session(drawn, signals)


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
    """Presses of every place of the face on what its labelled presses leave possible of one object;
    a session is a draw. Otherwise as `twin_frames`."""
    parts = []
    for number, drawn in enumerate(drawn_twins(twin.unknowns.spec, draws), 1):
        if progress is not None:
            progress(f"presses of twin {number} of {draws}")
        signals = twin.signals(np.random.default_rng((drawn.seed, 9)))
        parts.append(_one_session(drawn, signals))
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


def split_twins(frames: FrameSet) -> Split:
    """Whole twins: the last fifth of them (at least one) validates, none is tested."""
    twins = np.unique(frames.session_id)
    held_out = max(1, round(VALIDATION_SHARE * len(twins)))
    validation = np.isin(frames.session_id, twins[len(twins) - held_out :])
    return Split(~validation, validation, np.zeros(len(frames), dtype=bool))
