"""Figures of identifiability: drawn from rows, blind sets included."""

import numpy as np

from design.spec.object import ObjectSpec
from estimator.information.identifiability import Identifiability, WorstSet
from instobj.figures.information import draw_blindest, draw_identifiability

SPEC = ObjectSpec(name="cube")


def row(contacts, sensors, channels, bound):
    """A row with made-up bounds; infinite ones stand for blind sets."""
    xy = np.array([[-12.0, 3.0], [6.0, 1.5], [4.5, -13.5]])[:contacts]
    direction = np.ones((contacts, 3)) / np.sqrt(3 * contacts)
    blind = not np.isfinite(bound)
    return Identifiability(
        contacts, sensors, channels, 3 * contacts, 3 * sensors, 40,
        min(3 * sensors, 3 * contacts), 2.0, np.inf if blind else 9.0,
        bound / 3 if not blind else np.inf, bound, bound * 4, 0.5, 1.0,
        WorstSet(2, np.inf if blind else 30.0, xy, direction),
    )  # fmt: skip


def made_rows():
    return [
        row(k, n, channels, np.inf if channels == "own" and n < k else 2.0 * k / n)
        for channels in ("own", "all")
        for n in (1, 2, 3)
        for k in (1, 2, 3)
    ]


def test_bounds_against_sensors_are_drawn_with_blind_sets_marked(tmp_path):
    pictures = []
    for rows in (made_rows(), [row for row in made_rows() if np.isfinite(row.bound_90_mm)]):
        draw_identifiability(SPEC, rows, tmp_path / "bounds.png")
        pictures.append((tmp_path / "bounds.png").read_bytes())
    assert all(picture.startswith(b"\x89PNG") for picture in pictures)
    assert pictures[0] != pictures[1]


def test_blindest_sets_are_drawn_for_the_specified_number_of_sensors(tmp_path):
    draw_blindest(SPEC, made_rows(), tmp_path / "three.png")
    two = SPEC.model_copy(update={"sensors": SPEC.sensors.model_copy(update={"count_per_face": 2})})
    draw_blindest(two, made_rows(), tmp_path / "two.png")
    pictures = [(tmp_path / name).read_bytes() for name in ("three.png", "two.png")]
    assert all(picture.startswith(b"\x89PNG") for picture in pictures)
    assert pictures[0] != pictures[1]
