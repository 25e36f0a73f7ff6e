"""Errors that a slipped core and loose tolerances cause, for many layouts at once.

Lowest fidelity level of a layout search (`tolerances.localisation_bias` does the same on simulated
presses): an estimator is calibrated on the design, weighted least squares about its signals, and reads
another object, zeroed as it is. Signals are linear in the magnets' motions, as in
`estimator.layouts.scoring`; what is off about one face's magnets is off about all faces' alike.
Errors add up by their squares: those by the core's shift and by Earth's field, which make up most of it,
for each direction by itself, all others over drawn objects. Everything is differentiable. Medians over
places are within 6 % of exact fields for the same motions of magnets.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from estimator.layouts.batch import Layouts
from estimator.layouts.placed import chips
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.scorer import LayoutScorer, within_candidates

SLIP_MM = 1.0
"""Of the core in the shell, along each of six directions."""
_OBJECTS = 5
"""Within the tolerances but for the core's shift and Earth's field."""
_SEED = 8
_RIDGE = 1e-6
"""Of the scaled information: what float32 can tell from nothing."""


@dataclass(frozen=True)
class _Object:
    """One object off the design: layout, places of its sensors, chips (counts to counts), modulus, change of
    a uniform field between zeroing and press (T, in the face's frame); how much of the mean square it is."""

    layouts: Layouts
    sensor_shift_mm: Float[Tensor, "layout sensor 3"]
    chips: Float[Tensor, "sensor 3 3"]
    modulus_ratio: float
    uniform_t: Float[Tensor, "3"]
    weight: float


def slip_places_mm(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "layout place"]:
    """Place error (rms) where the core has slipped by 1 mm along ±x, ±y and ±n of the face.

    Presses stay as they were: the shell is taken to follow none of the slip.
    """
    return _false_places(scorer, layouts, slipped_scores(layouts))


def tolerance_places_mm(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "layout place"]:
    """Place error (rms) of objects within the specification's tolerances.

    The same draws for every layout. Left out are the core's turn and temperature.
    """
    return _false_places(scorer, layouts, toleranced_scores(scorer, layouts))


def slipped_scores(layouts: Layouts) -> Iterator[_Object]:
    design, ways = _designed(layouts), torch.eye(3, dtype=layouts.sensor_mm.dtype)
    for way in torch.cat([ways, -ways]):
        shift = (SLIP_MM * way).expand_as(design.sensor_shift_mm)
        yield replace(design, sensor_shift_mm=shift, weight=1 / 6)


def _designed(layouts: Layouts) -> _Object:
    like = layouts.sensor_mm
    none = torch.zeros(*like.shape[:2], 3, dtype=like.dtype)
    chips = torch.eye(3, dtype=like.dtype).expand(like.shape[1], 3, 3)
    return _Object(layouts, none, chips, 1.0, none.new_zeros(3), 1.0)


def toleranced_scores(scorer: LayoutScorer, layouts: Layouts) -> Iterator[_Object]:
    rng, sizes, dtype = (
        np.random.default_rng(_SEED),
        scorer.spec.tolerances,
        layouts.sensor_mm.dtype,
    )
    magnets, sensors = layouts.magnet_mm.shape[1], layouts.sensor_mm.shape[1]

    def drawn(*shape: int) -> Tensor:
        return torch.as_tensor(rng.standard_normal(shape), dtype=dtype)

    seat = torch.tensor(
        [sizes.magnet_seat_mm, sizes.magnet_seat_mm, sizes.magnet_seat_depth_mm], dtype=dtype
    )
    for _ in range(_OBJECTS):
        shift, tilt = (
            seat * drawn(magnets, 3),
            np.deg2rad(sizes.magnet_tilt_deg) * drawn(magnets, 2),
        )
        moved = layouts.each(
            partial(_moved, shift, tilt, 1 + sizes.remanence_relative * drawn(magnets))
        )
        shift = sizes.sensor_seat_mm * drawn(sensors, 3)
        turn = np.deg2rad(sizes.sensor_rotation_deg) * drawn(sensors, 3)
        gain = 1 + sizes.sensor_gain_relative * drawn(sensors, 3)
        yield _Object(
            within_candidates(scorer, moved),
            shift.expand(len(layouts), sensors, 3),
            gain[..., None] * (torch.eye(3, dtype=dtype) + cross_products(turn)),
            float(np.exp(sizes.modulus_relative * rng.standard_normal())),
            torch.zeros(3, dtype=dtype),
            1 / _OBJECTS,
        )
    design = _designed(layouts)
    earth_t = 1e-6 * sizes.earth_field_ut * np.sqrt(2 / 3)  # zeroed one way, pressed another
    for way in torch.eye(3, dtype=dtype):
        shift = (sizes.core_shift_mm * way).expand_as(design.sensor_shift_mm)
        yield replace(design, sensor_shift_mm=shift)
        yield replace(design, uniform_t=earth_t * way)


def _moved(
    shift_mm: Tensor, tilt_rad: Tensor, strength: Tensor, one: Layouts, _: int | None
) -> Layouts:
    return replace(
        one,
        magnet_mm=one.magnet_mm + shift_mm,
        turn_rad=one.turn_rad + tilt_rad,
        polarity=one.polarity * strength,
    )


def _false_places(
    scorer: LayoutScorer, layouts: Layouts, objects: Iterator[_Object]
) -> Float[Tensor, "layout place"]:
    nominal = press_changes(scorer, layouts).by_parameter
    square = torch.zeros_like(nominal[0, :, 0])
    for one in objects:
        off = signals_of_object(scorer, one) - nominal[:, :, 3]
        square = square + one.weight * read_places(nominal[:, :, :3], off)[..., :2].square().sum(-1)
    return (square + 1e-12).sqrt()


def signals_of_object(scorer: LayoutScorer, one: _Object) -> Float[Tensor, "channel layout place"]:
    """Whitened change in presses of the same force."""
    changes = press_changes(scorer, one.layouts, one.sensor_shift_mm).by_parameter
    force = scorer.presses.force_n
    change = changes[:, :, 3] + changes[:, :, 2] * (force / one.modulus_ratio - force)
    sigma = scorer.sigma_counts
    if one.uniform_t.any():
        _, axes = chips(scorer.presses, one.layouts, scorer.sensor_depth_mm, scorer.chip)
        uniform = scorer.counts_per_t / sigma * (axes @ one.uniform_t)
        change = change + uniform.flatten(1).T[..., None]
    turned = one.chips * sigma / sigma[:, None]  # from and to units of sigma
    by_sensor = change.unflatten(0, (-1, 3))
    return torch.einsum("sij,sjlp->silp", turned, by_sensor).flatten(0, 1)


def read_places(
    jacobian: Float[Tensor, "channel layout 3 place"],
    change: Float[Tensor, "channel layout place"],
) -> Float[Tensor, "layout place 3"]:
    """Least squares for x, y (mm) and force (N)."""
    by_place = jacobian.permute(1, 3, 0, 2)
    size = (by_place.square().sum(dim=2, keepdim=True) + 1e-20).sqrt()
    scaled = by_place / size
    information = scaled.transpose(2, 3) @ scaled + _RIDGE * torch.eye(3, dtype=scaled.dtype)
    projected = scaled.transpose(2, 3) @ change.permute(1, 2, 0)[..., None]
    return torch.linalg.solve(information, projected)[..., 0] / size[:, :, 0]


def cross_products(turn: Float[Tensor, "sensor 3"]) -> Float[Tensor, "sensor 3 3"]:
    """Matrices of the small rotations that turn chips: fields turn the other way."""
    x, y, z = turn.unbind(1)
    zero = torch.zeros_like(x)
    rows = torch.stack([zero, z, -y, -z, zero, x, y, -x, zero], dim=1)
    return rows.unflatten(1, (3, 3))
