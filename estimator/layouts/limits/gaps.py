"""Gaps between cylinders and boxes of a batch of layouts, as `design.layout` has them, with gradients."""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

Prisms = tuple[Tensor, Tensor, Tensor]
"""Floor, top and axis of pockets, coordinates first, in the object's frame."""


def length(vector: Tensor) -> Tensor:
    """Return lengths of vectors, coordinates first."""
    return (vector**2).sum(0).clamp(min=1e-12).sqrt()


def shortest_way(p: Tensor, p_end: Tensor, q: Tensor, q_end: Tensor) -> Tensor:
    """Shortest way from the second of two segments to the first, coordinates first, as
    `design.layout.pockets` has it."""
    first, second, gap = p_end - p, q_end - q, p - q
    aa, bb, ab = ((u * v).sum(0) for u, v in ((first, first), (second, second), (first, second)))
    pa, pb = (first * gap).sum(0), (second * gap).sum(0)
    determinant = aa * bb - ab * ab
    parallel = determinant < 1e-6 * aa * bb
    s = (ab * pb - bb * pa) / torch.where(parallel, 1.0, determinant)
    s = torch.where(parallel, 0.0, s).clamp(0, 1)
    t = ((ab * s + pb) / bb).clamp(0, 1)
    s = ((ab * t - pa) / aa).clamp(0, 1)
    return gap + s * first - t * second


def missing_between_prisms_mm(
    first: Prisms, second: Prisms, radius: Float[Tensor, "magnet"], least: float
) -> Float[Tensor, "edge layout magnet other"]:
    """Return what the gap of every two prisms lacks; in full only where spheres round them lack it.

    `radius` holds that of the prisms, which both sides share in this order.
    """
    p, p_end, u = (part[..., :, None] for part in first)
    q, q_end, v = (part[..., None, :] for part in second)
    parts = torch.broadcast_tensors(p, p_end, u, q, q_end, v)
    p, p_end, _, q, q_end, _ = (part.detach() for part in parts)
    apart = ((p + p_end - q - q_end) / 2).norm(dim=0)
    halves = ((p_end - p).norm(dim=0) + (q_end - q).norm(dim=0)) / 2
    close = (apart - halves - radius[:, None] - radius < least).nonzero(as_tuple=True)
    p, p_end, u, q, q_end, v = (part[:, *close] for part in parts)
    gap = _gap_of_prisms((p, p_end, u), (q, q_end, v), (radius[close[-2]], radius[close[-1]]))
    return torch.zeros_like(apart).index_put(close, torch.relu(least - gap))


def _gap_of_prisms(
    first: Prisms, second: Prisms, radii: tuple[Float[Tensor, "pair"], Float[Tensor, "pair"]]
) -> Float[Tensor, "pair"]:
    """Largest gap along either axis and along the shortest way between the axes."""
    (p, p_end, u), (q, q_end, v) = first, second
    way = shortest_way(p, p_end, q, q_end)
    gaps = []
    for d in (way / length(way), u, v):
        a, a_end, b, b_end = ((d * end).sum(0) for end in (p, p_end, q, q_end))
        reach = sum(
            radius * (1 - (d * axis).sum(0) ** 2).clamp(min=1e-12).sqrt()
            for radius, axis in zip(radii, (u, v), strict=True)
        )
        apart = torch.maximum(
            torch.minimum(a, a_end) - torch.maximum(b, b_end),
            torch.minimum(b, b_end) - torch.maximum(a, a_end),
        )
        gaps.append(apart - reach)
    return torch.stack(gaps).amax(dim=0)


def missing_between_boxes_mm(
    centre: Float[Tensor, "layout box 3"],
    axes: Float[Tensor, "layout box 3 3"],
    half_mm: Float[Tensor, "3"] | Float[Tensor, "layout box 3"],
    least_mm: float,
) -> Float[Tensor, "layout"]:
    """Return what the gaps of any two boxes lack; `half_mm` are half edges of all, or of each.

    As `design.layout.boards`: the gap of two boxes is the largest along any of their axes and the
    products of these. Worked out in full only where it may be missing: along its own axes a box
    reaches half its edges, a turned one no further than its corners.
    """
    half = half_mm.expand_as(centre)
    i, j = torch.triu_indices(centre.shape[1], centre.shape[1], offset=1)
    with torch.no_grad():
        way = (centre[:, i] - centre[:, j])[..., None]
        beside = [
            ((axes[:, k] @ way)[..., 0].abs() - half[:, k]).amax(dim=-1)
            - half[:, neighbour].norm(dim=-1)
            for k, neighbour in ((i, j), (j, i))
        ]
        close = torch.maximum(*beside) < least_mm
    layout, pair = close.nonzero(as_tuple=True)
    first, second = (layout, i[pair]), (layout, j[pair])
    a, b = axes[first], axes[second]
    crossed = torch.linalg.cross(a[..., :, None, :], b[..., None, :, :]).flatten(-3, -2)
    directions = torch.cat([a, b, crossed], dim=-2)
    length = (directions * directions).sum(-1, keepdim=True)
    parallel = length[..., 0] < 1e-6
    directions = directions / length.clamp(min=1e-6).sqrt()
    apart = (directions @ (centre[first] - centre[second])[..., None])[..., 0].abs()
    reach = sum(
        ((directions @ box.transpose(-1, -2)).abs() @ edges[..., None])[..., 0]
        for box, edges in ((a, half[first]), (b, half[second]))
    )
    gap = (apart - reach).masked_fill(parallel, -torch.inf).amax(dim=-1)
    missing = torch.relu(least_mm - gap)
    return torch.zeros_like(centre[:, 0, 0]).index_add(0, layout, missing)
