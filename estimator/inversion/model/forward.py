"""Forward model of several contacts: presses summed as motions, whose field is taken to second order.

Motions of the shell's bodies add up under joint contact to 0.0 to 1.1 % of the signals at 8 N per face,
and to 2.1 % at worst at 17 N (small strain; ten grasps of two faces of the paper's cube with one to
three tips per jaw); signals themselves add up to 0.1 to 4.6 %, 9.7 % at worst, since the field is not
linear in the motion. Each contact's own signals come from a table of single presses, so that one contact
is met exactly, whatever the table is of, the design's presses or those of a calibrated twin. What contacts
do to each other's comes from the curvature of each magnet's field: the second derivatives of the counts by
its motion, times both motions. That is 0.06 % of the signals off the exact field of the summed motions at
8 N per face, 0.3 % at 17 N, and no field is computed while contacts come and go.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid, press_lattice
from design.layout.places.contact_places import face_rows, pressed_nodes
from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, magnets_model
from estimator.information.shear import ShearSignals
from estimator.inversion.model.arrays import (
    Array,
    float64,
    like,
    to_host,
    true_rows,
    zeros,
)
from estimator.inversion.model.table import (
    PressTable,
    motion_table,
    shear_table,
    signal_table,
    skin_table,
)
from estimator.signals.field_setup import Scene, counts, min_distance_mm, sensed_field
from estimator.signals.interpolation import among_pressed
from estimator.signals.press_states import rest_motion
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import designed
from fem.presses.results import MagnetMotions, PressForces

NONE = -1
"""`face` of an empty contact slot."""
_NEARER_MM = 1.0
"""Distance by which several contacts may bring magnet and sensor nearer than one."""
_STEPS = np.array([0.5, 0.5, 0.5, 0.05, 0.05, 0.05])
"""Motions (mm, rad) over which second derivatives are taken: those of presses of some newtons."""


@dataclass(frozen=True)
class ContactModel:
    """Expected changes of counts under contacts anywhere on the object.

    Contacts are `face` (problem, contact), index of the face in `signals.faces` or `NONE`, and
    `contact` (problem, contact, 3): x and y in mm in the face's frame, and normal force in N.

    Attributes
    ----------
    signals, motions : tables of single presses
    rest : (body, 6) motion that is there without a press
    nearest_mm : between magnet and sensor in single presses
    skin : depth and contact area of single presses (`skin_table`)
    shear : what tangential forces add, 2 · channels; None where contacts are frictionless
    """

    spec: ObjectSpec
    signals: PressTable
    motions: PressTable
    rest: Float[np.ndarray, "body 6"]
    nearest_mm: float
    skin: PressTable
    shear: PressTable | None = None

    def select_face(self, index: int) -> ContactModel:
        """The same object pressed on one face only, which then is face 0."""
        shear = None if self.shear is None else self.shear.select_face(index)
        return replace(
            self,
            signals=self.signals.select_face(index),
            motions=self.motions.select_face(index),
            skin=self.skin.select_face(index),
            shear=shear,
        )

    def moved_to(self, reference: Array) -> ContactModel:
        """The same for contacts that are arrays of the reference's kind, on its device."""
        shear = None if self.shear is None else self.shear.moved_to(reference)
        tables = self.signals.moved_to(reference), self.motions.moved_to(reference)
        return replace(self, signals=tables[0], motions=tables[1], shear=shear)

    @cached_property
    def scene(self) -> Scene:
        """Magnets and sensors of the design."""
        return designed(self.spec).scene

    @cached_property
    def field(self) -> MagnetsModel:
        """The field model that serves several contacts."""
        return magnets_model(self.spec.magnets, self.nearest_mm - _NEARER_MM)

    @property
    def channels(self) -> int:
        """Channels of the whole object: sensor · 3 + axis."""
        return self.signals.coefficients.shape[-1]

    @cached_property
    def bounds(self) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
        """Least and largest x, y (mm) and force (N) of a contact that the tables know."""
        x, y, root = self.signals.x.breaks, self.signals.y.breaks, self.signals.largest_force_n
        return np.array([x[0], y[0], 0.0]), np.array([x[-1], y[-1], root])

    @cached_property
    def cells(self) -> tuple[Float[np.ndarray, "_ 2"], ...]:
        """Middles of the lattice's cells between presses of each face, mm."""
        lattice = press_lattice(self.spec)
        pressed = pressed_nodes(self.spec)[face_rows(self.spec, self.signals.faces)]
        x, y = ((nodes[1:] + nodes[:-1]) / 2 for nodes in (lattice.x_mm, lattice.y_mm))
        middles = PlaceGrid(x, y).xy_mm
        return tuple(
            middles[among_pressed(lattice, pressed_row, *middles.T)] for pressed_row in pressed
        )

    @cached_property
    def whole(self) -> bool:
        """Return whether every face has all places of the lattice."""
        return bool(pressed_nodes(self.spec).all())

    @property
    def area_mm2(self) -> float:
        """Return the area of all faces where a contact may be."""
        (low, high), faces = self.bounds, len(self.signals.faces)
        rectangles = float(faces * np.prod(high[:2] - low[:2]))
        if self.whole:
            return rectangles
        nx, ny = press_lattice(self.spec).shape
        return rectangles * sum(map(len, self.cells)) / (faces * (nx - 1) * (ny - 1))

    def select_faces(
        self,
        face: Int[Array, "problem contact"],
        contact: Float[Array, "problem contact 3"],
    ) -> Float[Array, "problem contact 3"]:
        """Return the contacts; those outside their face are moved to its border."""
        if self.whole:
            return contact
        from scipy.spatial import KDTree

        face_row, place = to_host(face), to_host(contact)
        moved, half = place.copy(), self.spec.contact_grid.pitch_mm / 4
        for index, middles in enumerate(self.cells):
            here = face_row == index
            nearest = middles[KDTree(middles).query(place[here, :2])[1]]
            moved[here, :2] = np.clip(place[here, :2], nearest - half, nearest + half)
        return like(contact, moved)

    def singles(
        self,
        face: Int[Array, "problem contact"],
        contact: Float[Array, "problem contact 3"],
    ) -> Float[Array, "problem contact 4 channel"]:
        """Counts of each contact alone and their derivatives by x, y and force; 0 where empty."""
        if not isinstance(contact, np.ndarray):
            return self._fill_slots(face, contact, self.signals.values)
        # What a fit ends at is asked for again by its uncertainty, and by the next frame's fit.
        if not (self._latest and all(map(np.array_equal, self._latest, (face, contact)))):
            counts = self._fill_slots(face, contact, self.signals.values)
            counts.flags.writeable = False
            # copies: callers may write into their arrays
            self._latest[:] = face.copy(), contact.copy(), counts
        return self._latest[2]

    @cached_property
    def _latest(self) -> list[np.ndarray]:
        """Face, contact and counts of the latest call of `singles`."""
        return []

    def pulls(
        self,
        face: Int[Array, "problem contact"],
        contact: Float[Array, "problem contact 3"],
    ) -> Float[Array, "problem contact 2 channel"]:
        """Counts that a tangential force along x and along y gives, each of its standard deviation
        (`pull_sigma_n`); 0 where empty or frictionless."""
        table = self.shear
        if table is None:
            return zeros(contact, (*face.shape, 2, self.channels))

        def pulled(face: Array, contact: Array) -> Array:
            per_n = table.values(face, contact)[:, 0]
            sigma = self.pull_sigma_n(contact)[:, None, None]
            return sigma * per_n.reshape(-1, 2, self.channels)

        return self._fill_slots(face, contact, pulled)

    def _fill_slots(
        self, face: Array, contact: Array, values: Callable[[Array, Array], Array]
    ) -> Float[Array, "problem contact *values"]:
        """Return what the filled slots give, at their place among the empty ones."""
        filled = face != NONE
        if filled.all():
            results = values(face.reshape(-1), contact.reshape(-1, 3))
            return results.reshape(*face.shape, *results.shape[1:])
        results = values(face[filled], contact[filled])
        all_slots = zeros(results, (*face.shape, *results.shape[1:]))
        all_slots[filled] = results
        return all_slots

    def pull_sigma_n(self, contact: Float[Array, "*n 3"]) -> Float[Array, "*n"]:
        """Standard deviation of a contact's tangential force along each axis before a frame is seen."""
        return 0.5 * self.spec.inversion.tangential_share * contact[..., 2]

    def interaction(
        self,
        face: Int[Array, "problem contact"],
        contact: Float[Array, "problem contact 3"],
    ) -> Float[Array, "problem channel"]:
        """Return what contacts together give beyond the sum of each alone, counts."""
        filled: Bool[Array, "problem contact"] = face != NONE
        several = filled.sum(axis=1) > 1
        if not len(face) or not several.all():
            extra = zeros(contact, (len(face), self.channels))
            rows = true_rows(several)
            if len(rows):
                extra[rows] = self.interaction(face[rows], contact[rows])
            return extra
        shape = (*face.shape, len(self.rest), 6)
        moved = float64(self._fill_slots(face, contact, self.motions.expected)).reshape(shape)
        return interaction_counts(moved, moved, self.pair_counts)

    @cached_property
    def pair_counts(self) -> Float[Array, "pair channel"]:
        """Half the second derivatives of the counts by the motion of each body, (body · 36, channel), by
        central differences; bodies do not bend each other's field."""
        # (f(+i +j) − f(+i −j) − f(−i +j) + f(−i −j)) / 4; for i = j this is the difference over 2 steps
        signs = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])
        ends = np.eye(6) * _STEPS
        parts = []
        for body in range(len(self.rest)):
            states = np.zeros((6, 6, 4, *self.rest.shape))
            for corner, (first, second) in enumerate(signs):
                states[:, :, corner, body] = first * ends[:, None] + second * ends[None]
            corners = self.counts_of_motions(states.reshape(-1, *self.rest.shape))
            # sums the corners by their signs: (4,) @ (36, 4, channel)
            second = (signs.prod(axis=1) / 4) @ corners.reshape(36, 4, -1)
            parts.append(second / 2 / np.outer(_STEPS, _STEPS).reshape(36, 1))
        return like(self.signals.coefficients, np.concatenate(parts))

    def counts_of_motions(
        self, moved: Float[np.ndarray, "state body 6"]
    ) -> Float[np.ndarray, "state channel"]:
        """Counts of motions beyond those at rest, of the exact field."""
        return self._counts(self.rest + moved) - self._resting

    @cached_property
    def _resting(self) -> Float[np.ndarray, "channel"]:
        return self._counts(self.rest[None])[0]

    def _counts(
        self, states: Float[np.ndarray, "state body 6"]
    ) -> Float[np.ndarray, "state channel"]:
        field = sensed_field(self.scene, states, self.field)
        return counts(self.scene, field, self.spec).reshape(len(states), -1)


