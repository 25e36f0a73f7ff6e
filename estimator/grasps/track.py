"""Contacts of an object over time, from any estimator or from labels, with their uncertainty."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.stats import chi2, norm

from design.body.surface_chart import FaceFrame
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.inversion.readings import ContactSets
from estimator.networks.prediction import Prediction

_PRESSED = 0.5
"""Probability of a contact above which a network's frame counts as pressed."""


@dataclass(frozen=True)
class ContactTrack:
    """Contacts frame by frame.

    Attributes
    ----------
    time_s : (frame,)
    face : (frame, contact), `NO_FACE` where the slot is empty
    xy_mm : (frame, contact, 2) in the face's frame; NaN where empty
    force_n : (frame, contact, 3) along x, y and the inward normal of the face; NaN along x and y
        where the estimator takes contacts for frictionless
    covariance : (frame, contact, 5, 5) of x, y (mm) and the three forces (N); 0 where nothing is read
    explained : (frame,) frames that the estimator trusts
    """

    time_s: Float[np.ndarray, "frame"]
    face: Int[np.ndarray, "frame contact"]
    xy_mm: Float[np.ndarray, "frame contact 2"]
    force_n: Float[np.ndarray, "frame contact 3"]
    covariance: Float[np.ndarray, "frame contact 5 5"]
    explained: Bool[np.ndarray, "frame"]

    def __len__(self) -> int:
        return len(self.time_s)

    def select(
        self, frames: slice | Int[np.ndarray, "some"] | Bool[np.ndarray, "frame"]
    ) -> ContactTrack:
        """The given frames, in order."""
        return ContactTrack(*(getattr(self, field.name)[frames] for field in fields(self)))

    @property
    def has_tangential(self) -> bool:
        """Return whether any tangential force was read."""
        return bool(np.isfinite(self.force_n[..., :2]).any())

    @property
    def normal_n(self) -> Float[np.ndarray, "frame contact"]:
        """Normal force of each contact, 0 where the slot is empty."""
        return np.where(self.face != NO_FACE, np.nan_to_num(self.force_n[..., 2]), 0.0)

    @property
    def total_n(self) -> Float[np.ndarray, "frame"]:
        """Sum of the normal forces."""
        return self.normal_n.sum(axis=1)

    @property
    def total_sigma_n(self) -> Float[np.ndarray, "frame"]:
        """Standard deviation of `total_n`; errors of contacts count as independent."""
        return np.sqrt(self.covariance[..., 4, 4].sum(axis=1))

    def face_force_n(self, face: int) -> Float[np.ndarray, "frame"]:
        """Sum of the normal forces on a face."""
        return np.where(self.face == face, self.normal_n, 0.0).sum(axis=1)

    def face_sigma_n(self, face: int) -> Float[np.ndarray, "frame"]:
        """Standard deviation of `face_force_n`; errors of contacts count as independent."""
        return np.sqrt(np.where(self.face == face, self.covariance[..., 4, 4], 0.0).sum(axis=1))

    def face_centre_mm(self, face: int) -> Float[np.ndarray, "frame 2"]:
        """Centre of the normal forces on a face; NaN in frames without a contact there."""
        weight = np.where(self.face == face, self.normal_n, 0.0)[..., None]
        total = weight.sum(axis=1)
        moment = (weight * np.nan_to_num(self.xy_mm)).sum(axis=1)
        return np.divide(moment, total, out=np.full(moment.shape, np.nan), where=total > 0)


def track_of_sets(time_s: Float[np.ndarray, "frame"], sets: ContactSets) -> ContactTrack:
    """Contacts that an inversion found."""
    covariance = np.zeros((*sets.face.shape, 5, 5))
    # ContactSets orders x, y, normal force; tangential forces are independent of these
    rows = np.array([0, 1, 4])
    covariance[..., rows[:, None], rows] = np.nan_to_num(sets.covariance)
    for axis in (0, 1):
        covariance[..., 2 + axis, 2 + axis] = np.nan_to_num(sets.tangential_sigma_n[..., axis]) ** 2
    force = np.concatenate([sets.tangential_n, sets.force_n[..., None]], axis=2)
    return ContactTrack(time_s, sets.face, sets.xy_mm, force, covariance, sets.explained)


