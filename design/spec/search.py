"""Layout search in a specification: what may change, limits, objectives.

Everything that is left out of `[search.vary]` stays as the specification has it. Lists are choices:
the mechanics of every magnet's outline is solved once, in minutes. Ranges are continuous.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, field_validator, model_validator

from design.spec.base import (
    Coordinate,
    Count,
    Distinct,
    Force,
    Length,
    SpecPart,
)

Objective = Literal[
    "worst_position_bound_mm",
    "percentile_99_position_bound_mm",
    "median_position_bound_mm",
    "position_over_limit",
    "worst_force_bound_n",
    "median_false_force_n",
    "percentile_95_false_force_n",
    "sensitivity_ratio",
]
OVER_LIMIT = "position_over_limit"
OBJECTIVES_TO_MAXIMIZE = ("sensitivity_ratio",)

Range = tuple[Coordinate, Coordinate]
Some = Field(min_length=1, max_length=20)


class VarySpec(SpecPart):
    """Variables that may change; magnets, and sensors that move, have one layout for all faces, one for
    each size of face (`layouts`: half extents within 10 %), or one for each; depths, tilts and
    poles are the same on all. Where there are several, names of places in trials begin with `face` and
    the first face that has them. `magnet_sizes` are catalogued magnets, one for each place.

    A changed magnet keeps its pocket's clearance and the silicone above it. `magnet_reach_mm` and
    `sensor_reach_mm` limit |x| and |y|.
    """

    layouts: Literal["one", "per size", "per face"] = "per size"
    magnet_count: Annotated[tuple[Count, ...], Some, Distinct] | None = None
    magnet_sizes: Annotated[tuple[str, ...], Some, Distinct] | None = None
    magnet_reach_mm: Length | None = None
    magnet_depth_mm: Range | None = None
    magnet_tilt_deg: Annotated[float, Field(gt=0, le=30)] | None = None
    magnet_north: bool = False
    sensor_count: (
        Annotated[tuple[Annotated[int, Field(ge=1, le=24)], ...], Some, Distinct] | None
    ) = None
    sensor_reach_mm: Length | None = None
    sensor_chip: Annotated[tuple[Literal["inward", "outward"], ...], Some, Distinct] | None = None

    @model_validator(mode="after")
    def _is_possible(self) -> VarySpec:
        if self.magnet_depth_mm and not 0 < self.magnet_depth_mm[0] < self.magnet_depth_mm[1]:
            raise ValueError(
                "search.vary.magnet_depth_mm must rise from above 0; got "
                f"{list(self.magnet_depth_mm)}. Give the least depth first"
            )
        for part in ("magnet", "sensor"):
            if getattr(self, f"{part}_count") and getattr(self, f"{part}_reach_mm") is None:
                raise ValueError(
                    f"search.vary.{part}_count needs search.vary.{part}_reach_mm: where more or fewer "
                    f"{part}s go must be free as well. Add it, or leave {part}_count out"
                )
        return self


class SearchLimitsSpec(SpecPart):
    """Limits that every layout must keep, beyond what any specification must and what `check --fabrication`
    asks of layouts: `silicone.thinnest_wall_mm` round pockets, `printer.wall_mm` round recesses.

    `times_start` says how many times the starting specification's value a score may have at most
    (`sensitivity_ratio`: at least); `position_over_limit` may not grow unless it says otherwise: what gets
    worse beyond `limits.position_bound_mm` is made up for elsewhere. At rest and in the deepest press
    a tenth of the sensors' range stays free, and 95 % of virtual objects keep every chip
    within it.
    """

    times_start: Annotated[
        dict[Objective, Annotated[float, Field(gt=0, le=1e4)]], Field(validate_default=True)
    ] = Field(default_factory=dict)

    @field_validator("times_start", mode="before")
    @classmethod
    def _with_default(cls, given: object) -> object:
        return {OVER_LIMIT: 1.0, **given} if isinstance(given, dict) else given


class SearchSpec(SpecPart):
    """A layout search: what may change, limits, objectives and budget.

    With several objectives the result is a Pareto front; the first names the layouts that the next
    levels get. Every trial is a random start whose continuous variables are improved by `polish_steps`
    generations of CMA-ES, about a hundred scorings each. `trials` that choices and processes do
    not need are joined to fewer, of up to 600 generations each. `seconds` are those of a whole call,
    mechanics and all fidelity levels: trials end at `trials` or after 40 % of the time, whichever is first.
    Each has as many generations as its time holds; one beyond `trial_limit_s` is given up. Three
    times as many as `finalists` go to the second fidelity level (rigid magnets), these to the last.
    Bounds are of a baseline that is `sensors.zeroing_counts` off.
    """

    objectives: Annotated[tuple[Objective, ...], Field(min_length=1, max_length=4)] = (
        "worst_position_bound_mm",
    )
    forces_n: Annotated[tuple[Force, ...], Field(max_length=8)] = (1.0, 3.5, 12.0)
    polish_steps: Annotated[int, Field(ge=0, le=1000)] = 300
    trials: Annotated[int, Field(ge=1, le=10_000_000)] = 60
    seconds: Annotated[float, Field(gt=0, le=1e8)] = 2700.0
    finalists: Annotated[int, Field(ge=1, le=10_000)] = 2
    vary: VarySpec = VarySpec()
    limits: SearchLimitsSpec = SearchLimitsSpec()

    @property
    def trial_limit_s(self) -> float:
        """Time of one trial: a quarter of an hour, or 3 s for each of its generations, ten times what they
        take on one core."""
        return max(900.0, 3.0 * self.polish_steps)

    @property
    def named(self) -> set[str]:
        """Scores that are objectives or limited."""
        return {*self.objectives, *self.limits.times_start}

    @model_validator(mode="after")
    def _agrees(self) -> SearchSpec:
        if any(b <= a for a, b in pairwise(self.forces_n)):
            raise ValueError(
                f"search.forces_n must increase strictly; got {list(self.forces_n)}. Sort the forces "
                "and remove repeats"
            )
        if len(set(self.objectives)) < len(self.objectives):
            raise ValueError(
                f"search.objectives names one twice: {list(self.objectives)}. Leave one out"
            )
        return self
