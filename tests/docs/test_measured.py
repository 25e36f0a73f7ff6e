"""Measured pages are what the results files say; each says how, when and with which version."""

import re
import sys
import tomllib
from datetime import date

import pytest

from tests.support.pages import DOCS, ROOT

sys.path.insert(0, str(DOCS))
import measured
from site_pages import commands

PAGES = measured.read_pages()
RESULTS = [
    pytest.param(result, id=f"{name}-{result['title']}")
    for name, page in PAGES.items()
    for result in page["results"]
]
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]


def numbers(version: str) -> list[int]:
    """Return a version as numbers that can be compared."""
    return [int(part) for part in version.split(".")]


def is_there(command: str) -> bool:
    """Return whether the script that a command line runs exists."""
    words = command.split()
    if words[:3] == ["python", "-m", "studies"]:
        return words[3] in {*commands("studies.__main__"), "STUDY"}
    if words[:2] == ["python", "-m"]:
        path = ROOT / words[2].replace(".", "/")
        return path.with_suffix(".py").exists() or (path / "__main__.py").exists()
    if words[0] == "instobj":
        return words[1] in commands() or " ".join(words[1:3]) in commands()
    if words[0] == "make":
        return bool(re.search(rf"^{words[1]}:", (ROOT / "Makefile").read_text(), re.MULTILINE))
    scripts = [word for word in words[1:] if "/" in word and "=" not in word]
    return words[0] in ("python", "pytest") and all((ROOT / script).exists() for script in scripts)


def faults(result: measured.Result) -> list[str]:
    """Return what a result does not say of itself, in words."""
    command, commit = result.get("command"), result.get("commit", "")
    days = [date.fromisoformat(day) for day in result["date"].split(" to ")]
    checks = {
        "no such command": command is not None and not is_there(command),
        "neither a command nor a commit": not (command or re.fullmatch("[0-9a-f]{7,40}", commit)),
        "a version to come": numbers(result["version"]) > numbers(VERSION),
        "days in the wrong order": days != sorted(days),
        "a row of another length": any(
            len(row) != len(table["columns"])
            for table in result.get("tables", ())
            for row in table["rows"]
        ),
    }
    return [text for text, broken in checks.items() if broken]


def test_the_pages_are_what_the_generator_writes():
    texts = {path.stem: path.read_text() for path in (DOCS / "measured").glob("*.md")}
    assert texts == {name: measured.page_text(name, page) for name, page in PAGES.items()}


@pytest.mark.parametrize("result", RESULTS)
def test_a_result_says_how_when_and_with_which_version(result):
    assert not faults(result)


def test_every_record_of_a_script_says_the_same():
    records = [path for path in measured.RESULTS.rglob("*.json") if path.parent.name != "measured"]
    assert records
    for path in records:
        assert not faults(measured.read_record(path)), path


def test_a_result_that_says_too_little_is_noticed():
    good = {"title": "x", "version": "0.1.0", "date": "2026-11-21", "command": "make test"}
    assert not faults(good)
    assert faults(good | {"command": "python benchmarks/no_such.py"}) == ["no such command"]
    assert faults(good | {"command": None}) == ["neither a command nor a commit"]
    table = {"columns": ["a", "b"], "rows": [["1"]]}
    assert faults(good | {"tables": [table]}) == ["a row of another length"]
    with pytest.raises(KeyError):
        faults({"title": "x", "date": "2026-11-21"})
