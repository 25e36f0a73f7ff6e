"""Flux density of many magnets at many points as torch tensors, with gradients, on any device.

The law is `estimator.field.models`'; this module only cuts the pairs into pieces that fit the
processor's cache and puts the results together, so that gradients in magnet position, axis and
sensor position come from autograd. Where no gradient is wanted on a processor, the pieces are
worked on as NumPy arrays that share the tensors' memory: its operations start a third quicker.

No command needs it: it is the way to large batches with gradients for those who use the library, and
the form in which `benchmarks/field.py` measures the law against magpylib.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from design.errors import InputError
from estimator.field.models import MagnetsModel, sum_over_magnets
from estimator.field.vectors import Vector

_CPU_ARRAY_BYTES = 96 * 1024
"""Size of one temporary of a chunk: a dozen of them about fill a second-level cache, and each is well
below the size at which allocators ask the system for memory every time."""
_ACCELERATOR_PAIRS = 1 << 22
"""Pairs of a chunk where launching a kernel costs more than memory does."""


def batched_field(
    points_mm: Float[Tensor, "#press point 3"],
    centres_mm: Float[Tensor, "#press magnet 3"],
    axes: Float[Tensor, "#press magnet 3"],
    model: MagnetsModel,
    chunk_pairs: int | None = None,
    sides: Float[Tensor, "#press magnet 3"] | None = None,
    strength: Float[Tensor, "magnet"] | None = None,
    size: Int[np.ndarray, "magnet"] | None = None,
) -> Float[Tensor, "press point 3"]:
    """Flux density (T) of all magnets together, at every point of every press.

    Differentiable in all three tensors; autograd then keeps about 25 numbers per pair. float32 costs
    1e-6 of the field compared with the model's own error and is about twice as fast as float64 on a
    processor.

    Parameters
    ----------
    points_mm : mm; first dimension 1 where the points are the same in every press
    centres_mm : mm, centres of the magnets; first dimension 1 where they are the same
    axes : unit vectors along the polarization; normalise inside the graph to optimise them
    model : dipole, multipole or charges (`field.field_model` chooses the order for a nearest distance)
    chunk_pairs : pairs worked on at once; by default what fits the processor's cache
    sides : unit vectors along the first edge of blocks; round magnets need none
    strength : polarization of each magnet over the model's; all alike where left out
    size : which of the model's sizes each magnet has, where there are several

    Raises
    ------
    InputError
        An exact body has no torch form, or the tensors differ in type or device.
    """
    _check(points_mm, centres_mm, axes, model)
    presses = max(len(points_mm), len(centres_mm), len(axes))
    pairs = (chunk_pairs or _default_chunk_pairs(points_mm)) // centres_mm.shape[1]
    press_chunk = max(1, min(presses, pairs))
    point_chunk = max(1, pairs // press_chunk)
    plain = points_mm.device.type == "cpu" and not _wants_gradient(
        points_mm, centres_mm, axes, sides, strength
    )
    weight: Any = 1.0 if strength is None else strength[:, None, None]
    if plain and strength is not None:
        weight = weight.detach().numpy()
    parts = []
    for start in range(0, presses, press_chunk):
        rows = slice(start, start + press_chunk)
        centre = _components(centres_mm, rows, 1, plain)
        axis = _components(axes, rows, 1, plain)
        side = None if sides is None else _components(sides, rows, 1, plain)
        point = _components(points_mm, rows, 0, plain)
        field = [
            _stacked(
                sum_over_magnets(
                    _piece(point, first, point_chunk), centre, axis, model, side, weight, size
                )
            )
            for first in range(0, points_mm.shape[1], point_chunk)
        ]
        parts.append(torch.cat(field, dim=1).permute(2, 1, 0))
    return torch.cat(parts)


def _wants_gradient(*given: Tensor | None) -> bool:
    return torch.is_grad_enabled() and any(t is not None and t.requires_grad for t in given)


def _components(
    vectors: Float[Tensor, "#press many 3"], rows: slice, new_dimension: int, plain: bool
) -> Vector:
    """x, y, z of those presses, each with presses last and a dimension of size 1 put in."""
    if len(vectors) > 1:
        vectors = vectors[rows]
    parts = (part.contiguous().unsqueeze(new_dimension) for part in vectors.permute(2, 1, 0))
    x, y, z = (part.detach().numpy() for part in parts) if plain else parts
    return x, y, z


def _piece(point: Vector, first: int, count: int) -> Vector:
    x, y, z = (component[:, first : first + count] for component in point)
    return x, y, z


def _stacked(field: Vector) -> Tensor:
    """One tensor with the components first."""
    if isinstance(field[0], Tensor):
        return torch.stack(field)
    return torch.from_numpy(np.array(field))


def _default_chunk_pairs(like: Tensor) -> int:
    if like.device.type != "cpu":
        return _ACCELERATOR_PAIRS
    return _CPU_ARRAY_BYTES // like.element_size()


def _check(points_mm: Tensor, centres_mm: Tensor, axes: Tensor, model: MagnetsModel) -> None:
    exact = [size_model.magnet.description for size_model in model.size_models if size_model.exact]
    if exact:
        raise InputError(
            f"the exact field of {exact[0]} has no torch "
            "form and no gradients. Keep points far enough away for the multipole series, or "
            "call estimator.field.total_field"
        )
    kinds = {(str(t.dtype), str(t.device)) for t in (points_mm, centres_mm, axes)}
    if len(kinds) > 1:
        raise InputError(
            "points, centres and axes must share one type and device; got "
            f"{', '.join(' on '.join(kind) for kind in sorted(kinds))}. Convert them alike"
        )
    if 0 in (*points_mm.shape, *centres_mm.shape):
        raise InputError("points and centres must not be empty. Give at least one of each")
