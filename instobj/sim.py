"""Instrumented object in a physics simulator: contacts in, counts of every channel out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from jaxtyping import Float, Int

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_places import filled_places
from design.spec_io import load_spec
from estimator.inversion.model.arrays import Array, float32, float64, library, like, zeros
from estimator.inversion.model.forward import NONE, ContactModel, contact_model
from estimator.inversion.model.joint_response import JointResponse, joint_response
from estimator.inversion.model.places import SurfacePlaces, surface_places
from estimator.inversion.model.table import PressTable
from estimator.inversion.steps import Relaxation, Sampling
from estimator.inversion.storage import load_inversion
from estimator.signals.hall import full_scale_counts
from estimator.signals.nuisances import ambient_field, warmth
from estimator.signals.presses import rest_counts
from instobj.store.readers import PRESSES, SHEAR, SIGNALS

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

__all__ = ["HallObject"]

_MM_PER_M = 1e3
_PITCH_MM = 3.0
"""Pitch of a specification's presses, at most: interpolation between those 7 mm apart errs by up to 37 %."""
_NEAR_IN_TIPS = 1.0
"""Contacts this many tip radii apart press the same silicone by exp(-1)."""


class HallObject:
    """Hall sensors of one object under the contacts of a simulator; a call of `read` is one step.

    Stored presses say what each contact changes. What contacts do to each other follows from the
    curvature of each magnet's field. Silicone yields less the harder it is pressed, so contacts
    near each other are looked up at the force that they have together. Sides without sensors feel
    nothing. Friction counts where the file holds tangential forces: `inversion.tangential_share`
    above 0 in the training, which needs flat faces.

    Against joint contact mechanics on the paper's cube, tips of 5 mm radius anywhere on its faces, up
    to 12 N, the largest error of 200 states is 0.8 % of the signals (rms) for one contact. For two on
    a face it is 7 % at 10.5 mm from each other (95 % of states: 4.2 %), 2.1 % at 15 mm and 0.9 % at
    25 mm, on two faces 2.2 %. In the inner half of the patches of a ball of 50 mm (60 states) it is
    1.0 % for one contact, for two on a face 3.6 % at 10.5 mm and 2.1 % at 15 mm.
    Of a specification presses are simulated out to the edges of all flat faces, 3 mm apart at most. In
    a box whose edges fit no such pitch the outermost millimetre is extrapolated and errs by up to 5 %.
    `contacts.nc` holds presses of its `contact_grid` alone. Places and forces beyond the outermost are
    read at the nearest: the error grows by 30 % of the signals per mm.
    Near an edge the direction of a force says which face it presses; without directions the nearest
    face is pressed.

    Parameters
    ----------
    source : path
        Specification (`.toml`), or `contacts.nc` of a run, as of a calibrated twin (`instobj train
        FRAMES --twin SPEC --set training.model=inversion`).
    ambient_ut : (3,)
        Uniform field in the world, µT; it turns in the object's frame as the object turns.
    seed : int or None
        Of noise and drift. None leaves out noise, drift, rounding to counts and clipping.
    delay_s : float
        From the sampling of a frame to its arrival, s. Frames are taken at `sensors.frame_rate_hz`
        where steps have a duration, and the last that arrived is returned.

    Attributes
    ----------
    spec : ObjectSpec
    rest_counts : (sensor, 3) expected counts without contact and without ambient field
    feels_friction : whether tangential forces change the counts

    Raises
    ------
    InputError
        No such file, another one, an invalid specification, or a negative delay.
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
        source: Path | str,
        ambient_ut: tuple[float, float, float] = (0.0, 0.0, 0.0),
        seed: int | None = 0,
        delay_s: float = 0.0,
    ) -> None:
        if not delay_s >= 0:
            raise InputError(f"delay_s is a time of 0 s or more; got {delay_s:g}. Give 0 for none")
        if len(ambient_ut) != 3:
            raise InputError(f"ambient_ut has x, y and z in µT; got {len(ambient_ut)} numbers")
        model = _pressed_to_the_edges(source) if _is_spec(source) else load_inversion(source).model
        self.spec: ObjectSpec = model.spec
        frames = {frame.number: frame for frame in face_frames(self.spec)}
        faces = [frames[number] for number in model.signals.faces.tolist()]
        self.rest_counts = rest_counts(self.spec)
        self.feels_friction = model.shear is not None
        field = ambient_field(self.spec.changed(tolerances={"earth_field_ut": 1.0}))
        warm = warmth(self.spec.changed(tolerances={"temperature_k": 1.0}))
        tables = [surface_places(faces), joint_response(model)]
        self._tables = tables if model.shear is None else [*tables, model.shear]
        low, high = _bounds_to_the_edges(model) if _is_spec(source) else model.bounds
        self._arrays = {
            "low": low,
            "high": high,
            "rest": self.rest_counts.ravel(),
            "ambient_ut": np.asarray(ambient_ut, float),
            "counts_per_ut": (field.columns / field.deviation).T,
            "counts_per_k": warm.columns[:, 0],
            "noise": np.asarray(self.spec.sensors.noise_counts, float),
            "faces": np.arange(len(faces)),
            "tangents": np.stack([frame.axes[:, :2] for frame in faces]),
        }
        self._seed = seed
        self._delay_s = delay_s
        self._known: dict[str, tuple[Any, dict[str, Array], Callable[..., Array]]] = {}
        self.reset()

    def __repr__(self) -> str:
        sensors = len(self.rest_counts)
        return f"HallObject of {self.spec.name}: counts of {sensors} sensors × 3 axes"

    def reset(self) -> None:
        """Begin again, as after a new zero: no relaxation, no frame under way, another drift.

        `read` does so by itself where the number of objects changes.
        """
        self._objects = 0
        self._relaxation = Relaxation(self.spec.silicone.prony)
        self._sampling = Sampling(self.spec.sensors.frame_rate_hz, self._delay_s)
        self._drift: Array = None

    def read(
        self,
        points_mm: Float[Array, "*object contact 3"],
        force_n: Float[Array, "*object contact"] | Float[Array, "*object contact 3"],
        rotation: Float[Array, "*object 3 3"] | None = None,
        step_s: float = 0.0,
        warming_k: float | Float[Array, "object"] = 0.0,
    ) -> Float[Array, "*object sensor 3"]:
        """Return the counts that are read after one step, of one object or of many alike.

        NumPy's arrays or tensors of torch; tensors are worked on where they are. Many objects take
        one call a step, and slots of fewer contacts are filled with forces of 0.

        Parameters
        ----------
        points_mm : (contact, 3) or (object, contact, 3)
            Contact points in the object's frame.
        force_n : (contact,), (object, contact), or with a last axis of 3
            Normal forces, N; or forces on the object in its frame. Of these the part into the face
            presses, what pulls off counts as 0, and the part along the face is friction.
        rotation : (3, 3) or (object, 3, 3)
            Columns are the object's axes in the world; turns the ambient field.
        step_s : float
            Time since the last call, s. Forces relax by it where the silicone has `prony` terms.
            Without it the frame of this instant is returned.
        warming_k : float or (object,)
            Temperature of all magnets above that of the zero, K.

        Raises
        ------
        InputError
            Shapes that do not fit each other, a negative step, or what is no number. Numbers in tensors
            are not looked at, since this waits for a card.
        """
        _require_contacts(points_mm, force_n, rotation, step_s)
        of_one = points_mm.ndim == 2
        points, force = float64(points_mm), float64(force_n)
        if of_one:
            points, force = points[None], force[None]
        if self._objects not in (0, len(points)):
            self.reset()
        self._objects = len(points)
        (places, response, *shear), arrays, draw = self._prepare(points)
        felt = _find_places(places, arrays, points, force)
        pressed, changes = self._changes(response, arrays, felt, step_s)
        if felt.pull_n is not None and shear:
            changes = changes + _friction_changes(shear[0], pressed, felt)
        if not isinstance(warming_k, float) or warming_k:
            warming = like(points, warming_k).reshape(-1, 1)
            # remanence, and with it what contacts change, falls with temperature
            changes = changes * (1 + NDFEB_REMANENCE_PER_KELVIN * warming)
            changes = changes + warming * arrays["counts_per_k"]
        turned = arrays["ambient_ut"]
        if rotation is not None:
            # rotationᵀ · field of each object
            turned = turned @ float64(rotation)
        expected = arrays["rest"] + turned @ arrays["counts_per_ut"] + changes
        counts = self._read_out(
            expected.reshape(len(points), *self.rest_counts.shape), arrays["noise"], draw
        )
        counts = self._sampling.arrived(counts, step_s)
        return counts[0] if of_one else counts

    def read_world(
        self,
        points_m: Float[Array, "object contact 3"],
        force_n: Float[Array, "object contact 3"],
        position_m: Float[Array, "object 3"],
        rotation: Float[Array, "object 3 3"],
        step_s: float = 0.0,
    ) -> Float[Array, "object sensor 3"]:
        """Return the counts of many objects from contacts as simulators give them: in the world.

        Parameters
        ----------
        points_m : (object, contact, 3)
            Contact points, m. Slots of no contact hold NaN, or any point and no force.
        force_n : (object, contact, 3)
            Forces on the object, N: normal force and friction.
        position_m, rotation : (object, 3) and (object, 3, 3)
            The object's origin, m, and its axes as columns.
        step_s : float
            Time since the last call, s.
        """
        empty = ~library(points_m).isfinite(points_m).all(-1)[..., None]
        away = float64(points_m) - float64(position_m)[:, None]
        rotation = float64(rotation)
        # rows · rotation are coordinates along the object's axes
        points_mm = _MM_PER_M * library(away).where(empty, 0.0, away) @ rotation
        force = library(away).where(empty, 0.0, float64(force_n)) @ rotation
        return self.read(points_mm, force, rotation, step_s)

    def read_mujoco(self, model: Any, data: Any, body: str) -> Float[np.ndarray, "sensor 3"]:
        """Return the counts after one step under the contacts of a MuJoCo body.

        `model` and `data` are MuJoCo's; call it once a step, after `mj_step`. The body's frame is
        the object's, in metres.
        """
        import mujoco

        number = model.body(body).id
        contacts = data.contact
        second = model.geom_bodyid[contacts.geom] == number
        mine = np.flatnonzero(second.any(axis=1))
        wrench, force = np.zeros(6), np.empty((len(mine), 3))
        for row, index in enumerate(mine):
            mujoco.mj_contactForce(model, data, index, wrench)  # pyright: ignore[reportAttributeAccessIssue]
            # rows of the frame are the contact's axes; the force is that on the second body
            on_second = wrench[:3] @ contacts.frame[index].reshape(3, 3)
            force[row] = on_second if second[index, 1] else -on_second
        points, position = contacts.pos[mine][None], data.xpos[number][None]
        rotation = data.xmat[number].reshape(1, 3, 3)
        return self.read_world(points, force[None], position, rotation, model.opt.timestep)[0]

    def _prepare(self, reference: Array) -> tuple[Any, dict[str, Array], Callable[..., Array]]:
        """Return tables, arrays and the source of noise as arrays of the reference's kind."""
        on_host = isinstance(reference, np.ndarray)
        device = "" if on_host else str(reference.device)
        if device not in self._known:
            tables = [table.moved_to(reference) for table in self._tables]
            arrays = {name: like(reference, array) for name, array in self._arrays.items()}
            self._known[device] = tables, arrays, _noise_source(reference, self._seed)
        return self._known[device]

    def _changes(
        self, response: JointResponse, arrays: dict[str, Array], felt: _OnFaces, step_s: float
    ) -> tuple[_Pressed, Float[Array, "object channel"]]:
        """Return at which force and stiffness each contact is looked up, and what all change, counts."""
        force, stiffening = felt.force_n, 1.0
        if self.spec.silicone.prony:
            on_face = felt.face[..., None] == arrays["faces"]
            stiffening = self._relaxation.stiffening(on_face, force, step_s)
        force = force * stiffening
        together = self._force_together(felt.face, felt.place_mm, force)
        share = force / (together + (together == 0))
        largest = together.clip(None, arrays["high"][2])[..., None]
        contact = library(largest).concatenate([felt.place_mm, largest], -1)
        return _Pressed(contact, stiffening), response.changes(felt.face, contact, share)

    def _read_out(self, expected: Array, sigma: Array, draw: Callable[..., Array]) -> Array:
        """Return whole counts with noise and drift, clipped; as expected without a seed."""
        if self._seed is None:
            return expected
        if self._drift is None:
            self._drift = draw(expected.shape) * self.spec.sensors.drift_counts
        limit = full_scale_counts(self.spec.sensors)
        noise = draw(expected.shape) * sigma
        return (expected + self._drift + noise).round().clip(-limit, limit)

    def _force_together(
        self,
        face: Int[Array, "object contact"],
        place: Float[Array, "object contact 2"],
        force_n: Float[Array, "object contact"],
    ) -> Float[Array, "object contact"]:
        """Return the force (N) of each contact and of neighbours, who count less with distance."""
        if force_n.shape[1] == 1:
            return force_n
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


