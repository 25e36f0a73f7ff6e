"""Table of single presses: signals and motions of the shell's bodies by face, place and force.

Splines through the presses of `estimator.signals.interpolation`, resampled at constant force.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import PlaceGrid
from design.layout.places.contact_places import contact_places, face_rows
from design.spec.object import ObjectSpec
from estimator.frames.tangential import slope_traces
from estimator.information.shear import ShearSignals
from estimator.inversion.model.spline import CubicAxes, CubicAxis, cubic_axis, spline_coefficients
from estimator.signals.continuation import continued
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
"""Whether value and derivatives by x, y and force take an axis's weights or their derivatives."""
_OF_X, _OF_Y, _OF_FORCE = (
    2 * node + by
    for node, by in zip(
        (np.arange(4), np.repeat(np.arange(4), 4), np.tile(np.arange(4), 4)), _DERIVED, strict=True
    )
)
"""Where an axis's (node, derivative) stands for x, and for every pair of y and force."""
_CHUNK = 128
"""Contacts at a time, whose coefficients fit a second-level cache."""
_STEP_X, _STEP_Y = (step.ravel() for step in np.meshgrid(range(4), range(4), indexing="ij"))


@dataclass(frozen=True)
class PressTable:
    """Splines over the presses of every face.

    Attributes
    ----------
    faces : (face,) numbers of the faces, in the order of the first axis of `coefficients`
    coefficients : (face, x, y, force, channel)
    """

    faces: Int[np.ndarray, "face"]
    x: CubicAxis
    y: CubicAxis
    root: CubicAxis
    coefficients: Float[np.ndarray, "face nx ny nf channel"]

    def of_face(self, index: int) -> PressTable:
        """Presses of one face, which then is face 0."""
        only = slice(index, index + 1)
        return replace(self, faces=self.faces[only], coefficients=self.coefficients[only])

    @property
    def largest_force_n(self) -> float:
        """Last node of the splines."""
        return float((self.root.breaks[-1] + _FIRST_ROOT) ** 2 - _NEAR_ZERO_N)

    def values(
        self, face: Int[np.ndarray, "n"], contact: Float[np.ndarray, "n 3"]
    ) -> Float[np.ndarray, "n 4 channel"]:
        """Channels of contacts (x, y in mm and force in N), and their derivatives by these three.

        `face` counts faces from 0, in the order of `faces`.
        """
        values = np.empty((len(face), 4, self.coefficients.shape[-1]))
        for start in range(0, len(face), _CHUNK):
            rows = slice(start, start + _CHUNK)
            first, weights = self._weights(face[rows], contact[rows])
            values[rows] = weights @ self._blocks(*first)
        return values

    def _weights(
        self, face: np.ndarray, contact: np.ndarray
    ) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
        """Where each contact's 64 coefficients begin, and their weights for value and derivatives."""
        shifted = np.maximum(contact[:, 2], 0.0) + _NEAR_ZERO_N
        shifted_root = np.sqrt(shifted)
        root = shifted_root - _FIRST_ROOT
        first, along = self._axes.weights((contact[:, 0], contact[:, 1], root))
        along[2, :, :, 1] /= (2 * shifted_root)[:, None]
        of_x, of_y, of_force = along.astype(np.float32).reshape(3, len(face), 8)
        weights = of_y.take(_OF_Y, axis=1)
        weights *= of_force.take(_OF_FORCE, axis=1)
        weights = of_x.take(_OF_X, axis=1)[..., None] * weights[:, :, None]
        return (face, *first), weights.reshape(len(face), 4, 64)

    @cached_property
    def _axes(self) -> CubicAxes:
        return CubicAxes((self.x, self.y, self.root))

    def _blocks(
        self, face: np.ndarray, ix: np.ndarray, iy: np.ndarray, jf: np.ndarray
    ) -> Float[np.ndarray, "n 64 channel"]:
        _, nx, ny, _, channels = self.coefficients.shape
        places = (face[:, None] * nx + ix[:, None] + _STEP_X) * ny + iy[:, None] + _STEP_Y
        return self._runs[places, jf[:, None]].reshape(len(face), 64, channels)

    @cached_property
    def _runs(self) -> Float[np.ndarray, "place start run"]:
        """Overlapping views of four force nodes each: a contact is sixteen contiguous runs."""
        faces, nx, ny, nf, channels = self.coefficients.shape
        flat = np.ascontiguousarray(self.coefficients).reshape(faces * nx * ny, nf * channels)
        runs = np.lib.stride_tricks.sliding_window_view(flat, 4 * channels, axis=1)
        return runs[:, ::channels]


