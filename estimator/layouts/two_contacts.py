"""Bounds of two contacts at once, for many layouts at once, with gradients.

Lowest fidelity level of a layout search, as `estimator.layouts.scoring`: two tips on one face, or one
on each of two opposite faces. Derivatives by (force, x, y) of each contact are brought to an
orthonormal basis, in which all that joins two contacts is a 3 × 3 matrix of cosines. Signals of the
opposite face's sensors are left out, as its magnets are taken to rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from estimator.information.contact_sets import spread_pairs, spread_places
from estimator.layouts.batch import Layouts
from estimator.layouts.cross_face import neighbour_changes
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.scorer import LayoutScorer

_SMALLEST = 1e-6
"""Share of a direction's information that the others do not explain, from which float32 holds."""


@dataclass(frozen=True)
class _Basis:
    """What the signals of each contact span, and how its coordinates turn into x and y.

    x = `x_by_x` · second + `x_by_y` · third, y = `y_by_y` · third coordinate, in mm.
    """

    orthonormal: Float[Tensor, "layout channel 3 place"]
    x_by_x: Float[Tensor, "layout place"]
    x_by_y: Float[Tensor, "layout place"]
    y_by_y: Float[Tensor, "layout place"]


def pairs_own_mm(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "layout pair"]:
    """Position bound of the worse of two contacts on the face, from its own channels."""
    return _pairs_mm(scorer, _basis(_own_changes(scorer, layouts).transpose(0, 1)))


def pairs_all_mm(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "layout pair"]:
    """Position bound of the worse of two contacts on the face, from the channels of all faces."""
    every = _changes_by_face(scorer, layouts)
    return _pairs_mm(scorer, _basis(torch.cat(list(every.values()), dim=1)))


def grasps_mm(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
) -> Float[Tensor, "layout grasp"]:
    """Position bound of the worse of two contacts on opposite faces, from the channels of all faces.

    None where no two of the scorers' faces are opposite.
    """
    found = [torch.zeros(len(layouts[0]), 0, dtype=layouts[0].magnet_mm.dtype)]
    by_face = {pair[0].presses.face: pair for pair in zip(scorers, layouts, strict=True)}
    for face, pair in by_face.items():
        opposite = pair[0].presses.opposite
        if opposite in by_face and face < opposite:
            found.append(_across_mm(pair, by_face[opposite]))
    return torch.cat(found, dim=1)


def _across_mm(
    one: tuple[LayoutScorer, Layouts], other: tuple[LayoutScorer, Layouts]
) -> Float[Tensor, "layout grasp"]:
    changes = _changes_by_face(*one), _changes_by_face(*other)
    zero = torch.zeros_like(changes[0][one[0].presses.face])
    faces = sorted({*changes[0], *changes[1]})
    a, b = (_basis(torch.cat([own.get(f, zero) for f in faces], dim=1)) for own in changes)
    return _worse_mm(a, b, torch.cartesian_prod(*(torch.arange(o.x_by_x.shape[1]) for o in (a, b))))


def _pairs_mm(scorer: LayoutScorer, contacts: _Basis) -> Float[Tensor, "layout pair"]:
    return _worse_mm(contacts, contacts, torch.as_tensor(spread_pairs(scorer.spec)))


def _own_changes(scorer: LayoutScorer, layouts: Layouts) -> Float[Tensor, "channel layout 3 place"]:
    places = _spread_rows(scorer)
    return press_changes(scorer, layouts).by_parameter[:, :, :3, places]


def _spread_rows(scorer: LayoutScorer) -> Int[Tensor, "place"]:
    """Of the spread places among the face's own."""
    return torch.as_tensor(scorer.presses.rows_of(spread_places(scorer.spec)))


def _changes_by_face(
    scorer: LayoutScorer, layouts: Layouts
) -> dict[int, Float[Tensor, "layout channel 3 place"]]:
    """Whitened derivatives by x, y and force of the channels of each face that shows some."""
    places, every = _spread_rows(scorer), scorer.presses.count
    columns = (every * torch.arange(3)[:, None] + places).ravel()
    others = neighbour_changes(scorer, layouts, columns).unflatten(-1, (3, -1))
    own = _own_changes(scorer, layouts).transpose(0, 1)
    named = zip(scorer.presses.neighbours, others.unbind(1), strict=True)
    return {scorer.presses.face: own} | dict(named)


def _basis(changes: Float[Tensor, "layout channel 3 place"]) -> _Basis:
    """Gram–Schmidt in the order force, x, y."""
    x, y, force = changes.unbind(2)
    first, _ = _unit(force, force)
    along_x, along_y = ((first * column).sum(1, keepdim=True) for column in (x, y))
    second, left_x = _unit(x - along_x * first, x)
    y = y - along_y * first
    shared = (second * y).sum(1, keepdim=True)
    third, left_y = _unit(y - shared * second, changes[:, :, 1])
    x_by_y = -shared[:, 0] / (left_x * left_y)
    return _Basis(torch.stack([first, second, third], dim=2), 1 / left_x, x_by_y, 1 / left_y)


def _unit(
    left: Float[Tensor, "layout channel place"], whole: Float[Tensor, "layout channel place"]
) -> tuple[Float[Tensor, "layout channel place"], Float[Tensor, "layout place"]]:
    """Direction and length of what is left of a column, held at a thousandth of the whole."""
    least = _SMALLEST * whole.square().sum(1) + 1e-20
    length = torch.maximum(left.square().sum(1), least).sqrt()
    return left / length[:, None], length


def _worse_mm(
    one: _Basis, other: _Basis, pairs: Int[Tensor, "pair 2"]
) -> Float[Tensor, "layout pair"]:
    a, b = pairs.unbind(1)
    first, second = (basis.orthonormal.double().flatten(2) for basis in (one, other))
    joint = (first.transpose(1, 2) @ second).unflatten(2, (3, -1)).unflatten(1, (3, -1))
    cosine = joint.permute(0, 2, 4, 1, 3)[:, a, b]
    found = _bound_mm(one, cosine, a), _bound_mm(other, cosine.transpose(2, 3), b)
    return torch.maximum(*found).to(one.x_by_x.dtype)


def _bound_mm(
    contact: _Basis, cosine: Float[Tensor, "layout pair 3 3"], place: Int[Tensor, "pair"]
) -> Float[Tensor, "layout pair"]:
    """Bound of one contact where the other is unknown: force eliminated, then x and y."""
    explained = (cosine[..., :, None, :] * cosine[..., None, :, :]).sum(-1)
    left = (1 + _SMALLEST) * torch.eye(3, dtype=cosine.dtype) - explained
    across = left[..., 0, 1:] / left[..., :1, 0]
    xx, xy, yy = (
        left[..., 1 + i, 1 + j] - left[..., 0, 1 + i] * across[..., j]
        for i, j in ((0, 0), (0, 1), (1, 1))
    )
    determinant = (xx * yy - xy * xy).clamp(min=_SMALLEST**2)
    by_x, by_y, own_y = (
        part.double()[:, place] for part in (contact.x_by_x, contact.x_by_y, contact.y_by_y)
    )
    of_x = by_x**2 * yy - 2 * by_x * by_y * xy + by_y**2 * xx
    return ((of_x + own_y**2 * xx) / determinant).sqrt()
