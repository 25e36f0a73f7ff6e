"""Instrumented object in a physics simulator: contacts in, counts of every channel out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float, Int

from design.layout.body import face_frames
from estimator.inversion.model.arrays import Array, float64, library, like
from estimator.inversion.model.forward import NONE
from estimator.inversion.model.joint_response import joint_response
from estimator.inversion.model.places import surface_places
from estimator.inversion.storage import load_inversion
from estimator.signals.hall import full_scale_counts
from estimator.signals.nuisances import ambient_field
from estimator.signals.presses import rest_counts

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

__all__ = ["HallObject"]

_MM_PER_M = 1e3
_PYRAMIDAL = 0
"""MuJoCo's number of a friction cone with edges, `mjCONE_PYRAMIDAL`."""
_NEAR_IN_TIPS = 1.0
"""Contacts this many tip radii apart press the same silicone by exp(-1)."""


class HallObject:
    """Hall sensors of one object under the contacts of a simulator; a call of `read` is one frame.

    Stored presses say what each contact changes. What contacts do to each other follows from the
    curvature of each magnet's field. Silicone yields less the harder it is pressed, so contacts
    near each other are looked up at the force that they have together. Places and forces beyond
    the outermost presses of a face are read at the nearest of these. Normal forces alone count,
    and sides without sensors feel nothing.

    Against joint contact mechanics of tips of 5 mm radius on the paper's cube, 0.8 to 14 N, the
    largest error of 60 states is 0.8 % of the signals (rms) for one contact. For two on a face it
    is 2.1 % at 10.5 mm, 1.3 % at 15 mm and 0.9 % at 22 mm from each other, on two faces 1.3 %.

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
        model = load_inversion(contacts).model
        self.spec: ObjectSpec = model.spec
        frames = {frame.number: frame for frame in face_frames(self.spec)}
        faces = [frames[number] for number in model.signals.faces.tolist()]
        self.rest_counts = rest_counts(self.spec)
        field = ambient_field(self.spec.changed(tolerances={"earth_field_ut": 1.0}))
        ambient = np.asarray(ambient_ut, float)
        self._tables = surface_places(faces), joint_response(model)
        self._arrays = {
            "low": model.bounds[0],
            "high": model.bounds[1],
            "rest": self.rest_counts.ravel(),
            "ambient_ut": ambient,
            "counts_per_ut": (field.columns / field.deviation).T,
            "noise": np.asarray(self.spec.sensors.noise_counts, float),
            "faces": np.arange(len(faces)),
        }
        self._seed = seed
        self._relaxation = _Relaxation(self.spec)
        self._known: dict[str, tuple[Any, Any, dict[str, Array], Callable[..., Array]]] = {}

    def __repr__(self) -> str:
        sensors = len(self.rest_counts)
        return f"HallObject of {self.spec.name}: counts of {sensors} sensors × 3 axes"

    def read(
        self,
        points_mm: Float[Array, "*object contact 3"],
        force_n: Float[Array, "*object contact"],
        rotation: Float[Array, "*object 3 3"] | None = None,
        step_s: float = 0.0,
    ) -> Float[Array, "*object sensor 3"]:
        """Return the counts of one frame, of one object or of many alike.

        NumPy's arrays or tensors of torch; tensors are worked on where they are. Many objects take
        one call a step, and slots of fewer contacts are filled with forces of 0.

        Parameters
        ----------
        points_mm : (contact, 3) or (object, contact, 3)
            Contact points in the object's frame.
        force_n : (contact,) or (object, contact)
            Normal forces, N.
        rotation : (3, 3) or (object, 3, 3)
            Columns are the object's axes in the world; turns the ambient field.
        step_s : float
            Time since the last call, s. Forces relax by it where the silicone has `prony` terms.
        """
        of_one = points_mm.ndim == 2
        points, force = float64(points_mm), float64(force_n)
        if of_one:
            points, force = points[None], force[None]
        places, response, arrays, draw = self._prepare(points)
        face, place = places.nearest(points.reshape(-1, 3))
        face = face.reshape(force.shape)
        # a slot without force has no face
        face = library(face).where(force > 0, face, NONE)
        place = place.reshape(*force.shape, 2).clip(arrays["low"][:2], arrays["high"][:2])
        on_face = face[..., None] == arrays["faces"]
        force = force * self._relaxation.stiffening(on_face, force, step_s)
        together = self._force_together(face, place, force)
        share = force / (together + (together == 0))
        contact = library(place).concatenate(
            [place, together.clip(None, arrays["high"][2])[..., None]], -1
        )
        turned = arrays["ambient_ut"]
        if rotation is not None:
            # rotationᵀ · field of each object
            turned = turned @ float64(rotation)
        expected = arrays["rest"] + turned @ arrays["counts_per_ut"]
        expected = expected + response.changes(face, contact, share)
        shape = self.rest_counts.shape if of_one else (len(force), *self.rest_counts.shape)
        return self._read_out(expected.reshape(shape), arrays["noise"], draw)

    def read_mujoco(self, model: Any, data: Any, body: str) -> Float[np.ndarray, "sensor 3"]:
        """Return the counts of one frame under the contacts of a MuJoCo body.

        `model` and `data` are MuJoCo's; call it once a step, after `mj_step`. The body's frame is
        the object's, in metres.
        """
        number = model.body(body).id
        rotation = data.xmat[number].reshape(3, 3)
        all_contacts = data.contact
        touches = (model.geom_bodyid[all_contacts.geom] == number).any(axis=1)
        mine = touches & (all_contacts.efc_address >= 0)
        points_mm = _MM_PER_M * (all_contacts.pos[mine] - data.xpos[number]) @ rotation
        rows = np.ones(int(mine.sum()), int)
        # Edges of a friction pyramid share the normal force; an elliptic cone has it in its first row
        if model.opt.cone == _PYRAMIDAL:
            rows = np.maximum(2 * (all_contacts.dim[mine] - 1), 1)
        first = all_contacts.efc_address[mine]
        force = [data.efc_force[k : k + n].sum() for k, n in zip(first, rows, strict=True)]
        return self.read(points_mm, np.array(force), rotation, model.opt.timestep)

    def _prepare(self, reference: Array) -> tuple[Any, Any, dict[str, Array], Callable[..., Array]]:
        """Return tables, arrays and the source of noise as arrays of the reference's kind."""
        on_host = isinstance(reference, np.ndarray)
        device = "" if on_host else str(reference.device)
        if device not in self._known:
            places, response = (table.moved_to(reference) for table in self._tables)
            arrays = {name: like(reference, array) for name, array in self._arrays.items()}
            self._known[device] = places, response, arrays, _noise_source(reference, self._seed)
        return self._known[device]

    def _read_out(self, expected: Array, sigma: Array, draw: Callable[..., Array]) -> Array:
        """Return whole counts with the chips' noise, clipped; as expected without a seed."""
        if self._seed is None:
            return expected
        limit = full_scale_counts(self.spec.sensors)
        return (expected + draw(expected.shape) * sigma).round().clip(-limit, limit)

    def _force_together(
        self,
        face: Int[Array, "object contact"],
        place: Float[Array, "object contact 2"],
        force_n: Float[Array, "object contact"],
    ) -> Float[Array, "object contact"]:
        """Return the force (N) of each contact and of neighbours, who count less with distance."""
        reach_mm = _NEAR_IN_TIPS * self.spec.indenter.radius_mm
        apart = place[:, :, None] - place[:, None]
        # squares over x and y; a contact is its own neighbour in full
        near = library(place).exp(-(apart**2).sum(-1) / reach_mm**2)
        near = near * (face[:, :, None] == face[:, None])
        return (near @ force_n[..., None])[..., 0]


