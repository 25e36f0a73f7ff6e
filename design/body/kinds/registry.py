"""Registry of the kinds of body, by name: a new one is a line here."""

from __future__ import annotations

from design.body.kinds.base import BodyKind
from design.body.kinds.box import Box
from design.body.kinds.capsule import Capsule
from design.body.kinds.cylinder import Cylinder
from design.body.kinds.dome import Dome
from design.body.kinds.ellipsoid import Ellipsoid
from design.body.kinds.imported import Imported
from design.body.kinds.pad import Pad
from design.body.kinds.sphere import Sphere

KINDS: dict[str, type[BodyKind]] = {
    kind.name: kind for kind in (Box, Pad, Cylinder, Capsule, Sphere, Ellipsoid, Dome, Imported)
}
"""Kinds in the order in which users see them."""
