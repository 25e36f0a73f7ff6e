"""Nested dissection of a symmetric sparse matrix: a tree of separators, from its graph alone.

A part of the graph is split where differences of distances from far vertices are near their median:
fronts of two such distances meet in a surface that is nearly plane. Of the edges across, the
separator is the smallest set of vertices that covers them all (König's theorem, by a maximum
matching). Unknowns with like columns, such as the components of one node, are one vertex.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from scipy.sparse import csgraph

from fem.linear.sparse import shape_of

LEAF_UNKNOWNS = 700
"""Unknowns up to which a part is not split further."""
LARGE_GRAPH = 6000
"""Unknowns from which more splits are tried: there a good one is worth most."""


@dataclass(frozen=True)
class Dissection:
    """Order of elimination: unknowns of node k are `order[start[k]:start[k + 1]]`, children first.

    `parent[k]` is the node's parent, the number of nodes at a root.
    """

    order: Int[np.ndarray, "n"]
    start: Int[np.ndarray, "ends"]
    parent: Int[np.ndarray, "node"]


def dissect(
    matrix: sp.csr_matrix, late: Bool[np.ndarray, "n"], kept: Bool[np.ndarray, "n"]
) -> Dissection:
    """Dissection of the unknowns that are not `kept`.

    A `late` unknown stands in the lowest node below which all its other neighbours are eliminated,
    and there behind the early ones.
    """
    early = np.flatnonzero(~late & ~kept)
    group, graph = _vertices(matrix, early)
    nodes, parents = _tree(graph, np.bincount(group).astype(float))
    owner = np.full(len(late), -1)
    of_group = np.empty(shape_of(graph)[0], int)
    for number, vertices in enumerate(nodes):
        of_group[vertices] = number
    owner[early] = of_group[group]
    parent = np.array(parents)
    owner_of_early, waiting = owner.copy(), np.flatnonzero(late & ~kept)
    rows, first = matrix[waiting], first_descendants(parent)
    for number, begin, end in zip(waiting, rows.indptr[:-1], rows.indptr[1:], strict=True):
        neighbours = owner_of_early[rows.indices[begin:end]]
        neighbours = neighbours[neighbours >= 0]
        node = int(neighbours.max()) if len(neighbours) else len(parent) - 1
        while (neighbours < first[node]).any():
            node = parent[node]
        owner[number] = node
    ordered = np.flatnonzero(~kept)
    ordered = ordered[np.lexsort((late[ordered], owner[ordered]))]
    return Dissection(ordered, np.searchsorted(owner[ordered], np.arange(len(parent) + 1)), parent)


def first_descendants(parent: Int[np.ndarray, "node"]) -> Int[np.ndarray, "node"]:
    """Lowest number in the subtree of each node; children come before their parent."""
    first = np.arange(len(parent))
    for node, above in enumerate(parent):
        if above < len(parent):
            first[above] = min(first[above], first[node])
    return first


def _vertices(
    matrix: sp.csr_matrix, unknowns: Int[np.ndarray, "early"]
) -> tuple[Int[np.ndarray, "early"], sp.csr_matrix]:
    """The vertex of every unknown, and the graph of the vertices."""
    near = sp.csr_matrix(matrix[unknowns][:, unknowns])
    pattern = sp.csr_matrix((np.ones(near.nnz), near.indices, near.indptr), shape=near.shape)
    pattern = sp.csr_matrix(pattern + sp.identity(len(unknowns)) > 0, dtype=float)
    pattern.sort_indices()
    sums = pattern @ np.random.default_rng(1).random(len(unknowns))  # alike where columns are
    _, first, group = np.unique(sums, return_index=True, return_inverse=True)
    member = sp.csr_matrix((np.ones(len(group)), (np.arange(len(group)), group)))
    graph = sp.csr_matrix(pattern[first] @ member > 0, dtype=float)
    graph.setdiag(0)
    graph.eliminate_zeros()
    return group, graph


def _tree(
    graph: sp.csr_matrix, weight: Float[np.ndarray, "vertex"]
) -> tuple[list[np.ndarray], list[int]]:
    """Vertices and parent of every node, children first."""
    nodes: list[np.ndarray] = []
    parents: list[int] = []

    def add(vertices: np.ndarray, children: tuple[int, ...]) -> int:
        nodes.append(vertices)
        parents.append(-1)
        for child in children:
            parents[child] = len(nodes) - 1
        return len(nodes) - 1

    def split(vertices: np.ndarray, inside: sp.csr_matrix) -> int:
        halves = None
        if weight[vertices].sum() > LEAF_UNKNOWNS:
            halves = _halves(inside, weight[vertices])
        if halves is None:
            return add(vertices, ())
        separator, first_side = halves
        sides = [np.flatnonzero(side) for side in (first_side, ~first_side & ~separator)]
        children = [split(vertices[side], inside[side][:, side]) for side in sides]
        return add(vertices[separator], tuple(children))

    split(np.arange(len(weight)), graph)
    return nodes, [len(nodes) if parent < 0 else parent for parent in parents]


def _halves(
    graph: sp.csr_matrix, weight: Float[np.ndarray, "vertex"]
) -> tuple[Bool[np.ndarray, "vertex"], Bool[np.ndarray, "vertex"]] | None:
    """Separator and left side; None where no split leaves a quarter on both sides."""
    total, best = weight.sum(), None
    pieces, piece = csgraph.connected_components(graph, directed=False)
    if pieces > 1:  # about half of the weight on each side, whole pieces
        upto = np.cumsum(np.bincount(piece, weight))
        half = upto < max(0.5 * total, upto[0] + 0.5)
        return np.zeros(len(weight), bool), half[piece]
    large = total > LARGE_GRAPH
    rows = np.repeat(np.arange(len(weight)), np.diff(graph.indptr))
    for level in _levels(graph, 3 if large else 1):
        order = np.argsort(level, kind="stable")
        upto = np.cumsum(weight[order])
        shares = np.linspace(0.4, 0.6, 5 if large else 3) * total
        for limit in np.unique(level[order[np.searchsorted(upto, shares)]]):
            lower_side = level <= limit
            separator = vertex_cover(rows, graph.indices, lower_side)
            width = weight[separator].sum()
            smaller = min(
                weight[lower_side & ~separator].sum(), weight[~lower_side & ~separator].sum()
            )
            cost = width * (1 + 0.5 * (total - width - 2 * smaller) / total)
            if smaller > 0.25 * total and (best is None or cost < best[0]):
                best = cost, separator, lower_side & ~separator
    return None if best is None else best[1:]


def _levels(graph: sp.csr_matrix, pairs: int) -> list[Float[np.ndarray, "vertex"]]:
    """Functions on the vertices of a connected graph whose level sets separate well, two for each of
    some pairs of far vertices."""
    nearest, levels = np.inf, []
    begin = int(np.argmax(csgraph.dijkstra(graph, indices=0, unweighted=True)))
    for _ in range(pairs):
        pair = []
        for _ in range(2):
            pair.append(csgraph.dijkstra(graph, indices=begin, unweighted=True))
            nearest = np.minimum(nearest, pair[-1])
            begin = int(np.argmax(pair[-1]))
        begin = int(np.argmax(nearest))
        levels.append((pair[0] - pair[1], pair[0] ** 2 - pair[1] ** 2))
    return [level for forms in zip(*levels, strict=True) for level in forms]


def vertex_cover(
    rows: Int[np.ndarray, "edge"],
    columns: Int[np.ndarray, "edge"],
    from_side: Bool[np.ndarray, "vertex"],
) -> Bool[np.ndarray, "vertex"]:
    """Smallest set of vertices that covers all edges from left to right."""
    across = from_side[rows] & ~from_side[columns]
    from_vertices, row = np.unique(rows[across], return_inverse=True)
    to_vertices, column = np.unique(columns[across], return_inverse=True)
    edges = sp.csr_matrix(
        (np.ones(len(row)), (row, column)), shape=(len(from_vertices), len(to_vertices))
    )
    match = csgraph.maximum_bipartite_matching(edges, perm_type="column")
    partner = np.full(len(to_vertices), -1)
    partner[match[match >= 0]] = np.flatnonzero(match >= 0)
    reached, beyond = match < 0, np.zeros(len(to_vertices), bool)
    newly, back = reached, sp.csr_matrix(edges.T)
    while newly.any():  # along paths of edges outside and inside the matching, in turn
        beyond |= np.asarray(back @ newly.astype(float)) > 0
        newly_matched = np.zeros(len(from_vertices), bool)
        newly_matched[partner[beyond & (partner >= 0)]] = True
        newly = newly_matched & ~reached
        reached = reached | newly
    cover = np.zeros(len(from_side), bool)
    cover[from_vertices[~reached]] = True
    cover[to_vertices[beyond]] = True
    return cover
