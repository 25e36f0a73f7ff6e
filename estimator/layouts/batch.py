"""Batches of layouts as tensors: where magnets and sensors of one face are, and how they turn."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.layout.pockets import magnet_bodies, sensor_places
from design.spec.object import ObjectSpec

_Made = TypeVar("_Made")


@dataclass(frozen=True)
class Layouts:
    """Layouts of one face, each repeated on all faces unless `by_face` has others; every tensor may want
    gradients.

    Attributes
    ----------
    magnet_mm : x, y in the face's frame and depth below the face, in the core too, mm
    turn_rad : rotation vector of each magnet's axis about the face's x and y, rad; 0 is outward
    polarity : polarization over that of a magnet of its size and the first one's remanence, negative for
        north inward
    sensor_mm : x, y in the face's frame, mm; chips are turned about the normal by their azimuth
    by_face : layouts of all faces by number, this one's (`face`) too, where they are not all the same
    at_places : what is computed from these very places (`estimator.layouts.surfaces`), next to the places;
        layouts made by `replace` share it
    """

    magnet_mm: Float[Tensor, "layout magnet 3"]
    turn_rad: Float[Tensor, "layout magnet 2"]
    polarity: Float[Tensor, "layout magnet"]
    sensor_mm: Float[Tensor, "layout sensor 2"]
    by_face: Mapping[int, Layouts] = field(default_factory=dict)
    face: int | None = None
    at_places: dict[Hashable, tuple[Tensor, Tensor]] = field(
        default_factory=dict, repr=False, compare=False
    )
    _kept: dict[Hashable, tuple[tuple[Any, ...], Any]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def kept(self, name: Hashable, made_of: tuple[Any, ...], make: Callable[[], _Made]) -> _Made:
        """Return what is computed once of these layouts and of these very objects, with its graph of
        gradients: scorers of several forces share most of it."""
        key = name, *map(id, made_of)
        if key not in self._kept:
            self._kept[key] = made_of, make()
        return self._kept[key][1]

    def __len__(self) -> int:
        return len(self.magnet_mm)

    def __getitem__(self, rows: slice) -> Layouts:
        return Layouts(
            self.magnet_mm[rows],
            self.turn_rad[rows],
            self.polarity[rows],
            self.sensor_mm[rows],
            {face: layouts[rows] for face, layouts in self.by_face.items()},
            self.face,
        )

    def magnets(self, which: Sequence[int]) -> Layouts:
        """With some magnets of every face alone, counted from 0."""
        some = list(which)
        return replace(
            self,
            magnet_mm=self.magnet_mm[:, some],
            turn_rad=self.turn_rad[:, some],
            polarity=self.polarity[:, some],
            by_face={face: layouts.magnets(which) for face, layouts in self.by_face.items()},
        )

    def layouts_of_face(self, face: int) -> Layouts:
        """The layouts of another face."""
        return self.by_face.get(face, self)

    def seen_from(self, face: int) -> Layouts:
        """The same layouts of all faces, as those of another one."""
        return layouts_by_face(self.by_face, face)

    def map_faces(self, change: Callable[[Layouts, int | None], Layouts]) -> Layouts:
        """With a change made to the layouts of every face: by its number, or None of one for all."""
        if self.face is None:
            return change(self, None)
        changed = {face: change(layouts, face) for face, layouts in self.by_face.items()}
        return layouts_by_face(changed, self.face)


def layouts_by_face(of_faces: Mapping[int, Layouts], face: int) -> Layouts:
    """The layouts of one face that knows those of the others."""
    return replace(of_faces[face], by_face=of_faces, face=face)


def layouts_of(spec: ObjectSpec, face: int, dtype: torch.dtype = torch.float32) -> Layouts:
    """The specification's own layout of one face, as a batch of one; with those of the others where the
    specification places magnets face by face."""
    if len(spec.magnets.lists) == 1:
        return _own_layout(spec, face, dtype)
    return layouts_by_face(
        {number: _own_layout(spec, number, dtype) for number in spec.body.sensed}, face
    )


def _own_layout(spec: ObjectSpec, face: int, dtype: torch.dtype) -> Layouts:
    index = spec.body.sensed.index(face)
    bodies, places = magnet_bodies(spec)[index], sensor_places(spec)[index]
    below = [0.0, 0.0, magnets_below_mm(spec)]
    tilts = spec.magnets.tilt_deg or ((0.0, 0.0),) * len(bodies)

    def batch(part: Any) -> Tensor:
        return torch.as_tensor(np.array(part, dtype=float)[None], dtype=dtype)

    return Layouts(
        batch([body.centre_mm * [1, 1, -1] + below for body in bodies]),
        batch(np.deg2rad(tilts)),
        batch(np.multiply(spec.magnets.polarities, spec.magnets.strengths)),
        batch([(x, y) for x, y, _ in places]),
    )


def magnets_below_mm(spec: ObjectSpec) -> float:
    """Return the depth below a face of the plane from which its magnets' depths count: the core's where
    they rest in it."""
    return 0.0 if spec.arrangement == "sensors-in-core" else spec.shell.thickness_mm


def magnet_axes(layouts: Layouts) -> Float[Tensor, "3 layout magnet"]:
    """Unit axes: the outward normal turned by the rotation vector."""
    about_x, about_y = layouts.turn_rad.unbind(-1)
    angle = (about_x * about_x + about_y * about_y + 1e-14).sqrt()  # a root with a slope at rest
    share = angle.sin() / angle
    return torch.stack([share * about_y, -share * about_x, angle.cos()])


def chip_axes(
    sensor_mm: Float[Tensor, "layout sensor 2"], on_board: Float[Tensor, "3 3"]
) -> Float[Tensor, "layout sensor 3 3"]:
    """Chip axes as rows, in the face's frame, from columns on the board; at the centre azimuth 0."""
    x, y = sensor_mm.unbind(-1)
    squared = x * x + y * y
    centred = squared == 0
    length = torch.where(centred, 1.0, squared).sqrt()
    cosine, sine = torch.where(centred, 1.0, x / length), y / length
    zeros, ones = torch.zeros_like(x), torch.ones_like(x)
    rows = torch.stack([sine, cosine, zeros, -cosine, sine, zeros, zeros, zeros, ones], dim=-1)
    board = rows.reshape(*x.shape, 3, 3)
    return (board @ on_board).transpose(-1, -2)
