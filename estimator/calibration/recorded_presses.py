"""Recorded presses as mean signals under mean forces, and the model's signals of them.

A press is the mean over its loaded frames, those in which every contact holds at least half of its
largest force of that press. The model superposes small-strain motions: contacts of both jaws and
all tips add, which leaves out how one dimple changes the other's contact area.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.body.surface_chart import FACE_AXES
from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.combine import jumps_between
from estimator.recordings.reading import Recording
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.press_states import motions_as_signals, rest_motion
from fem.presses.results import MagnetMotions, PressForces

LOADED_SHARE = 0.5
LEAST_FRAMES = 5
MODULUS_RATIOS = np.geomspace(0.2, 3.0, 13)
"""Moduli over the specification's at which motions are tabulated."""

Contact = tuple[int, float, float]
"""Face, x and y (mm in the face's frame)."""


@dataclass(frozen=True)
class RecordedPresses:
    """All usable presses of some recordings.

    Attributes
    ----------
    signal_counts : (press, channel) mean change against rest; NaN where a channel is dead
    face_force_n : (press, 6) mean force on the face of each number, N
    case : (press,) which of `cases` each is: the contacts (face, x, y) that are pressed together
    recording : (press,) number of the file
    frames : (press,) frames in the mean
    noise_counts : (axis,) white noise of one frame
    """

    signal_counts: Float[np.ndarray, "press channel"]
    face_force_n: Float[np.ndarray, "press side"]
    case: Int[np.ndarray, "press"]
    recording: Int[np.ndarray, "press"]
    frames: Int[np.ndarray, "press"]
    cases: tuple[tuple[Contact, ...], ...]
    noise_counts: Float[np.ndarray, "3"]

    def __len__(self) -> int:
        return len(self.case)

    def face_of_case(self, face: int) -> Bool[np.ndarray, "case"]:
        """Return which cases press a face."""
        return np.array([any(contact[0] == face for contact in case) for case in self.cases])


def require_presses_of(spec: ObjectSpec, presses: RecordedPresses) -> None:
    """Raise InputError where recordings have other channels, or press other faces, than the object has."""
    recorded, faces = presses.signal_counts.shape[1], spec.body.sensed
    channels = 3 * spec.sensors.count_per_face * len(faces)
    if recorded != channels:
        raise InputError(
            f"the recordings hold {recorded} channels; {spec.name} has {channels}: "
            f"{spec.sensors.count_per_face} sensors on each of {len(faces)} faces. Give the specification "
            "of the recorded object"
        )
    beyond = set(pressed_faces(presses)) - set(faces)
    if beyond:
        raise InputError(
            f"the recordings press face {min(beyond)}; {spec.name} senses {list(faces)}. Give the "
            "specification of the recorded object (body.sensed_faces)"
        )


def with_all_sensors(spec: ObjectSpec, recordings: Sequence[Recording]) -> list[Recording]:
    """Generic recordings with room for all faces and sensors of the object: columns that they lack were
    not recorded. Other formats have a fixed number of sensors, and stay as they are."""
    return [
        _with_room(recording, max(spec.body.sensed), spec.sensors.count_per_face)
        if recording.report.kind == "generic"
        else recording
        for recording in recordings
    ]


def _with_room(recording: Recording, faces: int, sensors: int) -> Recording:
    had_faces, had_sensors = recording.rest_counts.shape[1:3]
    faces = max(faces, had_faces)
    room = ((0, 0), (0, faces - had_faces), (0, max(0, sensors - had_sensors)), (0, 0))
    signals = np.pad(recording.frames.signal_counts, room, constant_values=np.nan)
    return replace(
        recording,
        frames=replace(recording.frames, signal_counts=signals, faces=np.arange(1, faces + 1)),
        rest_counts=np.pad(recording.rest_counts, room, constant_values=np.nan),
    )


def sensors_not_recorded(
    spec: ObjectSpec, recordings: Sequence[Recording]
) -> list[tuple[int, int]]:
    """Face and number of the object's sensors of which no recording has a reading.

    Raises
    ------
    InputError
        A face is pressed of which no sensor was recorded.
    """
    read = np.any(
        [np.isfinite(recording.rest_counts).any(axis=(0, 3)) for recording in recordings], axis=0
    )
    read = read[:, : spec.sensors.count_per_face]
    faces = spec.body.sensed
    pressed = {int(face) for recording in recordings for face in recording.report.faces_pressed}
    blind = [face for face in faces if face in pressed and not read[face - 1].any()]
    if blind:
        raise InputError(
            f"face {blind[0]} is pressed, and none of its sensors was recorded: there is nothing to judge "
            "such presses by. Give recordings that have its columns, or that press other faces"
        )
    return [(face, int(n) + 1) for face in faces for n in np.flatnonzero(~read[face - 1])]


def keep_sensed_faces(spec: ObjectSpec, presses: RecordedPresses) -> RecordedPresses:
    """Channels of the object's sensed faces alone, where recordings have room for all of a cube's and
    the others never spoke; as they are where that is not so."""
    count, faces = 3 * spec.sensors.count_per_face, np.asarray(spec.body.sensed)
    recorded, absent = divmod(presses.signal_counts.shape[1], count)
    if absent or max(faces) > recorded:
        return presses
    by_face = presses.signal_counts.reshape(len(presses), recorded, count)
    others = np.setdiff1d(np.arange(recorded), faces - 1)
    if np.isfinite(by_face[:, others]).any():
        return presses
    return replace(presses, signal_counts=by_face[:, faces - 1].reshape(len(presses), -1))


def own_channels(spec: ObjectSpec, face: int) -> Int[np.ndarray, "channel"]:
    """Those of the sensed face of that number, among all channels."""
    count = 3 * spec.sensors.count_per_face
    return spec.body.sensed.index(face) * count + np.arange(count)


