"""Flat jaws over faces or parts of them, read from frames: a kind of contact, weighed against tips.

A jaw is a rigid plane that presses a rectangle of a face (`fem.contact.jaw`): its force, two leans, and each
edge that lies on the face are unknown; an edge beyond the border is none. Jaws add up as motions, and the
field of the sum is exact. Edges are let go one by one, the nearest to a border first, and all these fits are
weighed. The most probable pose is found by Levenberg and Marquardt's method; its evidence by Laplace's
approximation has the frame's constant in common with that of tips, so that their difference is the log of
the odds. Numbers of contacts have one prior whatever their kind; a jaw is as likely on every face, and each
of its edges as likely on the face as beyond it. What is uncertain of a jaw includes which edges lie on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, product
from typing import NamedTuple

import numpy as np
from jaxtyping import Bool, Float
from scipy.special import chdtrc

from design.layout.body import face_frames
from estimator.inversion.evidence import log_mass_between
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.problems import BLIND, Observations
from fem.contact.jaw import JawFace

MOST_LEAN = 2.0
"""Depth gained from the middle to an edge, over the depth at the middle, at most."""
_POSE = 7
"""Unknowns of a jaw: force (N), two leans, low and high edge along x, then along y (mm)."""
_EDGE, _EDGES = 3, 4
"""First edge among them, and how many there are."""
_STEP = 1e-4
"""Step of differences, over the width of the prior: signals bend little over it."""
_SMALL_N = 1.0
"""Force of each jaw at which signals are taken for linear, for the start of a fit."""
_SMALL_LEAN = 0.2
"""Lean by which patterns of leans are taken."""
_LEAST_N = 1e-3
"""Least force of a jaw: keeps the fit off 0, where leans say nothing."""
_LEAST_EDGE_MM = 6.0
"""Least edge of a jaw: what is smaller is as well a tip."""
_LINES = 7
"""Lines along each side of a face between which parts of it are tried as a start."""
_RIDGE = 1e-9
"""Share of a matrix's diagonal that is added to it: patterns may be alike."""
_ROUNDS, _ROUNDS_FROM_LAST = 30, 8
"""Steps of a fit: from scratch, and from the frame before."""
_SETTLED = 5e-3
"""Fall of the misfit by a step below which a fit has ended: evidence does not ask for more. At twice that the
force of a light finger hung by half a deviation on how slopes were taken."""
_HOPELESS = 10.0
"""Log of the odds against a fit from which edges that are let go no longer help."""
_FAINT = 7.0
"""Log of the odds against a fit from which it changes no mean: one in a thousand."""
_FALLS = 1.5
"""Misfit that may still fall, over what a linear model says: signals bend. At 1 a finger over a corner was
lost; at 1.5 none of 156 frames of tips and jaws was read otherwise than with all fits run to their ends."""


@dataclass(frozen=True)
class JawFit:
    """The most probable jaws of a frame.

    Attributes
    ----------
    faces : of the jaws
    pose : (jaw, 7) force (N), the two leans, and the edges (mm): low and high along x, then along y
    free : (jaw, 7) what is unknown of it: an edge that is not lies beyond the border
    log_evidence, more : of all fits on these faces, but for the frame's constant, and what others than the
        best add to it
    values : (jaw, 5) centre of pressure in the face's frame (mm), force (N), and edges along x and y of the
        part of the face that it covers (mm)
    covariance : (jaw, 5, 5) of the values
    off, among : (jaw, 5), (jaw, 5, 5) what the mean over fits with other edges adds to values and covariance
    tilt_deg : (jaw, 2) about the face's x and y
    p_value : chance of a misfit as large if the jaws were true
    """

    faces: tuple[int, ...]
    pose: Float[np.ndarray, "jaw 7"]
    free: Bool[np.ndarray, "jaw 7"]
    log_evidence: float
    more: float
    values: Float[np.ndarray, "jaw 5"]
    covariance: Float[np.ndarray, "jaw 5 5"]
    off: Float[np.ndarray, "jaw 5"]
    among: Float[np.ndarray, "jaw 5 5"]
    tilt_deg: Float[np.ndarray, "jaw 2"]
    p_value: float


