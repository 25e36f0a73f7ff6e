"""Table of single presses: signals and motions of the shell's bodies by face, place and force.

Splines through the presses of `estimator.signals.interpolation`, resampled at constant force.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import PlaceGrid
from design.layout.places.contact_places import contact_places, face_rows
from design.spec.object import ObjectSpec
from estimator.frames.tangential import slope_traces
from estimator.information.shear import ShearSignals
from estimator.inversion.model.arrays import Array, chosen, float32, library, like, zeros
from estimator.inversion.model.spline import CubicAxes, CubicAxis, cubic_axis, spline_coefficients
from estimator.signals.continuation import fill_lattice
from estimator.signals.interpolation import Traces, press_traces
from estimator.signals.monotone import monotone_cubic
from estimator.signals.press_states import motions_as_signals
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, PressForces

FORCE_NODES = 14
"""Along the force of a press; 14 leave 0.1 % of the signals' rms of the paper's cube."""
_NEAR_ZERO_N = 0.5
"""Nodes stand evenly in the root of the force beyond this."""
_FIRST_ROOT = np.sqrt(_NEAR_ZERO_N)
_DERIVED = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])[..., None]
"""1 where the value or a derivative by x, y or force takes an axis's derivative weights, else 0."""
_OF_X, _OF_Y, _OF_FORCE = (
    2 * node + by
    for node, by in zip(
        (np.arange(4), np.repeat(np.arange(4), 4), np.tile(np.arange(4), 4)), _DERIVED, strict=True
    )
)
"""Index of an axis's (node, derivative) for x, and for every pair of y and force."""
_CHUNK, _DEVICE_CHUNK = 128, 1 << 14
"""Contacts at a time: their coefficients fit a second-level cache, or a device's memory."""
_STEP_X, _STEP_Y = (step.ravel() for step in np.meshgrid(range(4), range(4), indexing="ij"))


@dataclass(frozen=True)
class PressTable:
    """Splines over the presses of every face.

    Attributes
    ----------
    faces : (face,) numbers of the faces, in the order of the first axis of `coefficients`
    coefficients : (face, x, y, force, channel); contacts are given as arrays of this one's kind
    """

    faces: Int[np.ndarray, "face"]
    x: CubicAxis
    y: CubicAxis
    root: CubicAxis
    coefficients: Float[Array, "face nx ny nf channel"]

    def select_face(self, index: int) -> PressTable:
        """Presses of one face, which then is face 0."""
        only = slice(index, index + 1)
        return replace(self, faces=self.faces[only], coefficients=self.coefficients[only])

    def moved_to(self, reference: Array) -> PressTable:
        """The same where the reference is."""
        return replace(self, coefficients=like(reference, self.coefficients))

    @property
    def largest_force_n(self) -> float:
        """Last node of the splines."""
        return float((self.root.breaks[-1] + _FIRST_ROOT) ** 2 - _NEAR_ZERO_N)

    def values(
        self, face: Int[Array, "n"], contact: Float[Array, "n 3"]
    ) -> Float[Array, "n 4 channel"]:
        """Channels of contacts (x, y in mm and force in N), and their derivatives by these three.

        `face` counts faces from 0, in the order of `faces`.
        """
        chunk = _CHUNK if isinstance(self.coefficients, np.ndarray) else _DEVICE_CHUNK
        if len(face) <= chunk:
            return self._few(face, contact)
        values = zeros(self.coefficients, (len(face), 4, self.coefficients.shape[-1]))
        for start in range(0, len(face), chunk):
            rows = slice(start, start + chunk)
            values[rows] = self._few(face[rows], contact[rows])
        return values

    def expected(
        self, face: Int[Array, "n"], contact: Float[Array, "n 3"]
    ) -> Float[Array, "n channel"]:
        """Channels of contacts as in `values`, without derivatives."""
        first, weights = self._weights(face, contact, 1)
        if isinstance(self.coefficients, np.ndarray):
            return (weights @ self._blocks(*first))[:, 0]
        nf, channels = self.coefficients.shape[-2:]
        places, (*_, jf) = self._rows(*first[:3]), first
        rows = (places * nf + jf[:, None])[..., None] + like(jf, np.arange(4))
        # sums the 64 rows of each contact without a copy of them
        return library(rows).nn.functional.embedding_bag(
            rows.reshape(len(face), 64),
            self.coefficients.reshape(-1, channels),
            per_sample_weights=weights[:, 0],
            mode="sum",
        )

    def _few(self, face: Array, contact: Array) -> Float[Array, "n 4 channel"]:
        first, weights = self._weights(face, contact)
        return weights @ self._blocks(*first)

    def _weights(
        self, face: Array, contact: Array, wanted: int = 4
    ) -> tuple[tuple[Array, ...], Array]:
        """Return where each contact's 64 coefficients begin, and their weights.

        These are for the first `wanted` of value and derivatives by x, y and force.
        """
        shifted_root = (contact[:, 2].clip(0.0) + _NEAR_ZERO_N) ** 0.5
        point = contact[:, 0], contact[:, 1], shifted_root - _FIRST_ROOT
        first, axis_weights = self._axes.weights(point)
        axis_weights[2, :, :, 1] /= (2 * shifted_root)[:, None]
        of_x, of_y, of_force = float32(axis_weights).reshape(3, len(face), 8)
        take_x, take_y, take_force = (take[:wanted] for take in self._places[:3])
        weights = chosen(of_y, take_y)
        weights *= chosen(of_force, take_force)
        weights = chosen(of_x, take_x)[..., None] * weights[:, :, None]
        return (face, *first), weights.reshape(len(face), wanted, 64)

    @cached_property
    def _axes(self) -> CubicAxes:
        return CubicAxes((self.x, self.y, self.root), self.coefficients)

    @cached_property
    def _places(self) -> list[Array]:
        """Return where weights and coefficients of a contact stand."""
        return [like(self.coefficients, i) for i in (_OF_X, _OF_Y, _OF_FORCE, _STEP_X, _STEP_Y)]

    def _blocks(self, face: Array, ix: Array, iy: Array, jf: Array) -> Float[Array, "n 64 channel"]:
        channels = self.coefficients.shape[-1]
        places = self._rows(face, ix, iy)
        return self._runs[places, jf[:, None]].reshape(len(face), 64, channels)

    def _rows(self, face: Array, ix: Array, iy: Array) -> Int[Array, "n 16"]:
        """Return the sixteen places of a contact's coefficients, counted over all faces."""
        _, nx, ny, _, _ = self.coefficients.shape
        *_, step_x, step_y = self._places
        return (face[:, None] * nx + ix[:, None] + step_x) * ny + iy[:, None] + step_y

    @cached_property
    def _runs(self) -> Float[Array, "place start run"]:
        """Overlapping views of four force nodes each: a contact is sixteen contiguous runs."""
        faces, nx, ny, nf, channels = self.coefficients.shape
        shape = faces * nx * ny, nf * channels
        if not isinstance(self.coefficients, np.ndarray):
            return self.coefficients.reshape(shape).unfold(1, 4 * channels, channels)
        flat = np.ascontiguousarray(self.coefficients).reshape(shape)
        runs = np.lib.stride_tricks.sliding_window_view(flat, 4 * channels, axis=1)
        return runs[:, ::channels]