def interaction_counts(
    moved: Float[Array, "object contact body 6"],
    shared: Float[Array, "object contact body 6"],
    pair_counts: Float[Array, "pair channel"],
) -> Float[Array, "object channel"]:
    """Return what motions together do beyond the sum of each alone, to second order.

    `shared` are the motions times the share of each contact; `pair_counts` as in `ContactModel`.
    """
    together = shared.sum(1)
    # (Σ w m)(Σ w m)ᵀ − Σ w m mᵀ of each body: 0 for one contact, however often it is split
    pairs = together[..., :, None] * together[..., None, :]
    # sums w m mᵀ over contacts: (object, body, component, contact) @ (…, contact, component)
    pairs = pairs - shared.swapaxes(1, 2).swapaxes(2, 3) @ moved.swapaxes(1, 2)
    return pairs.reshape(len(moved), -1) @ pair_counts


def contact_model(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    signals: Signals,
    shear: ShearSignals | None = None,
) -> ContactModel:
    """The model of an object whose single presses give `signals`, on the design's mechanics.

    `signals` are those of the table itself (`estimator.signals.presses.press_signals`) or of a twin
    calibrated on labelled presses; the interaction of contacts stays the design's. `shear` is needed
    where contacts may pull sideways.

    Raises
    ------
    InputError
        `inversion.tangential_share` without `shear`.
    """
    share = spec.inversion.tangential_share
    if share and shear is None:
        raise InputError(
            f"inversion.tangential_share = {share:g} needs the signals of tangential forces; got none. "
            "Simulate them (stage shear), or set it to 0"
        )
    place = designed(spec).scene
    nearest = min_distance_mm(place, motions.all_motions)
    return ContactModel(
        spec,
        signal_table(signals),
        motion_table(forces, motions),
        rest_motion(motions),
        nearest,
        skin_table(forces, signals),
        shear_table(spec, signals, shear) if share and shear is not None else None,
    )
