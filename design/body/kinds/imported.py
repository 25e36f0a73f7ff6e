"""The imported body: a closed surface from a file."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from design.body.imported import read_surface
from design.body.kinds.offset import OffsetBody

if TYPE_CHECKING:
    import trimesh


class Imported(OffsetBody):
    """STL, STEP and others, moved so that its box is centred."""

    name = "imported"
    from_file = True

    def parting_azimuth(self, size_mm: np.ndarray) -> None:
        """Return where least of it is an undercut."""
        return None

    def outer_surface(self) -> trimesh.Trimesh:
        return read_surface(self.file, self.scale)
