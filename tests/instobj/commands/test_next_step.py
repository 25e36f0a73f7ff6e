"""The line that a command ends with: a command of instobj that a shell takes as it stands."""

import shlex
from pathlib import Path

import pytest
from typer.main import get_command

from instobj.cli.app import app
from instobj.commands.next_step import (
    NEXT,
    assessing_text,
    next_step,
    training_step,
    verdict_step,
)
from instobj.report.summary import TWIN_TITLE

PATHS = (Path("a folder/my box.toml"), Path("recording.csv"))


def parsed(words):
    """Name of the command in a line, and its options as typer reads them."""
    command = get_command(app)
    while hasattr(command, "commands"):
        name, *words = words
        command = command.commands[name]
    return name, command.make_context(name, words).params


@pytest.mark.parametrize("done", NEXT)
def test_every_next_step_is_taken_as_it_stands_also_with_blanks_in_paths(done):
    count = {"docs": 0, "predict": 2, "validate": 2, "assess": 2}.get(NEXT[done].split()[0], 1)
    program, *words = shlex.split(next_step(done, *PATHS[:count]))
    assert program == "instobj"
    name, options = parsed(words)
    assert name in NEXT[done].split()
    given = [value for value in options.values() if value in PATHS or value == [PATHS[0]]]
    assert len(given) >= min(count, 1)


def test_what_was_set_and_where_results_lie_is_handed_on():
    line = next_step("check", PATHS[0], out=Path("my results"), overrides=["score.force_n=3"])
    assert shlex.split(line)[2:] == [
        *("a folder/my box.toml", "--out", "my results", "--set", "score.force_n=3"),
    ]


@pytest.mark.parametrize(
    ("verdicts", "following"),
    [(("GO", "GO"), "run"), (("GO", "NO-GO"), "run --to verdict"), (("GO", None), "score")],
)
def test_the_verdict_chooses_what_comes_next(tmp_path, verdicts, following):
    specs = [tmp_path / f"{name}.toml" for name in "ab"]
    for path in specs:
        path.write_text(f'name = "{path.stem}"\n')
    summaries = [{} if word is None else {"verdict": {word: ""}} for word in verdicts]
    document = {"objects": [{"summary": summary} for summary in summaries]}
    command = "run" if following == "score" else "score"
    words = shlex.split(verdict_step(command, specs, Path(), [], document))
    named = [path for path in specs if "verdict" not in following or path == specs[1]]
    assert words[1:] == [*following.split(), *map(str, named)]


def test_what_a_search_left_behind_is_not_searched_again(tmp_path):
    path = tmp_path / "best.toml"
    path.write_text('name = "a_best"\n')
    document = {"objects": [{"summary": {"verdict": {"NO-GO": ""}}}]}
    assert verdict_step("run", [path], Path(), [], document).startswith("instobj optimize ")
    (tmp_path / "search.json").write_text("{}")
    assert verdict_step("run", [path], Path(), [], document) == "instobj docs layout_search"


@pytest.mark.parametrize(
    ("file", "helps", "following"),
    [
        ("contacts.nc", ["no: measure", "yes"], "predict runs/a/contacts.nc frames.nc"),
        ("contacts.nc", ["no: measure"], "train frames.nc"),
        ("face_1.safetensors", ["yes: as drawn"], "train --export runs/a"),
        ("face_1.safetensors", ["no: train", "not used: few"], "train frames.nc"),
        ("face_1.safetensors", [], "train --export runs/a"),
    ],
)
def test_training_goes_on_as_its_twin_s_verdict_says(file, helps, following):
    """A twin that helped on no face was followed by `predict`."""
    summary = {TWIN_TITLE: [{"helps": text} for text in helps]} if helps else {}
    document = {"summary": summary, "files": [{"path": f"runs/a/{file}"}]}
    assert training_step(Path("frames.nc"), document, Path(), []) == f"instobj {following}"
    assert ("--spec SPEC.toml" in assessing_text(document)) == (file != "contacts.nc")
