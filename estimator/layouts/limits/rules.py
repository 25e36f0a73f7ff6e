"""Limits that a batch of layouts breaks, as distances with gradients.

The rules are the same that check a specification, those of `check --fabrication` that layouts
decide (`design.fabrication.layout`, with its figures), and the search's own.
"""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.layouts.batch import Layouts
from estimator.layouts.limits.curved import broken_on_surfaces_mm
from estimator.layouts.limits.flat import broken_on_flat_faces_mm
from estimator.layouts.limits.parts import boards_beside_hole_mm, boards_of
from estimator.layouts.limits.reverse import broken_in_reverse_mm
from estimator.layouts.presses.basis import faces_differ
from estimator.layouts.vectors import LayoutSpace

RULES = (
    "pocket gap",
    "pockets near the edge",
    "pocket gap across an edge",
    "seal",
    "board gap",
    "boards near the edge",
    "board beside the wire hole",
    "chip near a magnet",
    "magnets in the core",
)


def constraint_violations_mm(
    space: LayoutSpace, layouts: Layouts, face: int
) -> Float[Tensor, "layout rule"]:
    """Return how much each of `RULES` is broken, mm summed over the parts; 0 where it is kept.

    The layouts are those of one face; magnets, and sensors that move, lie alike on all. Where faces
    differ, on the face that breaks a rule most.
    """
    spec = space.structured
    all_layouts = list(layouts.by_face.values()) or [layouts]
    pocket_gap, board_gap = max(spec.silicone.thinnest_wall_mm, space.gap_mm), spec.printer.wall_mm
    in_core = spec.arrangement == "sensors-in-core"
    broken = broken_on_surfaces_mm if faces_differ(spec) else broken_on_flat_faces_mm
    if in_core:
        missing = broken(spec, layouts, face, pocket_gap, board_gap)
    else:
        missing = broken_in_reverse_mm(spec, layouts, pocket_gap)
    nothing = torch.zeros_like(layouts.sensor_mm[:, 0, 0])
    if space.sensors and in_core:
        beside = [
            boards_beside_hole_mm(spec, boards_of(spec, layouts_of_face))
            for layouts_of_face in all_layouts
        ]
        rule = "board beside the wire hole"
        missing[rule] = torch.stack([*beside, missing.get(rule, nothing)]).amax(dim=0)
    return torch.stack([missing.get(rule, nothing) for rule in RULES], dim=1)
