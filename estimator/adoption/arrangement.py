"""Arrangement: the same object pressed with moving chips and with moving magnets.

A press moves what lies in the shell, as far as a bell about the place says; what sits in the core rests.
Both ways have the same bodies, the same ten numbers and the bell's three, so that nothing but who moves
differs. Far from the press a chip that moves feels nothing, and a magnet that moves is felt by all chips.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.adoption.findings import CERTAIN, Finding, share_as_high
from estimator.adoption.fit import Motion, Moving, Pressed, fit_object
from estimator.field.models import magnets_model
from estimator.signals.field_setup import Scene, min_distance_mm, scene, zero_motion

SPREAD_MM, SHARE = 9.0, 0.4
"""Radius of the bell (one standard deviation) and motion at its middle per travel, before they are fitted."""
EXTRA = (0.3, 0.3, 0.5)
"""Sizes of ln of the bell's radius, motion aside per radius, tilt over the bell's slope less one."""
EXCHANGES, FOLDS = 999, 5
LEAST_EXPLAINED = 0.6
"""Share of the changes that the better way must explain. A made normal object, held against one magnet over
every chip, was reverse at p 0.01 with 0.36; the right geometry explains 0.82 and more."""
_NEAREST_MM = 1.5
"""Distance of a chip and a magnet that the field model must take."""
_DEEPEST_MM = 6.0
"""Travel of the shell that presses are taken to reach, before their scale is fitted."""


@dataclass(frozen=True)
class Arrangement:
    """Share of the changes of unseen places that each way explains, and the null of their difference.

    `null` holds differences with the two ways exchanged at random at every place.
    """

    reverse: float
    normal: float
    null: Float[np.ndarray, "exchange"]

    @property
    def p(self) -> float:
        """Share of exchanges in which one way leads by as much."""
        return share_as_high(np.abs(self.null).tolist(), abs(self.reverse - self.normal))

    @property
    def finding(self) -> Finding:
        """Say what was found."""
        names = {
            True: "reverse: chips move, magnets rest",
            False: "normal: magnets move, chips rest",
        }
        is_certain = self.p <= CERTAIN and max(self.reverse, self.normal) >= LEAST_EXPLAINED
        answer = names[self.reverse > self.normal] if is_certain else "cannot be told"
        return Finding(
            "arrangement",
            answer,
            f"explained of unseen places: reverse {100 * self.reverse:.0f} %, normal "
            f"{100 * self.normal:.0f} %",
            f"difference of {100 * np.median(np.abs(self.null)):.0f} %",
            self.p,
        )


def told_arrangement(
    spec: ObjectSpec, faces: Sequence[Pressed], seed: int = 0, kept: int = 2
) -> Arrangement:
    """Fit both ways to four fifths of a face's places and judge them on the others, each fifth once.

    An object has one arrangement: places of all its faces decide together. `kept` starts of each fit are
    refined.
    """
    deepest = [_one_travel(pressed.complete) for pressed in faces]
    size = sum(np.sum(pressed.change_mt**2) for pressed in deepest)
    reverse, normal = (
        np.concatenate([_squares_left(thing, pressed, seed, kept) for pressed in deepest]) / size
        for thing in (moving_bodies(spec, True), moving_bodies(spec, False))
    )
    sign = np.random.default_rng((seed, 51)).choice([-1, 1], (EXCHANGES, len(reverse)))
    return Arrangement(float(1 - reverse.sum()), float(1 - normal.sum()), sign @ (normal - reverse))


def _one_travel(pressed: Pressed) -> Pressed:
    """Keep the deepest press of every place."""
    order = np.lexsort((-pressed.travel_mm, pressed.place))
    first = np.r_[True, np.diff(pressed.place[order]) != 0]
    return pressed.select(order[first])


def _squares_left(
    thing: Moving, pressed: Pressed, seed: int, kept: int
) -> Float[np.ndarray, "press"]:
    """Squares (mT²) that a fit leaves of every press, which it has not seen."""
    squares = np.zeros(len(pressed.place))
    order = np.random.default_rng((seed, 52)).permutation(len(squares))
    for fold in range(min(FOLDS, len(squares))):
        rows = order[fold::FOLDS]
        fit = fit_object(thing, pressed.select(np.setdiff1d(order, rows)), kept)
        unseen = pressed.select(rows)
        off = fit.recorded(unseen) - fit.predicted(unseen)[0]
        squares[rows] = np.sum(off**2, axis=(1, 2))
    return squares


def moving_bodies(spec: ObjectSpec, sensors_move: bool) -> Moving:
    """Return a specification's object whose chips, or whose magnets, move as a bell says."""
    place = replace(scene(spec), sensors_move=sensors_move)
    nearest = min(min_distance_mm(place, zero_motion(place)), _NEAREST_MM)
    frame = face_frames(spec)[0]
    return Moving(
        place, magnets_model(spec.magnets, nearest), _bell(place, frame.axes), _DEEPEST_MM, EXTRA
    )


def _bell(place: Scene, axes: Float[np.ndarray, "3 3"]) -> Motion:
    """Return motions of the bodies: inwards, aside and tilted, about the place pressed."""
    body = place.sensors.position_mm if place.sensors_move else place.magnets.centre_mm
    local = body @ axes[:, :2]

    def motion(xy: np.ndarray, travel: np.ndarray, extra: np.ndarray) -> np.ndarray:
        radius = SPREAD_MM * float(np.exp(extra[0]))
        return bell_motion(local, axes, xy, travel, radius, float(extra[1]), 1 + float(extra[2]))

    return motion


def bell_motion(
    local_mm: Float[np.ndarray, "body 2"],
    axes: Float[np.ndarray, "3 3"],
    xy_mm: Float[np.ndarray, "press 2"],
    travel_mm: Float[np.ndarray, "press"],
    radius_mm: float,
    aside: float,
    tilt: float,
) -> Float[np.ndarray, "press body 6"]:
    """Motions of bodies at places of a face under presses: `SHARE` of the travel inwards at the middle.

    `aside` is the motion away from the place per radius of the bell, `tilt` the turn over its slope.
    """
    x, y, outwards = axes.T
    offset = local_mm[None] - xy_mm[:, None]
    bell = SHARE * travel_mm[:, None] * np.exp(-np.sum(offset**2, axis=2) / (2 * radius_mm**2))
    away = aside * bell[..., None] * offset / radius_mm
    slope = tilt * bell[..., None] * offset / radius_mm**2
    shift = away[..., :1] * x + away[..., 1:] * y - bell[..., None] * outwards
    # a surface w(x, y) turns by (∂w/∂y, −∂w/∂x, 0)
    turn = slope[..., 1:] * x - slope[..., :1] * y
    return np.concatenate([shift, turn], axis=2)
