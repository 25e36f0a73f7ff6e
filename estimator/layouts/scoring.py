"""Scores of many layouts in batches on stored motions of candidate magnets, with gradients.

Lowest fidelity level of a layout search. A layout is one face's magnets and sensors, repeated on every face;
every magnet is rigid as if it were alone. Counts are linearised in the magnets' motions about rest,
J = ∂S/∂(motion) · ∂(motion)/∂(x, y, F), with the field's derivatives in closed form and the
motions' compressed (`estimator.layouts.press_basis`). The other faces' magnets count too, by a lower order
of the series and a shorter basis: cheap, as they are further away and move less.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from design.errors import InputError
from design.layout.places.positions import chip_on_board
from design.layout.pockets import boards_depth_mm
from design.spec.object import ObjectSpec
from estimator.field.gradient import FieldChange
from estimator.field.sources import BlockMagnet, Magnet, magnet_sources
from estimator.information.fisher import NoiseState, disturbance_counts
from estimator.layouts.batch import Layouts
from estimator.layouts.bounds import bounds, percentile
from estimator.layouts.mixed_rows import candidate_ends_mm, mixed_rows
from estimator.layouts.near_field import OTHER, OWN, PRESSED, Magnets, Reach, field_of_magnets
from estimator.layouts.placed import chips, other_magnets, own_magnets
from estimator.layouts.press_basis import PressBasis

_CHUNK = 512
_FORCE_VARIANCE, _CURVE_VARIANCE = 1 / 8, 1 / 128
"""Of c and of c² − c, which do not correlate, in a press whose force is c of its peak, a raised cosine."""


@dataclass(frozen=True)
class LayoutScore:
    """Scores over layouts, of presses of one face read by its own sensors.

    Attributes
    ----------
    worst_position_bound_mm, median_position_bound_mm, worst_force_bound_n : Cramér–Rao bounds over
        the contact locations, at the basis's force
    sensitivity_ratio : 5th over 50th percentile of δ (covariance form, white noise) over the places
    largest_counts : largest magnitude of any own channel, at rest and in the deepest presses
    """

    worst_position_bound_mm: Float[Tensor, "layout"]
    median_position_bound_mm: Float[Tensor, "layout"]
    worst_force_bound_n: Float[Tensor, "layout"]
    sensitivity_ratio: Float[Tensor, "layout"]
    largest_counts: Float[Tensor, "layout"]


@dataclass(frozen=True)
class PlaceInformation:
    """Bounds and δ (up to a factor that is the same everywhere) of every contact location; the largest
    magnitude of any own channel in counts, at rest and in the deepest simulated presses.

    These are told by scorers of the largest force among those worked out together, the others tell those at
    rest. The shell without magnets is pressed as deep, by the change with force at the basis's, and the
    pressed face's magnets are where that moves them. The second fidelity level, whose presses reach the same
    depth with more force, had 1.02 to 1.11 times as many (fourteen layouts of the paper's cube) and 1.17
    times (one of a pear, whose presses took a third more force). With boards in the shell, which
    stiffen it more, the chain had 1.57 and 1.72 times as many (two layouts).
    """

    position_bound_mm: Float[Tensor, "layout place"]
    force_bound_n: Float[Tensor, "layout place"]
    sensitivity: Float[Tensor, "layout place"]
    largest_counts: Float[Tensor, "layout"]


@dataclass(frozen=True)
class ChannelChanges:
    """Counts of own channels at rest, and the change of whitened ones with the motion of each body in the
    silicone, whatever is pressed how hard: `by_own` and, of the faces that move, `by_other` magnets;
    boards change their own channels alone. Besides, where the chips are, their axes and the other faces'
    field (T) there."""

    resting_counts: Float[Tensor, "layout sensor 3"]
    by_own: Float[Tensor, "layout channel motion"]
    by_other: Float[Tensor, "layout channel motion_of_others"]
    sensor_mm: Float[Tensor, "3 layout sensor"]
    axes: Float[Tensor, "layout sensor 3 3"]
    others_t: Float[Tensor, "3 layout sensor"]


@dataclass(frozen=True)
class PressChanges:
    """Whitened derivatives of own channels by x, y and force, and their change in the press itself; of what
    moves with the silicone, which of a face's bodies (None: all), and how they move with the presses
    of their size."""

    by_parameter: Float[Tensor, "channel layout 4 place"]
    channels: ChannelChanges
    motions: tuple[
        tuple[tuple[int, ...] | None, PressBasis, Float[Tensor, "layout body 6 rank"]], ...
    ]

    @property
    def resting_counts(self) -> Float[Tensor, "layout sensor 3"]:
        return self.channels.resting_counts


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

    def of_each_size(
        self, layouts: Layouts
    ) -> list[tuple[PressBasis, Layouts, tuple[int, ...] | None]]:
        """What moves with the silicone, size by size: its presses, its bodies alone, and which of a face's
        they are; None for all."""
        bodies = moving_bodies(self, layouts)
        if len(self.presses_of) == 1:
            return [(self.presses, bodies, None)]
        return [
            (presses, bodies.magnets(which), which)
            for presses, which in zip(self.presses_of, self.spec.magnets.by_size, strict=True)
        ]


def layout_scorer(
    spec: ObjectSpec,
    presses: PressBasis | Sequence[PressBasis],
    state: NoiseState = "fresh",
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
    sigma = disturbance_counts(spec.sensors, state, 3)
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
        Blocks, coils switched face by face, chips turned one by one, or an axis
        without noise.
    """
    blocks = [m for m in magnet_sources(spec.magnets) if isinstance(m, BlockMagnet)]
    if blocks:
        raise InputError(
            f"layouts are scored in batches with round magnets only; got {blocks[0].description}. Use the "
            "full chain"
        )
    if spec.magnets.switching != "all-on":
        raise InputError(
            'layouts are scored in batches with all magnets on; got magnets.switching = "'
            f'{spec.magnets.switching}". Use the full chain'
        )
    if spec.sensors.rotations_deg is not None:
        raise InputError(
            "layouts are scored in batches with chips turned by the azimuth of their place; got "
            "sensors.rotations_deg. Use the full chain"
        )
    if not all(np.ravel(spec.sensors.noise_counts)):
        raise InputError("δ needs white noise on every axis. Set sensors.noise_counts above 0")


def score_layouts(scorer: LayoutScorer, layouts: Layouts, chunk: int = _CHUNK) -> LayoutScore:
    """Score every layout; differentiable in all four tensors.

    Memory: at most 0.4 MB per layout of a chunk; with gradients of every layout.

    Raises
    ------
    InputError
        A magnet outside the candidates.
    """
    parts = [
        _summary(place_information(scorer, layouts[first : first + chunk]))
        for first in range(0, len(layouts), chunk)
    ]
    return LayoutScore(
        *(torch.cat([getattr(part, f.name) for part in parts]) for f in fields(LayoutScore))
    )


def place_information(scorer: LayoutScorer, layouts: Layouts) -> PlaceInformation:
    """Bounds and δ at every contact location, all layouts at once."""
    return places_information([scorer], [layouts])[0]


def places_information(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
) -> list[PlaceInformation]:
    """The same of several scorers; fields are worked out once where face and batch are the same."""
    seen: dict[tuple[int, int], ChannelChanges] = {}
    largest_n = max(scorer.presses.force_n for scorer in scorers)
    found = []
    for scorer, one in zip(scorers, layouts, strict=True):
        key = scorer.presses.face, id(one)
        if key not in seen:
            seen[key] = _channel_changes(scorer, one)
        changes = _press_changes(scorer, one, seen[key])
        counts = changes.resting_counts.flatten(1).abs().amax(dim=1)
        if scorer.presses.force_n == largest_n:
            counts = torch.maximum(counts, _counts_when_pressed(scorer, one, changes))
        found.append(_information(scorer, changes, counts))
    return found


def _information(
    scorer: LayoutScorer, changes: PressChanges, largest_counts: Float[Tensor, "layout"]
) -> PlaceInformation:
    by_parameter = changes.by_parameter
    position, force = bounds(by_parameter[:, :, :3])
    return PlaceInformation(position, force, _sensitivity(scorer, by_parameter), largest_counts)


def _sensitivity(
    scorer: LayoutScorer, by_parameter: Float[Tensor, "channel layout 4 place"]
) -> Float[Tensor, "layout place"]:
    """√det of the channels' covariance in a press, in units of white noise, signals taken as parabolas over
    force: their change in the press and their slope at its peak."""
    white = scorer.white_share.repeat(len(by_parameter) // 3)[:, None, None]
    at_peak = by_parameter[:, :, 3] * white
    curve = by_parameter[:, :, 2] * white * scorer.presses.force_n - at_peak
    straight, both, bent = (
        (one * other).sum(0)
        for one, other in ((at_peak, at_peak), (at_peak, curve), (curve, curve))
    )
    along = 1 + _FORCE_VARIANCE * straight
    across = 1 + _CURVE_VARIANCE * torch.relu(bent - _FORCE_VARIANCE * both.square() / along)
    return (along * across).sqrt()


def _counts_when_pressed(
    scorer: LayoutScorer, layouts: Layouts, changes: PressChanges
) -> Float[Tensor, "layout"]:
    """Largest of any channel, each sensor's in the deepest press at the place where signals that are linear
    in the motions have most."""
    _, _, by_force, in_press = changes.by_parameter.unbind(2)
    sigma = scorer.sigma_counts.repeat(len(by_force) // 3)[:, None, None]
    resting = changes.resting_counts.flatten(1).T[..., None]
    linear = resting + sigma * (in_press + by_force * _beyond_n(scorer))
    place = linear.abs().unflatten(0, (-1, 3)).amax(dim=1).argmax(dim=-1).T
    counts = _counts_of_pressed_boards if scorer.sensors_move else _counts_of_pressed_magnets
    return counts(scorer, layouts, changes, place).abs().amax(dim=1)


def _counts_of_pressed_magnets(
    scorer: LayoutScorer,
    layouts: Layouts,
    changes: PressChanges,
    place: Int[Tensor, "layout sensor"],
) -> Float[Tensor, "layout channel"]:
    """Of every sensor, the pressed face's magnets where its own press has moved them: their fields grow
    faster than their motions."""
    channels, sensors = changes.channels, place.shape[1]
    motion = layouts.magnet_mm.new_zeros(*place.shape, layouts.magnet_mm.shape[1], 6)
    for which, presses, rows in changes.motions:
        moved = torch.einsum("lmkr,rls->lsmk", rows, _deepest(scorer, presses)[:, place])
        motion[:, :, slice(None) if which is None else list(which)] = moved
    centre, axis = (part[:, :, None] for part in own_magnets(scorer.presses, layouts))
    shift, turn = motion.permute(3, 0, 1, 2).split(3)
    turned = axis + torch.linalg.cross(turn, axis.expand_as(turn), dim=0)
    magnets = (centre + shift).flatten(1, 2), (turned / turned.norm(dim=0)).flatten(1, 2)
    polarity = layouts.polarity.repeat_interleave(sensors, dim=0)
    own = field_at(scorer, channels.sensor_mm.flatten(1)[..., None], magnets, polarity, PRESSED)
    field = own.field.sum(-1)[..., 0].unflatten(1, place.shape) + channels.others_t
    return _counts(scorer, channels.axes, field)


def _deepest(scorer: LayoutScorer, presses: PressBasis) -> Float[Tensor, "rank place"]:
    """Basis of the pressed face's motions in the deepest presses."""
    table = presses.own.basis.unflatten(1, (4, -1))
    return table[:, 3] + table[:, 2] * _beyond_n(scorer)


def _beyond_n(scorer: LayoutScorer) -> Float[Tensor, "place"]:
    """From the basis's force to that of the deepest press."""
    return scorer.presses.deepest_n - scorer.presses.force_n


def _counts_of_pressed_boards(
    scorer: LayoutScorer,
    layouts: Layouts,
    changes: PressChanges,
    place: Int[Tensor, "layout sensor"],
) -> Float[Tensor, "layout channel"]:
    """Of each board in the deepest press at a place of its own: signals of boards that come near magnets are
    far from linear."""
    ((_, presses, rows),) = changes.motions
    motion = torch.einsum("lskr,rls->lsk", rows, _deepest(scorer, presses)[:, place])
    moved = changes.channels.sensor_mm + motion[..., :3].permute(2, 0, 1)
    own, other = _field_changes(scorer, layouts, moved)
    field = (own.field.sum(-1) + other.field.sum(-1)).permute(1, 2, 0)
    felt = _turned_back(field, motion[..., 3:])
    return _counts(scorer, changes.channels.axes, felt.permute(2, 0, 1))


def _counts(
    scorer: LayoutScorer,
    axes: Float[Tensor, "layout sensor 3 3"],
    field_t: Float[Tensor, "3 layout sensor"],
) -> Float[Tensor, "layout channel"]:
    return scorer.counts_per_t * (axes @ field_t.permute(1, 2, 0)[..., None]).flatten(1)


def press_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_shift_mm: Float[Tensor, "layout sensor 3"] | None = None,
) -> PressChanges:
    """What presses change, with sensors shifted off their places (boards do not turn with it)."""
    return _press_changes(scorer, layouts, _channel_changes(scorer, layouts, sensor_shift_mm))


def _turned_back(
    field: Float[Tensor, "layout sensor 3"], turn_rad: Float[Tensor, "layout sensor 3"]
) -> Float[Tensor, "layout sensor 3"]:
    """As a body feels it that has turned by a rotation vector (Rodrigues)."""
    angle = (turn_rad.square().sum(-1, keepdim=True) + 1e-14).sqrt()
    once = torch.linalg.cross(turn_rad, field, dim=-1)
    twice = torch.linalg.cross(turn_rad, once, dim=-1)
    return field - angle.sin() / angle * once + (1 - angle.cos()) / angle**2 * twice


def _channel_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_shift_mm: Float[Tensor, "layout sensor 3"] | None = None,
) -> ChannelChanges:
    sensor, axes = chips(scorer.presses, layouts, scorer.sensor_depth_mm, scorer.chip)
    if sensor_shift_mm is not None:
        sensor = sensor + sensor_shift_mm.permute(2, 0, 1)
    own, other = _field_changes(scorer, layouts, sensor)
    others_t = other.field.sum(-1)
    counts = _counts(scorer, axes, own.field.sum(-1) + others_t).unflatten(1, (-1, 3))
    there = sensor, axes, others_t
    whitened = axes * (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    if scorer.sensors_move:
        by_own = _each_its_own(whitened @ by_motion_of_sensors(own, other))
        return ChannelChanges(counts, by_own, by_own[..., :0], *there)
    moving = _of_moving_faces(
        other.by_motion, layouts.magnet_mm.shape[1], len(scorer.presses.neighbours)
    )
    return ChannelChanges(
        counts, _by_channel(whitened, own.by_motion), _by_channel(whitened, moving), *there
    )


def _press_changes(
    scorer: LayoutScorer, layouts: Layouts, channels: ChannelChanges
) -> PressChanges:
    moving, motions = [], []
    for presses, bodies, which in scorer.of_each_size(layouts):
        rows, tables = mixed_rows(presses, bodies), (presses.own, presses.other)
        count = bodies.magnet_mm.shape[1]
        motions.append((which, presses, rows[0].reshape(len(layouts), count, 6, -1)))
        some = (_of_bodies(each, which, layouts) for each in (channels.by_own, channels.by_other))
        moving += [
            (by_channel @ row.reshape(len(layouts), by_channel.shape[2], -1), table.basis)
            for by_channel, row, table in zip(some, rows, tables, strict=True)
            if by_channel.numel()
        ]
    mixed, basis = torch.cat([m for m, _ in moving], dim=-1), torch.cat([b for _, b in moving])
    change = mixed.transpose(0, 1).reshape(-1, len(basis)) @ basis
    by_parameter = change.reshape(mixed.shape[1], len(layouts), 4, -1)
    return PressChanges(by_parameter, channels, tuple(motions))


def within_candidates(scorer: LayoutScorer, layouts: Layouts) -> Layouts:
    """Magnets, or boards in the silicone, beyond the candidates at the nearest of their places."""

    def nearest(one: Layouts, face: int | None) -> Layouts:
        first, last = _ends_of_bodies_mm(scorer, face)
        if scorer.sensors_move:
            xy = torch.maximum(torch.minimum(one.sensor_mm, last[..., :2]), first[..., :2])
            return replace(one, sensor_mm=xy)
        return replace(one, magnet_mm=torch.maximum(torch.minimum(one.magnet_mm, last), first))

    return layouts.each(nearest)


def _ends_of_bodies_mm(scorer: LayoutScorer, face: int | None) -> tuple[Tensor, Tensor]:
    """Least and greatest (x, y, depth) of candidates; (body, 3) where bodies have several sizes."""
    ends = [candidate_ends_mm(presses, face) for presses in scorer.presses_of]
    if len(ends) == 1:
        return ends[0]
    numbers = list(scorer.spec.magnets.size_numbers)
    first, last = (torch.stack(parts)[numbers] for parts in zip(*ends, strict=True))
    return first, last


def _of_bodies(
    by_channel: Float[Tensor, "layout channel motion"],
    which: tuple[int, ...] | None,
    layouts: Layouts,
) -> Float[Tensor, "layout channel some_motion"]:
    """Columns of some magnets' motions, on all faces."""
    if which is None or not by_channel.numel():
        return by_channel
    count = layouts.magnet_mm.shape[1]
    return by_channel.unflatten(-1, (count, -1))[..., list(which), :].flatten(-2)


def moving_bodies(scorer: LayoutScorer, layouts: Layouts) -> Layouts:
    """What moves with the silicone, as magnets of layouts: these, or boards that lie flat."""
    if not scorer.sensors_move:
        return layouts

    def boards(one: Layouts, _: int | None) -> Layouts:
        depth = torch.full_like(one.sensor_mm[..., :1], scorer.sensor_depth_mm)
        flat, at = torch.zeros_like(one.sensor_mm), torch.cat([one.sensor_mm, depth], dim=-1)
        return replace(one, magnet_mm=at, turn_rad=flat, polarity=torch.ones_like(flat[..., 0]))

    return layouts.each(boards)


def by_motion_of_sensors(*of_magnets: FieldChange) -> Float[Tensor, "layout sensor 3 6"]:
    """Change of the field that sensors feel with their own motions, from that with magnets'.

    A sensor moved one way sees magnets moved the other way; one that turns feels the field turned back.
    """
    field = torch.cat([one.field for one in of_magnets], dim=-1).sum(-1).permute(1, 2, 0)
    shifted = torch.cat([one.by_motion[:, :3] for one in of_magnets], dim=-1)
    shift = -shifted.sum(-1).permute(2, 3, 0, 1)
    about = torch.eye(3, dtype=field.dtype).expand(*field.shape, 3)
    turn = torch.linalg.cross(field[..., None, :].expand_as(about), about, dim=-1)
    return torch.cat([shift, turn.transpose(-1, -2)], dim=-1)


def _each_its_own(
    by_motion: Float[Tensor, "layout sensor 3 6"],
) -> Float[Tensor, "layout channel motion"]:
    layouts, sensors = by_motion.shape[:2]
    own = torch.eye(sensors, dtype=by_motion.dtype)[:, None, :, None]
    return (by_motion[:, :, :, None] * own).reshape(layouts, 3 * sensors, -1)


def _field_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_mm: Float[Tensor, "3 layout sensor"],
) -> tuple[FieldChange, FieldChange]:
    """Fields and their changes at (layout, sensor, magnet) of own and (magnet, face) of others."""
    presses, polarity = scorer.presses, layouts.polarity
    others = other_magnets(presses, layouts)
    faces, flat = others[0].shape[3], (others[0].flatten(2), others[1].flatten(2))
    return (
        field_at(scorer, sensor_mm, own_magnets(presses, layouts), polarity, OWN),
        field_at(scorer, sensor_mm, flat, polarity.repeat_interleave(faces, dim=1), OTHER),
    )


def field_at(
    scorer: LayoutScorer,
    sensor_mm: Float[Tensor, "3 layout sensor"],
    magnets: Magnets,
    polarity: Float[Tensor, "layout magnet"],
    reach: Reach,
) -> FieldChange:
    """`field_of_magnets` of the scorer's."""
    which = scorer.spec.magnets.by_size
    return field_of_magnets(scorer.sizes, which, sensor_mm, magnets, polarity, reach)


def _of_moving_faces(
    by_motion: Float[Tensor, "3 6 layout sensor other"], magnets: int, faces: int
) -> Float[Tensor, "3 6 layout sensor moving"]:
    """Without the opposite face, the last one, where there is one."""
    every = by_motion.unflatten(-1, (magnets, by_motion.shape[-1] // magnets))
    return every[..., :faces].flatten(-2)


def _by_channel(
    whitened: Float[Tensor, "layout sensor 3 3"],
    by_motion: Float[Tensor, "3 6 layout sensor magnet"],
) -> Float[Tensor, "layout channel motion"]:
    """Change of whitened channels with motions, (magnet, 6) along the last axis."""
    layouts, sensors = whitened.shape[:2]
    by_field = by_motion.permute(2, 3, 0, 4, 1).reshape(layouts, sensors, 3, -1)
    return (whitened @ by_field).reshape(layouts, 3 * sensors, -1)


def _summary(places: PlaceInformation) -> LayoutScore:
    position = places.position_bound_mm.sort(dim=1).values
    low, middle = (percentile(places.sensitivity.sort(dim=1).values, q) for q in (5.0, 50.0))
    return LayoutScore(
        position[:, -1],
        percentile(position, 50.0),
        places.force_bound_n.amax(dim=1),
        low / middle,
        places.largest_counts,
    )
