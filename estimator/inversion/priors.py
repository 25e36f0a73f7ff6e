"""Priors of contacts, before a frame is seen: how many, where, how hard, and known probes."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass
from functools import cache

import numpy as np
from jaxtyping import Float, Int

from design.layout.tips import tip_positions_mm
from estimator.inversion.model.arrays import (
    Array,
    chosen,
    float64,
    library,
    like,
    true_rows,
    zeros,
)
from estimator.inversion.model.forward import NONE

Bounds = tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]
"""Least and largest x, y (mm) and force (N)."""
_OVERLAP_MM, SPACING_SIGMA_MM = 0.5, 0.2
"""Standard deviations of how far tips may seem to overlap, and of distances within a known probe."""
_ROOT = np.sqrt(2 * np.pi)
JAWS_SPREAD = 0.3
"""Relative standard deviation of the whole forces of two jaws about their mean: they balance but for the
weight and the acceleration of the object."""
_TURNS, _TIGHTEST = 720, 0.01
_UNPAIRED = np.log(1e-3)
"""Log odds that a gripper's contacts are not as many on two faces: one jaw alone, a tip that hangs over."""


@dataclass(frozen=True)
class Priors:
    """Beliefs about contacts before a frame is seen.

    Attributes
    ----------
    number : probabilities of 0, 1, 2, … contacts
    faces, area_mm2 : number and whole area of the sensed faces; contacts are equally likely
        everywhere on them
    force_n : least and largest of a face, forces between are equally likely, however contacts share them
    apart_mm : least distance of two contacts on a face (twice the tip's radius); 0 for none
    force_spread : relative standard deviation of the forces of a face's contacts, where they are
        tips of one probe that bear alike; None where nothing is known of that
    spacing_mm : of probes, where they are known: distance between the tips of the probe of two, of
        three, … of which a face meets one; empty where contacts are free
    paired : contacts are tips of two jaws, as many on each of two faces, which they press alike
        (`JAWS_SPREAD`); other numbers are rare
    """

    number: tuple[float, ...]
    faces: int
    area_mm2: float
    force_n: tuple[float, float]
    apart_mm: float = 0.0
    force_spread: float | None = None
    spacing_mm: tuple[float, ...] = ()
    paired: bool = False

    @property
    def most(self) -> int:
        """Largest number of contacts."""
        return len(self.number) - 1


@dataclass
class Quadratic:
    """Misfit, its slope and curvature at the contacts of some problems; `Problems.log_spread`."""

    misfit: Array
    slope: Array
    curvature: Array
    log_spread: Array

    @property
    def parts(self) -> tuple[Array, Array, Array, Array]:
        """All four."""
        return self.misfit, self.slope, self.curvature, self.log_spread

    def select(self, rows: Array) -> Quadratic:
        """Those of some problems."""
        return Quadratic(*(part[rows] for part in self.parts))


