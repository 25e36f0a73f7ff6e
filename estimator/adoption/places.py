"""The order of the places pressed, found from the signals alone; the null exchanges places.

Two places are near where the own chips of a face answer alike. Distances along chains of near places
give a map of them (Isomap); what it cannot tell is how that map is turned, stretched or mirrored. An order
of labels, in rows or in a snake of any two numbers, is judged by how well its grid lies on the map.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int
from scipy.sparse.csgraph import shortest_path
from scipy.spatial.distance import cdist

from estimator.adoption.findings import CERTAIN, EXCHANGES, Finding, share_as_high
from estimator.adoption.presses import ForeignPresses

_NEIGHBOURS = 5
"""Nearest places that a place is joined to; more where parts stay apart."""
LEAST_PLACES = 6
"""Places from which a map is drawn: two rows of three."""


@dataclass(frozen=True)
class PlaceOrder:
    """Order of a face's places: numbers as labelled, their grid (row, column), and how well it fits.

    `rank_correlation` (row, column) is Spearman's, between grid and map.
    """

    place: Int[np.ndarray, "place"]
    grid: Int[np.ndarray, "place 2"]
    name: str
    rank_correlation: Float[np.ndarray, "2"]
    null: Float[np.ndarray, "exchange"]

    @property
    def p(self) -> float:
        """Share of exchanges, searched alike, that fit as well."""
        return share_as_high(self.null.tolist(), float(self.rank_correlation.min()))

    def finding(self, face: int) -> Finding:
        """Say what was found."""
        x, y = self.rank_correlation
        return Finding(
            f"order of places, face {face}",
            f"{self.name}; mirror images and turns look alike"
            if self.p <= CERTAIN
            else "cannot be told: no grid beats its null",
            f"rank correlation of grid and signals {x:.2f} (rows), {y:.2f} (columns)",
            f"{np.median(self.null):.2f}",
            self.p,
        )


def order_of_places(presses: ForeignPresses, chips: list[int], face: int) -> PlaceOrder | None:
    """Find the order of a face's places; None where they are too few, or no grid has their number."""
    face_presses = presses.select(np.flatnonzero(presses.face[:, 0] == face))
    place = np.unique(face_presses.place[:, 0])
    shapes = list(_grids(len(place)))
    if len(place) < LEAST_PLACES or not shapes or len(chips) < 2:
        return None
    where = map_of_places(face_presses, chips, place)
    best = max(shapes, key=lambda named: _fit(where, named[1]).min())
    rng = np.random.default_rng((0, 32))
    null = [
        max(_fit(where[order], grid).min() for _, grid in shapes)
        for order in (rng.permutation(len(place)) for _ in range(EXCHANGES))
    ]
    return PlaceOrder(place, best[1], best[0], _fit(where, best[1]), np.array(null))


def map_of_places(
    presses: ForeignPresses, chips: list[int], place: Int[np.ndarray, "place"]
) -> Float[np.ndarray, "place 2"]:
    """Lay places out in a plane by the logarithms of their chips' answers, which fall with distance."""
    size = presses.size[:, chips]
    floor = 0.02 * np.nanmax(size)
    rows = [np.flatnonzero(presses.place[:, 0] == number) for number in place]
    mean = np.array([np.sqrt(np.nanmean(size[r] ** 2, axis=0)) for r in rows])
    mean = np.where(np.isfinite(mean), mean, np.nanmean(mean, axis=0))
    apart = cdist(np.log(mean + floor), np.log(mean + floor))
    chain_lengths = _chained(apart)
    # classical scaling: twice-centred squares of distances are inner products
    centre = np.eye(len(place)) - 1 / len(place)
    value, vector = np.linalg.eigh(-centre @ chain_lengths**2 @ centre / 2)
    return vector[:, -2:] * np.sqrt(np.maximum(value[-2:], 0.0))


def _chained(apart: Float[np.ndarray, "place place"]) -> Float[np.ndarray, "place place"]:
    """Lengths of the shortest chains of near places."""
    rank = apart.argsort(axis=1).argsort(axis=1)
    for count in range(min(_NEIGHBOURS, len(apart) - 1), len(apart)):
        near = np.minimum(rank, rank.T) <= count
        chain_lengths = shortest_path(np.where(near, apart, 0.0), directed=False)
        if np.isfinite(chain_lengths).all():
            return chain_lengths
    return apart


def _grids(count: int) -> Iterator[tuple[str, Int[np.ndarray, "place 2"]]]:
    """Yield orders of this number of places: in rows and in a snake, of all shapes of two or more rows."""
    for rows in range(2, count // 2 + 1):
        if count % rows:
            continue
        columns = count // rows
        number = np.arange(count)
        grid = np.column_stack([number // columns, number % columns])
        yield f"{rows} rows of {columns}", grid
        snake = grid.copy()
        odd = grid[:, 0] % 2 == 1
        snake[odd, 1] = columns - 1 - grid[odd, 1]
        yield f"a snake, {rows} rows of {columns}", snake


def _fit(where: Float[np.ndarray, "place 2"], grid: np.ndarray) -> Float[np.ndarray, "2"]:
    """Spearman's rank correlation of the grid with the map turned and stretched onto it."""
    terms = np.column_stack([np.ones(len(where)), where])
    laid = terms @ np.linalg.lstsq(terms, grid, rcond=None)[0]
    # every row has as many places, so that mean ranks of the grid are its numbers, but for a scale
    rank = laid.argsort(axis=0).argsort(axis=0)
    rank, number = rank - rank.mean(axis=0), grid - grid.mean(axis=0)
    return np.sum(rank * number, axis=0) / np.sqrt(
        np.sum(rank**2, axis=0) * np.sum(number**2, axis=0)
    )
