"""`instobj check --fabrication`: findings as JSON, table and picture; exit 1 where one fails."""

import json

import pytest
import trimesh
from typer.testing import CliRunner

import design.fabrication.check
from design.fabrication.check import Checked
from design.fabrication.finding import Finding
from instobj.cli.app import app
from instobj.render.findings import marked_parts
from tests.support.cli import assert_one_clear_error
from tests.support.cli import run as command_line


def finding(check, part, status, place=(1.0, 2.0, 3.0)):
    return Finding(check, part, 0.38, 0.8, "mm", status, "thicken it", place)


FINDINGS = [
    finding("draft", "shell", "warn"),
    finding("thinnest wall", "core", "fail", (4.0, -5.0, 6.0)),
    finding("closed surface", "core", "pass"),
    finding("clearance", "mould", "warn", None),
]


@pytest.fixture
def checked(monkeypatch, tmp_path):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    box = trimesh.creation.box((8, 10, 12))
    found = list(FINDINGS)
    monkeypatch.setattr(
        design.fabrication.check,
        "check_fabrication",
        lambda spec, progress: Checked(found, {"core": box, "shell": box}),
    )
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    return tmp_path, found


def run(folder, *more):
    arguments = ["check", str(folder / "cube.toml"), "--fabrication", "--out", str(folder), *more]
    return CliRunner().invoke(app, arguments)


def test_a_failure_ends_with_1_and_is_told_with_its_place(checked):
    folder, _ = checked
    done = run(folder, "--json")
    assert done.exit_code == 1
    result = json.loads(done.stdout)["fabrication"][0]
    assert result["status"] == "fail"
    assert result["findings"][1]["place_mm"] == [4.0, -5.0, 6.0]
    for name in ("fabrication.json", "fabrication.png"):
        assert (folder / "cad_out" / "cube" / name).is_file()
    shown = " ".join(run(folder).stdout.split())
    assert (
        "1 of 4 checks pass; stop: `build` refuses what fails (1); warnings alone stop nothing"
        in shown
    )
    assert "go on" not in shown
    assert "4.0, -5.0, 6.0" in shown


def test_warnings_alone_say_to_go_on(checked):
    folder, found = checked
    found[:] = [finding("draft", "shell", "warn"), finding("closed surface", "core", "pass")]
    done = run(folder)
    assert done.exit_code == 0
    shown = " ".join(done.stdout.split())
    assert "1 of 2 checks pass; go on: nothing fails; warnings alone stop nothing" in shown


def test_build_refuses_what_fabrication_fails_on_and_writes_nothing(checked):
    """`build` made parts, with exit code 0, of what `check --fabrication` fails on."""
    folder, _ = checked
    done = command_line("build", folder / "cube.toml", cwd=folder)
    assert_one_clear_error(done, "cube is not built", "core, thinnest wall: 0.38 mm", "thicken it")
    assert "draft" not in done.stderr, "warnings do not stop a build"
    assert not (folder / "cad_out").exists()


def test_parts_that_ask_for_the_same_are_told_in_one_sentence(checked):
    folder, found = checked
    found += [finding("draft", f"mould_pin_{number}", "warn") for number in (1, 2)]
    shown = " ".join(run(folder).stdout.split())
    assert shown.count(f"draft: {found[0].what}") == 1
    assert "warn: shell, mould_pin_1, mould_pin_2, draft: " in shown


def test_warnings_alone_end_with_0(checked):
    folder, found = checked
    del found[1]
    assert run(folder).exit_code == 0


def test_places_are_drawn_on_their_parts_failures_first():
    box = trimesh.creation.box((8, 10, 12))
    marked = marked_parts(FINDINGS, {"core": box, "shell": box})
    assert list(marked) == ["core", "shell"]
    assert [f.status for f in marked["core"]] == ["fail"]
