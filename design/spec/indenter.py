"""The indenter in a specification: a rigid tip, or a probe of two or three, and how it is pressed."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import Finite, NonNegative, Positive, SpecPart

Direction = Annotated[float, Field(ge=-60, le=60)]
Tilt = Annotated[float, Field(ge=-45, le=45)]
Vertices = Annotated[tuple[tuple[Finite, Finite, Finite], ...], Field(min_length=4)]


class IndenterSpec(SpecPart):
    """Rigid indenter pressed into a face; each kind reads its own sizes.

    hemisphere: `radius_mm`. flat: a disk of `radius_mm`. cylinder: `radius_mm` and `length_mm`, lying
    along the face's x. cuboid: `size_mm`. stl: the convex body in `file`, its lowest point down. The
    edges of flat and cuboid are rounded by `fillet_mm`. `yaw_deg` turns the indenter about the face's
    normal, then `tilt_deg` about the face's x and y; the place pressed is where its lowest point
    lands. `direction_deg` is how far its path leans from the inward normal towards x and y: at depth
    d it has moved sideways by d tan of them. A probe has `tip_count` tips, `tip_spacing_mm` apart
    (left out: as the paper's, 15 mm for two and 20 mm for three) about the place pressed.
    """

    kind: Literal["hemisphere", "flat", "cylinder", "cuboid", "stl"] = "hemisphere"
    radius_mm: Positive = 5.0
    length_mm: Positive = 10.0
    size_mm: tuple[Positive, Positive] = (10.0, 10.0)
    fillet_mm: NonNegative = 0.0
    file: str | None = None
    vertices_mm: Vertices | None = None
    yaw_deg: Finite = 0.0
    tilt_deg: tuple[Tilt, Tilt] = (0.0, 0.0)
    direction_deg: tuple[Direction, Direction] = (0.0, 0.0)
    friction: Literal["none", "sticking"] = "none"
    tip_count: Literal[1, 2, 3] = 1
    tip_spacing_mm: Positive | None = None

    @model_validator(mode="after")
    def _shape_is_whole(self) -> IndenterSpec:
        if (self.kind == "stl") != (self.vertices_mm is not None):
            raise ValueError(
                f"indenter.file goes with indenter.kind = 'stl', and that kind needs it; got kind "
                f"{self.kind!r} and file {self.file!r}. Give the STL of a convex body in mm, or "
                "another kind"
            )
        if self.kind == "hemisphere" and any(self.tilt_deg):
            raise ValueError(
                f"indenter.tilt_deg = {list(self.tilt_deg)} does nothing to a hemisphere. Set it to "
                "[0, 0], or indenter.direction_deg for an oblique path"
            )
        room = {"flat": self.radius_mm, "cuboid": min(self.size_mm) / 2}.get(self.kind, 0.0)
        if self.fillet_mm and not self.fillet_mm < room:
            raise ValueError(
                f"indenter.fillet_mm rounds the edges of flat and cuboid and must be below half their "
                f"width; got {self.fillet_mm:g} for kind {self.kind!r} ({room:g} mm). Make it smaller"
            )
        return self
