"""Study files: which specifications a sweep takes through the chain."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import prod
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, ValidationError, model_validator

from design.errors import InputError, SpecError
from design.files import require_regular_file
from design.spec.base import Count, SpecPart, complaints
from design.spec.object import ObjectSpec
from design.spec_io import load_spec

MOST_VARIANTS = 10_000
SweptStage = Literal["scores", "metrics", "frames"]
End = Annotated[float, Field(ge=-1e8, le=1e8)]
"""End of a range of any key."""
Value = int | float | str | bool | list[Any]
_NAME = r"^[A-Za-z0-9][A-Za-z0-9_.-]*$"


class LatinHypercubeSpec(SpecPart):
    """`count` points of a Latin hypercube over ranges of numbers; the seed makes it repeatable."""

    count: Count
    ranges: Annotated[dict[str, tuple[End, End]], Field(min_length=1)]
    seed: Annotated[int, Field(ge=0)] = 1

    @model_validator(mode="after")
    def _ranges_rise(self) -> LatinHypercubeSpec:
        for key, (low, high) in self.ranges.items():
            if low >= high:
                raise ValueError(
                    f"latin_hypercube.ranges: {key} must rise; got {low:g} to {high:g}"
                )
        return self


class StudySpec(SpecPart):
    """A sweep as its file has it.

    Either one `specification` with a `grid` (every combination) or a `latin_hypercube`, or `files`.
    `set` changes keys of every specification, `stages` are what each is taken to: bounds, trained
    estimators on held-out presses, simulated presses. Paths are relative to the study's file.
    """

    name: Annotated[str, Field(pattern=_NAME, max_length=80)]
    specification: str | None = None
    files: tuple[str, ...] = ()
    stages: Annotated[tuple[SweptStage, ...], Field(min_length=1)] = ("scores",)
    set: dict[str, Value] = Field(default_factory=dict)
    grid: dict[str, Annotated[list[Value], Field(min_length=1)]] = Field(default_factory=dict)
    latin_hypercube: LatinHypercubeSpec | None = None

    @model_validator(mode="after")
    def _says_one_thing(self) -> StudySpec:
        if (self.specification is None) == (not self.files):
            raise ValueError("give either specification, with a grid or latin_hypercube, or files")
        given = bool(self.files) + bool(self.grid) + (self.latin_hypercube is not None)
        if given != 1:
            raise ValueError("give exactly one of files, grid and latin_hypercube")
        if self.count > MOST_VARIANTS:
            raise ValueError(f"it has {self.count} specifications; {MOST_VARIANTS} at most")
        return self

    @property
    def count(self) -> int:
        """Specifications of the study."""
        if self.latin_hypercube:
            return self.latin_hypercube.count
        return len(self.files) or prod(map(len, self.grid.values()))


@dataclass(frozen=True)
class Variant:
    """One specification of a sweep: what was changed, and the object or why there is none."""

    label: str
    changes: dict[str, Value]
    spec: ObjectSpec | None
    refused: str = ""


@dataclass(frozen=True)
class Study:
    """A study's name, what its specifications are taken to, and these."""

    name: str
    stages: tuple[SweptStage, ...]
    variants: tuple[Variant, ...]

    @property
    def keys(self) -> tuple[str, ...]:
        """Those that the study changes."""
        return tuple({key: None for variant in self.variants for key in variant.changes})


def load_study(path: Path) -> Study:
    """Read a study and every specification of it; specifications that do not fit together say why.

    Raises
    ------
    SpecError
        The study cannot be read, or not one of its specifications can.
    """
    require_regular_file(path, f"no study at {path}. docs/sweeps.md shows one")
    try:
        study_spec = StudySpec.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise SpecError(f"{path} is not TOML ({error}). Fix it") from None
    except ValidationError as error:
        said = "\n".join(f"- {complaint}" for complaint in complaints(error, StudySpec))
        raise SpecError(f"{path} is not a valid study:\n{said}") from None
    variants = tuple(
        _variant(label, path.parent / file, study_spec.set | changes, changes)
        for label, file, changes in _changes(study_spec)
    )
    if all(variant.spec is None for variant in variants):
        raise SpecError(f"{path}: no specification can be made: {variants[0].refused}")
    return Study(study_spec.name, tuple(dict.fromkeys(study_spec.stages)), variants)


def _changes(study: StudySpec) -> Iterator[tuple[str, str, dict[str, Value]]]:
    """Label, file and changes of every specification."""
    if study.files:
        yield from ((Path(file).stem, file, {}) for file in study.files)
        return
    points = _grid(study.grid) if study.grid else _latin_hypercube(study.latin_hypercube)
    width = len(str(study.count))
    for number, changes in enumerate(points, start=1):
        yield f"{study.name}_{number:0{width}d}", str(study.specification), changes


def _grid(grid: dict[str, list[Value]]) -> Iterator[dict[str, Value]]:
    for values in product(*grid.values()):
        yield dict(zip(grid, values, strict=True))


def _latin_hypercube(wanted: LatinHypercubeSpec | None) -> Iterator[dict[str, Value]]:
    from scipy.stats import qmc

    assert wanted is not None
    low, high = np.array(list(wanted.ranges.values())).T
    unit = qmc.LatinHypercube(len(low), rng=np.random.default_rng(wanted.seed)).random(wanted.count)
    for point in low + unit * (high - low):
        yield dict(zip(wanted.ranges, (float(f"{value:.6g}") for value in point), strict=True))


def _variant(
    label: str, file: Path, changes: dict[str, Value], varied: dict[str, Value]
) -> Variant:
    # A list of JSON-able values is TOML as well.
    overrides = [f"{key}={json.dumps(value)}" for key, value in changes.items()]
    try:
        spec = load_spec(file, overrides)
    except InputError as error:
        return Variant(label, varied, None, str(error))
    return Variant(label, varied, spec.changed(name=label))
