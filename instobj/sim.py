"""Instrumented object in a physics simulator: contacts in, counts of every channel out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float, Int
from scipy.spatial import KDTree

from design.layout.body import face_frames
from estimator.inversion.storage import load_inversion
from estimator.signals.hall import read_out
from estimator.signals.nuisances import ambient_field
from estimator.signals.presses import rest_counts

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

__all__ = ["HallObject"]

_MM_PER_M = 1e3
_PYRAMIDAL = 0
"""MuJoCo's number of a friction cone with edges, `mjCONE_PYRAMIDAL`."""
_OFF_SURFACE_MM = 3.0
"""A contact point farther from a sensed face is on another side: bodies of a simulator sink into each
other by a fraction of this."""
_SAMPLES = 16
"""Points along each side of a face, from which the nearest face of a contact is told."""
_NEAR_IN_TIPS = 1.0
"""Contacts this many tip radii apart press the same silicone by exp(-1)."""


class HallObject:
    """Hall sensors of one object under the contacts of a simulator; a call of `read` is one frame.

    The motions that contacts give the magnets come from stored presses and add up; the field of
    all magnets follows exactly. Silicone yields less the harder it is pressed, so contacts near
    each other are looked up at the force that they have together. Places beyond the outermost
    presses of a face are read at the nearest of these. Normal forces alone count, and sides
    without sensors feel nothing. Against joint contact mechanics of tips of 5 mm radius on the
    paper's cube, 2 to 8 N: 1.1 % of a contact's signals (rms) at most, two on a face 3.6 %.

    Parameters
    ----------
    contacts : path
        `contacts.nc` of a run (`instobj train SPEC --set training.model=inversion`).
    ambient_ut : (3,)
        Uniform field in the world, µT; it turns in the object's frame as the object turns.
    seed : int or None
        Of the noise. None leaves out noise, rounding to counts and clipping.

    Attributes
    ----------
    spec : ObjectSpec
    rest_counts : (sensor, 3) expected counts without contact and without ambient field

    Raises
    ------
    InputError
        No such file, or another one.
    StoreError
        Damaged.

    Examples
    --------
    >>> import numpy as np
    >>> from instobj.sim import HallObject
    >>> cube = HallObject("contacts.nc")
    >>> top = np.array([[0.0, 0.0, cube.spec.body.size_mm[2] / 2]])
    >>> cube.read(top, np.array([4.0])).shape == cube.rest_counts.shape
    True
    """

    def __init__(
        self,
        contacts: Path | str,
        ambient_ut: tuple[float, float, float] = (0.0, 0.0, 0.0),
        seed: int | None = 0,
    ) -> None:
        self._model = load_inversion(contacts).model
        self.spec: ObjectSpec = self._model.spec
        frames = {frame.number: frame for frame in face_frames(self.spec)}
        self._faces = [frames[number] for number in self._model.signals.faces.tolist()]
        self._surface = KDTree(np.concatenate([_samples_mm(frame) for frame in self._faces]))
        self.rest_counts = rest_counts(self.spec)
        field = ambient_field(self.spec.changed(tolerances={"earth_field_ut": 1.0}))
        self._counts_per_ut = field.columns / field.deviation
        self._ambient_ut = np.asarray(ambient_ut, float)
        self._rng = None if seed is None else np.random.default_rng(seed)
        self._relaxation = _Relaxation(self.spec, len(self._faces))

    def __repr__(self) -> str:
        sensors = len(self.rest_counts)
        return f"HallObject of {self.spec.name}: counts of {sensors} sensors × 3 axes"

    def read(
        self,
        points_mm: Float[np.ndarray, "contact 3"],
        force_n: Float[np.ndarray, "contact"],
        rotation: Float[np.ndarray, "3 3"] | None = None,
        step_s: float = 0.0,
    ) -> Float[np.ndarray, "sensor 3"]:
        """Return the counts of one frame.

        Parameters
        ----------
        points_mm : (contact, 3)
            Contact points in the object's frame.
        force_n : (contact,)
            Normal forces, N.
        rotation : (3, 3)
            Columns are the object's axes in the world; turns the ambient field.
        step_s : float
            Time since the last call, s. Forces relax by it where the silicone has `prony` terms.
        """
        face, place = self._project(points_mm)
        sensed = face >= 0
        contact = np.column_stack([place, force_n])[sensed]
        change = self._change(face[sensed], contact, step_s)
        turned = self._ambient_ut if rotation is None else rotation.T @ self._ambient_ut
        change = change + self._counts_per_ut @ turned
        expected = self.rest_counts + change.reshape(self.rest_counts.shape)
        if self._rng is None:
            return expected
        return read_out(expected, self.spec.sensors, self._rng)

    def read_mujoco(self, model: Any, data: Any, body: str) -> Float[np.ndarray, "sensor 3"]:
        """Return the counts of one frame under the contacts of a MuJoCo body.

        `model` and `data` are MuJoCo's; call it once a step, after `mj_step`. The body's frame is
        the object's, in metres.
        """
        number = model.body(body).id
        rotation = data.xmat[number].reshape(3, 3)
        points, forces = [], []
        for contact in data.contact[: data.ncon]:
            if contact.efc_address >= 0 and number in model.geom_bodyid[contact.geom]:
                points.append((contact.pos - data.xpos[number]) @ rotation)
                forces.append(_normal_force_n(model, data, contact))
        points_mm = _MM_PER_M * np.reshape(points, (-1, 3))
        return self.read(points_mm, np.array(forces), rotation, model.opt.timestep)

    def _project(
        self, points_mm: Float[np.ndarray, "contact 3"]
    ) -> tuple[Int[np.ndarray, "contact"], Float[np.ndarray, "contact 2"]]:
        """Return the nearest sensed face of each point (-1: none) and the place on it, mm."""
        sample = np.asarray(self._surface.query(points_mm)[1])
        face, place = sample // _SAMPLES**2, np.empty((len(points_mm), 2))
        for index in set(face.tolist()):
            here, frame = face == index, self._faces[index]
            local = frame.from_object(points_mm[here])
            off = ~frame.covers(local[:, :2]) | ~(abs(local[:, 2]) <= _OFF_SURFACE_MM)
            place[here] = frame.from_plane(local[:, :2])
            face[here] = np.where(off, -1, index)
        low, high = self._model.bounds
        return face, np.clip(place, low[:2], high[:2])

    def _change(
        self,
        face: Int[np.ndarray, "contact"],
        contact: Float[np.ndarray, "contact 3"],
        step_s: float,
    ) -> Float[np.ndarray, "channel"]:
        """Return what contacts (x, y in mm and force in N) on faces change, counts."""
        contact[:, 2] *= self._relaxation.stiffening(face, contact[:, 2], step_s)
        if not len(face):
            return np.zeros(self._model.channels)
        together = self._force_together(face, contact)
        share = np.divide(contact[:, 2], together, out=np.zeros_like(together), where=together > 0)
        contact[:, 2] = together
        moved = self._model.motions.values(face, contact)[:, 0] * share[:, None]
        motion = moved.sum(axis=0, dtype=float).reshape(1, *self._model.rest.shape)
        return self._model.counts_of_motions(motion)[0]

    def _force_together(
        self, face: Int[np.ndarray, "contact"], contact: Float[np.ndarray, "contact 3"]
    ) -> Float[np.ndarray, "contact"]:
        """Return the force (N) of each contact and of neighbours, who count less with distance."""
        reach_mm = _NEAR_IN_TIPS * self.spec.indenter.radius_mm
        apart = contact[:, None, :2] - contact[None, :, :2]
        # squares over x and y; a contact is its own neighbour in full
        near = np.exp(-np.square(apart).sum(axis=2) / reach_mm**2)
        return (near * (face[:, None] == face)) @ contact[:, 2]


