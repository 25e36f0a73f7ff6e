"""The command line as a user meets it: help, errors, interruption."""

import ast
import json
import os
import re
import signal
import subprocess
import sys
import time
from importlib.metadata import version
from pathlib import Path

import pytest
import tomli_w
from typer.main import get_command

from design.processes import ONE_THREAD
from instobj.cli.app import app
from instobj.cli.renamed import OPTIONS
from tests.support.cli import CUBE, assert_one_clear_error, run, run_apart
from tests.support.objects.body_cases import BODIES, CORE, GRID, ONE

ROOT = Path(__file__).parents[3]
PACKAGES = ("design", "fem", "estimator", "instobj")


def test_help_names_every_command_and_starts_quickly(tmp_path):
    started = time.perf_counter()
    done = run_apart("--help", cwd=tmp_path)
    assert done.returncode == 0
    for command in [
        "new",
        "check",
        "build",
        "score",
        "run",
        "optimize",
        "train",
        "recordings",
        "bench",
    ]:
        assert command in done.stdout
    assert time.perf_counter() - started < 5


@pytest.mark.parametrize(
    ("asked", "found"),
    [
        ({}, "{1}"),
        pytest.param(dict.fromkeys(ONE_THREAD, "2"), "{2}", marks=pytest.mark.slow),
    ],
)
def test_libraries_take_one_thread_unless_the_user_asks_for_more(asked, found):
    """As the command's own process finds them, once it has answered."""
    program = (
        "import sys; from instobj.cli.app import main; sys.argv = ['instobj', '--help']\n"
        "assert not {'numpy', 'torch'} & sys.modules.keys()\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "import scipy.linalg, threadpoolctl, torch\n"
        "found = {one['num_threads'] for one in threadpoolctl.threadpool_info()}\n"
        "print(found | {torch.get_num_threads()})"
    )
    bare = {name: value for name, value in os.environ.items() if name not in ONE_THREAD}
    done = subprocess.run(
        [sys.executable, "-c", program], env=bare | asked, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == found


def test_new_writes_a_specification_that_check_accepts(tmp_path):
    assert run("new", "my_object", cwd=tmp_path).returncode == 0
    done = run("check", "my_object.toml", "--json", cwd=tmp_path)
    (row,) = json.loads(done.stdout)["specifications"]
    assert (row["name"], row["magnets"], row["sensors"]) == ("my_object", 25, 15)
    assert_one_clear_error(run("new", "my_object", cwd=tmp_path), "already there")


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("shell.thicknes_mm=8", ("thickness_mm",)),
        ("shell.thickness_mm=-8", ("greater than or equal to 0.3", "-8")),
        ("magnets.positions_mm=[[0,0],[4,0]]", ("overlap",)),
        ("name=../evil", ("name",)),
        ("shell", ("key=value",)),
        ("sensors.range_mt=3", ("range",)),
    ],
)
def test_bad_specifications_end_with_one_clear_error(tmp_path, override, words):
    assert_one_clear_error(run("check", CUBE, "--set", override, cwd=tmp_path), *words)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("content", "word"),
    [(None, "no specification"), ("name = ", "TOML"), (b"\xff\xfe\x00", "text"), ("", "name")],
)
def test_bad_files_end_with_one_clear_error(tmp_path, content, word):
    path = tmp_path / "spec.toml"
    if content is not None:
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    assert_one_clear_error(run("run", path, cwd=tmp_path), word)


def test_json_errors_are_json(tmp_path):
    done = run("check", "missing.toml", "--json", cwd=tmp_path)
    assert done.returncode == 2
    assert "missing.toml" in json.loads(done.stdout)["error"]