@dataclass(frozen=True)
class Jaws:
    """Jaws that frames are read as.

    Attributes
    ----------
    model : what motions do to the signals
    tables : of the faces that a jaw can press
    number : probabilities of 0, 1, 2, … contacts
    """

    model: ContactModel
    tables: tuple[JawFace, ...]
    number: tuple[float, ...]

    @cached_property
    def most_n(self) -> float:
        """Return the largest force: of the press of the specification that goes deepest, without lean."""
        deepest = float(np.max(self.model.spec.press.depths_mm))
        return max(deepest * t.press(np.zeros(2))[0] for t in self.tables)

    def groups(self, pressed: Sequence[int]) -> list[tuple[int, ...]]:
        """Return faces that jaws may press where tips were read on `pressed`: each with or without the
        face opposite, which a grasp presses too."""
        faces = set(pressed)
        # every jaw takes a slot of a contact
        return [g for g in self._all_groups if faces & set(g) and len(g) < len(self.number)]

    @cached_property
    def _all_groups(self) -> list[tuple[int, ...]]:
        covered = sorted(table.face for table in self.tables)
        pairs = {tuple(sorted((a, self._opposite[a]))) for a in covered if a in self._opposite}
        return [(face,) for face in covered] + sorted(p for p in pairs if set(p) <= set(covered))

    def log_density(self, group: tuple[int, ...]) -> float:
        """Log of how likely jaws on these faces are, each edge on the face or beyond it as given."""
        alike = sum(len(faces) == len(group) for faces in self._all_groups)
        return float(np.log(self.number[len(group)] / alike)) - _EDGES * len(group) * np.log(2)

    @cached_property
    def _opposite(self) -> dict[int, int]:
        normals = {frame.number: frame.normal for frame in face_frames(self.model.spec)}
        pairs = product(normals, normals)
        # −1 is the cosine between normals of opposite faces
        return {a: b for a, b in pairs if normals[a] @ normals[b] < -1 + 1e-6}

    def fit(
        self,
        observations: Observations,
        groups: Sequence[tuple[int, ...]],
        least: float,
        linear: bool = False,
    ) -> JawFit | None:
        """Return the most probable jaws of one frame on some group of faces: the mean of fits with all edges
        unknown, and with ever fewer, down to jaws over whole faces. None where their evidence is
        less than `least`.

        The group is the best where signals are taken for linear. With `linear` it must reach `least` there.
        """
        starts = {group: self._problem(observations, group).start() for group in groups}
        group = max(starts, key=lambda group: starts[group][1], default=())
        if not group or (linear and starts[group][1] < least):
            return None
        whole, borders = self._whole(group), self._whole_pose(group)
        pose, free, rounds = starts[group][0], np.ones_like(whole), _ROUNDS
        # as many fits as edges and one more may be summed up
        needed = enough = least - np.log(1 + _EDGES * len(group))
        peaks: list[_Peak] = []
        while True:
            peaks.append(self._problem(observations, group, free).peak(pose, rounds, needed))
            # edges that are let go explain no more than all of them
            if peaks[0].most_evidence < enough:
                return None
            best = max(peak.log_evidence for peak in peaks)
            needed = best - _HOPELESS
            if np.array_equal(free, whole) or peaks[-1].log_evidence < best - _HOPELESS:
                break
            pose, free, rounds = peaks[-1].pose.copy(), free.copy(), _ROUNDS_FROM_LAST
            inside = np.where(free & ~whole, abs(pose - borders), np.inf)
            nearest = int(inside.argmin())
            free[nearest], pose[nearest] = False, borders[nearest]
        total = float(np.logaddexp.reduce([peak.log_evidence for peak in peaks]))
        if total < least:
            return None
        likely_peaks = [peak for peak in peaks if peak.log_evidence > best - _FAINT]
        fits = [self._problem(observations, group, peak.free).fit(peak) for peak in likely_peaks]
        return replace(_mean(fits), log_evidence=total, more=total - best)

    def refit(self, observations: Observations, last: JawFit) -> JawFit:
        """Return the jaws of the frame before, as they are in this one."""
        problem = self._problem(observations, last.faces, last.free.ravel())
        fit = problem.fit(problem.peak(last.pose.ravel(), _ROUNDS_FROM_LAST))
        fit = replace(fit, log_evidence=fit.log_evidence + last.more, more=last.more)
        return _with_others(fit, fit.covariance, last.off, last.among)

    def _problem(
        self,
        observations: Observations,
        group: tuple[int, ...],
        free: Bool[np.ndarray, "k"] | None = None,
    ) -> _Problem:
        unknowns = np.ones(_POSE * len(group), bool) if free is None else free
        return _Problem(self, observations, group, unknowns)

    @staticmethod
    def _whole(group: tuple[int, ...]) -> Bool[np.ndarray, "k"]:
        """Unknowns of jaws over whole faces."""
        return np.tile(np.arange(_POSE) < _EDGE, len(group))

    def tables_of(self, group: tuple[int, ...]) -> list[JawFace]:
        """Return the faces of a group."""
        return [table for face in group for table in self.tables if table.face == face]

    def _whole_pose(self, group: tuple[int, ...]) -> Float[np.ndarray, "k"]:
        """Jaws over whole faces, without force or lean."""
        ends = [np.r_[np.zeros(_EDGE), table.whole_mm.ravel()] for table in self.tables_of(group)]
        return np.concatenate(ends)

    def change(
        self, group: tuple[int, ...], pose: Float[np.ndarray, "k"]
    ) -> Float[np.ndarray, "channel"]:
        """Return counts of jaws by their pose."""
        moved = np.zeros(self.model.rest.shape)
        for jaw, table in enumerate(self.tables_of(group)):
            force, *shape = pose[_POSE * jaw : _POSE * (jaw + 1)]
            moved += force * _motion_of_newton(table, np.array(shape))
        return self.model.counts_of_motions(moved[None])[0]

    def slopes(
        self,
        group: tuple[int, ...],
        pose: Float[np.ndarray, "k"],
        free: Bool[np.ndarray, "k"],
        step: Float[np.ndarray, "k"],
    ) -> Float[np.ndarray, "free channel"]:
        """Return counts by each free unknown, per unit of it: differences over steps of motions that are
        linear in it."""
        moved, by_pose = np.zeros(self.model.rest.shape), []
        for jaw, table in enumerate(self.tables_of(group)):
            force, *shape = pose[_POSE * jaw : _POSE * (jaw + 1)]
            lean, edges = np.array(shape[:2]), np.reshape(shape[2:], (2, 2))
            per_newton, slopes = table.motion_with_slopes(lean, edges)
            moved += force * per_newton
            by_pose += [per_newton, *(force * slopes)]
        ends = moved + step[free, None, None] * np.array(by_pose)[free]
        counts = self.model.counts_of_motions(np.concatenate([moved[None], ends]))
        return (counts[1:] - counts[:1]) / step[free, None]

    @cached_property
    def _parts(self) -> dict[int, tuple[np.ndarray, np.ndarray]]:
        return {}

    def parts(
        self, face: int
    ) -> tuple[Float[np.ndarray, "part 4"], Float[np.ndarray, "part 3 channel"]]:
        """Return edges of parts of a face, and counts per newton on each of a level jaw and of its leans."""
        if face not in self._parts:
            (table,) = self.tables_of((face,))
            sides = [
                list(combinations(np.linspace(-half, half, _LINES), 2)) for half in table.half_mm
            ]
            edges = np.array([[*x, *y] for x, y in product(*sides)])
            leans = np.array([[0.0, 0.0], [_SMALL_LEAN, 0.0], [0.0, _SMALL_LEAN]])
            shapes = [np.r_[lean, part] for part in edges for lean in leans]
            moved = np.stack([_motion_of_newton(table, shape) for shape in shapes])
            counts = self.model.counts_of_motions(_SMALL_N * moved) / _SMALL_N
            self._parts[face] = edges, counts.reshape(len(edges), len(leans), -1)
        return self._parts[face]


