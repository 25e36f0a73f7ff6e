"""Contacts of an object over time, from any estimator or from labels, with their uncertainty."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.stats import chi2, norm

from design.body.surface_chart import FaceFrame
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.inversion.readings import ContactSets
from estimator.networks.prediction import Prediction

NORMAL_MAD = 1.4826
"""Standard deviation over median absolute deviation of a normal error."""
_EFFICIENCY = 0.37 * 2 / 3
"""Degrees of freedom that a difference of successive frames adds to their variance: a median absolute
deviation has 0.37 of the efficiency of a root mean square (Rousseeuw & Croux, J. Am. Stat. Assoc. 88, 1993),
differences have 2/3 of that of deviations (von Neumann, Ann. Math. Stat. 12, 1941)."""
_SHARES = (np.arange(64) + 0.5) / 64
"""Shares of an error that may be new in every frame, over which is summed."""
_BY_FRAME = ("time_s", "face", "xy_mm", "force_n", "covariance", "explained", "jaws")
"""Fields of a track with a row for each frame."""
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
    jaws : (frame,) frames whose contacts are flat jaws, not round tips
    scale_error : standard deviation of a factor that all forces have in common (of the modulus), relative
    """

    time_s: Float[np.ndarray, "frame"]
    face: Int[np.ndarray, "frame contact"]
    xy_mm: Float[np.ndarray, "frame contact 2"]
    force_n: Float[np.ndarray, "frame contact 3"]
    covariance: Float[np.ndarray, "frame contact 5 5"]
    explained: Bool[np.ndarray, "frame"]
    jaws: Bool[np.ndarray, "frame"]
    scale_error: float = 0.0

    def __len__(self) -> int:
        return len(self.time_s)

    def select(
        self, frames: slice | Int[np.ndarray, "some"] | Bool[np.ndarray, "frame"]
    ) -> ContactTrack:
        """The given frames, in order."""
        return replace(self, **{name: getattr(self, name)[frames] for name in _BY_FRAME})

    @classmethod
    def joined(cls, parts: Sequence[ContactTrack]) -> ContactTrack:
        """Parts one after the other, of one estimator."""
        columns = {
            name: np.concatenate([getattr(part, name) for part in parts]) for name in _BY_FRAME
        }
        return replace(parts[0], **columns)

    def averaged(self, frames: Int[np.ndarray, "some"]) -> ContactTrack:
        """Mean of frames with the same contacts, as one frame.

        Of the variances of a frame, what is new in each of n frames falls to 1/n, and the rest lasts.
        """
        values = np.concatenate([self.xy_mm, self.force_n], axis=2)[frames]
        covariance = self.covariance[frames].mean(axis=0)
        variance = np.diagonal(covariance, axis1=1, axis2=2)
        lasting = variance_of_mean(variance, values)
        # correlations between coordinates stay, only their deviations shrink
        ratio = np.sqrt(
            np.divide(lasting, variance, out=np.ones_like(variance), where=variance > 0)
        )
        covariance = covariance * ratio[:, :, None] * ratio[:, None, :]
        mean = values.mean(axis=0)[None]
        return ContactTrack(
            self.time_s[frames].mean(keepdims=True), self.face[frames[:1]], mean[..., :2], mean[..., 2:],
            covariance[None], np.array([self.explained[frames].all()]),
            np.array([self.jaws[frames].any()]), self.scale_error,
        )  # fmt: skip

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
        """Standard deviation of `total_n`; errors of contacts are independent but for the common factor."""
        return np.hypot(
            np.sqrt(self.covariance[..., 4, 4].sum(axis=1)), self.scale_error * self.total_n
        )

    def face_force_n(self, face: int) -> Float[np.ndarray, "frame"]:
        """Sum of the normal forces on a face."""
        return np.where(self.face == face, self.normal_n, 0.0).sum(axis=1)

    def face_sigma_n(self, face: int) -> Float[np.ndarray, "frame"]:
        """Standard deviation of `face_force_n`, as that of `total_n`."""
        independent = np.where(self.face == face, self.covariance[..., 4, 4], 0.0).sum(axis=1)
        return np.hypot(np.sqrt(independent), self.scale_error * self.face_force_n(face))

    def face_centre_mm(self, face: int) -> Float[np.ndarray, "frame 2"]:
        """Centre of the normal forces on a face; NaN in frames without a contact there."""
        weight = np.where(self.face == face, self.normal_n, 0.0)[..., None]
        total = weight.sum(axis=1)
        moment = (weight * np.nan_to_num(self.xy_mm)).sum(axis=1)
        return np.divide(moment, total, out=np.full(moment.shape, np.nan), where=total > 0)


