"""Designs side by side: scores, a figure, and a page whose views are linked."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.commands.compare import comparison_picture
from instobj.commands.next_step import verdict_step
from instobj.commands.run import run_chain
from instobj.report.cells import turned
from instobj.report.pages import write_page
from instobj.report.remedies import DESIGN_STAGES
from instobj.stages.run import Run
from instobj.store.publish import file_rows
from instobj.store.readers import RESPONSE, SCENE, SCORES, STILL

MOST = 4
"""Designs on a page: each view is a picture in three dimensions."""


def score_designs(
    paths: list[Path], also: Sequence[str], out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Bring each specification to its scores; two to four of them get `comparison.html` as well.

    `also` "shear" adds bounds of tangential forces, "jaw" those of a flat jaw over each face.

    Raises
    ------
    InputError
        A bad specification, two of one name, an unknown word in `also`, or a jaw on a curved face.
    """
    for word in also:
        if word not in ("shear", "jaw"):
            raise InputError(
                f"--also {word!r} is not known. Give --also shear, --also jaw, or both"
            )
    sheared = ("shear_scores",) if "shear" in also else ()
    stages = (*DESIGN_STAGES, *sheared, "discretisation")
    compared = 1 < len(paths) <= MOST
    result = run_chain(paths, (*stages, "scene") if compared else stages, out, overrides)
    for path in paths if "jaw" in also else ():
        run = Run(load_spec(path, overrides))
        title = (
            f"{run.spec.name}: a flat jaw over each face at {run.spec.score.force_n:g} N, and tips"
        )
        result.setdefault("tables", {})[title] = jaw_rows(run)
    result["next"] = verdict_step("score", paths, out, overrides, result)
    if not compared:
        return result
    specs = [load_spec(path, overrides) for path in paths]
    scenes = [Run(spec).require("scene").folder for spec in specs]
    page = write_comparison_page(
        specs, scenes, result["comparison"]["rows"], comparison_picture(specs, out)
    )
    result["comparison"]["files"] += file_rows([page])
    return result


def jaw_rows(run: Run) -> list[dict[str, Any]]:
    """Bounds of jaws at `score.force_n`: over each face, its middle (half as long), opposed faces."""
    from estimator.information.jaws import jaw_bounds
    from fem.presses.jaws import jaw_faces

    scores, rows = run.read(SCORES), []
    for jaw in jaw_bounds(run.spec, jaw_faces(run.spec, run.read(RESPONSE))):
        index = scores.faces.tolist().index(jaw.face)
        tips = scores.judged[index]
        rows.append(
            {
                "face": jaw.face,
                "against": jaw.against,
                "over": "face" if jaw.covered == 1 else "middle",
                "σ force N": jaw.force_bound_n,
                "of tips N": float(np.median(scores.force_bound_n[index, tips])),
                "σ centre mm": jaw.centre_bound_mm,
                "σ place of tips mm": float(np.median(scores.position_bound_mm[index, tips])),
                "σ tilt °": jaw.tilt_bound_deg,
                "σ size mm": jaw.size_bound_mm,
                "drifted N": jaw.force_bound_drifted_n,
                "mm": jaw.centre_bound_drifted_mm,
                "°": jaw.tilt_bound_drifted_deg,
                "size mm": jaw.size_bound_drifted_mm,
            }
        )
    return rows


def write_comparison_page(
    specs: list[ObjectSpec], scenes: list[Path], scores: list[dict[str, Any]], figure: Path
) -> Path:
    """Write `comparison.html` next to the figure, from the folders of the scenes."""
    names = [spec.name for spec in specs]
    return write_page(
        figure.with_name("comparison.html"),
        "comparison.html.j2",
        names=names,
        rows=turned(scores),
        designs=[
            (name, SCENE.path(folder), STILL.path(folder))
            for name, folder in zip(names, scenes, strict=True)
        ],
        figure=figure,
    )
