"""Recordings that robots write: every count and stamp comes back, and what is missing is said."""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError, RecordingError
from estimator.adoption.text_table import read_text_table
from estimator.recordings.formats.files import read_signals, read_table
from estimator.recordings.formats.lerobot import HALL_COUNTS
from estimator.recordings.formats.robot import (
    MESSAGES,
    lerobot_features,
    robot_csv,
    write_bag,
    write_lerobot,
)
from tests.support.cli import run
from tests.support.recordings.generic_csv import write_generic_csv

rosbag2 = pytest.importorskip("rosbags.rosbag2")
MESSAGE_FOLDER = Path(__file__).parents[4] / "ros2" / "instobj_msgs" / "msg"


def same(a, b):
    assert_array_equal(np.round(a.time_s * 1e9), np.round(b.time_s * 1e9))
    for name in ("counts", "force_n", "face", "tip_xy_mm", "case", "declared_rest"):
        assert_array_equal(getattr(a, name), getattr(b, name), name)


def test_a_bag_holds_what_the_recording_holds_as_a_folder_and_as_one_file(table, tmp_path):
    write_generic_csv(table, tmp_path / "a.csv")
    write_bag(tmp_path / "a.csv", tmp_path / "bag")
    written = read_table(tmp_path / "a.csv")
    same(read_table(tmp_path / "bag"), written)
    (mcap,) = (tmp_path / "bag").glob("*.mcap")
    same(read_table(mcap), written)


def test_a_channel_without_a_reading_has_none_in_the_bag(tmp_path):
    (tmp_path / "a.csv").write_text("time_s,F1-X1,F1-Y1\n0.5,1,\n1.25,-7,3\n1.5,2,2\n")
    write_bag(tmp_path / "a.csv", tmp_path / "bag")
    time_s, counts = read_signals(tmp_path / "bag")
    assert time_s.tolist() == [0.5, 1.25, 1.5]
    assert_array_equal(counts[:, 0, 0, :2], [[1, np.nan], [-7, 3], [2, 2]])


def test_the_names_come_once_and_are_those_of_the_ros_package(tmp_path):
    (tmp_path / "a.csv").write_text("time_s,F1-X1\n0.5,1\n1.25,-7\n1.5,2\n")
    write_bag(tmp_path / "a.csv", tmp_path / "bag")
    with rosbag2.Reader(tmp_path / "bag") as bag:
        assert {c.topic: c.msgcount for c in bag.connections} == {
            "/instobj/layout": 1,
            "/instobj/frames": 3,
        }
    for name, text in MESSAGES.items():
        assert (MESSAGE_FOLDER / f"{name.rpartition('/')[2]}.msg").read_text() == text


def foreign_bag(path):
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_JAZZY)
    name = "std_msgs/msg/String"
    with rosbag2.Writer(path, version=9) as bag:
        topic = bag.add_connection("/chatter", name, typestore=store)
        bag.write(topic, 5, store.serialize_cdr(store.types[name]("hello"), name))


def test_a_foreign_bag_is_refused_with_its_topics(tmp_path):
    foreign_bag(tmp_path / "bag")
    with pytest.raises(RecordingError, match=r"/chatter.*/instobj/layout.*as a CSV") as refused:
        read_signals(tmp_path / "bag")
    assert "adopt" not in str(refused.value)  # which reads bags too, and would say the same again


@pytest.mark.parametrize("content", [b"", b"\x89MCAP0\r\n", b"no bag at all"])
def test_a_damaged_file_is_one_error(tmp_path, content):
    (tmp_path / "a.mcap").write_bytes(content)
    with pytest.raises(RecordingError, match="no bag that can be read") as refused:
        read_signals(tmp_path / "a.mcap")
    assert str(refused.value).endswith(
        f"its {len(content)} bytes are cut off, damaged, or of another format. Copy or record it again"
    )


def test_a_cut_bag_is_one_error(tmp_path):
    rows = "".join(f"{k / 10},{k},{-k}\n" for k in range(400))
    (tmp_path / "a.csv").write_text("time_s,F1-X1,F1-Y1\n" + rows)
    write_bag(tmp_path / "a.csv", tmp_path / "bag")
    (mcap,) = (tmp_path / "bag").glob("*.mcap")
    mcap.write_bytes(mcap.read_bytes()[:5000])
    with pytest.raises(RecordingError, match="no bag that can be read"):
        read_signals(tmp_path / "bag")


