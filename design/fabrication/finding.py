"""Finding of a fabrication check: a value against its limit, at a place, with advice."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

Status = Literal["pass", "warn", "fail"]
Place = tuple[float, float, float]


@dataclass(frozen=True)
class Finding:
    """One check of one part; `place_mm` is in the part's own frame, None where it has none.

    `what` says what was measured and, where it did not pass, how to fix it.
    """

    check: str
    part: str
    value: float
    limit: float
    unit: str
    status: Status
    what: str
    place_mm: Place | None = None

    @property
    def told(self) -> str:
        """In a line."""
        return f"{self.part}, {self.check}: {self.value:.3g} {self.unit}, limit {self.limit:.3g}"

    @classmethod
    def from_dict(cls, given: dict[str, Any]) -> Finding:
        """Return the finding that `dataclasses.asdict` gave, also from JSON, where its place is a list."""
        place = given["place_mm"]
        values: dict[str, Any] = given | {"place_mm": None if place is None else place_of(place)}
        return cls(**values)


def status_above(value: float, limit: float, warn_factor: float = 1.0) -> Status:
    """Fails below the limit, or where the value is not known (NaN); warns below the limit times the factor.

    Figures within 1e-6 of a limit meet it: they come from floating-point geometry.
    """
    if not value >= limit - 1e-6:
        return "fail"
    return "warn" if value < warn_factor * limit - 1e-6 else "pass"


def worst(findings: list[Finding]) -> Status:
    """The worst status among findings; pass where there are none."""
    statuses = {finding.status for finding in findings}
    return "fail" if "fail" in statuses else "warn" if "warn" in statuses else "pass"


def place_of(point: Any) -> Place:
    """Any three numbers as a place."""
    x, y, z = (round(float(v), 4) for v in point)
    return (x, y, z)
