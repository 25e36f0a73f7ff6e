"""Presses of one face on a lattice of places and forces, which signals of others may be taken for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from estimator.information.fisher import whitened
from estimator.signals.continuation import fill_lattice
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import Traces, press_traces, unresolved_presses
from estimator.signals.live import is_live, read_change
from estimator.signals.presses import Signals

_FORCES = 10
"""Number of forces of the lattice, evenly spaced in their root."""
_STEP = 1e-30
"""Imaginary step of complex-step differentiation."""


@dataclass(frozen=True)
class PlaceSlopes:
    """Change of signals with the place, less what a change of force undoes, along two axes.

    The axes are perpendicular, and so are the changes along them.

    Attributes
    ----------
    axes : unit vectors in the face's plane
    per_mm : lengths of the changes along them, in standard deviations of noise
    patterns : the changes at unit length; 0 along a blind axis
    """

    axes: Float[np.ndarray, "*n 2 2"]
    per_mm: Float[np.ndarray, "*n 2"]
    patterns: Float[np.ndarray, "*n 2 channel"]


def place_slopes(slopes: Float[np.ndarray, "*n channel 3"]) -> PlaceSlopes:
    """From the derivatives of whitened signals by x, y (per mm) and force (per N)."""
    force, _ = unit_vectors(slopes[..., 2])
    x, y = (
        slope - (slope * force).sum(-1, keepdims=True) * force
        for slope in (slopes[..., 0], slopes[..., 1])
    )
    # eigenvectors of [[xx, xy], [xy, yy]] in closed form
    xx, xy, yy = ((a * b).sum(-1) for a, b in ((x, x), (x, y), (y, y)))
    angle = np.arctan2(2 * xy, xx - yy) / 2
    c, s = np.cos(angle), np.sin(angle)
    axes = np.stack([np.stack([c, s], -1), np.stack([-s, c], -1)], -2)
    patterns, per_mm = unit_vectors(axes @ np.stack([x, y], -2))
    return PlaceSlopes(axes, per_mm, patterns)


def unit_vectors(
    vectors: Float[np.ndarray, "*n channel"],
) -> tuple[Float[np.ndarray, "*n channel"], Float[np.ndarray, "*n"]]:
    """Vectors at unit length, and their lengths; those of length 0 stay."""
    length = np.linalg.norm(vectors, axis=-1)
    return vectors / np.where(length > 0, length, 1.0)[..., None], length


@dataclass(frozen=True)
class RivalPresses:
    """Presses of one face on a lattice of places and forces.

    Attributes
    ----------
    xy_mm, step_mm : places of a square lattice, and its step
    force_n : growing forces, the same at each place
    there : which presses exist, at least one at each place
    signals : expected changes, each channel in the unit of its noise (or in counts)
    slopes : their derivatives by x, y (per mm) and force (per N)
    """

    xy_mm: Float[np.ndarray, "place 2"]
    step_mm: float
    force_n: Float[np.ndarray, "force"]
    is_pressed: Bool[np.ndarray, "place force"]
    signals: Float[np.ndarray, "place force channel"]
    slopes: Float[np.ndarray, "place force channel 3"]

    def whitened(
        self,
        sigma_counts: Float[np.ndarray, "channel"],
        nuisances: Float[np.ndarray, "channel k"] | None = None,
    ) -> RivalPresses:
        """The same with independent disturbances of unit size (`estimator.information.fisher`)."""
        signals = whitened(self.signals, sigma_counts, nuisances)
        slopes = whitened(self.slopes.swapaxes(-1, -2), sigma_counts, nuisances).swapaxes(-1, -2)
        return RivalPresses(
            self.xy_mm, self.step_mm, self.force_n, self.is_pressed, signals, slopes
        )

    @cached_property
    def place_slopes(self) -> PlaceSlopes:
        """Along the principal axes of each press."""
        return place_slopes(self.slopes)


def rival_presses(
    spec: ObjectSpec, signals: Signals, face: int, channels: Int[np.ndarray, "some"]
) -> RivalPresses:
    """All presses of a face, in counts as the chips tell them; channels beyond their range have no slope.

    Places whose force does not grow with depth are left out.
    """
    index = signals.faces.tolist().index(face)
    lattice, unresolved = signals.lattice, unresolved_presses(signals)[index]
    usable = signals.pressed[index] & ~unresolved[:, -1] & (unresolved.mean(axis=1) < 0.5)
    x, y = lattice.xy_mm[usable].T
    traces = press_traces(signals, np.full(len(x), face), x, y).select_channels(channels)
    reach = np.zeros(len(usable))
    reach[usable] = traces.force_n[:, -1]
    force = reach.max() * (np.arange(1, _FORCES + 1) / _FORCES) ** 2
    counts, per_n = (
        fill_lattice(values, usable, lattice.shape) for values in _interpolate_forces(traces, force)
    )
    rest, most = signals.baseline_counts.ravel()[channels], full_scale_counts(spec.sensors)
    slopes = np.stack([*_across(lattice, counts), per_n], axis=-1)
    slopes *= is_live(rest, counts, most)[..., None]
    pressed = force <= reach[:, None]
    kept = pressed.any(axis=1)
    return RivalPresses(
        lattice.xy_mm[kept],
        float(lattice.x_mm[1] - lattice.x_mm[0]),
        force,
        pressed[kept],
        read_change(rest, counts, most)[kept],
        slopes[kept],
    )


def _interpolate_forces(
    traces: Traces, force_n: Float[np.ndarray, "force"]
) -> tuple[Float[np.ndarray, "press force channel"], Float[np.ndarray, "press force channel"]]:
    """Counts at given forces and their slopes per N; beyond the deepest press on the last slope."""
    held = np.minimum(force_n, traces.force_n[:, -1:])
    complex_counts = traces.curves.evaluate(held + 1j * _STEP)
    per_n = np.imag(complex_counts) / _STEP
    return np.real(complex_counts) + (force_n - held)[..., None] * per_n, per_n


def _across(
    lattice: PlaceGrid, values: Float[np.ndarray, "place force channel"]
) -> tuple[Float[np.ndarray, "place force channel"], Float[np.ndarray, "place force channel"]]:
    """Slopes by x and y, of the cubic splines (not-a-knot) through the lattice, at its places."""
    from scipy.interpolate import make_interp_spline

    grid, slopes = values.reshape(*lattice.shape, -1), []
    for axis, nodes in enumerate((lattice.x_mm, lattice.y_mm)):
        by = make_interp_spline(nodes, np.eye(len(nodes)), k=3)(nodes, nu=1)
        axis_slopes = np.moveaxis(np.tensordot(by, grid, axes=(1, axis)), 0, axis)
        slopes.append(axis_slopes.reshape(values.shape))
    return slopes[0], slopes[1]
