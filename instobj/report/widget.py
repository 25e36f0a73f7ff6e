"""The view of an object as a widget of a notebook: the report's markup, program and scene (anywidget)."""

from __future__ import annotations

import anywidget
import traitlets

from instobj.report.pages import render, style
from instobj.viewer.bundling import program

_RENDER = "\nexport default { render: instobjViewer.render };\n"


class ObjectView(anywidget.AnyWidget):
    """One object in three dimensions.

    Attributes
    ----------
    markup : controls, stage and numbers of the view, as in the report
    scene : archive of the stage `scene`
    """

    _esm = program() + _RENDER
    _css = style("viewer.css")
    markup = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Bytes().tag(sync=True)


def object_view(name: str, scene: bytes) -> ObjectView:
    """The widget of an object, by its name and its scene's archive."""
    return ObjectView(markup=str(render("widget.html.j2", title=name)), scene=scene)
