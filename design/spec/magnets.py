"""The magnets in a specification: what they are, where they sit, and how coils are switched.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from math import pi
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from design.catalogue.magnets import (
    NDFEB_RECOIL_PERMEABILITY,
    REFERENCE_TEMPERATURE_C,
    MagnetShape,
    magnet_grade,
    magnet_part,
    remanence_at_temperature_t,
)
from design.spec.base import Finite, NonNegative, Positive, RecoilPermeability, SpecPart

MU0_T_MM_PER_A = 4e-4 * pi
"""Permeability of vacuum, T·mm/A."""

Tilt = Annotated[float, Field(ge=-30, le=30)]


Places = Annotated[tuple[tuple[Finite, Finite], ...], Field(min_length=1)]


def _depth_of_lists(given: Any) -> str:
    """Whether places are given for each face of its own, or one list for all."""
    try:
        return "each face" if isinstance(given[0][0], list | tuple) else "all faces"
    except (IndexError, KeyError, TypeError):
        return "all faces"


PlacesOfFaces = Annotated[
    Annotated[Places, Tag("all faces")]
    | Annotated[tuple[Places, ...], Field(min_length=1), Tag("each face")],
    Discriminator(_depth_of_lists),
]


class MagnetSpec(SpecPart):
    """Axially magnetised bodies: one layout repeated on every sensed face, or one for each.

    `positions_mm` is a list of places (x, y), or one such list for each sensed face, all equally
    long; what else is given of each magnet holds for that of its number on every face.

    `north` says of each magnet which way its north pole points; left out, all point outward.

    `part` gives shape and dimensions (and grade) of a catalogued magnet. A ring has an
    `inner_diameter_mm`; a block has edges `size_mm` along the face's x and y. `remanence_t` is that
    at 20 °C; left out, it is the typical one of `grade`. `recoil_permeability` makes the polarization
    smaller than the remanence (docs/field.md); 1 takes the two as equal.

    `kind = "coil"` puts air-core coils of the same outline in the magnets' place, wound from the
    inner to the outer diameter with `turns` of `current_a`; only they can be switched on face by
    face, each face while its own sensors are read. Where magnets sit in the core (`arrangement`),
    their outer pole lies `depth_below_core_face_mm` below the core's face.

    `depth_mm` is that of the mid-plane's centre below the face, one for all magnets or one each;
    left out, magnets lie on the floor of pockets of `shell.pocket_depth_mm`. `tilt_deg` turns each
    magnet, with its pocket, about its centre by the rotation vector (about x, about y) of the
    face's frame.
    """

    part: str | None = None
    kind: Literal["permanent", "coil"] = "permanent"
    shape: MagnetShape = "disk"
    diameter_mm: Positive = 6.0
    inner_diameter_mm: NonNegative = 0.0
    size_mm: tuple[Positive, Positive] = (5.0, 5.0)
    height_mm: Positive = 1.0
    grade: str | None = None
    remanence_t: Positive = 1.43
    recoil_permeability: RecoilPermeability = NDFEB_RECOIL_PERMEABILITY
    temperature_c: Annotated[float, Field(ge=-40, le=150)] = REFERENCE_TEMPERATURE_C
    turns: Annotated[int, Field(ge=1)] = 50
    current_a: Finite = 0.2
    switching: Literal["all-on", "face-by-face"] = "all-on"
    depth_below_core_face_mm: NonNegative = 0.0
    positions_mm: PlacesOfFaces = (
        (0.0, 0.0),
        (10.0, 10.0),
        (-10.0, 10.0),
        (-10.0, -10.0),
        (10.0, -10.0),
    )
    depth_mm: Positive | tuple[Positive, ...] | None = None
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
        if self.depth_mm is None:
            return ()
        if isinstance(self.depth_mm, tuple):
            return self.depth_mm
        return (self.depth_mm,) * self.count

    @property
    def working_remanence_t(self) -> float:
        """Remanence at `temperature_c`."""
        return remanence_at_temperature_t(self.remanence_t, self.temperature_c)

    @property
    def winding_polarization_t(self) -> float:
        """μ0 N I / L: the polarization of the body whose field is that of the winding."""
        return MU0_T_MM_PER_A * self.turns * self.current_a / self.height_mm

    @model_validator(mode="before")
    @classmethod
    def _figures_of_part_and_grade(cls, given: Any) -> Any:
        if not isinstance(given, dict):
            return given
        if isinstance(given.get("part"), str):
            part = magnet_part(given["part"])
            graded = part.grade is not None and given.get("remanence_t") is None
            given = {**part.figures(), **({"grade": part.grade} if graded else {}), **given}
        if isinstance(given.get("grade"), str):
            given = {"remanence_t": magnet_grade(given["grade"]).remanence_t, **given}
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
        listed = (("depth_mm", self.depths_mm), ("tilt_deg", self.tilt_deg), ("north", self.north))
        for key, values in listed:
            if len(values) not in (0, count):
                raise ValueError(
                    f"magnets.{key} needs one entry for each of the {count} magnets.positions_mm; "
                    f"got {len(values)}. Add the missing ones, or leave the key out"
                )

    def _check_part(self) -> None:
        if self.part is None:
            return
        for name, value in magnet_part(self.part).figures().items():
            if getattr(self, name) != value:
                raise ValueError(
                    f"magnets.{name} = {getattr(self, name)!r} contradicts magnets.part = "
                    f"{self.part!r} ({value!r}). Leave one of the two out"
                )

    def _check_shape(self) -> None:
        hollow = self.shape == "ring" or self.kind == "coil"
        if self.inner_diameter_mm >= self.diameter_mm and hollow:
            raise ValueError(
                f"magnets.inner_diameter_mm must be below magnets.diameter_mm = "
                f"{self.diameter_mm:g}; got {self.inner_diameter_mm:g}. Make the hole smaller"
            )
        if self.shape == "ring" and not self.inner_diameter_mm:
            raise ValueError(
                "magnets.shape = 'ring' needs magnets.inner_diameter_mm above 0; got 0"
            )
        if self.inner_diameter_mm and not hollow:
            raise ValueError(
                f"magnets.inner_diameter_mm = {self.inner_diameter_mm:g} belongs to a ring or a coil; "
                f"magnets.shape is {self.shape!r}. Leave it out, or choose shape = 'ring'"
            )
        if self.kind == "coil" and self.shape == "block":
            raise ValueError(
                "magnets.kind = 'coil' is wound round; got magnets.shape = 'block'. Choose shape = "
                "'disk' (or 'ring', the same for a coil)"
            )
        if self.switching == "face-by-face" and self.kind != "coil":
            raise ValueError(
                "magnets.switching = 'face-by-face' needs magnets.kind = 'coil'; permanent magnets "
                "cannot be switched off. Choose coils, or switching = 'all-on'"
            )

    def _check_grade(self) -> None:
        if self.grade is None:
            return
        grade = magnet_grade(self.grade)
        if not grade.admits(self.remanence_t):
            raise ValueError(
                f"magnets.remanence_t = {self.remanence_t:g} lies outside grade {grade.name} "
                f"({grade.remanence_min_t:g} to {grade.remanence_max_t:g} T). Leave remanence_t out "
                f"to take the typical {grade.remanence_t:g} T, or leave magnets.grade out"
            )
        if self.temperature_c > grade.max_temperature_c:
            raise ValueError(
                f"magnets.temperature_c = {self.temperature_c:g} exceeds the "
                f"{grade.max_temperature_c:g} °C at which grade {grade.name} begins to lose "
                "magnetisation for good. Lower it, or leave magnets.grade out for a hotter grade"
            )