def _motion_of_newton(
    table: JawFace, shape: Float[np.ndarray, "6"]
) -> Float[np.ndarray, "magnet 6"]:
    """Motions per newton of a jaw of two leans and four edges."""
    force, _, motion = table.press(shape[:2], shape[2:].reshape(2, 2))
    return motion / force


def _mean(fits: Sequence[JawFit]) -> JawFit:
    """The best of some fits on the same faces; what is read of it is their mean by their odds."""
    best = max(fits, key=lambda fit: fit.log_evidence)
    odds = np.exp([fit.log_evidence - best.log_evidence for fit in fits])
    values = np.stack([fit.values for fit in fits])
    off = np.average(values, axis=0, weights=odds) - best.values
    away = values - best.values - off
    among = np.average(away[..., :, None] * away[..., None, :], axis=0, weights=odds)
    covariance = np.average([fit.covariance for fit in fits], axis=0, weights=odds)
    return _with_others(best, covariance, off, among)


def _with_others(
    fit: JawFit,
    covariance: Float[np.ndarray, "jaw 5 5"],
    off: Float[np.ndarray, "jaw 5"],
    among: Float[np.ndarray, "jaw 5 5"],
) -> JawFit:
    """The fit with what other edges would read."""
    values = fit.values + off
    return replace(fit, values=values, covariance=covariance + among, off=off, among=among)


