"""Mechanics in a specification: contact locations, indenter, presses, mesh, model, slip."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import Angle, Coordinate, Length, Offset, SpecPart

Shift = Annotated[float, Field(ge=-3, le=3)]
Turn = Annotated[float, Field(ge=-10, le=10)]


class ContactGridSpec(SpecPart):
    """Contact places on each face, centred on it; place = X·count_y + Y, counted from 0.

    The pitch is along the surface, also of curved faces.

    "fill" gives each face as many as fit (`design.layout.places.contact_places`; 10 × 10 on the
    paper's cube), a pair of counts the same ones to all.
    """

    count: (
        Literal["fill"]
        | tuple[Annotated[int, Field(ge=2, le=100)], Annotated[int, Field(ge=2, le=100)]]
    ) = "fill"
    pitch_mm: Length = 3.0


class PressSpec(SpecPart):
    """Depths below the undeformed face to which every place is pressed."""

    depths_mm: Annotated[tuple[Length, ...], Field(min_length=2)] = (
        0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0,
    )  # fmt: skip

    @model_validator(mode="after")
    def _depths_increase(self) -> PressSpec:
        if any(b <= a for a, b in zip(self.depths_mm, self.depths_mm[1:], strict=False)):
            raise ValueError(
                f"press.depths_mm must increase strictly; got {list(self.depths_mm)}. Sort the "
                "depths and remove repeats"
            )
        return self


class MeshSpec(SpecPart):
    """Target edge lengths: `edge_mm` in the bulk, `surface_edge_mm` under the pressed faces.

    At the rims of rigid bodies, and under the tip of a single press, they are `rim_edge_ratio`
    times those under the faces; magnets are prisms of 16 sides, of 8 where that is 1. The mesh leaves
    no surface by more than `envelope_mm`; half of it is for the triangles that stand for curved
    surfaces.
    """

    edge_mm: Annotated[float, Field(ge=0.02, le=100)] = 4.0
    surface_edge_mm: Annotated[float, Field(ge=0.02, le=100)] = 1.7
    rim_edge_ratio: Annotated[float, Field(ge=0.1, le=1)] = 0.4
    envelope_mm: Annotated[float, Field(ge=1e-4, le=5)] = 0.06

    @property
    def magnet_sides(self) -> int:
        """Sides of the prisms that stand for round magnets: half as many where their rims are coarse."""
        return 16 if self.rim_edge_ratio < 1 else 8

    @property
    def finest_edge_mm(self) -> float:
        """Edges at the rims of rigid bodies, and under the tip of a single press."""
        return self.rim_edge_ratio * self.surface_edge_mm


class SlipSpec(SpecPart):
    """Slip of the core against the bonded shell after casting, seen from the shell.

    The core has turned about the object's origin by the rotation vector `rotation_deg`, then
    shifted by `shift_mm`: the core is kept still, and the shell follows its interface.
    `rim` "held" clamps the silicone's flat ring round the open face to the mounting plate, in
    every press.
    """

    shift_mm: tuple[Shift, Shift, Shift] = (0.0, 0.0, 0.0)
    rotation_deg: tuple[Turn, Turn, Turn] = (0.0, 0.0, 0.0)
    rim: Literal["free", "held"] = "free"

    @property
    def slipped(self) -> bool:
        """Return whether there is any slip."""
        return any(self.shift_mm) or any(self.rotation_deg)


class MechanicsSpec(SpecPart):
    """Finite element of the silicone, and its hold on the core.

    "taylor-hood" takes Poisson ratios from 0.01 to 0.5; "p2" is for foams and lattices, −0.3 to 0.45;
    "p2-p0" (symmetric positive definite, a little too soft) up to 0.4999. On a "frictionless" core the
    shell slides but does not lift off. The correction "large-strain" presses a few places with
    large deformation and corrects all presses by a fit to them (minutes, once).
    """

    element: Literal["taylor-hood", "p2-p0", "p2"] = "taylor-hood"
    interface: Literal["bonded", "frictionless"] = "bonded"
    slip: SlipSpec = SlipSpec()
    correction: Literal["none", "large-strain"] = "none"

    @model_validator(mode="after")
    def _correction_knows_the_model(self) -> MechanicsSpec:
        plain = self.element == "taylor-hood" and self.interface == "bonded"
        if self.correction != "none" and not (plain and not self.slip.slipped):
            raise ValueError(
                "mechanics.correction = 'large-strain' needs element = 'taylor-hood', interface = "
                f"'bonded' and no slip; got {self.element!r}, {self.interface!r}, shift "
                f"{list(self.slip.shift_mm)}. Set them so, or correction = 'none'"
            )
        return self

    @model_validator(mode="after")
    def _slip_needs_a_bond(self) -> MechanicsSpec:
        if self.interface == "frictionless" and self.slip.slipped:
            raise ValueError(
                "mechanics.slip moves a bonded interface, but mechanics.interface is 'frictionless': "
                "a shell that slides keeps no slip. Set interface = 'bonded', or leave the slip out"
            )
        return self


Direction = Annotated[float, Field(ge=-60, le=60)]
Tilt = Annotated[float, Field(ge=-45, le=45)]
Vertices = Annotated[tuple[tuple[Coordinate, Coordinate, Coordinate], ...], Field(min_length=4)]


Pad = tuple[
    Annotated[float, Field(ge=0, le=20)],
    Annotated[float, Field(ge=1e-3, le=1e5)],
    Annotated[float, Field(ge=0, le=0.5)],
]


class IndenterSpec(SpecPart):
    """Indenter pressed into a face; each kind reads its own sizes.

    hemisphere: `radius_mm`. flat: a disk of `radius_mm`. cylinder: `radius_mm`, lying along the
    face's x, as long as the first of `size_mm`. cuboid, a jaw: `size_mm`. ellipsoid, a fingertip:
    `size_mm` are its widths, `radius_mm` is half its height. stl: the convex body of `vertices_mm` (in a
    specification's file also the path of its STL), its lowest point down. The edges of flat and
    cuboid are rounded by `fillet_mm`. `turn_deg` turns the indenter about the face's normal, then
    about the face's x, then about its y; the place pressed is where its lowest point lands, of flat
    and cuboid the middle of the underside. Rigid, or with a soft pad bonded to it: `pad` is its
    thickness (mm), Young's modulus (MPa) and Poisson's ratio. `direction_deg` is how far its path
    leans from the inward normal towards x and y: at depth d it has moved sideways by d tan of them. A
    probe has `tip_count` tips about the place pressed: as the paper's, two 15 mm and three 20 mm apart,
    larger ones 3 and 4 radii.
    """

    kind: Literal["hemisphere", "flat", "cylinder", "cuboid", "ellipsoid", "stl"] = "hemisphere"
    radius_mm: Length = 5.0
    size_mm: tuple[Length, Length] = (10.0, 10.0)
    fillet_mm: Offset = 0.0
    pad: Pad = (0.0, 1.0, 0.45)
    vertices_mm: Vertices | None = None
    turn_deg: tuple[Angle, Tilt, Tilt] = (0.0, 0.0, 0.0)
    direction_deg: tuple[Direction, Direction] = (0.0, 0.0)
    friction: Literal["none", "sticking"] = "none"
    tip_count: Literal[1, 2, 3] = 1

    @property
    def is_one_plain_ball(self) -> bool:
        """Return whether it is one rigid hemisphere that goes straight and without friction."""
        alone = self.kind == "hemisphere" and self.tip_count == 1 and not self.pad[0]
        return alone and not any(self.direction_deg) and self.friction == "none"

    @model_validator(mode="after")
    def _pad_slides(self) -> IndenterSpec:
        if self.pad[0] and self.friction != "none":
            raise ValueError(
                f"indenter.pad = {list(self.pad)} is a pad that slides on the face; got "
                f"indenter.friction = {self.friction!r}. Set friction = 'none', or leave the pad out"
            )
        return self

    @model_validator(mode="after")
    def _shape_is_whole(self) -> IndenterSpec:
        if (self.kind == "stl") != (self.vertices_mm is not None):
            raise ValueError(
                "indenter.vertices_mm goes with indenter.kind = 'stl', and that kind needs it; got kind "
                f"{self.kind!r}. Give the STL of a convex body in mm or its corners, or another kind"
            )
        if self.kind == "hemisphere" and any(self.turn_deg[1:]):
            raise ValueError(
                f"a tilt in indenter.turn_deg = {list(self.turn_deg)} does nothing to a hemisphere. Set it "
                "to 0, or indenter.direction_deg for an oblique path"
            )
        room = {"flat": self.radius_mm, "cuboid": min(self.size_mm) / 2}.get(self.kind, 0.0)
        if self.fillet_mm and not self.fillet_mm < room:
            raise ValueError(
                f"indenter.fillet_mm rounds the edges of flat and cuboid and must be below half their "
                f"width; got {self.fillet_mm:g} for kind {self.kind!r} ({room:g} mm). Make it smaller"
            )
        return self
