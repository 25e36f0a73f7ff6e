"""Types that the parts of a specification share."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache
from math import inf
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, Union, get_args, get_origin

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    ValidationError,
    field_validator,
)
from pydantic_core import PydanticCustomError

from design.errors import SpecError
from design.spec.removed import REMOVED

# Bounds of what is plausible: beyond them lies a slip of the keyboard or another unit.
Length = Annotated[float, Field(gt=0, le=1000)]
"""mm; a body is 1 m long at most."""
Offset = Annotated[float, Field(ge=0, le=1000)]
"""mm; 0 leaves it out."""
Coordinate = Annotated[float, Field(ge=-1000, le=1000)]
"""mm."""
Wall = Annotated[float, Field(ge=0.3, le=200)]
"""mm, of the shell or the core."""
Angle = Annotated[float, Field(ge=-720, le=720)]
"""Degrees, two turns at most."""
Component = Annotated[float, Field(ge=-1e4, le=1e4)]
"""Component of a direction of any length."""
Force = Annotated[float, Field(ge=0.001, le=500)]
"""N; 500 N is more than a hand presses with."""
Remanence = Annotated[float, Field(ge=0.01, le=2.0)]
"""T; the strongest magnets that are sold have 1.55."""
FieldRange = Annotated[float, Field(ge=0.01, le=3000)]
"""mT; of a Hall sensor."""
Counts = Annotated[float, Field(ge=0, le=1e6)]
"""Offsets of a channel."""
Density = Annotated[float, Field(ge=0.005, le=20)]
"""g/cm³; from foams to metals."""
Count = Annotated[int, Field(ge=1, le=100_000)]


def _distinct(given: tuple[Any, ...]) -> tuple[Any, ...]:
    repeated = sorted({str(name) for name in given if given.count(name) > 1})
    if repeated:
        message = "names {twice} twice. Name each once"
        raise PydanticCustomError("repeated", message, {"twice": ", ".join(repeated)})
    return given


Distinct = AfterValidator(_distinct)
"""Refuses a list that names something twice."""


_SHOULD_BE = "Input should be "
_WORDS = {
    "a valid tuple": "a list in brackets",
    "a valid number, unable to parse string as a number": "a number alone (the key names its unit)",
    "a valid integer, unable to parse string as an integer": "a whole number",
}
"""pydantic's words, and plainer ones."""
_UNITS = {
    "mpa": ("MPa", {"kPa": 1e-3, "Pa": 1e-6}),
    "n": ("N", {"mN": 1e-3, "gf": 9.80665e-3}),
    "t": ("T", {"kG": 0.1, "mT": 1e-3, "G": 1e-4}),
    "mm": ("mm", {"µm": 1e-3, "m": 1e3, "cm": 10.0}),
    "mt": ("mT", {"µT": 1e-3, "T": 1e3}),
    "cm3": ("g/cm³", {"kg/m³": 1e-3}),
    "relative": ("", {"percent": 1e-2}),
    "tolerance": ("", {"percent": 1e-2}),
}
"""Units by the end of a key: its unit, and others in its unit that values are often given in."""
_BOUNDS = {
    "gt": "greater than",
    "ge": "greater than or equal to",
    "lt": "less than",
    "le": "less than or equal to",
}
"""pydantic's names of bounds and its words, the lower ones first."""
_OTHER_KIND = ("_type", "_parsing", "literal_error", "int_from_float")
"""Ends of pydantic's types of errors of a value that is not of the kind at all."""

Part = TypeVar("Part", bound="SpecPart")  # not Self, which the tests' type checks refuse


