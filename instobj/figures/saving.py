"""Saving of figures: atomic, one resolution, the same bytes from the same data."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from design.files import atomic_path

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DPI = 120


def save_figure(figure: Figure, path: Path | str) -> Path:
    """Write a figure as PNG at `DPI` dots per inch, complete or not at all; returns the path.

    Raises
    ------
    InputError
        The picture cannot be written.
    """
    figure.set_dpi(DPI)
    _lay_out(figure)
    with atomic_path(path) as temporary:
        figure.savefig(temporary, dpi=DPI, format="png", metadata={"Software": None})
    return Path(path)


def _lay_out(figure: Figure) -> None:
    """Once: with an engine left in place, saving would draw and lay out everything twice."""
    engine = figure.get_layout_engine()
    if engine is not None:
        engine.execute(figure)
        figure.set_layout_engine(None)  # "none" would leave a placeholder that draws once more