class _Peak(NamedTuple):
    """The most probable jaws with given unknowns: pose, what is free of it, log evidence, the most that it
    could be were edges known, half χ² there and (k, k) covariance of the unknowns."""

    pose: Float[np.ndarray, "k"]
    free: Bool[np.ndarray, "k"]
    log_evidence: float
    most_evidence: float
    misfit: float
    covariance: Float[np.ndarray, "k k"]


@dataclass(frozen=True)
class _Problem:
    """Jaws on given faces in one frame, of which `free` unknowns are looked for."""

    jaws: Jaws
    observations: Observations
    group: tuple[int, ...]
    free: Bool[np.ndarray, "k"]

    @cached_property
    def bounds(self) -> tuple[Float[np.ndarray, "k"], Float[np.ndarray, "k"]]:
        """Return the least and the most of every unknown."""
        low, high = [], []
        for table in self.jaws.tables_of(self.group):
            x, y = table.half_mm
            low += [_LEAST_N, -MOST_LEAN, -MOST_LEAN, -x, -x, -y, -y]
            high += [self.jaws.most_n, MOST_LEAN, MOST_LEAN, x, x, y, y]
        return np.array(low), np.array(high)

    @cached_property
    def width(self) -> Float[np.ndarray, "k"]:
        """Return how wide the even priors are."""
        low, high = self.bounds
        return high - low

    def peak(self, start: Float[np.ndarray, "k"], rounds: int, least: float = -np.inf) -> _Peak:
        """Return the most probable jaws near a start; any where evidence cannot reach `least`."""
        pose, residual, slopes = self._descend(start, rounds, least)
        curvature, misfit = slopes @ slopes.T + self._prior, 0.5 * float(residual @ residual)
        inverse, free = np.linalg.inv(curvature), self.free
        count, volume = int(free.sum()), np.linalg.slogdet(curvature)[1]
        evidence = self._laplace(count, float(volume) + 2 * self._log_volume, misfit)
        low, high = (end[free] for end in self.bounds)
        sigma, slope = np.sqrt(inverse.diagonal()), slopes @ residual
        evidence += log_mass_between(pose[free], low, high, sigma, slope).sum()
        covariance = np.zeros((len(pose), len(pose)))
        covariance[np.ix_(free, free)] = inverse
        most = self._most_evidence(curvature, misfit)
        return _Peak(pose, free, float(evidence), most, misfit, covariance)

    def _most_evidence(self, curvature: Float[np.ndarray, "free free"], misfit: float) -> float:
        """Laplace's log evidence were all edges known: every edge to be found takes a factor below 1."""
        inner = self.jaws._whole(self.group)
        block = curvature[np.ix_(inner[self.free], inner[self.free])]
        volume = np.linalg.slogdet(block)[1] + 2 * np.log(self.width[inner]).sum()
        return self._laplace(len(block), float(volume), misfit)

    def _laplace(self, count: int, volume: float, misfit: float) -> float:
        """Log evidence (2π)^{k/2} e^{−misfit} / √volume of k unknowns, `volume` that of H times the square of
        the even priors'."""
        peak = 0.5 * (count * np.log(2 * np.pi) - volume) - misfit
        return float(peak) + self.jaws.log_density(self.group)

    def fit(self, peak: _Peak) -> JawFit:
        """Return what is read of the most probable jaws."""
        pose, covariance = peak.pose, peak.covariance
        readings = int((self.observations.sigma < BLIND).sum())
        freedoms = max(readings - int(peak.free.sum()), 1)
        values, spreads = [], []
        for jaw, table in enumerate(self.jaws.tables_of(self.group)):
            part = slice(_POSE * jaw, _POSE * (jaw + 1))
            value = _described(table, pose[part])
            # differences inwards, as unknowns end at their bounds
            step = self._inward(pose, 1e-3)[part]
            ends = np.tile(value, (_POSE, 1))
            for unknown in np.flatnonzero(peak.free[part]):
                moved = pose[part].copy()
                moved[unknown] += step[unknown]
                ends[unknown] = _described(table, moved)
            by_pose = (ends - value)[:, :5].T / step
            values.append(value)
            spreads.append(by_pose @ covariance[part, part] @ by_pose.T)
        described = np.array(values)
        return JawFit(
            self.group, pose.reshape(-1, _POSE), peak.free.reshape(-1, _POSE), peak.log_evidence, 0.0,
            described[:, :5], np.array(spreads), np.zeros((len(values), 5)),
            np.zeros((len(values), 5, 5)), described[:, 5:],
            float(chdtrc(freedoms, 2 * peak.misfit)),
        )  # fmt: skip

    @cached_property
    def _log_volume(self) -> float:
        """Log of the volume of the even priors; two edges of one side keep their order and distance."""
        volume = np.log(self.width[self.free]).sum()
        for jaw in range(len(self.group)):
            for low in (_EDGE, _EDGE + 2):
                side = slice(_POSE * jaw + low, _POSE * jaw + low + 2)
                between = int(self.free[side].sum())
                width = self.width[side.start]
                volume += between * np.log1p(-_LEAST_EDGE_MM / width) - (between == 2) * np.log(2)
        return float(volume)

    @cached_property
    def _prior(self) -> Float[np.ndarray, "free free"]:
        """Even priors; their normal stand-in keeps the curvature regular, as with tips."""
        return np.diag(12 / self.width[self.free] ** 2)

    def _inward(self, pose: Float[np.ndarray, "k"], share: float) -> Float[np.ndarray, "k"]:
        """Steps of a share of the priors' width, away from the upper bounds."""
        step = share * self.width
        return np.where(pose + step > self.bounds[1], -step, step)

    def _clipped(self, pose: Float[np.ndarray, "k"]) -> Float[np.ndarray, "k"]:
        """The nearest pose within bounds, of edges that are wide enough apart."""
        clipped = np.clip(pose, *self.bounds)
        for first in range(0, len(pose), _POSE):
            for low in (first + _EDGE, first + _EDGE + 2):
                lack = _LEAST_EDGE_MM - (clipped[low + 1] - clipped[low])
                if lack > 0:
                    middle = clipped[low : low + 2].mean()
                    half = self.bounds[1][low] - _LEAST_EDGE_MM / 2
                    middle = np.clip(middle, -half, half)
                    clipped[low : low + 2] = middle + _LEAST_EDGE_MM / 2 * np.array([-1, 1])
        return np.where(self.free, clipped, pose)

    def _white(
        self, change: Float[np.ndarray, "pose channel"]
    ) -> Float[np.ndarray, "pose channel"]:
        return self.observations.white(change[None])[0]

    def _residual(self, pose: Float[np.ndarray, "k"]) -> Float[np.ndarray, "channel"]:
        change = self.jaws.change(self.group, pose) - self.observations.counts
        return self._white(change)[0]

    def _slopes(self, pose: Float[np.ndarray, "k"]) -> Float[np.ndarray, "free channel"]:
        """Whitened change by each unknown, per unit of it."""
        step = self._inward(pose, _STEP)
        return self._white(self.jaws.slopes(self.group, pose, self.free, step))

    @property
    def _whole_part(self) -> int:
        """Row of the whole face among its parts: of the first and last line along both sides."""
        pairs = list(combinations(range(_LINES), 2))
        whole = pairs.index((0, _LINES - 1))
        return whole * len(pairs) + whole

    def start(self) -> tuple[Float[np.ndarray, "k"], float]:
        """Return the parts that fit best, each face's in turn, and log evidence, were signals linear."""
        counts = self._white(self.observations.counts)[0]
        rows = {face: self._white_parts(face) for face in self.group}
        chosen = dict.fromkeys(self.group, self._whole_part)
        start, best, volume = self.jaws._whole_pose(self.group), 0.0, 0.0
        spread = np.zeros(len(self.group))
        for jaw, face in [*enumerate(self.group)] * len(self.group):
            others = [rows[number][chosen[number]] for number in self.group if number != face]
            beside = np.concatenate([np.zeros((0, len(counts))), *others])
            patterns = np.concatenate(
                [rows[face], np.broadcast_to(beside, (len(rows[face]), *beside.shape))], axis=1
            )
            square = patterns @ patterns.swapaxes(1, 2)
            ridge = _RIDGE * np.trace(square, axis1=1, axis2=2)
            square += ridge[:, None, None] * np.eye(square.shape[1])
            projected = patterns @ counts
            share = np.linalg.solve(square, projected[..., None])[..., 0]
            # the fall of the misfit; jaws only push
            fall = np.where(share[:, :3].sum(axis=1) > 0, (share * projected).sum(axis=1), -np.inf)
            chosen[face], best = int(fall.argmax()), float(fall.max())
            if not np.isfinite(best):
                return start, -np.inf
            volume = float(np.linalg.slogdet(square[chosen[face]])[1])
            # what the mean over all parts, alike likely, is under the best
            spread[jaw] = np.logaddexp.reduce(fall / 2) - best / 2 - np.log(len(fall))
            level, *leans = share[chosen[face], :3]
            force = float(np.clip(level + sum(leans), _SMALL_N, self.jaws.most_n))
            part = slice(_POSE * jaw, _POSE * (jaw + 1))
            lean = np.clip(_SMALL_LEAN * np.array(leans) / force, -1, 1)
            start[part] = np.r_[force, lean, self.jaws.parts(face)[0][chosen[face]]]
        # unknowns of the linear fit are the force times each lean, in units of `_SMALL_LEAN`
        inner, force = self.jaws._whole(self.group), start[::_POSE]
        volume += 2 * (np.log(self.width[inner]).sum() + 2 * np.log(force / _SMALL_LEAN).sum())
        misfit = 0.5 * (float(counts @ counts) - best)
        return start, self._laplace(int(inner.sum()), float(volume), misfit) + float(spread.sum())

    def _white_parts(self, face: int) -> Float[np.ndarray, "part 3 channel"]:
        counts = self.jaws.parts(face)[1]
        return self._white(counts.reshape(-1, counts.shape[2])).reshape(counts.shape)

    def _descend(
        self, pose: Float[np.ndarray, "k"], rounds: int, least: float
    ) -> tuple[
        Float[np.ndarray, "k"], Float[np.ndarray, "channel"], Float[np.ndarray, "free channel"]
    ]:
        """Return the pose of least misfit near a start, its whitened residual, and the slopes there.

        It ends early where the misfit that a linear model leaves allows no evidence of `least`.
        """
        pose, free = self._clipped(pose), self.free
        residual = self._residual(pose)
        misfit, damping = 0.5 * float(residual @ residual), 1e-3
        slopes = self._slopes(pose)
        for _ in range(rounds):
            curvature = slopes @ slopes.T + self._prior
            gradient = slopes @ residual
            if np.isfinite(least):
                falls = 0.5 * float(gradient @ np.linalg.solve(curvature, gradient))
                if self._most_evidence(curvature, misfit - _FALLS * falls) < least:
                    break
            # Marquardt's scaling: damping in the parameters' own units
            damped = curvature + damping * np.diag(np.diag(curvature))
            step = np.zeros_like(pose)
            step[free] = np.linalg.solve(damped, gradient)
            tried = self._clipped(pose - step)
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
        return pose, residual, slopes


def _described(table: JawFace, pose: Float[np.ndarray, "7"]) -> Float[np.ndarray, "7"]:
    """Centre of pressure (mm), force (N), size (mm), and tilt about x and y (degrees)."""
    force, lean, edges = pose[0], pose[1:_EDGE], pose[_EDGE:].reshape(2, 2)
    per_mm, centre, _ = table.press(lean, edges)
    size = np.diff(edges)[:, 0]
    gained = lean * force / per_mm / (size / 2)
    # depth gained towards +y is a turn about −x, towards +x about +y
    tilt = np.degrees(np.arctan([-gained[1], gained[0]]))
    return np.concatenate([centre, [force], size, tilt])
