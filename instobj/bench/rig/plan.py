"""Plan of presses on one face: places in their order, depths, speeds, and the limits of force."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from instobj.bench.rig.contact_law import contact_law, travel_bound_mm

STOPS = 4
"""Depths per press, if none are given: a press and its retraction must fit into Grbl's buffer."""
_LIMIT_SHARE = 4 / 3
"""The limit over the force that ends a press: what a press gains within two frames at its speed."""
_SHARE = 1 / STOPS
_SHALLOWER = 0.85
_MOST_STROKES = 100
_WAY_S = 2.0
_LEAST_FULL_N = 1.0
"""Above the three times the touch that finds a surface."""


@dataclass(frozen=True)
class PressSettings:
    """Course of every press.

    Attributes
    ----------
    depths_mm : where the tip stops on its way down, below the height of first touch
    dwell_s : how long it stops there
    rest_s : how long it waits above the place before, for the baseline
    speed_mm_s : of the press; moves in the air are as fast as the machine can
    strokes : how often a place is loaded before the tip leaves it
    stroke_speed_mm_s : of strokes after the first, which go where the first one went
    pause_s : how long the tip rests above the surface between strokes, for their baselines
    lift_mm : how far above
    clearance_mm : of the tip above the object between presses
    approach_mm : how far above the object the press begins to be slow
    full_n : force at which a press ends before its deepest stop
    """

    depths_mm: tuple[float, ...]
    dwell_s: float = 0.5
    rest_s: float = 1.5
    speed_mm_s: float = 1.0
    strokes: int = 1
    stroke_speed_mm_s: float = 4.0
    pause_s: float = 1.0
    lift_mm: float = 0.5
    clearance_mm: float = 5.0
    approach_mm: float = 1.0
    full_n: float = 15.0

    def __post_init__(self) -> None:
        rising = all(a < b for a, b in zip((0.0, *self.depths_mm), self.depths_mm, strict=False))
        if not self.depths_mm or not rising:
            raise InputError(
                f"--plan depths_mm must grow from above 0, got {list(self.depths_mm)}. Give mm below "
                "the height of first touch, such as --plan depths_mm=1,2"
            )
        if not self.full_n >= _LEAST_FULL_N:
            raise InputError(f"--plan full_n={self.full_n:g} must be {_LEAST_FULL_N:g} N or more")
        least_mm = max(self.approach_mm, self.lift_mm)
        if min(self.approach_mm, self.lift_mm) <= 0 or self.clearance_mm < least_mm:
            raise InputError(f"clearance {self.clearance_mm:g} mm must be {least_mm:g} mm or more")
        if not 1 <= self.strokes <= _MOST_STROKES:
            raise InputError(f"--plan strokes={self.strokes} must be 1 to {_MOST_STROKES}")

    @property
    def limit_n(self) -> float:
        """Force that stops the machine and ends the run."""
        return _LIMIT_SHARE * self.full_n

    @property
    def seconds(self) -> float:
        """About how long a press takes, with the way to its place."""
        return self.loaded_s + self.clear_s

    @property
    def loaded_s(self) -> float:
        """Return how long of it the tip touches the object."""
        deepest, later = self.depths_mm[-1], self.strokes - 1
        moving_s = self._ways * deepest / self.speed_mm_s + later * deepest / self.stroke_speed_mm_s
        return moving_s + self.strokes * len(self.depths_mm) * self.dwell_s

    @property
    def clear_s(self) -> float:
        """Return how long of it the tip is in the air."""
        later_s = self.pause_s + self.lift_mm / self.stroke_speed_mm_s
        first_s = self._ways * self.approach_mm / self.speed_mm_s
        return _WAY_S + self.rest_s + first_s + (self.strokes - 1) * later_s

    @property
    def _ways(self) -> int:
        """At the speed of the press: the last stroke of several comes up as fast as the machine can."""
        return 2 if self.strokes == 1 else 1

    def settings_after_full(self, full_mm: float, strokes: int) -> PressSettings:
        """For strokes where the full force was met at a depth: they stay above that."""
        shallower = self.down_to(_SHALLOWER * full_mm)
        return replace(shallower, strokes=strokes, speed_mm_s=self.stroke_speed_mm_s)

    def down_to(self, deepest_mm: float) -> PressSettings:
        """With no stop below a depth."""
        depths = tuple(depth for depth in self.depths_mm if depth < deepest_mm)
        if len(depths) < len(self.depths_mm):
            depths = (*depths, round(deepest_mm, 3))
        return replace(self, depths_mm=depths)