def fresh_variance(values: Float[np.ndarray, "frame *any"]) -> Float[np.ndarray, "*any"]:
    """Variance of what is new in every frame, by the median of successive differences; 0 of fewer than three
    frames."""
    if len(values) < 3:
        return np.zeros(values.shape[1:])
    steps = np.diff(values, axis=0)
    # a difference of two frames varies twice as much as one of them
    scatter = NORMAL_MAD * np.median(abs(steps - np.median(steps, axis=0)), axis=0)
    # of one column NumPy gives a scalar, which callers would not take for an array
    return np.asarray(scatter**2 / 2)


def variance_of_mean(
    variance: Float[np.ndarray, "*any"], values: Float[np.ndarray, "frame *any"]
) -> Float[np.ndarray, "*any"]:
    """Variance of the mean of frames whose errors have a `variance` each, part of it new in every frame.

    The new part is some share of it, of 0 to 1, any of them as likely before. A few frames show it badly:
    where they scatter by chance as much as a frame's whole error, nothing would seem to last. So it is the
    mean of what the scatter leaves possible, a sample variance of few degrees of freedom.
    """
    count, fresh = len(values), np.nan_to_num(fresh_variance(values))
    ratio = np.divide(fresh, variance, out=np.zeros_like(fresh), where=variance > 0)[..., None]
    freedom = _EFFICIENCY * (count - 1)
    log_odds = -freedom / 2 * (np.log(_SHARES) + ratio / _SHARES)
    odds = np.exp(log_odds - log_odds.max(axis=-1, keepdims=True))
    # values that never change: nothing is new
    share = np.where(fresh > 0, odds @ _SHARES / odds.sum(axis=-1), 0.0)
    lasting = np.maximum(variance * (1 - (1 - 1 / count) * share), fresh / count)
    return np.asarray(np.minimum(lasting, variance))


def track_of_sets(
    time_s: Float[np.ndarray, "frame"], sets: ContactSets, force_error: float
) -> ContactTrack:
    """Contacts that an inversion found, whose forces are uncertain by a common `force_error` (relative)."""
    covariance = np.zeros((*sets.face.shape, 5, 5))
    # ContactSets orders x, y, normal force; tangential forces are independent of these
    rows = np.array([0, 1, 4])
    covariance[..., rows[:, None], rows] = np.nan_to_num(sets.covariance)
    for axis in (0, 1):
        covariance[..., 2 + axis, 2 + axis] = np.nan_to_num(sets.tangential_sigma_n[..., axis]) ** 2
    # the sets count the common error with each contact's own
    common = (force_error * np.nan_to_num(sets.force_n)) ** 2
    covariance[..., 4, 4] = np.maximum(covariance[..., 4, 4] - common, 0.0)
    force = np.concatenate([sets.tangential_n, sets.force_n[..., None]], axis=2)
    return ContactTrack(
        time_s, sets.face, sets.xy_mm, force, covariance, sets.explained, sets.jaws, force_error
    )


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
    tips = np.zeros(len(face), bool)
    return ContactTrack(time_s, face, xy, force, covariance, explained, tips)


def track_of_labels(frames: FrameSet) -> ContactTrack:
    """Contacts that load cells and labels tell, taken as exact.

    Tangential forces of recordings without a cell for them are written as 0 and count as unread.
    """
    force = frames.force_n.copy()
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
        np.zeros(shape[0], bool),
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
    scale_error : as there
    """

    face: Int[np.ndarray, "contact"]
    point_mm: Float[np.ndarray, "contact 3"]
    axes: Float[np.ndarray, "contact 3 3"]
    force_n: Float[np.ndarray, "contact 3"]
    covariance: Float[np.ndarray, "contact 5 5"]
    scale_error: float = 0.0

    def __len__(self) -> int:
        return len(self.face)

    @property
    def inward(self) -> Float[np.ndarray, "contact 3"]:
        """Inward normals: directions in which contacts push the object."""
        return self.axes[..., 2]

    def drawn(
        self, normals: Float[np.ndarray, "draw contact 5"], common: Float[np.ndarray, "draw"]
    ) -> list[Placed]:
        """Others of the contacts that the covariance and the common factor allow, from standard normal
        numbers; zeros give the contacts themselves.

        Points move in the tangent plane, so that normals stay: exact on flat faces.
        """
        # the symmetric root also exists where rows are 0, which Cholesky's does not
        value, vector = np.linalg.eigh(self.covariance)
        root = vector * np.sqrt(value.clip(0.0))[..., None, :]
        # draw d, contact c, of i and j of its five coordinates
        error = np.einsum("cij,dcj->dci", root, normals)
        points = self.point_mm + np.einsum("cij,dcj->dci", self.axes[..., :2], error[..., :2])
        forces = (self.force_n + error[..., 2:]) * (1 + self.scale_error * common)[:, None, None]
        forces[..., 2] = forces[..., 2].clip(0.0)
        each = zip(points, forces, strict=True)
        return [replace(self, point_mm=point, force_n=force) for point, force in each]


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
        track.scale_error,
    )
