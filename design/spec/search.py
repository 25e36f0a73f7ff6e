"""Layout search in a specification: what may change, limits, objectives.

Everything that is left out of `[search.vary]` stays as the specification has it. Lists are choices:
the mechanics of every shell (thickness, core, silicone, magnet's outline) is solved once, in
minutes, and a shell that came up before costs nothing. Ranges are continuous.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from design.spec.base import (
    Angle,
    Coordinate,
    Count,
    Distinct,
    FieldRange,
    Force,
    Length,
    Offset,
    SpecPart,
    Wall,
)
from design.spec.renamed import under_names_now

Engine = Literal["tpe", "cma-es", "nsga-ii", "nsga-iii", "random"]
Objective = Literal[
    "worst_position_bound_mm",
    "percentile_99_position_bound_mm",
    "percentile_95_position_bound_mm",
    "median_position_bound_mm",
    "position_bound_over_start",
    "worst_force_bound_n",
    "median_false_force_n",
    "percentile_95_false_force_n",
    "sensitivity_ratio",
    "edge_position_bound_mm",
    "pair_own_position_bound_mm",
    "pair_all_position_bound_mm",
    "grasp_position_bound_mm",
    "slip_place_mm",
    "tolerance_place_mm",
    "task_loss",
    "compliance_deviation",
    "cost",
    "build_minutes",
]
OBJECTIVES_TO_MAXIMIZE = ("sensitivity_ratio",)
PARETO_ENGINES = ("tpe", "nsga-ii", "nsga-iii", "random")

WantedCompliance = dict[
    Literal["everywhere", "corner", "edge", "mid_edge", "centre"],
    Annotated[float, Field(ge=1e-4, le=100)],
]
_SOFTENS = ("shell_thickness_mm", "silicone", "core_size_mm")
Range = tuple[Coordinate, Coordinate]
Some = Field(min_length=1, max_length=20)
Price = Annotated[float, Field(ge=0, le=1e6)]
"""In any currency; also minutes by hand."""


class VarySpec(SpecPart):
    """What may change; magnets, and sensors that move, have one layout for all faces, one for each size
    of face (`layouts`: half extents within 10 %), or one for each; depths, tilts, poles and grades are the
    same on all. Where there are several, names of places in trials begin with `face` and the first face that
    has them. `magnet_part` are catalogued magnets for all places, `magnet_sizes` for each by itself.

    A changed magnet keeps its pocket's clearance and the silicone above it; where thickness or core
    change, the core's inside stays and the body grows or shrinks. A changed range takes the part's
    gain and noise. `magnet_reach_mm` and `sensor_reach_mm` limit |x| and |y|, of sensors on a ring
    the radius.
    """

    layouts: Literal["one", "per size", "per face"] = "per size"
    magnet_count: Annotated[tuple[Count, ...], Some, Distinct] | None = None
    magnet_part: Annotated[tuple[str, ...], Some, Distinct] | None = None
    magnet_sizes: Annotated[tuple[str, ...], Some, Distinct] | None = None
    magnet_reach_mm: Length | None = None
    magnet_depth_mm: Range | None = None
    magnet_tilt_deg: Annotated[float, Field(gt=0, le=30)] | None = None
    magnet_north: bool = False
    magnet_grade: Annotated[tuple[str, ...], Some, Distinct] | None = None
    sensor_count: (
        Annotated[tuple[Annotated[int, Field(ge=1, le=12)], ...], Some, Distinct] | None
    ) = None
    sensor_reach_mm: Length | None = None
    sensor_chip: Annotated[tuple[Literal["inward", "outward"], ...], Some, Distinct] | None = None
    sensor_turn_deg: Annotated[tuple[Angle, ...], Some, Distinct] | None = None
    sensor_range_mt: Annotated[tuple[FieldRange, ...], Some, Distinct] | None = None
    shell_thickness_mm: Annotated[tuple[Wall, ...], Some, Distinct] | None = None
    silicone: Annotated[tuple[str, ...], Some, Distinct] | None = None
    core_size_mm: Annotated[tuple[Length, ...], Some, Distinct] | None = None

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
    """What every layout must keep, beyond what any specification must and what `check --fabrication`
    asks of layouts: `silicone.thinnest_wall_mm` round pockets, `printer.wall_mm` round recesses.

    `pocket_gap_mm` and `board_gap_mm` are what is left between the pockets of two magnets and between
    the recesses of two sensor boards, where that is more; `wiring_mm` is the length of straight wires
    from a face's sensors to its centre; `parts_per_face` counts magnets and sensors; `cost` is that of
    all faces, in the unit of the prices, `build_minutes` their time by hand. `times_start` says how many
    times the starting specification's value a score may have at most (`sensitivity_ratio`: at least);
    `places_worse` is the share of (force, contact location) whose position bound may be larger than the
    start's. At rest and in the deepest press `limits.saturation_margin` of the sensors' range stays free,
    and 95 % of virtual objects keep every chip within it.
    """

    pocket_gap_mm: Offset = 1.0
    board_gap_mm: Offset = 0.0
    wiring_mm: Annotated[float, Field(gt=0, le=1e5)] | None = None
    parts_per_face: Count | None = None
    cost: Annotated[float, Field(gt=0, le=1e6)] | None = None
    build_minutes: Annotated[float, Field(gt=0, le=1e6)] | None = None
    places_worse: Annotated[float, Field(ge=0, le=1)] = 0.02
    times_start: dict[Objective, Annotated[float, Field(gt=0, le=1e4)]] = Field(
        default_factory=dict
    )

    @field_validator("times_start", mode="before")
    @classmethod
    def _names_now(cls, given: Any) -> Any:
        return under_names_now("search.limits.times_start", given)


class PricesSpec(SpecPart):
    """Of one part, in any currency, and minutes by hand; sensors with their board.

    A magnet's pole is found and it is pressed in; a sensor gets five wires and is tested and glued.
    """

    magnet: Price = 0.2
    sensor: Price = 3.0
    magnet_minutes: Price = 2.0
    sensor_minutes: Price = 15.0

    def cost(self, magnets: int, sensors: int) -> float:
        """Of so many parts."""
        return self.magnet * magnets + self.sensor * sensors

    def build_minutes(self, magnets: int, sensors: int) -> float:
        """By hand, of so many parts."""
        return self.magnet_minutes * magnets + self.sensor_minutes * sensors


class TaskSpec(SpecPart):
    """What presses are read for: those of `from_n` and more are to be found, placed `within_mm`, and their
    force told within `force_percent` of itself. `task_loss` is the share that fails in any of these."""

    from_n: Force = 1.0
    within_mm: Annotated[float, Field(gt=0, le=100)] = 3.0
    force_percent: Annotated[float, Field(gt=0, le=100)] = 10.0


class SearchSpec(SpecPart):
    """A layout search: what may change, limits, objectives, engine and budget.

    With several objectives the result is a Pareto front; the first names the layouts that the next
    levels get. Every trial's continuous variables are improved by `polish_steps` generations of
    CMA-ES, about a hundred scorings each; `trials` that choices, `batch` and processes do not need are
    joined to fewer, of up to 600 generations each. `seconds` are those of a whole call, mechanics and
    all fidelity levels: trials end at `trials` or after 40 % of the time, whichever is first. A trial
    beyond `trial_seconds` is given up. `leaders` go to the second fidelity level (rigid magnets),
    `finalists` to the last.
    Bounds are of a `baseline` just taken, or of one that has drifted by `sensors.drift_counts` since.
    `compliance_mm_per_n` is indentation depth over force at `score.force_n` that
    `compliance_deviation` is taken from, by area (later ones over earlier ones; "edge" without
    corners); none: even.
    """

    objectives: Annotated[tuple[Objective, ...], Field(min_length=1, max_length=4)] = (
        "worst_position_bound_mm",
    )
    forces_n: Annotated[tuple[Force, ...], Field(max_length=8)] = (1.0, 3.5, 12.0)
    baseline: Literal["fresh", "drifted"] = "fresh"
    engine: Engine = "tpe"
    polish_steps: Annotated[int, Field(ge=0, le=1000)] = 300
    trials: Annotated[int, Field(ge=1, le=10_000_000)] = 60
    seconds: Annotated[float, Field(gt=0, le=1e8)] = 2700.0
    trial_seconds: Annotated[float, Field(gt=0, le=1e8)] = 900.0
    batch: Annotated[int, Field(ge=1, le=1024)] = 1
    leaders: Annotated[int, Field(ge=1, le=100_000)] = 6
    finalists: Annotated[int, Field(ge=1, le=10_000)] = 2
    magnet_symmetry: Literal["free", "mirrored", "four-fold"] = "free"
    sensor_symmetry: Literal["free", "mirrored", "ring"] = "free"
    compliance_mm_per_n: WantedCompliance = Field(default_factory=dict)
    vary: VarySpec = VarySpec()
    limits: SearchLimitsSpec = SearchLimitsSpec()
    prices: PricesSpec = PricesSpec()
    task: TaskSpec = TaskSpec()

    @property
    def named(self) -> set[str]:
        """Scores that are objectives or limited."""
        return {*self.objectives, *self.limits.times_start}

    @field_validator("objectives", mode="before")
    @classmethod
    def _names_now(cls, given: Any) -> Any:
        return under_names_now("search.objectives", given)

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
        if len(self.objectives) > 1 and self.engine not in PARETO_ENGINES:
            raise ValueError(
                f'search.engine = "{self.engine}" takes a single objective; got '
                f"{len(self.objectives)}. Choose one of {', '.join(PARETO_ENGINES)}"
            )
        if self.finalists > self.leaders:
            raise ValueError(
                f"search.finalists = {self.finalists} come from search.leaders = {self.leaders}. Give "
                "more leaders"
            )
        if "position_bound_over_start" in self.named and self.limits.places_worse == 1:
            raise ValueError(
                "position_bound_over_start leaves out the share search.limits.places_worse of the contact "
                "locations; got places_worse = 1, which leaves out all of them. Give a share below 1, "
                "such as 0.02"
            )
        self._check_symmetry()
        self._check_compliance()
        return self

    def _check_compliance(self) -> None:
        free = any(getattr(self.vary, name) is not None for name in _SOFTENS)
        if "compliance_deviation" in self.objectives and not free:
            raise ValueError(
                'search.objectives has "compliance_deviation", which the lowest fidelity level takes of the '
                f"shell without magnets: places of magnets and sensors do not change it. Free one of "
                f"{', '.join(f'search.vary.{name}' for name in _SOFTENS)}; how magnets stiffen the "
                "shell is scored at the second fidelity level, whatever the objectives"
            )

    def _check_symmetry(self) -> None:
        for part, symmetry in (("magnet", self.magnet_symmetry), ("sensor", self.sensor_symmetry)):
            if symmetry != "free" and getattr(self.vary, f"{part}_reach_mm") is None:
                raise ValueError(
                    f'search.{part}_symmetry = "{symmetry}" arranges {part}s anew and needs '
                    f'search.vary.{part}_reach_mm. Add it, or use "free"'
                )
