"""The network that reads the contacts on one face from changes of Hall counts.

It takes raw changes against rest (counts) and gives a `Reading` in N and mm: scaling and units are
part of it, so that what is trained, saved, exported and used is one and the same.

`HeadsNetwork` is a compact trunk on arcsinh(ΔS / 3σ) and ΔS / 30σ, σ the white noise of each
channel (small changes stay visible in the one, contacts add up in the other), with heads for the
share of force at each pixel (softmax), the total force, contact or none, the centre of force in
mm, and how far force and centre are likely to be off. Scaling by the noise keeps weak and strong
presses alike in range, which mattered more than width in comparisons.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from estimator.networks.forest import Forest
from estimator.networks.intervals.coverage import Coverage, gp_weight, growth
from estimator.networks.process import Process

SIGMA_SPAN = 3.0
"""Signal, in standard deviations, up to which an input grows in proportion (asinh)."""
LINEAR_SIGMA_SPAN = 30.0
"""Standard deviations that the linear inputs are divided by."""
DOUBT_POWER = 2
"""Forces are multiplied by P(contact)², so that doubtful contacts stay visible but faint."""
GATHER_MM = 9.0
"""Within this distance force is gathered on the likeliest pixels; tips that stand further apart
keep their shares. On 15 200 frames of a coarse paper's cube, against sharpening all shares of a
face alike: E_f of one tip 7.1 instead of 7.5 %, of two 8.5 instead of 13.0, of three 6.1 instead of
10.1; A_sim 0.951 instead of 0.925. Between 6 and 12 mm the choice hardly matters."""
SPLAT_PITCHES = 0.3
"""Standard deviation, in pitches of the grid, of the spot that a continuous position draws."""
_LEAST_SPREAD = 1e-3
"""Least standard deviation of an output: the likelihood stays finite."""
_LEAST_WEIGHT = 1e-12
"""Added to every weight, so that their sum is never 0."""
_LEAST_FORCE_N = 1e-6
"""Force that stands for 0 where it divides."""


class Reading(NamedTuple):
    """Reading of each frame by an estimator.

    Attributes
    ----------
    heatmap_n : (frame, axis, nx, ny) N; axes are the normal, or with three axes x, y and normal
    force_n : (frame,) total normal force, N
    xy_mm : (frame, 2) centre of the normal force in the face's frame, mm
    contact : (frame,) probability of a contact
    force_halfwidth_n : (frame,) the interval is `force_n` ± this; NaN before calibration
    position_radius_mm : (frame,) the true centre lies within this radius of `xy_mm`; likewise
    novelty : (frame,) distance from what training covers; above 1 the frame is novel
        (`estimator.networks.intervals.coverage`). Of single members 0
    """

    heatmap_n: Float[Tensor, "frame axis nx ny"]
    force_n: Float[Tensor, "frame"]
    xy_mm: Float[Tensor, "frame 2"]
    contact: Float[Tensor, "frame"]
    force_halfwidth_n: Float[Tensor, "frame"]
    position_radius_mm: Float[Tensor, "frame"]
    novelty: Float[Tensor, "frame"]


class Heads(NamedTuple):
    """Outputs of `HeadsNetwork` for training: forces in units of the scale, spreads likewise and
    in mm (mean absolute deviations)."""

    share_logits: Float[Tensor, "frame pixel"]
    force: Float[Tensor, "frame axis"]
    contact_logit: Float[Tensor, "frame"]
    xy_mm: Float[Tensor, "frame 2"]
    force_spread: Float[Tensor, "frame"]
    position_spread_mm: Float[Tensor, "frame"]


class HeadsNetwork(nn.Module):
    """Trunk and heads on noise-scaled inputs.

    Parameters
    ----------
    continuous : shares are a spot around the centre of force, for presses with one contact at
        places that training need not have seen; otherwise a softmax over pixels
    """

    sigma_counts: Tensor
    grid_mm: Tensor
    pitch_mm: Tensor
    force_scale_n: Tensor
    sharpness: Tensor
    faint: Tensor
    near: Tensor

    def __init__(
        self,
        sigma_counts: Float[np.ndarray, "channel"],
        grid_x_mm: Float[np.ndarray, "nx"],
        grid_y_mm: Float[np.ndarray, "ny"],
        hidden_units: Sequence[int],
        force_scale_n: float,
        axes: int = 1,
        continuous: bool = False,
    ) -> None:
        super().__init__()
        self.axes, self.continuous = axes, continuous
        self.shape = (len(grid_x_mm), len(grid_y_mm))
        self.pixels = len(grid_x_mm) * len(grid_y_mm)
        self.trunk = _trunk([2 * len(sigma_counts), *hidden_units])
        self.heads = nn.Linear(hidden_units[-1], self.pixels + axes + 5)
        _buffer(self, "sigma_counts", sigma_counts)
        _buffer(self, "grid_mm", _pixel_centres_mm(grid_x_mm, grid_y_mm))
        _buffer(self, "pitch_mm", np.array([_pitch_mm(grid_x_mm), _pitch_mm(grid_y_mm)]))
        _buffer(self, "force_scale_n", force_scale_n)
        _buffer(self, "sharpness", 1.0)
        _buffer(self, "faint", 0.2)
        centres = self.grid_mm.double()
        near = (torch.cdist(centres, centres) <= GATHER_MM + 1e-6).float()
        self.register_buffer("near", near, persistent=False)

    def heads_of(self, counts: Float[Tensor, "frame channel"]) -> Heads:
        """Training's view."""
        sigmas = counts / self.sigma_counts
        scaled = [torch.asinh(sigmas / SIGMA_SPAN), sigmas / LINEAR_SIGMA_SPAN]
        output = self.heads(self.trunk(torch.cat(scaled, dim=1)))
        sizes = (self.pixels, self.axes - 1, 1, 1, 2, 2)
        logits, tangential, normal, contact, xy, spread = output.split(sizes, dim=1)
        force = torch.cat([tangential, nn.functional.softplus(normal)], dim=1)
        xy_mm = xy * self.grid_mm.abs().amax(dim=0).clamp(min=1.0)
        spread = nn.functional.softplus(spread) + _LEAST_SPREAD
        if self.continuous:
            logits = -self._distance2_in_pitches(xy_mm) / (2 * SPLAT_PITCHES**2)
        return Heads(logits, force, contact[:, 0], xy_mm, 0.1 * spread[:, 0], spread[:, 1])

    def _distance2_in_pitches(self, xy_mm: Tensor) -> Tensor:
        away = (self.grid_mm - xy_mm[:, None]) / self.pitch_mm
        return (away**2).sum(dim=2)

    def gathered(self, share: Tensor, logits: Tensor) -> Tensor:
        """Every pixel's share dealt out among the pixels near it, by their softmax at `sharpness`.

        Training leaves the mean of what may be there. This goes from a mean over neighbouring
        places towards the likeliest of them, and leaves the shares of distant tips alone. Below
        `faint` times the largest a share is taken for a mere chance and goes; from twice that it
        stays whole.
        """
        weight = torch.softmax(self.sharpness * logits, dim=1) + _LEAST_WEIGHT
        gathered = weight * ((share / (weight @ self.near)) @ self.near)
        ratio = gathered / gathered.amax(dim=1, keepdim=True)
        kept = gathered * (ratio / self.faint - 1).clamp(0.0, 1.0)
        return kept / kept.sum(dim=1, keepdim=True)

    def forward(self, counts: Float[Tensor, "frame channel"]) -> Reading:
        heads = self.heads_of(counts)
        share = torch.softmax(heads.share_logits, dim=1)
        if not self.continuous:
            share = self.gathered(share, heads.share_logits)
        contact = torch.sigmoid(heads.contact_logit)
        force_n = self.force_scale_n * heads.force * (contact**DOUBT_POWER)[:, None]
        heatmap = (force_n[:, :, None] * share[:, None]).unflatten(2, self.shape)
        halfwidth = self.force_scale_n * heads.force_spread
        radius, none = heads.position_spread_mm, torch.zeros_like(contact)
        return Reading(heatmap, force_n[:, -1], heads.xy_mm, contact, halfwidth, radius, none)


