"""Saving of figures: atomic, one resolution, the same bytes from the same data."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from design.files import atomic_path

if TYPE_CHECKING:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

DPI = 120
"""Dots per inch of figures."""
_COMPRESSION = 4
"""Level of PNG's compression, from 0 (none) to 9 (slow)."""


def save_figure(figure: Figure, path: Path | str) -> Path:
    """Write a figure as PNG at `DPI` dots per inch, complete or not at all; returns the path.

    Raises
    ------
    InputError
        The picture cannot be written.
    """
    return save_drawn(drawn(figure), path)


def drawn(figure: Figure) -> FigureCanvasAgg:
    """A figure laid out and drawn at `DPI` dots per inch."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure.set_dpi(DPI)
    _lay_out(figure)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return canvas


def save_drawn(canvas: FigureCanvasAgg, path: Path | str) -> Path:
    """Write what is drawn on a canvas, as `save_figure` does.

    Without the transparency that nothing has, and less thoroughly compressed than usual: a tenth
    smaller all the same, in two thirds of the time.
    """
    from PIL import Image

    pixels, dpi = np.asarray(canvas.buffer_rgba()), canvas.figure.dpi
    picture = Image.fromarray(pixels)
    if pixels[..., 3].min() == 255:
        picture = picture.convert("RGB")
    content = io.BytesIO()  # Pillow's encoder does not tell why a file cannot be written
    picture.save(content, format="png", dpi=(dpi, dpi), compress_level=_COMPRESSION)
    with atomic_path(path) as temporary:
        temporary.write_bytes(content.getbuffer())
    return Path(path)


def _lay_out(figure: Figure) -> None:
    """Once: with an engine left in place, saving would draw and lay out everything twice."""
    engine = figure.get_layout_engine()
    if engine is not None:
        engine.execute(figure)
        figure.set_layout_engine(None)  # "none" would leave a placeholder that draws once more
