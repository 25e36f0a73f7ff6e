"""Designs side by side: scores, a figure, and a page whose views are linked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.files import atomic_path
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.commands.compare import comparison_picture
from instobj.commands.run import run_chain
from instobj.report.pages import render
from instobj.stages.run import Run
from instobj.store.publish import file_rows
from instobj.store.readers import SCENE, STILL

MOST = 4
"""Designs on a page: each view is a picture in three dimensions."""


def score_designs(
    paths: list[Path], shear: bool, out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Bring each specification to its scores; two to four of them get `comparison.html` as well.

    Raises
    ------
    InputError
        A bad specification, or two of one name.
    """
    stages = ("scores", "weak_areas", *(("shear_scores",) if shear else ()), "discretisation")
    compared = 1 < len(paths) <= MOST
    result = run_chain(paths, (*stages, "scene") if compared else stages, out, overrides)
    if not compared:
        return result
    specs = [load_spec(path, overrides) for path in paths]
    scenes = [Run(spec).require("scene").folder for spec in specs]
    page = write_comparison_page(
        specs, scenes, result["comparison"]["rows"], comparison_picture(specs, out)
    )
    result["comparison"]["files"] += file_rows([page])
    return result


def write_comparison_page(
    specs: list[ObjectSpec], scenes: list[Path], scores: list[dict[str, Any]], figure: Path
) -> Path:
    """Write `comparison.html` beside the figure, from the folders of the scenes."""
    names = [spec.name for spec in specs]
    page = render(
        "comparison.html.j2",
        names=names,
        rows=[
            [score, *(_cell(of_one[score]) for of_one in scores)]
            for score in scores[0]
            if score != "object"
        ],
        designs=[
            (name, SCENE.path(folder), STILL.path(folder))
            for name, folder in zip(names, scenes, strict=True)
        ],
        figure=figure,
    )
    path = figure.with_name("comparison.html")
    with atomic_path(path) as temporary:
        temporary.write_text(page, encoding="utf-8")
    return path


def _cell(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
