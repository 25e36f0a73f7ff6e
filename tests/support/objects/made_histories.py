"""Histories of searches that were never run, and layouts to show."""

import numpy as np

from design.spec_io import parse_spec
from instobj.search.outcome.history import History
from instobj.search.outcome.layouts import ShownLayout
from tests.support.objects.search_cases import OBJECTIVES


def made_up_history():
    """Sixty trials of two objectives, better and better."""
    rng = np.random.default_rng(1)
    values = np.exp(rng.normal(size=(60, 2)) - np.linspace(0, 1, 60)[:, None])
    names = ("worst_position_bound_mm", "worst_force_bound_n")
    feasible = rng.random(60) < 0.7
    return History(names, values, feasible, np.array([2.0, 3.0]), 41 * np.arange(1, 61))


def history_of_three():
    """Three trials of two objectives; the third breaks limits."""
    values = np.array([[1.0, 3.0], [2.0, 1.0], [3.0, 3.0]])
    return History(
        OBJECTIVES, values, np.array([True, True, False]), np.array([2.0, 9.0]), np.arange(1, 4)
    )  # fmt: skip


def made_up_layouts():
    """The paper's layout, and one of three magnets."""
    start = parse_spec({"name": "a"}, "a")
    few = {"positions_mm": [[9, 9], [0, 1], [-9, 8]], "north": ["inward", "outward", "inward"]}
    found = parse_spec({"name": "b", "magnets": few}, "b")
    return [ShownLayout("start", start, (2.0, np.inf)), ShownLayout("trial 3", found, (1.0, 3.0))]
