"""`instobj assess`: from recordings to a ranking, a page and one clear error for what cannot be read."""

import base64
import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from design.catalogue.bus_parts import MOTION
from estimator.frames.dataset import load_frames, save_frames
from estimator.grasps.measures import conditions_of, measured_grasps
from estimator.grasps.ranking import compare, exchanged_share
from estimator.grasps.track import ContactTrack, track_of_labels
from estimator.inversion.storage import save_inversion
from estimator.recordings.reading import read_recording
from estimator.recordings.table import channel_name
from instobj.commands.assess.groups import (
    Group,
    MeasuredRecording,
    axis_of,
    difference_row,
    full_rows,
    grasp_rows,
    median_rows,
    whole_document,
    write_csv,
)
from instobj.commands.assess.sentences import difference_text
from instobj.commands.assess.tracks import ReadRecording, unexplained_share
from tests.estimator.grasps.grasps_by_hand import joined, squeeze
from tests.support.archives import unpack
from tests.support.browser import Browser, chromium
from tests.support.cli import run
from tests.support.mechanics.inverted import SPEC, inverted
from tests.support.recordings.handled import FORCE, handled
from tests.support.recordings.public_recordings import FOLDER, NAMES

GENTLE_N, ROUGH_N = (2.8, 3.0, 3.2, 3.1, 2.9, 3.0), (5.6, 6.0, 6.4, 5.8, 6.1, 5.9)
OUTPUT = ("--model", "model", "--json", "--out", "grasps.mcap")


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    """A model folder, and folders of a gentle and a rough gripper with one recording of the same name."""
    folder = tmp_path_factory.mktemp("assess")
    (folder / "model").mkdir()
    save_inversion(inverted(), folder / "model" / "contacts.nc")
    for name, peaks, seed in (("gentle", GENTLE_N, 1), ("rough", ROUGH_N, 2)):
        (folder / name).mkdir()
        save_frames(handled(peaks, seed)[0], folder / name / "day1.nc")
    return folder


@pytest.fixture(scope="module")
def ranked(bench):
    done = run("assess", "rough", "gentle", *OUTPUT, "--limit", "tomato", cwd=bench)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout), bench / "runs" / "rough+gentle" / "assess"


def test_the_gentle_gripper_is_ranked_first_in_a_sentence(ranked):
    document, _ = ranked
    (ranking, damage) = document["tables"]["ranking"]
    assert (ranking["sure"], ranking["test"]) == ("yes", "signed ranks of pairs")
    assert "tomato" in damage["measure"]
    assert any(
        text.startswith("gentle has a lower peak force than rough: by")
        for text in document["texts"]
    )
    assert any("Peak force is the sum over all jaws" in text for text in document["texts"])
    assert document["exchanged"] <= 0.08


def test_the_first_lines_answer_for_each_gripper(ranked):
    """Tomatoes break at some 6 N: three newtons are good, six are not."""
    document, folder = ranked
    rough, gentle = document["texts"][:2]
    assert rough.startswith("rough: not good (6 grasps, in the median), because chance of damage")
    assert gentle.startswith("gentle: good (6 grasps, in the median): friction needed")
    assert "Forces are known to ±" in gentle
    page = (folder / "assess.html").read_text()
    assert page.index("gentle: good") < page.index("<h2>")


def test_a_recording_that_the_estimator_was_trained_on_is_named(bench, tmp_path):
    (tmp_path / "model").mkdir()
    for name, seed in (("known.nc", 10), ("fresh.nc", 11)):
        save_frames(handled(GENTLE_N[:1], seed)[0], tmp_path / name)
    for source, target in (
        (bench / "model/contacts.nc", "contacts.nc"),
        (tmp_path / "known.nc", "frames.nc"),
    ):
        (tmp_path / "model" / target).write_bytes(source.read_bytes())
    done = run("assess", "known.nc", "fresh.nc", "--model", "model", "--json", cwd=tmp_path)
    document = json.loads(done.stdout)
    said = [text for text in document["texts"] if "was trained on this recording" in text]
    assert len(said) == 1
    assert said[0].startswith("known.nc")


