"""A newly soldered object that is not there: readings for every question, with planted faults.

Chips, magnets and core lie within the specification's tolerances; the hand that holds the magnet, the
way the core is laid down and Earth's field are drawn at random.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, field_of_each, magnets_model
from estimator.field.vectors import components
from estimator.signals.field_setup import scene
from estimator.signals.hall import read_out
from estimator.tolerances.assembly import Assembly, draw, undisturbed
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.asking.asked import POSES, Question, Recording, magnet_names
from instobj.bench.bringup.asking.held_magnet import OVER_MM, held_magnet
from instobj.bench.bringup.diagnosis.earth import EARTH_UT, turn_to_object
from instobj.bench.bringup.diagnosis.findings import channel_name

HAND_MM, HAND_DEG, HEIGHT_MM = 3.0, 15.0, (4.0, 15.0)
"""Errors of the simulated hand: sideways and tilt (standard deviations), height above the core where 10 mm
are asked for."""
TREMOR_MM, TREMOR_DEG, LAID_DEG = 0.3, 1.0, 5.0
"""Standard deviations of a hand: place and tilt of a held magnet, and how an object is laid."""
_DRIFT_MS = 15 * 60 * 1000
"""Time in which offsets drift by `sensors.drift_counts`: 15 minutes."""
_STUCK_COUNTS = 128.0
"""Reading at which a stuck channel stays."""
_FAULT = re.compile(r"(swap|turn|twist|mirror|flip|dead|stuck|silent|gain)=([^=]+?)(?:=([\d.]+))?")
FAULTS = (
    "swap=F1-S2,F3-S1, turn=F1-S2 (by 120° about its diagonal), twist=F1-S2 (by 120° about its Z), "
    "mirror=F1-S2, flip=F3-M2, dead=F4-Y1 (noise alone), stuck=F4-Y1, silent=F4-S1, gain=F5-S2=1.1"
)


@dataclass(frozen=True)
class PlantedFault:
    """Planted fault: kind, parts by name, and how much where that matters."""

    kind: str
    where: tuple[str, ...]
    size: float = 1.1


@dataclass
class SimulatedObject:
    """An object with its user; readings depend on what was asked before, as real ones do.

    Attributes
    ----------
    matrix, offset : counts = matrix · field (mT, object's frame) + offset, by channel
    silent, dead, stuck : (chip, axis) that send nothing, noise alone, or one value
    """

    spec: ObjectSpec
    assembly: Assembly
    matrix: Float[np.ndarray, "chip 3 3"]
    offset: Float[np.ndarray, "chip 3"]
    position_mm: Float[np.ndarray, "chip 3"]
    silent: Bool[np.ndarray, "chip 3"]
    dead: Bool[np.ndarray, "chip 3"]
    stuck: Bool[np.ndarray, "chip 3"]
    flipped: Bool[np.ndarray, "magnet"]
    earth_ut: Float[np.ndarray, "3"]
    slope_per_ms: Float[np.ndarray, "chip 3"]
    held_strength: float
    rng: np.random.Generator
    clock_ms: int = 0
    sequence: int = 0
    magnets_in: int = 0

    def recording(self, question: Question) -> Recording:
        """Return what the board sends while the user does as asked."""
        field_mt = self._field_mt(question)
        # c chip, b coordinate of the field, a channel; … frames
        counts = np.einsum("cab,...cb->...ca", self.matrix, field_mt) + self.offset
        step_ms = 1000 / self.spec.sensors.frame_rate_hz
        ms = self.clock_ms + np.round(step_ms * np.arange(question.frames)).astype(int)
        drift = self.slope_per_ms * ms[:, None, None]
        counts = np.where(self.dead, self.offset, counts) + drift
        counts = read_out(counts, self.spec.sensors, self.rng)
        counts[:, self.stuck] = _STUCK_COUNTS
        counts[:, self.silent] = np.nan
        sequence = (self.sequence + np.arange(question.frames)) % 65536
        self.clock_ms, self.sequence = int(ms[-1]) + 5000, int(sequence[-1]) + 50
        return Recording(question.name, counts, sequence, ms, 0, 0)

    def _field_mt(self, question: Question) -> Float[np.ndarray, "frame chip 3"]:
        if question.step == "magnet":
            self.magnets_in = question.part + 1
        elif question.step == "rest":
            self.magnets_in = len(self.flipped)
        pose = question.part % len(POSES) if question.step == "earth" else 0
        laid = Rotation.from_rotvec(np.deg2rad(LAID_DEG) * self.rng.standard_normal(3))
        earth_ut = turn_to_object(pose) @ laid.apply(self.earth_ut)
        field = np.zeros((question.frames, len(self.matrix), 3)) + 1e-3 * earth_ut
        if question.step == "held":
            field = field + self._held_mt(question)
        return field + self._shell_mt()

    def _held_mt(self, question: Question) -> Float[np.ndarray, "frame chip 3"]:
        held = held_magnet(self.spec, [question.part])
        rng, frames = self.rng, question.frames
        higher_mm = rng.uniform(*HEIGHT_MM) - OVER_MM
        about = np.r_[HAND_MM * rng.standard_normal(2), higher_mm]
        tilt = np.deg2rad(HAND_DEG) * rng.standard_normal(2)
        shake = np.cumsum(rng.standard_normal((frames, 5)), axis=0) / np.sqrt(frames)
        pose = np.zeros((frames, 8))
        pose[:, :3] = about + TREMOR_MM * shake[:, :3]
        pose[:, 3:5] = tilt + np.deg2rad(TREMOR_DEG) * shake[:, 3:]
        centre = np.concatenate([held.centre_mm(frame_pose[None]) for frame_pose in pose])
        axis = np.concatenate([held.axis(frame_pose[None]) for frame_pose in pose])
        return self.held_strength * _field_mt(
            self.position_mm, centre[:, None], axis[:, None], held.magnet
        )

    def _shell_mt(self) -> Float[np.ndarray, "chip 3"]:
        """Field of the magnets that are in their pockets."""
        magnets, some = self.assembly.scene.magnets, slice(0, self.magnets_in)
        axis = np.where(self.flipped[:, None], -1.0, 1.0) * magnets.axis
        model = magnets_model(self.spec.magnets, 5.0)
        fields = _field_mt(
            self.position_mm,
            magnets.centre_mm[some, None],
            axis[some, None],
            model,
            magnets.side[some, None],
            magnets.size[some],
        )
        return (magnets.strength[some, None, None] * fields).sum(axis=0)


def _field_mt(
    points_mm: Float[np.ndarray, "*points 3"],
    centres_mm: Float[np.ndarray, "*centres 3"],
    axes: Float[np.ndarray, "*axes 3"],
    model: MagnetsModel,
    sides: Float[np.ndarray, "*axes 3"] | None = None,
    size: Int[np.ndarray, "magnet"] | None = None,
) -> Float[np.ndarray, "*any 3"]:
    side = None if sides is None else components(sides)
    offset = components(points_mm - centres_mm)
    field = field_of_each(offset, components(axes), model, side, size)
    return 1e3 * np.stack(np.broadcast_arrays(*field), axis=-1)


def simulated_object(
    spec: ObjectSpec, seed: int, faults: tuple[PlantedFault, ...] = ()
) -> SimulatedObject:
    """An object within tolerance, always the same for one seed, with these faults."""
    rng = np.random.default_rng((seed, 19))
    drawn_spec = spec.changed(seed=int(rng.integers(2**31)))
    assembly = draw(drawn_spec, undisturbed(scene(drawn_spec)), rng)
    place, scale = assembly.scene, spec.sensors.counts_per_mt
    direction = rng.standard_normal(3)
    earth = rng.uniform(*EARTH_UT) * direction / np.linalg.norm(direction)
    chips = len(place.sensors.face)
    slope = spec.sensors.drift_counts / _DRIFT_MS * rng.standard_normal((chips, 3))
    made = SimulatedObject(
        spec,
        assembly,
        scale * place.chips.matrix @ place.sensors.axes,
        scale * place.chips.offset_mt,
        place.sensors.position_mm,
        np.zeros((chips, 3), bool),
        np.zeros((chips, 3), bool),
        np.zeros((chips, 3), bool),
        np.zeros(len(place.magnets.face), bool),
        earth,
        slope,
        1 + spec.tolerances.remanence_relative * float(rng.standard_normal()),
        rng,
    )
    for fault in faults:
        made = _with_fault(made, fault)
    return made


def parse_fault(text: str) -> PlantedFault:
    """`gain=F5-S2=1.1` as a fault.

    Raises
    ------
    InputError
        Anything else than the kinds of faults.
    """
    match = _FAULT.fullmatch(text)
    if match is None:
        raise InputError(f"--simulated {text!r} is not known. Give one of {FAULTS}")
    return PlantedFault(match[1], tuple(match[2].split(",")), float(match[3] or 1.1))


def _with_fault(made: SimulatedObject, fault: PlantedFault) -> SimulatedObject:
    if fault.kind == "flip":
        rows = [_number(magnet_names(made.spec), name, fault) for name in fault.where]
        flipped = made.flipped.copy()
        flipped[rows] = True
        return replace(made, flipped=flipped)
    names = sensor_names(made.assembly.scene.sensors.face)
    channels = {channel_name(n, a): (k, a) for k, n in enumerate(names) for a in range(3)}
    if fault.where[0] in channels:
        return _with_channel_fault(made, fault, channels[fault.where[0]])
    rows = [_number(names, name, fault) for name in fault.where]
    matrix, position, silent = made.matrix.copy(), made.position_mm.copy(), made.silent.copy()
    offset = made.offset.copy()
    if fault.kind == "swap" and len(rows) == 2:
        for given in (matrix, position, offset):
            given[rows] = given[rows[::-1]]
    elif fault.kind == "turn":
        matrix[rows] = np.eye(3)[[1, 2, 0]] @ matrix[rows]
    elif fault.kind == "twist":
        matrix[rows] = Rotation.from_euler("z", 120, degrees=True).as_matrix() @ matrix[rows]
    elif fault.kind == "mirror":
        matrix[rows] = np.diag([-1.0, 1.0, 1.0]) @ matrix[rows]
    elif fault.kind == "gain":
        matrix[rows] *= fault.size
    elif fault.kind == "silent":
        silent[rows] = True
    else:
        raise InputError(f"--simulated {fault.kind} does not go with {fault.where}. Give {FAULTS}")
    return replace(made, matrix=matrix, position_mm=position, offset=offset, silent=silent)


def _with_channel_fault(
    made: SimulatedObject, fault: PlantedFault, channel: tuple[int, int]
) -> SimulatedObject:
    matrix, dead, stuck = made.matrix.copy(), made.dead.copy(), made.stuck.copy()
    if fault.kind == "gain":
        matrix[channel] *= fault.size
    elif fault.kind == "dead":
        dead[channel] = True
    elif fault.kind == "stuck":
        stuck[channel] = True
    else:
        raise InputError(f"--simulated {fault.kind} does not go with {fault.where}. Give {FAULTS}")
    return replace(made, matrix=matrix, dead=dead, stuck=stuck)


def _number(names: list[str], name: str, fault: PlantedFault) -> int:
    if name not in names:
        raise InputError(
            f"--simulated {fault.kind}: no {name!r} in this object. Give one of {', '.join(names)}"
        )
    return names.index(name)