def test_unwritable_output_is_refused_before_any_work(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    done = run("run", CUBE, "--out", blocked / "out", cwd=tmp_path)
    assert_one_clear_error(done, "cannot write", "--out")
    assert not (tmp_path / ".instobj").exists()


def test_two_specifications_of_one_name_are_refused(tmp_path):
    assert_one_clear_error(run("build", CUBE, CUBE, cwd=tmp_path), "both named")


@pytest.mark.parametrize("out", [".", "contacts.mcap"])
def test_a_model_that_is_not_there_is_said_so_wherever_contacts_go(tmp_path, out):
    (tmp_path / "a.csv").write_text("time_s,F1-X1\n0,1\n")
    done = run("predict", "none.nc", "a.csv", "--out", out, cwd=tmp_path)
    assert_one_clear_error(done, "no model at none.nc")


def test_a_twin_asked_for_as_a_command_names_both_options(tmp_path):
    done = run("twin", "cube.toml", "--mjcf", "--urdf", cwd=tmp_path)
    assert_one_clear_error(done, "instobj build SPEC --twin", "instobj train FRAMES --twin SPEC")


def test_bad_data_sets_end_with_one_clear_error(tmp_path):
    (tmp_path / "frames.nc").write_text("not a data set")
    assert_one_clear_error(run("train", "frames.nc", cwd=tmp_path), "frames.nc")
    assert_one_clear_error(run("train", "none.nc", cwd=tmp_path), "none.nc")
    wrong = run("train", "frames.nc", "--set", "shell.thickness_mm=9", cwd=tmp_path)
    assert_one_clear_error(wrong)


def test_ctrl_c_keeps_finished_stages_and_the_next_run_goes_on(tmp_path):
    content = {"name": "pad"} | GRID | ONE | CORE | BODIES["pad"]
    (tmp_path / "pad.toml").write_text(tomli_w.dumps(content))
    command = [sys.executable, "-m", "instobj", "build", "pad.toml", "--json"]
    process = subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    until = time.monotonic() + 60
    while not any(tmp_path.glob(".instobj/.leases/*")) and time.monotonic() < until:
        time.sleep(0.01)  # until the stage is at work
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Traceback" not in errors
    assert "interrupted" in json.loads(output)["error"]
    kept = [path.name for path in tmp_path.glob(".instobj/*") if path.name != ".leases"]
    assert not kept
    assert not list(tmp_path.glob("cad_out/pad/*"))
    again = run("build", "pad.toml", "--json", cwd=tmp_path)
    assert again.returncode == 0, again.stderr
    assert json.loads(again.stdout)["objects"][0]["stages"][0]["reused"] is False


def test_without_a_command_the_first_session_is_shown(tmp_path):
    done = run(cwd=tmp_path)
    assert done.returncode == 0
    named = re.findall(r"^  instobj (\w+)", done.stdout, re.MULTILINE)
    assert named == ["new", "check", "score", "optimize", "build"]


def test_at_most_sixteen_commands_stand_beside_the_bench_and_the_documentation():
    group = get_command(app)
    shown = {name for name, command in group.commands.items() if not command.hidden}
    assert {"bench", "docs"} <= shown
    assert len(shown - {"bench", "docs"}) <= 16


def test_the_room_of_the_bench_is_loaded_when_its_commands_are_named():
    code = (
        "import sys; from instobj.cli.app import app; from typer.main import get_command\n"
        "bench = get_command(app).commands['bench']; print('instobj.bench' in sys.modules)\n"
        "print(*sorted(bench.commands)); print('instobj.bench' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    names = ["bringup collect firmware live material rig selftest"]
    assert done.stdout.splitlines() == ["False", *names, "True"]


@pytest.mark.parametrize(
    ("old", "new"),
    [("mesh", "run --to mesh"), ("selftest", "bench selftest"), ("evaluate", "train")],
)
def test_an_old_name_works_and_says_the_new_one(tmp_path, old, new):
    done = run(old, "missing.toml", "missing.csv", cwd=tmp_path)
    assert done.returncode == 2
    assert f"warning: `instobj {old}` is now `instobj {new}`" in done.stderr
    assert "missing" in done.stderr.splitlines()[-1]


def test_an_old_name_whose_arguments_changed_says_what_to_write(tmp_path):
    done = run("grasp", "cube.toml", "--jaw", "3:0,0", "--force", "4", cwd=tmp_path)
    assert_one_clear_error(done, "instobj press SPEC --jaw")


@pytest.mark.parametrize("workers", ["0", "two", "-1"])
def test_workers_are_a_number_or_an_address(tmp_path, workers):
    assert_one_clear_error(run("run", CUBE, "--workers", workers, cwd=tmp_path), "--workers")


def test_a_result_that_does_not_exist_is_refused_with_those_that_do(tmp_path):
    assert_one_clear_error(run("run", CUBE, "--to", "moon", cwd=tmp_path), "moon", "compliance")


def test_a_cost_of_a_slip_wants_a_slip(tmp_path):
    done = run("run", CUBE, "--to", "slip", cwd=tmp_path)
    assert_one_clear_error(done, "mechanics.slip.shift_mm")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("bench collect out --port x --baud 9600", "--port PORT@BAUD"),
        ("bench collect out --port x@fast", "PORT@BAUD"),
        ("bench collect out --replay a.csv@-1", "FILE@2"),
        ("bench collect out --port x --stop 0", "frames, such as 100"),
        ("bench collect out --port x --stop nans", "seconds, such as 10s"),
        ("bench live --demo --page far:http", "TCP port"),
        ("predict model.onnx a.csv --zero rest:2", "rest:20"),
        ("predict model.onnx a.csv --zero always", "rest, first or none"),
        ("check a.toml --shell.thickness_mm=9", "--set shell.thickness_mm=VALUE"),
    ],
)
def test_options_of_one_text_and_those_that_went_say_what_to_write(words, told, tmp_path):
    assert_one_clear_error(run(*words.split(), cwd=tmp_path), told)