class ContactEstimator(nn.Module):
    """Networks, averaged, with trees and a process where there are any, with calibrated
    intervals.

    The total force comes from the networks and from the trees, whose share is `force_share`; the
    centre is weighed by `place_shares` from the networks' own, their heatmap's, and the
    trees'. Where a frame is novel, force and centre are those of the process. The members' spreads
    times `force_quantile` and `position_quantile` (`estimator.networks.intervals.conformal`) and
    what novelty adds (`estimator.networks.intervals.coverage`) are the intervals' half-widths.
    """

    force_quantile: Tensor
    position_quantile: Tensor
    force_share: Tensor
    place_shares: Tensor

    def __init__(
        self,
        members: Sequence[nn.Module],
        coverage: Coverage,
        forest: Forest | None = None,
        process: Process | None = None,
    ) -> None:
        super().__init__()
        self.members = nn.ModuleList(members)
        self.coverage, self.forest, self.process = coverage, forest, process
        for name in ("force_quantile", "position_quantile"):
            _buffer(self, name, float("nan"))
        _buffer(self, "force_share", 0.0)
        _buffer(self, "place_shares", np.array([1.0, 0.0, 0.0]))

    def forward(self, counts: Float[Tensor, "frame channel"]) -> Reading:
        readings = [member(counts) for member in self.members]
        columns = zip(*readings, strict=True)
        mean = Reading(*(torch.stack(column).mean(dim=0) for column in columns))
        places = [mean.xy_mm, self._centre_of(mean.heatmap_n[:, -1])]
        if self.forest is not None:
            force_n, xy_mm = self.forest(counts)
            trusted_n = force_n * mean.contact**DOUBT_POWER
            mean = with_force(mean, torch.lerp(mean.force_n, trusted_n, self.force_share))
            places.append(xy_mm)
        xy = sum(
            (share * place for share, place in zip(self.place_shares, places, strict=False)),
            torch.zeros_like(mean.xy_mm),
        )
        novelty = self.coverage(counts)
        if self.process is None:
            new, grown = torch.zeros_like(novelty), growth(novelty)
        else:
            new = grown = gp_weight(novelty)
            force_n, xy_mm = self.process(counts)
            mean = with_force(mean, torch.lerp(mean.force_n, force_n, new))
            xy = torch.lerp(xy, xy_mm, new[:, None])
        radius = (1 - new) * mean.position_radius_mm * self.position_quantile
        return mean._replace(
            xy_mm=xy,
            force_halfwidth_n=(1 - new) * mean.force_halfwidth_n * self.force_quantile
            + self.coverage.force_slope_n * grown,
            position_radius_mm=torch.minimum(
                radius + self.coverage.place_slope_mm * grown, self.furthest_mm(xy)
            ),
            novelty=novelty,
        )

    def furthest_mm(self, xy_mm: Float[Tensor, "frame 2"]) -> Float[Tensor, "frame"]:
        """Distance to the corner of the contact grid that is furthest away."""
        grid_mm = self.members[0].get_buffer("grid_mm")
        away = torch.maximum(xy_mm - grid_mm.amin(dim=0), grid_mm.amax(dim=0) - xy_mm)
        return (away**2).sum(dim=1).sqrt()

    def _centre_of(self, heatmap_n: Float[Tensor, "frame nx ny"]) -> Float[Tensor, "frame 2"]:
        return heatmap_centre_mm(heatmap_n, self.members[0].get_buffer("grid_mm"))