def pressed_faces(presses: RecordedPresses) -> list[int]:
    """Numbers of the faces that are pressed in some case."""
    return sorted({contact[0] for case in presses.cases for contact in case})


def recorded_presses(recordings: Sequence[Recording]) -> RecordedPresses:
    """Means over the loaded frames of every press of every recording.

    Channels whose rest level jumped between the recordings are left out of all.

    Raises
    ------
    InputError
        No press with enough loaded frames, or one file given twice.
    """
    digests = [recording.frames.spec_hash for recording in recordings]
    if len(set(digests)) < len(digests):
        raise InputError("the same recording is given twice. Remove the repeat")
    rows = [
        (number, *row)
        for number, recording in enumerate(recordings)
        for row in presses_in_frames(recording.frames)
    ]
    if not rows:
        raise InputError(
            f"no press holds {LEAST_FRAMES} loaded frames. Give recordings with whole presses"
        )
    cases = tuple(sorted({row[3] for row in rows}))
    number, signal, force, case, frames = zip(*rows, strict=True)
    signals = np.stack(signal)
    signals[:, jumps_between(recordings).ravel()] = np.nan
    return RecordedPresses(
        signals,
        np.stack(force),
        np.array([cases.index(contacts) for contacts in case]),
        np.array(number),
        np.array(frames),
        cases,
        np.median([recording.frames.noise_counts for recording in recordings], axis=0),
    )


def presses_in_frames(
    frames: FrameSet,
) -> list[tuple[np.ndarray, np.ndarray, tuple[Contact, ...], int]]:
    touching = np.any(frames.contact_face != NO_FACE, axis=1) & frames.valid
    presses = []
    for press in np.unique(frames.press_id):
        rows = np.flatnonzero((frames.press_id == press) & touching)
        if not len(rows):
            continue
        newton = np.nan_to_num(frames.force_n[rows, :, 2])
        held = newton >= LOADED_SHARE * newton.max(axis=0)
        loaded = rows[held.all(axis=1)]
        if len(loaded) < LEAST_FRAMES:
            continue
        part = frames.select(loaded)
        signal = part.signal_counts.mean(axis=0).reshape(-1)
        presses.append((signal, _face_force(part), _contacts(part), len(loaded)))
    return presses


def _face_force(part: FrameSet) -> Float[np.ndarray, "6"]:
    newton = np.nan_to_num(part.force_n[:, :, 2])
    per_face = [(newton * (part.contact_face == face)).sum(axis=1).mean() for face in FACE_AXES]
    return np.array(per_face)


def _contacts(part: FrameSet) -> tuple[Contact, ...]:
    face, xy = part.contact_face[0], part.contact_xy_mm[0]
    used = [slot for slot in range(len(face)) if face[slot] != NO_FACE]
    return tuple(sorted((int(face[s]), float(xy[s, 0]), float(xy[s, 1])) for s in used))


@dataclass(frozen=True)
class PredictedMotions:
    """Motions of the shell's bodies in every recorded press, were it any of the cases.

    `motion` (press, case, ratio, body, 6) at `MODULUS_RATIOS`; NaN where the case does not press
    the same faces. `beyond` (press, case, ratio) marks forces above the deepest simulated press:
    motions are extended in proportion to force there.
    """

    motion: Float[np.ndarray, "press case ratio body 6"]
    beyond: Bool[np.ndarray, "press case ratio"]

    def motion_of_cases(
        self, case: Int[np.ndarray, "press"], ratio: float
    ) -> Float[np.ndarray, "press body 6"]:
        """Motions of all presses, each as the given case, linear in the logarithm of the modulus."""
        place = np.interp(np.log(ratio), np.log(MODULUS_RATIOS), np.arange(len(MODULUS_RATIOS)))
        low = min(int(place), len(MODULUS_RATIOS) - 2)
        share = place - low
        rows = self.motion[np.arange(len(case)), case]
        return (1 - share) * rows[:, low] + share * rows[:, low + 1]


def predicted_motions(
    forces: PressForces, motions: MagnetMotions, presses: RecordedPresses
) -> PredictedMotions:
    """Superpose the lattice's presses; a face's tips share its force equally.

    Raises
    ------
    InputError
        A recorded place outside the simulated lattice.
    """
    moving, rest = motions_as_signals(forces, motions), rest_motion(motions)
    shape = (len(presses), len(presses.cases), len(MODULUS_RATIOS))
    total = np.zeros((*shape, *rest.shape))
    beyond = np.zeros(shape, bool)
    for number, case in enumerate(presses.cases):
        faces = [contact[0] for contact in case]
        for face, x, y in case:
            traces = press_traces(moving, np.array([face]), np.array([x]), np.array([y]))
            share = presses.face_force_n[:, face - 1] / faces.count(face)
            newton = (share[:, None] / MODULUS_RATIOS).reshape(1, -1)
            reached = counts_at_force(traces, newton, "clamp")
            extended = newton / np.where(newton > 0, reached.force_n, 1.0)
            part = (reached.counts * np.where(newton > 0, extended, 0.0)[..., None])[0]
            total[:, number] += part.reshape(len(presses), len(MODULUS_RATIOS), *rest.shape)
            beyond[:, number] |= reached.clamped.reshape(shape[0], -1)
        pressed = np.zeros(presses.face_force_n.shape[1], bool)
        pressed[np.array(faces) - 1] = True
        presses_elsewhere = np.any((presses.face_force_n > 0) != pressed, axis=1)
        total[presses_elsewhere, number] = np.nan
    return PredictedMotions(rest + total, beyond)
