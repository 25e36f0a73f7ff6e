"""Recordings that robots write, read as generic CSV: rosbag2 folders, MCAP files, LeRobot data sets.

A bag (a rosbag2 folder, or one `.mcap` or `.db3` file of it) has two topics. The names of all
columns come once, as `instobj_msgs/Layout` on /instobj/layout, and numbers often, as
`instobj_msgs/Frame` on /instobj/frames. LeRobot data sets: `estimator.recordings.formats.lerobot`.
An MCAP file that ROS did not write is read where a JSON topic names its numbers so: {"time_s": 0.1,
"F1-X1": 12, …}; without `time_s` the file's own stamps count.
Stamps are kept to 1 ns, numbers exactly.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
import shutil
import tempfile
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError, RecordingError
from design.files import atomic_path, require_regular_file
from estimator.recordings.formats.lerobot import counts_feature, data_set_rows, write_data_set

LAYOUT, FRAMES = "/instobj/layout", "/instobj/frames"
MESSAGES = {
    "instobj_msgs/msg/Layout": """\
# Names of the numbers of each Frame, sent once (transient local).
string[] channels  # F1-X1 …, raw counts
string[] labels    # session, rest, cell1_force_n, …; as docs/recordings.md names them
""",
    "instobj_msgs/msg/Frame": """\
# Readings of all channels at one time.
std_msgs/Header header
float64[] counts
bool[] valid       # false: the channel has no reading
float64[] labels   # NaN: not known
""",
}
"""Definition of each message; `ros2/instobj_msgs/msg` has the same."""
_MISSING = re.compile(r"#\s*missing\s*=\s*(\S+)\s*")
_MCAP = b"\x89MCAP0\r\n\x01"
"""First bytes of an MCAP file, with its header's mark."""
_CHANNEL = re.compile(r"F[1-6]-[XYZ]\d\d?")
_SUFFIXES = (".mcap", ".db3")
_NS = 1_000_000_000
"""Nanoseconds of a second."""


def is_robot_file(path: Path) -> bool:
    """Return whether a path is a bag or a LeRobot data set, by its name and its files."""
    return (path.suffix in _SUFFIXES and path.exists()) or any(
        (path / name).is_file() for name in ("metadata.yaml", "meta/info.json")
    )


def robot_csv(path: Path) -> bytes:
    """Return a bag or a LeRobot data set as a generic CSV.

    Raises
    ------
    RecordingError
        Damaged, or without the topics or the feature of an instrumented object.
    ImportError
        The extra `instobj[robot]` is not installed.
    """
    if (path / "meta").is_dir():
        rows = data_set_rows(path)
    else:
        rows = _json_rows(path) if _is_other_mcap(path) else _bag_rows(path)
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode()


def write_bag(recording: Path | str, bag: Path | str) -> None:
    """Write a recording as a rosbag2 folder, or as its one MCAP file, which Foxglove opens too.

    Parameters
    ----------
    recording : path
        Generic CSV, bag or LeRobot data set with stamps (`time_s`, s) from 0 on.
    bag : path
        Folder to be made; NAME.mcap is the one file alone.

    Returns
    -------
    None

    Raises
    ------
    InputError
        No such file, the bag exists, or stamps (`time_s`) are missing or below 0.
    ImportError
        The extra `instobj[robot]` is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> import instobj
    >>> _ = Path("presses.csv").write_text("time_s,F1-X1\\n0.0,12\\n0.1,15\\n")
    >>> instobj.robot.write_bag("presses.csv", "presses_bag")
    >>> sorted(path.name for path in Path("presses_bag").iterdir())
    ['metadata.yaml', 'presses_bag.mcap']
    """
    path = Path(bag)
    if path.exists():
        raise InputError(f"{path} exists already. Give the bag another name")
    table = _numbers_of(Path(recording))
    if path.suffix != ".mcap":
        _write_folder(path, *table)
        return
    with tempfile.TemporaryDirectory() as folder, atomic_path(path) as temporary:
        _write_folder(Path(folder) / "bag", *table)
        shutil.move(Path(folder) / "bag" / "bag.mcap", temporary)


