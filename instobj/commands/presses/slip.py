"""Cost of a slip of the core, by both models of it: the command."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.errors import InputError
from design.spec_io import load_spec, spec_hash
from instobj.report.core_section import comparison_rows, slip_title
from instobj.stages.makers.slip import with_slip
from instobj.stages.run import Run
from instobj.store.publish import file_rows, publish_to, require_writable, run_folder, stage_row
from instobj.store.readers import SLIP


def slip_specification(
    path: Path,
    shift_mm: tuple[float, float, float],
    rotation_deg: tuple[float, float, float],
    rim: str,
    out: Path,
    overrides: list[str],
) -> dict[str, Any]:
    """Compare both models of a slip with the object as calibrated.

    Results go to `runs/<name>/slip_<shift>_<rotation>_<rim>/`.

    Raises
    ------
    InputError
        A bad specification, or no slip, or one out of range.
    """
    spec = load_spec(path, overrides)
    if not any(shift_mm) and not any(rotation_deg):
        raise InputError("no slip given. Give --shift X Y Z or --rotation X Y Z")
    slip = {"shift_mm": shift_mm, "rotation_deg": rotation_deg, "rim": rim}
    slipped = with_slip(spec, slip)
    require_writable(out)
    run = Run(slipped)
    result = run.require("slip")
    content = SLIP.read(result.folder)
    files = publish_to(run_folder(out, spec.name) / _folder(slip), result)
    return {
        "command": "slip",
        "objects": [
            {
                "name": spec.name,
                "spec_hash": spec_hash(spec),
                "stages": [stage_row(result) for result in run.results.values()],
                "summary": {
                    slip_title(slip): comparison_rows(content["models"]),
                    "change of the resting signal": content["sensors"],
                },
                "files": file_rows(files),
            }
        ],
    }


def _folder(slip: dict[str, Any]) -> str:
    values = (*slip["shift_mm"], *slip["rotation_deg"])
    return "slip_" + "_".join(f"{value:g}" for value in values) + f"_{slip['rim']}"
