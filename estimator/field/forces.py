"""Forces and torques on magnets: by each other, and by steel plates through their images.

A magnet of uniform polarization J feels a field as its pole charges do: F = ∮ (J·n) B dA / μ₀ and
τ = ∮ (J·n) r × B dA / μ₀ over its two flat ends (Jackson, Classical Electrodynamics, section 5.10),
with B of all other sources. No gradient is needed, and near magnets count with their true shapes.
Steel pulls a magnet as its image does. Aluminium, plastic and silicone have no image at rest.

Ends of near magnets are summed over 4 × 16 points: within 0.3 % of magpylib for magnets of Ø6 that
leave 1 mm between them or more, and of far ones over four points, within 1 % (tests). Polarization is
that of magnets alone; what near ones take from each other's is left out (docs/measured/field.md).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import MagnetLayout, magnet_layout
from design.layout.pockets import Outline
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from estimator.field.environment import Plate
from estimator.field.models import MagnetsModel, field_of_each, magnets_model
from estimator.field.sources import DiskMagnet, Magnet, magnet_sources
from estimator.field.vectors import components
from fem.candidates.quadrature import outline_quadrature

_NEAR_POINTS, _FAR_POINTS = (4, 16), (1, 4)
"""Circles on an end of a round magnet, and points on each; blocks take half as many each way."""
_FAR = 5.0
"""Distance of centres, in radii of the sphere about the largest magnet, beyond which few points do."""
_N_PER_T2_MM2 = 1e-6 / (4e-7 * np.pi)
"""Force (N) per T² mm²: 1/μ₀ in A/(T m), and mm² in m²."""
_POINTS_PER_CHUNK = 4000
"""Points on targets at a time: a dozen arrays of them in float64 fit a second-level cache."""
_ITSELF_MM = 1e-9
"""Distance below which a source is the target itself."""


def resting_loads(spec: ObjectSpec) -> Float[np.ndarray, "magnet 6"]:
    """Force (N) and torque about its centre (N mm) on each magnet at rest, by all others."""
    magnets = magnet_layout(spec)
    return loads_by_each(magnets, magnets, spec.magnets).sum(axis=1)


def plate_loads(spec: ObjectSpec, plate: Plate) -> Float[np.ndarray, "magnet 6"]:
    """Force (N) and torque about its centre (N mm) on each magnet at rest, by a steel plate."""
    magnets = magnet_layout(spec)
    return loads_by_each(magnets, mirrored(magnets, plate), spec.magnets).sum(axis=1)


def loads_by_each(
    targets: MagnetLayout, sources: MagnetLayout, magnets: MagnetSpec
) -> Float[np.ndarray, "target source 6"]:
    """Force (N) and torque about its centre (N mm) on each target by each source; a magnet exerts none
    on itself."""
    bodies = magnet_sources(magnets)
    gap = np.linalg.norm(targets.centre_mm[:, None] - sources.centre_mm, axis=2)
    itself = gap < _ITSELF_MM
    reach = max(body.circumscribed_radius_mm for body in bodies)
    is_far = gap > _FAR * reach
    loads = np.zeros((*gap.shape, 6))
    for pairs, count in ((~is_far & ~itself, _NEAR_POINTS), (is_far, _FAR_POINTS)):
        if not pairs.any():
            continue
        # Points on a target are nearer to a source than its centre, by its radius at most.
        model = magnets_model(magnets, max(float(gap[pairs].min()) - reach, 0.0))
        of_size = targets.size[:, None] == np.arange(len(bodies))
        for body, has_size in zip(bodies, of_size.T, strict=True):
            poles = _poles(body, *count)
            target, source = np.nonzero(pairs & has_size[:, None])
            for some in _chunks(len(target), len(poles[1])):
                row, column = target[some], source[some]
                acting = sources.choose(column)
                loads[row, column] = _loads(targets.choose(row), poles, acting, model)
    return loads


def _chunks(pairs: int, points: int) -> Iterator[slice]:
    """Yield slices of pairs with as many points at a time as are quick."""
    step = max(1, _POINTS_PER_CHUNK // points)
    yield from (slice(first, first + step) for first in range(0, pairs, step))


def mirrored(magnets: MagnetLayout, plate: Plate) -> MagnetLayout:
    """Return the images of magnets behind the surface of a steel plate."""
    images = (
        plate.image_of_place(components(magnets.centre_mm)),
        plate.image_of_moment(components(magnets.axis)),
        plate.image_of_moment(components(magnets.side)),
    )
    centre, axis, side = (np.stack(image, axis=-1) for image in images)
    strength = plate.strength * magnets.strength
    return replace(magnets, centre_mm=centre, axis=axis, side=side, strength=strength)


_Poles = tuple[Float[np.ndarray, "point 3"], Float[np.ndarray, "point"]]
"""Points on a magnet's ends in its own frame (mm), and the pole charge of each (T mm²)."""


def _loads(
    targets: MagnetLayout, poles: _Poles, sources: MagnetLayout, model: MagnetsModel
) -> Float[np.ndarray, "pair 6"]:
    """Force and torque on targets of one size, each by the source of its number."""
    points, charges = poles
    arm = points @ targets.frames.swapaxes(1, 2)
    offset = components(targets.centre_mm[:, None] + arm - sources.centre_mm[:, None])
    axis, side = (components(given[:, None]) for given in (sources.axis, sources.side))
    field_t = np.stack(field_of_each(offset, axis, model, side, sources.size), axis=-1)
    field_t *= sources.strength[:, None, None]
    # s pair, p point, k coordinate: charge times field, summed over the points
    weight = _N_PER_T2_MM2 * targets.strength[:, None] * charges
    force, torque = (
        np.einsum("sp,spk->sk", weight, part) for part in (field_t, np.cross(arm, field_t))
    )
    return np.hstack([force, torque])


def _poles(magnet: Magnet, radial: int, around: int) -> _Poles:
    if isinstance(magnet, DiskMagnet):
        ends = [(Outline((r, r), True), w * np.pi * r**2) for r, w in magnet.cylinders]
    else:
        x, y = magnet.size_mm
        ends = [(Outline((x / 2, y / 2), False), x * y)]
    points, charges = [], []
    for outline, area in ends:
        flat, share = outline_quadrature(outline, radial, around)
        for sign in (1.0, -1.0):
            points.append(np.column_stack([flat, np.full(len(flat), sign * magnet.height_mm / 2)]))
            charges.append(sign * magnet.polarization_t * area * share)
    return np.concatenate(points), np.concatenate(charges)