def _normal_force_n(model: Any, data: Any, contact: Any) -> float:
    """Return the normal force of one contact of MuJoCo, as its `mj_contactForce` does."""
    rows = 1
    # Edges of a friction pyramid share the normal force; an elliptic cone has it in its first row
    if model.opt.cone == _PYRAMIDAL and contact.dim > 1:
        rows = 2 * (contact.dim - 1)
    return float(data.efc_force[contact.efc_address : contact.efc_address + rows].sum())


def _samples_mm(frame: FaceFrame) -> Float[np.ndarray, "sample 3"]:
    """Return points of one face's surface, spread over its frame's rectangle."""
    share = np.linspace(-1, 1, _SAMPLES)
    xy = np.stack(np.meshgrid(share, share), axis=-1).reshape(-1, 2) * frame.half_extents_mm
    return frame.to_object(np.column_stack([xy, np.zeros(len(xy))]))


class _Relaxation:
    """Forces that relaxed silicone bears, as forces of the elastic presses that move magnets as far.

    A Prony series (`fem.presses.viscoelastic`), by face: contacts of a simulator come and go, and
    the sum over a face is what lasts.
    """

    def __init__(self, spec: ObjectSpec, faces: int) -> None:
        self._fraction = np.array([term.fraction for term in spec.silicone.prony])[:, None]
        self._time_s = np.array([term.time_s for term in spec.silicone.prony])[:, None]
        self._memory_n = np.zeros((len(self._fraction), faces))
        self._elastic_n = np.zeros(faces)

    def stiffening(
        self, face: Int[np.ndarray, "contact"], force_n: Float[np.ndarray, "contact"], step_s: float
    ) -> Float[np.ndarray, "contact"]:
        """Return the factor on the force of each contact after a step."""
        if not len(self._fraction):
            return np.ones(len(face))
        felt = np.bincount(face, force_n, len(self._elastic_n))
        decay = np.exp(-step_s / self._time_s)
        # memory' = decay memory + gain (elastic' - elastic); gain of a linear rise within the step
        gain = (1 - decay) * self._time_s / step_s if step_s else np.ones_like(decay)
        held = (self._fraction * (decay * self._memory_n - gain * self._elastic_n)).sum(axis=0)
        lasting = 1 - self._fraction.sum() + (self._fraction * gain).sum()
        # felt = (1 - sum of fractions) elastic' + sum of fractions memory', solved for elastic'
        elastic = np.maximum(felt - held, 0.0) / lasting
        self._memory_n = decay * self._memory_n + gain * (elastic - self._elastic_n)
        self._elastic_n = elastic
        factor = np.divide(elastic, felt, out=np.ones_like(felt), where=felt > 0)
        return factor[face]
