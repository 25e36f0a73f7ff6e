"""Cramér–Rao bounds of a flat jaw that covers a face: net force, centre of pressure, tilt.

Its pose (depth at the face's middle, depths gained towards +x and +y) makes the signals; force and centre of
pressure are functions of the pose, so that their bounds are G (JᵀΣ⁻¹J)⁻¹Gᵀ, J and G the derivatives of
signals and of (force, centre) by the pose. At no tilt and `score.force_n`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from estimator.information.fisher import SUFFIXES, disturbance_counts, whitened_slopes
from estimator.information.sensitivity import read_channels
from estimator.signals.live import live_in_press
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals, press_signals
from fem.presses.jaws import JawFace
from fem.presses.results import MagnetMotions, PressForces

_STEP = 0.05
"""Step of depth and lean, over the depth, of central differences: contact changes where it does at all."""


@dataclass(frozen=True)
class JawBounds:
    """Bounds of a jaw on each face, freshly zeroed and `…_drifted_…`; infinite where signals cannot tell.

    Attributes
    ----------
    depth_mm : at which the jaw bears `score.force_n`
    force_bound_n : σF
    centre_bound_mm : √(σx² + σy²) of the centre of pressure
    tilt_bound_deg : √(σ² + σ²) of the tilts about x and y
    """

    face: int
    depth_mm: float
    force_bound_n: float
    force_bound_drifted_n: float
    centre_bound_mm: float
    centre_bound_drifted_mm: float
    tilt_bound_deg: float
    tilt_bound_drifted_deg: float


def jaw_bounds(spec: ObjectSpec, jaws: Sequence[JawFace]) -> tuple[JawBounds, ...]:
    """Return the bounds of a jaw on each face, from `score.channels`; nuisances integrated out."""
    return tuple(_bounds_of(spec, jaw) for jaw in jaws)


def _bounds_of(spec: ObjectSpec, jaw: JawFace) -> JawBounds:
    depth = spec.score.force_n / jaw.press(np.zeros(2))[0]
    poses = depth * np.vstack([side * _STEP * np.eye(3) for side in (1, -1)])
    poses[:, 0] += depth
    pressed = [_pressed(jaw, pose) for pose in poses]
    signals = signals_of_motions(spec, np.stack([motion for *_, motion in pressed]))
    felt = np.array([[force, *centre] for force, centre, _ in pressed])
    change = signals.delta_counts[0, 0].reshape(len(poses), -1)
    # rows pose, columns: central differences by depth and the two gained depths
    slopes = ((change[:3] - change[3:]) / (2 * _STEP * depth)).T[None]
    by_pose = ((felt[:3] - felt[3:]) / (2 * _STEP * depth)).T
    slopes = slopes * live_in_press(spec, signals.baseline_counts, change[:1])[..., None]
    used, nuisances = read_channels(spec, signals, jaw.face), nuisance_columns(spec)
    # a gained depth over half an edge is the tangent of the tilt
    by_tilt = np.degrees(np.hstack([np.zeros((2, 1)), np.diag(1 / jaw.half_mm)]))
    row = {}
    for state, suffix in SUFFIXES.items():
        sigma = disturbance_counts(spec.sensors, state, change.shape[1])[used]
        white = whitened_slopes(slopes[:, used], sigma, nuisances[used])[0]
        force, x, y = _deviations(white, by_pose)
        row[f"force_bound{suffix}_n"] = float(force)
        row[f"centre_bound{suffix}_mm"] = float(np.hypot(x, y))
        row[f"tilt_bound{suffix}_deg"] = float(np.hypot(*_deviations(white, by_tilt)))
    return JawBounds(jaw.face, float(depth), **row)


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
    white: Float[np.ndarray, "channel 3"], derivative: Float[np.ndarray, "k 3"]
) -> Float[np.ndarray, "k"]:
    """Standard deviations of functions of the pose; infinite where signals do not show it."""
    size = np.linalg.norm(white, axis=0)
    if not size.all() or np.linalg.matrix_rank(white / size, tol=1e-7) < 3:
        return np.full(len(derivative), np.inf)
    spread = derivative @ np.linalg.pinv(white)
    return np.linalg.norm(spread, axis=1)
