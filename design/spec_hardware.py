"""The hardware in a specification: body, shell, magnets, core, sensors.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

from pydantic import Field, model_validator

from design.catalogue import (
    REFERENCE_TEMPERATURE_C,
    hall_part,
    magnet_grade,
    remanence_at_temperature_t,
)
from design.spec_types import Finite, NonNegative, Positive, SpecPart

Averaging = Literal[1, 2, 4, 8, 16, 32]
Tilt = Annotated[float, Field(ge=-30, le=30)]


class BodySpec(SpecPart):
    """Outer shape of the silicone shell."""

    kind: Literal["box"] = "box"
    size_mm: tuple[Positive, Positive, Positive] = (42.0, 42.0, 42.0)


class ShellSpec(SpecPart):
    """Silicone walls and the moulded pockets that take the magnets."""

    thickness_mm: Positive = 8.0
    pocket_diameter_mm: Positive = 6.0
    pocket_depth_mm: Positive = 3.0


class MagnetSpec(SpecPart):
    """Axially magnetised disks, one layout repeated on every sensed face, north outward.

    `remanence_t` is that at 20 °C; left out, it is the typical one of `grade`. `depth_mm` is that
    of the mid-plane's centre below the face, one for all magnets or one each; left out, magnets
    lie on the floor of pockets of `shell.pocket_depth_mm`. `tilt_deg` turns each magnet, with its
    pocket, about its centre by the rotation vector (about x, about y) of the face's frame.
    """

    diameter_mm: Positive = 6.0
    height_mm: Positive = 1.0
    grade: str | None = None
    remanence_t: Positive = 1.43
    temperature_c: Annotated[float, Field(ge=-40, le=150)] = REFERENCE_TEMPERATURE_C
    positions_mm: Annotated[tuple[tuple[Finite, Finite], ...], Field(min_length=1)] = (
        (0.0, 0.0),
        (10.0, 10.0),
        (-10.0, 10.0),
        (-10.0, -10.0),
        (10.0, -10.0),
    )
    depth_mm: Positive | tuple[Positive, ...] | None = None
    tilt_deg: tuple[tuple[Tilt, Tilt], ...] = ()

    @property
    def depths_mm(self) -> tuple[float, ...]:
        """`depth_mm` of every magnet; empty where it is left out."""
        if self.depth_mm is None:
            return ()
        if isinstance(self.depth_mm, tuple):
            return self.depth_mm
        return (self.depth_mm,) * len(self.positions_mm)

    @property
    def working_remanence_t(self) -> float:
        """Remanence at `temperature_c`."""
        return remanence_at_temperature_t(self.remanence_t, self.temperature_c)

    @model_validator(mode="before")
    @classmethod
    def _remanence_of_the_grade(cls, given: Any) -> Any:
        if not isinstance(given, dict) or not isinstance(given.get("grade"), str):
            return given
        return {"remanence_t": magnet_grade(given["grade"]).remanence_t, **given}

    @model_validator(mode="after")
    def _one_for_each(self) -> MagnetSpec:
        count = len(self.positions_mm)
        for key, values in (("depth_mm", self.depths_mm), ("tilt_deg", self.tilt_deg)):
            if len(values) not in (0, count):
                raise ValueError(
                    f"magnets.{key} needs one entry for each of the {count} magnets.positions_mm; "
                    f"got {len(values)}. Add the missing ones, or leave the key out"
                )
        return self

    @model_validator(mode="after")
    def _grade_agrees(self) -> MagnetSpec:
        if self.grade is None:
            return self
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
        return self


class CoreSpec(SpecPart):
    """Rigid printed core that fills the shell's cavity down to the core's own height."""

    wall_mm: Positive = 4.5
    recess_width_mm: Positive = 7.0
    recess_inner_radius_mm: Positive = 4.5
    recess_outer_radius_mm: Positive = 11.0
    recess_depth_mm: Positive = 3.0
    hub_radius_mm: Positive = 2.0
    hub_depth_mm: Positive = 0.5
    wire_hole_top_diameter_mm: Positive = 2.0
    wire_hole_side_diameter_mm: Positive = 4.0


class SensorSpec(SpecPart):
    """Three-axis Hall sensors on the core, the same ring on every sensed face.

    Chip axes: X = −tangential, Y = radial outward, Z = the face's outward normal. `range_mt`,
    `counts_per_mt` and `noise_counts` are those of `part` where they are left out; the default
    part's noise, gain and drift were measured on the recordings (16× averaging, ±40 mT).
    `averaging` is the number of conversions in a reading; it enters the part's noise alone.
    """

    part: str = "TMAG5273A1"
    averaging: Averaging = 16
    count_per_face: Annotated[int, Field(ge=1, le=12)] = 3
    radius_mm: Positive = 8.585
    depth_below_core_face_mm: NonNegative = 2.3
    first_azimuth_deg: tuple[Finite, Finite, Finite, Finite, Finite] = (240, 180, 240, 60, 300)
    counts_per_mt: Positive = 820.0
    range_mt: Positive = 40.0
    noise_counts: tuple[Positive, Positive, Positive] = (22.0, 22.0, 11.0)
    zeroing_counts: NonNegative = 10.0
    drift_counts: NonNegative = 60.0
    frame_rate_hz: Positive = 10.5

    @model_validator(mode="before")
    @classmethod
    def _figures_of_the_part(cls, given: Any) -> Any:
        return {**_part_figures(given), **given} if isinstance(given, dict) else given


def _part_figures(given: dict[str, Any]) -> dict[str, Any]:
    """The part's range, gain and noise where `given` has none; values of other types are left."""
    name, averaging = given.get("part", "TMAG5273A1"), given.get("averaging", 16)
    range_mt, counts_per_mt = given.get("range_mt"), given.get("counts_per_mt")
    numbers = all(isinstance(n, int | float | None) for n in (range_mt, counts_per_mt))
    if not (isinstance(name, str) and averaging in get_args(Averaging) and numbers):
        return {}
    part = hall_part(name)
    if range_mt is None and part.ranges:
        range_mt = part.ranges[0].range_mt
    if counts_per_mt is None and range_mt is not None and part.ranges:
        counts_per_mt = part.range_covering(float(range_mt)).counts_per_mt
    noise_counts = given.get("noise_counts")
    if noise_counts is None and counts_per_mt is not None and part.noise is not None:
        noise_counts = part.noise.at(float(counts_per_mt), int(averaging))
    figures = {"range_mt": range_mt, "counts_per_mt": counts_per_mt, "noise_counts": noise_counts}
    missing = [f"sensors.{key}" for key, value in figures.items() if value is None]
    if missing:
        raise ValueError(
            f"sensors.part = {name!r} has no figure in the catalogue for {', '.join(missing)}. Give "
            "what was measured or what the datasheet says for your settings"
        )
    return figures