def with_force(mean: Reading, force_n: Tensor) -> Reading:
    """Heatmaps keep the networks' shares."""
    ratio = (force_n / mean.force_n.clamp(min=_LEAST_FORCE_N))[:, None, None, None]
    heatmap = torch.cat([mean.heatmap_n[:, :-1], mean.heatmap_n[:, -1:] * ratio], dim=1)
    return mean._replace(heatmap_n=heatmap, force_n=force_n)


def heatmap_centre_mm(
    heatmap_n: Float[Tensor, "frame nx ny"], grid_mm: Float[Tensor, "pixel 2"]
) -> Float[Tensor, "frame 2"]:
    """Centre of the positive forces of heatmaps; the grid's origin where they are all but zero."""
    weight = torch.relu(heatmap_n).flatten(1)
    return weight @ grid_mm / weight.sum(dim=1, keepdim=True).clamp(min=_LEAST_FORCE_N)


def _pitch_mm(grid_mm: Float[np.ndarray, "n"]) -> float:
    return float(np.diff(grid_mm).mean()) if len(grid_mm) > 1 else 1.0


def _trunk(widths: Sequence[int]) -> nn.Sequential:
    layers: list[nn.Module] = []
    for wide, narrow in pairwise(widths):
        layers += [nn.Linear(wide, narrow), nn.SiLU()]
    return nn.Sequential(*layers)


def _pixel_centres_mm(
    grid_x_mm: Float[np.ndarray, "nx"], grid_y_mm: Float[np.ndarray, "ny"]
) -> Float[np.ndarray, "pixel 2"]:
    return np.stack(np.meshgrid(grid_x_mm, grid_y_mm, indexing="ij"), axis=-1).reshape(-1, 2)


def _buffer(module: nn.Module, name: str, value: np.ndarray | float) -> None:
    module.register_buffer(name, torch.as_tensor(np.asarray(value, dtype=np.float32)))