def write_lerobot(recording: Path | str, folder: Path | str) -> None:
    """Write a recording as a LeRobot data set (version 2.1) of raw counts.

    Consecutive frames of one session are an episode. `timestamp` is even, as LeRobot wants it; the
    feature `instobj.time_ns` keeps the stamps, `instobj.labels` all labels.

    Parameters
    ----------
    recording : path
        Generic CSV, bag or LeRobot data set with stamps (`time_s`, s) from 0 on. Counts are whole
        numbers of 24 bits at most.
    folder : path
        Folder to be made.

    Returns
    -------
    None

    Raises
    ------
    InputError
        No such file, the folder exists, or stamps (`time_s`) are missing or below 0.
    ImportError
        The extra `instobj[robot]` is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> import instobj
    >>> _ = Path("a.csv").write_text("time_s,F1-X1\\n0.0,12\\n0.1,15\\n")
    >>> instobj.robot.write_lerobot("a.csv", "presses.lerobot")
    >>> sorted(path.name for path in Path("presses.lerobot").iterdir())
    ['data', 'meta']
    """
    path = Path(folder)
    if path.exists():
        raise InputError(f"{path} exists already. Give the data set another name")
    header, stamps_ns, rows = _numbers_of(Path(recording))
    values, time = np.array(rows), header.index("time_s")
    channels = [n for n, name in enumerate(header) if _CHANNEL.fullmatch(name)]
    labels = [n for n in range(len(header)) if n != time and n not in channels]
    named = [header[n] for n in labels], values[:, labels]
    stamps = np.array(stamps_ns, np.int64)
    with tempfile.TemporaryDirectory(dir=path.absolute().parent) as temporary:
        made = Path(temporary) / "set"
        write_data_set(made, [header[n] for n in channels], values[:, channels], stamps, named)
        made.rename(path)


def _numbers_of(path: Path) -> tuple[list[str], list[int], list[list[float]]]:
    """Return names, stamps (ns) and rows (NaN: none) of a generic CSV or of what robots wrote."""
    if is_robot_file(path):
        raw = robot_csv(path)
    else:
        raw = require_regular_file(path, f"no recording at {path}").read_bytes()
    try:
        content = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(
            f"{path} is no text in UTF-8. Give a generic CSV (`instobj docs recordings`)"
        ) from None
    lines = [line for line in content.splitlines() if line.strip()]
    mark = _MISSING.fullmatch(lines[0]) if lines else None
    header, *cells = csv.reader(lines[bool(mark) :] or [""])
    header = [name.strip() for name in header]
    if "time_s" not in header or not any(_CHANNEL.fullmatch(name) for name in header):
        raise InputError(
            f"{path} has no columns time_s (s) and F1-X1 …, which a bag needs. Give a generic CSV "
            "(`instobj docs recordings`)"
        )
    time = header.index("time_s")
    try:
        missing = float(mark[1]) if mark else math.nan
        # Decimal: a clock's stamp with 1 ns has more digits than a float
        stamps_ns = [round(Decimal(row[time].strip() or "nan") * _NS) for row in cells]
        rows = [
            [float(cell) if cell.strip() else math.nan for _, cell in zip(header, row, strict=True)]
            for row in cells
        ]
    except (ValueError, ArithmeticError, IndexError):
        raise InputError(
            f"{path} needs numbers in all cells, and stamps in time_s (s). Mend it"
        ) from None
    if min(stamps_ns, default=-1) < 0:
        raise InputError(f"{path} needs stamps from 0 on in a column time_s (s). Add them")
    for n, name in enumerate(header):
        if _CHANNEL.fullmatch(name) or name.endswith("_face"):  # as the generic format has it
            for row in rows:
                row[n] = math.nan if row[n] == missing else row[n]
    return header, stamps_ns, rows


def _write_folder(
    path: Path, header: list[str], stamps_ns: list[int], rows: list[list[float]]
) -> None:
    from rosbags import rosbag2

    store, time = _typestore(), header.index("time_s")
    channels = [n for n, name in enumerate(header) if name[:1] == "F"]
    labels = [n for n in range(len(header)) if n != time and n not in channels]
    layout, frame = (store.types[name] for name in MESSAGES)
    header_type, stamp_type = (
        store.types["std_msgs/msg/Header"],
        store.types["builtin_interfaces/msg/Time"],
    )
    mcap = rosbag2.StoragePlugin.MCAP
    with rosbag2.Writer(path, version=9, storage_plugin=mcap) as writer:
        topics = [
            writer.add_connection(topic, name, typestore=store)
            for topic, name in zip((LAYOUT, FRAMES), MESSAGES, strict=True)
        ]
        names = layout([header[n] for n in channels], [header[n] for n in labels])
        writer.write(topics[0], stamps_ns[0], _serialized(store, names))
        for stamp_ns, row in zip(stamps_ns, rows, strict=True):
            counts = [row[n] for n in channels]
            message = frame(
                header_type(stamp_type(*divmod(stamp_ns, _NS)), ""),
                np.array(counts),
                np.array([not math.isnan(count) for count in counts]),
                np.array([row[n] for n in labels]),
            )
            writer.write(topics[1], stamp_ns, _serialized(store, message))


def _serialized(store: Any, message: Any) -> bytes:
    return bytes(store.serialize_cdr(message, message.__msgtype__))


def _typestore() -> Any:
    from rosbags import typesys

    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    for name, text in MESSAGES.items():
        store.register(typesys.get_types_from_msg(text, name))
    return store


def _bag_rows(path: Path) -> Iterator[list[Any]]:
    from rosbags import rosbag2

    store = _typestore()
    try:
        with rosbag2.Reader(path) as bag:
            yield from _rows_of_messages(bag, store)
    except RecordingError:
        raise
    except Exception as error:  # a damaged file makes the library's parser fail in any way
        size = sum(part.stat().st_size for part in (path, *path.glob("*")) if part.is_file())
        raise RecordingError(
            f"it is no bag that can be read to its end: its {size} bytes are cut off, damaged, or of another "
            "format. Copy or record it again"
        ) from error