def test_a_specification_of_another_body_is_refused(bench):
    (bench / "longer.toml").write_text('name = "longer"\nbody.size_mm = [60, 42, 42]\n')
    done = run("assess", "gentle", "--model", "model", "--spec", "longer.toml", cwd=bench)
    assert done.returncode == 2
    assert "has another body than the one that the inversion reads" in done.stderr


def test_forces_are_those_that_pressed(ranked):
    _, folder = ranked
    with (folder / "grasps.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["group"] for row in rows] == ["rough"] * 6 + ["gentle"] * 6
    true = 2 * np.array([*ROUGH_N, *GENTLE_N])
    for name, rtol in (("mean_n", 0.12), ("grasp_n", 0.25)):
        read = np.array([float(row[name]) for row in rows])
        np.testing.assert_allclose(read, true if name == "mean_n" else true / 2, rtol=rtol)
    # of a steady window, as wrong as the mean force and no more
    peak, mean = (np.array([float(row[name]) for row in rows]) for name in ("peak_n", "mean_n"))
    np.testing.assert_allclose(peak, true, rtol=0.12)
    assert np.all(peak >= mean)


def test_page_figure_and_document_are_written_and_agree(ranked):
    document, folder = ranked
    assert {path.name for path in folder.iterdir()} == {
        "assess.png", "assess.html", "assess.json", "grasps.csv",
    }  # fmt: skip
    page = (folder / "assess.html").read_text()
    assert "gentle has a lower peak force than rough" in page
    assert "Agriculture 13(12)" in page  # the limit's source stands on the page
    whole = json.loads((folder / "assess.json").read_text())
    assert len(whole["grasps"]) == 12
    assert np.array(whole["grasps"][0]["wrench_covariance"]).shape == (6, 6)
    assert whole["texts"] == document["texts"]


def test_the_page_plays_what_the_object_felt(ranked):
    """Contacts of every grasp on the skin: their normal forces add up to the peak that the table says."""
    _, folder = ranked
    page = (folder / "assess.html").read_text(encoding="utf-8")
    (packed,) = re.findall(r'id="grasps">([^<]+)<', page)
    content, arrays = unpack(base64.b64decode(packed))
    with (folder / "grasps.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(content["grasps"]) == len(rows)
    for grasp, row in zip(content["grasps"], rows, strict=True):
        assert grasp["name"] == f"{row['group']}, day1.nc, grasp {row['grasp']}"
        at = grasp["frames"][0] + grasp["peak"]
        some = slice(*arrays["first"][at : at + 2])
        normal_n = -np.sum(arrays["pull_n"][some] * arrays["normal"][some], axis=1)
        assert normal_n.sum() == pytest.approx(float(row["peak_n"]), rel=0.15)
        off_mm = np.abs(arrays["point_mm"][some]).max(axis=1) - max(SPEC.body.size_mm) / 2
        assert np.all(np.abs(off_mm) < 0.1)


@pytest.mark.skipif(chromium() is None, reason="no Chromium on this machine")
def test_a_grasp_is_chosen_and_played_in_a_browser(ranked):
    _, folder = ranked
    with Browser(1000, 700) as browser:
        browser.open(folder / "assess.html", "document.querySelector('.viewer')?.dataset.ready")
        felt = "document.querySelector('[data-name=felt]').textContent"
        assert "2 contacts" in browser.ask(felt)
        browser.ask("document.querySelector('[data-name=play]').click()")
        browser.wait(f"!{felt}.startsWith('0.00 s')")
        chosen = "const one = document.querySelector('[data-name=grasp]'); one.value = '7'"
        browser.ask(f"(() => {{ {chosen}; one.dispatchEvent(new Event('change')); }})()")
        assert browser.ask(felt).startswith("0.00 s")
        assert not browser.problems()


def test_what_cannot_be_said_is_said(ranked):
    texts = " ".join(ranked[0]["texts"])
    assert "The weight is not given" in texts
    assert "load cells lie in the 90 % interval" in texts
    assert "a blunt finger needs more force, so that damage is overstated" in texts
    # at most the two frames of fifteen in which jaws begin and end, at a fifth of the peak
    missed = float(re.search(r"and (\d+) % of the frames that they show pressed", texts)[1])
    assert missed <= 100 * np.mean(FORCE[FORCE > 0] < 0.3)


def test_frames_that_nothing_explains_count_where_no_contact_is_read():
    """Ten frames: two of a contact, one not explained with it, two without any contact."""
    face = np.zeros((10, 1), int)
    face[2:5] = 3
    explained = np.ones(10, bool)
    explained[4:7] = False
    nothing = np.full((10, 1, 5), np.nan)
    track = ContactTrack(
        np.arange(10) / 10,
        face,
        nothing[..., :2],
        nothing[..., :3],
        np.zeros((10, 1, 5, 5)),
        explained,
        np.zeros(10, bool),
    )
    assert unexplained_share([track]) == pytest.approx(3 / 5)
    assert unexplained_share([track.select(slice(0, 2))]) == 0


def test_what_is_not_known_of_flat_jaws_is_a_dash_empty_or_null_and_not_ranked(tmp_path):
    groups = []
    for name in ("tips", "jaws"):
        track = joined(*(squeeze(peak_n) for peak_n in (4.0, 5.0, 6.0)))
        track = replace(track, jaws=np.full(len(track), name == "jaws"))
        read = ReadRecording(tmp_path / name, track, None, "inversion", [], [], False, None)
        grasps = measured_grasps(track, conditions_of(SPEC))
        groups.append(Group(name, [MeasuredRecording(read, grasps, [])]))
    shown = [row[axis_of("pressure_mpa")] for row in grasp_rows(groups, ["pressure_mpa"])]
    assert "–" not in shown[:3]
    assert shown[3:] == ["–"] * 3
    (medians,) = median_rows(groups, ["pressure_mpa"])
    assert medians["jaws"] == "–"
    with write_csv(tmp_path / "grasps.csv", full_rows(groups)).open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for name in ("depth_mm", "pressure_mpa", "energy_mj"):
        assert all(float(row[name]) > 0 for row in rows[:3])
        assert {row[name] + row[f"{name}_low"] for row in rows[3:]} == {""}
        written = json.loads(json.dumps(whole_document({}, groups), allow_nan=False))["grasps"]
        assert [row[name] is None for row in written] == [False] * 3 + [True] * 3
        values = {group.name: group.values(name) for group in groups}
        for paired in (False, True):
            (difference,) = compare(values, paired)
            assert "cannot be ranked" in difference_text(difference, name)
            assert difference_row(difference)["sure"] == "no"


def test_contacts_of_all_recordings_go_to_one_mcap_file(bench, ranked):
    mcap = pytest.importorskip("mcap.reader")
    files = {row["path"].rpartition("/")[2] for row in ranked[0]["files"]}
    assert {"assess.html", "grasps.mcap"} <= files
    with (bench / "grasps.mcap").open("rb") as file:
        sent = [
            (channel.topic, message.log_time, json.loads(message.data))
            for _, channel, message in mcap.make_reader(file).iter_messages()
            if channel.topic.endswith("/contacts")
        ]
    for name in ("rough", "gentle"):
        frames = load_frames(bench / name / "day1.nc")
        stamps = [stamp for topic, stamp, _ in sent if topic == f"/{name}/day1.nc/contacts"]
        assert sorted(stamps) == sorted(round(1e9 * t) for t in frames.time_s)
    strongest = max(sum(c["force_n"] for c in frame["contacts"]) for _, _, frame in sent)
    assert strongest == pytest.approx(2 * max(ROUGH_N), rel=0.2)
    again = run("assess", "rough", "gentle", *OUTPUT, cwd=bench)
    assert again.returncode == 2
    assert "grasps.mcap exists already" in again.stderr


def test_a_gripper_against_itself_is_not_ranked(bench):
    done = run("assess", "gentle/day1.nc", "gentle2.nc", "--model", "model", "--json", cwd=bench)
    assert done.returncode == 2
    save_frames(handled(GENTLE_N[::-1], 7)[0], bench / "gentle2.nc")
    done = run("assess", "gentle/day1.nc", "gentle2.nc", "--model", "model", "--json", cwd=bench)
    document = json.loads(done.stdout)
    (ranking,) = document["tables"]["ranking"]
    assert (ranking["sure"], ranking["test"]) == ("no", "rank sums")
    assert any("cannot be ranked by peak force" in text for text in document["texts"])
    # without a limit a good grasp is a safe and steady one, and says so
    assert all(": good (6 grasps" in text for text in document["verdicts"])
    assert all(text.endswith("no limit is given (--limit).") for text in document["verdicts"])


def raw_csv(path, counts, cells=False, blank=None, motion=None):
    """A board's recording of counts, with an idle load cell or without any, with an IMU or without."""
    names = [channel_name(*index) for index in np.ndindex(5, 3, 3)]
    cell = ["cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm"] * cells
    imu = [] if motion is None else MOTION
    lines = [",".join(["time_s", *names, *cell, *imu])]
    for row, values in enumerate(np.round(counts + 300)):
        read = ["" if index == blank else f"{value:.0f}" for index, value in enumerate(values)]
        moved = [] if motion is None else [f"{value}" for value in motion[row]]
        lines.append(",".join([f"{row / 10}", *read, *(["0", "", "", ""] * cells), *moved]))
    path.write_text("\n".join(lines) + "\n")


def test_a_recording_that_still_grows_is_read_as_far_as_it_goes(bench):
    """Frames are written line by line: at first one grasp is over, then a second is held."""
    _, counts = handled(GENTLE_N[:2], 3)
    quiet = np.random.default_rng(4).normal(0, 15, (40, counts.shape[1]))
    path = bench / "growing.csv"
    raw_csv(path, np.concatenate([quiet, counts]))
    lines = path.read_text().splitlines(keepends=True)
    for grasps, rows in ((1, 41 + len(FORCE)), (2, 41 + len(FORCE) + 12)):
        path.write_text("".join(lines[:rows]))
        done = run("assess", path, "--model", "model", "--json", cwd=bench)
        document = json.loads(done.stdout)
        table = document["tables"]["grasps"]
        assert [row["grasp"] for row in table] == list(range(1, grasps + 1))
        assert not any("load cells and labels" in text for text in document["texts"])


def test_a_boards_recording_without_presses_on_load_cells_is_read_with_the_jolts_of_its_imu(bench):
    """The second grasp is hit by 30 m/s² in its hold."""
    _, counts = handled(GENTLE_N[:2], 3)
    quiet = np.random.default_rng(4).normal(0, 15, (40, counts.shape[1]))
    motion = np.tile([0.0, 0.0, 9.80665, 0.0, 0.0, 0.0], (40 + len(counts), 1))
    motion[40 + len(FORCE) + 12, 2] += 30.0
    raw_csv(bench / "moved.csv", np.concatenate([quiet, counts]), cells=True, motion=motion)
    done = run("assess", "moved.csv", "--model", "model", "--json", cwd=bench)
    document = json.loads(done.stdout)
    assert [row["grasp"] for row in document["tables"]["grasps"]] == [1, 2]
    assert any("few grasps (2)" in text for text in document["texts"])
    assert any("load cells and labels are not used" in text for text in document["texts"])
    assert any("IMU: hardest jolt 30.0 m/s² beyond gravity" in text for text in document["texts"])
    with (bench / "runs/moved/assess/grasps.csv").open() as file:
        jolts = [float(row["jolt_m_s2"]) for row in csv.DictReader(file)]
    assert jolts == pytest.approx([0.0, 30.0], abs=0.1)


def test_a_channel_without_readings_is_left_out(bench):
    frames, _ = handled(GENTLE_N[:2], 5)
    frames.signal_counts[:, 1, 2] = np.nan
    save_frames(frames, bench / "dead.nc")
    done = run("assess", "dead.nc", "--model", "model", "--json", cwd=bench)
    assert len(json.loads(done.stdout)["tables"]["grasps"]) == 2


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["gentle", "--protocol", "juggling"], "handling, grasp-strength"),
        (["gentle", "--model", "nowhere"], "nowhere"),
        (["gentle", "--model", "gentle"], "holds no estimator"),
        (["gentle", "--limit", "durian"], "apple"),
        (["model"], "holds no recording"),
        (["nowhere.csv"], "no recording at nowhere.csv"),
        (["gentle", "gentle"], "given twice"),
        (["rest.nc"], "no grasp in rest.nc"),
        (["empty.csv"], "empty.csv"),
        (["text.csv"], "text.csv"),
        (["nan.nc"], "nan.nc"),
        (["gentle", "--spec", "nowhere.toml"], "nowhere.toml"),
    ],
)
def test_bad_input_is_one_clear_error(bench, arguments, said):
    rest = load_frames(bench / "gentle" / "day1.nc").select(np.arange(4))
    save_frames(rest, bench / "rest.nc")
    silent = load_frames(bench / "gentle" / "day1.nc")
    silent.signal_counts[:] = np.nan
    save_frames(silent, bench / "nan.nc")
    (bench / "empty.csv").write_text("")
    (bench / "text.csv").write_text("a,b\nc,d\n")
    model = [] if "--model" in arguments else ["--model", "model"]
    done = run("assess", *arguments, *model, cwd=bench)
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("error:") == 1
    assert "Traceback" not in done.stderr


