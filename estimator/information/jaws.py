"""Cramér–Rao bounds of a flat jaw over a face or its middle: net force, centre of pressure, tilt, size.

Its pose (depth at the middle, depths gained towards +x and +y, and edges that lie on the face) makes the
signals; what is read are functions of the pose, so that their bounds are G (JᵀΣ⁻¹J)⁻¹Gᵀ, J and G the
derivatives of signals and of (force, centre, tilts, size) by the pose. At no tilt and `score.force_n`.
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

_STEP = 0.025
"""Step of central differences, over the depth for depth and lean, over the face's half edge for an edge: a
quarter of a cell of its compliance, so that what bears hardly changes."""
_MIDDLE = 0.5
"""Edges of a small jaw over those of the face: its four edges lie on the face and are unknown."""
_FUNCTIONS = 7
"""Functions of a pose: force, centre along x and y, tilt about x and y, size along x and y."""


@dataclass(frozen=True)
class JawBounds:
    """Bounds of a jaw on a face, freshly zeroed and `…_drifted_…`; infinite where signals cannot tell.

    Attributes
    ----------
    face : under the jaw
    against : face under a second jaw that is unknown as well, None without one
    covered : edges of the jaw over those of the face; below 1 all four of its edges are unknown
    depth_mm : at which the jaw bears `score.force_n`
    force_bound_n : σF
    centre_bound_mm : √(σx² + σy²) of the centre of pressure
    tilt_bound_deg : √(σ² + σ²) of the tilts about x and y
    size_bound_mm : √(σ² + σ²) of the edges' lengths along x and y; NaN where the jaw covers the face
    """

    face: int
    against: int | None
    covered: float
    depth_mm: float
    force_bound_n: float
    force_bound_drifted_n: float
    centre_bound_mm: float
    centre_bound_drifted_mm: float
    tilt_bound_deg: float
    tilt_bound_drifted_deg: float
    size_bound_mm: float
    size_bound_drifted_mm: float


def jaw_bounds(spec: ObjectSpec, jaws: Sequence[JawFace]) -> tuple[JawBounds, ...]:
    """Return the bounds of a jaw over each face, of one over the middle of each, half as long and wide, then
    of both jaws over each pair of opposed faces.

    Bounds read `score.channels`, and nuisances are integrated out. Motions of two jaws add up: on the
    paper's cube that is wrong by up to 5 % of the largest motion at known forces.
    """
    normal = {frame.number: np.asarray(frame.normal) for frame in face_frames(spec)}
    pressed = [_jaw_at_force(jaw, spec.score.force_n) for jaw in jaws]
    alone = [(jaw,) for jaw in pressed]
    alone += [(_jaw_at_force(jaw, spec.score.force_n, _MIDDLE),) for jaw in jaws]
    # normals of opposed faces are each other's negative
    pairs = [
        pair
        for pair in combinations(pressed, 2)
        if normal[pair[0].face] @ normal[pair[1].face] < -0.99
    ]
    return tuple(bounds for group in (*alone, *pairs) for bounds in _bounds_of(spec, group))


class _JawAtForce(NamedTuple):
    """A jaw at a force, and the ends of its central differences: each unknown up, then each down.

    `level` and `ends` (6) are motions of the magnets, `steps` those of the unknowns; `functions` (7, unknown)
    are the derivatives of force, centre, tilts and size.
    """

    face: int
    covered: float
    depth_mm: float
    level: Float[np.ndarray, "magnet 6"]
    ends: Float[np.ndarray, "end magnet 6"]
    steps: Float[np.ndarray, "unknown"]
    functions: Float[np.ndarray, "7 unknown"]


def _jaw_at_force(jaw: JawFace, force_n: float, covered: float = 1.0) -> _JawAtForce:
    edges = covered * jaw.whole_mm
    depth = force_n / jaw.press(np.zeros(2), edges)[0]
    pose = np.concatenate([[depth, 0.0, 0.0], edges.ravel()])
    steps = _STEP * np.concatenate([[depth] * 3, np.repeat(jaw.half_mm, 2)])
    # edges of a jaw that covers the face lie beyond it: not unknown
    unknown = slice(None if covered < 1 else 3)
    poses = np.concatenate([pose + side * np.diag(steps)[unknown] for side in (1, -1)])
    level = _pressed(jaw, pose)[2]
    pressed = [_pressed(jaw, ends) for ends in poses]
    felt = np.array([[force, *centre] for force, centre, _ in pressed])
    steps = steps[unknown]
    by_pose = np.subtract(*np.split(felt, 2)).T / (2 * steps)
    # a gained depth over half an edge is the tangent of the tilt; the size is high less low edge
    by_tilt = np.hstack([np.zeros((2, 1)), np.degrees(np.diag(1 / (covered * jaw.half_mm)))])
    geometry = np.asarray(block_diag(by_tilt, np.kron(np.eye(2), [-1.0, 1.0])))[:, unknown]
    ends = np.stack([motion for *_, motion in pressed])
    functions = np.concatenate([by_pose, geometry])
    return _JawAtForce(jaw.face, covered, float(depth), level, ends, steps, functions)


def _bounds_of(spec: ObjectSpec, group: Sequence[_JawAtForce]) -> list[JawBounds]:
    """Bounds of jaws that press at once, each at `score.force_n`."""
    motions = [sum(jaw.level for jaw in group) - jaw.level + jaw.ends for jaw in group]
    steps = np.stack([jaw.steps for jaw in group])
    signals = signals_of_motions(spec, np.concatenate(motions))
    change = signals.delta_counts[0, 0].reshape(len(group), 2, steps.shape[1], -1)
    # columns: central differences by each unknown of each jaw in turn
    slopes = (change[:, 0] - change[:, 1]) / (2 * steps[..., None])
    slopes = slopes.reshape(1, steps.size, -1).transpose(0, 2, 1)
    middle = change[0].mean((0, 1))[None]
    slopes = slopes * live_in_press(spec, signals.baseline_counts, middle)[..., None]
    used = np.unique(np.concatenate([read_channels(spec, signals, jaw.face) for jaw in group]))
    functions = np.asarray(block_diag(*(jaw.functions for jaw in group)))
    nuisances, columns = nuisance_columns(spec), {}
    for state, suffix in SUFFIXES.items():
        sigma = disturbance_counts(spec.sensors, state, change.shape[-1])[used]
        white = whitened_slopes(slopes[:, used], sigma, nuisances[used])[0]
        force, x, y, *turns, length, width = _deviations(white, functions).reshape(-1, _FUNCTIONS).T
        columns[f"force_bound{suffix}_n"] = force
        columns[f"centre_bound{suffix}_mm"] = np.hypot(x, y)
        columns[f"tilt_bound{suffix}_deg"] = np.hypot(*turns)
        # edges of a jaw over a whole face lie beyond its border: they press nothing
        size = np.where(group[0].covered < 1, np.hypot(length, width), np.nan)
        columns[f"size_bound{suffix}_mm"] = size
    faces = [jaw.face for jaw in group]
    return [
        JawBounds(
            face,
            faces[1 - number] if len(faces) == 2 else None,
            group[number].covered,
            group[number].depth_mm,
            **{name: float(column[number]) for name, column in columns.items()},
        )
        for number, face in enumerate(faces)
    ]


def _pressed(
    jaw: JawFace, pose: Float[np.ndarray, "7"]
) -> tuple[float, Float[np.ndarray, "2"], Float[np.ndarray, "magnet 6"]]:
    """Force, centre of pressure and motions at a pose: depth at the middle, depths gained, edges (mm)."""
    force, centre, motion = jaw.press(pose[1:3] / pose[0], pose[3:].reshape(2, 2))
    return force * pose[0], centre, motion * pose[0]


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
