"""Contacts as channels of Foxglove: what an MCAP file and a live view hold."""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

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
    assert set(read) == {"/instobj/contacts", "/instobj/wrench", "/instobj/scene"}
    stamps = [time_ns for time_ns, _ in read["/instobj/contacts"]]
    assert stamps == [round(1e9 * frame["time_s"]) for frame in frames]
    assert [json.loads(data) for _, data in read["/instobj/contacts"]] == frames
    wrench = json.loads(read["/instobj/wrench"][0][1])
    assert_allclose(list(wrench["force"].values()), contact_wrench(SPEC, frames[0]["contacts"])[0])
    # the body comes with the first frame alone
    sizes = [len(data) for _, data in read["/instobj/scene"]]
    assert sizes[0] > 5 * max(sizes[1:])


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
