"""LeRobot data sets of raw counts: read in the layouts of versions 2.1 and 3, written in that of 2.1.

`meta/info.json` names the channels in the feature `observation.hall_counts`; every episode is a
session. LeRobot's own stamps are single precision and evenly spaced, so the writer adds a recording's
stamps and labels as further features. The layout follows LeRobot's documentation of its data sets
(huggingface.co/docs/lerobot); no LeRobot package has read one so far.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from design.errors import RecordingError

HALL_COUNTS, TIME_NS, LABELS = "observation.hall_counts", "instobj.time_ns", "instobj.labels"
_NS = 1_000_000_000
"""Nanoseconds of a second."""
_DATA = "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet"
_CHUNK = 1000
"""Episodes in a folder, as LeRobot has them."""
_TASK = "presses of an instrumented object"


def counts_feature(channels: list[str]) -> dict[str, dict[str, Any]]:
    """Return the feature that holds raw counts of the channels."""
    return {HALL_COUNTS: {"dtype": "float32", "shape": (len(channels),), "names": channels}}


def write_data_set(
    folder: Path,
    channels: list[str],
    counts: Float[np.ndarray, "frame channel"],
    stamps_ns: Int[np.ndarray, "frame"],
    labels: tuple[list[str], Float[np.ndarray, "frame label"]],
) -> None:
    """Write counts, stamps and labels (names, numbers) as a data set; sessions in a row are episodes."""
    names, values = labels
    session = values[:, names.index("session")] if "session" in names else np.zeros(len(counts))
    starts = np.flatnonzero(np.diff(session, prepend=np.nan) != 0)
    episodes = np.split(np.arange(len(counts)), starts[1:])
    steps = np.diff(stamps_ns)
    # one rate for all, as LeRobot has it: whole frames a second, 1 at least
    fps = max(1, round(_NS / np.median(steps[steps > 0]))) if (steps > 0).any() else 1
    single = {"shape": (1,), "names": None}
    features = counts_feature(channels) | {TIME_NS: {"dtype": "int64"} | single}
    if names:
        features[LABELS] = {"dtype": "float64", "shape": (len(names),), "names": names}
    features |= {"timestamp": {"dtype": "float32"} | single}
    for name in ("frame_index", "episode_index", "index", "task_index"):
        features[name] = {"dtype": "int64"} | single
    lines = []
    for episode, rows in enumerate(episodes):
        columns = {HALL_COUNTS: counts[rows].astype(np.float32), TIME_NS: stamps_ns[rows]}
        if names:
            columns[LABELS] = values[rows]
        columns |= {
            "timestamp": (np.arange(len(rows)) / fps).astype(np.float32),
            "frame_index": np.arange(len(rows)),
            "episode_index": np.full(len(rows), episode),
            "index": rows,
            "task_index": np.zeros(len(rows), int),
        }
        _write_episode(folder, episode, columns)
        stats = {name: _statistics(column) for name, column in columns.items()}
        lines.append(({"tasks": [_TASK], "length": len(rows)}, {"stats": stats}))
    info = {
        "codebase_version": "v2.1",
        "robot_type": None,
        "total_episodes": len(episodes),
        "total_frames": len(counts),
        "total_tasks": 1,
        "total_videos": 0,
        "total_chunks": (len(episodes) - 1) // _CHUNK + 1,
        "chunks_size": _CHUNK,
        "fps": fps,
        "splits": {"train": f"0:{len(episodes)}"},
        "data_path": _DATA,
        "video_path": None,
        "features": features,
    }
    _write_meta(folder / "meta", info, lines)


def _write_episode(folder: Path, episode: int, columns: dict[str, np.ndarray]) -> None:
    import pyarrow
    from pyarrow import parquet

    path = folder / _DATA.format(episode_chunk=episode // _CHUNK, episode_index=episode)
    path.parent.mkdir(parents=True, exist_ok=True)
    arrays = {
        name: pyarrow.array(column)
        if column.ndim == 1
        else pyarrow.FixedSizeListArray.from_arrays(column.ravel(), column.shape[1])
        for name, column in columns.items()
    }
    parquet.write_table(pyarrow.table(arrays), path)


def _statistics(column: np.ndarray) -> dict[str, list[Any]]:
    """Return least, largest, mean, deviation and number of each number of a feature, as LeRobot has them."""
    values = column.reshape(len(column), -1).astype(float)
    # JSON knows no NaN: of a channel without any reading all are 0
    some = np.isfinite(values)
    filled = np.where(some, values, 0.0)
    number = some.sum(axis=0).clip(1)
    mean = filled.sum(axis=0) / number
    deviation = np.sqrt((np.where(some, values - mean, 0.0) ** 2).sum(axis=0) / number)
    parts = {
        "min": np.where(some, values, np.inf).min(axis=0),
        "max": np.where(some, values, -np.inf).max(axis=0),
        "mean": mean,
        "std": deviation,
    }
    result = {name: np.where(np.isfinite(x), x, 0.0).tolist() for name, x in parts.items()}
    return result | {"count": [len(column)]}


def _write_meta(
    folder: Path, info: dict[str, Any], lines: list[tuple[dict[str, Any], dict[str, Any]]]
) -> None:
    folder.mkdir(parents=True)
    numbered = [{"episode_index": n} for n in range(len(lines))]
    (folder / "info.json").write_text(json.dumps(info, indent=4))
    rows = {
        "tasks.jsonl": [{"task_index": 0, "task": _TASK}],
        "episodes.jsonl": [n | length for n, (length, _) in zip(numbered, lines, strict=True)],
        "episodes_stats.jsonl": [n | stats for n, (_, stats) in zip(numbered, lines, strict=True)],
    }
    for name, documents in rows.items():
        (folder / name).write_text("".join(json.dumps(row) + "\n" for row in documents))


def data_set_rows(path: Path) -> Iterator[list[Any]]:
    """Yield the header and the frames of a data set as rows of a generic CSV.

    Raises
    ------
    RecordingError
        Damaged, or without raw counts whose names are the channels.
    """
    from pyarrow import parquet

    try:
        features = json.loads((path / "meta/info.json").read_text())["features"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise RecordingError(f"its meta/info.json cannot be read ({error})") from None
    names = (features.get(HALL_COUNTS) or {}).get("names")
    if not names:
        raise RecordingError(
            f"its features are {', '.join(features)}; raw counts belong into {HALL_COUNTS}, with the "
            "channels' names"
        )
    labels = (features.get(LABELS) or {}).get("names") or []
    # sessions that are among the labels are not counted again
    numbered = [] if "session" in labels else ["session"]
    yield ["time_s", *numbered, *names, *labels]
    columns = ["timestamp", "episode_index", HALL_COUNTS]
    columns += [name for name in (TIME_NS, LABELS) if name in features]
    for part in sorted((path / "data").rglob("*.parquet")):
        try:
            table = parquet.read_table(part, columns=columns).to_pylist()
        except (OSError, ValueError, KeyError) as error:
            raise RecordingError(f"{part.name} cannot be read ({error})") from None
        for row in table:
            episode = [str(row["episode_index"] + 1)] if numbered else []
            values = [*row[HALL_COUNTS], *(row[LABELS] if labels else [])]
            yield [_stamp(row), *episode, *(_cell(value) for value in values)]


def _stamp(row: dict[str, Any]) -> str:
    if TIME_NS not in row:
        return f"{row['timestamp']:.9f}"
    seconds, rest_ns = divmod(row[TIME_NS], _NS)
    return f"{seconds}.{rest_ns:09d}"


def _cell(value: float | None) -> str:
    """Return a number as a cell, empty where there is none."""
    return "" if value is None or np.isnan(value) else f"{value:.17g}"
