"""What all numbers of a specification share: limits on both sides, and none that is no number."""

import re
import typing
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError, create_model

from design.errors import SpecError
from design.spec.base import Count, Force, Length, Offset, Remanence
from design.spec.object import ObjectSpec


def parts(annotation):
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in typing.get_args(annotation):
        yield from parts(inner)


def test_every_number_has_bounds_on_both_sides():
    """A value of another unit or a slip of the keyboard lies beyond one of them."""
    open_ended = []
    for key, one in typed_numbers(ObjectSpec):
        for value in (-9e12, 9e12, 10**13):
            try:
                one(value=value)
            except SpecError:
                continue
            open_ended.append((key, value))
    assert not open_ended


def test_poses_of_the_paper_s_two_and_three_contacts_turn_into_each_other():
    """Level pairs and the same upright; triples and the same upside down."""
    collection = ObjectSpec(name="paper").collection
    dual, triple = collection.poses
    level = {*product((-6, -3, 0, 3, 6), (-10.5, 10.5), (0,)), *product((-6, 0, 6), (-1.5,), (0,))}
    assert len(dual) == 26
    assert set(dual) == level | {(y, x, 90) for x, y, _ in level}
    upward = {*product((-3, 0, 3), (-6, 0), (0,)), (0, -3, 0)}
    assert len(triple) == 14
    assert set(triple) == upward | {(-x, -y, 180) for x, y, _ in upward}


def numbers(annotation, metadata=()) -> Iterator[typing.Any]:
    """Types of the numbers that a field holds, with their own limits."""
    if annotation in (float, int):
        yield typing.Annotated[annotation, *metadata] if metadata else annotation
    elif typing.get_origin(annotation) is typing.Annotated:
        yield from numbers(annotation.__origin__, annotation.__metadata__)
    else:
        for inner in typing.get_args(annotation):
            yield from numbers(inner, metadata)


def typed_numbers(model, before=""):
    """Every key that holds numbers, with their types as its part of the specification takes them."""
    for name, field in model.model_fields.items():
        for part in parts(field.annotation):
            yield from typed_numbers(part, f"{before}{name}.")
        bounds = tuple(one for one in field.metadata if not isinstance(one, type))
        for kind in numbers(field.annotation, bounds):
            yield f"{before}{name}", create_model("One", __base__=model.__base__, value=(kind, ...))


def test_no_key_takes_a_number_that_is_none():
    found = dict(typed_numbers(ObjectSpec))
    assert len(found) > 140
    for key, one in found.items():
        for value in (float("nan"), float("inf"), -float("inf")):
            with pytest.raises(SpecError, match="value"):
                pytest.fail(f"{key} takes {one(value=value)}")


@pytest.mark.parametrize(
    ("kind", "taken", "refused"),
    [
        (Length, [1e-9, 1e3], [0, -1e-9, 1.0001e3, float("inf")]),
        (Offset, [0, 1e3], [-1e-9, 1.0001e3, float("inf")]),
        (Force, [0.001, 500], [0.0009, 501]),
        (Remanence, [0.01, 2.0], [0.009, 2.01]),
        (Count, [1, 10**5], [0, -1, 1.5, 10**5 + 1]),
    ],
)
def test_numbers_of_a_kind_end_at_its_limits(kind, taken, refused):
    adapter = TypeAdapter(kind)
    for value in taken:
        assert adapter.validate_python(value) == value
    for value in refused:
        with pytest.raises(ValidationError):
            adapter.validate_python(value)


def keys(model, above=""):
    """Every key by its dotted name, those in lists of tables too."""
    for name, field in model.model_fields.items():
        tables = list(parts(field.annotation))
        for table in tables:
            yield from keys(table, f"{above}{name}.")
        if not tables:
            yield f"{above}{name}"


MOST_KEYS = 190
"""Keys of a specification, at most: a new one takes the place of another. Lower it when one goes."""


def test_a_specification_gains_no_key():
    named = list(keys(ObjectSpec))
    assert len(named) == len(set(named))
    assert len(named) <= MOST_KEYS


ROOT = Path(__file__).parents[3]
PAGES = [*ROOT.glob("docs/*.md"), *ROOT.glob("docs/reference/*.md")]
EXAMPLES = [path for path in ROOT.glob("examples/**/*.toml") if path.stem != "paper_cube"]


def test_every_key_is_named_on_a_page_or_set_in_an_example_beside_the_template():
    """Names are dotted or the last part as code; in a file a line sets the key."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in [*PAGES, *EXAMPLES])
    unknown = []
    for key in keys(ObjectSpec):
        last = key.rpartition(".")[2]
        written = rf"\b{re.escape(key)}\b|`{last}`|(?:^|[{{,]) *{last} = "
        if not re.search(written, text, re.MULTILINE):
            unknown.append(key)
    assert not unknown
