"""Files of stage results, read into what they hold."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fem.large_strain.correction import StrainCorrection

LARGE_STRAIN = "large_strain.json"


def stored_correction(folder: Path) -> StrainCorrection | None:
    """The correction in the folder of the stage "large_strain"; None where none was asked for."""
    from fem.large_strain.correction import StrainCorrection

    content = large_strain_content(folder)["correction"]
    if content is None:
        return None
    return StrainCorrection(
        content["thickness_mm"],
        tuple(content["force"]),
        tuple(content["shift"]),
        tuple(content["rotation"]),
    )


def large_strain_content(folder: Path) -> dict[str, Any]:
    """What the stage "large_strain" wrote: coefficients, errors, and a row for each press."""
    return json.loads((folder / LARGE_STRAIN).read_text(encoding="utf-8"))
