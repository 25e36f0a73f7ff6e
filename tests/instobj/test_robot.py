"""Contacts as channels of Foxglove: what an MCAP file and a live view hold."""

import json
import struct
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.layout.body import face_frame
from design.spec_io import load_spec
from instobj.robot import contact_wrench, foxglove_channels, is_foxglove

foxglove = pytest.importorskip("foxglove")
SPEC = load_spec(Path(__file__).parents[2] / "examples" / "paper_cube.toml")


def contact(face, x_mm, y_mm, force_n, **more):
    return {"face": face, "x_mm": x_mm, "y_mm": y_mm, "force_n": force_n} | more


def test_opposite_jaws_cancel_and_an_offset_gives_its_torque():
    jaws = [contact(2, 0.0, 0.0, 5.0), contact(4, 0.0, 0.0, 5.0)]
    force_n, torque_nm = contact_wrench(SPEC, jaws)
    assert_allclose(force_n, 0, atol=1e-12)
    assert_allclose(torque_nm, 0, atol=1e-12)
    frame = face_frame(SPEC, 1)
    force_n, torque_nm = contact_wrench(SPEC, [contact(1, 10.0, 0.0, 4.0)])
    assert_allclose(force_n, -4 * frame.normal, atol=1e-12)
    # a push of 4 N along −n, 10 mm along x from the axis: 0.01 · 4 (x × −n)
    assert_allclose(torque_nm, 0.04 * np.cross(frame.x, -frame.normal), atol=1e-12)


def test_a_tangential_force_counts_along_the_face():
    frame = face_frame(SPEC, 3)
    pulled = contact(3, 0.0, 0.0, 2.0, tangential_x_n=0.5, tangential_y_n=-1.0)
    force_n, _ = contact_wrench(SPEC, [pulled])
    assert_allclose(force_n, 0.5 * frame.x - frame.y - 2 * frame.normal, atol=1e-12)


def test_an_mcap_file_holds_every_frame_with_its_stamp(tmp_path):
    frames = [
        {"frame": k, "time_s": 1.0 + k / 8, "contacts": [contact(1, k / 10, 2.0, 3.0)]}
        for k in range(5)
    ]
    with foxglove_channels(tmp_path / "a.mcap", SPEC) as send:
        for frame in frames:
            send(frame)
    read = messages(tmp_path / "a.mcap")
    heatmaps = {f"/instobj/heatmap_{face}" for face in range(1, 6)}
    assert set(read) == {"/instobj/contacts", "/instobj/wrench", "/instobj/scene"} | heatmaps
    stamps = [time_ns for time_ns, _ in read["/instobj/contacts"]]
    assert stamps == [round(1e9 * frame["time_s"]) for frame in frames]
    assert [json.loads(data) for _, data in read["/instobj/contacts"]] == frames
    wrench = json.loads(read["/instobj/wrench"][0][1])
    assert_allclose(list(wrench["force"].values()), contact_wrench(SPEC, frames[0]["contacts"])[0])
    # the body comes with the first frame alone
    sizes = [len(data) for _, data in read["/instobj/scene"]]
    assert sizes[0] > 5 * max(sizes[1:])


def test_a_heatmap_holds_the_force_where_its_cell_lies_in_the_object(tmp_path):
    pressed = [contact(3, 4.6, -7.4, 2.0), contact(3, 4.4, -7.6, 1.5), contact(1, 0.0, 0.0, 9.0)]
    with foxglove_channels(tmp_path / "a.mcap", SPEC) as send:
        send({"time_s": 0.0, "contacts": pressed})
    ((_, data),) = messages(tmp_path / "a.mcap")["/instobj/heatmap_3"]
    cells, grid = decoded_grid(data)
    assert cells.sum() == pytest.approx(3.5)
    row, column = np.unravel_index(cells.argmax(), cells.shape)
    assert cells[row, column] == pytest.approx(3.5)
    # the cell's middle, by the grid's own pose and cell size, is the location (4.5, −7.5) of face 3
    middle = np.array([column + 0.5, row + 0.5, 0]) * np.append(grid.cell_m, 0)
    place_m = grid.position_m + grid.rotation.apply(middle)
    expected_mm = face_frame(SPEC, 3).to_object(np.array([4.5, -7.5, 0.0]))
    assert_allclose(1e3 * place_m, expected_mm, atol=1e-6)


