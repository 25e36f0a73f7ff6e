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
_MOMENT_AM2 = 0.4
"""Deviation of a foreign magnet's moment: Ø10 × 5 mm of 1.3 T."""
_SHELLS_MM = ((25.0, 45.0), (45.0, 75.0), (75.0, 130.0))
"""Distances of such magnets beyond the farthest chip: nearer ones pull the object's own magnets. One wide
prior for all of them would leave far ones to contacts: it asks for gradients ten times as large."""
_DRAWN_MAGNETS, _MAGNET_COLUMNS = 2000, 15
"""Magnets drawn, and columns kept: a uniform field, its 5 gradients and 7 second derivatives."""


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


def magnet_columns(spec: ObjectSpec) -> tuple[Float[np.ndarray, "channel k"], ...]:
    """Return columns A, with A Aᵀ the covariance of the counts that a magnet near the object adds.

    One array for each shell of distances, the nearest first. No contact adds these. Magnets are
    drawn: dipoles in any direction and distance (log-uniform). The columns kept hold all but 5 % of
    a channel's deviation; they feel steel with a moment too.
    """
    place = scene(spec)
    sensors_mm = place.sensors.position_mm
    farthest_mm = float(np.linalg.norm(sensors_mm, axis=1).max())
    # n magnet, s sensor, a chip axis, c coordinate of the object
    axes = spec.sensors.counts_per_mt * (place.chips.matrix @ place.sensors.axes)
    columns = []
    for shell_mm in _SHELLS_MM:
        field_mt = _drawn_dipoles_mt(sensors_mm, farthest_mm + np.array(shell_mm))
        counts = np.einsum("sac,nsc->nsa", axes, field_mt).reshape(_DRAWN_MAGNETS, -1)
        _, size, rows = np.linalg.svd(counts / _DRAWN_MAGNETS**0.5, full_matrices=False)
        columns.append((size[:_MAGNET_COLUMNS, None] * rows[:_MAGNET_COLUMNS]).T)
    return tuple(columns)


def _drawn_dipoles_mt(
    sensors_mm: Float[np.ndarray, "sensor 3"], shell_mm: Float[np.ndarray, "2"]
) -> Float[np.ndarray, "magnet sensor 3"]:
    """Return the fields (mT) of dipoles drawn in a shell of distances from the middle."""
    rng = np.random.default_rng(0)
    way = rng.standard_normal((_DRAWN_MAGNETS, 1, 3))
    way /= np.linalg.norm(way, axis=2, keepdims=True)
    low, high = np.log(shell_mm)
    distance_mm = np.exp(rng.uniform(low, high, (_DRAWN_MAGNETS, 1, 1)))
    moment = _MOMENT_AM2 / 3**0.5 * rng.standard_normal((_DRAWN_MAGNETS, 1, 3))
    offset_mm = sensors_mm - distance_mm * way
    far_mm = np.linalg.norm(offset_mm, axis=2, keepdims=True)
    direction = offset_mm / far_mm
    # Dipole (Jackson, Classical Electrodynamics, 3rd ed., 5.56), μ0/4π = 1e-7; mT and mm: 1e3 · 1e9
    projection = (direction * moment).sum(axis=2, keepdims=True)
    return 1e5 / far_mm**3 * (3 * direction * projection - moment)