class Pairs:
    """Pairs of contacts that share a face, in problems whose faces stay: tips that do not overlap, stand as
    their probe has them, and bear alike where they are known to."""

    def __init__(self, priors: Priors, face: Int[Array, "problem contact"]) -> None:
        self.priors = priors
        first, second = _pairs_of(face.shape[1])
        self._first, self._second = like(face, first), like(face, second)
        of_first = chosen(face, self._first)
        self._both = (of_first == chosen(face, self._second)) & (of_first != NONE)
        self._some = bool(self._both.any())
        self._alike = chosen((face[:, :, None] == face[:, None, :]).sum(axis=2), self._first)
        self._jaw = jaw_pairs(face) if priors.paired else zeros(face, face.shape)

    def select(self, rows: Array) -> Pairs:
        """Those of some problems."""
        few = copy(self)
        few._both, few._alike, few._jaw = self._both[rows], self._alike[rows], self._jaw[rows]
        return few

    def add(self, quadratic: Quadratic, contact: Float[Array, "problem contact 3"]) -> None:
        """Add what the priors say of contacts to the misfit, with its slope and curvature."""
        if self.priors.paired:
            self._add_balance_prior(quadratic, contact)
        if not self._some:
            return
        if self.priors.spacing_mm:
            self._add_spacing_prior(quadratic, contact, self.priors.spacing_mm)
        elif self.priors.apart_mm:
            self._add_overlap_prior(quadratic, contact, self.priors.apart_mm)
        if self.priors.force_spread is not None:
            self._add_alike_prior(quadratic, contact, self.priors.force_spread)

    def _add_overlap_prior(self, quadratic: Quadratic, contact: Array, apart_mm: float) -> None:
        between = self._differences(contact)
        overlap = self._both & ((between * between).sum(axis=2) < apart_mm**2)
        rows = true_rows(overlap.any(axis=1))
        if len(rows):
            self._add_distance_prior(
                quadratic, rows, between[rows], apart_mm, _OVERLAP_MM, overlap[rows]
            )

    def _add_spacing_prior(
        self, quadratic: Quadratic, contact: Array, spacing_mm: tuple[float, ...]
    ) -> None:
        wanted = like(contact, np.array([0.0, 0.0, *spacing_mm]))
        rows = true_rows(self._both.any(axis=1))
        alike = self._alike[rows]
        has_spacing = self._both[rows] & (alike < len(wanted))
        target = wanted[alike.clip(max=len(wanted) - 1)]
        between = self._differences(contact[rows])
        self._add_distance_prior(quadratic, rows, between, target, SPACING_SIGMA_MM, has_spacing)

    def _add_alike_prior(self, quadratic: Quadratic, contact: Array, spread: float) -> None:
        xp, rows = library(contact), true_rows(self._both.any(axis=1))
        force, both = contact[rows][:, :, 2], self._both[rows]
        first_force, second_force = (
            xp.where(both, chosen(force, slots), 1.0) for slots in (self._first, self._second)
        )
        scale = both / (spread * float64(self._alike[rows].clip(1)) ** 0.5)
        residual = scale * xp.log(first_force / second_force)
        self._add(quadratic, rows, residual, {2: (scale / first_force, scale / second_force)})

    def _add_balance_prior(self, quadratic: Quadratic, contact: Array) -> None:
        rows = true_rows(self._jaw.any(axis=1))
        xp, jaw, force = library(contact), self._jaw[rows], contact[rows][:, :, 2]
        first_force, second_force = (
            (force * (jaw == side)).sum(axis=1)[:, None] for side in (1, -1)
        )
        scale = 1 / (2**0.5 * JAWS_SPREAD)
        residual = scale * xp.log(first_force / second_force)
        by = zeros(residual, (*residual.shape, quadratic.slope.shape[1]))
        by[:, 0, 2::3] = scale * jaw / xp.where(jaw > 0, first_force, second_force)
        _add_squares(quadratic, rows, residual, by)

    def _differences(self, contact: Array) -> Float[Array, "problem pair 2"]:
        place = contact[:, :, :2]
        return chosen(place, self._first) - chosen(place, self._second)

    def _add_distance_prior(
        self,
        quadratic: Quadratic,
        rows: Array,
        between: Array,
        wanted_mm: Array | float,
        sigma_mm: float,
        held: Array,
    ) -> None:
        distance = ((between * between).sum(axis=2) ** 0.5).clip(1e-6)
        scale = float64(held) / sigma_mm
        direction = between * (scale / distance)[..., None]
        both_alike = {axis: (direction[..., axis], direction[..., axis]) for axis in (0, 1)}
        self._add(quadratic, rows, scale * (distance - wanted_mm), both_alike)

    def _add(
        self,
        quadratic: Quadratic,
        rows: Array,
        residual: Array,
        slopes: dict[int, tuple[Array, Array]],
    ) -> None:
        """One more term ½ left² for every pair: its slope by these parameters of the first contact,
        and less that by the second's."""
        by = zeros(residual, (*residual.shape, quadratic.slope.shape[1]))
        pair = like(residual, np.arange(residual.shape[1]))
        for parameter, (by_first, by_second) in slopes.items():
            by[:, pair, 3 * self._first + parameter] = by_first
            by[:, pair, 3 * self._second + parameter] = -by_second
        _add_squares(quadratic, rows, residual, by)