def test_places_at_risk_are_of_peaks_that_are_explained(bench):
    """A magnet beside one gripper: nothing explains its frames, and the page says what it leaves out."""
    save_frames(handled(ROUGH_N[:2], 12)[0], bench / "firm.nc")
    frames, _ = handled(GENTLE_N[:1], 8)
    pressed = np.any(frames.contact_face > 0, axis=1)
    beside = np.random.default_rng(9).normal(0, 600, frames.signal_counts.shape[1:])
    frames.signal_counts[pressed] += beside
    save_frames(frames, bench / "magnet.nc")
    arguments = ("--model", "model", "--limit", "tomato", "--json")
    done = run("assess", "firm.nc", "magnet.nc", *arguments, cwd=bench)
    document = json.loads(done.stdout)
    at_risk = document["tables"]["places most at risk"]
    assert {row["group"] for row in at_risk} == {"firm"}
    # its figures are withheld, and its answer says why
    (answer,) = (text for text in document["texts"] if text.startswith("magnet: "))
    assert answer.startswith("magnet: cannot be said, because the estimator does not explain")
    assert "Calibrate" in answer
    assert {row["group"] for row in document["tables"]["grasps"]} == {"firm"}
    with (bench / "runs" / "firm+magnet" / "assess" / "grasps.csv").open() as file:
        withheld = [row for row in csv.DictReader(file) if row["group"] == "magnet"]
    assert {row["peak_n"] for row in withheld} == {""}
    assert all(float(row["unexplained"]) > 0.5 for row in withheld)
    assert any("leave out 1 of 3 grasps" in text for text in document["texts"])


