"""`instobj predict` and `export` with an estimator that inverts the forward model."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from typer.testing import CliRunner

from design.errors import InputError
from estimator.frames.dataset import load_frames, save_frames
from estimator.inversion.storage import load_inversion, save_inversion
from estimator.recordings.boards.lines import encode_frame
from instobj.cli.app import app
from instobj.commands.predict import export_models
from instobj.commands.run import run_estimator
from tests.support.mechanics.inverted import SPEC, inverted, labelled_frames, noisy_counts
from tests.support.recordings.dummy_board import dummy_board

CHANNELS = tuple(
    f"F{face}-{axis}{chip}" for face in range(1, 6) for chip in (1, 2, 3) for axis in "XYZ"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The estimator, and frames of rest and of two contacts."""
    target = tmp_path_factory.mktemp("contacts")
    estimator, rng = inverted(), np.random.default_rng(3)
    save_inversion(estimator, target / "contacts.nc")
    face, contact = np.full((16, 6), -1), np.zeros((16, 6, 3))
    face[10:, :2], contact[10:, :2] = [2, 4], [[4.0, 4.0, 6.0], [-5.0, 3.0, 7.0]]
    counts = noisy_counts(estimator, face, contact, rng, turned=False)
    there = (face >= 0)[..., None]
    number = np.where(face >= 0, estimator.model.signals.faces[face], 0)
    placed = np.where(there, contact, np.nan)
    frames = labelled_frames(number, placed[..., :2], placed[..., 2])
    save_frames(replace(frames, signal_counts=counts.reshape(16, 5, 3, 3)), target / "grasp.nc")
    cell = ["cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm"]
    lines = [",".join(["time_s", *CHANNELS, *cell])]
    for row, values in enumerate(np.round(counts + 300)):
        lines.append(",".join([f"{row / 10}", *(f"{value:.0f}" for value in values), "0,,,"]))
    (target / "grasp.csv").write_text("\n".join(lines) + "\n")
    return target


