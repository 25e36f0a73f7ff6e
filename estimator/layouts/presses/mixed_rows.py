"""Short rows of magnets anywhere among the candidates, and where candidates end."""

from __future__ import annotations

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import embedding_bag, grid_sample, pad

from design.errors import InputError
from estimator.layouts.batch import Layouts
from estimator.layouts.presses.basis import Patch, PressBasis, StrainCoupling

_BEYOND = 1e-4
"""Share of a lattice step that a magnet may lie beyond the last candidate.

Layouts stand in float32: a magnet on the border may seem to lie outside by rounding.
"""


def interpolate_motion_rows(
    basis: PressBasis, layouts: Layouts
) -> tuple[Float[Tensor, "magnet own"], Float[Tensor, "magnet other"]]:
    """Return the rows of magnets that lie between candidates, as `CandidateMotions.at` does.

    Each row is a tricubic convolution (`cubic_kernel`) of the 4 × 4 × 4 candidates round a magnet.
    Layouts follow one another along `magnet`. The rows are differentiable in the positions.

    Raises
    ------
    InputError
        A place outside the candidates.
    """
    made_of = (
        basis.own_table.rows,
        basis.other_table.rows,
        basis.first_mm,
        basis.step_mm,
        basis.held,
        basis.patches,
    )
    return layouts.kept("rows", made_of, lambda: _mixed_rows(basis, layouts))


def _mixed_rows(
    basis: PressBasis, layouts: Layouts
) -> tuple[Float[Tensor, "magnet own"], Float[Tensor, "magnet other"]]:
    xyd_mm = layouts.magnet_mm.reshape(-1, 3)
    # Flat faces that are alike share one lattice: neighbours and weights serve both tables.
    if not basis.patches:
        near = rows_around(basis, (xyd_mm - basis.first_mm) / basis.step_mm, xyd_mm)
        own_rows = _turned(_weighted(basis.own_table.rows, *near), basis, layouts)
        return own_rows + _moved_by_others(basis, layouts, xyd_mm, near), _weighted(
            basis.other_table.rows, *near
        )
    # Faces that differ have a lattice each: the pressed face first, then its neighbours.
    # The opposite face is left out: its magnets hardly move (`PressBasis`).
    pressed, *adjacent = basis.patches[: 1 + len(basis.neighbours)]
    lengths_mm = _along(pressed, layouts)
    own_rows, *others = (
        rows_around(patch, (place - patch.first_mm) / patch.step_mm, xyd_mm)
        for patch, place in [
            (pressed, lengths_mm),
            *((patch, _along(patch, layouts)) for patch in adjacent),
        ]
    )
    moving = [
        _weighted(basis.other_table.rows, patch.start + index, weight)
        for patch, (index, weight) in zip(basis.patches[1 : 1 + len(others)], others, strict=True)
    ]
    other_rows = torch.cat(moving, dim=1) if moving else torch.zeros_like(xyd_mm[:, :0])
    rows = _turned(_weighted(basis.own_table.rows, *own_rows), basis, layouts)
    return rows + _moved_by_others(basis, layouts, lengths_mm, own_rows), other_rows


def _turned(
    rows: Float[Tensor, "magnet column"], basis: PressBasis, layouts: Layouts
) -> Float[Tensor, "magnet own"]:
    """Return the rows of magnets that are tilted as their layouts say, to first order in the tilt."""
    rank = len(basis.own_table.basis)
    if rows.shape[1] == 6 * rank:
        return rows
    # Columns: 6 · rank of the magnet as it lies flat; then what its 3 rotations gain with each
    # rad of tilt about the face's x, and about its y (`compression.with_turns`).
    still, grown = rows[:, : 6 * rank], rows[:, 6 * rank :].unflatten(1, (2, 3, -1))
    turn = layouts.turn_rad.reshape(-1, 2, 1, 1)
    rotation = turn[:, 0] * grown[:, 0] + turn[:, 1] * grown[:, 1]
    # A tilt changes no displacement: zeros for those 3, and for the vectors that are not kept.
    more = pad(rotation, (0, rank - rotation.shape[2], 3, 0))
    return still + more.flatten(1)


