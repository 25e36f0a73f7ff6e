"""Types that the parts of a specification share."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from design.errors import SpecError

LARGEST = 1e8
"""Of any number: larger ones are slips of the keyboard, and overflow when they are multiplied."""
Positive = Annotated[float, Field(gt=0, le=LARGEST, allow_inf_nan=False)]
NonNegative = Annotated[float, Field(ge=0, le=LARGEST, allow_inf_nan=False)]
Finite = Annotated[float, Field(ge=-LARGEST, le=LARGEST, allow_inf_nan=False)]
RecoilPermeability = Annotated[float, Field(ge=1, le=2)]
"""Relative; 1 takes a magnet's remanence as its polarization."""
Count = Annotated[int, Field(ge=1)]


Part = TypeVar("Part", bound="SpecPart")  # not Self, which the tests' type checks refuse


class SpecPart(BaseModel):
    """Frozen; unknown keys are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    def changed(self: Part, **fields: Any) -> Part:
        """A copy with other values of these fields, validated together with all that stay.

        Figures that were once taken from a part or preset stay as they are. Whether everything
        still fits together is asked of `design.spec_io.check`.

        Raises
        ------
        SpecError
            There is no such field, or the values break a rule.
        """
        try:
            # not dict(self), which calls a field named `keys`
            validated = self.model_validate(self.__dict__ | fields)
        except ValidationError as error:
            raise SpecError("\n".join(map(explained, problems_of(error)))) from None
        return super().model_copy(update={name: getattr(validated, name) for name in fields})

    def model_copy(
        self: Part, *, update: Mapping[str, Any] | None = None, deep: bool = False
    ) -> Part:
        """As pydantic's, but what is updated is validated (`changed`)."""
        if update:
            return self.changed(**update)
        return super().model_copy(deep=deep)  # pyright: ignore[reportReturnType]


def problems_of(error: ValidationError) -> list[Any]:
    """pydantic's errors, without those of a list that is too short because its entries are wrong."""
    every = error.errors()
    within = {problem["loc"][:length] for problem in every for length in range(len(problem["loc"]))}
    return [problem for problem in every if problem["loc"] not in within]


def explained(problem: Any) -> str:
    """One of pydantic's errors in words: where, what is wrong, what was received."""
    where = ".".join(str(part) for part in problem["loc"])
    message = problem["msg"].removeprefix("Value error, ")
    if problem["type"] == "value_error":
        return message
    if problem["type"] == "missing":
        return f"{where} is missing. Add it"
    received = "" if isinstance(problem.get("input"), dict) else f"; got {problem.get('input')!r}"
    return f"{where}: {message}{received}"