def test_scene_and_heatmaps_have_schemas_that_foxglove_brings(tmp_path):
    with foxglove_channels(tmp_path / "a.mcap", SPEC) as send:
        send({"time_s": 0.0, "contacts": []})
    from mcap.reader import make_reader

    with (tmp_path / "a.mcap").open("rb") as file:
        summary = make_reader(file).get_summary()
    channels = summary.channels.values()
    named = {
        c.topic: summary.schemas[c.schema_id].name
        for c in channels
        if "json" not in c.message_encoding
    }
    assert named.pop("/instobj/scene") == "foxglove.SceneUpdate"
    assert set(named) == {f"/instobj/heatmap_{face}" for face in range(1, 6)}
    assert set(named.values()) == {"foxglove.Grid"}
    others = {summary.schemas[c.schema_id].encoding for c in channels if c.topic not in named}
    assert others <= {"jsonschema", "protobuf"}  # which Foxglove shows by itself


def test_a_frame_without_a_stamp_is_refused(tmp_path):
    with (
        pytest.raises(InputError, match=r"a\.mcap needs stamps"),
        foxglove_channels(tmp_path / "a.mcap", SPEC) as send,
    ):
        send({"time_s": float("nan"), "contacts": []})


def decoded_grid(data):
    """Cells, and pose and size of a cell, of a message foxglove.Grid, by its public numbers of fields
    (protobuf: 3 pose, 4 columns, 5 size of a cell, 9 data)."""
    fields = protobuf_fields(data)
    pose, cell = protobuf_fields(fields[3]), protobuf_fields(fields[5])
    position, turn = protobuf_fields(pose[1]), protobuf_fields(pose[2])
    (columns,) = struct.unpack("<I", fields[4])
    quaternion = [double(turn, k) for k in (1, 2, 3, 4)]
    return np.frombuffer(fields[9], "<f4").reshape(-1, columns), SimpleNamespace(
        position_m=np.array([double(position, k) for k in (1, 2, 3)]),
        rotation=Rotation.from_quat(quaternion),
        cell_m=np.array([double(cell, k) for k in (1, 2)]),
    )


def double(fields, number):
    """A number, 0 where protobuf leaves it out."""
    return struct.unpack("<d", fields.get(number, bytes(8)))[0]


def protobuf_fields(data):
    """Bytes of each field of a protobuf message, by number; the last where one is repeated."""
    fields, at = {}, 0

    def varint():
        nonlocal at
        value = shift = 0
        while True:
            byte = data[at]
            at += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    while at < len(data):
        key = varint()
        length = {1: 8, 5: 4}.get(key & 7)
        if key & 7 == 0:
            fields[key >> 3] = struct.pack("<Q", varint())
            continue
        length = varint() if length is None else length
        fields[key >> 3] = data[at : at + length]
        at += length
    return fields


def messages(path):
    """Stamp (ns) and content of each message, by topic."""
    from mcap.reader import make_reader

    read = {}
    with path.open("rb") as file:
        for _, channel, message in make_reader(file).iter_messages():
            read.setdefault(channel.topic, []).append((message.log_time, message.data))
    return read


def test_a_live_view_listens_on_the_loopback_alone_and_a_taken_port_is_one_error():
    with foxglove_channels(Path("foxglove:8799"), SPEC) as send:
        send({"frame": 0, "time_s": 0.0, "contacts": []})
        table = Path("/proc/net/tcp").read_text()
        listening = [line.split()[1] for line in table.splitlines()[1:] if line.split()[3] == "0A"]
        assert f"0100007F:{8799:04X}" in listening
        assert f"00000000:{8799:04X}" not in listening
        with (
            pytest.raises(InputError, match="foxglove:8799"),
            foxglove_channels(Path("foxglove:8799"), SPEC),
        ):
            pass


@pytest.mark.parametrize(
    ("target", "shown"),
    [
        ("a.mcap", True),
        ("foxglove", True),
        ("foxglove:9000", True),
        ("out", False),
        ("foxglove:x", False),
    ],
)
def test_targets_of_foxglove(target, shown):
    assert is_foxglove(Path(target)) is shown


def test_a_port_that_is_none_is_named_before_any_work():
    with pytest.raises(InputError, match=r"foxglove:70000.* 65535"):
        is_foxglove(Path("foxglove:70000"))