def candidate_ends_mm(
    basis: PressBasis, face: int | None = None
) -> tuple[Float[Tensor, "3"], Float[Tensor, "3"]]:
    """Return the least and greatest (x, y, depth) that have candidates, on one face or on all of them.

    x and y are those of the frames' planes (mm).
    """
    patches = [patch for patch in basis.patches if face in (None, patch.surface.number)]
    ends = [
        (lattice.first_mm, lattice.first_mm + lattice.step_mm * (torch.tensor(lattice.nodes) - 1))
        for lattice in patches or (basis,)
    ]
    # Candidates of a curved face are told by lengths along it; layouts by x and y in its plane.
    for index, patch in enumerate(patches):
        in_plane = torch.stack(ends[index]).double()
        in_plane[:, :2] = torch.as_tensor(
            patch.surface.frame.to_plane(in_plane[:, :2].cpu().numpy())
        )
        ends[index] = in_plane[0].to(basis.first_mm), in_plane[1].to(basis.first_mm)
    least, most = (torch.stack(parts) for parts in zip(*ends, strict=True))
    return least.amax(dim=0), most.amin(dim=0)  # what all of these faces have


def _along(patch: Patch, layouts: Layouts) -> Float[Tensor, "magnet 3"]:
    """Lengths along a patch's surface, and depths, of its magnets, as its candidates have them."""
    xyd = layouts.layouts_of_face(patch.surface.number).magnet_mm.reshape(-1, 3)
    return torch.cat([patch.surface.lengths_mm(xyd[:, :2]), xyd[:, 2:]], dim=1)


def rows_around(
    lattice: PressBasis | Patch, place: Float[Tensor, "magnet 3"], xyd_mm: Float[Tensor, "magnet 3"]
) -> tuple[Int[Tensor, "magnet 64"], Float[Tensor, "magnet 64"]]:
    """Return the rows of the 64 lattice nodes round each place, and their weights.

    `place` counts lattice steps from the first node; `xyd_mm` serves the message alone.
    """
    last = torch.tensor(lattice.nodes, dtype=place.dtype) - 1
    outside = (place < -_BEYOND) | (place > last + _BEYOND)
    if outside.any():
        magnet, axis = outside.nonzero()[0].tolist()
        low = float(lattice.first_mm[axis])
        high = low + float(lattice.step_mm[axis] * last[axis])
        raise InputError(
            f"{('x', 'y', 'depth')[axis]} = {float(xyd_mm[magnet, axis]):.4g} mm of a magnet lies "
            f"outside the candidates ({low:g} to {high:g} mm). Keep magnets within them"
        )
    # Cell of a place; one on the last node belongs to the last cell. A cell has no derivative.
    # The tables hold one more node beyond each end, so that the four neighbours of
    # a cell along an axis, −1 … 2, are nodes cell … cell + 3 of a table of nodes + 2.
    cell = torch.minimum(place.detach().floor().clamp(min=0), last - 1)
    # Weights of a tensor product: w(ix, iy, iz) = x[ix] · y[iy] · z[iz].
    x, y, z = cubic_kernel(place - cell).unbind(1)
    weight = x[:, :, None, None] * y[:, None, :, None] * z[:, None, None, :]
    _, ny, nz = (count + 2 for count in lattice.nodes)
    # Node (ix, iy, iz) is row (ix · ny + iy) · nz + iz. By a sum: CUDA multiplies no integer matrices.
    corner = (cell.long() * torch.tensor([ny * nz, nz, 1])).sum(1)
    around = torch.arange(4)
    near = ((around[:, None, None] * ny + around[:, None]) * nz + around).reshape(-1)
    return corner[:, None] + near, weight.reshape(-1, 64)


def _weighted(
    rows: Float[Tensor, "node column"],
    index: Int[Tensor, "magnet 64"],
    weight: Float[Tensor, "magnet 64"],
) -> Float[Tensor, "magnet column"]:
    """Return weighted sums of 64 rows each, without a copy of the rows."""
    if not rows.numel():
        return torch.zeros(len(index), 0, dtype=weight.dtype)
    return embedding_bag(index, rows, per_sample_weights=weight, mode="sum")


def _moved_by_others(
    basis: PressBasis,
    layouts: Layouts,
    along_mm: Float[Tensor, "magnet 3"],
    near: tuple[Tensor, Tensor],
) -> Float[Tensor, "magnet own"]:
    """Return the rows of the motion that each magnet gets from the other magnets of its face.

    These are rigid: each resists the strain round it, and so moves the silicone (`fem.candidates.influence`).
    """
    count, rank = layouts.magnet_mm.shape[1], len(basis.own_table.basis)
    if count == 1:
        return torch.zeros_like(layouts.magnet_mm[:, 0, :1])
    strain = _weighted(basis.held.strain, *near).reshape(len(layouts), count, 5, -1)
    between = influences(basis.held, along_mm.reshape(len(layouts), count, 3))
    # l layout, i magnet that moves, j magnet that resists, m of 6 motions, s of 5 strains, r vector
    moved = torch.einsum("lijms,ljsr->limr", between, strain)
    if basis.patches and not basis.patches[0].surface.frame.flat:
        # On a curved face motions stand in each magnet's own axes: turn them into the face's frame.
        # t displacement or rotation, a own axis, b axis of the face's frame
        axes = basis.patches[0].surface.magnets(layouts.layouts_of_face(basis.face))[1]
        moved = torch.einsum("liba,litar->litbr", axes, moved.unflatten(2, (2, 3))).flatten(2, 3)
    return pad(moved, (0, rank - moved.shape[3])).flatten(2).flatten(0, 1)