def test_a_bag_is_not_overwritten_and_needs_stamps(tmp_path):
    (tmp_path / "a.csv").write_text("time_s,F1-X1\n-1,1\n1.25,-7\n")
    with pytest.raises(InputError, match="stamps from 0"):
        write_bag(tmp_path / "a.csv", tmp_path / "bag")
    (tmp_path / "taken").mkdir()
    with pytest.raises(InputError, match="exists already"):
        write_bag(tmp_path / "a.csv", tmp_path / "taken")


def lerobot(folder, features, counts):
    """Two episodes in the layout of a LeRobot data set, version 3."""
    pyarrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    (folder / "meta").mkdir(parents=True)
    (folder / "data" / "chunk-000").mkdir(parents=True)
    info = {"codebase_version": "v3.0", "fps": 10, "features": features}
    (folder / "meta" / "info.json").write_text(json.dumps(info))
    half = len(counts) // 2
    columns = {
        "timestamp": np.tile(np.arange(half) / 10, 2).astype("float32"),
        "episode_index": np.repeat([0, 1], half),
        HALL_COUNTS: list(counts.astype("float32")),
    }
    target = folder / "data" / "chunk-000" / "file-000.parquet"
    parquet.write_table(pyarrow.table(columns), target)


@pytest.mark.parametrize("write", [write_bag, write_lerobot])
def test_a_binary_file_becomes_no_bag_with_one_error(tmp_path, write):
    """A data set of `run --to frames` ended in a traceback, and a byte-order mark hid the first column."""
    (tmp_path / "frames.nc").write_bytes(b"\x89HDF\r\n\x1a\n")
    with pytest.raises(InputError, match=r"frames\.nc is no text in UTF-8.*Give a generic CSV"):
        write(tmp_path / "frames.nc", tmp_path / "made")
    (tmp_path / "marked.csv").write_bytes(b"\xef\xbb\xbftime_s,F1-X1\n0.5,1\n1.25,-7\n")
    write(tmp_path / "marked.csv", tmp_path / "made")
    assert (tmp_path / "made").is_dir()


def test_a_lerobot_data_set_is_read_by_the_names_of_its_feature(tmp_path):
    counts = np.random.default_rng(0).integers(-3000, 3000, (40, 2))
    features = lerobot_features(["F2-X1", "F2-Z3"])
    assert features[HALL_COUNTS]["shape"] == (2,)
    lerobot(tmp_path / "set", features, counts)
    time_s, read = read_signals(tmp_path / "set")
    assert_array_equal(read[:, 1, 0, 0], counts[:, 0])
    assert_array_equal(read[:, 1, 2, 2], counts[:, 1])
    assert_array_equal(np.round(time_s, 6), np.tile(np.arange(20) / 10, 2))


def test_a_written_lerobot_data_set_holds_what_the_recording_holds(table, tmp_path):
    write_generic_csv(table, tmp_path / "a.csv")
    write_lerobot(tmp_path / "a.csv", tmp_path / "set")
    same(read_table(tmp_path / "set"), read_table(tmp_path / "a.csv"))


