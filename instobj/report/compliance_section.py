"""The report's map of how soft the object is where."""

from __future__ import annotations

from pathlib import Path

from design.spec.object import ObjectSpec
from instobj.report import elements


def compliance_section(spec: ObjectSpec, presses: Path, scratch: Path) -> str:
    """HTML; `presses` is the folder of the presses' stage."""
    from fem.presses.compliance_map import compliance_map
    from fem.presses.results import load_presses
    from instobj.figures.compliance import WITH_MAGNETS, draw_compliance

    forces, _ = load_presses(presses / "presses.nc")
    draw_compliance(spec, compliance_map(forces), scratch)
    return (
        "<h2>How soft it is where</h2>"
        + elements.image(scratch / WITH_MAGNETS, "Compliance of every place")
        + "<p class='note'>Travel per newton of every contact place, the secant at the stated depth. "
        "<code>instobj compliance</code> shows it beside the same object without magnets, with the "
        "numbers as a table.</p>"
    )
