"""Types that the parts of a specification share."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, get_args

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from design.errors import SpecError

LARGEST = 1e8
"""Of any number: larger ones are slips of the keyboard, and overflow when they are multiplied."""
Positive = Annotated[float, Field(gt=0, le=LARGEST)]
NonNegative = Annotated[float, Field(ge=0, le=LARGEST)]
Finite = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
RecoilPermeability = Annotated[float, Field(ge=1, le=2)]
"""Relative; 1 takes a magnet's remanence as its polarization."""
Count = Annotated[int, Field(ge=1)]


Part = TypeVar("Part", bound="SpecPart")  # not Self, which the tests' type checks refuse


class SpecPart(BaseModel):
    """Frozen; unknown keys are refused, and numbers that are none (NaN) or infinite in any key."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    if (
        not TYPE_CHECKING
    ):  # the fields that pydantic makes of the annotations stay known to checkers

        def __init__(self, /, **fields: Any) -> None:
            try:
                super().__init__(**fields)
            except ValidationError as error:
                raise SpecError("\n".join(complaints(error, type(self)))) from None

        __init__.__pydantic_base_init__ = True  # else validators would call it for parts of a whole

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
            raise SpecError("\n".join(complaints(error, type(self)))) from None
        return super().model_copy(update={name: getattr(validated, name) for name in fields})

    def model_copy(
        self: Part, *, update: Mapping[str, Any] | None = None, deep: bool = False
    ) -> Part:
        """As pydantic's, but what is updated is validated (`changed`)."""
        if update:
            return self.changed(**update)
        return super().model_copy(deep=deep)  # pyright: ignore[reportReturnType]


def complaints(error: ValidationError, model: type[BaseModel]) -> list[str]:
    """pydantic's errors about a model in words: where, what is wrong, what was received.

    Without those of a list that is too short because its entries are wrong.
    """
    every = error.errors()
    within = {problem["loc"][:length] for problem in every for length in range(len(problem["loc"]))}
    return [_complaint(problem, model) for problem in every if problem["loc"] not in within]


def _complaint(problem: Any, model: type[BaseModel]) -> str:
    unknown = problem["type"] == "extra_forbidden"
    # pydantic names the variant of a key too: those have a space, as only an unknown key may
    where = ".".join(part for part in map(str, problem["loc"]) if unknown or " " not in part)
    message = problem["msg"].removeprefix("Value error, ")
    if problem["type"] == "value_error":
        return message
    if problem["type"] == "missing":
        return f"{where} is missing. Add it"
    if problem["type"] == "extra_forbidden":
        return f"{where} is not a key. {_nearest_key(problem['loc'], model)}"
    received = "" if isinstance(problem.get("input"), dict) else f"; got {problem.get('input')!r}"
    return f"{where}: {message}{received}"


def _nearest_key(location: tuple[Any, ...], model: type[BaseModel]) -> str:
    known = sorted(_known_keys(location[:-1], model))
    name = str(location[-1])
    close = difflib.get_close_matches(name, known, n=1, cutoff=0.6)
    stem = name.rsplit("_", 1)[0]
    close = close or [key for key in known if key.rsplit("_", 1)[0] == stem]
    return f"Did you mean {close[0]!r}?" if close else f"Known keys: {', '.join(known)}"


def _known_keys(location: tuple[Any, ...], model: type[BaseModel]) -> set[str]:
    for part in location:
        if isinstance(part, str):  # a number counts the entries of a list of tables
            annotation = model.model_fields[part].annotation
            kinds = (annotation, *get_args(annotation))
            model = next(t for t in kinds if isinstance(t, type) and issubclass(t, BaseModel))
    return set(model.model_fields)
