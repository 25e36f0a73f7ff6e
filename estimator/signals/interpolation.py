"""Signals between the simulated places and forces, and their derivatives.

Across a face: cubic splines (not-a-knot) in x and y through the lattice, at constant depth step,
for force and counts alike. Along a press: a monotone piecewise cubic (`estimator.signals.monotone`)
through (force, counts) with rest, (0, 0), as first point.

Error between the places of a 1.5 mm lattice: within 0.3 % of a face's largest signal for smooth
dimples (tested). For the cube's finite elements (1.7 mm surface edges) against presses simulated
at the places themselves: 3 % of the signals' rms, 5 % of the largest signal at worst, next to the
rims of the rigid magnets; both simulations' mesh errors of 1 to 2 % of force are part of it.

Where a shallow press found no contact on the mesh its force does not grow: such points are put on
the chord of their neighbours and marked (`Traces.corrected`, `unresolved_presses`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float, Inexact, Int

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from estimator.signals.monotone import MonotoneCurves, monotone_cubic
from estimator.signals.presses import Signals

_STEP = 1e-30
"""Imaginary step of complex-step differentiation: exact to rounding, no cancellation."""
_LEAST_RISE_N = 1e-6
"""Rise over the force of all shallower steps, at least: a press with less is not resolved."""
_ON_EDGE_MM = 1e-6
"""Step to either side of a place: one on an edge belongs to the cells on both sides."""


@dataclass(frozen=True)
class Traces:
    """Traces that presses pass through with growing depth; node 0 is rest.

    `depth_mm` (node,), `force_n` (press, node) increasing from 0, `counts` (press, node, channel)
    change against rest with channel = sensor · 3 + axis. `corrected` (press, node) marks points that
    mechanics did not resolve and that lie on the chord of their neighbours.
    """

    depth_mm: Float[np.ndarray, "node"]
    force_n: Inexact[np.ndarray, "press node"]
    counts: Inexact[np.ndarray, "press node channel"]
    corrected: Bool[np.ndarray, "press node"]

    @cached_property
    def curves(self) -> MonotoneCurves:
        """Counts over force."""
        return MonotoneCurves(self.force_n, self.counts)

    def select_channels(self, channels: Int[np.ndarray, "some"]) -> Traces:
        """The same presses seen by some of the channels."""
        return replace(self, counts=self.counts[..., channels])


@dataclass(frozen=True)
class SignalsAtForce:
    """Signals at given forces; `clamped` marks forces beyond the deepest simulated press.

    `force_n` (press, frame) is the force at which `counts` (press, frame, channel) hold: the one
    asked for, or the largest reachable where clamped.
    """

    counts: Float[np.ndarray, "press frame channel"]
    force_n: Float[np.ndarray, "press frame"]
    clamped: Bool[np.ndarray, "press frame"]


@dataclass(frozen=True)
class SignalGradient:
    """Counts (press, channel) and their derivatives per mm in x and y and per N, each at
    constant values of the other two."""

    counts: Float[np.ndarray, "press channel"]
    d_x: Float[np.ndarray, "press channel"]
    d_y: Float[np.ndarray, "press channel"]
    d_force: Float[np.ndarray, "press channel"]

    @property
    def jacobian(self) -> Float[np.ndarray, "press channel 3"]:
        """∂(counts)/∂(x, y, F): counts per mm, per mm and per N."""
        return np.stack([self.d_x, self.d_y, self.d_force], axis=-1)


def press_traces(
    signals: Signals,
    face: Int[np.ndarray, "press"],
    x_mm: Float[np.ndarray, "press"],
    y_mm: Float[np.ndarray, "press"],
) -> Traces:
    """Force and counts at every depth for presses anywhere within the lattice.

    Parameters
    ----------
    face : numbers of the faces pressed
    x_mm, y_mm : places in the face's frame, mm

    Raises
    ------
    InputError
        A place outside the lattice or half a pitch from all that the face has, an unknown face, or a
        force that does not grow with depth.
    """
    _require_pressed(signals, face, x_mm, y_mm)
    weights = _lattice_weights(signals, x_mm, y_mm)
    return _traces(signals, face, weights[0] + 0.0)


def counts_at_force(
    traces: Traces,
    force_n: Float[np.ndarray, "press frame"],
    beyond: Literal["raise", "clamp"] = "raise",
) -> SignalsAtForce:
    """Signals of each press at its own forces (N, ≥ 0).

    Raises
    ------
    InputError
        A negative force, or with `beyond="raise"` a force that the deepest press does not reach.
    """
    largest = np.real(traces.force_n[:, -1:])
    clamped = force_n > largest * (1 + 1e-9)
    if force_n.size and force_n.min() < 0:
        raise InputError(f"press forces must be at least 0 N; got {force_n.min():g}")
    if beyond == "raise" and clamped.any():
        press = int(np.argmax(clamped.any(axis=1)))
        raise InputError(
            f"a force of {force_n[press].max():.3g} N was asked for where the deepest simulated "
            f"press reaches {largest[press, 0]:.3g} N. Ask for less, or add to press.depths_mm"
        )
    held = np.minimum(force_n, largest)
    return SignalsAtForce(traces.curves.evaluate(held), held, clamped)


def depth_at_force(
    traces: Traces, force_n: Float[np.ndarray, "press frame"]
) -> Float[np.ndarray, "press frame"]:
    """Travel (mm) at which each press reaches its forces; the deepest depth beyond its reach."""
    depth = np.broadcast_to(traces.depth_mm[:, None], (*traces.force_n.shape, 1))
    # force grows as depth to the power 3/2: depth to that power is nearly linear in force
    powered = monotone_cubic(
        traces.force_n, depth**1.5, np.minimum(force_n, traces.force_n[:, -1:])
    )
    return powered[..., 0] ** (2 / 3)


def force_at_depth(
    traces: Traces, depth_mm: float | Float[np.ndarray, "press"]
) -> Float[np.ndarray, "press"]:
    """Force (N) of each press at one travel for all or its own (mm, at most the deepest)."""
    powered = np.broadcast_to(traces.depth_mm**1.5, traces.force_n.shape)
    wanted = np.broadcast_to(np.asarray(depth_mm) ** 1.5, len(powered))[:, None]
    return monotone_cubic(powered, traces.force_n[..., None], wanted)[:, 0, 0]


def signal_gradient(
    signals: Signals,
    face: Int[np.ndarray, "press"],
    x_mm: Float[np.ndarray, "press"],
    y_mm: Float[np.ndarray, "press"],
    force_n: Float[np.ndarray, "press"],
) -> SignalGradient:
    """Counts and their derivatives in x, y (at constant force) and force.

    They are the exact derivatives of the interpolant, by complex-step differentiation. Raises as
    `press_traces` and `counts_at_force` do.
    """
    _require_pressed(signals, face, x_mm, y_mm)
    value, along_x, along_y = _lattice_weights(signals, x_mm, y_mm)
    force = force_n[:, None]
    base = _traces(signals, face, value + 0.0)
    counts = counts_at_force(base, force).counts[:, 0]
    derivatives = []
    for change, force_change in ((along_x, 0.0), (along_y, 0.0), (0 * value, 1.0)):
        trace = _traces(signals, face, value + 1j * _STEP * change)
        changed = trace.curves.evaluate(force + 1j * _STEP * force_change)
        derivatives.append(np.imag(changed[:, 0]) / _STEP)
    return SignalGradient(counts, *derivatives)


def _lattice_weights(
    signals: Signals, x_mm: Float[np.ndarray, "press"], y_mm: Float[np.ndarray, "press"]
) -> tuple[Float[np.ndarray, "press place"], ...]:
    """Weights of the lattice places for the value and its x and y derivatives (1, 1/mm, 1/mm)."""
    wx, dx = _axis_weights(signals.lattice.x_mm, x_mm, "x")
    wy, dy = _axis_weights(signals.lattice.y_mm, y_mm, "y")
    pairs = ((wx, wy), (dx, wy), (wx, dy))
    return tuple(
        (a[:, :, None] * b[:, None, :]).reshape(len(a), a.shape[1] * b.shape[1]) for a, b in pairs
    )


def _axis_weights(
    nodes_mm: Float[np.ndarray, "node"], at_mm: Float[np.ndarray, "press"], name: str
) -> tuple[Float[np.ndarray, "press node"], Float[np.ndarray, "press node"]]:
    from scipy.interpolate import make_interp_spline

    low, high = nodes_mm[0] - 1e-9, nodes_mm[-1] + 1e-9
    outside = (at_mm < low) | (at_mm > high)
    if outside.any():
        raise InputError(
            f"{name} = {at_mm[outside][0]:.4g} mm lies outside the pressed lattice "
            f"({nodes_mm[0]:g} to {nodes_mm[-1]:g} mm). Stay inside, or reduce "
            "protocol.lateral_jitter_mm to half of contact_grid.pitch_mm at most"
        )
    spline = make_interp_spline(nodes_mm, np.eye(len(nodes_mm)), k=3)
    return spline(at_mm), spline(at_mm, nu=1)


def _traces(
    signals: Signals,
    face: Int[np.ndarray, "press"],
    weights: Inexact[np.ndarray, "press place"],
) -> Traces:
    nodes = len(signals.depth_mm) + 1
    channels = signals.baseline_counts.size
    force = np.zeros((len(face), nodes), weights.dtype)
    counts = np.zeros((len(face), nodes, channels), weights.dtype)
    whole = signals.whole
    for index, number in enumerate(signals.faces):
        here = np.flatnonzero(face == number)
        force[here, 1:] = weights[here] @ whole.force_n[index]
        delta = whole.delta_counts[index].reshape(len(signals.lattice), -1)
        counts[here, 1:] = (weights[here] @ delta).reshape(len(here), nodes - 1, channels)
    depth = np.concatenate([[0.0], signals.depth_mm])
    return corrected_traces(Traces(depth, force, counts, np.zeros(force.shape, bool)), face)


def _require_pressed(
    signals: Signals,
    face: Int[np.ndarray, "press"],
    x_mm: Float[np.ndarray, "press"],
    y_mm: Float[np.ndarray, "press"],
) -> None:
    """Raise InputError for a face, or a place of it, that was not pressed."""
    unknown = np.setdiff1d(face, signals.faces)
    if unknown.size:
        raise InputError(
            f"face {unknown[0]} was not pressed; signals cover faces {signals.faces.tolist()}"
        )
    if signals.pressed.all():
        return
    for number, pressed in zip(signals.faces.tolist(), signals.pressed, strict=True):
        here = np.flatnonzero(face == number)
        beyond = here[~among_pressed(signals.lattice, pressed, x_mm[here], y_mm[here])]
        if len(beyond):
            x, y = x_mm[beyond[0]], y_mm[beyond[0]]
            raise InputError(
                f"({x:.4g}, {y:.4g}) mm on face {number} lies beside the contact locations that the face "
                "has, and half a pitch round them. Press nearer to one of them"
            )


def among_pressed(
    lattice: PlaceGrid,
    pressed: Bool[np.ndarray, "node"],
    x_mm: Float[np.ndarray, "press"],
    y_mm: Float[np.ndarray, "press"],
) -> Bool[np.ndarray, "press"]:
    """Return whether places of one face lie in a cell of the lattice whose corners are all pressed."""
    is_pressed = pressed.reshape(lattice.shape)
    cells = is_pressed[:-1, :-1] & is_pressed[1:, :-1] & is_pressed[:-1, 1:] & is_pressed[1:, 1:]
    within = np.zeros(len(x_mm), bool)
    for aside_x, aside_y in product((-_ON_EDGE_MM, _ON_EDGE_MM), repeat=2):
        rows, columns = (
            np.clip(np.searchsorted(nodes, values) - 1, 0, len(nodes) - 2)
            for nodes, values in ((lattice.x_mm, x_mm + aside_x), (lattice.y_mm, y_mm + aside_y))
        )
        within |= cells[rows, columns]
    return within


def unresolved_presses(signals: Signals) -> Bool[np.ndarray, "face place step"]:
    """Presses of the lattice whose force does not exceed that of all shallower ones."""
    return ~grows_by_step(signals.force_n) & signals.pressed[..., None]


def grows_by_step(force_n: Float[np.ndarray, "*any step"]) -> Bool[np.ndarray, "*any step"]:
    highest_before = np.maximum.accumulate(force_n, axis=-1)[..., :-1]
    highest_before = np.concatenate(
        [np.zeros_like(force_n[..., :1]), np.maximum(highest_before, 0)], axis=-1
    )
    return np.greater(force_n, highest_before + _LEAST_RISE_N)


def corrected_traces(traces: Traces, face: Int[np.ndarray, "press"]) -> Traces:
    """Put points whose force does not grow on the chord between their neighbours."""
    grows = grows_by_step(np.real(traces.force_n[:, 1:]))
    grows = np.concatenate([np.ones_like(grows[:, :1]), grows], axis=1)
    for press in np.flatnonzero(~grows.all(axis=1)):
        good = np.flatnonzero(grows[press])
        if not grows[press, -1] or 2 * len(good) <= grows.shape[1]:
            received = np.round(np.real(traces.force_n[press]), 3).tolist()
            raise InputError(
                f"the force on face {face[press]} does not grow with depth: {received} N. Refine "
                "mesh.surface_edge_mm or press deeper"
            )
        depth = traces.depth_mm
        units = np.eye(len(depth))
        chord = np.stack([np.interp(depth, depth[good], unit[good]) for unit in units], axis=1)
        traces.force_n[press] = chord @ traces.force_n[press]
        traces.counts[press] = chord @ traces.counts[press]
    return replace(traces, corrected=~grows)