def signal_table(signals: Signals) -> PressTable:
    """Changes of counts (channel = sensor · 3 + axis) of every press of the lattice."""
    nodes = force_nodes(signals)
    values = []
    for face, pressed in zip(signals.faces.tolist(), signals.pressed, strict=True):
        x, y = signals.lattice.xy_mm[pressed].T
        traces = press_traces(signals, np.full(len(x), face), x, y)
        values.append(
            fill_lattice(interpolate_forces(traces, nodes), pressed, signals.lattice.shape)
        )
    return force_table(signals.faces, signals.lattice, nodes, np.stack(values))


def motion_table(forces: PressForces, motions: MagnetMotions) -> PressTable:
    """Motions of all bodies (six channels each, mm and rad) beyond those at rest."""
    return signal_table(motions_as_signals(forces, motions))


def skin_table(forces: PressForces, signals: Signals) -> PressTable:
    """Depth (mm) and contact area (mm²) of every press, each to the power 3/2: so they grow about as the
    force does. A press of one depth has one area, however hard the silicone that `signals` show."""
    area = forces.contact_area_mm2
    depth = np.broadcast_to(forces.depth_mm, area.shape)
    # three axes of one sensor, as counts have; the third says nothing
    grown = np.stack([depth, area, np.zeros_like(area)], axis=-1)[..., None, :] ** 1.5
    return signal_table(replace(signals, delta_counts=grown, baseline_counts=np.zeros((1, 3))))


def shear_table(spec: ObjectSpec, signals: Signals, shear: ShearSignals) -> PressTable:
    """Change of counts per newton along x, then along y (2 · channels), at the contact locations."""
    nodes, values = force_nodes(signals), []
    places = contact_places(spec)[face_rows(spec, shear.faces)]
    for face, pressed in zip(shear.faces.tolist(), places, strict=True):
        xy = shear.grid.xy_mm[pressed]
        slopes = slope_traces(spec, signals, shear, np.full(len(xy), face), xy)
        face_values = np.concatenate([interpolate_forces(slope, nodes) for slope in slopes], axis=2)
        values.append(fill_lattice(face_values, pressed, shear.grid.shape))
    return force_table(shear.faces, shear.grid, nodes, np.stack(values))


def force_nodes(signals: Signals) -> Float[np.ndarray, "node"]:
    """From 0 to the force that the hardest place needs at most, evenly in its root."""
    largest = float(signals.force_n[signals.pressed, -1].max())
    last = np.sqrt(largest + _NEAR_ZERO_N)
    return np.linspace(_FIRST_ROOT, last, FORCE_NODES) ** 2 - _NEAR_ZERO_N


def interpolate_forces(
    traces: Traces, force_n: Float[np.ndarray, "node"]
) -> Float[np.ndarray, "press node channel"]:
    """Channels at the given forces, beyond the deepest press along its last slope."""
    reach = traces.force_n[:, -1:]
    wanted = np.broadcast_to(force_n, (len(reach), len(force_n)))
    inside = monotone_cubic(traces.force_n, traces.counts, np.minimum(wanted, reach))
    near_last = monotone_cubic(traces.force_n, traces.counts, 0.98 * reach)
    last = traces.counts[:, -1:]
    slope = (last - near_last) / (0.02 * reach)[..., None]
    return inside + np.maximum(wanted - reach, 0.0)[..., None] * slope


def force_table(
    faces: np.ndarray, lattice: PlaceGrid, force_n: np.ndarray, values: np.ndarray
) -> PressTable:
    grid = values.reshape(len(faces), len(lattice.x_mm), len(lattice.y_mm), len(force_n), -1)
    root = np.sqrt(force_n + _NEAR_ZERO_N) - _FIRST_ROOT
    nodes = (lattice.x_mm, lattice.y_mm, root)
    coefficients = np.stack([spline_coefficients(nodes, face) for face in grid])
    x, y, root = (cubic_axis(axis_nodes) for axis_nodes in nodes)
    return PressTable(faces, x, y, root, coefficients.astype(np.float32))