def _add_squares(
    quadratic: Quadratic,
    rows: Array,
    residual: Float[Array, "row term"],
    by: Float[Array, "row term parameter"],
) -> None:
    """Terms ½ left² of some problems, with their slopes `by` the parameters."""
    turned = by.swapaxes(1, 2)
    quadratic.misfit[rows] += 0.5 * (residual * residual).sum(axis=1)
    quadratic.slope[rows] += (turned @ residual[..., None])[..., 0]
    quadratic.curvature[rows] += turned @ by


def jaw_pairs(face: Int[Array, "problem contact"]) -> Float[Array, "problem contact"]:
    """1 and −1 for the contacts of two faces where just two are pressed, else 0."""
    xp, some = library(face), face != NONE
    on_first = some & (face == face[:, :1])
    on_second = some & ~on_first
    second = xp.amax(xp.where(on_second, face, NONE), 1)[:, None]
    two = on_second.any(axis=1) & (~on_second | (face == second)).all(axis=1)
    return (float64(on_first) - float64(on_second)) * float64(two)[:, None]


@cache
def _pairs_of(slots: int) -> tuple[np.ndarray, np.ndarray]:
    return np.triu_indices(slots, 1)


def log_density(
    priors: Priors,
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
) -> Float[np.ndarray, "problem"]:
    """Log prior density of sets of contacts, whatever the order of their contacts."""
    counted = _counted(priors)[np.sum(face != NONE, axis=1)]
    return counted + _face_densities(priors, face, contact) + _squeezed(priors, face, contact)


@cache
def _counted(priors: Priors) -> Float[np.ndarray, "number"]:
    """Return the log density of n contacts anywhere, apart from each other.

    For known probes, whose tips are apart, contacts have one order.
    """
    number = np.arange(priors.most + 1)
    each = -np.log(priors.area_mm2 * np.ptp(priors.force_n))
    of_number = np.log(np.maximum(np.asarray(priors.number), 1e-300))
    if priors.spacing_mm:
        return number * each + of_number
    apart = number * (number - 1) / 2 * np.log1p(-_too_near(priors))
    return number * each + of_number + _log_factorials(priors.most) - apart


def _too_near(priors: Priors) -> float:
    """Chance that two contacts anywhere are on one face and nearer than `apart_mm`: exact on squares
    (Philip, The probability distribution of the distance between two random points in a box, 2007)."""
    side = np.sqrt(priors.area_mm2 / priors.faces)
    t = min(priors.apart_mm / side, 1.0)
    return float((np.pi * t**2 - 8 / 3 * t**3 + t**4 / 2) / priors.faces)


def _face_densities(
    priors: Priors, face: np.ndarray, contact: np.ndarray
) -> Float[np.ndarray, "problem"]:
    """Log of how much denser the prior is than that of contacts each of which bears anything alone.

    The whole force of a face is even, and so are the ways to share it among n contacts, which have the
    density (n − 1)! / force^(n−1); where they bear alike, their logarithms are normal about the mean. Of a
    known probe one contact stands anywhere, the second on a ring, the third at one of two points; orders
    of tips are those within a face, times those of the faces, so that tips of one probe are not taken
    for ones that happened to meet.
    """
    gained, orders = np.zeros(len(face)), _log_factorials(priors.most)
    pressed = np.zeros(len(face), int)
    for number_of_face in range(priors.faces):
        here = face == number_of_face
        number = here.sum(axis=1)
        more = np.maximum(number - 1, 0)
        force = np.where(here, contact[..., 2], 0.0).sum(axis=1).clip(1e-9)
        if priors.force_spread is None:
            width = force
            gained += orders[more]
        else:
            width = _ROOT * priors.force_spread * force / np.maximum(number, 1)
            gained += 0.5 * np.log(np.maximum(number, 1))
        gained += more * np.log(np.ptp(priors.force_n) / width)
        if priors.spacing_mm:
            gained += standing_probes(priors)[np.minimum(number, len(priors.spacing_mm) + 2)]
            gained += orders[number]
            pressed += number > 0
    return gained + orders[pressed]


@cache
def _log_factorials(most: int) -> Float[np.ndarray, "number"]:
    return np.cumsum(np.log(np.arange(most + 1).clip(1)))


