"""Surfaces of body and core under layouts in batches: where parts lie and how they turn, with gradients.

All geometry comes from `design`, in double precision; its slopes are central differences, computed
where they are asked for. Beside its patch a part is taken to lie at the patch's nearest place on the way
to its middle, so that everything is finite: limits of their own keep parts on their patches.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.layout.body import core_frames, face_frames
from design.layout.places.positions import chip_on_board, sinks_of_boards_mm
from design.layout.pockets import board_frame, boards_depth_mm
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts

_STEP = 1e-4
"""Step of central differences, mm: in double precision good to 1e-8 mm."""
_WITHIN, _WELL_WITHIN = 1 - 1e-6, 0.98
"""Shares of a patch, and of a board's reach, that still count as inside."""
_AZIMUTHS, _BISECTIONS = 64, 20
"""Directions in which a board's reach is found, and halvings of its interval."""
_BEYOND_ALL_MM = 1e6
"""Reach on a flat core, where no board is too far out for its surface."""

_Function = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Surface:
    """A sensed patch of the body, the core's under it, and what its boards are like."""

    frame: FaceFrame
    core: FaceFrame
    spec: ObjectSpec

    @property
    def number(self) -> int:
        return self.frame.number

    def lengths_mm(self, xy_mm: Float[Tensor, "*n 2"]) -> Float[Tensor, "*n 2"]:
        """Places of the frame's plane as lengths along the surface, as candidates have them."""
        return pointwise(self.frame.from_plane, xy_mm)

    @cached_property
    def shape(self) -> Hashable:
        """Key of places in the frames' own coordinates: the same of faces that are turned copies."""
        frames = self.frame, self.core
        return tuple((frame.relief, frame.half_extents_mm, frame.round) for frame in frames)

    @property
    def chip_frame(self) -> FaceFrame:
        """The face that boards are mounted on."""
        return self.core if self.spec.arrangement == "sensors-in-core" else self.frame

    def magnets(
        self, layouts: Layouts
    ) -> tuple[Float[Tensor, "layout magnet 3"], Float[Tensor, "layout magnet 3 3"]]:
        """Centres of magnets (mm) and axes as columns of the surface over them (the third its normal), in
        the coordinates of `frame`."""
        values = self._placed("magnets", layouts, layouts.magnet_mm, self._magnets)
        return values[..., :3], values[..., 3:].unflatten(-1, (3, 3))

    def chips(
        self, layouts: Layouts
    ) -> tuple[Float[Tensor, "layout sensor 3"], Float[Tensor, "layout sensor 3 3"]]:
        """Sensing points (mm) and chips' axes as columns, in the coordinates of `chip_frame`."""
        values = self._placed("sensors", layouts, layouts.sensor_mm, self._sensors)
        return values[..., :3], values[..., 3:12].unflatten(-1, (3, 3))

    def boards(
        self, layouts: Layouts
    ) -> tuple[
        Float[Tensor, "layout sensor 3"],
        Float[Tensor, "layout sensor 3 3"],
        Float[Tensor, "layout sensor"],
    ]:
        """Points of the core's surface over sensors (mm); radial, tangential and normal direction as columns,
        in the coordinates of `core`; and by how much boards lie deeper than on a flat core (mm)."""
        values = self._placed("sensors", layouts, layouts.sensor_mm, self._sensors)[..., 12:]
        return values[..., :3], values[..., 3:12].unflatten(-1, (3, 3)), values[..., 12]

    def _placed(self, part: str, layouts: Layouts, places: Tensor, function: _Function) -> Tensor:
        """Values at places, computed once for faces of the same shape that share these places."""
        # `_version` rises where places are changed in place
        kept, key = layouts.at_places, (part, self.shape, id(places), places._version)
        if key not in kept:
            kept[key] = places, pointwise(function, places)
        return kept[key][1]

    def _magnets(self, xyd_mm: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 12"]:
        xy = clamp_to_patch_mm(self.frame, xyd_mm[:, :2])
        return _joined(*self.frame.raised(np.column_stack([xy, -xyd_mm[:, 2]])))

    def _sensors(self, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n values"]:
        """Chips, and in the core their boards, whose sinks take longest."""
        if self.spec.arrangement == "sensors-in-shell":
            return self._chips(xy_mm, np.full(len(xy_mm), boards_depth_mm(self.spec)))
        sink = self.sinks_mm(xy_mm)
        chips = self._chips(xy_mm, self.spec.sensors.depth_below_core_face_mm + sink)
        return np.column_stack([chips, self._boards(xy_mm), sink])

    def _chips(
        self, xy_mm: Float[np.ndarray, "n 2"], depth_mm: Float[np.ndarray, "n"]
    ) -> Float[np.ndarray, "n 12"]:
        xy = clamp_to_patch_mm(self.chip_frame, xy_mm)
        point, axes = self.chip_frame.raised(np.column_stack([xy, -depth_mm]))
        board = board_frame(_azimuths(xy_mm))
        return _joined(point, axes @ board @ chip_on_board(self.spec.sensors))

    def _boards(self, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n 12"]:
        xy, azimuth = clamp_to_patch_mm(self.core, xy_mm), _azimuths(xy_mm)
        point, axes = self.core.raised(np.column_stack([xy, 0 * azimuth]))
        tangent, across, normal = axes.transpose(2, 0, 1)
        cosine, sine = np.cos(azimuth)[:, None], np.sin(azimuth)[:, None]
        radial, tangential = cosine * tangent + sine * across, cosine * across - sine * tangent
        return _joined(point, np.stack([radial, tangential, normal], axis=-1))

    def sinks_mm(self, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
        """Return how much deeper boards lie than on a flat core; beyond `reach_mm` as just within it."""
        if self.core.flat:
            return np.zeros(len(xy_mm))
        azimuth = _azimuths(xy_mm)
        least = np.minimum(1.0, _WELL_WITHIN * self.reach_mm(xy_mm) / _radii(xy_mm))
        places = np.column_stack([xy_mm * least[:, None], azimuth])
        return np.nan_to_num(sinks_of_boards_mm(self.spec, self.core, places))

    def reach_mm(self, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
        """Return how far from the middle a board towards a place has room in the core's patch."""
        if self.core.flat:
            return np.full(len(xy_mm), _BEYOND_ALL_MM)
        turn = 2 * np.pi * np.arange(_AZIMUTHS + 1) / _AZIMUTHS
        return np.interp(
            _azimuths(xy_mm) % (2 * np.pi), turn, np.append(self._reach, self._reach[0])
        )

    @cached_property
    def _reach(self) -> Float[np.ndarray, "azimuth"]:
        """Return reaches of azimuths in equal steps from 0, by bisection."""
        turn = 2 * np.pi * np.arange(_AZIMUTHS) / _AZIMUTHS
        way = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
        low, high = np.zeros(_AZIMUTHS), np.full(_AZIMUTHS, max(self.core.half_extents_mm))
        for _ in range(_BISECTIONS):
            middle = (low + high) / 2
            xy = middle[:, None] * way
            room = np.isfinite(
                sinks_of_boards_mm(self.spec, self.core, np.column_stack([xy, turn]))
            )
            room &= self.core.covers(xy)
            low, high = np.where(room, middle, low), np.where(room, high, middle)
        return low


def surfaces(spec: ObjectSpec) -> dict[int, Surface]:
    """Return the surfaces of all sensed faces, by number."""
    return {surface.number: surface for surface in _surfaces(spec)}


@cached_geometry
def _surfaces(spec: ObjectSpec) -> tuple[Surface, ...]:
    pairs = zip(face_frames(spec), core_frames(spec), strict=True)
    return tuple(Surface(frame, core, spec) for frame, core in pairs)


def clamp_to_patch_mm(
    frame: FaceFrame, xy_mm: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n 2"]:
    """Return places; those outside a patch move towards its middle until they lie on it."""
    share = np.asarray(xy_mm) / np.asarray(frame.half_extents_mm)
    size = np.linalg.norm(share, axis=1) if frame.round else abs(share).max(axis=1)
    return xy_mm * np.minimum(1.0, _WITHIN / np.maximum(size, 1e-12))[:, None]


def to_object(frame: FaceFrame, local_mm: Float[Tensor, "*part 3"]) -> Float[Tensor, "*part 3"]:
    """Points in the coordinates of a face's plane, in the object's frame."""
    return turned_to_object(frame, local_mm) + local_mm.new_tensor(frame.centre_mm.tolist())


def turned_to_object(frame: FaceFrame, rows: Float[Tensor, "*part 3"]) -> Float[Tensor, "*part 3"]:
    """Directions in the coordinates of a face's plane, in the object's frame."""
    return rows @ rows.new_tensor(frame.axes.T.tolist())


def _joined(
    point: Float[np.ndarray, "n 3"], axes: Float[np.ndarray, "n 3 3"]
) -> Float[np.ndarray, "n 12"]:
    return np.concatenate([point, axes.reshape(-1, 9)], axis=1)


def _azimuths(xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    return np.arctan2(xy_mm[:, 1], xy_mm[:, 0])


def _radii(xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    return np.maximum(np.linalg.norm(xy_mm, axis=1), 1e-9)


def pointwise(
    function: _Function, points: Float[Tensor, "*n inputs"]
) -> Float[Tensor, "*n outputs"]:
    """A function of a few numbers of each point, given in NumPy; gradients are central differences."""
    values: Any = _Pointwise.apply(points.reshape(-1, points.shape[-1]), function)
    return values.reshape(*points.shape[:-1], -1)


class _Pointwise(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, points: Tensor, function: _Function) -> Tensor:
        values = points.detach().double().cpu().numpy()
        if not ctx.needs_input_grad[0]:
            return torch.as_tensor(function(values), dtype=points.dtype, device=points.device)
        count, inputs = values.shape
        steps = _STEP * np.eye(inputs)
        places = values + np.concatenate([np.zeros((1, inputs)), steps, -steps])[:, None]
        values_at_places = function(places.reshape(-1, inputs)).reshape(1 + 2 * inputs, count, -1)
        slopes = (values_at_places[1 : 1 + inputs] - values_at_places[1 + inputs :]) / (2 * _STEP)
        ctx.save_for_backward(torch.as_tensor(slopes, device=points.device))
        return torch.as_tensor(values_at_places[0], dtype=points.dtype, device=points.device)

    @staticmethod
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor, None]:
        (slopes,) = ctx.saved_tensors
        # Chain rule: n place, i input, o output; slopes are ∂output/∂input by central differences
        back = torch.einsum("ino,no->ni", slopes, grads[0].double())
        return back.to(grads[0].dtype), None