class _OnFaces(NamedTuple):
    """Contacts of objects on their faces: face (`NONE`: empty), place, normal force, friction or None."""

    face: Int[Array, "object contact"]
    place_mm: Float[Array, "object contact 2"]
    force_n: Float[Array, "object contact"]
    pull_n: Float[Array, "object contact 2"] | None


class _Pressed(NamedTuple):
    """Places (mm) and forces (N) at which contacts are looked up, and by how much relaxed forces grew."""

    contact: Float[Array, "object contact 3"]
    stiffening: Any


def _find_places(
    places: SurfacePlaces, arrays: dict[str, Array], points_mm: Array, force_n: Array
) -> _OnFaces:
    """Return where contact points are pressed by which forces; what pulls off counts as 0."""
    vectors = force_n.ndim == 3
    push = zeros(points_mm, points_mm.shape)
    if vectors:
        size = ((force_n**2).sum(-1) ** 0.5)[..., None]
        push = force_n / (size + (size == 0))
    face, place, normal = places.nearest(points_mm.reshape(-1, 3), push.reshape(-1, 3))
    shape = points_mm.shape[:2]
    face, pull = face.reshape(shape), None
    if vectors:
        # friction along x and y of the face; i coordinate of the object, t tangent
        pull = library(force_n).einsum("oci,ocit->oct", force_n, arrays["tangents"][face])
        force_n = (-(force_n * normal.reshape(points_mm.shape)).sum(-1)).clip(0.0)
    # a slot without force has no face
    face = library(face).where(force_n > 0, face, NONE)
    place = place.reshape(*shape, 2).clip(arrays["low"][:2], arrays["high"][:2])
    return _OnFaces(face, place, force_n, pull)


