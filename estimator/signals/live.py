"""Live channels: those whose readings change with a press. A clipped one stands still, like a dead one.

Every bound, score and estimate of an object asks here which channels count.
"""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import Signals

_Array = TypeVar("_Array", bound=Any)


def is_live(rest_counts: _Array, change_counts: _Array, range_counts: Any) -> Any:
    """Return whether channels are within their range at rest and in a press, arrays or tensors.

    A change is known against rest alone, so that one clipped at rest shows no press either.
    """
    at_rest = abs(rest_counts) <= range_counts
    return at_rest & (abs(rest_counts + change_counts) <= range_counts)


def live_in_press(
    spec: ObjectSpec,
    rest_counts: Float[np.ndarray, "sensor 3"],
    change_counts: Float[np.ndarray, "press channel"],
) -> Bool[np.ndarray, "press channel"]:
    """Return the flat channels that are live in each press: measured, not dead, within their range."""
    in_range = is_live(rest_counts.ravel(), change_counts, full_scale_counts(spec.sensors))
    return in_range & live_channels(spec).ravel()


def live_jacobian(
    spec: ObjectSpec,
    signals: Signals,
    face: Int[np.ndarray, "press"],
    x_mm: Float[np.ndarray, "press"],
    y_mm: Float[np.ndarray, "press"],
    force_n: Float[np.ndarray, "press"],
) -> Float[np.ndarray, "press channel 3"]:
    """∂(counts)/∂(x, y, F) of `signal_gradient`, 0 of channels that are not live there."""
    gradient = signal_gradient(signals, face, x_mm, y_mm, force_n)
    live = live_in_press(spec, signals.baseline_counts, gradient.counts)
    return gradient.jacobian * live[..., None]


def read_change(
    rest_counts: Float[np.ndarray, "channel"],
    change_counts: Float[np.ndarray, "*any channel"],
    range_counts: float,
) -> Float[np.ndarray, "*any channel"]:
    """Expected changes against rest as chips tell them: none beyond the range, none of those clipped at
    rest."""
    pressed = np.clip(rest_counts + change_counts, -range_counts, range_counts)
    return np.where(abs(rest_counts) <= range_counts, pressed - rest_counts, 0.0)
