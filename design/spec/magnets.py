"""The magnets in a specification: what they are and where they sit.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal, TypeVar

from pydantic import Discriminator, Field, Tag, model_validator

from design.catalogue.magnets import GRADES, MAGNET_PARTS, MagnetShape
from design.spec.base import (
    Coordinate,
    Length,
    Offset,
    Remanence,
    SpecPart,
)

Value = TypeVar("Value", float, str)

Tilt = Annotated[float, Field(ge=-30, le=30)]


Places = Annotated[tuple[tuple[Coordinate, Coordinate], ...], Field(min_length=1)]


def _depth_of_lists(given: Any) -> str:
    """Return whether places are given for each face of its own, or one list for all."""
    try:
        return "each face" if isinstance(given[0][0], list | tuple) else "all faces"
    except (IndexError, KeyError, TypeError):
        return "all faces"


PlacesOfFaces = Annotated[
    Annotated[Places, Tag("all faces")]
    | Annotated[tuple[Places, ...], Field(min_length=1), Tag("each face")],
    Discriminator(_depth_of_lists),
]


LengthOfEach = Annotated[tuple[Length, ...], Field(min_length=1)]
Edges = tuple[Length, Length]
EdgesOfMagnets = Annotated[
    Annotated[Edges, Tag("all magnets")]
    | Annotated[tuple[Edges, ...], Field(min_length=1), Tag("each magnet")],
    Discriminator(lambda given: "each magnet" if _holds_lists(given) else "all magnets"),
]


def _holds_lists(given: Any) -> bool:
    return isinstance(given, list | tuple) and bool(given) and isinstance(given[0], list | tuple)


@dataclass(frozen=True)
class MagnetSize:
    """Outline and height (mm) of one magnet: of a disk or ring its diameters, of a block its edges."""

    shape: MagnetShape
    diameter_mm: float
    inner_diameter_mm: float
    edges_mm: tuple[float, float]
    height_mm: float

    @property
    def half_mm(self) -> tuple[float, float]:
        """Half of the outline along a block's edges; of a round one its radius twice."""
        x, y = self.edges_mm if self.shape == "block" else (self.diameter_mm, self.diameter_mm)
        return x / 2, y / 2

    @property
    def told(self) -> str:
        across = {
            "disk": f"Ø{self.diameter_mm:g}",
            "ring": f"Ø{self.diameter_mm:g}/{self.inner_diameter_mm:g}",
            "block": f"{self.edges_mm[0]:g} × {self.edges_mm[1]:g}",
        }[self.shape]
        return f"{across} × {self.height_mm:g} mm"


