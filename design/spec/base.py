"""Types that the parts of a specification share."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, Union, get_args, get_origin

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


_SHOULD_BE = "Input should be "
_OTHER_KIND = ("_type", "_parsing", "literal_error", "int_from_float")
"""Ends of pydantic's types of errors of a value that is not of the kind at all."""

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

    Without those of a list that is too short because its entries are wrong, and, where a key takes values
    of several kinds, without those of kinds that the value is not.
    """
    every = _of_fitting_kinds(error.errors(), model)
    within = {problem["loc"][:length] for problem in every for length in range(len(problem["loc"]))}
    return [_complaint(problem, model) for problem in every if problem["loc"] not in within]


def _of_fitting_kinds(problems: list[Any], model: type[BaseModel]) -> list[Any]:
    """Of a key that takes several kinds pydantic tells what is wrong with each: the kinds that the value
    is not are left out, or, where it is none of them, told together."""
    found: dict[tuple[Any, ...], list[Any]] = {}
    for problem in problems:
        kind = _place_of_kind(problem["loc"], model)
        key = problem["loc"] if kind is None else problem["loc"][:kind]
        rest = () if kind is None else problem["loc"][kind + 1 :]
        other = kind is not None and not rest and problem["type"].endswith(_OTHER_KIND)
        found.setdefault(key, []).append((other, problem | {"loc": (*key, *rest)}))
    told = []
    for tried in found.values():
        fitting = [problem for other, problem in tried if not other]
        told += fitting or [
            tried[0][1] | {"msg": _any_of([problem["msg"] for _, problem in tried])}
        ]
    return told


def _any_of(messages: list[str]) -> str:
    wanted = [message.removeprefix(_SHOULD_BE).split(", ")[0] for message in messages]
    return f"{_SHOULD_BE}{' or '.join(wanted)}" if len(messages) > 1 else messages[0]


def _place_of_kind(location: tuple[Any, ...], model: type[BaseModel]) -> int | None:
    """Where in the location pydantic names the kind that it tried, as it does in keys of several kinds;
    None where the kind is found first and named by us, with a space ("each face")."""
    annotation: Any = model
    for place, part in enumerate(location):
        kinds = _kinds(annotation)
        if len(kinds) > 1:
            ours = " " in str(part) and "[" not in str(part)
            return None if ours else place
        annotation = _inside(kinds[0], part)
    return None


def _kinds(annotation: Any) -> list[Any]:
    if get_origin(annotation) is Annotated:
        return _kinds(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return [
            kind for one in get_args(annotation) for kind in _kinds(one) if kind is not NoneType
        ]
    return [annotation]


def _inside(kind: Any, part: Any) -> Any:
    """Annotation of what lies at a part of a location; None where that is not known."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return kind.model_fields[part].annotation if part in kind.model_fields else None
    inner = get_args(kind)
    if get_origin(kind) is dict:
        return inner[1]
    if get_origin(kind) is tuple and isinstance(part, int) and inner[-1] is not Ellipsis:
        return inner[part] if part < len(inner) else None
    return inner[0] if inner else None


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
