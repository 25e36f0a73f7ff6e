"""Standard deviations of what a frame shows around the forward model."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.inversion.problems import BLIND, Observations
from estimator.signals.nuisances import Nuisance, nuisances
from estimator.signals.presses import Signals
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from fem.presses.results import MagnetMotions, PressForces

_ROUNDING = 12**-0.5
"""Standard deviation of rounding to whole counts."""
SUM_ERROR, MESH_ERROR = 0.006, 0.02
"""Relative errors of the signals: by adding up the motions of contacts, and by the mesh."""
_OBJECTS = 3
"""Virtual objects from which the model's error is taken."""
MOST_ERROR = 0.25
"""Largest relative error of a forward model that explains a frame: it explains no signals off by
more, however wrong it is known to be. Objects within the default tolerances
differ by 0.17 from the design."""


@dataclass(frozen=True)
class Disturbances:
    """Independent Gaussian disturbances of every channel.

    Attributes
    ----------
    noise_counts : (channel,) white noise of a frame
    offset_counts : (channel,) error of the zero and drift since, the same in all frames of a hold
    model_error : (channel,) of the forward model, relative to the change that a chip shows. It turns
        chips and magnets as much as it scales them, so that all axes of a chip get their share.
    force_error : of the modulus, and so of all forces, relative; no signal shows it
    nuisances : that add to all channels together
    """

    noise_counts: Float[np.ndarray, "channel"]
    offset_counts: Float[np.ndarray, "channel"]
    model_error: Float[np.ndarray, "channel"]
    force_error: float = 0.0
    nuisances: tuple[Nuisance, ...] = ()

    @cached_property
    def columns(self) -> Float[np.ndarray, "channel k"]:
        """Counts of the nuisances, a standard deviation of each."""
        none = np.zeros((len(self.noise_counts), 0))
        return np.hstack([none, *(nuisance.columns for nuisance in self.nuisances)])

    @cached_property
    def deviations(self) -> Float[np.ndarray, "k"]:
        """Standard deviation of each unknown of the nuisances, in its unit."""
        deviations = [
            np.full(nuisance.columns.shape[1], nuisance.deviation) for nuisance in self.nuisances
        ]
        return np.concatenate([np.zeros(0), *deviations])

    def observed(
        self,
        counts: Float[np.ndarray, "frame channel"],
        averaged: Int[np.ndarray, "frame"] | None = None,
        drift_counts: float = 0.0,
    ) -> Observations:
        """Return frames with their standard deviations, each the mean of `averaged` readings (default 1).

        Every channel has drifted by `drift_counts` (rms).

        A channel without a reading (NaN) says nothing.
        """
        white = self.noise_counts**2 + _ROUNDING**2
        readings = np.ones(len(counts)) if averaged is None else averaged
        plain_sigma = np.sqrt(white / readings[:, None] + self.offset_counts**2 + drift_counts**2)
        missing = np.isnan(counts)
        counts = np.where(missing, 0.0, counts)
        by_chip = counts.reshape(len(counts), -1, 3)
        change = np.sqrt((by_chip * by_chip).sum(axis=2) / 3).repeat(3, axis=1)
        strict = np.minimum(self.model_error, MOST_ERROR)
        sigmas = (
            plain_sigma,
            np.hypot(plain_sigma, self.model_error * change),
            np.hypot(plain_sigma, strict * change),
        )
        still, sigma, strict = (np.where(missing, BLIND, sigma) for sigma in sigmas)
        return Observations(counts, sigma, still, strict, self.columns)


def disturbances(
    spec: ObjectSpec, model_error: float | Float[np.ndarray, "sensor 1"], force_error: float
) -> Disturbances:
    """Return the specification's disturbances: white noise, `zeroing_counts`
    and what its use changes after the zero.

    The forward model is wrong by `model_error`, of all sensors or of each, and by what adding up
    contacts costs (`SUM_ERROR`). Axes that the part does not measure, and dead ones, say nothing.
    """
    live = live_channels(spec)
    noise = np.where(live, np.asarray(spec.sensors.noise_counts, float), BLIND).ravel()
    offset = np.full(live.size, spec.sensors.zeroing_counts)
    error = np.hypot(np.broadcast_to(model_error, live.shape), SUM_ERROR)
    return Disturbances(noise, offset, error.ravel(), force_error, nuisances(spec))


def design_error(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, signals: Signals
) -> float:
    """Return the relative difference of signals between objects within `[tolerances]` and the design.

    Root mean square over the presses of three virtual objects at equal travel, with what meshes of
    one design differ by.
    """
    pressed = signals.pressed
    size = np.mean(signals.delta_counts[pressed] ** 2)
    drawn = (
        twin_signals(spec, drawn_assembly(spec, spec.seed + number), forces, motions)
        for number in range(_OBJECTS)
    )
    differ = [
        np.mean((variant.delta_counts[pressed] - signals.delta_counts[pressed]) ** 2) / size
        for variant in drawn
    ]
    return float(np.sqrt(np.mean(differ) + MESH_ERROR**2))