PUBLIC = [FOLDER / name for name in NAMES]
needs_recordings = pytest.mark.skipif(
    not all(path.is_file() for path in PUBLIC), reason=f"public recordings are not in {FOLDER}"
)


@pytest.fixture(scope="module")
def public_grasps():
    """Grasps of both recordings by their load cells and labels."""
    conditions = conditions_of(SPEC)
    return [
        measured_grasps(track_of_labels(read_recording(path).frames), conditions) for path in PUBLIC
    ]


@needs_recordings
def test_grasps_of_the_public_recordings_are_found_and_their_jaws_balance(public_grasps):
    one, two = public_grasps
    assert (len(one), len(two)) == (25, 17)  # presses that the reader counts by its own rules
    for grasp in (*one, *two):
        assert grasp.opposed
        # two load cells of one gripper: alike within their gain and the object's weight
        assert abs(grasp.readings["asymmetry"].value) < 0.08
        assert grasp.readings["regrasps"].value == 0


@needs_recordings
def test_exchanged_jaws_of_the_public_recordings_are_not_ranked(public_grasps):
    grasps = [grasp for recording in public_grasps for grasp in recording]
    jaws = {
        f"face {face}": np.array([grasp.faces[face][0].value for grasp in grasps])
        for face in (3, 5)
    }
    assert exchanged_share(jaws, paired=True, draws=300) <= 0.08
    files = {
        path.name: np.array([g.readings["peak_n"].value for g in found])
        for path, found in zip(PUBLIC, public_grasps, strict=True)
    }
    assert exchanged_share(files, draws=300) <= 0.08
