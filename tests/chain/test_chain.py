"""The whole chain on a small object, through the command that a user runs."""

import csv
import json
import re
import tomllib
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
import trimesh
import xarray as xr
from PIL import Image

from design.spec.object import ObjectSpec
from design.spec.search import SearchLimitsSpec, VarySpec
from design.spec_io import load_spec, parse_spec, spec_hash
from estimator.information.scores import score_places
from estimator.signals.presses import load_signals
from instobj.stages.run import WORTH_A_LINE_S
from instobj.stages.table import STAGES
from tests.support.browser import Browser, chromium
from tests.support.cli import assert_one_clear_error, run
from tests.support.markup import assert_short

ROOT = Path(__file__).parents[2]
SMALL = """
name = "small"
[body]
sensed_faces = [1, 3]
[mesh]
edge_mm = 8.0
surface_edge_mm = 3.0
rim_edge_ratio = 1
envelope_mm = 0.1
[contact_grid]
count = [4, 4]
pitch_mm = 7.0
[press]
depths_mm = [0.5, 1.0, 2.0, 3.0]
[protocol]
presses_per_place = 5
frames_per_press = [4, 16]
[inversion]
contacts = 3
"""
NETWORKS = [f"--set=training.{setting}"
            for setting in ("model=compact", "hidden_units=[64, 64]", "epochs=30")]  # fmt: skip
FACES = (1, 3)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("chain")
    (folder / "small.toml").write_text(SMALL)
    return folder


ON_REQUEST = {
    "plain_mesh",
    "plain_response",
    "plain_presses",
    "compliance",
    "candidates",
    "second_fidelity",
    "shear",
    "shear_scores",
    "identify",
    "collection",
    "pulled_collection",
    "fabrication",
    "sheet",
    "networks",
    "metrics",
}
"""Stages of commands beside `run`, which the report does without."""


