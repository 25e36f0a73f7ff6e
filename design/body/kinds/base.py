"""The contract of a kind of body: what layout, fit, mould, mesh and mechanics ask it.

A kind knows no specification, only the few measures below; `design.layout.body.body_of` hands them
over. Its exact solid, where it has one, is an entry in `design/solids/body.py`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame, face_axes, less_on_faces
from design.body.triangles import cylinder_between

if TYPE_CHECKING:
    import trimesh

Opening = Literal["open", "bore", "closed"]
Inside = Literal["core", "silicone", "air"]

OVERSHOOT_MM = 1.0
"""Length by which the cavity's triangles reach beyond an open face."""

ALL_FACES = (1, 2, 3, 4, 5, 6)


@dataclass(frozen=True)
class BodyKind(ABC):
    """A body in a box of `size_mm` (x, y, z) about the origin, with silicone of `thickness_mm`.

    Of the `opened` faces the core's cavity runs out, through the whole side or through a bore of
    `bore_mm`. Triangles of curved surfaces keep within `envelope_mm`. `inside` says what holds the
    silicone, and `file` where an imported surface comes from; `digest`, of its content, keeps apart what is
    kept of a file and of another of its name.
    """

    size_mm: tuple[float, float, float]
    thickness_mm: float
    envelope_mm: float
    opened: tuple[int, ...] = ()
    bore_mm: float = 0.0
    inside: Inside = "core"
    file: str | None = None
    scale: float = 1.0
    digest: str | None = None

    name: ClassVar[str]
    """Name of the kind, in `body.kind`."""
    faces: ClassVar[tuple[int, ...]] = ALL_FACES
    """Faces that such a body can have."""
    openable: ClassVar[tuple[int, ...]] = (6,)
    """Faces that may be open."""
    opens_sides: ClassVar[bool] = False
    """True where a whole side opens, else a bore."""
    on_base: ClassVar[bool] = False
    """True where the silicone stands on a rigid base, whose top the mould leaves open."""
    cuboid: ClassVar[bool] = False
    """True where its sides are flat and meet at right angles: only then a sliding core and the reverse
    arrangement are known."""
    sampled: ClassVar[bool] = False
    """True where it is known by its triangles, its core an offset of them, and has no exact solid."""
    mirrored: ClassVar[bool] = False
    """True where the triangles of its surface are alike in all octants."""
    insides: ClassVar[tuple[Inside, ...]] = ("core",)
    """Supports that may hold the silicone."""
    from_file: ClassVar[bool] = False
    """True where its surface is read from `body.file`."""
    size_rule: ClassVar[str] = ""
    """Rule that `size_mm` must follow, where `takes_size` refuses some."""
    round_below: ClassVar[bool] = False
    """True where it ends below in a flat disk, its own diameter wide."""
    takes_keys: ClassVar[bool] = True
    """True where the core can have keys: a plug or the core itself shapes the silicone around them."""
    comments: ClassVar[Mapping[str, str]] = {}
    """Comments in a new specification (`instobj new`), by key or table, where the template's do not fit."""

    @classmethod
    def takes_size(cls, size_mm: tuple[float, float, float]) -> bool:
        """Return whether a box of those edges can hold a body of this kind."""
        return True

    @classmethod
    def falls_apart(cls, closed: list[int]) -> bool:
        """Return whether silicone on those faces alone would not hang together."""
        return False

    @property
    def half_mm(self) -> Float[np.ndarray, "3"]:
        return np.asarray(self.size_mm) / 2

    @property
    def core_half_mm(self) -> Float[np.ndarray, "3"]:
        """Half extents of a core that is centred: the body's less one shell thickness per side."""
        return self.half_mm - self.thickness_mm

    @property
    def radius_mm(self) -> float:
        """About z, of kinds that are round about it."""
        return self.size_mm[0] / 2

    @property
    def core_radius_mm(self) -> float:
        """The same of the core: the body's less one shell thickness."""
        return self.radius_mm - self.thickness_mm

    @property
    def opening(self) -> Opening:
        """Return how the core's cavity runs out of the silicone: through a side, a bore, or nowhere."""
        if self.on_base:
            return "open"
        if not self.opened:
            return "closed"
        return "open" if self.opens_sides else "bore"

    @property
    def corners_mm(self) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
        """Lowest and highest corner of the silicone's outside."""
        return -self.half_mm, self.half_mm

    @property
    def silicone_mm(self) -> float:
        """Depth of silicone under a patch's centre."""
        return self.thickness_mm

    @property
    def core_floor_mm(self) -> float:
        """Level at which the −z axis leaves the core."""
        return -float(self.core_half_mm[2])

    @property
    def room_for_recesses(self) -> tuple[float, str]:
        """Return what recesses must be less deep than (mm), and its name."""
        return float(self.core_half_mm.min()), "half the core"

    @property
    def thickness_below_mm(self) -> float:
        """Return what the silicone's thickness must be below, besides what its core needs."""
        return float("inf")

    def passage_mm(self, axes: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "2 2"]:
        """Lowest and highest corner, along the first two axes, of what passes out of the opening.

        Zeros where nothing does.
        """
        if self.opening == "closed":
            return np.zeros((2, 2))
        radius = self.bore_mm / 2 if self.opening == "bore" else self.core_radius_mm
        return np.array([[-radius, -radius], [radius, radius]])

    def parting_azimuth(self, size_mm: Float[np.ndarray, "3"]) -> float | None:
        """Angle (rad) of a mould's parting plane's normal from `across`; None: least undercut.

        `size_mm` are the body's extents along the mould's axes. By default the plane goes
        through two edges of the body's box.
        """
        return float(np.arctan2(size_mm[0], size_mm[1]))

    @abstractmethod
    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        """A face, or the same of the surface `inward_mm` below the outside."""

    def core_frame(self, number: int) -> FaceFrame:
        """The same on the core's surface."""
        return self.frame(number, self.thickness_mm)

    @abstractmethod
    def core_distance_mm(self, points_mm: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n"]:
        """Below 0 in what holds the silicone from inside; the distance to it close to its surface."""

    @abstractmethod
    def outer_surface(self) -> trimesh.Trimesh:
        """The silicone's outside as if it were solid, mm."""

    @abstractmethod
    def core_surface(self) -> trimesh.Trimesh | None:
        """The surface of what holds the silicone from inside; None where that is the base alone."""

    def cavity_surface(self) -> trimesh.Trimesh | None:
        """Return what the core and its passage out of the open faces keep free, 1 mm beyond them; or None."""
        core = self.core_surface()
        return None if core is None else self.with_bore(core)

    def with_bore(self, core: trimesh.Trimesh) -> trimesh.Trimesh:
        """The core's surface with its bore out of face 6, where that is open."""
        if 6 not in self.opened:
            return core
        bottom, inside = -self.size_mm[2] / 2 - OVERSHOOT_MM, self.core_floor_mm / 2
        return core.union(cylinder_between(self.bore_mm / 2, bottom, inside, self.envelope_mm))

    @abstractmethod
    def volume_mm3(self) -> float:
        """Volume of the sealed silicone without keys and slits, pockets filled."""

    def less(self, layer_mm: float) -> BodyKind:
        """The body without a layer of that thickness on all of its outside, round the same core."""
        x, y, z = (edge - 2 * layer_mm for edge in self.size_mm)
        return replace(self, size_mm=(x, y, z), thickness_mm=self.thickness_mm - layer_mm)

    def cast_corners_mm(
        self, layer_mm: float, sensed: tuple[int, ...]
    ) -> tuple[np.ndarray, np.ndarray]:
        """`corners_mm` without a layer on the sensed faces."""
        return less_on_faces(*self.corners_mm, layer_mm, sensed)

    def cast_surface(self, layer_mm: float, sensed: tuple[int, ...]) -> trimesh.Trimesh:
        """The outside less a layer that a second pour adds, where faces are `sensed` or all over."""
        return self.less(layer_mm).outer_surface()

    @property
    def support_ends(self) -> list[tuple[Float[np.ndarray, "3"], float]]:
        """Planes in which a core with straight walls ends: normal towards the open face, level in mm."""
        normals = [face_axes(face)[0] for face in self.opened if self.opens_sides]
        return [(normal, float(abs(normal) @ self.core_half_mm)) for normal in normals]

    def end_slabs(self, width_mm: float) -> list[trimesh.Trimesh]:
        """At each open side a slab below the end of the core, that much wider than it, and as high."""
        return []

    def core_span_mm(
        self, overshoot_mm: float
    ) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
        """Corners of the core's box, drawn out through the open faces and beyond."""
        half = self.half_mm + overshoot_mm
        low, high = -self.core_half_mm, self.core_half_mm
        for face in self.opened:
            normal = face_axes(face)[0]
            high = np.where(normal > 0, half, high)
            low = np.where(normal < 0, -half, low)
        return low, high

    @property
    def outside(self) -> BodyKind:
        """The same with nothing that only its inside depends on: one for all cores."""
        return replace(self, thickness_mm=0.0, opened=(), bore_mm=0.0, inside="core")
