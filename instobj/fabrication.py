"""Fabrication checks as a stage of the chain, and as a part of `instobj check`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from instobj.stage import StageContext, write_json

FINDINGS = "fabrication.json"
PICTURE = "fabrication.png"


def make_fabrication(context: StageContext, folder: Path) -> None:
    """All findings, and a picture of the places where something did not pass."""
    from design.fabrication import check_fabrication
    from design.finding import worst
    from instobj.report.fabrication_figure import draw_findings

    checked = check_fabrication(context.spec, context.step)
    context.step("drawing the places found")
    draw_findings(checked.findings, checked.meshes, context.spec.name, folder / PICTURE)
    content = {
        "name": context.spec.name,
        "printer": context.spec.printer.name,
        "silicone": context.spec.silicone.name,
        "status": worst(checked.findings),
        "findings": [finding.as_dict() for finding in checked.findings],
    }
    write_json(content, folder / FINDINGS)


def fabrication_of(specs: list[Path], overrides: list[str], out: Path) -> list[dict[str, Any]]:
    """Findings of every specification, published to `cad_out/<name>`."""
    from design.spec_io import load_spec
    from instobj.chain import Chain
    from instobj.publish import file_rows, publish, require_writable

    require_writable(out)
    found = []
    for path in specs:
        spec = load_spec(path, overrides)
        result = Chain(spec).require("fabrication")
        content = json.loads((result.folder / FINDINGS).read_text(encoding="utf-8"))
        found.append(content | {"files": file_rows(publish(spec, result, out))})
    return found
