"""Constants of layouts that are scored in batches: presses, chips, magnets and noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.errors import InputError
from design.layout.places.positions import chip_on_board
from design.layout.pockets import boards_depth_mm
from design.spec.object import ObjectSpec
from estimator.field.sources import BlockMagnet, Magnet, magnet_sources
from estimator.information.fisher import disturbance_counts
from estimator.layouts.batch import Layouts
from estimator.layouts.presses.basis import PressBasis
from estimator.layouts.presses.mixed_rows import candidate_ends_mm


@dataclass(frozen=True)
class LayoutScorer:
    """All that stays the same between layouts; `layout_scorer` makes it.

    `sizes` are the sources of the magnets' distinct sizes, `presses_of` the presses at candidates of each.
    `chip` are the chip's axes as columns on its board, `counts_per_t` counts per T,
    `white_share` one sigma of an axis over that of the white noise. The pressed face stands for
    `faces` sensed ones. `sensor_depth_mm` is below the face, in the core or in the shell; there the
    sensors' boards move and the magnets rest.
    """

    spec: ObjectSpec
    presses_of: tuple[PressBasis, ...]
    sizes: tuple[Magnet, ...]
    sensor_depth_mm: float
    chip: Float[Tensor, "3 3"]
    counts_per_t: float
    sigma_counts: Float[Tensor, "3"]
    white_share: Float[Tensor, "3"]
    faces: int = 1

    @property
    def presses(self) -> PressBasis:
        """Those of the first size: the shell's own figures are the same in all."""
        return self.presses_of[0]

    @property
    def sensors_move(self) -> bool:
        return self.spec.arrangement == "sensors-in-shell"

    def size_variants(
        self, layouts: Layouts
    ) -> list[tuple[PressBasis, Layouts, tuple[int, ...] | None]]:
        """Return bodies that move with the silicone, size by size: presses, the bodies alone, and which of
        a face's they are; None for all."""
        bodies = layouts
        if self.sensors_move:
            bodies = layouts.kept("boards", (self.spec,), lambda: moving_bodies(self, layouts))
        if len(self.presses_of) == 1:
            return [(self.presses, bodies, None)]
        return [
            (presses, bodies.kept(which, (), partial(bodies.magnets, which)), which)
            for presses, which in zip(
                self.presses_of, self.spec.magnets.numbers_by_size, strict=True
            )
        ]


def layout_scorer(
    spec: ObjectSpec,
    presses: PressBasis | Sequence[PressBasis],
    faces: int = 1,
) -> LayoutScorer:
    """Set up scoring of layouts of this specification's magnets and chips, with the presses at candidates of
    every size of what moves with the silicone.

    Chips are nominal, and nothing but the magnets is around: what the environment adds at rest does
    not change the bounds.

    Raises
    ------
    InputError
        Of `require_scorable`.
    """
    require_scorable(spec)
    presses_of = (presses,) if isinstance(presses, PressBasis) else tuple(presses)
    like = presses_of[0].first_mm
    sigma = disturbance_counts(spec.sensors, "fresh", 3)
    white = np.asarray(spec.sensors.noise_counts, dtype=float)
    return LayoutScorer(
        spec,
        presses_of,
        magnet_sources(spec.magnets),
        _sensor_depth_mm(spec),
        torch.as_tensor(chip_on_board(spec.sensors), dtype=like.dtype),
        1e3 * spec.sensors.counts_per_mt,
        torch.as_tensor(sigma, dtype=like.dtype),
        torch.as_tensor(sigma / white, dtype=like.dtype),
        faces,
    )


def _sensor_depth_mm(spec: ObjectSpec) -> float:
    if spec.arrangement == "sensors-in-shell":
        return boards_depth_mm(spec)
    return spec.shell.thickness_mm + spec.sensors.depth_below_core_face_mm


def require_scorable(spec: ObjectSpec) -> None:
    """Layouts of this specification can be scored in batches.

    Raises
    ------
    InputError
        Blocks, chips turned one by one, or an axis
        without noise.
    """
    blocks = [m for m in magnet_sources(spec.magnets) if isinstance(m, BlockMagnet)]
    if blocks:
        raise InputError(
            f"layouts are scored in batches with round magnets only; got {blocks[0].description}. Use the "
            "full chain"
        )
    if spec.sensors.rotations_deg is not None:
        raise InputError(
            "layouts are scored in batches with chips turned by the azimuth of their place; got "
            "sensors.rotations_deg. Use the full chain"
        )
    if not all(np.ravel(spec.sensors.noise_counts)):
        raise InputError("δ needs white noise on every axis. Set sensors.noise_counts above 0")


def clamp_to_candidates(scorer: LayoutScorer, layouts: Layouts) -> Layouts:
    """Magnets, or boards in the silicone, beyond the candidates at the nearest of their places."""

    same: dict[tuple[object, ...], Layouts] = {}

    def nearest(layouts_of_face: Layouts, face: int | None) -> Layouts:
        first, last = _ends_of_bodies_mm(scorer, face)
        # faces that share layouts and candidates go on sharing
        key = id(layouts_of_face), *first.flatten().tolist(), *last.flatten().tolist()
        if key not in same:
            same[key] = clamped(layouts_of_face, first, last)
        return same[key]

    def clamped(layouts_of_face: Layouts, first: Tensor, last: Tensor) -> Layouts:
        if scorer.sensors_move:
            xy = torch.maximum(
                torch.minimum(layouts_of_face.sensor_mm, last[..., :2]), first[..., :2]
            )
            return replace(layouts_of_face, sensor_mm=xy)
        return replace(
            layouts_of_face,
            magnet_mm=torch.maximum(torch.minimum(layouts_of_face.magnet_mm, last), first),
        )

    return layouts.map_faces(nearest)


def _ends_of_bodies_mm(scorer: LayoutScorer, face: int | None) -> tuple[Tensor, Tensor]:
    """Least and greatest (x, y, depth) of candidates; (body, 3) where bodies have several sizes."""
    ends = [candidate_ends_mm(presses, face) for presses in scorer.presses_of]
    if len(ends) == 1:
        return ends[0]
    numbers = list(scorer.spec.magnets.size_numbers)
    first, last = (torch.stack(parts)[numbers] for parts in zip(*ends, strict=True))
    return first, last


def moving_bodies(scorer: LayoutScorer, layouts: Layouts) -> Layouts:
    """Return what moves with the silicone, as magnets of layouts: these, or boards that lie flat."""
    if not scorer.sensors_move:
        return layouts

    def boards(layouts_of_face: Layouts, _: int | None) -> Layouts:
        depth = torch.full_like(layouts_of_face.sensor_mm[..., :1], scorer.sensor_depth_mm)
        flat, place = (
            torch.zeros_like(layouts_of_face.sensor_mm),
            torch.cat([layouts_of_face.sensor_mm, depth], dim=-1),
        )
        return replace(
            layouts_of_face, magnet_mm=place, turn_rad=flat, polarity=torch.ones_like(flat[..., 0])
        )

    return layouts.map_faces(boards)
