"""Cramér–Rao bounds of a flat jaw that covers a face: net force, centre of pressure, tilt.

Its pose (depth at the face's middle, depths gained towards +x and +y) makes the signals; force and centre of
pressure are functions of the pose, so that their bounds are G (JᵀΣ⁻¹J)⁻¹Gᵀ, J and G the derivatives of
signals and of (force, centre) by the pose. At no tilt and `score.force_n`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np
from jaxtyping import Float
from scipy.linalg import block_diag

from design.layout.body import face_frames
from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from estimator.information.fisher import SUFFIXES, disturbance_counts, whitened_slopes
from estimator.information.sensitivity import read_channels
from estimator.signals.live import live_in_press
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals, press_signals
from fem.contact.jaw import JawFace
from fem.presses.results import MagnetMotions, PressForces

_STEP = 0.05
"""Step of depth and lean, over the depth, of central differences: contact changes where it does at all."""


@dataclass(frozen=True)
class JawBounds:
    """Bounds of a jaw on a face, freshly zeroed and `…_drifted_…`; infinite where signals cannot tell.

    Attributes
    ----------
    face : under the jaw
    against : face under a second jaw that is unknown as well, None without one
    depth_mm : at which the jaw bears `score.force_n`
    force_bound_n : σF
    centre_bound_mm : √(σx² + σy²) of the centre of pressure
    tilt_bound_deg : √(σ² + σ²) of the tilts about x and y
    """

    face: int
    against: int | None
    depth_mm: float
    force_bound_n: float
    force_bound_drifted_n: float
    centre_bound_mm: float
    centre_bound_drifted_mm: float
    tilt_bound_deg: float
    tilt_bound_drifted_deg: float


def jaw_bounds(spec: ObjectSpec, jaws: Sequence[JawFace]) -> tuple[JawBounds, ...]:
    """Return the bounds of a jaw on each face, then of both jaws on each pair of opposed faces.

    Bounds read `score.channels`, and nuisances are integrated out. Motions of two jaws add up: on the
    paper's cube that is wrong by up to 5 % of the largest motion at known forces.
    """
    normal = {frame.number: np.asarray(frame.normal) for frame in face_frames(spec)}
    pressed = [_jaw_at_force(jaw, spec.score.force_n) for jaw in jaws]
    alone = [(jaw,) for jaw in pressed]
    # normals of opposed faces are each other's negative
    pairs = [
        pair
        for pair in combinations(pressed, 2)
        if normal[pair[0].face] @ normal[pair[1].face] < -0.99
    ]
    return tuple(bounds for group in (*alone, *pairs) for bounds in _bounds_of(spec, group))


class _JawAtForce(NamedTuple):
    """A jaw at a force, and the ends of its central differences: each pose up, then each down.

    `level` and `ends` (6) are motions of the magnets; `functions` (5, pose) the derivatives of force,
    centre and tilts by the pose.
    """

    face: int
    depth_mm: float
    level: Float[np.ndarray, "magnet 6"]
    ends: Float[np.ndarray, "end magnet 6"]
    functions: Float[np.ndarray, "5 3"]


def _jaw_at_force(jaw: JawFace, force_n: float) -> _JawAtForce:
    depth = force_n / jaw.press(np.zeros(2))[0]
    poses = depth * np.vstack([side * _STEP * np.eye(3) for side in (1, -1)])
    poses[:, 0] += depth
    level = _pressed(jaw, np.array([depth, 0.0, 0.0]))[2]
    pressed = [_pressed(jaw, pose) for pose in poses]
    felt = np.array([[force, *centre] for force, centre, _ in pressed])
    by_pose = (felt[:3] - felt[3:]).T / (2 * _STEP * depth)
    # a gained depth over half an edge is the tangent of the tilt
    by_tilt = np.degrees(np.hstack([np.zeros((2, 1)), np.diag(1 / jaw.half_mm)]))
    ends = np.stack([motion for *_, motion in pressed])
    return _JawAtForce(jaw.face, float(depth), level, ends, np.vstack([by_pose, by_tilt]))


def _bounds_of(spec: ObjectSpec, group: Sequence[_JawAtForce]) -> list[JawBounds]:
    """Bounds of jaws that press at once, each at `score.force_n`."""
    motions = [sum(jaw.level for jaw in group) - jaw.level + jaw.ends for jaw in group]
    depths = [jaw.depth_mm for jaw in group]
    signals = signals_of_motions(spec, np.concatenate(motions))
    change = signals.delta_counts[0, 0].reshape(len(group), 2, 3, -1)
    # columns: central differences by depth and the two gained depths of each jaw in turn
    slopes = (change[:, 0] - change[:, 1]) / (2 * _STEP * np.array(depths)[:, None, None])
    slopes = slopes.reshape(1, 3 * len(group), -1).transpose(0, 2, 1)
    middle = change[0].mean((0, 1))[None]
    slopes = slopes * live_in_press(spec, signals.baseline_counts, middle)[..., None]
    used = np.unique(np.concatenate([read_channels(spec, signals, jaw.face) for jaw in group]))
    functions = np.asarray(block_diag(*(jaw.functions for jaw in group)))
    nuisances, columns = nuisance_columns(spec), {}
    for state, suffix in SUFFIXES.items():
        sigma = disturbance_counts(spec.sensors, state, change.shape[-1])[used]
        white = whitened_slopes(slopes[:, used], sigma, nuisances[used])[0]
        force, x, y, *tilts = _deviations(white, functions).reshape(-1, 5).T
        columns[f"force_bound{suffix}_n"] = force
        columns[f"centre_bound{suffix}_mm"] = np.hypot(x, y)
        columns[f"tilt_bound{suffix}_deg"] = np.hypot(*tilts)
    faces = [jaw.face for jaw in group]
    return [
        JawBounds(
            face,
            faces[1 - number] if len(faces) == 2 else None,
            depths[number],
            **{name: float(column[number]) for name, column in columns.items()},
        )
        for number, face in enumerate(faces)
    ]


def _pressed(
    jaw: JawFace, pose_mm: Float[np.ndarray, "3"]
) -> tuple[float, Float[np.ndarray, "2"], Float[np.ndarray, "magnet 6"]]:
    """Force, centre of pressure and motions at a pose: depth at the middle, depths gained."""
    force, centre, motion = jaw.press(pose_mm[1:] / pose_mm[0])
    return force * pose_mm[0], centre, motion * pose_mm[0]


def signals_of_motions(spec: ObjectSpec, motion: Float[np.ndarray, "load magnet 6"]) -> Signals:
    """Return the signals of some loads that are known by the magnets' motions, as steps of one place, the
    same for every face."""
    loads, place = np.arange(1.0, len(motion) + 1), PlaceGrid(np.zeros(1), np.zeros(1))
    faces = np.array(spec.body.sensed)
    none = np.zeros((len(faces), 1, len(motion)))
    on_all_faces = np.tile(motion, (len(faces), 1, 1, 1, 1))
    forces = PressForces(faces, place, loads, none, none)
    return press_signals(spec, forces, MagnetMotions(faces, place, loads, on_all_faces))


def _deviations(
    white: Float[np.ndarray, "channel unknown"], derivative: Float[np.ndarray, "k unknown"]
) -> Float[np.ndarray, "k"]:
    """Standard deviations of functions of the pose; infinite where signals do not show it."""
    size = np.linalg.norm(white, axis=0)
    if not size.all() or np.linalg.matrix_rank(white / size, tol=1e-7) < len(size):
        return np.full(len(derivative), np.inf)
    spread = derivative @ np.linalg.pinv(white)
    return np.linalg.norm(spread, axis=1)
