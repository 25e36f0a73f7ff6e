"""`instobj assess` without an estimator: contact slip in the raw channels of recordings."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.frames.dataset import load_frames
from estimator.grasps.channel_slip import LEAST_HOLD, REST_FRAMES, slips_in_channels
from instobj.commands.assess.groups import write_csv
from instobj.commands.assess.tracks import TENSORS, recordings_in
from instobj.commands.readings import is_data_set, recorded_stream
from instobj.store.publish import file_rows, require_writable, run_folder, run_name

_READ_SHARE = 0.9
"""Share of the frames that a channel must have a reading in to be used."""


def assess_raw(paths: Sequence[Path], out: Path) -> dict[str, Any]:
    """Judge every hold of recordings without a specification; writes `runs/<name>/assess/slips.csv`.

    Raises
    ------
    InputError
        A bad recording, or no hold in any of them.
    """
    require_writable(out)
    files = [file for path in paths for file in recordings_in(path)]
    rows = [row for file in files for row in _rows(file)]
    if not rows:
        raise InputError(
            f"no contact shows in {', '.join(map(str, paths))}: no channel leaves the noise of the first "
            f"{REST_FRAMES} frames for long. Begin each recording at rest, and hold for {LEAST_HOLD} frames"
        )
    name = "+".join(path.absolute().name if path.is_dir() else run_name(path) for path in paths[:2])
    slipped = sum(row["slipped"] == "yes" for row in rows)
    short = sum(row["slipped"] == "cannot be said" for row in rows)
    return {
        "command": "assess",
        "texts": [
            f"{slipped} of {len(rows) - short} holds slipped, by the raw channels alone"
            + (f"; of {short} too short ones nothing is said" if short else ""),
            "A slide without any pull before it is missed. A pull to one side and then across counts "
            "as slip. Forces and places need an estimator (--model)",
        ],
        "tables": {"slip": rows},
        "files": file_rows([write_csv(run_folder(out, name) / "assess" / "slips.csv", rows)]),
    }


def _rows(path: Path) -> list[dict[str, Any]]:
    values, time_s = _channels(path)
    stamped = len(time_s) == len(values)
    clock = time_s if stamped else np.arange(len(values), dtype=float)
    rows = []
    for number, hold in enumerate(slips_in_channels(values, clock), start=1):
        verdict = "cannot be said" if np.isnan(hold.bend) else "yes" if hold.slipped else "no"
        row = {
            "recording": path.name,
            "hold": number,
            "from frame": hold.start,
            "to frame": hold.end,
            "signal over noise": round(hold.signal, 1),
            "bend": None if np.isnan(hold.bend) else round(hold.bend, 2),
            "slipped": verdict,
            "onset frame": round(hold.onset, 1) if hold.slipped else None,
        }
        if stamped:
            onset_s = float(np.interp(hold.onset, np.arange(len(clock)), clock))
            row["onset s"] = round(onset_s, 3) if hold.slipped else None
        rows.append(row)
    return rows


def _channels(
    path: Path,
) -> tuple[Float[np.ndarray, "frame channel"], Float[np.ndarray, "stamp"]]:
    """Readings of the channels that have them, in the frames that lack none; stamps (s) where there are."""
    if path.suffix == TENSORS:
        # torch is slow to load, a robot lacks it, and only such files need it
        try:
            from estimator.networks.tensor_file import read_recorded_tensor
        except ModuleNotFoundError:
            raise InputError(
                f"{path} needs torch to be read, which is not installed. Run: pip install torch, or give the "
                "recording as CSV"
            ) from None
        values, time_s = read_recorded_tensor(path), np.empty(0)
    elif is_data_set(path):
        frames = load_frames(path)
        values, time_s = frames.signal_counts.reshape(len(frames), -1), frames.time_s
    else:
        stream = recorded_stream(path)
        values = np.where(stream.left_out, np.nan, stream.raw).reshape(len(stream.raw), -1)
        time_s = stream.time_s
    read = np.isfinite(values)
    values = values[:, read.mean(axis=0) >= _READ_SHARE]
    whole = np.isfinite(values).all(axis=1)
    return values[whole], time_s[whole] if len(time_s) else time_s