class SpecPart(BaseModel):
    """Frozen; unknown keys are refused, and numbers that are none (NaN) or infinite in any key."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @field_validator("*", mode="before")
    @classmethod
    def _booleans_are_no_numbers(cls, given: Any, info: Any) -> Any:
        takes_booleans, switch, by_name = _booleans_of(cls, info.field_name)
        named = by_name and isinstance(given, dict)
        if not takes_booleans and _holds_a_boolean(list(given.values()) if named else given):
            raise PydanticCustomError("boolean", "true and false are no values of this key")
        if switch and not isinstance(given, bool | NoneType):
            raise PydanticCustomError("no_boolean", "write true or false")
        return given

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
        """Copy as pydantic does, but what is updated is validated (`changed`)."""
        if update:
            return self.changed(**update)
        return super().model_copy(deep=deep)  # pyright: ignore[reportReturnType]


def complaints(error: ValidationError, model: type[BaseModel]) -> list[str]:
    """pydantic's errors about a model in words: where, what is wrong, what was received.

    Without those of a list that is too short because its entries are wrong, and, where a key takes values
    of several kinds, without those of kinds that the value is not.
    """
    all_problems = _keep_fitting_kinds(error.errors(), model)
    within = {
        problem["loc"][:length] for problem in all_problems for length in range(len(problem["loc"]))
    }
    return [_complaint(problem, model) for problem in all_problems if problem["loc"] not in within]


def _keep_fitting_kinds(problems: list[Any], model: type[BaseModel]) -> list[Any]:
    """Keep the problems of kinds that a value is: of a key that takes several, pydantic reports each; where
    the value is none of them, they are reported together."""
    by_key: dict[tuple[Any, ...], list[Any]] = {}
    for problem in problems:
        kind = _place_of_kind(problem["loc"], model)
        key = problem["loc"] if kind is None else problem["loc"][:kind]
        rest = () if kind is None else problem["loc"][kind + 1 :]
        is_other_kind = kind is not None and not rest and problem["type"].endswith(_OTHER_KIND)
        by_key.setdefault(key, []).append((is_other_kind, problem | {"loc": (*key, *rest)}))
    fitting_problems = []
    for tried in by_key.values():
        fitting = [problem for is_other_kind, problem in tried if not is_other_kind]
        fitting_problems += fitting or [
            tried[0][1] | {"msg": _any_of([problem["msg"] for _, problem in tried])}
        ]
    return fitting_problems


def _any_of(messages: list[str]) -> str:
    wanted = [message.removeprefix(_SHOULD_BE).split(", ")[0] for message in messages]
    return f"{_SHOULD_BE}{' or '.join(wanted)}" if len(messages) > 1 else messages[0]


def _place_of_kind(location: tuple[Any, ...], model: type[BaseModel]) -> int | None:
    """Return where in the location pydantic names the kind that it tried, as it does in keys of several
    kinds; None where the kind is found first and named by us, with a space ("each face")."""
    annotation: Any = model
    for place, part in enumerate(location):
        kinds = _kinds(annotation)
        if len(kinds) > 1:
            ours = " " in str(part) and "[" not in str(part)
            return None if ours else place
        annotation = _inside(kinds[0], part)
    return None


@cache
def _booleans_of(part: type[BaseModel], key: str) -> tuple[bool, bool, bool]:
    """Return whether a key takes booleans, takes nothing else, and takes values by name."""
    annotation = part.model_fields[key].annotation
    kinds = _kinds(annotation)
    by_name = any(get_origin(kind) is dict for kind in kinds)
    return _takes_booleans(annotation), kinds == [bool], by_name


def _takes_booleans(annotation: Any) -> bool:
    return annotation is bool or any(map(_takes_booleans, get_args(annotation)))


def _holds_a_boolean(given: Any) -> bool:
    """Return whether one stands in a value or list; a table among these is looked at as a part of its own."""
    if isinstance(given, list | tuple):
        return any(map(_holds_a_boolean, given))
    return isinstance(given, bool)


def _kinds(annotation: Any) -> list[Any]:
    if get_origin(annotation) is Annotated:
        return _kinds(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return [
            kind
            for argument in get_args(annotation)
            for kind in _kinds(argument)
            if kind is not NoneType
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
    key = ".".join(part for part in where.split(".") if not part.isdigit())
    if unknown and key in REMOVED:
        return f"{key} was removed: {REMOVED[key]}. Leave it out"
    if unknown:
        return f"{where} is not a key. {_nearest_key(problem['loc'], model)}"
    if problem["type"] == "string_pattern_mismatch":
        message = "letters, digits, _ . - alone, a letter or digit first; no blanks, no umlauts"
    if removed := REMOVED.get(f"{key} = {problem.get('input')}"):
        return f"{key} = {problem['input']!r} was removed: {removed}"
    for word, plain in _WORDS.items():
        message = message.replace(word, plain)
    bounds = _bounds(problem, model)
    if len(bounds) > 1:
        message = _SHOULD_BE + " and ".join(
            f"{_BOUNDS[kind]} {bounds[kind]:.10g}" for kind in bounds
        )
    received = "" if isinstance(problem.get("input"), dict) else f"; got {_shown(problem)}"
    return f"{where}: {message}{received}{_proposal(problem, bounds)}"


def _shown(problem: Any) -> str:
    """Return what was received, cut where it is long."""
    text = repr(problem.get("input"))
    return text if len(text) <= 80 else f"{text[:60]}…"


def _bounds(problem: Any, model: type[BaseModel]) -> dict[str, float]:
    """Return both bounds of a number that lies beyond one of them, the lower first; {} of all else."""
    broken = {kind: bound for kind, bound in problem.get("ctx", {}).items() if kind in _BOUNDS}
    kinds, metadata = [model], []
    for part in problem["loc"] if broken else ():
        fields = [
            kind.model_fields[part]
            for kind in kinds
            if isinstance(kind, type) and issubclass(kind, BaseModel) and part in kind.model_fields
        ]
        metadata += [list(field.metadata) for field in fields]
        kinds = [
            inner for field in fields for inner in _nested(field.annotation, metadata)
        ] or kinds
    for constraints in metadata:
        all_bounds = {
            kind: float(getattr(constraint, kind))
            for kind in _BOUNDS
            for constraint in constraints
            if getattr(constraint, kind, None) is not None
        }
        if broken.items() <= all_bounds.items():
            return all_bounds
    return {kind: float(bound) for kind, bound in broken.items()}


def _nested(annotation: Any, metadata: list[list[Any]]) -> list[Any]:
    """Return all that an annotation is made of, and collect the constraints of its parts."""
    if get_origin(annotation) is Annotated:
        inner, *given = get_args(annotation)
        metadata.append(
            [constraint for each in given for constraint in getattr(each, "metadata", [each])]
        )
        return _nested(inner, metadata)
    return [
        annotation,
        *(kind for constraint in get_args(annotation) for kind in _nested(constraint, metadata)),
    ]


def _proposal(problem: Any, bounds: dict[str, float]) -> str:
    """Proposes brackets, or the unit in which a value beyond a bound would lie within both."""
    key = next((part for part in reversed(problem["loc"]) if isinstance(part, str)), "")
    unit, others = _UNITS.get(key.rsplit("_", 1)[-1], ("", {}))
    value = problem.get("input")
    low, high = bounds.get("ge", bounds.get("gt", -inf)), bounds.get("le", bounds.get("lt", inf))
    if problem["type"] == "tuple_type" and isinstance(value, str) and "," in value:
        return f". Write it as [{', '.join(part.strip() for part in value.split(','))}]"
    if not isinstance(value, int | float) or not (bounds and value > 0):
        return ""
    for other_unit, factor in others.items():
        changed = factor * value
        # a value that is too large is taken for one in a smaller unit, and the other way round
        if (factor < 1) == (value >= high) and low <= changed <= high:
            return f". In {other_unit} it would be {f'{changed:g} {unit}'.strip()}"
    return ""


def _nearest_key(location: tuple[Any, ...], model: type[BaseModel]) -> str:
    keys = sorted(_known_keys(location[:-1], model))
    name = str(location[-1])
    close = difflib.get_close_matches(name, keys, n=1, cutoff=0.6)
    stem = name.rsplit("_", 1)[0]
    close = close or [key for key in keys if key.rsplit("_", 1)[0] == stem]
    close = close or sorted(_keys_named(name, model), key=len)
    return f"Did you mean {close[0]!r}?" if close else f"Known keys: {', '.join(keys)}"


def _keys_named(name: str, model: Any) -> list[str]:
    """Dotted keys of that very name in any table of a model."""
    dotted_keys = []
    for key, field in model.model_fields.items():
        for kind in _kinds(field.annotation):
            kind = get_args(kind)[0] if get_origin(kind) is tuple else kind
            if isinstance(kind, type) and issubclass(kind, BaseModel):
                dotted_keys += [
                    f"{key}.{inner}"
                    for inner in (name, *_keys_named(name, kind))
                    if inner != name or name in kind.model_fields
                ]
    return dotted_keys


def _known_keys(location: tuple[Any, ...], model: type[BaseModel]) -> set[str]:
    for part in location:
        if isinstance(part, str):  # a number counts the entries of a list of tables
            annotation = model.model_fields[part].annotation
            kinds = (annotation, *get_args(annotation))
            model = next(t for t in kinds if isinstance(t, type) and issubclass(t, BaseModel))
    return set(model.model_fields)