def told(arguments):
    done = CliRunner().invoke(app, [*map(str, arguments), "--json"])
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def test_a_labelled_data_set_is_read_and_judged(folder):
    document = told(["predict", folder / "contacts.nc", folder / "grasp.nc", "--out", folder])
    summary, judged = document["tables"].values()
    assert (summary[0]["frames"], summary[0]["frames with contact"]) == (16, 6)
    assert [row["force"] for row in judged][-1] == "rest"
    assert judged[-1]["number right %"] == 100
    with (folder / "runs/grasp/contacts.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["contacts"] for row in rows[:10]] == ["0"] * 10
    assert rows[0]["face"] == ""
    pressed = [row for row in rows if int(row["frame"]) >= 10]
    assert sum(row["contacts"] == "2" for row in pressed) >= 10
    assert all(float(row["force_n"]) > 0 and row["explained"] == "1" for row in pressed)
    assert {row["chip_out"] for row in rows} == {""}
    assert all(abs(float(row[f"field_{axis}_ut"])) < 40 for row in rows for axis in "xyz")
    assert all(3 < float(row["field_sigma_ut"]) < 20 for row in rows)


def test_a_chip_that_lies_is_named_in_every_frame(folder, tmp_path):
    frames = load_frames(folder / "grasp.nc")
    counts = frames.signal_counts.copy()
    counts[:, 2, 0, 1] += 20_000.0
    save_frames(replace(frames, signal_counts=counts), tmp_path / "lying.nc")
    arguments = ["predict", folder / "contacts.nc", tmp_path / "lying.nc"]
    document = told([*arguments, "--out", tmp_path])
    (summary,) = next(iter(document["tables"].values()))
    assert summary["frames without a chip that was not believed"] == 16
    assert summary["frames that no contact explains"] == 0
    assert summary["condition of the object"] == "fine: read without F3-1: check its wires"
    with (tmp_path / "runs/lying/contacts.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert {row["chip_out"] for row in rows} == {"F3-1"}


def test_a_recording_is_zeroed_and_tracked(folder, tmp_path):
    arguments = ["predict", folder / "contacts.nc", folder / "grasp.csv", "--zero", "first"]
    document = told([*arguments, "--out", tmp_path])
    assert any("makes a data set of it, whose contacts" in text for text in document["texts"])
    with (tmp_path / "runs" / "grasp" / "contacts.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert rows[0]["frame"] == "8"
    assert {row["contacts"] for row in rows if int(row["frame"]) < 10} == {"0"}
    assert sum(row["contacts"] == "2" for row in rows if int(row["frame"]) >= 10) >= 8


def test_a_chip_that_a_whole_file_lacks_is_left_out(folder, tmp_path):
    """The grasp on faces 3 and 5 is read by the other chips."""
    with (folder / "grasp.csv").open() as file:
        header, *rows = csv.reader(file)
    kept = [k for k, name in enumerate(header) if not name.startswith("F1-") or name[4] != "3"]
    path = tmp_path / "less.csv"
    path.write_text("\n".join(",".join(row[k] for k in kept) for row in [header, *rows]) + "\n")
    arguments = ["predict", folder / "contacts.nc", path, "--zero", "first"]
    document = told([*arguments, "--out", tmp_path])
    assert any("no reading of F1-X3, F1-Y3, F1-Z3" in text for text in document["texts"])
    with (tmp_path / "runs" / "less" / "contacts.csv").open() as file:
        rows_of_contacts = list(csv.DictReader(file))
    assert sum(row["contacts"] == "2" for row in rows_of_contacts if int(row["frame"]) >= 10) >= 8


def sent_to(mcap):
    """Stamps (s) of every topic of an MCAP file, and the documents of its contacts."""
    reader, stamps, documents = pytest.importorskip("mcap.reader"), {}, []
    with mcap.open("rb") as file:
        for _, channel, message in reader.make_reader(file).iter_messages():
            stamps.setdefault(channel.topic, []).append(message.log_time / 1e9)
            if channel.topic == "/instobj/contacts":
                documents.append(json.loads(message.data))
    return stamps, documents


TOPICS = {
    *("/instobj/contacts", "/instobj/wrench", "/instobj/scene"),
    *(f"/instobj/heatmap_{face}" for face in range(1, 6)),
}


def test_a_recordings_contacts_go_to_foxglove_with_its_stamps(folder, tmp_path):
    mcap, arguments = tmp_path / "a.mcap", ["predict", folder / "contacts.nc", folder / "grasp.csv"]
    document = told([*arguments, "--zero", "first", "--out", mcap])
    assert {row["path"] for row in document["files"]} >= {str(mcap)}
    stamps, documents = sent_to(mcap)
    assert set(stamps) == TOPICS
    for sent in stamps.values():
        np.testing.assert_allclose(sent, np.arange(8, 16) / 10, atol=1e-9)
    with (tmp_path / "runs" / "grasp" / "contacts.csv").open() as file:
        rows = list(csv.DictReader(file))
    for frame in documents:
        tabled = [row for row in rows if int(row["frame"]) == frame["frame"] and row["face"]]
        assert [str(contact["face"]) for contact in frame["contacts"]] == [
            row["face"] for row in tabled
        ]


def test_a_boards_contacts_go_to_foxglove(folder, tmp_path):
    rng = np.random.default_rng(3)

    def lines(number):
        return encode_frame(number, 10 * number, rng.normal(300, 20, 45).round().tolist())

    arguments = ["predict", folder / "contacts.nc", "--zero", "first", "--frames", "20"]
    with dummy_board(lines, channels=CHANNELS) as port:
        arguments += ["--port", port, "--out", tmp_path / "board.mcap"]
        done = CliRunner().invoke(app, [*map(str, arguments)])
    assert done.exit_code == 0, done.output
    stamps, documents = sent_to(tmp_path / "board.mcap")
    assert set(stamps) == TOPICS
    assert documents == [json.loads(line) for line in done.stdout.splitlines()]
    assert len(documents) == 20


def test_a_chip_that_stands_still_makes_no_contacts_in_a_recording(folder, tmp_path):
    """62 frames at rest; it was believed, and ghosts were told in most of them."""
    rng = np.random.default_rng(7)
    face, contact = np.full((62, 6), -1), np.zeros((62, 6, 3))
    counts = np.round(300 + noisy_counts(inverted(), face, contact, rng, turned=False)).reshape(
        62, 5, 3, 3
    )
    counts[30:, 2, 1] = [700, -200, 600]
    rows = [
        f"{k / 10}," + ",".join(f"{v:.0f}" for v in one.ravel()) for k, one in enumerate(counts)
    ]
    path = tmp_path / "rest.csv"
    path.write_text("\n".join([",".join(["time_s", *CHANNELS]), *rows]) + "\n")
    arguments = ["predict", folder / "contacts.nc", path, "--zero", "first:20"]
    document = told([*arguments, "--out", tmp_path])
    assert any("standing still: F3-S2, rows 30–61" in text for text in document["texts"])
    with (tmp_path / "runs" / "rest" / "contacts.csv").open() as file:
        found = [int(row["contacts"]) for row in csv.DictReader(file)]
    assert len(found) == 42
    assert max(found) == 0


def test_a_board_tells_which_chip_it_leaves_out(folder):
    rng = np.random.default_rng(3)

    def lines(number):
        counts = 300 + rng.normal(0, 20, 45)
        counts[9:12] = 777
        return encode_frame(number, 10 * number, [float(round(value)) for value in counts])

    arguments = ["predict", folder / "contacts.nc", "--zero", "first", "--frames", "30"]
    with dummy_board(lines, channels=CHANNELS) as port:
        done = CliRunner().invoke(app, [*map(str, arguments), "--port", port])
    assert done.exit_code == 0, done.output
    last = json.loads(done.stdout.splitlines()[-1])
    assert last["left_out"].startswith("F2-S1: standing still")


def test_a_board_is_read_live(folder):
    rng = np.random.default_rng(2)
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, 0], contact[0, 0] = 2, [3.0, -2.0, 7.0]
    held = noisy_counts(inverted(), face, contact, rng, turned=False)[0]

    def lines(number):
        counts = (held if number % 60 >= 30 else 0 * held) + rng.normal(0, 5, 45)
        return encode_frame(number, 10 * number, [float(round(value)) for value in counts])

    arguments = ["predict", folder / "contacts.nc", "--zero", "none", "--frames", "45"]
    with dummy_board(lines, channels=CHANNELS) as port:
        done = CliRunner().invoke(app, [*map(str, arguments), "--port", port])
    assert done.exit_code == 0, done.output
    documents = [json.loads(line) for line in done.stdout.splitlines()]
    pressed = [one for one in documents if one["contacts"]]
    assert 5 <= len(pressed) <= 40
    assert {contact["face"] for one in pressed for contact in one["contacts"]} == {3}
    assert all(one["explained"] and one["lost_frames"] == 0 for one in documents)


def test_export_reads_it_once_and_copies_it(folder, tmp_path):
    export_models([folder], tmp_path)
    assert load_inversion(tmp_path / "contacts.nc").priors == inverted().priors
    damaged = tmp_path / "damaged.nc"
    content = bytearray((folder / "contacts.nc").read_bytes())
    content[len(content) // 2] ^= 0xFF
    damaged.write_bytes(content)
    done = CliRunner().invoke(app, ["train", "--export", str(damaged)])
    assert done.exit_code != 0
    assert "damaged" in str(done.exception)


def test_readings_of_another_object_are_refused(folder, tmp_path):
    nothing = np.full((2, 1), 0)
    frames = labelled_frames(nothing, np.full((2, 1, 2), np.nan), np.full((2, 1), np.nan))
    save_frames(replace(frames, signal_counts=np.zeros((2, 5, 2, 3))), tmp_path / "other.nc")
    done = CliRunner().invoke(
        app, ["predict", str(folder / "contacts.nc"), str(tmp_path / "other.nc")]
    )
    assert isinstance(done.exception, InputError)
    assert "2 sensors on faces" in str(done.exception)


def test_a_data_set_needs_the_objects_specification(folder, tmp_path):
    with pytest.raises(InputError, match="--twin SPEC"):
        run_estimator([folder / "grasp.nc"], ("networks",), tmp_path, ["training.model=inversion"])


def test_keys_of_the_inversion_are_checked():
    with pytest.raises(ValueError, match="contacts"):
        SPEC.inversion.changed(contacts=9)
    with pytest.raises(ValueError, match="model_error"):
        SPEC.inversion.changed(model_error=1.2)


def test_frames_that_nothing_explains_are_warned_of_once_with_their_share(folder, tmp_path):
    """A magnet beside the object: most frames are no contact; too short a file is named as such."""
    frames = load_frames(folder / "grasp.nc").select(np.repeat(np.arange(16), 2))
    save_frames(frames, tmp_path / "sound.nc")
    beside = np.random.default_rng(2).normal(0, 900, frames.signal_counts.shape[1:])
    spoilt = frames.signal_counts.copy()
    spoilt[4:] += beside
    save_frames(replace(frames, signal_counts=spoilt), tmp_path / "magnet.nc")
    texts = {
        name: told(["predict", folder / "contacts.nc", tmp_path / f"{name}.nc"])["texts"]
        for name in ("sound", "magnet")
    }
    assert texts["sound"] == []
    (warning,) = texts["magnet"]
    assert "of 32 frames" in warning
    assert "another object" in warning
    short = told(["predict", folder / "contacts.nc", folder / "grasp.nc"])["texts"]
    assert any("16 frames were read, too few" in text for text in short)
