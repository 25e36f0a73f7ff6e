"""Pages from templates: self-contained HTML with pictures and style within the file."""

from __future__ import annotations

import base64
import hashlib
from functools import lru_cache
from io import BytesIO
from math import isinf, isnan
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from instobj.viewer.bundling import program

_TEMPLATES = Path(__file__).parent / "templates"


def render(page: str, /, **context: Any) -> Markup:
    """A template of this room, by its name, filled in; text is escaped, names that are missing are errors."""
    return Markup(_environment().get_template(page).render(context))


def shown(value: float | None) -> str:
    """A number to three digits, ∞ where it has no bound, or a dash where there is none."""
    if value is None or isnan(value):
        return "–"
    return "∞" if isinf(value) else f"{value:.3g}"


def picture(path: Path) -> str:
    """A PNG as a link that holds it, in the 256 colours that are nearest to its own.

    A third of the size: on maps and curves colours are off by 0.3 of 255 in the mean.
    """
    from PIL import Image

    with Image.open(path) as image:
        flat = image.convert("RGB").quantize(
            256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE
        )
    buffer = BytesIO()
    flat.save(buffer, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def embedded(path: Path) -> str:
    """A file's bytes as base64."""
    return base64.b64encode(path.read_bytes()).decode()


def policy() -> str:
    """Return what a page with the viewer may do: run that program, show its own pictures, ask no network."""
    digest = base64.b64encode(hashlib.sha256(program().encode()).digest()).decode()
    own = "img-src data:; style-src 'unsafe-inline'"
    return f"default-src 'none'; {own}; script-src 'sha256-{digest}'"


@lru_cache(maxsize=1)
def _environment() -> Environment:
    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.globals |= {"picture": picture, "style": style, "embedded": embedded}
    environment.globals |= {"policy": policy, "program": lambda: Markup(program())}
    return environment


def style(name: str) -> Markup:
    """A style sheet of this room."""
    return Markup((_TEMPLATES / name).read_text(encoding="utf-8"))
