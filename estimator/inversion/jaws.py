"""Flat jaws over whole faces, read from frames: another kind of contact, weighed against tips by evidence.

A jaw's motions of the magnets are its depth times a table over how it leans (`fem.presses.jaws`): as patterns
of low order, uniform and two tilts, with the contact that is lost. Jaws add up as motions, and the field of
the sum is exact. The most probable pose of the jaws on given faces is found by Levenberg and Marquardt's
method; its evidence by Laplace's approximation has the frame's constant in common with that of tips, so that
their difference is the log of the odds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float
from scipy.interpolate import RegularGridInterpolator
from scipy.special import chdtrc

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.problems import BLIND, Observations

if TYPE_CHECKING:  # readers on a robot have no finite elements
    from fem.linear.response import ResponseOperator
    from fem.presses.jaws import JawFace

MOST_LEAN = 2.0
"""Share in the table: the depth gained from the middle to a border, over the depth at the middle."""
_NODES = 9
"""Leans of the table along each axis."""
_STEP = 1e-4
"""Step of differences, over the width of the prior: signals bend little over it."""
_SMALL_N = 1.0
"""Force of each jaw without lean at which signals are taken for linear, for the start of a fit."""
_LEAST_N = 1e-3
"""Least force of a jaw: keeps the fit off 0, where leans say nothing."""
_ROUNDS, _ROUNDS_FROM_LAST = 30, 8
"""Steps of a fit: from scratch, and from the frame before."""
_SETTLED = 1e-3
"""Fall of the misfit by a step below which a fit has ended: evidence does not ask for more."""
_SURE = 3.0
"""Log of the odds that a jaw must have over tips: 20 to 1, as a wrong kind misleads more than none."""


@dataclass(frozen=True)
class JawTable:
    """A jaw on one face over its two leans.

    Attributes
    ----------
    face : its number
    half_mm : half edges of the face
    values : (lean, lean, column) force (N per mm), moment of the pressures (2, N) and motions of the magnets
        (magnet × 6), all per mm of depth at the middle
    """

    face: int
    half_mm: Float[np.ndarray, "2"]
    values: Float[np.ndarray, "lean lean column"]

    @cached_property
    def _spline(self) -> RegularGridInterpolator:
        return RegularGridInterpolator((_leans(), _leans()), self.values, method="cubic")

    def pattern(
        self, lean: Float[np.ndarray, "pose 2"]
    ) -> tuple[
        Float[np.ndarray, "pose"], Float[np.ndarray, "pose 2"], Float[np.ndarray, "pose magnet 6"]
    ]:
        """Return what `JawFace.press` gives at each pose, from a cubic spline over the table."""
        rows = self._spline(lean)
        return rows[:, 0], rows[:, 1:3] / rows[:, :1], rows[:, 3:].reshape(len(rows), -1, 6)


@dataclass(frozen=True)
class JawFit:
    """The most probable jaws of a frame.

    Attributes
    ----------
    faces : of the jaws
    pose : (jaw, 3) force (N) and the two leans
    log_evidence : but for the frame's constant; other groups and tips are as likely before
    covariance : (jaw, 3, 3) of the centre of pressure (mm) and the force (N)
    centre_mm, tilt_deg : (jaw, 2) centre of pressure in the face's frame; tilt about the face's x and y
    p_value : chance of a misfit as large if the jaws were true
    """

    faces: tuple[int, ...]
    pose: Float[np.ndarray, "jaw 3"]
    log_evidence: float
    covariance: Float[np.ndarray, "jaw 3 3"]
    centre_mm: Float[np.ndarray, "jaw 2"]
    tilt_deg: Float[np.ndarray, "jaw 2"]
    p_value: float

    def beats(self, log_evidence: float) -> bool:
        """Return whether jaws are far more probable than tips of that evidence."""
        return self.log_evidence > log_evidence + _SURE


def jaw_tables(spec: ObjectSpec, response: ResponseOperator) -> tuple[JawTable, ...]:
    """Press a jaw on each flat rectangular face at all leans of the table; none on curved bodies."""
    from fem.presses.jaws import coverable_faces, jaw_faces

    flat = coverable_faces(spec)
    return tuple(map(_table, jaw_faces(spec, response, flat))) if flat else ()


def _leans() -> Float[np.ndarray, "lean"]:
    return np.linspace(-MOST_LEAN, MOST_LEAN, _NODES)


def _table(jaw: JawFace) -> JawTable:
    rows = []
    for lean in product(_leans(), _leans()):
        force, centre, motion = jaw.press(np.array(lean))
        rows.append(np.concatenate([[force], force * centre, motion.ravel()]))
    return JawTable(jaw.face, jaw.half_mm, np.array(rows).reshape(_NODES, _NODES, -1))


@dataclass(frozen=True)
class Jaws:
    """Jaws that frames are read as.

    Attributes
    ----------
    model : what motions do to the signals
    tables : of the faces that a jaw can cover
    """

    model: ContactModel
    tables: tuple[JawTable, ...]

    @cached_property
    def most_n(self) -> float:
        """Return the largest force: of the press of the specification that goes deepest, without lean."""
        deepest = float(np.max(self.model.spec.press.depths_mm))
        return max(deepest * float(t.pattern(np.zeros((1, 2)))[0][0]) for t in self.tables)

    def groups(self, pressed: Sequence[int]) -> list[tuple[int, ...]]:
        """Return faces that jaws may cover where tips were read on `pressed`: each with or without the
        face opposite, which a grasp presses too."""
        covered, groups = {table.face for table in self.tables}, set()
        for face in covered & set(pressed):
            groups.add((face,))
            opposite = self._opposite.get(face)
            if opposite in covered:
                groups.add(tuple(sorted((face, opposite))))
        return sorted(groups)

    @cached_property
    def _opposite(self) -> dict[int, int]:
        normals = {frame.number: frame.normal for frame in face_frames(self.model.spec)}
        pairs = product(normals, normals)
        # −1 is the cosine between normals of opposite faces
        return {a: b for a, b in pairs if normals[a] @ normals[b] < -1 + 1e-6}

    def fit(self, observations: Observations, groups: Sequence[tuple[int, ...]]) -> JawFit | None:
        """Return the most probable jaws of one frame on some group of faces."""
        fits = [self._fitted(observations, group) for group in groups]
        return max(fits, key=lambda fit: fit.log_evidence, default=None)

    def refit(self, observations: Observations, last: JawFit) -> JawFit:
        """Return the jaws of the frame before, as they are in this one."""
        return self._fitted(observations, last.faces, last.pose.ravel())

    def _tables_of(self, group: tuple[int, ...]) -> list[JawTable]:
        return [table for face in group for table in self.tables if table.face == face]

    def _change(
        self, group: tuple[int, ...], poses: Float[np.ndarray, "pose k"]
    ) -> Float[np.ndarray, "pose channel"]:
        """Counts of jaws with force (N) and two leans each."""
        moved = np.zeros((len(poses), *self.model.rest.shape))
        for jaw, table in enumerate(self._tables_of(group)):
            force, lean = poses[:, 3 * jaw], poses[:, 3 * jaw + 1 : 3 * jaw + 3]
            per_mm, _, motion = table.pattern(lean)
            moved += (force / per_mm)[:, None, None] * motion
        return self.model.counts_of_motions(moved)

    def _fitted(
        self,
        observations: Observations,
        group: tuple[int, ...],
        start: Float[np.ndarray, "k"] | None = None,
    ) -> JawFit:
        count = len(group)
        width = np.tile([self.most_n, 2 * MOST_LEAN, 2 * MOST_LEAN], count)
        problem = _Problem(self, observations, group, width)
        if start is None:
            pose, misfit, curvature = problem.descend(problem.start(), _ROUNDS)
        else:
            pose, misfit, curvature = problem.descend(start, _ROUNDS_FROM_LAST)
        volume = np.linalg.slogdet(curvature)[1]
        # Laplace: (2π)^{k/2} e^{−misfit} / √det H over the volume of the even priors
        evidence = 0.5 * (3 * count * np.log(2 * np.pi) - volume) - misfit - np.log(width).sum()
        freedoms = max(int((observations.sigma < BLIND).sum()) - 3 * count, 1)
        p_value = float(chdtrc(freedoms, 2 * misfit))
        return self._described(group, pose, evidence, np.linalg.inv(curvature), p_value)

    def _described(
        self,
        group: tuple[int, ...],
        pose: Float[np.ndarray, "k"],
        evidence: float,
        covariance: Float[np.ndarray, "k k"],
        p_value: float,
    ) -> JawFit:
        centres, tilts, spreads = [], [], []
        for jaw, table in enumerate(self._tables_of(group)):
            part = slice(3 * jaw, 3 * jaw + 3)
            force, *lean = pose[part]
            # differences inwards, as the table ends at `MOST_LEAN`
            inward = np.where(np.array(lean) > 0, -1e-3, 1e-3)
            around = np.array(lean) + np.vstack([np.zeros(2), np.diag(inward)])
            per_mm, centre, _ = table.pattern(around)
            by_pose = np.zeros((3, 3))  # centre (x, y) by leans, and force by itself
            by_pose[:2, 1:] = (centre[1:] - centre[:1]).T / inward
            by_pose[2, 0] = 1.0
            spreads.append(by_pose @ covariance[part, part] @ by_pose.T)
            gained = np.array(lean) * force / per_mm[0] / table.half_mm
            centres.append(centre[0])
            # depth gained towards +y is a turn about −x, towards +x about +y
            tilts.append(np.degrees(np.arctan([-gained[1], gained[0]])))
        poses = pose.reshape(-1, 3)
        return JawFit(
            group, poses, float(evidence), np.array(spreads), np.array(centres), np.array(tilts),
            p_value,
        )  # fmt: skip


@dataclass(frozen=True)
class _Problem:
    """Jaws on given faces in one frame, in units of the priors' widths."""

    jaws: Jaws
    observations: Observations
    group: tuple[int, ...]
    width: Float[np.ndarray, "k"]

    @property
    def _low(self) -> Float[np.ndarray, "k"]:
        return np.tile([_LEAST_N, -MOST_LEAN, -MOST_LEAN], len(self.group))

    def _white(
        self, change: Float[np.ndarray, "pose channel"]
    ) -> Float[np.ndarray, "pose channel"]:
        return self.observations.white(change[None])[0]

    def _residual(self, pose: Float[np.ndarray, "k"]) -> Float[np.ndarray, "channel"]:
        change = self.jaws._change(self.group, pose[None]) - self.observations.counts
        return self._white(change)[0]

    def _slopes(self, pose: Float[np.ndarray, "k"]) -> Float[np.ndarray, "k channel"]:
        """Whitened change by each parameter, per unit of it."""
        step = _STEP * self.width
        inward = np.where(pose + step > self._low + self.width, -1.0, 1.0) * step
        ends = self.jaws._change(self.group, np.vstack([pose, pose + np.diag(inward)]))
        return self._white(ends[1:] - ends[:1]) / inward[:, None]

    def start(self) -> Float[np.ndarray, "k"]:
        """Return the forces without lean that fit best where signals are linear in them."""
        poses = np.zeros((len(self.group), 3 * len(self.group)))
        poses[np.arange(len(self.group)), ::3] = _LEAST_N
        np.fill_diagonal(poses[:, ::3], _SMALL_N)
        slopes = self._white(self.jaws._change(self.group, poses)) / _SMALL_N
        counts = self._white(self.observations.counts)[0]
        force, *_ = np.linalg.lstsq(slopes.T, counts, rcond=None)
        start = np.zeros(len(self.width))
        start[::3] = np.clip(force, _SMALL_N, self.jaws.most_n)
        return start

    def descend(
        self, pose: Float[np.ndarray, "k"], rounds: int
    ) -> tuple[Float[np.ndarray, "k"], float, Float[np.ndarray, "k k"]]:
        """Return the pose of least misfit near a start, its half χ², and the curvature there."""
        residual = self._residual(pose)
        misfit, damping = 0.5 * float(residual @ residual), 1e-3
        # even priors; their normal stand-in keeps the curvature regular, as with tips
        prior = np.diag(12 / self.width**2)
        slopes = self._slopes(pose)
        for _ in range(rounds):
            curvature = slopes @ slopes.T + prior
            # Marquardt's scaling: damping in the parameters' own units
            damped = curvature + damping * np.diag(np.diag(curvature))
            step = np.linalg.solve(damped, slopes @ residual)
            tried = np.clip(pose - step, self._low, self._low + self.width)
            ahead = self._residual(tried)
            reached = 0.5 * float(ahead @ ahead)
            if reached >= misfit:
                damping *= 10
                if damping > 1e6:  # no step is short enough: the bound holds the pose
                    break
                continue
            fell, pose, residual, misfit = misfit - reached, tried, ahead, reached
            damping, slopes = damping / 10, self._slopes(pose)
            if fell < _SETTLED:
                break
        return pose, misfit, slopes @ slopes.T + prior