def influences(
    held: StrainCoupling, along_mm: Float[Tensor, "layout magnet 3"]
) -> Float[Tensor, "layout magnet magnet 6 5"]:
    """Return the motion of each magnet of a face, in its own frame, for each strain round each other one.

    `held.values` holds it for pairs along x. So a pair at the angle θ to x is looked up by its
    distance and depths, its strains are turned by −θ, and the motion is turned back by θ.
    """
    xy, depth = along_mm[..., :2], along_mm[..., 2]
    away = xy[:, :, None] - xy[:, None]
    itself = torch.eye(along_mm.shape[1], dtype=torch.bool)[..., None]
    # A magnet is no pair with itself: any length, here (1, 1) mm, avoids 0/0; its row becomes 0 below.
    # 1e-6 mm² (a distance of 1 µm) keeps the root's derivative finite for two magnets at one place.
    distance = (away.masked_fill(itself, 1.0).square().sum(-1) + 1e-6).sqrt()
    own_depth, other_depth = torch.broadcast_tensors(depth[:, :, None], depth[:, None])
    share = (torch.stack([distance, own_depth, other_depth], dim=-1) - held.first_mm) / held.span_mm
    # `grid_sample` takes places from −1 to 1, the table's last axis (distance) first. Beyond the
    # border its end counts: the first distance for nearer pairs, and 0, the last entry, further off.
    table = grid_sample(
        held.values[None], 2 * share[None] - 1, padding_mode="border", align_corners=True
    )
    motion = table[0].permute(1, 2, 3, 0).unflatten(-1, (6, 5)).masked_fill(itself[..., None], 0.0)
    cosine, sine = (away.masked_fill(itself, 1.0) / distance[..., None]).unbind(-1)
    # Columns, in the order of `STRAINS`: the strain along z stays, shears xz and yz turn by θ,
    # strains in the plane by 2θ (cos 2θ = cos² θ − sin² θ, sin 2θ = 2 sin θ cos θ).
    once, twice = (cosine, sine), (cosine.square() - sine.square(), 2 * cosine * sine)
    columns = [motion[..., :1], *_turned_columns(motion[..., 1:3], once)]
    motion = torch.cat([*columns, *_turned_columns(motion[..., 3:], twice)], dim=-1)
    # Rows: x and y of the displacement, and of the rotation, turn by θ; z stays.
    rows = motion.unflatten(-2, (2, 3)).movedim(-2, 0)
    c, s = (part[..., None, None] for part in once)
    turned = torch.stack([c * rows[0] - s * rows[1], s * rows[0] + c * rows[1], rows[2]], dim=-2)
    return turned.flatten(-3, -2)


def _turned_columns(
    pair: Float[Tensor, "*n 6 2"], turn: tuple[Float[Tensor, "*n"], Float[Tensor, "*n"]]
) -> list[Float[Tensor, "*n 6 1"]]:
    """Return two columns of motions for strains in the face's frame, from those in the pair's frame.

    `turn` is the cosine and sine of the angle by which these two strains turn.
    """
    c, s = (part[..., None, None] for part in turn)
    # motion = M ε', and ε' = Tᵀ ε with T = [[c, −s], [s, c]]: the columns of M Tᵀ
    first, second = pair[..., :1], pair[..., 1:]
    return [c * first - s * second, s * first + c * second]


def cubic_kernel(t: Float[Tensor, "magnet 3"]) -> Float[Tensor, "magnet 3 4"]:
    """Return weights of the nodes at −1, 0, 1, 2 for a point at 0 ≤ t ≤ 1.

    Cubic convolution with a = −1/2 (Keys, IEEE Trans. Acoust. Speech Signal Process. 29, 1981):
    exact for parabolas, with a continuous first derivative. Written in Horner's form.
    """
    return torch.stack(
        [
            ((-0.5 * t + 1) * t - 0.5) * t,
            (1.5 * t - 2.5) * t * t + 1,
            ((-1.5 * t + 2) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t,
        ],
        dim=-1,
    )
