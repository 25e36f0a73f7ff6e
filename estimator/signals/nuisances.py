"""Changes since the zero that are no contact: what each adds to all channels, linear in a few unknowns.

An object that is picked up after its zero is turned in Earth's field and warms up. Each such
nuisance is a priori normal with mean 0. Readers and bounds integrate it out: with the columns A of
`nuisance_columns` the covariance of a frame is diag(σ²) + A Aᵀ.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.spec.environment import EnvironmentSpec
from design.spec.object import ObjectSpec
from estimator.signals.field_setup import scene
from estimator.signals.presses import rest_counts

AMBIENT_FIELD = "ambient field"
"""Name of the nuisance whose unknowns are x, y and z of a uniform field."""


@dataclass(frozen=True)
class Nuisance:
    """One kind of change since the zero.

    Attributes
    ----------
    name, unit : of the unknowns
    deviation : standard deviation of each unknown before a frame is seen, in the unit
    columns : (channel, unknown) counts that one standard deviation of each unknown adds
    """

    name: str
    unit: str
    deviation: float
    columns: Float[np.ndarray, "channel k"]


def nuisances(spec: ObjectSpec) -> tuple[Nuisance, ...]:
    """Return what changes since the zero in the use `limits.use`; nothing where that is "bench".

    Sizes are those of `tolerances`; a size of 0 leaves its nuisance out.
    """
    if spec.limits.use == "bench":
        return ()
    return tuple(nuisance for nuisance in (ambient_field(spec), warmth(spec)) if nuisance.deviation)


def nuisance_columns(spec: ObjectSpec) -> Float[np.ndarray, "channel k"]:
    """Return the columns of all nuisances side by side, counts per standard deviation."""
    channels = 3 * len(scene(spec).sensors.face)
    return np.hstack([np.zeros((channels, 0)), *(nuisance.columns for nuisance in nuisances(spec))])


def ambient_field(spec: ObjectSpec) -> Nuisance:
    """Return the change of a uniform field (µT) along x, y and z of the object.

    Earth's field of size b has any direction at the zero and any other later. A component of a
    random direction has the variance b²/3, and the difference of two twice that. Chips in the shell
    turn with a press: for a turn of 0.1 rad the columns err by a tenth.
    """
    place = scene(spec)
    deviation_ut = float(np.sqrt(2 / 3)) * spec.tolerances.earth_field_ut
    # s sensor, a chip axis, c coordinate of the object: counts per µT along each coordinate
    per_ut = 1e-3 * spec.sensors.counts_per_mt * (place.chips.matrix @ place.sensors.axes)
    return Nuisance(AMBIENT_FIELD, "µT", deviation_ut, deviation_ut * per_ut.reshape(-1, 3))


def warmth(spec: ObjectSpec) -> Nuisance:
    """Return a change of temperature (K) of all magnets together.

    Remanence falls by 0.11 %/K, and with it all that a chip shows at rest. The catalogue has no
    drift of the chips' offsets with temperature: `sensors.drift_counts` is for that.
    """
    deviation_k = spec.tolerances.temperature_k
    alone = spec.changed(environment=EnvironmentSpec())
    per_k = NDFEB_REMANENCE_PER_KELVIN * rest_counts(alone).reshape(-1, 1)
    return Nuisance("temperature", "K", deviation_k, deviation_k * per_k)
