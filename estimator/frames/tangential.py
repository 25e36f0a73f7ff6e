"""Tangential forces in simulated frames: signals per newton along the face, at any place and force.

They come from the contact locations alone (`estimator.information.shear`), a grid twice as coarse as that
of the presses, by the same interpolation.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import grid_places_in_lattice
from design.spec.object import ObjectSpec
from estimator.information.shear import ShearSignals, carry_over_missing
from estimator.signals.interpolation import Traces, counts_at_force, press_traces
from estimator.signals.presses import Signals


def slope_traces(
    spec: ObjectSpec,
    signals: Signals,
    shear: ShearSignals,
    face: Int[np.ndarray, "press"],
    xy_mm: Float[np.ndarray, "press 2"],
) -> tuple[Traces, Traces]:
    """Counts per newton along x and along y, at growing normal force, for presses on the grid's area.

    Raises
    ------
    InputError
        A place beyond the outermost contact locations.
    """
    force = signals.force_n[:, grid_places_in_lattice(spec)]
    traces_by_axis = []
    for axis in range(2):
        per_n = Signals(
            shear.faces,
            shear.grid,
            shear.depth_mm,
            force,
            shear.counts_per_n[:, :, :, axis],
            signals.baseline_counts,
        )
        traces = press_traces(per_n, face, xy_mm[:, 0], xy_mm[:, 1])
        counts = traces.counts.copy()
        carry_over_missing(counts)
        traces_by_axis.append(replace(traces, counts=counts))
    return traces_by_axis[0], traces_by_axis[1]


def pulled_counts(
    slopes: tuple[Traces, Traces],
    force_n: Float[np.ndarray, "press frame"],
    pull_n: Float[np.ndarray, "press frame 2"],
) -> Float[np.ndarray, "press frame channel"]:
    """Change of counts by tangential forces at given normal forces."""
    counts_per_n = [counts_at_force(traces, force_n, "clamp").counts for traces in slopes]
    return counts_per_n[0] * pull_n[..., :1] + counts_per_n[1] * pull_n[..., 1:]