@cache
def standing_probes(priors: Priors) -> Float[np.ndarray, "number"]:
    """Log density of the places of n tips of a known probe, all on the face, over that of n contacts
    anywhere."""
    ring = 2 * np.pi * np.asarray(priors.spacing_mm) * _ROOT * SPACING_SIGMA_MM
    point = 2 * (_ROOT * SPACING_SIGMA_MM) ** 2 / np.sin(np.pi / 3)  # two rings that cross
    extra = np.arange(len(priors.spacing_mm))
    gained = np.log(priors.area_mm2 / ring) + extra * np.log(priors.area_mm2 / point)
    side = np.sqrt(priors.area_mm2 / priors.faces)
    gained -= np.log([fitting_sets(n, mm, side) for n, mm in enumerate(priors.spacing_mm, 2)])
    return np.concatenate([[0.0, 0.0], gained, [-np.inf]])


def _squeezed(
    priors: Priors, face: np.ndarray, contact: np.ndarray
) -> Float[np.ndarray, "problem"] | float:
    """Log of how much denser the prior of two jaws is for forces that balance: their mean is even, and the
    logarithm of their ratio is normal."""
    if not priors.paired:
        return 0.0
    jaw = jaw_pairs(face)
    first_force, second_force = (
        np.where(jaw == side, contact[..., 2], 0.0).sum(axis=1) for side in (1, -1)
    )
    two = jaw.any(axis=1)
    product, mean = (
        np.where(two, first_force * second_force, 1.0),
        np.where(two, (first_force + second_force) / 2, 1.0),
    )
    width = _ROOT * np.sqrt(2) * JAWS_SPREAD * product / mean
    return np.where(two, np.log(np.ptp(priors.force_n) / width), 0.0)


def fitting_sets(tips: int, spacing_mm: float, side_mm: float) -> float:
    """Share of the places and turns of a probe, one tip of it anywhere on a square face, at which all are on
    it; not below `_TIGHTEST`, as a face that is no square may hold a probe that a square does not."""
    turns = np.linspace(0, 2 * np.pi, _TURNS, endpoint=False)
    tips_mm = tip_positions_mm(tips, spacing_mm=spacing_mm) @ [1, 1j]
    turned = tips_mm * np.exp(1j * turns)[:, None]
    extent = np.real(turned), np.imag(turned)
    room = [np.maximum(1 - np.ptp(coordinate, axis=1) / side_mm, 0) for coordinate in extent]
    return max(float(np.mean(room[0] * room[1])), _TIGHTEST)


def number_on(
    priors: Priors, face: Int[np.ndarray, "problem contact"]
) -> Int[np.ndarray, "problem face"]:
    """Return how many contacts each face has."""
    return np.stack([np.sum(face == index, axis=1) for index in range(priors.faces)], axis=1)


def log_paired(
    priors: Priors, face: Int[np.ndarray, "problem contact"]
) -> Float[np.ndarray, "problem"]:
    """Log of how likely sets are where contacts are those of two jaws, over that of any: nothing pressed and
    as many contacts on each of two faces stay as they are."""
    if not priors.paired:
        return np.zeros(len(face))
    number = number_on(priors, face)
    several = number.max(axis=1, initial=0)
    two = (np.sum(number > 0, axis=1) == 2) & (2 * several == number.sum(axis=1))
    return np.where(two | (several == 0), 0.0, _UNPAIRED)


def widths(priors: Priors) -> Float[np.ndarray, "3"]:
    """Return the widths of the priors of x, y and force on one face: no posterior is wider."""
    side = np.sqrt(priors.area_mm2 / priors.faces)
    return np.array([side, side, np.ptp(priors.force_n)])


@cache
def flat_precision(priors: Priors) -> Float[np.ndarray, "3"]:
    """Return the precisions of normal priors as wide as the even ones."""
    return 12 / np.square(widths(priors))


def held_between(bounds: Bounds, priors: Priors) -> Bounds:
    """Return what bounds of a model leave of the priors, or these of them."""
    (low, high), (least, most) = bounds, priors.force_n
    return np.array([*low[:2], least]), np.array([*high[:2], min(most, high[2])])