def _require_contacts(points_mm: Any, force_n: Any, rotation: Any, step_s: float) -> None:
    """Raise `InputError` where shapes do not fit each other, time runs back, or a number is none."""
    # a list has no shape; one of torch prints its name too
    points: tuple[int, ...] = tuple(getattr(points_mm, "shape", ()))
    force: tuple[int, ...] = tuple(getattr(force_n, "shape", ()))
    if len(points) not in (2, 3) or points[-1:] != (3,) or force not in (points[:-1], points):
        raise InputError(
            "points_mm is an array (contact, 3) or (object, contact, 3), and force_n has a number or a "
            f"vector for each; got shapes {points} and {force}. Give arrays of these shapes"
        )
    objects = points[0] if len(points) == 3 else 1
    turn = (3, 3) if rotation is None else tuple(rotation.shape)
    if turn not in ((3, 3), (objects, 3, 3)):
        raise InputError(
            f"rotation is (3, 3) or ({objects}, 3, 3) here; got {turn}. Give each object's axes as columns"
        )
    if not step_s >= 0:
        raise InputError(
            f"step_s is a time of 0 s or more; got {step_s:g}. Give the time since the last call"
        )
    for name, array in (("points_mm", points_mm), ("force_n", force_n)):
        if isinstance(array, np.ndarray) and not np.isfinite(array).all():
            raise InputError(
                f"{name} has what is no number. Give slots of no contact any point and a force of 0"
            )