def _is_other_mcap(path: Path) -> bool:
    """Return whether a file is MCAP that ROS 2 did not write, by the profile of its header."""
    if path.suffix != ".mcap" or not path.is_file():
        return False
    with path.open("rb") as file:
        head = file.read(64)
    # mark, u8 length of the record, u4 length of the profile, profile
    length = int.from_bytes(head[17:21], "little")
    return head.startswith(_MCAP) and len(head) > 21 and head[21 : 21 + length] != b"ros2"


def _json_rows(path: Path) -> Iterator[list[Any]]:
    from mcap.exceptions import McapError
    from mcap.reader import make_reader

    topics: dict[str, str] = {}
    names: list[str] = []
    read_topic = None
    with path.open("rb") as file:
        try:
            for schema, channel, message in make_reader(file).iter_messages():
                topics[channel.topic] = (
                    f"{channel.message_encoding} {schema.name if schema else ''}"
                )
                values = json.loads(message.data) if channel.message_encoding == "json" else None
                if not isinstance(values, dict):
                    continue
                if read_topic is None and any(_CHANNEL.fullmatch(name) for name in values):
                    names = [name for name in values if name != "time_s"]
                    read_topic = channel.topic
                    yield ["time_s", *names]
                if channel.topic == read_topic:
                    stamp = values.get("time_s", Decimal(message.log_time) / _NS)
                    yield [stamp, *(values.get(name, "") for name in names)]
        except (McapError, ValueError) as error:
            raise RecordingError(
                f"it is no MCAP file that can be read to its end. Record it again ({error})"
            ) from None
    if read_topic is None:
        topic_list = ", ".join(
            f"{topic} ({kind.strip()})" for topic, kind in sorted(topics.items())
        )
        raise RecordingError(
            f"it has the topics {topic_list or 'none'}; counts are read from a json topic with fields "
            f"F1-X1 …, or from {LAYOUT} and {FRAMES} (`instobj docs recordings`). Export the topic with "
            "the counts as CSV, and give that to `instobj adopt`"
        )


def _rows_of_messages(bag: Any, store: Any) -> Iterator[list[Any]]:
    types = {connection.topic: connection.msgtype for connection in bag.connections}
    wanted = dict(zip((LAYOUT, FRAMES), MESSAGES, strict=True))
    if not wanted.items() <= types.items():
        topics = ", ".join(sorted(types)) or "none"
        raise RecordingError(
            f"it has the topics {topics}; a bag of an instrumented object has {LAYOUT} and {FRAMES} "
            "(`instobj docs recordings`). Export the topic with the counts as a CSV of one column a channel "
            "and give that in the bag's place"
        )
    width = None
    for connection, _, data in bag.messages():
        if connection.topic not in wanted:
            continue
        message = store.deserialize_cdr(data, connection.msgtype)
        if connection.topic == LAYOUT:
            if width is None:  # a second layout of the same bag is the same object's
                width = len(message.channels), len(message.labels)
                yield ["time_s", *message.channels, *message.labels]
            continue
        if width is None:
            raise RecordingError(
                f"frames come before their names ({LAYOUT}). Record the layout too"
            )
        if (len(message.counts), len(message.labels)) != width or len(message.valid) != width[0]:
            raise RecordingError(
                f"a frame has {len(message.counts)} counts where {width[0]} channels have names. "
                "Record one object a bag"
            )
        stamp = message.header.stamp
        yield [
            f"{stamp.sec}.{stamp.nanosec:09d}",
            *_cells(message.counts, message.valid),
            *_cells(message.labels, [True] * width[1]),
        ]


def _cells(values: Any, valid: Any) -> list[str]:
    """Return numbers as cells, empty where there is none."""
    return [
        f"{value:.17g}" if has_reading and not math.isnan(value) else ""
        for value, has_reading in zip(values, valid, strict=True)
    ]


def lerobot_features(channels: list[str]) -> dict[str, dict[str, Any]]:
    """Return the feature of a LeRobot data set that holds raw counts.

    Parameters
    ----------
    channels : list of str
        Names of the channels, such as F1-X1, in the order of the counts.

    Returns
    -------
    dict
        Name of the feature → its type, shape and names, for `LeRobotDataset.create`.

    Raises
    ------
    InputError
        A name that is no channel's.

    Examples
    --------
    >>> import instobj
    >>> instobj.robot.lerobot_features(["F1-X1", "F1-Y1"])["observation.hall_counts"]["shape"]
    (2,)
    """
    wrong = [name for name in channels if not _CHANNEL.fullmatch(name)]
    if wrong:
        raise InputError(f"{wrong[0]!r} is no channel. Give names such as F1-X1")
    return counts_feature(list(channels))
