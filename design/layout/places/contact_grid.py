"""The grid of contact locations on a face, and the finer lattice that presses are simulated on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_places import grid_count
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec


@dataclass(frozen=True)
class PlaceGrid:
    """A rectangular grid of contact locations on a face; place index = ix · len(y_mm) + iy.

    x and y are lengths along the surface from the face's middle, in constant steps. `FaceFrame.to_plane`
    gives a location's place in the plane of a curved face's frame; on flat faces it is the same.
    """

    x_mm: Float[np.ndarray, "nx"]
    y_mm: Float[np.ndarray, "ny"]

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.x_mm), len(self.y_mm)

    @property
    def xy_mm(self) -> Float[np.ndarray, "place 2"]:
        x, y = np.meshgrid(self.x_mm, self.y_mm, indexing="ij")
        return np.column_stack([x.ravel(), y.ravel()])

    def __len__(self) -> int:
        return len(self.x_mm) * len(self.y_mm)


@cached_geometry
def contact_grid(spec: ObjectSpec) -> PlaceGrid:
    """The specification's places (the paper: 10 × 10, pitch 3 mm, ±13.5 about the face centre).

    On curved faces steps are along the surface, so that the places lie evenly on it.

    Which of them a face has says `design.layout.places.contact_places.contact_places`.
    """
    pitch = spec.contact_grid.pitch_mm
    x, y = ((np.arange(n) - (n - 1) / 2) * pitch for n in grid_count(spec))
    return PlaceGrid(x, y)


@cached_geometry
def press_lattice(spec: ObjectSpec) -> PlaceGrid:
    """The contact grid refined by two, with half a pitch of margin: (2n + 1) locations per axis.

    Contact location (X, Y) is lattice place (2X + 1, 2Y + 1). Signals between places are
    interpolated on this lattice, and derivatives in x and y are taken on it.
    """
    pitch = spec.contact_grid.pitch_mm
    x, y = ((np.arange(2 * n + 1) - n) * pitch / 2 for n in grid_count(spec))
    return PlaceGrid(x, y)


@cached_geometry
def grid_places_in_lattice(spec: ObjectSpec) -> Int[np.ndarray, "place"]:
    """Lattice place of each contact location, in the order of the contact grid."""
    nx, ny = grid_count(spec)
    ix, iy = np.meshgrid(2 * np.arange(nx) + 1, 2 * np.arange(ny) + 1, indexing="ij")
    return (ix * (2 * ny + 1) + iy).ravel()