@pytest.fixture(scope="module")
def first(folder):
    done = run("run", "small.toml", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    return done


def _document(done) -> dict:
    (result,) = json.loads(done.stdout)["objects"]
    return result


def test_run_works_through_every_stage_and_says_so(first):
    worked = [name for name in STAGES if name not in ON_REQUEST]
    assert sorted(row["stage"] for row in _document(first)["stages"]) == sorted(worked)
    for row in _document(first)["stages"]:
        if row["seconds"] >= WORTH_A_LINE_S:  # a log has lines for those that take their time
            assert STAGES[row["stage"]].title in first.stderr


def test_a_run_ends_with_five_findings_and_the_page_in_few_lines(folder, first):
    """The first run made everything, and told its progress; this one finds it stored."""
    done = run("run", "small.toml", cwd=folder)
    assert len([*first.stderr.splitlines(), *done.stdout.splitlines()]) <= 30
    names = [line.split(":")[0].strip() for line in done.stdout.splitlines()]
    at = names.index("judged on")
    assert names[at - 1] in ("GO", "NO-GO")
    # its mesh is coarser than the default, which is said next to what was judged
    assert names[at + 1 : at + 5] == ["mesh", "limited by", "edges", "what to change"]
    assert done.stdout.splitlines()[-1] == "open  runs/small/report.html"


def test_run_writes_the_files_of_the_contract(folder, first):
    written = {Path(row["path"]).as_posix() for row in _document(first)["files"]}
    parts = ("core", "shell", "mould_box", "mould_plug", "probe_1", "probe_2", "probe_3")
    expected = {f"cad_out/small/{part}.{kind}" for part in parts for kind in ("stl", "step")}
    expected |= {"cad_out/small/manifest.json"}
    expected |= {"runs/small/maps/delta_overview.png"}
    names = (
        "discretisation.json",
        "signals.nc",
        "scores.csv",
        "contacts.nc",
        "contact_metrics.json",
    )
    expected |= {f"runs/small/{name}" for name in (*names, "report.html")}
    assert expected <= written
    for path in written:
        assert (folder / path).stat().st_size > 0


def test_the_published_signals_give_the_published_bounds(folder, first):
    """Those at the contact locations alone cannot: borders came out 0.70 to 2.1 times as large."""
    run = folder / "runs/small"
    scores = score_places(
        load_spec(folder / "small.toml"), load_signals(run / "lattice_signals.nc")
    )
    with (run / "scores.csv").open() as file:
        published = [float(row["position_bound_mm"]) for row in csv.DictReader(file)]
    np.testing.assert_allclose(scores.position_bound_mm.ravel(), published, rtol=1e-4)


def test_the_shell_stl_has_the_closed_form_volume(folder, first):
    mesh = trimesh.load_mesh(folder / "cad_out/small/shell.stl")
    assert mesh.is_watertight
    np.testing.assert_allclose(mesh.volume, 42**3 - 26 * 26 * 34 - 10 * np.pi * 3**2 * 3, rtol=5e-4)


def test_the_manifest_carries_the_hash_of_the_whole_specification(folder, first):
    manifest = json.loads((folder / "cad_out/small/manifest.json").read_text())
    assert manifest["spec_hash"] == spec_hash(load_spec(folder / "small.toml"))


def test_signals_are_labelled_quantised_readings(folder, first):
    with xr.open_dataset(folder / "runs/small/signals.nc", engine="h5netcdf") as data:
        assert data["reading_counts"].dims == ("face", "place", "step", "sensor", "axis")
        assert tuple(data.face.values) == FACES
        assert dict(data.sizes) | {"face": 2, "place": 16, "step": 4, "sensor": 6} == dict(
            data.sizes
        )
        reading = data["reading_counts"].values
        expected = data["baseline_counts"].values + data["delta_counts"].values
    assert (reading == np.round(reading)).all()
    scatter = (reading - expected).std(axis=(0, 1, 2, 3))
    np.testing.assert_allclose(scatter, [22, 22, 11], rtol=0.1)


def test_networks_beat_the_linear_estimator(folder, first):
    done = run("train", "small.toml", *NETWORKS, "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert all((folder / f"runs/small/face_{face}.safetensors").exists() for face in FACES)
    summary = _document(done)["summary"]
    maps, errors = (
        next(rows for title, rows in summary.items() if words in title)
        for words in ("force maps of held-out", "simple regressions, held-out")
    )
    assert [row["face"] for row in maps] == list(FACES)
    for face in FACES:
        network, linear = (
            next(row for row in errors if (row["face"], row["estimator"]) == (face, name))
            for name in ("model", "ridge")
        )
        assert network["force %"] < linear["force %"]
        assert network["place mm"] < 0.5 * linear["place mm"]


def test_the_report_opens_with_the_verdict_and_stands_alone(folder, first):
    page = (folder / "runs/small/report.html").read_text()
    body = page[page.index("<body>") :]
    assert re.search(r'<h1>small\s<span class="(no-)?go">(NO-)?GO</span></h1>', body[:200])
    for title in ("Limiting figure", "What to change", "<b>Edges</b>: ", "Provenance"):
        assert title in page
    assert_short(page)
    assert not re.findall(r"""src=["'](?!data:)|<link|<script src|@import""", page)
    for link in re.findall(r"""href=["']([^"'#]+)""", page):
        assert (folder / "runs/small" / link).exists(), link


@pytest.fixture(scope="module")
def page(folder, first):
    """The report in a browser, once its view in three dimensions stands."""
    if chromium() is None:
        pytest.skip("no Chromium on this machine")
    with Browser() as browser:
        ready = 'document.querySelector(".viewer")?.dataset.ready === "yes"'
        browser.open(folder / "runs/small/report.html", ready)
        yield browser


NAMED = "document.querySelector('[data-name=\"{}\"]')"


def _shown(page, name):
    return page.ask(NAMED.format(name) + ".textContent")


def _canvas(page):
    """Left, top, right, lower end of the view in the window, scrolled to its middle."""
    canvas = NAMED.format("canvas")
    page.ask(f"{canvas}.scrollIntoView({{block: 'center'}})")
    box = f"(({{left, top, right, bottom}}) => [left, top, right, bottom])({canvas}.getBoundingClientRect())"
    left, top, right, bottom = page.ask(box)
    assert right - left > 300
    assert bottom - top > 300
    return left, top, right, bottom


def _body_after(page, key):
    """Pixels of the view once a key has moved the depth's slider."""
    page.ask(NAMED.format("depth") + ".focus()")
    page.press(key)
    page.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    box = _canvas(page)
    return np.asarray(Image.open(BytesIO(page.picture())).convert("RGB").crop(box), int)


def test_the_view_loads_without_a_complaint_or_a_request(page, folder):
    page.wait("performance.getEntriesByName('instobj objects shown').length === 1")
    assert page.problems() == []
    assert page.requests() == [(folder / "runs/small/report.html").as_uri()]


def test_a_click_on_the_body_tells_the_numbers_of_the_table(page, folder):
    before = _shown(page, "place")
    left, top, right, bottom = _canvas(page)
    page.click(left + 0.62 * (right - left), top + 0.58 * (bottom - top))
    place = _shown(page, "place")
    assert place != before
    face, x, y = map(float, re.fullmatch(r"face (\d) \((.*), (.*)\) mm", place).groups())
    assert face == 3
    signals = load_signals(folder / "runs/small/lattice_signals.nc")
    xy = signals.lattice.xy_mm
    (at,) = np.flatnonzero((xy == (x, y)).all(axis=1))
    _body_after(page, "End")
    assert _shown(page, "travel") == "3.00 mm"
    assert _shown(page, "force") == f"{signals.force_n[1, at, -1]:.2f} N"
    rows = page.ask(f"Array.from({NAMED.format('counts')}.rows, (r) => "
                    "Array.from(r.cells, (c) => Number(c.textContent)))")  # fmt: skip
    assert [row[:2] for row in rows] == [[f, k] for f in FACES for k in (1, 2, 3)]
    np.testing.assert_allclose(
        [row[2:] for row in rows], signals.delta_counts[1, at, -1], rtol=0, atol=0.6
    )


def test_the_slider_bends_the_silicone(page):
    """Pixels that are silicone before and after, and are lit otherwise: neither tip nor arrows."""
    page.ask(f"{NAMED.format('opacity')}.value = 100;"
             f"{NAMED.format('opacity')}.dispatchEvent(new Event('input'))")  # fmt: skip
    rest, pressed = _body_after(page, "Home"), _body_after(page, "End")
    silicone = [
        (one[..., 0] > one[..., 2] + 25) & (one[..., 1] > one[..., 2]) for one in (rest, pressed)
    ]
    changed = silicone[0] & silicone[1] & (abs(rest - pressed).max(axis=2) > 8)
    assert silicone[0].mean() > 0.05
    assert 0.002 < changed.sum() / silicone[0].sum() < 0.6


def test_a_second_run_reuses_everything(folder, first):
    again = _document(run("run", "small.toml", "--json", cwd=folder))
    assert all(row["reused"] for row in again["stages"])
    assert again["files"] == _document(first)["files"]


def test_a_change_of_a_sensor_reruns_no_mechanics(folder, first):
    done = run(
        "run", "small.toml", "--to", "presses", "--set", "sensors.radius_mm=8", "--json", cwd=folder
    )
    reused = {row["stage"]: row["reused"] for row in _document(done)["stages"]}
    mechanics = ("mesh", "response", "large_strain", "presses")
    mechanics += ("coarse_response", "discretisation")
    assert reused == dict.fromkeys(mechanics, True) | {"signals": False}


def test_a_data_set_of_the_run_trains_like_a_recorded_one(folder, first):
    arguments = ("evaluate", "runs/small/frames.nc", "--set", "training.epochs=3", "--json")
    done = run(*arguments, cwd=folder)
    assert done.returncode == 0, done.stderr
    (_, short), (title, rows) = list(_document(done)["summary"].items())[:2]
    assert short.keys() - {"holds for"} == {f"face {face}" for face in FACES}
    assert "held-out" in title
    assert {row["face"] for row in rows} == set(FACES)


INVERTS = ("--set", "training.model=inversion", "--set", "inversion.contacts=3")


def test_contacts_of_the_whole_object_are_found_by_inversion(folder, first):
    done = run("train", "small.toml", "--json", cwd=folder)  # of the report: nothing is made again
    assert all(row["reused"] for row in _document(done)["stages"])
    content = json.loads((folder / "runs/small/contact_metrics.json").read_text())
    assert content["judged"].endswith("turned and warmed since its zero")
    rows = content["contacts"]
    pressed = [row for row in rows if row["force"] == "from 4 N" and row["tips a face"] == 1]
    assert pressed[0]["number right %"] > 90
    assert pressed[0]["distance mm"] < 2.0
    assert rows[-1]["number right %"] > 98


@pytest.mark.slow
def test_contacts_of_a_data_set_are_found_by_inverting_its_twin(folder, first):
    (folder / "pressed").mkdir()
    data = folder / "pressed" / "frames.nc"
    data.write_bytes((folder / "runs/small/frames.nc").read_bytes())
    done = run("train", "pressed/frames.nc", "--twin", "small.toml", *INVERTS, "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    twin = json.loads((folder / "runs/pressed/calibration.json").read_text())
    assert {row["face"] for row in twin["faces"]} == set(FACES)
    judged = json.loads((folder / "runs/pressed/contact_metrics.json").read_text())["contacts"]
    held = next(row for row in judged if row["force"] == "from 4 N")
    jitter_mm = np.sqrt(np.pi / 2) * 0.3  # mean distance of the presses from their labels
    assert held["number right %"] > 98
    assert held["distance mm"] < 1.3 * np.hypot(held["bound mm"], jitter_mm)


def test_an_error_in_a_later_stage_keeps_earlier_results(folder, first):
    done = run("score", "small.toml", "--set", "sensors.range_mt=3", cwd=folder)
    assert_one_clear_error(done, "range")
    assert not list((folder / ".instobj").glob(".making-*"))
    reused = _document(run("run", "small.toml", "--to", "presses", "--json", cwd=folder))["stages"]
    assert all(row["reused"] for row in reused)


def test_the_example_is_the_template_and_the_defaults():
    example = ROOT / "examples" / "paper_cube.toml"
    template = (ROOT / "instobj/templates/cube.toml").read_text()
    named = tomllib.loads(template.replace("NAME", "paper_cube"))
    assert named == tomllib.loads(example.read_text())
    assert spec_hash(load_spec(example)) == spec_hash(ObjectSpec(name="paper_cube"))
    switched_on = tomllib.loads(re.sub(r"^# (?=\w+ = )", "", template, flags=re.MULTILINE))
    chosen = [("magnets", key) for key in ("grade", "part", "depth_mm", "tilt_deg", "north")]
    chosen += [("sensors", "positions_mm"), ("sensors", "rotations_deg"), ("core", "bay_mm")]
    chosen += [("body", "sensed_faces"), ("body", "file")]
    chosen += [("mould", k) for k in ("style", "parting_azimuth_deg")]
    chosen += [("indenter", "vertices_mm")]
    chosen += [("collection", "poses")]
    chosen += [("training", key) for key in ("history_frames", "ensemble", "trees", "process")]
    chosen += [("inversion", "model_error"), ("load_cell", "pins"), ("load_cell", "scale_n")]
    optional = {where: switched_on[where[0]].pop(where[1]) for where in chosen}
    search = switched_on.pop("search")
    for table, part in (("vary", VarySpec), ("limits", SearchLimitsSpec)):
        assert set(search[table]) == set(part.model_fields)
    assert parse_spec({"name": "all", "search": search}, "all lines").search.vary.magnet_count
    silicone = dict(switched_on["silicone"])
    for key in ("modulus_from", "layers", "prony"):
        del switched_on["silicone"][key]
    assert spec_hash(parse_spec(switched_on | {"name": "paper_cube"}, "all lines")) == spec_hash(
        ObjectSpec(name="paper_cube")
    )
    for (table, key), value in optional.items():
        switched_on[table][key] = value
    switched_on |= {"silicone": silicone, "search": search}
    written = {key: set(value) for key, value in switched_on.items() if isinstance(value, dict)}
    fields = ObjectSpec.model_fields
    for key, names in written.items():
        assert names == set(fields[key].annotation.model_fields)  # type: ignore[union-attr]