class MagnetSpec(SpecPart):
    """Axially magnetised bodies: one layout repeated on every sensed face, or one for each.

    `positions_mm` is a list of places (x, y), or one such list for each sensed face, all equally
    long; what else is given of each magnet holds for that of its number on every face.

    `north` says of each magnet which way its north pole points; left out, all point outward.

    `part` gives shape and dimensions (and grade) of a catalogued magnet. A ring has an
    `inner_diameter_mm`; a block has edges `size_mm` along the face's x and y. `remanence_t` is that
    at 20 °C; left out, it is the typical one of `grade`. All these are one for all magnets or one
    each, but the shape, which is one for all. Magnets demagnetise themselves, which makes the polarization
    smaller than the remanence (docs/field.md).

    Where magnets sit in the core (`arrangement`), their outer pole lies `depth_below_core_face_mm`
    below the core's face.

    `depth_mm` is the depth of the mid-plane's centre below the face, one for all magnets or one each;
    left out, magnets lie on the floor of pockets of `shell.pocket_depth_mm`. `tilt_deg` turns each
    magnet, with its pocket, about its centre by the rotation vector (about x, about y) of the
    face's frame.
    """

    part: str | tuple[str, ...] | None = None
    shape: MagnetShape = "disk"
    diameter_mm: Length | LengthOfEach = 6.0
    inner_diameter_mm: Offset | Annotated[tuple[Offset, ...], Field(min_length=1)] = 0.0
    size_mm: EdgesOfMagnets = (5.0, 5.0)
    height_mm: Length | LengthOfEach = 1.0
    grade: str | tuple[str, ...] | None = None
    remanence_t: Remanence | Annotated[tuple[Remanence, ...], Field(min_length=1)] = 1.43
    depth_below_core_face_mm: Offset = 0.0
    positions_mm: PlacesOfFaces = (
        (0.0, 0.0),
        (10.0, 10.0),
        (-10.0, 10.0),
        (-10.0, -10.0),
        (10.0, -10.0),
    )
    depth_mm: Length | tuple[Length, ...] | None = None
    tilt_deg: tuple[tuple[Tilt, Tilt], ...] = ()
    north: tuple[Literal["outward", "inward"], ...] = ()

    @property
    def lists(self) -> tuple[Places, ...]:
        """Places on each face, or one list for all faces; `design.layout.pockets.magnet_places` gives
        the faces' own."""
        each = isinstance(self.positions_mm[0][0], tuple)
        return self.positions_mm if each else (self.positions_mm,)  # pyright: ignore[reportReturnType]

    @property
    def count(self) -> int:
        """Magnets on a face."""
        return len(self.lists[0])

    @property
    def polarities(self) -> tuple[int, ...]:
        """1 for every magnet with its north outward, −1 for the others."""
        return tuple(
            1 if way == "outward" else -1 for way in self.north or ("outward",) * self.count
        )

    @property
    def depths_mm(self) -> tuple[float, ...]:
        """`depth_mm` of every magnet; empty where it is left out."""
        return () if self.depth_mm is None else self._list_for_each_magnet(self.depth_mm)

    @property
    def grades(self) -> tuple[str, ...]:
        """`grade` of every magnet; empty where it is left out."""
        return () if self.grade is None else self._list_for_each_magnet(self.grade)

    @property
    def remanences_t(self) -> tuple[float, ...]:
        """`remanence_t` of every magnet."""
        return self._list_for_each_magnet(self.remanence_t)

    @property
    def parts(self) -> tuple[str, ...]:
        """`part` of every magnet; empty where it is left out."""
        return () if self.part is None else self._list_for_each_magnet(self.part)

    @property
    def sizes(self) -> tuple[MagnetSize, ...]:
        """Outline and height of every magnet."""
        edges = self.size_mm if _holds_lists(self.size_mm) else (self.size_mm,) * self.count
        rows = zip(
            self._list_for_each_magnet(self.diameter_mm),
            self._list_for_each_magnet(self.inner_diameter_mm),
            edges,
            self._list_for_each_magnet(self.height_mm),
            strict=True,
        )
        return tuple(MagnetSize(self.shape, *row) for row in rows)  # pyright: ignore[reportArgumentType]

    @property
    def distinct_sizes(self) -> tuple[MagnetSize, ...]:
        """Every size once, in the order in which magnets first have it."""
        return tuple(dict.fromkeys(self.sizes))

    @property
    def size_numbers(self) -> tuple[int, ...]:
        """Number of every magnet's size in `distinct_sizes`."""
        distinct = self.distinct_sizes
        return tuple(distinct.index(size) for size in self.sizes)

    @property
    def numbers_by_size(self) -> tuple[tuple[int, ...], ...]:
        """Magnets of a face, counted from 0, of every one of `distinct_sizes`."""
        numbers = self.size_numbers
        return tuple(
            tuple(magnet for magnet, size_number in enumerate(numbers) if size_number == number)
            for number in range(len(self.distinct_sizes))
        )

    @property
    def kinds(self) -> tuple[str, ...]:
        """Return what distinguishes magnets: size where there are several, and grade, else remanence."""
        names = self.grades or tuple(f"{remanence_t:g} T" for remanence_t in self.remanences_t)
        if len(self.distinct_sizes) == 1:
            return names
        alike = len(set(names)) == 1
        return tuple(
            size.told if alike else f"{size.told}, {name}"
            for size, name in zip(self.sizes, names, strict=True)
        )

    @property
    def numbers_by_kind(self) -> dict[str, tuple[int, ...]]:
        """Magnets of a face, counted from 0, of every kind: each is bought by itself."""
        numbers_by_kind: dict[str, tuple[int, ...]] = {}
        for number, kind in enumerate(self.kinds):
            numbers_by_kind[kind] = (*numbers_by_kind.get(kind, ()), number)
        return numbers_by_kind

    @property
    def strengths(self) -> tuple[float, ...]:
        """Polarization of every magnet over that of one of its size and the first's remanence, with which
        it goes."""
        first = self.remanences_t[0]
        return tuple(remanence_t / first for remanence_t in self.remanences_t)

    def _list_for_each_magnet(self, given: Value | tuple[Value, ...]) -> tuple[Value, ...]:
        return given if isinstance(given, tuple) else (given,) * self.count

    @model_validator(mode="before")
    @classmethod
    def _figures_of_part_and_grade(cls, given: Any) -> Any:
        if not isinstance(given, dict):
            return given
        if given.get("part") and _names(given["part"]):
            given = {**_figures_of_parts(given["part"], given.get("remanence_t") is None), **given}
        grade = given.get("grade")
        if isinstance(grade, str):
            given = {"remanence_t": GRADES.named(grade).remanence_t, **given}
        elif isinstance(grade, list | tuple) and grade and all(isinstance(g, str) for g in grade):
            given = {"remanence_t": tuple(GRADES.named(g).remanence_t for g in grade), **given}
        return given

    @model_validator(mode="after")
    def _agrees(self) -> MagnetSpec:
        self._check_one_for_each()
        self._check_part()
        self._check_shape()
        self._check_grade()
        return self

    def _check_one_for_each(self) -> None:
        count, counts = self.count, sorted({len(places) for places in self.lists})
        if len(counts) > 1:
            raise ValueError(
                f"magnets.positions_mm must hold as many places on every face; got {counts}. Add or take "
                "out places"
            )
        sizes = ("part", "diameter_mm", "inner_diameter_mm", "size_mm", "height_mm")
        for key in ("depth_mm", "tilt_deg", "north", *sizes, "grade", "remanence_t"):
            values = getattr(self, key)
            if key == "size_mm" and not _holds_lists(values):
                continue  # the pair of all
            if isinstance(values, tuple) and len(values) not in (0, count):
                raise ValueError(
                    f"magnets.{key} needs one entry for each of the {count} magnets.positions_mm; "
                    f"got {len(values)}. Add the missing ones, or leave the key out"
                )

    def _check_part(self) -> None:
        for index, name in enumerate(self.parts):
            part, size = MAGNET_PARTS.named(name), self.sizes[index]
            figures = part.figures()
            given = {key: getattr(size, "edges_mm" if key == "size_mm" else key) for key in figures}
            if part.grade is not None and self.grades:
                figures["grade"], given["grade"] = part.grade, self.grades[index]
            for key, value in figures.items():
                if given[key] != value:
                    raise ValueError(
                        f"magnets.{key} = {given[key]!r} contradicts magnets.part = {name!r} "
                        f"({value!r}). Leave one of the two out"
                    )

    def _check_shape(self) -> None:
        hollow = self.shape == "ring"
        for size in self.distinct_sizes:
            self._check_hole(size, hollow)

    def _check_hole(self, size: MagnetSize, hollow: bool) -> None:
        if size.inner_diameter_mm >= size.diameter_mm and hollow:
            raise ValueError(
                f"magnets.inner_diameter_mm must be below magnets.diameter_mm = "
                f"{size.diameter_mm:g}; got {size.inner_diameter_mm:g}. Make the hole smaller"
            )
        if self.shape == "ring" and not size.inner_diameter_mm:
            raise ValueError(
                "magnets.shape = 'ring' needs magnets.inner_diameter_mm above 0; got 0"
            )
        if size.inner_diameter_mm and not hollow:
            raise ValueError(
                f"magnets.inner_diameter_mm = {size.inner_diameter_mm:g} belongs to a ring; "
                f"magnets.shape is {self.shape!r}. Leave it out, or choose shape = 'ring'"
            )

    def _check_grade(self) -> None:
        for name, remanence_t in zip(self.grades, self.remanences_t, strict=bool(self.grades)):
            grade = GRADES.named(name)
            if not grade.admits(remanence_t):
                raise ValueError(
                    f"magnets.remanence_t = {remanence_t:g} lies outside grade {grade.name} "
                    f"({grade.remanence_min_t:g} to {grade.remanence_max_t:g} T). Leave remanence_t out "
                    f"to take the typical {grade.remanence_t:g} T, or leave magnets.grade out"
                )


def _names(part: Any) -> bool:
    return isinstance(part, str) or (
        isinstance(part, list | tuple) and all(isinstance(name, str) for name in part)
    )


def _figures_of_parts(names: str | Sequence[str], graded: bool) -> dict[str, Any]:
    """Return what one catalogued magnet gives for all magnets, or several for one each."""
    if isinstance(names, str):
        part = MAGNET_PARTS.named(names)
        return part.figures() | ({"grade": part.grade} if graded and part.grade else {})
    parts = [MAGNET_PARTS.named(name) for name in names]
    shapes = sorted({part.shape for part in parts})
    if len(shapes) > 1:
        raise ValueError(
            f"magnets.part must name magnets of one shape; got {' and '.join(shapes)}. Choose disks, "
            "rings or blocks"
        )
    figures = {key: tuple(part.figures()[key] for part in parts) for key in parts[0].figures()}
    grades = tuple(part.grade for part in parts)
    grade_figures = {"grade": grades} if graded and all(grades) else {}
    return figures | {"shape": shapes[0]} | grade_figures
