"""Places on sensed faces of points in the object's frame, for many points at once."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float, Int

from design.body.surface_chart import FaceFrame
from estimator.inversion.model.arrays import Array, apply_in_chunks, library, like

_SAMPLES = 16
"""Points along each side of a face, in the middles of as many parts: on the border they would be those of the
next face too. Half their distance, d, on a sphere of radius R, displaces a place by d² / (2 R) at most:
0.1 mm on a ball of 42 mm, and some 0.2 mm where patches meet; flat faces are met exactly."""
_OFF_SURFACE_MM = 3.0
"""A contact point farther from a sensed face is on another side: bodies of a simulator sink into each
other by a fraction of this. By as much a face is nearer that is pushed straight on."""
_BORDER = 1.01
"""Share of a face's half extent within which a point is on it: simulators round by less."""
_CHUNK = 128
"""Points at a time: their distances to all samples fit a second-level cache."""
_SAME_MM = 0.1
"""Two patches hold the same point where their surfaces are nearer to each other than this."""
_SHIFT_MM = 1e-3
"""Step by which the rate of lengths along a surface is found."""


@dataclass(frozen=True)
class SurfacePlaces:
    """Points of all faces, each with the plane that touches the surface there.

    Attributes
    ----------
    point_mm, normal : in the object's frame
    face : index of the face
    xy_mm, across : place in the face's plane, and its change with the point
    place_mm, rate : lengths along the surface, and their change with x and y
    half_mm, round : extents of the face, and whether it is an ellipse
    squared_mm2, towards : a point p under a push f is nearest where squared − 2 towards · (p, f) is least
    """

    point_mm: Float[Array, "sample 3"]
    normal: Float[Array, "sample 3"]
    face: Int[Array, "sample"]
    xy_mm: Float[Array, "sample 2"]
    across: Float[Array, "sample 2 3"]
    place_mm: Float[Array, "sample 2"]
    rate: Float[Array, "sample 2"]
    half_mm: Float[Array, "sample 2"]
    round: Bool[Array, "sample"]
    squared_mm2: Float[Array, "sample"]
    towards: Float[Array, "sample 6"]

    def moved_to(self, reference: Array) -> SurfacePlaces:
        """The same where the reference is."""
        return SurfacePlaces(
            **{part.name: like(reference, getattr(self, part.name)) for part in fields(self)}
        )

    def nearest(
        self, points_mm: Float[Array, "n 3"], push: Float[Array, "n 3"]
    ) -> tuple[Int[Array, "n"], Float[Array, "n 2"], Float[Array, "n 3"]]:
        """Return the nearest face of each point (-1: none), the place on it (mm) and its normal.

        `push` is the direction of the force, of length 1 or 0 where none is known. Near an edge it
        decides which face is pressed.
        """
        xp = library(points_mm)
        pressed = xp.concatenate([points_mm, push], -1)
        sample = apply_in_chunks(self._nearest_sample, _CHUNK, pressed)
        away = points_mm - self.point_mm[sample]
        normal = self.normal[sample]
        height = (away * normal).sum(-1)
        # each sample's change of place in its plane times the way from it
        shift = (self.across[sample] @ away[..., None])[..., 0]
        share = (self.xy_mm[sample] + shift) / self.half_mm[sample]
        outside = xp.where(
            self.round[sample], (share**2).sum(-1), abs(share[:, 0]).clip(abs(share[:, 1]))
        )
        on_face = (outside <= _BORDER) & (abs(height) <= _OFF_SURFACE_MM)
        place = self.place_mm[sample] + self.rate[sample] * shift
        return xp.where(on_face, self.face[sample], -1), place, normal

    def _nearest_sample(self, pressed: Float[Array, "n 6"]) -> Int[Array, "n"]:
        return library(pressed).argmin(self.squared_mm2 - 2 * pressed @ self.towards.T, 1)


def surface_places(frames: list[FaceFrame]) -> SurfacePlaces:
    """Points spread over the half extents of every face, as far as its surface reaches.

    Where patches of a curved body overlap, each point is on the one whose middle it is nearer to. So
    the border of another patch takes no contact that lies beyond it.
    """
    parts = [_face_samples(index, frame) for index, frame in enumerate(frames)]
    kept = [
        _is_most_central(part[0], frame, [face for face in frames if face is not frame])
        for part, frame in zip(parts, frames, strict=True)
    ]
    parts = [tuple(column[keep] for column in part) for part, keep in zip(parts, kept, strict=True)]
    return SurfacePlaces(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _is_most_central(
    point_mm: Float[np.ndarray, "sample 3"], frame: FaceFrame, neighbours: list[FaceFrame]
) -> Bool[np.ndarray, "sample"]:
    """Return which points of a face no other face holds nearer to its middle."""
    central = _share_of_reach(point_mm, frame)
    kept = np.ones(len(point_mm), bool)
    for neighbour in neighbours:
        xy = (point_mm - neighbour.centre_mm) @ neighbour.axes[:, :2]
        covered = np.flatnonzero(neighbour.covers(xy))
        foot = neighbour.to_object(np.pad(xy[covered], ((0, 0), (0, 1))))
        shared = covered[np.linalg.norm(foot - point_mm[covered], axis=1) < _SAME_MM]
        kept[shared] &= _share_of_reach(point_mm[shared], neighbour) >= central[shared]
    return kept


def _share_of_reach(
    point_mm: Float[np.ndarray, "sample 3"], frame: FaceFrame
) -> Float[np.ndarray, "sample"]:
    """Return how far from the middle points lie: 1 on the border."""
    share = (point_mm - frame.centre_mm) @ frame.axes[:, :2] / frame.half_extents_mm
    return np.hypot(*share.T) if frame.round else abs(share).max(axis=1)


def _face_samples(index: int, frame: FaceFrame) -> tuple[np.ndarray, ...]:
    share = (2 * np.arange(_SAMPLES) + 1) / _SAMPLES - 1
    xy = np.stack(np.meshgrid(share, share), axis=-1).reshape(-1, 2) * frame.half_extents_mm
    xy = xy[frame.covers(xy)]
    point, normal = frame.to_object(np.pad(xy, ((0, 0), (0, 1)))), frame.axes_at(xy)[..., 2]
    # what moves a point along the surface moves it in the plane; what lifts it does not
    in_plane = np.eye(3) - normal[:, :, None] * normal[:, None]
    across = frame.axes[:, :2].T @ in_plane
    shift = np.full(2, _SHIFT_MM)
    rate = (frame.from_plane(xy + shift) - frame.from_plane(xy - shift)) / (2 * shift)
    columns = (np.full(len(xy), index), xy, across, frame.from_plane(xy), rate)
    half = np.broadcast_to(frame.half_extents_mm, xy.shape)
    around, squared = np.full(len(xy), frame.round), np.sum(point**2, axis=1)
    # |p − s|² without the |p|² that all samples share, and d² less where a push f meets n: + d² f·n
    towards = np.hstack([point, -0.5 * _OFF_SURFACE_MM**2 * normal])
    return point, normal, *columns, half, around, squared, towards
