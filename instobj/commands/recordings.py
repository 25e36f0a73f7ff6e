"""`instobj recordings`: recordings into one data set, and what was found in them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from instobj.store.publish import file_rows, require_writable, run_folder

if TYPE_CHECKING:
    from estimator.recordings.reading import Grid


def read_recordings(files: list[Path], out: Path, spec: Path | None = None) -> dict[str, Any]:
    """Read recordings into one data set, `runs/<stems>/frames.nc`, and say what was found.

    `spec` gives the contact grid of an object that is not the paper's cube.

    Raises
    ------
    InputError
        A file that is no recording, or is given twice, or an invalid specification.
    """
    from estimator.frames.dataset import save_frames
    from estimator.recordings.combine import combine, jump_between_faults
    from estimator.recordings.reading import read_recording
    from instobj.store.progress import ProgressLine

    require_writable(out)
    progress = ProgressLine()
    grid_mm = None if spec is None else _grid_mm(spec)
    found = []
    for path in files:
        with progress.stage(f"reading {path}"):
            found.append(read_recording(path, grid_mm))
    frames = found[0].frames if len(found) == 1 else combine(found)
    between = jump_between_faults(found)
    target = run_folder(out, "+".join(path.stem for path in files)) / "frames.nc"
    save_frames(frames, target)
    return {
        "command": "recordings",
        "reports": [recording.report.as_dict() for recording in found],
        "between": [vars(fault) for fault in between],
        "texts": [*(str(recording.report) for recording in found), *map(str, between)],
        "files": file_rows([target]),
    }


def _grid_mm(spec: Path) -> Grid:
    from design.layout.positions import contact_grid
    from design.spec_io import load_spec

    grid = contact_grid(load_spec(spec, []))
    return grid.x_mm, grid.y_mm
