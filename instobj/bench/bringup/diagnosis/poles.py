"""Pole and pocket of every magnet, from the step that it makes when it is put in.

The change of all chips is compared with what a magnet of the specification would make in any of the
pockets, either way round, with a uniform field by which the hand turned the object.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from estimator.field.models import field_of_each, magnets_model
from estimator.field.vectors import components
from instobj.bench.bringup.asking.asked import magnet_names
from instobj.bench.bringup.diagnosis.findings import ChipFound, Finding

TURNED_UT = 100.0
"""Standard deviation beforehand of a uniform change of the field."""
WEAK, STRONG, ABSENT = 0.6, 1.6, 0.2
"""Strength of a magnet over the designed one below, above and below which a finding is made."""
_MARGIN = 10.0
"""ln of the odds by which another pocket must be likelier."""
_ROBUST = 4.0
"""Scale of Cauchy's misfit, in standard deviations: outliers do not rule."""


@dataclass(frozen=True)
class MagnetFound:
    """One magnet: the pocket that it seems to be in, and its moment there over the designed one."""

    expected_pocket: int
    pocket: int
    strength: float


@dataclass(frozen=True)
class PocketFields:
    """Steps that each magnet of the specification makes, as the found chips read them.

    Attributes
    ----------
    step : counts of every channel
    error : standard deviation that tolerances leave
    uniform : counts of a uniform field of 1 count along x, y, z
    floor : standard deviation that zero and noise of every channel add
    turned : prior standard deviation of a uniform change of the field
    """

    step: Float[np.ndarray, "pocket chip 3"]
    error: Float[np.ndarray, "pocket chip"]
    uniform: Float[np.ndarray, "chip 3 3"]
    floor: float
    turned: float

    def sigma(self, pocket: int) -> Float[np.ndarray, "chip 1"]:
        """Standard deviation (counts) of every chip's channels, for a magnet in a pocket."""
        return np.hypot(self.error[pocket], self.floor)[:, None]


def pocket_fields(spec: ObjectSpec, chips: Sequence[ChipFound]) -> PocketFields:
    """For the object as designed, magnets without `as_built` flips."""
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    model = magnets_model(spec.magnets, 5.0)
    sites = [chip.site for chip in chips]
    axes = np.stack([chip.turn for chip in chips]) @ sensors.axes[sites]
    offset = sensors.position_mm[sites] - magnets.centre_mm[:, None]
    axis, side = components(magnets.axis[:, None]), components(magnets.side[:, None])
    field = field_of_each(components(offset), axis, model, side, magnets.size)
    in_object = magnets.strength[:, None, None] * np.stack(field, axis=-1)
    # p pocket, c chip, b object coordinate, a chip axis; 1e3: field in T, gain per mT
    step = 1e3 * spec.sensors.counts_per_mt * np.einsum("cab,pcb->pca", axes, in_object)
    error = np.linalg.norm(step, axis=2) * _relative(spec, np.linalg.norm(offset, axis=2))
    floor = np.hypot(spec.sensors.zeroing_counts, max(spec.sensors.noise_counts) / 2)
    turned = 1e-3 * TURNED_UT * spec.sensors.counts_per_mt
    return PocketFields(step, error, axes, float(floor), turned)


def _relative(
    spec: ObjectSpec, distance_mm: Float[np.ndarray, "pocket chip"]
) -> Float[np.ndarray, "pocket chip"]:
    given = spec.tolerances
    # along the distance and across it, at the magnet
    at_magnet = (given.magnet_seat_mm, given.magnet_seat_mm)
    seats = (*at_magnet, given.sensor_seat_mm, given.core_shift_mm)
    turns = np.deg2rad([given.magnet_tilt_deg, given.sensor_rotation_deg, given.core_yaw_deg])
    fixed = np.sum(turns**2) + given.remanence_relative**2 + given.sensor_gain_relative**2
    return np.sqrt(fixed + (3 * np.linalg.norm(seats) / distance_mm) ** 2)


def find_magnet(
    fields: PocketFields, expected_pocket: int, change: Float[np.ndarray, "chip 3"]
) -> MagnetFound:
    """Pocket and moment that explain a step (counts, NaN where unknown) best; ties stay as asked."""
    pockets = range(len(fields.step))
    cost = np.array([[cost_of(fields, p, sign, change) for sign in (1.0, -1.0)] for p in pockets])
    cost[np.arange(len(cost)) != expected_pocket] += _MARGIN
    pocket = int(np.unravel_index(np.argmin(cost), cost.shape)[0])
    return MagnetFound(expected_pocket, pocket, strength_of(fields, pocket, change))


def cost_of(
    fields: PocketFields, pocket: int, sign: float, change: Float[np.ndarray, "chip 3"]
) -> float:
    """−ln likelihood, up to a constant, at the best uniform field."""
    residual = change - sign * fields.step[pocket]
    sigma = np.broadcast_to(fields.sigma(pocket), residual.shape)
    has_reading = np.isfinite(residual)
    rows = fields.uniform[has_reading] / sigma[has_reading, None]
    values = residual[has_reading] / sigma[has_reading]
    with_prior = np.vstack([rows, np.eye(3) / fields.turned])
    uniform, *_ = np.linalg.lstsq(with_prior, np.append(values, np.zeros(3)), rcond=None)
    off = (values - rows @ uniform) / _ROBUST
    return float(np.sum(0.5 * _ROBUST**2 * np.log1p(off**2) + np.log(sigma[has_reading])))


def strength_of(fields: PocketFields, pocket: int, change: Float[np.ndarray, "chip 3"]) -> float:
    """Moment over the designed one, together with a uniform field, by weighted least squares."""
    weight = np.broadcast_to(1 / fields.sigma(pocket), change.shape)
    has_reading = np.isfinite(change)
    rows = np.column_stack([fields.step[pocket][has_reading], fields.uniform[has_reading]])
    weighted = rows * weight[has_reading, None], change[has_reading] * weight[has_reading]
    return float(np.linalg.lstsq(*weighted, rcond=None)[0][0])


def magnet_findings(spec: ObjectSpec, magnet: MagnetFound) -> list[Finding]:
    """Return what is wrong with one magnet; nothing where all is well."""
    names = magnet_names(spec)
    name, size = names[magnet.expected_pocket], abs(magnet.strength)
    share = f"{magnet.strength:+.2f} of the designed moment"
    if size < ABSENT:
        return [Finding("weak magnet", name, f"no step was seen ({share})")]
    wrong = []
    if magnet.pocket != magnet.expected_pocket:
        wrong.append(Finding("misplaced magnet", name, f"it seems to be in {names[magnet.pocket]}"))
    if magnet.strength < 0:
        wrong.append(Finding("flipped magnet", name, share))
    elif not WEAK < size < STRONG:
        wrong.append(Finding("weak magnet", name, share))
    return wrong