@dataclass(frozen=True)
class PressPlan:
    """Presses on one face in their order; `reference` marks the returns to one place."""

    object_name: str
    face: int
    places_mm: tuple[tuple[float, float], ...]
    reference: tuple[bool, ...]
    settings: PressSettings
    seed: int

    def __len__(self) -> int:
        return len(self.places_mm)

    @property
    def seconds(self) -> float:
        """About how long it takes, without touching off."""
        return self.settings.seconds * len(self)


def plan_of(document: dict[str, Any]) -> PressPlan:
    """The plan that a journal holds."""
    settings = document["settings"] | {"depths_mm": tuple(document["settings"]["depths_mm"])}
    places = tuple((float(x), float(y)) for x, y in document["places_mm"])
    return PressPlan(
        document["object_name"],
        document["face"],
        places,
        tuple(document["reference"]),
        PressSettings(**settings),
        document["seed"],
    )


def bounded_depths_mm(
    spec: ObjectSpec, full_n: float = PressSettings.full_n, by_travel: bool = False
) -> Float[np.ndarray, "depth"]:
    """Depths of the specification at which less than the limit is expected, by `contact_law`; without a load
    cell at the modulus' upper end too.

    Raises
    ------
    InputError
        There is none.
    """
    limit_n = _LIMIT_SHARE * full_n
    deepest_mm = (
        travel_bound_mm(spec, limit_n) if by_travel else contact_law(spec).depth_mm(limit_n)
    )
    depths = np.asarray(spec.press.depths_mm)
    if not (depths <= deepest_mm).any():
        raise InputError(
            f"at {depths[0]:g} mm, the least of press.depths_mm, more than {limit_n:g} N are "
            f"expected. Raise full_n, or give --plan depths_mm below {deepest_mm:.2f}"
        )
    return depths[depths <= deepest_mm]


def stops_of(
    spec: ObjectSpec, full_n: float = PressSettings.full_n, by_travel: bool = False
) -> tuple[float, ...]:
    """Four of the bounded depths, evenly down to the deepest."""
    depths = bounded_depths_mm(spec, full_n, by_travel)
    wanted = depths[-1] * np.arange(1, STOPS + 1) * _SHARE
    nearest = np.unique(np.abs(depths - wanted[:, None]).argmin(axis=1))
    return tuple(depths[nearest].tolist())


def middle_place(places_mm: Float[np.ndarray, "place 2"]) -> int:
    """The reference place: the one nearest to the face's middle."""
    return int(np.linalg.norm(places_mm, axis=1).argmin())


def face_places(spec: ObjectSpec, face: int) -> Float[np.ndarray, "place 2"]:
    """Places of the contact grid that a face has (mm, in the face's frame).

    Raises
    ------
    InputError
        The face has no sensors.
    """
    if face not in spec.body.sensed:
        raise InputError(
            f"--face {face} has no sensors in {spec.name!r}. Choose among {list(spec.body.sensed)}"
        )
    return contact_grid(spec).xy_mm[contact_places(spec)[spec.body.sensed.index(face)]]


def press_plan(
    spec: ObjectSpec,
    face: int,
    settings: PressSettings,
    seed: int,
    repeats: int = 1,
    reference_every: int = 10,
    presses: int | None = None,
) -> PressPlan:
    """Places of the contact grid, each `repeats` times in rounds of random order.

    After every `reference_every` presses (0: never), and at the start and the end, the place nearest
    to the face's middle is pressed, so that drift shows. `presses` keeps the first ones.
    """
    places = face_places(spec, face)
    rng = np.random.default_rng(seed)
    order = np.concatenate([rng.permutation(len(places)) for _ in range(repeats)])
    chosen = [(place, False) for place in order.tolist()[:presses]]
    if reference_every:
        back = (middle_place(places), True)
        starts = range(0, len(chosen), reference_every)
        chosen = [press for k in starts for press in (back, *chosen[k : k + reference_every])] + [
            back
        ]
    places_of_presses = tuple((float(places[k, 0]), float(places[k, 1])) for k, _ in chosen)
    return PressPlan(
        spec.name, face, places_of_presses, tuple(is_back for _, is_back in chosen), settings, seed
    )
