"""Extremely randomised trees that support the networks, as tensors, saved and exported alike.

Geurts, Ernst & Wehenkel, Machine Learning 63 (2006), grown by scikit-learn. On recordings of a few
tens of presses they read force and place as well as networks, and err elsewhere: the mean of both
does better than either.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from estimator.frames.face_data import Channel, FaceData, channel_counts

LEAST_FRAMES_OF_LEAF = 2
MOST_LEVELS = 14
"""Each level of a tree is a step of the exported graph."""


class ForestShape(NamedTuple):
    """Trees that give force and as many that give place; nodes of all of them; their depth."""

    trees: int
    nodes: int
    depth: int


class Forest(nn.Module):
    """Trees for force (the first `trees`) and for place (the others), node after node.

    `split` of a node is the channel, `threshold_counts` its limit, `below` and `above` the nodes
    that follow; leaves follow themselves. `answer` is force (N), 0 or place x, y (mm).
    """

    root: Tensor
    split: Tensor
    threshold_counts: Tensor
    below: Tensor
    above: Tensor
    answer: Tensor

    def __init__(self, shape: ForestShape) -> None:
        super().__init__()
        self.shape = shape
        self.register_buffer("root", torch.zeros(2 * shape.trees, dtype=torch.int64))
        for name in ("split", "below", "above"):
            self.register_buffer(name, torch.zeros(shape.nodes, dtype=torch.int64))
        self.register_buffer("threshold_counts", torch.zeros(shape.nodes))
        self.register_buffer("answer", torch.zeros(shape.nodes, 2))

    def forward(
        self, counts: Float[Tensor, "frame channel"]
    ) -> tuple[Float[Tensor, "frame"], Float[Tensor, "frame 2"]]:
        """Total force (N) and its centre (mm)."""
        node = self.root + torch.zeros_like(counts[:, :1], dtype=torch.int64)
        for _ in range(self.shape.depth):
            value = torch.gather(counts, 1, self.split[node])
            node = torch.where(
                value <= self.threshold_counts[node], self.below[node], self.above[node]
            )
        answer = self.answer[node]
        trees = self.shape.trees
        return answer[:, :trees, 0].mean(dim=1), answer[:, trees:].mean(dim=1)


def fit_forest(data: FaceData, channels: tuple[Channel, ...], trees: int, seed: int) -> Forest:
    """Force from all frames, place from those with contact."""
    from sklearn.ensemble import ExtraTreesRegressor

    counts = channel_counts(data.frames, channels).astype(np.float32)
    touched = data.contact
    targets = (
        (counts, data.heatmap_n.sum(axis=(1, 2))[:, None]),
        (counts[touched], data.centre_mm[touched]),
    )
    grown: list[Any] = []
    for inputs, target in targets:
        regressor = ExtraTreesRegressor(
            trees,
            min_samples_leaf=LEAST_FRAMES_OF_LEAF,
            max_depth=MOST_LEVELS,
            random_state=seed,
        )
        answer = target if target.shape[1] == 2 else target[:, 0]
        grown += [tree.tree_ for tree in regressor.fit(inputs, answer).estimators_]
    return _forest_of(grown)


def _forest_of(grown: list[Any]) -> Forest:
    """Trees of scikit-learn, those of force first."""
    starts = np.cumsum([0, *(tree.node_count for tree in grown)])
    depth = max(int(tree.max_depth) for tree in grown)
    forest = Forest(ForestShape(len(grown) // 2, int(starts[-1]), depth))
    below, above = (
        np.concatenate(
            [_followers(tree, side) + start for tree, start in zip(grown, starts, strict=False)]
        )
        for side in ("children_left", "children_right")
    )
    answer = np.zeros((int(starts[-1]), 2))
    for tree, start in zip(grown, starts, strict=False):
        values = tree.value[:, :, 0]
        answer[start : start + tree.node_count, : values.shape[1]] = values
    columns = {
        "root": starts[:-1],
        "below": below,
        "above": above,
        "split": np.concatenate([np.maximum(tree.feature, 0) for tree in grown]),
        "threshold_counts": np.concatenate([tree.threshold for tree in grown]),
        "answer": answer,
    }
    for name, values in columns.items():
        getattr(forest, name).copy_(torch.as_tensor(values))
    return forest


def _followers(tree: Any, side: str) -> np.ndarray:
    """The node itself in a leaf."""
    children = np.asarray(getattr(tree, side))
    return np.where(children < 0, np.arange(len(children)), children)