def _is_spec(source: Path | str) -> bool:
    return Path(source).suffix == ".toml"


def _pressed_to_the_edges(spec_path: Path | str) -> ContactModel:
    """Return the forward model of a specification with presses wherever its tip lands on a face."""
    from estimator.information.shear import shear_signals
    from instobj.stages.run import Run

    spec = load_spec(Path(spec_path))
    grid = spec.contact_grid.changed(count="fill", pitch_mm=_pitch_to_the_edges_mm(spec))
    spec = spec.changed(contact_grid=grid)
    run, shear = Run(spec), None
    forces, motions = run.read(PRESSES)
    if spec.inversion.tangential_share:
        shear = shear_signals(spec, motions, run.read(SHEAR))
    return contact_model(spec, forces, motions, run.read(SIGNALS), shear)


def _pitch_to_the_edges_mm(spec: ObjectSpec) -> float:
    """Return the pitch at which the outermost presses come nearest to the edges of all faces."""
    frames = face_frames(spec)
    half_mm = np.array([frame.half_lengths_mm for frame in frames])
    # a grid has at most 100 locations along an axis, and 0.8 of this pitch is tried below
    coarsest = min(spec.contact_grid.pitch_mm, max(_PITCH_MM, 2 * half_mm.max() / 80))
    if not all(frame.flat for frame in frames):
        return coarsest  # beyond a patch lies the next one

    def left_mm(pitch_mm: float) -> float:
        places = filled_places(spec, pitch_mm).places
        count = np.column_stack([places.any(axis=across).sum(axis=1) for across in (2, 1)])
        # the outermost presses lie half a pitch beyond the outermost locations
        return float((half_mm - count * pitch_mm / 2).max())

    return min((coarsest * np.linspace(1.0, 0.8, 101)).tolist(), key=left_mm)


