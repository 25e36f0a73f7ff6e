"""Flat jaws over whole faces, read from frames: another kind of contact, weighed against tips by evidence.

A jaw's motions of the magnets are its depth times a table over how it leans (`fem.presses.jaws`): as patterns
of low order, uniform and two tilts, with the contact that is lost. Jaws add up as motions, and the field of
the sum is exact, as with tips (`estimator.inversion.model.forward`). The most probable pose of the jaws on
given faces is found by Gauss and Newton's method; its evidence by Laplace's approximation has the frame's
constant in common with that of tips, so that their difference is the log of the odds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from jaxtyping import Float
from scipy.interpolate import RegularGridInterpolator
from scipy.optimize import least_squares

from estimator.inversion.inversion import Inversion
from estimator.inversion.problems import Observations
from fem.presses.jaws import JawFace

MOST_LEAN = 2.0
"""Share in the table: the depth gained from the middle to a border, over the depth at the middle."""
_NODES = 9
"""Leans of the table along each axis."""
_STEP = 1e-4
"""Step of differences, over the width of the prior: signals bend little over it."""
_STARTS_N = (0.02, 0.2)
"""Forces from which a fit starts, over the largest."""


@dataclass(frozen=True)
class JawTable:
    """A jaw on one face over its two leans: force (N) and motions per mm, centre of pressure (mm)."""

    face: int
    half_mm: Float[np.ndarray, "2"]
    values: RegularGridInterpolator

    def pattern(
        self, lean: Float[np.ndarray, "2"]
    ) -> tuple[float, Float[np.ndarray, "2"], Float[np.ndarray, "magnet 6"]]:
        """Return what `JawFace.press` gives, from a cubic spline over the table."""
        row = self.values(lean)[0]
        return float(row[0]), row[1:3] / row[0], row[3:].reshape(-1, 6)


@dataclass(frozen=True)
class JawReading:
    """The most probable jaws of a frame, and how much more probable they are than the best tips.

    Attributes
    ----------
    faces, force_n, centre_mm, tilt_deg : of each jaw: face, net force, centre of pressure in the
        face's frame, and tilt about the face's x and y
    log_odds : log of the posterior odds against the tips of `Inversion.read`
    p_value : chance of a misfit as large if the jaws were true
    """

    faces: tuple[int, ...]
    force_n: Float[np.ndarray, "jaw"]
    centre_mm: Float[np.ndarray, "jaw 2"]
    tilt_deg: Float[np.ndarray, "jaw 2"]
    log_odds: float
    p_value: float

    @property
    def kind(self) -> str:
        """Name of the kind of contact that explains the frame best: "jaws" or "tips"."""
        return "jaws" if self.log_odds > 0 else "tips"


def jaw_table(jaw: JawFace) -> JawTable:
    """Press one face's jaw at all leans of the table."""
    nodes = np.linspace(-MOST_LEAN, MOST_LEAN, _NODES)
    rows = []
    for lean in product(nodes, nodes):
        force, centre, motion = jaw.press(np.array(lean))
        rows.append(np.concatenate([[force], force * centre, motion.ravel()]))
    values = np.array(rows).reshape(_NODES, _NODES, -1)
    return JawTable(
        jaw.face, jaw.half_mm, RegularGridInterpolator((nodes, nodes), values, method="cubic")
    )


@dataclass(frozen=True)
class JawReader:
    """Reads jaws with the model, noise and priors of an inversion."""

    inversion: Inversion
    tables: tuple[JawTable, ...]
    most_n: float

    def read(
        self, counts: Float[np.ndarray, "frame channel"], groups: Sequence[tuple[int, ...]]
    ) -> tuple[JawReading, ...]:
        """The best of some groups of faces with a jaw on each, for every frame; weighed against tips."""
        frames = self.inversion.disturbances.observed(counts)
        search = self.inversion.search
        sets = search.contacts(frames)
        tips = sets.log_evidence[sets.best()]
        readings = []
        for frame in range(len(counts)):
            single = frames.select(np.array([frame]))
            fits = [self._fitted(single, group) for group in groups]
            evidence, group, pose = max(fits, key=lambda fit: fit[0])
            # all groups are as likely, and jaws as likely as tips
            odds = evidence - np.log(len(groups)) - float(tips[frame])
            readings.append(self._reading(single, group, pose, odds))
        return tuple(readings)

    def _tables_of(self, group: tuple[int, ...]) -> list[JawTable]:
        return [table for face in group for table in self.tables if table.face == face]

    def _change(self, group: tuple[int, ...], poses: Float[np.ndarray, "some k"]) -> np.ndarray:
        """Counts (some, channel) of jaws with force (N) and two leans each."""
        moved = np.zeros((len(poses), *self.inversion.model.rest.shape))
        for row, pose in enumerate(poses):
            for table, (force, *lean) in zip(
                self._tables_of(group), pose.reshape(-1, 3), strict=True
            ):
                per_mm, _, motion = table.pattern(np.array(lean))
                moved[row] += force / per_mm * motion
        return self.inversion.model.counts_of_motions(moved)

    def _fitted(
        self, observed: Observations, group: tuple[int, ...]
    ) -> tuple[float, tuple[int, ...], np.ndarray]:
        """Log evidence of jaws on these faces, and their pose."""
        count = len(group)
        width = np.tile([self.most_n, 2 * MOST_LEAN, 2 * MOST_LEAN], count)
        low = np.tile([1e-3, -MOST_LEAN, -MOST_LEAN], count)

        def residual(pose: np.ndarray) -> np.ndarray:
            change = self._change(group, pose[None]) - observed.counts
            return observed.white(change[:, None])[0, 0]

        def slopes(pose: np.ndarray) -> np.ndarray:
            step = _STEP * width
            inward = np.where(pose + step > low + width, -1.0, 1.0) * step
            ends = self._change(group, np.vstack([pose, pose + np.diag(inward)]))
            return observed.white((ends[1:] - ends[:1])[None])[0].T / inward

        starts = [np.tile([share * self.most_n, 0.0, 0.0], count) for share in _STARTS_N]
        fits = [
            least_squares(
                residual,
                start,
                slopes,  # pyright: ignore[reportArgumentType]
                (low, low + width),
                x_scale=width,
            )
            for start in starts
        ]
        best = min(fits, key=lambda fit: fit.cost)
        # even priors; their normal stand-in keeps the curvature regular, as with tips
        curvature = best.jac.T @ best.jac + np.diag(12 / width**2)
        volume = np.linalg.slogdet(curvature)[1]
        evidence = 0.5 * (3 * count * np.log(2 * np.pi) - volume) - best.cost - np.log(width).sum()
        return float(evidence), group, best.x

    def _reading(
        self, observed: Observations, group: tuple[int, ...], pose: np.ndarray, log_odds: float
    ) -> JawReading:
        from scipy.special import chdtrc

        force, centre, tilt = [], [], []
        for table, (newton, *lean) in zip(self._tables_of(group), pose.reshape(-1, 3), strict=True):
            per_mm, where, _ = table.pattern(np.array(lean))
            gained = np.array(lean) * newton / per_mm / table.half_mm
            force.append(newton)
            centre.append(where)
            # depth gained towards +y is a turn about −x, towards +x about +y
            tilt.append(np.degrees(np.arctan([-gained[1], gained[0]])))
        change = self._change(group, pose[None]) - observed.counts
        white = observed.white(change[:, None])
        freedoms = max(white.shape[2] - len(pose), 1)
        return JawReading(
            group,
            np.array(force),
            np.array(centre),
            np.array(tilt),
            log_odds,
            float(chdtrc(freedoms, float((white**2).sum()))),
        )