def track_of_networks(
    time_s: Float[np.ndarray, "frame"], predictions: Mapping[int, Prediction], cover: float
) -> ContactTrack:
    """One contact per face: the whole force and the centre that each face's network reads.

    Intervals that hold the share `cover` are taken for normal ones.
    """
    faces = sorted(predictions)
    columns = [predictions[face] for face in faces]
    pressed = np.stack([column.contact > _PRESSED for column in columns], axis=1)
    face = np.where(pressed, np.array(faces), NO_FACE)
    force = np.full((*face.shape, 3), np.nan)
    force[..., 2] = np.stack([column.force_n for column in columns], axis=1).clip(0.0)
    half = np.stack([column.force_halfwidth_n for column in columns], axis=1)
    radius = np.stack([column.position_radius_mm for column in columns], axis=1)
    covariance = np.zeros((*face.shape, 5, 5))
    # a radius holds the share in two dimensions: r² = σ² χ²₂(cover)
    covariance[..., 0, 0] = covariance[..., 1, 1] = radius**2 / chi2.ppf(cover, 2)
    covariance[..., 4, 4] = (half / norm.ppf(0.5 + cover / 2)) ** 2
    covariance = np.where(pressed[..., None, None], covariance, 0.0)
    force = np.where(pressed[..., None], force, np.nan)
    xy = np.stack([column.xy_mm for column in columns], axis=1)
    novel = np.stack([column.novel for column in columns], axis=1)
    explained = ~np.any(novel & pressed, axis=1)
    xy = np.where(pressed[..., None], xy, np.nan)
    return ContactTrack(time_s, face, xy, force, covariance, explained)


def track_of_labels(frames: FrameSet, true: bool = False) -> ContactTrack:
    """Contacts that load cells and labels tell, taken as exact; what each tip bears with `true`.

    Tangential forces of recordings without a cell for them are written as 0 and count as unread.
    """
    force = frames.true_force_n if true and frames.true_force_n is not None else frames.force_n
    force = force.copy()
    if not np.nan_to_num(force[..., :2]).any():
        force[..., :2] = np.nan
    shape = frames.contact_face.shape
    return ContactTrack(
        frames.time_s,
        frames.contact_face,
        frames.contact_xy_mm,
        force,
        np.zeros((*shape, 5, 5)),
        np.ones(shape[0], bool),
    )


@dataclass(frozen=True)
class Placed:
    """Contacts of one frame in the object's frame.

    Attributes
    ----------
    face : (contact,)
    point_mm : (contact, 3)
    axes : (contact, 3, 3) columns x, y and the inward normal
    force_n : (contact, 3) along these; NaN where not read
    covariance : (contact, 5, 5) as in `ContactTrack`
    """

    face: Int[np.ndarray, "contact"]
    point_mm: Float[np.ndarray, "contact 3"]
    axes: Float[np.ndarray, "contact 3 3"]
    force_n: Float[np.ndarray, "contact 3"]
    covariance: Float[np.ndarray, "contact 5 5"]

    def __len__(self) -> int:
        return len(self.face)

    @property
    def inward(self) -> Float[np.ndarray, "contact 3"]:
        """Inward normals: directions in which contacts push the object."""
        return self.axes[..., 2]

    def drawn(self, normals: Float[np.ndarray, "contact 5"]) -> Placed:
        """Another of the contacts that the covariance allows, from standard normal numbers.

        Points move in the tangent plane, so that normals stay: exact on flat faces.
        """
        # the symmetric root also exists where rows are 0, which Cholesky's does not
        value, vector = np.linalg.eigh(self.covariance)
        root = vector * np.sqrt(value.clip(0.0))[..., None, :]
        error = np.einsum("cij,cj->ci", root, normals)
        point = self.point_mm + np.einsum("cij,cj->ci", self.axes[..., :2], error[:, :2])
        force = self.force_n + error[:, 2:]
        force[:, 2] = force[:, 2].clip(0.0)
        return Placed(self.face, point, self.axes, force, self.covariance)


def placed_contacts(track: ContactTrack, frame: int, faces: Mapping[int, FaceFrame]) -> Placed:
    """Contacts of one frame in the object's frame; those on faces that it has not are left out."""
    slots = [slot for slot in range(track.face.shape[1]) if int(track.face[frame, slot]) in faces]
    point, axes = np.zeros((len(slots), 3)), np.zeros((len(slots), 3, 3))
    for row, slot in enumerate(slots):
        chart = faces[int(track.face[frame, slot])]
        xy = chart.to_plane(track.xy_mm[frame, slot])
        point[row] = chart.to_object(np.append(xy, 0.0))
        # the frame's third axis points out of the surface, contacts push inwards
        axes[row] = chart.axes_at(xy) * np.array([1.0, 1.0, -1.0])
    return Placed(
        track.face[frame, slots],
        point,
        axes,
        track.force_n[frame, slots],
        track.covariance[frame, slots],
    )
