"""Priors of contacts, before a frame is seen: how many, where, how hard, and known probes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.forward import NONE

_OVERLAP_MM, SPACING_SIGMA_MM = 0.5, 0.2
"""Standard deviations of how far tips may seem to overlap, and of distances within a known probe."""
_ROOT = np.sqrt(2 * np.pi)


@dataclass(frozen=True)
class Priors:
    """What is believed of contacts before a frame is seen.

    Attributes
    ----------
    number : probabilities of 0, 1, 2, … contacts
    faces, area_mm2 : number and whole area of the sensed faces; contacts are equally likely
        everywhere on them
    force_n : least and largest, forces between are equally likely
    apart_mm : least distance of two contacts on a face (twice the tip's radius); 0 for none
    force_spread : relative standard deviation of the forces of a face's contacts, where they are
        tips of one probe that bear alike; None where nothing is known of that
    spacing_mm : of probes, where they are known: distance between the tips of the probe of two, of
        three, … of which a face meets one; empty where contacts are free
    """

    number: tuple[float, ...]
    faces: int
    area_mm2: float
    force_n: tuple[float, float]
    apart_mm: float = 0.0
    force_spread: float | None = None
    spacing_mm: tuple[float, ...] = ()

    @property
    def most(self) -> int:
        """Largest number of contacts."""
        return len(self.number) - 1


@dataclass
class Quadratic:
    """Misfit, its slope and curvature at the contacts of some problems; `Problems.log_spread`."""

    misfit: np.ndarray
    slope: np.ndarray
    curvature: np.ndarray
    log_spread: np.ndarray


def add_priors(found: Quadratic, priors: Priors, face: np.ndarray, contact: np.ndarray) -> None:
    """Tips that do not overlap, stand as their probe has them, and bear alike where they are known to."""
    first, second = _pairs_of(face.shape[1])
    both = (face[:, first] == face[:, second]) & (face[:, first] != NONE)
    (rows,) = np.nonzero(both.any(axis=1))
    if not len(rows):
        return
    alike = np.sum(face[rows, :, None] == face[rows, None, :], axis=2)[:, first]
    pairs = _Pairs(found, rows, contact[rows], first, second, both[rows], alike)
    if priors.spacing_mm:
        pairs.stand(priors.spacing_mm)
    elif priors.apart_mm:
        pairs.keep_apart(priors.apart_mm)
    if priors.force_spread is not None:
        pairs.bear_alike(priors.force_spread)


@cache
def _pairs_of(slots: int) -> tuple[np.ndarray, np.ndarray]:
    return np.triu_indices(slots, 1)


@dataclass(frozen=True)
class _Pairs:
    """Pairs of contacts in some problems (`rows` of `found`), those that share a face (`both`).

    `alike` (problem, pair) counts the contacts of the first one's face.
    """

    found: Quadratic
    rows: np.ndarray
    contact: np.ndarray
    first: np.ndarray
    second: np.ndarray
    both: np.ndarray
    alike: np.ndarray

    def keep_apart(self, apart_mm: float) -> None:
        between, distance = self._between()
        overlap = self.both & (distance < apart_mm)
        if overlap.any():
            self._hold(between, distance, apart_mm, _OVERLAP_MM, overlap)

    def stand(self, spacing_mm: tuple[float, ...]) -> None:
        wanted = np.array([0.0, 0.0, *spacing_mm])
        known = self.both & (self.alike < len(wanted))
        target = wanted[np.minimum(self.alike, len(wanted) - 1)]
        self._hold(*self._between(), target, SPACING_SIGMA_MM, known)

    def bear_alike(self, spread: float) -> None:
        one, other = (
            np.where(self.both, self.contact[:, slots, 2], 1.0)
            for slots in (self.first, self.second)
        )
        scale = self.both / (spread * np.sqrt(np.maximum(self.alike, 1)))
        self._add(scale * np.log(one / other), [2], [scale / one], [scale / other])

    def _between(self) -> tuple[np.ndarray, np.ndarray]:
        between = self.contact[:, self.first, :2] - self.contact[:, self.second, :2]
        return between, np.maximum(np.sqrt(np.sum(between**2, axis=2)), 1e-6)

    def _hold(
        self,
        between: np.ndarray,
        distance: np.ndarray,
        wanted_mm: np.ndarray | float,
        sigma_mm: float,
        held: np.ndarray,
    ) -> None:
        scale = held / sigma_mm
        along = (between * (scale / distance)[..., None]).transpose(2, 0, 1)
        self._add(scale * (distance - wanted_mm), [0, 1], along, along)

    def _add(self, left: np.ndarray, parameters: list[int], one: Any, other: Any) -> None:
        """One more term ½ left² for every pair: its slope by these parameters of the first contact,
        and less that by the second's."""
        rows = np.zeros((*left.shape, self.found.slope.shape[1]))
        pair = np.arange(len(self.first))
        for parameter, by_first, by_second in zip(parameters, one, other, strict=True):
            rows[:, pair, 3 * self.first + parameter] = by_first
            rows[:, pair, 3 * self.second + parameter] = -by_second
        turned = rows.transpose(0, 2, 1)
        self.found.misfit[self.rows] += 0.5 * np.sum(left**2, axis=1)
        self.found.slope[self.rows] += (turned @ left[..., None])[..., 0]
        self.found.curvature[self.rows] += turned @ rows


def log_density(
    priors: Priors,
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
) -> Float[np.ndarray, "problem"]:
    """Log prior density of sets of contacts, whatever the order of their contacts."""
    number = np.sum(face != NONE, axis=1)
    each = -np.log(priors.area_mm2 * np.ptp(priors.force_n))
    counted = np.log(np.maximum(np.asarray(priors.number), 1e-300))[number]
    orders = np.array([np.sum(np.log(np.arange(1, n + 1))) for n in range(priors.most + 1)])
    return number * each + counted + orders[number] + _probe_density(priors, face, contact)


def _probe_density(
    priors: Priors, face: np.ndarray, contact: np.ndarray
) -> Float[np.ndarray, "problem"]:
    """Log of how much denser the prior is where probes and equal forces are known.

    Of a face's n contacts one stands anywhere; the second then stands on a ring, the third at one
    of two points. Forces but one follow the first.
    """
    gained = np.zeros(len(face))
    for one in range(priors.faces):
        here = face == one
        number = here.sum(axis=1)
        more = np.maximum(number - 1, 0)
        if priors.force_spread is not None:
            force = np.where(here, contact[..., 2], 0.0).sum(axis=1)
            width = _ROOT * priors.force_spread * np.maximum(force, 1e-9) / np.maximum(number, 1)
            gained += np.where(more > 0, more * np.log(np.ptp(priors.force_n) / width), 0.0)
        if priors.spacing_mm:
            gained += _standing(priors)[np.minimum(number, len(priors.spacing_mm) + 2)]
    return gained


def _standing(priors: Priors) -> Float[np.ndarray, "number"]:
    """Log density of the places of n tips of a known probe over that of n contacts anywhere."""
    ring = 2 * np.pi * np.asarray(priors.spacing_mm) * _ROOT * SPACING_SIGMA_MM
    point = 2 * (_ROOT * SPACING_SIGMA_MM) ** 2
    extra = np.arange(len(priors.spacing_mm))
    gained = np.log(priors.area_mm2 / ring) + extra * np.log(priors.area_mm2 / point)
    return np.concatenate([[0.0, 0.0], gained, [-np.inf]])


def widths(priors: Priors) -> Float[np.ndarray, "3"]:
    """Of the priors of x, y and force on one face: no posterior is wider."""
    side = np.sqrt(priors.area_mm2 / priors.faces)
    return np.array([side, side, np.ptp(priors.force_n)])