@pytest.mark.parametrize("option", ["--seed", "build --mjcf", "collect --force", "train --start"])
def test_an_option_that_went_says_what_to_write(option, tmp_path):
    """Options that went from one command alone are asked of that one."""
    command, _, name = option.rpartition(" ")
    group = ["bench"] if command == "collect" else []
    done = run(*group, command or "run", name, "1", cwd=tmp_path)
    told = f"It went with 0.2.0: {OPTIONS[option]}"
    assert_one_clear_error(done, f"No such option: {name}", told)


def shown_options(command):
    """Yield every option of a command and of those in its group, but for those that are not shown."""
    for inner in getattr(command, "commands", {}).values():
        if not inner.hidden:
            yield from shown_options(inner)
    yield from (one for one in command.params if one.param_type_name == "option")


MOST_OPTIONS = 128
"""Options of all commands, at most: a new one takes the place of another."""


def test_the_version_is_that_of_the_package(tmp_path):
    assert run(cwd=tmp_path).stdout.startswith(f"instobj {version('instobj')}. A first session")


def test_the_commands_gain_no_option():
    assert 100 < len(list(shown_options(get_command(app)))) <= MOST_OPTIONS


def test_an_interrupt_that_a_destructor_meets_is_not_forgotten():
    """Python prints such an exception and goes on."""
    program = (
        "import signal, time, typer; from instobj.cli.app import run_command\n"
        "class Late:\n"
        "    def __del__(self): signal.raise_signal(signal.SIGINT)\n"
        "app = typer.Typer()\n"
        "@app.command()\n"
        "def work():\n"
        "    Late()\n"
        "    time.sleep(1)\n"
        "    print('went on')\n"
        "run_command(app, [])\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 130
    assert "went on" not in done.stdout
    assert "Traceback" not in done.stderr
    assert "interrupted" in done.stderr


def named_commands():
    """Yield every `instobj COMMAND` that a text of the program names, and the file that holds it."""
    for path in (path for room in PACKAGES for path in (ROOT / room).rglob("*.py")):
        source = path.read_text(encoding="utf-8")
        for node in ast.walk(ast.parse(source)) if "`instobj" in source else ():
            parts = node.values if isinstance(node, ast.JoinedStr) else [node]
            text = "".join(str(getattr(part, "value", "")) for part in parts)
            if isinstance(node, ast.Constant | ast.JoinedStr):
                yield from ((name, path) for name in re.findall(r"`instobj\s+([a-z]+)", text))


def test_messages_name_commands_that_exist():
    """Old names are handed on, and no message sends anybody to them."""
    listed = get_command(app).commands.items()
    commands = {name for name, command in listed if not command.hidden}
    named = list(named_commands())
    assert {"new", "run"} <= {name for name, _ in named}
    assert not [(name, path) for name, path in named if name not in commands]