def signal_table(signals: Signals) -> PressTable:
    """Changes of counts (channel = sensor · 3 + axis) of every press of the lattice."""
    nodes = _force_nodes(signals)
    values = []
    for face, there in zip(signals.faces.tolist(), signals.pressed, strict=True):
        x, y = signals.lattice.xy_mm[there].T
        traces = press_traces(signals, np.full(len(x), face), x, y)
        values.append(_on_lattice(_at_forces(traces, nodes), there, signals.lattice))
    return _table(signals.faces, signals.lattice, nodes, np.stack(values))


def _on_lattice(
    values: Float[np.ndarray, "place node channel"],
    there: Bool[np.ndarray, "every"],
    lattice: PlaceGrid,
) -> Float[np.ndarray, "every node channel"]:
    """Values of the places that a face has, continued smoothly to those that it has not."""
    if there.all():
        return values
    every = np.full((len(there), *values.shape[1:]), np.nan)
    every[there] = values
    return continued(every, there, lattice.shape)


def motion_table(forces: PressForces, motions: MagnetMotions) -> PressTable:
    """Motions of all bodies (six channels each, mm and rad) beyond those at rest."""
    return signal_table(motions_as_signals(forces, motions))


def shear_table(spec: ObjectSpec, signals: Signals, shear: ShearSignals) -> PressTable:
    """Change of counts per newton along x, then along y (2 · channels), at the contact locations."""
    nodes, values = _force_nodes(signals), []
    places = contact_places(spec)[face_rows(spec, shear.faces)]
    for face, there in zip(shear.faces.tolist(), places, strict=True):
        xy = shear.grid.xy_mm[there]
        slopes = slope_traces(spec, signals, shear, np.full(len(xy), face), xy)
        found = np.concatenate([_at_forces(one, nodes) for one in slopes], axis=2)
        values.append(_on_lattice(found, there, shear.grid))
    return _table(shear.faces, shear.grid, nodes, np.stack(values))


def _force_nodes(signals: Signals) -> Float[np.ndarray, "node"]:
    """From 0 to the force that the hardest place needs at most, evenly in its root."""
    largest = float(signals.force_n[signals.pressed, -1].max())
    last = np.sqrt(largest + _NEAR_ZERO_N)
    return np.linspace(_FIRST_ROOT, last, FORCE_NODES) ** 2 - _NEAR_ZERO_N


def _at_forces(
    traces: Traces, force_n: Float[np.ndarray, "node"]
) -> Float[np.ndarray, "press node channel"]:
    """Channels at the given forces, beyond the deepest press along its last slope."""
    reach = traces.force_n[:, -1:]
    wanted = np.broadcast_to(force_n, (len(reach), len(force_n)))
    inside = monotone_cubic(traces.force_n, traces.counts, np.minimum(wanted, reach))
    before = monotone_cubic(traces.force_n, traces.counts, 0.98 * reach)
    last = traces.counts[:, -1:]
    slope = (last - before) / (0.02 * reach)[..., None]
    return inside + np.maximum(wanted - reach, 0.0)[..., None] * slope


def _table(
    faces: np.ndarray, lattice: PlaceGrid, force_n: np.ndarray, values: np.ndarray
) -> PressTable:
    grid = values.reshape(len(faces), len(lattice.x_mm), len(lattice.y_mm), len(force_n), -1)
    root = np.sqrt(force_n + _NEAR_ZERO_N) - _FIRST_ROOT
    nodes = (lattice.x_mm, lattice.y_mm, root)
    coefficients = np.stack([spline_coefficients(nodes, face) for face in grid])
    x, y, root = (cubic_axis(at) for at in nodes)
    return PressTable(faces, x, y, root, coefficients.astype(np.float32))