def _noise_source(reference: Array, seed: int | None) -> Callable[..., Array]:
    """Return what draws standard normal numbers of a shape, of the reference's kind."""
    if isinstance(reference, np.ndarray):
        return np.random.default_rng(seed).standard_normal
    xp = library(reference)
    generator = xp.Generator(reference.device).manual_seed(seed or 0)
    return lambda shape: reference.new_empty(shape).normal_(generator=generator)


class _Relaxation:
    """Forces that relaxed silicone bears, as forces of the elastic presses that move magnets as far.

    A Prony series (`fem.presses.viscoelastic`), by face: contacts of a simulator come and go, and
    the sum over a face is what lasts.
    """

    def __init__(self, spec: ObjectSpec) -> None:
        self._fraction = np.array([term.fraction for term in spec.silicone.prony])
        self._time_s = np.array([term.time_s for term in spec.silicone.prony])
        self._memory_n: Array = None
        self._elastic_n: Array = None

    def stiffening(
        self,
        on_face: Array,
        force_n: Float[Array, "object contact"],
        step_s: float,
    ) -> Any:
        """Return the factor on the force of each contact (object, contact, face) after a step."""
        if not len(self._fraction):
            return 1.0
        felt = (on_face * force_n[..., None]).sum(1)
        fraction, time_s = (
            like(force_n, given)[:, None, None] for given in (self._fraction, self._time_s)
        )
        if self._memory_n is None:
            self._memory_n, self._elastic_n = 0 * fraction * felt, 0 * felt
        decay = library(fraction).exp(-step_s / time_s)
        # memory' = decay memory + gain (elastic' - elastic); gain of a linear rise within the step
        gain = (1 - decay) * time_s / step_s if step_s else 0 * decay + 1
        held = (fraction * (decay * self._memory_n - gain * self._elastic_n)).sum(0)
        lasting = 1 - fraction.sum() + (fraction * gain).sum()
        # felt = (1 - sum of fractions) elastic' + sum of fractions memory', solved for elastic'
        elastic = (felt - held).clip(0.0) / lasting
        self._memory_n = decay * self._memory_n + gain * (elastic - self._elastic_n)
        self._elastic_n = elastic
        factor = elastic / (felt + (felt == 0))
        return (on_face * factor[:, None]).sum(-1)
