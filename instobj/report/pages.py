"""Pages from templates: self-contained HTML with pictures and style within the file."""

from __future__ import annotations

import base64
import hashlib
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.files import atomic_path
from instobj.report.cells import table_of
from instobj.viewer.bundling import program

if TYPE_CHECKING:
    from jinja2 import Environment

_TEMPLATES = Path(__file__).parent / "templates"
_STEPS = 51
"""Steps of each colour in pictures of pages, 5 of 255 each, with black and white as they are."""


def render(page: str, /, **context: Any) -> str:
    """Fill a template of this room in: text is escaped, missing names are errors, other pages take it."""
    return _safe(_environment().get_template(page).render(context))


def write_page(path: Path, page: str, /, **context: Any) -> Path:
    """Write a page, complete or not at all, and return where it is; as `render`."""
    text = render(page, **context)
    with atomic_path(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return path


def _safe(text: str) -> str:
    """Return text that templates take as it is: HTML, scripts and styles of our own."""
    return _environment().filters["safe"](text)


def picture(path: Path) -> str:
    """A PNG as a link that holds it as WebP, a third of the size: colours are off by 2 of 255 at most."""
    from matplotlib.image import imread, imsave

    shares = imread(path)[..., :3]
    pixels = np.uint8(255 / _STEPS * np.round(shares * _STEPS))
    buffer = BytesIO()
    imsave(buffer, pixels, format="webp", pil_kwargs={"lossless": True, "method": 1})
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()


def embedded(path: Path) -> str:
    """A file's bytes as base64."""
    return base64.b64encode(path.read_bytes()).decode()


def policy() -> str:
    """Return what a page with the viewer may do: run that program, show its own pictures, ask no network."""
    digest = base64.b64encode(hashlib.sha256(program().encode()).digest()).decode()
    sources = "img-src data:; style-src 'unsafe-inline'"
    return f"default-src 'none'; {sources}; script-src 'sha256-{digest}'"


@lru_cache(maxsize=1)
def _environment() -> Environment:
    # a robot's environment has no jinja2: it shows tables, and writes no pages
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.globals |= {"picture": picture, "style": style, "embedded": embedded}
    environment.globals |= {"table_of": table_of}
    environment.globals |= {"policy": policy, "program": lambda: _safe(program())}
    return environment


def style(name: str) -> str:
    """A style sheet of this room."""
    return _safe((_TEMPLATES / name).read_text(encoding="utf-8"))
