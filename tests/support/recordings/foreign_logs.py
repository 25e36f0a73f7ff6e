"""Logs of objects that others built, made with magpylib: any faces, places, chips and arrangement."""

from dataclasses import dataclass, replace

import magpylib
import numpy as np
from scipy.spatial.transform import Rotation

NORMALS = np.array([[0, 0, 1], [0, -1, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, 0, -1.0]])
ACROSS = np.array([[1, 0, 0], [0, 0, -1], [0, 0, -1], [0, 0, -1], [0, 0, -1], [0, 1.0, 0]])
"""Outward normal and x of faces 1 to 6; y = normal × x."""


@dataclass(frozen=True)
class ForeignObject:
    """A cube of `faces` faces: chips on a ring and magnets at points of every face.

    `reverse` has the chips in the shell, 5.5 mm above the magnets in the core.
    """

    faces: int = 5
    chips: int = 3
    ring_mm: float = 14.0
    magnets_mm: tuple = ((0.0, 0.0),)
    magnet_size_mm: tuple = (24.0, 3.0)
    reverse: bool = True
    core_mm: float = 25.0
    gap_mm: float = 5.5
    spread_mm: float = 9.0
    counts_per_mt: float = 246.0
    azimuth_deg: float = 21.6

    @property
    def frames(self):
        """(face, 3, 3): x, y and normal of every face as rows."""
        n, x = NORMALS[: self.faces], ACROSS[: self.faces]
        return np.stack([x, np.cross(n, x), n], axis=1)

    def placed(self, xy, height):
        """Points (face, point, 3) at places of every face, `height` above the core's face."""
        local = np.column_stack([xy, np.full(len(xy), self.core_mm + height)])
        return np.einsum("pk,fkj->fpj", local, self.frames)

    @property
    def chip_xy(self):
        """Places of a face's chips."""
        azimuth = np.deg2rad(self.azimuth_deg) + 2 * np.pi * np.arange(self.chips) / self.chips
        return self.ring_mm * np.column_stack([np.cos(azimuth), np.sin(azimuth)])

    def bulge(self, xy, place, depth):
        """Motion (point, 6) of the shell's points under a press, in the face's frame: mm and rad."""
        offset = xy - np.asarray(place)
        bell = 0.5 * depth * np.exp(-np.sum(offset**2, axis=1) / (2 * self.spread_mm**2))
        slope = bell[:, None] * offset / self.spread_mm**2
        aside = 0.3 * self.spread_mm * slope
        zero = np.zeros(len(xy))
        return np.column_stack([aside, -bell, slope[:, 1], -slope[:, 0], zero])

    def counts(self, presses):
        """Counts (press, face · chip, 3) of presses (face, x, y, depth); face 0 presses nothing."""
        magnets = np.asarray(self.magnets_mm)
        moving = self.chip_xy if self.reverse else magnets
        steps = np.zeros((len(presses), self.faces, len(moving), 6))
        for row, (face, x, y, depth) in enumerate(presses):
            if face > 0:
                frame = self.frames[face - 1]
                local = self.bulge(moving, (x, y), depth)
                turned = np.hstack([local[:, :3] @ frame, local[:, 3:] @ frame])
                steps[row, face - 1] = turned
        steps = steps.reshape(len(presses), -1, 6)
        at = self.placed(magnets, 0.0 if self.reverse else self.gap_mm).reshape(-1, 3)
        seen = self.placed(self.chip_xy, self.gap_mm if self.reverse else 0.0).reshape(-1, 3)
        field = np.zeros((len(presses), len(seen), 3))
        face_of = np.repeat(np.arange(self.faces), len(magnets))
        still = np.zeros((len(presses), len(seen), 6))
        moved = steps if self.reverse else np.zeros((len(presses), len(at), 6))
        chips = seen + (moved[:, :, :3] if self.reverse else still[:, :, :3])
        for m, (centre, face) in enumerate(zip(at, face_of, strict=True)):
            shift = np.zeros((len(presses), 6)) if self.reverse else steps[:, m]
            stand = Rotation.from_matrix(self.frames[face].T)
            turn = Rotation.from_rotvec(shift[:, 3:]) * stand
            offset = chips - (centre + shift[:, :3])[:, None]
            inside = np.stack([t.inv().apply(o) for t, o in zip(turn, offset, strict=True)])
            d, h = self.magnet_size_mm
            part = magpylib.magnet.Cylinder(
                polarization=(0, 0, 1.3), dimension=(1e-3 * d, 1e-3 * h)
            ).getB(1e-3 * inside.reshape(-1, 3))
            part = part.reshape(inside.shape)
            field += np.stack([t.apply(b) for t, b in zip(turn, part, strict=True)])
        if self.reverse:
            turned = [
                Rotation.from_rotvec(-s[:, 3:]).apply(b) for s, b in zip(steps, field, strict=True)
            ]
            field = np.stack(turned)
        return 1e3 * self.counts_per_mt * np.einsum("psj,sij->psi", field, self.chip_axes)

    @property
    def chip_axes(self):
        """Axes (chip, 3, 3) of all chips: against the tangent, outwards along the ring, outwards."""
        out = self.chip_xy / self.ring_mm
        local = np.zeros((self.chips, 3, 3))
        local[:, 0, :2] = np.column_stack([out[:, 1], -out[:, 0]])
        local[:, 1, :2] = out
        local[:, 2, 2] = 1.0
        return np.einsum("cik,fkj->fcij", local, self.frames).reshape(-1, 3, 3)


@dataclass(frozen=True)
class Log:
    """Rows of a log: labels (face, place, level) and counts (row, chip, 3)."""

    labels: np.ndarray
    counts: np.ndarray

    def columns(self, order=None):
        """Return all columns, chips in another order."""
        chips = self.counts if order is None else self.counts[:, list(order)]
        return np.hstack([self.labels, chips.reshape(len(chips), -1)])

    def with_counts(self, counts):
        """Return the same labels beside other counts."""
        return replace(self, counts=counts)


def grid(shape, pitch):
    """Places in rows: x outer, y inner, about the middle."""
    axes = [(np.arange(n) - (n - 1) / 2) * p for n, p in zip(shape, pitch, strict=True)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)


def make_log(
    thing,
    faces=(1,),
    shape=(5, 5),
    pitch=(7.8, 9.6),
    levels=5,
    rows=8,
    noise=7.0,
    touch=-1.0,
    seed=0,
):
    """A log of presses to rising levels, 1 mm apart, at every place of some faces; rest at the end."""
    places = grid(shape, pitch)
    labels = [(f, p + 1, v + 1) for f in faces for p in range(len(places)) for v in range(levels)]
    presses = [(f, *places[p - 1], v - touch) for f, p, v in labels]
    labels, presses = [*labels, (0, 0, 0)], [*presses, (0, 0, 0, 0)]
    levels_counts = thing.counts(presses)
    repeats = np.full(len(labels), rows)
    repeats[-1] = 10 * rows
    rng = np.random.default_rng(seed)
    counts = np.repeat(levels_counts, repeats, axis=0)
    counts = np.round(counts + noise * rng.standard_normal(counts.shape))
    return Log(np.repeat(np.array(labels, float), repeats, axis=0), counts)