def test_a_written_lerobot_data_set_keeps_every_count_and_stamp(tmp_path):
    # stamps of a clock with 1 ns, the largest count of 24 bits, a gap, two sessions, an unknown label
    lines = [
        "1700000000.123456789,1,16777215,,0.25",
        "1700000000.223456788,1,-7,3,",
        "1700000001.000000001,2,2,2,1e-9",
    ]
    header = "time_s,session,F1-X1,F1-Y1,cell1_force_n"
    (tmp_path / "a.csv").write_text("\n".join([header, *lines]))
    done = run("recordings", "a.csv", "--out", "b.lerobot", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    read, *rows = robot_csv(tmp_path / "b.lerobot").decode().splitlines()
    order = [header.split(",").index(name) for name in read.split(",")]
    assert sorted(order) == list(range(5))
    for row, line in zip(rows, lines, strict=True):
        cells = line.split(",")
        stamp, *values = row.split(",")
        wanted_stamp, *wanted = [cells[n] for n in order]
        assert stamp == wanted_stamp
        numbers = [[float(cell or "nan") for cell in part] for part in (values, wanted)]
        assert_array_equal(*numbers)


def test_a_written_lerobot_data_set_has_the_layout_that_its_info_states(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    rows = "".join(f"{10 + k / 50},{1 + (k >= 30)},{k},{-k}\n" for k in range(50))
    (tmp_path / "a.csv").write_text("time_s,session,F1-X1,F2-Z3\n" + rows)
    write_lerobot(tmp_path / "a.csv", tmp_path / "set")
    meta = tmp_path / "set" / "meta"
    info = json.loads((meta / "info.json").read_text())
    assert (info["codebase_version"], info["fps"]) == ("v2.1", 50)
    assert (info["total_episodes"], info["total_frames"]) == (2, 50)
    assert info["features"][HALL_COUNTS]["names"] == ["F1-X1", "F2-Z3"]
    lengths = [json.loads(line)["length"] for line in (meta / "episodes.jsonl").open()]
    stats = [json.loads(line)["stats"] for line in (meta / "episodes_stats.jsonl").open()]
    assert lengths == [30, 20]
    assert stats[1][HALL_COUNTS]["min"] == [30, -49]
    assert stats[1][HALL_COUNTS]["mean"] == [39.5, -39.5]
    for episode, length in enumerate(lengths):
        path = info["data_path"].format(episode_chunk=0, episode_index=episode)
        frames = parquet.read_table(tmp_path / "set" / path)
        assert set(frames.column_names) == set(info["features"])
        assert frames["episode_index"].to_pylist() == [episode] * length
        assert_allclose(frames["timestamp"].to_numpy(), np.arange(length) / 50, atol=1e-4)
    with pytest.raises(InputError, match="exists already"):
        write_lerobot(tmp_path / "a.csv", tmp_path / "set")


def test_a_feature_of_no_channel_is_refused():
    with pytest.raises(InputError, match="'x' is no channel"):
        lerobot_features(["F1-X1", "x"])


def test_a_lerobot_data_set_without_counts_says_what_it_has(tmp_path):
    lerobot(tmp_path / "set", {"observation.state": {}}, np.zeros((4, 2)))
    with pytest.raises(RecordingError, match=r"observation\.state.*observation\.hall_counts"):
        read_signals(tmp_path / "set")


def test_an_error_names_its_file_once_wherever_it_is_raised(tmp_path):
    (tmp_path / "a.mcap").write_bytes(b"no bag at all")
    for read, path in (
        (read_table, tmp_path / "a.mcap"),
        (read_signals, tmp_path / "a.mcap"),
        (read_text_table, tmp_path / "a.mcap"),
        (read_text_table, tmp_path / "none.csv"),
    ):
        with pytest.raises(RecordingError) as error:
            read(path)
        assert str(error.value).count(str(path)) == 1


def test_one_mcap_file_holds_every_count_and_stamp_and_can_be_converted_again(tmp_path):
    # stamps of a clock with 1 ns, which no float has, the largest count of 24 bits, a gap
    stamps = ["1700000000.123456789", "1700000000.223456788", "1700000001.000000001"]
    cells = ["16777215,,1", "-7.25,3,0", "2.125,2,0"]
    rows = "".join(f"{stamp},{row}\n" for stamp, row in zip(stamps, cells, strict=True))
    (tmp_path / "a.csv").write_text("# missing = -7.25\ntime_s,F1-X1,F1-Y1,rest\n" + rows)
    assert run("recordings", "a.csv", "--out", "b.mcap", cwd=tmp_path).returncode == 0
    assert run("recordings", "b.mcap", "--out", "c.mcap", cwd=tmp_path).returncode == 0
    for name in ("b.mcap", "c.mcap"):
        header, *lines = robot_csv(tmp_path / name).decode().splitlines()
        assert header == "time_s,F1-X1,F1-Y1,rest"
        assert [line.partition(",")[0] for line in lines] == stamps
        assert [line.partition(",")[2] for line in lines] == ["16777215,,1", ",3,0", "2.125,2,0"]


@pytest.mark.parametrize(
    ("write", "name"), [(write_bag, "bag"), (write_bag, "b.mcap"), (write_lerobot, "b.lerobot")]
)
def test_six_faces_with_gaps_and_saturated_counts_come_back(tmp_path, write, name):
    channels = [f"F{f}-{axis}{n}" for f in range(1, 7) for n in range(1, 5) for axis in "XYZ"]
    rng = np.random.default_rng(3)
    cells = rng.integers(-32768, 32768, (40, len(channels))).astype(str)
    cells[rng.random(cells.shape) < 0.1] = ""  # readings that did not come
    cells[10:20, 5], cells[:, 7] = "32767", "-32768"  # at the ends of 16 bits
    # a clock that pauses for 10 s, and steps of 1 ns
    stamps = [f"{1_700_000_000 + k // 20 * 10}.{100_000_000 + k:09d}" for k in range(40)]
    lines = [",".join([stamp, *row]) for stamp, row in zip(stamps, cells.tolist(), strict=True)]
    (tmp_path / "a.csv").write_text("\n".join([",".join(["time_s", *channels]), *lines]))
    write(tmp_path / "a.csv", tmp_path / name)
    header, *rows = robot_csv(tmp_path / name).decode().splitlines()
    order = [header.split(",").index(column) for column in ["time_s", *channels]]
    assert [",".join(row.split(",")[n] for n in order) for row in rows] == lines


@pytest.mark.parametrize(
    ("files", "content", "said"),
    [
        (["a.csv"], "a,b\n1,2\n", "no columns time_s"),
        (["a.csv"], "", "no columns time_s"),
        (["a.csv"], "time_s,F1-X1\n0,word\n", "needs numbers"),
        (["a.csv"], "time_s,F1-X1\n0,1\n0.1\n", "needs numbers"),
        (["a.csv"], "# missing = word\ntime_s,F1-X1\n0,1\n", "needs numbers"),
        (["a.csv"], "F1-X1,time_s\n1,\n", "needs numbers"),
        (["a.csv", "a.csv"], "time_s,F1-X1\n0,1\n", "takes one recording"),
        (["none.csv"], "", "no recording at none.csv"),
    ],
)
def test_what_cannot_become_a_bag_is_one_error(tmp_path, files, content, said):
    (tmp_path / "a.csv").write_text(content)
    done = run("recordings", *files, "--out", "b.mcap", cwd=tmp_path)
    assert done.returncode == 2
    assert said in done.stderr
    assert not (tmp_path / "b.mcap").exists()


def write_mcap(path, profile, encoding, schema, messages, topic="/hall"):
    """An MCAP file of another program: one topic, (stamp in ns, bytes) each."""
    writer_of = pytest.importorskip("mcap.writer")
    with path.open("wb") as file:
        writer = writer_of.Writer(file)
        writer.start(profile=profile, library="other")
        known = writer.register_schema(*schema) if schema else 0
        channel = writer.register_channel(topic, encoding, known)
        for stamp_ns, data in messages:
            writer.add_message(channel, stamp_ns, data, stamp_ns)
        writer.finish()


@pytest.mark.parametrize("stamped", [True, False])
def test_json_of_another_program_is_read_where_fields_are_channels(tmp_path, stamped):
    stamps_ns = [1_700_000_000_123_456_789, 1_700_000_000_223_456_789, 1_700_000_000_323_456_789]
    messages = []
    for number, stamp_ns in enumerate(stamps_ns):
        values = {"F2-X1": 16777213 + number, "F2-Z3": -number} | (
            {"time_s": number / 8} if stamped else {}
        )
        messages.append((stamp_ns, json.dumps(values).encode()))
    write_mcap(tmp_path / "a.mcap", "", "json", ("hall", "jsonschema", b"{}"), messages)
    time_s, counts = read_signals(tmp_path / "a.mcap")
    assert_array_equal(counts[:, 1, 0, 0], [16777213, 16777214, 16777215])
    assert_array_equal(counts[:, 1, 2, 2], [0, -1, -2])
    expected = [0, 0.125, 0.25] if stamped else np.array(stamps_ns) / 1e9
    assert_allclose(time_s, expected, rtol=0, atol=5e-7)


@pytest.mark.parametrize(
    ("profile", "encoding", "schema", "data"),
    [
        ("", "json", None, b'{"values": [1, 2]}'),
        ("", "json", None, b"[1, 2]"),
        ("", "protobuf", ("my.Counts", "protobuf", b"\x0a"), b"\x08\x01"),
        ("ros1", "ros1", ("std_msgs/Int32MultiArray", "ros1msg", b"int32[] data"), b"\0\0\0\0"),
        ("ros2", "cdr", ("std_msgs/msg/Int32", "ros2msg", b"int32 data"), bytes(8)),
    ],
)
def test_other_topics_are_named_with_what_would_be_needed(
    tmp_path, profile, encoding, schema, data
):
    write_mcap(tmp_path / "a.mcap", profile, encoding, schema, [(5, data)])
    with pytest.raises(RecordingError, match=r"/hall.*/instobj/layout.*Export") as error:
        read_signals(tmp_path / "a.mcap")
    if profile != "ros2":
        assert f"/hall ({encoding}" in str(error.value)


def test_a_cut_file_of_another_program_is_one_error(tmp_path):
    messages = [(k, json.dumps({"F1-X1": k}).encode()) for k in range(400)]
    write_mcap(tmp_path / "a.mcap", "", "json", None, messages)
    whole = (tmp_path / "a.mcap").read_bytes()
    (tmp_path / "a.mcap").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(RecordingError, match="read to its end"):
        read_signals(tmp_path / "a.mcap")
