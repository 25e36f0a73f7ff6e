"""Robustness budget as a result: the effect of each tolerance, and its file."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from design.files import atomic_path
from estimator.tolerances.saturation import Saturation

SEAT_ERROR = (
    "Presses are not simulated anew. A magnet that sits aside is moved as if the press lay as far "
    "aside the other way: what its seat does to a press's signal is then wrong by 30 % (median over "
    "places; by 73 % if it kept its motion). One that sits too deep keeps its motion: the size of "
    "what its seat does is right in the median, but wrong by up to a factor of three at single "
    "places. Measured on a cube of 42 mm with a shell of 8 mm against finite elements with point "
    "magnets at either seat."
)
REACH_SHARE = 0.7
"""Share of a location's deepest press, where the force asked for is more: leaves room for softer silicone."""
_RANGES = ("position_median_mm", "position_worst_mm", "force_median_n", "force_worst_n")


@dataclass(frozen=True)
class Spread:
    """Standard deviations that one contribution, or all, cause; medians and worst over places.

    Attributes
    ----------
    baseline_counts, baseline_worst_counts : of channels at rest: rms and the worst
    signal, signal_worst : of the change in a press, √Σσ² over the face's channels over its size
    position_bound, position_bound_worst : of the Cramér–Rao position bound, relative
    force_bound, force_bound_worst : of the force bound, relative
    false_place_mm, false_place_worst_mm : place error (rms) of an estimator calibrated on the design
    false_force_n, false_force_worst_n : its force error (rms)
    """

    name: str
    baseline_counts: float
    baseline_worst_counts: float
    signal: float
    signal_worst: float
    position_bound: float
    position_bound_worst: float
    force_bound: float
    force_bound_worst: float
    false_place_mm: float
    false_place_worst_mm: float
    false_force_n: float
    false_force_worst_n: float


@dataclass(frozen=True)
class BoundRange:
    """A bound over the toleranced objects: that of the design, and 5 to 95 % of objects."""

    design: float
    low: float
    high: float


@dataclass(frozen=True)
class Robustness:
    """A specification's robustness budget.

    `contributions` are each alone, to first order, in the order of their shares in the variances of
    false place and false force. `together` is their root sum of squares, `monte_carlo` all at once
    by `draws` objects. Bounds (mm, N) are freshly zeroed ones: that of the median place and that of
    the worst. `reduced_places` locations are judged at less than `force_n` (`REACH_SHARE`); locations that
    never reach it are left out. `saturation` is how many of as many objects leave the range of a chip.
    """

    contributions: tuple[Spread, ...]
    together: Spread
    monte_carlo: Spread
    draws: int
    force_n: float
    reduced_places: int
    position_median_mm: BoundRange
    position_worst_mm: BoundRange
    force_median_n: BoundRange
    force_worst_n: BoundRange
    saturation: Saturation


def save_robustness(budget: Robustness, path: Path | str) -> None:
    """Write the budget as JSON."""
    with atomic_path(path) as temporary:
        temporary.write_text(json.dumps(asdict(budget), indent=1) + "\n", encoding="utf-8")


def load_robustness(path: Path | str) -> Robustness:
    """Read what `save_robustness` wrote."""
    content = json.loads(Path(path).read_text(encoding="utf-8"))
    ranges = {name: BoundRange(**content.pop(name)) for name in _RANGES}
    rows = tuple(Spread(**row) for row in content.pop("contributions"))
    whole = {name: Spread(**content.pop(name)) for name in ("together", "monte_carlo")}
    lists = content.pop("saturation")
    saturated = Saturation(lists.pop("objects"), **{name: tuple(v) for name, v in lists.items()})
    return Robustness(contributions=rows, saturation=saturated, **whole, **ranges, **content)
