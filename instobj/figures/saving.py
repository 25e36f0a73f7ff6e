"""Saving of figures: atomic, one resolution, the same bytes from the same data."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

from design.files import atomic_path

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DPI = 120
"""Dots per inch of figures."""
_COMPRESSION = 4
"""Level of PNG's compression, from 0 (none) to 9 (slow); pages pack their copies again."""


def save_figure(figure: Figure, path: Path | str) -> Path:
    """Write a figure as PNG at `DPI` dots per inch, complete or not at all; returns the path.

    Raises
    ------
    InputError
        The picture cannot be written.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.image import imsave

    figure.set_dpi(DPI)
    _lay_out(figure)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    content = io.BytesIO()  # the encoder does not tell why a file cannot be written
    imsave(
        content,
        canvas.buffer_rgba(),
        format="png",
        dpi=DPI,
        metadata={"Software": "instobj"},  # in place of a version, so that bytes stay the same
        pil_kwargs={"compress_level": _COMPRESSION},
    )
    with atomic_path(path) as temporary:
        temporary.write_bytes(content.getbuffer())
    return Path(path)


def _lay_out(figure: Figure) -> None:
    """Once: with an engine left in place, saving would draw and lay out everything twice."""
    engine = figure.get_layout_engine()
    if engine is not None:
        engine.execute(figure)
        figure.set_layout_engine(None)  # "none" would leave a placeholder that draws once more
