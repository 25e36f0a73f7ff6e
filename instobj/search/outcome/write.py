"""Files of a search: specifications that `instobj run` takes, its results and a page."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from design.files import atomic_path
from design.layout.places.coverage import covered_share
from design.search.space import SearchSpace
from design.spec.mechanics import MeshSpec
from design.spec.object import ObjectSpec
from design.spec.search import SearchSpec
from design.spec.silicone import is_test_file
from design.tables import toml_text
from estimator.layouts.fidelity import SCORE_NAMES
from instobj.search.outcome.history import search_history
from instobj.search.outcome.layouts import shown_layouts
from instobj.search.outcome.page import ChainResults, write_search_page
from instobj.search.trials import KeptTrials
from instobj.search.verdict import Promoted, Promotion, best_in_words, best_known
from instobj.stages.run import Run
from instobj.store.stage import write_json

BEST, RESULTS = "best.toml", "search.json"


def write_outcome(
    space: SearchSpace,
    kept: KeptTrials,
    promotion: Promotion,
    folder: Path,
    spec_folder: Path,
    step: Callable[[str], None],
) -> list[Path]:
    """Write finalists, the best of them, `search.json`, the page.

    `spec_folder` is the folder of the specification, from which it names other files.
    """
    written = []
    for place, layout in enumerate(promotion.finalists, start=1):
        written.append(folder / f"finalist_{place}.toml")
        write_specification(
            layout.spec, f"{space.spec.name}_finalist_{place}", written[-1], spec_folder
        )
    search = space.spec.search
    best_spec, about = best_known(search, promotion).spec, best_in_words(search, promotion)
    written.append(write_best(best_spec, about, space.spec.name, folder, spec_folder))
    written.append(folder / RESULTS)
    write_json(_results(promotion), written[-1])
    history = search_history(space, kept)
    start, best = (Run(layout.spec) for layout in (promotion.start, promotion.best))
    scores = None
    if promotion.finalists:
        scores = start.require("scores").folder, best.require("scores").folder
    results = ChainResults(best.require("build").folder, scores)
    layouts = shown_layouts(space, kept, promotion, history)
    written.append(
        write_search_page(space.spec, promotion, history, layouts, results, folder, step)
    )
    return written


def write_best(spec: ObjectSpec, about: str, name: str, folder: Path, beside: Path) -> Path:
    """Write the best layout so far of the search of `name`, and what is known of it in its first line."""
    folder.mkdir(parents=True, exist_ok=True)
    write_specification(spec, f"{name}_best", folder / BEST, beside, f"# {about}\n")
    return folder / BEST


def write_specification(
    spec: ObjectSpec, name: str, path: Path, beside: Path, comment: str = ""
) -> None:
    """A layout as a specification file of its own, without the search; a mesh coarser than the default, as
    searches take it, is named in a comment."""
    content = spec.changed(name=name, search=SearchSpec()).model_dump(
        mode="json", exclude_none=True
    )
    del content["search"], content["as_built"]
    if is_test_file(spec.silicone.modulus_from):
        content["silicone"]["modulus_from"] = str(
            (beside / content["silicone"]["modulus_from"]).absolute()
        )
    if "file" in content["indenter"]:
        content["indenter"]["file"] = str((beside / content["indenter"]["file"]).absolute())
    coarse = [
        name
        for name in ("edge_mm", "surface_edge_mm", "rim_edge_ratio")
        if content["mesh"][name] > getattr(MeshSpec(), name)
    ]
    if coarse:
        keys = ", ".join(coarse)
        comment += f"# Coarse mesh of this search: for the final run delete {keys} below [mesh]\n"
    with atomic_path(path) as temporary:
        temporary.write_bytes(f"{comment}{toml_text(content)}".encode())


def _results(promotion: Promotion) -> dict[str, Any]:
    def promoted(layout: Promoted) -> dict[str, Any]:
        levels = {
            level: {name: getattr(score, name) for name in SCORE_NAMES}
            for level, score in layout.levels.items()
        }
        return {"layout": layout.label, "trial": layout.trial, "rungs": levels}

    return json.loads(
        json.dumps(
            {
                "better": promotion.better,
                "gains": promotion.gains,
                "objections": promotion.objections,
                "shortened": promotion.shortened,
                "covered_share": covered_share(promotion.best.spec),
                "start": promoted(promotion.start),
                "leaders": [promoted(layout) for layout in promotion.leaders],
                "finalists": [layout.label for layout in promotion.finalists],
                "ratios": {name: asdict(ratio) for name, ratio in promotion.ratios.items()},
            }
        )
    )