def _bounds_to_the_edges(
    model: ContactModel,
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Return least and largest x, y (mm) and force (N) of contacts: out to the edges of flat faces, one
    interval between presses beyond the outermost at most. The splines go on there."""
    (low, high), frames = model.bounds, face_frames(model.spec)
    if not all(frame.flat for frame in frames):
        return low, high
    half_mm = np.max([frame.half_lengths_mm for frame in frames], axis=0)
    # presses lie half a pitch apart
    reach = np.append(half_mm - high[:2], 0.0).clip(0.0, model.spec.contact_grid.pitch_mm / 2)
    return low - reach, high + reach


def _friction_changes(
    shear: PressTable, pressed: _Pressed, felt: _OnFaces
) -> Float[Array, "object channel"]:
    """Return what friction changes, counts: each contact's counts per newton along x and y."""
    face, contact = felt.face, pressed.contact
    pull_n = felt.pull_n * like(contact, pressed.stiffening)[..., None]
    touching = face != NONE
    per_n = zeros(shear.coefficients, (*face.shape, shear.coefficients.shape[-1]))
    per_n[touching] = shear.expected(face[touching], contact[touching])
    per_n = per_n.reshape(*face.shape, 2, -1)
    return (per_n * float32(pull_n)[..., None]).sum((1, 2))
